//! The work of a gradient on the tiles of the image.

mod crossings;
mod flow;
mod surfaces;

use std::cell::Cell;
use std::mem;

use ad::lanes::Lanes;
use ad::{Additive, Mask, Tangent, Vec3, select};
use glam::DVec3;

use super::gradient::Wanted;
use super::mirrors::{Dark, Sight};
use super::prepared::Prepared;
use super::radiance::{PixelLoss, mean_radiance};
use super::shade::{LightCotangent, Pulled, Shaded};
use super::sums::{Slots, StripSums, material_sum};
use super::tiles::{Strip, Tile, for_each_strip};
use super::transparency::PulledCover;
use super::vertices::{ChosenVertices, VertexSums};
use super::view::{Group, Sample, View};
use crate::acceleration::{PACKET_RAYS, rays};
use crate::counts::count;
use crate::kernels::camera::{Frame, primary_ray};
use crate::precision::{MOST_LANES, lanes_of_vectors, sum_of_vectors, vectors_of_lanes};
use flow::{Flow, ToSurface};

/// What the strips of the image add up to, each by itself.
pub(crate) fn sweep<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted<'_>,
) -> Vec<StripSums> {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let vertices = wanted.chosen_vertices(prepared);
    let start = || Sweep::new(prepared, loss, wanted, &vertices);
    for_each_strip(width, height, start, Sweep::strip)
}

/// The work on strips that follow each other on a thread.
struct Sweep<'a, L: Lanes, P> {
    prepared: &'a Prepared<'a, L>,
    loss: &'a P,
    wanted: Wanted<'a>,
    dark: Dark,
    sight: Sight<L>,
    flows: Vec<Flow<L>>,
    sums: StripSums,
    materials: Slots,
    spheres: Slots,
    vertices: VertexSums<'a>,
    uvs: Slots,
    texels: Slots,
}

impl<'a, L: Lanes, P: PixelLoss> Sweep<'a, L, P> {
    fn new(
        prepared: &'a Prepared<'a, L>,
        loss: &'a P,
        wanted: Wanted<'a>,
        vertices: &'a ChosenVertices,
    ) -> Self {
        let slots = |wanted: bool, count: usize| Slots::new(if wanted { count } else { 0 });
        Self {
            prepared,
            loss,
            wanted,
            dark: Dark::of_gradient(wanted, prepared.pass),
            sight: Sight::default(),
            flows: Vec::new(),
            sums: StripSums::zero(prepared),
            materials: slots(wanted.materials(), prepared.materials.len()),
            spheres: slots(wanted.spheres, prepared.spheres.len()),
            vertices: VertexSums::new(vertices),
            uvs: slots(wanted.texture_coordinates, prepared.uvs.len()),
            texels: slots(wanted.texels, prepared.texels.len()),
        }
    }

    fn strip(&mut self, strip: Strip) -> StripSums {
        for tile in strip.tiles() {
            self.add_tile(&tile);
        }
        mem::replace(&mut self.sums, StripSums::zero(self.prepared))
    }

    fn add_tile(&mut self, tile: &Tile) {
        let (mut sight, mut flows) = (mem::take(&mut self.sight), mem::take(&mut self.flows));
        let Self { prepared, loss, .. } = *self;
        if prepared.sampling.is_single() {
            // The radiance of the ray is that of the pixel: no need to look twice.
            for sample in prepared.samples(tile) {
                let mut sum = 0.0;
                self.add_sample(&sample, &mut sight, &mut flows, &mut |group, radiance| {
                    let (loss, cotangent) = respond(loss, tile, group, radiance);
                    sum += loss;
                    cotangent
                });
                self.sums.loss += sum + loss_of_black(loss, tile, sight.views()[0].missed);
            }
        } else {
            let radiance = mean_radiance(prepared, tile, &mut sight);
            let mut cotangents = [DVec3::ZERO; PACKET_RAYS];
            let part = 1.0 / f64::from(prepared.sampling.count());
            for ray in rays(tile.rays()) {
                let (x, y) = tile.pixel(ray);
                let (value, derivative) = loss.evaluate(x, y, radiance[ray]);
                self.sums.loss += value;
                cotangents[ray] = derivative * part;
            }
            for sample in prepared.gradient_samples(tile) {
                self.add_sample(&sample, &mut sight, &mut flows, &mut |group, _| {
                    lanes_that_matter::<L>(group.rays().map(|(lane, ray)| (lane, cotangents[ray])))
                });
            }
        }
        (self.sight, self.flows) = (sight, flows);
    }

    /// Adds what flows back from one ray through each pixel of a tile. `respond` gives the cotangent
    /// of the radiance of a group, unless it is zero.
    fn add_sample(
        &mut self,
        sample: &Sample<'_>,
        sight: &mut Sight<L>,
        flows: &mut Vec<Flow<L>>,
        respond: &mut Respond<'_, L>,
    ) {
        self.prepared.see(sample, self.dark, sight);
        let views = sight.views();
        flows.resize_with(views.len().max(flows.len()), Flow::default);

        let (first, deeper) = flows.split_at_mut(1);
        let beyond = views.get(1).zip(deeper.first_mut());
        if self.is_by_few_vertices() && views.len() == 1 {
            let (prepared, chosen) = (self.prepared, self.vertices.chosen);
            self.pull_shading(&views[0], beyond, &mut first[0].surfaces, &mut |group, radiance| {
                respond(group, radiance).filter(|_| shows_any(prepared, group, chosen))
            });
        } else {
            self.pull_shading(&views[0], beyond, &mut first[0].surfaces, respond);
        }
        for depth in 1..views.len() {
            let (flows, deeper) = flows.split_at_mut(depth + 1);
            let Flow { radiance, surfaces, .. } = &mut flows[depth];
            let beyond = views.get(depth + 1).zip(deeper.first_mut());
            self.pull_shading(&views[depth], beyond, surfaces, &mut |group, _| {
                let cotangent = radiance[group.first / L::COUNT];
                Some(select(L::mask_from_bits(group.alive), cotangent, Additive::zero()))
            });
        }

        if self.wanted.surface() {
            for depth in (1..views.len()).rev() {
                let (flows, deeper) = flows.split_at_mut(depth + 1);
                let Flow { rays, surfaces, .. } = &mut flows[depth];
                let beyond = deeper.first().filter(|_| depth + 1 < views.len());
                self.pull_surfaces(&views[depth], beyond, surfaces, |group, to_ray| {
                    rays[group.first / L::COUNT].accumulate(to_ray);
                });
            }
            let (first, deeper) = flows.split_at_mut(1);
            let beyond = deeper.first().filter(|_| views.len() > 1);
            let mut to_frame = Tangent::<Frame<L>>::zero();
            let Self { prepared, wanted, .. } = *self;
            self.pull_surfaces(&views[0], beyond, &first[0].surfaces, |group, to_ray| {
                if wanted.camera {
                    let (x, y) = prepared.film(sample.tile, views[0].offsets.as_ref(), group.first);
                    let (_, pullback) = primary_ray::vjp::<L>(prepared.frame, x, y);
                    to_frame.accumulate(pullback(to_ray).0);
                }
            });
            if wanted.camera {
                self.sums.frame.accumulate(to_frame.sum(Mask::splat(true)));
            }
        }
    }

    /// Whether groups that show none of the wanted vertices have no gradient, unless rays go on from them.
    fn is_by_few_vertices(&self) -> bool {
        self.wanted.only_vertices()
            && !self.vertices.chosen.are_all()
            && !self.prepared.has_varied_opacity
    }

    /// From the radiance of a view, whose cotangents `respond` gives, to its materials and lights,
    /// to its surface points, and to the radiance of the rays that go on.
    #[inline]
    fn pull_shading(
        &mut self,
        view: &View<L>,
        beyond: Option<(&View<L>, &mut Flow<L>)>,
        surfaces: &mut Vec<Option<ToSurface<L>>>,
        respond: &mut Respond<'_, L>,
    ) {
        let Self { prepared, wanted, .. } = *self;
        let (shown, mut to_beyond) = beyond.unzip();
        if let Some(flow) = &mut to_beyond {
            flow.start();
        }
        surfaces.clear();
        for group in &view.groups {
            let materials = prepared.materials(group);
            let appearance = prepared.appearance(group, &materials);
            let textured = &appearance.textured;
            let shaded = Shaded::new(prepared, group, &appearance, view, shown);
            let (own_cotangent, through) = (Cell::new(None), Cell::new(None));
            let Self { sums, materials: slots, texels, .. } = self;
            let StripSums { lights, custom_lights, materials: of_materials, .. } = sums;
            let to_light = |light: usize, cotangent: LightCotangent<'_, L>| {
                if wanted.lights() {
                    lights[light].add(&cotangent, wanted);
                }
            };
            if wanted.surface() {
                surfaces.push(None);
            }
            let to_shown = |cotangent, mut pulled: Pulled<'_, L>| {
                count(|counts| &counts.shading_pullbacks, u64::from(group.alive.count_ones()));
                if !custom_lights.is_empty() {
                    shaded.pull_back_custom_lights(cotangent, &mut pulled, |light, cotangent| {
                        let to_light = &mut custom_lights[light];
                        prepared.pull_custom_illumination(group, light, cotangent, to_light)
                    });
                }
                let Pulled { material, surface } = pulled;
                let uv = textured.as_ref().map(|textured| {
                    let varied = through.get().and_then(|through: PulledCover<L>| through.varied);
                    textured.pull_back(material, varied, |texel, cotangent| {
                        if wanted.texels {
                            texels.add(&mut sums.texels, texel as usize, cotangent);
                        }
                    })
                });
                let mirror = to_beyond.as_mut().and_then(|flow| {
                    let mirror = shaded.pull_back_mirror(cotangent)?;
                    let radiance = &mut flow.radiance[group.first / L::COUNT];
                    radiance.accumulate(mirror.radiance);
                    if let Some(PulledCover { behind, .. }) = through.get() {
                        radiance.accumulate(behind);
                    }
                    Some(mirror)
                });
                if let Some(PulledCover { plain, .. }) = through.get().filter(|_| wanted.opacities)
                {
                    prepared.pull_opacity(&materials, plain, &mut sums.opacities);
                }
                if wanted.materials() {
                    for (index, lanes) in materials.iter() {
                        let mask = L::mask_from_bits(lanes);
                        let mut sum = material_sum(material, mask, wanted);
                        let mirror = mirror.as_ref().filter(|_| wanted.mirrors);
                        if let Some(mirror) = mirror.filter(|_| prepared.is_opaque(index)) {
                            sum.reflection = sum_of_vectors::<L>(mirror.reflection, mask);
                        }
                        slots.add(of_materials, index, sum);
                    }
                }
                if let Some(last) = surfaces.last_mut() {
                    *last = Some(ToSurface { surface: *surface, uv });
                }
            };
            let respond = |own| {
                let (own, pulled) = shaded.pull_back_seen(own, respond(group, shaded.seen(own))?);
                through.set(pulled);
                own_cotangent.set(Some(own));
                Some(own)
            };
            shaded.pull_back(respond, to_light, to_shown);
            let passed_matters = wanted.opacities || prepared.has_varied_opacity;
            if let Some(cotangent) = own_cotangent.get().filter(|_| passed_matters) {
                let mut to_points = Vec3::<L>::zero();
                shaded.pull_back_passed(cotangent, |light, left| {
                    to_points.accumulate(self.pull_passed(view, group, light, left));
                });
                if let Some(ToSurface { surface, .. }) =
                    surfaces.last_mut().and_then(Option::as_mut)
                {
                    surface.point.accumulate(to_points);
                }
            }
        }
    }
}

/// Whether a group shows a triangle with one of these corners.
fn shows_any<L: Lanes>(
    prepared: &Prepared<'_, L>,
    group: &Group<L>,
    vertices: &ChosenVertices,
) -> bool {
    let triangles = group.primitives.iter().filter_map(|(index, _)| prepared.triangles.get(index));
    triangles.flatten().any(|&vertex| vertices.place(vertex as usize).is_some())
}

/// The loss of the pixels of a group, and the cotangent of their radiance, unless it is zero: what
/// the loss does not care about has no gradient.
#[inline]
fn respond<L: Lanes>(
    loss: &impl PixelLoss,
    tile: &Tile,
    group: &Group<L>,
    radiance: Vec3<L>,
) -> (f64, Option<Vec3<L>>) {
    let radiance = vectors_of_lanes::<L>(radiance);
    let mut sum = 0.0;
    let cotangents = group.rays().map(|(lane, ray)| {
        let (x, y) = tile.pixel(ray);
        let (value, derivative) = loss.evaluate(x, y, radiance[lane]);
        sum += value;
        (lane, derivative)
    });
    let cotangents = lanes_that_matter::<L>(cotangents);
    (sum, cotangents)
}

/// The loss of the pixels of a tile that show nothing.
fn loss_of_black(loss: &impl PixelLoss, tile: &Tile, missed: u64) -> f64 {
    let pixels = rays(missed).map(|ray| tile.pixel(ray));
    pixels.map(|(x, y)| loss.evaluate(x, y, DVec3::ZERO).0).sum()
}

/// Vectors, by lane; the other lanes are zero. Nothing if all are zero.
#[inline]
fn lanes_that_matter<L: Lanes>(vectors: impl Iterator<Item = (usize, DVec3)>) -> Option<Vec3<L>> {
    let mut lanes = [DVec3::ZERO; MOST_LANES];
    vectors.for_each(|(lane, vector)| lanes[lane] = vector);
    let matters = lanes.iter().any(|&vector| vector != DVec3::ZERO);
    matters.then(|| lanes_of_vectors::<L>(&lanes))
}

/// From the radiance of a group to its cotangent, unless that is zero.
type Respond<'a, L> = dyn FnMut(&Group<L>, Vec3<L>) -> Option<Vec3<L>> + 'a;
