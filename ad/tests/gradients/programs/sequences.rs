//! Sequences: a hidden Markov model in logarithms, butterflies over chunks that are swapped.

use ad::{Differentiable, Real, differentiable};

use crate::oracle::{check, check_generic};

#[derive(Clone, Debug, Differentiable)]
struct Model {
    initial: Vec<f64>,
    transition: Vec<Vec<f64>>,
    emission: Vec<Vec<f64>>,
}

#[derive(Debug, PartialEq, Differentiable)]
#[constant]
enum ModelError {
    Empty,
    UnknownSymbol { symbol: usize, at: usize },
}

#[differentiable]
fn log_sum_exp(xs: &[f64]) -> f64 {
    let largest = xs.iter().cloned().fold(f64::NEG_INFINITY, f64::max);
    if largest == f64::NEG_INFINITY {
        return largest;
    }
    largest + xs.iter().map(|x| (x - largest).exp()).sum::<f64>().ln()
}

#[differentiable]
impl Model {
    fn states(&self) -> usize {
        self.initial.len()
    }

    /// Softmax of a row.
    fn normalized(row: &[f64]) -> Vec<f64> {
        let total = log_sum_exp(row);
        row.iter().map(|x| x - total).collect()
    }

    fn log_likelihood(&self, #[constant] symbols: &[usize]) -> Result<f64, ModelError> {
        let first = symbols.first().ok_or(ModelError::Empty)?;
        let n = self.states();
        let transition: Vec<Vec<f64>> =
            self.transition.iter().map(|row| Self::normalized(row)).collect();
        let emission: Vec<Vec<f64>> =
            self.emission.iter().map(|row| Self::normalized(row)).collect();
        let initial = Self::normalized(&self.initial);
        let mut alpha: Vec<f64> = (0..n).map(|i| initial[i] + emission[i][*first]).collect();
        for (at, &symbol) in symbols.iter().enumerate().skip(1) {
            if symbol >= emission[0].len() {
                return Err(ModelError::UnknownSymbol { symbol, at });
            }
            let mut next = vec![0.0; n];
            for j in 0..n {
                let terms: Vec<f64> = (0..n).map(|i| alpha[i] + transition[i][j]).collect();
                next[j] = log_sum_exp(&terms) + emission[j][symbol];
            }
            alpha = next;
        }
        Ok(log_sum_exp(&alpha))
    }
}

#[differentiable]
fn both(x: f64, y: f64) -> Result<f64, ModelError> {
    let model = Model {
        initial: vec![0.0, x],
        transition: vec![vec![x, -0.3], vec![y, 0.1 * x * y]],
        emission: vec![vec![0.2, y, -0.1], vec![x - y, 0.0, 0.5]],
    };
    let a = model.log_likelihood(&[0, 1, 2, 2, 1])?;
    let b = model.log_likelihood(&[2])?;
    Ok(a - 0.5 * b * b)
}

#[differentiable]
fn likelihood(x: f64, y: f64) -> f64 {
    both(x, y).unwrap_or(0.0)
        + match both(y, x) {
            Ok(value) => value.sin(),
            Err(_) => 1.0,
        }
}

#[test]
fn a_hidden_markov_model() {
    check!(likelihood(x, y) at [0.3, -0.7], [1.2, 0.4]);
    let model =
        Model { initial: vec![0.0], transition: vec![vec![0.0]], emission: vec![vec![0.0, 1.0]] };
    assert_eq!(model.log_likelihood_vjp(&[]).0, Err(ModelError::Empty));
    let unknown = ModelError::UnknownSymbol { symbol: 4, at: 1 };
    assert_eq!(model.log_likelihood_vjp(&[1, 4]).0, Err(unknown));
}

/// In place, real and imaginary parts beside each other; the inverse but for its factor where `sign`
/// is 1.
#[differentiable]
fn fourier<S: Real>(re: &mut [S], im: &mut [S], #[constant] sign: f64) {
    let n = re.len();
    let mut j = 0;
    for i in 1..n {
        let mut bit = n >> 1;
        while j & bit != 0 {
            j ^= bit;
            bit >>= 1;
        }
        j |= bit;
        if i < j {
            re.swap(i, j);
            im.swap(i, j);
        }
    }
    let mut length = 2;
    while length <= n {
        let half = length / 2;
        let angle = sign * std::f64::consts::TAU / length as f64;
        for (re, im) in re.chunks_exact_mut(length).zip(im.chunks_exact_mut(length)) {
            for k in 0..half {
                let (s, c) = (angle * k as f64).sin_cos();
                let (s, c) = (S::from_f64(s), S::from_f64(c));
                let (x, y) =
                    (re[k + half] * c - im[k + half] * s, re[k + half] * s + im[k + half] * c);
                re[k + half] = re[k] - x;
                im[k + half] = im[k] - y;
                re[k] += x;
                im[k] += y;
            }
        }
        length <<= 1;
    }
}

/// The convolution of two signals, in frequencies.
#[differentiable]
fn convolved<S: Real>(x: S, y: S) -> S {
    let mut a = [x, y, x * y, S::ONE, S::ZERO, y, x - y, S::HALF];
    let mut a_im = [S::ZERO; 8];
    let mut b = [S::ONE, x, S::ZERO, y * y, S::ZERO, S::ZERO, x, S::ONE];
    let mut b_im = [S::ZERO; 8];
    fourier(&mut a, &mut a_im, -1.0);
    fourier(&mut b, &mut b_im, -1.0);
    for k in 0..8 {
        let re = a[k] * b[k] - a_im[k] * b_im[k];
        a_im[k] = a[k] * b_im[k] + a_im[k] * b[k];
        a[k] = re;
    }
    fourier(&mut a, &mut a_im, 1.0);
    let mut sum = S::ZERO;
    for (k, value) in a.iter().enumerate() {
        sum += *value * S::from_f64(0.3 * k as f64 - 1.0);
    }
    sum * a[3]
}

#[test]
fn a_convolution_by_fourier_transforms() {
    check_generic!(convolved(x, y) at [0.3, -0.7], [1.2, 0.4]);
}
