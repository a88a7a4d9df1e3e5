//! Between the `f64` of the scene and the scalar of the kernels: parameters go down, cotangents
//! come up.

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
            pub fn add<S: Scalar>(&mut self, cotangent: &$tangent<S>) {
                $(self.$vector += widen::<S>(cotangent.$vector);)*
                $(self.$scalar += cotangent.$scalar.to_f64();)*
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
