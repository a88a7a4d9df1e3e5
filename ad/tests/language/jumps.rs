//! `while`, `loop`, labels, `break` and `continue` at any depth.

use ad::{Mask, Real, differentiable};

use crate::oracle::{check, check_generic};

#[differentiable]
fn while_condition<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    while a.cmplt(S::from_f64(10.0)).all() {
        a = a * a + y;
    }
    a * x
}

#[differentiable]
fn zero_trips(x: f64, y: f64) -> f64 {
    let mut a = x * y;
    while a > 100.0 {
        a *= 0.5;
    }
    for _ in 5..2 {
        a *= y;
    }
    a + x
}

#[differentiable]
fn while_with_counter(x: f64, y: f64) -> f64 {
    let (mut a, mut b) = (x, y);
    let mut i = 0;
    let mut total: f64 = 0.0;
    while i < 7 && total < 20.0 {
        let t = a * b + i as f64;
        a = b;
        b = t * 0.5;
        total += a * t;
        i += 1;
    }
    total * i as f64
}

#[differentiable]
fn root(x: f64, y: f64) -> Option<f64> {
    if x > y { Some((x - y).sqrt()) } else { None }
}

#[differentiable]
fn while_let(x: f64, y: f64) -> f64 {
    let mut a = x;
    let mut product = 1.0;
    while let Some(r) = root(a, y) {
        product *= r;
        a = a - r * 0.5 - 0.1;
        if product < 1e-3 {
            break;
        }
    }
    product * a
}

#[differentiable]
fn loop_with_value<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    let found = loop {
        a = a * y + S::ONE;
        if a.cmpgt(S::from_f64(20.0)).all() {
            break a * x;
        }
        if a.cmplt(S::from_f64(-5.0)).all() {
            break y;
        }
        a = a + x;
    };
    found * a
}

#[differentiable]
fn loop_as_tail(x: f64, y: f64) -> f64 {
    let mut a = x;
    loop {
        a += y * y + 0.1;
        if a > 8.0 {
            return a * y;
        } else if a > 3.0 && y > 1.0 {
            break a;
        }
    }
}

#[differentiable]
fn loop_left_by_return(x: f64, y: f64) -> f64 {
    let mut a = x;
    loop {
        a = a * 1.5 + y * y;
        if a > 10.0 {
            return a * y;
        }
    }
}

#[differentiable]
fn loop_of_constants(x: f64, y: f64) -> f64 {
    let mut n = 1;
    let steps: i32 = loop {
        n *= 2;
        if n as f64 > x {
            break n + 1;
        }
    };
    let scale = loop {
        break 3.0;
    };
    x * y * steps as f64 + scale * y
}

#[differentiable]
fn break_and_continue(x: f64, y: f64) -> f64 {
    let mut a = x;
    let mut b = 0.0;
    for i in 0..12 {
        a = a * y + 0.3;
        if i % 3 == 1 {
            continue;
        }
        b += a * x;
        if b > 6.0 {
            b *= y;
            break;
        }
        a += b;
    }
    a * b
}

/// Jumps in the middle of arms that go on.
#[differentiable]
fn jumps_among_arms(x: f64, y: f64) -> f64 {
    let mut a = x;
    let mut i = 0;
    while i < 20 {
        i += 1;
        let b = match i % 4 {
            0 => continue,
            1 => {
                a *= y;
                if a > 5.0 {
                    break;
                }
                a + y
            }
            2 if a < -3.0 => break,
            _ => {
                a += 0.2 * x;
                a * a
            }
        };
        a = 0.6 * b + a * 0.1;
    }
    a + i as f64 * x
}

#[differentiable]
fn labels(x: f64, y: f64) -> f64 {
    let mut total = x;
    'rows: for i in 0..5 {
        let mut row = y;
        for j in 0..5 {
            row = row * x + j as f64 * 0.1;
            if j == i {
                continue;
            }
            if row > 4.0 {
                total += row;
                continue 'rows;
            }
            if total > 30.0 {
                break 'rows;
            }
            if row < -2.0 {
                return total * row;
            }
            total += row * y;
        }
        total *= 1.1;
    }
    total * y
}

#[differentiable]
fn value_through_labels(x: f64, y: f64) -> f64 {
    let mut a = x;
    let found = 'outer: loop {
        let mut k = 0;
        let inner = loop {
            a += y * 0.7 + 0.05;
            k += 1;
            if a > 9.0 {
                break 'outer a * a;
            }
            if k > 3 {
                break a * y;
            }
            if a < -20.0 {
                return x;
            }
        };
        if inner > 5.0 && y < 1.0 {
            break inner + x;
        }
        a = a + 0.1 * inner * inner;
    };
    found * x
}

#[differentiable]
fn labelled_block(x: f64, y: f64) -> f64 {
    let a = 'found: {
        if x > 1.0 {
            break 'found x * y;
        }
        let t = x * x;
        for i in 0..4 {
            if t * (i as f64) > y {
                break 'found t + y;
            }
        }
        if y < -5.0 {
            return t;
        }
        y * y
    };
    'last: {
        if a > 3.0 {
            break 'last a * x;
        }
        a * a
    }
}

#[differentiable]
fn option_in_loops(x: f64, y: f64) -> Option<f64> {
    let mut a = x;
    let mut i = 0;
    while root(a, y)? > 0.5 {
        a -= 0.4 * root(a, 0.0)?;
        i += 1;
        if i == 2 {
            continue;
        }
        a -= 0.1;
        if i > 6 {
            break;
        }
    }
    Some(a * root(a, y * 0.5)?)
}

#[test]
fn while_loops() {
    check_generic!(while_condition(x, y) at [1.3, 0.7], [11.0, 2.0], [2.1, 0.4], [0.2, 1.5]);
    check!(zero_trips(x, y) at [1.3, 0.7]);
    check!(while_with_counter(x, y) at [1.3, 0.7], [3.0, 2.5], [9.0, 8.0]);
    check!(while_let(x, y) at [1.3, 0.7], [0.3, 0.7], [4.0, 0.2], [30.0, 2.0]);
}

#[test]
fn endless_loops() {
    check_generic!(loop_with_value(x, y) at [1.3, 1.7], [-3.3, 0.9], [25.0, 2.0], [-30.0, 0.5]);
    check!(loop_as_tail(x, y) at [1.3, 0.7], [1.3, 1.7], [9.0, 0.3]);
    check!(loop_left_by_return(x, y) at [1.3, 0.7], [12.0, 0.7]);
    check!(loop_of_constants(x, y) at [1.3, 0.7], [13.0, 0.7]);
}

#[test]
fn jumps() {
    check!(break_and_continue(x, y) at [1.3, 0.7], [0.2, 0.1], [-2.0, 0.4], [4.0, 3.0]);
    check!(jumps_among_arms(x, y) at [1.3, 0.7], [-2.5, 1.4], [3.1, 2.1], [0.1, 0.2]);
    check!(labels(x, y) at [1.3, 0.7], [0.4, 0.9], [2.5, 1.1], [-1.5, 2.0], [1.02, 1.9]);
    check!(
        value_through_labels(x, y) at [1.3, 0.7], [1.3, 0.2], [9.5, 0.3], [-30.0, -1.0], [0.2, 1.3]
    );
    check!(labelled_block(x, y) at [1.3, 0.7], [1.3, 5.7], [0.6, 0.9], [0.6, 2.9], [0.6, -6.0]);
}

#[test]
fn jumps_of_options() {
    for (x, y) in [(2.0, 0.3), (5.0, 0.1), (0.2, 0.3), (9.0, 0.05), (1.1, 0.9), (3.0, -40.0)] {
        let (value, pullback) = option_in_loops::vjp(x, y);
        assert_eq!(value, option_in_loops(x, y));
        let (to_x, to_y) = pullback(1.0);
        if value.is_some() {
            let primal = |p: &[f64]| option_in_loops(p[0], p[1]).unwrap();
            crate::oracle::assert_gradient("option_in_loops", primal, &[x, y], &[to_x, to_y]);
        } else {
            assert_eq!((to_x, to_y), (0.0, 0.0));
        }
    }
}

fn goes_on() -> bool {
    true
}

/// Loops whose body never comes to its end.
#[differentiable]
fn run_once(x: f64, y: f64) -> f64 {
    let mut s = x;
    while goes_on() {
        s *= y;
        break;
    }
    for _ in 0..3 {
        s += y;
        break;
    }
    for t in [x, y] {
        s *= t;
        return s;
    }
    s
}

#[test]
fn bodies_without_an_end() {
    crate::oracle::check!(run_once(x, y) at [0.7, 0.4], [-0.4, 1.7]);
}

/// Iterators of iterators are loops within the loop whose items they are: jumps lead to that one.
#[differentiable]
fn continued(x: f64, y: f64) -> f64 {
    let rows = vec![vec![x, -y], vec![], vec![y, x * y, 2.0]];
    let mut s = 1.0 + x;
    for t in rows.iter().flatten() {
        if *t < 0.0 {
            s += 0.5;
            continue;
        }
        s += t * s.cos();
    }
    'pairs: for (i, j) in (0..3).flat_map(|i| (0..4).map(move |j| (i, j))) {
        if i == j {
            s *= x;
            continue;
        }
        for k in 0..j {
            if k == i {
                continue 'pairs;
            }
            s += rows[2][k.min(2)] * s.sin();
        }
    }
    s
}

#[test]
fn loops_over_iterators_of_iterators_go_on() {
    crate::oracle::check!(continued(x, y) at [0.7, 0.4], [1.3, -0.6]);
}
