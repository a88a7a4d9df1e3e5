//! Derivatives of glam's square matrices, column by column.

#![allow(clippy::type_complexity)]

use core::array;

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, DVec4, Mat2, Mat3, Mat4, Vec2, Vec3, Vec4};

use super::scale_vector;
use super::{MulPullback, bilinear, scale, scale_elements};
use crate::vector::Vector;
use crate::{Additive, Differentiable, Mask, Real};

/// A square matrix.
trait Square<const N: usize>: Copy {
    /// A column.
    type Column: Vector;

    fn columns(self) -> [Self::Column; N];
    fn of_columns(columns: [Self::Column; N]) -> Self;
    /// The numbers of each column.
    fn numbers(self) -> [[<Self::Column as Vector>::Scalar; N]; N];
    fn of_numbers(numbers: [[<Self::Column as Vector>::Scalar; N]; N]) -> Self;
}

/// The cotangents of matrix and vector in a product of both.
#[inline(always)]
fn times_vector<M: Square<N>, const N: usize>(
    matrix: M,
    vector: [<M::Column as Vector>::Scalar; N],
    cotangent: M::Column,
) -> (M, [<M::Column as Vector>::Scalar; N]) {
    let columns = matrix.columns();
    let to_matrix = vector.map(|number| cotangent.map_elements(|g| scale(g, number)));
    let to_vector = columns.map(|column| scale_elements(cotangent, column).element_sum());
    (M::of_columns(to_matrix), to_vector)
}

/// The cotangents of both factors of a product of matrices.
#[inline(always)]
fn times_matrix<M: Square<N>, const N: usize>(left: M, right: M, cotangent: M) -> (M, M) {
    let (numbers, cotangents) = (right.numbers(), cotangent.columns());
    let mut to_left = [M::Column::zero(); N];
    let to_right = array::from_fn(|j| {
        let (part, column) = times_vector(left, numbers[j], cotangents[j]);
        for (sum, part) in to_left.iter_mut().zip(part.columns()) {
            sum.accumulate(part);
        }
        column
    });
    (M::of_columns(to_left), M::of_numbers(to_right))
}

/// The determinant of what is left of a matrix of at most four columns without a column and a row,
/// with its sign.
fn cofactor<S: Real, const N: usize>(matrix: &[[S; N]; N], column: usize, row: usize) -> S {
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
}

/// The derivative of the determinant: the matrix of cofactors.
fn cofactors<M: Square<N>, const N: usize>(matrix: M) -> M {
    let numbers = matrix.numbers();
    M::of_numbers(array::from_fn(|j| array::from_fn(|i| cofactor(&numbers, j, i))))
}

/// The cotangent of a matrix whose inverse is `inverse`: -W^T G W^T for W the inverse. 0 where the
/// matrix has none.
fn inverse_pullback<M: Square<N>, const N: usize>(inverse: M, cotangent: M) -> M {
    let (w, g) = (inverse.numbers(), cotangent.numbers());
    type Number<M, const N: usize> = <<M as Square<N>>::Column as Vector>::Scalar;
    let sum = |f: &dyn Fn(usize) -> Number<M, N>| {
        (0..N).fold(<Number<M, N>>::zero(), |sum, k| sum + f(k))
    };
    // Element (row, column) of G W^T is the sum over k of G(row, k) W(column, k).
    let product: [[Number<M, N>; N]; N] =
        array::from_fn(|column| array::from_fn(|row| sum(&|k| scale(g[k][row], w[k][column]))));
    let pulled: [[Number<M, N>; N]; N] = array::from_fn(|column| {
        array::from_fn(|row| -sum(&|k| scale(product[column][k], w[row][k])))
    });
    let is_defined = w.iter().flatten().all(|number| number.is_finite().all());
    match is_defined {
        true => M::of_numbers(pulled),
        false => M::of_columns([M::Column::zero(); N]),
    }
}

/// The `_vjp` siblings of the methods that all square matrices have.
pub trait MatrixRules: Differentiable<Tangent = Self> + Sized {
    /// A number.
    type Scalar: Real;
    /// A column.
    type Column;

    /// The transpose of the cotangent.
    fn transpose_vjp(&self) -> (Self, impl FnOnce(Self) -> Self + use<Self>);
    /// The cotangent times the cofactors.
    fn determinant_vjp(&self) -> (Self::Scalar, impl FnOnce(Self::Scalar) -> Self + use<Self>);
    /// -W^T G W^T for the inverse W; 0 where there is none.
    fn inverse_vjp(&self) -> (Self, impl FnOnce(Self) -> Self + use<Self>);
    /// The diagonal of the cotangent.
    fn from_diagonal_vjp(diagonal: Self::Column) -> (Self, impl FnOnce(Self) -> Self::Column);
    /// To the column.
    fn col_vjp(
        &self,
        index: usize,
    ) -> (Self::Column, impl FnOnce(Self::Column) -> (Self, ()) + use<Self>);
}

macro_rules! matrices {
    ($($matrix:ident $scalar:ident $column:ident $n:literal $rules:ident
        $times:ident $times_vjp:ident ($($axis:ident),*) ($($tuple:ident),*);)*) => {$(
        impl Square<$n> for $matrix {
            type Column = $column;

            #[inline(always)]
            fn columns(self) -> [$column; $n] {
                [$(self.$axis),*]
            }

            #[inline(always)]
            fn of_columns(columns: [$column; $n]) -> Self {
                let [$($axis),*] = columns;
                Self::from_cols($($axis),*)
            }

            #[inline(always)]
            fn numbers(self) -> [[$scalar; $n]; $n] {
                self.to_cols_array_2d()
            }

            #[inline(always)]
            fn of_numbers(numbers: [[$scalar; $n]; $n]) -> Self {
                Self::from_cols_array_2d(&numbers)
            }
        }

        impl Differentiable for $matrix {
            type Tangent = Self;
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            #[inline(always)]
            fn irregularity(&self) -> f64 {
                if self.is_finite() { 0.0 } else { f64::NAN }
            }
        }

        impl Additive for $matrix {
            #[inline(always)]
            fn zero() -> Self {
                Self::of_columns([$column::zero(); $n])
            }

            #[inline(always)]
            fn accumulate(&mut self, other: Self) {
                *self += other;
            }
        }

        impl MulPullback for $matrix {
            #[inline(always)]
            fn mul_pullback(self, rhs: Self, cotangent: Self) -> (Self, Self) {
                times_matrix(self, rhs, cotangent)
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: Self,
                tangent: Self,
                rhs_tangent: Self,
            ) -> (Self, Self) {
                let along = bilinear(|a: Self, b: Self| a * b, (self, rhs), (tangent, rhs_tangent));
                (self * rhs, along)
            }
        }

        impl MulPullback<$column> for $matrix {
            #[inline(always)]
            fn mul_pullback(self, rhs: $column, cotangent: $column) -> (Self, $column) {
                let (to_matrix, to_vector) = times_vector(self, rhs.to_array(), cotangent);
                (to_matrix, $column::from_array(to_vector))
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: $column,
                tangent: Self,
                rhs_tangent: $column,
            ) -> ($column, $column) {
                let along = bilinear(|a: Self, b: $column| a * b, (self, rhs), (tangent, rhs_tangent));
                (self * rhs, along)
            }
        }

        impl MulPullback<$scalar> for $matrix {
            #[inline(always)]
            fn mul_pullback(self, rhs: $scalar, cotangent: Self) -> (Self, $scalar) {
                let cotangents = cotangent.columns();
                let to_matrix = cotangents.map(|g| g.map_elements(|g| scale(g, rhs)));
                let parts = cotangents.iter().zip(self.columns());
                let to_scalar = parts.map(|(&g, column)| scale_elements(g, column).element_sum());
                (Self::of_columns(to_matrix), to_scalar.sum())
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: $scalar,
                tangent: Self,
                rhs_tangent: $scalar,
            ) -> (Self, Self) {
                let along = bilinear(|a: Self, b: $scalar| a * b, (self, rhs), (tangent, rhs_tangent));
                (self * rhs, along)
            }
        }

        impl MulPullback<$matrix> for $scalar {
            #[inline(always)]
            fn mul_pullback(self, rhs: $matrix, cotangent: $matrix) -> ($scalar, $matrix) {
                let (to_matrix, to_scalar) = rhs.mul_pullback(self, cotangent);
                (to_scalar, to_matrix)
            }

            #[inline(always)]
            fn mul_jvp(
                self,
                rhs: $matrix,
                tangent: $scalar,
                rhs_tangent: $matrix,
            ) -> ($matrix, $matrix) {
                rhs.mul_jvp(self, rhs_tangent, tangent)
            }
        }

        impl MatrixRules for $matrix {
            type Scalar = $scalar;
            type Column = $column;

            #[inline(always)]
            fn transpose_vjp(&self) -> (Self, impl FnOnce(Self) -> Self + use<>) {
                (self.transpose(), |g: Self| g.transpose())
            }

            #[inline(always)]
            fn determinant_vjp(&self) -> ($scalar, impl FnOnce($scalar) -> Self + use<>) {
                let matrix = *self;
                (self.determinant(), move |g| {
                    let cofactors = cofactors::<Self, $n>(matrix).columns();
                    Self::of_columns(cofactors.map(|column| scale_vector(g, column)))
                })
            }

            #[inline(always)]
            fn inverse_vjp(&self) -> (Self, impl FnOnce(Self) -> Self + use<>) {
                let inverse = self.inverse();
                (inverse, move |g| inverse_pullback::<Self, $n>(inverse, g))
            }

            #[inline(always)]
            fn from_diagonal_vjp(diagonal: $column) -> (Self, impl FnOnce(Self) -> $column) {
                (Self::from_diagonal(diagonal), |g: Self| {
                    let numbers = g.numbers();
                    $column::from_array(array::from_fn(|i| numbers[i][i]))
                })
            }

            #[inline(always)]
            fn col_vjp(
                &self,
                index: usize,
            ) -> ($column, impl FnOnce($column) -> (Self, ()) + use<>) {
                (self.col(index), move |g| {
                    let mut columns = [$column::zero(); $n];
                    columns[index] = g;
                    (Self::of_columns(columns), ())
                })
            }
        }

        #[doc = concat!("The `_vjp` siblings of methods of `", stringify!($matrix), "` alone.")]
        pub trait $rules: Sized {
            /// The cotangents of the columns.
            fn from_cols_vjp(
                $($axis: $column),*
            ) -> (Self, impl FnOnce(Self) -> ($($tuple),*));
            /// The cotangents of matrix and vector.
            fn $times_vjp(
                &self,
                vector: $column,
            ) -> ($column, impl FnOnce($column) -> (Self, $column) + use<Self>);
        }

        impl $rules for $matrix {
            #[inline(always)]
            fn from_cols_vjp(
                $($axis: $column),*
            ) -> (Self, impl FnOnce(Self) -> ($($tuple),*)) {
                (Self::from_cols($($axis),*), |g: Self| ($(g.$axis),*))
            }

            #[inline(always)]
            fn $times_vjp(
                &self,
                vector: $column,
            ) -> ($column, impl FnOnce($column) -> (Self, $column) + use<>) {
                let matrix = *self;
                (self.$times(vector), move |g| matrix.mul_pullback(vector, g))
            }
        }
    )*};
}

matrices! {
    Mat2 f32 Vec2 2 Mat2Rules mul_vec2 mul_vec2_vjp (x_axis, y_axis) (Vec2, Vec2);
    Mat3 f32 Vec3 3 Mat3Rules mul_vec3 mul_vec3_vjp
        (x_axis, y_axis, z_axis) (Vec3, Vec3, Vec3);
    Mat4 f32 Vec4 4 Mat4Rules mul_vec4 mul_vec4_vjp
        (x_axis, y_axis, z_axis, w_axis) (Vec4, Vec4, Vec4, Vec4);
    DMat2 f64 DVec2 2 DMat2Rules mul_vec2 mul_vec2_vjp (x_axis, y_axis) (DVec2, DVec2);
    DMat3 f64 DVec3 3 DMat3Rules mul_vec3 mul_vec3_vjp
        (x_axis, y_axis, z_axis) (DVec3, DVec3, DVec3);
    DMat4 f64 DVec4 4 DMat4Rules mul_vec4 mul_vec4_vjp
        (x_axis, y_axis, z_axis, w_axis) (DVec4, DVec4, DVec4, DVec4);
}
