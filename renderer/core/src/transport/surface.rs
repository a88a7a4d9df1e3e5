//! Surface points.

use ad::{Differentiable, Fields, Real, Vec3};

/// A point of a surface, as shading needs it.
#[derive(Clone, Copy, Debug, Differentiable, Fields)]
pub struct SurfacePoint<S: Real> {
    /// The position.
    pub point: Vec3<S>,
    /// The unit normal, on the side of the viewer.
    pub normal: Vec3<S>,
    /// The unit vector towards the viewer.
    pub view: Vec3<S>,
}
