//! A Blinn-Phong shader with 16 inputs.

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable};
use glam::{DVec3, dvec3};

use crate::problem::Problem;
use crate::random::Random;

/// What a point is lit by and seen from, and what it is made of.
#[derive(Clone, Copy)]
pub struct Inputs<S: Real> {
    pub normal: Vec3<S>,
    pub light: Vec3<S>,
    pub view: Vec3<S>,
    pub albedo: Vec3<S>,
    pub specular: Vec3<S>,
    pub exponent: S,
}

impl<S: Real> Inputs<S> {
    /// From 16 numbers.
    pub fn new(x: &[S; 16]) -> Self {
        let vector = |at: usize| Vector3::new(x[at], x[at + 1], x[at + 2]);
        Self {
            normal: vector(0),
            light: vector(3),
            view: vector(6),
            albedo: vector(9),
            specular: vector(12),
            exponent: x[15],
        }
    }
}

/// Red, green and blue of the reflected light, weighted by `weights`.
#[differentiable]
pub fn shade<S: Real>(
    normal: Vec3<S>,
    light: Vec3<S>,
    view: Vec3<S>,
    albedo: Vec3<S>,
    specular: Vec3<S>,
    exponent: S,
) -> S {
    let to_light = light.normalize();
    let half = (to_light + view.normalize()).normalize();
    let unit = normal.normalize();
    let diffuse = unit.dot(to_light).max(S::ZERO);
    let highlight = unit.dot(half).max(S::ZERO).powf(exponent);
    let color = albedo * diffuse + specular * highlight;
    color.x() * S::from_f64(0.2126)
        + color.y() * S::from_f64(0.7152)
        + color.z() * S::from_f64(0.0722)
}

fn flat(vectors: [DVec3; 5], exponent: f64) -> [f64; 16] {
    std::array::from_fn(|at| if at < 15 { vectors[at / 3][at % 3] } else { exponent })
}

/// The gradient, written by hand.
pub fn adjoint(i: Inputs<f64>) -> [f64; 16] {
    let light_recip = i.light.length_recip();
    let view_recip = i.view.length_recip();
    let normal_recip = i.normal.length_recip();
    let (to_light, to_view) = (i.light * light_recip, i.view * view_recip);
    let between = to_light + to_view;
    let between_recip = between.length_recip();
    let half = between * between_recip;
    let unit = i.normal * normal_recip;
    let cosine = unit.dot(to_light);
    let half_cosine = unit.dot(half);
    let diffuse = cosine.max(0.0);
    let base = half_cosine.max(0.0);
    let highlight = base.powf(i.exponent);

    let color_bar = dvec3(0.2126, 0.7152, 0.0722);
    let albedo_bar = color_bar * diffuse;
    let specular_bar = color_bar * highlight;
    let diffuse_bar = color_bar.dot(i.albedo);
    let highlight_bar = color_bar.dot(i.specular);
    let cosine_bar = if cosine > 0.0 { diffuse_bar } else { 0.0 };
    let (half_cosine_bar, exponent_bar) = if base > 0.0 {
        let scaled = highlight_bar * highlight;
        (scaled * i.exponent / base, scaled * base.ln())
    } else {
        (0.0, 0.0)
    };
    let across = |bar: DVec3, unit: DVec3, recip: f64| (bar - unit * unit.dot(bar)) * recip;
    let between_bar = across(unit * half_cosine_bar, half, between_recip);
    let unit_bar = half * half_cosine_bar + to_light * cosine_bar;
    flat(
        [
            across(unit_bar, unit, normal_recip),
            across(unit * cosine_bar + between_bar, to_light, light_recip),
            across(between_bar, to_view, view_recip),
            albedo_bar,
            specular_bar,
        ],
        exponent_bar,
    )
}

pub struct Shading;

impl Problem for Shading {
    const NAME: &'static str = "shading, 16 inputs";
    const OUTPUTS: usize = 1;

    fn point(&self) -> Vec<f64> {
        let mut random = Random::new(2);
        let mut x = random.numbers::<16>().map(|x| 0.2 * x + 0.5);
        x[15] = 20.0;
        x.to_vec()
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        let i = Inputs::new(x.first_chunk().expect("16 numbers"));
        outputs[0] = shade::<S>(i.normal, i.light, i.view, i.albedo, i.specular, i.exponent);
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        let i = Inputs::<f64>::new(x.first_chunk().expect("16 numbers"));
        let (normal, light, view, albedo, specular, exponent) =
            shade::grad::<f64>(i.normal, i.light, i.view, i.albedo, i.specular, i.exponent);
        jacobian.copy_from_slice(&flat([normal, light, view, albedo, specular], exponent));
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let [i, d] =
            [x, direction].map(|x| Inputs::<f64>::new(x.first_chunk().expect("16 numbers")));
        (_, tangents[0]) = shade::jvp::<f64>(
            i.normal, i.light, i.view, i.albedo, i.specular, i.exponent, //
            d.normal, d.light, d.view, d.albedo, d.specular, d.exponent,
        );
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        let inputs = Inputs::new(x.first_chunk().expect("16 numbers"));
        jacobian.copy_from_slice(&adjoint(inputs));
    }
}
