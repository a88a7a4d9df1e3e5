//! Loops over elements, and chains of iterator adapters.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::assert_gradient;

/// Checks the gradient of a function of an array and a number.
macro_rules! check_array {
    ($f:ident, $n:literal) => {{
        let values: [f64; $n] = std::array::from_fn(|i| 0.7 + 0.31 * ((i * 3) % 7) as f64);
        for y in [1.3, -0.45] {
            let (value, (to_values, to_y)) = $f::value_and_grad(&values, y);
            assert_eq!(value.to_bits(), $f(&values, y).to_bits(), stringify!($f));
            let point: Vec<f64> = values.iter().copied().chain([y]).collect();
            let primal = |p: &[f64]| $f(p[..$n].try_into().unwrap(), p[$n]);
            let gradient: Vec<f64> = to_values.into_iter().chain([to_y]).collect();
            assert_gradient(stringify!($f), primal, &point, &gradient);
        }
    }};
}

#[differentiable]
fn by_reference(xs: &[f64; 5], y: f64) -> f64 {
    let mut total = y;
    for x in xs {
        total += x * y;
    }
    for x in xs.iter() {
        total = total * 0.5 + *x * x.sin();
    }
    for &x in xs {
        total += x * x;
    }
    total
}

#[differentiable]
fn by_value(xs: &[f64; 5], y: f64) -> f64 {
    let copy = *xs;
    let mut changing = [y, 2.0 * y, y * y];
    let mut total = 1.0;
    for x in copy {
        total *= x + y;
    }
    for x in changing {
        changing[0] += x;
        changing[2] = changing[0] * x;
        total += x * changing[1];
    }
    for x in [y, total, changing[2]] {
        total += x.sin();
    }
    for weight in [0.1, 0.2] {
        total += weight * total;
    }
    total + changing[2]
}

#[differentiable]
fn adapters(xs: &[f64; 7], y: f64) -> f64 {
    let mut total = 0.0;
    for (i, x) in xs.iter().enumerate() {
        total += *x * i as f64 * y;
    }
    for (i, &x) in xs.iter().enumerate().rev().skip(1).step_by(2) {
        total = total * 0.9 + x * i as f64;
    }
    for (a, b) in xs.iter().zip(xs.iter().skip(2)).take(4) {
        total += a * b;
    }
    for ((i, a), (j, b)) in xs.iter().enumerate().zip(xs.iter().rev().enumerate()) {
        if i > j {
            continue;
        }
        total += (a - b) * (i + 2 * j) as f64;
    }
    for (k, x) in (1..).zip(xs) {
        total += x.powi(k) * 0.01;
    }
    for i in (0..7).rev().step_by(3) {
        total = total * y + xs[i];
    }
    total
}

#[differentiable]
fn runs(xs: &[f64; 7], y: f64) -> f64 {
    let mut total = y;
    for w in xs.windows(3) {
        total += w[0] * w[1] - w[2] * y;
    }
    for (i, pair) in xs.chunks_exact(2).enumerate() {
        total += pair[0] / pair[1] * i as f64;
    }
    for part in xs.chunks(3) {
        let mut product = 1.0;
        for x in part {
            product *= x;
        }
        total += product;
    }
    for w in xs.windows(9) {
        total += w[8];
    }
    total
}

#[differentiable]
fn in_place(xs: &[f64; 5], y: f64) -> f64 {
    let mut state = *xs;
    for x in state.iter_mut() {
        *x *= y;
        *x += 0.5;
    }
    for (x, old) in state.iter_mut().zip(xs) {
        *x = *x * old + x.sin();
    }
    for (i, x) in state.iter_mut().enumerate().rev() {
        if i % 2 == 0 {
            *x = y;
        }
    }
    let mut total = 0.0;
    for x in &state {
        total += x * x;
    }
    for x in &mut state {
        *x -= total;
    }
    state[0] * state[1] + state[4]
}

#[derive(Clone, Copy, Differentiable)]
struct Particle {
    position: [f64; 2],
    mass: f64,
}

#[differentiable]
fn energy(particles: &[Particle; 3], g: f64) -> f64 {
    let mut total = 0.0;
    for (i, a) in particles.iter().enumerate() {
        for b in particles.iter().skip(i + 1) {
            let mut square = 0.0;
            for (p, q) in a.position.iter().zip(&b.position) {
                square += (p - q) * (p - q);
            }
            total -= g * a.mass * b.mass / square.sqrt();
        }
    }
    for Particle { position: [x, y], mass } in particles {
        total += mass * (x * x + *y);
    }
    total
}

#[differentiable]
fn rows<S: Real>(matrix: [[S; 3]; 2], x: [S; 3]) -> S {
    let mut product = [S::ZERO; 2];
    for (entry, row) in product.iter_mut().zip(&matrix) {
        for (m, v) in row.iter().zip(x) {
            *entry = *entry + *m * v;
        }
    }
    let [a, b] = product;
    a * b
}

#[differentiable]
fn exits(xs: &[f64; 7], y: f64) -> f64 {
    let mut product = 1.0;
    'outer: for (i, x) in xs.iter().enumerate() {
        for z in xs.iter().take(i) {
            if *z > 2.0 && *x > 2.0 {
                continue 'outer;
            }
            if product > 30.0 {
                break 'outer;
            }
            product *= (z + y).abs() + 0.6;
        }
        if x * product < -50.0 {
            return *x * y;
        }
        product += x;
    }
    product
}

#[differentiable]
fn sums(xs: &[f64; 7], y: f64) -> f64 {
    let squares: f64 = xs.iter().map(|x| x * x).sum();
    let dot = xs.iter().zip(xs.iter().rev()).map(|(a, b)| a * b * y).sum::<f64>();
    let product: f64 = xs.iter().product();
    let plain = xs.iter().sum::<f64>();
    let weighted: f64 = (0..7).map(|i| xs[i] * i as f64).sum();
    let nothing: f64 = xs.iter().take(0).map(|x| x * y).sum();
    squares / dot + product * plain + weighted * nothing + weighted
}

#[differentiable]
fn folds(xs: &[f64; 7], y: f64) -> f64 {
    let horner = xs.iter().rev().fold(0.0, |value, &c| value * y + c);
    let (low, high) = xs.iter().copied().fold((f64::MAX, f64::MIN), |(low, high), x| {
        let x = x * y;
        (low.min(x), high.max(x))
    });
    let greatest = xs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let mut count = 0;
    xs.iter().for_each(|x| {
        if *x > 1.0 {
            count += 1;
        }
    });
    horner + low * high - greatest * count as f64
}

#[differentiable]
fn filtered(xs: &[f64; 7], y: f64) -> f64 {
    let mut total: f64 = xs.iter().filter(|x| **x > 1.0).map(|x| x * y).sum();
    total += xs.iter().copied().filter(|&x| x < 2.0).fold(1.0, |a, x| a * x);
    for (i, x) in xs.iter().map(|x| x * y).filter(|x| x.abs() > 1.1).enumerate() {
        total += x * i as f64;
    }
    for (_, x) in xs.iter().enumerate().filter(|(i, _)| i % 3 == 0) {
        total += x.sin();
    }
    total += xs.iter().take_while(|x| **x < 2.0).map(|x| x * x).sum::<f64>();
    let above = xs.iter().filter(|&&x| x > 1.5).count();
    if xs.iter().any(|x| x * y > 3.0) && !xs.iter().all(|&x| x > 1.0) {
        total *= y;
    }
    total * above as f64
}

#[differentiable]
fn extremes(xs: &[f64; 7], y: f64) -> f64 {
    let most = xs.iter().map(|x| x * y).max_by(|a, b| a.partial_cmp(b).unwrap());
    let least = xs.iter().copied().min_by(|a, b| a.total_cmp(b));
    match (most, least) {
        (Some(most), Some(least)) => most * most * least,
        _ => y,
    }
}

#[differentiable]
fn chained(xs: &[f64; 5], y: f64) -> f64 {
    let other = [y, y * y];
    let mut total = 0.0;
    for (i, x) in xs.iter().chain(&other).enumerate() {
        if i == 6 {
            total *= y;
            continue;
        }
        total += x * x * (i as f64 + y);
    }
    for (k, x) in (0..2).chain(3..4).zip(xs.iter().map(|x| x * y).chain([total])) {
        total += x * k as f64;
    }
    let sum: f64 = other.into_iter().chain(xs.iter().copied()).rev().map(f64::sin).sum();
    for (a, b) in xs.iter().zip(&other).chain(other.iter().zip(xs)) {
        total += *a / *b;
    }
    total * sum + xs.iter().take(2).chain(xs.iter().skip(3)).product::<f64>()
}

#[differentiable]
fn filter_mapped(xs: &[f64; 7], y: f64) -> f64 {
    let root = |x: &f64| if *x > 1.0 { Some((x - 1.0).sqrt() * y) } else { None };
    let mut total: f64 = xs.iter().filter_map(root).sum();
    for (i, x) in xs.iter().filter_map(|x| (*x < 2.0).then_some(*x)).enumerate() {
        total += x * i as f64;
    }
    total += xs
        .iter()
        .map_while(|&x| if x < 1.9 { Some(x * y) } else { None })
        .fold(1.0, |product, x| product * x);
    let indices: usize = (0..7).filter_map(|i| if xs[i] > y { Some(i) } else { None }).sum();
    total * indices as f64
}

#[differentiable]
fn nested(xs: &[f64; 5], y: f64) -> f64 {
    let rows = [[xs[0], y], [xs[1], xs[2] * y], [xs[3], xs[4]]];
    let sum: f64 = rows.iter().flatten().map(|x| x * x).sum();
    let x = 2.0 * y;
    let mut total = sum;
    for (i, product) in (0..4).flat_map(|i| xs.iter().skip(i).map(move |x| x * xs[i])).enumerate() {
        total += product * x * i as f64;
    }
    let pairs: Vec<f64> =
        rows.iter().flat_map(|row| row.iter().map(|entry| entry * row[0])).collect();
    for p in &pairs {
        total += p.sin();
    }
    total += xs.iter().flat_map(|x| [*x, x * y]).product::<f64>();
    total += rows.iter().flat_map(|row| vec![row[0] * x; 2]).filter(|x| *x > 0.5).sum::<f64>();
    total + rows.into_iter().flatten().filter(|x| *x > 1.0).fold(0.0, |a, x| a * y + x)
}

#[differentiable]
fn reduced(xs: &[f64; 5], y: f64) -> f64 {
    let most = xs.iter().map(|x| x * y).reduce(f64::max).unwrap();
    let product = xs.iter().copied().reduce(|a, b| a * b + y);
    let last = xs.iter().copied().filter(|x| *x < 2.0).last();
    let nothing = xs.iter().take(0).copied().reduce(|a, b| a + b);
    let least = xs.iter().cloned().min_by(|a, b| a.total_cmp(b)).expect("there are some");
    let sum = most * product.unwrap_or(1.0) + last.unwrap_or(y) * least;
    match nothing {
        Some(x) => x,
        None => sum,
    }
}

#[differentiable]
fn built(xs: &[f64; 5], y: f64) -> f64 {
    let powers: [f64; 4] = std::array::from_fn(|i| y.powi(i as i32) + xs[i]);
    let mut running = 1.0;
    let products = core::array::from_fn::<f64, 5, _>(|i| {
        running *= xs[i] * y;
        running
    });
    let squares = products.map(|p| p * p + powers[1]);
    let mut changing = [y, 2.0 * y];
    changing[0] *= y;
    let [a, b] = changing.map(f64::sin);
    changing[1] = a * b;
    let pairs = squares.map(|s| (s, s * y));
    let counts: [usize; 3] = std::array::from_fn(|i| i * i);
    let mut total = running + changing[0] * changing[1];
    for (i, (s, t)) in pairs.iter().enumerate() {
        total += s * t + counts[i % 3] as f64;
    }
    total
}

#[differentiable]
fn mapped_options(x: Option<f64>, y: f64) -> f64 {
    let halved = |t: f64| t * 0.5;
    let doubled = Some(y * y).map(|t| t * 2.0);
    let product: Option<f64> = x.map(|x| x * y);
    let half = product.map(halved);
    match (doubled, product, half) {
        (Some(a), Some(b), Some(c)) => a * b * c,
        (Some(a), _, _) => a * a,
        _ => y,
    }
}

#[differentiable]
fn methods_of_options(x: f64, y: f64) -> f64 {
    let above = (x > 1.0).then_some(x * y);
    let root = root_of(y).and_then(|r| root_of(r - 0.5)).or_else(|| root_of(x * x));
    let half = |t: f64| t * 0.5 * y;
    let a = above.unwrap_or_else(|| y * y);
    let b = root.map_or(x, |r| r * a);
    let c = above.map_or_else(|| x + y, half);
    let d = checked(x).unwrap_or_else(|error: usize| y * error as f64);
    a * b + c * d
}

#[differentiable]
fn root_of(x: f64) -> Option<f64> {
    (x >= 0.0).then(|| x.sqrt())
}

#[differentiable]
fn checked(x: f64) -> Result<f64, usize> {
    if x > 0.0 { Ok(x * x) } else { Err(3) }
}

#[test]
fn options_by_method() {
    crate::oracle::check!(methods_of_options(x, y) at [1.3, 0.7], [-0.4, 2.1], [0.3, 0.1], [1.2, -0.4]);
}

#[test]
fn arrays_by_element() {
    check_array!(built, 5);
    let primal = |p: &[f64]| mapped_options(Some(p[0]), p[1]);
    let (x, y) = mapped_options::grad(Some(1.3), 0.7);
    assert_gradient("mapped_options", primal, &[1.3, 0.7], &[x, y]);
    let primal = |p: &[f64]| mapped_options(None, p[0]);
    let (x, y) = mapped_options::grad(None, 0.7);
    assert_gradient("mapped_options", primal, &[0.7], &[y]);
    assert_eq!(x, 0.0);
}

#[test]
fn loops_over_elements() {
    check_array!(by_reference, 5);
    check_array!(by_value, 5);
    check_array!(adapters, 7);
    check_array!(runs, 7);
    check_array!(in_place, 5);
    check_array!(exits, 7);
}

#[test]
fn chains() {
    check_array!(sums, 7);
    check_array!(folds, 7);
    check_array!(filtered, 7);
    check_array!(extremes, 7);
    check_array!(chained, 5);
    check_array!(filter_mapped, 7);
    check_array!(nested, 5);
    check_array!(reduced, 5);
}

#[test]
fn elements_with_parts() {
    let point = [0.3, -1.2, 1.5, 2.0, 0.4, 0.7, -1.1, 0.2, 2.5, 0.8];
    let particles = |p: &[f64]| -> [Particle; 3] {
        std::array::from_fn(|i| Particle { position: [p[3 * i], p[3 * i + 1]], mass: p[3 * i + 2] })
    };
    let primal = |p: &[f64]| energy(&particles(p), p[9]);
    let (value, (by_particles, by_g)) = energy::value_and_grad(&particles(&point), point[9]);
    assert_eq!(value, primal(&point));
    let mut gradient = Vec::new();
    for particle in by_particles {
        gradient.extend(particle.position);
        gradient.push(particle.mass);
    }
    gradient.push(by_g);
    assert_gradient("energy", primal, &point, &gradient);

    let primal = |p: &[f64]| rows([[p[0], p[1], p[2]], [p[3], p[4], p[5]]], [p[6], p[7], p[8]]);
    let ([a, b], x) = rows::grad([[0.3, -1.2, 1.5], [2.0, 0.4, 0.7]], [-1.1, 0.2, 2.5]);
    assert_gradient("rows", primal, &point[..9], &[a, b, x].concat());
}

/// Iterators without derivative: over texts, and over integers that are counted.
#[differentiable]
fn over_constants(x: f64, y: f64) -> f64 {
    let (text, ids) = ("a1b 22 c", [1_usize, 2, 0]);
    let v = [x, y, x * y];
    let mut sum = 0.0;
    for (i, c) in text.char_indices().filter(|(_, c)| c.is_alphabetic()) {
        sum += y * i as f64 + f64::from(c as u8) * 0.01 * x;
    }
    for (i, b) in text.bytes().enumerate().filter(|(i, _)| i % 2 == 0) {
        sum *= 1.0 + 0.01 * f64::from(b) * x * i as f64;
    }
    let lengths = text.split_whitespace().map(|word| word.len() as f64 * x).sum::<f64>();
    let table = "1.5;2\n0.25;-1";
    let mut fitted = 0.0;
    for line in table.lines() {
        fitted +=
            line.split(';').map(|cell| cell.parse::<f64>().unwrap() * y.tanh()).product::<f64>();
    }
    let digits = text.chars().filter(|c| c.is_ascii_digit()).count();
    let positive = ids.iter().filter(|id| **id > 0).count();
    sum * digits as f64 * fitted
        + lengths * ids.iter().map(|&id| v[id] * positive as f64).sum::<f64>()
}

#[test]
fn iterators_without_derivative() {
    crate::oracle::check!(over_constants(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

/// Lists of lists, and of options, that never change.
#[differentiable]
fn over_constant_lists(x: f64, y: f64) -> f64 {
    let rows = vec![vec![1.0, 2.0], vec![], vec![3.0]];
    let weights = [vec![(1_usize, 0.5)], vec![(0, 2.0), (1, -1.0)]];
    let known = [Some(1.5), None, Some(0.5)];
    let v = [x, x * y];
    let mut sum = rows.iter().flatten().sum::<f64>() * y;
    for k in rows.iter().flatten() {
        sum += k * x;
    }
    for (i, w) in weights.iter().flatten() {
        sum += w * v[*i] * y;
    }
    sum += known.iter().flatten().map(|k| k.sin() * y - k).sum::<f64>();
    let mut counts = vec![vec![1.0, 2.0], vec![3.0]];
    for k in counts.iter_mut().flatten() {
        *k += 1.0;
    }
    counts.into_iter().flatten().fold(sum, |a, k| a + k * x * x)
}

/// Items of one list after the other whose values nobody asks for.
#[differentiable]
fn counted(x: f64, y: f64) -> f64 {
    let (v, w) = ([x, y], [y]);
    let mut sum = v.iter().chain(std::iter::once(&1.0)).map(|_| x).sum::<f64>();
    for _ in v.iter().chain(&w) {
        sum *= y;
    }
    for (i, _) in v.iter().chain(w.iter()).enumerate() {
        sum += i as f64 * x;
    }
    sum
}

#[test]
fn items_of_several_lists() {
    crate::oracle::check!(over_constant_lists(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    crate::oracle::check!(counted(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[derive(Clone, Differentiable)]
struct Sums {
    rows: Vec<f64>,
    total: f64,
}

#[differentiable]
fn weighted(rows: Vec<f64>, total: f64) -> f64 {
    rows[0] * total + rows[1]
}

/// Sums of which nothing but their items tells the type while they are added up.
#[differentiable]
fn untold_sums(x: f64, y: f64) -> f64 {
    let xs = [x, y, x * y];
    let rows = (0..2).map(|j| xs.iter().map(|t| t * xs[j]).sum()).collect();
    let mut sums = Sums { rows, total: xs.iter().copied().sum() };
    sums.rows = (0..2).map(|j| xs.iter().map(|t| t * sums.rows[j]).product()).collect();
    sums.total += weighted(
        (0..2).map(|j| xs.iter().map(|t| t * sums.rows[j]).sum()).collect(),
        xs.iter().sum(),
    );
    sums.rows[0] * sums.total + sums.rows[1]
}

#[test]
fn sums_are_of_the_type_of_their_items() {
    crate::oracle::check!(untold_sums(x, y) at [1.3, 0.7], [-0.4, 1.1]);
}
