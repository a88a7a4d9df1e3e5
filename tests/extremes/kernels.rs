//! The kernels as functions of a list of numbers, so that they can be compared in any arithmetic.

use std::array;

use ad::vector::{Vector, Vector3};
use ad::{Real, Vec3, differentiable};
use renderer::transport::camera::{Camera, Ray, camera_frame, primary_ray};
use renderer::transport::direct::{attenuate, direct};
use renderer::transport::illumination::Illumination;
use renderer::transport::light::{
    DistantLight, PointLight, SpotLight, illuminate_by_distant, illuminate_by_point,
    illuminate_by_spot,
};
use renderer::transport::material::{Lobes, Material};
use renderer::transport::smooth::{
    SmoothPoint, next_ray_outward, place_normal, smooth_point, weighted_normal,
};
use renderer::transport::sphere::{Sphere, sphere_point, sphere_uv};
use renderer::transport::surface::SurfacePoint;
use renderer::transport::texture::{Footprint, Uv, modulate, modulate_opacity};
use renderer::transport::transform::{Transform, place, unplace};
use renderer::transport::triangle::{Triangle, triangle_point, triangle_uv};
use renderer::transport::vertex::{next_ray, outgoing};

/// A kernel under test.
pub trait Kernel {
    /// The vectors and numbers that it takes, with how many coordinates each has.
    const INPUTS: &'static [(&'static str, usize)];
    /// How many coordinates each of its results has.
    const OUTPUTS: &'static [usize];

    /// Its results, one after the other.
    fn value<S: Real>(x: &[S]) -> Vec<S>;

    /// The cotangents of what it takes by those of the results.
    fn pull_back<S: Real>(x: &[S], cotangents: &[S]) -> Vec<S>;
}

macro_rules! kernels {
    ($($(#[$doc:meta])* $name:ident = $function:ident $inputs:expr => $outputs:expr;)*) => {$(
        $(#[$doc])*
        pub struct $name;

        impl Kernel for $name {
            const INPUTS: &'static [(&'static str, usize)] = &$inputs;
            const OUTPUTS: &'static [usize] = &$outputs;

            fn value<S: Real>(x: &[S]) -> Vec<S> {
                $function::<S>(x).to_vec()
            }

            fn pull_back<S: Real>(x: &[S], cotangents: &[S]) -> Vec<S> {
                let (_, pullback) = $function::vjp::<S>(x);
                pullback(array::from_fn(|i| cotangents[i]))
            }
        }
    )*};
}

kernels! {
    /// A camera and a point of its image plane; the ray.
    PrimaryRay = primary [
        ("look_from", 3), ("look_at", 3), ("up", 3), ("vfov", 1), ("film_scale", 1), ("film", 2),
    ] => [3, 3];
    /// A ray and the corners of a triangle; the point and the normal where they meet.
    TrianglePoint = triangle [
        ("origin", 3), ("direction", 3), ("a", 3), ("b", 3), ("c", 3),
    ] => [3, 3];
    /// A ray, the corners of a smooth triangle and their normals; the point, the shading normal and that of
    /// the flat triangle.
    OnSmooth = on_smooth [
        ("origin", 3), ("direction", 3), ("a", 3), ("b", 3), ("c", 3),
        ("normal of a", 3), ("normal of b", 3), ("normal of c", 3),
    ] => [3, 3, 3];
    /// A point of a smooth triangle; the ray that a mirror sends on.
    SmoothMirrored = smooth_mirrored [
        ("point", 3), ("normal", 3), ("view", 3), ("outward", 3),
    ] => [3, 3];
    /// A triangle; what it adds to the normals of its corners.
    Weighted = weighted [("a", 3), ("b", 3), ("c", 3)] => [3];
    /// A transform and a normal; its place in the world.
    PlacedNormal = placed_normal [
        ("translation", 3), ("rotation", 3), ("scale", 3), ("normal", 3),
    ] => [3];
    /// A ray and a sphere; the point and the normal where it enters.
    SphereEntered = sphere_entered [
        ("origin", 3), ("direction", 3), ("center", 3), ("radius", 1),
    ] => [3, 3];
    /// The same where it leaves.
    SphereLeft = sphere_left [
        ("origin", 3), ("direction", 3), ("center", 3), ("radius", 1),
    ] => [3, 3];
    /// A point of a triangle, its corners, their places on a texture; its place.
    TriangleUv = triangle_place [("point", 3), ("a", 3), ("b", 3), ("c", 3), ("uv", 6)] => [2];
    /// A point of a sphere, and the sphere; its place on a texture.
    SphereUv = sphere_place [
        ("point", 3), ("center", 3), ("radius", 1), ("rotation", 3),
    ] => [2];
    /// A point light on a surface; the radiance towards the viewer.
    PointLit = point_lit [
        ("position", 3), ("color", 3), ("intensity", 1),
        ("diffuse", 3), ("roughness", 1), ("specular", 3), ("exponent", 1),
        ("point", 3), ("normal", 3), ("view", 3),
    ] => [3];
    /// A distant light on a surface; the radiance towards the viewer.
    DistantLit = distant_lit [
        ("direction", 3), ("color", 3), ("intensity", 1),
        ("diffuse", 3), ("roughness", 1), ("specular", 3), ("exponent", 1),
        ("point", 3), ("normal", 3), ("view", 3),
    ] => [3];
    /// A surface point; the ray that a mirror sends on.
    Mirrored = mirrored [("point", 3), ("normal", 3), ("view", 3)] => [3, 3];
    /// A surface point; the ray that goes on behind it.
    Straight = straight [("point", 3), ("normal", 3), ("view", 3)] => [3, 3];
    /// A colour, the texels around a place of a texture of 4 x 2, and the place; the colour there.
    Textured = textured [("color", 3), ("texels", 12), ("uv", 2)] => [3];
    /// An opacity, the texels around a place, the place, what is seen of a surface and behind it; what is
    /// seen of both.
    Covered = covered [
        ("opacity", 1), ("texels", 12), ("uv", 2), ("own", 3), ("beyond", 3),
    ] => [3];
    /// What a mirror adds, what is seen of it and in it; what is seen of both.
    Added = added [("mirror", 3), ("own", 3), ("beyond", 3)] => [3];
    /// What light has passed, and the opacity of one more surface; what is left of it.
    Attenuated = attenuated [("transmittance", 1), ("opacity", 1)] => [1];
    /// A point light and a point; the direction, the distance and the irradiance there.
    ByPoint = by_point [
        ("position", 3), ("color", 3), ("intensity", 1), ("point", 3),
    ] => [3, 1, 3];
    /// A distant light; the direction to it and its irradiance.
    ByDistant = by_distant [("direction", 3), ("color", 3), ("irradiance", 1)] => [3, 3];
    /// A spot light and a point; the irradiance there.
    BySpot = by_spot [
        ("position", 3), ("direction", 3), ("color", 3), ("intensity", 1), ("inner", 1), ("outer", 1),
        ("point", 3),
    ] => [3];
    /// A transform and a point; its place in the world.
    Placed = placed [
        ("translation", 3), ("rotation", 3), ("scale", 3), ("point", 3),
    ] => [3];
    /// A transform and a place in the world; the point.
    Unplaced = unplaced [
        ("translation", 3), ("rotation", 3), ("scale", 3), ("point", 3),
    ] => [3];
}

#[differentiable]
fn vector<S: Real>(x: &[S], at: usize) -> Vec3<S> {
    <Vec3<S>>::new(x[at], x[at + 1], x[at + 2])
}

#[differentiable]
fn ray<S: Real>(x: &[S]) -> Ray<S> {
    Ray { origin: vector::<S>(x, 0), direction: vector::<S>(x, 3) }
}

#[differentiable]
fn six<S: Real>(u: Vec3<S>, v: Vec3<S>) -> [S; 6] {
    [u.x(), u.y(), u.z(), v.x(), v.y(), v.z()]
}

#[differentiable]
fn three<S: Real>(v: Vec3<S>) -> [S; 3] {
    [v.x(), v.y(), v.z()]
}

#[differentiable]
fn primary<S: Real>(x: &[S]) -> [S; 6] {
    let camera = Camera {
        look_from: vector::<S>(x, 0),
        look_at: vector::<S>(x, 3),
        up: vector::<S>(x, 6),
        vfov: x[9],
        film_scale: x[10],
    };
    let ray = primary_ray::<S>(camera_frame::<S>(camera, S::ONE), x[11], x[12]);
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn corners<S: Real>(x: &[S], at: usize) -> Triangle<S> {
    Triangle { a: vector::<S>(x, at), b: vector::<S>(x, at + 3), c: vector::<S>(x, at + 6) }
}

#[differentiable]
fn triangle<S: Real>(x: &[S]) -> [S; 6] {
    let surface = triangle_point::<S>(corners::<S>(x, 6), ray::<S>(x));
    six::<S>(surface.point, surface.normal)
}

#[differentiable]
fn on_smooth<S: Real>(x: &[S]) -> [S; 9] {
    let normals = [vector::<S>(x, 15), vector::<S>(x, 18), vector::<S>(x, 21)];
    let point = smooth_point::<S>(corners::<S>(x, 6), normals, ray::<S>(x));
    let (at, n, outward) = (point.surface.point, point.surface.normal, point.outward);
    [at.x(), at.y(), at.z(), n.x(), n.y(), n.z(), outward.x(), outward.y(), outward.z()]
}

#[differentiable]
fn smooth_mirrored<S: Real>(x: &[S]) -> [S; 6] {
    let at = SmoothPoint { surface: point::<S>(x), outward: vector::<S>(x, 9) };
    let ray = next_ray_outward::<S>(at, S::ONE.cmplt(S::ZERO));
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn weighted<S: Real>(x: &[S]) -> [S; 3] {
    three::<S>(weighted_normal::<S>(corners::<S>(x, 0)))
}

#[differentiable]
fn placed_normal<S: Real>(x: &[S]) -> [S; 3] {
    three::<S>(place_normal::<S>(transform::<S>(x), vector::<S>(x, 9)))
}

#[differentiable]
fn sphere<S: Real>(x: &[S]) -> Sphere<S> {
    Sphere { center: vector::<S>(x, 6), radius: x[9], rotation: <Vec3<S>>::splat(S::ZERO) }
}

#[differentiable]
fn sphere_entered<S: Real>(x: &[S]) -> [S; 6] {
    let entered = S::ONE.cmplt(S::ZERO);
    let surface = sphere_point::<S>(sphere::<S>(x), entered, ray::<S>(x));
    six::<S>(surface.point, surface.normal)
}

#[differentiable]
fn sphere_left<S: Real>(x: &[S]) -> [S; 6] {
    let left = S::ZERO.cmplt(S::ONE);
    let surface = sphere_point::<S>(sphere::<S>(x), left, ray::<S>(x));
    six::<S>(surface.point, surface.normal)
}

#[differentiable]
fn triangle_place<S: Real>(x: &[S]) -> [S; 2] {
    let places = [Uv { u: x[12], v: x[13] }, Uv { u: x[14], v: x[15] }, Uv { u: x[16], v: x[17] }];
    let uv = triangle_uv::<S>(corners::<S>(x, 3), places, vector::<S>(x, 0));
    [uv.u, uv.v]
}

#[differentiable]
fn sphere_place<S: Real>(x: &[S]) -> [S; 2] {
    let sphere = Sphere { center: vector::<S>(x, 3), radius: x[6], rotation: vector::<S>(x, 7) };
    let uv = sphere_uv::<S>(sphere, vector::<S>(x, 0));
    [uv.u, uv.v]
}

#[differentiable]
fn material<S: Real>(x: &[S]) -> Material<S> {
    let none = <Vec3<S>>::splat(S::ZERO);
    Material {
        emission: none,
        diffuse: vector::<S>(x, 7),
        roughness: x[10],
        specular: vector::<S>(x, 11),
        exponent: x[14],
        mirror: none,
        opacity: S::ONE,
        metallic: S::ZERO,
        ior: S::ONE,
    }
}

#[differentiable]
fn surface<S: Real>(x: &[S]) -> SurfacePoint<S> {
    SurfacePoint { point: vector::<S>(x, 15), normal: vector::<S>(x, 18), view: vector::<S>(x, 21) }
}

#[differentiable]
fn lit<S: Real>(x: &[S], light: Illumination<S>) -> [S; 3] {
    let visible = S::ZERO.cmplt(S::ONE);
    let (material, surface) = (material::<S>(x), surface::<S>(x));
    let lobes = Lobes { rough: true, glossy: true, facets: false };
    three::<S>(direct::<S>(material, lobes, surface, light, visible, S::ONE))
}

#[differentiable]
fn point_light<S: Real>(x: &[S]) -> PointLight<S> {
    PointLight { position: vector::<S>(x, 0), color: vector::<S>(x, 3), radiant_intensity: x[6] }
}

#[differentiable]
fn distant_light<S: Real>(x: &[S]) -> DistantLight<S> {
    DistantLight { direction: vector::<S>(x, 0), color: vector::<S>(x, 3), irradiance: x[6] }
}

#[differentiable]
fn point_lit<S: Real>(x: &[S]) -> [S; 3] {
    lit::<S>(x, illuminate_by_point::<S>(point_light::<S>(x), vector::<S>(x, 15)))
}

#[differentiable]
fn distant_lit<S: Real>(x: &[S]) -> [S; 3] {
    lit::<S>(x, illuminate_by_distant::<S>(distant_light::<S>(x)))
}

#[differentiable]
fn point<S: Real>(x: &[S]) -> SurfacePoint<S> {
    SurfacePoint { point: vector::<S>(x, 0), normal: vector::<S>(x, 3), view: vector::<S>(x, 6) }
}

#[differentiable]
fn mirrored<S: Real>(x: &[S]) -> [S; 6] {
    let ray = next_ray::<S>(point::<S>(x), S::ONE.cmplt(S::ZERO));
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn straight<S: Real>(x: &[S]) -> [S; 6] {
    let ray = next_ray::<S>(point::<S>(x), S::ZERO.cmplt(S::ONE));
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn footprint<S: Real>(x: &[S], at: usize) -> Footprint<S> {
    Footprint {
        texels: [
            vector::<S>(x, at),
            vector::<S>(x, at + 3),
            vector::<S>(x, at + 6),
            vector::<S>(x, at + 9),
        ],
        width: S::from_f64(4.0),
        height: S::from_f64(2.0),
    }
}

#[differentiable]
fn textured<S: Real>(x: &[S]) -> [S; 3] {
    let uv = Uv { u: x[15], v: x[16] };
    three::<S>(modulate::<S>(vector::<S>(x, 0), footprint::<S>(x, 3), uv))
}

#[differentiable]
fn covered<S: Real>(x: &[S]) -> [S; 3] {
    let opacity = modulate_opacity::<S>(x[0], footprint::<S>(x, 1), Uv { u: x[13], v: x[14] });
    let (transparent, none) = (S::ZERO.cmplt(S::ONE), <Vec3<S>>::splat(S::ZERO));
    let (own, beyond) = (vector::<S>(x, 15), vector::<S>(x, 18));
    three::<S>(outgoing::<S>(opacity, none, transparent, own, beyond))
}

#[differentiable]
fn added<S: Real>(x: &[S]) -> [S; 3] {
    let opaque = S::ONE.cmplt(S::ZERO);
    let (own, beyond) = (vector::<S>(x, 3), vector::<S>(x, 6));
    three::<S>(outgoing::<S>(S::ONE, vector::<S>(x, 0), opaque, own, beyond))
}

#[differentiable]
fn attenuated<S: Real>(x: &[S]) -> [S; 1] {
    [attenuate::<S>(x[0], x[1])]
}

#[differentiable]
fn by_point<S: Real>(x: &[S]) -> [S; 7] {
    let light = illuminate_by_point::<S>(point_light::<S>(x), vector::<S>(x, 7));
    let (to, brings) = (light.direction, light.irradiance);
    [to.x(), to.y(), to.z(), light.distance, brings.x(), brings.y(), brings.z()]
}

#[differentiable]
fn by_distant<S: Real>(x: &[S]) -> [S; 6] {
    let light = illuminate_by_distant::<S>(distant_light::<S>(x));
    six::<S>(light.direction, light.irradiance)
}

#[differentiable]
fn by_spot<S: Real>(x: &[S]) -> [S; 3] {
    let light = SpotLight {
        position: vector::<S>(x, 0),
        direction: vector::<S>(x, 3),
        color: vector::<S>(x, 6),
        radiant_intensity: x[9],
        inner_angle: x[10],
        outer_angle: x[11],
    };
    three::<S>(illuminate_by_spot::<S>(light, vector::<S>(x, 12)).irradiance)
}

#[differentiable]
fn transform<S: Real>(x: &[S]) -> Transform<S> {
    Transform {
        translation: vector::<S>(x, 0),
        rotation: vector::<S>(x, 3),
        scale: vector::<S>(x, 6),
    }
}

#[differentiable]
fn placed<S: Real>(x: &[S]) -> [S; 3] {
    three::<S>(place::<S>(transform::<S>(x), vector::<S>(x, 9)))
}

#[differentiable]
fn unplaced<S: Real>(x: &[S]) -> [S; 3] {
    three::<S>(unplace::<S>(transform::<S>(x), vector::<S>(x, 9)))
}
