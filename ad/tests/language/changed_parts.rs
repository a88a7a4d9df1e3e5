//! Names for parts of constants that get derivatives later, beside variables that these are added to.

use ad::{Differentiable, differentiable};

use crate::oracle::{check, check_list};

#[derive(Clone, Debug, Differentiable)]
struct Pair {
    a: f64,
    b: f64,
}

#[differentiable]
fn range(xs: &[f64]) -> f64 {
    let mut width = 0.0;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for x in xs {
        low = low.min(*x);
        high = high.max(*x);
    }
    width += high - low;
    width * width
}

#[differentiable]
fn running_deviation(xs: &[f64]) -> f64 {
    let mut total = 0.0;
    let mut count = 0;
    let (mut mean, mut sum, step) = (0.0, 0.0, 1);
    for x in xs {
        count += step;
        let difference = x - mean;
        mean += difference / count as f64;
        sum += difference * (x - mean);
        total += sum;
    }
    total
}

/// Structs, arrays, vectors, and what a loop takes apart.
#[differentiable]
fn of_other_types(xs: &[f64]) -> f64 {
    let mut total = 0.0;
    let Pair { mut a, b } = Pair { a: 1.0, b: 2.0 };
    let [mut c, d] = [3.0, 4.0];
    let (mut list, mut e) = (vec![1.0, 2.0], 0.5);
    let mut partial = vec![];
    for x in xs {
        a *= x;
        c += a * b;
        list[0] *= c;
        e += list[0] * d;
        partial.push(e);
        total += e;
    }
    for (mut f, g) in [(1.0, 2.0), (3.0, 4.0)] {
        f += xs[0];
        total += f * g;
    }
    for mut h in [1.0, 2.0] {
        h *= xs[1];
        total += h * h;
    }
    total * partial[0]
}

/// Those of types without derivative stay constants.
#[differentiable]
fn beside_counters(xs: &[f64]) -> f64 {
    let mut order = Vec::new();
    let mut doubled = 0;
    let (mut i, mut product, step) = (0, 1.0, 1);
    while i < xs.len() {
        product *= xs[i];
        order.push(i);
        doubled += step + step;
        i += 1;
    }
    product * xs[order[1]] * doubled as f64
}

#[differentiable]
fn in_options(x: f64, y: f64) -> f64 {
    let mut total = 0.0;
    let list = Some(vec![1.0, 2.0]);
    match list {
        Some(mut list) => {
            list[0] = x;
            list.push(y);
            total += list[0] * list[1] * list[2];
        }
        None => total += 1.0,
    }
    let pair: Result<Pair, String> = Ok(Pair { a: 1.0, b: 2.0 });
    match pair {
        Ok(Pair { mut a, mut b }) => {
            b += x * y;
            a += b;
            total *= a;
        }
        Err(message) => total += message.len() as f64,
    }
    if let Some(mut number) = Some(3.0) {
        number *= x;
        total += number * number;
    }
    let count = Some(3_usize);
    if let Some(mut count) = count {
        while count > 0 {
            count -= 1;
            total += x * count as f64;
        }
    }
    total * y
}

#[test]
fn parts_of_constants() {
    check_list!(range, running_deviation, of_other_types, beside_counters at [0.7, 1.3, -0.4]);
    check!(in_options(x, y) at [0.7, 1.3], [-0.4, 0.9]);
}
