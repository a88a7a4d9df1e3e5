//! What glam computes with vectors and motions, as formulas over any scalar: the value of a rule comes
//! from glam, and both modes differentiate the formula.

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
