//! Functions that a `macro_rules!` writes: precedence of what it was given, and hygiene.

use ad::{differentiable, no_diff};

use crate::oracle::check;

/// Defines a function with the attribute, and as `plain` the same without it.
macro_rules! both {
    ($name:ident($x:ident, $y:ident) by $macro:ident!($($argument:tt)*)) => {
        mod $name {
            use super::*;

            $macro!(#[differentiable] differentiated $x $y $($argument)*);
            $macro!(#[inline] plain $x $y $($argument)*);

            #[test]
            fn agrees_with_the_plain_function() {
                for (x, y) in [(1.3, 0.7), (-0.4, 2.1)] {
                    assert_eq!(differentiated(x, y).to_bits(), plain(x, y).to_bits());
                    let (value, _) = differentiated::value_and_grad(x, y);
                    assert_eq!(value.to_bits(), plain(x, y).to_bits());
                }
                check!(differentiated(x, y) at [1.3, 0.7], [-0.4, 2.1]);
            }
        }
    };
}

macro_rules! arithmetic {
    (#[$attribute:ident] $name:ident $x:ident $y:ident $e:expr) => {
        #[$attribute]
        fn $name($x: f64, $y: f64) -> f64 {
            let t = 3.0 * $x;
            $y + t * $e + 1.0 / $e - $e + -$e * $e.sin() / $e.powi(2) - t % $e
        }
    };
}

both!(sum(x, y) by arithmetic!(x + y));
both!(negative(x, y) by arithmetic!(-x * y));
both!(constant(x, y) by arithmetic!(2.0_f64 + 3.0));
both!(chosen(x, y) by arithmetic!(if x > y { x } else { y + 2.0 }));

macro_rules! integers {
    (#[$attribute:ident] $name:ident $x:ident $y:ident $t:ty, $n:expr, $l:literal, $c:expr) => {
        #[$attribute]
        fn $name($x: $t, $y: f64) -> f64 {
            let mut total = 0.0;
            for i in 0..2 * $n {
                total += $x * i as $t + ($n << 1) as f64;
            }
            let repeated = [$x; 2 * $n];
            assert!(2 * $n == 6 && $n * 2 != 7);
            let scale = no_diff(|| 2.0 * $l.abs());
            if $c && $n > 100 || !$c {
                total = 0.0;
            }
            total * $l.abs() * scale + repeated[2 * $n - 1] * $y
        }
    };
}

both!(in_integers(x, y) by integers!(f64, 1 + 2, -3.0_f64, x > 0.0 || y > 0.0));

macro_rules! marked {
    ($name:ident, #[$mark:meta], $e:expr) => {
        #[differentiable]
        fn $name(x: f64, y: f64) -> f64 {
            let mut s = y;
            #[$mark]
            for _ in 0..3 {
                s = s * $e + x;
            }
            s
        }
    };
}

marked!(mark_of_the_caller, #[differentiable(checkpoint)], 1.0 - 0.5);

macro_rules! fallible {
    ($name:ident $result:ty, $e:expr) => {
        #[differentiable]
        fn $name(x: f64, y: f64) -> $result {
            let positive = Some(x * x)?;
            let mut s = y;
            #[differentiable(checkpoint)]
            for _ in 0..3 {
                s = s * $e + positive;
            }
            Some(s * $e)
        }
    };
}

fallible!(through_a_type Option<f64>, 1.0 - 0.5);

#[differentiable]
fn marked_loop_beside_groups(x: f64, y: f64) -> f64 {
    through_a_type(x, y).unwrap()
}

#[test]
fn types_are_seen_through() {
    check!(marked_loop_beside_groups(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(mark_of_the_caller(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

macro_rules! hygienic {
    (#[$attribute:ident] $name:ident $x:ident $y:ident $e:expr) => {
        #[$attribute]
        fn $name($x: f64, $y: f64) -> f64 {
            let t = 3.0 * $x;
            let u = $e;
            let mut s = t * u;
            for t in [1.0, 2.0] {
                let f = |u: f64| u * t + $e;
                s += f($x) * t;
            }
            if let Some(t) = Some(s * 0.5) {
                s += t * $e;
            }
            match Some(s) {
                Some(t) if t > $e - 100.0 => s += $e * t,
                _ => {}
            }
            #[allow(unused_variables)]
            let k = no_diff(|| {
                let z = 2.0;
                z
            });
            s + k
        }
    };
}

both!(names_of_the_caller(t, u) by hygienic!(t * t * u));
both!(names_of_the_closure(s, k) by hygienic!(s - k * k));

macro_rules! deferred {
    (#[$attribute:ident] $name:ident $x:ident $y:ident $e:expr) => {
        #[$attribute]
        fn $name($x: f64, $y: f64) -> f64 {
            let r;
            if $x > 0.0 {
                r = $x * $e;
            } else {
                r = $e;
            }
            let (mut a, b) = (r, $e);
            (a, _) = (a * b, $e);
            a
        }
    };
}

both!(names_without_a_value(r, a) by deferred!(r * a));

macro_rules! documented {
    ($(#[$meta:meta])* $name:ident($x:ident) = $e:expr) => {
        $(#[$meta])*
        #[differentiable]
        fn $name($x: f64) -> f64 {
            $e
        }
    };
}

documented! {
    /// The square.
    #[inline]
    square(x) = x * x
}

#[test]
fn attributes_by_a_fragment() {
    assert_eq!(square::value_and_grad(3.0), (9.0, 6.0));
}
