//! Areas of polygons of a few corners.

/// A point of the image, in pixels.
pub type Point = [f64; 2];

/// The area of a polygon in one quadrant, that of positive coordinates where `signs` are 1 and that of negative ones
/// where they are -1; negative if its corners run the other way round.
///
/// Pushed to the closest points of the quadrant, the polygon's border encloses that area, and what lies on an
/// axis then adds nothing to the integral of x dy along it (Green's theorem): only the parts of its sides within count.
pub fn area_in_quadrant(corners: &[Point], signs: [f64; 2]) -> f64 {
    let in_quadrant = |&[x, y]: &Point| [signs[0] * x, signs[1] * y];
    let Some(mut before) = corners.last().map(in_quadrant) else { return 0.0 };
    let mut area = 0.0;
    for to in corners.iter().map(in_quadrant) {
        let from = std::mem::replace(&mut before, to);
        let (mut start, mut end) = (0.0_f64, 1.0_f64);
        for (from, to) in from.into_iter().zip(to) {
            match (from < 0.0, to < 0.0) {
                (false, false) => {}
                (true, true) => end = 0.0,
                (true, false) => start = start.max(from / (from - to)),
                (false, true) => end = end.min(from / (from - to)),
            }
        }
        if start < end {
            let middle = 0.5 * (start + end);
            area += (from[0] + middle * (to[0] - from[0])) * (end - start) * (to[1] - from[1]);
        }
    }
    signs[0] * signs[1] * area
}
