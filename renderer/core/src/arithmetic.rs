//! What the kernels compute in.

/// The scalar of the kernels, and how many pixels go through them side by side.
///
/// Images, losses and gradients of different widths agree to rounding: some functions, such as
/// powers, are polynomials on lanes and the system's library on single numbers.
///
/// Each takes its time to compile, so there is one for either precision, and single numbers with the feature
/// `single-lane`: to compare and to test. Turned down: 8 lanes of single precision, which take 1.1 times as long as 16;
/// where a register holds 8 (AVX2 alone), an image takes as long with 16, a gradient 0.9 times as long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Single precision, pixel by pixel.
    #[cfg(feature = "single-lane")]
    F32,
    /// Single precision, 16 pixels at a time.
    F32x16,
    /// Double precision, pixel by pixel.
    #[cfg(feature = "single-lane")]
    F64,
    /// Double precision, 8 pixels at a time.
    F64x8,
}

/// The precision of a scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl Arithmetic {
    /// All arithmetics that this build has.
    pub const ALL: &[Self] = &[
        #[cfg(feature = "single-lane")]
        Self::F32,
        Self::F32x16,
        #[cfg(feature = "single-lane")]
        Self::F64,
        Self::F64x8,
    ];

    /// The scalar and the number of lanes in a word: `f32x16`.
    pub fn name(self) -> &'static str {
        match self {
            #[cfg(feature = "single-lane")]
            Self::F32 => "f32",
            Self::F32x16 => "f32x16",
            #[cfg(feature = "single-lane")]
            Self::F64 => "f64",
            Self::F64x8 => "f64x8",
        }
    }

    /// The fastest arithmetic of the given precision.
    pub fn fastest(precision: Precision) -> Self {
        match precision {
            Precision::F32 => Self::F32x16,
            Precision::F64 => Self::F64x8,
        }
    }

    /// The precision of its scalar.
    pub fn precision(self) -> Precision {
        match self {
            Self::F32x16 => Precision::F32,
            Self::F64x8 => Precision::F64,
            #[cfg(feature = "single-lane")]
            Self::F32 => Precision::F32,
            #[cfg(feature = "single-lane")]
            Self::F64 => Precision::F64,
        }
    }
}

/// The fastest in single precision.
impl Default for Arithmetic {
    fn default() -> Self {
        Self::fastest(Precision::F32)
    }
}

/// Runs `$body` with the type `$scalar` standing for that of an [`Arithmetic`].
macro_rules! with_arithmetic {
    ($arithmetic:expr, $scalar:ident => $body:expr) => {
        match $arithmetic {
            #[cfg(feature = "single-lane")]
            $crate::arithmetic::Arithmetic::F32 => {
                type $scalar = f32;
                $body
            }
            $crate::arithmetic::Arithmetic::F32x16 => {
                type $scalar = ad::lanes::f32x16;
                $body
            }
            #[cfg(feature = "single-lane")]
            $crate::arithmetic::Arithmetic::F64 => {
                type $scalar = f64;
                $body
            }
            $crate::arithmetic::Arithmetic::F64x8 => {
                type $scalar = ad::lanes::f64x8;
                $body
            }
        }
    };
}

pub(crate) use with_arithmetic;
