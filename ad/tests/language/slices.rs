//! Slices, vectors and boxes: as parameters, as values, element by element.

use ad::{Differentiable, differentiable};
use glam::DVec2;

use crate::oracle::{assert_gradient, check};

/// Checks the gradient by a slice of a function of it.
fn check_slice(
    name: &str,
    value_and_gradient: impl Fn(&[f64]) -> (f64, Vec<f64>),
    f: impl Fn(&[f64]) -> f64,
    x: &[f64],
) {
    let (value, gradient) = value_and_gradient(x);
    assert_eq!(value.to_bits(), f(x).to_bits(), "{name} at {x:?}");
    assert_gradient(name, f, x, &gradient);
}

macro_rules! check_slices {
    ($($f:ident),+ at $($x:expr),+) => {
        for x in [$(&$x[..]),+] {
            $(check_slice(stringify!($f), |x| $f::value_and_grad(x), |x| $f(x), x);)+
        }
    };
}

#[differentiable]
fn chain(xs: &[f64]) -> f64 {
    let mut product = 1.0;
    let n = xs.len();
    for i in 0..n {
        product *= xs[i] + xs[n - 1 - i] * 0.3;
    }
    product
}

#[differentiable]
fn first_only(xs: &[f64]) -> f64 {
    let scale = xs.len() as f64;
    xs[0] * xs[0] * scale
}

#[differentiable]
fn parts(xs: &[f64]) -> f64 {
    let n = xs.len();
    let half = n / 2;
    first_only(&xs[..half]) + 2.0 * chain(&xs[half..]) * first_only(&xs[1..=half]) + chain(&xs[..])
}

#[differentiable]
fn copied(xs: &[f64]) -> f64 {
    let mut ys = xs.to_vec();
    for i in 1..ys.len() {
        ys[i] = ys[i] * ys[i - 1] + xs[i];
    }
    ys[0] = xs[1] * ys[0];
    let last = ys[ys.len() - 1];
    let total = chain(&ys);
    ys = vec![last; 3];
    ys[1] *= 2.0;
    total + ys[0] * ys[1] + chain(&ys)
}

#[differentiable]
fn made(xs: &[f64]) -> f64 {
    let n = xs.len();
    let mut sums = vec![0.0; n + 1];
    for i in 0..n {
        sums[i + 1] = sums[i] + xs[i] * xs[i];
    }
    let pair = vec![sums[n], xs[0], 3.0];
    pair[0] * pair[1] + pair[2] * sums[1]
}

#[differentiable]
fn arrays_as_slices(xs: &[f64]) -> f64 {
    let a = [xs[0], 2.0, xs[1] * xs[0]];
    let mut b = [xs[1]; 4];
    let before = chain(&b);
    b[2] *= xs[0];
    chain(&a) + chain(&b) * before + first_only(&b[1..3])
}

#[test]
fn slices() {
    check_slices!(chain, first_only, parts, copied, made, arrays_as_slices
        at [1.3, 0.7], [0.4, -2.1, 1.1], [0.9, 1.2, -0.7, 0.3, 1.5]);
}

/// Scales in place what it owns.
#[differentiable]
fn scaled(mut xs: Vec<f64>, by: f64) -> Vec<f64> {
    for i in 0..xs.len() {
        xs[i] *= by;
    }
    xs
}

#[differentiable]
fn owned(x: f64, y: f64) -> f64 {
    let xs = vec![x, y, x * y];
    let ys = scaled(xs, y);
    let zs = scaled(ys.clone(), x);
    ys[0] * zs[1] + zs[2]
}

#[differentiable]
fn rows(matrix: &[Vec<f64>], x: &[f64; 2]) -> f64 {
    let mut sum = 0.0;
    for i in 0..matrix.len() {
        let row = &matrix[i];
        for j in 0..row.len() {
            sum += row[j] * matrix[i][j] * x[j % 2];
        }
    }
    sum
}

#[differentiable]
fn points(points: &[DVec2], pairs: &[(f64, [f64; 2])]) -> f64 {
    let mut sum = 0.0;
    for i in 0..points.len() {
        sum += points[i].x * pairs[i].1[0] + points[i].dot(points[0]) * pairs[i].0;
    }
    sum
}

#[differentiable]
fn boxed(x: Box<f64>, y: f64) -> Box<f64> {
    let mut inner = Box::new(*x * y);
    *inner *= y;
    inner
}

#[differentiable]
fn boxes(x: f64, y: f64) -> f64 {
    let b = boxed(Box::new(x), y);
    *b * x
}

#[derive(Clone, Differentiable)]
struct Layer {
    weights: Vec<f64>,
    bias: f64,
    #[constant]
    name: String,
}

#[differentiable]
fn layer(layer: &Layer, x: f64) -> f64 {
    let known = layer.name.len() as f64;
    layer.weights[1] * x + layer.bias * known
}

/// Rows of several lengths, arrays and slices, one after the other.
#[differentiable]
fn concatenated(x: f64, y: f64) -> f64 {
    let rows = vec![vec![x, y], vec![], vec![x * y]];
    let rows = rows.concat();
    let arrays = [[x, rows[2]], [y, rows[0]]].concat();
    let slices = [&rows[..], &arrays[1..3]].concat();
    slices.iter().enumerate().map(|(i, z)| (i + 1) as f64 * z * z).sum()
}

#[differentiable]
fn squares(xs: &[f64]) -> f64 {
    xs.iter().map(|x| x * x).sum()
}

/// A type whose method has a name that lists have.
#[derive(Clone, Differentiable)]
struct Tail {
    values: Vec<f64>,
}

#[differentiable]
impl Tail {
    fn as_slice(&self) -> &[f64] {
        &self.values[1..]
    }
}

/// Lists as slices, in a name, in calls, in loops, in branches and in patterns.
#[differentiable]
fn as_slices(x: f64, y: f64) -> f64 {
    let mut list = vec![x, y, x * y];
    let tail = Tail { values: vec![y, x] };
    let before = squares(list.as_slice()) * tail.as_slice()[0];
    list[0] *= before;
    let slice = list.as_slice();
    let chosen = if x > 0.0 { list.as_slice() } else { &slice[1..] };
    let mut sum = chosen[0];
    for z in [x, y].as_slice() {
        sum += z * slice[1];
    }
    match list.as_slice() {
        [first, .., last] => sum * *first + *last,
        _ => sum,
    }
}

#[test]
fn values() {
    check!(as_slices(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(concatenated(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(owned(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(boxes(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn gradients_have_the_shape_of_the_parameters() {
    let matrix = vec![vec![1.0, 2.0], vec![], vec![3.0, 4.0, 5.0]];
    let (by_matrix, by_x) = rows::grad(&matrix, &[0.5, 0.25]);
    assert_eq!(by_matrix, [vec![1.0, 1.0], vec![], vec![3.0, 2.0, 5.0]]);
    assert_eq!(by_x, [1.0 + 9.0 + 25.0, 4.0 + 16.0]);

    let (by_points, by_pairs) =
        points::grad(&[DVec2::new(1.0, 2.0), DVec2::X], &[(3.0, [4.0, 5.0]), (6.0, [7.0, 8.0])]);
    assert_eq!(by_points, [DVec2::new(2.0 * 3.0 + 6.0 + 4.0, 12.0), DVec2::new(7.0 + 6.0, 12.0)]);
    assert_eq!(by_pairs, [(5.0, [1.0, 0.0]), (1.0, [1.0, 0.0])]);

    let net = Layer { weights: vec![1.0, 2.0, 3.0], bias: 0.5, name: "ab".to_owned() };
    let (by_layer, by_x) = layer::grad(&net, 4.0);
    assert_eq!((by_layer.weights, by_layer.bias, by_x), (vec![0.0, 4.0, 0.0], 2.0, 2.0));

    assert_eq!(first_only::grad(&[2.0, 1.0, 1.0]), [12.0, 0.0, 0.0]);
}

#[differentiable]
fn unused(_xs: &[f64], y: f64) -> f64 {
    y * y
}

#[test]
fn cotangents_of_any_length_are_accepted() {
    assert_eq!(unused::grad(&[1.0, 2.0], 3.0), (vec![0.0, 0.0], 6.0));
    for seed in [vec![], vec![1.0], vec![1.0, 1.0], vec![1.0; 5]] {
        let (ys, pullback) = scaled::vjp(vec![1.0, 2.0], 3.0);
        assert_eq!(ys, [3.0, 6.0]);
        let mut full = seed.clone();
        full.resize(2, 0.0);
        assert_eq!(pullback(seed), (vec![3.0 * full[0], 3.0 * full[1]], full[0] + 2.0 * full[1]));
    }
}

/// Reads, writes, copies and passes on parts.
#[differentiable]
fn sweeps(xs: &[f64]) -> f64 {
    let n = xs.len();
    let mut ys = xs.to_vec();
    for i in 1..n {
        ys[i] = 0.5 * ys[i - 1] + ys[i] * xs[n - i];
    }
    let mut sum = 0.0;
    for i in 0..n / 2 {
        sum += first_only(&ys[2 * i..2 * i + 2]);
    }
    sum
}

#[test]
fn work_grows_as_the_length() {
    let seconds = |n: usize| {
        let xs: Vec<f64> = (0..n).map(|i| (i as f64).sin()).collect();
        let runs = (0..5).map(|_| {
            let start = std::time::Instant::now();
            let gradient = sweeps::grad(&xs);
            assert_eq!(gradient.len(), n);
            start.elapsed().as_secs_f64()
        });
        runs.fold(f64::INFINITY, f64::min)
    };
    let (ten, thousand, many) = (seconds(10), seconds(1000), seconds(100_000));
    // Quadratic work would give a factor of 10,000; the bounds leave room for a busy machine.
    assert!(thousand < 1000.0 * ten, "{ten} s for 10 elements, {thousand} s for 1000");
    assert!(many < 1000.0 * thousand, "{thousand} s for 1000 elements, {many} s for 100000");
}

#[differentiable]
fn iterated(xs: &[f64]) -> f64 {
    let mut ys = xs.to_vec();
    for (y, x) in ys.iter_mut().zip(xs) {
        *y *= x;
    }
    let mut sum = 0.0;
    for (i, pair) in ys.windows(2).enumerate() {
        sum += pair[0] * pair[1] * i as f64;
    }
    for x in xs {
        sum += x * x;
    }
    let total: f64 = ys.iter().map(|y| y * sum).sum();
    total * xs.iter().rev().skip(1).fold(1.0, |product, x| product * x)
}

#[differentiable]
fn scaled_in_place(xs: &mut [f64], by: f64) {
    for x in xs.iter_mut() {
        *x *= by;
    }
}

#[differentiable]
fn scaled_sum(xs: &[f64]) -> f64 {
    let mut ys = xs.to_vec();
    scaled_in_place(&mut ys, xs[0]);
    scaled_in_place(&mut ys[1..], xs[1]);
    ys.iter().zip(xs.iter()).map(|(y, x)| y * x).sum::<f64>()
}

#[test]
fn loops_over_elements() {
    check_slices!(iterated, scaled_sum at [1.3, 0.7], [0.4, -2.1, 1.1], [0.9, 1.2, -0.7, 0.3, 1.5]);
}

#[differentiable]
fn ends(xs: &[f64]) -> f64 {
    match xs {
        [] => 0.0,
        [only] => only * only,
        [first, .., last] if first > last => first / last,
        [first, middle @ .., last] => first * last.sin() + ends(middle),
    }
}

#[differentiable]
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    let [lowest, higher @ ..] = coefficients else { return 0.0 };
    lowest + x * polynomial(higher, x)
}

#[differentiable]
fn ends_of_array(xs: [f64; 4], y: f64) -> f64 {
    let [first, rest @ ..] = xs;
    let [.., before, last] = rest;
    let mut total = first * last;
    for x in rest {
        total += x * before * y;
    }
    let [.., mut end] = [y, total, before];
    end *= y;
    total + end
}

#[differentiable]
fn lent_parts(xs: &[f64], y: f64) -> f64 {
    let mut total = xs.first().unwrap() * y + *xs.last().expect("there are some");
    if let Some(third) = xs.get(2) {
        total += third * third * y;
    }
    total += xs.get(17).map_or(y, |x| *x) + xs.last().copied().unwrap_or(0.0).sin();
    let (left, right) = xs.split_at(2);
    for (a, b) in left.iter().zip(right) {
        total += a * b;
    }
    let own = [y, total];
    total * own.first().copied().unwrap() + left.iter().sum::<f64>() * right.len() as f64
}

#[differentiable]
fn median(xs: &[f64], y: f64) -> f64 {
    let mut sorted: Vec<f64> = xs.iter().map(|x| x * y).collect();
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let n = sorted.len();
    let middle = if n % 2 == 1 { sorted[n / 2] } else { 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]) };
    let mut rest = vec![middle];
    rest.extend(sorted.iter().map(|x| (x - middle).abs()));
    rest.extend([y, middle * y]);
    rest.extend(sorted);
    rest.sort_unstable_by(|a, b| b.total_cmp(a));
    rest.iter().enumerate().map(|(i, x)| x * i as f64).sum::<f64>() * middle
}

#[differentiable]
fn optional_reference(x: Option<&f64>, rows: (&[f64], f64)) -> f64 {
    x.copied().unwrap_or(2.0) * rows.1 + rows.0[0] * rows.0[1]
}

#[test]
fn parts_and_order() {
    for n in [3, 4, 6] {
        let xs = &[0.35, -1.2, 1.5, 0.72, 1.41, 0.9][..n];
        let point = [xs, &[1.3]].concat();
        let checks: [(fn(&[f64], f64) -> f64, _); 2] =
            [(lent_parts, lent_parts::grad(xs, 1.3)), (median, median::grad(xs, 1.3))];
        for (f, (to_xs, to_y)) in checks {
            let gradient = [&to_xs[..], &[to_y]].concat();
            let primal = |p: &[f64]| f(&p[..n], p[n]);
            crate::oracle::assert_gradient("parts", primal, &point, &gradient);
        }
    }
    let (to_x, (to_row, to_y)) = optional_reference::grad(Some(&3.0), (&[0.5, 0.25], 2.0));
    assert_eq!((to_x, to_row, to_y), (2.0, vec![0.25, 0.5], 3.0));
    let (to_x, (_, to_y)) = optional_reference::grad(None, (&[0.5, 0.25], 2.0));
    assert_eq!((to_x, to_y), (0.0, 2.0));
}

#[test]
fn patterns() {
    for xs in [&[][..], &[1.3], &[2.0, 0.7], &[0.3, 1.5, 0.7, 1.1], &[0.3, 1.5, 0.2, 0.7, 1.2]] {
        let (value, gradient) = ends::value_and_grad(xs);
        assert_eq!(value, ends(xs));
        crate::oracle::assert_gradient("ends", ends, xs, &gradient);
    }
    let point = [0.3, -1.2, 1.5, 0.7];
    let primal = |p: &[f64]| polynomial(&p[..3], p[3]);
    let (to_coefficients, to_x) = polynomial::grad(&point[..3], point[3]);
    crate::oracle::assert_gradient(
        "polynomial",
        primal,
        &point,
        &[&to_coefficients[..], &[to_x]].concat(),
    );
    let point = [0.3, -1.2, 1.5, 0.7, 1.4];
    let primal = |p: &[f64]| ends_of_array(p[..4].try_into().unwrap(), p[4]);
    let (to_xs, to_y) = ends_of_array::grad(point[..4].try_into().unwrap(), point[4]);
    let gradient = [&to_xs[..], &[to_y]].concat();
    crate::oracle::assert_gradient("ends_of_array", primal, &point, &gradient);
}
