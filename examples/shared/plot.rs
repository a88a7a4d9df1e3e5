//! Curves against a linear or a logarithmic axis, as SVG.

use std::path::Path;

use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, ValueFormatter};
use plotters::prelude::*;
use renderer::Error;
use renderer::palette::CurveColors;

/// Width and height in pixels.
const SIZE: (u32, u32) = (900, 540);

/// One curve.
pub struct Curve {
    /// Its name in the legend.
    pub label: String,
    pub points: Vec<Point>,
}

/// One point of a curve. What is not positive cannot be shown on a logarithmic axis and is left out.
pub struct Point {
    pub x: f64,
    pub y: f64,
    /// The standard deviation of `y`, drawn as a bar; 0 if there is none.
    pub deviation: f64,
}

/// What is on the horizontal axis.
pub struct Horizontal<'a> {
    pub title: &'a str,
    pub is_logarithmic: bool,
}

/// Draws curves over a logarithmic vertical axis.
///
/// # Errors
///
/// If the file cannot be written.
pub fn save_plot(
    path: &Path,
    caption: &str,
    horizontal: Horizontal<'_>,
    vertical: &str,
    curves: &[Curve],
) -> Result<(), Error> {
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    let points = || curves.iter().flat_map(|curve| &curve.points).filter(|point| point.y > 0.0);
    let (left, right) = extent(points().map(|point| point.x));
    let Horizontal { title, is_logarithmic } = horizontal;
    let drawn = if is_logarithmic {
        draw(&area, caption, (left..right).log_scale(), title, vertical, curves)
    } else {
        draw(&area, caption, left..right, title, vertical, curves)
    };
    drawn.map_err(|error| Error::new(path.display(), error))
}

fn draw<X>(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    caption: &str,
    horizontal: X,
    title: &str,
    vertical: &str,
    curves: &[Curve],
) -> Result<(), Box<dyn std::error::Error>>
where
    X: AsRangedCoord<Value = f64>,
    X::CoordDescType: ValueFormatter<f64>,
{
    let heights = curves.iter().flat_map(|curve| &curve.points).map(|point| point.y);
    let (low, high) = extent(heights.filter(|&y| y > 0.0));
    // Room for the legend above the curves.
    let top = 1.5 * high * (high / low).powf(0.07 * curves.len() as f64);
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(area)
        .margin(16)
        .margin_right(48)
        .caption(caption, ("sans-serif", 18))
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(horizontal, (low / 1.5..top).log_scale())?;
    chart
        .configure_mesh()
        .x_desc(title)
        .y_desc(vertical)
        .x_label_formatter(&|x| format!("{x}"))
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 15))
        .bold_line_style(RGBColor(220, 220, 220))
        .light_line_style(TRANSPARENT)
        .draw()?;
    for (index, curve) in curves.iter().enumerate() {
        let color = CurveColors::pick(index).to_rgba();
        let points = || curve.points.iter().filter(|point| point.y > 0.0);
        let line = LineSeries::new(points().map(|p| (p.x, p.y)), color.stroke_width(2));
        chart
            .draw_series(line)?
            .label(&curve.label)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2)));
        let bar = |p: &Point| {
            // A bar that would reach below 0 ends at the lower edge.
            let lowest = (p.y - p.deviation).max(low / 1.5);
            PathElement::new([(p.x, lowest), (p.x, p.y + p.deviation)], color)
        };
        chart.draw_series(points().filter(|point| point.deviation > 0.0).map(bar))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.8))
        .border_style(RGBColor(180, 180, 180))
        .label_font(("sans-serif", 14))
        .draw()?;
    area.present()?;
    Ok(())
}

/// The least and the largest of some numbers.
fn extent(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    numbers.fold((f64::MAX, f64::MIN_POSITIVE), |(low, high), x| (low.min(x), high.max(x)))
}
