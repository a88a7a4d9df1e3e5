//! A natural cubic spline, fitted to points: the algorithm of Thomas.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

type Real = f64;

#[derive(Clone, Debug, Differentiable)]
struct Spline {
    #[constant]
    knots: Vec<Real>,
    values: Vec<Real>,
    moments: Vec<Real>,
}

#[differentiable]
fn thomas(lower: &[Real], diagonal: &[Real], upper: &[Real], right: &[Real]) -> Option<Vec<Real>> {
    let n = diagonal.len();
    let mut c = vec![0.0; n];
    let mut d = vec![0.0; n];
    c[0] = upper[0] / diagonal[0];
    d[0] = right[0] / diagonal[0];
    for i in 1..n {
        let m = diagonal[i] - lower[i] * c[i - 1];
        if m.abs() < 1e-14 {
            return None;
        }
        if i + 1 < n {
            c[i] = upper[i] / m;
        }
        d[i] = (right[i] - lower[i] * d[i - 1]) / m;
    }
    for i in (0..n - 1).rev() {
        d[i] -= c[i] * d[i + 1];
    }
    Some(d)
}

#[differentiable]
impl Spline {
    fn fit(#[constant] knots: &[Real], values: &[Real]) -> Option<Spline> {
        let n = knots.len();
        let mut lower = vec![0.0; n];
        let mut diagonal = vec![1.0; n];
        let mut upper = vec![0.0; n];
        let mut right = vec![0.0; n];
        for i in 1..n - 1 {
            let (h0, h1) = (knots[i] - knots[i - 1], knots[i + 1] - knots[i]);
            lower[i] = h0 / 6.0;
            diagonal[i] = (h0 + h1) / 3.0;
            upper[i] = h1 / 6.0;
            right[i] = (values[i + 1] - values[i]) / h1 - (values[i] - values[i - 1]) / h0;
        }
        thomas(&lower, &diagonal, &upper, &right).map(|moments| Spline {
            knots: knots.to_vec(),
            values: values.to_vec(),
            moments,
        })
    }

    fn at(&self, t: Real) -> Real {
        let last = self.knots.len() - 2;
        let i =
            self.knots.iter().position(|k| *k > t).map_or(last, |p| p.saturating_sub(1)).min(last);
        let h = self.knots[i + 1] - self.knots[i];
        let a = (self.knots[i + 1] - t) / h;
        let b = 1.0 - a;
        a * self.values[i]
            + b * self.values[i + 1]
            + ((a * a * a - a) * self.moments[i] + (b * b * b - b) * self.moments[i + 1]) * h * h
                / 6.0
    }
}

#[differentiable]
fn misfit(values: &[Real], t: Real) -> Real {
    let knots: Vec<Real> = (0..values.len()).map(|i| i as Real).collect();
    let Some(spline) = Spline::fit(&knots, values) else { return 0.0 };
    let mut sum = 0.0;
    for k in 0..4 {
        let x = k as Real * 0.7 + t;
        let residual = spline.at(x) - x.sin() as Real;
        sum += residual.powi(2);
    }
    sum / 4 as Real
}

#[differentiable]
fn fitted(x: f64, t: f64) -> f64 {
    misfit(&[0.1, x, 0.5, x * x, -0.2], t)
}

#[test]
fn a_spline() {
    check!(fitted(x, t) at [0.6, 0.15], [-0.4, 0.55]);
}
