//! Cameras at their ends.

use crate::kernels::PrimaryRay;
use crate::oracle::{Case, check};

struct View {
    look_from: [f64; 3],
    look_at: [f64; 3],
    up: [f64; 3],
    vfov: f64,
}

const ORDINARY: View =
    View { look_from: [0.5, 1.5, 4.0], look_at: [0.0, 0.25, 0.0], up: [0.125, 1.0, 0.0], vfov: 45.0 };

impl View {
    #[track_caller]
    fn check(self, name: &str, length: f64, value: f64, gradient: f64) {
        let Self { look_from, look_at, up, vfov } = self;
        let numbers = [&look_from[..], &look_at, &up, &[vfov, 1.0, 0.625, -0.375]].concat();
        let x: Vec<f64> = numbers.into_iter().map(|x| f64::from(x as f32)).collect();
        let angle = vfov.min(180.0 - vfov);
        check::<PrimaryRay>(&Case {
            name,
            x: &x,
            lengths: &[length, length, length, 0.1 * angle, 0.1 * angle / vfov, 0.1 * angle / vfov],
            value,
            gradient,
        });
    }
}

#[test]
fn fields_of_view() {
    for vfov in [1e-3, 1.0, 90.0, 179.0, 179.99] {
        let view = View { vfov, ..ORDINARY };
        view.check(&format!("field of view {vfov} degrees"), 0.01, 10.0, 10.0 + 1e3 / (180.0 - vfov));
    }
}

#[test]
fn places_and_directions() {
    for distance in [1e-3, 1e-6] {
        let view = View { look_from: [0.0, 0.25, distance], ..ORDINARY };
        view.check(&format!("look_at {distance:e} from look_from"), 0.1 * distance, 10.0, 20.0);
        let up = [-0.5 + distance, -1.25, -4.0];
        let view = View { up, ..ORDINARY };
        view.check(&format!("up {distance:e} from the view"), 0.1 * distance, 0.1 / distance, 0.5 / distance);
    }
}
