//! Gather: from the numbers of a scene to lanes of inputs.

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Vec3};

use super::coalesce::{Coalesced, select_lanes};
use super::integrator::Integrator;
use super::lanes::numbers_of_lanes;
use crate::counts::count;
use crate::number::{MAX_LANES, Number, splat_vector};
use crate::scene::Slot;
use crate::trace::bvh::rays;
use crate::trace::layout::{Kind, TextureLayout};
use crate::transport::camera::Ray;
use crate::transport::hit::{Primitive, hit};
use crate::transport::material::Material;
use crate::transport::sphere::Sphere;
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::{Footprint, Uv, texel_position};
use crate::transport::triangle::Triangle;

/// What a texture gives for one number of the materials of a lane group.
pub struct Lookup<S: Number> {
    /// A bit for each lane that has a texture. In the others all texels are white.
    pub lanes: u32,
    /// The indices of the texels among those of all textures, by lane.
    pub indices: [[u32; 4]; MAX_LANES],
    pub footprint: Footprint<S>,
}

impl<S: Number> Integrator<'_, S> {
    /// The points where rays meet primitives of one kind.
    #[inline]
    pub fn surface(
        &self,
        kind: Kind,
        primitives: &Coalesced,
        inside: u32,
        ray: Ray<S>,
    ) -> SurfacePoint<S> {
        match self.primitive(kind, primitives) {
            Some(primitive) => hit::<S>(primitive, S::mask(inside), ray),
            None => self.custom_surface(primitives, ray),
        }
    }

    /// The primitives, unless they are custom shapes.
    #[inline]
    pub fn primitive(&self, kind: Kind, primitives: &Coalesced) -> Option<Primitive<S>> {
        match kind {
            Kind::Triangle => Some(Primitive::Triangle(self.triangle(primitives))),
            Kind::Sphere => Some(Primitive::Sphere(self.sphere(primitives))),
            Kind::Custom => None,
        }
    }

    #[inline]
    pub fn triangle(&self, primitives: &Coalesced) -> Triangle<S> {
        let vertex = |vertex: u32| splat_vector::<S>(self.inputs.vertices[vertex as usize]);
        primitives.gather::<S, _>(|triangle| {
            let [a, b, c] = self.layout.triangles[triangle];
            Triangle { a: vertex(a), b: vertex(b), c: vertex(c) }
        })
    }

    #[inline]
    fn sphere(&self, primitives: &Coalesced) -> Sphere<S> {
        primitives.gather::<S, _>(|primitive| {
            let (_, index) = self.layout.kind_of(primitive);
            self.inputs.spheres[index].map(S::splat)
        })
    }

    fn custom_surface(&self, primitives: &Coalesced, ray: Ray<S>) -> SurfacePoint<S> {
        let mut shapes = primitives.iter().map(|(primitive, lanes)| {
            let (_, index) = self.layout.kind_of(primitive);
            (self.inputs.shapes[index].point(ray), lanes)
        });
        let zero = Vec3::<S>::splat(S::ZERO);
        let first = shapes.next().map(|(surface, _)| surface);
        let first = first.unwrap_or(SurfacePoint { point: zero, normal: zero, view: zero });
        shapes.fold(first, |chosen, (surface, lanes)| SurfacePoint {
            point: select_lanes::<S, _>(lanes, &surface.point, &chosen.point),
            normal: select_lanes::<S, _>(lanes, &surface.normal, &chosen.normal),
            view: chosen.view,
        })
    }

    /// The lanes by material.
    #[inline]
    pub fn materials(&self, primitives: &Coalesced) -> Coalesced {
        primitives.map(|primitive| self.layout.material_of[primitive])
    }

    /// The materials, without textures.
    #[inline]
    pub fn material(&self, materials: &Coalesced) -> Material<S> {
        materials.gather::<S, _>(|material| self.inputs.materials[material].map(S::splat))
    }

    /// A bit for each lane whose material is transparent.
    #[inline]
    pub fn transparent_lanes(&self, materials: &Coalesced) -> u32 {
        if !self.layout.has_transparency {
            return 0;
        }
        materials.lanes_where(|material| self.layout.materials[material].is_transparent)
    }

    /// The texture coordinates of the corners of triangles.
    pub fn corner_uvs(&self, kind: Kind, primitives: &Coalesced) -> [Uv<S>; 3] {
        let none = [Uv { u: S::ZERO, v: S::ZERO }; 3];
        if kind != Kind::Triangle {
            return none;
        }
        let uv = |index: u32| self.inputs.uvs[index as usize].map(S::splat);
        primitives.gather::<S, [Uv<S>; 3]>(|triangle| {
            // A scene without textures has none.
            let corners = self.layout.uvs.of(triangle);
            corners.map_or(none, |corners| corners.map(uv))
        })
    }

    /// The texels around texture coordinates on primitives of a kind, in the textures that their materials have
    /// in a slot, if any has one.
    pub fn lookup(
        &self,
        slot: Slot,
        kind: Kind,
        materials: &Coalesced,
        uv: Uv<S>,
    ) -> Option<Lookup<S>> {
        let mut textures = [None; MAX_LANES];
        let mut lanes = 0;
        for (material, of_material) in materials.iter() {
            if let Some(texture) = self.layout.materials[material].textures.get(slot) {
                lanes |= of_material;
                rays(of_material.into()).for_each(|lane| textures[lane] = Some(texture as usize));
            }
        }
        let texture_of = |lane: usize| {
            textures[lane].map(|texture| (texture, self.layout.textures[texture].on(kind)))
        };
        (lanes != 0).then(|| self.texels(texture_of, lanes, uv))
    }

    /// The texels around texture coordinates in the texture of each lane; those without one are white.
    pub(super) fn texels(
        &self,
        texture_of: impl Fn(usize) -> Option<(usize, TextureLayout)>,
        lanes: u32,
        uv: Uv<S>,
    ) -> Lookup<S> {
        count(|counts| &counts.texture_lookups, u64::from(lanes.count_ones()));
        let size = |of: fn(&TextureLayout) -> u32| {
            <S::Lanes as Lanes>::from_lanes(|lane| {
                Real::from_f64(f64::from(texture_of(lane).map_or(1, |(_, texture)| of(&texture))))
            })
        };
        let (width, height) = (size(|texture| texture.width), size(|texture| texture.height));
        let values = Uv { u: uv.u.primal(), v: uv.v.primal() };
        let (x, y) = texel_position::<S::Lanes>(values, width, height);
        let (x, y) = (numbers_of_lanes(x), numbers_of_lanes(y));
        let mut indices = [[0; 4]; MAX_LANES];
        for lane in rays(lanes.into()) {
            if let Some((_, layout)) = texture_of(lane) {
                indices[lane] = layout.around(x[lane], y[lane]);
            }
        }
        // Nothing else is done here, so that those that are not in a cache are waited for together.
        let mut channels = [[[<S::Lane as Real>::ONE; MAX_LANES]; 3]; 4];
        for lane in rays(lanes.into()) {
            let Some((texture, layout)) = texture_of(lane) else { continue };
            for (channels, index) in channels.iter_mut().zip(indices[lane]) {
                let texel = self.inputs.texels[texture].at(index as usize - layout.first_texel);
                for (channel, value) in channels.iter_mut().zip([texel.x(), texel.y(), texel.z()]) {
                    channel[lane] = value;
                }
            }
        }
        let texels = channels.map(|channels| {
            let [r, g, b] = channels.map(|channel| S::from_each(|lane| channel[lane]));
            Vector3::new(r, g, b)
        });
        let (width, height) = (S::constant(width), S::constant(height));
        Lookup { lanes, indices, footprint: Footprint { texels, width, height } }
    }
}
