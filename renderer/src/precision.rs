//! Between the `f64` of the scene and the scalar of the kernels: parameters go down, cotangents
//! come up.

use ad::lanes::Lanes;
use ad::vector::Vector3;
use ad::{Real, Scalar, Select, Vec3, select};
use glam::DVec3;
use wide::f64x8;

use crate::kernels::camera::{Camera, CameraTangent, Frame, FrameTangent, Ray, RayTangent};
use crate::kernels::light::{DistantLight, DistantLightTangent, PointLight, PointLightTangent};
use crate::kernels::material::{Material, MaterialTangent};
use crate::kernels::sphere::{Sphere, SphereTangent};
use crate::kernels::texture::{Uv, UvTangent};
use crate::scene::Light;

/// A vector in the precision of the kernels.
#[inline]
pub fn narrow<S: Real>(v: DVec3) -> Vec3<S> {
    Vector3::new(S::from_f64(v.x), S::from_f64(v.y), S::from_f64(v.z))
}

/// A vector in double precision.
#[inline]
pub fn widen<S: Scalar>(v: Vec3<S>) -> DVec3 {
    DVec3::new(v.x().to_f64(), v.y().to_f64(), v.z().to_f64())
}

/// The most lanes that a scalar has.
pub const MOST_LANES: usize = 16;

/// A number in every lane.
#[inline]
pub fn splat<L: Lanes>(x: L::Element) -> L {
    L::from_lanes(|_| x)
}

/// A vector in every lane.
#[inline]
pub fn splat_vector<L: Lanes>(v: Vec3<L::Element>) -> Vec3<L> {
    Vector3::new(splat(v.x()), splat(v.y()), splat(v.z()))
}

/// What `convert` makes of the number in each lane; those beyond the last lane are zero.
#[inline]
fn each_lane<L: Lanes, T: Copy + Default>(x: L, convert: impl Fn(f64) -> T) -> [T; MOST_LANES] {
    let mut numbers = [T::default(); MOST_LANES];
    for (number, x) in numbers.iter_mut().zip(x.lanes().as_ref()) {
        *number = convert(x.to_f64());
    }
    numbers
}

/// The number in each lane, in single precision; those beyond the last lane are zero.
#[inline]
pub fn singles_of_lanes<L: Lanes>(x: L) -> [f32; MOST_LANES] {
    each_lane(x, |x| x as f32)
}

/// The number in each lane, in double precision; those beyond the last lane are zero.
#[inline]
pub fn numbers_of_lanes<L: Lanes>(x: L) -> [f64; MOST_LANES] {
    each_lane(x, |x| x)
}

/// The vector in each lane, in double precision; those beyond the last lane are zero.
#[inline]
pub fn vectors_of_lanes<L: Lanes>(v: Vec3<L>) -> [DVec3; MOST_LANES] {
    let [x, y, z] = [v.x(), v.y(), v.z()].map(numbers_of_lanes);
    std::array::from_fn(|lane| DVec3::new(x[lane], y[lane], z[lane]))
}

/// The vectors side by side.
#[inline]
pub fn lanes_of_vectors<L: Lanes>(vectors: &[DVec3; MOST_LANES]) -> Vec3<L> {
    let along = |axis: usize| L::from_lanes(|lane| L::Element::from_f64(vectors[lane][axis]));
    Vector3::new(along(0), along(1), along(2))
}

/// The sum of the lanes in which `mask` holds, in double precision.
#[inline]
pub fn sum_of_lanes<L: Lanes>(x: L, mask: L::Mask) -> f64 {
    let numbers = numbers_of_lanes(select(mask, x, L::ZERO));
    if L::COUNT == 1 {
        return numbers[0];
    }
    let (low, high) = numbers.split_at(MOST_LANES / 2);
    (f64x8::from(low) + f64x8::from(high)).reduce_add()
}

/// The sum of the vectors in the lanes in which `mask` holds, in double precision.
#[inline]
pub fn sum_of_vectors<L: Lanes>(v: Vec3<L>, mask: L::Mask) -> DVec3 {
    DVec3::new(sum_of_lanes(v.x(), mask), sum_of_lanes(v.y(), mask), sum_of_lanes(v.z(), mask))
}

impl Light<f64> {
    /// The parameters in the precision of the kernels.
    pub fn narrow<S: Real>(&self) -> Light<S> {
        match self {
            Self::Point(light) => Light::Point(light.narrow()),
            Self::Distant(light) => Light::Distant(light.narrow()),
        }
    }
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

            /// Adds a cotangent to a gradient.
            pub fn add(&mut self, cotangent: &$tangent<f64>) {
                $(self.$vector += cotangent.$vector;)*
                $(self.$scalar += cotangent.$scalar;)*
            }
        }

        impl<S: Scalar> $type<S> {
            /// The same parameters in every lane.
            #[inline]
            pub fn splat<L: Lanes<Element = S>>(&self) -> $type<L> {
                $type {
                    $($vector: splat_vector::<L>(self.$vector),)*
                    $($scalar: splat::<L>(self.$scalar),)*
                }
            }
        }

        impl<S: Real> Select for $type<S> {
            type Mask = S::Mask;

            #[inline]
            fn select(mask: S::Mask, if_true: Self, if_false: Self) -> Self {
                Self {
                    $($vector: select(mask, if_true.$vector, if_false.$vector),)*
                    $($scalar: select(mask, if_true.$scalar, if_false.$scalar),)*
                }
            }
        }

        impl $tangent<f64> {
            /// Whether every number of it is.
            pub fn is_finite(&self) -> bool {
                $(self.$vector.is_finite() &&)* $(self.$scalar.is_finite() &&)* true
            }
        }

        impl<L: Lanes> $tangent<L> {
            /// The sum of the cotangents in the lanes in which `mask` holds.
            #[inline]
            pub fn sum(&self, mask: L::Mask) -> $tangent<f64> {
                $tangent {
                    $($vector: sum_of_vectors::<L>(self.$vector, mask),)*
                    $($scalar: sum_of_lanes(self.$scalar, mask),)*
                }
            }
        }
    )*};
}

parameters! {
    Camera, CameraTangent { look_from look_at up } { vfov focus }
    Frame, FrameTangent { origin forward right up } {}
    Ray, RayTangent { origin direction } {}
    PointLight, PointLightTangent { position color } { intensity }
    DistantLight, DistantLightTangent { direction color } { intensity }
    Material, MaterialTangent { ambient diffuse specular reflection } { exponent }
    Sphere, SphereTangent { center } { radius }
    Uv, UvTangent {} { u v }
}
