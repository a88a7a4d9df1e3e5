//! What the macro takes for a single number, and functions of very many products.

use ad::{differentiable, select};
use glam::DVec3;

use crate::oracle::check;

/// Begins as a literal and is none later: a product with it needs the care of any other.
#[differentiable]
fn literal_that_grows(x: f64, y: f64) -> f64 {
    let mut factor = 2.0;
    factor = factor / (x - 1.0);
    let product = x * factor;
    select(x == 1.0, y, product * y)
}

#[differentiable]
fn literal_that_is_zero(x: f64, y: f64) -> f64 {
    let zero = 0.0;
    let a = x * zero + zero - zero * y;
    a + x * 1e300 * 1e-300 - y / 2.0 + 3.0 / y - (-2.0) * x
}

/// Numbers behind references, in slices, arrays of arrays and vectors of numbers.
#[differentiable]
fn places(x: f64, xs: &[f64], rows: &[[f64; 2]; 2], tail: Vec<f64>) -> f64 {
    let mut sums = [0.0; 2];
    let own: [f64; 2] = [x, -x];
    for i in 0..2 {
        sums[i] += xs[i] * rows[i][1 - i] - own[i] * tail[i];
        sums[i] -= x;
    }
    sums[0] * sums[1] - xs[2]
}

/// Made of literals alone, and of one type with what they meet later.
#[differentiable]
fn made_of_literals(x: f64, y: f32) -> f64 {
    let (half, third) = (0.5, 1.0 / -3.0);
    let (mut wide, mut narrow) = (0.0, -0.5 * 2.0);
    for _ in 0..3 {
        wide = half * wide + x * x;
        narrow = third * narrow + y * narrow;
    }
    let none = 0.0 * 3.0;
    wide * f64::from(narrow) + none / x
}

/// A number beside a vector is a factor of the vector.
#[differentiable]
fn beside_vectors(x: f64, y: f64) -> f64 {
    let v = DVec3::new(x, y, 1.0) * x;
    let w = 2.0 * v - v / y;
    let arm = if x > y { x } else { w.x };
    let sine: f64 = x.sin();
    arm * w.dot(v) * sine
}

#[differentiable]
fn single_precision(x: f32, y: f32) -> f32 {
    let mut a = x * 0.25;
    a -= y;
    let b = y as f64 * 2.0;
    a * x - b as f32 / 3.0
}

#[test]
fn numbers_are_pulled_back_as_numbers() {
    check!(literal_that_grows(x, y) at [0.5, 0.7], [3.0, -0.2]);
    assert_eq!(literal_that_grows::grad(1.0, 3.0), (0.0, 1.0));
    check!(literal_that_is_zero(x, y) at [0.5, 0.7], [3.0, -0.2]);
    let (by_x, by_y) = made_of_literals::grad(0.7, 1.3);
    let primal = |x: &[f64]| made_of_literals(x[0], x[1] as f32);
    crate::oracle::assert_gradient("literals", |x| primal(&[x[0], 1.3]), &[0.7], &[by_x]);
    // (y - 1/3)^3 times the sum of 1, 1/2, 1/4 times x^2
    let expected = -3.0 * (1.3_f64 - 1.0 / 3.0).powi(2) * 1.75 * 0.49;
    crate::oracle::assert_close("literals in single precision", by_y.into(), expected, 1e-5);
    check!(beside_vectors(x, y) at [0.5, 0.7], [1.1, -0.4]);
    assert_eq!(single_precision::grad(2.0, 3.0), (1.0 - 3.0, -2.0 - 2.0 / 3.0));

    let place = |x: &[f64]| places(x[0], &x[1..4], &[[x[4], x[5]], [x[6], x[7]]], x[8..].to_vec());
    let at = [0.3, 1.2, -0.7, 2.0, 0.9, -1.1, 0.4, 0.6, 1.5, -0.5];
    let (to_x, to_xs, to_rows, to_tail) =
        places::grad(at[0], &at[1..4], &[[at[4], at[5]], [at[6], at[7]]], at[8..].to_vec());
    let gradient = [vec![to_x], to_xs, to_rows.concat(), to_tail].concat();
    crate::oracle::assert_gradient("places", place, &at, &gradient);
}

/// Writes a function of 64 times the same steps.
macro_rules! many_steps {
    ($name:ident($a:ident, $x:ident, $y:ident) { $($step:tt)* }) => {
        many_steps!(@twice $name($a, $x, $y) [$($step)*] [. . . . . .]);
    };
    (@twice $name:ident($a:ident, $x:ident, $y:ident) [$($step:tt)*] [. $($more:tt)*]) => {
        many_steps!(@twice $name($a, $x, $y) [$($step)* $($step)*] [$($more)*]);
    };
    (@twice $name:ident($a:ident, $x:ident, $y:ident) [$($step:tt)*] []) => {
        #[differentiable]
        fn $name($x: f64, $y: f64) -> f64 {
            let mut $a = $x;
            $($step)*
            $a
        }
    };
}

// Infinite where x is 0, which does not reach the value.
many_steps!(very_long(a, x, y) {
    a = select(x == 0.0, a * y * y + y * y, a * (y / x) * y);
});

#[test]
fn very_many_products() {
    check!(very_long(x, y) at [0.5, 0.7], [1.1, -1.05]);
    // y^2 + y^4 + y^6 + ..
    let (_, (by_x, by_y)) = very_long::value_and_grad(0.0, 0.5);
    assert_eq!(by_x, 0.25_f64.powi(64));
    crate::oracle::assert_close("by y", by_y, 1.0 / 0.75_f64.powi(2), 1e-12);
}
