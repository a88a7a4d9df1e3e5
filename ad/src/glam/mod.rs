//! All that knows of glam: the rules of its types, and what the traits of this crate say of them. Without
//! the feature `glam` there is none of it.

#![allow(clippy::wrong_self_convention, reason = "methods are named after those of glam")]
#![allow(
    clippy::type_complexity,
    clippy::too_many_arguments,
    reason = "a rule takes arguments and tangents, and returns a value and a closure"
)]

mod arrange;
mod geometry;
mod kin;
mod mapped;
mod matrix;
mod motion;
mod operators;
mod precision;
#[doc(hidden)]
pub mod swizzle;
mod values;
mod vector;

pub use arrange::{
    AlignRules, AlignedRules, ArrayRules, AsAlignedRules, ColumnSliceRules, RowSliceRules,
    SliceRules, With2Rules, With3Rules, With4Rules, construct,
};
#[doc(hidden)]
pub use arrange::{dvec2, dvec3, dvec4, vec2, vec3, vec4};
pub use kin::{Kin, Numbers};
pub use mapped::{DoubleMapRules, SingleMapRules};
pub use matrix::{
    EulerRules, Matrix2Rules, Matrix3Rules, Matrix4Rules, ProjectionRules, ResizedRules,
};
pub use motion::{
    Affine2Rules, Affine3Rules, AngleRules, PlaneColumnRules, PlaneMotionRules, QuaternionRules,
    RotationRules, ScaleAngleRules, SpaceColumnRules, TransformRules,
};
pub use precision::*;
pub use vector::{
    GlamRules, Select2Rules, Select3Rules, Select4Rules, SelectAlignedRules, SelectWideRules,
    SpaceRules, Vec2Rules, Vec4Rules,
};

/// The traits of the rules, without names.
pub(crate) mod methods {
    pub use super::precision::{
        ToAffine2 as _, ToAffine3 as _, ToDAffine2 as _, ToDAffine3 as _, ToDMat2 as _,
        ToDMat3 as _, ToDMat4 as _, ToDQuat as _, ToDVec2 as _, ToDVec3 as _, ToDVec4 as _,
        ToMat2 as _, ToMat3 as _, ToMat4 as _, ToQuat as _, ToVec2 as _, ToVec3 as _, ToVec4 as _,
    };
    pub use super::{
        Affine2Rules as _, Affine3Rules as _, AlignRules as _, AlignedRules as _, AngleRules as _,
        ArrayRules as _, AsAlignedRules as _, ColumnSliceRules as _, DoubleMapRules as _,
        EulerRules as _, GlamRules as _, Matrix2Rules as _, Matrix3Rules as _, Matrix4Rules as _,
        PlaneColumnRules as _, PlaneMotionRules as _, ProjectionRules as _, QuaternionRules as _,
        ResizedRules as _, RotationRules as _, RowSliceRules as _, ScaleAngleRules as _,
        Select2Rules as _, Select3Rules as _, Select4Rules as _, SelectAlignedRules as _,
        SelectWideRules as _, SingleMapRules as _, SliceRules as _, SpaceColumnRules as _,
        SpaceRules as _, TransformRules as _, Vec2Rules as _, Vec4Rules as _, With2Rules as _,
        With3Rules as _, With4Rules as _,
    };
}
