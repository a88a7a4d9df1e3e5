//! The radiance that leaves the vertices of scattered paths.

use ad::lanes::Lanes;
use ad::vector::Vector;
use ad::{Real, Vec3};

use super::Event;
use crate::number::Number;
use crate::primal::coalesce::select_lanes;
use crate::primal::vertex::Vertex;
use crate::primal::wavefront::LaneGroup;
use crate::transport::dielectric::sent_on_by_dielectric;
use crate::transport::direct::direct;
use crate::transport::emitter::found_emission;
use crate::transport::material::Bsdf;
use crate::transport::scatter::{gathered, sent_on};

impl<S: Number> Vertex<'_, S> {
    /// The radiance that leaves towards the viewer where light takes all paths.
    #[inline(never)]
    pub fn scattered_radiance(&self) -> Vec3<S> {
        let (own, opacity) = (self.scattered_own(), self.material.opacity);
        gathered::<S>(opacity, own, self.sent_on(), self.scattered_beyond())
    }

    /// What the surfaces emit, where that counts, and what they reflect of lights and of emitters that were
    /// looked for.
    pub fn scattered_own(&self) -> Vec3<S> {
        let scattering = &self.wavefront().scattering;
        let weight = scattering.found[self.group.block()];
        let mut own = found_emission::<S>(self.material.emission, weight);
        if self.looks_for_light() {
            own = self.add_direct(own, self.lights());
        }
        for sample in scattering.emitters_of(self.group.index) {
            let visible = S::mask(sample.lanes);
            let illumination = sample.illumination;
            own = own
                + direct::<S>(
                    self.material,
                    self.lobes,
                    self.group.surface,
                    illumination,
                    visible,
                    S::ONE,
                );
        }
        own
    }

    /// Whether the surfaces reflect light that is looked for: not where paths end, nor if they are smooth.
    pub fn looks_for_light(&self) -> bool {
        !self.wavefront().scattering.events.is_empty() && self.group.bsdf != Bsdf::Dielectric
    }

    /// The part that the surfaces send on of what paths bring.
    fn sent_on(&self) -> Vec3<S> {
        let Event { direction, straight, mirrored, factor } = self.event();
        let (straight, mirrored) = (S::mask(straight), S::mask(mirrored));
        let surface = self.group.surface;
        if self.group.bsdf == Bsdf::Dielectric {
            let inside = S::mask(self.group.inside);
            return sent_on_by_dielectric::<S>(self.material, surface, inside, mirrored, factor);
        }
        let (material, lobes) = (self.material, self.lobes);
        sent_on::<S>(material, lobes, surface, direction, straight, mirrored, factor)
    }

    /// How the paths go on.
    pub fn event(&self) -> Event<S> {
        match self.wavefront().scattering.events.get(self.group.block()) {
            Some(event) => *event,
            None => Event::end(),
        }
    }

    /// The radiance from where paths go on.
    pub fn scattered_beyond(&self) -> Vec3<S> {
        self.beyond.unwrap_or(Vec3::<S>::splat(S::ZERO))
    }
}

impl<S: Number> Event<S> {
    /// All paths end.
    pub fn end() -> Self {
        let zero = Vec3::<S>::splat(S::ZERO);
        Self { direction: zero, straight: 0, mirrored: 0, factor: S::ZERO }
    }

    /// Lets the paths in some lanes go on, in which they have ended so far.
    pub fn put(&mut self, lanes: u32, event: &Self) {
        self.direction = select_lanes::<S, _>(lanes, &event.direction, &self.direction);
        self.straight |= event.straight & lanes;
        self.mirrored |= event.mirrored & lanes;
        self.factor = select_lanes::<S, _>(lanes, &event.factor, &self.factor);
    }
}

impl<S: Number> LaneGroup<S> {
    /// A bit for each lane in which a direction leaves the surface on the side of the viewer, as it is
    /// shaded and as it is.
    pub(super) fn leave_surface(&self, direction: Vec3<S::Lanes>) -> u32 {
        let (_, normal) = self.geometry();
        self.face(direction) & S::Lanes::mask_bits(normal.dot(direction).cmpgt(S::Lanes::ZERO))
    }

    /// A bit for each lane in which a direction leaves the surface on the side of the viewer, as it is shaded.
    fn face(&self, direction: Vec3<S::Lanes>) -> u32 {
        let (_, normal) = self.values();
        S::Lanes::mask_bits(normal.dot(direction).cmpgt(S::Lanes::ZERO)) & self.alive
    }

    /// A bit for each lane that may be lit from a direction. Smooth triangles have light from behind themselves, as
    /// they have that of lights: shadow rays start [above them](crate::transport::smooth::curved_point()).
    pub(super) fn lit_from(&self, direction: Vec3<S::Lanes>) -> u32 {
        if self.is_smooth { self.face(direction) } else { self.leave_surface(direction) }
    }
}
