//! What light does: the mathematics of the renderer, once.
//!
//! In tracing order: a [`camera`] sends a ray through a pixel; [`hit`] gives the surface point on the
//! [`triangle`], flat or [`smooth`], [`sphere`] or custom [`shape`] that it meets; a [`texture`]
//! varies the [`material`] there, or bends the normal as a [`normal_map`]; the [`brdf`] is that of
//! [`blinn_phong`] or of [`microfacet`]; [`direct`]
//! gives what the [`illumination`] by a [`light`], or a part of an [`area_light`], makes the surface reflect; [`vertex`] puts together what leaves a path vertex and
//! the ray to the next one. Where light takes all paths, [`emitter`] gives what surfaces that shine bring to
//! others, [`scatter`] and [`dielectric`] where it goes on from a surface, and [`environment`] what surrounds
//! the scene. [`transform`] places geometry in the world, and [`depth`] tells how far it is from the camera.
//!
//! Every function is `#[differentiable]` and generic over `S:` [`Real`], so one source runs at
//! `f32`, `f64`, on SIMD lanes, dual numbers, a tape, and in extended precision, and its pullback is
//! generated. Functions choose with `select`, `max` and `min` instead of `if`, because lanes may differ.
//! There are no images, indices or scenes here: which primitive a ray hits, and whether a light is
//! visible, is decided by tracing and not differentiated; a function recomputes the hit from the
//! primitive's own parameters.
//!
//! Units are those of radiometry in linear RGB: radiance W/(m² sr), irradiance W/m², radiant intensity
//! W/sr.

pub mod area_light;
pub mod blinn_phong;
pub mod brdf;
pub mod camera;
pub mod depth;
pub mod dielectric;
pub mod direct;
pub mod direction;
pub mod edge;
pub mod emitter;
pub mod environment;
pub mod hit;
pub mod illumination;
pub mod light;
pub mod material;
pub mod microfacet;
pub mod normal_map;
pub mod scatter;
pub mod shape;
pub mod smooth;
pub mod sphere;
pub mod surface;
pub mod texture;
pub mod transform;
pub mod triangle;
pub mod vertex;

use ad::{Real, differentiable, select};

/// `x`, or 0 where it is negative. Unlike `max` it keeps NaN, so that NaN shows in the image.
#[differentiable]
#[inline]
pub fn positive_part<S: Real>(x: S) -> S {
    select(x.cmplt(S::ZERO), S::ZERO, x)
}
