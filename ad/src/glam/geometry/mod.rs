//! What glam computes with vectors and motions, as formulas over any scalar: the value of a rule comes
//! from glam, and both modes differentiate the formula.

/// Differentiable functions over any scalar `S`, one a row: the name, the lengths of arrays that the types
/// tell, in brackets, arguments and result, and the formula.
macro_rules! formulas {
    ($(
        $(#[$doc:meta])*
        $name:ident $([$($length:ident),*])? ($($x:tt: $X:ty),*) -> $R:ty = $formula:expr;
    )*) => {$(
        $(#[$doc])*
        #[ad_macros::differentiable]
        pub fn $name<S: crate::Real $($(, const $length: usize)*)?>($($x: $X),*) -> $R {
            $formula
        }
    )*};
}

pub mod matrix;
pub mod motion;
pub mod rotation;
pub mod vector;

/// A vector of space.
type Triple<S> = [S; 3];

/// A quaternion: x, y, z, w.
type Quaternion<S> = [S; 4];

/// The columns of a matrix.
type Columns<S> = [[S; 3]; 3];

/// Whether a comparison holds in every lane.
fn holds<M: crate::Mask>(condition: M) -> bool {
    condition.all()
}
