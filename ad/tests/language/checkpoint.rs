//! `#[differentiable(checkpoint)]`: recomputing instead of storing.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{assert_gradient, check, check_generic};

#[differentiable(checkpoint)]
fn iterated<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    for i in 0..6 {
        a = (a * y + x * S::from_f64(0.1 * i as f64)).sin();
    }
    a * y
}

#[differentiable]
fn many_times<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    for _ in 0..4 {
        a = a + iterated(a, y) * iterated(y, x);
    }
    a
}

#[differentiable(checkpoint)]
fn weighted<const N: usize>(values: &[f64; N], (scale, n): (f64, usize)) -> f64 {
    let mut total = 0.0;
    for (i, value) in values.iter().enumerate() {
        total += (value * scale).exp() * (i + n) as f64;
    }
    total
}

#[derive(Clone, Copy, Differentiable)]
struct Oscillator {
    position: f64,
    velocity: f64,
}

#[differentiable]
impl Oscillator {
    #[differentiable(checkpoint)]
    fn step(&self, stiffness: f64) -> Oscillator {
        let velocity = self.velocity - 0.1 * stiffness * self.position.sin();
        Oscillator { position: self.position + 0.1 * velocity, velocity }
    }

    #[differentiable(checkpoint)]
    fn energy(self, stiffness: f64) -> f64 {
        let half = self.velocity * self.velocity * 0.5;
        half + stiffness * (1.0 - self.position.cos())
    }
}

#[differentiable]
fn swing(x: f64, stiffness: f64) -> f64 {
    let mut state = Oscillator { position: x, velocity: 0.0 };
    for _ in 0..30 {
        state = state.step(stiffness);
    }
    state.energy(stiffness) + state.position
}

#[differentiable]
fn checkpointed_loop<S: Real>(x: S, y: S) -> S {
    let mut a = x;
    let mut b = y;
    let mut count = 0;
    #[differentiable(checkpoint)]
    for i in 0..10 {
        let t = a * y;
        if i % 4 == 3 {
            continue;
        }
        if i % 3 == 1 {
            b = b + t * x;
            count += 1;
        } else {
            a = (a + b * S::from_f64(0.1 * count as f64)).sin();
        }
        for j in 0..i {
            a = a + b * t * S::from_f64(0.01 * j as f64);
        }
    }
    a = a * b;
    b = a + x;
    a * b * S::from_f64(count as f64)
}

/// Variables that the loop reads and something later changes.
#[differentiable]
fn state_changed_later(x: f64, y: f64, n: usize) -> f64 {
    let mut rate = x * y;
    let mut table = [x, y, x + y];
    let mut total = 0.0;
    for k in 0..2 {
        #[differentiable(checkpoint)]
        for i in (0..n).rev() {
            total += rate * table[i % 3] * (i + k) as f64;
            table[(i + 1) % 3] *= y;
        }
        rate = total * 0.1;
        table = [rate, x, y];
    }
    total * rate + table[0]
}

#[differentiable]
fn over_elements(values: &[f64; 7], y: f64) -> f64 {
    let mut state = [y, 1.0];
    #[differentiable(checkpoint)]
    for (i, pair) in values.windows(2).enumerate() {
        state[0] = state[0] * pair[0] + values[i] * pair[1];
        state[1] += state[0];
    }
    state[0] * state[1]
}

/// Loops around and within a checkpointed one, with few iterations each.
#[differentiable]
fn between_short_loops(x: f64, y: f64) -> f64 {
    let pair = [x, y];
    let mut c = x;
    for _ in 0..1 {
        #[differentiable(checkpoint)]
        for _ in 1..=5 {
            for v in pair.iter().cycle().take(8) {
                c = (c + *v).sin();
            }
        }
    }
    c
}

#[test]
fn checkpoints_between_short_loops() {
    check!(between_short_loops(x, y) at [0.5, -0.3], [1.2, 0.4]);
}

#[test]
fn loops() {
    check_generic!(checkpointed_loop(x, y) at [1.3, 0.7], [-0.4, 1.1]);
    for n in [0, 1, 2, 3, 4, 5, 9, 11] {
        let (value, (to_x, to_y, ())) = state_changed_later::value_and_grad(1.3, 0.7, n);
        assert_eq!(value, state_changed_later(1.3, 0.7, n));
        let primal = |p: &[f64]| state_changed_later(p[0], p[1], n);
        assert_gradient("state_changed_later", primal, &[1.3, 0.7], &[to_x, to_y]);
    }
    let values = [0.3, -1.2, 1.5, 2.0, 0.4, 0.7, -1.1];
    let primal = |p: &[f64]| over_elements(p[..7].try_into().unwrap(), p[7]);
    let (by_values, by_y) = over_elements::grad(&values, 0.8);
    let point = [&values[..], &[0.8]].concat();
    let gradient = [&by_values[..], &[by_y]].concat();
    assert_gradient("over_elements", primal, &point, &gradient);
}

#[test]
fn functions() {
    check_generic!(iterated(x, y) at [1.3, 0.7], [-0.4, 2.1]);
    check_generic!(many_times(x, y) at [1.3, 0.7], [-0.4, 1.1]);
    check!(swing(x, y) at [1.3, 0.7], [-0.4, 2.1]);

    let point = [0.3, -0.2, 0.5, 0.7];
    let primal = |p: &[f64]| weighted(&[p[0], p[1], p[2]], (p[3], 2));
    let (value, (values, (scale, ()))) = weighted::value_and_grad(&[0.3, -0.2, 0.5], (0.7, 2));
    assert_eq!(value, primal(&point));
    assert_gradient("weighted", primal, &point, &[values[0], values[1], values[2], scale]);
}

/// The pullback holds the arguments and nothing else, but for what debug builds compare.
#[test]
fn memory() {
    let fingerprint = size_of::<ad::rt::Fingerprint>();
    let (_, pullback) = iterated::vjp(1.3_f64, 0.7);
    assert_eq!(size_of_val(&pullback), 2 * size_of::<f64>() + fingerprint);
    let (_, pullback) = weighted::vjp(&[0.0; 100], (0.7, 2));
    assert_eq!(size_of_val(&pullback), 102 * size_of::<f64>() + fingerprint);
}

/// Left early, in every way.
#[differentiable]
pub fn left_early(x: f64, y: f64, n: usize) -> f64 {
    let mut a = x;
    let mut b = y;
    #[differentiable(checkpoint)]
    for i in 0..n {
        a = (a * y + 0.3 * b).sin();
        if i == 4 {
            a *= 3.0;
            break;
        }
        b += a * x;
    }
    'outer: for k in 0..3 {
        #[differentiable(checkpoint)]
        for i in 0..n {
            b = b * 0.9 + a * (k + i) as f64;
            let mut c = b;
            for j in 0..3 {
                if j == 1 && i == 2 {
                    continue 'outer;
                }
                if j == 2 && k == 2 && i == 1 {
                    break 'outer;
                }
                if j == 2 {
                    break;
                }
                c += a;
            }
            a = c.cos();
        }
        a += 0.1;
    }
    #[differentiable(checkpoint)]
    'own: for i in 0..n {
        let mut k = 0;
        loop {
            b *= 1.0 + 0.5 * x * x;
            k += 1;
            if i > 1 {
                break 'own;
            }
            if k > i {
                continue 'own;
            }
        }
    }
    a * b + a
}

#[differentiable]
fn returned(x: f64, y: f64, n: usize) -> f64 {
    let mut a = x;
    for k in 0..2 {
        #[differentiable(checkpoint)]
        for i in 0..n {
            a = a * y + 0.1;
            if i + k == 4 {
                return a * a;
            }
            let Some(root) = positive(x + 1.0 + a * 0.01) else { return a };
            a += root;
        }
    }
    a + y
}

/// Jumps that take a value along, out of what stands around the loop.
#[differentiable]
fn carried(x: f64, y: f64, n: usize) -> f64 {
    let mut a = x;
    let found = 'search: {
        #[differentiable(checkpoint)]
        for i in 0..n {
            a = a * y + 0.1;
            if i == 3 && x > 0.0 {
                break 'search a * a;
            }
            if a > 4.0 {
                break 'search a - x;
            }
        }
        a + y
    };
    let mut rounds = 0;
    let last = 'rounds: loop {
        rounds += 1;
        #[differentiable(checkpoint)]
        while a < 6.0 {
            a += 0.3 + x * x;
            if a > 5.0 && rounds > 1 {
                break 'rounds a * y;
            }
            if a > 5.5 {
                a *= 0.5;
                continue 'rounds;
            }
        }
        a = 0.2 * a;
    };
    found * last
}

#[differentiable]
fn positive(x: f64) -> Option<f64> {
    if x > 0.0 { Some(x.sqrt()) } else { None }
}

#[differentiable]
fn attempted(x: f64, y: f64) -> Option<f64> {
    let mut a = x;
    #[differentiable(checkpoint)]
    for _ in 0..6 {
        let next = positive(a * y)? + positive(a - 0.2)? * x;
        a = next;
    }
    Some(a * y)
}

#[differentiable]
fn tried(x: f64, y: f64) -> f64 {
    match attempted(x, y) {
        Some(a) => a * x,
        None => x * y * y,
    }
}

/// Numbers without end, until it is enough.
#[differentiable]
fn counted(x: f64, y: f64) -> f64 {
    let mut sum = x;
    #[differentiable(checkpoint)]
    for i in 1_u16.. {
        if i % 3 == 0 {
            continue;
        }
        sum += (sum * y).sin() / f64::from(i);
        if sum > 2.0 || i > 20 {
            break;
        }
    }
    sum * y
}

/// Items of which nobody knows how many there are, with more than a segment of one.
#[differentiable]
fn spelled(x: f64, y: f64) -> f64 {
    let (mut sum, mut word) = (x, 0.0);
    #[differentiable(checkpoint)]
    for letter in "where so many letters are, segments grow".chars().filter(|c| c.is_alphabetic()) {
        if letter > 'o' {
            word += 0.1;
            continue;
        }
        sum += (sum * y + word).sin() / f64::from(u32::from(letter) - 90);
    }
    sum * y
}

/// States that are borrowed.
#[derive(Clone, Differentiable)]
struct Body {
    position: [f64; 2],
    rates: Vec<f64>,
}

#[differentiable]
impl Body {
    fn advance(&mut self, dt: f64, steps: usize) -> f64 {
        let mut path = 0.0;
        #[differentiable(checkpoint)]
        for i in 0..steps {
            self.position[0] += dt * self.rates[i % 2] * self.position[1].cos();
            self.position[1] -= dt * self.position[0] * self.rates[1];
            self.rates[0] *= 1.0 - dt;
            if self.energy(1) > 30.0 {
                break;
            }
            path += self.position[0];
        }
        path + self.position[1]
    }

    fn energy(&self, steps: usize) -> f64 {
        let mut sum = 0.0;
        #[differentiable(checkpoint)]
        for i in 0..steps {
            sum += self.position[i % 2] * self.rates[0];
        }
        sum * self.position[0]
    }

    fn settled(mut self, steps: usize) -> f64 {
        #[differentiable(checkpoint)]
        for _ in 0..steps {
            self.position[0] = self.position[0].sin() * self.rates[1];
            self.rates[1] += self.position[0];
        }
        self.rates[1] * self.position[0]
    }

    fn weighed(self, steps: usize) -> f64 {
        let mut sum = 0.0;
        #[differentiable(checkpoint)]
        for i in 0..steps {
            sum = sum * self.rates[i % 2] + self.position[0];
        }
        sum
    }
}

#[differentiable]
fn smooth(values: &mut [f64], total: &mut f64, by: f64) {
    #[differentiable(checkpoint)]
    for i in 1..values.len() {
        values[i] = values[i] * by + values[i - 1];
        *total += values[i] * *total;
        doubled(total, &values[i - 1..i + 1]);
    }
    *total *= by;
}

#[differentiable]
fn doubled(total: &mut f64, values: &[f64]) {
    *total += 0.1 * values[0] * values[1];
}

#[differentiable]
fn borrowed(x: f64, y: f64) -> f64 {
    let mut body = Body { position: [x, y], rates: vec![y, x] };
    let path = body.advance(0.1, 9) + body.energy(3);
    let mut values = [x, y, x * y, path];
    let mut total = y;
    smooth(&mut values, &mut total, 0.7);
    body.clone().settled(4) + body.weighed(5) * total + values[3]
}

/// A field that has the name of a variable that is not there yet.
#[differentiable]
fn names_of_fields(x: f64, y: f64) -> f64 {
    let mut sum = x;
    #[differentiable(checkpoint)]
    for i in 0..3 {
        let state = Oscillator { position: sum, velocity: y };
        sum += state.position * state.velocity * i as f64;
    }
    let mut position = sum * x;
    position *= y;
    let mut velocity = position;
    velocity += sum;
    velocity * position
}

#[test]
fn names_of_fields_are_no_variables() {
    check!(names_of_fields(x, y) at [1.3, 0.7], [-0.4, 1.1]);
}

#[test]
fn loops_that_are_left_early() {
    for n in [0, 1, 2, 4, 5, 6, 9] {
        let (value, (to_x, to_y, ())) = left_early::value_and_grad(1.3, 0.7, n);
        assert_eq!(value, left_early(1.3, 0.7, n));
        let primal = |p: &[f64]| left_early(p[0], p[1], n);
        assert_gradient("left_early", primal, &[1.3, 0.7], &[to_x, to_y]);
        for x in [1.3, -1.05] {
            let (value, (to_x, to_y, ())) = returned::value_and_grad(x, 0.7, n);
            assert_eq!(value, returned(x, 0.7, n));
            let primal = |p: &[f64]| returned(p[0], p[1], n);
            assert_gradient("returned", primal, &[x, 0.7], &[to_x, to_y]);
            let (value, (to_x, to_y, ())) = carried::value_and_grad(x, 0.7, n);
            assert_eq!(value, carried(x, 0.7, n));
            let along_x = carried::jvp(x, 0.7, n, 1.0, 0.0, ()).1;
            assert!((along_x - to_x).abs() <= 1e-12 * to_x.abs());
            let primal = |p: &[f64]| carried(p[0], p[1], n);
            assert_gradient("carried", primal, &[x, 0.7], &[to_x, to_y]);
        }
    }
    check!(tried(x, y) at [1.3, 0.7], [0.5, 0.2], [-0.3, 0.4], [2.1, 1.2]);
    check!(counted(x, y) at [1.3, 0.7], [0.5, 0.2], [-0.3, 0.4]);
    check!(spelled(x, y) at [1.3, 0.7], [0.5, 0.2], [-0.3, 0.4]);
}

/// Other names for what is borrowed, and for parts of it.
#[differentiable]
fn steps_by_name(whole: &mut [f64], body: &mut Body, by: f64) {
    let elements = whole;
    #[differentiable(checkpoint)]
    for _ in 0..5 {
        elements[0] = elements[0] * by + elements[1].sin();
    }
    let (first, rest) = elements.split_at_mut(1);
    let last = body.rates.last_mut().unwrap();
    #[differentiable(checkpoint)]
    for index in 0..6 {
        first[0] *= (rest[index % 2] * by).cos();
        rest[0] += first[0] * *last;
        *last *= by;
    }
}

#[differentiable]
fn by_other_names(x: f64, y: f64) -> f64 {
    let mut body = Body { position: [x, y], rates: vec![y, x] };
    let mut whole = [x, y, x * y];
    steps_by_name(&mut whole, &mut body, y);
    whole[0] * whole[1] + whole[2] * body.rates[1] + body.rates[0]
}

#[test]
fn loops_on_what_is_borrowed() {
    check!(borrowed(x, y) at [1.3, 0.7], [-0.4, 1.1]);
    check!(by_other_names(x, y) at [1.3, 0.7], [-0.4, 1.1]);
}

#[differentiable]
fn halved(x: f64, y: f64) -> f64 {
    let (mut a, mut b, mut count) = (x, y, 0_usize);
    #[differentiable(checkpoint)]
    while a > 0.05 && count < 40 {
        count += 1;
        if count % 3 == 0 {
            b *= a.cos();
            continue;
        }
        a *= 0.9;
        b += a * y;
        a += 0.001 * b * b;
    }
    a * b + b
}

#[differentiable]
fn left_loops(x: f64, y: f64, n: usize) -> Option<f64> {
    let mut a = x;
    let mut i = 0;
    let mut history = vec![x];
    #[differentiable(checkpoint)]
    'outer: loop {
        i += 1;
        a = (a * y + 0.3).sin() + 1.0;
        let mut j = 0;
        while j < 3 {
            j += 1;
            if i % 7 == 6 {
                continue 'outer;
            }
            a += 0.1 * y;
        }
        history.push(a * y);
        if i == n {
            break;
        }
        if a > 100.0 {
            return Some(a * a);
        }
        history[i / 2] *= y;
        (a - 1.0).is_finite().then_some(())?;
    }
    Some(history.iter().map(|h| h * a).sum())
}

#[differentiable]
fn matched_loop(x: f64, y: f64) -> f64 {
    let mut left = vec![x, y, x * y, 0.5];
    let mut sum = y;
    #[differentiable(checkpoint)]
    while let Some(last) = left.pop() {
        sum = (sum * last + x).sin();
        if sum > 0.9 && last > 0.2 {
            left.push(0.3 * last);
            sum *= 0.5;
        }
    }
    sum
}

#[differentiable]
impl Oscillator {
    fn settle(&mut self, values: &mut [f64], limit: f64) {
        let mut steps = 0;
        #[differentiable(checkpoint)]
        while self.velocity.abs() > limit && steps < 20 {
            self.position += 0.1 * self.velocity;
            self.velocity *= 0.8 + 0.01 * values[steps % values.len()];
            values[steps % 2] += self.position;
            steps += 1;
        }
    }
}

#[differentiable]
fn settled(x: f64, y: f64) -> f64 {
    let mut state = Oscillator { position: x, velocity: y };
    let mut values = [x, 0.2, y];
    state.settle(&mut values, 0.05);
    state.position * state.velocity + values[0] * values[1] * values[2]
}

#[differentiable]
fn left(x: f64, y: f64) -> f64 {
    let mut sum: f64 = 0.0;
    for n in [1, 2, 5, 12, 33, 70] {
        sum += left_loops(x, y, n).unwrap_or(x * y) * (1.0 + 0.01 * sum).cos() / n as f64;
    }
    sum
}

/// Ends with the value of a loop, in a block with that of another one.
#[differentiable]
fn of_value(x: f64, y: f64) -> f64 {
    let first = {
        let mut a = x;
        #[differentiable(checkpoint)]
        loop {
            a = a * 0.5 + y;
            if a.abs() < 1.5 {
                break a * 2.0;
            }
        }
    };
    let mut sum = first * x;
    #[differentiable(checkpoint)]
    'steps: loop {
        for weight in [x, y] {
            sum = sum * 0.7 + 0.01 * weight;
            if sum.abs() < 1.0 {
                break 'steps sum * first;
            }
        }
    }
}

/// Never comes to the end of its loop.
#[differentiable]
fn returned_for_ever(x: f64, y: f64) -> f64 {
    let mut a = x;
    #[differentiable(checkpoint)]
    loop {
        a = a * 0.5 + y;
        if a.abs() < 1.5 {
            return a * x;
        }
    }
}

#[test]
fn loops_have_values() {
    check!(of_value(x, y) at [1.3, 0.7], [9.0, -0.3], [0.01, 0.4]);
    check!(returned_for_ever(x, y) at [1.3, 0.7], [9.0, -0.3], [0.01, 0.4]);
}

#[test]
fn loops_under_conditions() {
    check!(halved(x, y) at [1.3, 0.7], [0.4, -0.3], [0.01, 2.0]);
    check!(left(x, y) at [1.3, 0.7], [0.4, -0.3]);
    check!(matched_loop(x, y) at [1.3, 0.7], [0.4, -0.3]);
    check!(settled(x, y) at [1.3, 0.7], [0.4, -0.3], [0.4, 0.01]);
}

/// What runs twice has to do the same twice.
mod impure {
    use std::cell::Cell;

    use ad::differentiable;

    thread_local! {
        static SEED: Cell<u64> = const { Cell::new(1) };
    }

    fn next() -> f64 {
        SEED.set(SEED.get().wrapping_mul(6364136223846793005).wrapping_add(1));
        (SEED.get() >> 11) as f64 / (1_u64 << 53) as f64
    }

    #[differentiable]
    fn in_a_loop(x: f64) -> f64 {
        let mut s = x;
        #[differentiable(checkpoint)]
        for _ in 0..9 {
            s += next() * x * s;
        }
        s
    }

    #[differentiable]
    fn in_a_while(x: f64, n: usize) -> f64 {
        let (mut s, mut i) = (x, 0);
        #[differentiable(checkpoint)]
        while i < n {
            s *= 1.0 + next() * x;
            i += 1;
        }
        s
    }

    #[differentiable(checkpoint)]
    fn in_a_function(x: f64) -> f64 {
        next() * x
    }

    #[test]
    #[should_panic = "a checkpointed computation gives something else"]
    fn loops_are_compared() {
        in_a_loop::grad(1.3);
    }

    #[test]
    #[should_panic = "a checkpointed computation gives something else"]
    fn loops_under_conditions_are_compared() {
        in_a_while::grad(1.3, 10);
    }

    #[test]
    #[should_panic = "a checkpointed computation gives something else"]
    fn functions_are_compared() {
        in_a_function::grad(1.3);
    }
}
