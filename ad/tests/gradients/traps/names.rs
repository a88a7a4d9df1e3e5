//! The same name for different things.

use ad::{Differentiable, differentiable, no_diff};

use crate::oracle::check;

#[differentiable]
fn positive(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x * x) } else { None }
}

/// A name bound by an arm ends with the arm, though what follows the `match` runs in it.
#[differentiable]
fn arm_name_ends_with_arm(x: f64, y: f64) -> f64 {
    let a = match positive(x) {
        Some(y) => y + 1.0,
        None => return y,
    };
    a * y
}

#[differentiable]
fn if_let_name_ends_with_branch(x: f64, y: f64) -> f64 {
    let mut a = x;
    if let Some(x) = positive(y) {
        a += x;
    } else {
        return x * x;
    }
    a * x
}

#[differentiable]
fn let_else_name_goes_on(x: f64, y: f64) -> f64 {
    let Some(x) = positive(x * y) else {
        return x * 3.0;
    };
    x * y
}

#[differentiable]
fn shadowed_across_branches(x: f64, y: f64) -> f64 {
    let a = x * y;
    let b = if a > 1.0 {
        let a = a * x;
        let x = a + 1.0;
        if x > 3.0 {
            let a = x * x;
            a
        } else {
            x
        }
    } else {
        let y = a * a;
        y
    };
    a * b * x * y
}

#[differentiable]
fn shadowed_in_loop(x: f64, y: f64) -> f64 {
    let i = x * y;
    let mut acc = i;
    for i in 0..3 {
        let x = acc * i as f64;
        let acc_before = acc;
        acc = x + y;
        let acc = acc * acc_before;
        let _ = acc;
    }
    acc * i * x
}

/// Names of elements and of parameters of closures that are also names of variables, which a loop
/// changes.
#[differentiable]
fn elements_called_like_variables(x: f64, y: f64) -> f64 {
    let values = [x, y, x * y];
    let mut total = x;
    let mut count = 0;
    for i in 0..3 {
        let before = total * y;
        for total in values.iter() {
            if values.iter().any(|x| *x > *total && *x > y) {
                count += 1;
            }
        }
        let scaled = |count: f64| count * total;
        total = scaled(values[i]) + before * count as f64;
        if matches!(Some(count), Some(x) if x > 5) {
            total *= x;
        }
    }
    total * count as f64
}

/// Names begin with a capital letter in mathematics.
#[differentiable]
#[allow(non_snake_case)]
fn capital_names(x: f64, y: f64) -> f64 {
    let (A, B) = (x * y, x + y);
    let [C, _] = [A * A, B];
    let D = C * B;
    D + A
}

#[differentiable]
#[allow(non_snake_case)]
fn capital_parameters((A, B): (f64, f64), C: f64) -> f64 {
    A * B * C
}

/// A function of the user's that is called like one of `ad`'s.
#[differentiable]
fn select(mask: bool, x: f64, y: f64) -> f64 {
    if mask { x * x } else { y * y * y }
}

#[differentiable]
fn calls_own_select(x: f64, y: f64) -> f64 {
    select(x > y, x, y) + select(x < y, x, y)
}

#[differentiable]
fn raw_names(r#type: f64, y: f64) -> f64 {
    let r#match = r#type * y;
    let mut r#loop = r#match * r#match;
    r#loop += r#type;
    r#loop * r#match
}

#[derive(Clone, Debug, Differentiable)]
struct Raw {
    r#final: f64,
}

#[derive(Clone, Debug, Differentiable)]
enum RawVariant {
    r#Await(f64),
    #[allow(dead_code)]
    r#Do(Raw),
}

#[differentiable]
impl Raw {
    fn r#move(&self, by: f64) -> f64 {
        self.r#final * by
    }
}

#[differentiable]
fn raw_items(x: f64, y: f64) -> f64 {
    let raw = Raw { r#final: x * y };
    match RawVariant::r#Await(y) {
        RawVariant::r#Await(wait) => raw.r#move(wait),
        RawVariant::r#Do(raw) => raw.r#final,
    }
}

/// The tangent of a variant has another name than that of a struct beside the enum.
#[derive(Clone, Debug, Differentiable)]
struct ShapeCircle {
    radius: f64,
}

#[derive(Clone, Debug, Differentiable)]
enum Shape {
    Circle(ShapeCircle),
    Square(f64),
}

#[differentiable]
fn named_after_variants(x: f64, y: f64) -> f64 {
    let shapes = [Shape::Circle(ShapeCircle { radius: x }), Shape::Square(x * y)];
    let area = |shape: &Shape| match shape {
        Shape::Circle(circle) => circle.radius * circle.radius * y,
        Shape::Square(side) => side * side,
    };
    area(&shapes[0]) * area(&shapes[1])
}

/// Names that generated code might choose.
#[differentiable]
fn generated_names(x: f64, x_bar: f64) -> f64 {
    let value = x * x_bar;
    let product = value * x;
    let result_bar = product + value;
    let tape = result_bar * x_bar;
    let x_space = tape + x;
    let mut path = 0.0;
    if x_space > 0.0 {
        path = x_space * product;
    }
    path + tape
}

/// Constants whose names are in lower case, which only the compiler tells from variables.
#[allow(non_upper_case_globals)]
mod lower_case {
    use ad::differentiable;

    const zero: i32 = 0;
    const edge: f64 = 1.0;

    #[differentiable]
    pub fn of_integers(x: f64, y: f64) -> f64 {
        let mut s = 0.0;
        for n in 0..3 {
            s += match n {
                zero => x,
                _ => y * x,
            };
            s *= match n {
                zero => x,
                k if k > zero + 1 => k as f64 * y,
                k => y + k as f64,
            };
            if let zero = n {
                s *= y;
            }
            if matches!(n, zero) {
                s += x;
            }
            while let zero = n {
                s += y;
                break;
            }
            let f = |m: i32| match m {
                zero => x,
                _ => y,
            };
            s += f(n) * f(0);
        }
        s * edge
    }

    #[differentiable]
    pub fn of_numbers(x: f64, y: f64) -> f64 {
        match (x, 1) {
            (edge, zero) => x,
            (v, zero) => v * y,
            (v, k) => match Some(y) {
                Some(edge) => v * edge,
                Some(v) => v * x * k as f64,
                None => x,
            },
        }
    }
}

#[test]
fn constants_in_patterns() {
    use lower_case::{of_integers, of_numbers};

    check!(of_integers(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(of_numbers(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// Variables in the texts of macros, where nothing is differentiated.
#[differentiable]
fn written_out(x: f64, y: f64) -> f64 {
    use std::fmt::Write;

    let z = x * y;
    let y = z + y;
    let length = no_diff(|| {
        let mut text = String::new();
        if y > -1e6 {
            write!(text, "{y:.3} {z:.2} {0} {k:>w$.2}", x > y, k = 3.0, w = 5).unwrap();
            assert!(!text.is_empty(), "no {y}");
            text += &format!("{x:.1}{text}", text = 3,);
        }
        text.len()
    });
    let values = [x, y];
    let mut sum = length as f64 * x;
    for t in &values {
        sum += t * no_diff(|| format!("{t:.4}").len() as f64) * y;
    }
    sum
}

#[test]
fn names_in_texts() {
    check!(written_out(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

mod elsewhere {
    use ad::differentiable;

    #[differentiable]
    pub fn cube(x: f64) -> f64 {
        x * x * x
    }
}

#[differentiable]
fn renamed_call(x: f64, y: f64) -> f64 {
    use_of(elsewhere::cube(x), y)
}

#[differentiable]
fn use_of(x: f64, y: f64) -> f64 {
    third_power(x) * y
}

use elsewhere::cube as third_power;

#[test]
fn scopes() {
    check!(arm_name_ends_with_arm(x, y) at [1.3, 0.7], [-1.3, 0.7]);
    check!(if_let_name_ends_with_branch(x, y) at [1.3, 0.7], [1.3, -0.7]);
    check!(let_else_name_goes_on(x, y) at [1.3, 0.7], [1.3, -0.7]);
    check!(shadowed_across_branches(x, y) at [1.3, 0.7], [1.3, 1.7], [1.1, 0.95]);
    check!(elements_called_like_variables(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.4, 0.3]);
    check!(shadowed_in_loop(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn spellings() {
    check!(capital_names(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    assert_eq!(capital_parameters::grad((2.0, 3.0), 5.0), ((15.0, 10.0), 6.0));
    check!(raw_names(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(raw_items(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(named_after_variants(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(generated_names(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn paths() {
    check!(calls_own_select(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(renamed_call(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// What a pattern binds hides no variable of its name that something else stands for.
#[differentiable]
fn hidden_by_an_arm(x: f64, y: f64) -> f64 {
    let t = x * y;
    let q = t;
    let times_t = |a: f64| a * t;
    let (v, mut sum) = ([x, y], 1.0);
    let (w, chosen) = (v, (Some([y, x]), 3));
    for option in [Some(x), None, Some(y)] {
        match option {
            Some(t) if t > 0.5 => sum += q * t,
            Some(t) => sum -= times_t(t) + t,
            None => sum *= t,
        }
        if let (Some(v), 3) = chosen {
            sum += w[0] * v[0] - v[1] * w[1];
        }
    }
    sum
}

/// Nor does what is bound on the way, by `?`, hide one.
#[differentiable]
fn hidden_on_the_way(x: f64, y: f64) -> Option<f64> {
    let a = if x > y { x } else { y * y };
    let b = match positive(x) {
        Some(u) => u * a,
        None => a,
    };
    let c = positive(a * b)? * a + positive(b)? * (if a > b { b } else { a * y });
    Some(c * positive(c)? - a)
}

#[differentiable]
fn on_the_way(x: f64, y: f64) -> f64 {
    hidden_on_the_way(x, y).unwrap_or(x * y)
}

/// What a condition binds hides no parameter that has another name, too.
#[differentiable]
fn hidden_in_a_condition(x: f64, y: f64) -> f64 {
    let q = x;
    let w = y;
    let v = [y, 2.0, x * y];
    let above = v.iter().copied().any(|x| x > q);
    let chosen = matches!(Some(1.0), Some(x) if x > q);
    let first = v.iter().copied().position(|y| y > w).unwrap_or(2);
    let limit = {
        let y = 0.9;
        w > y
    };
    let scale = if chosen { q } else { w };
    if above && limit { scale * v[first] } else { w * scale + v[first] * q }
}

/// Names that are parts of paths in what is generated, of values that are moved.
#[differentiable]
fn parts_of_paths(x: f64, y: f64) -> f64 {
    let result = rules(vec![x]);
    let option = rules(vec![y, x]).ok();
    let attempt = rules(vec![x * y]).and_then(|t| rules(vec![t, y]));
    let core = match result {
        Ok(t) => t * y,
        Err(_) => y,
    };
    option.map_or(core, |t| t * core) + attempt.unwrap_or(x)
}

#[differentiable]
fn rules(rt: Vec<f64>) -> Result<f64, String> {
    if rt[0] > 0.0 { Ok(rt.iter().product()) } else { Err("negative".to_owned()) }
}

#[test]
fn names_of_patterns_and_paths() {
    check!(hidden_by_an_arm(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(on_the_way(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.8, 0.9]);
    check!(hidden_in_a_condition(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.6, -1.2]);
    check!(parts_of_paths(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.8, -0.9]);
}
