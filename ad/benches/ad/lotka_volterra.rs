//! The predator-prey equations, 1000 steps of the classical Runge-Kutta method; parameters and
//! start by the prey at the end.

use ad::{Real, differentiable};

use crate::peers::{Number, Peers, peers};
use crate::problem::Problem;

const STEPS: usize = 1000;

/// The length of a step.
const H: f64 = 0.01;

#[differentiable]
pub fn simulate<S: Real>(p: [S; 6]) -> S {
    let (a, b, c, d) = (p[0], p[1], p[2], p[3]);
    let mut x = p[4];
    let mut y = p[5];
    let h = S::from_f64(H);
    let half = S::from_f64(H / 2.0);
    let sixth = S::from_f64(H / 6.0);
    for _ in 0..1000 {
        let k1 = a * x - b * x * y;
        let l1 = c * x * y - d * y;
        let x2 = x + half * k1;
        let y2 = y + half * l1;
        let k2 = a * x2 - b * x2 * y2;
        let l2 = c * x2 * y2 - d * y2;
        let x3 = x + half * k2;
        let y3 = y + half * l2;
        let k3 = a * x3 - b * x3 * y3;
        let l3 = c * x3 * y3 - d * y3;
        let x4 = x + h * k3;
        let y4 = y + h * l3;
        let k4 = a * x4 - b * x4 * y4;
        let l4 = c * x4 * y4 - d * y4;
        x += sixth * (k1 + S::TWO * k2 + S::TWO * k3 + k4);
        y += sixth * (l1 + S::TWO * l2 + S::TWO * l3 + l4);
    }
    x
}

/// [`simulate`], for the numbers of other crates.
fn simulate_of_numbers<T: Number>(p: &[T]) -> T {
    let [a, b, c, d, mut x, mut y] = *p.first_chunk().expect("6 numbers");
    let slope = |x: T, y: T| (a * x - b * x * y, c * x * y - d * y);
    for _ in 0..STEPS {
        let (k1, l1) = slope(x, y);
        let (k2, l2) = slope(x + k1 * (H / 2.0), y + l1 * (H / 2.0));
        let (k3, l3) = slope(x + k2 * (H / 2.0), y + l2 * (H / 2.0));
        let (k4, l4) = slope(x + k3 * H, y + l3 * H);
        x = x + (k1 + k2 * 2.0 + k3 * 2.0 + k4) * (H / 6.0);
        y = y + (l1 + l2 * 2.0 + l3 * 2.0 + l4) * (H / 6.0);
    }
    x
}

/// The gradient, written by hand: the states are stored, the stages of a step computed again.
pub fn adjoint(p: [f64; 6]) -> [f64; 6] {
    let [a, b, c, d, mut x, mut y] = p;
    let mut states = [(0.0, 0.0); STEPS];
    let slope = |x: f64, y: f64| (a * x - b * x * y, c * x * y - d * y);
    for state in &mut states {
        *state = (x, y);
        let (k1, l1) = slope(x, y);
        let (k2, l2) = slope(x + H / 2.0 * k1, y + H / 2.0 * l1);
        let (k3, l3) = slope(x + H / 2.0 * k2, y + H / 2.0 * l2);
        let (k4, l4) = slope(x + H * k3, y + H * l3);
        x += H / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
        y += H / 6.0 * (l1 + 2.0 * l2 + 2.0 * l3 + l4);
    }

    let mut gradient = [0.0; 4];
    let (mut x_bar, mut y_bar) = (1.0, 0.0);
    for &(x, y) in states.iter().rev() {
        let (k1, l1) = slope(x, y);
        let (x2, y2) = (x + H / 2.0 * k1, y + H / 2.0 * l1);
        let (k2, l2) = slope(x2, y2);
        let (x3, y3) = (x + H / 2.0 * k2, y + H / 2.0 * l2);
        let (k3, l3) = slope(x3, y3);
        let (x4, y4) = (x + H * k3, y + H * l3);

        // The cotangents of a point whose slope has the cotangents `k_bar` and `l_bar`.
        let mut pull_back = |x: f64, y: f64, k_bar: f64, l_bar: f64| {
            gradient[0] += k_bar * x;
            gradient[1] -= k_bar * (x * y);
            gradient[2] += l_bar * (x * y);
            gradient[3] -= l_bar * y;
            (k_bar * (a - b * y) + l_bar * (c * y), l_bar * (c * x - d) - k_bar * (b * x))
        };
        let (k_bar, l_bar) = (H / 6.0 * x_bar, H / 6.0 * y_bar);
        let (x4_bar, y4_bar) = pull_back(x4, y4, k_bar, l_bar);
        let (k3_bar, l3_bar) = (2.0 * k_bar + H * x4_bar, 2.0 * l_bar + H * y4_bar);
        let (x3_bar, y3_bar) = pull_back(x3, y3, k3_bar, l3_bar);
        let (k2_bar, l2_bar) = (2.0 * k_bar + H / 2.0 * x3_bar, 2.0 * l_bar + H / 2.0 * y3_bar);
        let (x2_bar, y2_bar) = pull_back(x2, y2, k2_bar, l2_bar);
        let (k1_bar, l1_bar) = (k_bar + H / 2.0 * x2_bar, l_bar + H / 2.0 * y2_bar);
        let (x1_bar, y1_bar) = pull_back(x, y, k1_bar, l1_bar);
        x_bar += x1_bar + x2_bar + x3_bar + x4_bar;
        y_bar += y1_bar + y2_bar + y3_bar + y4_bar;
    }
    let [a, b, c, d] = gradient;
    [a, b, c, d, x_bar, y_bar]
}

pub struct LotkaVolterra;

impl Problem for LotkaVolterra {
    const NAME: &'static str = "Lotka-Volterra RK4 1000";
    const OUTPUTS: usize = 1;

    fn point(&self) -> Vec<f64> {
        vec![1.5, 1.0, 1.0, 3.0, 1.0, 1.0]
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        outputs[0] = simulate(*x.first_chunk().expect("6 numbers"));
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&simulate::grad(*x.first_chunk().expect("6 numbers")));
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let [x, direction] = [x, direction].map(|x| *x.first_chunk().expect("6 numbers"));
        tangents[0] = simulate::jvp(x, direction).1;
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        jacobian.copy_from_slice(&adjoint(*x.first_chunk().expect("6 numbers")));
    }

    fn peers(&self) -> Option<&dyn Peers> {
        Some(self)
    }
}

peers!(LotkaVolterra, simulate_of_numbers);
