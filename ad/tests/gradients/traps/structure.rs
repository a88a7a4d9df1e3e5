//! The structure of the control flow: loops, exits, arms not taken, parameters not used.

use ad::{Differentiable, differentiable, select, stop_gradient};
use glam::DVec3;

use crate::oracle::{assert_close, assert_gradient, check};

#[differentiable]
fn nested_bounded_loops(x: f64, y: f64) -> f64 {
    let mut total = 0.0;
    for i in 0..4 {
        let mut inner = x;
        for j in i..4 {
            inner = inner * y + x * j as f64;
        }
        total += inner * inner * i as f64;
    }
    total
}

#[differentiable]
fn code_after_loop_with_return(x: f64, y: f64) -> f64 {
    let mut a = x;
    for i in 0..5 {
        a = a * y;
        if a < 0.1 {
            return a * i as f64 + y;
        }
    }
    let b = a * a;
    for _ in 0..2 {
        if b > 4.0 {
            return b * x;
        }
        a += b;
    }
    a * b
}

#[differentiable]
fn vector_from_loop(x: f64, y: f64) -> DVec3 {
    let mut v = DVec3::new(x, y, 1.0);
    for i in 0..3 {
        v = v.cross(DVec3::new(y, i as f64, x)) + v * x;
    }
    v
}

/// The Jacobian of the body depends on a parameter.
#[differentiable]
fn newton(guess: f64, target: f64) -> f64 {
    let mut x = guess;
    for _ in 0..6 {
        x = x - (x * x - target) / (2.0 * x);
        if (x * x - target).abs() < 1e-14 {
            return x;
        }
    }
    x
}

#[differentiable]
fn early_exit_of_product(x: f64, y: f64) -> f64 {
    let factors = [x, y, x * y, x + y, y];
    let mut product = 1.0;
    for i in 0..5 {
        if factors[i] < 0.0 {
            return product;
        }
        product *= factors[i];
    }
    product
}

/// The product is left before a factor that would end it at zero.
#[differentiable]
fn early_break_of_product(x: f64, y: f64) -> f64 {
    let factors = [x, y, x * y, x - 1.3, y];
    let mut product = 1.0;
    let mut used = 0;
    for factor in factors.iter() {
        if *factor == 0.0 || product > 3.0 {
            break;
        }
        product *= factor;
        used += 1;
    }
    while product < 0.5 {
        product *= 1.0 + x * x;
        if used > 4 {
            break;
        }
        used += 1;
    }
    product * used as f64
}

/// A loop within a loop, each left and continued from within the other's iterations, with what
/// follows depending on where.
#[differentiable]
fn code_after_nested_breaks(x: f64, y: f64) -> f64 {
    let mut total = x;
    let mut i = 0;
    'outer: loop {
        i += 1;
        if i > 12 {
            break;
        }
        let mut row = y;
        for j in 0..i {
            row = row * x + total * 0.1;
            if row > 3.0 {
                total += row;
                continue 'outer;
            }
            if i + j > 8 {
                break 'outer;
            }
        }
        if total > 6.0 {
            return total * row;
        }
        total = total * 1.2 + row;
    }
    total * y + x
}

/// What the arm not taken computes is infinite or not a number.
#[differentiable]
fn arm_not_taken(x: f64, y: f64) -> f64 {
    let a = if x > 0.0 { x.sqrt() * x.ln() } else { y };
    let b = select(x > 0.0, x.sqrt().abs() * x.ln(), y * x);
    let c = select(x > 0.0, y / x.max(0.0).sqrt(), y);
    let d = select(x > 0.0, DVec3::new(x.ln(), y, 1.0).normalize().x, 1.0);
    a * y + b + c * d
}

#[differentiable]
fn used_zero_one_many_times(zero: f64, one: f64, many: f64) -> f64 {
    let unused = zero * one;
    let _ = unused * many;
    one + many * many + many / (many + many) - many
}

#[derive(Clone, Copy, Differentiable)]
struct Light {
    #[allow(dead_code)]
    position: DVec3,
    power: [f64; 2],
    #[constant]
    id: usize,
}

#[differentiable]
#[allow(unused_variables)]
fn unused_parameters(light: Light, v: DVec3, pair: (f64, [f64; 3]), o: Option<f64>, n: i32) -> f64 {
    light.power[1]
}

#[differentiable]
fn returns_constant(x: f64, y: f64) -> f64 {
    if x > y {
        return 3.0;
    }
    2.0
}

#[differentiable]
fn returns_parameter(x: f64, y: f64) -> f64 {
    if x > y { x } else { y }
}

#[differentiable]
fn stopped(x: f64, y: f64) -> f64 {
    let cell = stop_gradient(x.floor()) as i32;
    let weight = ad::stop_gradient(x * y);
    y * cell as f64 + weight * x
}

#[test]
fn loops() {
    check!(nested_bounded_loops(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(code_after_loop_with_return(x, y) at [1.3, 0.7], [1.3, 1.7], [1.3, 0.4], [2.3, 0.95]);
    check!(newton(x, y) at [1.3, 0.7], [3.0, 2.0], [1.4143, 2.0]);
    check!(early_exit_of_product(x, y) at [1.3, 0.7], [1.3, -0.7], [-1.3, 0.7], [1.3, 4.0]);
    check!(early_break_of_product(x, y) at [1.2, 0.7], [0.4, 0.3], [2.1, 1.6], [-0.4, 0.9]);
    check!(code_after_nested_breaks(x, y) at [1.3, 0.7], [0.4, 0.2], [-0.9, 0.3], [0.2, 2.5]);
    let (by_x, by_y) = early_break_of_product::grad(1.3, 0.7);
    assert_close("product before a zero", by_x, 3.0 * 2.0 * 1.3 * 0.7 * 0.7, 1e-14);
    assert_close("product before a zero", by_y, 3.0 * 2.0 * 1.3 * 1.3 * 0.7, 1e-14);
    let (value, pullback) = vector_from_loop::vjp(1.3, 0.7);
    assert_eq!(value, vector_from_loop(1.3, 0.7));
    let cotangent = DVec3::new(0.3, -2.0, 0.9);
    let (to_x, to_y) = pullback(cotangent);
    let primal = |p: &[f64]| vector_from_loop(p[0], p[1]).dot(cotangent);
    assert_gradient("vector_from_loop", primal, &[1.3, 0.7], &[to_x, to_y]);
}

#[test]
fn arms_not_taken_poison_nothing() {
    check!(arm_not_taken(x, y) at [1.3, 0.7], [-1.3, 0.7]);
    let (to_x, to_y) = arm_not_taken::grad(0.0, 0.7);
    assert_eq!((to_x, to_y), (0.7, 2.4));
}

#[test]
fn uses() {
    let gradient = used_zero_one_many_times::grad(2.0, 3.0, 5.0);
    assert_eq!(gradient, (0.0, 1.0, 9.0));
    check!(returns_parameter(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    assert_eq!(returns_constant::grad(1.0, 2.0), (0.0, 0.0));
    assert_eq!(returns_constant::grad(2.0, 1.0), (0.0, 0.0));
}

#[test]
fn unused_parameters_have_zeros_of_their_shape() {
    let light = Light { position: DVec3::ONE, power: [1.0, 2.0], id: 3 };
    assert_eq!(light.id, 3);
    let (to_light, to_v, to_pair, to_option, ()) =
        unused_parameters::grad(light, DVec3::ONE, (1.0, [2.0; 3]), Some(1.0), 1);
    assert_eq!((to_light.position, to_light.power), (DVec3::ZERO, [0.0, 1.0]));
    assert_eq!((to_v, to_pair, to_option), (DVec3::ZERO, (0.0, [0.0; 3]), 0.0));
}

#[test]
fn stop_gradient_stops() {
    assert_eq!(stopped::grad(2.5, 3.0), (7.5, 2.0));
}
