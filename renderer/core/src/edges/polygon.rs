//! Polygons of a few corners.

/// A point of the image, in pixels.
pub type Point = [f64; 2];

/// A polygon that is cut until little is left of it.
#[derive(Clone, Default)]
pub struct Polygon(Vec<Point>);

impl Polygon {
    pub fn clear(&mut self) {
        self.0.clear();
    }

    pub fn push(&mut self, corner: Point) {
        self.0.push(corner);
    }

    /// The area, negative if the corners run the other way round.
    pub fn area(&self) -> f64 {
        let Some(&[left, top]) = self.0.first() else { return 0.0 };
        // Relative to a corner: differences of places in a large image would lose digits.
        let next = self.0.iter().cycle().skip(1);
        let twice: f64 = (self.0.iter().zip(next))
            .map(|(a, b)| (a[0] - left) * (b[1] - top) - (b[0] - left) * (a[1] - top))
            .sum();
        0.5 * twice
    }

    /// Whether a corner is beyond a border, as in [`clip`](Self::clip).
    pub fn reaches(&self, axis: usize, border: f64, above: bool) -> bool {
        self.0
            .iter()
            .any(|corner| if above { corner[axis] > border } else { corner[axis] < border })
    }

    /// The part whose coordinate `axis` is at least `border`, or at most if not `above` (Sutherland &
    /// Hodgman, "Reentrant Polygon Clipping", 1974), written over `into`.
    pub fn clip(&self, axis: usize, border: f64, above: bool, into: &mut Self) {
        into.clear();
        let side = |point: &Point| if above { point[axis] - border } else { border - point[axis] };
        let next = self.0.iter().cycle().skip(1);
        for (a, b) in self.0.iter().zip(next) {
            let (of_a, of_b) = (side(a), side(b));
            if of_a >= 0.0 {
                into.push(*a);
            }
            if of_a * of_b < 0.0 {
                let part = of_a / (of_a - of_b);
                into.push([a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part]);
            }
        }
    }
}
