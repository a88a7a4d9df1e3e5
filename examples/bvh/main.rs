//! Images with and without a bounding volume hierarchy, figure 2 of the paper on RayTracer.jl
//! ("Accelerating the Rendering using Acceleration Structures").
//!
//! `cargo run --release --example bvh [mesh.obj]`
//!
//! Time and allocated bytes for each pixel of a mesh of 137 triangles, 32 x 32 to 1024 x 1024 pixels;
//! then 100 to 1,000,000 triangles in an image of 64 x 64. Both ways the same image. An argument names
//! a mesh to stand for the one of 137 triangles. `out/bvh/` gets the plots and a picture.

mod experiment;
#[path = "../shared/mesh_argument.rs"]
mod mesh_argument;
#[path = "../shared/plot.rs"]
mod plot;
#[path = "../../renderer/benches/sphere.rs"]
mod sphere;

use std::alloc::System;
use std::path::Path;
use std::time::Instant;

use plot::{Curve, Horizontal, Point, save_plot};
use renderer::files::save_png;
use renderer::{Error, PrimaryVisibility, Scene};
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

const WAYS: [(&str, PrimaryVisibility); 2] =
    [("hierarchy", PrimaryVisibility::Bvh), ("brute force", PrimaryVisibility::BruteForce)];
const SIZES: [u32; 6] = [32, 64, 128, 256, 512, 1024];
const TRIANGLES: [usize; 5] = [100, 1_000, 10_000, 100_000, 1_000_000];
/// How often a scene is prepared; the fastest counts.
const PREPARATIONS: usize = 3;
/// Images are repeated for so long; the fastest counts.
const SECONDS: f64 = 0.1;

fn main() -> Result<(), Error> {
    let out = Path::new("out/bvh");
    std::fs::create_dir_all(out).map_err(|error| Error::new(out.display(), error))?;
    let no_curves = || WAYS.map(|(label, _)| Curve { label: label.to_owned(), points: Vec::new() });
    let (mut times, mut bytes, mut growth) = (no_curves(), no_curves(), no_curves());

    println!(
        "{:>14}  {:>24}  {:>24}",
        "pixels", "ns per pixel: bvh, brute", "bytes per pixel: bvh, brute"
    );
    for size in SIZES {
        let mut scene = experiment::scene(137, size)?;
        mesh_argument::apply(&mut scene)?;
        let pixels = f64::from(size * size);
        let costs = measure_ways(&scene)?;
        let [bvh, brute] = &costs;
        let nanoseconds = |cost: &Cost| 1e9 * cost.seconds / pixels;
        println!(
            "{:>14}  {:>11.1} {:>12.1}  {:>11.1} {:>12.1}",
            format!("{size} x {size}"),
            nanoseconds(bvh),
            nanoseconds(brute),
            bvh.bytes as f64 / pixels,
            brute.bytes as f64 / pixels
        );
        for (way, cost) in costs.iter().enumerate() {
            let at = |y: f64| Point { x: pixels, y, deviation: 0.0 };
            times[way].points.push(at(nanoseconds(cost)));
            bytes[way].points.push(at(cost.bytes as f64 / pixels));
        }
        if size == SIZES[0] {
            let [bvh, brute] = [bvh, brute].map(|cost| 1e6 * cost.preparation);
            println!("{:>14}  {bvh:.0} and {brute:.0} microseconds before the first image", "");
        }
        if size == SIZES[SIZES.len() - 1] {
            let renderer = experiment::renderer(&scene, PrimaryVisibility::Bvh)?;
            save_png(&renderer.render(), &out.join("mesh.png"))?;
        }
    }

    println!("{:>14}  {:>24}", "triangles", "ms per image: bvh, brute");
    for triangles in TRIANGLES {
        let scene = experiment::scene(triangles, 64)?;
        let costs = measure_ways(&scene)?.map(|cost| 1e3 * cost.seconds);
        println!("{triangles:>14}  {:>11.3} {:>12.3}", costs[0], costs[1]);
        for (curve, y) in growth.iter_mut().zip(costs) {
            curve.points.push(Point { x: triangles as f64, y, deviation: 0.0 });
        }
    }

    let along = |title| Horizontal { title, is_logarithmic: true };
    save_plot(
        &out.join("time.svg"),
        "137 triangles",
        along("pixels"),
        "nanoseconds per pixel",
        &times,
    )?;
    save_plot(
        &out.join("memory.svg"),
        "137 triangles",
        along("pixels"),
        "allocated bytes per pixel",
        &bytes,
    )?;
    save_plot(
        &out.join("triangles.svg"),
        "64 x 64 pixels",
        along("triangles"),
        "milliseconds",
        &growth,
    )?;
    println!("plots in {}", out.display());
    Ok(())
}

/// What an image costs.
struct Cost {
    /// To build the hierarchy or to gather the triangles, before the first image.
    preparation: f64,
    seconds: f64,
    bytes: usize,
}

fn measure_ways(scene: &Scene) -> Result<[Cost; 2], Error> {
    let [bvh, brute] = WAYS.map(|(_, visibility)| measure(scene, visibility));
    Ok([bvh?, brute?])
}

fn measure(scene: &Scene, visibility: PrimaryVisibility) -> Result<Cost, Error> {
    let mut preparation = f64::INFINITY;
    for _ in 0..PREPARATIONS {
        let clock = Instant::now();
        experiment::renderer(scene, visibility)?;
        preparation = preparation.min(clock.elapsed().as_secs_f64());
    }
    let renderer = experiment::renderer(scene, visibility)?;
    // The first image also warms up what threads keep.
    renderer.render();
    let region = Region::new(ALLOCATOR);
    renderer.render();
    let bytes = region.change().bytes_allocated;
    let clock = Instant::now();
    let mut seconds = f64::INFINITY;
    while clock.elapsed().as_secs_f64() < SECONDS {
        let clock = Instant::now();
        renderer.render();
        seconds = seconds.min(clock.elapsed().as_secs_f64());
    }
    Ok(Cost { preparation, seconds, bytes })
}
