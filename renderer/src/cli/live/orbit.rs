//! A camera that goes around the scene.

use glam::DVec3;

use crate::scene::{Camera, Scene};

/// How close to the poles it comes, in degrees of latitude.
const HIGHEST: f64 = 89.0;
/// How much closer and farther it goes than it begins.
const NEAREST: f64 = 0.02;
const FARTHEST: f64 = 50.0;

/// Where the camera is, as turns from where the scene has it.
#[derive(Clone, Copy)]
pub(super) struct Orbit {
    /// To the right around the vertical axis, and upwards, in degrees.
    pub turn: f64,
    pub rise: f64,
    /// The distance over the one that it begins at.
    pub distance: f64,
}

impl Orbit {
    /// The camera. It goes around the mean of the points that the cameras of the scene look at, which is what
    /// somebody has found worth a look: the middle of all objects is often that of a large floor.
    pub fn camera(self, scene: &Scene) -> Camera<f64> {
        let cameras: Vec<&Camera<f64>> = match scene.views() {
            [] => vec![&scene.camera],
            views => views.iter().map(|view| &view.camera).collect(),
        };
        let center =
            cameras.iter().map(|camera| camera.look_at).sum::<DVec3>() / cameras.len() as f64;
        let first = *cameras[0];
        let up = first.up.try_normalize().unwrap_or(DVec3::Y);
        let back = first.look_from - center;
        let level = back.reject_from_normalized(up);
        let level = level.try_normalize().unwrap_or(up.any_orthonormal_vector());
        let latitude = back.dot(up).atan2(back.dot(level)).to_degrees() + self.rise;
        let (sine, cosine) = latitude.clamp(-HIGHEST, HIGHEST).to_radians().sin_cos();
        let (turn_sine, turn_cosine) = self.turn.to_radians().sin_cos();
        let level = level * turn_cosine + up.cross(level) * turn_sine;
        let direction = level * cosine + up * sine;
        let distance = back.length() * self.distance.clamp(NEAREST, FARTHEST);
        Camera { look_from: center + direction * distance, look_at: center, up, ..first }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let look_from = DVec3::new(3.0, 4.0, 0.0);
        Scene::new(8, 8, Camera::looking(look_from, DVec3::new(0.0, 1.0, 0.0)))
    }

    fn from(turn: f64, rise: f64, distance: f64) -> DVec3 {
        Orbit { turn, rise, distance }.camera(&scene()).look_from
    }

    #[test]
    fn it_begins_at_the_camera_and_goes_around() {
        let near = |a: DVec3, x, y, z| assert!(a.distance(DVec3::new(x, y, z)) < 1e-12, "{a}");
        near(from(0.0, 0.0, 1.0), 3.0, 4.0, 0.0);
        near(from(90.0, 0.0, 1.0), 0.0, 4.0, -3.0);
        near(from(360.0, -45.0, 2.0), 2.0 * 18_f64.sqrt(), 1.0, 0.0);
        near(from(180.0, 0.0, 1.0), -3.0, 4.0, 0.0);
    }

    #[test]
    fn it_stays_off_the_poles_and_at_a_distance() {
        for (rise, distance) in [(1e9, 0.0), (-1e9, 1e300), (0.0, -5.0)] {
            let camera = Orbit { turn: 1e9, rise, distance }.camera(&scene());
            let offset = camera.look_from - camera.look_at;
            assert!(offset.is_finite() && offset.length() > 0.01 && offset.length() < 1e3);
            assert!(offset.normalize().cross(DVec3::Y).length() > 0.01);
        }
    }
}
