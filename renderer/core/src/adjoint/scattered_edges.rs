//! Gradients with edges where light takes all paths.
//!
//! Paths bring the interior term; next to curved silhouettes those of [strips](crate::edges::Limb) do. The boundary term
//! of what the camera sees comes from the scene in direct light: its edges are those of the surfaces that the camera
//! sees, also in mirrors and through transparent surfaces, and those of the shadows of lights on them. At the edges of surfaces that the camera sees first the jump is that of light that takes
//! all paths, and the mean of as many as go through a pixel; elsewhere it is that of direct light. The boundary term of
//! all other light comes from [boundary segments](crate::boundary). Where these do not lead, points and parts stand for
//! what shines, which come in [rounds](crate::primal::rounds).
//!
//! What is left out: edges seen through what refracts, and of indirect light on what is seen by mirrors or through
//! transparent surfaces.

use glam::DVec3;

use super::boundary::sweep_boundary;
use super::chain::Chain;
use super::edges::{sweep_crossings, visit_strips};
use super::reduce::Totals;
use super::request::Request;
use crate::edges::{Geometry, Limb, StripPaths, View};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::parallel;
use crate::primal::integrator::Prepared;
use crate::primal::known::KnownPaths;
use crate::primal::wavefront::Source;
use crate::scene::Scene;
use crate::trace::bvh::rays;
use crate::trace::tile::for_each_strip;

/// Adds the sums of the strips of the image, and of the crossings of each round.
pub fn sweep_paths_with_edges<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    loss: &dyn PixelLoss,
    request: &Request,
    totals: &mut Totals,
) {
    let (width, height) = (prepared.layout.width, prepared.layout.height);
    let paths = prepared.integrator().with_zero_weight(request.zero_weight);
    let mut cotangents = vec![DVec3::ZERO; width as usize * height as usize];
    prepared.for_each_round(scene, |round, direct| {
        let integrator = direct.integrator().with_zero_weight(request.zero_weight);
        let geometry = Geometry::new(integrator);
        let view = View::of_paths(&geometry, integrator, prepared.integrator(), round);
        if round.index == 0 {
            let limb = Limb::of_paths(&view, &geometry, request.is_steep_at_silhouettes());
            let start = || Chain::new(paths, scene, request);
            let weight = |pixel, film| limb.weight(&geometry, pixel, film);
            let strips = for_each_strip(width, height, start, |chain, strip| {
                let mut of_strip = Vec::new();
                for tile in strip.tiles() {
                    let cotangents = chain.scattered_tile(loss, &tile, &weight);
                    of_strip
                        .extend(rays(tile.rays()).map(|ray| (tile.pixel(ray), cotangents[ray])));
                }
                (chain.scatter.take(), of_strip)
            });
            let count = f64::from(paths.layout.sampling.count());
            for (of_strip, pixels) in strips {
                totals.add_all([of_strip]);
                for ((x, y), cotangent) in pixels {
                    cotangents[y as usize * width as usize + x as usize] = cotangent * count;
                }
            }
            let of_strips = StripPaths::new(round, paths.layout.sampling);
            totals.add_all(parallel::map_init(limb.bands(), start, |chain, band| {
                let seen = (&view, &limb, &geometry);
                visit_strips(seen, band, &cotangents, |(first, film), of_rays| {
                    of_strips.each(first, |numbers, part| {
                        let source = Source::ScatteredFilm(film, numbers);
                        chain.pull_scattered(source, |_| of_rays.map(|of_ray| of_ray * part));
                    });
                });
                chain.scatter.take()
            }));
            totals.add_all(sweep_boundary(prepared, scene, request, &cotangents));
        }
        let start = || (Chain::new(integrator, scene, request), KnownPaths::default());
        totals.add_all(sweep_crossings(&view, &geometry, start, &cotangents, |_| false));
    });
}
