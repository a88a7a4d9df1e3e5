//! The scalars that images are computed in.
//!
//! [`transport`](crate::transport) runs on any [`Real`]; to trace rays and to gather inputs, the
//! renderer has to know which numbers an `S` stands for. A [`Number`] is one or several
//! [lanes](Number::Lanes), which may carry derivatives beside their values: images are computed on plain
//! lanes, derivatives along a direction on dual numbers of lanes, and recordings on the variables of a
//! tape. So there is one forward pass for all of them.

use ad::lanes::{Lanes, f32x16, f64x8};
use ad::tape::Var;
use ad::vector::Vector3;
use ad::{Dual, Real, Scalar, Vec3};

/// A scalar that images can be computed in.
pub trait Number: Real {
    /// The values alone: rays are traced by them.
    type Lanes: Lanes;

    /// One lane: the numbers of a scene are kept as these.
    type Lane: Real;

    /// What a scene is placed in the world with, before it is narrowed: an `f64` with the derivatives
    /// that a lane has.
    type Wide: Real;

    /// The mask that holds in the lanes whose bits are set, lane 0 in the lowest bit.
    fn mask(lanes: u32) -> Self::Mask;

    /// The values.
    fn primal(self) -> Self::Lanes;

    /// A number whose derivatives are zero.
    fn constant(value: Self::Lanes) -> Self;

    /// The numbers that `f` gives for lanes 0, 1, ..
    fn from_each(f: impl FnMut(usize) -> Self::Lane) -> Self;

    /// The number in one lane.
    fn lane(self, lane: usize) -> Self::Lane;

    /// The same number in every lane.
    fn splat(element: Self::Lane) -> Self;

    /// A number in the precision of the lanes.
    fn narrow(wide: Self::Wide) -> Self::Lane;
}

macro_rules! lanes {
    ($($type:ident of $precision:ident,)*) => {$(
        impl Number for $type {
            type Lanes = Self;
            type Lane = <Self as Lanes>::Element;
            type Wide = f64;

            #[inline(always)]
            fn mask(lanes: u32) -> Self::Mask {
                Self::mask_from_bits(lanes)
            }

            #[inline(always)]
            fn primal(self) -> Self {
                self
            }

            #[inline(always)]
            fn constant(value: Self) -> Self {
                value
            }

            #[inline(always)]
            fn from_each(f: impl FnMut(usize) -> Self::Lane) -> Self {
                Self::from_lanes(f)
            }

            #[inline(always)]
            fn lane(self, lane: usize) -> Self::Lane {
                self.lanes().as_ref()[lane]
            }

            #[inline(always)]
            fn splat(element: Self::Lane) -> Self {
                Self::from_lanes(|_| element)
            }

            #[inline(always)]
            fn narrow(wide: f64) -> Self::Lane {
                <Self as Lanes>::Element::from_f64(wide)
            }
        }

        impl Plain for $type {
            fn vectors(of_lanes: &[Vec3<Self::Lane>]) -> Vectors<'_> {
                Vectors::$precision(of_lanes)
            }
        }
    )*};
}

lanes!(f32 of Single, f32x16 of Single, f64 of Double, f64x8 of Double,);

impl<L: Plain> Number for Dual<L> {
    type Lanes = L;
    type Lane = Dual<<L as Lanes>::Element>;
    type Wide = Dual<f64>;

    #[inline(always)]
    fn mask(lanes: u32) -> Self::Mask {
        L::mask_from_bits(lanes)
    }

    #[inline(always)]
    fn primal(self) -> L {
        self.value
    }

    #[inline(always)]
    fn constant(value: L) -> Self {
        Self::constant(value)
    }

    #[inline(always)]
    fn from_each(mut f: impl FnMut(usize) -> Self::Lane) -> Self {
        let mut derivatives = [<L as Lanes>::Element::ZERO; MAX_LANES];
        let value = L::from_lanes(|lane| {
            let element = f(lane);
            derivatives[lane] = element.derivative;
            element.value
        });
        Self::new(value, L::from_lanes(|lane| derivatives[lane]))
    }

    #[inline(always)]
    fn lane(self, lane: usize) -> Self::Lane {
        Dual::new(self.value.lane(lane), self.derivative.lane(lane))
    }

    #[inline(always)]
    fn splat(element: Self::Lane) -> Self {
        Self::new(L::from_lanes(|_| element.value), L::from_lanes(|_| element.derivative))
    }

    #[inline(always)]
    fn narrow(wide: Dual<f64>) -> Self::Lane {
        let narrow = <L as Lanes>::Element::from_f64;
        Dual::new(narrow(wide.value), narrow(wide.derivative))
    }
}

impl Number for Var {
    type Lanes = f64;
    type Lane = Self;
    type Wide = Self;

    fn mask(lanes: u32) -> bool {
        lanes & 1 == 1
    }

    fn primal(self) -> f64 {
        self.value()
    }

    fn constant(value: f64) -> Self {
        Self::from_f64(value)
    }

    fn from_each(mut f: impl FnMut(usize) -> Self) -> Self {
        f(0)
    }

    fn lane(self, _: usize) -> Self {
        self
    }

    fn splat(element: Self) -> Self {
        element
    }

    fn narrow(wide: Self) -> Self {
        wide
    }
}

/// Lanes without derivatives.
pub trait Plain: Lanes + Number<Lanes = Self, Lane = <Self as Lanes>::Element, Wide = f64> {
    /// Vectors of single lanes, whichever lanes these are.
    fn vectors(of_lanes: &[Vec3<Self::Lane>]) -> Vectors<'_>;
}

/// Vectors of either precision.
#[derive(Clone, Copy)]
pub enum Vectors<'a> {
    Single(&'a [glam::Vec3]),
    Double(&'a [glam::DVec3]),
}

impl Vectors<'_> {
    /// One of them.
    #[inline]
    pub fn at(self, index: u32) -> glam::DVec3 {
        match self {
            Self::Single(vectors) => vectors[index as usize].as_dvec3(),
            Self::Double(vectors) => vectors[index as usize],
        }
    }
}

/// The most lanes that a number has.
pub const MAX_LANES: usize = 16;

/// A vector of numbers with the same vector in every lane.
#[inline(always)]
pub fn splat_vector<S: Number>(v: Vec3<S::Lane>) -> Vec3<S> {
    Vector3::new(S::splat(v.x()), S::splat(v.y()), S::splat(v.z()))
}

/// A vector whose derivatives are zero.
#[inline(always)]
pub fn constant_vector<S: Number>(v: Vec3<S::Lanes>) -> Vec3<S> {
    Vector3::new(S::constant(v.x()), S::constant(v.y()), S::constant(v.z()))
}

/// The values of a vector.
#[inline(always)]
pub fn primal_vector<S: Number>(v: Vec3<S>) -> Vec3<S::Lanes> {
    Vector3::new(v.x().primal(), v.y().primal(), v.z().primal())
}

/// The value of a scalar at double precision.
#[inline(always)]
pub fn widen<S: Scalar>(v: Vec3<S>) -> glam::DVec3 {
    glam::DVec3::new(v.x().to_f64(), v.y().to_f64(), v.z().to_f64())
}
