//! Groups of triangles whose normals are bent by normal maps.

use ad::lanes::Lanes;
use ad::{Fields, select};

use super::coalesce::Coalesced;
use super::integrator::Integrator;
use super::wavefront::{Bent, LaneGroup, Mapped};
use crate::number::{Number, primal_vector};
use crate::scene::Slot;
use crate::trace::layout::Kind;
use crate::transport::hit::{Primitive, surface_uv};
use crate::transport::normal_map::{NormalMap, mapped_normal, rounded_normal};
use crate::transport::surface::SurfacePoint;

/// Surface points, what they have if their normals are bent, and their normal maps.
type MappedSurface<S> = (SurfacePoint<S>, Option<Bent<S>>, Option<Box<Mapped<S>>>);

impl<S: Number> Integrator<'_, S> {
    /// Surface points whose normals the normal maps of triangles have bent, and these maps, if any of them has
    /// one.
    #[inline(never)]
    pub fn map_normals(
        &self,
        kind: Kind,
        primitives: &Coalesced,
        surface: SurfacePoint<S>,
        bent: Option<Bent<S>>,
    ) -> MappedSurface<S> {
        let materials = self.materials(primitives);
        let has_map =
            |material: usize| self.layout.materials[material].textures.get(Slot::Normal).is_some();
        if kind != Kind::Triangle || materials.lanes_where(has_map) == 0 {
            return (surface, bent, None);
        }
        let triangle = self.triangle(primitives);
        let corners = self.corner_uvs(kind, primitives);
        let uv = surface_uv::<S>(Primitive::Triangle(triangle), corners, surface.point);
        let Some(lookup) = self.lookup(Slot::Normal, kind, &materials, uv) else {
            return (surface, bent, None);
        };
        let scale = |triangle: usize| S::from_f64(self.layout.normal_scale(triangle));
        let scale = primitives.gather::<S, S>(scale);
        let map = NormalMap { footprint: lookup.footprint, uv, scale };
        let mapped = S::mask(lookup.lanes);
        let normal = mapped_normal::<S>(triangle, corners, surface, map, mapped);
        let bent = bent.unwrap_or_else(|| Bent {
            outward: surface.normal,
            curved: primal_vector::<S>(surface.point),
        });
        let mapped = Mapped { normal: surface.normal, lookup, map };
        (SurfacePoint { normal, ..surface }, Some(bent), Some(Box::new(mapped)))
    }
}

impl<S: Number> LaneGroup<S> {
    /// The surface points as paths are scattered there, to lobes of this width: with the shading normals, or,
    /// where a map bends them, with normals close to these that do not vary.
    pub fn scattering_surface(&self, width: S::Lanes) -> SurfacePoint<S::Lanes> {
        let surface = self.surface.map(S::primal);
        let Some(mapped) = &self.mapped else { return surface };
        let plain = primal_vector::<S>(mapped.normal);
        let rounded = rounded_normal::<S::Lanes>(plain, surface.normal, width);
        let is_mapped = S::Lanes::mask_from_bits(mapped.lookup.lanes);
        SurfacePoint { normal: select(is_mapped, rounded, plain), ..surface }
    }
}
