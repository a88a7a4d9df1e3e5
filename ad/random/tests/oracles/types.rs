//! What random programs use beside numbers and arrays: a type with operators and methods, an enum,
//! and functions of options, slices and `&mut`.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use ad::{Differentiable, Real, differentiable};

#[derive(Clone, Copy, Differentiable)]
pub struct Pair<S> {
    pub a: S,
    pub b: S,
}

#[differentiable]
impl<S: Real<Mask = bool>> Pair<S> {
    /// Keeps it bounded.
    pub fn tamed(self) -> Self {
        Self { a: self.a.sin(), b: self.b.tanh() }
    }

    pub fn turn(&mut self, by: S) {
        let a = self.a;
        self.a = a * by.cos() - self.b * by.sin();
        self.b = a * by.sin() + self.b * by.cos();
    }

    pub fn dot(&self, other: &Self) -> S {
        self.a * other.a + self.b * other.b
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Add for Pair<S> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { a: self.a + other.a, b: self.b + other.b }
    }
}

/// Not linear.
#[differentiable]
impl<S: Real<Mask = bool>> Sub for Pair<S> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { a: self.a * other.b - other.a, b: self.b - other.b * self.a }
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Mul for Pair<S> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { a: self.a * other.a - self.b * other.b, b: self.a * other.b + self.b * other.a }
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Mul<S> for Pair<S> {
    type Output = Self;

    fn mul(self, by: S) -> Self {
        Self { a: self.a * by, b: self.b * by }
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Neg for Pair<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { a: -self.a, b: self.b }
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> AddAssign for Pair<S> {
    fn add_assign(&mut self, other: Self) {
        self.a = self.a + other.a * self.b;
        self.b = self.b + other.b;
    }
}

/// Not `Copy`; bounded by its operators.
#[derive(Clone, Differentiable)]
pub struct List<S>(pub Vec<S>);

#[differentiable]
impl<S: Real<Mask = bool>> List<S> {
    pub fn total(&self) -> S {
        let mut sum = S::ZERO;
        for x in &self.0 {
            sum = sum * S::HALF + *x;
        }
        sum.sin()
    }

    pub fn folded<F: Fn(S, S) -> S>(&self, start: S, f: F) -> S {
        let mut state = start;
        for x in &self.0 {
            state = f(state, *x);
        }
        state
    }
}

#[differentiable]
impl<'a, S: Real<Mask = bool>> Mul<&'a List<S>> for &List<S> {
    type Output = List<S>;

    fn mul(self, other: &'a List<S>) -> List<S> {
        let n = other.0.len();
        let mut data = self.0.clone();
        for (i, x) in data.iter_mut().enumerate() {
            *x = (*x * other.0[(i + 1) % n] - other.0[i]).sin();
        }
        List(data)
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Add for List<S> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        List(self.0.iter().zip(&other.0).map(|(a, b)| (*a + *b * *a).tanh()).collect())
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Mul<S> for List<S> {
    type Output = Self;

    fn mul(mut self, by: S) -> Self {
        for x in &mut self.0 {
            *x = *x * by;
        }
        self
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Neg for &List<S> {
    type Output = List<S>;

    fn neg(self) -> List<S> {
        List(self.0.iter().map(|x| S::HALF - *x).collect())
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> AddAssign<&List<S>> for List<S> {
    fn add_assign(&mut self, other: &List<S>) {
        for i in 0..self.0.len() {
            self.0[i] = (self.0[i] + other.0[i] * self.0[0]).cos();
        }
    }
}

#[derive(Clone, Copy, Differentiable)]
pub enum Shape<S> {
    Point,
    Disc(S),
    Box { w: S, h: S },
}

#[differentiable]
pub fn shape<S: Real<Mask = bool>>(w: S, h: S) -> Shape<S> {
    if w.cmplt(S::from_f64(-0.5)) {
        Shape::Point
    } else if h.cmplt(w) {
        Shape::Disc(w * h)
    } else {
        Shape::Box { w, h }
    }
}

/// `None` below 0.
#[differentiable]
pub fn root<S: Real<Mask = bool>>(x: S) -> Option<S> {
    if x.cmplt(S::ZERO) { None } else { Some((x + S::from_f64(0.25)).sqrt()) }
}

#[differentiable]
pub fn roots<S: Real<Mask = bool>>(x: S, y: S) -> Result<S, bool> {
    let Some(first) = root(x) else { return Err(y.cmplt(x)) };
    let second = checked(y)?;
    Ok(first - second * both(x, y).unwrap_or(y))
}

#[differentiable]
fn checked<S: Real<Mask = bool>>(x: S) -> Result<S, bool> {
    match root(x) {
        Some(root) => Ok(root),
        None => Err(false),
    }
}

#[differentiable]
fn both<S: Real<Mask = bool>>(x: S, y: S) -> Option<S> {
    Some(root(x - S::HALF)? * root(y)?)
}

#[differentiable]
pub fn mixed<S: Real<Mask = bool>>(values: &[S]) -> S {
    let mut sum = S::ZERO;
    for (i, pair) in values.windows(2).enumerate() {
        sum = sum + pair[0] * pair[1] * S::from_f64(0.5 + i as f64);
    }
    match values {
        [first, .., last] => sum + *first - *last,
        [only] => *only,
        [] => sum,
    }
}

/// Changes the values in place, and returns what fell out.
#[differentiable]
pub fn shifted<S: Real<Mask = bool>>(values: &mut [S], by: S) -> S {
    let mut carried = by;
    for value in values.iter_mut() {
        let next = *value * by;
        *value = (carried + *value * S::HALF).sin();
        carried = next;
    }
    carried.tanh()
}

/// The sum of what a function makes of several numbers.
#[differentiable]
pub fn summed<S: Real<Mask = bool>, F: Fn(S) -> S>(f: F, start: S, n: usize) -> S {
    let mut sum = S::ZERO;
    for i in 0..n {
        sum = sum + f(start + S::from_f64(i as f64)) * f(sum);
        if sum.cmpgt(S::from_f64(4.0)) {
            return sum;
        }
    }
    sum
}

/// What a function makes of a number, again and again.
#[differentiable]
pub fn folded<S, F>(f: &F, start: S, values: &[S]) -> S
where
    S: Real<Mask = bool> + 'static,
    F: Fn(S, &[S]) -> S,
{
    let mut state = start;
    for i in 0..values.len().min(3) {
        state = f(state, &values[i..]).tanh();
    }
    state
}

#[differentiable]
pub fn bent<S: Real<Mask = bool>>(x: S) -> S {
    if x.cmplt(S::ZERO) { x * x } else { (x + S::ONE).sin() }
}
