//! The numbers of a scene at the scalar of a pass.

use ad::vector::{Vector, Vector3};
use ad::{Fields, Real, Tangent, Vec3};
use glam::DVec3;

use super::placed::PlacedMesh;
use super::shining::ShiningInputs;
use super::sky_lights::sky_lights;
use super::texels::TexelInputs;
use super::varying::{Varying, lifted, lifted_vector, narrow_vector};
use crate::custom::{EmitterKernel, ShapeKernel};
use crate::number::{Number, splat_vector};
use crate::scene::{LightSource, Mesh, Object, Scene, ShapeObject, Transform};
use crate::settings::Pass;
use crate::trace::layout::{Kind, Layout};
use crate::transport::area_light::Place;
use crate::transport::camera::{CameraFrame, Ray, camera_frame};
use crate::transport::environment::Environment;
use crate::transport::hit::Primitive;
use crate::transport::illumination::Illumination;
use crate::transport::light::{Light, illuminate, match_light};
use crate::transport::material::Material;
use crate::transport::sphere::Sphere;
use crate::transport::surface::SurfacePoint;
use crate::transport::texture::Uv;
use crate::transport::triangle::Triangle;

/// A light as surfaces are shaded by it.
pub enum LightInputs<S: Number> {
    Known {
        light: Light<S>,
        /// The point of it.
        place: Place<S>,
    },
    /// A point of a surface.
    Shining(ShiningInputs<S>),
    /// Of one's own: the numbers of all its fields.
    Custom { kernel: EmitterKernel, numbers: Vec<S::Lane>, origin: Vec3<S> },
}

impl<S: Number> LightInputs<S> {
    /// The illumination of a point, if nothing is between them.
    #[inline]
    pub fn illuminate(&self, point: Vec3<S>) -> Illumination<S> {
        match self {
            Self::Known { light, place } => illuminate::<S>(*light, *place, point),
            Self::Shining(shining) => shining.illuminate(point),
            Self::Custom { kernel, numbers, origin } => {
                kernel.at::<S>().illuminate(numbers, point + *origin)
            }
        }
    }

    /// The pullback of [`illuminate`](Self::illuminate) for all but surfaces: returns the cotangent of the
    /// point; those of the numbers of the light go to `to_number`.
    #[inline]
    pub fn pull_illuminate(
        &self,
        point: Vec3<S>,
        cotangent: Tangent<Illumination<S>>,
        mut to_number: impl FnMut(usize, S),
    ) -> Vec3<S> {
        match self {
            Self::Known { light, place } => {
                let (_, pullback) = illuminate::vjp::<S>(*light, *place, point);
                let (cotangent, _, point) = &pullback(cotangent);
                match_light!(light, _light, cotangent, part => part.visit(&mut to_number));
                *point
            }
            Self::Shining(shining) => shining.pull_illuminate(point, cotangent).1,
            Self::Custom { kernel, numbers, origin } => {
                let point = point + *origin;
                kernel.at::<S>().pull_illuminate(numbers, point, cotangent, &mut to_number)
            }
        }
    }
}

/// A custom shape.
#[derive(Clone, PartialEq)]
pub struct ShapeInputs<S: Number> {
    pub kernel: ShapeKernel,
    /// The numbers of all its fields.
    pub numbers: Vec<S::Lane>,
    /// Relative to the origin of the inputs.
    pub transform: Transform<S>,
}

impl<S: Number> ShapeInputs<S> {
    /// The surface point where a ray meets the shape.
    pub fn point(&self, ray: Ray<S>) -> SurfacePoint<S> {
        self.kernel.at::<S>().point(&self.numbers, self.transform, ray)
    }

    /// The pullback of [`point`](Self::point); the cotangents of the numbers go to `to_number`.
    pub fn pull_point(
        &self,
        ray: Ray<S>,
        cotangent: Tangent<SurfacePoint<S>>,
        to_number: &mut dyn FnMut(usize, S),
    ) -> (Tangent<Transform<S>>, Tangent<Ray<S>>) {
        let kernel = self.kernel.at::<S>();
        kernel.pull_point(&self.numbers, self.transform, ray, cotangent, to_number)
    }

    /// The pullback of the margin of the shape, which vanishes at its silhouette.
    pub fn pull_margin(
        &self,
        ray: Ray<S>,
        cotangent: S,
        to_number: &mut dyn FnMut(usize, S),
    ) -> (Tangent<Transform<S>>, Tangent<Ray<S>>) {
        let kernel = self.kernel.at::<S>();
        kernel.pull_margin(&self.numbers, self.transform, ray, cotangent, to_number)
    }
}

/// The numbers of a scene.
///
/// Positions are relative to the middle of the scene as it was when it was prepared, the `origin`, so
/// that a scene far from zero keeps its precision. Differences of positions, and with them gradients,
/// are not affected.
pub struct Inputs<S: Number> {
    pub origin: DVec3,
    pub frame: CameraFrame<S>,
    /// Where light takes all paths.
    pub environment: Option<Environment<S>>,
    pub lights: Vec<LightInputs<S>>,
    pub materials: Vec<Material<S::Lane>>,
    pub spheres: Vec<Sphere<S::Lane>>,
    /// The vertices of all meshes in the world, one mesh after the other.
    pub vertices: Vec<Vec3<S::Lane>>,
    /// The unit normals, or zeros, of the meshes that are shaded with any, one mesh after the other.
    pub normals: Vec<Vec3<S::Lane>>,
    /// The texture coordinates of all meshes, one mesh after the other; empty if the scene has no
    /// textures.
    pub uvs: Vec<Uv<S::Lane>>,
    /// The texels of each texture.
    pub texels: Vec<TexelInputs<S::Lane>>,
    pub shapes: Vec<ShapeInputs<S>>,
}

impl<S: Number> Inputs<S> {
    /// The inputs of a scene, some numbers of which vary.
    pub fn new(scene: &Scene, layout: &Layout, origin: DVec3, varying: &Varying<S::Wide>) -> Self {
        let mut inputs = Self {
            origin,
            frame: CameraFrame::from_fn(&mut |_| S::ZERO),
            environment: None,
            lights: Vec::new(),
            materials: Vec::new(),
            spheres: Vec::new(),
            vertices: Vec::new(),
            normals: Vec::new(),
            uvs: Vec::new(),
            texels: Vec::new(),
            shapes: Vec::new(),
        };
        inputs.update(scene, layout, varying);
        inputs
    }

    /// Takes over the numbers of the scene, whose objects are those that the inputs were made of;
    /// returns whether geometry has moved.
    pub fn update(&mut self, scene: &Scene, layout: &Layout, varying: &Varying<S::Wide>) -> bool {
        let origin = lifted_vector::<S>(self.origin);
        self.look(scene, varying);
        self.environment = scene
            .environment
            .filter(|_| layout.path_tracing.is_some())
            .map(|sky| in_lanes::<S, _>(&varying.lift(Object::Environment, &sky.values)));
        self.lights = lights(scene, layout, origin, varying);
        self.materials.clear();
        self.materials.extend(scene.materials.iter().enumerate().map(|(index, material)| {
            narrow::<S, _>(&varying.lift(Object::Material(index), &material.values))
        }));
        self.update_textures(scene, layout, varying);
        let vertices = self.update_meshes(scene, origin, varying);
        let spheres = self.update_spheres(scene, origin, varying);
        let shapes = shapes(scene, origin, varying);
        let shapes_moved = self.shapes != shapes;
        self.shapes = shapes;
        let shining: Vec<_> = self.shining::<S>(layout, |number| number).collect();
        self.lights.extend(shining.into_iter().map(LightInputs::Shining));
        vertices | spheres | shapes_moved
    }

    /// The points of surfaces that shine which a layout has chosen, in the numbers `T`.
    pub fn shining<'a, T: Number>(
        &'a self,
        layout: &'a Layout,
        to: impl Fn(S::Lane) -> T::Lane + Copy + 'a,
    ) -> impl Iterator<Item = ShiningInputs<T>> + 'a {
        let number = move |number| T::splat(to(number));
        let vector =
            move |v: Vec3<S::Lane>| <Vec3<T>>::new(number(v.x()), number(v.y()), number(v.z()));
        layout.shining.iter().map(move |point| {
            let primitive = match layout.kind_of(point.primitive as usize) {
                (Kind::Sphere, index) => Primitive::Sphere(self.spheres[index].map(number)),
                (_, index) => {
                    let corner = |vertex: u32| vector(self.vertices[vertex as usize]);
                    let [a, b, c] = layout.triangles[index].map(corner);
                    Primitive::Triangle(Triangle { a, b, c })
                }
            };
            let material = layout.material_of[point.primitive as usize];
            let emission = vector(self.materials[material as usize].emission);
            let seen = self.seen_part(layout, point.primitive as usize, point.at);
            let [r, g, b] = seen.to_array().map(T::from_f64);
            let seen = <Vec3<T>>::new(r, g, b);
            ShiningInputs::new(point, primitive, emission * seen)
        })
    }

    /// The origin of all positions, in the world.
    pub fn world_origin(&self) -> Vec3<S> {
        splat_vector::<S>(narrow_vector::<S>(lifted_vector::<S>(self.origin)))
    }

    /// Takes over what the scene is seen through.
    pub fn look(&mut self, scene: &Scene, varying: &Varying<S::Wide>) {
        let frame = frame::<S>(scene, lifted_vector::<S>(self.origin), varying);
        self.frame = in_lanes::<S, _>(&frame);
    }

    fn update_textures(&mut self, scene: &Scene, layout: &Layout, varying: &Varying<S::Wide>) {
        self.texels.clear();
        self.uvs.clear();
        for (index, texture) in scene.textures.iter().enumerate() {
            let varying = varying.block(Object::Texture(index), "texels");
            self.texels.push(match (varying, texture.texels.shared()) {
                (Some(block), _) => {
                    TexelInputs::Own(block.as_chunks().0.iter().map(vector::<S>).collect())
                }
                (None, Some(shared)) => TexelInputs::Shared(shared.clone()),
                (None, None) => {
                    let texels = texture.texels.iter();
                    TexelInputs::Own(
                        texels.map(|texel| vector::<S>(&lifted::<S, 3>(&texel))).collect(),
                    )
                }
            });
        }
        if layout.uvs.is_empty() {
            return;
        }
        for (index, mesh) in scene.meshes.iter().enumerate() {
            let uv = |&[u, v]: &[S::Wide; 2]| Uv { u: S::narrow(u), v: S::narrow(v) };
            match varying.block(Object::Mesh(index), "texture_coordinates") {
                Some(block) => self.uvs.extend(block.as_chunks().0.iter().map(uv)),
                None => {
                    let coordinates = mesh.texture_coordinates.iter();
                    self.uvs.extend(coordinates.map(|given| uv(&lifted::<S, 2>(given))));
                }
            }
        }
    }

    fn update_meshes(
        &mut self,
        scene: &Scene,
        origin: Vec3<S::Wide>,
        varying: &Varying<S::Wide>,
    ) -> bool {
        let count = scene.meshes.iter().map(|mesh| mesh.vertices.len()).sum();
        let is_new = self.vertices.len() != count;
        let mut moved = is_new;
        let zero = Vec3::<S::Lane>::splat(Real::ZERO);
        self.vertices.resize(count, zero);
        self.normals.resize(scene.meshes.iter().map(Mesh::normal_count).sum(), zero);
        let (mut vertices, mut normals) = (&mut self.vertices[..], &mut self.normals[..]);
        for (index, mesh) in scene.meshes.iter().enumerate() {
            let (of_mesh, others) = vertices.split_at_mut(mesh.vertices.len());
            vertices = others;
            let placed = PlacedMesh::<S>::new(index, mesh, varying);
            let has_moved = placed.replace_vertices(origin, of_mesh);
            moved |= has_moved;
            let (of_mesh, others) = normals.split_at_mut(mesh.normal_count());
            normals = others;
            placed.replace_normals(is_new || has_moved, of_mesh);
        }
        moved
    }

    fn update_spheres(
        &mut self,
        scene: &Scene,
        origin: Vec3<S::Wide>,
        varying: &Varying<S::Wide>,
    ) -> bool {
        let spheres = scene.spheres.iter().enumerate().map(|(index, sphere)| {
            let mut sphere = varying.lift(Object::Sphere(index), &sphere.values);
            sphere.center = sphere.center - origin;
            narrow::<S, _>(&sphere)
        });
        let spheres: Vec<Sphere<S::Lane>> = spheres.collect();
        let moved = self.spheres != spheres;
        self.spheres = spheres;
        moved
    }
}

/// The frame of the camera, relative to an origin.
pub fn frame<S: Number>(
    scene: &Scene,
    origin: Vec3<S::Wide>,
    varying: &Varying<S::Wide>,
) -> CameraFrame<S::Wide> {
    let mut camera = varying.lift(scene.eye(), scene.seen_from());
    camera.look_from = camera.look_from - origin;
    camera.look_at = camera.look_at - origin;
    camera_frame::<S::Wide>(camera, S::Wide::from_f64(scene.aspect()))
}

/// The lights that surfaces are shaded by: the index of each in the scene, and the point of it.
pub fn places(scene: &Scene) -> impl Iterator<Item = (usize, Place<f64>)> {
    let count = scene.light_samples;
    scene.lights.iter().enumerate().flat_map(move |(index, light)| {
        light.source.places(count).into_iter().map(move |place| (index, place))
    })
}

/// The lights, relative to an origin, and the parts of the sky; none where radiance is not what is shown.
pub fn lights<S: Number>(
    scene: &Scene,
    layout: &Layout,
    origin: Vec3<S::Wide>,
    varying: &Varying<S::Wide>,
) -> Vec<LightInputs<S>> {
    let inputs = |(index, place): (usize, Place<f64>)| {
        let object = Object::Light(index);
        match &scene.lights[index].source {
            LightSource::Known(light) => {
                let light = match_light!(light, light => Variant(varying.lift(object, light)));
                let light = light.relative_to(origin);
                let light = match_light!(light, light => Variant(in_lanes::<S, _>(&light)));
                LightInputs::Known { light, place: place.map(S::from_f64) }
            }
            LightSource::Custom { kernel, numbers } => LightInputs::Custom {
                kernel: kernel.clone(),
                numbers: narrow_all::<S>(&varying.lift_custom(object, kernel.fields, numbers)),
                origin: splat_vector::<S>(narrow_vector::<S>(origin)),
            },
        }
    };
    match layout.pass {
        Pass::Radiance => {
            let of_sky = sky_lights::<S>(scene, layout, varying).into_iter().map(|light| {
                let light = Light::Distant(in_lanes::<S, _>(&light));
                LightInputs::Known { light, place: Place::POINT.map(S::from_f64) }
            });
            places(scene).map(inputs).chain(of_sky).collect()
        }
        _ => Vec::new(),
    }
}

/// The custom shapes, relative to an origin.
pub fn shapes<S: Number>(
    scene: &Scene,
    origin: Vec3<S::Wide>,
    varying: &Varying<S::Wide>,
) -> Vec<ShapeInputs<S>> {
    let inputs = |(index, shape): (usize, &ShapeObject)| {
        let (object, kernel) = (Object::Shape(index), &shape.kernel);
        let mut transform = varying.lift(object, &shape.transform);
        transform.translation = transform.translation - origin;
        let numbers = varying.lift_custom(object, kernel.fields, &shape.numbers);
        ShapeInputs {
            kernel: kernel.clone(),
            numbers: narrow_all::<S>(&numbers),
            transform: in_lanes::<S, _>(&transform),
        }
    };
    scene.shapes.iter().enumerate().map(inputs).collect()
}

#[inline]
fn vector<S: Number>(&[x, y, z]: &[S::Wide; 3]) -> Vec3<S::Lane> {
    narrow_vector::<S>(Vector3::new(x, y, z))
}

/// A struct in the precision of a pass.
fn narrow<S: Number, T: Fields<S::Wide>>(value: &T) -> T::With<S::Lane> {
    value.map(S::narrow)
}

fn narrow_all<S: Number>(values: &[S::Wide]) -> Vec<S::Lane> {
    values.iter().map(|&value| S::narrow(value)).collect()
}

/// A struct in the precision of a pass, the same in every lane.
fn in_lanes<S: Number, T: Fields<S::Wide>>(value: &T) -> T::With<S> {
    value.map(|number| S::splat(S::narrow(number)))
}
