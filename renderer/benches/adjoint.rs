//! The adjoint of intersect-and-shade, written by hand: what generated code is measured by.

use std::f64::consts::FRAC_1_PI;

use ad::vector::{Vector, Vector3};
use ad::{Additive, Real, Tangent, Vec3, select};
use renderer::transport::camera::Ray;
use renderer::transport::light::PointLight;
use renderer::transport::material::Material;
use renderer::transport::triangle::{Triangle, exact_cross};

/// The cotangents of ray, triangle, material and light: what the generated pullback returns.
pub type Cotangents<S> =
    (Tangent<Ray<S>>, Tangent<Triangle<S>>, Tangent<Material<S>>, Tangent<PointLight<S>>);

/// The radiance of a triangle under a point light, and its pullback at `seed`.
pub fn pixel<S: Real>(
    ray: Ray<S>,
    triangle: Triangle<S>,
    material: Material<S>,
    light: PointLight<S>,
    seed: Vec3<S>,
) -> (Vec3<S>, Cotangents<S>) {
    let Triangle { a, b, c } = triangle;
    let Ray { origin, direction } = ray;
    let (u, v) = (b - a, c - a);
    let normal = exact_cross::<S>(u, v);
    let slope = direction.dot(normal);
    let from_origin = a - origin;
    let inverse_slope = slope.recip();
    let distance = from_origin.dot(normal) * inverse_slope;
    let inverse_length = normal.length_recip();
    let unit = normal * inverse_length;
    let behind = slope.cmpgt(S::ZERO);
    let facing = select(behind, -unit, unit);

    let to_light = light.position - (origin + direction * distance);
    let inverse_distance = to_light.length_recip();
    let towards = to_light * inverse_distance;
    let inverse_square = inverse_distance * inverse_distance;
    let flux_density = light.radiant_intensity * inverse_square;
    let irradiance = light.color * flux_density;
    let cosine = facing.dot(towards).max(S::ZERO);
    let sum = towards - direction;
    let inverse_sum = sum.length_recip();
    let half_way = sum * inverse_sum;
    let alignment = facing.dot(half_way).max(S::ZERO);
    let highlight = alignment.powf(material.exponent);
    let inverse_pi = S::from_f64(FRAC_1_PI);
    let brdf = (material.diffuse + material.specular * highlight) * inverse_pi;
    let value = brdf * irradiance * cosine;

    let albedo_bar = seed * irradiance * (cosine * inverse_pi);
    let lit = seed * brdf;
    let irradiance_bar = lit * cosine;
    let cosine_bar = select(cosine.cmpgt(S::ZERO), lit.dot(irradiance), S::ZERO);
    let highlight_bar = albedo_bar.dot(material.specular);
    let aligned = alignment.cmpgt(S::ZERO);
    let power = highlight_bar * highlight;
    let alignment_bar = select(aligned, power * material.exponent / alignment, S::ZERO);
    let exponent_bar = select(aligned, power * alignment.ln(), S::ZERO);
    let half_way_bar = facing * alignment_bar;
    let sum_bar = (half_way_bar - half_way * half_way.dot(half_way_bar)) * inverse_sum;
    let facing_bar = half_way * alignment_bar + towards * cosine_bar;
    let towards_bar = sum_bar + facing * cosine_bar;
    let flux_density_bar = irradiance_bar.dot(light.color);
    let radial = S::TWO * flux_density_bar * flux_density * inverse_square;
    let to_light_bar =
        (towards_bar - towards * towards.dot(towards_bar)) * inverse_distance - to_light * radial;

    let point_bar = -to_light_bar;
    let distance_bar = point_bar.dot(direction) * inverse_slope;
    let slope_bar = -distance_bar * distance;
    let unit_bar = select(behind, -facing_bar, facing_bar);
    let normal_bar = (unit_bar - unit * unit.dot(unit_bar)) * inverse_length
        + from_origin * distance_bar
        + direction * slope_bar;
    let (u_bar, v_bar) = (v.cross(normal_bar), normal_bar.cross(u));
    let along = normal * distance_bar;
    let ray = Tangent::<Ray<S>> {
        origin: point_bar - along,
        direction: point_bar * distance + normal * slope_bar - sum_bar,
    };
    let triangle = Tangent::<Triangle<S>> { a: along - u_bar - v_bar, b: u_bar, c: v_bar };
    let material = Tangent::<Material<S>> {
        diffuse: albedo_bar,
        specular: albedo_bar * highlight,
        exponent: exponent_bar,
        ..Additive::zero()
    };
    let light = Tangent::<PointLight<S>> {
        position: to_light_bar,
        color: irradiance_bar * flux_density,
        radiant_intensity: flux_density_bar * inverse_square,
    };
    (value, (ray, triangle, material, light))
}
