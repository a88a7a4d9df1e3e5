//! An option priced by Monte Carlo, with random numbers of its own.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

/// Numerical Recipes' generator.
struct Lcg {
    state: u64,
}

impl Lcg {
    fn new(seed: u64) -> Self {
        Lcg { state: seed.wrapping_mul(2862933555777941757).wrapping_add(3037000493) }
    }

    fn uniform(&mut self) -> f64 {
        self.state = self.state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.state >> 11) as f64 + 0.5) / (1u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        let (u, v) = (self.uniform(), self.uniform());
        (-2.0 * u.ln()).sqrt() * (std::f64::consts::TAU * v).cos()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
struct Market {
    spot: f64,
    rate: f64,
    volatility: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Payoff {
    Call,
    Put,
    Asian { fixings: usize },
}

#[differentiable]
fn payoff(#[constant] kind: Payoff, path: &[f64], strike: f64) -> f64 {
    let last = path[path.len() - 1];
    match kind {
        Payoff::Call => (last - strike).max(0.0),
        Payoff::Put => (strike - last).max(0.0),
        Payoff::Asian { fixings } => {
            let average: f64 = path.iter().rev().take(fixings).sum::<f64>() / fixings as f64;
            if average > strike { average - strike } else { 0.0 }
        }
    }
}

#[differentiable]
fn price(
    market: &Market,
    #[constant] kind: Payoff,
    strike: f64,
    years: f64,
    #[constant] paths: usize,
    #[constant] steps: usize,
) -> f64 {
    const SEED: u64 = 42;
    let dt = years / steps as f64;
    let drift = (market.rate - 0.5 * market.volatility.powi(2)) * dt;
    let sigma = market.volatility * dt.sqrt();
    let mut state = SEED;
    let mut total = 0.0;
    for _ in 0..paths {
        let mut path = Vec::with_capacity(steps);
        let mut s = market.spot;
        for _ in 0..steps {
            // Twelve uniforms make a normal.
            let mut z = -6.0;
            for _ in 0..12 {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                z += (state >> 11) as f64 / (1u64 << 53) as f64;
            }
            s *= (drift + sigma * z).exp();
            path.push(s);
        }
        total += payoff(kind, &path, strike);
    }
    (-market.rate * years).exp() * total / paths as f64
}

#[differentiable]
fn portfolio(spot: f64, volatility: f64, rate: f64) -> f64 {
    let market = Market { spot, rate, volatility };
    let mut value = 0.0;
    for (i, kind) in
        [Payoff::Call, Payoff::Put, Payoff::Asian { fixings: 3 }].into_iter().enumerate()
    {
        let weight = 1.0 + 0.5 * i as f64;
        value += weight * price(&market, kind, 1.0, 0.75, 40, 5);
    }
    value
}

#[test]
fn an_option_by_monte_carlo() {
    check!(portfolio(spot, volatility, rate) at [1.02, 0.3, 0.02], [0.9, 0.15, 0.05]);
}

/// The same with the generator behind a call that has no derivative.
#[differentiable]
fn terminal(spot: f64, volatility: f64, rate: f64) -> f64 {
    let normals: Vec<f64> = ad::no_diff(|| {
        let mut lcg = Lcg::new(7);
        (0..64).map(|_| lcg.normal()).collect()
    });
    let drift = rate - 0.5 * volatility * volatility;
    let (mut sum, mut squares) = (0.0, 0.0);
    for value in normals.iter().map(|z| spot * (drift + volatility * z).exp()) {
        // A payoff without a kink.
        let gain = 0.1 * ((value - 1.0) / 0.1).exp().ln_1p();
        sum += gain;
        squares += gain * gain;
    }
    let n = normals.len() as f64;
    let mean = sum / n;
    mean + 0.1 * (squares / n - mean * mean).sqrt()
}

#[test]
fn random_numbers_behind_a_call() {
    check!(terminal(spot, volatility, rate) at [1.02, 0.3, 0.02], [0.9, 0.15, 0.05]);
}
