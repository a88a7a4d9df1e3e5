//! The material.

use ad::{Differentiable, Fields, Real, Vec3};

/// How a material scatters light (its bidirectional scattering distribution function): what its numbers mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Bsdf {
    /// A diffuse surface with a Blinn-Phong highlight, which may be a mirror:
    /// [`blinn_phong`](super::blinn_phong).
    #[default]
    BlinnPhong,
    /// A metal, or a glossy layer on a diffuse surface, as glTF 2.0 defines it:
    /// [`microfacet`](super::microfacet). A smooth metal is one of roughness 0.
    MetallicRoughness,
    /// A smooth surface that reflects and refracts, as of glass: [`dielectric`](super::dielectric).
    Dielectric,
}

impl Bsdf {
    /// The kinds by the names that scene files give them.
    #[doc(hidden)]
    pub const ALL: [(&'static str, Self); 3] = [
        ("blinn_phong", Self::BlinnPhong),
        ("metallic_roughness", Self::MetallicRoughness),
        ("dielectric", Self::Dielectric),
    ];

    /// Whether a field of [`Material`], or what a texture varies, means something to it.
    #[doc(hidden)]
    pub fn has(self, field: &str) -> bool {
        match field {
            "emission" | "diffuse" => true,
            "opacity" | "roughness" | "normal" => self != Self::Dielectric,
            "specular" | "exponent" | "mirror" => self == Self::BlinnPhong,
            "metallic" | "metallic_roughness" => self == Self::MetallicRoughness,
            "ior" => self != Self::BlinnPhong,
            _ => false,
        }
    }
}

/// The numbers of a material of any [kind](Bsdf); colours are linear RGB.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct Material<S: Real> {
    /// The radiance that the surface emits.
    pub emission: Vec3<S>,
    /// The albedo of the diffuse part; of a metallic-roughness material its base colour, which is that of a
    /// metal; of a dielectric the part of light that it lets through.
    pub diffuse: Vec3<S>,
    /// The roughness from 0 to 1. Of a metallic-roughness material, that of its facets: 0 is smooth. Else that
    /// of the diffuse part, from 0, which is Lambert's: how much of its light goes back to where it comes
    /// from, as that of dust, plaster and clay does.
    pub roughness: S,
    /// The albedo of the highlight.
    pub specular: Vec3<S>,
    /// The sharpness of the highlight; 0 or more.
    pub exponent: S,
    /// The part of the radiance from the mirror direction that is added; 0 is no mirror.
    pub mirror: Vec3<S>,
    /// The part of its own radiance that a transparent surface shows; the rest is what lies straight
    /// behind it. 1 for opaque materials.
    pub opacity: S,
    /// Of a metallic-roughness material: how much of it is metal, from 0 to 1.
    pub metallic: S,
    /// The index of refraction of the dielectric part, at least 1.
    pub ior: S,
}

impl Material<f64> {
    /// The lobes that its BRDF has, of this kind.
    #[doc(hidden)]
    pub fn lobes(&self, bsdf: Bsdf) -> Lobes {
        match bsdf {
            Bsdf::BlinnPhong => Lobes {
                rough: self.roughness != 0.0,
                glossy: self.specular != glam::DVec3::ZERO,
                facets: false,
            },
            Bsdf::MetallicRoughness => Lobes { facets: true, ..Lobes::default() },
            Bsdf::Dielectric => Lobes::default(),
        }
    }

    /// An opaque Lambertian material.
    pub fn lambertian(albedo: glam::DVec3) -> Self {
        Self {
            emission: glam::DVec3::ZERO,
            diffuse: albedo,
            roughness: 0.0,
            specular: glam::DVec3::ZERO,
            exponent: 1.0,
            mirror: glam::DVec3::ZERO,
            opacity: 1.0,
            metallic: 0.0,
            ior: 1.5,
        }
    }
}

/// A grey Lambertian material of albedo 0.7: what files that name no material get.
impl Default for Material<f64> {
    fn default() -> Self {
        Self::lambertian(glam::DVec3::splat(0.7))
    }
}

/// What BRDFs have beside Lambert's; the other terms are not computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Differentiable)]
pub struct Lobes {
    /// A roughness.
    pub rough: bool,
    /// A highlight.
    pub glossy: bool,
    /// Facets in place of everything else: those of metallic-roughness materials, which do not share their
    /// lanes with others.
    pub facets: bool,
}

impl Lobes {
    /// Those that any of two has.
    pub(crate) fn union(self, other: Self) -> Self {
        Self {
            rough: self.rough | other.rough,
            glossy: self.glossy | other.glossy,
            facets: self.facets | other.facets,
        }
    }
}
