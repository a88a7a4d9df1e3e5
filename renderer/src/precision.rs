//! Between the `f64` of the scene and the scalar of the kernels: parameters go down, cotangents
//! come up.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Real, Scalar, Vec3};
use glam::DVec3;

use crate::kernels::camera::{Camera, CameraTangent, Frame, FrameTangent};
use crate::kernels::light::{DistantLight, DistantLightTangent, PointLight, PointLightTangent};
use crate::kernels::material::{Material, MaterialTangent};
use crate::kernels::sphere::{Sphere, SphereTangent};

/// A vector in the precision of the kernels.
pub fn narrow<S: Real>(v: DVec3) -> Vec3<S> {
    Vector3::new(S::from_f64(v.x), S::from_f64(v.y), S::from_f64(v.z))
}

/// A vector in double precision.
pub fn widen<S: Scalar>(v: Vec3<S>) -> DVec3 {
    DVec3::new(v.x().to_f64(), v.y().to_f64(), v.z().to_f64())
}

/// The most lanes that a scalar has.
pub const MOST_LANES: usize = 16;

/// The vectors that `f` gives for lanes 0, 1, .., side by side.
#[inline]
pub fn lanes_of_vectors<L: Lanes>(f: impl Fn(usize) -> Vec3<L::Element>) -> Vec3<L> {
    Vector3::new(
        L::from_lanes(|lane| f(lane).x()),
        L::from_lanes(|lane| f(lane).y()),
        L::from_lanes(|lane| f(lane).z()),
    )
}

/// The vector in each lane, in double precision; those beyond the last lane are zero.
#[inline]
pub fn vectors_of_lanes<L: Lanes>(v: Vec3<L>) -> [DVec3; MOST_LANES] {
    let (x, y, z) = (v.x().lanes(), v.y().lanes(), v.z().lanes());
    let elements = x.as_ref().iter().zip(y.as_ref()).zip(z.as_ref());
    let mut vectors = [DVec3::ZERO; MOST_LANES];
    for (vector, ((x, y), z)) in vectors.iter_mut().zip(elements) {
        *vector = DVec3::new(x.to_f64(), y.to_f64(), z.to_f64());
    }
    vectors
}

/// The number in each lane, in double precision; those beyond the last lane are zero.
#[inline]
pub fn numbers_of_lanes<L: Lanes>(x: L) -> [f64; MOST_LANES] {
    let mut numbers = [0.0; MOST_LANES];
    for (number, x) in numbers.iter_mut().zip(x.lanes().as_ref()) {
        *number = x.to_f64();
    }
    numbers
}

macro_rules! parameters {
    ($($type:ident, $tangent:ident { $($vector:ident)* } { $($scalar:ident)* })*) => {$(
        impl $type<f64> {
            /// The parameters in the precision of the kernels.
            pub fn narrow<S: Real>(&self) -> $type<S> {
                $type {
                    $($vector: narrow::<S>(self.$vector),)*
                    $($scalar: S::from_f64(self.$scalar),)*
                }
            }

            /// Zero everywhere: a gradient before anything has been added.
            pub fn zero() -> Self {
                Self { $($vector: DVec3::ZERO,)* $($scalar: 0.0,)* }
            }

            /// Adds the cotangents in all lanes to a gradient.
            pub fn add<L: Lanes>(&mut self, cotangent: &$tangent<L>) {
                $(self.$vector += vectors_of_lanes::<L>(cotangent.$vector).iter().sum::<DVec3>();)*
                $(self.$scalar += numbers_of_lanes(cotangent.$scalar).iter().sum::<f64>();)*
            }

            /// Adds the cotangent in each of the first lanes to a gradient of its own.
            ///
            /// `target` gets the lane and a function that adds to the gradient it is given.
            pub fn scatter<L: Lanes>(
                cotangent: &$tangent<L>,
                count: usize,
                mut target: impl FnMut(usize, &dyn Fn(&mut Self)),
            ) {
                $(let $vector = vectors_of_lanes::<L>(cotangent.$vector);)*
                $(let $scalar = numbers_of_lanes(cotangent.$scalar);)*
                for lane in 0..count {
                    target(lane, &|sum| {
                        $(sum.$vector += $vector[lane];)*
                        $(sum.$scalar += $scalar[lane];)*
                    });
                }
            }

            /// Adds another gradient.
            pub fn merge(&mut self, other: &Self) {
                $(self.$vector += other.$vector;)*
                $(self.$scalar += other.$scalar;)*
            }
        }
    )*};
}

parameters! {
    Camera, CameraTangent { look_from look_at up } { vfov focus }
    Frame, FrameTangent { origin forward right up } {}
    PointLight, PointLightTangent { position color } { intensity }
    DistantLight, DistantLightTangent { direction color } { intensity }
    Material, MaterialTangent { ambient diffuse specular } { exponent }
    Sphere, SphereTangent { center } { radius }
}
