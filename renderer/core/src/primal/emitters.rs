//! Which primitives shine, and which parts of the environment, and how much.

use std::iter;
use std::ops::Range;

use ad::Scalar;
use glam::DVec3;

use super::inputs::Inputs;
use crate::number::{Number, widen};
use crate::parallel;
use crate::scene::{EnvironmentObject, Scene, Slot};
use crate::trace::emitters::{Emitters, ShiningPoint};
use crate::trace::layout::{Kind, Layout};
use crate::trace::sampling::random_numbers;
use crate::trace::sky::shares;
use crate::transport::emitter::barycentric_of;
use crate::transport::environment::direction_of;

/// In so many rows and columns lie the points by which it is known how brightly a textured primitive shines.
const SIDE_OF_POINTS: u32 = 4;

/// What vertices of paths look for, where light takes all: the triangles and spheres that shine, and then the
/// cells of the environment by their ranks, if it has a texture. Shapes of one's own, and an environment that is the
/// same everywhere, are found by scattered rays alone.
pub fn emitters<S: Number<Lane: Scalar>>(
    scene: &Scene,
    layout: &Layout,
    inputs: &Inputs<S>,
) -> Emitters {
    if layout.path_tracing.is_none() {
        return Emitters::default();
    }
    let cells = sky_powers(scene, layout).into_iter();
    let first_cell = layout.material_of.len() as u32;
    Emitters::new(surface_powers(scene, layout, inputs), first_cell, cells)
}

/// The triangles and spheres that shine.
pub fn surface_emitters<S: Number<Lane: Scalar>>(
    scene: &Scene,
    layout: &Layout,
    inputs: &Inputs<S>,
) -> Emitters {
    let powers = surface_powers(scene, layout, inputs);
    Emitters::new(powers, layout.material_of.len() as u32, iter::empty())
}

/// So many points of surfaces that shine, spread over their power; none if there are none.
pub fn shining_points(
    layout: &Layout,
    surfaces: &Emitters,
    count: u32,
    seed: Option<u32>,
) -> Vec<ShiningPoint> {
    let point = |(primitive, numbers, choices): (u32, [f64; 2], f64)| {
        let is_even = is_even(layout, primitive as usize);
        let at = match layout.kind_of(primitive as usize).0 {
            Kind::Sphere if is_even => [numbers[0], numbers[1], 0.0],
            kind => point_of(kind, numbers),
        };
        ShiningPoint { primitive, at, is_even, choices }
    };
    let count = if surfaces.is_empty() { 0 } else { count };
    let shift = seed.map_or([0.5, 0.0, 0.0], |seed| random_numbers(!seed, 0));
    surfaces.spread(count, shift).map(point).collect()
}

/// The power of each triangle and sphere that shines.
fn surface_powers<S: Number<Lane: Scalar>>(
    scene: &Scene,
    layout: &Layout,
    inputs: &Inputs<S>,
) -> impl Iterator<Item = (u32, f64)> {
    let radiances: Vec<DVec3> =
        scene.materials.iter().map(|material| material.values.emission).collect();
    let shines = radiances.iter().any(|&radiance| radiance != DVec3::ZERO);
    let primitives = if shines { 0..layout.material_of.len() } else { 0..0 };
    primitives.filter_map(move |primitive| {
        let radiance = radiances[layout.material_of[primitive] as usize];
        if radiance == DVec3::ZERO {
            return None;
        }
        let seen = mean_seen_part(layout, inputs, primitive);
        let power = (radiance * seen).max_element() * area(layout, inputs, primitive);
        Some((primitive as u32, power))
    })
}

/// Whether textures leave a primitive as bright everywhere.
fn is_even(layout: &Layout, primitive: usize) -> bool {
    !layout.traits_of(primitive).textures.any_of(&Slot::OF_EMISSION)
}

/// The point of a primitive that two even numbers choose, evenly by area: barycentric coordinates, or a direction from
/// the centre of a sphere.
fn point_of(kind: Kind, [u, v]: [f64; 2]) -> [f64; 3] {
    match kind {
        Kind::Triangle => barycentric_of::<f64>([u, v]),
        Kind::Sphere | Kind::Custom => direction_of::<f64>([v, 2.0 * u, 1.0]).to_array(),
    }
}

/// The mean part that is seen of the emission of a primitive, by a few of its points.
fn mean_seen_part<S: Number>(layout: &Layout, inputs: &Inputs<S>, primitive: usize) -> DVec3 {
    let side = if is_even(layout, primitive) { 1 } else { SIDE_OF_POINTS };
    let (kind, _) = layout.kind_of(primitive);
    let middle = |index: u32| (f64::from(index) + 0.5) / f64::from(side);
    let numbers = (0..side).flat_map(|row| (0..side).map(move |column| [column, row].map(middle)));
    let parts = numbers.map(|numbers| inputs.seen_part(layout, primitive, point_of(kind, numbers)));
    parts.sum::<DVec3>() / f64::from(side * side)
}

/// The power of each cell of the environment, in the order of their ranks: what it brings to a disc as large
/// as the scene, up to the factor that powers of surfaces lack.
fn sky_powers(scene: &Scene, layout: &Layout) -> Vec<f64> {
    let (Some(sky), Some((texture, map))) = (&layout.sky, layout.map) else { return Vec::new() };
    let Some(EnvironmentObject { values, .. }) = scene.environment else { return Vec::new() };
    let radius = scene.bounding_box().map_or(1.0, |(low, high)| 0.5 * low.distance(high));
    let texels = &scene.textures[texture].texels;
    // A map that is turned reaches another part of the cells that stand still.
    let shift = values.rotation / 360.0 % 1.0 * f64::from(map.width);
    let columns: Vec<_> = (0..map.width).map(|cell| shares(cell, shift)).collect();
    let rows: Vec<_> = (0..map.height).map(|cell| shares(cell, 0.0)).collect();
    let [of_columns, of_rows] = map.wrap;
    let radiance = |(column, row): (u32, u32)| {
        let mut mean = DVec3::ZERO;
        for (y, of_row) in rows[row as usize] {
            for (x, of_column) in columns[column as usize] {
                let (x, y) = (of_columns.index(x, map.width), of_rows.index(y, map.height));
                let texel = texels.at(y as usize * map.width as usize + x as usize);
                mean += DVec3::from(texel) * (of_row * of_column);
            }
        }
        (mean * values.radiance).max_element()
    };
    let power = |cell: (u32, u32)| radiance(cell) * sky.solid_angle(cell.1) * radius * radius;
    let of_some = |ranks: Range<usize>| -> Vec<f64> {
        ranks.map(|rank| sky.cell_at(rank as u32).map_or(0.0, power)).collect()
    };
    parallel::map_ranges(sky.ranks() as usize, of_some).concat()
}

fn area<S: Number<Lane: Scalar>>(layout: &Layout, inputs: &Inputs<S>, primitive: usize) -> f64 {
    match layout.kind_of(primitive) {
        (Kind::Triangle, index) => {
            let corner = |vertex: u32| widen::<S::Lane>(inputs.vertices[vertex as usize]);
            let [a, b, c] = layout.triangles[index].map(corner);
            0.5 * (b - a).cross(c - a).length()
        }
        (Kind::Sphere, index) => {
            let radius = inputs.spheres[index].radius.to_f64();
            4.0 * std::f64::consts::PI * radius * radius
        }
        (Kind::Custom, _) => 0.0,
    }
}
