//! What random programs use that has effects, or names that mean several things.

use std::cell::Cell;

use ad::{Differentiable, Real, differentiable};

use crate::types::Pair;

thread_local! {
    static SEED: Cell<u64> = const { Cell::new(1) };
    static SCALE: Cell<f64> = const { Cell::new(1.0) };
}

/// Starts anew: every run of a program draws the same numbers.
pub fn reset() {
    SEED.set(1);
    SCALE.set(1.0);
}

/// The next random number.
pub fn draw() -> f64 {
    let seed =
        SEED.get().wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    SEED.set(seed);
    (seed >> 33) as f64 / (1_u64 << 31) as f64
}

/// What the innermost guard has set.
pub fn scale() -> f64 {
    SCALE.get()
}

/// Sets the scale, until it is dropped.
pub struct Guard(f64);

impl Guard {
    pub fn set(scale: f64) -> Self {
        Self(SCALE.replace(scale))
    }
}

impl Drop for Guard {
    fn drop(&mut self) {
        SCALE.set(self.0);
    }
}

/// Changes the values, and tells something of them.
#[differentiable]
pub fn raises<S: Real<Mask = bool>>(values: &mut [S]) -> bool {
    let mut carried = S::HALF;
    for value in values.iter_mut() {
        *value = (*value * carried + S::HALF).sin();
        carried = *value;
    }
    carried.cmpgt(S::ZERO)
}

#[differentiable]
pub fn raised<S: Real<Mask = bool>>(values: &mut [S]) -> usize {
    let mut count = 1;
    for i in 1..values.len() {
        values[i] = (values[i] - values[i - 1]).cos();
        if values[i].cmplt(S::HALF) {
            count += 1;
        }
    }
    count
}

#[derive(Clone, Copy, Differentiable)]
pub struct Ball<S> {
    pub height: S,
    pub speed: S,
}

#[differentiable]
impl<S: Real<Mask = bool>> Ball<S> {
    pub fn bounce(&mut self) -> bool {
        self.height = (self.height + self.speed * S::HALF).sin();
        if self.height.cmplt(S::ZERO) {
            self.speed = -self.speed * self.height;
            true
        } else {
            false
        }
    }

    pub fn run(&mut self, steps: usize) -> S {
        let mut hits = 0;
        for _ in 0..steps {
            if self.bounce() && hits < 2 {
                hits += 1;
            }
        }
        let last: bool = self.bounce();
        if last { self.height * S::from_f64(hits as f64) } else { self.speed }
    }
}

pub mod left {
    use ad::{Real, differentiable};

    #[differentiable]
    pub fn curved<S: Real>(x: S) -> S {
        x.sin() * x
    }
}

pub mod right {
    use ad::{Real, differentiable};

    #[differentiable]
    pub fn curved<S: Real>(x: S) -> S {
        x.cos() - S::HALF
    }
}

#[differentiable]
pub fn curved<S: Real>(x: S) -> S {
    x.tanh()
}

#[differentiable]
pub trait Soft {
    fn pressed(&self) -> Self;
}

#[differentiable]
pub trait Hard {
    fn pressed(&self) -> Self;
}

#[differentiable]
impl<S: Real<Mask = bool>> Soft for Pair<S> {
    fn pressed(&self) -> Self {
        Self { a: self.a.sin(), b: self.b * self.a }
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Hard for Pair<S> {
    fn pressed(&self) -> Self {
        Self { a: self.b * self.b, b: self.a.cos() }
    }
}

#[differentiable]
impl<S: Real<Mask = bool>> Pair<S> {
    pub fn pressed(&self) -> Self {
        Self { a: self.a * self.b, b: self.a - self.b }
    }
}

/// A constant whose name could be that of a variable.
#[allow(non_upper_case_globals)]
pub const two: usize = 2;

/// A program from parts, which its own names and operators must not meet.
macro_rules! of_parts {
    ($(#[$mark:meta])? $name:ident $(<$s:ident>)? ($x:ident, $y:ident: $scalar:ty) $number:path, $p:expr, $q:expr, $r:expr) => {
        $(#[$mark])?
        fn $name $(<$s: Real<Mask = bool>>)? ($x: $scalar, $y: $scalar) -> $scalar {
            let a = $p * $number(2.0) - $q;
            let t = a * $q;
            let b = t - $p * $r;
            let sum = [a, t, b].iter().fold($number(0.5), |b, t| b * $r + *t * $p);
            (b * $p + a / ($number(1.5) + $r * $r) + sum - -$q).tanh()
        }
    };
}

pub(crate) use of_parts;
