//! Roots, integrals, differential equations.

use ad::differentiable;

/// Newton's method for Kepler's equation.
#[differentiable]
fn eccentric_anomaly(mean: f64, eccentricity: f64) -> f64 {
    let mut e = if eccentricity < 0.8 { mean } else { std::f64::consts::PI };
    for _ in 0..50 {
        let delta = (e - eccentricity * e.sin() - mean) / (1.0 - eccentricity * e.cos());
        e -= delta;
        if delta.abs() < 1e-14 {
            break;
        }
    }
    e
}

#[differentiable]
fn orbit(mean: f64, eccentricity: f64) -> f64 {
    let e = eccentric_anomaly(mean, eccentricity);
    let x = e.cos() - eccentricity;
    let y = (1.0 - eccentricity.powi(2)).sqrt() * e.sin();
    x.hypot(y) + y.atan2(x)
}

/// Bisection, then the implicit function theorem by one Newton step.
fn bisect(f: impl Fn(f64) -> f64, mut lo: f64, mut hi: f64) -> f64 {
    while hi - lo > 1e-12 {
        let mid = 0.5 * (lo + hi);
        if f(lo) * f(mid) <= 0.0 {
            hi = mid;
        } else {
            lo = mid;
        }
    }
    0.5 * (lo + hi)
}

#[differentiable]
fn implied(a: f64, b: f64) -> f64 {
    let root = ad::no_diff(|| bisect(|x| x.exp() * a - b - x, 0.0, 5.0));
    let f = root.exp() * a - b - root;
    let slope = ad::stop_gradient(root.exp() * a - 1.0);
    root - f / slope
}

#[derive(Clone, Copy, Debug, ad::Differentiable)]
struct State {
    q: [f64; 2],
    p: [f64; 2],
}

#[differentiable]
fn derivative(s: &State, k: f64, coupling: f64) -> State {
    let stretch = s.q[1] - s.q[0];
    State {
        q: s.p,
        p: [-k * s.q[0] + coupling * stretch, -k * s.q[1] - coupling * stretch.powi(3)],
    }
}

#[differentiable]
fn axpy(s: &State, d: &State, h: f64) -> State {
    let mut out = *s;
    for i in 0..2 {
        out.q[i] += h * d.q[i];
        out.p[i] += h * d.p[i];
    }
    out
}

#[differentiable]
fn rk4_step(s: &State, k: f64, c: f64, h: f64) -> State {
    let k1 = derivative(s, k, c);
    let k2 = derivative(&axpy(s, &k1, 0.5 * h), k, c);
    let k3 = derivative(&axpy(s, &k2, 0.5 * h), k, c);
    let k4 = derivative(&axpy(s, &k3, h), k, c);
    let mut out = *s;
    for ((q, a), ((b, c), d)) in out.q.iter_mut().zip(&k1.q).zip(k2.q.iter().zip(&k3.q).zip(&k4.q))
    {
        *q += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
    }
    for i in 0..2 {
        out.p[i] += h / 6.0 * (k1.p[i] + 2.0 * k2.p[i] + 2.0 * k3.p[i] + k4.p[i]);
    }
    out
}

#[differentiable]
fn pendulums(k: f64, c: f64) -> f64 {
    let mut state = State { q: [1.0, 0.0], p: [0.0, 0.5] };
    let mut trajectory = vec![state];
    for _ in 0..20 {
        state = rk4_step(&state, k, c, 0.05);
        trajectory.push(state);
    }
    trajectory.iter().map(|s| s.q[0] * s.q[0] + s.q[1]).sum::<f64>() / trajectory.len() as f64
}

/// Explicit heat equation on a grid, with a source.
#[differentiable]
fn heat(alpha: f64, source: f64) -> f64 {
    const N: usize = 12;
    let dx = 1.0 / (N - 1) as f64;
    let dt = 0.2 * dx * dx;
    let mut u = vec![0.0; N];
    u[N / 2] = 1.0;
    for step in 0..15 {
        let mut next = u.clone();
        for i in 1..N - 1 {
            next[i] = u[i] + alpha * dt / (dx * dx) * (u[i - 1] - 2.0 * u[i] + u[i + 1]);
        }
        next[3] += source * dt * (step as f64).cos();
        u = next;
    }
    u.iter().enumerate().map(|(i, v)| v * v * (i as f64 + 1.0)).sum()
}

/// The Thomas algorithm.
#[differentiable]
fn tridiagonal(lower: &[f64], diagonal: &[f64], upper: &[f64], rhs: &[f64]) -> Vec<f64> {
    let n = diagonal.len();
    let mut c = vec![0.0; n];
    let mut d = vec![0.0; n];
    c[0] = upper[0] / diagonal[0];
    d[0] = rhs[0] / diagonal[0];
    for i in 1..n {
        let m = diagonal[i] - lower[i - 1] * c[i - 1];
        if i < n - 1 {
            c[i] = upper[i] / m;
        }
        d[i] = (rhs[i] - lower[i - 1] * d[i - 1]) / m;
    }
    let mut x = d.clone();
    for i in (0..n - 1).rev() {
        x[i] = d[i] - c[i] * x[i + 1];
    }
    x
}

/// A natural cubic spline through points, at a place.
#[differentiable]
fn spline(x: f64, y: f64) -> f64 {
    let xs = [0.0, 0.7, 1.5, 2.1, 3.0];
    let ys = [y, x * 0.3, y * y, 0.4, x];
    let n = xs.len();
    let h: Vec<f64> = xs.windows(2).map(|w| w[1] - w[0]).collect();
    let mut rhs = vec![0.0; n];
    for i in 1..n - 1 {
        rhs[i] = 6.0 * ((ys[i + 1] - ys[i]) / h[i] - (ys[i] - ys[i - 1]) / h[i - 1]);
    }
    let mut diagonal = vec![1.0; n];
    let mut lower = vec![0.0; n - 1];
    let mut upper = vec![0.0; n - 1];
    for i in 1..n - 1 {
        diagonal[i] = 2.0 * (h[i - 1] + h[i]);
        lower[i - 1] = h[i - 1];
        upper[i] = h[i];
    }
    let m = tridiagonal(&lower, &diagonal, &upper, &rhs);
    let at = x.clamp(xs[0], xs[n - 1]);
    let k = xs.iter().rposition(|&knot| knot <= at).unwrap_or(0).min(n - 2);
    let (a, b) = (xs[k + 1] - at, at - xs[k]);
    (m[k] * a.powi(3) + m[k + 1] * b.powi(3)) / (6.0 * h[k])
        + (ys[k] / h[k] - m[k] * h[k] / 6.0) * a
        + (ys[k + 1] / h[k] - m[k + 1] * h[k] / 6.0) * b
}

#[test]
fn solvers() {
    use crate::oracle::{check, check_reverse};
    check!(orbit(mean, eccentricity) at [0.7, 0.3], [2.4, 0.9], [-1.1, 0.05]);
    check_reverse!(implied(a, b) at [0.9, 2.0], [0.5, 3.0]);
    check_reverse!(pendulums(k, c) at [1.3, 0.7], [0.4, 2.1]);
    check!(heat(alpha, source) at [1.3, 0.7], [0.4, 2.1]);
    check!(spline(x, y) at [1.3, 0.7], [2.4, -0.9], [0.2, 1.9]);
}
