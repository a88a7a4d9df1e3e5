//! What must hold of a scene before it is rendered.

use std::collections::HashSet;

use glam::DVec3;

use super::{ParameterId, Scene};
use crate::Error;

#[cfg(test)]
mod tests;

/// Lengths and coordinates beyond this overflow when an `f32` squares them.
const LARGEST_LENGTH: f64 = 1e18;
/// Lengths below this vanish when an `f32` squares them.
const SMALLEST_LENGTH: f64 = 1e-18;
/// Other numbers beyond this leave the range of an `f32`.
const LARGEST_NUMBER: f64 = 1e38;
/// The sine of the angle below which two directions count as parallel.
const PARALLEL: f64 = 1e-6;
/// The most pixels of an image.
const MOST_PIXELS: u64 = 1 << 28;

/// What is wrong with a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Invalid {
    /// The path of the parameter or field: `camera.look_from`, `mesh.tree.vertices[7]`.
    pub path: String,
    /// What is wrong with it, and what would be right.
    pub problem: String,
}

impl Scene {
    /// Checks that the scene can be rendered: every number is finite and in its range at `f32`,
    /// the camera looks somewhere, indices are in range, names are unique.
    ///
    /// A name may hold dots: in a path it is what stands between the first dot and the last.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong, at `place: path`; `place` is the file that the scene is from.
    pub fn validate(&self, place: impl ToString) -> Result<(), Error> {
        self.check().map_err(|Invalid { path, problem }| {
            Error::new(format!("{}: {path}", place.to_string()), problem)
        })
    }

    /// [`validate`](Self::validate) for a scene that is not from a file.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong.
    pub fn check(&self) -> Result<(), Invalid> {
        self.check_structure()?;
        for id in self.parameter_ids() {
            self.check_numbers(id)?;
        }
        self.check_camera()?;
        self.check_surfaces()
    }

    /// The parallel arrays and the names.
    fn check_structure(&self) -> Result<(), Invalid> {
        let Scene { parameters, light_names, material_names, spheres, meshes, .. } = self;
        let counts = [
            ("light", light_names.len(), parameters.lights.len()),
            ("material", material_names.len(), parameters.materials.len()),
            ("sphere", spheres.len(), parameters.spheres.len()),
            ("mesh", meshes.len(), parameters.vertices.len()),
        ];
        for (kind, names, values) in counts {
            if names != values {
                return invalid(kind, format!("{names} names for {values} objects"));
            }
        }
        check_names("light", light_names.iter().map(String::as_str))?;
        check_names("material", material_names.iter().map(String::as_str))?;
        check_names("sphere", spheres.iter().map(|s| s.name.as_str()))?;
        check_names("mesh", meshes.iter().map(|m| m.name.as_str()))
    }

    /// Each number of a parameter by itself.
    fn check_numbers(&self, id: ParameterId) -> Result<(), Invalid> {
        use ParameterId::*;
        let values = self.parameters.get(id);
        let path = || self.path(id).to_string();
        let is_length = matches!(
            id,
            LookFrom
                | LookAt
                | Up
                | LightPosition(_)
                | LightDirection(_)
                | SphereCenter(_)
                | SphereRadius(_)
                | Vertices(_)
        );
        let bound = if is_length { LARGEST_LENGTH } else { LARGEST_NUMBER };
        for (i, &value) in values.iter().enumerate() {
            let element = || match id {
                Vertices(_) => format!("{}[{}]", path(), i / 3),
                _ => path(),
            };
            if !value.is_finite() {
                return invalid(element(), format!("{value} is not a finite number"));
            }
            if value.abs() > bound {
                return invalid(element(), format!("{value:e} is beyond {bound:e}"));
            }
        }
        let not_negative = matches!(
            id,
            LightColor(_)
                | LightIntensity(_)
                | Ambient(_)
                | Diffuse(_)
                | Specular(_)
                | Exponent(_)
                | Reflection(_)
        );
        match (id, values) {
            _ if not_negative => match values.iter().find(|v| **v < 0.0) {
                Some(value) => invalid(path(), format!("must not be negative, is {value}")),
                None => Ok(()),
            },
            (Vfov, &[v]) if v <= 0.0 || v >= 180.0 => {
                invalid(path(), format!("must lie between 0 and 180 degrees, is {v}"))
            }
            (Focus, &[v]) if v <= 0.0 => invalid(path(), format!("must be above 0, is {v}")),
            (SphereRadius(_), &[v]) if v < SMALLEST_LENGTH => {
                invalid(path(), format!("must be above 0, is {v}"))
            }
            (Up | LightDirection(_), &[x, y, z])
                if DVec3::new(x, y, z).length() < SMALLEST_LENGTH =>
            {
                invalid(path(), "must be a direction, is the zero vector")
            }
            _ => Ok(()),
        }
    }

    fn check_camera(&self) -> Result<(), Invalid> {
        let camera = &self.parameters.camera;
        if self.width == 0 || self.height == 0 {
            let size = if self.width == 0 { "camera.width" } else { "camera.height" };
            return invalid(size, "must be at least 1 pixel, is 0");
        }
        let pixels = u64::from(self.width) * u64::from(self.height);
        if pixels > MOST_PIXELS {
            let problem = format!("{pixels} pixels; an image may have up to {MOST_PIXELS}");
            return invalid("camera.width", problem);
        }
        // What f64 tells apart may still be one point to an f32.
        let view = camera.look_at - camera.look_from;
        if camera.look_at.as_vec3() == camera.look_from.as_vec3() || view.length() < SMALLEST_LENGTH
        {
            return invalid("camera.look_from", "must differ from camera.look_at");
        }
        let sine = view.normalize().cross(camera.up.normalize()).length();
        if sine < PARALLEL {
            return invalid(
                "camera.up",
                "must not be parallel to the view from camera.look_from to camera.look_at",
            );
        }
        Ok(())
    }

    /// The indices of spheres and meshes.
    fn check_surfaces(&self) -> Result<(), Invalid> {
        let materials = self.material_names.len();
        let no_material = |path: String, index: u32| {
            invalid(path, format!("names material {index} of {materials}"))
        };
        for sphere in &self.spheres {
            if sphere.material as usize >= materials {
                return no_material(format!("sphere.{}.material", sphere.name), sphere.material);
            }
        }
        for (mesh, vertices) in self.meshes.iter().zip(&self.parameters.vertices) {
            let path = format!("mesh.{}", mesh.name);
            if mesh.materials.len() != mesh.triangles.len() {
                let (materials, triangles) = (mesh.materials.len(), mesh.triangles.len());
                return invalid(path, format!("{materials} materials for {triangles} triangles"));
            }
            if let Some(&index) = mesh.materials.iter().find(|&&m| m as usize >= materials) {
                return no_material(path, index);
            }
            let indices = mesh.triangles.as_flattened();
            if let Some(index) = indices.iter().find(|&&i| i as usize >= vertices.len()) {
                return invalid(path, format!("names vertex {index} of {}", vertices.len()));
            }
        }
        Ok(())
    }
}

fn check_names<'a>(kind: &str, names: impl Iterator<Item = &'a str>) -> Result<(), Invalid> {
    let mut seen = HashSet::new();
    for (i, name) in names.enumerate() {
        if name.is_empty() {
            return invalid(kind, format!("number {} has an empty name", i + 1));
        }
        if name.trim() != name || name.chars().any(char::is_control) {
            return invalid(
                format!("{kind}.{}", name.escape_debug()),
                "a name must not begin or end with a space, nor hold control characters",
            );
        }
        if !seen.insert(name) {
            return invalid(format!("{kind}.{name}"), format!("two {kind} objects have this name"));
        }
    }
    Ok(())
}

fn invalid<T>(path: impl ToString, problem: impl ToString) -> Result<T, Invalid> {
    Err(Invalid { path: path.to_string(), problem: problem.to_string() })
}
