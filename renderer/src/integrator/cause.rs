//! What is not finite at a pixel, in words.

use std::sync::Mutex;

use ad::Vec3;
use ad::lanes::Lanes;
use glam::DVec3;

use super::gradient::{Wanted, gradient};
use super::mirrors::{Dark, Sight};
use super::non_finite::Chosen;
use super::prepared::Prepared;
use super::radiance::{PixelLoss, loss};
use super::shade::Shaded;
use super::tiles::tile_of;
use super::view::{Group, Shape};
use crate::precision::vectors_of_lanes;
use crate::scene::{ParameterId, Scene};

/// What is not finite first on the way from the camera to the gradient of a pixel.
pub(super) fn cause<L: Lanes>(
    prepared: &Prepared<'_, L>,
    pixel_loss: &impl PixelLoss,
    ids: &[ParameterId],
    (x, y): (u32, u32),
) -> String {
    let Scene { width, height, .. } = *prepared.scene;
    let (tile, ray) = tile_of(width, height, x, y);
    let mut sight = Sight::default();
    let mut overflowing = None;
    for sample in prepared.samples(&tile) {
        prepared.see(&sample, Dark::default(), &mut sight);
        if let Some(kernel) = prepared.non_finite_kernel(&sight, ray) {
            return kernel;
        }
        overflowing = overflowing.or_else(|| prepared.non_finite_radiance(&sight, ray));
    }

    let probe = Probe { loss: pixel_loss, pixel: (x, y), radiance: Mutex::default() };
    let value = loss(prepared, &probe);
    let radiance = probe.radiance.into_inner().unwrap_or_default();
    if let Some(primitive) = overflowing {
        return format!("the radiance is {radiance}, on {}", prepared.path_of(primitive));
    }
    if !value.is_finite() {
        return format!("the loss is {value}, of the radiance {radiance}");
    }

    let wanted = Wanted::by(ids);
    let mut shown = Vec::new();
    for sample in prepared.gradient_samples(&tile) {
        prepared.see(&sample, Dark::of_gradient(wanted, prepared.pass), &mut sight);
        if let Some(kernel) = prepared.non_finite_kernel(&sight, ray) {
            return kernel;
        }
        let met = sight.views().iter().filter_map(|view| view.hits.get(ray));
        let paths = met.map(|hit| prepared.path_of(hit.primitive as usize));
        shown.extend(paths);
    }
    shown.sort();
    shown.dedup();
    let mut chosen = vec![false; width as usize * height as usize];
    chosen[y as usize * width as usize + x as usize] = true;
    let chosen = Chosen { loss: pixel_loss, chosen: &chosen, width };
    let gradient = gradient(prepared, &chosen, wanted).gradient;
    let of_parameter = |id: &ParameterId| {
        let value = *gradient.get(*id).iter().find(|value| !value.is_finite())?;
        let (path, shown) = (prepared.scene.path(*id), shown.join(" and "));
        Some(format!("the derivative by {path} is {value}, on {shown}"))
    };
    let by_radiance = || format!("the derivative of the loss by the radiance {radiance} is not");
    ids.iter().find_map(of_parameter).unwrap_or_else(by_radiance)
}

/// The loss of one pixel, which notes its radiance.
struct Probe<'a, P> {
    loss: &'a P,
    pixel: (u32, u32),
    radiance: Mutex<DVec3>,
}

impl<P: PixelLoss> PixelLoss for Probe<'_, P> {
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

impl<L: Lanes> Prepared<'_, L> {
    /// The kernel that gives a ray of a packet, from the camera or where it goes on, what is not finite,
    /// with the object.
    fn non_finite_kernel(&self, sight: &Sight<L>, ray: usize) -> Option<String> {
        let mut ray_kernel = "primary_ray";
        sight.views().iter().find_map(|view| {
            let group = group_of(&view.groups, ray)?;
            let lane = ray - group.first;
            let kernel = kernel_of_lane(ray_kernel, group, lane);
            let is_transparent = self.transparent_among(&self.materials(group)) >> lane & 1 == 1;
            ray_kernel = if is_transparent { "straight_ray" } else { "mirrored_ray" };
            let (kernel, path) = (kernel?, self.path_of(view.hits.primitive[ray] as usize));
            Some(format!("the kernel `{kernel}` is not, on {path}"))
        })
    }

    /// The primitive, seen directly, by mirrors or through others, whose radiance an image cannot hold: the
    /// last one on the way of a ray, for in front of it infinities go on.
    fn non_finite_radiance(&self, sight: &Sight<L>, ray: usize) -> Option<usize> {
        let views = sight.views();
        (0..views.len()).rev().find_map(|depth| {
            let view = &views[depth];
            let group = group_of(&view.groups, ray)?;
            let materials = self.materials(group);
            let appearance = self.appearance(group, &materials);
            let mirrored = views.get(depth + 1);
            let shaded = Shaded::new(self, group, &appearance, view, mirrored);
            let radiance = vectors_of_lanes::<L>(shaded.radiance())[ray - group.first];
            let is_finite = radiance.as_vec3().is_finite();
            (!is_finite).then(|| view.hits.primitive[ray] as usize)
        })
    }

    /// The path of the object that a primitive belongs to: `mesh.tree`.
    fn path_of(&self, primitive: usize) -> String {
        let Scene { meshes, spheres, shapes, .. } = self.scene;
        if let Some(&[corner, ..]) = self.triangles.get(primitive) {
            return format!("mesh.{}", meshes[self.vertex_of_mesh(corner).0].name);
        }
        let index = self.sphere_of(primitive);
        match spheres.get(index) {
            Some(sphere) => format!("sphere.{}", sphere.name),
            None => format!("shape.{}", shapes[index - spheres.len()].name),
        }
    }
}

/// The group that a ray is in, if it meets something.
fn group_of<L: Lanes>(groups: &[Group<L>], ray: usize) -> Option<&Group<L>> {
    groups.iter().find(|group| group.rays().any(|(_, of_group)| of_group == ray))
}

/// The kernel that gives a lane of a group what is not finite, if one does: `ray_kernel` gives the
/// rays.
fn kernel_of_lane<L: Lanes>(
    ray_kernel: &'static str,
    group: &Group<L>,
    lane: usize,
) -> Option<&'static str> {
    let finite = |v: Vec3<L>| vectors_of_lanes::<L>(v)[lane].is_finite();
    if !finite(group.ray.origin) || !finite(group.ray.direction) {
        return Some(ray_kernel);
    }
    let surface = match group.shape {
        Shape::Triangles => "triangle_surface",
        Shape::Spheres(_) => "sphere_surface",
        Shape::Custom => "surface",
    };
    let is_finite = finite(group.surface.point) && finite(group.surface.normal);
    (!is_finite).then_some(surface)
}
