//! What a branch keeps takes the room of the arm that is taken, not of the largest.

use ad::differentiable;

use crate::taken;

#[differentiable]
fn ball(x: f64, y: f64, z: f64, place: f64) -> f64 {
    let (x, y) = (x - place, y - 0.1 * place);
    (x * x + y * y + z * z).sqrt() - 0.3
}

/// The distance to the nearest of balls, which are looked at from near alone.
#[differentiable]
fn map(x: f64, y: f64, z: f64) -> f64 {
    let mut nearest = z + 1.0;
    if x.abs() < 1.0 {
        nearest = nearest.min(ball(x, y, z, 0.1)).min(ball(x, y, z, 0.2)).min(ball(y, x, z, 0.3));
        nearest = nearest.min(ball(x, z, y, 0.4)).min(ball(z, y, x, 0.5)).min(ball(y, z, x, 0.6));
        nearest = nearest.min(ball(z, x, y, 0.7)).min(ball(x, x, z, 0.8)).min(ball(y, y, z, 0.9));
    }
    nearest
}

#[differentiable]
fn marched(x: f64, y: f64) -> f64 {
    let (mut way, mut glow) = (0.0, 0.0);
    for _ in 0..100 {
        let distance = map(x + 0.1 * way, y * way, 4.0 - 0.8 * way);
        glow += y / (1.0 + distance * distance);
        way += 0.05 * distance;
    }
    glow * way
}

pub fn arms_that_are_not_taken_take_no_room() {
    let bytes = |x: f64, y: f64| {
        let ((_, pullback), (_, bytes)) = {
            let mut kept = None;
            let counts = taken(|| kept = Some(marched::vjp(x, y)));
            (kept.expect("was just made"), counts)
        };
        let (by_x, by_y) = pullback(1.0);
        let [along_x, along_y] = [(1.0, 0.0), (0.0, 1.0)].map(|(u, v)| marched::jvp(x, y, u, v).1);
        for (by, along) in [(by_x, along_x), (by_y, along_y)] {
            assert!((by - along).abs() < 1e-9 * along.abs().max(1.0), "{by} {along}");
        }
        bytes
    };
    let (far, near) = (bytes(5.0, 0.2), bytes(0.3, 0.2));
    // Nine calls a step keep three numbers each at least.
    assert!(near > 100 * 9 * 24, "{near} bytes");
    assert!(far < 100 * 200, "{far} bytes");
}
