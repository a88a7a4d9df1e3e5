//! From normals that normal maps have bent to texels, triangles, and the normals as they are.

use ad::{Additive, Tangent};

use super::chain::Chain;
use crate::number::Plain;
use crate::primal::wavefront::{LaneGroup, Mapped};
use crate::transport::normal_map::mapped_normal;
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::Uv;
use crate::transport::triangle::Triangle;

impl<L: Plain> Chain<'_, L> {
    /// Turns the cotangents of surface points whose normals are bent into those of points whose normals are
    /// not; returns those of the triangles and of the texture coordinates of the points.
    #[inline(never)]
    pub(super) fn pull_mapped_normal(
        &mut self,
        group: &LaneGroup<L>,
        mapped: &Mapped<L>,
        surface: &mut Tangent<SurfacePoint<L>>,
    ) -> (Tangent<Triangle<L>>, Tangent<Uv<L>>) {
        let triangle = self.integrator.triangle(&group.primitives);
        let corners = self.integrator.corner_uvs(group.kind, &group.primitives);
        let plain = SurfacePoint { normal: mapped.normal, ..group.surface };
        let lanes = mapped.lookup.lanes;
        let (_, pullback) =
            mapped_normal::vjp::<L>(triangle, corners, plain, mapped.map, L::mask(lanes));
        let (triangle, corners, of_plain, map, ()) = pullback(surface.normal);
        self.scatter_texels(&mapped.lookup, lanes, map.footprint.texels);
        self.scatter_uvs(group.kind, &group.primitives, corners);
        surface.normal = Additive::zero();
        surface.accumulate(of_plain);
        (triangle, map.uv)
    }
}
