//! Facets and glass by themselves: values by other formulas, samples, energy, derivatives.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use ad::Real;
use glam::{DVec3, dvec3};
use renderer::Material;
use renderer::transport::dielectric::{fresnel, refracted_direction, relative_ior};
use renderer::transport::microfacet::{
    Sampling, facet_density, facet_direction, metallic_roughness, sampling, scattered_density,
    scattered_direction,
};
use renderer::transport::surface::SurfacePoint;

fn material(color: DVec3, metallic: f64, roughness: f64) -> Material<f64> {
    Material { metallic, roughness, ..Material::lambertian(color) }
}

/// A unit vector at an angle from z, turned about it.
fn at(angle: f64, around: f64) -> DVec3 {
    dvec3(angle.sin() * around.cos(), angle.sin() * around.sin(), angle.cos())
}

/// A surface seen at an angle from its normal, z.
fn seen_at(angle: f64) -> SurfacePoint<f64> {
    SurfacePoint { point: DVec3::ZERO, normal: DVec3::Z, view: at(angle, 0.0) }
}

/// The BRDF of the specification, by angles and tangents.
fn independent(material: Material<f64>, view: DVec3, light: DVec3) -> DVec3 {
    let half_way = (view + light).normalize();
    let width = material.roughness.powi(2);
    let tangent_squared = |v: DVec3| (v.x * v.x + v.y * v.y) / (v.z * v.z);
    let facing = tangent_squared(half_way) / width.powi(2);
    let distribution = 1.0 / (PI * width.powi(2) * half_way.z.powi(4) * (1.0 + facing).powi(2));
    let lambda = |v: DVec3| ((1.0 + width.powi(2) * tangent_squared(v)).sqrt() - 1.0) / 2.0;
    let seen = 1.0 / (1.0 + lambda(view) + lambda(light));
    let specular = distribution * seen / (4.0 * view.z * light.z);
    let rest = (1.0 - view.dot(half_way)).powf(5.0);
    let straight_on = ((1.0 - material.ior) / (1.0 + material.ior)).powf(2.0);
    let mix = |a: DVec3, b: DVec3, t: f64| a * (1.0 - t) + b * t;
    let layer = straight_on + (1.0 - straight_on) * rest;
    let dielectric = mix(material.diffuse / PI, DVec3::splat(specular), layer);
    let metal = specular * mix(material.diffuse, DVec3::ONE, rest);
    mix(dielectric, metal, material.metallic)
}

/// The integral over a hemisphere, or from the pole to another angle, of a function that has its peak
/// somewhere: the midpoint rule, where both sines are the measure.
fn integral(to: f64, steps: usize, value: impl Fn(DVec3) -> f64) -> f64 {
    let mut sum = 0.0;
    for i in 0..steps {
        let angle = (i as f64 + 0.5) / steps as f64 * to;
        for j in 0..2 * steps {
            let around = (j as f64 + 0.5) / (2 * steps) as f64 * TAU;
            sum += value(at(angle, around)) * angle.sin();
        }
    }
    sum * to / steps as f64 * PI / steps as f64
}

#[test]
fn values_are_those_of_other_formulas() {
    let color = dvec3(0.9, 0.5, 0.2);
    for (metallic, roughness, ior) in
        [(0.0, 0.5, 1.5), (1.0, 0.3, 1.5), (0.4, 0.8, 1.8), (0.7, 1.0, 1.1), (1.0, 0.05, 2.0)]
    {
        let material = Material { ior, ..material(color, metallic, roughness) };
        for view in [0.0, 0.4, 1.1, 1.5] {
            let surface = seen_at(view);
            for (angle, around) in [(0.0, 0.0), (0.4, PI), (1.0, 2.0), (1.2, PI), (1.56, 3.0)] {
                let light = at(angle, around);
                let found = metallic_roughness::<f64>(material, surface, light);
                let expected = independent(material, surface.view, light);
                let error = (found - expected).abs().max_element();
                assert!(error <= 1e-9 * expected.max_element(), "{found}, expected {expected}");
            }
        }
    }
}

/// Samples fall into parts of the sphere as often as the density says: those of facets and of both lobes.
#[test]
fn samples_are_spread_as_their_density_says() {
    const SIDE: usize = 600;
    let numbers = || {
        (0..SIDE * SIDE).map(|i| {
            let fraction = |k: usize| (k as f64 + 0.5) / SIDE as f64;
            [fraction(i % SIDE), fraction(i / SIDE)]
        })
    };
    for (width, share, view) in
        [(0.25, 1.0, 0.3), (0.8, 1.0, 1.3), (1.0, 1.0, 0.0), (0.3, 0.5, 1.0)]
    {
        let surface = seen_at(view);
        let sampling = Sampling { width, share };
        let mut counts = [[0.0; 8]; 6];
        for (index, numbers) in numbers().enumerate() {
            // Which lobe: a third number, even whatever the others are.
            let lobe = (index as f64 * 0.618_033_988_749_894_9).fract();
            let direction = scattered_direction::<f64>(sampling, surface, lobe, numbers);
            assert!((direction.length() - 1.0).abs() < 1e-12);
            let angle = direction.z.clamp(-1.0, 1.0).acos();
            let around = direction.y.atan2(direction.x).rem_euclid(TAU);
            let row = ((angle / PI * 6.0) as usize).min(5);
            counts[row][((around / TAU * 8.0) as usize).min(7)] += 1.0;
        }
        let density = |direction| match share {
            1.0 => facet_density::<f64>(width, surface, direction),
            _ => scattered_density::<f64>(sampling, surface, direction),
        };
        let (steps, mut expected) = (960, [[0.0; 8]; 6]);
        for i in 0..steps {
            let angle = (i as f64 + 0.5) / steps as f64 * PI;
            for j in 0..steps {
                let around = (j as f64 + 0.5) / steps as f64 * TAU;
                let area = angle.sin() * PI * TAU / (steps * steps) as f64;
                expected[i * 6 / steps][j * 8 / steps] += density(at(angle, around)) * area;
            }
        }
        let total: f64 = expected.as_flattened().iter().sum();
        assert!((total - 1.0).abs() < 2e-3, "{width} {share} {view}: {total}");
        for (count, expected) in counts.as_flattened().iter().zip(expected.as_flattened()) {
            let found = count / (SIDE * SIDE) as f64;
            assert!((found - expected).abs() < 1.5e-3, "{width} {share}: {found} of {expected}");
        }
    }
}

/// What a surface reflects of light from everywhere, by samples.
fn albedo(material: Material<f64>, view: f64) -> DVec3 {
    const SIDE: usize = 300;
    let surface = seen_at(view);
    let of_lobes = sampling::<f64>(material, surface, material.metallic < 1.0);
    let mut sum = DVec3::ZERO;
    for index in 0..SIDE * SIDE {
        let fraction = |k: usize| (k as f64 + 0.5) / SIDE as f64;
        let numbers = [fraction(index % SIDE), fraction(index / SIDE)];
        let lobe = (index as f64 * 0.618_033_988_749_894_9).fract();
        let direction = scattered_direction::<f64>(of_lobes, surface, lobe, numbers);
        if direction.z > 0.0 {
            let density = scattered_density::<f64>(of_lobes, surface, direction);
            let brdf = metallic_roughness::<f64>(material, surface, direction);
            sum += brdf * (direction.z / density);
        }
    }
    sum / (SIDE * SIDE) as f64
}

/// Metals reflect no more than they receive, and others but at grazing angles; what they do is the integral of
/// the independent formula.
#[test]
fn energy_is_that_of_the_integral_and_never_more_than_all() {
    for (metallic, roughness) in
        [(1.0, 1.0), (1.0, 0.5), (1.0, 0.02), (0.0, 1.0), (0.0, 0.3), (0.5, 0.6), (0.0, 0.0)]
    {
        let material = material(DVec3::ONE, metallic, roughness);
        for view in [0.0, 0.5, 1.0, 1.4, 1.56] {
            let found = albedo(material, view);
            // The base of the specification forgets at grazing angles what the layer reflects.
            let most = if metallic == 1.0 || view < 0.9 { 1.0 + 3e-3 } else { 2.0 };
            assert!(found.max_element() <= most, "{metallic} {roughness} {view}: {found}");
            if metallic == 1.0 && roughness < 0.1 {
                assert!(found.min_element() >= 0.99, "{found}");
            }
            if roughness < 0.5 {
                continue;
            }
            let view_direction = at(view, 0.0);
            let expected = integral(FRAC_PI_2, 500, |light| {
                independent(material, view_direction, light).x * light.z
            });
            let error = (found.x - expected).abs();
            assert!(error < 3e-3, "{metallic} {roughness} {view}: {found} of {expected}");
        }
    }
    // In closed form for a white metal of roughness 1, straight on: the integral of c / (1 + c) from 0 to 1.
    let white = albedo(material(DVec3::ONE, 1.0, 1.0), 0.0).x;
    assert!((white - (1.0 - std::f64::consts::LN_2)).abs() < 1e-4, "{white}");
}

/// The generated pullback of the BRDF, by all of its inputs, beside differences.
#[test]
fn pullbacks_agree_with_differences() {
    let surface = SurfacePoint {
        point: DVec3::ZERO,
        normal: dvec3(0.1, -0.2, 1.0).normalize(),
        view: dvec3(0.5, 0.3, 0.8).normalize(),
    };
    let light = dvec3(-0.6, 0.1, 0.7).normalize();
    let seed = dvec3(0.3, 0.5, -0.8);
    for (metallic, roughness) in [(0.3, 0.4), (0.9, 0.15), (0.05, 0.95)] {
        let values = Material { ior: 1.7, ..material(dvec3(0.8, 0.4, 0.3), metallic, roughness) };
        let (_, pullback) = metallic_roughness::vjp::<f64>(values, surface, light);
        let (by_material, by_surface, by_light) = pullback(seed);
        let found = [
            by_material.diffuse.x,
            by_material.roughness,
            by_material.metallic,
            by_material.ior,
            by_surface.normal.x,
            by_surface.view.y,
            by_light.z,
        ];
        for (index, found) in found.into_iter().enumerate() {
            let value = |step: f64| {
                let (mut values, mut surface, mut light) = (values, surface, light);
                let number = match index {
                    0 => &mut values.diffuse.x,
                    1 => &mut values.roughness,
                    2 => &mut values.metallic,
                    3 => &mut values.ior,
                    4 => &mut surface.normal.x,
                    5 => &mut surface.view.y,
                    _ => &mut light.z,
                };
                *number += step;
                metallic_roughness::<f64>(values, surface, light).dot(seed)
            };
            let expected = ad::check::derivative(value, 0.0, 1e-3).value;
            let error = (found - expected).abs();
            assert!(error <= 1e-8 * (1.0 + expected.abs()), "{index}: {found}, not {expected}");
        }
    }
}

/// What light and viewers at every angle, and the least roughness, lead to: finite values and derivatives, in
/// both precisions.
#[test]
fn extremes_are_finite() {
    fn check<S: Real<Mask = bool> + Into<f64>>() {
        let real = |x: f64| S::from_f64(x);
        for roughness in [0.0, 1e-4, 1e-2, 0.3, 1.0] {
            for metallic in [0.0, 1.0] {
                for cosine in [-1e-3, 0.0, 1e-30, 1e-9, 1e-3, 0.5, 1.0] {
                    for other in [-0.5, 0.0, 1e-20, 1e-4, 0.7, 1.0] {
                        let [view, light] = [(cosine, 1.0), (other, -1.0)].map(|(c, side)| {
                            let sine = f64::sqrt(1.0 - c * c) * side;
                            <ad::Vec3<S> as ad::vector::Vector3>::new(real(sine), S::ZERO, real(c))
                        });
                        let up = ad::vector::Vector3::new(S::ZERO, S::ZERO, S::ONE);
                        let point = ad::vector::Vector3::new(S::ZERO, S::ZERO, S::ZERO);
                        let surface = SurfacePoint { point, normal: up, view };
                        let values = material(DVec3::ONE, metallic, roughness);
                        let values = ad::Fields::map(&values, real);
                        let (value, pullback) =
                            metallic_roughness::vjp::<S>(values, surface, light);
                        let (by, by_surface, by_light) = pullback(up);
                        let of_lobes = sampling::<S>(values, surface, metallic < 1.0);
                        let sampled = scattered_direction::<S>(
                            of_lobes,
                            surface,
                            real(0.3),
                            [real(0.2), real(0.9)],
                        );
                        let density = scattered_density::<S>(of_lobes, surface, sampled);
                        let mut numbers = vec![by.roughness, by.metallic, by.ior, density];
                        for v in [value, by.diffuse, by_surface.normal, by_surface.view, by_light] {
                            numbers.extend([
                                ad::vector::Vector3::x(v),
                                ad::vector::Vector3::y(v),
                                ad::vector::Vector3::z(v),
                            ]);
                        }
                        let place = format!("{roughness} {metallic} {cosine} {other}");
                        let numbers: Vec<f64> = numbers.into_iter().map(Into::into).collect();
                        assert!(numbers.iter().all(|x| x.is_finite()), "{place}: {numbers:?}");
                        assert!(numbers[3] >= 0.0, "{place}");
                    }
                }
            }
        }
    }
    check::<f64>();
    check::<f32>();
}

/// A smooth metal reflects to the mirror direction.
#[test]
fn the_sharpest_facets_are_a_mirror() {
    for angle in [0.0, 0.7, 1.4] {
        let surface = seen_at(angle);
        for numbers in [[0.1, 0.3], [0.6, 0.9], [0.9, 0.5]] {
            let direction = facet_direction::<f64>(1e-4, surface, numbers);
            assert!(direction.distance(at(angle, PI)) < 2e-3, "{direction}");
        }
    }
}

/// Values of handbooks: air and glass, Brewster's angle, total reflection; Snell's law; both directions lose
/// alike.
#[test]
fn glass_obeys_fresnel_and_snell() {
    let ior = 1.5;
    assert!((fresnel::<f64>(ior, 1.0) - 0.04).abs() < 1e-15);
    assert!((fresnel::<f64>(ior, 1e-9) - 1.0).abs() < 1e-8);
    assert!(fresnel::<f64>(1.0, 0.3) < 1e-30);
    // Only one polarisation is reflected.
    let brewster = ior.atan();
    let transmitted = (brewster.sin() / ior).asin();
    let perpendicular = ((brewster - transmitted).sin() / (brewster + transmitted).sin()).powi(2);
    assert!((fresnel::<f64>(ior, brewster.cos()) - perpendicular / 2.0).abs() < 1e-12);
    let critical = (1.0 / ior).asin();
    assert_eq!(fresnel::<f64>(relative_ior::<f64>(ior, true), (critical + 1e-6).cos()), 1.0);
    assert!(fresnel::<f64>(1.0 / ior, (critical - 1e-3).cos()) < 1.0);
    let glass = Material { ior, ..Material::lambertian(DVec3::ONE) };
    for angle in [0.0, 0.5, 1.2] {
        let refracted = refracted_direction::<f64>(glass, seen_at(angle), false);
        let inner = (angle.sin() / ior).asin();
        assert!(refracted.distance(at(PI - inner, PI)) < 1e-12);
        let inwards = fresnel::<f64>(ior, angle.cos());
        let outwards = fresnel::<f64>(1.0 / ior, inner.cos());
        assert!((inwards - outwards).abs() < 1e-12, "{inwards} {outwards}");
    }
}
