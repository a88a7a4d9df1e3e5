//! The kernels as functions of a list of numbers, so that they can be compared in any arithmetic.

use std::array;

use ad::vector::Vector3;
use ad::{Real, Vec3, differentiable};
use renderer::kernels::camera::{Camera, Ray, frame, primary_ray};
use renderer::kernels::light::{DistantLight, PointLight, ray_along, ray_to_position};
use renderer::kernels::material::{
    Material, reflection_of_distant_light, reflection_of_point_light,
};
use renderer::kernels::sphere::{Sphere, sphere_surface};
use renderer::kernels::surface::{SurfacePoint, mirrored_ray, seen_through, straight_ray};
use renderer::kernels::texture::{Uv, bilinear, sphere_uv, triangle_uv, varied_opacity};
use renderer::kernels::triangle::triangle_surface;

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
        ("look_from", 3), ("look_at", 3), ("up", 3), ("vfov", 1), ("focus", 1), ("film", 2),
    ] => [3, 3];
    /// A ray and the corners of a triangle; the point and the normal where they meet.
    TriangleSurface = triangle [
        ("origin", 3), ("direction", 3), ("a", 3), ("b", 3), ("c", 3),
    ] => [3, 3];
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
    SphereUv = sphere_place [("point", 3), ("center", 3), ("radius", 1)] => [2];
    /// A point light on a surface; the radiance towards the viewer.
    PointLit = point_lit [
        ("position", 3), ("color", 3), ("intensity", 1),
        ("diffuse", 3), ("specular", 3), ("exponent", 1),
        ("point", 3), ("normal", 3), ("view", 3),
    ] => [3];
    /// A distant light on a surface; the radiance towards the viewer.
    DistantLit = distant_lit [
        ("direction", 3), ("color", 3), ("intensity", 1),
        ("diffuse", 3), ("specular", 3), ("exponent", 1),
        ("point", 3), ("normal", 3), ("view", 3),
    ] => [3];
    /// A surface point; the ray that a mirror sends on.
    Mirrored = mirrored [("point", 3), ("normal", 3), ("view", 3)] => [3, 3];
    /// A surface point; the ray that goes on behind it.
    Straight = straight [("point", 3), ("normal", 3), ("view", 3)] => [3, 3];
    /// The texels around a place of a texture of 4 x 2, and the place; the colour there.
    Textured = textured [("texels", 12), ("uv", 2)] => [3];
    /// A texel, an opacity, what is seen of a surface and behind it; what is seen of both.
    Covered = covered [("texel", 3), ("opacity", 1), ("own", 3), ("behind", 3)] => [3];
    /// Where a light is, and a point; the ray from the point to the light.
    ToPosition = to_position [("position", 3), ("point", 3)] => [3, 3];
    /// Where a light comes from, and a point; the ray towards it.
    ToDirection = to_direction [("direction", 3), ("point", 3)] => [3, 3];
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
        focus: x[10],
    };
    let ray = primary_ray::<S>(frame::<S>(camera, S::ONE), x[11], x[12]);
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn triangle<S: Real>(x: &[S]) -> [S; 6] {
    let surface = triangle_surface::<S>(
        ray::<S>(x),
        vector::<S>(x, 6),
        vector::<S>(x, 9),
        vector::<S>(x, 12),
    );
    six::<S>(surface.point, surface.normal)
}

#[differentiable]
fn sphere<S: Real>(x: &[S]) -> Sphere<S> {
    Sphere { center: vector::<S>(x, 6), radius: x[9] }
}

#[differentiable]
fn sphere_entered<S: Real>(x: &[S]) -> [S; 6] {
    let entered = S::ONE.cmplt(S::ZERO);
    let surface = sphere_surface::<S>(ray::<S>(x), sphere::<S>(x), entered);
    six::<S>(surface.point, surface.normal)
}

#[differentiable]
fn sphere_left<S: Real>(x: &[S]) -> [S; 6] {
    let left = S::ZERO.cmplt(S::ONE);
    let surface = sphere_surface::<S>(ray::<S>(x), sphere::<S>(x), left);
    six::<S>(surface.point, surface.normal)
}

#[differentiable]
fn triangle_place<S: Real>(x: &[S]) -> [S; 2] {
    let corners = [Uv { u: x[12], v: x[13] }, Uv { u: x[14], v: x[15] }, Uv { u: x[16], v: x[17] }];
    let uv = triangle_uv::<S>(
        vector::<S>(x, 0),
        vector::<S>(x, 3),
        vector::<S>(x, 6),
        vector::<S>(x, 9),
        corners,
    );
    [uv.u, uv.v]
}

#[differentiable]
fn sphere_place<S: Real>(x: &[S]) -> [S; 2] {
    let sphere = Sphere { center: vector::<S>(x, 3), radius: x[6] };
    let uv = sphere_uv::<S>(vector::<S>(x, 0), sphere);
    [uv.u, uv.v]
}

#[differentiable]
fn material<S: Real>(x: &[S]) -> Material<S> {
    let none = vector::<S>(x, 7) * S::ZERO;
    Material {
        ambient: none,
        diffuse: vector::<S>(x, 7),
        specular: vector::<S>(x, 10),
        exponent: x[13],
        reflection: none,
    }
}

#[differentiable]
fn surface<S: Real>(x: &[S]) -> SurfacePoint<S> {
    SurfacePoint { point: vector::<S>(x, 14), normal: vector::<S>(x, 17), view: vector::<S>(x, 20) }
}

#[differentiable]
fn point_lit<S: Real>(x: &[S]) -> [S; 3] {
    let light =
        PointLight { position: vector::<S>(x, 0), color: vector::<S>(x, 3), intensity: x[6] };
    three::<S>(reflection_of_point_light::<S>(material::<S>(x), surface::<S>(x), light))
}

#[differentiable]
fn distant_lit<S: Real>(x: &[S]) -> [S; 3] {
    let light =
        DistantLight { direction: vector::<S>(x, 0), color: vector::<S>(x, 3), intensity: x[6] };
    three::<S>(reflection_of_distant_light::<S>(material::<S>(x), surface::<S>(x), light))
}

#[differentiable]
fn point<S: Real>(x: &[S]) -> SurfacePoint<S> {
    SurfacePoint { point: vector::<S>(x, 0), normal: vector::<S>(x, 3), view: vector::<S>(x, 6) }
}

#[differentiable]
fn mirrored<S: Real>(x: &[S]) -> [S; 6] {
    let ray = mirrored_ray::<S>(point::<S>(x));
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn straight<S: Real>(x: &[S]) -> [S; 6] {
    let ray = straight_ray::<S>(point::<S>(x));
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn textured<S: Real>(x: &[S]) -> [S; 3] {
    let texels = [vector::<S>(x, 0), vector::<S>(x, 3), vector::<S>(x, 6), vector::<S>(x, 9)];
    let uv = Uv { u: x[12], v: x[13] };
    three::<S>(bilinear::<S>(texels, uv, S::from_f64(4.0), S::from_f64(2.0)))
}

#[differentiable]
fn covered<S: Real>(x: &[S]) -> [S; 3] {
    let opacity = varied_opacity::<S>(x[3], vector::<S>(x, 0));
    three::<S>(seen_through::<S>(opacity, vector::<S>(x, 4), vector::<S>(x, 7)))
}

#[differentiable]
fn to_position<S: Real>(x: &[S]) -> [S; 6] {
    let ray = ray_to_position::<S>(vector::<S>(x, 0), vector::<S>(x, 3));
    six::<S>(ray.origin, ray.direction)
}

#[differentiable]
fn to_direction<S: Real>(x: &[S]) -> [S; 6] {
    let ray = ray_along::<S>(vector::<S>(x, 0), vector::<S>(x, 3));
    six::<S>(ray.origin, ray.direction)
}
