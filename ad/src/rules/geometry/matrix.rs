//! Matrices, column by column.

use ad_macros::differentiable;

use super::vector::{quotient, times};
use crate::Real;

#[differentiable]
pub fn scaled<S: Real, const N: usize>(a: [[S; N]; N], factor: S) -> [[S; N]; N] {
    std::array::from_fn(|i| times::<S, N>(a[i], factor))
}

#[differentiable]
pub fn scaling<S: Real, const N: usize>(factor: S, a: [[S; N]; N]) -> [[S; N]; N] {
    scaled::<S, N>(a, factor)
}

#[differentiable]
pub fn divided<S: Real, const N: usize>(a: [[S; N]; N], by: S) -> [[S; N]; N] {
    std::array::from_fn(|i| quotient::<S, N>(a[i], by))
}

#[differentiable]
pub fn transformed<S: Real, const N: usize>(a: [[S; N]; N], v: [S; N]) -> [S; N] {
    let mut sum = times::<S, N>(a[0], v[0]);
    for i in 1..N {
        for j in 0..N {
            sum[j] += a[i][j] * v[i];
        }
    }
    sum
}

#[differentiable]
pub fn product<S: Real, const N: usize>(a: [[S; N]; N], b: [[S; N]; N]) -> [[S; N]; N] {
    std::array::from_fn(|i| transformed::<S, N>(a, b[i]))
}
