//! Rays that leave a surface neither meet that surface nor pass through another.
//!
//! A thousand lights shine on each of many hits. From outside of a convex surface all those that it
//! faces have to arrive, from inside of a closed one none of those outside. The rays go from hits to
//! distant lights, and between hits and point lights in both of the ways that the renderer has.

use std::f64::consts::PI;

use glam::{DVec3, dvec3};
use renderer::transport::camera::{camera_frame, primary_ray};
use renderer::{
    Arithmetic, Camera, DistantLight, Light, Material, PointLight, Scene, SphereObject,
};

use crate::images::{ARITHMETICS, render};
use crate::meshes::{Mesh, Random};

const SIZE: u32 = 12;

/// A convex closed surface.
enum Surface {
    Sphere { center: DVec3, radius: f64 },
    Mesh { mesh: Mesh, center: DVec3, radius: f64 },
}

impl Surface {
    fn center(&self) -> DVec3 {
        match *self {
            Self::Sphere { center, .. } | Self::Mesh { center, .. } => center,
        }
    }

    fn radius(&self) -> f64 {
        match *self {
            Self::Sphere { radius, .. } | Self::Mesh { radius, .. } => radius,
        }
    }

    fn corners(&self) -> Vec<[DVec3; 3]> {
        match self {
            Self::Sphere { .. } => Vec::new(),
            Self::Mesh { mesh, center, radius } => {
                mesh.corners().map(|corners| corners.map(|v| v * *radius + *center)).collect()
            }
        }
    }

    /// The distance at which a ray meets the surface, and the normal there, in double precision.
    fn meet(&self, origin: DVec3, direction: DVec3) -> Option<(f64, DVec3)> {
        if let Self::Sphere { center, radius } = *self {
            let from = origin - center;
            let along = from.dot(direction);
            let root = (along * along - from.length_squared() + radius * radius).sqrt();
            let distance = [-along - root, -along + root].into_iter().find(|&t| t > 0.0)?;
            return Some((distance, (from + direction * distance) / radius));
        }
        let meet = |[a, b, c]: [DVec3; 3]| {
            let normal = (b - a).cross(c - a);
            let distance = (a - origin).dot(normal) / direction.dot(normal);
            let point = origin + direction * distance;
            let inside = |p: DVec3, q: DVec3| (q - p).cross(point - p).dot(normal) >= 0.0;
            let hit = distance > 0.0 && inside(a, b) && inside(b, c) && inside(c, a);
            hit.then(|| (distance, normal.normalize()))
        };
        self.corners().into_iter().filter_map(meet).min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn add_to(self, scene: &mut Scene) {
        let name = (scene.spheres().len() + scene.meshes().len()).to_string();
        let added = match self {
            Self::Sphere { center, radius } => {
                scene.add_sphere(SphereObject::new(name, center, radius))
            }
            Self::Mesh { mesh, center, radius } => {
                let vertices = mesh.vertices.iter().map(|&v| (v * radius + center).into());
                scene.add_mesh(renderer::Mesh::new(name, vertices.collect(), mesh.triangles))
            }
        };
        added.unwrap();
    }
}

/// Where lights stand.
#[derive(Clone, Copy, PartialEq)]
enum Lights {
    Distant,
    Outside,
    Inside,
}

impl Lights {
    fn around(self, center: DVec3, radius: f64, count: usize) -> Vec<Light<f64>> {
        let mut random = Random(7);
        let light = |_| {
            // Each makes a white surface that faces it reflect the radiance 1.
            let color = DVec3::ONE;
            if self == Self::Distant {
                let direction = random.direction();
                return DistantLight { direction, color, irradiance: PI }.into();
            }
            let offset = match self {
                Self::Inside => random.in_ball() * 0.9,
                _ => random.direction() * 10.0_f64.powf(0.1 + 3.0 * random.number()),
            };
            let offset = offset * radius;
            let radiant_intensity = PI * offset.length_squared();
            PointLight { position: center + offset, color, radiant_intensity }.into()
        };
        (0..count).map(light).collect()
    }
}

/// White surfaces under many lights.
fn scene(surfaces: Vec<Surface>, camera: Camera<f64>, lights: Vec<Light<f64>>) -> Scene {
    let mut scene = Scene::new(SIZE, SIZE, camera);
    for (index, light) in lights.into_iter().enumerate() {
        scene.add_light(index.to_string(), light).unwrap();
    }
    scene.add_material("white", Material::lambertian(DVec3::ONE)).unwrap();
    surfaces.into_iter().for_each(|surface| surface.add_to(&mut scene));
    scene
}

/// The radiance of each pixel under lights that all arrive.
fn unshadowed(surface: &Surface, camera: Camera<f64>, lights: &[Light<f64>]) -> Vec<f64> {
    let frame = camera_frame::<f64>(camera, 1.0);
    let position = |i: u32| (2.0 * f64::from(i) + 1.0) / f64::from(SIZE) - 1.0;
    let pixels = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y)));
    let radiance = |(x, y): (u32, u32)| {
        let ray = primary_ray::<f64>(frame, position(x), -position(y));
        let Some((distance, normal)) = surface.meet(ray.origin, ray.direction) else { return 0.0 };
        let point = ray.origin + ray.direction * distance;
        let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
        let reflected = |light: &Light<f64>| match light {
            Light::Distant(light) => normal.dot(light.direction.normalize()).max(0.0),
            Light::Point(light) => {
                let to_light = light.position - point;
                let squared = to_light.length_squared();
                let most = light.radiant_intensity / (PI * squared);
                most * (normal.dot(to_light) / squared.sqrt()).max(0.0)
            }
            light => unreachable!("{light:?}"),
        };
        lights.iter().map(reflected).sum()
    };
    pixels.map(radiance).collect()
}

/// Checks that every light arrives at the first of the surfaces where it is on the same side as the
/// camera, and else none.
#[track_caller]
fn check(name: &str, surfaces: Vec<Surface>, eye: DVec3, lights: Lights, count: usize) {
    let surface = &surfaces[0];
    let (center, radius) = (surface.center(), surface.radius());
    let inside = eye.distance(center) < radius;
    let all = inside == (lights == Lights::Inside);
    let lights = lights.around(center, radius, count);
    let look_at = if inside { center + dvec3(0.3, -0.2, -1.0) * radius } else { center };
    let camera =
        Camera { look_from: eye, look_at, up: dvec3(0.1, 0.9, 0.2), vfov: 40.0, film_scale: 1.0 };
    let expected = match all {
        true => unshadowed(surface, camera, &lights),
        false => vec![0.0; (SIZE * SIZE) as usize],
    };
    let scene = scene(surfaces, camera, lights);
    for arithmetic in ARITHMETICS {
        let image = render(&scene, arithmetic);
        check_pixels(name, arithmetic, &expected, &image.pixels);
    }
}

#[track_caller]
fn check_pixels(name: &str, arithmetic: Arithmetic, expected: &[f64], found: &[[f32; 3]]) {
    let brightest = expected.iter().copied().fold(0.0, f64::max).max(1.0);
    for (pixel, (expected, found)) in expected.iter().zip(found).enumerate() {
        let error = (f64::from(found[0]) - expected).abs() / brightest;
        assert!(
            error <= 1e-4,
            "{name}, {arithmetic:?}, pixel {pixel}: {} instead of {expected}",
            found[0]
        );
    }
}

fn check_everywhere(lights: usize) {
    let sphere = |center: DVec3, radius: f64| Surface::Sphere { center, radius };
    let mesh = |center: DVec3, radius: f64| Surface::Mesh { mesh: Mesh::sphere(2), center, radius };
    type Make = fn(DVec3, f64) -> Surface;
    let kinds: [(&str, Make); 2] = [("sphere", sphere), ("mesh", mesh)];
    for (kind, surface) in kinds {
        for exponent in [-8, 0, 8] {
            let size = 10.0_f64.powi(exponent);
            let radius = 0.3 * size;
            let center = dvec3(1.0, -0.7, 0.4) * size;
            let outside = center + dvec3(0.9, 1.1, 2.0) * radius;
            let inside = center + dvec3(-0.2, 0.3, 0.1) * radius;
            for (eye, place) in [(outside, "outside"), (inside, "inside")] {
                for (kind_of_light, which) in [
                    ("distant", Lights::Distant),
                    ("near", Lights::Outside),
                    ("enclosed", Lights::Inside),
                ] {
                    let name = format!("{kind} of size 1e{exponent} from {place}, {kind_of_light}");
                    // Coordinates are relative to the middle of the scene, which this moves.
                    let far = sphere(center * -20.0, 0.01 * radius);
                    check(&name, vec![surface(center, radius), far], eye, which, lights);
                }
            }
        }
    }
}

#[test]
fn concentric_spheres_keep_their_light_apart() {
    for scale in [1e-8, 1.0, 1e8] {
        let sphere = |radius: f64| Surface::Sphere { center: DVec3::X * scale, radius };
        let (inner, outer) = (scale, (1.0 + 4e-5) * scale);
        let eye = |offset: f64| (DVec3::X + DVec3::Y * offset) * scale;
        for which in [Lights::Distant, Lights::Outside, Lights::Inside] {
            for (name, seen, behind, offset) in
                [("from outside", outer, inner, 3.0), ("from inside", inner, outer, 0.4)]
            {
                let name = format!("concentric spheres of size {scale:e} {name}");
                check(&name, vec![sphere(seen), sphere(behind)], eye(offset), which, 100);
            }
        }
    }
}

#[test]
fn surfaces_neither_shadow_themselves_nor_leak() {
    check_everywhere(100);
}

#[test]
#[ignore = "a minute"]
fn a_thousand_lights() {
    check_everywhere(1000);
}
