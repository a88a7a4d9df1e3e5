//! What the vertices of a mesh and the texels of a texture cost by themselves, whatever images say.

mod surface;
mod variation;

pub use surface::{EdgeLengths, NormalConsistency};
pub use variation::TotalVariation;

/// The vector at an index of numbers that are vectors, one after the other.
fn vector(x: &[f64], index: usize) -> glam::DVec3 {
    glam::DVec3::from_slice(&x[3 * index..])
}

/// Adds to a vector among such numbers.
fn add(to: &mut [f64], index: usize, vector: glam::DVec3) {
    let to = to[3 * index..][..3].iter_mut();
    to.zip(vector.to_array()).for_each(|(to, number)| *to += number);
}

#[cfg(test)]
mod tests {
    use ad::check;

    /// The gradient of an energy is that of its value.
    pub fn agrees_with_differences(x: &[f64], energy: impl Fn(&[f64]) -> (f64, Vec<f64>)) {
        let (value, gradient) = energy(x);
        assert!(value > 0.0 && gradient.len() == x.len());
        for index in 0..x.len() {
            let at = |number: f64| {
                let mut x = x.to_vec();
                x[index] = number;
                energy(&x).0
            };
            let expected = check::derivative(at, x[index], 1e-4).value;
            let off = (gradient[index] - expected).abs();
            assert!(
                off <= 1e-8 * (1.0 + expected.abs()),
                "{index}: {} {expected}",
                gradient[index]
            );
        }
    }
}
