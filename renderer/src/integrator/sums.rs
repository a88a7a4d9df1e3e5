//! What the pixels of a strip add up to, in double precision.

use ad::lanes::Lanes;
use ad::{Additive, Mask, Vec3};
use glam::DVec3;

use super::gradient::Wanted;
use super::prepared::Prepared;
use super::shade::LightCotangent;
use crate::kernels::camera::FrameTangent;
use crate::kernels::light::{DistantLightTangent, PointLightTangent};
use crate::kernels::material::MaterialTangent;
use crate::kernels::sphere::SphereTangent;
use crate::kernels::texture::UvTangent;
use crate::precision::{sum_of_lanes, sum_of_vectors};
use crate::scene::Light;

/// Where the sum of each index stands in a list of sums.
///
/// A sparse set (Briggs & Torczon, "An Efficient Representation for Sparse Sets", 1993): it is never
/// cleared, because a slot counts only if the sum in it bears its index. So a strip costs the time
/// and the memory of what it touches, however much there is.
pub struct Slots(Vec<u32>);

impl Slots {
    /// For indices below `count`.
    pub fn new(count: usize) -> Self {
        Self(vec![0; count])
    }

    /// Adds `term` to the sum of an index.
    #[inline]
    pub fn add<T: Additive>(&mut self, sums: &mut Vec<(u32, T)>, index: usize, term: T) {
        let slot = &mut self.0[index];
        match sums.get_mut(*slot as usize) {
            Some((of, sum)) if *of == index as u32 => sum.accumulate(term),
            _ => {
                *slot = sums.len() as u32;
                sums.push((index as u32, term));
            }
        }
    }
}

/// The cotangent of a light of either kind.
#[derive(Clone, Debug)]
pub enum LightSum {
    Point(PointLightTangent<f64>),
    Distant(DistantLightTangent<f64>),
}

impl LightSum {
    fn zero(light: &Light<f64>) -> Self {
        match light {
            Light::Point(_) => Self::Point(Additive::zero()),
            Light::Distant(_) => Self::Distant(Additive::zero()),
        }
    }

    /// Adds what flows back from a group.
    #[inline]
    pub(super) fn add<L: Lanes>(&mut self, cotangent: &LightCotangent<'_, L>, wanted: Wanted<'_>) {
        let all = Mask::splat(true);
        let vectors = |wanted, v| vector_if::<L>(wanted, v, all);
        let (sum_of_place, sum_of_color, sum_of_intensity) = match self {
            Self::Point(sum) => (&mut sum.position, &mut sum.color, &mut sum.intensity),
            Self::Distant(sum) => (&mut sum.direction, &mut sum.color, &mut sum.intensity),
        };
        let (place, color, intensity) = match cotangent {
            LightCotangent::Point(light) => (light.position, light.color, light.intensity),
            LightCotangent::Distant(light) => (light.direction, light.color, light.intensity),
        };
        *sum_of_place += vectors(wanted.light_places, place);
        *sum_of_color += vectors(wanted.light_colors, color);
        *sum_of_intensity += number_if(wanted.light_intensities, intensity, all);
    }

    /// The cotangent of where the light is, or where it comes from.
    pub fn place(&mut self) -> &mut DVec3 {
        match self {
            Self::Point(sum) => &mut sum.position,
            Self::Distant(sum) => &mut sum.direction,
        }
    }

    fn is_finite(&self) -> bool {
        match self {
            Self::Point(sum) => sum.is_finite(),
            Self::Distant(sum) => sum.is_finite(),
        }
    }

    /// Adds the sum to a gradient.
    pub fn add_to(&self, gradient: &mut Light<f64>) {
        match (self, gradient) {
            (Self::Point(sum), Light::Point(light)) => light.add(sum),
            (Self::Distant(sum), Light::Distant(light)) => light.add(sum),
            _ => unreachable!("the sums have the shape of the lights"),
        }
    }
}

/// What the wanted cotangents of a material add up to in the lanes in which `mask` holds, but for its
/// reflection.
#[inline]
pub(super) fn material_sum<L: Lanes>(
    cotangent: &MaterialTangent<L>,
    mask: L::Mask,
    wanted: Wanted<'_>,
) -> MaterialTangent<f64> {
    let vectors = |wanted, v| vector_if::<L>(wanted, v, mask);
    MaterialTangent {
        ambient: vectors(wanted.ambient, cotangent.ambient),
        diffuse: vectors(wanted.diffuse, cotangent.diffuse),
        specular: vectors(wanted.specular, cotangent.specular),
        exponent: number_if(wanted.exponents, cotangent.exponent, mask),
        reflection: DVec3::ZERO,
    }
}

#[inline]
fn vector_if<L: Lanes>(wanted: bool, v: Vec3<L>, mask: L::Mask) -> DVec3 {
    if wanted { sum_of_vectors::<L>(v, mask) } else { DVec3::ZERO }
}

#[inline]
fn number_if<L: Lanes>(wanted: bool, x: L, mask: L::Mask) -> f64 {
    if wanted { sum_of_lanes(x, mask) } else { 0.0 }
}

/// The loss of a strip, and what flows back from it. Sums by index are in the order in which the
/// indices were first touched.
pub struct StripSums {
    pub loss: f64,
    pub frame: FrameTangent<f64>,
    pub lights: Vec<LightSum>,
    /// By material.
    pub materials: Vec<(u32, MaterialTangent<f64>)>,
    /// By opacity.
    pub opacities: Vec<f64>,
    /// By sphere.
    pub spheres: Vec<(u32, SphereTangent<f64>)>,
    /// By wanted vertex.
    pub vertices: Vec<(u32, DVec3)>,
    /// By texture coordinates, counted through all meshes.
    pub uvs: Vec<(u32, UvTangent<f64>)>,
    /// By texel, counted through all textures.
    pub texels: Vec<(u32, DVec3)>,
    /// By shape that a user adds.
    pub shapes: Vec<Vec<f64>>,
    /// By light that a user adds.
    pub custom_lights: Vec<Vec<f64>>,
}

impl StripSums {
    pub fn zero<L: Lanes>(prepared: &Prepared<'_, L>) -> Self {
        let zeros = |lists: &[Vec<f64>]| lists.iter().map(|list| vec![0.0; list.len()]).collect();
        Self {
            loss: 0.0,
            frame: Additive::zero(),
            lights: prepared.lights.iter().map(LightSum::zero).collect(),
            materials: Vec::new(),
            opacities: vec![0.0; prepared.opacities.len()],
            spheres: Vec::new(),
            vertices: Vec::new(),
            uvs: Vec::new(),
            texels: Vec::new(),
            shapes: zeros(&prepared.parameters.shapes),
            custom_lights: zeros(&prepared.parameters.custom_lights),
        }
    }

    /// Whether all of it is.
    pub fn is_finite(&self) -> bool {
        let numbers = self.shapes.iter().chain(&self.custom_lights).flatten();
        self.loss.is_finite()
            && self.frame.is_finite()
            && self.lights.iter().all(LightSum::is_finite)
            && self.materials.iter().all(|(_, sum)| sum.is_finite())
            && self.spheres.iter().all(|(_, sum)| sum.is_finite())
            && self.vertices.iter().all(|(_, sum)| sum.is_finite())
            && self.uvs.iter().all(|(_, sum)| sum.is_finite())
            && self.texels.iter().all(|(_, sum)| sum.is_finite())
            && self.opacities.iter().chain(numbers).copied().all(f64::is_finite)
    }
}

#[cfg(test)]
mod tests {
    use super::Slots;

    /// What a slot still says of an earlier list does not count.
    #[test]
    fn sums_stand_in_the_order_of_their_first_terms_list_after_list() {
        let mut slots = Slots::new(100);
        for offset in [0, 3, 50] {
            let mut sums = Vec::new();
            for (index, term) in [(7, 1.0), (2, 10.0), (7, 2.0), (40, 5.0), (2, 0.5)] {
                slots.add(&mut sums, index + offset, term);
            }
            let at = |index: usize| (index + offset) as u32;
            assert_eq!(sums, [(at(7), 3.0), (at(2), 10.5), (at(40), 5.0)]);
        }
    }
}
