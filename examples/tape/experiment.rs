//! The loss of a small image of one triangle, as one function of everything that it depends on.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable};
use renderer::transport::camera::{Camera, camera_frame, primary_ray};
use renderer::transport::direct::direct;
use renderer::transport::light::{PointLight, illuminate_by_point};
use renderer::transport::material::{Lobes, Material};
use renderer::transport::triangle::{Triangle, triangle_point};

/// Camera, the corners of a triangle that fills the image, material and light: 43 numbers.
pub const INPUTS: [f64; 43] = [
    0.1, 0.2, 3.0, 0.0, 0.1, 0.0, 0.0, 1.0, 0.0, 40.0,
    1.0, // look_from, look_at, up, vfov, film_scale
    -9.0, -8.0, 0.1, 9.0, -8.0, 0.0, 0.0, 9.0, -0.2, // corners
    0.02, 0.03, 0.04, 0.7, 0.5, 0.3, 0.2, 0.25, 0.3, 0.0, 0.0, 0.0, 20.0, // material
    1.0, 2.0, 4.0, 1.0, 0.9, 0.8, 25.0, // light: position, colour, radiant intensity
    0.3, 0.2, 0.1, // the colour that every pixel should have
];

/// What pixels share, from the numbers.
#[differentiable]
fn vector<S: Real>(x: &[S], first: usize) -> Vec3<S> {
    <Vec3<S>>::new(x[first], x[first + 1], x[first + 2])
}

/// The sum over pixels of the squared difference between their radiance and the wanted colour.
#[differentiable]
pub fn image_loss<S: Real>(x: &[S], size: usize) -> S {
    let camera = Camera {
        look_from: vector::<S>(x, 0),
        look_at: vector::<S>(x, 3),
        up: vector::<S>(x, 6),
        vfov: x[9],
        film_scale: x[10],
    };
    let frame = camera_frame::<S>(camera, S::ONE);
    let triangle = Triangle { a: vector::<S>(x, 11), b: vector::<S>(x, 14), c: vector::<S>(x, 17) };
    let material = Material {
        roughness: S::ZERO,
        emission: vector::<S>(x, 20),
        diffuse: vector::<S>(x, 23),
        specular: vector::<S>(x, 26),
        mirror: vector::<S>(x, 29),
        exponent: x[32],
        opacity: S::ONE,
        metallic: S::ZERO,
        ior: S::ONE,
    };
    let light = PointLight {
        position: vector::<S>(x, 33),
        color: vector::<S>(x, 36),
        radiant_intensity: x[39],
    };
    let lit = S::ZERO.cmplt(S::ONE);
    let wanted = vector::<S>(x, 40);
    let mut loss = S::ZERO;
    for row in 0..size {
        for column in 0..size {
            let place = |index: usize| S::from_f64((2 * index + 1) as f64 / size as f64 - 1.0);
            let ray = primary_ray::<S>(frame, place(column), place(row));
            let surface = triangle_point::<S>(triangle, ray);
            let arriving = illuminate_by_point::<S>(light, surface.point);
            let lobes = Lobes { rough: false, glossy: true, facets: false };
            let reflected = direct::<S>(material, lobes, surface, arriving, lit, S::ONE);
            let radiance = material.emission + reflected;
            let difference = radiance - wanted;
            loss += difference.dot(difference);
        }
    }
    loss
}
