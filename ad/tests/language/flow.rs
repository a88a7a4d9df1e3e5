//! Branches and loops.

use ad::{Mask, Real, differentiable};

use crate::oracle::{check, check_generic};

#[differentiable]
fn if_statement(x: f64, y: f64) -> f64 {
    let mut a = x * y;
    if x > y {
        a *= x;
        let x = a + y;
        a += x;
    } else if y > 2.0 {
        a = y * y;
    }
    if a > 100.0 {
        a = x;
    }
    a * y
}

#[differentiable]
fn if_expression<S: Real>(x: S, y: S) -> S {
    let a = if x.cmpgt(y).all() { x.sin() } else { y * y * x };
    let b = if (a - x).cmplt(S::ZERO).all() & y.cmpgt(S::ZERO).all() {
        let t = a * y;
        t - x
    } else {
        S::ONE
    };
    a * b + b
}

#[differentiable]
fn assignments_without_semicolon(x: f64, y: f64) -> f64 {
    let mut a = x;
    if x > y {
        a = y * y
    } else {
        a *= y
    }
    match x > 1.0 {
        true => a += x * y,
        false => a = a * x,
    }
    a
}

#[differentiable]
fn match_numbers(x: f64, n: usize) -> f64 {
    let a = match n {
        0 => x,
        1 | 2 => x * x,
        3..=5 => {
            let t = x.sin();
            t * t
        }
        n if n % 2 == 0 => x * n as f64,
        _ => 1.0,
    };
    match n {
        0 => a * x,
        _ => a,
    }
}

#[differentiable]
fn match_tuple<S: Real>(x: S, y: S) -> S {
    let mut scale = S::ONE;
    match (x.cmpgt(S::ZERO).all(), y.cmpgt(S::ZERO).all()) {
        (true, true) => scale = x * y,
        (true, false) => {
            scale = scale - y;
        }
        _ => {}
    }
    match (x * y, x - y) {
        (a, b) if a.cmpgt(b).all() => a * scale,
        (a, mut b) => {
            b = b * a;
            b * scale + a
        }
    }
}

#[differentiable]
fn match_option(x: f64, y: f64) -> f64 {
    let a = if x > 0.0 { Some(x * y) } else { None };
    let b = match a {
        Some(a) if a > 2.0 => a * a,
        Some(a) => a + y,
        None => y * x * 3.0,
    };
    if let Some(a) = a { a * b } else { b - x }
}

#[differentiable]
fn nested_loops(x: f64, y: f64) -> f64 {
    let mut acc = x;
    for i in 0..3 {
        let mut row = y * i as f64;
        for j in 0..=i {
            row = (row + x * j as f64).sin();
            for _ in 1..3 {
                acc += row * x;
            }
        }
        acc *= row + 1.0;
    }
    acc
}

#[differentiable]
fn loops_and_branches<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    let mut b = y;
    for i in 0..6 {
        if i % 2 == 0 {
            a = a * b + x;
        } else {
            for j in i..i + 2 {
                if a.cmpgt(b).all() {
                    b = (a * S::from_f64(j as f64)).sin();
                } else {
                    a = a - b * y;
                }
            }
        }
    }
    a * b
}

#[differentiable]
fn horner<const N: usize>(coefficients: [f64; N], x: f64) -> f64 {
    let mut value = 0.0;
    for i in 0..N {
        value = value * x + coefficients[N - 1 - i];
    }
    value
}

#[differentiable]
fn long_loop(x: f64, y: f64) -> f64 {
    let mut a = x;
    for i in 0..100 {
        a = a * y + (i as f64) * 0.01 * x;
    }
    a
}

#[differentiable]
fn trips(x: f64, from: usize, to: usize) -> f64 {
    let mut product = 1.0;
    for i in from..to {
        product *= x + i as f64 * 0.1;
    }
    product
}

#[differentiable]
fn discrete_branches(x: f64, y: f64) -> f64 {
    let k: usize = if x > y { 2 } else { 1 };
    let mut count = 0;
    for i in 0..3 {
        if x * i as f64 > y {
            count += 1;
        }
    }
    let positive: bool = match k {
        2 => y > 0.0,
        _ => true,
    };
    let flag = if positive { 1.0 } else { 2.0 };
    [y, x, x * y][k] * (count + k) as f64 * flag
}

#[test]
fn branches() {
    check!(if_statement(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.3, 1.2], [12.0, 3.0]);
    check_generic!(if_expression(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.3, 1.2], [-2.0, -1.0]);
    check!(assignments_without_semicolon(x, y) at [1.3, 0.7], [-0.4, 2.1], [1.3, 2.2], [0.3, 0.1]);
    check!(discrete_branches(x, y) at [1.3, 0.7], [-0.4, 2.1], [1.0, -0.3], [0.9, 1.2]);
}

#[test]
fn matches() {
    for n in 0..9 {
        let (value, (slope, ())) = match_numbers::value_and_grad(0.7, n);
        assert_eq!(value, match_numbers(0.7, n));
        let expected = ad::check::derivative(|x| match_numbers(x, n), 0.7, 1e-3).value;
        crate::oracle::assert_close("match_numbers", slope, expected, 1e-9);
    }
    check_generic!(
        match_tuple(x, y) at [1.3, 0.7], [1.3, -0.7], [-0.4, 2.1], [-0.4, -2.1], [2.0, 3.0]
    );
    check!(match_option(x, y) at [1.3, 0.7], [1.3, 4.0], [-0.4, 2.1]);
}

#[test]
fn loops() {
    check!(nested_loops(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(loops_and_branches(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.2, 0.1]);
    check!(long_loop(x, y) at [1.3, 0.7], [-0.4, -0.9]);
    for (from, to) in [(0, 0), (5, 2), (0, 1), (2, 9)] {
        let (value, (slope, (), ())) = trips::value_and_grad(0.7, from, to);
        assert_eq!(value, trips(0.7, from, to));
        let expected = ad::check::derivative(|x| trips(x, from, to), 0.7, 1e-3).value;
        crate::oracle::assert_close("trips", slope, expected, 1e-9);
    }
}

#[test]
fn constant_generics() {
    let point = [0.5, -1.0, 2.0, 0.25, 0.8];
    let primal = |p: &[f64]| horner([p[0], p[1], p[2], p[3]], p[4]);
    let ([a, b, c, d], x) = horner::grad([0.5, -1.0, 2.0, 0.25], 0.8);
    crate::oracle::assert_gradient("horner", primal, &point, &[a, b, c, d, x]);
    assert_eq!(horner::grad([], 0.8), ([], 0.0));
}

#[differentiable]
fn within_ranges(x: f64, y: f64) -> f64 {
    let values = [x, y, x * y];
    let mut sum = 0.0;
    for (i, t) in values.iter().enumerate() {
        let inside = (x.min(y)..=x.max(y)).contains(t);
        sum += match i {
            _ if (0.0..y).contains(t) => t * t,
            1..=2 if inside => x * t,
            _ => y,
        };
        if inside && !(..1.0).contains(&sum) {
            sum *= 1.5;
        }
    }
    sum
}

/// One of two patterns, or the end of the program.
#[differentiable]
fn either_or_panic(x: f64, y: f64) -> f64 {
    let either = if x > y { Some(Ok(x * x)) } else { Some(Err(x * y)) };
    let Some(Ok(a) | Err(a)) = either else { unreachable!("one of them holds") };
    let Some(Ok(b) | Err(b)) = either else { return x };
    a * b * y
}

#[test]
fn ranges_and_alternatives() {
    check!(within_ranges(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.2, 0.3]);
    check!(either_or_panic(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// Conditions in a row that bind references.
#[differentiable]
fn chained_references(x: f64, y: f64) -> f64 {
    let mut values = vec![x, y, x * y];
    let (mut sum, mut i) = (0.0, 0);
    while let Some(u) = values.get(i)
        && *u < 5.0
        && let Some(w) = values.last()
    {
        i += 1;
        sum += u * w;
        if let Some(first) = values.first()
            && first > u
            && let [second, ..] = &values[1..]
        {
            sum *= second * u;
        }
    }
    if let Some(t) = values.first_mut()
        && *t > 0.0
    {
        *t *= sum;
    }
    if let Some(t) = values.first()
        && *t > 1.0
    {
        *t * sum
    } else {
        values[0] + sum
    }
}

#[test]
fn chains_of_conditions() {
    check!(chained_references(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.2, 0.3]);
}

/// Blocks and branches within conditions, indices and what decides for an iterator.
#[differentiable]
#[allow(clippy::blocks_in_conditions, reason = "what is tested")]
fn blocks_that_decide(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y];
    let mut count = v
        .iter()
        .filter(|t| {
            let (scaled, limit) = (*t * y, 0.2);
            if scaled > 1.0 { **t > 0.0 } else { scaled > limit }
        })
        .count();
    let first = if {
        let x = x * y;
        let y = x + 1.0;
        y > 1.5
    } {
        2
    } else {
        1
    };
    let z = v[if y > 1.0 {
        2
    } else {
        let last = first;
        last - 1
    }];
    while {
        let distance = z * count as f64;
        distance < 2.0 && count < 4
    } {
        count += 1;
    }
    z * v[first] * count as f64 + x
}

#[differentiable]
fn blocks_before_operators(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    if x > -1.0 && {
        v.push(x * y);
        v.len()
    } == 3
    {
        v[0] *= 2.0;
    }
    let mut sum = 0.0;
    while sum < 4.0 && {
        v.push(sum * x);
        v.len()
    } < 7
    {
        sum += v[v.len() - 1] + y;
    }
    let last = if y > 9.0 || { v[v.len() - 1] } < x { v[2] } else { v[1] };
    sum * if x > 1.0 { x } else { y }
        + match v.len() {
            5 => last,
            _ => x,
        } * { y }
}

#[test]
fn blocks_in_conditions() {
    check!(blocks_that_decide(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.4, 0.3]);
    check!(blocks_before_operators(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.4, 0.3]);
}
