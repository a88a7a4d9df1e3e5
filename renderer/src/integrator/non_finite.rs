//! What is behind an image, a loss or a gradient that is not finite.
//!
//! Rendering does not look for infinities and NaN: they spread, so that a sum that is finite says
//! that all its terms were. Kernels keep them (`positive_part` instead of `max`), and only when a sum
//! is not finite the pixels behind it are searched for, by rendering again. Turned down: tests in the
//! kernels and counters beside the sums, for which every image would pay.

use std::fmt;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

use ad::Vec3;
use ad::lanes::Lanes;
use glam::DVec3;

use super::gradient::{GradientResult, Wanted, gradient};
use super::mirrors::{Dark, Sight};
use super::prepared::Prepared;
use super::radiance::{PixelLoss, loss};
use super::sweep::sweep;
use super::tiles::{strip_index, tile_of};
use super::view::{Group, Sample, Shape};
use crate::precision::vectors_of_lanes;
use crate::scene::{ParameterId, Scene};

/// The pixels whose radiance, loss or gradient is not finite. Displays as one line.
#[derive(Clone, Debug, PartialEq)]
pub struct NonFinite {
    /// By pixel, row by row: whether it is finite.
    finite: Vec<bool>,
    /// How many are not.
    pub count: usize,
    /// The column and the row of the first of them.
    pub first: (u32, u32),
    /// What is not finite there first: the kernel or the derivative, with the object.
    pub cause: String,
}

impl fmt::Display for NonFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ((x, y), pixels) = (self.first, self.finite.len());
        let Self { count, cause, .. } = self;
        write!(f, "{count} of {pixels} pixels are not finite; at column {x}, row {y} {cause}")
    }
}

/// Searches for what makes an image not finite.
pub fn find_non_finite_radiance<L: Lanes>(prepared: &Prepared<'_, L>) -> Option<NonFinite> {
    /// Infinite for radiances that an image cannot hold.
    struct InImage;

    impl PixelLoss for InImage {
        fn evaluate(&self, _: u32, _: u32, radiance: DVec3) -> (f64, DVec3) {
            let value = if radiance.as_vec3().is_finite() { 0.0 } else { f64::INFINITY };
            (value, DVec3::ZERO)
        }
    }

    find_non_finite(prepared, &InImage, &[])
}

/// Searches for what makes a loss, or its gradient by the given parameters, not finite.
pub fn find_non_finite<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    ids: &[ParameterId],
) -> Option<NonFinite> {
    let mut finite = finite_losses(prepared, loss);
    if !ids.is_empty() {
        exclude_non_finite_gradients(prepared, loss, Wanted::by(ids), &mut finite);
    }
    let pixel = finite.iter().position(|finite| !finite)?;
    let width = prepared.scene.width as usize;
    let first = ((pixel % width) as u32, (pixel / width) as u32);
    Some(NonFinite {
        count: finite.iter().filter(|finite| !**finite).count(),
        cause: cause(prepared, loss, ids, first),
        first,
        finite,
    })
}

/// [`gradient()`] of the pixels that are finite alone; the others bring nothing to the loss.
pub fn gradient_of_finite<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted,
    found: &NonFinite,
) -> GradientResult {
    let width = prepared.scene.width;
    gradient(prepared, &Chosen { loss, chosen: &found.finite, width }, wanted)
}

/// A loss of some pixels.
struct Chosen<'a, P> {
    loss: &'a P,
    /// By pixel.
    chosen: &'a [bool],
    width: u32,
}

impl<P: PixelLoss> PixelLoss for Chosen<'_, P> {
    fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
        match self.chosen[y as usize * self.width as usize + x as usize] {
            true => self.loss.evaluate(x, y, radiance),
            false => (0.0, DVec3::ZERO),
        }
    }
}

/// By pixel: whether radiance, loss and its derivative are finite.
fn finite_losses<L: Lanes>(prepared: &Prepared<'_, L>, pixel_loss: &impl PixelLoss) -> Vec<bool> {
    struct Watched<'a, P> {
        loss: &'a P,
        finite: Vec<AtomicBool>,
        width: u32,
    }

    impl<P: PixelLoss> PixelLoss for Watched<'_, P> {
        fn evaluate(&self, x: u32, y: u32, radiance: DVec3) -> (f64, DVec3) {
            let (value, derivative) = self.loss.evaluate(x, y, radiance);
            let finite = radiance.is_finite() && value.is_finite() && derivative.is_finite();
            let pixel = y as usize * self.width as usize + x as usize;
            self.finite[pixel].store(finite, Ordering::Relaxed);
            (0.0, DVec3::ZERO)
        }
    }

    let Scene { width, height, .. } = *prepared.scene;
    let pixels = width as usize * height as usize;
    let finite = (0..pixels).map(|_| AtomicBool::new(true)).collect();
    let watched = Watched { loss: pixel_loss, finite, width };
    loss(prepared, &watched);
    watched.finite.into_iter().map(AtomicBool::into_inner).collect()
}

/// Clears the pixels that bring no finite gradient although their loss is finite: by halves, in all
/// strips at once.
fn exclude_non_finite_gradients<L: Lanes>(
    prepared: &Prepared<'_, L>,
    loss: &impl PixelLoss,
    wanted: Wanted,
    finite: &mut [bool],
) {
    let width = prepared.scene.width;
    // By strip: sets of pixels that may hold one whose gradient is not finite.
    let mut suspects: Vec<Vec<Vec<usize>>> = Vec::new();
    for (pixel, _) in finite.iter().enumerate().filter(|(_, finite)| **finite) {
        let (x, y) = (pixel % width as usize, pixel / width as usize);
        let strip = strip_index(width, x, y);
        suspects.resize_with(suspects.len().max(strip + 1), || vec![Vec::new()]);
        suspects[strip][0].push(pixel);
    }
    while suspects.iter().any(|sets| !sets.is_empty()) {
        let sets: Vec<Vec<usize>> =
            suspects.iter_mut().map(|sets| sets.pop().unwrap_or_default()).collect();
        let mut chosen = vec![false; finite.len()];
        sets.iter().flatten().for_each(|&pixel| chosen[pixel] = true);
        let strips = sweep(prepared, &Chosen { loss, chosen: &chosen, width }, wanted);
        for ((mut set, sums), suspects) in sets.into_iter().zip(strips).zip(&mut suspects) {
            match set[..] {
                _ if sums.is_finite() => {}
                [] => {}
                [pixel] => finite[pixel] = false,
                _ => {
                    suspects.push(set.split_off(set.len() / 2));
                    suspects.push(set);
                }
            }
        }
    }
}

/// What is not finite first on the way from the camera to the gradient of a pixel.
fn cause<L: Lanes>(
    prepared: &Prepared<'_, L>,
    pixel_loss: &impl PixelLoss,
    ids: &[ParameterId],
    (x, y): (u32, u32),
) -> String {
    let Scene { width, height, .. } = *prepared.scene;
    let (tile, ray) = tile_of(width, height, x, y);
    let mut sight = Sight::default();
    let sample = Sample { tile: &tile, sampling: prepared.sampling, index: 0 };
    prepared.see(&sample, Dark::default(), &mut sight);
    let mut shown = "nothing".to_owned();
    for view in sight.views() {
        let shows = |group: &&Group<L>| group.rays().any(|(_, of_group)| of_group == ray);
        let Some(group) = view.groups.iter().find(shows) else { continue };
        let lane = ray - group.first;
        let primitive = view.hits.primitive[ray] as usize;
        if let Some(kernel) = non_finite_kernel(group, lane) {
            return format!("the kernel `{kernel}` is not, on {}", prepared.path_of(primitive));
        }
        shown = prepared.path_of(primitive);
    }

    let probe = Probe { loss: pixel_loss, pixel: (x, y), radiance: Mutex::default() };
    let value = loss(prepared, &probe);
    let radiance = probe.radiance.into_inner().unwrap_or_default();
    if !radiance.as_vec3().is_finite() {
        return format!("the radiance is {radiance}, on {shown}");
    }
    if !value.is_finite() {
        return format!("the loss is {value}, of the radiance {radiance}");
    }
    let mut chosen = vec![false; width as usize * height as usize];
    chosen[y as usize * width as usize + x as usize] = true;
    let chosen = Chosen { loss: pixel_loss, chosen: &chosen, width };
    let gradient = gradient(prepared, &chosen, Wanted::by(ids)).gradient;
    let of_parameter = |id: &ParameterId| {
        let value = *gradient.get(*id).iter().find(|value| !value.is_finite())?;
        Some(format!("the derivative by {} is {value}, on {shown}", prepared.scene.path(*id)))
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

/// The kernel that gives a lane of a group what is not finite, if one does.
fn non_finite_kernel<L: Lanes>(group: &Group<L>, lane: usize) -> Option<&'static str> {
    let finite = |v: Vec3<L>| vectors_of_lanes::<L>(v)[lane].is_finite();
    if !finite(group.ray.origin) || !finite(group.ray.direction) {
        return Some("primary_ray");
    }
    let surface = match group.shape {
        Shape::Triangles => "triangle_surface",
        Shape::Spheres(_) => "sphere_surface",
        Shape::Custom => "surface",
    };
    let is_finite = finite(group.surface.point) && finite(group.surface.normal);
    (!is_finite).then_some(surface)
}

impl<L: Lanes> Prepared<'_, L> {
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
