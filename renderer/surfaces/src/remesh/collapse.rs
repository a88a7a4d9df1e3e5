//! Short edges to points.

use glam::DVec3;

use super::surface::{Edge, LEAST_WIDTH, Surface, are_alike, middle, normal, width};

/// Collapses edges shorter than `shortest`, the shortest first, as long as no edge becomes longer than `longest`.
pub(super) fn collapse_short(surface: &mut Surface, shortest: f64, longest: f64) {
    loop {
        let lengths = surface.edges().into_iter().map(|edge| (surface.length(edge), edge));
        let mut short: Vec<_> = lengths.filter(|(length, _)| *length < shortest).collect();
        short.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        let collapse = |surface: &mut Surface, edge| {
            surface.length(edge) < shortest && collapse(surface, edge, longest)
        };
        if !short.into_iter().fold(false, |any, (_, edge)| collapse(surface, edge) || any) {
            return;
        }
    }
}

/// Makes one vertex of the two of an edge; `false` if that may not be.
fn collapse(surface: &mut Surface, [a, b]: [u32; 2], longest: f64) -> bool {
    let (gone, stays, place) = match [a, b].map(|vertex| surface.is_fixed[vertex as usize]) {
        [true, true] => return false,
        [true, false] => (b, a, surface.points[a as usize]),
        [false, true] => (a, b, surface.points[b as usize]),
        [false, false] => (b, a, closest_to_planes(surface, [a, b])),
    };
    let Edge::Inner(one, other) = surface.edge(gone, stays) else { return false };
    if !keeps_topology(surface, gone, stays, [one.apex, other.apex])
        || !keeps_shape(surface, [gone, stays], place, longest)
    {
        return false;
    }
    surface.remove(one.triangle);
    surface.remove(other.triangle);
    for triangle in surface.around(gone).to_vec() {
        surface.replace(triangle, gone, stays);
    }
    if !surface.is_fixed[stays as usize] {
        surface.origins[stays as usize] =
            middle(&surface.origins[stays as usize], &surface.origins[gone as usize]);
    }
    surface.points[stays as usize] = place;
    true
}

/// Of the ends of an edge and its middle the place closest to the planes of the triangles around, by the sum of squared
/// distances weighted with areas (Garland and Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997): corners
/// stay.
fn closest_to_planes(surface: &Surface, ends: [u32; 2]) -> DVec3 {
    let [a, b] = ends.map(|end| surface.points[end as usize]);
    let distance = |place: DVec3| -> f64 {
        let planes = ends
            .iter()
            .flat_map(|&end| surface.around(end).iter().map(move |&triangle| (end, triangle)));
        let square = |(end, triangle): (u32, u32)| {
            let normal = surface.normal(triangle);
            let off = normal.normalize_or_zero().dot(place - surface.points[end as usize]);
            normal.length() * off * off
        };
        planes.map(square).sum()
    };
    // Of equals the first: in a plane the middle.
    let places = [a.midpoint(b), a, b];
    let closer = |one: (f64, DVec3), place: DVec3| {
        let other = distance(place);
        if other < 0.999 * one.0 { (other, place) } else { one }
    };
    places.into_iter().fold((f64::INFINITY, places[0]), closer).1
}

/// Whether no other parts of the surface grow together: both ends share no neighbours but those across the edge
/// (Dey, Edelsbrunner, Guha and Nekhayev, "Topology Preserving Edge Contraction", 1999), and no triangle comes to lie on
/// another.
fn keeps_topology(surface: &Surface, gone: u32, stays: u32, apexes: [u32; 2]) -> bool {
    let neighbours = surface.neighbours(stays);
    let is_shared = |vertex: &u32| neighbours.binary_search(vertex).is_ok();
    if surface
        .neighbours(gone)
        .iter()
        .filter(|vertex| is_shared(vertex))
        .any(|vertex| !apexes.contains(vertex))
    {
        return false;
    }
    let others = |vertex: u32| {
        let corners =
            surface.around(vertex).iter().map(|&triangle| surface.triangles[triangle as usize]);
        corners.filter(move |corners| !(corners.contains(&gone) && corners.contains(&stays)))
    };
    let sorted = |mut corners: [u32; 3]| {
        corners.sort_unstable();
        corners
    };
    let staying: Vec<_> = others(stays).map(sorted).collect();
    !others(gone)
        .map(|corners| sorted(corners.map(|corner| if corner == gone { stays } else { corner })))
        .any(|moved| staying.contains(&moved))
}

/// Whether with both ends at a place no triangle around turns over or becomes narrow, a surface without folds gets
/// none, and no edge becomes longer than `longest`.
fn keeps_shape(surface: &Surface, [gone, stays]: [u32; 2], place: DVec3, longest: f64) -> bool {
    let mut around = [gone, stays].map(|end| surface.around(end)).concat();
    around.sort_unstable();
    around.dedup();
    let before: Vec<[u32; 3]> =
        around.iter().map(|&triangle| surface.triangles[triangle as usize]).collect();
    let others =
        before.iter().filter(|corners| !(corners.contains(&gone) && corners.contains(&stays)));
    let after: Vec<[u32; 3]> = others
        .clone()
        .map(|corners| corners.map(|corner| if corner == gone { stays } else { corner }))
        .collect();
    let region: DVec3 = before.iter().map(|&corners| surface.normal_of(corners)).sum();
    let then = |corner: u32| if corner == stays { place } else { surface.points[corner as usize] };
    others.zip(&after).all(|(&corners, moved)| {
        let [a, b, c] = moved.map(then);
        let (before, after) = (surface.normal_of(corners), normal([a, b, c]));
        // What had no area turns no way, but to that of its neighbours.
        let before = if before == DVec3::ZERO { region } else { before };
        let lengths = [a.distance(b), b.distance(c), c.distance(a)];
        are_alike(before, after)
            && width([a, b, c]) >= width(surface.places(corners)).min(LEAST_WIDTH)
            && lengths.iter().all(|&length| length <= longest)
    }) && !surface.adds_folds(&around, &after, then)
}
