//! What names the objects of a scene and their parameters.

/// An object of a scene, by kind and index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Object {
    /// The camera of a scene without views.
    Camera,
    /// A view.
    View(usize),
    /// The environment.
    Environment,
    /// A light.
    Light(usize),
    /// A material.
    Material(usize),
    /// A texture.
    Texture(usize),
    /// A sphere.
    Sphere(usize),
    /// A mesh.
    Mesh(usize),
    /// A custom shape.
    Shape(usize),
}

impl Object {
    /// The kind, as paths begin.
    pub fn kind(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::View(_) => "view",
            Self::Environment => "environment",
            Self::Light(_) => "light",
            Self::Material(_) => "material",
            Self::Texture(_) => "texture",
            Self::Sphere(_) => "sphere",
            Self::Mesh(_) => "mesh",
            Self::Shape(_) => "shape",
        }
    }
}

/// One parameter of a scene: a field of an object, or one vertex of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParameterId {
    /// The object.
    pub object: Object,
    /// The name of the field.
    pub field: &'static str,
    /// The index of a vertex, if the parameter is one vertex and not all.
    pub vertex: Option<usize>,
}

impl ParameterId {
    /// The parameter `field` of an object.
    #[doc(hidden)]
    pub fn new(object: Object, field: &'static str) -> Self {
        Self { object, field, vertex: None }
    }

    /// The mesh whose vertices, all of them, the parameter is; nothing if it is another one.
    pub fn whole_mesh(self) -> Option<usize> {
        match self.object {
            Object::Mesh(mesh) if self.field == "vertices" && self.vertex.is_none() => Some(mesh),
            _ => None,
        }
    }

    /// Whether two parameters have numbers in common: they are the same, or one is a vertex of the
    /// other.
    pub fn overlaps(self, other: Self) -> bool {
        (self.object, self.field) == (other.object, other.field)
            && (self.vertex == other.vertex || self.vertex.is_none() || other.vertex.is_none())
    }
}
