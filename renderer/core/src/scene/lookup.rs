//! From a path that a person typed to a parameter.

use super::parameter::split_index;
use super::{ParameterId, Scene};
use crate::Error;

/// How many paths a message lists at most.
const LISTED: usize = 8;
/// So many letters tell at least the kind of an object.
const TELLING: usize = 3;

impl Scene {
    /// The parameter that a path names: `light.key.position`, `mesh.tree.vertices[17]`.
    ///
    /// # Errors
    ///
    /// If there is none: the message lists the paths that are closest.
    pub fn parameter(&self, path: &str) -> Result<ParameterId, Error> {
        self.find_parameter(path).map_err(|problem| Error::new(path, problem))
    }

    /// The parameter that a path names, or one line that says that there is none and lists the paths
    /// that are closest.
    #[doc(hidden)]
    pub fn find_parameter(&self, path: &str) -> Result<ParameterId, String> {
        if let Some(id) = self.named(path) {
            return Ok(id);
        }
        if let Some((whole, index)) = split_index(path)
            && let Some(id) = self.named(whole)
            && let Some(mesh) = self.mesh_of(id)
            && id.field == "vertices"
        {
            let count = mesh.vertices.len();
            return Err(format!(
                "no parameter `{path}`: mesh `{}` has {count} vertices, counted from 0, and \
                 `{index}` is none of them",
                mesh.name
            ));
        }
        let counts_pixels = path.ends_with(".width") || path.ends_with(".height");
        if counts_pixels && ["camera.", "view."].iter().any(|kind| path.starts_with(kind)) {
            return Err(format!(
                "`{path}` counts pixels, and is no parameter: on the command line --width and --height say them"
            ));
        }
        let paths = self.parameters().into_iter().map(|id| self.path(id).to_string());
        let paths: Vec<String> = paths.collect();
        let close = closest(path, &paths);
        Err(if close.is_empty() {
            format!(
                "no parameter `{path}`: paths begin with {}, environment, light, material, sphere, \
                 mesh, texture or shape",
                self.eye().kind()
            )
        } else {
            format!("no parameter `{path}`; closest: {}", close.join(", "))
        })
    }
}

/// The paths among `paths` that someone may have meant by `path`: a slip of the keyboard; else the part of
/// a path; else the object, or only its kind, at the beginning.
fn closest<'a>(path: &str, paths: &'a [String]) -> Vec<&'a str> {
    let listed = |is_close: &dyn Fn(&str) -> bool| -> Vec<&'a str> {
        paths.iter().map(String::as_str).filter(|other| is_close(other)).take(LISTED).collect()
    };
    let fewest_slips = paths.iter().map(|other| edit_distance(path, other)).min().unwrap_or(0);
    if fewest_slips <= path.len() / 5 {
        return listed(&|other| edit_distance(path, other) == fewest_slips);
    }
    let with_part = listed(&|other| path.len() >= TELLING && other.contains(path));
    if !with_part.is_empty() {
        return with_part;
    }
    let common = |other: &str| path.bytes().zip(other.bytes()).take_while(|(a, b)| a == b).count();
    let longest = paths.iter().map(|other| common(other)).max().unwrap_or(0);
    if longest < TELLING { Vec::new() } else { listed(&|other| common(other) == longest) }
}

/// How many letters have to be inserted, removed or replaced (Levenshtein).
fn edit_distance(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, letter) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, other) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(letter != *other);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(row[j] + 1).min(diagonal + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Object;
    use crate::scene::example::tree;

    #[test]
    fn a_wrong_path_leads_to_the_right_one() {
        let scene = tree();
        assert_eq!(
            scene.find_parameter("camera.vfov"),
            Ok(ParameterId::new(Object::Camera, "vfov"))
        );
        assert_eq!(
            scene.find_parameter("light.key.positon").unwrap_err(),
            "no parameter `light.key.positon`; closest: light.key.position"
        );
        assert_eq!(
            scene.find_parameter("lights.kye.radiant_intensity").unwrap_err(),
            "no parameter `lights.kye.radiant_intensity`; closest: \
             light.key.radiant_intensity"
        );
        assert_eq!(
            scene.find_parameter("exponent").unwrap_err(),
            "no parameter `exponent`; closest: material.bark.exponent, material.leaves.exponent"
        );
        assert_eq!(
            scene.find_parameter("light.key.size").unwrap_err(),
            "no parameter `light.key.size`; closest: light.key.position, light.key.color, \
             light.key.radiant_intensity"
        );
        let vertex = |path: &str| scene.find_parameter(path);
        let mesh = Object::Mesh(0);
        let id = ParameterId { vertex: Some(7), ..ParameterId::new(mesh, "vertices") };
        assert_eq!(vertex("mesh.tree.vertices[7]"), Ok(id));
        assert_eq!(scene.path(id).to_string(), "mesh.tree.vertices[7]");
        let count = scene.meshes[0].vertices.len();
        for index in [count.to_string(), "-1".into(), "x".into(), String::new()] {
            assert_eq!(
                vertex(&format!("mesh.tree.vertices[{index}]")).unwrap_err(),
                format!(
                    "no parameter `mesh.tree.vertices[{index}]`: mesh `tree` has {count} vertices, \
                     counted from 0, and `{index}` is none of them"
                )
            );
        }
        let error = vertex("light.key.position[1]").unwrap_err();
        assert!(error.ends_with("closest: light.key.position"), "{error}");
        let error = scene.find_parameter("camera.width").unwrap_err();
        assert!(error.contains("is no parameter"), "{error}");
        let error = scene.find_parameter("x").unwrap_err();
        assert!(error.contains("paths begin with camera"), "{error}");
    }
}
