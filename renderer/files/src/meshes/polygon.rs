//! Polygons, cut into triangles.

use glam::DVec3;

/// A polygon that is not convex may have so many corners: cutting it up takes long.
const MOST_CORNERS: usize = 1000;

/// Cuts a polygon into triangles, three indices into `corners` each: a fan if it is convex,
/// otherwise ear by ear (Meisters, "Polygons have ears", 1975), in time cubic in the number of
/// corners at worst. Corners may share a place, as where an edge leads to a hole and back. What is
/// no simple polygon, or is not flat, is cut somehow; there are always two triangles fewer than
/// corners.
///
/// # Errors
///
/// If the polygon is not convex and has more than 1000 corners.
pub(crate) fn triangulate(corners: &[DVec3]) -> Result<Vec<[usize; 3]>, String> {
    let n = corners.len();
    let normal = normal(corners);
    let turns_left = |[a, b, c]: [usize; 3]| {
        (corners[b] - corners[a]).cross(corners[c] - corners[b]).dot(normal) >= 0.0
    };
    let convex = n <= 3 || (0..n).all(|i| turns_left([i, (i + 1) % n, (i + 2) % n]));
    if convex {
        return Ok((2..n).map(|i| [0, i - 1, i]).collect());
    }
    if n > MOST_CORNERS {
        return Err(format!(
            "a face of {n} corners is not convex; such ones may have {MOST_CORNERS}"
        ));
    }
    let mut triangles = Vec::with_capacity(n - 2);
    let mut left: Vec<usize> = (0..n).collect();
    while left.len() > 3 {
        let m = left.len();
        let triangle = |i: usize| [left[(i + m - 1) % m], left[i], left[(i + 1) % m]];
        let is_ear = |&i: &usize| {
            let ear = triangle(i);
            let inside = |&p: &usize| {
                !ear.iter().any(|&corner| corners[corner] == corners[p])
                    && within(corners, ear, normal, p)
            };
            turns_left(ear) && !left.iter().any(inside)
        };
        // Every simple polygon has an ear; of another one any corner will do.
        let ear = (0..m).find(is_ear).unwrap_or(1);
        triangles.push(triangle(ear));
        left.remove(ear);
    }
    triangles.push([left[0], left[1], left[2]]);
    Ok(triangles)
}

/// The direction that the polygon faces (Newell's method); its length is twice the area.
fn normal(corners: &[DVec3]) -> DVec3 {
    let Some(&origin) = corners.first() else { return DVec3::ZERO };
    let edges = corners.windows(2);
    edges.map(|edge| (edge[0] - origin).cross(edge[1] - origin)).sum()
}

/// Whether the corner `p` is in or on the triangle, seen along the normal.
fn within(corners: &[DVec3], [a, b, c]: [usize; 3], normal: DVec3, p: usize) -> bool {
    let side = |from: usize, to: usize| {
        (corners[to] - corners[from]).cross(corners[p] - corners[from]).dot(normal)
    };
    side(a, b) >= 0.0 && side(b, c) >= 0.0 && side(c, a) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(corners: &[DVec3], [a, b, c]: [usize; 3]) -> f64 {
        0.5 * (corners[b] - corners[a]).cross(corners[c] - corners[a]).z
    }

    fn plane(corners: &[(f64, f64)]) -> Vec<DVec3> {
        corners.iter().map(|&(x, y)| DVec3::new(x, y, 3.0)).collect()
    }

    #[test]
    fn triangles_cover_the_polygon_once() {
        let polygons: [&[(f64, f64)]; 5] = [
            &[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)],
            // An arrow head, its notch at each of the corners.
            &[(0.0, 0.0), (2.0, -1.0), (0.5, 0.0), (2.0, 1.0)],
            &[(0.5, 0.0), (2.0, 1.0), (0.0, 0.0), (2.0, -1.0)],
            // A comb, and one with corners on a line.
            &[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (3.0, 1.0), (2.0, 3.0), (1.0, 1.0), (0.0, 3.0)],
            &[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (2.0, 2.0), (1.0, 1.0), (0.0, 2.0), (0.0, 1.0)],
        ];
        for polygon in polygons {
            for turn in 0..polygon.len() {
                let mut corners = plane(polygon);
                corners.rotate_left(turn);
                for mirrored in [false, true] {
                    if mirrored {
                        corners.iter_mut().for_each(|corner| corner.x = -corner.x);
                    }
                    let triangles = triangulate(&corners).unwrap();
                    assert_eq!(triangles.len(), corners.len() - 2);
                    let areas = triangles.iter().map(|&t| area(&corners, t));
                    let sum: f64 = areas.clone().sum();
                    let absolute: f64 = areas.map(f64::abs).sum();
                    let whole = 0.5 * normal(&corners).z;
                    assert!((sum - whole).abs() < 1e-12, "{corners:?}: {sum} {whole}");
                    assert!((absolute - whole.abs()).abs() < 1e-12, "{corners:?}: {triangles:?}");
                }
            }
        }
    }

    /// A square with a square hole, to which an edge leads and back: two places are corners twice.
    #[test]
    fn a_hole_stays_open() {
        let corners = plane(&[
            (0.0, 0.0),
            (4.0, 0.0),
            (4.0, 4.0),
            (0.0, 4.0),
            (0.0, 0.0),
            (1.0, 1.0),
            (1.0, 3.0),
            (3.0, 3.0),
            (3.0, 1.0),
            (1.0, 1.0),
        ]);
        for turn in 0..corners.len() {
            let mut corners = corners.clone();
            corners.rotate_left(turn);
            let triangles = triangulate(&corners).unwrap();
            let areas = triangles.iter().map(|&t| area(&corners, t));
            assert_eq!(areas.clone().sum::<f64>(), 12.0);
            assert_eq!(areas.map(f64::abs).sum::<f64>(), 12.0, "{corners:?}: {triangles:?}");
            let middle = |t: &[usize; 3]| t.iter().map(|&i| corners[i]).sum::<DVec3>() / 3.0;
            let in_hole = |m: DVec3| (1.0..3.0).contains(&m.x) && (1.0..3.0).contains(&m.y);
            assert!(!triangles.iter().any(|t| area(&corners, *t) > 0.0 && in_hole(middle(t))));
        }
    }

    #[test]
    fn long_polygons_are_fans_or_refused() {
        let circle = |radius: fn(usize) -> f64| -> Vec<DVec3> {
            let corner =
                |i: usize| glam::DVec2::from_angle(i as f64 / 1000.0).extend(0.0) * radius(i);
            (0..6000).map(corner).collect()
        };
        assert_eq!(triangulate(&circle(|_| 2.0)).unwrap().len(), 5998);
        let star = triangulate(&circle(|i| 1.0 + (i % 2) as f64)).unwrap_err();
        assert_eq!(star, "a face of 6000 corners is not convex; such ones may have 1000");
    }

    #[test]
    fn what_is_no_polygon_is_cut_somehow() {
        let inf = 1e300;
        let cases: [&[(f64, f64)]; 4] = [
            &[(1.0, 1.0); 6],
            &[(0.0, 0.0), (1.0, 1.0), (1.0, 0.0), (0.0, 1.0)],
            &[(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (1.0, 0.0), (3.0, 0.0)],
            &[(inf, -inf), (-inf, inf), (inf, inf), (-inf, -inf), (0.0, 0.0)],
        ];
        for case in cases {
            assert_eq!(triangulate(&plane(case)).unwrap().len(), case.len() - 2);
        }
    }
}
