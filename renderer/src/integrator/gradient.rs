//! The gradient of a loss by every parameter.

use ad::lanes::Lanes;
use ad::{Additive, Tangent};
use glam::DVec3;

use super::prepared::Prepared;
use super::radiance::PixelLoss;
use super::range::with_range;
use super::sums::StripSums;
use super::sweep::sweep;
use super::vertices::ChosenVertices;
use crate::kernels::camera::{Camera, Frame, frame};
use crate::kernels::light::{DistantLight, PointLight};
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
use crate::scene::{Light, ParameterId, Parameters};

/// The parameters by which a gradient is wanted. Other kinds, and other vertices, cost nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wanted<'a> {
    ids: &'a [ParameterId],
    pub(super) camera: bool,
    /// Where lights are, or where they come from.
    pub(super) light_places: bool,
    pub(super) light_colors: bool,
    pub(super) light_intensities: bool,
    pub(super) custom_lights: bool,
    pub(super) ambient: bool,
    pub(super) diffuse: bool,
    pub(super) specular: bool,
    pub(super) exponents: bool,
    /// What materials reflect as mirrors: rays are then traced where they reflect nothing, too.
    pub(super) mirrors: bool,
    pub(super) opacities: bool,
    pub(super) spheres: bool,
    /// Any of them; which, say [`ChosenVertices`].
    pub(super) vertices: bool,
    pub(super) shapes: bool,
    pub(super) texture_coordinates: bool,
    pub(super) texels: bool,
}

impl<'a> Wanted<'a> {
    /// The given parameters.
    pub fn by(ids: &'a [ParameterId]) -> Self {
        use ParameterId::*;
        let mut wanted = Self { ids, ..Self::default() };
        for id in ids {
            *match id {
                LookFrom | LookAt | Up | Vfov | Focus => &mut wanted.camera,
                LightPosition(_) | LightDirection(_) => &mut wanted.light_places,
                LightColor(_) => &mut wanted.light_colors,
                LightIntensity(_) => &mut wanted.light_intensities,
                LightParameters(_) => &mut wanted.custom_lights,
                ShapeParameters(_) => &mut wanted.shapes,
                Ambient(_) => &mut wanted.ambient,
                Diffuse(_) => &mut wanted.diffuse,
                Specular(_) => &mut wanted.specular,
                Exponent(_) => &mut wanted.exponents,
                Reflection(_) => &mut wanted.mirrors,
                Opacity(_) => &mut wanted.opacities,
                SphereCenter(_) | SphereRadius(_) => &mut wanted.spheres,
                Vertices(_) | Vertex { .. } => &mut wanted.vertices,
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

    /// Whether vertices are all that it is by.
    pub(super) fn only_vertices(self) -> bool {
        self == Self { ids: self.ids, vertices: true, ..Self::default() }
    }

    /// The vertices among them.
    pub(super) fn chosen_vertices<L: Lanes>(self, prepared: &Prepared<'_, L>) -> ChosenVertices {
        ChosenVertices::new(prepared, self.ids)
    }

    pub(super) fn materials(self) -> bool {
        self.ambient || self.diffuse || self.specular || self.exponents || self.mirrors
    }

    pub(super) fn lights(self) -> bool {
        self.light_places || self.light_colors || self.light_intensities
    }
}

/// A loss and its gradient.
#[derive(Clone, Debug, PartialEq)]
pub struct GradientResult {
    /// The loss.
    pub loss: f64,
    /// Its derivative by each wanted parameter. For parameters that move edges it is the interior
    /// term, see [`Differentiability`](crate::scene::Differentiability).
    pub gradient: Gradient,
}

/// Derivatives by parameters of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    /// All but those by vertices.
    numbers: Parameters,
    chosen: ChosenVertices,
    /// By wanted vertex.
    vertices: Vec<[f64; 3]>,
}

impl Gradient {
    fn zero<L: Lanes>(prepared: &Prepared<'_, L>, wanted: Wanted<'_>) -> Self {
        let chosen = wanted.chosen_vertices(prepared);
        let vertices = vec![[0.0; 3]; chosen.count()];
        Self { numbers: zero(&prepared.parameters, wanted), chosen, vertices }
    }

    /// The derivatives by one parameter, in its shape. If it was not wanted: zeros, or, where a scene
    /// may have many of its kind (vertices, texels, texture coordinates), nothing.
    ///
    /// # Panics
    ///
    /// If `id` is not a parameter of the scene that this belongs to.
    pub fn get(&self, id: ParameterId) -> &[f64] {
        match id {
            ParameterId::Vertices(_) | ParameterId::Vertex { .. } => {
                self.vertices[self.chosen.range_of(id)].as_flattened()
            }
            _ => self.numbers.get(id),
        }
    }

    /// Multiplies all of it, of a scene with these parameters.
    pub(super) fn scale(&mut self, ids: &[ParameterId], factor: f64) {
        let scale = |numbers: &mut [f64]| numbers.iter_mut().for_each(|value| *value *= factor);
        scale(self.vertices.as_flattened_mut());
        ids.iter().for_each(|&id| scale(self.numbers.get_mut(id)));
    }
}

/// The loss of the image and its gradient by the wanted parameters.
pub fn gradient<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted<'_>,
) -> GradientResult {
    let result = reduce(prepared, sweep(prepared, loss, wanted), wanted);
    with_range(prepared, loss, wanted, result)
}

/// Puts strips together, always in the same order.
pub(crate) fn reduce<L: Lanes>(
    prepared: &Prepared<'_, L>,
    strips: Vec<StripSums>,
    wanted: Wanted<'_>,
) -> GradientResult {
    let mut total = GradientResult { loss: 0.0, gradient: Gradient::zero(prepared, wanted) };
    let mut frame = Tangent::<Frame<f64>>::zero();
    let Gradient { numbers: gradient, vertices, .. } = &mut total.gradient;
    for strip in strips {
        total.loss += strip.loss;
        frame.accumulate(strip.frame);
        for (light, sum) in gradient.lights.iter_mut().zip(&strip.lights) {
            sum.add_to(light);
        }
        for (material, sum) in &strip.materials {
            gradient.materials[*material as usize].add(sum);
        }
        if wanted.opacities {
            gradient.opacities.accumulate(strip.opacities);
        }
        for (sphere, sum) in &strip.spheres {
            gradient.spheres[*sphere as usize].add(sum);
        }
        for (vertex, sum) in strip.vertices {
            let vertex = &mut vertices[vertex as usize];
            *vertex = (DVec3::from(*vertex) + sum).into();
        }
        for (uv, sum) in strip.uvs {
            let (mesh, index) = prepared.uv_of_mesh(uv);
            let [u, v] = &mut gradient.texture_coordinates[mesh][index];
            *u += sum.u;
            *v += sum.v;
        }
        if wanted.shapes {
            gradient.shapes.accumulate(strip.shapes);
        }
        if wanted.custom_lights {
            gradient.custom_lights.accumulate(strip.custom_lights);
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

/// Zero, in the shape of `parameters`, but for vertices; nothing where there may be many and they are
/// not wanted.
fn zero(parameters: &Parameters, wanted: Wanted<'_>) -> Parameters {
    let zero_light = |light: &Light<f64>| match light {
        Light::Point(_) => Light::Point(PointLight::zero()),
        Light::Distant(_) => Light::Distant(DistantLight::zero()),
    };
    Parameters {
        camera: Camera::zero(),
        lights: parameters.lights.iter().map(zero_light).collect(),
        materials: vec![Material::zero(); parameters.materials.len()],
        opacities: vec![0.0; parameters.opacities.len()],
        spheres: vec![Sphere::zero(); parameters.spheres.len()],
        vertices: vec![Vec::new(); parameters.vertices.len()],
        texture_coordinates: zeros_if(
            wanted.texture_coordinates,
            &parameters.texture_coordinates,
            [0.0; 2],
        ),
        shapes: zeros_if(wanted.shapes, &parameters.shapes, 0.0),
        custom_lights: zeros_if(wanted.custom_lights, &parameters.custom_lights, 0.0),
        textures: zeros_if(wanted.texels, &parameters.textures, [0.0; 3]),
    }
}

fn zeros_if<T: Clone>(wanted: bool, lists: &[Vec<T>], zero: T) -> Vec<Vec<T>> {
    let length = |list: &Vec<T>| if wanted { list.len() } else { 0 };
    lists.iter().map(|list| vec![zero.clone(); length(list)]).collect()
}
