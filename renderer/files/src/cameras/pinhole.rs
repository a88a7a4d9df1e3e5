//! A camera as other programs describe it.

use glam::{DMat3, DVec3};
use renderer_core::scene::Camera;

/// Where a camera is, how it is turned, and how much it sees.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pinhole {
    /// The pinhole.
    pub position: DVec3,
    /// The directions to the right, upwards and backwards, unit vectors, as columns.
    pub axes: DMat3,
    /// Half the height of the image at distance 1.
    pub half_height: f64,
}

impl From<&Camera<f64>> for Pinhole {
    fn from(camera: &Camera<f64>) -> Self {
        let backward = (camera.look_from - camera.look_at).normalize();
        let right = camera.up.cross(backward).normalize();
        Self {
            position: camera.look_from,
            axes: DMat3::from_cols(right, backward.cross(right), backward),
            half_height: (0.5 * camera.vfov).to_radians().tan() * camera.film_scale,
        }
    }
}
