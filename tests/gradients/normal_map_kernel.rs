//! Normals bent by maps, one by one: values by another formula, derivatives.

use ad::Real;
use glam::{DMat3, DVec2, DVec3, dvec2, dvec3};
use renderer::transport::normal_map::{NormalMap, mapped_normal, rounded_normal};
use renderer::transport::surface::SurfacePoint;
use renderer::transport::texture::{Footprint, Uv};
use renderer::transport::triangle::Triangle;

/// The arguments of the function.
#[derive(Clone, Copy)]
struct Case {
    corners: [DVec3; 3],
    uvs: [DVec2; 3],
    normal: DVec3,
    view: DVec3,
    texel: DVec3,
    scale: f64,
}

impl Case {
    const NUMBERS: usize = 25;

    /// Numbers that look random.
    fn new(seed: usize) -> Self {
        let noise = |index: usize| ((seed * 977 + index) as f64 * 12.9898).sin() * 43_758.545_3;
        let number = |index: usize| 2.0 * noise(index).rem_euclid(1.0) - 1.0;
        let vector = |index: usize| dvec3(number(index), number(index + 1), number(index + 2));
        let corners = [vector(0), vector(3), vector(6)];
        let flat = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        let side = if seed.is_multiple_of(2) { 1.0 } else { -1.0 };
        Self {
            corners,
            uvs: [9, 11, 13].map(|index| dvec2(number(index), number(index + 1))),
            normal: (flat * side + 0.3 * vector(15)).normalize(),
            view: (flat * side + 0.5 * vector(18)).normalize(),
            texel: vector(21) * dvec3(0.15, 0.15, 0.1) + dvec3(0.5, 0.5, 0.85),
            scale: 1.0 + 0.5 * number(24),
        }
    }

    fn number(&mut self, index: usize) -> &mut f64 {
        match index {
            0..9 => &mut self.corners[index / 3][index % 3],
            9..15 => &mut self.uvs[(index - 9) / 2][(index - 9) % 2],
            15..18 => &mut self.normal[index - 15],
            18..21 => &mut self.view[index - 18],
            21..24 => &mut self.texel[index - 21],
            _ => &mut self.scale,
        }
    }

    fn arguments<S: Real>(&self) -> Arguments<S> {
        let vector = |v: DVec3| {
            ad::vector::Vector3::new(S::from_f64(v.x), S::from_f64(v.y), S::from_f64(v.z))
        };
        let uv = |v: DVec2| Uv { u: S::from_f64(v.x), v: S::from_f64(v.y) };
        let [a, b, c] = self.corners.map(vector);
        let (one, texel) = (S::ONE, vector(self.texel));
        let footprint = Footprint { texels: [texel; 4], width: one, height: one };
        let middle = Uv { u: S::HALF, v: S::HALF };
        let (normal, view) = (vector(self.normal), vector(self.view));
        (
            Triangle { a, b, c },
            self.uvs.map(uv),
            SurfacePoint { point: a, normal, view },
            NormalMap { footprint, uv: middle, scale: S::from_f64(self.scale) },
        )
    }

    fn bent(&self) -> DVec3 {
        let (triangle, corners, surface, map) = self.arguments::<f64>();
        mapped_normal::<f64>(triangle, corners, surface, map, true)
    }

    /// By the inverse of the matrix of the derivatives of `u`, `v` and the height.
    fn independent(&self) -> DVec3 {
        let [a, b, c] = self.corners;
        let [uv_a, uv_b, uv_c] = self.uvs;
        let flat = (b - a).cross(c - a).normalize();
        let gradient = |of_b: f64, of_c: f64| {
            DMat3::from_cols(b - a, c - a, flat).transpose().inverse() * dvec3(of_b, of_c, 0.0)
        };
        let by_u = gradient(uv_b.x - uv_a.x, uv_c.x - uv_a.x);
        let by_v = gradient(uv_b.y - uv_a.y, uv_c.y - uv_a.y);
        // The direction along which v stays, and u grows.
        let along_u = by_v.cross(flat);
        let along_u = along_u * along_u.dot(by_u).signum();
        let front = if flat.dot(self.view) < 0.0 { -self.normal } else { self.normal };
        let tangent = (along_u - along_u.project_onto(front)).normalize();
        let bitangent = front.cross(tangent);
        let bitangent = bitangent * by_u.cross(by_v).dot(flat).signum();
        let local = 2.0 * self.texel - DVec3::ONE;
        let bent =
            tangent * local.x * self.scale + bitangent * local.y * self.scale + front * local.z;
        bent.normalize() * front.dot(self.normal).signum()
    }
}

type Arguments<S> = (Triangle<S>, [Uv<S>; 3], SurfacePoint<S>, NormalMap<S>);

#[test]
fn bent_normals_agree_with_another_formula() {
    for seed in 0..200 {
        let case = Case::new(seed);
        let (found, expected) = (case.bent(), case.independent());
        // Others are turned towards the viewer.
        if expected.dot(case.view) > 0.0 {
            assert!((found - expected).length() < 1e-9, "{seed}: {found}, expected {expected}");
        } else {
            assert!(found.dot(case.view) > -1e-12, "{seed}: {found}");
            let plane = expected.cross(case.view).normalize();
            assert!(found.dot(plane).abs() < 1e-9 && found.dot(expected) > 0.0, "{seed}");
        }
    }
}

#[test]
fn derivatives_of_bent_normals_agree_with_differences() {
    let seed_of = dvec3(0.3, -0.8, 0.5);
    for seed in 0..60 {
        let case = Case::new(seed);
        let (triangle, corners, surface, map) = case.arguments::<f64>();
        let (_, pullback) = mapped_normal::vjp::<f64>(triangle, corners, surface, map, true);
        let (triangle, corners, surface, map, ()) = pullback(seed_of);
        let [a, b, c] = [triangle.a, triangle.b, triangle.c];
        let texel: DVec3 = map.footprint.texels.into_iter().sum();
        let vectors = [a, b, c].into_iter().flat_map(|v| v.to_array());
        let uvs = corners.into_iter().flat_map(|uv| [uv.u, uv.v]);
        let rest = [surface.normal, surface.view, texel].into_iter().flat_map(|v| v.to_array());
        let found: Vec<f64> = vectors.chain(uvs).chain(rest).chain([map.scale]).collect();
        assert_eq!(found.len(), Case::NUMBERS);
        let size = found.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (index, found) in found.into_iter().enumerate() {
            let at = |by: f64| {
                let mut moved = case;
                *moved.number(index) += by;
                moved.bent().dot(seed_of)
            };
            let step = 1e-4;
            let expected =
                (8.0 * (at(step) - at(-step)) - (at(2.0 * step) - at(-2.0 * step))) / (12.0 * step);
            let error = (found - expected).abs();
            assert!(error <= 1e-6 * size.max(1.0), "{seed} {index}: {found}, expected {expected}");
        }
    }
}

#[test]
fn maps_without_a_frame_or_a_direction_bend_nothing() {
    let case = Case::new(2);
    let [a, b, _] = case.uvs;
    let line = [a, b, 0.3 * a + 0.7 * b];
    for uvs in [[a; 3], [a, b, b], [DVec2::ZERO, dvec2(1.0, 2.0), dvec2(2.0, 4.0)]] {
        assert_eq!(Case { uvs, ..case }.bent(), case.normal);
    }
    // Rounding may leave an area.
    assert!(Case { uvs: line, ..case }.bent().is_normalized());
    let texel = DVec3::splat(0.5);
    assert_eq!(Case { texel, ..case }.bent(), case.normal);
    let texel = dvec3(0.5, 0.5, 1.0);
    assert!((Case { texel, ..case }.bent() - case.normal).length() < 1e-15);
    let (triangle, corners, surface, map) = case.arguments::<f64>();
    assert_eq!(mapped_normal::<f64>(triangle, corners, surface, map, false), case.normal);
    // Straight away from the viewer.
    let away = Case { view: case.normal, texel: dvec3(0.5, 0.5, 0.0), ..case };
    assert!(away.bent().is_normalized());
}

/// What a triangle says does not depend on its size.
#[test]
fn single_precision_holds_at_every_size() {
    for seed in 0..40 {
        let case = Case::new(seed);
        let expected = case.bent();
        for (size, of_uvs) in [(1e-17, 1.0), (1.0, 1e5), (1e17, 1e-5), (1e17, 1e5), (1e-17, 1e-5)] {
            let corners = case.corners.map(|corner| corner * size);
            let uvs = case.uvs.map(|uv| uv * of_uvs);
            let (triangle, corners, surface, map) =
                Case { corners, uvs, ..case }.arguments::<f32>();
            let found = mapped_normal::<f32>(triangle, corners, surface, map, true).as_dvec3();
            assert!((found - expected).length() < 1e-3, "{seed} {size}: {found} {expected}");
        }
    }
}

#[test]
fn rounded_normals_are_close_to_bent_ones() {
    for seed in 0..100 {
        let case = Case::new(seed);
        let bent = case.independent();
        for (width, most) in [(1.0, 0.028), (0.05, 0.05 * 0.11), (1e-4, 1e-4 * 0.11)] {
            let rounded = rounded_normal::<f64>(case.normal, bent, width);
            assert!(rounded.is_normalized() && rounded.distance(bent) < most, "{seed} {width}");
        }
        assert_eq!(rounded_normal::<f64>(DVec3::X, DVec3::X, 1.0), DVec3::X);
    }
}
