//! Colours for plots.

use plotters::style::Palette;

/// Colours of curves that can be told apart on white. Turned down: plotters' `Palette99`, of whose
/// first eight colours yellow and cyan can hardly be seen there.
pub struct CurveColors;

impl Palette for CurveColors {
    const COLORS: &'static [(u8, u8, u8)] = &[
        (31, 119, 180),
        (214, 39, 40),
        (44, 160, 44),
        (255, 127, 14),
        (148, 103, 189),
        (140, 86, 75),
        (23, 190, 207),
        (110, 110, 110),
    ];
}
