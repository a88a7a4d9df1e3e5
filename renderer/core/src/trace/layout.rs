//! What of a scene is discrete: sizes, indices, and what its materials can do.

use std::borrow::Cow;
use std::iter;
use std::ops::Range;
use std::sync::OnceLock;

use glam::DVec3;

use super::adjacency::Adjacency;
use super::corners::Corners;
use super::emitters::ShiningPoint;
use super::sampling::{Sampling, hash};
use super::sky::Sky;
use super::sky_parts::{self, SkyPart};
use crate::scene::{MaterialObject, MaterialTextures, Mesh, PathTracing, Scene, Slot, Wrap};
use crate::settings::{Pass, Settings};
use crate::transport::material::{Bsdf, Lobes};

/// The discrete part of a scene, and how it is rendered.
pub struct Layout {
    /// The size of the image in pixels.
    pub width: u32,
    pub height: u32,
    pub pass: Pass,
    /// How paths are chosen, if light takes all.
    pub path_tracing: Option<PathTracing>,
    pub sampling: Sampling,
    /// How many mirrors and transparent surfaces a path has at most.
    pub bounces: u32,
    /// How many surfaces the paths meet at most that direct light stands for, if it stands for all.
    stands_for_depth: Option<u32>,
    /// The triangles of all meshes, by index into the vertices of all meshes.
    pub triangles: Vec<[u32; 3]>,
    /// The number of spheres.
    pub spheres: usize,
    /// The material of each primitive: of the triangles, then of the spheres, then of the shapes.
    pub material_of: Vec<u32>,
    pub lights: Vec<LightTraits>,
    pub materials: Vec<MaterialTraits>,
    /// Whether any material is a mirror.
    pub has_mirrors: bool,
    /// Whether any material is transparent.
    pub has_transparency: bool,
    /// Whether any material has another BSDF than Blinn-Phong's.
    pub has_other_bsdfs: bool,
    /// Whether a texture varies an opacity.
    pub has_opacity_textures: bool,
    /// Whether any material has a normal map.
    pub has_normal_maps: bool,
    pub textures: Vec<TextureLayout>,
    /// The texture of the environment, if it has one, and which it is.
    pub map: Option<(usize, TextureLayout)>,
    /// The cells of the environment, if it has a texture.
    pub sky: Option<Sky>,
    /// The environment as distant lights, which come after those of the scene, where light is direct.
    pub sky_parts: Vec<SkyPart>,
    /// Points of surfaces that shine, which are lights too and come last: where only the edges of light that
    /// takes all paths are looked for.
    pub shining: Vec<ShiningPoint>,
    /// Whether light is direct here although the scene asks for all paths.
    is_direct: bool,
    /// What camera rays bring that meet nothing, where that is not the environment.
    pub background: Option<DVec3>,
    /// The first vertex of each mesh, then the number of all.
    pub first_vertices: Vec<u32>,
    /// Whether the transform of each mesh turns it into its mirror image.
    pub mirrored: Vec<bool>,
    /// The texture coordinates of the triangles; none if the scene has no textures.
    pub uvs: Corners,
    /// The normals of the smooth triangles.
    pub normals: Corners,
    adjacency: OnceLock<Adjacency>,
}

/// What a light can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightTraits {
    /// Which light of the scene it is, or is a point of; then come the parts of the sky, and points of surfaces.
    pub object: usize,
    /// Whether it is known to send nothing.
    pub is_black: bool,
}

/// What a material can do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaterialTraits {
    pub is_mirror: bool,
    pub bsdf: Bsdf,
    pub lobes: Lobes,
    pub is_transparent: bool,
    /// Whether it reflects nothing of what it receives.
    pub is_black: bool,
    /// Whether all of it is metal, which scatters by its facets alone.
    pub is_metal: bool,
    /// The probability with which a path goes on by the mirror, or straight through, and is not scattered.
    pub unscattered: f32,
    pub textures: MaterialTextures,
    pub normal_scale: f64,
}

impl MaterialTraits {
    /// Whether a texture or an opacity varies what is seen of the emission.
    pub fn varies_emission(&self) -> bool {
        self.is_transparent || self.textures.any_of(&Slot::OF_EMISSION)
    }

    /// Where radiance is not what is shown, no material is a mirror or transparent.
    fn of(object: &MaterialObject, pass: Pass) -> Self {
        let is_radiance = pass == Pass::Radiance;
        Self {
            is_mirror: is_radiance
                && object.bsdf == Bsdf::BlinnPhong
                && object.values.mirror != DVec3::ZERO,
            bsdf: object.bsdf,
            lobes: object.lobes(),
            is_transparent: is_radiance && object.transparent,
            is_black: object.bsdf == Bsdf::BlinnPhong
                && [object.values.diffuse, object.values.specular] == [DVec3::ZERO; 2],
            is_metal: object.values.metallic == 1.0
                && object.textures.get(Slot::MetallicRoughness).is_none(),
            unscattered: unscattered(object),
            textures: object.textures,
            normal_scale: object.normal_scale,
        }
    }
}

/// The probability with which a path that meets a material is not scattered: about the part that this has
/// of the light, in steps, so that small changes of the numbers leave paths where they are.
fn unscattered(object: &MaterialObject) -> f32 {
    const STEPS: f64 = 8.0;
    let material = &object.values;
    let part = match object.transparent {
        true => 1.0 - material.opacity,
        false => {
            let mirrored = material.mirror.max_element();
            mirrored / (mirrored + (material.diffuse + material.specular).max_element()).max(1e-30)
        }
    };
    ((part * STEPS).round().clamp(1.0, STEPS - 1.0) / STEPS) as f32
}

/// Where within pixels rays go: if nothing is said, as many as the scene says where light takes all paths; through
/// the middle where what is shown has no mean.
pub fn sampling_of(settings: Sampling, path_tracing: Option<PathTracing>, pass: Pass) -> Sampling {
    match path_tracing {
        _ if pass == Pass::Ids => Sampling::Center,
        Some(paths) => paths.sampling(settings),
        None => settings,
    }
}

/// The texture coordinates of corners, where textures vary materials or they are what is shown.
fn uvs(scene: &Scene, pass: Pass) -> Corners {
    Corners::new(&scene.meshes, |mesh| match scene.textures.is_empty() && pass != Pass::Uv {
        true => (0, Cow::Borrowed(&[])),
        false => (mesh.texture_coordinates.len(), Cow::Borrowed(&mesh.texture_triangles[..])),
    })
}

/// A texture among the texels of all.
#[derive(Clone, Copy, Debug)]
pub struct TextureLayout {
    pub first_texel: usize,
    pub width: u32,
    pub height: u32,
    /// Of columns and of rows.
    pub wrap: [Wrap; 2],
}

impl TextureLayout {
    /// The texture as primitives of a kind show it: on spheres columns go around, and rows end at the poles.
    #[inline]
    pub fn on(self, kind: Kind) -> Self {
        match kind {
            Kind::Sphere => Self { wrap: [Wrap::Repeat, Wrap::Clamp], ..self },
            Kind::Triangle | Kind::Custom => self,
        }
    }

    /// The texels among those of all textures.
    pub fn texels(&self) -> Range<usize> {
        self.first_texel..self.first_texel + self.width as usize * self.height as usize
    }

    /// The indices of the texels around a position: those of a
    /// [`Footprint`](crate::transport::texture::Footprint).
    #[inline]
    pub fn around(&self, x: f64, y: f64) -> [u32; 4] {
        let (column, row) = (x.floor() as i64, y.floor() as i64);
        let columns = [column, column.saturating_add(1)].map(|c| self.wrap[0].index(c, self.width));
        let rows = [row, row.saturating_add(1)].map(|r| self.wrap[1].index(r, self.height));
        let texel = |row: u32, column: u32| {
            (self.first_texel + row as usize * self.width as usize + column as usize) as u32
        };
        [
            texel(rows[0], columns[0]),
            texel(rows[0], columns[1]),
            texel(rows[1], columns[0]),
            texel(rows[1], columns[1]),
        ]
    }
}

/// Where lights stand for what shines, if light takes all paths: [boundary segments](crate::boundary) know the edges of
/// its shadows elsewhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandIns {
    None,
    /// Only where shadow rays [start](crate::transport::smooth::curved_point()) beyond another surface.
    AboveSurfaces,
    /// There, and on what mirrors show.
    InMirrors,
    Everywhere,
}

/// The kind of a primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Triangle,
    Sphere,
    Custom,
}

impl Layout {
    pub fn new(scene: &Scene, settings: &Settings) -> Self {
        let is_direct = scene.path_tracing().is_none();
        let sky_parts = match scene.environment {
            Some(_) if is_direct => {
                sky_parts::parts(scene.environment_map(), scene.light_samples, None)
            }
            _ => Vec::new(),
        };
        Self::with_parts(scene, settings, sky_parts, is_direct)
    }

    /// The same, where light is direct although the scene asks for all paths. Nothing stands yet for what shines.
    pub fn direct(scene: &Scene, settings: &Settings) -> Self {
        Self::with_parts(scene, settings, Vec::new(), true)
    }

    fn with_parts(
        scene: &Scene,
        settings: &Settings,
        sky_parts: Vec<SkyPart>,
        is_direct: bool,
    ) -> Self {
        let [width, height] = scene.size();
        let stands_for = scene.path_tracing().filter(|_| is_direct);
        let stands_for_depth = stands_for.map(|limits| limits.max_depth);
        let mut layout = Self {
            width,
            height,
            pass: settings.pass,
            path_tracing: None,
            sampling: settings.sampling,
            bounces: match stands_for_depth {
                // The last piece of a path leads to a light.
                Some(depth) => scene.bounces.min(depth.saturating_sub(2)),
                None => settings.bounces.unwrap_or(scene.bounces),
            },
            stands_for_depth,
            triangles: Vec::new(),
            spheres: scene.spheres.len(),
            material_of: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
            has_mirrors: false,
            has_transparency: false,
            has_other_bsdfs: false,
            has_opacity_textures: false,
            has_normal_maps: false,
            textures: textures(scene),
            map: None,
            sky: None,
            sky_parts,
            shining: Vec::new(),
            is_direct,
            background: None,
            first_vertices: vec![0],
            mirrored: Vec::new(),
            uvs: uvs(scene, settings.pass),
            normals: Corners::new(&scene.meshes, |mesh| {
                (mesh.normal_count(), mesh.normal_triangles())
            }),
            adjacency: OnceLock::new(),
        };
        let mut first = 0;
        for mesh in &scene.meshes {
            layout.triangles.extend(mesh.triangles.iter().map(|t| t.map(|v| v + first)));
            layout.material_of.extend(&mesh.materials);
            first += mesh.vertices.len() as u32;
            layout.first_vertices.push(first);
        }
        layout.material_of.extend(scene.spheres.iter().map(|sphere| sphere.material));
        layout.material_of.extend(scene.shapes.iter().map(|shape| shape.material));
        layout.show(scene, settings);
        layout
    }

    /// Takes over what is shown, and what follows from it: where rays go, and a map of the environment.
    pub fn show(&mut self, scene: &Scene, settings: &Settings) {
        if self.pass != settings.pass && [self.pass, settings.pass].contains(&Pass::Uv) {
            self.uvs = uvs(scene, settings.pass);
        }
        self.pass = settings.pass;
        self.update(scene);
        self.map = self.map(scene);
        let chooses_by = self.map.filter(|_| self.path_tracing.is_some());
        self.sky = chooses_by.map(|(_, map)| Sky::new(map.width, map.height));
        self.sampling = sampling_of(settings.sampling, self.path_tracing, self.pass);
    }

    /// Takes over what lights and materials can do, which depends on their numbers.
    pub fn update(&mut self, scene: &Scene) {
        let pass = self.pass;
        self.path_tracing = scene.path_tracing_of(pass).filter(|_| !self.is_direct);
        let environment = scene.environment.filter(|_| pass == Pass::Radiance);
        self.background = environment.and_then(|environment| environment.background);
        self.lights.clear();
        for (object, light) in scene.lights.iter().enumerate().filter(|_| pass == Pass::Radiance) {
            let traits = LightTraits { object, is_black: light.source.is_black() };
            let count = light.source.place_count(scene.light_samples);
            self.lights.extend(iter::repeat_n(traits, count));
        }
        if let Some(environment) = environment {
            let (is_black, map) =
                (environment.values.radiance == DVec3::ZERO, scene.environment_map());
            for (object, part) in (scene.lights.len()..).zip(&mut self.sky_parts) {
                part.update(map);
                self.lights.push(LightTraits { object, is_black });
            }
        }
        let first = scene.lights.len() + self.sky_parts.len();
        let shining = (first..).take(self.shining.len());
        self.lights.extend(shining.map(|object| LightTraits { object, is_black: false }));
        self.materials.clear();
        self.materials
            .extend(scene.materials.iter().map(|object| MaterialTraits::of(object, pass)));
        self.has_mirrors = self.materials.iter().any(|traits| traits.is_mirror);
        self.has_transparency = self.materials.iter().any(|traits| traits.is_transparent);
        self.has_other_bsdfs = self.materials.iter().any(|traits| traits.bsdf != Bsdf::BlinnPhong);
        let has =
            |slot: Slot| self.materials.iter().any(|traits| traits.textures.get(slot).is_some());
        self.has_opacity_textures = has(Slot::Opacity);
        self.has_normal_maps = has(Slot::Normal);
        self.mirrored.clear();
        self.mirrored.extend(scene.meshes.iter().map(Mesh::is_mirrored));
    }

    /// The texture of the environment, a sphere around the scene.
    fn map(&self, scene: &Scene) -> Option<(usize, TextureLayout)> {
        let environment = scene.environment.filter(|_| self.pass == Pass::Radiance)?;
        let texture = environment.texture? as usize;
        Some((texture, self.textures[texture].on(Kind::Sphere)))
    }

    /// The kind of a primitive, and its index among those of its kind.
    #[inline]
    pub fn kind_of(&self, primitive: usize) -> (Kind, usize) {
        let triangles = self.triangles.len();
        if primitive < triangles {
            (Kind::Triangle, primitive)
        } else if primitive < triangles + self.spheres {
            (Kind::Sphere, primitive - triangles)
        } else {
            (Kind::Custom, primitive - triangles - self.spheres)
        }
    }

    /// Which triangles share edges: found when it is first asked for.
    pub fn adjacency(&self) -> &Adjacency {
        let is_seam = |a: u32, b: u32| self.share_normals(a as usize, b as usize);
        self.adjacency.get_or_init(|| Adjacency::new(&self.triangles, is_seam))
    }

    /// The mesh or the sphere that a primitive belongs to, meshes first.
    pub fn object_of(&self, primitive: u32) -> usize {
        match self.triangles.get(primitive as usize) {
            Some(&[vertex, ..]) => self.mesh_of_vertex(vertex),
            None => self.meshes() + primitive as usize - self.triangles.len(),
        }
    }

    pub fn meshes(&self) -> usize {
        self.first_vertices.len() - 1
    }

    /// Where lights stand for what shines, as far as the edges of its shadows are looked for in images.
    pub fn stand_ins(&self) -> StandIns {
        match (self.has_transparency, self.has_mirrors, self.normals.is_empty()) {
            (true, ..) => StandIns::Everywhere,
            (false, true, _) => StandIns::InMirrors,
            (false, false, false) => StandIns::AboveSurfaces,
            (false, false, true) => StandIns::None,
        }
    }

    /// The first of the lights that stand for what shines; the others are those of the scene.
    pub fn first_stand_in(&self) -> usize {
        self.lights.len() - self.sky_parts.len() - self.shining.len()
    }

    /// Whether two triangles have an edge in common and the same normals there.
    pub fn share_normals(&self, a: usize, b: usize) -> bool {
        let [Some(first), Some(second)] = [a, b].map(|triangle| self.normals.of(triangle)) else {
            return false;
        };
        let corners = self.triangles[a].into_iter().zip(first);
        let shared = corners.filter_map(|(vertex, normal)| {
            let other = self.triangles[b].iter().position(|&other| other == vertex)?;
            Some(normal == second[other])
        });
        let mut count = 0;
        let are_same = shared.inspect(|_| count += 1).all(|is_same| is_same);
        are_same && count >= 2
    }

    /// Whether two triangles have one material, and nothing on it varies.
    pub fn look_alike(&self, a: usize, b: usize) -> bool {
        let material = self.material_of[a];
        let varies = self.pass == Pass::Uv || self.materials[material as usize].textures.any();
        material == self.material_of[b] && !varies
    }

    /// The number of vertices of all meshes.
    pub fn vertices(&self) -> usize {
        self.first_vertices.last().map_or(0, |&end| end as usize)
    }

    /// The vertices of a mesh among those of all.
    pub fn vertices_of(&self, mesh: usize) -> Range<usize> {
        self.first_vertices[mesh] as usize..self.first_vertices[mesh + 1] as usize
    }

    /// The number of custom shapes.
    pub fn customs(&self) -> usize {
        self.material_of.len() - self.triangles.len() - self.spheres
    }

    /// What the material of a primitive can do.
    #[inline]
    pub fn traits_of(&self, primitive: usize) -> &MaterialTraits {
        &self.materials[self.material_of[primitive] as usize]
    }

    /// A number for the materials of primitives that a light comes through: another one for others, zero for none.
    pub fn filters(&self, light: usize, primitives: impl Iterator<Item = u32>) -> u32 {
        let material = |primitive: u32| hash(self.material_of[primitive as usize] + 1);
        let sum = primitives.map(material).fold(0, u32::wrapping_add);
        sum.wrapping_mul(2 * light as u32 + 1)
    }

    /// Whether a light comes through so many transparent surfaces to one that paths meet at a `depth`. Paths for which
    /// direct light stands go through transparent surfaces to find what shines, and meet only so many in all.
    pub fn comes_through(&self, light: usize, surfaces: usize, depth: usize) -> bool {
        let is_met_by_paths = surfaces > 0 && light >= self.first_stand_in();
        let most = self.stands_for_depth.filter(|_| is_met_by_paths);
        most.is_none_or(|most| depth + surfaces + 1 < most as usize)
    }

    /// Whether a triangle is flat and opaque, and has a normal map, by which it may face lights that it stands before.
    pub fn shades_itself(&self, triangle: usize) -> bool {
        let traits = self.traits_of(triangle);
        let has_map = traits.textures.get(Slot::Normal).is_some();
        has_map && !traits.is_transparent && self.normals.of(triangle).is_none()
    }

    /// The scale of the normal map of a triangle, of the other sign where the triangle is mirrored.
    pub fn normal_scale(&self, triangle: usize) -> f64 {
        let scale = self.traits_of(triangle).normal_scale;
        if self.is_mirrored(triangle) { -scale } else { scale }
    }

    /// Whether the corners of a triangle go round the other way than in the mesh before it is scaled.
    pub fn is_mirrored(&self, triangle: usize) -> bool {
        self.mirrored[self.mesh_of(triangle)]
    }

    /// What a primitive is part of, as [`Pass::Ids`] counts: the object, its triangle, its material.
    pub fn ids_of(&self, primitive: usize) -> [usize; 3] {
        let meshes = self.first_vertices.len() - 1;
        let material = self.material_of[primitive] as usize;
        let (object, triangle) = match self.kind_of(primitive) {
            (Kind::Triangle, triangle) => {
                let mesh = self.mesh_of(triangle);
                let is_before = |corners: &[u32; 3]| self.mesh_of_vertex(corners[0]) < mesh;
                (mesh, triangle - self.triangles.partition_point(is_before))
            }
            (Kind::Sphere, sphere) => (meshes + sphere, 0),
            (Kind::Custom, shape) => (meshes + self.spheres + shape, 0),
        };
        [object, triangle, material].map(|index| index + 1)
    }

    /// The mesh of a triangle.
    pub fn mesh_of(&self, triangle: usize) -> usize {
        self.mesh_of_vertex(self.triangles[triangle][0])
    }

    /// The mesh of a vertex.
    pub fn mesh_of_vertex(&self, vertex: u32) -> usize {
        // The last of those that begin no later: meshes without vertices begin where the next one does.
        self.first_vertices.partition_point(|&first| first <= vertex) - 1
    }
}

/// Where the texels of each texture are, among those of all.
fn textures(scene: &Scene) -> Vec<TextureLayout> {
    let mut first_texel = 0;
    let textures = scene.textures.iter().map(|texture| {
        let placed = TextureLayout {
            first_texel,
            width: texture.width,
            height: texture.height,
            wrap: [texture.wrap; 2],
        };
        first_texel += texture.texels.len();
        placed
    });
    textures.collect()
}
