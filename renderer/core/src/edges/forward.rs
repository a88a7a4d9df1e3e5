//! The derivative of an image with edges along a direction.

use std::iter;

use ad::vector::{Vector, Vector3};
use ad::{Dual, Fields, Scalar, Vec3};
use glam::DVec3;

use super::crossing::{Crossing, Layer};
use super::geometry::{Edge, Geometry};
use super::limb::{Finer, Limb, StripPaths};
use super::view::View;
use crate::number::{Number, Plain};
use crate::parallel;
use crate::primal::image::{derivative_vector, mean_dual, visit};
use crate::primal::integrator::Integrator;
use crate::primal::known::KnownPaths;
use crate::primal::lanes::vectors_of_lanes;
use crate::primal::path::Path;
use crate::primal::wavefront::{LaneGroup, Source, Wavefront};
use crate::trace::bvh::{ray_at, rays};
use crate::trace::layout::Kind;
use crate::trace::tile::fill_tiles;
use crate::transport::camera::{Ray, primary_ray};
use crate::transport::edge::{ball_margin, plane_margin, segment_margin, sphere_margin};
use crate::transport::triangle::Triangle;

/// A number with its derivative along the direction.
pub type Moving = Dual<f64>;

/// How fast a crossing changes.
#[derive(Clone, Copy)]
struct Moved {
    /// The derivatives of the radiance on both sides.
    radiance: [DVec3; 2],
    /// The speed along its normal, in pixels.
    along: f64,
}

impl View {
    /// The derivatives of the pixels along the direction that the inputs of the integrator carry, and in which
    /// they get steep at silhouettes or not.
    pub fn derivative<L: Plain>(
        &self,
        geometry: &Geometry<'_>,
        integrator: Integrator<'_, Dual<L>>,
        is_steep: bool,
    ) -> Vec<DVec3> {
        let layout = integrator.layout;
        let grid = layout.sampling.as_grid();
        let limb = Limb::new(self, geometry, is_steep);
        let mut pixels = vec![DVec3::ZERO; self.pixels.len()];
        fill_tiles(layout.width, &mut pixels, Path::default, |path, tile| {
            let mut mean =
                mean_dual(integrator, tile, grid, None, path).map(|[_, derivative]| derivative);
            let packets = limb.packets(geometry, iter::once(*tile));
            let of_tile = |pixel: usize| {
                let [x, y] = [pixel % layout.width as usize, pixel / layout.width as usize];
                ray_at(x - tile.left, y - tile.top)
            };
            for ray in rays(tile.rays()) {
                let (x, y) = tile.pixel(ray);
                if limb.holds((y * layout.width + x) as usize) {
                    mean[ray] = DVec3::ZERO;
                }
            }
            for Finer { film, parts } in &packets {
                visit_derivatives(integrator, Source::Film(film), path, |ray, derivative| {
                    let (pixel, part) = parts[ray];
                    mean[of_tile(pixel)] += derivative * part;
                });
            }
            move |ray| mean[ray]
        });
        let moved = self.moved(geometry, integrator, is_steep);
        let strips = self.moved_strips(geometry, &limb, |path, (_, film), add| {
            visit_derivatives(integrator, Source::Film(film), path, add);
        });
        self.add_shares(layout.width, &mut pixels, |band, crossing, share| {
            let Moved { radiance: [a, b], along } = moved[band][crossing];
            let [of_a, of_b] = self.bands[band].radiance[crossing];
            let moved = ((of_a - of_b) * along + strips[band][crossing]) * share.length;
            match limb.holds(share.pixel as usize) {
                true => moved,
                false => a * share.areas[0] + b * share.areas[1] + moved,
            }
        });
        pixels
    }

    /// The part of it that comes from edges that move: the boundary term.
    pub fn boundary_derivative<L: Plain>(
        &self,
        geometry: &Geometry<'_>,
        integrator: Integrator<'_, Dual<L>>,
    ) -> Vec<DVec3> {
        let moved = self.moved(geometry, integrator, true);
        let (width, height) = (integrator.layout.width, integrator.layout.height);
        let mut pixels = vec![DVec3::ZERO; width as usize * height as usize];
        self.add_shares(width, &mut pixels, |band, crossing, share| {
            let [of_a, of_b] = self.bands[band].radiance[crossing];
            (of_a - of_b) * (moved[band][crossing].along * share.length)
        });
        pixels
    }

    /// Adds the derivatives of pixels by strips, where light takes all paths.
    pub fn add_strips<L: Plain>(
        &self,
        (geometry, limb): (&Geometry<'_>, &Limb),
        integrator: Integrator<'_, Dual<L>>,
        paths: StripPaths,
        pixels: &mut [DVec3],
    ) {
        if !limb.has_strips() {
            return;
        }
        let strips = self.moved_strips(geometry, limb, |path, (first, film), add| {
            paths.each(first, |numbers, part| {
                let source = Source::ScatteredFilm(film, numbers);
                visit_derivatives(integrator, source, path, |ray, derivative| {
                    add(ray, derivative * part);
                });
            });
        });
        self.add_shares(integrator.layout.width, pixels, |band, crossing, share| {
            strips[band][crossing] * share.length
        });
    }

    /// By band and crossing: the derivative of the radiance of a strip, for each pixel of the length of the edge. `visit`
    /// adds those of the rays of a packet.
    fn moved_strips<L: Plain>(
        &self,
        geometry: &Geometry<'_>,
        limb: &Limb,
        visit: impl Fn(&mut Path<Dual<L>>, (u32, &[[f64; 2]]), &mut dyn FnMut(usize, DVec3)) + Sync,
    ) -> Vec<Vec<DVec3>> {
        let bands = (0..self.bands.len()).collect();
        parallel::map_init(bands, Path::default, |path, band: usize| {
            let mut sums = vec![DVec3::ZERO; self.bands[band].crossings.len()];
            limb.of_strips(geometry, band, |packet, rays| {
                visit(path, packet, &mut |ray, derivative| {
                    let (crossing, width) = rays[ray];
                    sums[crossing] += derivative * width;
                });
            });
            sums
        })
    }

    /// By band: how fast the crossings change.
    fn moved<L: Plain>(
        &self,
        geometry: &Geometry<'_>,
        integrator: Integrator<'_, Dual<L>>,
        is_steep: bool,
    ) -> Vec<Vec<Moved>> {
        let start = || (KnownPaths::default(), Path::default());
        parallel::map_init(self.bands.iter().collect(), start, |(known, path), band| {
            let mut of_band = Vec::with_capacity(band.crossings.len());
            for (_, crossings) in band.packets() {
                band.paths(geometry, crossings, known);
                of_band.extend(moved(integrator, Source::Known(known), path, crossings, is_steep));
            }
            of_band
        })
    }
}

/// Calls `use_derivative` with the rays of a packet and the derivatives of their radiance.
fn visit_derivatives<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    source: Source<'_>,
    path: &mut Path<Dual<L>>,
    mut use_derivative: impl FnMut(usize, DVec3),
) {
    visit(integrator, source, path, |group, radiance| {
        let derivatives = vectors_of_lanes::<L>(derivative_vector::<L>(radiance));
        group.rays().for_each(|(lane, ray)| use_derivative(ray, derivatives[lane]));
    });
}

/// How fast the crossings of a packet change.
fn moved<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    source: Source<'_>,
    path: &mut Path<Dual<L>>,
    crossings: &[Crossing],
    is_steep: bool,
) -> Vec<Moved> {
    let still = Moved { radiance: [DVec3::ZERO; 2], along: 0.0 };
    let mut moved = vec![still; crossings.len()];
    visit_derivatives(integrator, source, path, |ray, derivative| {
        moved[ray / 2].radiance[ray % 2] = derivative;
    });
    for (index, (crossing, moved)) in crossings.iter().zip(&mut moved).enumerate() {
        let margin = margin(integrator, path.wavefronts(), crossing, 2 * index);
        moved.along = margin.map_or(0.0, |margin| -margin.derivative / crossing.slope);
        // At a silhouette that moves, radiance changes with the root of the distance to it.
        for side in 0..2 {
            let grazes = |wavefront| crossing.grazes(wavefront, 2 * index + side);
            if is_steep && path.wavefronts().iter().any(grazes) {
                moved.radiance[side] = DVec3::ZERO;
            }
        }
    }
    moved
}

/// The number of the edge of a crossing, whose first side is this ray of the packet.
fn margin<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    wavefronts: &[Wavefront<Dual<L>>],
    crossing: &Crossing,
    ray: usize,
) -> Option<Moving> {
    let group_of = |depth: u32, ray: usize| -> Option<&LaneGroup<Dual<L>>> {
        wavefronts.get(depth as usize)?.group_of(ray)
    };
    let (block, lane) = (ray / L::COUNT, ray % L::COUNT);
    let meets = match crossing.layer {
        Layer::Surface(0) => {
            let (x, y) = wavefronts[0].film[block];
            let ray = primary_ray::<Dual<L>>(
                integrator.inputs.frame,
                Dual::constant(x),
                Dual::constant(y),
            );
            in_lane::<L, _>(&ray, lane)
        }
        Layer::Surface(depth) => {
            in_lane::<L, _>(&wavefronts.get(depth as usize)?.rays[block], lane)
        }
        Layer::Shadow(depth, light) => {
            in_lane::<L, _>(&integrator.shadow_ray(light as usize, group_of(depth, ray)?), lane)
        }
    };
    match crossing.edge {
        Edge::Intersection(_) => {
            let Layer::Surface(depth) = crossing.layer else { return None };
            let point = |ray: usize| {
                let group = group_of(depth, ray)?;
                Some(in_lane::<L, _>(&group.surface, ray - group.first).point)
            };
            // The points are one but for rounding, so that it does not matter how the ray turns.
            let direction = meets.direction.map(|number| Moving::constant(number.value));
            Some((point(ray)? - point(ray + 1)?).dot(direction))
        }
        edge => margin_of(integrator, edge, meets),
    }
}

/// The number of an edge that one ray tells.
pub fn margin_of<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    edge: Edge,
    meets: Ray<Moving>,
) -> Option<Moving> {
    let vertex = |vertex: u32| widened::<L>(integrator.inputs.vertices[vertex as usize]);
    Some(match edge {
        Edge::Segment([a, b]) => segment_margin::<Moving>(vertex(a), vertex(b), meets),
        Edge::Silhouette(primitive) => silhouette(integrator, primitive as usize, meets),
        Edge::Intersection(_) => return None,
        Edge::Start(primitive) => match integrator.layout.kind_of(primitive as usize) {
            (Kind::Triangle, index) => {
                let [a, b, c] = integrator.layout.triangles[index].map(vertex);
                plane_margin::<Moving>(Triangle { a, b, c }, meets.origin)
            }
            (_, index) => {
                let sphere = integrator.inputs.spheres[index].map(wide::<L>);
                ball_margin::<Moving>(sphere, meets.origin)
            }
        },
    })
}

fn silhouette<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    primitive: usize,
    ray: Ray<Moving>,
) -> Moving {
    match integrator.layout.kind_of(primitive) {
        (Kind::Custom, index) => {
            let shape = &integrator.inputs.shapes[index];
            let numbers: Vec<Moving> = shape.numbers.iter().map(|&n| wide::<L>(n)).collect();
            let transform = in_lane::<L, _>(&shape.transform, 0);
            shape.kernel.at::<Moving>().intersect(&numbers, transform, ray).margin
        }
        (_, index) => {
            let sphere = integrator.inputs.spheres[index].map(wide::<L>);
            sphere_margin::<Moving>(sphere, ray)
        }
    }
}

/// A struct in one lane, in double precision.
pub fn in_lane<L: Plain, T: Fields<Dual<L>>>(value: &T, lane: usize) -> T::With<Moving> {
    value.map(|number| wide::<L>(Number::lane(number, lane)))
}

fn wide<L: Plain>(number: Dual<L::Lane>) -> Moving {
    Dual::new(number.value.to_f64(), number.derivative.to_f64())
}

fn widened<L: Plain>(v: Vec3<Dual<L::Lane>>) -> Vec3<Moving> {
    Vector3::new(wide::<L>(v.x()), wide::<L>(v.y()), wide::<L>(v.z()))
}
