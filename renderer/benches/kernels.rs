//! The cost of a gradient at kernel level: intersect and shade one pixel, 32 inputs.
//!
//! `cargo bench -p renderer --bench kernels` prints nanoseconds per call and the ratio to the
//! primal, medians over interleaved repetitions.

use std::hint::black_box;
use std::time::Instant;

use ad::lanes::Lanes;
use ad::{Additive, Real, Vec3, differentiable};
use renderer::kernels::camera::Ray;
use renderer::kernels::light::PointLight;
use renderer::kernels::material::{Material, reflection_of_point_light};
use renderer::kernels::triangle::triangle_surface;

#[differentiable]
fn pixel<S: Real>(
    ray: Ray<S>,
    a: Vec3<S>,
    b: Vec3<S>,
    c: Vec3<S>,
    material: Material<S>,
    light: PointLight<S>,
) -> Vec3<S> {
    let surface = triangle_surface::<S>(ray, a, b, c);
    reflection_of_point_light::<S>(material, surface, light)
}

struct Inputs<S: Real> {
    rays: Vec<Ray<S>>,
    a: Vec3<S>,
    b: Vec3<S>,
    c: Vec3<S>,
    material: Material<S>,
    light: PointLight<S>,
}

fn vector<S: Real>(x: f64, y: f64, z: f64) -> Vec3<S> {
    ad::vector::Vector3::new(S::from_f64(x), S::from_f64(y), S::from_f64(z))
}

impl<S: Real> Inputs<S> {
    fn new() -> Self {
        let rays = (0..1024).map(|i| {
            let (x, y) = (f64::from(i % 32) / 32.0 - 0.5, f64::from(i / 32) / 32.0 - 0.5);
            let direction = vector::<S>(x, y, -1.0);
            Ray {
                origin: vector::<S>(0.1, 0.2, 3.0),
                direction: ad::vector::Vector::normalize(direction),
            }
        });
        Self {
            rays: rays.collect(),
            a: vector::<S>(-5.0, -5.0, 0.1),
            b: vector::<S>(5.0, -5.0, 0.0),
            c: vector::<S>(0.0, 7.0, -0.2),
            material: Material {
                ambient: vector::<S>(0.0, 0.0, 0.0),
                diffuse: vector::<S>(0.7, 0.5, 0.3),
                specular: vector::<S>(0.2, 0.2, 0.2),
                exponent: S::from_f64(20.0),
            },
            light: PointLight {
                position: vector::<S>(1.0, 2.0, 4.0),
                color: vector::<S>(1.0, 0.9, 0.8),
                intensity: S::from_f64(100.0),
            },
        }
    }
}

fn seconds(mut run: impl FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..20 {
        run();
    }
    start.elapsed().as_secs_f64() / 20.0
}

fn median(mut samples: Vec<f64>) -> f64 {
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 2]
}

fn measure<S: Lanes>(name: &str) {
    let inputs = Inputs::<S>::new();
    let Inputs { rays, a, b, c, material, light } = &inputs;
    let seed = vector::<S>(1.0, 0.5, 0.25);
    let mut samples = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..51 {
        samples[0].push(seconds(|| {
            let mut sum = <Vec3<S>>::zero();
            for &ray in rays {
                let ray = black_box(ray);
                sum.accumulate(pixel::<S>(ray, *a, *b, *c, *material, *light));
            }
            black_box(sum);
        }));
        samples[1].push(seconds(|| {
            let mut sum = <Vec3<S>>::zero();
            let mut gradient = ad::Additive::zero();
            for &ray in rays {
                let ray = black_box(ray);
                let (value, pullback) = pixel::vjp::<S>(ray, *a, *b, *c, *material, *light);
                sum.accumulate(value);
                add(&mut gradient, pullback(seed));
            }
            black_box((sum, gradient));
        }));
        samples[2].push(seconds(|| {
            let mut sum = <Vec3<S>>::zero();
            let mut gradient = ad::Additive::zero();
            for &ray in rays {
                let ray = black_box(ray);
                let (value, pullback) = pixel::vjp::<S>(ray, *a, *b, *c, *material, *light);
                sum.accumulate(value);
                add(&mut gradient, pullback(seed).5);
            }
            black_box((sum, gradient));
        }));
    }
    let [primal, all, light_only] = samples.map(median);
    let per_call = 1e9 / (rays.len() * S::COUNT) as f64;
    println!(
        "{name}: primal {:.1} ns, value and all 32 derivatives {:.1} ns ({:.2} x), value and light {:.1} ns ({:.2} x)",
        primal * per_call,
        all * per_call,
        all / primal,
        light_only * per_call,
        light_only / primal,
    );
}

fn add<T: Additive>(sum: &mut T, term: T) {
    sum.accumulate(term);
}

fn main() {
    measure::<f32>("f32");
    measure::<f64>("f64");
    measure::<wide::f32x8>("f32x8");
    measure::<wide::f32x16>("f32x16");
}
