//! Groups of triangles whose normals are bent by normal maps.

use ad::lanes::Lanes;
use ad::{Fields, Vec3, select};

use super::coalesce::Coalesced;
use super::gather::Lookup;
use super::integrator::Integrator;
use super::wavefront::{Bent, LaneGroup};
use crate::number::{Number, primal_vector};
use crate::scene::Slot;
use crate::trace::layout::Kind;
use crate::transport::hit::{Primitive, surface_uv};
use crate::transport::normal_map::{NormalMap, mapped_normal, rounded_normal};
use crate::transport::surface::SurfacePoint;

/// The normal maps of a group.
pub struct Mapped<S: Number> {
    /// The shading normals without them.
    pub normal: Vec3<S>,
    /// The texels, in the lanes that have a map.
    pub lookup: Lookup<S>,
    pub map: NormalMap<S>,
}

impl<S: Number> Integrator<'_, S> {
    /// The normal maps of triangles at surface points, if any of them has one; they bend the normals of the
    /// points.
    #[inline]
    pub fn map_normals(
        &self,
        kind: Kind,
        primitives: &Coalesced,
        surface: &mut SurfacePoint<S>,
        bent: &mut Option<Bent<S>>,
    ) -> Option<Box<Mapped<S>>> {
        if !self.layout.has_normal_maps || kind != Kind::Triangle {
            return None;
        }
        let materials = self.materials(primitives);
        let has_map =
            |material: usize| self.layout.materials[material].textures.get(Slot::Normal).is_some();
        if materials.lanes_where(has_map) == 0 {
            return None;
        }
        let triangle = self.triangle(primitives);
        let corners = self.corner_uvs(kind, primitives);
        let uv = surface_uv::<S>(Primitive::Triangle(triangle), corners, surface.point);
        let lookup = self.lookup(Slot::Normal, &materials, uv)?;
        let scale = |triangle: usize| S::from_f64(self.layout.normal_scale(triangle));
        let scale = primitives.gather::<S, S>(scale);
        let map = NormalMap { footprint: lookup.footprint, uv, scale };
        let normal = surface.normal;
        let mapped = S::mask(lookup.lanes);
        surface.normal = mapped_normal::<S>(triangle, corners, *surface, map, mapped);
        bent.get_or_insert_with(|| Bent {
            outward: normal,
            curved: primal_vector::<S>(surface.point),
        });
        Some(Box::new(Mapped { normal, lookup, map }))
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
