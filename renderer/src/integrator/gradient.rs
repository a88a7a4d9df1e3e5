//! The gradient of a loss by every parameter.

use ad::lanes::Lanes;
use ad::{Additive, Tangent};
use glam::DVec3;

use super::prepared::Prepared;
use super::radiance::PixelLoss;
use super::sums::StripSums;
use super::sweep::sweep;
use crate::kernels::camera::{Camera, Frame, frame};
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
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
    /// Parameters of shapes that users add.
    pub shapes: bool,
    /// Texture coordinates.
    pub texture_coordinates: bool,
    /// Texels.
    pub texels: bool,
    /// What materials reflect as mirrors: rays are then traced where they reflect nothing, too.
    pub mirrors: bool,
}

impl Wanted {
    /// The kinds that the given parameters are of.
    pub fn by(ids: &[ParameterId]) -> Self {
        use ParameterId::*;
        let mut wanted = Self::default();
        for id in ids {
            *match id {
                LookFrom | LookAt | Up | Vfov | Focus => &mut wanted.camera,
                LightPosition(_) | LightDirection(_) | LightColor(_) | LightIntensity(_)
                | LightParameters(_) => &mut wanted.lights,
                ShapeParameters(_) => &mut wanted.shapes,
                Ambient(_) | Diffuse(_) | Specular(_) | Exponent(_) => &mut wanted.materials,
                Reflection(_) => {
                    wanted.mirrors = true;
                    &mut wanted.materials
                }
                SphereCenter(_) | SphereRadius(_) => &mut wanted.spheres,
                Vertices(_) => &mut wanted.vertices,
                TextureCoordinates(_) => &mut wanted.texture_coordinates,
                Texels(_) => &mut wanted.texels,
            } = true;
        }
        wanted
    }

    /// Whether the point that is seen depends on any of them.
    pub(super) fn surface(self) -> bool {
        self.camera || self.spheres || self.vertices || self.shapes || self.texture_coordinates
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
        for (uv, sum) in strip.uvs {
            let (mesh, index) = prepared.uv_of_mesh(uv);
            let [u, v] = &mut gradient.texture_coordinates[mesh][index];
            *u += sum.u;
            *v += sum.v;
        }
        for (total, sum) in gradient.shapes.iter_mut().zip(strip.shapes) {
            total.accumulate(sum);
        }
        for (total, sum) in gradient.custom_lights.iter_mut().zip(strip.custom_lights) {
            total.accumulate(sum);
        }
        for (texel, sum) in strip.texels {
            let (texture, index) = prepared.texel_of_texture(texel);
            let texel = &mut gradient.textures[texture][index];
            *texel = (DVec3::from(*texel) + sum).into();
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
        texture_coordinates: parameters
            .texture_coordinates
            .iter()
            .map(|mesh| vec![[0.0; 2]; mesh.len()])
            .collect(),
        shapes: parameters.shapes.iter().map(|list| vec![0.0; list.len()]).collect(),
        custom_lights: parameters.custom_lights.iter().map(|list| vec![0.0; list.len()]).collect(),
        textures: parameters.textures.iter().map(|texels| vec![[0.0; 3]; texels.len()]).collect(),
    }
}
