//! What the reverse sweep of a loop computes again has to be what the forward sweep computed.

use ad::differentiable;

use crate::oracle::check;

/// The array is read before and after an element is overwritten, within one iteration and across.
#[differentiable]
fn overwritten_element(x: f64, y: f64) -> f64 {
    let mut a = [x, y, x * y];
    let mut sum = 0.0;
    for i in 0..3 {
        let before = a[i] * a[i];
        a[i] = a[(i + 1) % 3] * y;
        sum += before * a[i] * a[(i + 2) % 3];
    }
    sum
}

/// The array no longer changes in the second loop, but does after it.
#[differentiable]
fn changed_after_the_loop(x: f64, y: f64) -> f64 {
    let mut a = [x; 4];
    for i in 0..4 {
        a[i] = a[i] * y + i as f64;
    }
    let mut sum = 0.0;
    for i in 0..4 {
        sum += a[i] * a[i] * x;
    }
    a[2] = sum * y;
    sum * a[2] + a[1]
}

/// The array of an outer iteration is finished before the inner loop that reads it.
#[differentiable]
fn finished_in_the_outer_iteration(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..3 {
        let mut a = [0.0; 4];
        for j in 0..4 {
            a[j] += x * (i + j) as f64;
            a[j] *= y;
        }
        for j in 0..4 {
            sum += a[j] * a[3 - j] * y;
        }
    }
    sum
}

/// The same, but the array goes on changing in the iteration.
#[differentiable]
fn unfinished_in_the_outer_iteration(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..3 {
        let mut a = [x; 4];
        for j in 0..4 {
            sum += a[j] * a[j] * y;
            a[3 - j] = a[j] * x + i as f64 * y;
        }
        if i > 0 {
            a[0] = sum;
        }
        sum += a[0];
    }
    sum
}

/// The counter is no function of the loop variable.
#[differentiable]
fn counted_index(x: f64, y: f64) -> f64 {
    let a = [x, y, x + y, x - y, x * y];
    let mut at = 0;
    let mut sum = 0.0;
    for i in 0..4 {
        let first = a[at];
        at = (2 * at + i) % 5;
        let second = a[at];
        sum += first * second * second;
    }
    sum
}

/// Two reads of one place with an assignment between them, in an arm.
#[differentiable]
fn assigned_in_an_arm(x: f64, y: f64) -> f64 {
    let mut a = x;
    for i in 0..5 {
        let first = a * a;
        if i % 2 == 0 {
            a = y * a;
        }
        let second = a * a;
        a = first * 0.25 + second * 0.125 * x;
    }
    a
}

/// Ranges that depend on the outer variable, and on data.
#[differentiable]
fn dependent_ranges(x: f64, y: f64, n: usize) -> f64 {
    let lengths = [2, 0, 3, 1];
    let mut sum = x;
    for i in 0..n {
        for j in i + 1..n {
            sum += x * y * (j - i) as f64;
            for k in 0..lengths[(i + j) % 4] {
                let power = sum * y + k as f64;
                sum = power.sin() + x;
            }
        }
    }
    sum
}

#[differentiable]
fn dependent_ranges_of_five(x: f64, y: f64) -> f64 {
    dependent_ranges(x, y, 5)
}

/// An inner loop that is left early pushes as many times as it ran.
#[differentiable]
fn first_above(x: f64, limit: f64) -> f64 {
    let mut power = 1.0;
    for i in 0..100 {
        power = power * x + i as f64 * 0.25;
        if power > limit {
            return power * x;
        }
    }
    limit * power
}

#[differentiable]
fn early_exits_in_a_loop(x: f64, y: f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..6 {
        sum += first_above(x + i as f64 * 0.125, y) * y;
    }
    sum
}

#[differentiable]
fn nested_early_exit(x: f64, y: f64) -> f64 {
    let mut sum = y;
    for i in 0..4 {
        let mut power = x;
        for j in 0..10 {
            power *= x + (i * j) as f64 * 0.0625;
            if power > 5.0 * y {
                return power * sum;
            }
            sum += power.exp() * 0.125;
        }
    }
    sum
}

/// Cheap methods, whose pullbacks are made again.
#[differentiable]
fn cheap_methods(x: f64, y: f64) -> f64 {
    let mut state = x;
    for i in 0..6 {
        let shifted = state - y * i as f64;
        let kinked = shifted.abs().max(0.25).mul_add(x, y);
        let wave = kinked.sin() * kinked.cos();
        state = wave.clamp(-0.4, 0.4) + kinked.min(3.0) * 0.25;
    }
    state
}

/// A constant that looks the same in two scopes, and a parameter that is rebound.
#[differentiable]
fn rebound_names(x: f64, y: f64) -> f64 {
    let scale = 2.0;
    let mut sum = 0.0;
    for i in 0..3 {
        let scale = scale * (i as f64 + 1.0);
        let x = x * scale;
        let x = x * x + y;
        sum += x * scale;
    }
    sum * scale
}

/// Elements of an array behind a reference, and of one within another.
#[differentiable]
fn rows(table: &[[f64; 2]; 3], x: f64) -> f64 {
    let mut sum = x;
    for i in 0..3 {
        let row = table[i];
        for j in 0..2 {
            sum = sum * x + row[j] * table[2 - i][1 - j] * sum;
        }
    }
    sum
}

#[differentiable]
fn rows_of_two(x: f64, y: f64) -> f64 {
    let table = [[x, y], [x * y, x], [y, 0.5]];
    rows(&table, y)
}

/// Nothing is saved from a loop that may run any number of times.
#[differentiable]
fn trips(x: f64, n: usize) -> f64 {
    let mut sum = 0.0;
    for i in 0..n {
        sum += (x * i as f64).sin();
    }
    sum
}

#[test]
fn gradients_are_those_of_the_function() {
    check!(overwritten_element(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(changed_after_the_loop(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(finished_in_the_outer_iteration(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(unfinished_in_the_outer_iteration(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(counted_index(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(assigned_in_an_arm(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(dependent_ranges_of_five(x, y) at [0.3, 0.2], [-0.4, 0.3]);
    check!(early_exits_in_a_loop(x, y) at [1.3, 20.3], [0.9, 3.1]);
    check!(nested_early_exit(x, y) at [1.1, 1.3], [0.3, 2.0]);
    check!(cheap_methods(x, y) at [0.7, 0.31], [-1.1, 0.43]);
    check!(rebound_names(x, y) at [0.7, 1.3], [-1.1, 0.4]);
    check!(rows_of_two(x, y) at [0.7, 1.3], [-1.1, 0.4]);
}

#[test]
fn trip_counts() {
    for n in [0, 1, 2, 65, 1000] {
        let expected: f64 = (0..n).map(|i| i as f64 * (0.3 * i as f64).cos()).sum();
        let (slope, ()) = trips::grad(0.3, n);
        crate::oracle::assert_close("trips", slope, expected, 1e-12);
    }
}

/// Indices that are defined together are computed again, each from what it was then.
#[differentiable]
fn indices_defined_together(x: f64, y: f64) -> f64 {
    let rows = [x, y, x * y, x - y, 2.0 * y, x * x];
    let mut n = 0;
    let mut total = 1.0;
    for i in 0..3 {
        let (w, b) = (2 * i, 2 * i + 1);
        let (last, next) = (n, n + 1);
        n = next;
        total += (rows[w] * total + rows[b]) * rows[last] * rows[next];
    }
    total
}

#[test]
fn several_at_once() {
    check!(indices_defined_together(x, y) at [0.5, 0.7], [-1.1, 0.4]);
}

/// Ranges end at lengths of slices, of which the reverse sweep knows nothing.
#[differentiable]
fn lengths(xs: &[f64]) -> f64 {
    let size = xs.len();
    let mut sum = 1.0;
    for i in 0..size {
        let (all, last) = (xs.len(), xs.len() - 1 - i);
        let same = all - 1 - last;
        sum += sum * xs[last] * xs[same];
        for k in same + 1..size - 1 {
            sum += xs[k] * xs[i] * sum;
        }
    }
    sum
}

#[test]
fn ranges_up_to_lengths() {
    let x = [0.3, -0.2, 0.5, 0.1];
    crate::oracle::assert_gradient("lengths", lengths, &x, &lengths::grad(&x));
}

/// The ways that branches go are told again from what their conditions were computed from, as it was then.
#[differentiable]
fn ways(x: f64, y: f64) -> f64 {
    let a = [x, y, x * y, x - y, 0.3];
    let (mut level, mut turns, mut sum) = (y, 0, 0.0);
    for i in 1..5 {
        let limit = 0.1 * i as f64;
        let error = a[i] - level;
        if error > limit {
            sum += error;
            turns += 1;
        } else if i % 2 == 0 {
            sum -= error * 0.5;
        } else if turns > 1 {
            sum += x;
        }
        if a[i] > a[i - 1] {
            sum += a[i] * 3.0;
        }
        level = level * 0.5 + error * y;
    }
    sum * level
}

const FOURTH: usize = 3;

/// The same of arms that are chosen by patterns and guards.
#[differentiable]
fn arms(x: f64, y: f64) -> f64 {
    let a = [x, y, x * y, x - y, 0.3];
    let fixed = [2, 1, 1, 1, 0];
    let mut changing = [0, 7, 2, 1, 0];
    let (mut sum, mut turns) = (x, 0);
    for i in 0..5 {
        sum += match i % 4 {
            FOURTH => y,
            0 if a[i] > 0.4 => a[i] * 3.0,
            0 | 2 => -a[i],
            _ => 1.0,
        };
        match fixed[4 - i] {
            0 | 7 => sum += x,
            1 if turns < 2 => sum -= y,
            _ => sum += a[i] * 2.0,
        }
        turns += 1;
        match changing[i] {
            1..=7 => sum -= a[4 - i],
            _ => sum += y * 0.5,
        }
        changing[i] = 5 - changing[4 - i];
    }
    sum * x
}

#[test]
fn the_same_ways_again() {
    check!(ways(x, y) at [0.5, 0.7], [-1.1, 0.4], [1.7, -0.6]);
    check!(arms(x, y) at [0.5, 0.7], [-1.1, 0.4], [1.7, -0.6]);
}
