//! Lights, and the irradiance they bring to a point.

use ad::vector::{Vector, Vector3};
use ad::{Differentiable, Fields, Real, Vec3, differentiable, select};

use super::area_light::{AreaLight, Place, illuminate_by_area};
use super::illumination::Illumination;

/// A light that shines from a point in all directions.
///
/// The irradiance on a surface that faces it at distance `r` is `color * radiant_intensity / r²`. A
/// light of power `P` has the radiant intensity `P / 4π`.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct PointLight<S: Real> {
    /// The position of the light.
    pub position: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// The radiant intensity, W/sr.
    pub radiant_intensity: S,
}

/// A light so far away that its rays are parallel.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct DistantLight<S: Real> {
    /// The direction towards the light; it need not be a unit vector.
    pub direction: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// The irradiance on a surface that faces the light, W/m².
    pub irradiance: S,
}

/// A point light that shines into a cone.
///
/// Between the angles the radiant intensity falls off as the square of a linear function of the cosine of
/// the angle from the axis (the specification of `KHR_lights_punctual`, "Inner and Outer Cone Angles"). It
/// has a kink at the inner angle and none at the outer one.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable, Fields)]
pub struct SpotLight<S: Real> {
    /// The position of the light.
    pub position: Vec3<S>,
    /// The direction in which the light shines; it need not be a unit vector.
    pub direction: Vec3<S>,
    /// Linear RGB.
    pub color: Vec3<S>,
    /// The radiant intensity inside the inner angle, W/sr.
    pub radiant_intensity: S,
    /// The angle from the axis at which the fall-off begins, degrees.
    pub inner_angle: S,
    /// The angle from the axis beyond which it is dark, degrees: above the inner angle, or the cone has a sharp
    /// edge, of which no derivative knows. A [`Scene`](crate::Scene) refuses that.
    pub outer_angle: S,
}

/// A light of a known kind.
///
/// The enum is the same in every lane. Kernels match on it, and its pullback is that of the match:
/// measured, this costs 1 % of a gradient more than a kernel for each kind, and saves the caller all
/// knowledge of the kinds.
#[derive(Clone, Copy, Debug, PartialEq, Differentiable)]
#[non_exhaustive]
pub enum Light<S: Real> {
    /// Shines from a point.
    Point(PointLight<S>),
    /// Shines from infinitely far.
    Distant(DistantLight<S>),
    /// Shines from a point into a cone.
    Spot(SpotLight<S>),
    /// Shines from a rectangle.
    Rectangle(AreaLight<S>),
    /// Shines from the ellipse in a rectangle.
    Disc(AreaLight<S>),
}

/// Matches on the kind of a light: `$body` sees the struct as `$inner` and the constructor of its variant
/// as `Variant`; with a cotangent of the light, the part of it that belongs to the struct as `$part`.
macro_rules! match_light {
    (@kind $variant:ident, $light:ident, $inner:ident $(, $cotangent:expr, $part:ident)? => $body:expr) => {{
        #[allow(unused_imports)]
        use $crate::transport::light::Light::$variant as Variant;
        let $inner = $light;
        $(let $part = &$cotangent.$variant.0;)?
        $body
    }};
    ($light:expr, $($rest:tt)*) => {
        match $light {
            $crate::transport::light::Light::Point(light) => {
                match_light!(@kind Point, light, $($rest)*)
            }
            $crate::transport::light::Light::Distant(light) => {
                match_light!(@kind Distant, light, $($rest)*)
            }
            $crate::transport::light::Light::Spot(light) => {
                match_light!(@kind Spot, light, $($rest)*)
            }
            $crate::transport::light::Light::Rectangle(light) => {
                match_light!(@kind Rectangle, light, $($rest)*)
            }
            $crate::transport::light::Light::Disc(light) => {
                match_light!(@kind Disc, light, $($rest)*)
            }
        }
    };
}

pub(crate) use match_light;

impl<S: Real> Light<S> {
    /// The light as it is seen from an origin.
    pub(crate) fn relative_to(self, origin: Vec3<S>) -> Self {
        match self {
            Self::Point(light) => {
                Self::Point(PointLight { position: light.position - origin, ..light })
            }
            Self::Spot(light) => {
                Self::Spot(SpotLight { position: light.position - origin, ..light })
            }
            Self::Rectangle(light) => {
                Self::Rectangle(AreaLight { center: light.center - origin, ..light })
            }
            Self::Disc(light) => Self::Disc(AreaLight { center: light.center - origin, ..light }),
            Self::Distant(_) => self,
        }
    }

    /// The position of a point of it, if it has any from which rays start.
    pub(crate) fn position(&self, place: Place<S>) -> Option<Vec3<S>> {
        match self {
            Self::Point(light) => Some(light.position),
            Self::Spot(light) => Some(light.position),
            Self::Rectangle(light) | Self::Disc(light) => Some(light.at(place)),
            Self::Distant(_) => None,
        }
    }

    /// Whether a point lies where the light does not shine: behind an area, or outside of a cone. `to_light` is
    /// a vector of any length from it towards the light. Nothing for lights that shine in all directions.
    pub(crate) fn is_turned_away(self, to_light: Vec3<S>) -> Option<S::Mask> {
        match self {
            Self::Point(_) | Self::Distant(_) => None,
            Self::Spot(SpotLight { direction, outer_angle, .. }) => {
                let axis = direction.normalize();
                let off_axis = one_minus_cosine::<S>(axis + to_light.normalize_or_zero());
                Some(off_axis.cmpge(one_minus_cosine_of_angle::<S>(outer_angle)))
            }
            Self::Rectangle(light) | Self::Disc(light) => {
                Some(light.right.cross(light.up).dot(to_light).cmpge(S::ZERO))
            }
        }
    }
}

/// A light that reaches every point from one direction: the numbers `self`, and what it brings.
#[differentiable]
pub trait Emitter {
    /// The scalar of the numbers.
    type Scalar: Real;

    /// The illumination of a point, if nothing is between them. Points are in the coordinates of the
    /// scene, in the precision of the scalar.
    fn illuminate(self, point: Vec3<Self::Scalar>) -> Illumination<Self::Scalar>;
}

/// The illumination of `point` by a light, or by a place of it, if nothing is between them.
#[differentiable]
#[inline]
pub fn illuminate<S: Real>(light: Light<S>, place: Place<S>, point: Vec3<S>) -> Illumination<S> {
    match light {
        Light::Rectangle(light) => illuminate_by_area::<S>(light, place, point),
        Light::Disc(light) => illuminate_by_area::<S>(light, place, point),
        Light::Point(light) => illuminate_by_point::<S>(light, point),
        Light::Distant(light) => illuminate_by_distant::<S>(light),
        Light::Spot(light) => illuminate_by_spot::<S>(light, point),
    }
}

/// The illumination by a point light. In the light itself, where it has no direction, it is zero.
#[differentiable]
#[inline]
pub fn illuminate_by_point<S: Real>(light: PointLight<S>, point: Vec3<S>) -> Illumination<S> {
    let to_light = light.position - point;
    // The derivative holds the square of this and no other power: the range of distances is the
    // largest that single precision has.
    let length_recip = to_light.length_recip();
    let recip = select(length_recip.is_finite(), length_recip, S::ZERO);
    Illumination {
        direction: to_light.normalize_or_zero(),
        distance: to_light.length(),
        irradiance: light.color * (light.radiant_intensity * recip * recip),
    }
}

/// The illumination by a distant light, the same everywhere.
#[differentiable]
#[inline]
pub fn illuminate_by_distant<S: Real>(light: DistantLight<S>) -> Illumination<S> {
    Illumination {
        direction: light.direction.normalize(),
        distance: S::ONE / S::ZERO,
        irradiance: light.color * light.irradiance,
    }
}

/// The illumination by a spot light.
#[differentiable]
#[inline]
pub fn illuminate_by_spot<S: Real>(light: SpotLight<S>, point: Vec3<S>) -> Illumination<S> {
    let SpotLight { position, color, radiant_intensity, .. } = light;
    let bulb = PointLight { position, color, radiant_intensity };
    let Illumination { direction, distance, irradiance } = illuminate_by_point::<S>(bulb, point);
    // One minus the cosines: differences of cosines lose small angles to rounding.
    let ray = one_minus_cosine::<S>(light.direction.normalize() + direction);
    let inner = one_minus_cosine_of_angle::<S>(light.inner_angle);
    let outer = one_minus_cosine_of_angle::<S>(light.outer_angle);
    let width = (outer - inner).max(S::EPSILON * outer);
    let linear = ((outer - ray) / width).max(S::ZERO).min(S::ONE);
    Illumination { direction, distance, irradiance: irradiance * (linear * linear) }
}

/// One minus the cosine of the angle between two unit vectors, by their difference.
#[differentiable]
#[inline]
fn one_minus_cosine<S: Real>(difference: Vec3<S>) -> S {
    S::HALF * difference.length_squared()
}

/// One minus the cosine of an angle in degrees.
#[differentiable]
#[inline]
fn one_minus_cosine_of_angle<S: Real>(angle: S) -> S {
    let sine = (angle * (S::PI / S::from_f64(360.0))).sin();
    S::TWO * sine * sine
}
