//! Neighbouring elements, to which the iterations of a loop add in turns: what one adds must neither get lost
//! nor go to another element.

use ad::differentiable;

use crate::oracle::{assert_gradient, check_list};

const X: [f64; 6] = [0.3, 1.2, -0.7, 2.0, 0.9, -1.1];

#[differentiable]
fn of_three(x: &[f64; 6]) -> f64 {
    let mut sum = x[0] * x[5];
    for i in 1..5 {
        if x[i] > x[i - 1] {
            sum += x[i - 1] * x[i + 1];
        } else {
            sum -= x[i].sin() * sum;
        }
        sum += x[i + 1] * x[i] - x[i - 1];
    }
    sum * x[2]
}

#[differentiable]
fn of_a_slice(x: &[f64]) -> f64 {
    let (mut sum, mut product) = (0.0, 1.0);
    for i in 1..=x.len() - 2 {
        product *= x[i - 1] + 2.0;
        let steep = x[i + 1] - x[i - 1];
        sum += if steep > 0.5 { steep * x[i] } else { product * x[i + 1] };
    }
    sum
}

#[differentiable]
fn of_windows(x: &[f64]) -> f64 {
    let mut sum = 0.0;
    for pair in x.windows(2) {
        sum += if pair[0] < pair[1] { pair[0] * pair[1] } else { pair[1].cos() };
    }
    for three in x.windows(3) {
        sum *= three[0] * three[2] - three[1];
    }
    sum
}

/// One element under two indices, and such as no counter tells apart.
#[differentiable]
#[allow(clippy::identity_op)]
fn under_two_indices(x: &[f64; 6]) -> f64 {
    let mut sum = 0.0;
    for i in 0..4 {
        let same = x[i] * x[i + 0] * x[i + 1];
        sum += same * x[5 - i] + x[i + 1] * x[3];
        if same > 0.0 {
            sum -= x[i + 2] * x[i + 1];
        }
    }
    sum
}

#[differentiable]
fn with_gaps(x: &[f64; 6]) -> f64 {
    let mut sum = 0.0;
    for i in 0..3 {
        let apart = x[i] - x[i + 3];
        sum += if apart > 0.0 { apart } else { apart * apart };
    }
    sum
}

#[differentiable]
fn until_a_break(x: &[f64; 6]) -> f64 {
    let mut sum = 0.0;
    for i in 1..6 {
        let step = x[i] - x[i - 1];
        if step > 2.5 {
            break;
        }
        sum += if step > 0.0 { step * step * sum } else { step * x[i] };
        sum += x[i - 1];
    }
    sum
}

#[differentiable]
fn again_and_again(x: &[f64; 6]) -> f64 {
    let mut sum = 1.0;
    for from in 0..4 {
        for i in from..4 {
            let step = x[i + 1] - x[i];
            sum += if step > 0.0 { step * sum } else { x[from] * x[i + 1] };
        }
    }
    sum
}

/// The row changes with the column.
#[differentiable]
fn along_the_diagonal(rows: &[[f64; 3]; 3]) -> f64 {
    let mut sum = 0.0;
    for i in 0..2 {
        let step = rows[i][i] - rows[i][i + 1];
        sum += if step > 0.0 { step * sum } else { step * rows[i + 1][i] };
        let k = 1 - i;
        sum *= rows[k][i] * rows[k][i + 1];
    }
    sum
}

#[differentiable]
fn along_rows(rows: &[[f64; 3]; 3]) -> f64 {
    let mut sum = 0.0;
    for k in 0..2 {
        for i in 0..2 {
            let step = rows[k][i] * rows[k][i + 1];
            sum += if step > 0.0 { step * rows[k + 1][i] } else { rows[k + 1][i + 1] * sum };
        }
    }
    sum
}

#[differentiable]
fn up_to(x: &[f64], #[constant] count: usize) -> f64 {
    let mut sum = x[0] * x[0];
    for i in 1..count {
        let step = x[i] - x[i - 1];
        sum += if step > 0.0 { step * sum } else { step };
    }
    sum
}

#[test]
fn neighbours_get_what_flows_to_them() {
    for sign in [1.0, -1.0] {
        let x = X.map(|x| sign * x);
        check_list!(of_three, of_a_slice, of_windows, under_two_indices at x);
        check_list!(with_gaps, until_a_break, again_and_again at x);
        let rows: [f64; 9] = std::array::from_fn(|i| x[i % 6] + 0.1 * i as f64);
        let square = |rows: &[f64]| -> [[f64; 3]; 3] {
            std::array::from_fn(|i| rows[3 * i..3 * i + 3].try_into().unwrap())
        };
        for (f, gradient) in [
            (along_the_diagonal as fn(&_) -> _, along_the_diagonal::grad(&square(&rows))),
            (along_rows, along_rows::grad(&square(&rows))),
        ] {
            assert_gradient("rows", |rows| f(&square(rows)), &rows, &gradient.concat());
        }
        for count in 0..=6 {
            assert_gradient("up to", |x| up_to(x, count), &x, &up_to::grad(&x, count).0);
        }
    }
}
