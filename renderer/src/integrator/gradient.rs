//! The gradient of a loss by every parameter.

use ad::{Scalar, Tangent, Vec3};
use glam::DVec3;

use super::pixel::{PixelLoss, Sight};
use super::prepared::{Prepared, Primitive};
use super::tiles::{Tile, for_each_tile};
use crate::kernels::camera::{Camera, Frame, frame, primary_ray};
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::{
    Material, MaterialTangent, reflection_of_distant_light, reflection_of_point_light,
};
use crate::kernels::sphere::{Sphere, sphere_surface};
use crate::kernels::surface::SurfacePoint;
use crate::kernels::triangle::triangle_surface;
use crate::precision::{narrow, widen};
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
pub fn gradient<S: Scalar>(
    prepared: &Prepared<'_, S>,
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
    fn new<S: Scalar>(prepared: &Prepared<'_, S>) -> Self {
        let zero_light = |light: &Light<S>| match light {
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

    fn add_tile<S: Scalar>(
        &mut self,
        prepared: &Prepared<'_, S>,
        loss: &impl PixelLoss,
        wanted: Wanted,
        tile: &Tile,
    ) {
        let mut lit = Vec::new();
        for (x, y) in tile.pixels() {
            let Some(sight) = prepared.look(x, y) else {
                self.loss += loss.evaluate(x, y, DVec3::ZERO).0;
                continue;
            };
            let radiance = prepared.radiance(&sight, &mut lit);
            let (pixel_loss, cotangent) = loss.evaluate(x, y, radiance);
            self.loss += pixel_loss;
            // A pixel that the loss does not care about has no gradient.
            if cotangent != DVec3::ZERO {
                self.add_pixel(prepared, wanted, &sight, &lit, narrow::<S>(cotangent));
            }
        }
    }

    /// Pulls the cotangent of a pixel's radiance back to the parameters.
    fn add_pixel<S: Scalar>(
        &mut self,
        prepared: &Prepared<'_, S>,
        wanted: Wanted,
        sight: &Sight<S>,
        lit: &[bool],
        cotangent: Vec3<S>,
    ) {
        let material_index = prepared.material_of[sight.hit.primitive as usize] as usize;
        let material = prepared.materials[material_index];
        let mut surface_cotangent = <Tangent<SurfacePoint<S>> as ad::Additive>::zero();
        let mut add_material_and_surface =
            |material: &MaterialTangent<S>, surface: Tangent<SurfacePoint<S>>| {
                if wanted.materials {
                    self.materials[material_index].add(material);
                }
                ad::Additive::accumulate(&mut surface_cotangent, surface);
            };

        let lights = prepared.lights.iter().zip(&mut self.lights).zip(lit);
        for ((light, sum), _) in lights.filter(|(_, lit)| **lit) {
            match (light, sum) {
                (Light::Point(light), Light::Point(sum)) => {
                    let (_, pullback) =
                        reflection_of_point_light::vjp::<S>(material, sight.surface, *light);
                    let (material, surface, light) = pullback(cotangent);
                    if wanted.lights {
                        sum.add(&light);
                    }
                    add_material_and_surface(&material, surface);
                }
                (Light::Distant(light), Light::Distant(sum)) => {
                    let (_, pullback) =
                        reflection_of_distant_light::vjp::<S>(material, sight.surface, *light);
                    let (material, surface, light) = pullback(cotangent);
                    if wanted.lights {
                        sum.add(&light);
                    }
                    add_material_and_surface(&material, surface);
                }
                _ => unreachable!("the sums have the shape of the lights"),
            }
        }
        if wanted.materials {
            self.materials[material_index].ambient += widen::<S>(cotangent);
        }
        if wanted.surface() {
            self.add_surface(prepared, wanted, sight, surface_cotangent);
        }
    }

    /// Pulls the cotangent of a surface point back to the primitive and the camera.
    fn add_surface<S: Scalar>(
        &mut self,
        prepared: &Prepared<'_, S>,
        wanted: Wanted,
        sight: &Sight<S>,
        cotangent: Tangent<SurfacePoint<S>>,
    ) {
        let ray_cotangent = match prepared.primitive(sight.hit.primitive) {
            Primitive::Triangle(index) => {
                let vertices = prepared.triangles[index];
                let [a, b, c] = vertices.map(|v| prepared.vertices[v as usize]);
                let (_, pullback) = triangle_surface::vjp::<S>(sight.ray, a, b, c);
                let (ray, a, b, c) = pullback(cotangent);
                if wanted.vertices {
                    let cotangents = [a, b, c].map(widen::<S>);
                    self.vertices.extend(vertices.into_iter().zip(cotangents));
                }
                ray
            }
            Primitive::Sphere(index) => {
                let (_, pullback) =
                    sphere_surface::vjp::<S>(sight.ray, prepared.spheres[index], sight.hit.leaves);
                let (ray, sphere, ()) = pullback(cotangent);
                if wanted.spheres {
                    self.spheres[index].add(&sphere);
                }
                ray
            }
        };
        if wanted.camera {
            let (x, y) = sight.film;
            let (_, pullback) = primary_ray::vjp::<S>(prepared.frame, x, y);
            let (frame, _, _) = pullback(ray_cotangent);
            self.frame.add(&frame);
        }
    }
}
