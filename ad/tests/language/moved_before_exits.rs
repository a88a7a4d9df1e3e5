//! Values that are not `Copy`, moved on a way that leaves and given a new value on the ways that go on.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

#[differentiable]
fn grown(v: Vec<f64>, by: f64) -> Vec<f64> {
    let mut v = v;
    v[0] *= by;
    v[1] += 0.1 * v[0];
    v
}

#[differentiable]
fn small(v: Vec<f64>, by: f64) -> Option<Vec<f64>> {
    let mut v = v;
    v[0] *= by;
    if v[0] > 3.0 { None } else { Some(v) }
}

#[differentiable]
fn tried(v: Vec<f64>, by: f64) -> Result<Vec<f64>, i32> {
    let mut v = v;
    v[1] *= by;
    if v[1] > 3.0 { Err(2) } else { Ok(v) }
}

#[differentiable]
fn total(v: Vec<f64>) -> f64 {
    v[0] * v[0] + 0.5 * v[1]
}

/// By `break`, in `for`, `while` and `loop`, and what follows does not read it.
#[differentiable]
fn left(x: f64, y: f64) -> f64 {
    let mut s = x * y;
    let mut v = vec![x, y];
    for i in 0..6 {
        let w = grown(v, y);
        if w[0] > 3.0 {
            s += w[0] * w[1];
            break;
        }
        s += w[1] * i as f64;
        v = w;
    }
    let mut u = vec![y, x];
    let mut i = 0;
    while i < 5 && u[0] < 50.0 {
        i += 1;
        let w = grown(u, x);
        if w[0] > 2.0 {
            s += total(w);
            break;
        }
        u = w;
    }
    let mut t = vec![x * y, y];
    loop {
        let w = grown(t, 1.5);
        if w[1] > 2.0 {
            break s + w[0];
        }
        s += w[0];
        t = w;
    }
}

/// It is moved by the exit itself.
#[differentiable]
fn consumed(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    for i in 0..8 {
        if v[0] > 3.0 {
            return total(v) * y;
        }
        if i == 6 {
            let w = grown(v, y);
            return w[0] - w[1];
        }
        v = grown(v, y);
    }
    v[0] * v[1]
}

/// What follows the loop reads it, where a `return` has moved it.
#[differentiable]
fn read_after(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    let mut n = 0;
    for i in 0..5 {
        let w = grown(v, y);
        if w[0] > 3.0 {
            return w[0] * x;
        }
        v = w;
        n += 1;
        if i == 3 {
            break;
        }
    }
    let mut u = grown(v, x);
    while n > 0 {
        n -= 1;
        let w = grown(u, 1.2);
        if w[1] > 3.0 {
            return w[1] + y;
        }
        u = w;
    }
    u[0] * u[1]
}

/// By `?`, in straight code and in loops.
#[differentiable]
fn attempted(x: f64, y: f64) -> Option<f64> {
    let mut v = vec![x, y];
    for _ in 0..3 {
        v = small(v, y)?;
        v = match small(v, 1.1) {
            Some(w) => w,
            None => return Some(x * y),
        };
    }
    v = small(v, 0.9)?;
    Some(v[0] * v[1])
}

#[differentiable]
fn attempts(x: f64, y: f64) -> f64 {
    attempted(x, y).unwrap_or(x - y)
}

#[differentiable]
fn failing(x: f64, y: f64) -> Result<Vec<f64>, i32> {
    let mut v = vec![x, y];
    for i in 0..3 {
        let w = tried(v, y + i as f64)?;
        if w[1] < 0.0 {
            return Ok(w);
        }
        v = grown(w, x);
    }
    Ok(v)
}

#[differentiable]
fn failures(x: f64, y: f64) -> f64 {
    match failing(x, y) {
        Ok(v) => total(v),
        Err(e) => f64::from(e) * x,
    }
}

/// By `continue`, and by a name from an inner loop.
#[differentiable]
fn nested(x: f64, y: f64) -> f64 {
    let mut s = x;
    let mut v = vec![x, y];
    'rows: for i in 0..4 {
        if i == 1 {
            v = grown(v, 1.1);
            continue;
        }
        for j in 0..3 {
            let w = grown(v, y);
            if w[0] > 4.0 {
                s += w[0];
                break 'rows;
            }
            if w[1] > 1.0 && j == 1 {
                v = grown(w, 0.9);
                continue 'rows;
            }
            if w[1] < -1.0 {
                return w[1] * s;
            }
            v = w;
        }
        s += v[0] * v[1];
    }
    s * y
}

/// In loops of which the iterations run twice.
#[differentiable]
fn with_checkpoints(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    let mut s = 0.0;
    #[differentiable(checkpoint)]
    for i in 0..7 {
        for k in 0..3 {
            let w = grown(v, y);
            if w[0] > 3.0 {
                v = vec![0.1 * w[1], w[0]];
                break;
            }
            if k == 1 && w[0] > 1.5 {
                v = grown(w, 0.8);
                continue;
            }
            v = w;
        }
        s += v[0] * x * i as f64;
    }
    s * v[0]
}

/// Several arms go on, and one has moved it.
#[differentiable]
fn joined(x: f64, y: f64) -> f64 {
    let mut v = vec![x, y];
    let mut s = y;
    for i in 0..5 {
        let k = match i % 3 {
            0 => v[0] * x,
            1 if v[0] > 2.0 => {
                let w = grown(v, y);
                s += w[1];
                break;
            }
            1 => {
                v = grown(v, 1.3);
                v[1]
            }
            _ => {
                if v[1] > 2.5 {
                    return total(v);
                }
                y
            }
        };
        s += k * v[0];
        v = grown(v, y);
    }
    s
}

#[differentiable]
fn in_straight_code(x: f64, y: f64) -> f64 {
    let v = vec![x, y];
    let k = match y > 1.0 {
        true if x > 1.0 => return total(v),
        true => x * y,
        false => y,
    };
    k * v[0] + v[1]
}

/// One that never changes is consumed where the loop is left.
#[differentiable]
fn unchanged(x: f64, y: f64) -> f64 {
    let v = vec![x, y, x * y];
    let mut s = x;
    for i in 0..3 {
        s += v[i] * y;
        if s > 2.0 {
            return total(v) * s;
        }
    }
    s
}

#[derive(Clone, Differentiable)]
struct State {
    at: Vec<f64>,
    weight: f64,
}

#[differentiable]
impl State {
    fn stepped(mut self, by: f64) -> Self {
        self.at[0] += by * self.weight;
        self.weight *= 0.9;
        self
    }

    fn run(mut self, by: f64) -> f64 {
        for _ in 0..6 {
            let next = self.stepped(by);
            if next.at[0] > 2.0 {
                return next.at[0] * next.weight;
            }
            self = next;
        }
        self.weight
    }
}

#[differentiable]
fn halved(x: Box<f64>, by: f64) -> Box<f64> {
    Box::new(*x * by)
}

#[differentiable]
fn objects(x: f64, y: f64) -> f64 {
    let start = State { at: vec![x, y], weight: y };
    let mut state = start.clone();
    let mut boxed = Box::new(x);
    let mut s = 0.0;
    loop {
        let State { at, weight } = state.stepped(x);
        let half = halved(boxed, weight);
        s += weight * *half;
        if s > 3.0 || weight < 0.3 {
            s += at[0];
            break;
        }
        boxed = half;
        state = State { at, weight };
    }
    s + start.run(y)
}

fn permuted(order: Vec<usize>) -> Vec<usize> {
    order.into_iter().rev().collect()
}

/// What carries no derivative moves too.
#[differentiable]
fn orders(x: f64, y: f64) -> f64 {
    let values = [x, y, x * y];
    let mut order: Vec<usize> = vec![0, 1, 2];
    let mut s = x;
    for i in 0..4 {
        let next = permuted(order);
        s += values[next[0]] * values[next[i % 3]];
        if s > 4.0 {
            break;
        }
        order = next;
    }
    s
}

#[test]
fn ways_that_go_on_find_them() {
    check!(left(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [0.3, 0.4]);
    check!(consumed(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6]);
    check!(read_after(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [1.1, 1.2]);
    check!(attempts(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [2.5, 1.25], [3.5, 0.8]);
    check!(failures(x, y) at [0.5, 1.3], [1.2, 0.4], [0.7, -0.6], [0.3, 0.2]);
    check!(nested(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [0.4, -0.9], [0.4, -2.9]);
    check!(with_checkpoints(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [0.4, -0.9]);
    check!(joined(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6], [0.4, 2.6]);
    check!(in_straight_code(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6]);
    check!(unchanged(x, y) at [0.5, 1.3], [1.2, 0.8], [0.2, 0.6]);
    check!(objects(x, y) at [0.5, 1.3], [1.2, 0.8], [0.2, 0.6], [1.9, 0.35]);
    check!(orders(x, y) at [0.5, 1.3], [1.2, 0.8], [1.7, 1.6]);
}
