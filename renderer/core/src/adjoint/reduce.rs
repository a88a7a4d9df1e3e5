//! The sums of all strips, as derivatives by parameters.

use ad::{Additive, Fields, Tangent};
use glam::DVec3;

use super::gradient::{Gradient, LossAndGradient};
use super::request::{Request, is_of_transform};
use super::scatter::{Sparse, Sums};
use super::sky::pull_sky;
use super::smooth::pull_normals;
use crate::number::Plain;
use crate::primal::integrator::Prepared;
use crate::scene::numbers::range_of;
use crate::scene::{
    Environment, Material, Mesh, Normals, Object, ParameterId, Scene, Sphere, Transform,
};
use crate::transport::camera::{Camera, CameraFrame, camera_frame};
use crate::transport::smooth::place_normal;
use crate::transport::transform::place;

/// The cotangents of what a scene has one of.
struct Around {
    camera: Tangent<Camera<f64>>,
    environment: Tangent<Environment<f64>>,
}

/// The sums of all strips, by slot.
pub(super) struct Totals {
    loss: f64,
    frame: Option<Tangent<CameraFrame<f64>>>,
    dense: Vec<f64>,
    materials: Vec<[f64; <Material<f64> as Fields<f64>>::LEN]>,
    spheres: Vec<[f64; <Sphere<f64> as Fields<f64>>::LEN]>,
    vertices: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    uvs: Vec<[f64; 2]>,
    texels: Vec<[f64; 3]>,
    /// By mesh: the cotangent of its transform, where that follows from its vertices and normals.
    transforms: Vec<Option<Tangent<Transform<f64>>>>,
}

impl Totals {
    pub fn zero(request: &Request) -> Self {
        Self {
            loss: 0.0,
            frame: None,
            dense: vec![0.0; request.dense],
            materials: vec![[0.0; _]; request.materials.count()],
            spheres: vec![[0.0; _]; request.spheres.count()],
            vertices: vec![[0.0; 3]; request.vertices.count()],
            normals: vec![[0.0; 3]; request.normals.count()],
            uvs: vec![[0.0; 2]; request.uvs.count()],
            texels: vec![[0.0; 3]; request.texels.count()],
            transforms: vec![None; request.transforms.len()],
        }
    }

    /// Puts strips together, always in the same order.
    pub fn add_all(&mut self, strips: impl IntoIterator<Item = Sums>) {
        strips.into_iter().for_each(|strip| self.add(strip));
    }

    fn add(&mut self, strip: Sums) {
        fn add<const N: usize>(totals: &mut [[f64; N]], sums: Sparse<N>) {
            for (slot, sum) in sums {
                let total = totals[slot as usize].iter_mut();
                total.zip(sum).for_each(|(total, sum)| *total += sum);
            }
        }
        self.loss += strip.loss;
        if let Some(frame) = strip.frame {
            self.frame.get_or_insert_with(Additive::zero).accumulate(frame);
        }
        self.dense.iter_mut().zip(strip.dense).for_each(|(total, sum)| *total += sum);
        add(&mut self.materials, strip.materials);
        add(&mut self.spheres, strip.spheres);
        add(&mut self.vertices, strip.vertices);
        add(&mut self.normals, strip.normals);
        add(&mut self.uvs, strip.uvs);
        add(&mut self.texels, strip.texels);
    }

    /// The gradient by what is requested, from the cotangents of all that it takes.
    pub fn reduce<L: Plain>(
        mut self,
        prepared: &Prepared<L>,
        scene: &Scene,
        request: &Request,
    ) -> LossAndGradient {
        let camera = camera_cotangent(prepared, scene, self.frame.take());
        self.unplace(prepared, scene, request);
        let environment = self.pull_environment(prepared, scene, request);
        let around = Around { camera, environment };
        let block = |&id: &ParameterId| (id, self.block(prepared, scene, request, &around, id));
        let blocks = request.ids.iter().map(block).collect();
        LossAndGradient { loss: self.loss, gradient: Gradient::new(blocks) }
    }

    /// From vertices and normals in the world to those before the transform of their mesh, and to that
    /// transform.
    fn unplace<L: Plain>(&mut self, prepared: &Prepared<L>, scene: &Scene, request: &Request) {
        for (index, mesh) in scene.meshes.iter().enumerate() {
            self.pull_normals(prepared, index, mesh, request);
            let is_requested = request
                .ids
                .iter()
                .any(|id| id.object == Object::Mesh(index) && is_of_transform(id));
            let follows = is_requested && request.transforms[index].is_none();
            if mesh.transform == Transform::IDENTITY && !follows {
                continue;
            }
            let mut to_transform = self.transforms[index].unwrap_or_else(Additive::zero);
            for (vertex, own) in prepared.layout.vertices_of(index).zip(&mesh.vertices) {
                let Some(slot) = request.vertices.slot(vertex) else { continue };
                let world = DVec3::from(self.vertices[slot]);
                let (_, pullback) = place::vjp::<f64>(mesh.transform, DVec3::from(*own));
                let (transform, own) = pullback(world);
                self.vertices[slot] = own.to_array();
                to_transform.accumulate(transform);
            }
            if follows {
                self.transforms[index] = Some(to_transform);
            }
        }
    }

    /// From the normals of a mesh in the world to what they are made of: the vertices in the world, or
    /// given directions and the transform.
    fn pull_normals<L: Plain>(
        &mut self,
        prepared: &Prepared<L>,
        index: usize,
        mesh: &Mesh,
        request: &Request,
    ) {
        let normals = request.normals.slots(prepared.layout.normals.of_mesh(index));
        if normals.is_empty() {
            return;
        }
        let normals = &mut self.normals[normals];
        match &mesh.normals {
            Normals::Flat => {}
            Normals::Smooth => {
                let vertices: Vec<DVec3> = mesh.world_vertices().collect();
                let first = prepared.layout.vertices_of(index).start;
                pull_normals(&vertices, &mesh.triangles, normals, |vertex, cotangent| {
                    if let Some(slot) = request.vertices.slot(first + vertex as usize) {
                        let sum = DVec3::from(self.vertices[slot]) + cotangent;
                        self.vertices[slot] = sum.to_array();
                    }
                });
            }
            Normals::Given { directions, .. } => {
                let mut to_transform = Tangent::<Transform<f64>>::zero();
                for (normal, own) in normals.iter_mut().zip(directions) {
                    let (_, pullback) = place_normal::vjp::<f64>(mesh.transform, (*own).into());
                    let (transform, own): (_, DVec3) = pullback((*normal).into());
                    *normal = own.to_array();
                    to_transform.accumulate(transform);
                }
                self.transforms[index] = Some(to_transform);
            }
        }
    }

    /// The cotangent of the environment: its own sums where light takes all paths, else what its parts bring.
    fn pull_environment<L: Plain>(
        &mut self,
        prepared: &Prepared<L>,
        scene: &Scene,
        request: &Request,
    ) -> Tangent<Environment<f64>> {
        let dense = &self.dense;
        if let Some(to) = request.environment {
            return Fields::from_fn(&mut |index| dense[to.start + index]);
        }
        let (Some(environment), layout) = (scene.environment, &prepared.layout) else {
            return Additive::zero();
        };
        let lights = layout.sky_parts.iter().zip(&request.lights[scene.lights.len()..]);
        let lights = lights.filter_map(|(part, to)| {
            let first = to.as_ref()?.start;
            Some((part, Fields::from_fn(&mut |index| dense[first + index])))
        });
        let (texels, first) = (&mut self.texels, layout.map.map_or(0, |(_, map)| map.first_texel));
        pull_sky(environment, lights, |texel, cotangent| {
            if let Some(slot) = request.texels.slot(first + texel) {
                let sum = DVec3::from(texels[slot]) + cotangent;
                texels[slot] = sum.to_array();
            }
        })
    }

    /// The derivatives by one parameter.
    fn block<L: Plain>(
        &self,
        prepared: &Prepared<L>,
        scene: &Scene,
        request: &Request,
        Around { camera, environment }: &Around,
        id: ParameterId,
    ) -> Vec<f64> {
        let layout = &prepared.layout;
        let fields = scene.all_fields(id.object);
        let range = range_of(&fields, id.field).unwrap_or(0..0);
        let dense = |start: usize| self.dense[start + range.start..][..range.len()].to_vec();
        match id.object {
            // An image is seen through one camera, and the same without the others.
            Object::Camera | Object::View(_) if id.object != scene.eye() => vec![0.0; range.len()],
            Object::Camera | Object::View(_) => range.map(|index| camera.number(index)).collect(),
            Object::Environment => range.map(|index| environment.number(index)).collect(),
            Object::Light(light) => {
                request.lights[light].map_or_else(Vec::new, |to| dense(to.start))
            }
            Object::Shape(shape) => {
                request.shapes[shape].map_or_else(Vec::new, |to| dense(to.start))
            }
            Object::Material(material) => {
                let slot = request.materials.slot(material);
                slot.map_or_else(Vec::new, |slot| self.materials[slot][range].to_vec())
            }
            Object::Sphere(sphere) => {
                let slot = request.spheres.slot(sphere);
                slot.map_or_else(Vec::new, |slot| self.spheres[slot][range].to_vec())
            }
            Object::Texture(texture) => {
                let slots = request.texels.slots(layout.textures[texture].texels());
                self.texels[slots].as_flattened().to_vec()
            }
            Object::Mesh(mesh) => match id.field {
                "vertices" => {
                    let mut vertices = layout.vertices_of(mesh);
                    if let Some(vertex) = id.vertex {
                        vertices = vertices.start + vertex..vertices.start + vertex + 1;
                    }
                    self.vertices[request.vertices.slots(vertices)].as_flattened().to_vec()
                }
                "normals" => {
                    let slots = request.normals.slots(layout.normals.of_mesh(mesh));
                    self.normals[slots].as_flattened().to_vec()
                }
                "texture_coordinates" => {
                    let slots = request.uvs.slots(layout.uvs.of_mesh(mesh));
                    self.uvs[slots].as_flattened().to_vec()
                }
                field => {
                    let range = range_of(Transform::<f64>::FIELDS, field).unwrap_or(0..0);
                    match (&self.transforms[mesh], request.transforms[mesh]) {
                        (Some(transform), _) => range.map(|i| transform.number(i)).collect(),
                        (None, Some(to)) => {
                            self.dense[to.start + range.start..][..range.len()].to_vec()
                        }
                        (None, None) => Vec::new(),
                    }
                }
            },
        }
    }
}

/// The cotangent of the camera, from that of its frame.
fn camera_cotangent<L: Plain>(
    prepared: &Prepared<L>,
    scene: &Scene,
    frame: Option<Tangent<CameraFrame<f64>>>,
) -> Tangent<Camera<f64>> {
    let Some(frame) = frame else { return Additive::zero() };
    let mut camera = *scene.seen_from();
    camera.look_from -= prepared.inputs.origin;
    camera.look_at -= prepared.inputs.origin;
    let (_, pullback) = camera_frame::vjp::<f64>(camera, scene.aspect());
    pullback(frame).0
}
