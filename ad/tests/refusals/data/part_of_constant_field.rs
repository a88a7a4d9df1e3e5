use ad::{Differentiable, differentiable};
use glam::DVec3;

#[derive(Clone, Copy, Differentiable)]
struct Camera {
    #[constant]
    up: DVec3,
    zoom: f64,
}

#[differentiable]
fn f(camera: Camera) -> f64 {
    camera.up.x * camera.zoom
}

fn main() {
    f::grad(Camera { up: DVec3::Y, zoom: 1.0 });
}
