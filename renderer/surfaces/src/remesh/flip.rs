//! Edges to the other diagonal.

use super::surface::{Edge, LEAST_WIDTH, Side, Surface, are_alike, width};

/// Flips edges where that brings the vertices of both triangles closer to six neighbours, or four on a border.
pub(super) fn even_out(surface: &mut Surface) {
    for [a, b] in surface.edges() {
        if let Edge::Inner(one, other) = surface.edge(a, b) {
            flip(surface, [a, b], one, other);
        }
    }
}

/// Flips an edge from `a` to `b`, if that is better.
fn flip(surface: &mut Surface, [a, b]: [u32; 2], one: Side, other: Side) {
    let (c, d) = (one.apex, other.apex);
    let [now_a, now_b, now_c, now_d] = [a, b, c, d].map(|vertex| surplus(surface, vertex));
    let squares =
        |surpluses: [isize; 4]| surpluses.iter().map(|surplus| surplus * surplus).sum::<isize>();
    if squares([now_a - 1, now_b - 1, now_c + 1, now_d + 1])
        >= squares([now_a, now_b, now_c, now_d])
    {
        return;
    }
    if surface.around(c).iter().any(|&triangle| surface.triangles[triangle as usize].contains(&d)) {
        return;
    }
    let before = [one, other].map(|side| surface.normal(side.triangle));
    let flipped = [[a, d, c], [d, b, c]];
    let after = flipped.map(|corners| surface.normal_of(corners));
    let least = [[a, b, c], [a, b, d]].map(|corners| width(surface.places(corners)));
    let least = least[0].min(least[1]).min(LEAST_WIDTH);
    if flipped.iter().any(|&corners| width(surface.places(corners)) < least) {
        return;
    }
    // Neither over a ridge nor out of the outline of the two triangles.
    if !are_alike(before[0], before[1])
        || after.iter().any(|after| !before.iter().all(|before| are_alike(*before, *after)))
    {
        return;
    }
    let place = |corner: u32| surface.points[corner as usize];
    if surface.adds_folds(&[one.triangle, other.triangle], &flipped, place) {
        return;
    }
    surface.replace(one.triangle, b, d);
    surface.replace(other.triangle, a, c);
}

/// How many neighbours more than it should a vertex has.
fn surplus(surface: &Surface, vertex: u32) -> isize {
    let triangles = surface.around(vertex).len() as isize;
    // On a border there is one neighbour more than triangles.
    let is_border =
        surface.is_fixed[vertex as usize] && surface.neighbours(vertex).len() as isize > triangles;
    triangles - if is_border { 3 } else { 6 }
}
