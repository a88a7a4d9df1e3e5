//! Derivatives of functions of glam that are those of a formula: glam gives the value, and both modes
//! differentiate the [formula](super::geometry).

#![allow(clippy::type_complexity)]

use glam::{Affine2, Affine3, Mat2, Mat3, Mat4, Quat, Vec2, Vec3, Vec4};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DMat4, DQuat, DVec2, DVec3, DVec4};

use super::{DivPullback, MulPullback, geometry};
use crate::{Additive, Differentiable, Real};

/// What formulas compute with: the numbers of a value.
pub trait Numbers: Sized {
    /// Arrays, and tuples of such.
    type Array;
    /// The numbers.
    fn numbers(self) -> Self::Array;
    /// What has these numbers.
    fn of_numbers(numbers: Self::Array) -> Self;
}

macro_rules! numbers {
    ($($type:ident [$array:ty] $to:ident $of:ident($($by:tt)?);)*) => {$(
        impl Numbers for $type {
            type Array = $array;

            #[inline(always)]
            fn numbers(self) -> $array {
                self.$to()
            }

            #[inline(always)]
            fn of_numbers(numbers: $array) -> Self {
                Self::$of($($by)? numbers)
            }
        }
    )*};
}

numbers! {
    f32 [f32] into from();
    Vec2 [[f32; 2]] to_array from_array();
    Vec3 [[f32; 3]] to_array from_array();
    Vec4 [[f32; 4]] to_array from_array();
    Quat [[f32; 4]] to_array from_array();
    Mat2 [[[f32; 2]; 2]] to_cols_array_2d from_cols_array_2d(&);
    Mat3 [[[f32; 3]; 3]] to_cols_array_2d from_cols_array_2d(&);
    Mat4 [[[f32; 4]; 4]] to_cols_array_2d from_cols_array_2d(&);
    Affine2 [[[f32; 2]; 3]] to_cols_array_2d from_cols_array_2d(&);
    Affine3 [[[f32; 3]; 4]] to_cols_array_2d from_cols_array_2d(&);
    f64 [f64] into from();
    DVec2 [[f64; 2]] to_array from_array();
    DVec3 [[f64; 3]] to_array from_array();
    DVec4 [[f64; 4]] to_array from_array();
    DQuat [[f64; 4]] to_array from_array();
    DMat2 [[[f64; 2]; 2]] to_cols_array_2d from_cols_array_2d(&);
    DMat3 [[[f64; 3]; 3]] to_cols_array_2d from_cols_array_2d(&);
    DMat4 [[[f64; 4]; 4]] to_cols_array_2d from_cols_array_2d(&);
    DAffine2 [[[f64; 2]; 3]] to_cols_array_2d from_cols_array_2d(&);
    DAffine3 [[[f64; 3]; 4]] to_cols_array_2d from_cols_array_2d(&);
}

macro_rules! tuples {
    ($(($($name:ident $index:tt),*))*) => {$(
        impl<$($name: Numbers),*> Numbers for ($($name,)*) {
            type Array = ($($name::Array,)*);

            #[inline(always)]
            fn numbers(self) -> Self::Array {
                ($(self.$index.numbers(),)*)
            }

            #[inline(always)]
            fn of_numbers(numbers: Self::Array) -> Self {
                ($($name::of_numbers(numbers.$index),)*)
            }
        }
    )*};
}

tuples!((A 0, B 1) (A 0, B 1, C 2) (A 0, B 1, C 2, D 3));

/// The types of glam of one precision.
pub trait Kin: Sized {
    /// A number.
    type S: Real;
    /// This type.
    type Own;
    /// A vector of the plane.
    type V2;
    /// A vector of space.
    type V3;
    /// A quaternion.
    type Q;
    /// A matrix of two columns.
    type M2;
    /// A matrix of three columns.
    type M3;
    /// A matrix of four columns.
    type M4;
    /// Axis and angle.
    type Turn;
}

macro_rules! kin {
    ($($scalar:ident $v2:ident $v3:ident $q:ident $m2:ident $m3:ident $m4:ident: $($type:ident)*;)*) => {$($(
        impl Kin for $type {
            type S = $scalar;
            type Own = Self;
            type V2 = $v2;
            type V3 = $v3;
            type Q = $q;
            type M2 = $m2;
            type M3 = $m3;
            type M4 = $m4;
            type Turn = ($v3, $scalar);
        }
    )*)*};
}

macro_rules! each_kin {
    ($($scalar:ident $v2:ident $v3:ident $v4:ident $q:ident $m2:ident $m3:ident $m4:ident $a2:ident $a3:ident;)*) => {
        kin! {$(
            $scalar $v2 $v3 $q $m2 $m3 $m4: $v2 $v3 $v4 $q $m2 $m3 $m4 $a2 $a3;
        )*}
    };
}

each_kin! {
    f32 Vec2 Vec3 Vec4 Quat Mat2 Mat3 Mat4 Affine2 Affine3;
    f64 DVec2 DVec3 DVec4 DQuat DMat2 DMat3 DMat4 DAffine2 DAffine3;
}

/// The siblings for both modes of methods (`fn`) and of functions that make such a value (`new`). A row
/// is the name of the method, those of its siblings, the arguments with their tangents, and the formula.
macro_rules! by_formula {
    ($(#[$doc:meta])* $rules:ident: $($type:ident)* { $($row:tt)* }) => {
        $(#[$doc])*
        pub trait $rules: Kin {
            by_formula!(@declare $($row)*);
        }

        by_formula!(@each $rules { $($row)* } $($type)*);
    };
    (@each $rules:ident $rows:tt $($type:ident)*) => {$(
        impl $rules for $type {
            by_formula!(@define $rows);
        }
    )*};
    (@declare $($kind:ident $method:ident $vjp:ident $jvp:ident
        ($($x:ident $dot:ident: $X:ident),*) -> $R:ident = $formula:path;)*) => {$(
        by_formula!(@declared $kind $method $vjp $jvp ($($x $dot: $X),*) -> $R);
    )*};
    (@declared fn $method:ident $vjp:ident $jvp:ident ($($x:ident $dot:ident: $X:ident),*) -> $R:ident) => {
        #[doc = concat!("The derivative of `", stringify!($method), "`.")]
        fn $vjp(
            self,
            $($x: Self::$X),*
        ) -> (Self::$R, impl FnOnce(Self::$R) -> by_formula!(@parts Self $(, Self::$X)*));
        #[doc = concat!("The derivative of `", stringify!($method), "` along tangents.")]
        fn $jvp(
            self,
            $($x: Self::$X,)*
            tangent: Self,
            $($dot: Self::$X),*
        ) -> (Self::$R, Self::$R);
    };
    (@declared new $method:ident $vjp:ident $jvp:ident ($($x:ident $dot:ident: $X:ident),*) -> $R:ident) => {
        #[doc = concat!("The derivative of `", stringify!($method), "`.")]
        fn $vjp($($x: Self::$X),*) -> (Self, impl FnOnce(Self) -> by_formula!(@parts $(Self::$X),*));
        #[doc = concat!("The derivative of `", stringify!($method), "` along tangents.")]
        fn $jvp($($x: Self::$X,)* $($dot: Self::$X),*) -> (Self, Self);
    };
    (@define { $($kind:ident $method:ident $vjp:ident $jvp:ident
        ($($x:ident $dot:ident: $X:ident),*) -> $R:ident = $formula:path;)* }) => {$(
        by_formula!(@defined $kind $method $vjp $jvp ($($x $dot: $X),*) -> $R = $formula);
    )*};
    (@defined fn $method:ident $vjp:ident $jvp:ident
        ($($x:ident $dot:ident: $X:ident),*) -> $R:ident = $formula:path) => {
        #[inline(always)]
        fn $vjp(
            self,
            $($x: <Self as Kin>::$X),*
        ) -> (
            <Self as Kin>::$R,
            impl FnOnce(<Self as Kin>::$R) -> by_formula!(@parts Self $(, <Self as Kin>::$X)*),
        ) {
            (self.$method($($x),*), move |cotangent: <Self as Kin>::$R| {
                use $formula as formula;
                let (_, pullback) = formula::vjp(self.numbers(), $($x.numbers()),*);
                Numbers::of_numbers(pullback(cotangent.numbers()))
            })
        }

        #[inline(always)]
        fn $jvp(
            self,
            $($x: <Self as Kin>::$X,)*
            tangent: Self,
            $($dot: <Self as Kin>::$X),*
        ) -> (<Self as Kin>::$R, <Self as Kin>::$R) {
            use $formula as formula;
            let (_, along) = formula::jvp(
                self.numbers(),
                $($x.numbers(),)*
                tangent.numbers(),
                $($dot.numbers()),*
            );
            (self.$method($($x),*), Numbers::of_numbers(along))
        }
    };
    (@defined new $method:ident $vjp:ident $jvp:ident
        ($($x:ident $dot:ident: $X:ident),*) -> $R:ident = $formula:path) => {
        #[inline(always)]
        fn $vjp(
            $($x: <Self as Kin>::$X),*
        ) -> (Self, impl FnOnce(Self) -> by_formula!(@parts $(<Self as Kin>::$X),*)) {
            (Self::$method($($x),*), move |cotangent: Self| {
                use $formula as formula;
                let (_, pullback) = formula::vjp($($x.numbers()),*);
                Numbers::of_numbers(pullback(cotangent.numbers()))
            })
        }

        #[inline(always)]
        fn $jvp($($x: <Self as Kin>::$X,)* $($dot: <Self as Kin>::$X),*) -> (Self, Self) {
            use $formula as formula;
            let (_, along) = formula::jvp($($x.numbers(),)* $($dot.numbers()),*);
            (Self::$method($($x),*), Numbers::of_numbers(along))
        }
    };
    (@parts $part:ty) => { $part };
    (@parts $($part:ty),*) => { ($($part),*) };
}

by_formula! {
    /// Methods that vectors of any length have.
    LengthRules: Vec2 Vec3 Vec4 DVec2 DVec3 DVec4 {
        fn normalize_or normalize_or_vjp normalize_or_jvp
            (fallback fallback_dot: Own) -> Own = geometry::normalize_or;
        fn reject_from reject_from_vjp reject_from_jvp
            (onto onto_dot: Own) -> Own = geometry::reject_from;
        fn project_onto_normalized project_onto_normalized_vjp project_onto_normalized_jvp
            (onto onto_dot: Own) -> Own = geometry::project_onto_normalized;
        fn reject_from_normalized reject_from_normalized_vjp reject_from_normalized_jvp
            (onto onto_dot: Own) -> Own = geometry::reject_from_normalized;
        fn clamp_length clamp_length_vjp clamp_length_jvp
            (min min_dot: S, max max_dot: S) -> Own = geometry::clamp_length;
        fn clamp_length_max clamp_length_max_vjp clamp_length_max_jvp
            (max max_dot: S) -> Own = geometry::clamp_length_max;
        fn clamp_length_min clamp_length_min_vjp clamp_length_min_jvp
            (min min_dot: S) -> Own = geometry::clamp_length_min;
        fn move_towards move_towards_vjp move_towards_jvp
            (end end_dot: Own, way way_dot: S) -> Own = geometry::move_towards;
        fn refract refract_vjp refract_jvp
            (normal normal_dot: Own, eta eta_dot: S) -> Own = geometry::refract;
    }
}

by_formula! {
    /// Functions and methods of vectors of the plane.
    PlaneRules: Vec2 DVec2 {
        new from_angle from_angle_vjp from_angle_jvp (angle angle_dot: S) -> Own = geometry::direction;
        fn to_angle to_angle_vjp to_angle_jvp () -> S = geometry::to_angle;
        fn angle_to angle_to_vjp angle_to_jvp (other other_dot: Own) -> S = geometry::angle_to;
        fn perp perp_vjp perp_jvp () -> Own = geometry::perp;
        fn perp_dot perp_dot_vjp perp_dot_jvp (other other_dot: Own) -> S = geometry::perp_dot;
        fn rotate rotate_vjp rotate_jvp (other other_dot: Own) -> Own = geometry::rotate;
        fn rotate_angle rotate_angle_vjp rotate_angle_jvp
            (angle angle_dot: S) -> Own = geometry::rotate_angle;
    }
}

by_formula! {
    /// Methods of vectors of space.
    SpaceRules: Vec3 DVec3 {
        fn angle_between angle_between_vjp angle_between_jvp
            (other other_dot: Own) -> S = geometry::angle_between;
        fn rotate_x rotate_x_vjp rotate_x_jvp (angle angle_dot: S) -> Own = geometry::rotate_x;
        fn rotate_y rotate_y_vjp rotate_y_jvp (angle angle_dot: S) -> Own = geometry::rotate_y;
        fn rotate_z rotate_z_vjp rotate_z_jvp (angle angle_dot: S) -> Own = geometry::rotate_z;
        fn rotate_axis rotate_axis_vjp rotate_axis_jvp
            (axis axis_dot: Own, angle angle_dot: S) -> Own = geometry::rotate_axis;
    }
}

by_formula! {
    /// Functions and methods of quaternions.
    TurnRules: Quat DQuat {
        new from_scaled_axis from_scaled_axis_vjp from_scaled_axis_jvp
            (axis axis_dot: V3) -> Own = geometry::from_scaled_axis;
        new from_rotation_arc from_rotation_arc_vjp from_rotation_arc_jvp
            (from from_dot: V3, to to_dot: V3) -> Own = geometry::from_rotation_arc;
        fn to_axis_angle to_axis_angle_vjp to_axis_angle_jvp () -> Turn = geometry::to_axis_angle;
        fn to_scaled_axis to_scaled_axis_vjp to_scaled_axis_jvp () -> V3 = geometry::to_scaled_axis;
        fn angle_between angle_between_vjp angle_between_jvp
            (other other_dot: Own) -> S = geometry::angle_of_turns;
    }
}

by_formula! {
    /// Functions and methods of matrices that stand for motions of the plane.
    PlaneMotionRules: Mat3 DMat3 {
        new from_mat2 from_mat2_vjp from_mat2_jvp (linear linear_dot: M2) -> Own = geometry::wider;
        new from_mat4 from_mat4_vjp from_mat4_jvp (matrix matrix_dot: M4) -> Own = geometry::narrower;
        new from_angle from_angle_vjp from_angle_jvp (angle angle_dot: S) -> Own = geometry::turn_of_plane;
        new from_scale from_scale_vjp from_scale_jvp (scale scale_dot: V2) -> Own = geometry::scale_of_plane;
        new from_translation from_translation_vjp from_translation_jvp
            (translation translation_dot: V2) -> Own = geometry::shift_of_plane;
        new from_scale_angle_translation from_scale_angle_translation_vjp from_scale_angle_translation_jvp
            (scale scale_dot: V2, angle angle_dot: S, translation translation_dot: V2) -> Own
            = geometry::motion_of_plane;
        fn transform_point2 transform_point2_vjp transform_point2_jvp
            (point point_dot: V2) -> V2 = geometry::transform_point;
        fn transform_vector2 transform_vector2_vjp transform_vector2_jvp
            (vector vector_dot: V2) -> V2 = geometry::transform_vector;
    }
}

by_formula! {
    /// Functions and methods of matrices that stand for projections of space.
    ProjectionRules: Mat4 DMat4 {
        new from_mat3 from_mat3_vjp from_mat3_jvp (linear linear_dot: M3) -> Own = geometry::wider;
        fn project_point3 project_point3_vjp project_point3_jvp
            (point point_dot: V3) -> V3 = geometry::project_point;
    }
}

by_formula! {
    /// Methods of matrices and numbers.
    ScaledRules: Mat2 Mat3 Mat4 DMat2 DMat3 DMat4 {
        fn mul_scalar mul_scalar_vjp mul_scalar_jvp (factor factor_dot: S) -> Own = geometry::scaled;
        fn div_scalar div_scalar_vjp div_scalar_jvp (by by_dot: S) -> Own = geometry::divided;
    }
}

by_formula! {
    /// Functions and methods of affine motions of the plane.
    Affine2Rules: Affine2 DAffine2 {
        new from_mat2 from_mat2_vjp from_mat2_jvp (linear linear_dot: M2) -> Own = geometry::affine_of;
        new from_mat2_translation from_mat2_translation_vjp from_mat2_translation_jvp
            (linear linear_dot: M2, translation translation_dot: V2) -> Own = geometry::affine;
        new from_angle from_angle_vjp from_angle_jvp (angle angle_dot: S) -> Own = geometry::affine_turn;
        new from_scale from_scale_vjp from_scale_jvp (scale scale_dot: V2) -> Own = geometry::affine_scale;
        new from_translation from_translation_vjp from_translation_jvp
            (translation translation_dot: V2) -> Own = geometry::affine_shift;
        new from_angle_translation from_angle_translation_vjp from_angle_translation_jvp
            (angle angle_dot: S, translation translation_dot: V2) -> Own = geometry::affine_turn_shift;
        new from_scale_angle_translation from_scale_angle_translation_vjp from_scale_angle_translation_jvp
            (scale scale_dot: V2, angle angle_dot: S, translation translation_dot: V2) -> Own
            = geometry::affine_scale_turn_shift;
        fn transform_point2 transform_point2_vjp transform_point2_jvp
            (point point_dot: V2) -> V2 = geometry::affine_point;
        fn transform_vector2 transform_vector2_vjp transform_vector2_jvp
            (vector vector_dot: V2) -> V2 = geometry::affine_vector;
        fn inverse inverse_vjp inverse_jvp () -> Own = geometry::affine_inverse2;
    }
}

by_formula! {
    /// Functions and methods of affine motions of space.
    Affine3Rules: Affine3 DAffine3 {
        new from_mat3 from_mat3_vjp from_mat3_jvp (linear linear_dot: M3) -> Own = geometry::affine_of;
        new from_mat3_translation from_mat3_translation_vjp from_mat3_translation_jvp
            (linear linear_dot: M3, translation translation_dot: V3) -> Own = geometry::affine;
        new from_mat4 from_mat4_vjp from_mat4_jvp (matrix matrix_dot: M4) -> Own = geometry::affine_of_matrix;
        new from_quat from_quat_vjp from_quat_jvp (turn turn_dot: Q) -> Own = geometry::affine_of_turn;
        new from_axis_angle from_axis_angle_vjp from_axis_angle_jvp
            (axis axis_dot: V3, angle angle_dot: S) -> Own = geometry::affine_about;
        new from_rotation_x from_rotation_x_vjp from_rotation_x_jvp
            (angle angle_dot: S) -> Own = geometry::affine_about_x;
        new from_rotation_y from_rotation_y_vjp from_rotation_y_jvp
            (angle angle_dot: S) -> Own = geometry::affine_about_y;
        new from_rotation_z from_rotation_z_vjp from_rotation_z_jvp
            (angle angle_dot: S) -> Own = geometry::affine_about_z;
        new from_scale from_scale_vjp from_scale_jvp (scale scale_dot: V3) -> Own = geometry::affine_scale;
        new from_translation from_translation_vjp from_translation_jvp
            (translation translation_dot: V3) -> Own = geometry::affine_shift;
        new from_rotation_translation from_rotation_translation_vjp from_rotation_translation_jvp
            (turn turn_dot: Q, translation translation_dot: V3) -> Own = geometry::affine_of_turn_shift;
        new from_scale_rotation_translation
            from_scale_rotation_translation_vjp from_scale_rotation_translation_jvp
            (scale scale_dot: V3, turn turn_dot: Q, translation translation_dot: V3) -> Own
            = geometry::affine_of_scale_turn_shift;
        fn transform_point3 transform_point3_vjp transform_point3_jvp
            (point point_dot: V3) -> V3 = geometry::affine_point;
        fn transform_vector3 transform_vector3_vjp transform_vector3_jvp
            (vector vector_dot: V3) -> V3 = geometry::affine_vector;
        fn inverse inverse_vjp inverse_jvp () -> Own = geometry::affine_inverse3;
    }
}

macro_rules! affine {
    ($($type:ident $linear:ident;)*) => {$(
        impl Differentiable for $type {
            type Tangent = Self;
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            #[inline(always)]
            fn irregularity(&self) -> f64 {
                if self.is_finite() { 0.0 } else { f64::NAN }
            }
        }

        impl Additive for $type {
            #[inline(always)]
            fn zero() -> Self {
                Self { $linear: Additive::zero(), translation: Additive::zero() }
            }

            #[inline(always)]
            fn accumulate(&mut self, other: Self) {
                self.$linear.accumulate(other.$linear);
                self.translation.accumulate(other.translation);
            }
        }

        impl MulPullback for $type {
            #[inline(always)]
            fn mul_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                let (_, pullback) = geometry::affine_product::vjp(self.numbers(), rhs.numbers());
                Numbers::of_numbers(pullback(cotangent.numbers()))
            }

            #[inline(always)]
            fn mul_jvp(self, rhs: Self, tangent: Self, rhs_tangent: Self) -> (Self, Self) {
                let (_, along) = geometry::affine_product::jvp(
                    self.numbers(),
                    rhs.numbers(),
                    tangent.numbers(),
                    rhs_tangent.numbers(),
                );
                (self * rhs, Self::of_numbers(along))
            }
        }
    )*};
}

affine! {
    Affine2 matrix2;
    Affine3 matrix3;
    DAffine2 matrix2;
    DAffine3 matrix3;
}

macro_rules! quotients {
    ($($type:ident $scalar:ident $formula:ident;)*) => {$(
        impl DivPullback<$scalar> for $type {
            #[inline(always)]
            fn div_pullback(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                let (_, pullback) = geometry::$formula::vjp(self.numbers(), rhs);
                Numbers::of_numbers(pullback(cotangent.numbers()))
            }

            #[inline(always)]
            fn div_jvp(self, rhs: $scalar, tangent: Self, rhs_tangent: $scalar) -> (Self, Self) {
                let (_, along) =
                    geometry::$formula::jvp(self.numbers(), rhs, tangent.numbers(), rhs_tangent);
                (self / rhs, Self::of_numbers(along))
            }
        }
    )*};
}

quotients! {
    Mat2 f32 divided;
    Mat3 f32 divided;
    Mat4 f32 divided;
    Quat f32 quotient;
    DMat2 f64 divided;
    DMat3 f64 divided;
    DMat4 f64 divided;
    DQuat f64 quotient;
}
