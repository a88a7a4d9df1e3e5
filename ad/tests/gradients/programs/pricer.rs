//! A Monte Carlo pricer, whose generator is advanced as it is drawn from.

use ad::{Differentiable, differentiable};

use crate::oracle::check;

struct Rng {
    state: u64,
    spare: Option<f64>,
}

impl Rng {
    fn new(seed: u64) -> Self {
        Rng { state: seed, spare: None }
    }

    fn uniform(&mut self) -> f64 {
        self.state ^= self.state << 13;
        self.state ^= self.state >> 7;
        self.state ^= self.state << 17;
        ((self.state >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
    }

    fn normal(&mut self) -> f64 {
        if let Some(spare) = self.spare.take() {
            return spare;
        }
        let radius = (-2.0 * self.uniform().ln()).sqrt();
        let angle = 2.0 * std::f64::consts::PI * self.uniform();
        self.spare = Some(radius * angle.sin());
        radius * angle.cos()
    }
}

#[derive(Clone, Copy, Debug, Differentiable)]
struct Market {
    spot: f64,
    rate: f64,
    volatility: f64,
}

#[derive(Clone, Copy, Debug, Differentiable)]
enum Payoff {
    Call(f64),
    Asian { strike: f64 },
}

#[differentiable]
fn path(market: &Market, steps: usize, dt: f64, #[constant] rng: &mut Rng) -> Vec<f64> {
    let mut s = market.spot;
    let mut path = Vec::with_capacity(steps);
    for _ in 0..steps {
        let z = rng.normal();
        let drift = (market.rate - 0.5 * market.volatility * market.volatility) * dt;
        s *= (drift + market.volatility * dt.sqrt() * z).exp();
        path.push(s);
    }
    path
}

#[differentiable]
fn payoff(kind: &Payoff, path: &[f64]) -> f64 {
    match kind {
        Payoff::Call(strike) => (path[path.len() - 1] - strike).max(0.0),
        Payoff::Asian { strike } => {
            let mean = path.iter().sum::<f64>() / path.len() as f64;
            (mean - strike).max(0.0)
        }
    }
}

#[differentiable]
fn price(market: Market, kind: Payoff, paths: usize, #[constant] rng: &mut Rng) -> f64 {
    let (steps, maturity) = (8, 1.0);
    let dt = maturity / steps as f64;
    let mut sum = 0.0;
    for _ in 0..paths {
        let path = path(&market, steps, dt, rng);
        sum += payoff(&kind, &path);
    }
    (-market.rate * maturity).exp() * sum / paths as f64
}

#[differentiable]
fn book(spot: f64, volatility: f64) -> f64 {
    #[constant]
    let mut rng = Rng::new(42);
    let market = Market { spot, rate: 0.03, volatility };
    price(market, Payoff::Call(1.0), 9, &mut rng)
        + price(market, Payoff::Asian { strike: 0.9 * spot }, 7, &mut rng)
}

#[test]
fn a_pricer() {
    check!(book(spot, volatility) at [1.05, 0.2], [0.95, 0.35]);
}
