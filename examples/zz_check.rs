#[path = "cornell/experiment.rs"]
mod experiment;
use renderer::glam::DVec3;
use renderer::scene::PathTracing;
use renderer::*;
use std::time::Instant;
struct Mean(f64);
impl PixelLoss for Mean {
    fn evaluate(&self, _: u32, _: u32, r: DVec3) -> (f64, DVec3) {
        (r.element_sum() * self.0, DVec3::splat(self.0))
    }
}
struct Square(f64);
impl PixelLoss for Square {
    fn evaluate(&self, _: u32, _: u32, r: DVec3) -> (f64, DVec3) {
        (r.length_squared() * self.0, r * (2.0 * self.0))
    }
}
fn main() {
    let samples: u32 = std::env::args().nth(1).map_or(64, |a| a.parse().unwrap());
    let scene = experiment::cornell(256, PathTracing { max_depth: 6, samples, seed: 0 }).unwrap();
    let renderer = Renderer::new(&scene, &Settings::default()).unwrap();
    let w = 1.0 / (3.0 * 65536.0);
    let ids: Vec<_> = ["red.diffuse", "green.diffuse"]
        .iter()
        .map(|p| scene.parameter(&format!("material.{p}")).unwrap())
        .collect();
    for _ in 0..3 {
        let t = Instant::now();
        let image = renderer.render();
        println!("image {:.3}", t.elapsed().as_secs_f64());
        let t = Instant::now();
        renderer.loss_and_gradient(&scene, &Square(w), &ids);
        println!("gradient {:.3}", t.elapsed().as_secs_f64());
        std::hint::black_box(image);
    }
    let image = renderer.render();
    let mean = |x0: usize, x1: usize, y0: usize, y1: usize| {
        let mut s = DVec3::ZERO;
        for y in y0..y1 {
            for x in x0..x1 {
                s += DVec3::from(image.pixels[y * 256 + x].map(f64::from));
            }
        }
        s / ((x1 - x0) * (y1 - y0)) as f64
    };
    println!("mean {}", mean(0, 256, 0, 256));
    for (a, b, c, e) in
        [(0, 128, 0, 128), (0, 128, 128, 256), (128, 256, 0, 128), (128, 256, 128, 256)]
    {
        println!("quarter {a} {c} {}", mean(c, e, a, b));
    }
    let ids: Vec<_> =
        ["red.diffuse", "green.diffuse", "white.diffuse", "lamp.diffuse", "lamp.emission"]
            .iter()
            .map(|p| scene.parameter(&format!("material.{p}")).unwrap())
            .collect();
    let g = renderer.loss_and_gradient(&scene, &Mean(w), &ids);
    for (id, b) in g.gradient.iter() {
        println!("gradient {} {:?}", scene.path(id), b);
    }
}
