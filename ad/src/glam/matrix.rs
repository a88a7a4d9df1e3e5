//! The rules of matrices.

use core::array;

use glam::{DMat2, DMat3, DMat4, Mat2, Mat3, Mat4};

use super::geometry::{matrix, motion};
use super::kin::{Kin, Numbers};
use crate::rules::linear::{Maps, Zero};
use crate::rules::row::rules;
use crate::rules::{chain, scale};
use crate::{Additive, Real};

/// The rules of the matrices of one number of columns.
macro_rules! square {
    ($($rules:ident $($matrix:ident)*, $len:literal $column:ident $times:ident($($axis:ident),*);)*) => {$(
        rules! {
            /// The rules of functions and methods of square matrices.
            $rules: Kin for $($matrix)* {
                from_cols($($axis: Self::$column),*) -> Self: |g| ($(g.$axis),*);
                from_diagonal(elements: Self::$column) -> Self:
                    |g| array::from_fn(|i| g.col(i)[i]).into();
                to_cols_array(&m) -> [Self::S; $len]: |g| Self::from_cols_array(&g);
                transpose(&m) -> Self: |g| g.transpose();
                col(&m, index: usize) -> Self::$column => {
                    let column = move |g| {
                        let mut matrix = Self::zero();
                        *matrix.col_mut(index) = g;
                        matrix
                    };
                    (Maps(move |t: Self| t.col(index), column), Zero())
                };
                $times(&m, v: Self::$column) -> Self::$column as matrix::transformed;
                mul_scalar(&m, factor: Self::S) -> Self as matrix::scaled;
                div_scalar(&m, by: Self::S) -> Self as matrix::divided;
                /// By the cofactors.
                determinant(&m) -> Self::S => {
                    let cofactors = cofactors(&m.numbers());
                    Maps(move |t: Self| entries(t.numbers(), cofactors), move |g| {
                        Self::of_numbers(cofactors.map(|column| column.map(|c| scale(g, c))))
                    })
                };
                /// -W T W along T for the inverse W; 0 where there is none.
                inverse(&m) -> Self = w => {
                    let between = |t: Self, w: Self| match w.is_finite() && t != Self::ZERO {
                        true => -(w * t * w),
                        false => Self::zero(),
                    };
                    Maps(move |t| between(t, w), move |g| between(g, w.transpose())) };
            }
        }

        $(
            impl ColumnsRules<[<$matrix as Kin>::S; $len]> for $matrix {
                #[inline(always)]
                fn from_cols_array_vjp(
                    array: &[Self::S; $len],
                ) -> (Self, impl FnOnce(Self) -> [Self::S; $len] + use<>) {
                    (Self::from_cols_array(array), |cotangent: Self| cotangent.to_cols_array())
                }

                #[inline(always)]
                fn from_cols_array_jvp(
                    array: &[Self::S; $len],
                    tangent: &[Self::S; $len],
                ) -> (Self, Self) {
                    (Self::from_cols_array(array), Self::from_cols_array(tangent))
                }
            }
        )*
    )*};
}

/// The rules of what makes a matrix of an array, which it borrows.
pub trait ColumnsRules<Array>: Kin {
    /// The cotangents as an array.
    fn from_cols_array_vjp(array: &Array) -> (Self, impl FnOnce(Self) -> Array + use<Self, Array>);

    /// A matrix of the tangents.
    fn from_cols_array_jvp(array: &Array, tangent: &Array) -> (Self, Self);
}

square! {
    Matrix2Rules Mat2 DMat2, 4 V2 mul_vec2(x_axis, y_axis);
    Matrix3Rules Mat3 DMat3, 9 V3 mul_vec3(x_axis, y_axis, z_axis);
    Matrix4Rules Mat4 DMat4, 16 V4 mul_vec4(x_axis, y_axis, z_axis, w_axis);
}

rules! {
    /// The rules of what makes a matrix of three columns of others.
    ResizedRules: Kin for Mat3 DMat3 {
        from_mat2(linear: Self::M2) -> Self as motion::resized;
        from_mat4(matrix: Self::M4) -> Self as motion::resized;
    }
}

rules! {
    /// The rules of functions and methods of matrices that stand for projections of space.
    ProjectionRules: Kin for Mat4 DMat4 {
        from_mat3(linear: Self::M3) -> Self as motion::resized;
        project_point3(&m, point: Self::V3) -> Self::V3 as motion::project_point3;
    }
}

/// The sum over the products of numbers of two matrices.
fn entries<S: Real, const N: usize>(tangent: [[S; N]; N], partials: [[S; N]; N]) -> S {
    let pairs = tangent.iter().flatten().zip(partials.iter().flatten());
    pairs.fold(S::ZERO, |sum, (&t, &p)| sum + chain(t, p))
}

/// The derivative of the determinant: each number times the sign of its place is the determinant of what is
/// left of a matrix of at most four columns without its column and row.
fn cofactors<S: Real, const N: usize>(matrix: &[[S; N]; N]) -> [[S; N]; N] {
    let cofactor = |column: usize, row: usize| {
        let others = |without: usize| (0..N).filter(move |&i| i != without).enumerate();
        let mut m: [[S; 3]; 3] =
            array::from_fn(|j| array::from_fn(|i| if i == j { S::ONE } else { S::ZERO }));
        for (j, from_column) in others(column) {
            for (i, from_row) in others(row) {
                m[j][i] = matrix[from_column][from_row];
            }
        }
        let pair = |i: usize, j: usize| m[1][i] * m[2][j] - m[1][j] * m[2][i];
        let determinant = m[0][0] * pair(1, 2) - m[0][1] * pair(0, 2) + m[0][2] * pair(0, 1);
        if (column + row).is_multiple_of(2) { determinant } else { -determinant }
    };
    array::from_fn(|j| array::from_fn(|i| cofactor(j, i)))
}
