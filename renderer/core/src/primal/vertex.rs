//! The radiance that leaves the path vertices of a lane group.

use ad::Vec3;
use ad::vector::{Vector, Vector3};

use super::coalesce::Coalesced;
use super::gather::Lookup;
use super::inputs::LightInputs;
use super::integrator::Integrator;
use super::wavefront::Occluder;
use super::wavefront::{LaneGroup, Wavefront};
use crate::counts::count;
use crate::number::Number;
use crate::scene::Slot;
use crate::settings::Pass;
use crate::trace::layout::Kind;
use crate::transport::depth::depth;
use crate::transport::direct::direct;
use crate::transport::hit::surface_uv;
use crate::transport::material::{Lobes, Material};
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::{Uv, modulate, modulate_facets, modulate_opacity};
use crate::transport::vertex::outgoing;

/// The textures of a lane group.
pub struct Textured<S: Number> {
    /// The materials without their textures.
    pub plain: Material<S>,
    pub uv: Uv<S>,
    /// The texture lookups of the material, by [`Slot`].
    pub lookups: [Option<Lookup<S>>; Slot::NUMBERS.len()],
}

/// The inputs of the path vertices of a lane group.
pub struct Vertex<'a, S: Number> {
    integrator: Integrator<'a, S>,
    pub group: &'a LaneGroup<S>,
    wavefront: &'a Wavefront<S>,
    /// The lanes by material.
    pub materials: Coalesced,
    /// On the heap, since vertices are moved about, and most have none.
    pub textured: Option<Box<Textured<S>>>,
    /// The materials, with their textures.
    pub material: Material<S>,
    /// A bit for each lane whose material is transparent.
    pub transparent: u32,
    pub lobes: Lobes,
    /// The radiance from where the rays go on, where they were traced.
    pub beyond: Option<Vec3<S>>,
}

impl<'a, S: Number> Integrator<'a, S> {
    /// Gathers the inputs of a group; `beyond` is the wavefront of the rays that go on from it.
    #[inline(always)]
    pub fn vertex(
        &self,
        group: &'a LaneGroup<S>,
        wavefront: &'a Wavefront<S>,
        beyond: Option<&Wavefront<S>>,
    ) -> Vertex<'a, S> {
        count(|counts| &counts.shaded, u64::from(group.alive.count_ones()));
        let materials = self.materials(&group.primitives);
        let mut material = self.material(&materials);
        let uv = || self.uv_of(group);
        let textured = self.textured(&Slot::NUMBERS, (group.kind, &materials), uv, &mut material);
        let lobes = materials.iter().map(|(material, _)| self.layout.materials[material].lobes);
        Vertex {
            integrator: *self,
            group,
            wavefront,
            material,
            textured,
            transparent: self.transparent_lanes(&materials),
            lobes: lobes.fold(self.zero_weight.lobes, Lobes::union),
            materials,
            beyond: beyond.map(|wavefront| wavefront.radiance[group.block()]),
        }
    }

    /// The texture coordinates of a group, if its primitives have any.
    fn uv_of(&self, group: &LaneGroup<S>) -> Option<Uv<S>> {
        let primitive = self.primitive(group.kind, &group.primitives)?;
        let corners = self.corner_uvs(group.kind, &group.primitives);
        Some(surface_uv::<S>(primitive, corners, group.surface.point))
    }

    /// The textures in some slots at the texture coordinates of points, if there are any; they vary the material.
    pub(super) fn textured(
        &self,
        slots: &[Slot],
        (kind, materials): (Kind, &Coalesced),
        uv: impl FnOnce() -> Option<Uv<S>>,
        material: &mut Material<S>,
    ) -> Option<Box<Textured<S>>> {
        let is_textured = |material: usize| self.layout.materials[material].textures.any_of(slots);
        if self.layout.textures.is_empty() || materials.lanes_where(is_textured) == 0 {
            return None;
        }
        let uv = uv()?;
        let lookup = |slot: Slot| {
            let is_wanted = slots.contains(&slot);
            is_wanted.then(|| self.lookup(slot, kind, materials, uv)).flatten()
        };
        let lookups = Slot::NUMBERS.map(lookup);
        let textured = Box::new(Textured { plain: *material, uv, lookups });
        textured.modulate(material);
        Some(textured)
    }
}

impl<S: Number> Textured<S> {
    /// Varies a material.
    fn modulate(&self, material: &mut Material<S>) {
        for slot in [Slot::Emission, Slot::Diffuse, Slot::Specular] {
            if let Some(lookup) = &self.lookups[slot as usize] {
                let color = color_of(material, slot);
                *color = modulate::<S>(*color, lookup.footprint, self.uv);
            }
        }
        if let Some(lookup) = &self.lookups[Slot::Opacity as usize] {
            material.opacity = modulate_opacity::<S>(material.opacity, lookup.footprint, self.uv);
        }
        if let Some(lookup) = &self.lookups[Slot::MetallicRoughness as usize] {
            let Material { roughness, metallic, .. } = *material;
            (material.roughness, material.metallic) =
                modulate_facets::<S>(roughness, metallic, lookup.footprint, self.uv);
        }
    }
}

/// The colour of a material that a texture varies.
#[inline]
fn color_of<S: Number>(material: &mut Material<S>, slot: Slot) -> &mut Vec3<S> {
    match slot {
        Slot::Emission => &mut material.emission,
        Slot::Diffuse => &mut material.diffuse,
        Slot::Specular => &mut material.specular,
        Slot::Opacity | Slot::MetallicRoughness | Slot::Normal => {
            unreachable!("{slot:?} is no colour")
        }
    }
}

impl<'a, S: Number> Vertex<'a, S> {
    /// The radiance that leaves towards the viewer.
    #[inline(always)]
    pub fn radiance(&self) -> Vec3<S> {
        if self.integrator.layout.path_tracing.is_some() {
            return self.scattered_radiance();
        }
        self.outgoing(self.own(self.lights()))
    }

    /// The rays that the group is among.
    pub fn wavefront(&self) -> &'a Wavefront<S> {
        self.wavefront
    }

    /// The lights of the scene.
    pub fn lights(&self) -> &'a [LightInputs<S>] {
        &self.integrator.inputs.lights
    }

    /// The lanes where a light is visible.
    #[inline]
    pub fn visible(&self, light: usize) -> S::Mask {
        S::mask(self.group.lanes_of(self.wavefront.visible[light]))
    }

    /// What transparent surfaces leave of a light, if there are any in the scene.
    #[inline]
    pub fn transmittance(&self, light: usize) -> Option<S> {
        let transmission = self.wavefront.transmissions.get(light)?;
        Some(transmission.of(self.group))
    }

    /// The transparent surfaces between a light and the group, which has this index in its wavefront.
    pub fn occluders(&self, light: usize) -> &'a [Occluder<S>] {
        match self.wavefront.transmissions.get(light) {
            Some(transmission) => transmission.occluders_of(self.group.index),
            None => &[],
        }
    }

    /// The radiance of the surfaces themselves under the first of the lights.
    // A call would move more than it computes: 3 % of an image.
    #[inline(always)]
    pub fn own(&self, lights: &[LightInputs<S>]) -> Vec3<S> {
        let own = match self.integrator.layout.pass {
            Pass::Radiance => self.material.emission,
            Pass::Albedo => self.material.diffuse,
            Pass::Coverage => Vec3::<S>::splat(S::ONE),
            measure => self.measured(measure),
        };
        self.add_direct(own, lights)
    }

    /// What a pass that measures shapes shows of the surfaces.
    #[inline(never)]
    fn measured(&self, measure: Pass) -> Vec3<S> {
        let Integrator { inputs, .. } = self.integrator;
        let SurfacePoint { point, normal, .. } = self.group.surface;
        match measure {
            Pass::Depth => Vec3::<S>::splat(depth::<S>(inputs.frame, point)),
            Pass::Position => point + inputs.world_origin(),
            Pass::Uv => {
                let uv = self.integrator.uv_of(self.group);
                let none = Uv { u: S::ZERO, v: S::ZERO };
                let Uv { u, v } = uv.unwrap_or(none);
                Vector3::new(u, v, S::ZERO)
            }
            Pass::Ids => self.group.primitives.gather::<S, _>(|primitive| {
                let ids = self.integrator.layout.ids_of(primitive);
                let [x, y, z] = ids.map(|id| S::from_f64(id as f64));
                Vector3::new(x, y, z)
            }),
            _ => normal,
        }
    }

    /// Adds what the surfaces reflect of lights.
    #[inline(always)]
    pub fn add_direct(&self, mut own: Vec3<S>, lights: &[LightInputs<S>]) -> Vec3<S> {
        for (index, light) in lights.iter().enumerate() {
            own = own + self.direct(index, light);
        }
        own
    }

    #[inline(always)]
    fn direct(&self, index: usize, light: &LightInputs<S>) -> Vec3<S> {
        let (surface, visible) = (self.group.surface, self.visible(index));
        let light = light.illuminate(surface.point);
        let direct = |left| direct::<S>(self.material, self.lobes, surface, light, visible, left);
        match self.transmittance(index) {
            // With a constant there is no product.
            None => direct(S::ONE),
            Some(left) => direct(left),
        }
    }

    /// The radiance that leaves towards the viewer, by that of the surfaces themselves.
    #[inline(always)]
    pub fn outgoing(&self, own: Vec3<S>) -> Vec3<S> {
        match self.goes_on() {
            None => own,
            Some(beyond) => {
                let Material { opacity, mirror, .. } = self.material;
                outgoing::<S>(opacity, mirror, S::mask(self.transparent), own, beyond)
            }
        }
    }

    /// The radiance from where rays go on; zero behind transparent surfaces where the path ends. Nothing
    /// if no ray goes on from the group.
    #[inline(always)]
    pub fn goes_on(&self) -> Option<Vec3<S>> {
        let is_radiance = self.integrator.layout.pass == Pass::Radiance;
        match self.beyond {
            Some(beyond) if is_radiance => Some(beyond),
            _ if self.transparent != 0 => Some(Vec3::<S>::splat(S::ZERO)),
            _ => None,
        }
    }
}
