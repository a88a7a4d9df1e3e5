//! The table of parameters: what is known of each field of each kind of object.
//!
//! The list of parameters, the optimiser, the check of a scene and scene files read it; names and
//! numbers are those of the structs. So a new number of an object is a field of its struct and a row
//! here.

use glam::DVec3;

use super::{Bsdf, Camera, LightSource, Mesh, Object, ParameterId, Scene};
use crate::transport::area_light::Place;
use crate::transport::microfacet::LEAST_ROUGHNESS;

/// Lengths and coordinates beyond this overflow when an `f32` squares them.
const LARGEST_LENGTH: f64 = 1e18;
/// Lengths below this vanish when an `f32` squares them.
pub const SMALLEST_LENGTH: f64 = 1e-18;
/// Other numbers beyond this leave the range of an `f32`.
const LARGEST_NUMBER: f64 = 1e38;
/// The power of a rounding error next to 1 is far from 1 beyond this exponent, and the highlight is
/// smaller than any pixel.
pub const LARGEST_EXPONENT: f64 = 1e6;
/// Above this a surface reflects nearly all.
const LARGEST_IOR: f64 = 1e3;
/// Normal maps of larger scales would say nothing but the direction along the surface.
pub(super) const LARGEST_NORMAL_SCALE: f64 = 1e6;
/// Texture coordinates beyond this do not tell texels apart in an `f32`.
pub(super) const LARGEST_COORDINATE: f64 = 1e6;

const LENGTH: (f64, f64) = (-LARGEST_LENGTH, LARGEST_LENGTH);
const EXTENT: (f64, f64) = (SMALLEST_LENGTH, LARGEST_LENGTH);
const ENERGY: (f64, f64) = (0.0, LARGEST_NUMBER);
const PART: (f64, f64) = (0.0, 1.0);
const CONE: (f64, f64) = (0.0, 90.0);
const NUMBER: (f64, f64) = (-LARGEST_NUMBER, LARGEST_NUMBER);

/// What is known of a field of a kind of object.
pub struct Row {
    kind: &'static str,
    field: &'static str,
    /// The values for which it means something, ends included.
    range: (f64, f64),
    /// The largest value where nobody says otherwise. A surface reflects no more light than it
    /// receives: beyond that, a bright spot could as well be explained by a surface that makes light
    /// as by a stronger lamp.
    pub usual_max: f64,
    /// A change that changes the image a lot, by the scene, the object and its numbers.
    scale: fn(&Scene, usize, &[f64]) -> f64,
    /// The learning rate, the length of the first Adam step, in that scale. It is large enough to get
    /// anywhere within the default number of iterations; steps get smaller where the gradient does.
    /// Cameras and geometry take their time: an edge tells where to go only within a pixel of where it
    /// should be.
    pub rate: f64,
    /// Whether it moves edges: silhouettes, or those of shadows.
    pub moves_edges: bool,
    /// Whether it is a direction, of any length above 0.
    pub is_direction: bool,
}

/// A field that moves no edges.
const fn smooth(
    kind: &'static str,
    field: &'static str,
    range: (f64, f64),
    scale: fn(&Scene, usize, &[f64]) -> f64,
) -> Row {
    let (usual_max, rate) = (f64::INFINITY, 0.04);
    Row { kind, field, range, usual_max, scale, rate, moves_edges: false, is_direction: false }
}

/// A field that moves edges.
const fn moving(
    kind: &'static str,
    field: &'static str,
    range: (f64, f64),
    scale: fn(&Scene, usize, &[f64]) -> f64,
) -> Row {
    Row { moves_edges: true, ..smooth(kind, field, range, scale) }
}

/// One that takes its time.
const fn slow(row: Row) -> Row {
    Row { rate: 0.01, ..row }
}

const fn direction(row: Row) -> Row {
    Row { is_direction: true, ..row }
}

/// An albedo.
const fn albedo(field: &'static str) -> Row {
    Row { usual_max: 1.0, ..smooth("material", field, ENERGY, one) }
}

const TABLE: &[Row] = &[
    // Those of views, too.
    slow(moving("camera", "look_from", LENGTH, |scene, i, _| view_distance(scene.camera_at(i)))),
    slow(moving("camera", "look_at", LENGTH, |scene, i, _| view_height(scene.camera_at(i)))),
    slow(direction(moving("camera", "up", LENGTH, size))),
    slow(moving("camera", "vfov", (1e-3, 179.999), size)),
    slow(moving("camera", "film_scale", (SMALLEST_LENGTH, LARGEST_NUMBER), size)),
    smooth("environment", "radiance", ENERGY, one),
    moving("environment", "rotation", NUMBER, degrees),
    moving("light", "position", LENGTH, |scene, i, _| light_distance(scene, i)),
    direction(moving("light", "direction", LENGTH, size)),
    moving("light", "center", LENGTH, |scene, i, _| light_distance(scene, i)),
    direction(moving("light", "right", LENGTH, size)),
    direction(moving("light", "up", LENGTH, size)),
    smooth("light", "color", ENERGY, one),
    // As much as brings the irradiance 1 to what the camera looks at, or what it is if that is more.
    smooth("light", "radiant_intensity", ENERGY, |scene, i, numbers| {
        size(scene, i, numbers).max(light_distance(scene, i).powi(2))
    }),
    smooth("light", "irradiance", ENERGY, |scene, i, numbers| size(scene, i, numbers).max(1.0)),
    smooth("light", "radiance", ENERGY, |scene, i, numbers| size(scene, i, numbers).max(1.0)),
    smooth("light", "inner_angle", CONE, degrees),
    smooth("light", "outer_angle", CONE, degrees),
    smooth("material", "emission", ENERGY, one),
    albedo("diffuse"),
    smooth("material", "roughness", PART, one),
    albedo("specular"),
    smooth("material", "exponent", (0.0, LARGEST_EXPONENT), |scene, i, numbers| {
        size(scene, i, numbers).max(10.0)
    }),
    albedo("mirror"),
    smooth("material", "opacity", PART, one),
    smooth("material", "metallic", PART, one),
    smooth("material", "ior", (1.0, LARGEST_IOR), one),
    moving("sphere", "center", LENGTH, |scene, i, _| scene.spheres[i].values.radius),
    moving("sphere", "radius", EXTENT, size),
    smooth("sphere", "rotation", NUMBER, degrees),
    slow(moving("mesh", "vertices", LENGTH, |scene, i, _| {
        positive_or(mean_edge(&scene.meshes[i]), view_distance(scene.seen_from()))
    })),
    slow(smooth("mesh", "texture_coordinates", (-LARGEST_COORDINATE, LARGEST_COORDINATE), one)),
    // They move what mirrors show.
    slow(direction(moving("mesh", "normals", LENGTH, size))),
    slow(moving("mesh", "translation", LENGTH, |scene, _, _| view_height(scene.seen_from()))),
    slow(moving("mesh", "rotation", NUMBER, degrees)),
    slow(moving("mesh", "scale", LENGTH, size)),
    smooth("texture", "texels", ENERGY, one),
    slow(moving("shape", "translation", LENGTH, |scene, _, _| view_height(scene.seen_from()))),
    slow(moving("shape", "rotation", NUMBER, degrees)),
    slow(moving("shape", "scale", LENGTH, size)),
];

/// Of a field that a custom shape or light has.
const CUSTOM: Row =
    slow(moving("", "", NUMBER, |scene, i, numbers| positive_or(size(scene, i, numbers), 1.0)));

/// The row of a parameter.
pub fn row(id: ParameterId) -> &'static Row {
    let kind = match id.object {
        Object::View(_) => Object::Camera.kind(),
        object => object.kind(),
    };
    TABLE.iter().find(|row| (row.kind, row.field) == (kind, id.field)).unwrap_or(&CUSTOM)
}

/// The fields of a kind of object, as they stand in the table; lights of all kinds have those of all.
pub fn fields(kind: &str) -> impl Iterator<Item = &'static str> {
    TABLE.iter().filter(move |row| row.kind == kind).map(|row| row.field)
}

impl Scene {
    /// The values for which a parameter means something, ends included.
    pub fn range(&self, id: ParameterId) -> (f64, f64) {
        match id.object {
            Object::Texture(i) if self.varies_parts(i) => PART,
            _ => row(id).range,
        }
    }

    /// What numbers seldom are less than: below the least width of facets, a roughness changes nothing.
    pub fn usual_min(&self, id: ParameterId) -> f64 {
        match id.object {
            Object::Material(i)
                if id.field == "roughness" && self.materials[i].bsdf == Bsdf::MetallicRoughness =>
            {
                LEAST_ROUGHNESS
            }
            _ => f64::NEG_INFINITY,
        }
    }

    /// A change of a parameter that changes the image a lot.
    ///
    /// - The camera turns or zooms by a part of its view; a light or the camera moves by a part of its
    ///   distance; a sphere by a part of its radius, vertices by a part of an edge of their mesh, a
    ///   mesh by a part of the view.
    /// - Rotations change by a radian, albedos and texels by 1.
    /// - A light changes as much as it takes to bring the irradiance 1 to what the camera looks at, or,
    ///   if it is stronger than that already, by what it is.
    pub fn natural_scale(&self, id: ParameterId) -> f64 {
        let index = match id.object {
            Object::Camera | Object::Environment => 0,
            Object::View(i) | Object::Light(i) | Object::Material(i) | Object::Texture(i) => i,
            Object::Sphere(i) | Object::Mesh(i) | Object::Shape(i) => i,
        };
        match id.object {
            // Whatever they are: they are many.
            Object::Texture(_) => (row(id).scale)(self, index, &[]),
            _ => (row(id).scale)(self, index, &self.get(id)),
        }
    }
}

fn one(_: &Scene, _: usize, _: &[f64]) -> f64 {
    1.0
}

fn degrees(_: &Scene, _: usize, _: &[f64]) -> f64 {
    1.0_f64.to_degrees()
}

/// The largest of the numbers.
fn size(_: &Scene, _: usize, numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0_f64, |size, value| size.max(value.abs()))
}

/// The distance of the point that a camera looks at.
fn view_distance(camera: &Camera<f64>) -> f64 {
    camera.look_from.distance(camera.look_at)
}

/// Half of the height that a camera sees at the point it looks at.
fn view_height(camera: &Camera<f64>) -> f64 {
    view_distance(camera) * (0.5 * camera.vfov).to_radians().tan() * camera.film_scale
}

/// The distance of a light from the point that the camera looks at.
fn light_distance(scene: &Scene, light: usize) -> f64 {
    let camera = scene.seen_from();
    let view = view_distance(camera);
    let position = match &scene.lights[light].source {
        LightSource::Known(light) => light.position(Place::POINT),
        LightSource::Custom { .. } => None,
    };
    position.map_or(view, |position| positive_or(position.distance(camera.look_at), view))
}

fn positive_or(size: f64, other: f64) -> f64 {
    if size > 0.0 { size } else { other }
}

/// The mean length of the edges of a mesh.
fn mean_edge(mesh: &Mesh) -> f64 {
    let vertex = |i: u32| DVec3::from_array(mesh.vertices[i as usize]);
    let edges = mesh.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let total: f64 = edges.map(|(a, b)| vertex(a).distance(vertex(b))).sum();
    total / (3 * mesh.triangles.len().max(1)) as f64
}

#[cfg(test)]
mod tests {
    use ad::Fields;

    use super::TABLE;
    use crate::scene::numbers::Numbers;
    use crate::scene::{
        AreaLight, Camera, DistantLight, Environment, Material, Mesh, PointLight, Sphere,
        SpotLight, Texture, Transform, Wrap,
    };

    /// Every field of every kind of object has one row, and no row is for nothing.
    #[test]
    fn every_field_has_a_row() {
        let texture = Texture {
            name: String::new(),
            width: 1,
            height: 1,
            wrap: Wrap::Repeat,
            texels: vec![[0.0_f64; 3]].into(),
        };
        let mesh = Mesh::new("", vec![], vec![]).texture_coordinates(vec![[0.0; 2]], vec![]);
        let mesh = mesh.normals(vec![], vec![]);
        let names =
            |fields: &[ad::Field]| fields.iter().map(|field| field.name).collect::<Vec<_>>();
        let fields = [
            ("camera", names(Camera::<f64>::FIELDS)),
            ("environment", names(Environment::<f64>::FIELDS)),
            ("light", names(PointLight::<f64>::FIELDS)),
            ("light", names(DistantLight::<f64>::FIELDS)),
            ("light", names(SpotLight::<f64>::FIELDS)),
            ("light", names(AreaLight::<f64>::FIELDS)),
            ("material", names(Material::<f64>::FIELDS)),
            ("sphere", names(Sphere::<f64>::FIELDS)),
            ("mesh", names(&mesh.fields())),
            ("texture", names(&texture.fields())),
            ("shape", names(Transform::<f64>::FIELDS)),
        ];
        let expected =
            fields.iter().flat_map(|(kind, names)| names.iter().map(move |name| (*kind, *name)));
        let mut expected: Vec<_> = expected.collect();
        let mut rows: Vec<_> = TABLE.iter().map(|row| (row.kind, row.field)).collect();
        rows.sort_unstable();
        expected.sort_unstable();
        // Lights of several kinds share fields.
        expected.dedup();
        assert_eq!(rows, expected);
    }
}
