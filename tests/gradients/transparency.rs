//! Transparent surfaces: what they show, and the gradient through them.

use glam::{DVec3, dvec3};
use renderer::integrator::{Pass, Prepared, RenderSettings, Visibility, render};
use renderer::kernels::light::DistantLight;
use renderer::kernels::material::Material;
use renderer::scene::{Light, MaterialObject, MeshObject, ParameterId, Scene, TextureObject, Wrap};
use wide::{f32x16, f64x8};

use crate::custom::add_spotlight;
use crate::image::{agrees_with_finite_differences, lanes_agree_on};
use crate::scenes::{mirror_scene, small_scene, textured_scene};

/// The small scene on a mirror, with a transparent sphere and mesh, behind two panes that stand between
/// camera, lights and floor.
fn transparent_scene(size: u32) -> Scene {
    let mut scene = mirror_scene(size);
    make_transparent(&mut scene);
    scene
}

/// [`transparent_scene`] with textures.
fn transparent_textured_scene(size: u32) -> Scene {
    let mut scene = textured_scene(size);
    make_transparent(&mut scene);
    scene
}

/// [`transparent_textured_scene`] where textures also vary the opacity of everything transparent, under
/// one more light, which a user defines.
pub fn varied_scene(size: u32) -> Scene {
    let mut scene = transparent_textured_scene(size);
    let texels = [[0.2, 0.5, 0.8], [0.9, 1.0, 0.7], [0.4, 0.1, 0.3], [0.6, 0.6, 0.0]];
    let wrap = Wrap::Mirror;
    scene.textures.push(TextureObject { name: "holes".into(), width: 2, height: 2, wrap });
    scene.parameters.textures.push(texels.to_vec());
    scene.materials[1].textures.opacity = Some(3);
    scene.materials[2].textures.opacity = Some(3);
    scene.parameters.texture_coordinates[2] =
        vec![[-0.2, 0.1], [1.3, 0.2], [0.4, 1.1], [0.0, 0.3], [1.1, -0.1], [0.7, 0.9]];
    scene.meshes[2].texture_triangles = vec![Some([0, 1, 2]), Some([3, 4, 5])];
    add_spotlight(&mut scene);
    scene
}

fn make_transparent(scene: &mut Scene) {
    let Scene { parameters, materials, meshes, bounces, .. } = scene;
    *bounces = 7;
    let object = parameters.materials[1];
    parameters.materials[1].reflection = DVec3::ZERO;
    parameters.materials.push(Material { reflection: DVec3::ZERO, exponent: 3.0, ..object });
    materials[1].opacity = Some(0);
    materials.push(MaterialObject { opacity: Some(1), ..MaterialObject::new("pane") });
    parameters.opacities = vec![0.6, 0.3];
    // The first is met by many a ray of a light, the second by every one of the camera.
    let panes = vec![
        [-1.5, 1.6, -0.5],
        [1.8, 1.7, -0.6],
        [0.2, 1.5, 1.9],
        [-4.0, -1.0, 4.1],
        [4.0, -1.2, 4.0],
        [0.1, 7.0, 4.3],
    ];
    parameters.vertices.push(panes);
    parameters.texture_coordinates.push(Vec::new());
    meshes.push(MeshObject {
        name: "panes".into(),
        triangles: vec![[0, 1, 2], [3, 4, 5]],
        materials: vec![2, 2],
        texture_triangles: Vec::new(),
    });
}

#[test]
fn every_parameter_agrees_with_finite_differences() {
    let scene = transparent_scene(20);
    scene.validate("scene").unwrap();
    for id in scene.parameter_ids() {
        agrees_with_finite_differences(&scene, id);
    }
}

#[test]
fn every_parameter_agrees_with_finite_differences_under_textures() {
    let scene = transparent_textured_scene(16);
    for id in scene.parameter_ids() {
        agrees_with_finite_differences(&scene, id);
    }
}

/// Also where light goes through them: by texels, by the triangles and spheres on the way, by the light.
#[test]
fn every_parameter_agrees_with_finite_differences_under_varied_opacity() {
    let scene = varied_scene(16);
    scene.validate("scene").unwrap();
    for id in scene.parameter_ids() {
        agrees_with_finite_differences(&scene, id);
    }
}

/// What covers everything, and what covers nothing, has a gradient by its opacity all the same.
#[test]
fn opaque_and_invisible_surfaces_have_a_gradient() {
    for opacities in [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
        let mut scene = transparent_scene(20);
        scene.parameters.opacities = opacities.to_vec();
        for id in [ParameterId::Opacity(0), ParameterId::Opacity(1), ParameterId::Diffuse(0)] {
            agrees_with_finite_differences(&scene, id);
        }
    }
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
    transparent.parameters.opacities = vec![1.0, 1.0];
    let mut opaque = transparent.clone();
    opaque.materials.iter_mut().for_each(|material| material.opacity = None);
    opaque.parameters.opacities.clear();
    is_same(&transparent, &opaque, 0.0);

    let mut invisible = transparent_scene(40);
    invisible.parameters.opacities[1] = 0.0;
    let mut without = invisible.clone();
    without.meshes[2].triangles.clear();
    without.meshes[2].materials.clear();
    is_same(&invisible, &without, 1e-6);
}

/// A texture that is white leaves an opacity as it is; a grey one scales it.
#[test]
fn textures_scale_opacities() {
    let mut white = varied_scene(40);
    white.parameters.textures[3].fill([1.0; 3]);
    let mut plain = white.clone();
    plain.materials.iter_mut().for_each(|material| material.textures.opacity = None);
    is_same(&white, &plain, 0.0);

    let mut grey = white.clone();
    grey.parameters.textures[3].fill([0.25, 0.5, 0.75]);
    plain.parameters.opacities.iter_mut().for_each(|opacity| *opacity *= 0.5);
    is_same(&grey, &plain, 1e-6);
}

/// A pane that covers its left half, lit from straight above: the light that goes through its right half
/// falls on the floor below.
#[test]
fn light_goes_through_holes() {
    let mut scene = panes_above_a_floor(&[(1.0, 4.0)]);
    scene.parameters.opacities = vec![1.0];
    // The middle of the texture lies above x = 0.
    scene.parameters.texture_coordinates[1] = vec![[-3.5, 0.0], [4.5, 0.0], [0.5, 1.0]];
    scene.meshes[1].texture_triangles = vec![Some([0, 1, 2])];
    let wrap = Wrap::Clamp;
    scene.textures = vec![TextureObject { name: "half".into(), width: 2, height: 1, wrap }];
    scene.parameters.textures = vec![vec![[1.0; 3], [0.0; 3]]];
    scene.materials[1].textures.opacity = Some(0);
    let Material { ambient, diffuse, .. } = scene.parameters.materials[0];
    // From below the pane, so that only its shadow is seen.
    scene.parameters.camera.look_from = dvec3(0.0, 0.9, 1.0);
    let image = render(&Prepared::<f32x16>::new(&scene));
    let row = image.height as usize / 2 * image.width as usize;
    for (column, pixel) in image.pixels[row..row + image.width as usize].iter().enumerate() {
        let x = (column as f64 + 0.5) / 8.0 - 0.5;
        let expected = if x < 0.0 { ambient } else { ambient + diffuse * 2.0 };
        // Between the texels of the middle the shadow is soft.
        if x.abs() > 0.3 {
            let error = (glam::Vec3::from(*pixel) - expected.as_vec3()).abs().max_element();
            assert!(error < 1e-6, "{column}: {pixel:?}");
        }
    }
}

fn is_same(a: &Scene, b: &Scene, tolerance: f32) {
    let [a, b] = [a, b].map(|scene| render(&Prepared::<f64x8>::new(scene)));
    for (a, b) in a.pixels.as_flattened().iter().zip(b.pixels.as_flattened()) {
        assert!((a - b).abs() <= tolerance, "{a} instead of {b}");
    }
}

/// Triangles at right angles to the y axis, given by their heights and sizes: a large floor at 0 of the
/// material 0, and panes of the material 1 above it, under one light that shines from straight above.
fn panes_above_a_floor(panes: &[(f64, f64)]) -> Scene {
    let mut scene = small_scene(8);
    scene.spheres.clear();
    scene.parameters.spheres.clear();
    let corners = |&(y, size): &(f64, f64)| [[-size, y, size], [size, y, size], [0.0, y, -size]];
    let vertices = panes.iter().flat_map(corners).collect();
    scene.parameters.vertices = vec![corners(&(0.0, 90.0)).to_vec(), vertices];
    scene.meshes[0].triangles = vec![[0, 1, 2]];
    scene.meshes[0].materials = vec![0];
    scene.meshes[1].triangles =
        (0..panes.len() as u32).map(|i| [0, 1, 2].map(|v| v + 3 * i)).collect();
    scene.meshes[1].materials = vec![1; panes.len()];
    scene.materials[1].opacity = Some(0);
    scene.parameters.lights = vec![Light::Distant(DistantLight {
        direction: DVec3::Y,
        color: DVec3::ONE,
        intensity: 2.0,
    })];
    scene.light_names.truncate(1);
    for material in &mut scene.parameters.materials {
        material.specular = DVec3::ZERO;
        material.ambient = dvec3(0.25, 0.5, 0.125);
    }
    scene.parameters.camera.look_at = DVec3::ZERO;
    scene
}

/// Two panes in parallel before a floor, each with its own radiance: what is left of floor and light is
/// known.
#[test]
fn panes_leave_what_they_do_not_cover() {
    let mut scene = panes_above_a_floor(&[(1.0, 90.0), (2.0, 90.0)]);
    scene.parameters.opacities = vec![0.3];
    scene.parameters.camera.look_from = dvec3(0.1, 5.0, 1.0);
    let [floor, pane] = [0, 1].map(|i| scene.parameters.materials[i]);
    let lit = |material: Material<f64>, left: f64| material.ambient + material.diffuse * 2.0 * left;
    let (shown, left) = (0.3, 0.7);
    let upper = lit(pane, 1.0) * shown;
    let lower = lit(pane, left) * shown * left;
    let expected = upper + lower + lit(floor, left * left) * left * left;
    for bounces in 0..4 {
        let expected = [upper, upper + lower, expected, expected][bounces as usize].as_vec3();
        for pixel in render(&Prepared::<f32x16>::new(&Scene { bounces, ..scene.clone() })).pixels {
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
        let settings = RenderSettings { pass, visibility, ..RenderSettings::default() };
        render(&Prepared::<f32x16>::with_settings(&scene, settings))
    };
    for pass in [Pass::Radiance, Pass::Albedo] {
        let tree = image(pass, Visibility::Tree);
        assert_eq!(tree, image(pass, Visibility::List));
        assert_eq!(tree, image(pass, Visibility::Raster));
    }
    let nearest = scene.parameters.materials[2].diffuse.as_vec3();
    let albedo = image(Pass::Albedo, Visibility::Tree);
    assert_eq!(albedo.pixels[32 + 64 * 17], nearest.to_array());
}
