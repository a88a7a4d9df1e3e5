//! Where camera rays meet the image plane, in the coordinates of
//! [`film_point`](crate::transport::camera::film_point()).

use ad::Real;
use ad::lanes::Lanes;

use super::integrator::Integrator;
use crate::number::Number;
use crate::trace::sampling::Offsets;
use crate::trace::tile::Tile;

impl<S: Number> Integrator<'_, S> {
    /// Where the rays from `first` on meet the image plane.
    #[inline]
    pub fn film(
        &self,
        tile: &Tile,
        offsets: Option<&Offsets>,
        first: usize,
    ) -> (S::Lanes, S::Lanes) {
        let position = |middle: S::Lanes, axis: usize, start: usize, size: u32| {
            // In halves of pixels from the middle of the image: whole numbers for middles of pixels,
            // so exact.
            let start = S::Lanes::from_f64(2.0 * start as f64 + 1.0 - f64::from(size));
            let within = offsets.map_or(S::Lanes::ZERO, |offsets| {
                S::Lanes::from_lanes(|lane| {
                    Real::from_f64(2.0 * f64::from(offsets[axis][first + lane]))
                })
            });
            (middle + start + within) * S::Lanes::from_f64(1.0 / f64::from(size))
        };
        let (x, y) = self.film_offsets[first / <S::Lanes as Lanes>::COUNT];
        let (width, height) = (self.layout.width, self.layout.height);
        (position(x, 0, tile.left, width), -position(y, 1, tile.top, height))
    }
}

/// The points of the film from `first` on; beyond the last, that one again.
pub fn film_lanes<L: Lanes>(points: &[[f64; 2]], first: usize) -> (L, L) {
    let along = |axis: usize| {
        L::from_lanes(|lane| {
            let point = points.get(first + lane).or(points.last());
            Real::from_f64(point.map_or(0.0, |point| point[axis]))
        })
    };
    (along(0), along(1))
}
