//! Images, and losses of them.

use ad::vector::Vector3;
use ad::{Dual, Vec3};
use glam::DVec3;

use super::integrator::Integrator;
use super::lanes::vectors_of_lanes;
use super::path::Path;
use super::wavefront::{RayLanes, Source, TileSample, samples, set_vectors};
use crate::image::Image;
use crate::loss::PixelLoss;
use crate::number::{Number, Plain, primal_vector};
use crate::trace::bvh::{PACKET_RAYS, PacketVectors, rays};
use crate::trace::sampling::Sampling;
use crate::trace::tile::{Tile, fill_tiles, for_each_strip};

/// How much the derivative of a sample counts, by its pixel and by where it meets the film.
pub type Weight<'a> = dyn Fn((u32, u32), [f64; 2]) -> f64 + Sync + 'a;

/// Renders the image over one of the same size: the mean of what the rays through each pixel bring.
/// Where the camera sees nothing, the image is black.
///
/// # Panics
///
/// If the image has another size than the scene's.
pub fn render_into<L: Plain>(integrator: Integrator<'_, L>, image: &mut Image) {
    let layout = integrator.layout;
    let size = (layout.width, layout.height);
    assert_eq!((image.width, image.height), size, "the image has the size of the scene's");
    fill_tiles(layout.width, &mut image.pixels, Path::default, |path, tile| {
        let mut colors = PacketVectors::ZERO;
        if layout.sampling.count() == 1 {
            let sample = TileSample { tile, sampling: layout.sampling, index: 0 };
            visit(integrator, Source::Tile(sample), path, |group, radiance| {
                set_vectors::<L>(&mut colors, group.first, group.alive, radiance);
            });
        } else {
            let radiance = mean_radiance(integrator, tile, path);
            for (ray, color) in radiance.iter().enumerate() {
                colors.set(ray, color.as_vec3());
            }
        }
        move |ray| colors.get(ray).into()
    });
}

/// The radiance of the pixels and its derivatives along the direction that the inputs carry, in double
/// precision from the radiance of each ray on.
pub fn pixels_dual<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    sampling: Sampling,
    weight: Option<&Weight<'_>>,
) -> Vec<[DVec3; 2]> {
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    let mut pixels = vec![[DVec3::ZERO; 2]; width as usize * height as usize];
    fill_tiles(width, &mut pixels, Path::default, |path, tile| {
        let mean = mean_dual(integrator, tile, sampling, weight, path);
        move |ray| mean[ray]
    });
    pixels
}

/// The radiance of the pixels of a tile and its derivative.
pub fn mean_dual<L: Plain>(
    integrator: Integrator<'_, Dual<L>>,
    tile: &Tile,
    sampling: Sampling,
    weight: Option<&Weight<'_>>,
    path: &mut Path<Dual<L>>,
) -> [[DVec3; 2]; PACKET_RAYS] {
    let mut total = [[DVec3::ZERO; 2]; PACKET_RAYS];
    for sample in samples(tile, sampling) {
        let mut of_sample = [DVec3::ZERO; PACKET_RAYS];
        visit(integrator, sample, path, |group, radiance| {
            let values = vectors_of_lanes::<L>(primal_vector::<Dual<L>>(radiance));
            let derivatives = vectors_of_lanes::<L>(derivative_vector::<L>(radiance));
            for (lane, ray) in group.rays() {
                total[ray][0] += values[lane];
                of_sample[ray] = derivatives[lane];
            }
        });
        weigh(&mut of_sample, weight, tile, path);
        for ([_, total], derivative) in total.iter_mut().zip(of_sample) {
            *total += derivative;
        }
    }
    let count = f64::from(sampling.count());
    total.map(|parts| parts.map(|sum| sum / count))
}

/// Multiplies the derivative of each sample by how much it counts: all the same without a `weight`.
pub fn weigh<S: Number>(
    derivatives: &mut [DVec3; PACKET_RAYS],
    weight: Option<&Weight<'_>>,
    tile: &Tile,
    path: &Path<S>,
) {
    let Some(weight) = weight else { return };
    let film = path.wavefronts()[0].film_points();
    for ((ray, derivative), film) in derivatives.iter_mut().enumerate().zip(film) {
        *derivative *= weight(tile.pixel(ray), film);
    }
}

/// The derivatives of a vector.
pub fn derivative_vector<L: Plain>(v: Vec3<Dual<L>>) -> Vec3<L> {
    Vector3::new(v.x().derivative, v.y().derivative, v.z().derivative)
}

/// The loss of the image, in double precision from the radiance on.
pub fn loss<L: Plain>(integrator: Integrator<'_, L>, loss: &dyn PixelLoss) -> f64 {
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    let strips = for_each_strip(width, height, Path::default, |path, strip| {
        let mut sum = 0.0;
        for tile in strip.tiles() {
            let radiance = mean_radiance(integrator, &tile, path);
            for ray in rays(tile.rays()) {
                let (x, y) = tile.pixel(ray);
                sum += loss.evaluate(x, y, radiance[ray]).0;
            }
        }
        sum
    });
    strips.into_iter().sum()
}

/// The radiance of the pixels of a tile, in double precision from that of each ray on.
#[inline(never)]
pub fn mean_radiance<L: Plain>(
    integrator: Integrator<'_, L>,
    tile: &Tile,
    path: &mut Path<L>,
) -> [DVec3; PACKET_RAYS] {
    mean_traced(integrator, tile, integrator.layout.sampling, path, |_, _| ())
}

/// The same by the rays of any sampling. Calls `keep` with the index of each sample and its paths.
#[inline]
pub fn mean_traced<L: Plain>(
    integrator: Integrator<'_, L>,
    tile: &Tile,
    sampling: Sampling,
    path: &mut Path<L>,
    keep: impl Fn(u32, &Path<L>),
) -> [DVec3; PACKET_RAYS] {
    let mut total = [DVec3::ZERO; PACKET_RAYS];
    for (index, sample) in samples(tile, sampling).enumerate() {
        add_radiance(integrator, sample, path, &mut total);
        keep(index as u32, path);
    }
    let count = f64::from(sampling.count());
    total.map(|radiance| radiance / count)
}

/// Adds what each ray of a packet brings.
#[inline]
pub fn add_radiance<L: Plain>(
    integrator: Integrator<'_, L>,
    source: Source<'_>,
    path: &mut Path<L>,
    total: &mut [DVec3],
) {
    visit(integrator, source, path, |group, radiance| {
        let radiance = vectors_of_lanes::<L>(radiance);
        for (lane, ray) in group.rays() {
            total[ray] += radiance[lane];
        }
    });
}

/// Calls `use_radiance` with the radiance of camera rays, as many as have lanes at a time; what is black
/// because they meet nothing is left out.
#[inline]
pub fn visit<S: Number>(
    integrator: Integrator<'_, S>,
    source: Source<'_>,
    path: &mut Path<S>,
    mut use_radiance: impl FnMut(RayLanes, Vec3<S>),
) {
    integrator.trace_path(source, path);
    let wavefronts = path.wavefronts();
    for group in &wavefronts[0].groups {
        let vertex = integrator.vertex(group, &wavefronts[0], wavefronts.get(1));
        use_radiance(group.lanes(), vertex.radiance());
    }
    integrator.visit_missed(&wavefronts[0], use_radiance);
}

/// How many rays there are at each depth, and how many of them hit something.
pub fn rays_by_depth<L: Plain>(integrator: Integrator<'_, L>) -> Vec<(u64, u64)> {
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    let depths = integrator.depths().max(integrator.layout.bounces as usize + 1);
    let strips = for_each_strip(width, height, Path::default, |path, strip| {
        let mut counts = vec![(0, 0); depths];
        for tile in strip.tiles() {
            for sample in samples(&tile, integrator.layout.sampling) {
                integrator.trace_path(sample, path);
                for (wavefront, (rays, hits)) in path.wavefronts().iter().zip(&mut counts) {
                    let hit = wavefront.groups.iter().map(|group| group.alive.count_ones());
                    let hit: u64 = hit.map(u64::from).sum();
                    *rays += hit + u64::from(wavefront.missed.count_ones());
                    *hits += hit;
                }
            }
        }
        counts
    });
    let mut total = vec![(0, 0); depths];
    for strip in strips {
        for ((rays, hits), (more_rays, more_hits)) in total.iter_mut().zip(strip) {
            *rays += more_rays;
            *hits += more_hits;
        }
    }
    total
}

/// Traces the rays of an image from the camera, and those of their shadows if they are wanted, and shades
/// nothing.
pub fn trace_only<L: Plain>(integrator: Integrator<'_, L>, shadows: bool) {
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    for_each_strip(width, height, super::wavefront::Wavefront::default, |wavefront, strip| {
        for tile in strip.tiles() {
            for sample in samples(&tile, integrator.layout.sampling) {
                integrator.trace_primary(sample, wavefront);
                if shadows {
                    integrator.trace_shadows(None, wavefront);
                }
            }
        }
    });
}
