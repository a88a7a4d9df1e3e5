//! A scene in the form that is rendered.

use std::iter;
use std::ops::Range;

use ad::lanes::Lanes;
use ad::{Real, Scalar, Vec3};
use glam::DVec3;
use rayon::prelude::*;

use super::raster::Raster;
use super::sampling::Sampling;
use super::settings::{Pass, RenderSettings, Visibility};
use super::textures::Texture;
use super::tiles::Tile;
use super::view::film_offsets;
use crate::acceleration::{Acceleration, PacketHits, PacketVectors, Shape, Shapes};
use crate::kernels::camera::{Frame, frame};
use crate::kernels::light::PointLight;
use crate::kernels::material::Material;
use crate::kernels::sphere::Sphere;
use crate::kernels::texture::Uv;
use crate::precision::{narrow, widen};
use crate::scene::{Light, Parameters, Scene, TextureObject};

/// A scene in the precision of the kernels, with its acceleration structure.
///
/// Positions are held relative to the middle of the scene as it was when it was prepared, so that
/// a scene far from the origin keeps its precision. Differences of positions, and with them
/// gradients, are not affected.
pub struct Prepared<'a, L: Lanes> {
    pub(super) scene: &'a Scene,
    pub(super) parameters: Parameters,
    pub(super) middle: DVec3,
    pub(super) pinhole: DVec3,
    pub(super) frame: Frame<L>,
    pub(super) lights: Vec<Light<f64>>,
    /// The lights as surfaces are shaded by them.
    pub(super) shining: Vec<Light<L>>,
    pub(super) materials: Vec<Material<L::Element>>,
    /// Whether any of them reflects like a mirror.
    pub(super) has_mirrors: bool,
    /// Those of transparent materials.
    pub(super) opacities: Vec<L::Element>,
    /// Whether any material is transparent. Colours alone are seen as if none were.
    pub(super) has_transparency: bool,
    /// Whether a texture varies the opacity of any of these.
    pub(super) has_varied_opacity: bool,
    pub(super) spheres: Vec<Sphere<L::Element>>,
    /// The vertices of all meshes, one mesh after the other.
    pub(super) vertices: Vec<Vec3<L::Element>>,
    /// The first vertex of each mesh.
    first_vertices: Vec<u32>,
    /// The triangles of all meshes, by index into `vertices`.
    pub(super) triangles: Vec<[u32; 3]>,
    /// The material of each primitive: of the triangles, then of the spheres.
    pub(super) material_of: Vec<u32>,
    pub(super) textures: Vec<Texture>,
    /// The texels of all textures, one texture after the other.
    pub(super) texels: Vec<Vec3<L::Element>>,
    /// The texture coordinates of all meshes, one mesh after the other.
    pub(super) uvs: Vec<Uv<L::Element>>,
    /// The first texture coordinates of each mesh.
    first_uvs: Vec<u32>,
    /// The texture coordinates of all triangles, by index into `uvs`; empty if the scene has no
    /// textures.
    pub(super) uv_triangles: Vec<Option<[u32; 3]>>,
    pub(super) film_offsets: Vec<(L, L)>,
    pub(super) acceleration: Acceleration,
    pub(super) pass: Pass,
    pub(super) sampling: Sampling,
    /// How many mirrors and transparent surfaces light meets at most.
    pub(super) bounces: u32,
    /// Whether, and from where, primitives are drawn instead of being found by rays.
    raster: Option<Raster>,
}

impl<'a, L: Lanes> Prepared<'a, L> {
    /// Prepares a scene. The scene has to be valid (see [`Scene::validate`]).
    pub fn new(scene: &'a Scene) -> Self {
        Self::with_settings(scene, RenderSettings::default())
    }

    /// Prepares a scene to be rendered in a certain way.
    pub fn with_settings(scene: &'a Scene, settings: RenderSettings) -> Self {
        let bounding_box = scene.bounding_box();
        let middle = bounding_box.map_or(DVec3::ZERO, |(low, high)| low.midpoint(high));
        let mut triangles = Vec::new();
        let mut material_of = Vec::new();
        let mut first_vertices = Vec::new();
        let mut first_vertex = 0;
        for (mesh, vertices) in scene.meshes.iter().zip(&scene.parameters.vertices) {
            triangles.extend(mesh.triangles.iter().map(|t| t.map(|v| v + first_vertex)));
            material_of.extend(&mesh.materials);
            first_vertices.push(first_vertex);
            first_vertex += vertices.len() as u32;
        }
        material_of.extend(scene.spheres.iter().map(|sphere| sphere.material));
        material_of.extend(scene.shapes.iter().map(|shape| shape.material));
        let (first_uvs, uv_triangles) = texture_triangles(scene);
        let has_transparency =
            settings.pass == Pass::Radiance && !scene.parameters.opacities.is_empty();

        let mut prepared = Self {
            scene,
            parameters: scene.parameters.clone(),
            middle,
            pinhole: DVec3::ZERO,
            frame: Frame::zero().narrow(),
            lights: Vec::new(),
            shining: Vec::new(),
            materials: Vec::new(),
            has_mirrors: false,
            opacities: Vec::new(),
            has_transparency,
            has_varied_opacity: has_transparency
                && scene.materials.iter().any(|material| material.textures.opacity.is_some()),
            spheres: Vec::new(),
            vertices: Vec::new(),
            first_vertices,
            triangles,
            material_of,
            textures: textures(scene),
            texels: Vec::new(),
            uvs: Vec::new(),
            first_uvs,
            uv_triangles,
            film_offsets: film_offsets(),
            acceleration: match settings.visibility {
                Visibility::List => Acceleration::list(&[][..]),
                Visibility::Tree | Visibility::Raster => {
                    Acceleration::with_effort(&[][..], settings.effort)
                }
            },
            pass: settings.pass,
            sampling: settings.sampling,
            bounces: settings.bounces.unwrap_or(scene.bounces),
            raster: None,
        };
        prepared.load_appearance();
        prepared.load_texels();
        prepared.load_texture_coordinates();
        prepared.load_geometry();
        if settings.visibility == Visibility::Raster {
            prepared.raster = Some(prepared.rasterize());
        }
        prepared
    }

    /// Moves to other values of the parameters. If geometry moved, the tree is fitted to
    /// it.
    ///
    /// # Panics
    ///
    /// If `parameters` has another shape than the scene's.
    pub fn set_parameters(&mut self, parameters: &Parameters) {
        let old = &self.parameters;
        let moved = old.vertices != parameters.vertices || old.spheres != parameters.spheres;
        let repainted = old.textures != parameters.textures;
        let remapped = old.texture_coordinates != parameters.texture_coordinates;
        self.parameters.clone_from(parameters);
        self.load_appearance();
        if repainted {
            self.load_texels();
        }
        if remapped {
            self.load_texture_coordinates();
        }
        if moved {
            self.load_geometry();
        }
        if self.raster.is_some() {
            self.raster = Some(self.rasterize());
        }
    }

    /// Changes how many mirrors and transparent surfaces light meets at most.
    #[cfg(feature = "files")]
    pub(crate) fn set_bounces(&mut self, bounces: u32) {
        self.bounces = bounces;
    }

    /// Changes the rays through pixels.
    #[cfg(feature = "files")]
    pub(crate) fn set_sampling(&mut self, sampling: Sampling) {
        self.sampling = sampling;
    }

    /// Finds what the wanted rays of a tile meet first.
    #[inline]
    pub(super) fn nearest_into(
        &self,
        tile: &Tile,
        directions: &PacketVectors,
        wanted: u64,
        hits: &mut PacketHits,
    ) {
        let origin = self.pinhole.as_vec3();
        match &self.raster {
            None => self.acceleration.nearest_packet_into(origin, directions, wanted, hits),
            Some(raster) => {
                raster.nearest_into(&self.geometry(), tile, origin, directions, wanted, hits);
            }
        }
        self.nearer_custom_shapes(origin, directions, wanted, hits);
    }

    fn rasterize(&self) -> Raster {
        let Scene { width, height, .. } = *self.scene;
        Raster::new(&self.geometry(), &self.exact_frame(), width, height)
    }

    fn geometry(&self) -> Geometry<'_, L::Element> {
        let Self { vertices, triangles, spheres, .. } = self;
        Geometry { vertices, triangles, spheres }
    }

    /// The frame of the camera, relative to the middle of the scene.
    fn exact_frame(&self) -> Frame<f64> {
        let mut camera = self.parameters.camera;
        camera.look_from -= self.middle;
        camera.look_at -= self.middle;
        frame::<f64>(camera, self.aspect())
    }

    /// The width divided by the height of the image.
    pub(super) fn aspect(&self) -> f64 {
        f64::from(self.scene.width) / f64::from(self.scene.height)
    }

    fn load_appearance(&mut self) {
        let frame = self.exact_frame();
        self.pinhole = frame.origin;
        self.frame = frame.narrow();
        let lights = match self.pass {
            Pass::Radiance => &self.parameters.lights[..],
            Pass::Albedo => &[],
        };
        self.lights = lights
            .iter()
            .map(|light| match light {
                Light::Point(light) => {
                    let position = light.position - self.middle;
                    Light::Point(PointLight { position, ..*light })
                }
                Light::Distant(light) => Light::Distant(*light),
            })
            .collect();
        self.shining = self.lights.iter().map(Light::narrow).collect();
        self.materials = self.parameters.materials.iter().map(Material::narrow).collect();
        self.opacities.clear();
        self.opacities.extend(self.parameters.opacities.iter().map(|&x| L::Element::from_f64(x)));
        self.has_mirrors = self.pass == Pass::Radiance
            && (0..self.materials.len()).any(|material| self.is_mirror(material));
    }

    fn load_texels(&mut self) {
        self.texels.clear();
        for texels in &self.parameters.textures {
            let texels = texels.par_iter().map(|&texel| narrow::<L::Element>(texel.into()));
            self.texels.par_extend(texels);
        }
    }

    fn load_texture_coordinates(&mut self) {
        let coordinates = self.parameters.texture_coordinates.iter().flatten();
        self.uvs.clear();
        self.uvs.extend(coordinates.map(|&[u, v]| Uv { u, v }.narrow()));
    }

    fn load_geometry(&mut self) {
        let middle = self.middle;
        self.vertices.clear();
        for vertices in &self.parameters.vertices {
            let relative =
                vertices.par_iter().map(|&v| narrow::<L::Element>(DVec3::from(v) - middle));
            self.vertices.par_extend(relative);
        }
        let spheres = self.parameters.spheres.iter();
        self.spheres = spheres
            .map(|sphere| Sphere { center: sphere.center - middle, ..*sphere }.narrow())
            .collect();
        let Self { vertices, triangles, spheres, .. } = self;
        self.acceleration.update(&Geometry { vertices, triangles, spheres });
    }

    /// The mesh of a vertex, and its index there.
    pub(super) fn vertex_of_mesh(&self, vertex: u32) -> (usize, usize) {
        part_and_index(vertex, &self.first_vertices, |&first| first)
    }

    /// The vertices of a mesh, by index through all meshes.
    pub(super) fn vertices_of_mesh(&self, mesh: usize) -> Range<usize> {
        let first = |mesh: usize| self.first_vertices.get(mesh).map(|&first| first as usize);
        let end = first(mesh + 1).unwrap_or(self.vertices.len());
        first(mesh).unwrap_or(end)..end
    }

    /// The mesh of texture coordinates, and their index there.
    pub(super) fn uv_of_mesh(&self, uv: u32) -> (usize, usize) {
        part_and_index(uv, &self.first_uvs, |&first| first)
    }

    /// The texture of a texel, and its index there.
    pub(super) fn texel_of_texture(&self, texel: u32) -> (usize, usize) {
        part_and_index(texel, &self.textures, |texture| texture.first_texel as u32)
    }

    /// The index of a sphere among the spheres.
    pub(super) fn sphere_of(&self, primitive: usize) -> usize {
        primitive - self.triangles.len()
    }
}

/// Which part of a list an index is in, and its index there, by the first index of each part.
fn part_and_index<T>(index: u32, parts: &[T], first: impl Fn(&T) -> u32) -> (usize, usize) {
    // The last of those that begin no later: parts without members begin where the next one does.
    let part = parts.partition_point(|part| first(part) <= index) - 1;
    (part, (index - first(&parts[part])) as usize)
}

/// Where the texels of each texture are, among those of all.
fn textures(scene: &Scene) -> Vec<Texture> {
    let mut first_texel = 0;
    let texture = |texture: &TextureObject| {
        let &TextureObject { width, height, wrap, .. } = texture;
        let placed = Texture { first_texel, width, height, wrap };
        first_texel += width as usize * height as usize;
        placed
    };
    scene.textures.iter().map(texture).collect()
}

/// The first texture coordinates of each mesh among those of all, and the texture coordinates of all
/// triangles.
fn texture_triangles(scene: &Scene) -> (Vec<u32>, Vec<Option<[u32; 3]>>) {
    let (mut firsts, mut triangles, mut first) = (Vec::new(), Vec::new(), 0);
    if scene.textures.is_empty() {
        return (firsts, triangles);
    }
    for (mesh, coordinates) in scene.meshes.iter().zip(&scene.parameters.texture_coordinates) {
        let moved = |corners: &Option<[u32; 3]>| corners.map(|c| c.map(|corner| corner + first));
        triangles.extend(mesh.texture_triangles.iter().map(moved));
        let bare = mesh.triangles.len() - mesh.texture_triangles.len();
        triangles.extend(iter::repeat_n(None, bare));
        firsts.push(first);
        first += coordinates.len() as u32;
    }
    (firsts, triangles)
}

/// The primitives as traversal takes them: the triangles, then the spheres.
struct Geometry<'a, S: Scalar> {
    vertices: &'a [Vec3<S>],
    triangles: &'a [[u32; 3]],
    spheres: &'a [Sphere<S>],
}

impl<S: Scalar> Shapes for Geometry<'_, S> {
    fn count(&self) -> usize {
        self.triangles.len() + self.spheres.len()
    }

    #[inline]
    fn shape(&self, index: u32) -> Shape {
        let index = index as usize;
        match self.triangles.get(index) {
            Some(corners) => {
                let corner = |vertex: u32| widen::<S>(self.vertices[vertex as usize]).as_vec3();
                Shape::Triangle(corners.map(corner))
            }
            None => {
                let Sphere { center, radius } = self.spheres[index - self.triangles.len()];
                Shape::Sphere(widen::<S>(center).as_vec3(), radius.to_f64() as f32)
            }
        }
    }
}
