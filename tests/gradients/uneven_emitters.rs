//! Surfaces that shine by a texture, or through an opacity.

use std::f64::consts::{PI, TAU};

use glam::{DVec2, DVec3, dvec2, dvec3};
use renderer::scene::{Integrator, MaterialObject, Slot, Wrap};
use renderer::{Camera, Mesh, PointLight, Scene, Settings, SphereObject, Texture, render};

use crate::moving_paths::{card, check};
use crate::paths::{agrees_with_differences, assert_close, emitting, floor_scene, lit_box};

/// Two by two colours, which are repeated: on a ball they go on across the seam.
const SLIDE: [[f64; 3]; 4] = [[0.9, 0.2, 0.1], [0.1, 0.4, 0.7], [0.3, 0.8, 0.2], [0.6, 0.5, 0.9]];

fn add_texture(scene: &mut Scene, name: &str, texels: [[f64; 3]; 4]) -> u32 {
    let texels = texels.to_vec().into();
    let wrap = Wrap::Repeat;
    scene.add_texture(Texture { name: name.into(), width: 2, height: 2, wrap, texels }).unwrap()
}

/// A material that shines by textures of its emission and its opacity.
fn add_lantern(scene: &mut Scene, emission: f64, slide: [[f64; 3]; 4], holes: [f64; 4]) -> u32 {
    let slide = add_texture(scene, "slide", slide);
    let holes = add_texture(scene, "holes", holes.map(|level| [level; 3]));
    let lamp = MaterialObject::from(emitting(emission, 0.0));
    let lamp = lamp.with_texture(Slot::Emission, slide).with_texture(Slot::Opacity, holes);
    scene.add_material("lantern", lamp).unwrap()
}

const CORNERS: [[f64; 3]; 4] =
    [[-0.4, 2.1, 0.6], [0.5, 2.2, 0.5], [0.6, 2.1, -0.4], [-0.5, 2.3, -0.5]];
const UVS: [[f64; 2]; 4] = [[0.1, 0.0], [1.0, 0.2], [0.9, 1.1], [-0.1, 0.9]];

fn slide(material: u32) -> Mesh {
    let triangles = vec![[0, 1, 2], [0, 2, 3]];
    let mesh = Mesh::new("slide", CORNERS.to_vec(), triangles.clone());
    mesh.texture_coordinates(UVS.to_vec(), triangles).material(material)
}

/// On spheres columns of texels go around and rows end at the poles, whatever the `wrap`: where a ball is seen, where it
/// shines, and where light goes through it.
#[test]
fn textures_go_around_spheres() {
    let image = |wrap: Wrap| {
        let mut scene = floor_scene();
        scene.camera = Camera::looking(dvec3(-2.0, 3.0, 3.0), dvec3(0.0, 1.0, 0.0));
        let lantern = add_lantern(&mut scene, 6.0, SLIDE, [0.9, 0.4, 0.7, 0.5]);
        scene.textures.iter_mut().for_each(|texture| texture.wrap = wrap);
        let ball = SphereObject::new("ball", dvec3(0.2, 1.0, -0.5), 0.8).material(lantern);
        scene.add_sphere(ball).unwrap();
        let position = dvec3(1.0, 4.0, 2.0);
        let bulb = PointLight { position, color: DVec3::ONE, radiant_intensity: 20.0 };
        scene.add_light("bulb", bulb).unwrap();
        [Integrator::Direct, scene.integrator].map(|integrator| {
            let scene = Scene { integrator, ..scene.clone() };
            render(&scene, &Settings::default()).unwrap()
        })
    };
    let expected = image(Wrap::Repeat);
    assert!([Wrap::Clamp, Wrap::Mirror].map(image).iter().all(|image| *image == expected));
}

/// Textures of one colour are that colour, to the same random numbers.
#[test]
fn even_textures_are_their_colour() {
    let color = dvec3(0.8, 0.4, 0.2);
    let mut textured = floor_scene();
    let lantern = add_lantern(&mut textured, 6.0, [color.to_array(); 4], [0.5; 4]);
    let mut plain = floor_scene();
    let mut lamp = MaterialObject::from(emitting(0.0, 0.0));
    lamp.values.emission = color * 6.0;
    let lamp = plain.add_material("lamp", lamp.with_opacity(0.5)).unwrap();
    for (scene, material) in [(&mut textured, lantern), (&mut plain, lamp)] {
        scene.add_mesh(slide(material)).unwrap();
        let ball = SphereObject::new("ball", dvec3(1.5, 1.0, -0.5), 0.3);
        scene.add_sphere(ball.material(material)).unwrap();
    }
    let [textured, plain] =
        [textured, plain].map(|scene| render(&scene, &Settings::default()).unwrap());
    let pairs = textured.pixels.as_flattened().iter().zip(plain.pixels.as_flattened());
    for (&found, &expected) in pairs {
        assert_close(found.into(), expected.into(), 1e-5);
    }
}

/// The colour between four texels, the first of the upper row.
fn bilinear(texels: [DVec3; 4], uv: DVec2) -> DVec3 {
    // From one texel to the next and back.
    let [x, y] = [2.0 * uv.x - 0.5, 2.0 * (1.0 - uv.y) - 0.5]
        .map(|at: f64| 1.0 - (at.rem_euclid(2.0) - 1.0).abs());
    texels[0].lerp(texels[1], x).lerp(texels[2].lerp(texels[3], x), y)
}

const HOLES: [f64; 4] = [0.9, 0.2, 0.5, 0.7];

fn shining(uv: DVec2) -> DVec3 {
    bilinear(SLIDE.map(DVec3::from), uv) * bilinear(HOLES.map(DVec3::splat), uv).x
}

/// What comes to the origin, facing up, from a point of a surface of this normal: by area.
fn irradiance(at: DVec3, normal: DVec3) -> f64 {
    let (distance, direction) = (at.length(), at.normalize());
    direction.y.max(0.0) * normal.dot(direction).abs() / distance.powi(2)
}

/// A slide above a floor brings what its points do, added up.
#[test]
fn slides_light_as_their_points() {
    let mut scene = floor_scene();
    let lantern = add_lantern(&mut scene, 6.0, SLIDE, HOLES);
    scene.add_mesh(slide(lantern)).unwrap();
    let mut expected = DVec3::ZERO;
    let side = 300;
    for triangle in [[0, 1, 2], [0, 2, 3]] {
        let [a, b, c] = triangle.map(|corner: usize| DVec3::from(CORNERS[corner]));
        let [p, q, r] = triangle.map(|corner: usize| DVec2::from(UVS[corner]));
        let twice_area = (b - a).cross(c - a);
        let area = 0.5 * twice_area.length() / f64::from(side * side);
        for row in 0..side {
            // The triangles that parallels to the sides make, each by its middle.
            for column in 0..2 * (side - row) - 1 {
                let third = f64::from(1 + column % 2) / 3.0;
                let at_b = (f64::from(column / 2) + third) / f64::from(side);
                let at_c = (f64::from(row) + third) / f64::from(side);
                let at = a + (b - a) * at_b + (c - a) * at_c;
                let uv = p + (q - p) * at_b + (r - p) * at_c;
                expected += shining(uv) * (area * irradiance(at, twice_area.normalize()));
            }
        }
    }
    assert_lit(&scene, 6.0 * expected);
}

/// So does a ball, the near half of it.
#[test]
fn textured_balls_light_as_their_points() {
    let mut scene = floor_scene();
    let lantern = add_lantern(&mut scene, 6.0, SLIDE, HOLES);
    let (center, radius) = (dvec3(0.4, 1.4, -0.3), 0.5);
    scene.add_sphere(SphereObject::new("ball", center, radius).material(lantern)).unwrap();
    let mut expected = DVec3::ZERO;
    let side = 400;
    let middle = |index: u32| (f64::from(index) + 0.5) / f64::from(side);
    for (row, column) in (0..side).flat_map(|row| (0..side).map(move |column| (row, column))) {
        let (height, longitude) = (2.0 * middle(row) - 1.0, TAU * (middle(column) - 0.5));
        let across = (1.0 - height * height).sqrt();
        let normal = dvec3(across * longitude.sin(), height, across * longitude.cos());
        let at = center + radius * normal;
        if normal.dot(at) < 0.0 {
            let area = 4.0 * PI * radius * radius / f64::from(side * side);
            // Between the middles of the first and the last row and the poles nothing changes.
            let up = (0.5 + height.asin() / PI).clamp(0.25, 0.75);
            let uv = dvec2(middle(column), up);
            expected += shining(uv) * (area * irradiance(at, normal));
        }
    }
    assert_lit(&scene, 6.0 * expected);
}

/// The colour of the floor under this irradiance, by so few paths that none would come to the lamp by chance.
#[track_caller]
fn assert_lit(scene: &Scene, irradiance: DVec3) {
    let image = render(scene, &Settings::default()).unwrap();
    let sum: DVec3 = image.pixels.iter().map(|pixel| DVec3::from(pixel.map(f64::from))).sum();
    let (found, expected) = (sum / image.pixels.len() as f64, irradiance * 0.6 / PI);
    for channel in 0..3 {
        assert_close(found[channel], expected[channel], 3e-3);
    }
}

/// Derivatives by texels, texture coordinates, emission and opacity, with the same random numbers.
#[test]
fn gradients_of_slides_and_balls_agree_with_differences() {
    let mut scene = lit_box(8);
    let lantern = add_lantern(&mut scene, 3.0, SLIDE, HOLES);
    let place = |[x, y, z]: [f64; 3]| [0.8 * x, y - 1.8, 0.8 * z];
    let mesh = slide(lantern);
    let vertices = mesh.vertices.iter().copied().map(place).collect();
    scene.add_mesh(Mesh { vertices, ..mesh }).unwrap();
    let ball = SphereObject::new("lantern", dvec3(-0.4, -0.3, 0.2), 0.12);
    scene.add_sphere(ball.material(lantern)).unwrap();
    let veil = MaterialObject::from(emitting(1.5, 0.2)).with_opacity(0.6);
    let veil = scene.add_material("veil", veil).unwrap();
    let ball = SphereObject::new("veil", dvec3(0.5, 0.3, 0.1), 0.15);
    scene.add_sphere(ball.material(veil)).unwrap();
    agrees_with_differences(&scene);
}

/// What shines unevenly moves, and what stands before it, with their shadows.
#[test]
fn soft_shadows_of_slides_and_balls_move() {
    let mut scene = card(2, 64);
    let lantern = add_lantern(&mut scene, 6.0, SLIDE, HOLES);
    scene.add_mesh(slide(lantern)).unwrap();
    for (path, most) in [("mesh.card.translation", 0.05), ("mesh.slide.translation", 0.01)] {
        check(&scene, path, most);
    }
    let mut scene = card(2, 64);
    let lantern = add_lantern(&mut scene, 6.0, SLIDE, HOLES);
    let ball = SphereObject::new("ball", dvec3(0.9, 2.3, 0.2), 0.35);
    scene.add_sphere(ball.material(lantern)).unwrap();
    // By 512 paths, and differences of 8,192, the place of the ball is .009 off.
    for (path, most) in [("mesh.card.translation", 0.08), ("sphere.ball.center", 0.012)] {
        check(&scene, path, most);
    }
}
