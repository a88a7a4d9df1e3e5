//! Code that is compiled under a condition: `all()` always holds, `any()` never.

#![allow(clippy::non_minimal_cfg, reason = "conditions whose answer is known")]

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn statements(x: f64, y: f64) -> f64 {
    #[cfg(any())]
    let scale = x;
    #[cfg(not(any()))]
    let scale = y * y;
    let mut sum = x;
    #[cfg(all())]
    {
        sum += scale * x;
    }
    #[cfg(any())]
    {
        sum *= 100.0;
    }
    #[cfg(all())]
    sum *= y;
    #[cfg(any())]
    sum -= 7.0 * x;
    #[cfg_attr(all(), differentiable(checkpoint))]
    for _ in 0..2 {
        #[cfg(any())]
        return x;
        #[cfg(all())]
        if sum > 100.0 {
            return x * y;
        }
        sum *= x;
    }
    #[cfg(all())]
    {
        sum * y
    }
    #[cfg(not(all()))]
    {
        sum
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Spring {
    stiffness: f64,
    #[cfg(any())]
    damping: f64,
    #[cfg(all())]
    rest: f64,
}

#[differentiable]
fn parts(x: f64, y: f64) -> f64 {
    let spring = Spring {
        stiffness: x,
        #[cfg(any())]
        damping: y,
        #[cfg(all())]
        rest: x * y,
    };
    let Spring {
        stiffness,
        #[cfg(any())]
        damping,
        #[cfg(all())]
        rest,
    } = spring;
    let powers = [
        x,
        #[cfg(any())]
        1.0,
        #[cfg(all())]
        x * y,
        #[cfg(all())]
        y,
    ];
    let (first, second) = (
        #[cfg(any())]
        1.0,
        powers[1],
        powers[2],
    );
    let chosen = match powers.len() {
        #[cfg(any())]
        3 => 1.0,
        #[cfg(all())]
        3 => x.max(
            #[cfg(any())]
            1.0,
            #[cfg(all())]
            y,
        ),
        _ => 2.0,
    };
    stiffness * rest + first * second * chosen
}

#[differentiable]
fn parameters(x: f64, #[cfg(any())] missing: f64, #[cfg(all())] y: f64) -> f64 {
    x * y * y
}

#[differentiable]
impl Spring {
    #[cfg(any())]
    fn energy(&self, missing: Missing) -> f64 {
        missing.energy()
    }

    #[cfg(all())]
    fn energy(&self, length: f64) -> f64 {
        #[cfg(any())]
        let stretch = 1.0;
        #[cfg(all())]
        let stretch = length - self.rest;
        self.stiffness * stretch * stretch
    }
}

#[differentiable]
trait Doubled {
    #[cfg(any())]
    fn doubled(&self, missing: Missing) -> f64;
    #[cfg(all())]
    fn doubled(&self) -> f64;
}

#[differentiable]
impl Doubled for Spring {
    #[cfg(all())]
    fn doubled(&self) -> f64 {
        2.0 * self.rest
    }
}

#[differentiable]
fn methods(x: f64, y: f64) -> f64 {
    let spring = Spring { stiffness: x, rest: y };
    spring.energy(x * y) * spring.doubled()
}

#[test]
fn conditions() {
    check!(statements(x, y) at [1.3, 0.7], [4.0, 3.0]);
    check!(parts(x, y) at [1.3, 0.7], [0.3, 0.9]);
    check!(parameters(x, y) at [1.3, 0.7]);
    check!(methods(x, y) at [1.3, 0.7]);
}
