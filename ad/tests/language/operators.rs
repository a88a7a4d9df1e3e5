//! Operators of one's own types.

use std::iter::{Product, Sum};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Rem, Sub, SubAssign};

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{check, check_generic};

#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
struct Complex {
    re: f64,
    im: f64,
}

#[differentiable]
impl Complex {
    fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    fn norm_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    fn conjugate(self) -> Self {
        Self::new(self.re, -self.im)
    }
}

#[differentiable]
impl Add for Complex {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

#[differentiable]
impl Sub for Complex {
    type Output = Complex;

    fn sub(self, other: Complex) -> Complex {
        Complex::new(self.re - other.re, self.im - other.im)
    }
}

#[differentiable]
impl Mul for Complex {
    type Output = Self;

    fn mul(self, o: Self) -> Self::Output {
        Self::Output { re: self.re * o.re - self.im * o.im, im: self.re * o.im + self.im * o.re }
    }
}

#[differentiable]
impl Div for Complex {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self * other.conjugate() * (1.0 / other.norm_squared())
    }
}

#[differentiable]
impl Neg for Complex {
    type Output = Self;

    fn neg(mut self) -> Self {
        self.re = -self.re;
        self.im = -self.im;
        self
    }
}

#[differentiable]
impl Mul<f64> for Complex {
    type Output = Self;

    fn mul(self, by: f64) -> Self {
        Self::new(self.re * by, self.im * by)
    }
}

#[differentiable]
impl std::ops::Mul<Complex> for f64 {
    type Output = Complex;

    fn mul(self, z: Complex) -> Complex {
        z * self
    }
}

#[differentiable]
impl Add<f64> for Complex {
    type Output = Self;

    fn add(self, real: f64) -> Self {
        Self { re: self.re + real, ..self }
    }
}

/// By halves, so that a mix-up with `+` shows.
#[differentiable]
impl AddAssign for Complex {
    fn add_assign(&mut self, Complex { re, im }: Self) {
        self.re += 0.5 * re;
        self.im += 0.5 * im * self.re;
    }
}

#[differentiable]
impl SubAssign for Complex {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

#[differentiable]
impl MulAssign for Complex {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

#[differentiable]
impl DivAssign<f64> for Complex {
    fn div_assign(&mut self, by: f64) {
        self.re /= by;
        self.im /= by;
    }
}

impl<'a> Mul<&'a Complex> for &Complex {
    type Output = Complex;

    fn mul(self, other: &'a Complex) -> Complex {
        *self * *other
    }
}

#[differentiable]
fn complex_numbers(x: f64, y: f64) -> f64 {
    let a = Complex::new(x, y);
    let b = Complex { re: y * y, im: x };
    let c = a * b + 2.0 * a - b / (a + 3.0);
    let d = -c * y + a * x;
    d.norm_squared() + (c - d).re
}

#[test]
fn operators_of_complex_numbers() {
    check!(complex_numbers(x, y) at [0.7, -1.2], [1.5, 0.4], [0.0, 2.0]);
}

/// How often `z -> z^2 + c` is bounded, smoothly.
#[differentiable]
fn julia(x: f64, y: f64, steps: usize) -> f64 {
    let c = Complex::new(x, y);
    let mut z = Complex::new(0.1, 0.2);
    let mut sum = 0.0;
    for i in 0..steps {
        z = z * z + c;
        if z.re > 0.0 {
            z -= c * 0.1;
        } else {
            z = -z;
        }
        if i % 3 == 1 {
            z *= Complex::new(0.9, x);
            z /= 1.0 + y * y;
        }
        sum += z.norm_squared();
        if sum > 40.0 {
            break;
        }
    }
    sum
}

#[differentiable]
fn julia_of_few(x: f64, y: f64) -> f64 {
    julia(x, y, 7) + julia(y, x, 1) + julia(x, x, 0)
}

#[test]
fn operators_in_loops() {
    check!(julia_of_few(x, y) at [0.3, -0.4], [-0.5, 0.6], [1.3, 1.1]);
}

#[differentiable]
fn assigned(x: f64, y: f64) -> f64 {
    let mut z = Complex::new(x, y);
    let mut zs = [z, z * 2.0, z + 1.0];
    for i in 0..3 {
        for k in 0..2 {
            zs[i] += z * zs[(i + k) % 3];
            z += zs[k];
        }
        zs[i] -= z;
        zs[i].re += z.im;
    }
    let mut pair = (z, x);
    pair.0 *= zs[2];
    pair.0 /= pair.1 + 2.0;
    pair.0.norm_squared() + zs[1].im
}

#[test]
fn assigning_operators_have_their_own_derivatives() {
    check!(assigned(x, y) at [0.3, -0.4], [-0.5, 0.6]);
}

#[differentiable]
impl Sum for Complex {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self { re: 0.5, im: -0.0 }, |sum, z| sum + z)
    }
}

#[differentiable]
impl<'a> Sum<&'a Complex> for Complex {
    fn sum<I: Iterator<Item = &'a Self>>(iter: I) -> Self {
        iter.fold(Self { re: 0.5, im: -0.0 }, |sum, &z| sum + z)
    }
}

#[differentiable]
impl Product for Complex {
    fn product<I: Iterator<Item = Complex>>(iter: I) -> Complex {
        iter.fold(Complex::new(1.0, 0.0), |product, z| product * z)
    }
}

#[differentiable]
fn sums_and_products(x: f64, y: f64) -> f64 {
    let zs = [Complex::new(x, y), Complex::new(y, 1.0), Complex::new(x * y, x)];
    let sum: Complex = zs.iter().sum();
    let squares = zs.iter().map(|z| z * z).sum::<Complex>();
    let product = zs.iter().copied().chain([sum]).product::<Complex>();
    (product + squares).norm_squared()
}

#[test]
fn sums_and_products_of_ones_own_type() {
    check!(sums_and_products(x, y) at [0.3, -0.4], [-0.5, 0.6]);
}

// References on both sides are what it is about.
#[allow(clippy::op_ref)]
#[differentiable]
fn by_reference(x: f64, y: f64) -> f64 {
    let zs = [Complex::new(x, y), Complex::new(y, 1.0), Complex::new(x * y, x)];
    let (a, b) = (&zs[0], &zs[1]);
    let mut product = a * b;
    for z in &zs {
        product = &product * z;
    }
    for pair in zs.windows(2) {
        product = product + pair[0] * pair[1];
    }
    (&product * &zs[2]).norm_squared()
}

#[test]
fn operators_of_references() {
    check!(by_reference(x, y) at [0.3, -0.4], [-0.5, 0.6]);
}

/// A type whose sums are not linear, and which would need another pullback in each iteration.
#[derive(Clone, Copy, Differentiable)]
struct Fraction<T>(T, T);

#[differentiable]
impl<T: Real> Add for Fraction<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let Self(n, d) = self;
        Self(n * other.1 + other.0 * d, d * other.1)
    }
}

#[differentiable]
impl<T> Sub for Fraction<T>
where
    T: Real,
{
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Of both, as long as the value is the same: the derivative is that of this one.
#[differentiable]
impl<T: Real> Neg for Fraction<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0 * self.1, -(self.1 * self.1))
    }
}

#[differentiable]
impl<T: Real> Mul for Fraction<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0, self.1 * other.1)
    }
}

#[differentiable]
impl<T: Real> Rem<T> for Fraction<T> {
    type Output = T;

    fn rem(self, by: T) -> T {
        self.0 * by / self.1
    }
}

#[differentiable]
fn fractions<S: Real>(x: S, y: S) -> S {
    let mut sum = Fraction(x, y);
    let mut other = Fraction(y, S::TWO + x * x);
    for i in 0..3 {
        for _ in 0..i {
            sum = sum + other;
        }
        if i == 1 {
            other = -other + sum;
        } else {
            other = sum - other * Fraction(x, S::ONE);
        }
    }
    (sum + other) % x + sum.0 / sum.1
}

#[test]
fn sums_that_are_not_linear() {
    check_generic!(fractions(x, y) at [0.8, 1.7], [1.2, 0.6], [-0.7, 0.9]);
}

#[derive(Clone, Copy, Differentiable)]
struct Dual<T> {
    value: T,
    slope: T,
}

#[differentiable]
impl<T: Real> Add for Dual<T> {
    type Output = Dual<T>;

    fn add(self, other: Dual<T>) -> Dual<T> {
        Dual { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

#[differentiable]
impl<T: Real> Mul for Dual<T> {
    type Output = Dual<T>;

    fn mul(self, other: Dual<T>) -> Dual<T> {
        Dual {
            value: self.value * other.value,
            slope: self.slope * other.value + self.value * other.slope,
        }
    }
}

#[differentiable]
impl<T: Real> Div for Dual<T> {
    type Output = Dual<T>;

    fn div(self, other: Dual<T>) -> Dual<T> {
        let value = self.value / other.value;
        Dual { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

/// The derivative of a product of powers, by dual numbers of one's own.
#[differentiable]
fn slope<S: Real>(x: S, y: S) -> S {
    let x = Dual { value: x, slope: S::ONE };
    let y = Dual { value: y, slope: S::ZERO };
    let mut power = x * y;
    for _ in 0..3 {
        power = power * x + y / x;
    }
    power.slope
}

#[test]
fn dual_numbers_of_ones_own() {
    check_generic!(slope(x, y) at [0.8, 1.7], [-1.2, 0.6]);
}

#[derive(Clone, Copy, Differentiable)]
struct Polynomial<const N: usize>([f64; N]);

#[differentiable]
impl<const N: usize> Polynomial<N> {
    fn at(self, x: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * x + c)
    }
}

/// Modulo x^N.
#[differentiable]
impl<const N: usize> Mul for Polynomial<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut product = [0.0; N];
        for i in 0..N {
            for k in 0..N - i {
                product[i + k] += self.0[i] * other.0[k];
            }
        }
        Polynomial(product)
    }
}

#[differentiable]
impl<const N: usize> Sub<f64> for Polynomial<N> {
    type Output = Self;

    fn sub(mut self, constant: f64) -> Self {
        self.0[0] -= constant;
        self
    }
}

#[differentiable]
fn polynomials(x: f64, y: f64) -> f64 {
    let mut p = Polynomial([x, y, 1.0, -0.5]);
    let q = Polynomial([1.0, x, 0.0, y]);
    for _ in 0..2 {
        p = p * q - y;
    }
    p.at(0.5) + (p * p).at(x)
}

#[test]
fn polynomials_of_fixed_degree() {
    check!(polynomials(x, y) at [0.8, 0.7], [-1.2, 0.6]);
}

#[derive(Clone, Copy, Differentiable)]
struct Quaternion {
    w: f64,
    v: [f64; 3],
}

#[differentiable]
impl Mul for Quaternion {
    type Output = Self;

    fn mul(self, o: Self) -> Self {
        let [a, b, c] = self.v;
        let [x, y, z] = o.v;
        Self {
            w: self.w * o.w - a * x - b * y - c * z,
            v: [
                self.w * x + a * o.w + b * z - c * y,
                self.w * y - a * z + b * o.w + c * x,
                self.w * z + a * y - b * x + c * o.w,
            ],
        }
    }
}

/// Rotates.
#[differentiable]
impl Mul<[f64; 3]> for Quaternion {
    type Output = [f64; 3];

    fn mul(self, v: [f64; 3]) -> [f64; 3] {
        let axis: [f64; 3] = self.v;
        let back = Self { w: self.w, v: axis.map(|x| -x) };
        (self * Self { w: 0.0, v } * back).v
    }
}

#[differentiable]
fn rotated(x: f64, y: f64) -> f64 {
    let q = Quaternion { w: x, v: [y, 0.3, x * y] };
    let r = q * q * Quaternion { w: 1.0, v: [0.0, y, 0.0] };
    let [a, b, c] = r * [x, 1.0, y];
    a * b + c
}

#[test]
fn quaternions_of_ones_own() {
    check!(rotated(x, y) at [0.8, 0.7], [-1.2, 0.6]);
}

/// A sum with its rounding error: `+=` with another type on the right, without `+`.
#[derive(Clone, Copy, Differentiable)]
struct Compensated {
    sum: f64,
    rest: f64,
}

#[differentiable]
impl AddAssign<f64> for Compensated {
    fn add_assign(&mut self, term: f64) {
        let next = self.sum + term;
        self.rest += if self.sum.abs() >= term.abs() {
            (self.sum - next) + term
        } else {
            (term - next) + self.sum
        };
        self.sum = next;
    }
}

#[differentiable]
fn compensated(x: f64, y: f64) -> f64 {
    let mut total = Compensated { sum: x, rest: 0.0 };
    for i in 0..4 {
        total += x * y * i as f64;
        total += y.sin();
    }
    total.sum * total.sum + total.rest
}

#[test]
fn a_compensated_sum() {
    check!(compensated(x, y) at [0.8, 0.7], [-1.2, 0.6]);
}

/// Generic over what has operators.
#[differentiable]
fn horner<S: Real>(x: S, y: S) -> S {
    let z = Fraction(x, y) * Fraction(x, S::ONE);
    let values = [z, z * z, z + z];
    let mut sum = values[0];
    #[differentiable(checkpoint)]
    for i in 0..3 {
        sum = sum * values[i] + z;
    }
    sum.0 / sum.1
}

#[test]
fn operators_in_a_loop_with_checkpoints() {
    check_generic!(horner(x, y) at [0.8, 1.7], [1.2, 0.6]);
}
