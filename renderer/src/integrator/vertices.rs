//! The vertices by which a gradient is wanted: all, those of some meshes, or single ones.

use std::ops::Range;

use ad::lanes::Lanes;
use glam::DVec3;

use super::prepared::Prepared;
use super::sums::Slots;
use crate::scene::ParameterId;

/// The wanted vertices of a scene, in its order, without the others between them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ChosenVertices {
    /// In the order of the scene; none overlaps another.
    runs: Vec<Run>,
    /// How many they are.
    count: usize,
    /// Whether there are no others.
    every: bool,
}

/// Wanted vertices that follow each other.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Run {
    mesh: usize,
    /// The first of them, by its index in the mesh.
    vertex: usize,
    count: usize,
    /// Whether they are the mesh's all.
    whole: bool,
    /// The index of the first of them through all meshes.
    first: usize,
    /// The index of the first of them among those wanted.
    place: usize,
}

impl ChosenVertices {
    /// Those that `ids` name.
    pub fn new<L: Lanes>(prepared: &Prepared<'_, L>, ids: &[ParameterId]) -> Self {
        let mut named: Vec<(usize, Option<usize>)> = ids
            .iter()
            .filter_map(|id| match *id {
                ParameterId::Vertices(mesh) => Some((mesh, None)),
                ParameterId::Vertex { mesh, vertex } => Some((mesh, Some(vertex))),
                _ => None,
            })
            .collect();
        // A mesh comes before its single vertices, which it covers.
        named.sort_unstable();
        named.dedup();
        let mut chosen = Self::default();
        for (mesh, vertex) in named {
            if chosen.runs.last().is_some_and(|run| run.whole && run.mesh == mesh) {
                continue;
            }
            let vertices = prepared.vertices_of_mesh(mesh);
            let (whole, place) = (vertex.is_none(), chosen.count);
            let count = if whole { vertices.len() } else { 1 };
            let vertex = vertex.unwrap_or(0);
            let first = vertices.start + vertex;
            chosen.runs.push(Run { mesh, vertex, count, whole, first, place });
            chosen.count += count;
        }
        chosen.every = chosen.count == prepared.vertices.len();
        chosen
    }

    /// The index of a vertex among those wanted.
    #[inline]
    pub fn place(&self, vertex: usize) -> Option<usize> {
        if self.every {
            return Some(vertex);
        }
        let run = self.runs[..self.runs.partition_point(|run| run.first <= vertex)].last()?;
        let index = vertex - run.first;
        (index < run.count).then_some(run.place + index)
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Whether they are all that the scene has.
    pub fn are_all(&self) -> bool {
        self.every
    }

    /// Where those that a parameter names stand among those wanted; nowhere if they are not wanted, or
    /// if it names none.
    pub fn range_of(&self, id: ParameterId) -> Range<usize> {
        let named = match id {
            ParameterId::Vertices(mesh) => (mesh, 0),
            ParameterId::Vertex { mesh, vertex } => (mesh, vertex),
            _ => return 0..0,
        };
        let until = self.runs.partition_point(|run| (run.mesh, run.vertex) <= named);
        match (id, self.runs[..until].last()) {
            (ParameterId::Vertices(mesh), Some(run)) if run.mesh == mesh && run.whole => {
                run.place..run.place + run.count
            }
            (ParameterId::Vertex { mesh, vertex }, Some(run))
                if run.mesh == mesh && vertex - run.vertex < run.count =>
            {
                let place = run.place + (vertex - run.vertex);
                place..place + 1
            }
            _ => 0..0,
        }
    }
}

/// The sums of wanted vertices.
pub(super) struct VertexSums<'a> {
    pub chosen: &'a ChosenVertices,
    slots: Slots,
}

impl<'a> VertexSums<'a> {
    pub fn new(chosen: &'a ChosenVertices) -> Self {
        Self { chosen, slots: Slots::new(chosen.count()) }
    }

    /// Adds `term` to the sum of a vertex, if it is wanted.
    #[inline]
    pub fn add(&mut self, sums: &mut Vec<(u32, DVec3)>, vertex: usize, term: DVec3) {
        if let Some(place) = self.chosen.place(vertex) {
            self.slots.add(sums, place, term);
        }
    }
}
