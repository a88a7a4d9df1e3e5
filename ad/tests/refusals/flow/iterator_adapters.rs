use ad::differentiable;

#[differentiable]
fn f(xs: [f64; 3]) -> f64 {
    let mut total = 0.0;
    for x in xs.iter().peekable() {
        total += x;
    }
    for (x, _) in xs.iter().filter(|x| **x > 0.0).zip(0..) {
        total += x;
    }
    let mut count = 0.0;
    let mut most = 2;
    let scaled = xs.iter().map(|x| x * 2.0).take(most);
    most += 1;
    for x in scaled {
        count += x * most as f64;
    }
    total += xs
        .iter()
        .map(|x| {
            count += x;
            x * count
        })
        .rev()
        .sum::<f64>();
    let mut ahead = xs.iter().peekable();
    let sums = xs.iter().scan(0.0, |sum, x| {
        *sum += x;
        Some(*sum)
    });
    let mut elements = xs.iter();
    total += elements.by_ref().take(1).sum::<f64>();
    for row in [xs, xs].iter().flat_map(|row| {
        let first = row[0];
        row.iter().map(move |x| x * first)
    }) {
        total += row;
    }
    for x in [xs, xs].into_iter().flatten() {
        if x > total {
            break;
        }
        total += x;
    }
    total + xs.iter().map(|x| x * 2.0).max_by_key(|x| *x as i32).unwrap()
}

#[differentiable]
fn greatest(xs: [f64; 3]) -> f64 {
    *xs.iter().skip(1).max_by(|a, b| a.total_cmp(b)).unwrap()
}

#[differentiable]
fn collected(xs: &[f64]) -> f64 {
    let boxed: Box<[f64]> = xs.iter().map(|x| x * x).collect();
    boxed[0]
}

#[differentiable]
fn rows(xs: &[f64]) -> f64 {
    let rows: Vec<&[f64]> = xs.chunks(2).collect();
    rows[1][0]
}

fn main() {
    f::grad([1.0; 3]);
    greatest::grad([1.0; 3]);
    rows::grad(&[1.0; 4]);
}
