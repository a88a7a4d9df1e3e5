//! The cost of a gradient, as a ratio to the cost of the function.
//!
//! `cargo bench -p ad --bench ad [-- NAME ..]` prints a line for each function whose name contains
//! one of the arguments: the generated adjoint and a good one by hand, which are checked to be
//! equal, and the other ways to a gradient; for two functions also the crates `reverse` and `num-dual`. Medians over interleaved repetitions, one thread. Forward
//! mode and dual numbers are measured in one direction, and multiplied by the number of inputs.

#![allow(clippy::needless_range_loop, reason = "the functions are written with indices throughout")]

mod branches;
mod bundle_adjustment;
mod gmm;
mod lotka_volterra;
mod lstm;
mod peers;
mod problem;
mod random;
mod rosenbrock;
mod shading;
mod timing;

fn main() {
    let wanted: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    run(&wanted, &rosenbrock::Rosenbrock);
    run(&wanted, &branches::Branches);
    run(&wanted, &shading::Shading);
    run(&wanted, &gmm::Gmm::new());
    run(&wanted, &lotka_volterra::LotkaVolterra);
    run(&wanted, &bundle_adjustment::BundleAdjustment);
    run(&wanted, &lstm::Lstm::new());
}

fn run<P: problem::Problem>(wanted: &[String], problem: &P) {
    if wanted.is_empty() || wanted.iter().any(|name| P::NAME.contains(name.as_str())) {
        problem::run(problem);
    }
}
