//! The rasteriser: which primitives may cover which tile of the image.
//!
//! Primitives are sorted into tiles by the boxes around them on the image; within a tile a ray
//! through the middle of each pixel is tested against the primitives of the tile alone, with the
//! tests that traversal uses. So the image is that of the ray tracer, perspective is exact without
//! interpolation, and nothing needs to be clipped but the boxes. Turned down: edge functions that are
//! stepped from pixel to pixel, which round differently from rays and leave gaps or doubles along
//! edges.

use glam::{DVec3, Vec3};

use super::bvh::{Hit, PacketHits, PacketVectors, Shape, ShapeTest, Shapes, rays};
use super::tile::{TILE, Tile};
use crate::transport::camera::CameraFrame;

/// The primitives that may cover each tile, in their order.
pub struct Raster {
    /// Tiles per row.
    columns: usize,
    tiles: Vec<Vec<u32>>,
    shapes: Vec<Shape>,
}

/// The smallest depth, relative to the distance of the farthest corner, at which a corner is
/// projected: nearer parts are clipped.
const NEAR: f64 = 1e-6;

impl Raster {
    /// Sorts the shapes that a camera sees in an image of `width` by `height` pixels.
    pub fn new(shapes: &impl Shapes, frame: &CameraFrame<f64>, width: u32, height: u32) -> Self {
        let (columns, rows) = (width.div_ceil(TILE as u32), height.div_ceil(TILE as u32));
        let mut tiles = vec![Vec::new(); columns as usize * rows as usize];
        let shapes: Vec<Shape> = (0..shapes.count() as u32).map(|id| shapes.shape(id)).collect();
        for (index, shape) in shapes.iter().enumerate() {
            let Some([low, high]) = film_box(frame, shape) else { continue };
            // A pixel more on each side, for what single precision makes of edges.
            let first = |at: f64, size: u32| {
                (((at + 1.0) * 0.5 * f64::from(size) - 1.0) / TILE as f64).floor().max(0.0) as usize
            };
            let last = |at: f64, size: u32, tiles: u32| {
                let tile = ((at + 1.0) * 0.5 * f64::from(size) + 1.0) / TILE as f64;
                (tile.floor().min(f64::from(tiles) - 1.0) + 1.0).max(0.0) as usize
            };
            // The y axis of the film points upwards.
            for row in first(-high[1], height)..last(-low[1], height, rows) {
                for column in first(low[0], width)..last(high[0], width, columns) {
                    tiles[row * columns as usize + column].push(index as u32);
                }
            }
        }
        Self { columns: columns as usize, tiles, shapes }
    }

    /// Finds what the wanted rays of a tile meet first.
    pub fn nearest_into(
        &self,
        tile: &Tile,
        origin: Vec3,
        directions: &PacketVectors,
        wanted: u64,
        hits: &mut PacketHits,
    ) {
        *hits = PacketHits::NONE;
        let members = &self.tiles[tile.top / TILE * self.columns + tile.left / TILE];
        for ray in rays(wanted) {
            let Some(test) = ShapeTest::new(origin, directions.get(ray)) else { continue };
            for &primitive in members {
                let (distance, leaves) = test.distance(&self.shapes[primitive as usize]);
                if distance < hits.distance[ray] {
                    hits.set(ray, Hit { primitive, distance, leaves });
                }
            }
        }
    }
}

/// The lowest and the highest coordinates on the film of the part of a shape that is before the
/// camera; nothing if all of it is behind.
fn film_box(frame: &CameraFrame<f64>, shape: &Shape) -> Option<[[f64; 2]; 2]> {
    let box_corners = |[low, high]: [Vec3; 2]| {
        let corner = |i: usize| {
            let side = |axis: usize| [low, high][i >> axis & 1][axis];
            Vec3::new(side(0), side(1), side(2)).as_dvec3()
        };
        (0..8).map(corner).collect()
    };
    let corners: Vec<DVec3> = match shape {
        Shape::Triangle(corners) => corners.map(Vec3::as_dvec3).to_vec(),
        &Shape::Sphere(center, radius) => box_corners([center - radius, center + radius]),
        Shape::Custom(shape) => box_corners(shape.bounds().into()),
    };
    // Depth and coordinates on the film times depth.
    let project = |corner: DVec3| {
        let from_eye = corner - frame.origin;
        let along = |axis: DVec3| from_eye.dot(axis) / axis.length_squared();
        DVec3::new(along(frame.right), along(frame.up), from_eye.dot(frame.forward))
    };
    let corners: Vec<DVec3> = corners.into_iter().map(project).collect();
    let farthest = corners.iter().map(|corner| corner.z).fold(f64::NEG_INFINITY, f64::max);
    if farthest <= 0.0 {
        return None;
    }
    let near = NEAR * farthest;
    let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    let mut include = |corner: DVec3| {
        for (axis, at) in [corner.x / corner.z, corner.y / corner.z].into_iter().enumerate() {
            bounds[0][axis] = bounds[0][axis].min(at);
            bounds[1][axis] = bounds[1][axis].max(at);
        }
    };
    for (i, &a) in corners.iter().enumerate() {
        if a.z >= near {
            include(a);
        }
        // Where the edge to another corner meets the near plane.
        for &b in &corners[i + 1..] {
            if (a.z < near) != (b.z < near) {
                let at = a.lerp(b, (near - a.z) / (b.z - a.z));
                include(DVec3::new(at.x, at.y, near));
            }
        }
    }
    Some(bounds)
}
