//! The system of equations of Large Steps.

use glam::DVec3;
use renderer_core::Error;
use rsparse::data::{Sprs, Symb};
use rsparse::{chol, schol};

use super::Laplacian;

/// `I + lambda L`, factored, where `L` is the sum over edges of their weight times the squared difference of
/// their ends (Nicolet, Jacobson and Jakob, "Large Steps in Inverse Rendering of Geometry", 2021).
///
/// A step by `(I + lambda L)^-1 (I + lambda L)^-1 g` in place of the gradient `g` is a step of gradient descent
/// in the coordinates `u = (I + lambda L) v` of the vertices `v`: it moves whole regions, and its fixed points
/// are the same. Symbolic and numeric factorisation (Cholesky, with the vertices in an order of approximately
/// minimum degree) are made once; a solution takes time in proportion to the entries of the factor.
pub struct System {
    /// The lower triangle.
    factor: Sprs<f64>,
    /// By vertex: its place in the factor.
    places: Vec<usize>,
}

/// The ordering of `A + A^T` in `rsparse`.
const CHOLESKY: i8 = 0;

impl System {
    /// Beyond this, the identity is lost beside the Laplacian.
    pub const LARGEST_LAMBDA: f64 = 1e9;

    /// Of a mesh.
    ///
    /// # Errors
    ///
    /// If `lambda` is not above 0, or above [`LARGEST_LAMBDA`](Self::LARGEST_LAMBDA).
    pub fn new(laplacian: &Laplacian, lambda: f64) -> Result<Self, Error> {
        let refuse = |problem: String| Error::new("large_steps", problem);
        if !(lambda > 0.0 && lambda <= Self::LARGEST_LAMBDA) {
            let most = Self::LARGEST_LAMBDA;
            return Err(refuse(format!("must be above 0 and at most {most:e}, is {lambda}")));
        }
        let matrix = matrix(laplacian, lambda);
        let mut symbolic: Symb = schol(&matrix, CHOLESKY);
        let factored = chol(&matrix, &mut symbolic);
        let factor = factored
            .map_err(|_| refuse(format!("{lambda} is too large: the matrix cannot be factored")))?;
        let places = match symbolic.pinv {
            Some(places) => places.into_iter().map(|place| place as usize).collect(),
            None => (0..laplacian.count).collect(),
        };
        Ok(Self { factor: factor.l, places })
    }

    /// Replaces a vector for each vertex, `b`, by the solution `x` of `(I + lambda L) x = b`.
    ///
    /// # Panics
    ///
    /// If there are not three numbers for each vertex.
    pub fn solve(&self, b: &mut [f64]) {
        let count = self.places.len();
        assert_eq!(b.len(), 3 * count, "three numbers for each vertex");
        let mut x = vec![DVec3::ZERO; count];
        for (&place, b) in self.places.iter().zip(b.as_chunks().0) {
            x[place] = DVec3::from_array(*b);
        }
        // All three at once: the factor is read once for each direction.
        for column in 0..count {
            let (diagonal, below) = self.column(column);
            let solved = x[column] / diagonal;
            x[column] = solved;
            below.for_each(|(row, entry)| x[row] -= entry * solved);
        }
        for column in (0..count).rev() {
            let (diagonal, below) = self.column(column);
            let known = below.fold(DVec3::ZERO, |sum, (row, entry)| sum + entry * x[row]);
            x[column] = (x[column] - known) / diagonal;
        }
        for (&place, b) in self.places.iter().zip(b.as_chunks_mut().0) {
            *b = x[place].to_array();
        }
    }

    /// A column of the factor: its entry on the diagonal, and those below with their rows.
    fn column(&self, column: usize) -> (f64, impl Iterator<Item = (usize, f64)>) {
        let Sprs { p: starts, i: rows, x: entries, .. } = &self.factor;
        let (start, end) = (starts[column] as usize, starts[column + 1] as usize);
        let below = rows[start + 1..end].iter().zip(&entries[start + 1..end]);
        (entries[start], below.map(|(&row, &entry)| (row, entry)))
    }
}

/// The matrix, column by column, rows in ascending order.
fn matrix(laplacian: &Laplacian, lambda: f64) -> Sprs<f64> {
    let count = laplacian.count;
    let mut columns: Vec<Vec<(usize, f64)>> =
        (0..count).map(|vertex| vec![(vertex, 1.0 + lambda * laplacian.degrees[vertex])]).collect();
    for &(a, b, weight) in &laplacian.edges {
        let (a, b) = (a as usize, b as usize);
        columns[a].push((b, -lambda * weight));
        columns[b].push((a, -lambda * weight));
    }
    let mut matrix = Sprs::zeros(count, count, count + 2 * laplacian.edges.len());
    let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
    for mut column in columns {
        column.sort_unstable_by_key(|(row, _)| *row);
        for (row, value) in column {
            rows.push(row);
            values.push(value);
        }
        starts.push(rows.len() as isize);
    }
    (matrix.p, matrix.i, matrix.x) = (starts, rows, values);
    matrix
}

#[cfg(test)]
mod tests {
    use super::super::{Weights, tests::strip};
    use super::*;

    /// What is solved, multiplied by the edges again, is what was given.
    #[test]
    fn solutions_solve() {
        let (vertices, triangles) = strip();
        for weights in [Weights::Uniform, Weights::Cotangent] {
            let laplacian = Laplacian::new(&vertices, &triangles, weights);
            for lambda in [0.1, 25.0, 1e6] {
                let system = System::new(&laplacian, lambda).unwrap();
                let b: Vec<f64> = (0..30).map(|i| (1.3 * f64::from(i)).cos()).collect();
                let mut x = b.clone();
                system.solve(&mut x);
                let mut again = x.clone();
                for &(a, b, weight) in &laplacian.edges {
                    for axis in 0..3 {
                        let (a, b) = (3 * a as usize + axis, 3 * b as usize + axis);
                        let difference = lambda * weight * (x[a] - x[b]);
                        again[a] += difference;
                        again[b] -= difference;
                    }
                }
                let error = again
                    .iter()
                    .zip(&b)
                    .map(|(a, b)| (a - b).abs())
                    .fold(0.0, |m: f64, e| if e.is_nan() { f64::INFINITY } else { m.max(e) });
                assert!(error < 1e-8, "{weights:?} {lambda}: {error}");
                // A vertex without neighbours stays what it is.
                assert!((x[27] - b[27]).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn what_cannot_be_solved_is_refused() {
        let (vertices, triangles) = strip();
        let laplacian = Laplacian::new(&vertices, &triangles, Weights::Uniform);
        for lambda in [0.0, -1.0, 1e10, f64::NAN, f64::INFINITY] {
            assert!(System::new(&laplacian, lambda).is_err(), "{lambda}");
        }
    }
}
