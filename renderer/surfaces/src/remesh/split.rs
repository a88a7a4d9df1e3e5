//! Long edges in two.

use super::surface::{Edge, Side, Surface};

/// Splits edges until none is longer than `longest`, the longest first: then triangles become rounder.
pub(super) fn split_long(surface: &mut Surface, longest: f64) {
    loop {
        let lengths = surface.edges().into_iter().map(|edge| (surface.length(edge), edge));
        let mut long: Vec<_> = lengths.filter(|(length, _)| *length > longest).collect();
        long.sort_by(|one, other| other.0.total_cmp(&one.0).then(one.1.cmp(&other.1)));
        // An edge vanishes by its own split alone.
        if !long.into_iter().fold(false, |any, (_, edge)| split(surface, edge) || any) {
            return;
        }
    }
}

/// Splits an edge in its middle; `false` if that may not be. Next to a longer edge it may not: where that cannot be split
/// either, there would be no end to it.
fn split(surface: &mut Surface, [a, b]: [u32; 2]) -> bool {
    let (sides, is_fixed) = match surface.edge(a, b) {
        Edge::Inner(one, other) => ([Some(one), Some(other)], false),
        Edge::Line(one, other) => ([Some(one), other], true),
        Edge::Other => return false,
    };
    let length = surface.length([a, b]);
    let mut apexes = sides.iter().flatten().map(|side| side.apex);
    if apexes.any(|apex| surface.length([a, apex]).max(surface.length([b, apex])) > length) {
        return false;
    }
    let [start, end] = [a, b].map(|vertex| surface.points[vertex as usize]);
    let between = start.midpoint(end);
    if between == start || between == end {
        return false;
    }
    let middle = surface.add_middle(a, b, is_fixed);
    for Side { triangle, .. } in sides.into_iter().flatten() {
        let half = surface.triangles[triangle as usize]
            .map(|corner| if corner == a { middle } else { corner });
        surface.replace(triangle, b, middle);
        surface.add(half, triangle);
    }
    true
}
