//! ADBench's log-likelihood of a Gaussian mixture model, 1000 points, 10 dimensions, 25 components.

use ad::{Real, differentiable, stop_gradient};

use crate::problem::Problem;
use crate::random::Random;

/// Dimensions.
pub const D: usize = 10;
/// Components.
pub const K: usize = 25;
/// Points.
pub const N: usize = 1000;
/// The logarithms of the diagonal of a component's triangular matrix, then its columns.
pub const FACTORS: usize = D + D * (D - 1) / 2;

/// The logarithms of the weights, the means and the inverse covariance factors.
#[derive(Clone)]
pub struct Mixture<S> {
    pub weights: [S; K],
    pub means: [[S; D]; K],
    pub factors: [[S; FACTORS]; K],
}

pub type Points = [[f64; D]; N];

/// Where element (`row`, `column`) lies among the factors, below the diagonal.
macro_rules! below {
    ($row:expr, $column:expr) => {
        D + $column * (2 * D - $column - 1) / 2 + $row - $column - 1
    };
}

#[differentiable]
pub fn log_likelihood<S: Real>(
    weights: &[S; K],
    means: &[[S; D]; K],
    factors: &[[S; FACTORS]; K],
    points: &[[f64; D]; N],
) -> S {
    let half = S::HALF;
    let mut diagonals = [[S::ZERO; D]; K];
    let mut offsets = [S::ZERO; K];
    let mut prior = S::ZERO;
    for k in 0..K {
        let mut log_determinant = S::ZERO;
        for i in 0..D {
            let diagonal = factors[k][i].exp();
            prior += half * diagonal * diagonal;
            diagonals[k][i] = diagonal;
            log_determinant += factors[k][i];
        }
        for i in D..FACTORS {
            prior += half * factors[k][i] * factors[k][i];
        }
        offsets[k] = weights[k] + log_determinant;
    }

    let mut total = S::ZERO;
    for n in 0..N {
        let mut terms = [S::ZERO; K];
        for k in 0..K {
            let mut transformed = [S::ZERO; D];
            for i in 0..D {
                let centered = S::from_f64(stop_gradient(points[n][i])) - means[k][i];
                transformed[i] += diagonals[k][i] * centered;
                for j in i + 1..D {
                    let at = D + i * (2 * D - i - 1) / 2 + j - i - 1;
                    transformed[j] += factors[k][at] * centered;
                }
            }
            let mut square = S::ZERO;
            for i in 0..D {
                square += transformed[i] * transformed[i];
            }
            terms[k] = offsets[k] - half * square;
        }
        total += log_sum_exp::<S>(&terms);
    }
    total - S::from_f64(N as f64) * log_sum_exp::<S>(weights) + prior + S::from_f64(constant())
}

/// The logarithm of the sum of exponentials, of which the largest is taken out.
#[differentiable]
fn log_sum_exp<S: Real>(terms: &[S; K]) -> S {
    let mut largest = stop_gradient(terms[0]);
    for k in 1..K {
        largest = stop_gradient(largest.max(terms[k]));
    }
    let mut sum = S::ZERO;
    for k in 0..K {
        sum += (terms[k] - largest).exp();
    }
    sum.ln() + largest
}

/// What does not depend on the parameters: the normalisation of the Gaussians and of the Wishart
/// prior with `gamma` = 1 and `m` = 0.
fn constant() -> f64 {
    use std::f64::consts::{LN_2, PI};
    let d = D as f64;
    // n = d + 1 degrees of freedom; ln of the multivariate gamma function at n / 2.
    let degrees = d + 1.0;
    let log_gamma: f64 =
        d * (d - 1.0) / 4.0 * PI.ln() + (0..D).map(|i| log_gamma_half(D + 1 - i)).sum::<f64>();
    let normalisation = -degrees * d * 0.5 * LN_2 - log_gamma;
    -(N as f64) * d * 0.5 * (2.0 * PI).ln() - K as f64 * normalisation
}

/// ln(gamma(twice / 2))
fn log_gamma_half(twice: usize) -> f64 {
    match twice {
        1 => 0.5 * std::f64::consts::PI.ln(),
        2 => 0.0,
        _ => (twice as f64 / 2.0 - 1.0).ln() + log_gamma_half(twice - 2),
    }
}

/// The gradient, written by hand: forwards and backwards point by point, so that nothing outlives
/// a point.
pub fn adjoint(m: &Mixture<f64>, points: &Points) -> Mixture<f64> {
    let mut bar = Mixture { weights: [0.0; K], means: [[0.0; D]; K], factors: [[0.0; FACTORS]; K] };
    let diagonals = m.factors.map(|f| std::array::from_fn::<_, D, _>(|i| f[i].exp()));
    let offsets: [f64; K] =
        std::array::from_fn(|k| m.weights[k] + m.factors[k][..D].iter().sum::<f64>());
    let mut offsets_bar = [0.0; K];
    let mut diagonals_bar = [[0.0; D]; K];

    for x in points {
        let mut centered = [[0.0; D]; K];
        let mut transformed = [[0.0; D]; K];
        let mut terms = [0.0; K];
        for k in 0..K {
            let (c, t) = (&mut centered[k], &mut transformed[k]);
            for i in 0..D {
                c[i] = x[i] - m.means[k][i];
                t[i] += diagonals[k][i] * c[i];
                for j in i + 1..D {
                    t[j] += m.factors[k][below!(j, i)] * c[i];
                }
            }
            terms[k] = offsets[k] - 0.5 * t.iter().map(|t| t * t).sum::<f64>();
        }

        let shares = softmax(&terms);
        for k in 0..K {
            offsets_bar[k] += shares[k];
            let (c, t) = (&centered[k], &transformed[k]);
            for i in 0..D {
                let own = -shares[k] * t[i];
                diagonals_bar[k][i] += own * c[i];
                let mut c_bar = own * diagonals[k][i];
                for j in i + 1..D {
                    let other = -shares[k] * t[j];
                    bar.factors[k][below!(j, i)] += other * c[i];
                    c_bar += other * m.factors[k][below!(j, i)];
                }
                bar.means[k][i] -= c_bar;
            }
        }
    }

    let shares = softmax(&m.weights);
    for k in 0..K {
        bar.weights[k] = offsets_bar[k] - N as f64 * shares[k];
        for i in 0..D {
            let diagonal = diagonals[k][i];
            bar.factors[k][i] = offsets_bar[k] + (diagonals_bar[k][i] + diagonal) * diagonal;
        }
        for i in D..FACTORS {
            bar.factors[k][i] += m.factors[k][i];
        }
    }
    bar
}

/// The derivative of [`log_sum_exp`].
fn softmax(terms: &[f64; K]) -> [f64; K] {
    let largest = terms.iter().fold(terms[0], |a, &b| a.max(b));
    let exponentials = terms.map(|t| (t - largest).exp());
    let sum: f64 = exponentials.iter().sum();
    exponentials.map(|e| e / sum)
}

pub struct Gmm {
    points: Box<Points>,
}

impl Gmm {
    pub fn new() -> Self {
        let mut random = Random::new(4);
        Self { points: Box::new(std::array::from_fn(|_| random.numbers().map(|x| 2.0 * x))) }
    }
}

impl<S: Real> Mixture<S> {
    /// From a flat list.
    fn read(x: &[S]) -> Self {
        let (weights, x) = x.split_first_chunk().expect("the weights");
        let (means, factors) = x.split_at(K * D);
        Self {
            weights: *weights,
            means: std::array::from_fn(|k| *means[k * D..].first_chunk().expect("a mean")),
            factors: std::array::from_fn(|k| {
                *factors[k * FACTORS..].first_chunk().expect("a component's factors")
            }),
        }
    }

    /// To a flat list.
    fn write(&self, x: &mut [S]) {
        let (weights, x) = x.split_at_mut(K);
        let (means, factors) = x.split_at_mut(K * D);
        weights.copy_from_slice(&self.weights);
        means.copy_from_slice(self.means.as_flattened());
        factors.copy_from_slice(self.factors.as_flattened());
    }
}

impl Problem for Gmm {
    const NAME: &'static str = "GMM d10 K25";
    const OUTPUTS: usize = 1;

    fn point(&self) -> Vec<f64> {
        let mut random = Random::new(5);
        (0..K * (1 + D + FACTORS)).map(|_| random.number()).collect()
    }

    fn value<S: Real<Mask = bool>>(&self, x: &[S], outputs: &mut [S]) {
        let m = Mixture::read(x);
        outputs[0] = log_likelihood(&m.weights, &m.means, &m.factors, &self.points);
    }

    fn generated(&self, x: &[f64], jacobian: &mut [f64]) {
        let m = Mixture::read(x);
        let (weights, means, factors, _) =
            log_likelihood::grad(&m.weights, &m.means, &m.factors, &self.points);
        Mixture { weights, means, factors }.write(jacobian);
    }

    fn forward(&self, x: &[f64], direction: &[f64], tangents: &mut [f64]) {
        let (m, d) = (Mixture::read(x), Mixture::read(direction));
        (_, tangents[0]) = log_likelihood::jvp(
            &m.weights,
            &m.means,
            &m.factors,
            &self.points,
            &d.weights,
            &d.means,
            &d.factors,
            &[[0.0; D]; N],
        );
    }

    fn by_hand(&self, x: &[f64], jacobian: &mut [f64]) {
        adjoint(&Mixture::read(x), &self.points).write(jacobian);
    }
}
