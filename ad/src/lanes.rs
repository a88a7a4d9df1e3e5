//! Several numbers side by side, for one instruction to work on.
//!
//! [`f32x8`], [`f32x16`] and [`f64x8`] are [`Real`], so a generic kernel and its generated
//! derivative run on 8 or 16 inputs at once. [`Lanes`] puts numbers into lanes and takes
//! them out again; plain `f32` and `f64` are one lane wide.
//!
//! Values agree with those of the scalar functions to a few units in the last place: `exp`, `ln`,
//! `powf` and the trigonometric functions are polynomials here, not the system's library. Angles are an
//! exception beyond 10^4 in single and 10^8 in double precision, where the error grows with their size
//! (`sin` is off by 1e-6 at 10^5 and by 0.03 at 10^6 in single, by 4e-8 at 10^9 in double precision), and so
//! are powers of infinite bases, which are finite.

use core::ops::{BitAnd, BitOr, Not};

pub use wide::{f32x8, f32x16, f64x8};
use wide::{u32x8, u32x16, u64x8};

use crate::vector::Xyz;
use crate::{Additive, Differentiable, Mask, NoDerivative, Real, Scalar, Select};

/// A [`Real`] made of [`COUNT`](Lanes::COUNT) numbers.
pub trait Lanes: Real {
    /// The type of one number.
    type Element: Scalar;

    /// How many there are.
    const COUNT: usize;

    /// The numbers that `f` gives for lanes 0, 1, ..
    fn from_lanes(f: impl FnMut(usize) -> Self::Element) -> Self;

    /// All of them; iterates from lane 0 on.
    fn lanes(self) -> impl AsRef<[Self::Element]>;

    /// The mask that holds in the lanes whose bits are set, lane 0 in the lowest bit.
    fn mask_from_bits(bits: u32) -> Self::Mask;

    /// Whether the mask holds in each lane, lane 0 in the lowest bit.
    fn mask_bits(mask: Self::Mask) -> u32;
}

macro_rules! single_lane {
    ($type:ident) => {
        impl Lanes for $type {
            type Element = $type;

            const COUNT: usize = 1;

            #[inline(always)]
            fn from_lanes(mut f: impl FnMut(usize) -> $type) -> $type {
                f(0)
            }

            #[inline(always)]
            fn lanes(self) -> impl AsRef<[$type]> {
                [self]
            }

            #[inline(always)]
            fn mask_from_bits(bits: u32) -> bool {
                bits & 1 == 1
            }

            #[inline(always)]
            fn mask_bits(mask: bool) -> u32 {
                mask.into()
            }
        }
    };
}

single_lane!(f32);
single_lane!(f64);

/// A mask: one truth value for each lane of `T`, all bits of which are set, or none.
#[derive(Clone, Copy, Debug)]
pub struct LaneMask<T>(T);

macro_rules! lanes {
    ($type:ident: $count:literal of $element:ident, bits in $bits:ident, splitter $splitter:literal) => {
        impl Differentiable for $type {
            type Tangent = Self;
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}

            #[inline(always)]
            fn irregularity(&self) -> f64 {
                if Real::is_finite(*self).all() { 0.0 } else { f64::NAN }
            }
        }

        impl Additive for $type {
            #[inline(always)]
            fn zero() -> Self {
                Self::splat(-0.0)
            }

            #[inline(always)]
            fn accumulate(&mut self, other: Self) {
                *self += other;
            }
        }

        impl Differentiable for LaneMask<$type> {
            type Tangent = ();
            type Shape = ();

            #[inline(always)]
            fn shape(&self) {}
        }

        impl NoDerivative for LaneMask<$type> {}

        impl BitAnd for LaneMask<$type> {
            type Output = Self;

            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl BitOr for LaneMask<$type> {
            type Output = Self;

            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl Not for LaneMask<$type> {
            type Output = Self;

            #[inline(always)]
            fn not(self) -> Self {
                Self(!self.0)
            }
        }

        impl Mask for LaneMask<$type> {
            #[inline(always)]
            fn splat(value: bool) -> Self {
                let zero = $type::ZERO;
                Self(if value { !zero } else { zero })
            }

            #[inline(always)]
            fn all(self) -> bool {
                self.0.all()
            }

            #[inline(always)]
            fn any(self) -> bool {
                self.0.any()
            }
        }

        impl Select for $type {
            type Mask = LaneMask<$type>;

            #[inline(always)]
            fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self {
                mask.0.select(if_true, if_false)
            }
        }

        impl Lanes for $type {
            type Element = $element;

            const COUNT: usize = $count;

            #[inline(always)]
            fn from_lanes(f: impl FnMut(usize) -> $element) -> Self {
                Self::new(core::array::from_fn(f))
            }

            #[inline(always)]
            fn lanes(self) -> impl AsRef<[$element]> {
                self.to_array()
            }

            #[inline(always)]
            fn mask_from_bits(bits: u32) -> Self::Mask {
                let bit = $bits::new(core::array::from_fn(|lane| 1 << lane));
                LaneMask(Self::from_bits(($bits::splat(bits.into()) & bit).simd_eq(bit)))
            }

            #[inline(always)]
            fn mask_bits(mask: Self::Mask) -> u32 {
                mask.0.to_bitmask()
            }
        }

        impl Real for $type {
            type Vec3 = Xyz<Self>;

            const ZERO: Self = Self::splat(0.0);
            const ONE: Self = Self::splat(1.0);
            const TWO: Self = Self::splat(2.0);
            const HALF: Self = Self::splat(0.5);
            const PI: Self = Self::splat(core::$element::consts::PI);
            const EPSILON: Self = Self::splat($element::EPSILON);
            const MIN_POSITIVE: Self = Self::splat($element::MIN_POSITIVE);

            #[inline(always)]
            fn from_f64(value: f64) -> Self {
                Self::splat(value as $element)
            }

            lanes!(@compare $type: cmplt simd_lt, cmple simd_le, cmpgt simd_gt, cmpge simd_ge, cmpeq simd_eq);

            #[inline(always)]
            fn is_finite(self) -> Self::Mask {
                LaneMask($type::is_finite(self))
            }

            #[inline(always)]
            fn vanishes(self) -> Self::Mask {
                self.cmpeq(<Self as Real>::ZERO)
            }

            #[inline(always)]
            fn clamp(self, low: Self, high: Self) -> Self {
                $type::max(self, low).min(high)
            }

            // The instruction for reciprocals is an approximation.
            #[inline(always)]
            fn recip(self) -> Self {
                <Self as Real>::ONE / self
            }

            #[inline(always)]
            fn difference_of_products(a: Self, b: Self, c: Self, d: Self) -> Self {
                let product = c * d;
                let error = if cfg!(target_feature = "fma") {
                    $type::mul_neg_add(c, d, product)
                } else {
                    product_error(c, d, product, $type::splat($splitter))
                };
                let difference = if cfg!(target_feature = "fma") {
                    $type::mul_sub(a, b, product)
                } else {
                    let other = a * b;
                    let other_error = product_error(a, b, other, $type::splat($splitter));
                    other - product - other_error
                };
                difference + error
            }

            #[inline(always)]
            fn powf(self, exponent: Self) -> Self {
                $type::powf_simd(self, exponent)
            }

            /// By repeated squaring.
            #[inline(always)]
            fn powi(self, exponent: i32) -> Self {
                let (mut power, mut square) = (<Self as Real>::ONE, self);
                let mut remaining = exponent.unsigned_abs();
                while remaining > 0 {
                    if remaining & 1 == 1 {
                        power *= square;
                    }
                    square *= square;
                    remaining >>= 1;
                }
                if exponent < 0 { Real::recip(power) } else { power }
            }

            lanes!(@unary $type: abs floor signum sqrt exp ln sin cos tan asin acos atan tanh);
            lanes!(@binary $type: min max copysign atan2);

            #[inline(always)]
            fn mul_add(self, a: Self, b: Self) -> Self {
                $type::mul_add(self, a, b)
            }
        }
    };
    (@compare $type:ident: $($name:ident $method:ident),*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> LaneMask<$type> {
            LaneMask($type::$method(self, other))
        }
    )*};
    (@unary $type:ident: $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self) -> Self {
            $type::$name(self)
        }
    )*};
    (@binary $type:ident: $($name:ident)*) => {$(
        #[inline(always)]
        fn $name(self, other: Self) -> Self {
            $type::$name(self, other)
        }
    )*};
}

// The splitters are 2^12 + 1 and 2^27 + 1: they cut the 24 bits of an `f32` and the 53 of an `f64`
// into halves (Veltkamp).
lanes!(f32x8: 8 of f32, bits in u32x8, splitter 4097.0);
lanes!(f32x16: 16 of f32, bits in u32x16, splitter 4097.0);
lanes!(f64x8: 8 of f64, bits in u64x8, splitter 134_217_729.0);

/// `product - a * b`, exactly, for machines without a fused instruction (Dekker 1971).
#[inline(always)]
fn product_error<S: Real>(a: S, b: S, product: S, splitter: S) -> S {
    let split = |x: S| {
        let scaled = x * splitter;
        let high = scaled - (scaled - x);
        (high, x - high)
    };
    let ((a_high, a_low), (b_high, b_low)) = (split(a), split(b));
    (product - a_high * b_high - a_high * b_low - a_low * b_high) - a_low * b_low
}
