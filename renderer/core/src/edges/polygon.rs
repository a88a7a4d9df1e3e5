//! Polygons of a few corners.

/// A point of the image, in pixels.
pub type Point = [f64; 2];

/// The most corners of a polygon: a region of a cell has up to seven, and each cut may add half as many.
const MOST: usize = 16;

/// A polygon that is cut until little is left of it.
#[derive(Clone, Copy)]
pub struct Polygon {
    corners: [Point; MOST],
    count: usize,
}

impl Polygon {
    pub const EMPTY: Self = Self { corners: [[0.0; 2]; MOST], count: 0 };

    pub fn push(&mut self, corner: Point) {
        self.corners[self.count] = corner;
        self.count += 1;
    }

    fn corners(&self) -> &[Point] {
        &self.corners[..self.count]
    }

    /// The corners with those that follow them, the first one after the last one.
    fn sides(&self) -> impl Iterator<Item = (Point, Point)> {
        let corners = self.corners();
        let last = corners.last().copied();
        corners.iter().scan(last, |before, &corner| Some((before.replace(corner)?, corner)))
    }

    /// The area, negative if the corners run the other way round.
    pub fn area(&self) -> f64 {
        let Some(&[left, top]) = self.corners().first() else { return 0.0 };
        // Relative to a corner: differences of places in a large image would lose digits.
        let twice: f64 = (self.sides())
            .map(|(a, b)| (a[0] - left) * (b[1] - top) - (b[0] - left) * (a[1] - top))
            .sum();
        0.5 * twice
    }

    /// Whether a corner is beyond a border, as in [`clip`](Self::clip).
    pub fn reaches(&self, axis: usize, border: f64, above: bool) -> bool {
        self.corners()
            .iter()
            .any(|corner| if above { corner[axis] > border } else { corner[axis] < border })
    }

    /// The part whose coordinate `axis` is at least `border`, or at most if not `above` (Sutherland &
    /// Hodgman, "Reentrant Polygon Clipping", 1974).
    pub fn clip(&self, axis: usize, border: f64, above: bool) -> Self {
        let mut part = Self::EMPTY;
        let side = |point: &Point| if above { point[axis] - border } else { border - point[axis] };
        for (a, b) in self.sides() {
            let (of_a, of_b) = (side(&a), side(&b));
            if of_a * of_b < 0.0 {
                let at = of_a / (of_a - of_b);
                part.push([a[0] + (b[0] - a[0]) * at, a[1] + (b[1] - a[1]) * at]);
            }
            if of_b >= 0.0 {
                part.push(b);
            }
        }
        part
    }
}
