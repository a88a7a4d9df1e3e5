//! The rules of matrices.

use core::array;

use glam::{DMat2, DMat3, DMat4, EulerRot, Mat2, Mat3, Mat4};

use super::geometry::{matrix, motion};
use super::kin::{Kin, Numbers};
use crate::rules::linear::{Maps, Negated, Same, Symmetric, Zero};
use crate::rules::row::rules;
use crate::rules::{RealRules, chain, scale};
use crate::{Additive, Real};

/// The derivative of an inverse, -W T W along T for the inverse W; 0 where there is none.
macro_rules! by_inverse {
    ($w:expr) => {{
        let between = |t: Self, w: Self| match w.is_finite() && t != Self::ZERO && w != Self::ZERO {
            true => -(w * t * w),
            false => Self::zero(),
        };
        let w = $w;
        Maps(move |t| between(t, w), move |g| between(g, w.transpose()))
    }};
}

/// The rules of the matrices of one number of columns.
macro_rules! square {
    ($($rules:ident $($matrix:ident)*, $n:literal $len:literal $size:ident
        $column:ident $vector:ident($($axis:ident),*);)*) => { pastey::paste! {$(
        rules! {
            /// The rules of functions and methods of square matrices.
            $rules: Kin for $($matrix)* {
                from_cols($($axis: Self::$column),*) -> Self: |g| ($(g.$axis),*);
                from_rows($($axis: Self::$column),*) -> Self: |g| {
                    let g = g.transpose();
                    ($(g.$axis),*)
                };
                from_rows_array(&array: [Self::S; $len]) -> Self: |g| g.to_rows_array();
                to_rows_array(&m) -> [Self::S; $len]: |g| Self::from_rows_array(&g);
                from_cols_array(&array: [Self::S; $len]) -> Self: |g| g.to_cols_array();
                from_cols_array_2d(&columns: [[Self::S; $n]; $n]) -> Self: |g| g.to_cols_array_2d();
                from_diagonal(elements: Self::$column) -> Self: |g| g.diagonal();
                diagonal(&m) -> Self::$column: |g| Self::from_diagonal(g);
                abs(&m) -> Self => numbers(m.numbers(), |x| x.abs_vjp().1(1.0));
                recip(&m) -> Self => numbers(m.numbers(), |x| x.recip_vjp().1(1.0));
                to_cols_array(&m) -> [Self::S; $len]: |g| Self::from_cols_array(&g);
                to_cols_array_2d(&m) -> [[Self::S; $n]; $n]: |g| Self::from_cols_array_2d(&g);
                transpose(&m) -> Self: |g| g.transpose();
                col(&m, index: usize) -> Self::$column => {
                    let column = move |g| {
                        let mut matrix = Self::zero();
                        *matrix.col_mut(index) = g;
                        matrix
                    };
                    (Maps(move |t: Self| t.col(index), column), Zero())
                };
                row(&m, index: usize) -> Self::$column => {
                    let row = move |g: Self::$column| {
                        let mut columns = [[-0.0; $n]; $n];
                        columns.iter_mut().zip(g.to_array()).for_each(|(to, g)| to[index] = g);
                        Self::from_cols_array_2d(&columns)
                    };
                    (Maps(move |t: Self| t.row(index), row), Zero())
                };
                [<mul_ $vector>](&m, v: Self::$column) -> Self::$column as matrix::transformed;
                [<transpose_mul_ $vector>](&m, v: Self::$column) -> Self::$column
                    as matrix::transformed_by_rows;
                mul_diagonal_scale(&m, scale: Self::$column) -> Self as matrix::stretched;
                [<mul_ $size>](&m, &other: Self) -> Self as matrix::product;
                [<add_ $size>](&m, &other: Self) -> Self => (Same(), Same());
                [<sub_ $size>](&m, &other: Self) -> Self => (Same(), Negated(Same()));
                mul_scalar(&m, factor: Self::S) -> Self as matrix::scaled;
                div_scalar(&m, by: Self::S) -> Self as matrix::divided;
                /// By the cofactors.
                determinant(&m) -> Self::S => {
                    let cofactors = cofactors(&m.numbers());
                    Maps(move |t: Self| entries(t.numbers(), cofactors), move |g| {
                        Self::of_numbers(cofactors.map(|column| column.map(|c| scale(g, c))))
                    })
                };
                inverse(&m) -> Self = w => by_inverse!(w);
                inverse_or_zero(&m) -> Self = w => by_inverse!(w);
                try_inverse(&m) -> Option<Self> = w => by_inverse!(w.unwrap_or(Self::ZERO));
            }
        }
    )*}};
}

square! {
    Matrix2Rules Mat2 DMat2, 2 4 mat2 V2 vec2(x_axis, y_axis);
    Matrix3Rules Mat3 DMat3, 3 9 mat3 V3 vec3(x_axis, y_axis, z_axis);
    Matrix4Rules Mat4 DMat4, 4 16 mat4 V4 vec4(x_axis, y_axis, z_axis, w_axis);
}

rules! {
    /// The rules of what makes a matrix of space of angles, each the rotation about an axis of its own.
    EulerRules: Kin for Mat3 Mat4 DMat3 DMat4 {
        /// Each number is a wave of each angle plus a constant: half of what lies between a quarter
        /// turn before and after is its derivative.
        from_euler(order: EulerRot, a: Self::S, b: Self::S, c: Self::S) -> Self => {
            let turned = |by: [Self::S; 3]| Self::from_euler(order, a + by[0], b + by[1], c + by[2]);
            let quarter = 0.5 * <Self::S as Real>::PI;
            let by_angle = |angle: usize| {
                let turn = |by| array::from_fn(|i| if i == angle { by } else { 0.0 });
                let slope = (turned(turn(quarter)) - turned(turn(-quarter))) * 0.5;
                Maps(move |t| slope * t, move |g: Self| entries(g.numbers(), slope.numbers()))
            };
            (Zero(), by_angle(0), by_angle(1), by_angle(2))
        };
    }
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
        from_mat3_translation(linear: Self::M3, translation: Self::V3) -> Self as motion::moved3;
        project_point3(&m, point: Self::V3) -> Self::V3 as motion::project_point3;
    }
}

/// The derivative of a function of each number of a matrix, by that of the function.
fn numbers<M, S, const N: usize>(
    matrix: [[S; N]; N],
    slope: impl Fn(S) -> S,
) -> Symmetric<impl FnOnce(M) -> M>
where
    S: Real,
    M: Numbers<Array = [[S; N]; N]>,
{
    let slopes = matrix.map(|column| column.map(&slope));
    Symmetric(move |t: M| {
        let t = t.numbers();
        M::of_numbers(array::from_fn(|i| array::from_fn(|j| chain(t[i][j], slopes[i][j]))))
    })
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
