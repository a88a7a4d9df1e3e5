//! How far surfaces are from each other.

use std::collections::HashMap;

use glam::{DVec3, IVec3};
use rayon::prelude::*;

use crate::random::Random;

/// Points on each surface.
const SAMPLES: usize = 50_000;
/// The side of the cells in which neighbours are looked for.
const CELL: f64 = 0.02;

/// A surface of triangles.
pub struct Surface<'a> {
    pub vertices: &'a [[f64; 3]],
    pub triangles: &'a [[u32; 3]],
}

/// Half the sum of the mean distances from points on each surface to the nearest of those on the other, and
/// the largest of these distances.
pub struct Distance {
    pub chamfer: f64,
    pub hausdorff: f64,
}

impl Surface<'_> {
    /// The distance to another.
    pub fn distance(&self, other: &Surface<'_>) -> Distance {
        let (a, b) = (self.samples(1), other.samples(2));
        let (there, back) = (distances(&a, &b), distances(&b, &a));
        let mean = |distances: &[f64]| distances.iter().sum::<f64>() / distances.len() as f64;
        let largest = there.iter().chain(&back).copied().fold(0.0, f64::max);
        Distance { chamfer: 0.5 * (mean(&there) + mean(&back)), hausdorff: largest }
    }

    /// Twice the area along the normal.
    fn normal(&self, triangle: &[u32; 3]) -> DVec3 {
        let [a, b, c] = triangle.map(|corner| DVec3::from(self.vertices[corner as usize]));
        (b - a).cross(c - a)
    }

    /// Points on it, as many wherever the area is the same.
    fn samples(&self, seed: u64) -> Vec<DVec3> {
        let mut sum = 0.0;
        let areas: Vec<f64> = self
            .triangles
            .iter()
            .map(|triangle| {
                sum += self.normal(triangle).length();
                sum
            })
            .collect();
        let mut random = Random(seed);
        let mut sample = || {
            let place = random.between(0.0, sum);
            let index = areas.partition_point(|&area| area <= place).min(areas.len() - 1);
            let corners = self.triangles[index];
            let [a, b, c] = corners.map(|corner| DVec3::from(self.vertices[corner as usize]));
            let (root, along) = (random.between(0.0, 1.0).sqrt(), random.between(0.0, 1.0));
            a * (1.0 - root) + b * (root * (1.0 - along)) + c * (root * along)
        };
        (0..SAMPLES).map(|_| sample()).collect()
    }
}

/// From each point to the nearest of others.
fn distances(points: &[DVec3], others: &[DVec3]) -> Vec<f64> {
    let cell_of = |point: DVec3| (point / CELL).floor().as_ivec3();
    let mut cells: HashMap<IVec3, Vec<DVec3>> = HashMap::new();
    others.iter().for_each(|&other| cells.entry(cell_of(other)).or_default().push(other));
    let nearest = |&point: &DVec3| {
        let (middle, mut nearest) = (cell_of(point), f64::INFINITY);
        // Shells of cells, until the next cannot hold a nearer one.
        for radius in 0_i32.. {
            if f64::from(radius - 1) * CELL > nearest {
                break;
            }
            for x in -radius..=radius {
                for y in -radius..=radius {
                    let on_side = x.abs() == radius || y.abs() == radius;
                    let step = if on_side || radius == 0 { 1 } else { 2 * radius };
                    for z in (-radius..=radius).step_by(step as usize) {
                        let found = cells.get(&(middle + IVec3::new(x, y, z)));
                        let found = found.into_iter().flatten();
                        nearest = found.map(|o| o.distance(point)).fold(nearest, f64::min);
                    }
                }
            }
        }
        nearest
    };
    points.par_iter().map(nearest).collect()
}
