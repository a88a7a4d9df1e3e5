//! Operands that change while an expression is evaluated.

use ad::{differentiable, stop_gradient};

use crate::oracle::{assert_close, check};

#[differentiable]
fn positive(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x * x) } else { None }
}

#[differentiable]
fn integer_changes_behind(x: f64, y: f64) -> f64 {
    let mut k = 2;
    let a = k as f64 * {
        k += 3;
        x * y
    };
    a * k as f64
}

#[differentiable]
fn float_changes_behind(x: f64, y: f64) -> f64 {
    let mut a = x;
    let b = a * {
        a += y;
        a
    } + a;
    let c = [
        a,
        {
            a *= b;
            a
        },
        a,
    ];
    let first = c[0].max({
        a = y;
        a
    });
    c[0] * c[1] + c[2] * a + first
}

#[differentiable]
fn comparison_changes_behind(x: f64, y: f64) -> f64 {
    let mut a = x;
    let (greater, b) = (a > y, {
        a = y - 1.0;
        a * x
    });
    let c = (a > y) as i32 as f64 * {
        a += 10.0;
        a
    };
    if greater { a * b + c } else { a + b + c }
}

#[differentiable]
fn stopped_value_changes_behind(x: f64, y: f64) -> f64 {
    let mut a = x;
    stop_gradient(a) * {
        a = y;
        a * a
    } + a
}

#[differentiable]
fn index_changes_behind(x: f64, y: f64) -> f64 {
    let values = [x, y, x * y];
    let mut k = 0;
    let mut out = [0.0; 3];
    out[k] = values[k + 1] * {
        k += 1;
        values[k + 1]
    };
    out[k] += values[k - 1];
    out[0] * values[0] + out[1] * values[1]
}

/// Parentheses that decide the value of what has no derivative.
#[differentiable]
fn grouping(x: f64, n: usize) -> f64 {
    let k = (n << 1) + 1;
    let j = (n | 1) * 2;
    let positive = !(n > 3 && n < 5);
    let i = (n > 1) as usize as f64;
    let h = (n + 1) as f64 * -(2.0 - 3.0);
    x * k as f64 + x * x * j as f64 + x * i * h * positive as usize as f64
}

#[differentiable]
fn overwritten_after_read(x: f64, y: f64) -> f64 {
    let mut a = x;
    let b = a * y;
    let c = a;
    a = b * b;
    let d = a * c;
    a = 3.0;
    let mut v = [x, y];
    let w = v;
    v[0] = v[1] * a;
    v[1] = d;
    v[0] * w[0] + v[1] * w[1] + d
}

#[test]
fn operands_keep_their_values() {
    check!(integer_changes_behind(x, y) at [1.3, 0.7]);
    check!(float_changes_behind(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(comparison_changes_behind(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(index_changes_behind(x, y) at [1.3, 0.7]);
    check!(overwritten_after_read(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[test]
fn stopped_values_are_those_of_their_time() {
    let (x, y) = (1.3, 0.7);
    let (value, (to_x, to_y)) = stopped_value_changes_behind::value_and_grad(x, y);
    assert_eq!(value, stopped_value_changes_behind(x, y));
    assert_eq!(to_x, 0.0);
    assert_close("stopped value", to_y, 2.0 * x * y + 1.0, 1e-15);
}

#[test]
fn grouping_is_kept() {
    for n in 0..6 {
        let (value, (slope, ())) = grouping::value_and_grad(0.7, n);
        assert_eq!(value, grouping(0.7, n));
        let expected = ad::check::derivative(|x| grouping(x, n), 0.7, 1e-3).value;
        assert_close("grouping", slope, expected, 1e-9);
    }
}

/// `?` and a mutation in one statement: what stands left of the `?` is evaluated before it.
#[differentiable]
fn exit_after_read(x: f64, y: f64) -> Option<f64> {
    let mut a = x;
    a += positive(a)? * positive(a + y)?;
    Some(a * positive(a)?)
}

#[test]
fn exits_keep_the_order() {
    let (x, y) = (0.8, 0.3);
    let (value, pullback) = exit_after_read::vjp(x, y);
    assert_eq!(value, exit_after_read(x, y));
    let (to_x, to_y) = pullback(1.0);
    let primal = |p: &[f64]| exit_after_read(p[0], p[1]).unwrap();
    crate::oracle::assert_gradient("exit_after_read", primal, &[x, y], &[to_x, to_y]);
}

#[differentiable]
fn grown(a: &mut f64, by: f64) -> Option<f64> {
    *a += by;
    if *a < 9.0 { Some(*a * by) } else { None }
}

#[differentiable]
fn advance(k: &mut usize, a: &mut f64) -> usize {
    *k += 1;
    *a *= 1.1;
    *k % 3
}

/// `?` behind what it changes: names, parts, receivers of methods, comparisons.
#[differentiable]
fn exit_that_changes(x: f64, y: f64) -> Option<f64> {
    let (mut a, mut pair) = (x, (x, y));
    let b = a + grown(&mut a, y)? * a;
    let c = [a, grown(&mut a, 0.5)?, a.max(grown(&mut a, 0.1)?), -a];
    let d = pair.0 * grown(&mut pair.0, y)? - pair.0;
    let e = a * if a > grown(&mut a, -0.5)? { a } else { return None };
    let less = a < grown(&mut a, 0.2)?;
    Some(if less { b } else { c[0] * c[1] + c[2] * c[3] + d * e })
}

/// The same in a loop, and through the reference that the function has.
#[differentiable]
fn exit_that_changes_behind(a: &mut f64, y: f64) -> Option<f64> {
    let mut s = 0.0;
    #[differentiable(checkpoint)]
    for _ in 0..3 {
        s += *a * grown(a, y)? - *a;
    }
    Some(s)
}

#[differentiable]
fn in_a_loop(x: f64, y: f64) -> Option<f64> {
    let mut a = x;
    Some(exit_that_changes_behind(&mut a, y)? * a)
}

/// Iterators and ranges that are made of what the next link, or the start of a fold, changes.
#[differentiable]
fn iterators_made_in_order(x: f64, y: f64) -> f64 {
    let v = [x, y, x * y, 0.3];
    let (mut a, mut k) = (x, 0);
    let s = v.iter().skip(k).zip(&v[advance(&mut k, &mut a)..]).map(|(b, c)| b * c).sum::<f64>();
    let t = v[advance(&mut k, &mut a)..].iter().fold(a, |b, c| b * c);
    let u = [a; 2].iter().zip([advance(&mut k, &mut a) as f64, a]).fold(a, |b, (c, d)| b + c * d);
    let w = v.iter().copied().take(k).nth(advance(&mut k, &mut a)).unwrap_or(a);
    let mut z = vec![a, s, t, u, w];
    z.copy_within(k % 3..2, advance(&mut k, &mut a) + 1);
    let drained: f64 = z.drain(k % 3..advance(&mut k, &mut a) + 3).sum();
    let length = z[advance(&mut k, &mut a) % 2..].len() as f64;
    s * t + u * w + drained * z[0] * a * length
}

/// What an iterator is made of, and the place that it extends, is computed once.
#[differentiable]
fn iterators_made_once(x: f64, y: f64) -> f64 {
    let (mut a, mut k) = (x, 0);
    let mut v = vec![x, y, x * y, 0.4, 1.0];
    let front: Vec<f64> = v.drain(..2).filter(|t| *t > 0.0).collect();
    let first: Vec<f64> =
        v.chunks(advance(&mut k, &mut a)).map(|chunk| chunk[0]).filter(|t| *t > -9.0).collect();
    let mut rows = vec![vec![a], vec![], vec![y]];
    rows[advance(&mut k, &mut a)].extend(v.iter().map(|t| t * a));
    front[0] * first[0] * rows[2][2] * a
}

#[test]
fn what_exits_and_iterators_change_is_read_before() {
    check!(exit_of_changes(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(exit_of_a_loop(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(iterators_made_once(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check!(iterators_made_in_order(x, y) at [1.3, 0.7], [-0.4, 2.1]);
}

#[differentiable]
fn exit_of_changes(x: f64, y: f64) -> f64 {
    exit_that_changes(x, y).unwrap_or(x * y)
}

#[differentiable]
fn exit_of_a_loop(x: f64, y: f64) -> f64 {
    in_a_loop(x, y).unwrap_or(x * y)
}

/// Random numbers: the order in which they are drawn shows in the value.
mod draws {
    use std::cell::Cell;
    use std::ops::{Neg, Sub};

    use ad::{Differentiable, differentiable};

    use crate::oracle::{assert_forward, assert_gradient};

    thread_local! {
        static SEED: Cell<u64> = const { Cell::new(1) };
    }

    fn next() -> f64 {
        let seed = SEED.get().wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        SEED.set(seed);
        (seed >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn skip() {
        next();
    }

    fn pick() -> usize {
        (next() * 3.0) as usize
    }

    /// Names of what is cheap, where it is `ad`'s.
    fn constant() -> f64 {
        next()
    }

    fn windows(_: usize) -> f64 {
        next()
    }

    fn from_f64(x: f64) -> f64 {
        x + next()
    }

    struct Noise;

    impl Noise {
        fn splat(x: f64) -> f64 {
            x * next()
        }
    }

    #[differentiable]
    fn positive(x: f64) -> Option<f64> {
        if x > 0.0 { Some(x * next()) } else { None }
    }

    #[differentiable]
    fn fallible(x: f64, y: f64) -> Option<f64> {
        let a = positive(x)? * positive(y + 1.0)? + next();
        let b = [positive(a + 1.0)?, next() * positive(x)?];
        let c = (next(), positive(y + next())?, next());
        if next() > positive(x)? + 10.0 {
            return None;
        }
        Some(a * b[0] - b[1] * c.0 + c.1 * c.2)
    }

    #[differentiable]
    fn product(a: f64, b: f64) -> f64 {
        a * a * b
    }

    #[differentiable]
    fn difference<F: Fn(f64) -> f64>(f: F, x: f64) -> f64 {
        f(x) - f(2.0 * x)
    }

    struct Generator {
        seed: Cell<u64>,
    }

    impl Generator {
        fn uniform(&self) -> f64 {
            self.seed.set(self.seed.get().wrapping_mul(6364136223846793005).wrapping_add(7));
            (self.seed.get() >> 11) as f64 / (1_u64 << 53) as f64
        }
    }

    #[differentiable]
    fn of_a_generator(x: f64, y: f64, #[constant] generator: &Generator) -> f64 {
        product(generator.uniform(), x * generator.uniform())
            - generator.uniform().max(y * generator.uniform())
    }

    #[differentiable]
    fn drawn(x: f64, y: f64) -> f64 {
        let generator = Generator { seed: Cell::new((next() * 1e9) as u64) };
        of_a_generator(x, y, &generator)
    }

    /// Defines functions, and a test of each that starts from the same seed every time.
    macro_rules! tests {
        ($($name:ident($x:ident, $y:ident) $body:block)*) => {$(
            #[test]
            fn $name() {
                #[differentiable]
                fn f($x: f64, $y: f64) -> f64 $body

                let point = [1.3, 0.7];
                let primal = |p: &[f64]| {
                    SEED.set(1);
                    f(p[0], p[1])
                };
                SEED.set(1);
                let (value, (by_x, by_y)) = f::value_and_grad(point[0], point[1]);
                assert_eq!(value.to_bits(), primal(&point).to_bits());
                assert_gradient(stringify!($name), primal, &point, &[by_x, by_y]);
                let forward = |p: &[f64], along: &[f64]| {
                    SEED.set(1);
                    f::jvp(p[0], p[1], along[0], along[1])
                };
                assert_forward(stringify!($name), forward, &point, value, &[by_x, by_y]);
            }
        )*};
    }

    #[derive(Clone, Copy, Differentiable)]
    struct Pair(f64, f64);

    #[differentiable]
    impl Sub for Pair {
        type Output = Self;

        fn sub(self, other: Self) -> Self {
            Self(self.0 - other.0, self.1 - other.1)
        }
    }

    #[differentiable]
    impl Neg for Pair {
        type Output = Self;

        fn neg(self) -> Self {
            Self(-self.0, -self.1)
        }
    }

    tests! {
        operators_of_constants(x, y) {
            let factor = next();
            let mut pair = Pair(factor, next());
            pair = Pair(factor, next()) - pair;
            pair = -Pair(pair.0, next());
            pair.0 * x - pair.1 * y * next()
        }
        arguments(x, y) { product(next(), x * next()) + y }
        operands(x, y) { next() - x * next() + y }
        receivers(x, y) { next().max(y * next()) * x }
        elements(x, y) {
            let v = [next(), x * next(), next()];
            let w = (next(), x * next());
            let u = vec![x * next(), next() * y, next()];
            v[0] * v[1] - v[2] * y - w.0 * w.1 + u.iter().sum::<f64>() * next() - next() * u[0]
        }
        places(x, y) {
            let mut v = [x, y, x];
            v[pick()] = next();
            v[pick()] += next() * x;
            v[0] * v[1] - v[2]
        }
        closures(x, y) {
            let c = |a: f64, b: f64| a - b * x;
            let f = |t: f64| t * next();
            c(next(), y * next()) + f(x) - f(y) * next() + difference(|t| t * next(), y)
        }
        results_that_nobody_uses(x, y) {
            let _ = next();
            let s = x * next();
            _ = next();
            for _ in (0..3).map(|_| next()) {}
            (0..3).for_each(|_| skip());
            for _ in 0..2 {
                skip()
            }
            if x > 0.0 {
                skip()
            }
            match pick() {
                1 => skip(),
                _ => {}
            }
            {
                skip();
                skip()
            }
            s * next() + y
        }
        choices(x, y) {
            let r = 2.0 * next() + (if x > next() { x * next() } else { next() * y }) - next();
            (if next() > 0.5 { 1.0 } else { 2.0 }) * next()
                - {
                    let k = next();
                    x * k
                } * next()
                + r
        }
        generators(x, y) { drawn(x, y) * next() - drawn(y, x) }
        cheap_names(x, y) {
            let mut s = 0.0;
            for i in 0..3 {
                s += x * constant() * i as f64;
                s *= y + windows(2) * x;
                s += x * x * Noise::splat(2.0) + from_f64(1.0) * s;
            }
            s
        }
        adapters_that_drop(x, y) {
            let v = [x, y, x * y];
            let s: f64 = v.iter().map(|t| t * next()).skip(1).sum();
            let t: f64 = v.iter().map(|t| t * next()).step_by(2).sum();
            let u: f64 = v.iter().filter(|t| **t * next() > 0.1).skip(1).take(1).sum();
            s + t * next() - u * next()
        }
        closures_of_adapters(x, y) {
            let v = vec![x, y, x * y, 1.0];
            let s = v.iter().map(|t| t * next()).rev().take(2).fold(next(), |a, b| a * next() + b)
                + v.iter().map(|t| t * next()).chain([next(), x * next()]).sum::<f64>();
            s * v
                .iter()
                .copied()
                .max_by(|a, b| (a * next()).partial_cmp(&(b * next())).unwrap())
                .unwrap()
        }
        exits(x, y) {
            let r = fallible(x, y).unwrap_or(next());
            let eager = fallible(y, x).map_or(next() * y, |t| t * next());
            let late = positive(y - 2.0).unwrap_or_else(|| next() * x);
            let chosen = (x > 0.0).then_some(next()).ok_or(next()).unwrap_or(0.0);
            r * next() + eager - late + chosen
        }
        assignments(x, y) {
            let mut v = [x, y, x];
            v[pick()] += next() * x;
            v[pick()] *= drawn(x, y);
            v[0] * v[1] - v[2]
        }
    }
}
