//! What flows back from view to view.

use ad::lanes::Lanes;
use ad::{Additive, Tangent, Vec3};

use crate::integrator::mirrors::blocks;
use crate::kernels::camera::Ray;
use crate::kernels::surface::SurfacePoint;
use crate::kernels::texture::Uv;

/// What flows back to surface points.
#[derive(Clone, Copy)]
pub(super) struct ToSurface<L: Lanes> {
    pub surface: Tangent<SurfacePoint<L>>,
    /// To their places on textures, if they have any.
    pub uv: Option<Tangent<Uv<L>>>,
}

/// What flows back to a view.
pub(super) struct Flow<L: Lanes> {
    /// By group: the cotangents of the surface points, unless they are zero.
    pub surfaces: Vec<Option<ToSurface<L>>>,
    /// The cotangents of the radiance that rays bring which go on, in vectors of lanes.
    pub radiance: Vec<Vec3<L>>,
    /// The cotangents of the rays that go on, in vectors of lanes.
    pub rays: Vec<Tangent<Ray<L>>>,
}

impl<L: Lanes> Default for Flow<L> {
    fn default() -> Self {
        Self { surfaces: Vec::new(), radiance: Vec::new(), rays: Vec::new() }
    }
}

impl<L: Lanes> Flow<L> {
    /// Nothing flows yet to a view of rays that go on.
    pub fn start(&mut self) {
        self.radiance.clear();
        self.radiance.resize(blocks::<L>(), Additive::zero());
        self.rays.clear();
        self.rays.resize(blocks::<L>(), Additive::zero());
    }
}
