//! The colours and the opacities that textures give the pixels of a group.

use std::array;

use ad::lanes::Lanes;
use ad::vector::{Vector, Vector3};
use ad::{Additive, Real, Tangent, Vec3, select};
use glam::DVec3;

use super::prepared::Prepared;
use super::sharing::Sharing;
use super::view::{Group, Shape};
use crate::acceleration::rays;
use crate::counts::count;
use crate::kernels::material::{Material, MaterialTangent};
use crate::kernels::texture::{Uv, bilinear, sphere_uv, texel_position, triangle_uv};
use crate::precision::{MOST_LANES, numbers_of_lanes, vectors_of_lanes};
use crate::scene::{MaterialTextures, Wrap};

/// A texture among the texels of all.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Texture {
    pub first_texel: usize,
    pub width: u32,
    pub height: u32,
    pub wrap: Wrap,
}

impl Texture {
    /// The indices of the texels around a position: those of [`bilinear`].
    #[inline]
    pub fn around(&self, x: f64, y: f64) -> [u32; 4] {
        let (column, row) = (x.floor() as i64, y.floor() as i64);
        let columns = [column, column.saturating_add(1)].map(|c| self.wrap.index(c, self.width));
        let rows = [row, row.saturating_add(1)].map(|r| self.wrap.index(r, self.height));
        let texel = |row: u32, column: u32| {
            (self.first_texel + row as usize * self.width as usize + column as usize) as u32
        };
        [
            texel(rows[0], columns[0]),
            texel(rows[0], columns[1]),
            texel(rows[1], columns[0]),
            texel(rows[1], columns[1]),
        ]
    }
}

/// The textures that a group shows.
pub(super) struct Textured<L: Lanes> {
    /// The material without textures.
    plain: Material<L>,
    uv: Uv<L>,
    ambient: Option<Lookup<L>>,
    diffuse: Option<Lookup<L>>,
    specular: Option<Lookup<L>>,
    opacity: Option<Lookup<L>>,
}

/// What textures give for one colour of the materials, or for their opacities.
struct Lookup<L: Lanes> {
    /// A bit for each lane that has a texture.
    lanes: u32,
    width: L,
    height: L,
    /// By lane.
    indices: [[u32; 4]; MOST_LANES],
    texels: [Vec3<L>; 4],
    /// White in lanes without texture.
    color: Vec3<L>,
}

impl<L: Lanes> Textured<L> {
    /// The material with its textures.
    #[inline]
    pub fn material(&self) -> Material<L> {
        let times = |color: Vec3<L>, lookup: &Option<Lookup<L>>| match lookup {
            Some(lookup) => color * lookup.color,
            None => color,
        };
        Material {
            ambient: times(self.plain.ambient, &self.ambient),
            diffuse: times(self.plain.diffuse, &self.diffuse),
            specular: times(self.plain.specular, &self.specular),
            ..self.plain
        }
    }

    /// The colours that vary the opacities.
    pub fn of_opacity(&self) -> Option<Vec3<L>> {
        self.opacity.as_ref().map(|lookup| lookup.color)
    }

    /// Turns the cotangent of the material with textures into that of the one without; those of
    /// texels go to `to_texel`, also from `of_opacity`, the cotangent of [that](Self::of_opacity). Returns
    /// that of the place on the textures.
    pub fn pull_back(
        &self,
        cotangent: &mut MaterialTangent<L>,
        of_opacity: Option<Vec3<L>>,
        mut to_texel: impl FnMut(u32, DVec3),
    ) -> Tangent<Uv<L>> {
        let mut to_uv = Tangent::<Uv<L>>::zero();
        let mut pull = |lookup: &Option<Lookup<L>>, plain: Vec3<L>, cotangent: &mut Vec3<L>| {
            if let Some(lookup) = lookup {
                to_uv.accumulate(lookup.pull_back(self.uv, *cotangent * plain, &mut to_texel));
                *cotangent = *cotangent * lookup.color;
            }
        };
        pull(&self.ambient, self.plain.ambient, &mut cotangent.ambient);
        pull(&self.diffuse, self.plain.diffuse, &mut cotangent.diffuse);
        pull(&self.specular, self.plain.specular, &mut cotangent.specular);
        if let Some((lookup, cotangent)) = self.opacity.as_ref().zip(of_opacity) {
            to_uv.accumulate(lookup.pull_back(self.uv, cotangent, &mut to_texel));
        }
        to_uv
    }
}

impl<L: Lanes> Lookup<L> {
    fn pull_back(
        &self,
        uv: Uv<L>,
        cotangent: Vec3<L>,
        to_texel: &mut impl FnMut(u32, DVec3),
    ) -> Tangent<Uv<L>> {
        let textured = L::mask_from_bits(self.lanes);
        let cotangent = select(textured, cotangent, Additive::zero());
        let (_, pullback) = bilinear::vjp::<L>(self.texels, uv, self.width, self.height);
        let (texels, to_uv, _, _) = pullback(cotangent);
        let texels = texels.map(vectors_of_lanes::<L>);
        for lane in rays(self.lanes.into()) {
            for (index, texel) in self.indices[lane].iter().zip(&texels) {
                to_texel(*index, texel[lane]);
            }
        }
        to_uv
    }
}

impl<L: Lanes> Prepared<'_, L> {
    /// The textures that a group shows, if any.
    pub(super) fn textured(&self, group: &Group<L>, materials: &Sharing) -> Option<Textured<L>> {
        let is_textured = |material: usize| self.scene.materials[material].textures.any();
        if self.textures.is_empty() || !materials.iter().any(|(material, _)| is_textured(material))
        {
            return None;
        }
        let uv = match group.shape {
            Shape::Triangles => {
                let [a, b, c] = self.corners(&group.primitives);
                triangle_uv::<L>(
                    group.surface.point,
                    a,
                    b,
                    c,
                    self.uv_of_corners(&group.primitives),
                )
            }
            // Their materials have no textures.
            Shape::Custom => return None,
            Shape::Spheres(_) => {
                sphere_uv::<L>(group.surface.point, self.spheres(&group.primitives))
            }
        };
        let lookup = |of: fn(&MaterialTextures) -> Option<u32>| self.look_up(uv, materials, of);
        Some(Textured {
            plain: self.material(materials),
            uv,
            ambient: lookup(|textures| textures.ambient),
            diffuse: lookup(|textures| textures.diffuse),
            specular: lookup(|textures| textures.specular),
            opacity: match self.has_transparency {
                true => lookup(|textures| textures.opacity),
                false => None,
            },
        })
    }

    /// The places of the corners of triangles.
    pub(super) fn uv_of_corners(&self, triangles: &Sharing) -> [Uv<L>; 3] {
        triangles.gather::<L, _>(|triangle| match self.uv_triangles[triangle] {
            Some(corners) => corners.map(|corner| self.uvs[corner as usize].splat()),
            None => [Uv { u: L::ZERO, v: L::ZERO }; 3],
        })
    }

    /// The colours at `uv` of the textures that materials have for one of their colours, or for their
    /// opacities.
    fn look_up(
        &self,
        uv: Uv<L>,
        materials: &Sharing,
        texture_of: impl Fn(&MaterialTextures) -> Option<u32>,
    ) -> Option<Lookup<L>> {
        let mut lanes = 0;
        let mut textures: [Option<Texture>; MOST_LANES] = [None; MOST_LANES];
        for (material, of_material) in materials.iter() {
            if let Some(texture) = texture_of(&self.scene.materials[material].textures) {
                lanes |= of_material;
                for lane in rays(of_material.into()) {
                    textures[lane] = Some(self.textures[texture as usize]);
                }
            }
        }
        if lanes == 0 {
            return None;
        }
        count(|counts| &counts.texture_lookups, u64::from(lanes.count_ones()));
        let size = |of: fn(&Texture) -> u32| {
            L::from_lanes(|lane| {
                let size = textures[lane].as_ref().map_or(1, of);
                <L::Element as Real>::from_f64(f64::from(size))
            })
        };
        let (width, height) = (size(|texture| texture.width), size(|texture| texture.height));
        let (x, y) = texel_position::<L>(uv, width, height);
        let (x, y) = (numbers_of_lanes(x), numbers_of_lanes(y));
        let indices = array::from_fn(|lane| match textures[lane] {
            Some(texture) => texture.around(x[lane], y[lane]),
            None => [0; 4],
        });
        let texels = array::from_fn(|corner| {
            let texel = |lane: usize| self.texels[indices[lane][corner] as usize];
            Vector3::new(
                L::from_lanes(|lane| texel(lane).x()),
                L::from_lanes(|lane| texel(lane).y()),
                L::from_lanes(|lane| texel(lane).z()),
            )
        });
        let color = bilinear::<L>(texels, uv, width, height);
        let white = Vec3::<L>::splat(L::ONE);
        let color = select(L::mask_from_bits(lanes), color, white);
        Some(Lookup { lanes, width, height, indices, texels, color })
    }
}
