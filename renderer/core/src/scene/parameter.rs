//! Parameters: blocks of numbers that paths such as `light.key.position` name.

use std::borrow::Cow;
use std::fmt;

use ad::{Field, Fields};
use glam::DVec3;

use super::numbers::Numbers;
use super::{Environment, EnvironmentObject, Material, Mesh, Object, ParameterId, Scene, table};

/// One that is black.
const NO_ENVIRONMENT: EnvironmentObject = EnvironmentObject {
    values: Environment { radiance: DVec3::ZERO, rotation: 0.0 },
    texture: None,
    background: None,
};

impl Scene {
    /// Whether silhouettes, shadows or other edges in the image move with a parameter, also those that are seen
    /// behind what refracts. Where light takes all paths, the gradient by it is right in the mean, but no
    /// derivative of the same estimate: directions that were scattered stay where they are.
    pub fn moves_edges(&self, id: ParameterId) -> bool {
        // Where light takes all paths the environment casts no shadow with an edge.
        let is_soft = id.object == Object::Environment && self.path_tracing().is_some();
        table::row(id).moves_edges && !is_soft || self.refracts_by(id)
    }

    fn object(&self, object: Object) -> &dyn Numbers {
        match object {
            Object::Camera => &self.camera,
            Object::View(i) => &self.views[i].camera,
            Object::Environment => self.environment.as_ref().unwrap_or(&NO_ENVIRONMENT),
            Object::Light(i) => &self.lights[i],
            Object::Material(i) => &self.materials[i],
            Object::Texture(i) => &self.textures[i],
            Object::Sphere(i) => &self.spheres[i],
            Object::Mesh(i) => &self.meshes[i],
            Object::Shape(i) => &self.shapes[i],
        }
    }

    fn object_mut(&mut self, object: Object) -> &mut dyn Numbers {
        match object {
            Object::Camera => &mut self.camera,
            Object::View(i) => &mut self.views[i].camera,
            Object::Environment => self.environment.get_or_insert(NO_ENVIRONMENT),
            Object::Light(i) => &mut self.lights[i],
            Object::Material(i) => &mut self.materials[i],
            Object::Texture(i) => &mut self.textures[i],
            Object::Sphere(i) => &mut self.spheres[i],
            Object::Mesh(i) => &mut self.meshes[i],
            Object::Shape(i) => &mut self.shapes[i],
        }
    }

    /// The name of an object; those of the camera and the environment are empty.
    pub(crate) fn name_of(&self, object: Object) -> &str {
        match object {
            Object::Camera | Object::Environment => "",
            Object::View(i) => &self.views[i].name,
            Object::Light(i) => &self.lights[i].name,
            Object::Material(i) => &self.materials[i].name,
            Object::Texture(i) => &self.textures[i].name,
            Object::Sphere(i) => &self.spheres[i].name,
            Object::Mesh(i) => &self.meshes[i].name,
            Object::Shape(i) => &self.shapes[i].name,
        }
    }

    /// The objects of the scene: the camera or the views, the environment if there is one, then the others
    /// by kind.
    pub(crate) fn objects(&self) -> impl Iterator<Item = Object> + use<> {
        let all = |count: usize, object: fn(usize) -> Object| (0..count).map(object);
        self.eyes()
            .chain(self.environment.map(|_| Object::Environment))
            .chain(all(self.lights.len(), Object::Light))
            .chain(all(self.materials.len(), Object::Material))
            .chain(all(self.spheres.len(), Object::Sphere))
            .chain(all(self.meshes.len(), Object::Mesh))
            .chain(all(self.textures.len(), Object::Texture))
            .chain(all(self.shapes.len(), Object::Shape))
    }

    /// The fields of an object that are parameters.
    pub(crate) fn fields(&self, object: Object) -> Vec<Field> {
        self.object(object).fields()
    }

    /// All fields of an object, also those that are no parameters of it, in the order of its numbers.
    pub(crate) fn all_fields(&self, object: Object) -> Vec<Field> {
        match object {
            Object::Material(_) => Material::<f64>::FIELDS.to_vec(),
            Object::Environment => Environment::<f64>::FIELDS.to_vec(),
            _ => self.fields(object),
        }
    }

    /// The parameters of an object.
    #[doc(hidden)]
    pub fn parameters_of(&self, object: Object) -> impl Iterator<Item = ParameterId> + use<> {
        self.fields(object).into_iter().map(move |field| ParameterId::new(object, field.name))
    }

    /// Every parameter of the scene, in a fixed order. Single vertices are not among them: they are
    /// parts of others.
    pub fn parameters(&self) -> Vec<ParameterId> {
        self.objects().flat_map(|object| self.parameters_of(object)).collect()
    }

    /// The numbers of a parameter.
    ///
    /// # Panics
    ///
    /// If `id` is not a parameter of the scene.
    pub fn get(&self, id: ParameterId) -> Cow<'_, [f64]> {
        let numbers = self.object(id.object).get(id.field);
        let numbers = numbers.unwrap_or_else(|| panic!("{id:?} is no parameter of the scene"));
        match (id.vertex, numbers) {
            (None, numbers) => numbers,
            (Some(vertex), Cow::Borrowed(all)) => Cow::Borrowed(&all[3 * vertex..][..3]),
            (Some(_), Cow::Owned(_)) => panic!("{id:?} has no vertices"),
        }
    }

    /// How many numbers a parameter has.
    ///
    /// # Panics
    ///
    /// If `id` is not a parameter of the scene.
    pub fn count(&self, id: ParameterId) -> usize {
        let field = self.fields(id.object).into_iter().find(|field| field.name == id.field);
        let field = field.unwrap_or_else(|| panic!("{id:?} is no parameter of the scene"));
        if id.vertex.is_some() { 3 } else { field.len }
    }

    /// Replaces the numbers of a parameter, which may then be out of their ranges: to be followed by
    /// [`check_values`](Self::check_values).
    ///
    /// # Panics
    ///
    /// If `id` is not a parameter of the scene, or has another number of numbers.
    #[doc(hidden)]
    pub fn assign(&mut self, id: ParameterId, numbers: &[f64]) {
        assert_eq!(numbers.len(), self.count(id), "{id:?} keeps its number of numbers");
        let first = 3 * id.vertex.unwrap_or(0);
        self.object_mut(id.object).set(id.field, first, numbers);
    }

    /// Replaces the numbers of several parameters, one after the other in `values`, without checking
    /// them.
    #[doc(hidden)]
    pub fn assign_all(&mut self, ids: &[ParameterId], mut values: &[f64]) {
        for &id in ids {
            let (numbers, rest) = values.split_at(self.count(id));
            self.assign(id, numbers);
            values = rest;
        }
    }

    /// Replaces the numbers of a parameter.
    ///
    /// # Errors
    ///
    /// If there are too few or too many numbers, or one is out of its range; the scene stays what it
    /// was.
    pub fn set(&mut self, id: ParameterId, numbers: &[f64]) -> Result<(), crate::Error> {
        let old = self.get(id).into_owned();
        if old.len() != numbers.len() {
            let problem = format!("needs {} numbers, has {}", old.len(), numbers.len());
            return Err(crate::Error::new(self.path(id), problem));
        }
        self.assign(id, numbers);
        self.check_values(&[id]).map_err(|invalid| {
            self.assign(id, &old);
            invalid.into()
        })
    }

    /// The shape of a parameter: empty for a number, `[3]` for a vector, `[n, 3]` for vertices
    /// and normals, `[n, 2]` for texture coordinates, `[height, width, 3]` for texels.
    pub fn shape(&self, id: ParameterId) -> Vec<usize> {
        let count = self.count(id);
        match (id.object, id.field, id.vertex) {
            (Object::Mesh(_), "vertices" | "normals", None) => vec![count / 3, 3],
            (Object::Mesh(_), "texture_coordinates", _) => vec![count / 2, 2],
            (Object::Texture(i), ..) => {
                vec![self.textures[i].height as usize, self.textures[i].width as usize, 3]
            }
            _ if count == 1 => Vec::new(),
            _ => vec![count],
        }
    }

    /// The path of a parameter: `light.key.position`.
    pub fn path(&self, id: ParameterId) -> ParameterPath<'_> {
        ParameterPath { scene: self, id }
    }

    /// The parameter that a path names, or nothing.
    pub(crate) fn named(&self, path: &str) -> Option<ParameterId> {
        let (kind, rest) = path.split_once('.')?;
        let field_of =
            |object: Object, name: &str| self.parameters_of(object).find(|id| id.field == name);
        let has_no_name = |object: &Object| matches!(object, Object::Camera | Object::Environment);
        let mut objects = self.objects().filter(has_no_name);
        if let Some(object) = objects.find(|object| object.kind() == kind) {
            return field_of(object, rest);
        }
        // Names may hold dots: the field is what follows the last one.
        let (name, field) = rest.rsplit_once('.')?;
        let mut objects = self.objects().filter(|&object| object.kind() == kind);
        let object = objects.find(|&object| self.name_of(object) == name)?;
        match split_index(field) {
            None => field_of(object, field),
            Some((field, index)) => {
                let id = field_of(object, field)?;
                let vertex = index.parse().ok()?;
                let vertices = self.mesh_of(id).filter(|_| field == "vertices")?.vertices.len();
                (vertex < vertices).then_some(ParameterId { vertex: Some(vertex), ..id })
            }
        }
    }

    /// The mesh that a parameter belongs to, if it is one of a mesh.
    pub(crate) fn mesh_of(&self, id: ParameterId) -> Option<&Mesh> {
        match id.object {
            Object::Mesh(index) => Some(&self.meshes[index]),
            _ => None,
        }
    }
}

/// `a[b]` as `a` and `b`.
pub(super) fn split_index(path: &str) -> Option<(&str, &str)> {
    path.strip_suffix(']')?.rsplit_once('[')
}

/// Displays as the path of a parameter.
pub struct ParameterPath<'a> {
    scene: &'a Scene,
    id: ParameterId,
}

impl fmt::Display for ParameterPath<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ParameterId { object, field, vertex } = self.id;
        match self.scene.name_of(object) {
            "" => write!(f, "{}.{field}", object.kind())?,
            name => write!(f, "{}.{name}.{field}", object.kind())?,
        }
        match vertex {
            Some(vertex) => write!(f, "[{vertex}]"),
            None => Ok(()),
        }
    }
}
