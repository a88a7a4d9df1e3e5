//! The gradient of a loss by every parameter.

use std::mem;

use ad::lanes::Lanes;
use ad::{Additive, Mask, Tangent, Vec3};
use glam::DVec3;

use super::prepared::Prepared;
use super::radiance::{PixelLoss, black_pixels};
use super::shade::{LightCotangent, Pulled, Shaded};
use super::shadows::Lit;
use super::sums::{Slots, StripSums};
use super::tiles::{Strip, Tile, for_each_strip};
use super::view::{Group, Shape, View};
use crate::kernels::camera::{Camera, Frame, Ray, frame, primary_ray};
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::{Sphere, sphere_surface};
use crate::kernels::surface::SurfacePoint;
use crate::kernels::triangle::triangle_surface;
use crate::precision::{MOST_LANES, lanes_of_vectors, sum_of_vectors, vectors_of_lanes};
use crate::scene::{Light, ParameterId, Parameters};

/// The kinds of parameters by which a gradient is wanted. Others cost nothing and stay zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted {
    /// Camera parameters.
    pub camera: bool,
    /// Light parameters.
    pub lights: bool,
    /// Material parameters.
    pub materials: bool,
    /// Sphere parameters.
    pub spheres: bool,
    /// Vertices.
    pub vertices: bool,
}

impl Wanted {
    /// The kinds that the given parameters are of.
    pub fn by(ids: &[ParameterId]) -> Self {
        use ParameterId::*;
        let mut wanted = Self::default();
        for id in ids {
            *match id {
                LookFrom | LookAt | Up | Vfov | Focus => &mut wanted.camera,
                LightPosition(_) | LightDirection(_) | LightColor(_) | LightIntensity(_) => {
                    &mut wanted.lights
                }
                Ambient(_) | Diffuse(_) | Specular(_) | Exponent(_) => &mut wanted.materials,
                SphereCenter(_) | SphereRadius(_) => &mut wanted.spheres,
                Vertices(_) => &mut wanted.vertices,
            } = true;
        }
        wanted
    }

    /// Whether the point that is seen depends on any of them.
    fn surface(self) -> bool {
        self.camera || self.spheres || self.vertices
    }
}

/// A loss and its gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct GradientResult {
    /// The loss.
    pub loss: f64,
    /// Its derivative by each parameter; the shape is that of the scene's parameters. For parameters
    /// that move edges it is the interior term, see
    /// [`Differentiability`](crate::scene::Differentiability).
    pub gradient: Parameters,
}

/// The loss of the image and its gradient by the wanted parameters.
pub fn gradient<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted,
) -> GradientResult {
    reduce(prepared, sweep(prepared, loss, wanted), wanted)
}

/// What the strips of the image add up to, each by itself.
pub(crate) fn sweep<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted,
) -> Vec<StripSums> {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let start = || Sweep::new(prepared, loss, wanted);
    for_each_strip(width, height, start, Sweep::strip)
}

/// Puts strips together, always in the same order.
pub(crate) fn reduce<L: Lanes>(
    prepared: &Prepared<'_, L>,
    strips: Vec<StripSums>,
    wanted: Wanted,
) -> GradientResult {
    let mut total = GradientResult { loss: 0.0, gradient: zero(&prepared.parameters) };
    let mut frame = Tangent::<Frame<f64>>::zero();
    let gradient = &mut total.gradient;
    for strip in strips {
        total.loss += strip.loss;
        frame.accumulate(strip.frame);
        for (light, sum) in gradient.lights.iter_mut().zip(&strip.lights) {
            sum.add_to(light);
        }
        for (material, sum) in &strip.materials {
            gradient.materials[*material as usize].add(sum);
        }
        for (sphere, sum) in &strip.spheres {
            gradient.spheres[*sphere as usize].add(sum);
        }
        for (vertex, sum) in strip.vertices {
            let (mesh, vertex) = prepared.vertex_of_mesh(vertex);
            let vertex = &mut gradient.vertices[mesh][vertex];
            *vertex = (DVec3::from(*vertex) + sum).into();
        }
    }
    if wanted.camera {
        let (_, pullback) = frame::vjp::<f64>(prepared.parameters.camera, prepared.aspect());
        gradient.camera.add(&pullback(frame).0);
    }
    total
}

/// Zero, in the shape of `parameters`.
fn zero(parameters: &Parameters) -> Parameters {
    let zero_light = |light: &Light<f64>| match light {
        Light::Point(_) => Light::Point(PointLight::zero()),
        Light::Distant(_) => Light::Distant(DistantLight::zero()),
    };
    Parameters {
        camera: Camera::zero(),
        lights: parameters.lights.iter().map(zero_light).collect(),
        materials: vec![Material::zero(); parameters.materials.len()],
        spheres: vec![Sphere::zero(); parameters.spheres.len()],
        vertices: parameters.vertices.iter().map(|mesh| vec![[0.0; 3]; mesh.len()]).collect(),
    }
}

/// The work on strips that follow each other on a thread.
struct Sweep<'a, L: Lanes, P> {
    prepared: &'a Prepared<'a, L>,
    loss: &'a P,
    wanted: Wanted,
    view: View<L>,
    sums: StripSums,
    materials: Slots,
    spheres: Slots,
    vertices: Slots,
}

impl<'a, L: Lanes, P: PixelLoss> Sweep<'a, L, P> {
    fn new(prepared: &'a Prepared<'a, L>, loss: &'a P, wanted: Wanted) -> Self {
        let slots = |wanted: bool, count: usize| Slots::new(if wanted { count } else { 0 });
        Self {
            prepared,
            loss,
            wanted,
            view: View::default(),
            sums: StripSums::zero(&prepared.lights),
            materials: slots(wanted.materials, prepared.materials.len()),
            spheres: slots(wanted.spheres, prepared.spheres.len()),
            vertices: slots(wanted.vertices, prepared.vertices.len()),
        }
    }

    fn strip(&mut self, strip: Strip) -> StripSums {
        for tile in strip.tiles() {
            self.add_tile(&tile);
        }
        mem::replace(&mut self.sums, StripSums::zero(&self.prepared.lights))
    }

    fn add_tile(&mut self, tile: &Tile) {
        let mut view = mem::take(&mut self.view);
        self.prepared.look(tile, &mut view);
        self.prepared.light_up(&mut view);
        self.sums.loss += black_pixels(tile, view.missed, self.loss);
        let mut to_frame = Tangent::<Frame<L>>::zero();
        for group in &view.groups {
            self.add_group(tile, group, &view.lit, &mut to_frame);
        }
        if self.wanted.camera {
            self.sums.frame.accumulate(to_frame.sum(Mask::splat(true)));
        }
        self.view = view;
    }

    #[inline]
    fn add_group(
        &mut self,
        tile: &Tile,
        group: &Group<L>,
        lit: &[Lit],
        to_frame: &mut Tangent<Frame<L>>,
    ) {
        let Self { prepared, wanted, sums, .. } = self;
        let respond = |radiance| {
            let (loss, cotangent) = respond(self.loss, tile, group, radiance);
            sums.loss += loss;
            cotangent
        };
        let to_light = |light: usize, cotangent: LightCotangent<L>| {
            if wanted.lights {
                sums.lights[light].add(&cotangent);
            }
        };
        let materials = prepared.materials(group);
        let shaded = Shaded::new(prepared, group, &materials, lit);
        let pulled = shaded.pull_back(respond, to_light);
        let Some(Pulled { material, surface }) = pulled else { return };
        if wanted.materials {
            for (index, lanes) in materials.iter() {
                let sum = material.sum(L::mask_from_bits(lanes));
                self.materials.add(&mut sums.materials, index, sum);
            }
        }
        if wanted.surface() {
            let to_ray = self.pull_surface(group, surface);
            if self.wanted.camera {
                let (x, y) = group.film;
                let (_, pullback) = primary_ray::vjp::<L>(self.prepared.frame, x, y);
                to_frame.accumulate(pullback(to_ray).0);
            }
        }
    }

    /// Pulls the cotangent of surface points back to primitives; returns that of the rays.
    #[inline]
    fn pull_surface(
        &mut self,
        group: &Group<L>,
        cotangent: Tangent<SurfacePoint<L>>,
    ) -> Tangent<Ray<L>> {
        let Self { prepared, wanted, sums, .. } = self;
        match group.shape {
            Shape::Triangles => {
                let [a, b, c] = prepared.corners(&group.primitives);
                let (_, pullback) = triangle_surface::vjp::<L>(group.ray, a, b, c);
                let (ray, a, b, c) = pullback(cotangent);
                if wanted.vertices {
                    for (triangle, lanes) in group.primitives.iter() {
                        let mask = L::mask_from_bits(lanes);
                        for (&vertex, corner) in prepared.triangles[triangle].iter().zip([a, b, c])
                        {
                            let sum = sum_of_vectors::<L>(corner, mask);
                            self.vertices.add(&mut sums.vertices, vertex as usize, sum);
                        }
                    }
                }
                ray
            }
            Shape::Spheres(leaves) => {
                let spheres = prepared.spheres(&group.primitives);
                let (_, pullback) = sphere_surface::vjp::<L>(group.ray, spheres, leaves);
                let (ray, sphere, ()) = pullback(cotangent);
                if wanted.spheres {
                    for (primitive, lanes) in group.primitives.iter() {
                        let sum = sphere.sum(L::mask_from_bits(lanes));
                        let index = prepared.sphere_of(primitive);
                        self.spheres.add(&mut sums.spheres, index, sum);
                    }
                }
                ray
            }
        }
    }
}

/// The loss of the pixels of a group, and the cotangent of their radiance, unless it is zero: what
/// the loss does not care about has no gradient.
#[inline]
fn respond<L: Lanes>(
    loss: &impl PixelLoss,
    tile: &Tile,
    group: &Group<L>,
    radiance: Vec3<L>,
) -> (f64, Option<Vec3<L>>) {
    let radiance = vectors_of_lanes::<L>(radiance);
    let mut sum = 0.0;
    // The lanes that do not count keep a cotangent of zero.
    let mut cotangents = [DVec3::ZERO; MOST_LANES];
    for (lane, ray) in group.rays() {
        let (x, y) = tile.pixel(ray);
        let (value, derivative) = loss.evaluate(x, y, radiance[lane]);
        sum += value;
        cotangents[lane] = derivative;
    }
    let matters = cotangents.iter().any(|&cotangent| cotangent != DVec3::ZERO);
    (sum, matters.then(|| lanes_of_vectors::<L>(&cotangents)))
}
