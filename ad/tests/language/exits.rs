//! Early exits: `return`, `?`, `let .. else`.

use ad::{Differentiable, Mask, Real, differentiable};

use crate::oracle::{assert_gradient, check, check_generic};

#[differentiable]
fn early_return<S: Real>(x: S, y: S) -> S {
    if x.cmplt(S::ZERO).all() {
        return y * x;
    }
    let z = match y.cmpgt(S::ONE).all() {
        true => x * y,
        false => return x,
    };
    if z.cmpgt(S::from_f64(10.0)).all() {
        let w = z * z;
        if y.cmpgt(S::from_f64(5.0)).all() {
            return w.sqrt() * x;
        }
    }
    z * z
}

#[derive(Clone, Differentiable)]
struct Sample {
    weight: f64,
    values: Vec<f64>,
    best: Option<f64>,
}

/// What a `match` may not look at without parentheses.
#[differentiable]
fn struct_literals_before_else(x: f64, y: f64) -> f64 {
    let sample = Sample { weight: x, values: vec![x * y, y], best: Some(x) };
    let Some(best) = Sample { weight: y, ..sample.clone() }.best else { return y };
    y * best + struct_literals_before_failures(&sample, x).unwrap_or(y)
}

#[differentiable]
fn struct_literals_before_failures(sample: &Sample, x: f64) -> Option<f64> {
    let twice = Sample { best: Some(x), ..sample.clone() }.best.map(|best| 2.0 * best * x)?;
    let best = Sample { weight: x, ..sample.clone() }.best?;
    let Some(lent) = &Sample { weight: x, ..sample.clone() }.best else { return None };
    Some(sample.weight * twice - best * sample.values[0] + lent * x)
}

/// Nor a `for`, which iterators become.
#[differentiable]
fn struct_literals_before_iterators(x: f64, y: f64) -> f64 {
    let sample = Sample { weight: x, values: vec![x * y, y], best: None };
    let (large, small): (Vec<f64>, Vec<f64>) =
        Sample { weight: y, ..sample.clone() }.values.into_iter().partition(|value| *value > 0.8);
    let roots: Option<Vec<f64>> = Sample { weight: y, ..sample.clone() }
        .values
        .iter()
        .map(|value| if *value > 0.0 { Some(value.sqrt()) } else { None })
        .collect();
    let root = roots.map_or(x, |roots| roots[0]);
    root + large.iter().sum::<f64>() - x * small.iter().sum::<f64>()
}

#[differentiable]
fn several_arms_go_on(x: f64, y: f64) -> f64 {
    let mut a = x;
    let b = if x > 1.0 {
        a *= y;
        if a > 5.0 {
            return a;
        }
        a + x
    } else if x > 0.0 {
        a = y * y;
        y
    } else {
        return x * y;
    };
    a * b
}

#[differentiable]
fn return_from_loop(x: f64, y: f64) -> f64 {
    let mut p = y;
    for i in 0..5 {
        p *= x + i as f64;
        if p > 10.0 {
            return p * x;
        }
        p += y;
    }
    p * p * x
}

#[differentiable]
fn return_from_nested_loops(x: f64, y: f64) -> f64 {
    let mut acc = x;
    for i in 0..4 {
        for j in 0..4 {
            acc += y * (i * j) as f64;
            if acc > 8.0 {
                if y > 1.0 {
                    return acc * y;
                } else {
                    return acc * acc;
                }
            }
        }
        if acc < -3.0 {
            return x;
        }
        acc *= x;
    }
    acc + y
}

#[differentiable]
fn return_in_block(x: f64, y: f64) -> f64 {
    let a = {
        let x = x * 2.0;
        if x > y {
            return x * x * y;
        }
        x + y
    };
    return a * x;
}

#[differentiable]
fn safe_sqrt(x: f64) -> Option<f64> {
    if x < 0.0 { None } else { Some(x.sqrt()) }
}

#[differentiable]
fn safe_ln(x: f64) -> Option<f64> {
    if x <= 0.0 {
        return None;
    }
    Some(x.ln())
}

#[differentiable]
fn question_marks(x: f64, y: f64) -> Option<f64> {
    let a = safe_sqrt(x)? + y * safe_sqrt(safe_ln(y)?)?;
    let b = match y > 3.0 {
        true => safe_ln(a)?,
        false => a * a,
    };
    if safe_sqrt(b)? > 1.0 {
        return Some(b * safe_sqrt(x * y)?);
    }
    let mut c = x;
    c *= safe_ln(y)?;
    Some(a * c)
}

#[differentiable]
fn question_mark_in_loop(x: f64, y: f64) -> Option<f64> {
    let mut a = x;
    for i in 0..3 {
        a = safe_sqrt(a * y - i as f64 * 0.5)? + x;
    }
    safe_ln(a)
}

#[differentiable]
fn let_else(x: f64, y: f64) -> f64 {
    let Some(a) = safe_sqrt(x) else {
        return y * y;
    };
    let Some(mut b) = safe_sqrt(y - a) else {
        let t = a * y;
        return t * x;
    };
    b *= a;
    let (Some(c), d) = (safe_ln(b), a * b) else { return b };
    c * d + a
}

#[differentiable]
fn if_let_else_chain(x: f64, y: f64) -> f64 {
    if let Some(a) = safe_sqrt(x) {
        if let Some(b) = safe_ln(y) {
            return a * b;
        }
        a
    } else if let Some(b) = safe_sqrt(y) {
        b * x
    } else {
        x * y
    }
}

#[derive(Clone, Copy, Differentiable)]
struct Hit {
    distance: f64,
    normal: f64,
}

#[differentiable]
fn intersect(x: f64, y: f64) -> Option<Hit> {
    let discriminant = x * x - y;
    let root = safe_sqrt(discriminant)?;
    Some(Hit { distance: x - root, normal: y * root })
}

#[differentiable]
fn struct_in_option(x: f64, y: f64) -> f64 {
    let Some(hit) = intersect(x, y) else { return x * y };
    let Some(Hit { distance, normal }) = intersect(x + hit.distance, y) else { return hit.normal };
    distance * normal + hit.distance
}

#[test]
fn returns() {
    check_generic!(
        early_return(x, y) at [-1.3, 0.7], [1.0, 4.0], [1.0, 0.5], [4.0, 3.0], [4.0, 6.0]
    );
    check!(several_arms_go_on(x, y) at [1.3, 0.7], [1.3, 6.0], [0.4, 2.1], [-0.4, 2.1]);
    check!(struct_literals_before_else(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(struct_literals_before_iterators(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(return_from_loop(x, y) at [1.3, 0.7], [0.1, 0.2], [-2.2, 0.3], [9.0, 3.0], [1.7, 0.2]);
    check!(
        return_from_nested_loops(x, y)
            at [1.3, 0.7], [1.3, 2.7], [0.3, 0.1], [-4.0, 0.2], [2.0, -1.0], [1.8, 0.4]
    );
    check!(return_in_block(x, y) at [1.3, 0.7], [0.3, 1.7]);
}

/// Checks a function with an optional result: where it is `None`, nothing flows back.
fn check_option(
    name: &str,
    f: fn(f64, f64) -> Option<f64>,
    vjp: impl Fn(f64, f64) -> (Option<f64>, (f64, f64)),
    x: f64,
    y: f64,
) {
    let (value, (to_x, to_y)) = vjp(x, y);
    assert_eq!(value, f(x, y), "{name} at {x}, {y}");
    match value {
        Some(_) => {
            let primal = |p: &[f64]| f(p[0], p[1]).unwrap();
            assert_gradient(name, primal, &[x, y], &[to_x, to_y]);
        }
        None => assert_eq!((to_x, to_y), (0.0, 0.0), "{name} at {x}, {y}"),
    }
}

#[test]
fn options() {
    let points = [(2.0, 3.5), (2.0, 2.5), (-1.0, 2.0), (0.3, 1.1), (0.3, 0.4), (0.5, 9.0)];
    for (x, y) in points {
        let vjp = |x, y| {
            let (value, pullback) = question_marks::vjp(x, y);
            (value, pullback(1.0))
        };
        check_option("question_marks", question_marks, vjp, x, y);
        let vjp = |x, y| {
            let (value, pullback) = question_mark_in_loop::vjp(x, y);
            (value, pullback(1.0))
        };
        check_option("question_mark_in_loop", question_mark_in_loop, vjp, x, y);
    }
    assert!(question_marks(2.0, 3.5).is_some() && question_marks(0.3, 0.4).is_none());
}

#[test]
fn let_else_and_if_let() {
    check!(let_else(x, y) at [-1.3, 0.7], [1.3, 0.7], [1.3, 2.7], [0.01, 2.0]);
    check!(if_let_else_chain(x, y) at [1.3, 0.7], [1.3, -0.7], [-1.3, 0.7], [-1.3, -0.7]);
    check!(struct_in_option(x, y) at [2.0, 1.5], [0.5, 1.5], [1.3, 1.6]);
}

#[derive(Clone, Copy, Debug, Differentiable)]
enum State {
    Idle,
    Moving { v: f64, left: u32 },
    Done(f64),
}

/// An assignment of what may leave the loop, and changes something on the way.
#[differentiable]
fn machine(x: f64, y: f64) -> f64 {
    let mut state = State::Idle;
    let mut position = 0.0;
    let mut marks = [x; 3];
    let mut steps = 0;
    loop {
        steps += 1;
        marks[steps % 3] = if steps > 9 {
            break x;
        } else {
            position += 0.1 * y;
            position * x
        };
        state = match state {
            State::Idle => State::Moving { v: x, left: 4 },
            State::Moving { v, left: 0 } => State::Done(v * position),
            State::Moving { v, left } => {
                position += v * 0.5;
                State::Moving { v: v * y + 0.1, left: left - 1 }
            }
            State::Done(r) => break r + steps as f64 * x * marks[0] + marks[1],
        };
    }
}

#[test]
fn assignments_of_what_leaves() {
    check!(machine(x, y) at [1.3, 0.7], [0.4, 2.1]);
}
