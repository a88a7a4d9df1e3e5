//! The gradient of a loss by every parameter.

use ad::lanes::Lanes;
use ad::{Additive, Tangent, Vec3};
use glam::DVec3;

use super::prepared::Prepared;
use super::radiance::PixelLoss;
use super::shade::{LightCotangent, pull_back, radiance};
use super::shadows::Lit;
use super::tiles::{Tile, for_each_tile};
use super::view::{Group, GroupShape, Seen};
use crate::kernels::camera::{Camera, Frame, Ray, frame, primary_ray};
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::{Sphere, sphere_surface};
use crate::kernels::surface::SurfacePoint;
use crate::kernels::triangle::triangle_surface;
use crate::precision::{MOST_LANES, lanes_of_vectors, narrow, vectors_of_lanes};
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
    let tiles = for_each_tile(prepared.scene.width, prepared.scene.height, |tile| {
        let mut sums = TileSums::new(prepared);
        sums.add_tile(prepared, loss, wanted, &tile);
        sums
    });

    // Put the tiles together, always in the same order.
    let mut total = TileSums::new(prepared);
    let mut vertices = zero_vertices(&prepared.parameters);
    let mut flat: Vec<&mut [f64; 3]> = vertices.iter_mut().flatten().collect();
    for tile in &tiles {
        total.merge(tile);
        for &(vertex, cotangent) in &tile.vertices {
            let sum = &mut flat[vertex as usize];
            **sum = (DVec3::from(**sum) + cotangent).into();
        }
    }

    let camera = match wanted.camera {
        true => camera_gradient(&prepared.parameters.camera, prepared.aspect(), &total.frame),
        false => Camera::zero(),
    };
    let TileSums { loss, lights, materials, spheres, .. } = total;
    GradientResult { loss, gradient: Parameters { camera, lights, materials, spheres, vertices } }
}

fn camera_gradient(camera: &Camera<f64>, aspect: f64, cotangent: &Frame<f64>) -> Camera<f64> {
    let (_, pullback) = frame::vjp::<f64>(*camera, aspect);
    let Frame { origin, forward, right, up } = *cotangent;
    let (cotangent, _) = pullback(Tangent::<Frame<f64>> { origin, forward, right, up });
    let mut gradient = Camera::zero();
    gradient.add(&cotangent);
    gradient
}

fn zero_vertices(parameters: &Parameters) -> Vec<Vec<[f64; 3]>> {
    parameters.vertices.iter().map(|vertices| vec![[0.0; 3]; vertices.len()]).collect()
}

/// What the pixels of a tile add up to, in double precision.
struct TileSums {
    loss: f64,
    frame: Frame<f64>,
    lights: Vec<Light<f64>>,
    materials: Vec<Material<f64>>,
    spheres: Vec<Sphere<f64>>,
    /// Contributions to vertices, counted through all meshes, in the order of the pixels.
    vertices: Vec<(u32, DVec3)>,
}

impl TileSums {
    fn new<L: Lanes>(prepared: &Prepared<'_, L>) -> Self {
        let zero_light = |light: &Light<f64>| match light {
            Light::Point(_) => Light::Point(PointLight::zero()),
            Light::Distant(_) => Light::Distant(DistantLight::zero()),
        };
        Self {
            loss: 0.0,
            frame: Frame::zero(),
            lights: prepared.lights.iter().map(zero_light).collect(),
            materials: vec![Material::zero(); prepared.materials.len()],
            spheres: vec![Sphere::zero(); prepared.spheres.len()],
            vertices: Vec::new(),
        }
    }

    fn merge(&mut self, other: &Self) {
        self.loss += other.loss;
        self.frame.merge(&other.frame);
        for (mine, theirs) in self.lights.iter_mut().zip(&other.lights) {
            match (mine, theirs) {
                (Light::Point(mine), Light::Point(theirs)) => mine.merge(theirs),
                (Light::Distant(mine), Light::Distant(theirs)) => mine.merge(theirs),
                _ => unreachable!("tiles of one scene have the same lights"),
            }
        }
        for (mine, theirs) in self.materials.iter_mut().zip(&other.materials) {
            mine.merge(theirs);
        }
        for (mine, theirs) in self.spheres.iter_mut().zip(&other.spheres) {
            mine.merge(theirs);
        }
    }

    fn add_tile<L: Lanes>(
        &mut self,
        prepared: &Prepared<'_, L>,
        loss: &impl PixelLoss,
        wanted: Wanted,
        tile: &Tile,
    ) {
        let view = prepared.view(tile);
        for &(x, y) in &view.missed {
            self.loss += loss.evaluate(x, y, DVec3::ZERO).0;
        }
        let frame = prepared.frame.narrow::<L>();
        let mut frame_cotangent = Tangent::<Frame<L>>::zero();
        let groups = prepared.groups(&view);
        let lit = prepared.lit(&view, &groups);
        for group in &groups {
            let seen = &view.seen[group.pixels.clone()];
            let radiance = vectors_of_lanes::<L>(radiance(group, &prepared.lights, &lit));

            // The lanes beyond the last pixel keep a cotangent of zero.
            let mut cotangents = [DVec3::ZERO; MOST_LANES];
            for ((pixel, radiance), cotangent) in seen.iter().zip(radiance).zip(&mut cotangents) {
                let (pixel_loss, derivative) = loss.evaluate(pixel.x, pixel.y, radiance);
                self.loss += pixel_loss;
                *cotangent = derivative;
            }
            // Pixels that the loss does not care about have no gradient.
            if cotangents.iter().any(|cotangent| *cotangent != DVec3::ZERO) {
                let cotangent =
                    lanes_of_vectors::<L>(|lane| narrow::<L::Element>(cotangents[lane]));
                let to_surface = self.add_shading(prepared, wanted, group, seen, &lit, cotangent);
                if wanted.surface() {
                    let to_ray = self.add_surface(prepared, wanted, group, seen, to_surface);
                    if wanted.camera {
                        let (x, y) = group.film;
                        let (_, pullback) = primary_ray::vjp::<L>(frame, x, y);
                        frame_cotangent.accumulate(pullback(to_ray).0);
                    }
                }
            }
        }
        self.frame.add(&frame_cotangent);
    }

    /// Pulls the cotangent of radiance back to lights and materials; returns that of the surface.
    fn add_shading<L: Lanes>(
        &mut self,
        prepared: &Prepared<'_, L>,
        wanted: Wanted,
        group: &Group<L>,
        seen: &[Seen],
        lit: &[Lit],
        cotangent: Vec3<L>,
    ) -> Tangent<SurfacePoint<L>> {
        let (to_material, to_surface) =
            pull_back(group, &prepared.lights, lit, cotangent, |index, cotangent| {
                if !wanted.lights {
                    return;
                }
                match (&mut self.lights[index], cotangent) {
                    (Light::Point(sum), LightCotangent::Point(light)) => sum.add(&light),
                    (Light::Distant(sum), LightCotangent::Distant(light)) => sum.add(&light),
                    _ => unreachable!("the sums have the shape of the lights"),
                }
            });
        if wanted.materials {
            Material::scatter(&to_material, seen.len(), |lane, add| {
                add(&mut self.materials[prepared.material_of(seen[lane].hit.primitive)]);
            });
        }
        to_surface
    }

    /// Pulls the cotangent of surface points back to primitives; returns that of the rays.
    fn add_surface<L: Lanes>(
        &mut self,
        prepared: &Prepared<'_, L>,
        wanted: Wanted,
        group: &Group<L>,
        seen: &[Seen],
        cotangent: Tangent<SurfacePoint<L>>,
    ) -> Tangent<Ray<L>> {
        match &group.shape {
            GroupShape::Triangles([a, b, c]) => {
                let (_, pullback) = triangle_surface::vjp::<L>(group.ray, *a, *b, *c);
                let (ray, a, b, c) = pullback(cotangent);
                if wanted.vertices {
                    let corners = [a, b, c].map(vectors_of_lanes::<L>);
                    for (lane, seen) in seen.iter().enumerate() {
                        let vertices = prepared.triangles[seen.index];
                        let cotangents = corners.map(|corner| corner[lane]);
                        self.vertices.extend(vertices.into_iter().zip(cotangents));
                    }
                }
                ray
            }
            GroupShape::Spheres(sphere, leaves) => {
                let (_, pullback) = sphere_surface::vjp::<L>(group.ray, *sphere, *leaves);
                let (ray, sphere, ()) = pullback(cotangent);
                if wanted.spheres {
                    Sphere::scatter(&sphere, seen.len(), |lane, add| {
                        add(&mut self.spheres[seen[lane].index]);
                    });
                }
                ray
            }
        }
    }
}
