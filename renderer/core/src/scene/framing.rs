//! A camera and a light for a scene that came without.

use std::f64::consts::PI;

use glam::DVec3;

use super::{Camera, Light, LightObject, LightSource, Mesh, PointLight, Scene};

/// The size of the image in pixels.
const SIZE: u32 = 512;
/// The vertical field of view in degrees.
const VFOV: f64 = 45.0;
/// The direction from the object towards the camera: in front (+z), to the right and above.
const TOWARDS_CAMERA: DVec3 = DVec3::new(1.0, 0.7, 1.6);
/// The room left around the object.
const MARGIN: f64 = 1.05;
/// The radiance of a white surface that faces the light where the sphere around the object is closest
/// to it: nothing is brighter, and nothing is clipped.
const RADIANCE: f64 = 1.0;
/// How many times as far as the camera the light is: the far side is not much darker than the near one.
const LIGHT_DISTANCE: f64 = 3.0;

impl Scene {
    /// Gives the scene a camera and a light, `key`, that fit its geometry.
    ///
    /// The camera looks at the centre of the bounding box from the front, to the right of and above
    /// it, such that the sphere around all vertices fits the square image. The light stands behind and
    /// above the camera; a white surface that faces it where that sphere is closest to it is just white.
    pub fn frame(&mut self) {
        let (center, radius) = self.bounding_sphere();
        // A sphere fits a cone of this half angle when it touches the cone's side.
        let distance = MARGIN * radius / (VFOV / 2.0).to_radians().sin();
        let look_from = center + TOWARDS_CAMERA.normalize() * distance;
        self.width = SIZE;
        self.height = SIZE;
        self.camera = Camera { vfov: VFOV, ..Camera::looking(look_from, center) };

        self.light_from_camera();
    }

    /// Replaces the lights by one, `key`, behind and above the camera.
    fn light_from_camera(&mut self) {
        let (center, radius) = self.bounding_sphere();
        let distance = self.camera.look_from.distance(center).max(radius);
        let backwards = (self.camera.look_from - center).try_normalize().unwrap_or(DVec3::Z);
        let upwards = self.camera.up.try_normalize().unwrap_or(DVec3::Y);
        let towards = (backwards + 0.5 * upwards).try_normalize().unwrap_or(backwards);
        let position = center + towards * (LIGHT_DISTANCE * distance);
        let nearest = position.distance(center) - radius;
        let radiant_intensity = RADIANCE * PI * nearest.powi(2);
        let light = Light::Point(PointLight { position, color: DVec3::ONE, radiant_intensity });
        self.lights =
            vec![LightObject { name: "key".to_owned(), source: LightSource::Known(light) }];
    }

    /// Gives the framed scene another camera, whose image has `aspect_ratio` times its height as its
    /// width; it is [aimed](Self::aimed) at the objects. The light moves with the camera.
    #[doc(hidden)]
    pub fn set_camera(&mut self, camera: Camera<f64>, aspect_ratio: Option<f64>) {
        self.camera = self.aimed(camera);
        self.light_from_camera();
        if let Some(ratio) = aspect_ratio {
            self.width = ((f64::from(SIZE) * ratio).round() as u32).max(1);
        }
    }

    /// A camera whose view is a unit vector, with the point that it looks at moved along the view to the depth
    /// of the objects, so that the distance to it says something.
    #[doc(hidden)]
    pub fn aimed(&self, mut camera: Camera<f64>) -> Camera<f64> {
        let (center, _) = self.bounding_sphere();
        let forward = camera.look_at - camera.look_from;
        let depth = (center - camera.look_from).dot(forward);
        if depth > 0.0 {
            camera.look_at = camera.look_from + forward * depth;
        }
        camera
    }

    /// The centre of the bounding box, and the radius around it that holds everything.
    fn bounding_sphere(&self) -> (DVec3, f64) {
        let center = self.bounding_box().map_or(DVec3::ZERO, |(low, high)| low.midpoint(high));
        // A vertex is a sphere without extent.
        let vertices = self.meshes.iter().flat_map(Mesh::world_vertices).map(|v| (v, 0.0));
        let spheres = self.spheres.iter().map(|s| (s.values.center, s.values.radius));
        let shapes = self.shapes.iter().map(|shape| {
            let (low, high) = shape.bounds();
            (low.midpoint(high), 0.5 * low.distance(high))
        });
        let parts = vertices.chain(spheres).chain(shapes);
        let radius = parts.map(|(c, r)| c.distance(center) + r).fold(0.0, f64::max);
        // A single point has no size of its own.
        (center, if radius > 0.0 { radius } else { 1.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::SphereObject;
    use crate::scene::example::tree;
    use crate::transport::area_light::Place;

    /// Where the camera sees a point: 1 is the edge of the image.
    fn projected(camera: &Camera<f64>, point: DVec3) -> [f64; 2] {
        let forward = (camera.look_at - camera.look_from).normalize();
        let right = forward.cross(camera.up).normalize();
        let offset = point - camera.look_from;
        let half_height = camera.film_scale * (camera.vfov / 2.0).to_radians().tan();
        let scale = 1.0 / (offset.dot(forward) * half_height);
        [offset.dot(right) * scale, offset.dot(right.cross(forward)) * scale]
    }

    #[test]
    fn the_object_fills_the_image_at_every_scale() {
        for scale in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
            for shift in [0.0, -5.0] {
                let mut scene = tree();
                for value in scene.meshes[0].vertices.as_flattened_mut() {
                    *value = (*value + shift) * scale;
                }
                scene.frame();
                assert_eq!(scene.check(), Ok(()), "{scale} {shift}");
                let camera = &scene.camera;
                let vertices = scene.meshes[0].vertices.iter();
                let seen = vertices.map(|&v| projected(camera, DVec3::from_array(v)));
                let largest = seen.flatten().map(f64::abs).fold(0.0, f64::max);
                assert!((0.6..1.0).contains(&largest), "{scale} {shift}: {largest}");

                let LightSource::Known(Light::Point(light)) = &scene.lights[0].source else {
                    panic!("a point light");
                };
                let white = |point: DVec3| {
                    light.radiant_intensity / (PI * light.position.distance_squared(point))
                };
                let vertices = scene.meshes[0].vertices.iter();
                let brightest = vertices.map(|&v| white(v.into())).fold(0.0, f64::max);
                assert!(brightest <= 1.0, "{brightest}");
                assert!(white(camera.look_at) > 0.7);
                assert!(light.position.y > camera.look_from.y);
            }
        }
    }

    /// The side that the camera sees is the one that is lit.
    #[test]
    fn flat_meshes_are_lit_from_the_side_that_is_seen() {
        for normal in DVec3::AXES {
            let mut scene = tree();
            for vertex in &mut scene.meshes[0].vertices {
                *vertex = DVec3::from(*vertex).reject_from(normal).to_array();
            }
            scene.frame();
            let LightSource::Known(light) = &scene.lights[0].source else { panic!("a light") };
            let towards_light = light.position(Place::POINT).unwrap() - scene.camera.look_at;
            let towards_camera = scene.camera.look_from - scene.camera.look_at;
            let sides = towards_light.dot(normal) * towards_camera.dot(normal);
            assert!(sides > 0.0, "{normal}: {towards_light} {towards_camera}");
        }
    }

    #[test]
    fn a_single_point_and_spheres_are_framed() {
        let mut scene = tree();
        scene.meshes[0].vertices.fill([3.0, 3.0, 3.0]);
        scene.frame();
        assert_eq!(scene.check(), Ok(()));
        assert_eq!(scene.camera.look_at, DVec3::splat(3.0));

        scene.meshes[0].vertices.fill([0.0; 3]);
        scene.add_sphere(SphereObject::new("ball", DVec3::X, 3.0)).unwrap();
        scene.frame();
        assert_eq!(scene.camera.look_at, DVec3::X);
        let top = projected(&scene.camera, DVec3::new(1.0, 3.0, 0.0));
        assert!(top[1] > 0.5 && top[1] < 1.0, "{top:?}");
    }
}
