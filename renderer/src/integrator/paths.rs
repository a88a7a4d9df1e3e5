//! What pixels show, written down, for who evaluates the kernels in another way.

use ad::lanes::Lanes;

use super::crossings::Crossing;
use super::gradient::Wanted;
use super::mirrors::{Dark, Sight};
use super::prepared::Prepared;
use super::tiles::{Tile, for_each_strip};
use crate::acceleration::rays;

/// What a ray through a pixel meets: directly, by one mirror or behind one transparent surface, by two,
/// and so on.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Path {
    /// The column of the pixel.
    pub x: u32,
    /// The row of the pixel.
    pub y: u32,
    /// From the camera on; empty if it sees nothing.
    pub meetings: Vec<Meeting>,
    /// How many rays that takes: the camera's, and those that go on.
    pub rays: usize,
}

/// One meeting of a ray with a surface.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Meeting {
    /// The index of the primitive: of a triangle, counted through all meshes, then of a sphere.
    pub primitive: usize,
    /// For a sphere: whether the ray comes from its inside.
    pub leaves: bool,
    /// The lights that reach the point.
    pub lit: Vec<Reached>,
}

/// A light that reaches a point.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reached {
    /// Its index.
    pub light: usize,
    /// The transparent surfaces that it goes through.
    pub crossed: Vec<Crossing>,
}

/// The paths of all rays through pixels, in a fixed order: what a gradient by the wanted parameters depends on.
pub(crate) fn paths<L: Lanes>(prepared: &Prepared<'_, L>, wanted: Wanted<'_>) -> Vec<Path> {
    let (width, height) = (prepared.scene.width, prepared.scene.height);
    let dark = Dark::of_gradient(wanted, prepared.pass);
    let strips = for_each_strip(width, height, Sight::default, |sight, strip| {
        let mut paths = Vec::new();
        for tile in strip.tiles() {
            for sample in prepared.samples(&tile) {
                prepared.see(&sample, dark, sight);
                paths.extend(rays(tile.rays()).map(|ray| path(&tile, sight, ray)));
            }
        }
        paths
    });
    strips.concat()
}

/// What one ray of a tile has met.
fn path<L: Lanes>(tile: &Tile, sight: &Sight<L>, ray: usize) -> Path {
    let (x, y) = tile.pixel(ray);
    let met = sight.views().iter().map_while(|view| {
        let hit = view.hits.get(ray)?;
        let lights = view.lit.iter().enumerate();
        let reached = lights.filter(|(_, lit)| lit.reaches(ray)).map(|(light, _)| {
            let passed = view.passed.get(light);
            let crossed = passed.iter().flat_map(|passed| passed.crossed(ray));
            let crossed = crossed.map(|(crossing, _)| crossing).collect();
            Reached { light, crossed }
        });
        let lit = reached.collect();
        Some(Meeting { primitive: hit.primitive as usize, leaves: hit.leaves, lit })
    });
    let meetings: Vec<Meeting> = met.collect();
    let next = sight.views().get(meetings.len());
    let into_nothing = next.is_some_and(|view| view.missed >> ray & 1 == 1);
    let rays = meetings.len() + usize::from(into_nothing);
    Path { x, y, meetings, rays }
}
