//! One pixel: what the camera sees there, and how bright it is.

use ad::vector::Vector;
use ad::{Scalar, Vec3};
use glam::DVec3;

use super::prepared::{Prepared, Primitive};
use crate::acceleration::Hit;
use crate::kernels::camera::{Ray, primary_ray};
use crate::kernels::material::{reflection_of_distant_light, reflection_of_point_light};
use crate::kernels::sphere::sphere_surface;
use crate::kernels::surface::SurfacePoint;
use crate::kernels::triangle::triangle_surface;
use crate::precision::widen;
use crate::scene::Light;

/// A loss that is a sum over pixels.
pub trait PixelLoss: Sync {
    /// What the pixel in column `x` and row `y` adds to the loss if it has this radiance, and the
    /// derivative of that by the radiance.
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3);
}

/// What the camera sees in a pixel.
pub(super) struct Sight<S: Scalar> {
    /// Position of the pixel on the image plane.
    pub film: (S, S),
    pub ray: Ray<S>,
    pub hit: Hit,
    pub surface: SurfacePoint<S>,
}

impl<S: Scalar> Prepared<'_, S> {
    /// Looks through the middle of a pixel; nothing if the camera sees nothing there.
    pub(super) fn look(&self, x: u32, y: u32) -> Option<Sight<S>> {
        let position =
            |index: u32, size: u32| (f64::from(index) + 0.5) / f64::from(size) * 2.0 - 1.0;
        let film = (
            S::from_f64(position(x, self.scene.width)),
            S::from_f64(-position(y, self.scene.height)),
        );
        let ray = primary_ray::<S>(self.frame, film.0, film.1);
        let hit = self.nearest(ray.origin, ray.direction)?;
        let surface = match self.primitive(hit.primitive) {
            Primitive::Triangle(index) => {
                let [a, b, c] = self.triangles[index].map(|v| self.vertices[v as usize]);
                triangle_surface::<S>(ray, a, b, c)
            }
            Primitive::Sphere(index) => sphere_surface::<S>(ray, self.spheres[index], hit.leaves),
        };
        Some(Sight { film, ray, hit, surface })
    }

    /// Whether a light reaches a point of a surface.
    pub(super) fn is_lit(&self, sight: &Sight<S>, light: &Light<S>) -> bool {
        let Sight { surface, hit, .. } = sight;
        let (direction, limit) = match light {
            Light::Point(light) => {
                let to_light = light.position - surface.point;
                (to_light, to_light.length().to_f64())
            }
            Light::Distant(light) => (light.direction, f64::INFINITY),
        };
        // From behind, a light brings nothing, whatever is in its way.
        if surface.normal.dot(direction).to_f64() <= 0.0 {
            return false;
        }
        let unit = direction.normalize();
        !self.is_shadowed(hit, surface.point, surface.normal, unit, limit)
    }

    /// The radiance of a pixel. `lit` receives, for each light, whether it reaches the surface.
    pub(super) fn radiance(&self, sight: &Sight<S>, lit: &mut Vec<bool>) -> DVec3 {
        let material = self.materials[self.material_of[sight.hit.primitive as usize] as usize];
        lit.clear();
        lit.extend(self.lights.iter().map(|light| self.is_lit(sight, light)));
        let reflected = self.lights.iter().zip(lit).filter(|(_, lit)| **lit).map(|(light, _)| {
            let reflected: Vec3<S> = match light {
                Light::Point(light) => {
                    reflection_of_point_light::<S>(material, sight.surface, *light)
                }
                Light::Distant(light) => {
                    reflection_of_distant_light::<S>(material, sight.surface, *light)
                }
            };
            widen::<S>(reflected)
        });
        widen::<S>(material.ambient) + reflected.sum::<DVec3>()
    }
}
