//! What is not finite at a pixel, in words.

use std::sync::Mutex;

use ad::Vec3;
use glam::DVec3;

use super::Chosen;
use crate::adjoint::{Request, loss_and_gradient};
use crate::loss::PixelLoss;
use crate::number::Plain;
use crate::primal::image::loss;
use crate::primal::integrator::{Integrator, Prepared};
use crate::primal::lanes::vectors_of_lanes;
use crate::primal::path::Path;
use crate::primal::wavefront::{LaneGroup, samples};
use crate::scene::{ParameterId, Scene};
use crate::trace::layout::Kind;
use crate::trace::tile::tile_of;

/// What is not finite first on the way from the camera to the gradient of a pixel.
pub(super) fn cause<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    pixel_loss: &dyn PixelLoss,
    request: &Request,
    (x, y): (u32, u32),
) -> String {
    let integrator = prepared.integrator();
    let (width, height) = (integrator.layout.width, integrator.layout.height);
    let sampling = integrator.layout.sampling;
    let (tile, ray) = tile_of(width, height, x, y);
    let mut path = Path::default();
    let mut overflowing = None;
    for sample in samples(&tile, sampling) {
        integrator.trace_path(sample, &mut path);
        if let Some(kernel) = non_finite_kernel(integrator, scene, &path, ray) {
            return kernel;
        }
        overflowing = overflowing.or_else(|| non_finite_radiance(integrator, &path, ray));
    }

    let probe = Probe { loss: pixel_loss, pixel: (x, y), radiance: Mutex::default() };
    let value = loss(integrator, &probe);
    let radiance = probe.radiance.into_inner().unwrap_or_default();
    if let Some(primitive) = overflowing {
        return format!("the radiance is {radiance}, on {}", path_of(integrator, scene, primitive));
    }
    if !value.is_finite() {
        return format!("the loss is {value}, of the radiance {radiance}");
    }

    let integrator = integrator.with_zero_weight(request.zero_weight);
    let mut shown = Vec::new();
    for sample in samples(&tile, sampling) {
        integrator.trace_path(sample, &mut path);
        if let Some(kernel) = non_finite_kernel(integrator, scene, &path, ray) {
            return kernel;
        }
        let hits = path.followed(ray).filter_map(|(wavefront, ray)| wavefront.hits.get(ray));
        shown.extend(hits.map(|hit| path_of(integrator, scene, hit.primitive as usize)));
    }
    shown.sort();
    shown.dedup();
    let mut chosen = vec![false; width as usize * height as usize];
    chosen[y as usize * width as usize + x as usize] = true;
    let chosen = Chosen { loss: pixel_loss, chosen: &chosen, width };
    let gradient = loss_and_gradient(prepared, scene, &chosen, request).gradient;
    let of_parameter = |(id, block): (ParameterId, &[f64])| {
        let value = block.iter().find(|value| !value.is_finite())?;
        let (path, shown) = (scene.path(id), shown.join(" and "));
        Some(format!("the derivative by {path} is {value}, on {shown}"))
    };
    let by_radiance = || format!("the derivative of the loss by the radiance {radiance} is not");
    gradient.iter().find_map(of_parameter).unwrap_or_else(by_radiance)
}

/// The loss of one pixel, which notes its radiance.
struct Probe<'a> {
    loss: &'a dyn PixelLoss,
    pixel: (u32, u32),
    radiance: Mutex<DVec3>,
}

impl PixelLoss for Probe<'_> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        if (x, y) != self.pixel {
            return (0.0, DVec3::ZERO);
        }
        if let Ok(mut noted) = self.radiance.lock() {
            *noted = radiance;
        }
        self.loss.evaluate(x, y, radiance)
    }
}

/// The kernel that gives a ray of a packet, from the camera or where it goes on, what is not finite,
/// with the object.
fn non_finite_kernel<L: Plain>(
    integrator: Integrator<'_, L>,
    scene: &Scene,
    path: &Path<L>,
    ray: usize,
) -> Option<String> {
    let mut ray_kernel = "primary_ray";
    path.followed(ray).find_map(|(wavefront, ray)| {
        let group = wavefront.group_of(ray)?;
        let kernel = kernel_of_lane(ray_kernel, group, ray - group.first);
        ray_kernel = "next_ray";
        let primitive = wavefront.hits.primitive[ray] as usize;
        Some(format!(
            "the kernel `{}` is not, on {}",
            kernel?,
            path_of(integrator, scene, primitive)
        ))
    })
}

/// The primitive, seen directly, by mirrors or through others, whose radiance an image cannot hold: the
/// last one on the path of a ray, for in front of it infinities go on.
fn non_finite_radiance<L: Plain>(
    integrator: Integrator<'_, L>,
    path: &Path<L>,
    ray: usize,
) -> Option<usize> {
    let wavefronts = path.wavefronts();
    let followed: Vec<_> = path.followed(ray).enumerate().collect();
    followed.into_iter().rev().find_map(|(depth, (wavefront, ray))| {
        let group = wavefront.group_of(ray)?;
        let vertex = integrator.vertex(group, wavefront, wavefronts.get(depth + 1));
        let radiance = vectors_of_lanes::<L>(vertex.radiance())[ray - group.first];
        let is_finite = radiance.as_vec3().is_finite();
        (!is_finite).then(|| wavefront.hits.primitive[ray] as usize)
    })
}

/// The path of the object that a primitive belongs to: `mesh.tree`.
fn path_of<L: Plain>(integrator: Integrator<'_, L>, scene: &Scene, primitive: usize) -> String {
    match integrator.layout.kind_of(primitive) {
        (Kind::Triangle, index) => {
            format!("mesh.{}", scene.meshes[integrator.layout.mesh_of(index)].name)
        }
        (Kind::Sphere, index) => format!("sphere.{}", scene.spheres[index].name),
        (Kind::Custom, index) => format!("shape.{}", scene.shapes[index].name),
    }
}

/// The kernel that gives a lane of a group what is not finite, if one does: `ray_kernel` gives the
/// rays.
fn kernel_of_lane<L: Plain>(
    ray_kernel: &'static str,
    group: &LaneGroup<L>,
    lane: usize,
) -> Option<&'static str> {
    let finite = |v: Vec3<L>| vectors_of_lanes::<L>(v)[lane].is_finite();
    if !finite(group.ray.origin) || !finite(group.ray.direction) {
        return Some(ray_kernel);
    }
    let surface = match group.kind {
        Kind::Triangle if group.mapped.is_some() => "mapped_normal",
        Kind::Triangle if group.is_smooth => "smooth_point",
        Kind::Triangle => "triangle_point",
        Kind::Sphere => "sphere_point",
        Kind::Custom => "intersect",
    };
    let is_finite = finite(group.surface.point) && finite(group.surface.normal);
    (!is_finite).then_some(surface)
}
