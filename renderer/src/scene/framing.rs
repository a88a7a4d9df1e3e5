//! A camera and a light for a scene that came without.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Light, Scene};
use crate::kernels::camera::Camera;
use crate::kernels::light::PointLight;

/// The size of the image in pixels.
const SIZE: u32 = 512;
/// The vertical field of view in degrees.
const VFOV: f64 = 45.0;
/// From the object towards the camera: in front (+z), to the right and above.
const TOWARDS_CAMERA: DVec3 = DVec3::new(1.0, 0.7, 1.6);
/// The room left around the object.
const MARGIN: f64 = 1.05;
/// The irradiance at the centre of the object.
const IRRADIANCE: f64 = 1.5;

impl Scene {
    /// Gives the scene a camera and a light, `key`, that fit its vertices and spheres.
    ///
    /// The camera looks at the centre of the bounding box from the front, to the right of and above
    /// it, such that the sphere around all vertices fits the square image. The light stands above
    /// the camera; a surface at the centre that faces it receives an irradiance of 1.5.
    pub(crate) fn frame(&mut self) {
        let (center, radius) = self.bounding_sphere();
        // A sphere fits a cone of this half angle when it touches the cone's side.
        let distance = MARGIN * radius / (VFOV / 2.0).to_radians().sin();
        let look_from = center + TOWARDS_CAMERA.normalize() * distance;
        self.width = SIZE;
        self.height = SIZE;
        self.parameters.camera =
            Camera { look_from, look_at: center, up: DVec3::Y, vfov: VFOV, focus: 1.0 };

        let position = look_from + DVec3::Y * (0.5 * distance);
        let intensity = IRRADIANCE * 4.0 * PI * position.distance_squared(center);
        self.light_names = vec!["key".to_owned()];
        self.parameters.lights =
            vec![Light::Point(PointLight { position, color: DVec3::ONE, intensity })];
    }

    /// The centre of the bounding box, and the radius around it that holds everything.
    fn bounding_sphere(&self) -> (DVec3, f64) {
        let vertices = self.parameters.vertices.as_slice().concat();
        let spheres = &self.parameters.spheres;
        // A vertex is a sphere without extent.
        let parts = || {
            let vertices = vertices.iter().map(|&v| (DVec3::from_array(v), 0.0));
            vertices.chain(spheres.iter().map(|s| (s.center, s.radius)))
        };
        let low = parts().map(|(c, r)| c - r).reduce(DVec3::min).unwrap_or(DVec3::ZERO);
        let high = parts().map(|(c, r)| c + r).reduce(DVec3::max).unwrap_or(DVec3::ZERO);
        let center = low.midpoint(high);
        let radius = parts().map(|(c, r)| c.distance(center) + r).fold(0.0, f64::max);
        // A single point has no size of its own.
        (center, if radius > 0.0 { radius } else { 1.0 })
    }
}
