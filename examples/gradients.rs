//! Gradients of your own function, three ways: written at compile time, by dual numbers, by finite
//! differences.
//!
//! `cargo run --release --example gradients`

use ad::{Dual, Real, check, differentiable};

/// Where a ball lands that is thrown with this speed and angle: explicit Euler steps for a second.
#[differentiable]
fn landing<S: Real>(speed: S, angle: S, drag: S) -> S {
    let step = S::from_f64(0.01);
    let gravity = S::from_f64(9.81);
    let mut x = S::ZERO;
    let mut y = S::ZERO;
    let mut vx = speed * angle.cos();
    let mut vy = speed * angle.sin();
    for _ in 0..100 {
        let friction = drag * (vx * vx + vy * vy).sqrt();
        vx = vx - friction * vx * step;
        vy = vy - (friction * vy + gravity) * step;
        x += vx * step;
        y += vy * step;
    }
    // Straight on from the last point to the ground.
    x - y * vx / vy
}

fn main() {
    let (speed, angle, drag) = (12.0, 0.8, 0.05);
    let (value, (by_speed, by_angle, by_drag)) = landing::value_and_grad::<f64>(speed, angle, drag);
    println!("lands at {value}");

    let dual = |derivatives: [f64; 3]| {
        let [a, b, c] = derivatives;
        landing(Dual::new(speed, a), Dual::new(angle, b), Dual::new(drag, c)).derivative
    };
    let differences = check::gradient(|x| landing(x[0], x[1], x[2]), &[speed, angle, drag], 1e-3);
    let rows = [
        ("speed", by_speed, dual([1.0, 0.0, 0.0])),
        ("angle", by_angle, dual([0.0, 1.0, 0.0])),
        ("drag", by_drag, dual([0.0, 0.0, 1.0])),
    ];
    println!(
        "{:>6}  {:>22}  {:>22}  {:>22}",
        "", "generated adjoint", "dual numbers", "finite differences"
    );
    for ((name, adjoint, dual), difference) in rows.into_iter().zip(differences) {
        println!("{name:>6}  {adjoint:>22}  {dual:>22}  {:>22}", difference.value);
    }
}
