//! What must hold of a scene before it is rendered.

use std::borrow::Cow;
use std::collections::HashSet;

use glam::DVec3;

use super::table::{self, LARGEST_COORDINATE, LARGEST_NORMAL_SCALE, SMALLEST_LENGTH};
use super::{
    Bsdf, Light, LightSource, MOST_LIGHT_SAMPLES, MaterialObject, Mesh, Normals, Object,
    ParameterId, PathTracing, Scene, ShapeObject, Slot, SphereObject, Texture,
};
use crate::{Error, memory};

#[cfg(test)]
mod tests;

/// The sine of the angle below which two directions count as parallel.
const PARALLEL: f64 = 1e-6;
/// The precision that the direction of the view has to have: that of the rays.
const DIRECTION: f64 = 1e-9;
/// The least angle between pixels: four units in the last place of a direction. Rays go through the
/// scene in single precision, whatever the kernels compute in, so closer ones would be the same.
const SMALLEST_ANGLE: f64 = 4.0 * f32::EPSILON as f64;
/// The most pixels of an image, and the most texels of all textures.
pub const MOST_PIXELS: u64 = 1 << 28;

/// What a pixel takes: its image, its radiance, and its target.
const PIXEL_BYTES: u64 = 48;
/// What a light takes: its numbers, and its name where errors need it.
const LIGHT_BYTES: u64 = 3000;
/// What the vertices of a path at one depth take: the record of a group of lanes, on each thread.
const BOUNCE_BYTES: u64 = 40_000;
/// What a texel of a map of the environment takes beside itself, where directions are chosen by it.
const CELL_BYTES: u64 = 48;

/// What is wrong with a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Invalid {
    /// The path of the parameter or field: `camera.look_from`, `mesh.tree.vertices[7]`.
    pub path: String,
    /// What is wrong with it, and what would be right.
    pub problem: String,
}

impl From<Invalid> for Error {
    fn from(Invalid { path, problem }: Invalid) -> Self {
        Self::new(path, problem)
    }
}

impl Scene {
    /// Checks that the scene can be rendered, and says in which file the problem is.
    ///
    /// # Errors
    ///
    /// The error of [`check`](Self::check), at `place: path`.
    pub fn validate(&self, place: impl ToString) -> Result<(), Error> {
        self.check().map_err(|Invalid { path, problem }| {
            Error::new(format!("{}: {path}", place.to_string()), problem)
        })
    }

    /// Checks that the scene can be rendered: every number is finite and in its range at `f32`, the
    /// camera looks somewhere, indices are in range, names are unique. What is added to a scene has been
    /// checked already; its public fields have not.
    ///
    /// A name may hold dots: in a path it is what stands between the first dot and the last.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong.
    pub fn check(&self) -> Result<(), Invalid> {
        let mut names = HashSet::new();
        for object in self.objects() {
            if !names.insert((object.kind(), self.name_of(object))) {
                return self.same_name(object);
            }
            self.check_values_of(object)?;
        }
        self.eyes().try_for_each(|eye| self.check_camera(eye))?;
        self.check_integrator()?;
        self.objects().try_for_each(|object| self.check_structure(object))?;
        self.check_memory()?;
        let texels = self.textures.iter().map(|texture| texture.texels.len() as u64).sum::<u64>();
        if texels > MOST_PIXELS {
            let problem = format!("{texels} texels; all textures may have up to {MOST_PIXELS}");
            return invalid("texture", problem);
        }
        Ok(())
    }

    /// What numbers alone may make large.
    fn check_memory(&self) -> Result<(), Invalid> {
        let bends = |material: &MaterialObject| {
            material.transparent || material.values.mirror != DVec3::ZERO
        };
        // Without mirrors and transparent surfaces paths end where they begin.
        let depth = if self.materials.iter().any(bends) { u64::from(self.bounces) } else { 0 };
        let pixels = (0..self.views.len().max(1)).map(|view| {
            let [width, height] = self.size_at(view);
            u64::from(width) * u64::from(height)
        });
        let kind = self.eye().kind();
        let scattered = self.path_tracing().map_or(0, |path| u64::from(path.max_depth));
        let map = self.environment.and_then(|environment| environment.texture);
        let lights = self.light_points() as u64;
        let texels = map
            .and_then(|texture| self.textures.get(texture as usize))
            .map_or(0, |map| u64::from(map.width) * u64::from(map.height));
        for (path, bytes) in [
            (&*format!("{kind}.width"), pixels.sum::<u64>().saturating_mul(PIXEL_BYTES)),
            ("light", lights.saturating_mul(LIGHT_BYTES)),
            ("bounces", depth.saturating_mul(BOUNCE_BYTES)),
            ("integrator.max_depth", scattered.saturating_mul(BOUNCE_BYTES)),
            ("environment.texture", texels.saturating_mul(CELL_BYTES)),
        ] {
            memory::ask(bytes).map_err(|problem| Invalid { path: path.into(), problem })?;
        }
        Ok(())
    }

    /// How many lights, or points of them, surfaces are shaded by.
    pub(super) fn light_points(&self) -> usize {
        let sky = self.environment.filter(|_| self.path_tracing().is_none());
        let of_sky = sky.map_or(0, |_| self.light_samples as usize);
        let lights = self.lights.iter().map(|light| light.source.place_count(self.light_samples));
        lights.sum::<usize>() + of_sky
    }

    /// Which paths of light count, and by how many points lights stand.
    fn check_integrator(&self) -> Result<(), Invalid> {
        if !(1..=MOST_LIGHT_SAMPLES).contains(&self.light_samples) {
            let (most, count) = (MOST_LIGHT_SAMPLES, self.light_samples);
            let problem = format!("must lie between 1 and {most}, is {count}");
            return invalid("light_samples", problem);
        }
        let Some(PathTracing { max_depth, samples, .. }) = self.path_tracing() else {
            let refracts = |material: &&MaterialObject| material.bsdf == Bsdf::Dielectric;
            if self.environment.is_some_and(|environment| environment.background.is_some()) {
                let problem = "is seen where light takes all paths: integrator.type = \"path\"";
                return invalid("environment.background", problem);
            }
            return match self.materials.iter().find(refracts) {
                None => Ok(()),
                Some(material) => invalid(
                    format!("material.{}.type", material.name),
                    "a dielectric refracts light that takes all paths: integrator.type = \"path\"",
                ),
            };
        };
        let most = PathTracing::MOST_SAMPLES;
        if max_depth == 0 {
            return invalid("integrator.max_depth", "must be at least 1, is 0");
        }
        if !(1..=most).contains(&samples) {
            let problem = format!("must lie between 1 and {most}, is {samples}");
            return invalid("integrator.samples", problem);
        }
        Ok(())
    }

    /// Checks the object that was added last of its kind.
    pub(super) fn check_object(&self, object: Object) -> Result<(), Invalid> {
        let name = self.name_of(object);
        let others = self.objects().filter(|other| other.kind() == object.kind());
        if others.filter(|&other| other != object).any(|other| self.name_of(other) == name) {
            return self.same_name(object);
        }
        self.check_values_of(object)?;
        self.check_structure(object)
    }

    /// Checks that the scene can be rendered with the values that these parameters have now.
    ///
    /// # Errors
    ///
    /// The first thing that is wrong.
    #[doc(hidden)]
    pub fn check_values(&self, changed: &[ParameterId]) -> Result<(), Invalid> {
        changed.iter().try_for_each(|&id| self.check_numbers(id))?;
        self.eyes().try_for_each(|eye| self.check_camera(eye))
    }

    fn check_values_of(&self, object: Object) -> Result<(), Invalid> {
        self.parameters_of(object).try_for_each(|id| self.check_numbers(id))
    }

    /// Each number of a parameter by itself.
    fn check_numbers(&self, id: ParameterId) -> Result<(), Invalid> {
        let (row, range) = (table::row(id), self.range(id));
        let problem = |value: f64| match value {
            _ if !value.is_finite() => Some(format!("{value} is not a finite number")),
            _ if (range.0..=range.1).contains(&value) => None,
            _ if matches!(id.object, Object::Texture(_)) && value > range.1 && range.1 == 1.0 => {
                Some(format!(
                    "must be at most 1 where they vary opacity or roughness or bend normals, is {value}"
                ))
            }
            _ => Some(out_of(range, value)),
        };
        let first = |values: &mut dyn Iterator<Item = f64>| {
            values.enumerate().find_map(|(index, value)| Some((index, problem(value)?)))
        };
        let (found, numbers) = match id.object {
            // Too many to be copied.
            Object::Texture(i) => {
                (first(&mut self.textures[i].texels.iter().flatten()), Cow::default())
            }
            _ => {
                let numbers = self.get(id);
                (first(&mut numbers.iter().copied()), numbers)
            }
        };
        if let Some((index, problem)) = found {
            let path = self.path(id).to_string();
            return match (id.field, id.vertex) {
                ("vertices", None) | ("normals" | "texels", _) => {
                    invalid(format!("{path}[{}]", index / 3), problem)
                }
                ("texture_coordinates", _) => invalid(format!("{path}[{}]", index / 2), problem),
                _ => invalid(path, problem),
            };
        }
        let is_zero = |v: &[f64; 3]| DVec3::from(*v).length() < SMALLEST_LENGTH;
        let zero = || numbers.as_chunks().0.iter().position(is_zero);
        if row.is_direction
            && let Some(index) = zero()
        {
            let index = if id.field == "normals" { format!("[{index}]") } else { String::new() };
            let path = format!("{}{index}", self.path(id));
            return invalid(path, "must be a direction, is the zero vector");
        }
        if let (Object::Light(light), "right" | "up") = (id.object, id.field)
            && let LightSource::Known(Light::Rectangle(light) | Light::Disc(light)) =
                &self.lights[light].source
            && light.right.cross(light.up).length() < SMALLEST_LENGTH * SMALLEST_LENGTH
            // The zero vector is the mistake of its own field.
            && light.up.length() >= SMALLEST_LENGTH
        {
            return invalid(self.path(id), "`right` and `up` must not point along one line");
        }
        if let (Object::Light(light), "inner_angle" | "outer_angle") = (id.object, id.field)
            && let LightSource::Known(Light::Spot(light)) = &self.lights[light].source
            && light.inner_angle >= light.outer_angle
        {
            let (inner, outer) = (light.inner_angle, light.outer_angle);
            let problem = format!(
                "`inner_angle`, {inner}, must be below `outer_angle`, {outer}: gradients do not see the edge of a sharp cone"
            );
            return invalid(self.path(id), problem);
        }
        // A ray meets a shape where the shape was before it was placed.
        let is_flat = || numbers.iter().any(|scale| scale.abs() < SMALLEST_LENGTH);
        if (id.object.kind(), id.field) == ("shape", "scale") && is_flat() {
            return invalid(self.path(id), "must not be 0 along any axis");
        }
        Ok(())
    }

    /// What the scene may be seen through.
    fn check_camera(&self, eye: Object) -> Result<(), Invalid> {
        let (index, place) = match eye {
            Object::View(view) => (view, format!("view.{}", self.views[view].name)),
            _ => (0, "camera".to_owned()),
        };
        let ([width, height], camera) = (self.size_at(index), self.camera_at(index));
        if width == 0 || height == 0 {
            let size = if width == 0 { "width" } else { "height" };
            return invalid(format!("{place}.{size}"), "must be at least 1 pixel, is 0");
        }
        let pixels = u64::from(width) * u64::from(height);
        if pixels > MOST_PIXELS {
            let problem = format!("{pixels} pixels; an image may have up to {MOST_PIXELS}");
            return invalid(format!("{place}.width"), problem);
        }
        // The direction is taken in double precision, wherever the camera stands.
        let view = camera.look_at - camera.look_from;
        let rounding = DIRECTION * camera.look_at.abs().max(camera.look_from.abs()).max_element();
        if view.length() < rounding.max(SMALLEST_LENGTH) {
            let problem = format!("must differ from {place}.look_at");
            return invalid(format!("{place}.look_from"), problem);
        }
        let sine = view.normalize().cross(camera.up.normalize()).length();
        if sine < PARALLEL {
            let problem = format!(
                "must not be parallel to the view from {place}.look_from to {place}.look_at"
            );
            return invalid(format!("{place}.up"), problem);
        }
        // From one pixel to the next, in radians where they are closest together.
        let half_height = (0.5 * camera.vfov).to_radians().tan() * camera.film_scale;
        let pixel = 2.0 * half_height / f64::from(height);
        if pixel < SMALLEST_ANGLE {
            let problem = format!(
                "pixels are {pixel:.1e} rad apart, too close for rays in single precision: a wider \
                 view or fewer pixels ({SMALLEST_ANGLE:.1e} rad or more) would do"
            );
            return invalid(format!("{place}.vfov"), problem);
        }
        Ok(())
    }

    /// The name of an object, and what it is made of beside numbers.
    fn check_structure(&self, object: Object) -> Result<(), Invalid> {
        self.check_name(object)?;
        match object {
            Object::View(_) => self.check_camera(object),
            Object::Camera | Object::Light(_) => Ok(()),
            Object::Environment => self.check_environment(),
            Object::Material(i) => self.check_material(i),
            Object::Texture(i) => check_texture(&self.textures[i]),
            Object::Sphere(i) => self.check_sphere(&self.spheres[i], object),
            Object::Mesh(i) => self.check_mesh(&self.meshes[i], object),
            Object::Shape(i) => self.check_shape(&self.shapes[i], object),
        }
    }

    fn check_name(&self, object: Object) -> Result<(), Invalid> {
        let (kind, name) = (object.kind(), self.name_of(object));
        if matches!(object, Object::Camera | Object::Environment) {
            return Ok(());
        }
        if name.is_empty() {
            return invalid(kind, "an object of this kind has an empty name");
        }
        if name.trim() != name || name.chars().any(char::is_control) {
            return invalid(
                format!("{kind}.{}", name.escape_debug()),
                "a name must not begin or end with a space, nor hold control characters",
            );
        }
        Ok(())
    }

    fn same_name(&self, object: Object) -> Result<(), Invalid> {
        let kind = object.kind();
        let path = format!("{kind}.{}", self.name_of(object));
        invalid(path, format!("two {kind} objects have this name"))
    }

    /// The textures of a material, and its opacity: a material is no mirror and transparent at once,
    /// since a ray goes on in one direction.
    fn check_material(&self, index: usize) -> Result<(), Invalid> {
        let material = &self.materials[index];
        let (path, textures) = (format!("material.{}", material.name), self.textures.len());
        let assigned = material.textures.0.iter().flatten();
        if let Some(index) = { assigned }.find(|&&texture| texture as usize >= textures) {
            return invalid(path, format!("names texture {index} of {textures}"));
        }
        if let Some(slot) = Slot::ALL
            .into_iter()
            .find(|&slot| material.textures.get(slot).is_some() && !material.bsdf.has(slot.field()))
        {
            let path = format!("{path}.{}_texture", slot.field());
            return invalid(path, "varies nothing that a material of this type has");
        }
        if material.textures.get(Slot::Normal).is_some() && material.values.mirror != DVec3::ZERO {
            let problem = "a mirror has none; leave out either normal_texture or mirror";
            return invalid(format!("{path}.normal_texture"), problem);
        }
        let scale = material.normal_scale;
        if !scale.is_finite() || scale.abs() > LARGEST_NORMAL_SCALE {
            let problem = match scale.is_finite() {
                true => out_of((-LARGEST_NORMAL_SCALE, LARGEST_NORMAL_SCALE), scale),
                false => format!("{scale} is not a finite number"),
            };
            return invalid(format!("{path}.normal_scale"), problem);
        }
        let path = format!("{path}.opacity");
        if material.transparent && material.bsdf == Bsdf::Dielectric {
            return invalid(
                path,
                "a dielectric has none: its index of refraction says what it lets through",
            );
        }
        if material.textures.get(Slot::Opacity).is_some() && !material.transparent {
            return invalid(path, "is missing; opacity_texture varies it");
        }
        if material.transparent && material.values.mirror != DVec3::ZERO {
            return invalid(path, "a mirror is opaque; leave out either opacity or mirror");
        }
        Ok(())
    }

    fn check_environment(&self) -> Result<(), Invalid> {
        let Some(environment) = &self.environment else { return Ok(()) };
        let textures = self.textures.len();
        if let Some(texture) = environment.texture.filter(|&index| index as usize >= textures) {
            return invalid(
                "environment.texture",
                format!("names texture {texture} of {textures}"),
            );
        }
        let (low, high) = self.range(ParameterId::new(Object::Environment, "radiance"));
        let background = environment.background.unwrap_or(DVec3::ZERO).to_array();
        match background.into_iter().find(|value| !(low..=high).contains(value)) {
            Some(value) if !value.is_finite() => {
                invalid("environment.background", format!("{value} is not a finite number"))
            }
            Some(value) => invalid("environment.background", out_of((low, high), value)),
            None => Ok(()),
        }
    }

    fn check_material_of(&self, object: Object, material: u32) -> Result<(), Invalid> {
        if (material as usize) < self.materials.len() {
            return Ok(());
        }
        let path = format!("{}.{}.material", object.kind(), self.name_of(object));
        invalid(path, format!("names material {material} of {}", self.materials.len()))
    }

    fn check_sphere(&self, sphere: &SphereObject, object: Object) -> Result<(), Invalid> {
        self.check_material_of(object, sphere.material)?;
        let material = &self.materials[sphere.material as usize];
        if material.textures.get(Slot::Normal).is_some() {
            let problem = "has a normal_texture, which bends the normals of meshes alone";
            return invalid(format!("sphere.{}.material", sphere.name), problem);
        }
        Ok(())
    }

    fn check_shape(&self, shape: &ShapeObject, object: Object) -> Result<(), Invalid> {
        self.check_material_of(object, shape.material)?;
        let material = &self.materials[shape.material as usize];
        let path = format!("shape.{}", shape.name);
        if material.textures.any() {
            let problem = "has a texture, for which this shape has no coordinates";
            return invalid(format!("{path}.material"), problem);
        }
        if material.transparent || material.bsdf == Bsdf::Dielectric {
            let problem = "has an opacity or is a dielectric; a shape of this kind is opaque";
            return invalid(format!("{path}.material"), problem);
        }
        Ok(())
    }

    fn check_mesh(&self, mesh: &Mesh, object: Object) -> Result<(), Invalid> {
        let path = format!("mesh.{}", mesh.name);
        if mesh.materials.len() != mesh.triangles.len() {
            let (materials, triangles) = (mesh.materials.len(), mesh.triangles.len());
            return invalid(path, format!("{materials} materials for {triangles} triangles"));
        }
        if let Some(&material) =
            mesh.materials.iter().find(|&&material| material as usize >= self.materials.len())
        {
            return self.check_material_of(object, material);
        }
        self.check_texture_coordinates(mesh)?;
        check_normals(mesh)?;
        let indices = mesh.triangles.as_flattened();
        let vertices = mesh.vertices.len();
        match indices.iter().find(|&&index| index as usize >= vertices) {
            Some(index) => invalid(path, format!("names vertex {index} of {vertices}")),
            None => Ok(()),
        }
    }

    /// The texture coordinates of a mesh: there where a texture needs them.
    fn check_texture_coordinates(&self, mesh: &Mesh) -> Result<(), Invalid> {
        let path = || format!("mesh.{}", mesh.name);
        let (given, triangles) = (mesh.texture_triangles.len(), mesh.triangles.len());
        if given != 0 && given != triangles {
            let problem = format!("texture coordinates of {given} triangles for {triangles}");
            return invalid(path(), problem);
        }
        let count = mesh.texture_coordinates.len();
        let indices = mesh.texture_triangles.iter().flatten().flatten();
        if let Some(index) = { indices }.find(|&&index| index as usize >= count) {
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
                    "triangle {triangle} has the material `{material}`, which has a texture, but \
                     has no texture coordinates"
                );
                invalid(path(), problem)
            }
            None => Ok(()),
        }
    }
}

/// The indices of the normals of a mesh.
fn check_normals(mesh: &Mesh) -> Result<(), Invalid> {
    let Normals::Given { directions, triangles } = &mesh.normals else { return Ok(()) };
    let path = || format!("mesh.{}.normals", mesh.name);
    let (given, count) = (triangles.len(), mesh.triangles.len());
    if given != count {
        return invalid(path(), format!("{given} triangles of normals for {count}"));
    }
    let count = directions.len();
    match triangles.iter().flatten().flatten().find(|&&index| index as usize >= count) {
        Some(index) => invalid(path(), format!("names normal {index} of {count}")),
        None => Ok(()),
    }
}

fn check_texture(texture: &Texture) -> Result<(), Invalid> {
    let (width, height) = (texture.width as usize, texture.height as usize);
    let path = format!("texture.{}", texture.name);
    if width == 0 || height == 0 {
        return invalid(path, format!("has no area: {width} x {height} texels"));
    }
    if width.checked_mul(height) != Some(texture.texels.len()) {
        let count = texture.texels.len();
        return invalid(path, format!("{count} texels for {width} x {height}"));
    }
    Ok(())
}

/// What is said of a number outside of a range.
fn out_of((low, high): (f64, f64), value: f64) -> String {
    match value {
        _ if value < 0.0 && low == 0.0 => format!("must not be negative, is {value}"),
        _ if value < low && low == SMALLEST_LENGTH => match value > 0.0 {
            true => format!("must be at least {low:e}, is {value:e}"),
            false => format!("must be above 0, is {value:?}"),
        },
        _ if high == 1.0 => format!("must be at most 1, is {value}"),
        _ if high >= LARGEST_COORDINATE => format!("{value:e} is beyond {high:e}"),
        _ => format!("must lie between {low} and {high}, is {value}"),
    }
}

fn invalid<T>(path: impl ToString, problem: impl ToString) -> Result<T, Invalid> {
    Err(Invalid { path: path.to_string(), problem: problem.to_string() })
}
