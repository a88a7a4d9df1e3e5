//! Matrices, column by column, with rules of their own as those of [vectors](super::vector) are.

use ad_macros::differentiable;

use super::vector::{combined, quotient, times};
use crate::Real;
use crate::rules::scale;

/// A matrix of `N` columns.
type Square<S, const N: usize> = [[S; N]; N];

formulas! {
    transformed[N](a: Square<S, N>, v: [S; N]) -> [S; N] = combined::<S, N, N, N>(a, v);
}

#[differentiable(vjp = product_vjp, jvp = product_jvp)]
pub fn product<S: Real, const N: usize>(a: Square<S, N>, b: Square<S, N>) -> Square<S, N> {
    b.map(|b| combined(a, b))
}

#[inline(always)]
fn product_vjp<S: Real, const N: usize>(
    a: Square<S, N>,
    b: Square<S, N>,
) -> (Square<S, N>, impl FnOnce(Square<S, N>) -> (Square<S, N>, Square<S, N>)) {
    (product(a, b), move |g| {
        // Number by number: to add up what `combined` gives for each column takes twice the time.
        let sums = |term: &dyn Fn(usize, usize, usize) -> S| -> Square<S, N> {
            let sum = |i, j| (0..N).fold(S::zero(), |sum, k| sum + term(i, j, k));
            std::array::from_fn(|i| std::array::from_fn(|j| sum(i, j)))
        };
        (sums(&|i, j, k| scale(g[k][j], b[k][i])), sums(&|i, j, k| scale(g[i][k], a[j][k])))
    })
}

#[inline(always)]
fn product_jvp<S: Real, const N: usize>(
    a: Square<S, N>,
    b: Square<S, N>,
    a_dot: Square<S, N>,
    b_dot: Square<S, N>,
) -> (Square<S, N>, Square<S, N>) {
    (product(a, b), std::array::from_fn(|i| combined::jvp(a, b[i], a_dot, b_dot[i]).1))
}

#[differentiable(vjp = transposed_vjp, jvp = transposed_jvp)]
pub fn transposed<S: Real, const N: usize>(a: Square<S, N>) -> Square<S, N> {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

#[inline(always)]
fn transposed_vjp<S: Real, const N: usize>(
    a: Square<S, N>,
) -> (Square<S, N>, impl FnOnce(Square<S, N>) -> Square<S, N>) {
    (transposed(a), transposed)
}

#[inline(always)]
fn transposed_jvp<S: Real, const N: usize>(
    a: Square<S, N>,
    a_dot: Square<S, N>,
) -> (Square<S, N>, Square<S, N>) {
    (transposed(a), transposed(a_dot))
}

formulas! {
    transformed_by_rows[N](a: Square<S, N>, v: [S; N]) -> [S; N]
        = transformed::<S, N>(transposed::<S, N>(a), v);
}

/// The columns, each times a number of its own.
#[differentiable(vjp = stretched_vjp, jvp = stretched_jvp)]
pub fn stretched<S: Real, const N: usize>(a: Square<S, N>, by: [S; N]) -> Square<S, N> {
    std::array::from_fn(|i| times(a[i], by[i]))
}

#[inline(always)]
fn stretched_vjp<S: Real, const N: usize>(
    a: Square<S, N>,
    by: [S; N],
) -> (Square<S, N>, impl FnOnce(Square<S, N>) -> (Square<S, N>, [S; N])) {
    (stretched(a, by), move |g| {
        let parts: [_; N] = std::array::from_fn(|i| times::vjp(a[i], by[i]).1(g[i]));
        (parts.map(|part| part.0), parts.map(|part| part.1))
    })
}

#[inline(always)]
fn stretched_jvp<S: Real, const N: usize>(
    a: Square<S, N>,
    by: [S; N],
    a_dot: Square<S, N>,
    by_dot: [S; N],
) -> (Square<S, N>, Square<S, N>) {
    let column = |i: usize| times::jvp(a[i], by[i], a_dot[i], by_dot[i]).1;
    (stretched(a, by), std::array::from_fn(column))
}

/// A function of a matrix and a number by that of a column and the number.
macro_rules! by_columns {
    ($($name:ident = $column:ident;)*) => { pastey::paste! {$(
        #[differentiable(vjp = [<$name _vjp>], jvp = [<$name _jvp>])]
        pub fn $name<S: Real, const N: usize>(a: Square<S, N>, number: S) -> Square<S, N> {
            a.map(|column| $column(column, number))
        }

        #[inline(always)]
        fn [<$name _vjp>]<S: Real, const N: usize>(
            a: Square<S, N>,
            number: S,
        ) -> (Square<S, N>, impl FnOnce(Square<S, N>) -> (Square<S, N>, S)) {
            ($name(a, number), move |g| {
                let parts: [_; N] = std::array::from_fn(|i| $column::vjp(a[i], number).1(g[i]));
                let to_number = parts.iter().fold(S::zero(), |sum, part| sum + part.1);
                (parts.map(|part| part.0), to_number)
            })
        }

        #[inline(always)]
        fn [<$name _jvp>]<S: Real, const N: usize>(
            a: Square<S, N>,
            number: S,
            a_dot: Square<S, N>,
            dot: S,
        ) -> (Square<S, N>, Square<S, N>) {
            ($name(a, number), std::array::from_fn(|i| $column::jvp(a[i], number, a_dot[i], dot).1))
        }
    )*}};
}

by_columns! {
    scaled = times;
    divided = quotient;
}

formulas! {
    scaling[N](factor: S, a: Square<S, N>) -> Square<S, N> = scaled::<S, N>(a, factor);
}
