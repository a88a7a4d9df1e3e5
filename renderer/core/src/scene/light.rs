//! Lights of a scene.

use std::borrow::Cow;

use ad::Field;
use glam::DVec3;

use super::numbers::{Numbers, range_of};
use crate::custom::{EmitterFamily, EmitterKernel};
use crate::transport::area_light::{AreaLight, Place};
use crate::transport::light::{DistantLight, Light, PointLight, SpotLight, match_light};

/// The most lights, or points of them, whose shadows have edges: a bit for each.
pub(crate) const MOST_EDGED_LIGHTS: usize = 64;

/// A light and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct LightObject {
    /// The name, unique among lights.
    pub name: String,
    /// What shines.
    pub source: LightSource,
}

/// What shines.
#[derive(Clone, Debug, PartialEq)]
pub enum LightSource {
    /// A light of a known kind.
    Known(Light<f64>),
    /// A custom light. Scene files do not know it.
    Custom {
        /// The kernel.
        kernel: EmitterKernel,
        /// The numbers of all its fields.
        numbers: Vec<f64>,
    },
}

impl LightSource {
    pub(super) fn custom<T: EmitterFamily>(light: &T) -> Self {
        let numbers = (0..T::LEN).map(|index| light.number(index)).collect();
        Self::Custom { kernel: T::kernel(), numbers }
    }

    /// By how many points it stands.
    pub(crate) fn place_count(&self, count: u32) -> usize {
        match self {
            Self::Known(Light::Rectangle(_) | Light::Disc(_)) => count as usize,
            Self::Known(_) | Self::Custom { .. } => 1,
        }
    }

    /// The points that it stands by, if its kind has an area, else one.
    pub(crate) fn places(&self, count: u32) -> Vec<Place<f64>> {
        match self {
            Self::Known(light) => light.places(count),
            Self::Custom { .. } => vec![Place::POINT],
        }
    }

    /// Whether the light is known to send nothing.
    pub(crate) fn is_black(&self) -> bool {
        match self {
            Self::Known(light) => light.is_black(),
            Self::Custom { .. } => false,
        }
    }
}

/// What lights with an area need.
const AREA: AreaLight<f64> = AreaLight {
    center: DVec3::NAN,
    right: DVec3::NAN,
    up: DVec3::NAN,
    color: DVec3::ONE,
    radiance: f64::NAN,
};

impl Light<f64> {
    /// The kinds by the names that scene files give them, with numbers that are not: what a kind needs
    /// is NaN, what it can do without has its default.
    #[doc(hidden)]
    pub const KINDS: [(&'static str, Self); 5] = [
        (
            "point",
            Self::Point(PointLight {
                position: DVec3::NAN,
                color: DVec3::ONE,
                radiant_intensity: f64::NAN,
            }),
        ),
        (
            "distant",
            Self::Distant(DistantLight {
                direction: DVec3::NAN,
                color: DVec3::ONE,
                irradiance: f64::NAN,
            }),
        ),
        (
            "spot",
            Self::Spot(SpotLight {
                position: DVec3::NAN,
                direction: DVec3::NAN,
                color: DVec3::ONE,
                radiant_intensity: f64::NAN,
                inner_angle: 0.0,
                outer_angle: 45.0,
            }),
        ),
        ("rectangle", Self::Rectangle(AREA)),
        ("disc", Self::Disc(AREA)),
    ];

    /// The points that it stands by.
    pub(crate) fn places(&self, count: u32) -> Vec<Place<f64>> {
        match self {
            Self::Rectangle(_) => Place::on_rectangle(count).collect(),
            Self::Disc(_) => Place::on_disc(count).collect(),
            Self::Point(_) | Self::Distant(_) | Self::Spot(_) => vec![Place::POINT],
        }
    }

    /// The name that scene files give its kind.
    #[doc(hidden)]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Point(_) => "point",
            Self::Distant(_) => "distant",
            Self::Spot(_) => "spot",
            Self::Rectangle(_) => "rectangle",
            Self::Disc(_) => "disc",
        }
    }

    /// Whether the light sends nothing.
    pub fn is_black(&self) -> bool {
        let radiance = match self {
            Self::Point(light) => light.color * light.radiant_intensity,
            Self::Distant(light) => light.color * light.irradiance,
            Self::Spot(light) => light.color * light.radiant_intensity,
            Self::Rectangle(light) | Self::Disc(light) => light.color * light.radiance,
        };
        radiance == DVec3::ZERO
    }
}

impl From<PointLight<f64>> for Light<f64> {
    fn from(light: PointLight<f64>) -> Self {
        Self::Point(light)
    }
}

impl From<DistantLight<f64>> for Light<f64> {
    fn from(light: DistantLight<f64>) -> Self {
        Self::Distant(light)
    }
}

impl From<SpotLight<f64>> for Light<f64> {
    fn from(light: SpotLight<f64>) -> Self {
        Self::Spot(light)
    }
}

impl Numbers for LightObject {
    fn fields(&self) -> Vec<Field> {
        match &self.source {
            LightSource::Known(light) => match_light!(light, light => Numbers::fields(light)),
            LightSource::Custom { kernel, .. } => kernel.fields.to_vec(),
        }
    }

    fn get(&self, field: &str) -> Option<Cow<'_, [f64]>> {
        match &self.source {
            LightSource::Known(light) => match_light!(light, light => Numbers::get(light, field)),
            LightSource::Custom { kernel, numbers } => {
                Some(Cow::Borrowed(&numbers[range_of(kernel.fields, field)?]))
            }
        }
    }

    fn set(&mut self, field: &str, first: usize, new: &[f64]) {
        match &mut self.source {
            LightSource::Known(light) => {
                match_light!(light, light => Numbers::set(light, field, first, new));
            }
            LightSource::Custom { kernel, numbers } => {
                if let Some(range) = range_of(kernel.fields, field) {
                    numbers[range.start + first..][..new.len()].copy_from_slice(new);
                }
            }
        }
    }
}
