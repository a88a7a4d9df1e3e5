//! What must hold of a scene before it is rendered.

use std::collections::HashSet;

use glam::DVec3;

use super::{MaterialObject, MeshObject, ParameterId, Parameters, Scene};
use crate::Error;
use crate::kernels::camera::Camera;

#[cfg(test)]
mod tests;

/// Lengths and coordinates beyond this overflow when an `f32` squares them.
const LARGEST_LENGTH: f64 = 1e18;
/// Lengths below this vanish when an `f32` squares them.
const SMALLEST_LENGTH: f64 = 1e-18;
/// Other numbers beyond this leave the range of an `f32`.
const LARGEST_NUMBER: f64 = 1e38;
/// The power of a rounding error next to 1 is far from 1 beyond this exponent, and the highlight is
/// smaller than any pixel.
pub(crate) const LARGEST_EXPONENT: f64 = 1e6;
/// Texture coordinates beyond this do not tell texels apart in an `f32`.
const LARGEST_COORDINATE: f64 = 1e6;
/// The sine of the angle below which two directions count as parallel.
const PARALLEL: f64 = 1e-6;
/// The precision that the direction of the view has to have: that of the rays.
const DIRECTION: f64 = 1e-9;
/// The least angle between pixels: four units in the last place of a direction. Rays go through the
/// scene in single precision, whatever the kernels compute in, so closer ones would be the same.
const SMALLEST_ANGLE: f64 = 4.0 * f32::EPSILON as f64;
/// The most pixels of an image, and the most texels of all textures.
pub const MOST_PIXELS: u64 = 1 << 28;

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
        self.check_values(&self.parameters, &self.parameter_ids())?;
        self.check_textures()?;
        self.check_opacities()?;
        self.check_surfaces()
    }

    /// Checks that the scene can be rendered with other values of some of its parameters.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong.
    pub fn check_values(
        &self,
        parameters: &Parameters,
        changed: &[ParameterId],
    ) -> Result<(), Invalid> {
        for &id in changed {
            self.check_numbers(parameters, id)?;
        }
        self.check_camera(&parameters.camera)
    }

    /// The parallel arrays and the names.
    fn check_structure(&self) -> Result<(), Invalid> {
        let Scene { parameters, light_names, materials, textures, spheres, meshes, .. } = self;
        let Scene { shapes, custom_lights, .. } = self;
        let counts = [
            ("light", light_names.len(), parameters.lights.len()),
            ("material", materials.len(), parameters.materials.len()),
            ("texture", textures.len(), parameters.textures.len()),
            ("sphere", spheres.len(), parameters.spheres.len()),
            ("shape", shapes.len(), parameters.shapes.len()),
            ("light", custom_lights.len(), parameters.custom_lights.len()),
            ("mesh", meshes.len(), parameters.vertices.len()),
            ("mesh", meshes.len(), parameters.texture_coordinates.len()),
        ];
        for (kind, names, values) in counts {
            if names != values {
                return invalid(kind, format!("{names} names for {values} objects"));
            }
        }
        let custom = custom_lights.iter().map(|light| &light.name);
        check_names("light", light_names.iter().chain(custom).map(String::as_str))?;
        check_names("shape", shapes.iter().map(|s| s.name.as_str()))?;
        check_names("material", materials.iter().map(|m| m.name.as_str()))?;
        check_names("texture", textures.iter().map(|t| t.name.as_str()))?;
        check_names("sphere", spheres.iter().map(|s| s.name.as_str()))?;
        check_names("mesh", meshes.iter().map(|m| m.name.as_str()))
    }

    /// Each number of a parameter by itself.
    fn check_numbers(&self, parameters: &Parameters, id: ParameterId) -> Result<(), Invalid> {
        use ParameterId::*;
        let values = parameters.get(id);
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
                | Vertex { .. }
        );
        let bound = match id {
            _ if is_length => LARGEST_LENGTH,
            TextureCoordinates(_) => LARGEST_COORDINATE,
            Exponent(_) => LARGEST_EXPONENT,
            _ => LARGEST_NUMBER,
        };
        for (i, &value) in values.iter().enumerate() {
            let element = || match id {
                Vertices(_) | Texels(_) => format!("{}[{}]", path(), i / 3),
                TextureCoordinates(_) => format!("{}[{}]", path(), i / 2),
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
                | Opacity(_)
                | Texels(_)
        );
        match (id, values) {
            _ if not_negative && values.iter().any(|&v| v < 0.0) => {
                let value = values.iter().copied().fold(0.0, f64::min);
                invalid(path(), format!("must not be negative, is {value}"))
            }
            (Opacity(_), &[v]) if v > 1.0 => invalid(path(), format!("must be at most 1, is {v}")),
            (Texels(i), _) if self.is_of_opacity(i) && values.iter().any(|&v| v > 1.0) => {
                let value = values.iter().copied().fold(1.0, f64::max);
                invalid(path(), format!("must be at most 1 where they vary opacity, is {value}"))
            }
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

    fn check_camera(&self, camera: &Camera<f64>) -> Result<(), Invalid> {
        if self.width == 0 || self.height == 0 {
            let size = if self.width == 0 { "camera.width" } else { "camera.height" };
            return invalid(size, "must be at least 1 pixel, is 0");
        }
        let pixels = u64::from(self.width) * u64::from(self.height);
        if pixels > MOST_PIXELS {
            let problem = format!("{pixels} pixels; an image may have up to {MOST_PIXELS}");
            return invalid("camera.width", problem);
        }
        // The direction is taken in double precision, wherever the camera stands.
        let view = camera.look_at - camera.look_from;
        let rounding = DIRECTION * camera.look_at.abs().max(camera.look_from.abs()).max_element();
        if view.length() < rounding.max(SMALLEST_LENGTH) {
            return invalid("camera.look_from", "must differ from camera.look_at");
        }
        let sine = view.normalize().cross(camera.up.normalize()).length();
        if sine < PARALLEL {
            return invalid(
                "camera.up",
                "must not be parallel to the view from camera.look_from to camera.look_at",
            );
        }
        // From one pixel to the next, in radians where they are closest together.
        let half_height = (0.5 * camera.vfov).to_radians().tan() * camera.focus;
        let pixel = 2.0 * half_height / f64::from(self.height);
        if pixel < SMALLEST_ANGLE {
            let problem = format!(
                "pixels are {pixel:.1e} rad apart, too close for rays in single precision: a wider \
                 view or fewer pixels ({SMALLEST_ANGLE:.1e} rad or more) would do"
            );
            return invalid("camera.vfov", problem);
        }
        Ok(())
    }

    /// The sizes of textures, and who wears which.
    fn check_textures(&self) -> Result<(), Invalid> {
        for (texture, texels) in self.textures.iter().zip(&self.parameters.textures) {
            let (width, height) = (texture.width as usize, texture.height as usize);
            let path = format!("texture.{}", texture.name);
            if width == 0 || height == 0 {
                return invalid(path, format!("has no area: {width} x {height} texels"));
            }
            if width.checked_mul(height) != Some(texels.len()) {
                let count = texels.len();
                return invalid(path, format!("{count} texels for {width} x {height}"));
            }
        }
        let texels = self.parameters.textures.iter().map(Vec::len).sum::<usize>() as u64;
        if texels > MOST_PIXELS {
            let problem = format!("{texels} texels; all textures may have up to {MOST_PIXELS}");
            return invalid("texture", problem);
        }
        let textures = self.textures.len();
        for material in &self.materials {
            if let Some(index) = material.textures.iter().find(|&t| t as usize >= textures) {
                let path = format!("material.{}", material.name);
                return invalid(path, format!("names texture {index} of {textures}"));
            }
        }
        Ok(())
    }

    /// Each opacity belongs to one material, which is no mirror: a ray goes on in one direction. A texture
    /// varies only an opacity that is there.
    fn check_opacities(&self) -> Result<(), Invalid> {
        let opacities = self.materials.iter().filter_map(|material| material.opacity);
        let count = self.parameters.opacities.len();
        if !opacities.clone().eq(0..count as u32) {
            let problem =
                format!("opacities {:?} for {count} of them", opacities.collect::<Vec<_>>());
            return invalid("material", problem);
        }
        let varied = |material: &&MaterialObject| material.textures.opacity.is_some();
        if let Some(bare) = self.materials.iter().filter(varied).find(|m| m.opacity.is_none()) {
            let problem = "is missing; opacity_texture varies it";
            return invalid(format!("material.{}.opacity", bare.name), problem);
        }
        let materials = self.materials.iter().zip(&self.parameters.materials);
        for (object, material) in materials.filter(|(object, _)| object.opacity.is_some()) {
            if material.reflection != DVec3::ZERO {
                let problem = "a mirror is opaque; leave out either opacity or reflection";
                return invalid(format!("material.{}.opacity", object.name), problem);
            }
        }
        Ok(())
    }

    /// The texture coordinates of a mesh: there where a texture needs them.
    fn check_texture_coordinates(
        &self,
        mesh: &MeshObject,
        coordinates: &[[f64; 2]],
    ) -> Result<(), Invalid> {
        let path = || format!("mesh.{}", mesh.name);
        let (given, triangles) = (mesh.texture_triangles.len(), mesh.triangles.len());
        if given != 0 && given != triangles {
            let problem = format!("texture coordinates of {given} triangles for {triangles}");
            return invalid(path(), problem);
        }
        let indices = mesh.texture_triangles.iter().flatten().flatten();
        if let Some(index) = indices.copied().find(|&i| i as usize >= coordinates.len()) {
            let count = coordinates.len();
            return invalid(path(), format!("names texture coordinate {index} of {count}"));
        }
        let bare = mesh.materials.iter().enumerate().find(|&(triangle, &material)| {
            self.materials[material as usize].textures.any()
                && mesh.texture_triangles.get(triangle).copied().flatten().is_none()
        });
        match bare {
            Some((triangle, &material)) => {
                let material = &self.materials[material as usize].name;
                let problem = format!(
                    "triangle {triangle} wears the material `{material}`, which has a texture, but \
                     has no texture coordinates"
                );
                invalid(path(), problem)
            }
            None => Ok(()),
        }
    }

    /// The indices of spheres and meshes.
    fn check_surfaces(&self) -> Result<(), Invalid> {
        let materials = self.materials.len();
        let no_material = |path: String, index: u32| {
            invalid(path, format!("names material {index} of {materials}"))
        };
        for sphere in &self.spheres {
            if sphere.material as usize >= materials {
                return no_material(format!("sphere.{}.material", sphere.name), sphere.material);
            }
        }
        for shape in &self.shapes {
            let path = || format!("shape.{}.material", shape.name);
            let Some(material) = self.materials.get(shape.material as usize) else {
                return no_material(path(), shape.material);
            };
            if material.textures.any() {
                return invalid(path(), "has a texture, for which this shape has no coordinates");
            }
            if material.opacity.is_some() {
                return invalid(path(), "has an opacity; a shape of this kind is opaque");
            }
        }
        let meshes = self.meshes.iter().zip(&self.parameters.vertices).enumerate();
        for (index, (mesh, vertices)) in meshes {
            let path = format!("mesh.{}", mesh.name);
            if mesh.materials.len() != mesh.triangles.len() {
                let (materials, triangles) = (mesh.materials.len(), mesh.triangles.len());
                return invalid(path, format!("{materials} materials for {triangles} triangles"));
            }
            if let Some(&index) = mesh.materials.iter().find(|&&m| m as usize >= materials) {
                return no_material(path, index);
            }
            self.check_texture_coordinates(mesh, &self.parameters.texture_coordinates[index])?;
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
