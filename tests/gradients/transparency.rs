//! Transparent surfaces: what they show, and the gradient through them.

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use renderer::scene::{MaterialObject, Slot, Wrap};
use renderer::{
    Arithmetic, DistantLight, Material, Mesh, Pass, PrimaryVisibility, Scene, Settings, Texture,
    render,
};

use crate::custom::add_spotlight;
use crate::image::{agrees_with_finite_differences, in_arithmetic, lanes_agree_on};
use crate::scenes::{Parts, mirror_parts, multiply, set, small_parts, textured_parts};

/// The small scene on a mirror, with a transparent sphere and mesh, behind two panes that stand between
/// camera, lights and floor.
fn transparent_parts(size: u32) -> Parts {
    make_transparent(mirror_parts(size))
}

fn transparent_scene(size: u32) -> Scene {
    transparent_parts(size).scene()
}

/// [`transparent_scene`] with textures.
fn transparent_textured_scene(size: u32) -> Scene {
    make_transparent(textured_parts(size)).scene()
}

/// [`transparent_textured_scene`] where textures also vary the opacity of everything transparent.
pub fn varied_parts(size: u32) -> Parts {
    let mut parts = make_transparent(textured_parts(size));
    let texels =
        vec![[0.2_f64, 0.5, 0.8], [0.9, 1.0, 0.7], [0.4, 0.1, 0.3], [0.6, 0.6, 0.0]].into();
    let holes = Texture { name: "holes".into(), width: 2, height: 2, wrap: Wrap::Mirror, texels };
    parts.textures.push(holes);
    for material in &mut parts.materials[1..] {
        *material = material.clone().with_texture(Slot::Opacity, 3);
    }
    parts.meshes[2] = parts.meshes[2].clone().texture_coordinates(
        vec![[-0.2, 0.1], [1.3, 0.2], [0.4, 1.1], [0.0, 0.3], [1.1, -0.1], [0.7, 0.9]],
        vec![[0, 1, 2], [3, 4, 5]],
    );
    parts
}

/// [`varied_parts`] under one more light, which a user defines.
pub fn varied_scene(size: u32) -> Scene {
    let mut scene = varied_parts(size).scene();
    add_spotlight(&mut scene);
    scene
}

fn make_transparent(mut parts: Parts) -> Parts {
    parts.bounces = 7;
    parts.materials[1].values.mirror = DVec3::ZERO;
    let values = Material { exponent: 3.0, ..parts.materials[1].values };
    let pane = MaterialObject { name: "pane".into(), ..values.into() };
    parts.materials.push(pane.with_opacity(0.3));
    parts.materials[1] = parts.materials[1].clone().with_opacity(0.6);
    // The first is met by many a ray of a light, the second by every one of the camera.
    let panes = vec![
        [-1.5, 1.6, -0.5],
        [1.8, 1.7, -0.6],
        [0.2, 1.5, 1.9],
        [-4.0, -1.0, 4.1],
        [4.0, -1.2, 4.0],
        [0.1, 7.0, 4.3],
    ];
    parts.meshes.push(Mesh::new("panes", panes, vec![[0, 1, 2], [3, 4, 5]]).material(2));
    parts
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let scene = transparent_scene(20);
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences_under_textures() {
    let scene = transparent_textured_scene(16);
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

/// Also where light goes through them: by texels, by the triangles and spheres on the way, by the light.
#[test]
fn every_parameter_agrees_with_finite_differences_under_varied_opacity() {
    let scene = varied_scene(16);
    for id in scene.parameters() {
        agrees_with_finite_differences(&scene, id);
    }
}

/// What covers everything, and what covers nothing, has a gradient by its opacity all the same.
#[test]
fn opaque_and_invisible_surfaces_have_a_gradient() {
    for opacities in [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
        let mut scene = transparent_scene(20);
        set_opacities(&mut scene, opacities);
        for path in ["material.object.opacity", "material.pane.opacity", "material.ground.diffuse"]
        {
            agrees_with_finite_differences(&scene, scene.parameter(path).unwrap());
        }
    }
}

fn set_opacities(scene: &mut Scene, [object, pane]: [f64; 2]) {
    set(scene, "material.object.opacity", &[object]);
    set(scene, "material.pane.opacity", &[pane]);
}

#[test]
fn lanes_agree_with_single_numbers() {
    lanes_agree_on(&transparent_scene(37));
    lanes_agree_on(&transparent_textured_scene(37));
    lanes_agree_on(&varied_scene(37));
}

/// An opacity of 1 is that of a material that has none; one of 0 leaves a scene as if nothing wore it.
#[test]
fn opacities_of_1_and_0_are_opaque_and_invisible() {
    let mut transparent = transparent_scene(40);
    set_opacities(&mut transparent, [1.0, 1.0]);
    let mut opaque = transparent_parts(40);
    for material in &mut opaque.materials {
        (material.transparent, material.values.opacity) = (false, 1.0);
    }
    is_same(&transparent, &opaque.scene(), 0.0);

    let mut invisible = transparent_scene(40);
    set(&mut invisible, "material.pane.opacity", &[0.0]);
    let mut without = transparent_parts(40);
    without.meshes.pop();
    is_same(&invisible, &without.scene(), 1e-6);
}

/// A texture that is white leaves an opacity as it is; a grey one scales it.
#[test]
fn textures_scale_opacities() {
    let mut white = varied_parts(40);
    white.textures[3].texels = vec![[1.0_f64; 3]; 4].into();
    let mut plain = white.clone();
    plain
        .materials
        .iter_mut()
        .for_each(|material| material.textures.0[Slot::Opacity as usize] = None);
    let mut plain = plain.scene();
    is_same(&white.clone().scene(), &plain, 0.0);

    let mut grey = white;
    grey.textures[3].texels = vec![[0.25_f64, 0.5, 0.75]; 4].into();
    for path in ["material.object.opacity", "material.pane.opacity"] {
        multiply(&mut plain, path, 0.5);
    }
    is_same(&grey.scene(), &plain, 1e-6);
}

/// A pane that covers its left half, lit from straight above: the light that goes through its right half
/// falls on the floor below.
#[test]
fn light_goes_through_holes() {
    let mut parts = panes_above_a_floor(&[(1.0, 4.0)], 1.0);
    let (name, texels) = ("half".into(), vec![[1.0_f64; 3], [0.0; 3]].into());
    parts.textures = vec![Texture { name, width: 2, height: 1, wrap: Wrap::Clamp, texels }];
    parts.materials[1] = parts.materials[1].clone().with_texture(Slot::Opacity, 0);
    // The middle of the texture lies above x = 0.
    let coordinates = vec![[-3.5, 0.0], [4.5, 0.0], [0.5, 1.0]];
    parts.meshes[1] = parts.meshes[1].clone().texture_coordinates(coordinates, vec![[0, 1, 2]]);
    let Material { emission, diffuse, .. } = parts.materials[0].values;
    // From below the pane, so that only its shadow is seen.
    parts.camera.look_from = dvec3(0.0, 0.9, 1.0);
    let image = render(&parts.scene(), &crate::without_edges()).unwrap();
    let row = image.height as usize / 2 * image.width as usize;
    for (column, pixel) in image.pixels[row..row + image.width as usize].iter().enumerate() {
        let x = (column as f64 + 0.5) / 8.0 - 0.5;
        let expected = if x < 0.0 { emission } else { emission + diffuse * 2.0 };
        // Between the texels of the middle the shadow is soft.
        if x.abs() > 0.3 {
            let error = (glam::Vec3::from(*pixel) - expected.as_vec3()).abs().max_element();
            assert!(error < 1e-6, "{column}: {pixel:?}");
        }
    }
}

fn is_same(a: &Scene, b: &Scene, tolerance: f32) {
    let [a, b] = [a, b].map(|scene| render(scene, &in_arithmetic(Arithmetic::F64x8)).unwrap());
    for (a, b) in a.pixels.as_flattened().iter().zip(b.pixels.as_flattened()) {
        assert!((a - b).abs() <= tolerance, "{a} instead of {b}");
    }
}

/// Triangles at right angles to the y axis, given by their heights and sizes: a large floor at 0 of the
/// material 0, and panes of the material 1 above it, under one light that shines from straight above.
fn panes_above_a_floor(panes: &[(f64, f64)], opacity: f64) -> Parts {
    let mut parts = small_parts(8);
    parts.spheres.clear();
    let corners = |&(y, size): &(f64, f64)| [[-size, y, size], [size, y, size], [0.0, y, -size]];
    let triangles = (0..panes.len() as u32).map(|i| [0, 1, 2].map(|v| v + 3 * i)).collect();
    parts.meshes = vec![
        Mesh::new("floor", corners(&(0.0, 90.0)).to_vec(), vec![[0, 1, 2]]),
        Mesh::new("panes", panes.iter().flat_map(corners).collect(), triangles).material(1),
    ];
    let (direction, color) = (DVec3::Y, DVec3::ONE);
    // What a white surface reflects of it is 2.
    let sun = DistantLight { direction, color, irradiance: 2.0 * PI };
    parts.lights = vec![("sun", sun.into())];
    for material in &mut parts.materials {
        material.values.specular = DVec3::ZERO;
        material.values.emission = dvec3(0.25, 0.5, 0.125);
    }
    parts.materials[1] = parts.materials[1].clone().with_opacity(opacity);
    parts.camera.look_at = DVec3::ZERO;
    parts
}

/// Two panes in parallel before a floor, each with its own radiance: what is left of floor and light is
/// known.
#[test]
fn panes_leave_what_they_do_not_cover() {
    let mut parts = panes_above_a_floor(&[(1.0, 90.0), (2.0, 90.0)], 0.3);
    parts.camera.look_from = dvec3(0.1, 5.0, 1.0);
    let [floor, pane] = [0, 1].map(|i| parts.materials[i].values);
    let lit =
        |material: Material<f64>, left: f64| material.emission + material.diffuse * 2.0 * left;
    let (shown, left) = (0.3, 0.7);
    let upper = lit(pane, 1.0) * shown;
    let lower = lit(pane, left) * shown * left;
    let expected = upper + lower + lit(floor, left * left) * left * left;
    for bounces in 0..4 {
        let expected = [upper, upper + lower, expected, expected][bounces as usize].as_vec3();
        let scene = Parts { bounces, ..parts.clone() }.scene();
        for pixel in render(&scene, &crate::without_edges()).unwrap().pixels {
            let error = (glam::Vec3::from(pixel) - expected).abs().max_element();
            assert!(error < 1e-6, "{bounces}: {pixel:?} instead of {expected}");
        }
    }
}

/// Whatever finds what rays meet, and in what precision, the image is the same; colours alone are those
/// of the nearest surface.
#[test]
fn visibility_does_not_matter() {
    let scene = transparent_scene(64);
    let image = |pass, visibility| {
        render(&scene, &Settings { pass, visibility, ..crate::without_edges() }).unwrap()
    };
    for pass in [Pass::Radiance, Pass::Albedo] {
        let bvh = image(pass, PrimaryVisibility::Bvh);
        assert_eq!(bvh, image(pass, PrimaryVisibility::BruteForce));
        assert_eq!(bvh, image(pass, PrimaryVisibility::Raster));
    }
    let nearest = scene.materials()[2].values.diffuse.as_vec3();
    let albedo = image(Pass::Albedo, PrimaryVisibility::Bvh);
    assert_eq!(albedo.pixels[32 + 64 * 17], nearest.to_array());
}
