//! What things cost, as ratios within one run.
//!
//! `cargo bench -p renderer -- [kernels | images | rays | scaling | requests] [ARGUMENT ..]`; without
//! a subject all but `scaling`, which takes minutes. `requests` is in `features`, which is built
//! without features of the crate, too.

mod adjoint;
mod images;
mod kernels;
mod rays;
mod scaling;
mod sphere;
mod timing;

fn main() {
    let arguments: Vec<String> =
        std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let (subject, rest) = match arguments.split_first() {
        Some((subject, rest)) => (subject.as_str(), rest),
        None => ("", &[][..]),
    };
    match subject {
        "kernels" => kernels::run(),
        "images" => images::run(rest),
        "rays" => rays::run(rest),
        "scaling" => scaling::run(rest),
        "" => {
            kernels::run();
            images::run(&[]);
            rays::run(&[]);
        }
        // Those of `features`.
        "requests" | "plain" => {}
        other => {
            eprintln!("error: no subject `{other}`: kernels, images, rays, scaling or requests");
        }
    }
}
