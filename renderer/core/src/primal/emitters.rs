//! Which primitives shine, and which parts of the environment, and how much.

use std::iter;
use std::ops::Range;

use ad::Scalar;
use glam::DVec3;

use super::inputs::Inputs;
use crate::number::{Number, widen};
use crate::parallel;
use crate::scene::{EnvironmentObject, MaterialObject, Scene};
use crate::trace::emitters::{Emitters, ShiningPoint};
use crate::trace::layout::{Kind, Layout};
use crate::trace::sky::shares;
use crate::transport::emitter::barycentric_of;

/// What vertices of paths look for, where light takes all: the triangles and spheres that shine, and then the
/// cells of the environment by their ranks, if it has a texture. Shapes of one's own, what has a texture of its
/// emission or an opacity, and an environment that is the same everywhere are found by scattered rays alone.
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
pub fn shining_points(layout: &Layout, surfaces: &Emitters, count: u32) -> Vec<ShiningPoint> {
    let point = |(primitive, numbers, choices): (u32, [f64; 2], f64)| {
        let at = match layout.kind_of(primitive as usize).0 {
            Kind::Triangle => barycentric_of::<f64>(numbers),
            Kind::Sphere | Kind::Custom => [numbers[0], numbers[1], 0.0],
        };
        ShiningPoint { primitive, at, choices }
    };
    let count = if surfaces.is_empty() { 0 } else { count };
    surfaces.spread(count).map(point).collect()
}

/// The power of each triangle and sphere that shines.
fn surface_powers<S: Number<Lane: Scalar>>(
    scene: &Scene,
    layout: &Layout,
    inputs: &Inputs<S>,
) -> impl Iterator<Item = (u32, f64)> {
    let radiance = |material: &MaterialObject| {
        if material.is_looked_for() { material.values.emission.max_element() } else { 0.0 }
    };
    let radiances: Vec<f64> = scene.materials.iter().map(radiance).collect();
    let shines = radiances.iter().any(|&radiance| radiance > 0.0);
    let primitives = if shines { 0..layout.material_of.len() } else { 0..0 };
    primitives.filter_map(move |primitive| {
        let radiance = radiances[layout.material_of[primitive] as usize];
        let power = (radiance > 0.0).then(|| radiance * area(layout, inputs, primitive))?;
        Some((primitive as u32, power))
    })
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
