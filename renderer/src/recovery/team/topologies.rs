//! Triangles of meshes as numbers that ranks send each other.

use crate::optimize::Topology;

/// For each: which variable, how many vertices, how many triangles; the vertices, the triangles, the materials.
/// A double holds every index exactly.
pub(in crate::recovery) fn topologies_to_numbers(topologies: &[Topology]) -> Vec<f64> {
    let numbers = |topology: &Topology| {
        let Topology { variable, vertices, triangles, materials } = topology;
        let counts = [*variable, vertices.len(), triangles.len()].map(|count| count as f64);
        let indices = triangles.as_flattened().iter().chain(materials).copied().map(f64::from);
        let vertices = vertices.as_flattened().iter().copied();
        counts.into_iter().chain(vertices).chain(indices).collect::<Vec<_>>()
    };
    topologies.iter().flat_map(numbers).collect()
}

/// The triangles of meshes [as numbers](topologies_to_numbers), again.
#[cfg(feature = "cli")]
pub(in crate::recovery) fn topologies_of_numbers(numbers: &[f64]) -> Vec<Topology> {
    let (mut topologies, mut rest) = (Vec::new(), numbers);
    while let Some((&[variable, vertices, triangles], after)) = rest.split_first_chunk() {
        let index = |&number: &f64| number as u32;
        let (vertices, after) = after.split_at(3 * vertices as usize);
        let (corners, after) = after.split_at(3 * triangles as usize);
        let (materials, after) = after.split_at(triangles as usize);
        topologies.push(Topology {
            variable: variable as usize,
            vertices: vertices.as_chunks().0.to_vec(),
            triangles: corners
                .as_chunks()
                .0
                .iter()
                .map(|c: &[f64; 3]| c.each_ref().map(index))
                .collect(),
            materials: materials.iter().map(index).collect(),
        });
        rest = after;
    }
    topologies
}

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;

    #[test]
    fn topologies_are_the_same_again() {
        let topology = |variable: usize, triangles: Vec<[u32; 3]>| Topology {
            variable,
            vertices: (0..4).map(|i| [f64::from(i), 0.1, -1e-300]).collect(),
            materials: vec![u32::MAX; triangles.len()],
            triangles,
        };
        let topologies = [topology(2, vec![[0, 1, 2], [3, 2, 1]]), topology(5, Vec::new())];
        assert_eq!(topologies_of_numbers(&topologies_to_numbers(&topologies)), topologies);
    }
}
