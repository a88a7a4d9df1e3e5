//! The parameters that a gradient is asked for.

use std::ops::Range;

use ad::Fields;

use super::selection::Selection;
use crate::primal::integrator::ZeroWeight;
use crate::scene::numbers::range_of;
use crate::scene::{
    DistantLight, Environment, LightSource, Material, Normals, Object, ParameterId, Scene, Sphere,
    Transform,
};
use crate::settings::{Edges, Pass};
use crate::trace::layout::Layout;
use crate::transport::light::match_light;
use crate::transport::material::{Bsdf, Lobes};

/// A bit for each number of a struct.
pub type Bits = u64;

/// The parameters that a gradient is asked for, and where their sums are. What is not asked for costs
/// nothing.
#[derive(Clone, Debug)]
pub struct Request {
    pub ids: Vec<ParameterId>,
    pub camera: bool,
    pub environment: Option<Dense>,
    /// By light, then by part of the sky: the numbers that are asked for, and where they begin among the dense
    /// sums.
    pub lights: Vec<Option<Dense>>,
    /// By custom shape: its numbers, then those of its transform.
    pub shapes: Vec<Option<Dense>>,
    /// By mesh: its transform, unless it follows from vertices and normals, because the vertices are asked
    /// for or the mesh has normals.
    pub transforms: Vec<Option<Dense>>,
    /// The number of dense sums.
    pub dense: usize,
    pub materials: Selection,
    pub material_numbers: Bits,
    pub spheres: Selection,
    pub sphere_numbers: Bits,
    pub vertices: Selection,
    pub normals: Selection,
    pub uvs: Selection,
    pub texels: Selection,
    /// Whether texels of normal maps are asked for.
    pub bends_normals: bool,
    /// Whether indices of refraction are asked for, which bend rays.
    refracts: bool,
    /// What is computed although its weight is zero.
    pub zero_weight: ZeroWeight,
    /// Whether edges move with what is asked for.
    moves_edges: bool,
    /// Whether lights move that facets or rough surfaces reflect.
    moves_grazing_lights: bool,
    takes_all_paths: bool,
}

/// Numbers that have a sum in every strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dense {
    /// Where the sums of the object begin.
    pub start: usize,
    pub numbers: Bits,
}

impl Request {
    /// The given parameters of a scene.
    pub fn new(scene: &Scene, layout: &Layout, ids: &[ParameterId]) -> Self {
        let is_light = |id: &ParameterId| matches!(id.object, Object::Light(_));
        let is_grazed = |lobes: Lobes| lobes.facets || lobes.rough;
        let mut request = Self {
            ids: ids.to_vec(),
            camera: ids.iter().any(|id| id.object == scene.eye()),
            environment: None,
            lights: vec![None; scene.lights.len() + layout.sky_parts.len()],
            shapes: vec![None; scene.shapes.len()],
            transforms: vec![None; scene.meshes.len()],
            dense: 0,
            materials: Selection::default(),
            material_numbers: 0,
            spheres: Selection::default(),
            sphere_numbers: 0,
            vertices: Selection::default(),
            normals: Selection::default(),
            uvs: Selection::default(),
            texels: Selection::default(),
            bends_normals: ids.iter().any(|id| scene.is_normal_map(id.object)),
            refracts: ids.iter().any(|&id| scene.refracts_by(id)),
            zero_weight: ZeroWeight::default(),
            moves_edges: ids.iter().any(|&id| scene.moves_edges(id)),
            moves_grazing_lights: layout.materials.iter().any(|traits| is_grazed(traits.lobes))
                && ids.iter().any(|id| is_light(id) && scene.moves_edges(*id)),
            takes_all_paths: layout.path_tracing.is_some(),
        };
        request.select_arrays(scene, layout);
        request.select_objects(scene, layout);
        let is_plain = |id: &ParameterId| match id.object {
            Object::Material(material) => layout.materials[material].bsdf == Bsdf::BlinnPhong,
            _ => false,
        };
        let of_material = |field: &str| ids.iter().any(|id| is_plain(id) && id.field == field);
        // Neither paths that are chosen at random nor edges are to be others than those of the image.
        let takes_all_paths = request.takes_all_paths;
        let of_zero = |field: &str| {
            let is_it = |id: &ParameterId| {
                is_plain(id)
                    && id.field == field
                    && scene.get(*id).iter().all(|&number| number == 0.0)
            };
            ids.iter().any(is_it)
        };
        let is_metallic_of_metal = |id: &ParameterId| match id.object {
            Object::Material(material) => {
                id.field == "metallic" && layout.materials[material].is_metal
            }
            _ => false,
        };
        let of_sky = request.select_sky(scene, layout);
        request.zero_weight = ZeroWeight {
            mirrors: layout.pass == Pass::Radiance && of_zero("mirror"),
            reflections: takes_all_paths && (of_zero("diffuse") || of_zero("specular")),
            bases: takes_all_paths && ids.iter().any(is_metallic_of_metal),
            lights: ids.iter().any(is_light) || of_sky,
            lobes: Lobes {
                rough: of_material("roughness"),
                glossy: of_material("specular"),
                facets: false,
            },
        };
        request
    }

    /// What there may be many of.
    fn select_arrays(&mut self, scene: &Scene, layout: &Layout) {
        let textures = &layout.textures;
        let texels = textures.last().map_or(0, |last| last.texels().end);
        let mut vertices: Vec<Range<usize>> = Vec::new();
        let mut normals: Vec<Range<usize>> = Vec::new();
        let (mut uvs, mut of_textures) = (Vec::new(), Vec::new());
        let (mut materials, mut spheres) = (Vec::new(), Vec::new());
        for id in &self.ids {
            match id.object {
                Object::Mesh(mesh) => {
                    let shaded_with = &scene.meshes[mesh].normals;
                    let is_moved = id.field == "vertices" && *shaded_with == Normals::Smooth;
                    let is_placed = is_of_transform(id) && *shaded_with != Normals::Flat;
                    if id.field == "normals" || is_moved || is_placed {
                        normals.push(layout.normals.of_mesh(mesh));
                    }
                    // Those of a mesh with a transform serve both.
                    match (id.field, id.vertex) {
                        ("vertices", None) => vertices.push(layout.vertices_of(mesh)),
                        ("vertices", Some(vertex)) => {
                            let vertex = layout.vertices_of(mesh).start + vertex;
                            vertices.push(vertex..vertex + 1);
                        }
                        _ if is_placed => vertices.push(layout.vertices_of(mesh)),
                        ("texture_coordinates", _) => uvs.push(layout.uvs.of_mesh(mesh)),
                        _ => {}
                    }
                }
                Object::Texture(texture) => of_textures.push(textures[texture].texels()),
                Object::Material(material) => materials.push(material..material + 1),
                Object::Sphere(sphere) => spheres.push(sphere..sphere + 1),
                Object::Camera
                | Object::View(_)
                | Object::Environment
                | Object::Light(_)
                | Object::Shape(_) => {}
            }
        }
        self.vertices = Selection::new(vertices, layout.vertices());
        self.normals = Selection::new(normals, layout.normals.count());
        self.uvs = Selection::new(uvs, layout.uvs.count());
        self.texels = Selection::new(of_textures, texels);
        self.materials = Selection::new(materials, layout.materials.len());
        self.spheres = Selection::new(spheres, layout.spheres);
    }

    /// Which numbers of objects.
    fn select_objects(&mut self, scene: &Scene, layout: &Layout) {
        for &ParameterId { object, field, .. } in &self.ids.clone() {
            match object {
                Object::Camera | Object::View(_) | Object::Texture(_) => {}
                // Their parts are lights.
                Object::Environment if layout.path_tracing.is_none() => {}
                Object::Environment => {
                    let numbers = bits(Environment::<f64>::FIELDS, field);
                    let len = Environment::<f64>::LEN;
                    add(&mut self.environment, &mut self.dense, len, numbers);
                }
                Object::Light(light) => {
                    let (fields, len) = match &scene.lights[light].source {
                        LightSource::Known(known) => match_light!(known, known => fields_of(known)),
                        LightSource::Custom { kernel, numbers } => (kernel.fields, numbers.len()),
                    };
                    add(&mut self.lights[light], &mut self.dense, len, bits(fields, field));
                }
                Object::Material(_) => {
                    self.material_numbers |= bits(Material::<f64>::FIELDS, field);
                }
                Object::Sphere(_) => self.sphere_numbers |= bits(Sphere::<f64>::FIELDS, field),
                Object::Mesh(mesh) => {
                    let numbers = bits(Transform::<f64>::FIELDS, field);
                    let by_vertices = ParameterId::new(object, "vertices");
                    let is_flat = scene.meshes[mesh].normals == Normals::Flat;
                    if numbers != 0 && is_flat && !self.ids.contains(&by_vertices) {
                        let len = Transform::<f64>::LEN;
                        add(&mut self.transforms[mesh], &mut self.dense, len, numbers);
                    }
                }
                Object::Shape(shape) => {
                    let kernel = &scene.shapes[shape].kernel;
                    let all = [kernel.fields, Transform::<f64>::FIELDS].concat();
                    let len = all.iter().map(|field| field.len).sum();
                    add(&mut self.shapes[shape], &mut self.dense, len, bits(&all, field));
                }
            }
        }
    }

    /// The parts of the sky, if anything that they follow from is asked for; returns whether it is.
    fn select_sky(&mut self, scene: &Scene, layout: &Layout) -> bool {
        let mut numbers = 0;
        for id in &self.ids {
            let field = match (id.object, id.field) {
                (Object::Environment, "rotation") => "direction",
                (Object::Environment, "radiance") => "color",
                (Object::Texture(at), _) if layout.map.is_some_and(|(map, _)| map == at) => "color",
                _ => continue,
            };
            numbers |= bits(DistantLight::<f64>::FIELDS, field);
        }
        let parts = &mut self.lights[scene.lights.len()..];
        if numbers == 0 || parts.is_empty() {
            return false;
        }
        for part in parts {
            add(part, &mut self.dense, DistantLight::<f64>::LEN, numbers);
        }
        true
    }

    /// The numbers of a light that are asked for; none of lights that stand for surfaces.
    pub fn light(&self, object: usize) -> Option<Dense> {
        *self.lights.get(object)?
    }

    /// Returns `true` if the points that camera rays meet depend on a requested parameter.
    pub fn moves_points(&self) -> bool {
        let turns = bits(Sphere::<f64>::FIELDS, "rotation");
        self.camera
            || !self.vertices.is_empty()
            || self.sphere_numbers & !turns != 0
            || self.transforms.iter().chain(&self.shapes).any(Option::is_some)
    }

    /// Returns `true` if the derivative of radiance may grow without bound towards silhouettes: that of points that
    /// move, and that by a light that a surface is grazed by where the viewer grazes it, as by one at the camera.
    pub fn is_steep_at_silhouettes(&self) -> bool {
        self.moves_points() || self.moves_grazing_lights
    }

    /// Returns `true` if surface points, with their normals and texture coordinates, or the rays that go on from them,
    /// depend on a requested parameter.
    pub fn moves_surfaces(&self) -> bool {
        let selected = [&self.spheres, &self.normals, &self.uvs];
        self.moves_points()
            || selected.iter().any(|selection| !selection.is_empty())
            || self.bends_normals
            || self.refracts
    }

    /// Returns `true` if something of the environment may be requested: its numbers, or texels, of which it may
    /// have some.
    pub fn has_environment(&self) -> bool {
        self.environment.is_some() || !self.texels.is_empty()
    }

    /// Returns `true` if the boundary term is requested. Where light takes all paths there is none unless edges
    /// move: images are the same with edges and without.
    pub fn has_edges(&self, edges: Edges) -> bool {
        let counts = self.moves_edges || !self.takes_all_paths;
        counts && edges.given(self.moves_edges) == Edges::On
    }

    /// Returns `true` if the transform of a mesh is requested whose vertices are not.
    pub fn moves_transforms(&self) -> bool {
        self.transforms.iter().any(Option::is_some)
    }

    /// Returns `true` if an opacity is requested.
    pub fn has_opacities(&self) -> bool {
        self.material_numbers & bits(Material::<f64>::FIELDS, "opacity") != 0
    }

    /// Returns `true` if only vertices are requested, not all of the scene, which move their triangles alone.
    pub fn is_few_vertices(&self) -> bool {
        let is_vertices =
            |id: &ParameterId| matches!(id.object, Object::Mesh(_)) && id.field == "vertices";
        self.ids.iter().all(is_vertices) && !self.vertices.is_whole() && self.normals.is_empty()
    }
}

/// The names of the fields of a struct, and the number of its numbers.
fn fields_of<T: Fields<f64>>(_: &T) -> (&'static [ad::Field], usize) {
    (T::FIELDS, T::LEN)
}

/// Whether a parameter is one of a transform.
pub fn is_of_transform(id: &ParameterId) -> bool {
    range_of(Transform::<f64>::FIELDS, id.field).is_some()
}

/// A bit for each number of a field.
pub fn bits(fields: &[ad::Field], name: &str) -> Bits {
    range_of(fields, name).map_or(0, |range| range.fold(0, |bits, index| bits | 1 << index))
}

/// Asks for numbers of an object that has `len`.
fn add(of: &mut Option<Dense>, dense: &mut usize, len: usize, numbers: Bits) {
    let requested = of.get_or_insert_with(|| {
        let start = *dense;
        *dense += len;
        Dense { start, numbers: 0 }
    });
    requested.numbers |= numbers;
}
