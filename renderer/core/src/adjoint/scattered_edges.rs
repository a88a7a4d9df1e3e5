//! Gradients with edges where light takes all paths.
//!
//! Paths bring the interior term; next to curved silhouettes those of [strips](crate::edges::Limb) do. The boundary term
//! of what the camera sees comes from the scene in direct light: its edges are those of the surfaces that the camera
//! sees, also in mirrors and through transparent surfaces, and those of the shadows of lights on them. At the edges of
//! surfaces that the camera sees first the jump is that of light that takes all paths, and the mean of as many as go
//! through a pixel; elsewhere it is that of direct light. The boundary term of all other light comes from [boundary
//! segments](crate::boundary). Where these do not lead, points and parts stand for what shines, which come in
//! [rounds](crate::primal::rounds).
//!
//! What is left out: edges seen through what refracts, and of indirect light on what is seen by mirrors or through
//! transparent surfaces.

use glam::DVec3;

use super::boundary::sweep_boundary;
use super::chain::Chain;
use super::edges::{sweep_crossings, visit_strips};
use super::reduce::Totals;
use super::request::Request;
use super::scatter::Sums;
use crate::edges::{Geometry, Limb, StripPaths, View};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::parallel;
use crate::primal::image::Weight;
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
    let mut cotangents = Vec::new();
    prepared.for_each_round(scene, |round, direct| {
        let integrator = direct.integrator().with_zero_weight(request.zero_weight);
        let geometry = Geometry::new(integrator);
        let view = View::of_paths(&geometry, integrator, prepared.integrator(), round);
        if round.index == 0 {
            let start = || {
                let paths = prepared.integrator().with_zero_weight(request.zero_weight);
                Chain::new(paths, scene, request)
            };
            let limb = Limb::of_paths(&view, &geometry, request.is_steep_at_silhouettes());
            let of_strips = StripPaths::new(round, prepared.layout.sampling);
            cotangents = sweep_samples(start, loss, &geometry, &limb, totals);
            let seen = (&view, &limb, &geometry);
            totals.add_all(sweep_strips(start, seen, of_strips, &cotangents));
            totals.add_all(sweep_boundary(prepared, scene, request, &cotangents));
        }
        let start = || (Chain::new(integrator, scene, request), KnownPaths::default());
        totals.add_all(sweep_crossings(&view, &geometry, start, &cotangents, |_| false));
    });
}

/// Adds the loss, and the interior term of the samples of pixels; returns the cotangents of these.
fn sweep_samples<'a, L: Plain>(
    start: impl Fn() -> Chain<'a, L> + Sync,
    loss: &dyn PixelLoss,
    geometry: &Geometry<'_>,
    limb: &Limb,
    totals: &mut Totals,
) -> Vec<DVec3> {
    let layout = geometry.layout;
    let (width, height) = (layout.width, layout.height);
    let weight = |pixel, film| limb.weight(geometry, pixel, film);
    let weight = limb.has_strips().then_some(&weight as &Weight<'_>);
    let strips = for_each_strip(width, height, start, |chain, strip| {
        let mut of_strip = Vec::new();
        let count = f64::from(chain.integrator.layout.sampling.count());
        for tile in strip.tiles() {
            let cotangents = chain.scattered_tile(loss, &tile, weight);
            let of_ray = |ray: usize| (tile.pixel(ray), cotangents[ray] * count);
            of_strip.extend(rays(tile.rays()).map(of_ray));
        }
        (chain.scatter.take(), of_strip)
    });
    let mut cotangents = vec![DVec3::ZERO; width as usize * height as usize];
    for (of_strip, pixels) in strips {
        totals.add_all([of_strip]);
        for ((x, y), cotangent) in pixels {
            cotangents[y as usize * width as usize + x as usize] = cotangent;
        }
    }
    cotangents
}

/// The sums of the strips along curved silhouettes: the rest of the interior term.
fn sweep_strips<'a, L: Plain>(
    start: impl Fn() -> Chain<'a, L> + Sync,
    (view, limb, geometry): (&View, &Limb, &Geometry<'_>),
    paths: StripPaths,
    cotangents: &[DVec3],
) -> Vec<Sums> {
    parallel::map_init(limb.bands(), start, |chain, band| {
        visit_strips((view, limb, geometry), band, cotangents, |(first, film), of_rays| {
            paths.each(first, |numbers, part| {
                let source = Source::ScatteredFilm(film, numbers);
                chain.pull_scattered(source, |_| of_rays.map(|of_ray| of_ray * part));
            });
        });
        chain.scatter.take()
    })
}
