//! A cubic spline as a struct, which is searched by bisection.

use ad::{Differentiable, differentiable};

#[derive(Debug, Clone, Differentiable)]
struct CubicSpline {
    knots: Vec<Knot>,
}

#[derive(Debug, Clone, Copy, Default, Differentiable)]
struct Knot {
    x: f64,
    y: f64,
    m: f64,
}

#[derive(Debug, Clone, PartialEq, Differentiable)]
#[constant]
enum SplineError {
    TooFew,
    NotSorted { at: usize },
}

#[differentiable]
impl CubicSpline {
    fn new(points: &[(f64, f64)]) -> Result<Self, SplineError> {
        if points.len() < 3 {
            return Err(SplineError::TooFew);
        }
        for (i, pair) in points.windows(2).enumerate() {
            if let [(x0, _), (x1, _)] = pair
                && x0 >= x1
            {
                return Err(SplineError::NotSorted { at: i });
            }
        }
        let n = points.len();
        let mut knots: Vec<Knot> =
            points.iter().map(|&(x, y)| Knot { x, y, ..Default::default() }).collect();
        // Thomas
        let (mut c, mut d) = (vec![0.0; n], vec![0.0; n]);
        for i in 1..n - 1 {
            let (h0, h1) = (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
            let a = h0 / 6.0;
            let b = (h0 + h1) / 3.0;
            let cc = h1 / 6.0;
            let rhs = (points[i + 1].1 - points[i].1) / h1 - (points[i].1 - points[i - 1].1) / h0;
            let w = b - a * c[i - 1];
            c[i] = cc / w;
            d[i] = (rhs - a * d[i - 1]) / w;
        }
        for i in (1..n - 1).rev() {
            knots[i].m = d[i] - c[i] * knots[i + 1].m;
        }
        Ok(Self { knots })
    }

    fn segment(&self, x: f64) -> usize {
        let mut lo = 0;
        let mut hi = self.knots.len() - 1;
        while hi - lo > 1 {
            let mid = (lo + hi) / 2;
            if self.knots[mid].x > x {
                hi = mid;
            } else {
                lo = mid;
            }
        }
        lo
    }

    fn eval(&self, x: f64) -> f64 {
        let i = self.segment(x);
        let Knot { x: x0, y: y0, m: m0 } = self.knots[i];
        let Knot { x: x1, y: y1, m: m1 } = self.knots[i + 1];
        let h = x1 - x0;
        let (t, u) = ((x1 - x) / h, (x - x0) / h);
        t * y0 + u * y1 + h.powi(2) / 6.0 * ((t.powi(3) - t) * m0 + (u.powi(3) - u) * m1)
    }

    fn integral(&self) -> f64 {
        self.knots
            .windows(2)
            .map(|w| {
                let (a, b) = (&w[0], &w[1]);
                let h = b.x - a.x;
                0.5 * h * (a.y + b.y) - h.powi(3) / 24.0 * (a.m + b.m)
            })
            .sum::<f64>()
    }
}

#[differentiable]
fn f(a: f64, b: f64) -> f64 {
    let points = [(0.0, a), (1.0, b), (2.5, a * b), (3.0, -1.0)];
    let spline = match CubicSpline::new(&points) {
        Ok(s) => s,
        Err(SplineError::TooFew) => return 0.0,
        Err(e) => panic!("bad points: {e:?}"),
    };
    spline.eval(1.3) + spline.eval(a) + spline.integral()
}

#[test]
fn pieces() {
    use crate::oracle::check;

    check!(f(a, b) at [0.7, 0.5], [1.4, -0.3]);
}
