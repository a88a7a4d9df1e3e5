//! The cost of a gradient at kernel level: intersect and shade one pixel, 32 inputs. Nanoseconds
//! per pixel, the ratio to the primal and to an adjoint written by hand, medians over interleaved
//! repetitions.

use std::hint::black_box;

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Additive, Real, Scalar, Vec3, differentiable, tape};
use renderer::transport::camera::Ray;
use renderer::transport::direct::direct;
use renderer::transport::light::{PointLight, illuminate_by_point};
use renderer::transport::material::{Lobes, Material};
use renderer::transport::triangle::{Triangle, triangle_point};

use super::adjoint::{self, Cotangents};
use super::timing::{median, seconds};

#[differentiable]
fn pixel<S: Real>(
    ray: Ray<S>,
    triangle: Triangle<S>,
    material: Material<S>,
    light: PointLight<S>,
) -> Vec3<S> {
    let surface = triangle_point::<S>(triangle, ray);
    let arriving = illuminate_by_point::<S>(light, surface.point);
    let lobes = Lobes { rough: false, glossy: true, facets: false };
    direct::<S>(material, lobes, surface, arriving, S::ZERO.cmplt(S::ONE), S::ONE)
}

struct Inputs<S: Real> {
    rays: Vec<Ray<S>>,
    triangle: Triangle<S>,
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
            triangle: Triangle {
                a: vector::<S>(-5.0, -5.0, 0.1),
                b: vector::<S>(5.0, -5.0, 0.0),
                c: vector::<S>(0.0, 7.0, -0.2),
            },
            material: Material {
                emission: vector::<S>(0.0, 0.0, 0.0),
                diffuse: vector::<S>(0.7, 0.5, 0.3),
                roughness: S::ZERO,
                specular: vector::<S>(0.2, 0.2, 0.2),
                exponent: S::from_f64(20.0),
                mirror: Vector::splat(S::ZERO),
                opacity: S::ONE,
                metallic: S::ZERO,
                ior: S::ONE,
            },
            light: PointLight {
                position: vector::<S>(1.0, 2.0, 4.0),
                color: vector::<S>(1.0, 0.9, 0.8),
                radiant_intensity: S::from_f64(25.0),
            },
        }
    }
}

fn measure<S: Lanes>(name: &str) {
    let inputs = Inputs::<S>::new();
    let Inputs { rays, triangle, material, light } = &inputs;
    let seed = vector::<S>(1.0, 0.5, 0.25);
    let primal = || {
        let mut sum = <Vec3<S>>::zero();
        for &ray in rays {
            sum.accumulate(pixel::<S>(black_box(ray), *triangle, *material, *light));
        }
        sum
    };
    let generated = || {
        sum_up(rays, |ray| {
            let (value, pullback) = pixel::vjp::<S>(ray, *triangle, *material, *light);
            (value, pullback(seed))
        })
    };
    let by_hand =
        || sum_up(rays, |ray| adjoint::pixel::<S>(ray, *triangle, *material, *light, seed));
    let mut samples = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..51 {
        samples[0].push(repeated(20, primal));
        samples[1].push(repeated(20, generated));
        samples[2].push(repeated(20, by_hand));
    }
    let per_pixel = 1e9 / (20 * rays.len() * S::COUNT) as f64;
    let [primal, generated_time, hand] = samples.map(|samples| median(samples) * per_pixel);
    println!(
        "{name:7} value {primal:6.1} ns; with all 32 derivatives {generated_time:6.1} ns ({:.2} x), by hand {hand:6.1} ns: generated / by hand {:.2}, derivatives differ by {:.1e}",
        generated_time / primal,
        generated_time / hand,
        difference(&generated().1, &by_hand().1),
    );
}

/// The sums of values and cotangents over rays.
fn sum_up<S: Lanes>(
    rays: &[Ray<S>],
    vjp: impl Fn(Ray<S>) -> (Vec3<S>, Cotangents<S>),
) -> (Vec3<S>, Cotangents<S>) {
    let mut sums: (Vec3<S>, Cotangents<S>) = Additive::zero();
    for &ray in rays {
        sums.accumulate(vjp(black_box(ray)));
    }
    sums
}

/// The greatest difference between two sums, relative to the greatest number.
fn difference<S: Lanes>(a: &Cotangents<S>, b: &Cotangents<S>) -> f64 {
    let numbers = |(ray, triangle, material, light): &Cotangents<S>| -> Vec<f64> {
        let vectors = [
            ray.origin,
            ray.direction,
            triangle.a,
            triangle.b,
            triangle.c,
            material.diffuse,
            material.specular,
            light.position,
            light.color,
        ];
        let of_vectors = vectors.into_iter().flat_map(|v| [v.x(), v.y(), v.z()]);
        let all = of_vectors.chain([material.exponent, light.radiant_intensity]);
        all.flat_map(|x| x.lanes().as_ref().to_vec()).map(|x| x.to_f64()).collect()
    };
    let (a, b) = (numbers(a), numbers(b));
    let greatest = a.iter().fold(0.0, |greatest: f64, x| greatest.max(x.abs()));
    a.iter().zip(&b).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / greatest
}

/// Measures every scalar.
pub fn run() {
    measure::<f32>("f32");
    measure::<f64>("f64");
    measure::<wide::f32x8>("f32x8");
    measure::<wide::f32x16>("f32x16");
    measure::<wide::f64x8>("f64x8");
    other_ways();
}

/// The same pixel as a function of its 32 inputs.
fn brightness<S: Real>(x: &[S]) -> S {
    let v = |first: usize| <Vec3<S>>::new(x[first], x[first + 1], x[first + 2]);
    let (emission, diffuse, specular) = (v(15), v(18), v(21));
    let (roughness, mirror, opacity) = (S::ZERO, Vector::splat(S::ZERO), S::ONE);
    let (exponent, metallic, ior) = (x[24], S::ZERO, S::ONE);
    let material = Material {
        emission,
        diffuse,
        roughness,
        specular,
        exponent,
        mirror,
        opacity,
        metallic,
        ior,
    };
    let light = PointLight { position: v(25), color: v(28), radiant_intensity: x[31] };
    let ray = Ray { origin: v(0), direction: v(3) };
    let triangle = Triangle { a: v(6), b: v(9), c: v(12) };
    pixel::<S>(ray, triangle, material, light).element_sum()
}

/// The gradient on a tape and by finite differences.
fn other_ways() {
    let x = [
        0.1, 0.2, 3.0, 0.1, -0.05, -0.99, -5.0, -5.0, 0.1, 5.0, -5.0, 0.0, 0.0, 7.0, -0.2, 0.0,
        0.0, 0.0, 0.7, 0.5, 0.3, 0.2, 0.2, 0.2, 20.0, 1.0, 2.0, 4.0, 1.0, 0.9, 0.8, 25.0,
    ];
    let differences = |x: &[f64; 32]| -> [f64; 32] {
        std::array::from_fn(|i| {
            let at = |offset: f64| {
                let mut moved = *x;
                moved[i] += offset;
                brightness(&moved)
            };
            (at(1e-6) - at(-1e-6)) / 2e-6
        })
    };
    let mut samples = [Vec::new(), Vec::new(), Vec::new()];
    for _ in 0..51 {
        let times = [
            repeated(1000, || brightness(black_box(&x))),
            repeated(1000, || tape::gradient(brightness, black_box(&x))),
            repeated(1000, || differences(black_box(&x))),
        ];
        for (samples, time) in samples.iter_mut().zip(times) {
            samples.push(time);
        }
    }
    let [value, tape, differences] = samples.map(median);
    println!(
        "f64     value {:6.1} ns; on a tape {:.1} x, by central differences {:.1} x",
        value * 1e6,
        tape / value,
        differences / value
    );
}

/// How long so many runs take.
fn repeated<T>(times: u32, run: impl Fn() -> T) -> f64 {
    seconds(|| {
        for _ in 0..times {
            black_box(run());
        }
    })
}
