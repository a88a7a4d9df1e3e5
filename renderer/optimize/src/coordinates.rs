//! Coordinates without bounds, for methods that know of none.

use renderer_core::Error;

use super::variable::Flat;
use super::{Scale, Variable};

/// No start is closer to a bound than this, in learning rates: on the bound itself the map is
/// flat, and no gradient leads away.
const MARGIN: f64 = 1e-3;

/// A smooth map from all real vectors onto the box that the bounds of variables are, as in MINUIT
/// (James and Roos, Computer Physics Communications 10, 1975): what has no bound is shifted and
/// scaled, what has one goes through a hyperbola, what has two goes through a sine.
///
/// One unit is one learning rate where no bound is near, so that parameters of different units
/// become comparable. On a logarithmic [`Scale`] all of this is of the logarithms.
///
/// Of the ways to keep an unbounded method within bounds this is the one that leaves it alone:
/// projecting its points would put a kink into the loss that its line search sees, and the
/// curvature that it learns across the kink is wrong. The price: on a bound the map is flat, so a
/// minimum there is approached, not jumped to, and a start on a bound has to be moved off it by a
/// thousandth of a learning rate.
#[derive(Clone, Debug)]
pub struct Coordinates {
    elements: Vec<Element>,
}

/// From a coordinate to an element: first to its place on its scale, then to the number.
#[derive(Clone, Copy, Debug)]
struct Element {
    map: Map,
    scale: Scale,
    lowest: f64,
    highest: f64,
}

/// The map of one element.
#[derive(Clone, Copy, Debug)]
enum Map {
    /// `origin + unit u`
    Free { origin: f64, unit: f64 },
    /// `bound + unit (sqrt(u^2 + 1) - 1)`; a negative unit for an upper bound.
    OneSided { bound: f64, unit: f64 },
    /// `middle + half sin(u unit / half)`
    TwoSided { middle: f64, half: f64, unit: f64 },
    /// The only value there is.
    Fixed(f64),
}

impl Coordinates {
    /// Coordinates for the elements of variables, one after the other.
    ///
    /// # Errors
    ///
    /// If the variables are not fit to be optimised; the place is the path.
    pub fn new(variables: &[Variable]) -> Result<Self, Error> {
        Ok(Self::of(&Flat::new(variables)?))
    }

    pub(super) fn of(flat: &Flat) -> Self {
        let element = |i: usize| {
            let scale = flat.scale[i];
            let [x, min, max] = [flat.x[i], flat.min[i], flat.max[i]].map(|x| scale.place(x));
            let map = Map::new(x, flat.learning_rate[i], min, max);
            Element { map, scale, lowest: flat.lowest(i), highest: flat.max[i] }
        };
        Self { elements: (0..flat.x.len()).map(element).collect() }
    }

    /// The coordinates of `x`, which is moved off its bounds.
    pub fn from_bounded(&self, x: &[f64]) -> Vec<f64> {
        self.elements.iter().zip(x).map(|(of, &x)| of.map.inverse(of.scale.place(x))).collect()
    }

    /// The elements at the coordinates `u`, none of them out of bounds.
    pub fn to_bounded(&self, u: &[f64]) -> Vec<f64> {
        self.elements.iter().zip(u).map(|(of, &u)| of.value(u)).collect()
    }

    /// The gradient by the coordinates, from that by the elements.
    pub fn pull_back(&self, u: &[f64], gradient: &[f64]) -> Vec<f64> {
        let slopes = self.elements.iter().zip(u).map(|(of, &u)| of.slope(u));
        slopes.zip(gradient).map(|(slope, g)| slope * g).collect()
    }
}

impl Element {
    fn value(self, u: f64) -> f64 {
        match self.scale {
            Scale::Linear => self.map.value(u),
            // The exponential of the logarithm of a bound may be across it.
            Scale::Log => Scale::Log.number(self.map.value(u)).clamp(self.lowest, self.highest),
        }
    }

    fn slope(self, u: f64) -> f64 {
        self.scale.slope(self.value(u)) * self.map.slope(u)
    }
}

impl Map {
    fn new(x: f64, unit: f64, min: f64, max: f64) -> Self {
        let half = 0.5 * max - 0.5 * min;
        match (min > f64::NEG_INFINITY, max < f64::INFINITY) {
            (false, false) => Self::Free { origin: x, unit },
            (true, false) => Self::OneSided { bound: min, unit },
            (false, true) => Self::OneSided { bound: max, unit: -unit },
            (true, true) if half > 0.0 => {
                Self::TwoSided { middle: min.midpoint(max), half, unit: unit.min(half) }
            }
            (true, true) => Self::Fixed(min),
        }
    }

    fn value(self, u: f64) -> f64 {
        match self {
            Self::Free { origin, unit } => origin + unit * u,
            // sqrt(u^2 + 1) - 1 without the cancellation.
            Self::OneSided { bound, unit } => bound + unit * (u / (u.hypot(1.0) + 1.0) * u),
            Self::TwoSided { middle, half, unit } => {
                let x = middle + half * (u * (unit / half)).sin();
                // Rounding must not carry a value across its bound.
                x.clamp(middle - half, middle + half)
            }
            Self::Fixed(x) => x,
        }
    }

    fn slope(self, u: f64) -> f64 {
        match self {
            Self::Free { unit, .. } => unit,
            Self::OneSided { unit, .. } => unit * (u / u.hypot(1.0)),
            Self::TwoSided { half, unit, .. } => unit * (u * (unit / half)).cos(),
            Self::Fixed(_) => 0.0,
        }
    }

    fn inverse(self, x: f64) -> f64 {
        match self {
            Self::Free { origin, unit } => (x - origin) / unit,
            Self::OneSided { bound, unit } => {
                let distance = ((x - bound) / unit).max(MARGIN);
                (distance * (distance + 2.0)).sqrt()
            }
            Self::TwoSided { middle, half, unit } => {
                let most = 1.0 - MARGIN * (unit / half);
                let sine = ((x - middle) / half).clamp(-most, most);
                sine.asin() * (half / unit)
            }
            Self::Fixed(_) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const INF: f64 = f64::INFINITY;

    fn coordinates(x: f64, unit: f64, min: f64, max: f64) -> Coordinates {
        scaled(Scale::Linear, x, unit, min, max)
    }

    fn scaled(scale: Scale, x: f64, unit: f64, min: f64, max: f64) -> Coordinates {
        let variable = Variable::new("x", vec![x], unit).bounded(min, max);
        Coordinates::new(&[Variable { scale, ..variable }]).unwrap()
    }

    #[test]
    fn on_a_logarithmic_scale_a_unit_is_a_factor() {
        for (min, max) in [(-INF, INF), (0.0, INF), (1e-4, INF), (0.0, 9.0), (1e-4, 9.0)] {
            let coordinates = scaled(Scale::Log, 3.0, 0.2, min, max);
            let value = |u: f64| coordinates.to_bounded(&[u])[0];
            let start = coordinates.from_bounded(&[3.0])[0];
            assert!((value(start) - 3.0).abs() < 1e-12, "{min} {max}");
            for u in [start, start - 2.0, start + 0.7, -1e4, 1e4] {
                assert!(value(u) > 0.0 && value(u) >= min && value(u) <= max, "{min} {max} {u}");
            }
            for u in [start, start - 2.0, start + 0.7] {
                let difference = (value(u + 1e-6) - value(u - 1e-6)) / 2e-6;
                let slope = coordinates.pull_back(&[u], &[1.0])[0];
                assert!((slope - difference).abs() < 1e-8, "{min} {max} {u}: {slope} {difference}");
            }
            if min <= 0.0 && max == INF {
                assert!((value(start + 1.0) / 3.0 - 0.2_f64.exp()).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn there_and_back() {
        for (min, max) in [(-INF, INF), (-1.0, INF), (-INF, 9.0), (-1.0, 9.0), (2.0, 4.0)] {
            for unit in [1e-3, 0.5, 100.0] {
                let coordinates = coordinates(3.0, unit, min, max);
                let u = coordinates.from_bounded(&[3.0]);
                let x = coordinates.to_bounded(&u)[0];
                assert!((x - 3.0).abs() < 1e-12, "{min} {max} {unit}: {x}");
            }
        }
    }

    #[test]
    fn every_coordinate_is_within_bounds() {
        for (min, max) in [(-1.0, INF), (-INF, 9.0), (-1.0, 9.0), (0.1, 0.3), (3.0, 3.0)] {
            let start = 3.0_f64.clamp(min, max);
            let coordinates = coordinates(start, 0.7, min, max);
            for u in [-1e300, -1e3, -3.0, -1e-9, 0.0, 0.1, 2.0, 5e8, 1e300] {
                let x = coordinates.to_bounded(&[u])[0];
                assert!((min..=max).contains(&x), "{min} {max} {u}: {x}");
            }
        }
    }

    #[test]
    fn slopes_are_those_of_the_map() {
        for (min, max) in [(-INF, INF), (-1.0, INF), (-INF, 9.0), (-1.0, 9.0), (3.0, 3.0)] {
            let coordinates = coordinates(3.0, 0.7, min, max);
            for u in [-2.0, -0.3, 0.0, 0.4, 3.0] {
                let value = |u: f64| coordinates.to_bounded(&[u])[0];
                let difference = (value(u + 1e-6) - value(u - 1e-6)) / 2e-6;
                let slope = coordinates.pull_back(&[u], &[1.0])[0];
                assert!((slope - difference).abs() < 1e-8, "{min} {max} {u}: {slope} {difference}");
            }
        }
    }

    #[test]
    fn a_start_on_a_bound_can_leave_it() {
        for (x, min, max) in [(0.0, 0.0, INF), (0.0, -INF, 0.0), (0.0, 0.0, 5.0), (5.0, 0.0, 5.0)] {
            let coordinates = coordinates(x, 0.1, min, max);
            let u = coordinates.from_bounded(&[x]);
            let moved = (coordinates.to_bounded(&u)[0] - x).abs();
            assert!((0.99e-4..1.01e-4).contains(&moved), "{min} {max}: {moved}");
            assert!(coordinates.pull_back(&u, &[1.0])[0].abs() > 0.005 * 0.1);
        }
    }
}
