//! Meshes whose triangles change in the course of a run.

use std::borrow::Cow;
use std::ops::Range;

use super::{Recovery, regularizer, variable};
use crate::Error;
use crate::experiment::{OptimizeSection, Remeshing, TunedParameter};
use crate::optimize::{Change, Scale, Topology};
use crate::remesh::{self, Remeshed, mean_edge_length, remesh};
use crate::scene::{Mesh, ParameterId, Scene};

/// What is wrong with how the triangles of a mesh are to change, if they are.
pub(crate) fn check_remeshing(scene: &Scene, tuned: &TunedParameter) -> Result<(), String> {
    let Some(Remeshing { edge_length, every }) = tuned.remesh else { return Ok(()) };
    let Some(mesh) = tuned.id.whole_mesh() else {
        return Err("is for all vertices of a mesh".to_owned());
    };
    if every == 0 {
        return Err("every: must be at least 1, is 0".to_owned());
    }
    let per_vertex = [("min", &tuned.min), ("max", &tuned.max), ("spread", &tuned.spread)];
    if let Some((field, _)) = per_vertex.iter().find(|(_, numbers)| numbers.is_some()) {
        return Err(format!("changes the vertices that `{field}` is for; leave one of them out"));
    }
    if tuned.scale == Scale::Log {
        return Err("moves vertices to either side of 0; leave scale = \"log\" out".to_owned());
    }
    let mesh = &scene.meshes()[mesh];
    remesh::check(mesh, edge_length)
        .map_err(|problem| format!("the mesh `{}`: {problem}", mesh.name))
}

/// Whether the optimiser goes on where triangles change.
pub(super) fn check_optimizer(
    scene: &Scene,
    section: &OptimizeSection,
    place: &str,
) -> Result<(), Error> {
    let refuse = |tuned: &TunedParameter, problem: String| {
        let path = scene.path(tuned.id);
        Error::new(format_args!("{place}: optimize.parameter.{path}.remesh"), problem)
    };
    let optimizer = section.optimizer.unwrap_or_default();
    for tuned in section.parameters.iter().filter(|tuned| tuned.remesh.is_some()) {
        check_remeshing(scene, tuned).map_err(|problem| refuse(tuned, problem))?;
        if optimizer.finds_step_lengths() {
            let name = optimizer.name();
            let problem = format!("{name} compares steps of the same vertices, which this changes");
            return Err(refuse(tuned, problem));
        }
    }
    Ok(())
}

/// A scene with the triangles of other meshes; nothing if these are none of the parameters, or incoherent.
pub(crate) fn with_topologies(
    scene: &Scene,
    ids: &[ParameterId],
    topologies: &[Topology],
) -> Option<Scene> {
    let mut scene = scene.clone();
    for Topology { variable, vertices, triangles, materials } in topologies {
        let mesh = &mut scene.meshes[ids.get(*variable)?.whole_mesh()?];
        let corners = triangles.as_flattened();
        if materials.len() != triangles.len()
            || corners.iter().any(|&corner| corner as usize >= vertices.len())
        {
            return None;
        }
        let (vertices, triangles) = (vertices.clone(), triangles.clone());
        *mesh = Mesh { vertices, triangles, materials: materials.clone(), ..mesh.clone() };
    }
    Some(scene)
}

impl Recovery<'_> {
    /// This inverse problem from where the triangles of meshes have [changed](TunedParameter::remesh) on: those of the
    /// scene are replaced. For the topologies of an [outcome](crate::optimize::Outcome::topologies).
    ///
    /// # Errors
    ///
    /// If they are none of this problem.
    pub fn with_topologies(&self, topologies: &[Topology]) -> Result<Recovery<'static>, Error> {
        let unknown =
            || Error::new("optimize", "the triangles of a mesh are not those of this problem");
        let scene = with_topologies(&self.scene, &self.ids, topologies).ok_or_else(unknown)?;
        let mut variables = self.variables.clone();
        for topology in topologies {
            // What follows from the size of the mesh stays what it was at the beginning.
            let (variable, tuned) =
                (&mut variables[topology.variable], &self.section.parameters[topology.variable]);
            let rate = variable.learning_rate.first().copied();
            *variable = variable::variable(&scene, tuned, rate, None)?;
        }
        let regularizers =
            regularizer::of(&scene, &self.section.parameters).map_err(|_| unknown())?;
        Ok(Recovery {
            scene: Cow::Owned(scene),
            section: self.section.clone(),
            settings: self.settings,
            targets: self.targets.clone(),
            ids: self.ids.clone(),
            regularizers,
            variables,
            allow_non_finite: self.allow_non_finite,
            left_out: self.left_out.clone(),
        })
    }

    /// What changes before an iteration of a run that is at `x`, with the problem from there on. Lengths fall from those
    /// of the meshes of `original`, the problem at the beginning.
    pub(super) fn remeshed(
        &self,
        original: &Scene,
        iteration: u64,
        x: &[f64],
    ) -> Result<Option<(Recovery<'static>, Change)>, Error> {
        let is_due = |tuned: &TunedParameter| tuned.remesh.is_some_and(|of| of.is_due(iteration));
        if !self.section.parameters.iter().any(is_due) {
            return Ok(None);
        }
        let scene = self.scene_at(x);
        let (mut topologies, mut pieces, mut start) = (Vec::new(), Vec::new(), 0);
        for (index, tuned) in self.section.parameters.iter().enumerate() {
            let block = start..start + self.variables[index].initial.len();
            start = block.end;
            let mut changed = None;
            if let (Some(remeshing), Some(mesh)) = (tuned.remesh, tuned.id.whole_mesh()) {
                if remeshing.is_due(iteration) {
                    let initial = mean_edge_length(&original.meshes[mesh]);
                    let length = remeshing.edge_length_at(iteration, initial);
                    changed = Some(remesh(&scene.meshes[mesh], length)?);
                }
                let now = changed.as_ref().map_or(&self.scene.meshes[mesh], |to| &to.mesh);
                topologies.push(topology(index, now));
            }
            pieces.push((block, changed));
        }
        let recovery = self.with_topologies(&topologies)?;
        let variables = recovery.variables.clone();
        let moved = |(block, changed): &(Range<usize>, Option<Remeshed>)| match changed {
            Some(changed) => changed.mesh.vertices.as_flattened().to_vec(),
            None => x[block.clone()].to_vec(),
        };
        let x = pieces.iter().flat_map(moved).collect();
        let carry = Box::new(move |memory: &[f64]| {
            let of_piece = |(block, changed): &(Range<usize>, Option<Remeshed>)| match changed {
                Some(changed) => changed.carry::<3>(&memory[block.clone()]),
                None => memory[block.clone()].to_vec(),
            };
            pieces.iter().flat_map(of_piece).collect()
        });
        Ok(Some((recovery, Change { topologies, variables, x, carry })))
    }
}

fn topology(variable: usize, mesh: &Mesh) -> Topology {
    let Mesh { vertices, triangles, materials, .. } = mesh.clone();
    Topology { variable, vertices, triangles, materials }
}
