//! The kernels of the renderer on other scalars: the gradient by forward mode and on a tape.
//!
//! What pixels show is taken from the renderer once ([`paths`]) and stays; the kernels are evaluated
//! along these paths pixel by pixel. That gives the interior term, as the
//! generated adjoint does, by code that shares nothing with it but the kernels themselves.

use ad::tape::{Recording, Var};
use ad::vector::{Vector, Vector3};
use ad::{Dual, Real, Scalar, Vec3};
use glam::DVec3;
use rayon::prelude::*;

use super::numbers::{Number, Numbers};
use crate::arithmetic::Precision;
use crate::integrator::{Crossing, Path, PixelLoss, Reached, Texture};
use crate::kernels::camera::{Frame, Ray, frame, primary_ray};
use crate::kernels::light::{ray_along, ray_to_position};
use crate::kernels::material::{Material, reflection_of_distant_light, reflection_of_point_light};
use crate::kernels::sphere::sphere_surface;
use crate::kernels::surface::{SurfacePoint, mirrored_ray, straight_ray};
use crate::kernels::texture::{
    Uv, bilinear, sphere_uv, texel_position, triangle_uv, varied_opacity,
};
use crate::kernels::triangle::triangle_surface;
use crate::scene::{Light, ParameterId, Scene};

/// A loss of the image along paths that stay. The scene has no shapes and lights of a user's own.
pub(super) struct Replay<'a, P> {
    pub scene: &'a Scene,
    /// What the derivatives are by.
    pub ids: &'a [ParameterId],
    pub paths: &'a [Path],
    pub loss: &'a P,
}

/// What a triangle or a sphere of the scene is.
enum Primitive {
    Triangle { mesh: usize, triangle: usize },
    Sphere(usize),
}

impl<P: PixelLoss> Replay<'_, P> {
    /// The derivatives by the numbers with these indices, by dual numbers of the scalar `S`: all
    /// paths once for each. What paths bring is added up in the precision given.
    pub fn by_forward_mode<S: Scalar>(&self, elements: &[usize], sums: Precision) -> Vec<f64> {
        let along = |&direction: &usize| {
            let pixels = self.paths.par_chunks(CHUNK).map(|paths| {
                let mut index = 0;
                let numbers = self.numbers(|value| {
                    let derivative = f64::from(u8::from(index == direction));
                    index += 1;
                    Dual::new(S::from_f64(value), S::from_f64(derivative))
                });
                let terms = self.linear_loss(&numbers, paths);
                sum(terms.map(|term| term.derivative.to_f64()), sums)
            });
            sum(pixels.collect::<Vec<f64>>().into_iter(), sums)
        };
        elements.iter().map(along).collect()
    }

    /// On tapes: one for each `chunk` of pixels.
    pub fn by_tape(&self, chunk: usize) -> Vec<f64> {
        let chunks = self.paths.par_chunks(chunk).map(|paths| {
            let recording = Recording::start();
            let numbers = self.numbers(|value| recording.variable(value));
            let loss = self.linear_loss(&numbers, paths).fold(Var::ZERO, |sum, term| sum + term);
            let cotangents = recording.cotangents(loss);
            let variables = numbers.varying.iter().flat_map(|(_, block)| block);
            variables.map(|&variable| cotangents.by(variable)).collect::<Vec<f64>>()
        });
        let mut total = Vec::new();
        for gradient in chunks.collect::<Vec<_>>() {
            total.resize(gradient.len(), 0.0);
            total.iter_mut().zip(gradient).for_each(|(total, part)| *total += part);
        }
        total
    }

    fn numbers<S>(&self, mut variable: impl FnMut(f64) -> S) -> Numbers<'_, S> {
        let parameters = &self.scene.parameters;
        let block = |&id: &ParameterId| {
            (id, parameters.get(id).iter().map(|&value| variable(value)).collect())
        };
        Numbers { parameters, varying: self.ids.iter().map(block).collect() }
    }

    /// By path, the radiance times the derivative of the loss by it: the derivatives of their sum are
    /// those of the loss.
    fn linear_loss<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        paths: &[Path],
    ) -> impl Iterator<Item = S> {
        let aspect = f64::from(self.scene.width) / f64::from(self.scene.height);
        let frame = frame::<S>(numbers.camera(), S::from_f64(aspect));
        paths.iter().map(move |path| {
            let radiance = self.radiance(numbers, frame, path);
            let [x, y, z] = [radiance.x(), radiance.y(), radiance.z()].map(Number::number);
            let (_, derivative) = self.loss.evaluate(path.x, path.y, DVec3::new(x, y, z));
            let [x, y, z] = derivative.to_array().map(S::from_f64);
            radiance.dot(Vector3::new(x, y, z))
        })
    }

    fn radiance<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        frame: Frame<S>,
        path: &Path,
    ) -> Vec3<S> {
        let place = |index: u32, count: u32| f64::from(2 * index + 1) / f64::from(count) - 1.0;
        let x = S::from_f64(place(path.x, self.scene.width));
        let y = S::from_f64(-place(path.y, self.scene.height));
        let mut ray = primary_ray::<S>(frame, x, y);
        let mut total = Vec3::<S>::splat(S::ZERO);
        // What the mirrors and the transparent surfaces so far leave of the radiance.
        let mut left = Vec3::<S>::splat(S::ONE);
        for meeting in &path.meetings {
            let primitive = self.primitive(meeting.primitive);
            let surface = self.surface(numbers, &primitive, ray, meeting.leaves);
            let index = self.material_index(&primitive);
            let material = self.material(numbers, &primitive, index, surface.point);
            let mut radiance = material.ambient;
            for Reached { light, crossed } in &meeting.lit {
                let light = numbers.light(*light);
                let left =
                    |&crossing: &Crossing| self.left(numbers, &light, surface.point, crossing);
                let passed =
                    crossed.iter().map(left).fold(S::ONE, |product, factor| product * factor);
                let reflected = match light {
                    Light::Point(light) => reflection_of_point_light::<S>(material, surface, light),
                    Light::Distant(light) => {
                        reflection_of_distant_light::<S>(material, surface, light)
                    }
                };
                radiance = radiance + reflected * passed;
            }
            match self.scene.materials[index].opacity {
                None => {
                    total = total + left * radiance;
                    left = left * material.reflection;
                    ray = mirrored_ray::<S>(surface);
                }
                Some(opacity) => {
                    let plain = numbers.opacity(opacity as usize);
                    let opacity = self.opacity(numbers, &primitive, index, plain, surface.point);
                    total = total + left * radiance * opacity;
                    left = left * (S::ONE - opacity);
                    ray = straight_ray::<S>(surface);
                }
            }
        }
        total
    }

    fn primitive(&self, index: usize) -> Primitive {
        let mut triangle = index;
        for (mesh, object) in self.scene.meshes.iter().enumerate() {
            match triangle.checked_sub(object.triangles.len()) {
                None => return Primitive::Triangle { mesh, triangle },
                Some(rest) => triangle = rest,
            }
        }
        Primitive::Sphere(triangle)
    }

    fn surface<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        primitive: &Primitive,
        ray: Ray<S>,
        leaves: bool,
    ) -> SurfacePoint<S> {
        match *primitive {
            Primitive::Triangle { mesh, triangle } => {
                let corners = self.scene.meshes[mesh].triangles[triangle];
                let [a, b, c] = corners.map(|corner| numbers.vertex(mesh, corner));
                triangle_surface::<S>(ray, a, b, c)
            }
            Primitive::Sphere(sphere) => {
                sphere_surface::<S>(ray, numbers.sphere(sphere), ad::Mask::splat(leaves))
            }
        }
    }

    fn material_index(&self, primitive: &Primitive) -> usize {
        let material = match *primitive {
            Primitive::Triangle { mesh, triangle } => self.scene.meshes[mesh].materials[triangle],
            Primitive::Sphere(sphere) => self.scene.spheres[sphere].material,
        };
        material as usize
    }

    /// The material of an index at a point, with its textures.
    fn material<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        primitive: &Primitive,
        index: usize,
        point: Vec3<S>,
    ) -> Material<S> {
        let mut material = numbers.material(index);
        let textures = self.scene.materials[index].textures;
        if !textures.any() {
            return material;
        }
        let uv = self.uv(numbers, primitive, point);
        for (texture, color) in [
            (textures.ambient, &mut material.ambient),
            (textures.diffuse, &mut material.diffuse),
            (textures.specular, &mut material.specular),
        ] {
            if let Some(texture) = texture {
                *color = *color * self.texture(numbers, texture as usize, uv);
            }
        }
        material
    }

    /// What a transparent surface leaves of the light that goes through it to a point.
    fn left<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        light: &Light<S>,
        lit: Vec3<S>,
        crossing: Crossing,
    ) -> S {
        let primitive = self.primitive(crossing.primitive);
        let index = self.material_index(&primitive);
        let Some(opacity) = self.scene.materials[index].opacity else { return S::ZERO };
        let to_light = match light {
            Light::Point(light) => ray_to_position::<S>(light.position, lit),
            Light::Distant(light) => ray_along::<S>(light.direction, lit),
        };
        let point = self.surface(numbers, &primitive, to_light, crossing.leaves).point;
        let plain = numbers.opacity(opacity as usize);
        S::ONE - self.opacity(numbers, &primitive, index, plain, point)
    }

    /// The opacity `plain` of the material of an index, at a point, with its texture.
    fn opacity<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        primitive: &Primitive,
        index: usize,
        plain: S,
        point: Vec3<S>,
    ) -> S {
        match self.scene.materials[index].textures.opacity {
            None => plain,
            Some(texture) => {
                let uv = self.uv(numbers, primitive, point);
                varied_opacity::<S>(plain, self.texture(numbers, texture as usize, uv))
            }
        }
    }

    fn uv<S: Number>(
        &self,
        numbers: &Numbers<'_, S>,
        primitive: &Primitive,
        point: Vec3<S>,
    ) -> Uv<S> {
        match *primitive {
            Primitive::Sphere(sphere) => sphere_uv::<S>(point, numbers.sphere(sphere)),
            Primitive::Triangle { mesh, triangle } => {
                let object = &self.scene.meshes[mesh];
                let [a, b, c] = object.triangles[triangle].map(|c| numbers.vertex(mesh, c));
                let places = match object.texture_triangles.get(triangle).copied().flatten() {
                    Some(corners) => corners.map(|corner| numbers.uv(mesh, corner)),
                    None => [Uv { u: S::ZERO, v: S::ZERO }; 3],
                };
                triangle_uv::<S>(point, a, b, c, places)
            }
        }
    }

    fn texture<S: Number>(&self, numbers: &Numbers<'_, S>, texture: usize, uv: Uv<S>) -> Vec3<S> {
        let object = &self.scene.textures[texture];
        let placed = Texture {
            first_texel: 0,
            width: object.width,
            height: object.height,
            wrap: object.wrap,
        };
        let (width, height) = (object.width.into(), object.height.into());
        let (width, height) = (S::from_f64(width), S::from_f64(height));
        let (x, y) = texel_position::<S>(uv, width, height);
        let texels = placed.around(x.number(), y.number());
        let texels = texels.map(|texel| numbers.texel(texture, texel));
        bilinear::<S>(texels, uv, width, height)
    }
}

/// A sum, one number after the other.
fn sum(terms: impl Iterator<Item = f64>, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => terms.sum(),
        Precision::F32 => terms.fold(0.0_f32, |sum, term| sum + term as f32).into(),
    }
}

/// So many pixels follow each other on one thread in forward mode.
const CHUNK: usize = 256;
