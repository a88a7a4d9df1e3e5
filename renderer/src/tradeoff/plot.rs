//! The plot of errors against times.

use plotters::prelude::*;

use super::axis::Axis;
use super::measurement::Measurement;
use super::table::pareto_front;
use crate::Error;

/// Width and height in pixels.
const SIZE: (u32, u32) = (900, 560);

/// Errors below are drawn here: rounding in double precision.
const LEAST_ERROR: f64 = 1e-16;

/// The axes that a plot tells apart, with their colours.
const COLORS: [(Axis, RGBColor); 6] = [
    (Axis::Arithmetic, RGBColor(31, 119, 180)),
    (Axis::Engine, RGBColor(214, 39, 40)),
    (Axis::Differences, RGBColor(150, 150, 150)),
    (Axis::Visibility, RGBColor(44, 160, 44)),
    (Axis::Tree, RGBColor(255, 127, 14)),
    (Axis::Bounces, RGBColor(148, 103, 189)),
];

/// The error of the gradient against the time that it takes as an SVG image, both logarithmic. A line
/// joins the Pareto front, whose settings are named. An error above 1 is drawn at 1.
///
/// # Errors
///
/// If the drawing fails.
pub fn plot_svg(caption: &str, measurements: &[Measurement]) -> Result<String, Error> {
    let mut svg = String::new();
    draw(caption, measurements, &mut svg).map_err(|error| Error::new("tradeoff plot", error))?;
    Ok(svg)
}

fn draw(
    caption: &str,
    measurements: &[Measurement],
    svg: &mut String,
) -> Result<(), Box<dyn std::error::Error>> {
    let place = |m: &Measurement| (1e3 * m.seconds, m.gradient_error.clamp(LEAST_ERROR, 1.0));
    let extent = |of: &dyn Fn(&Measurement) -> f64| {
        let numbers = measurements.iter().map(of);
        numbers.fold((f64::MAX, f64::MIN_POSITIVE), |(low, high), x| (low.min(x), high.max(x)))
    };
    let (fastest, slowest) = extent(&|m| place(m).0);
    let (least, largest) = extent(&|m| place(m).1);

    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(16)
        .margin_right(32)
        .caption(caption, ("sans-serif", 18))
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(
            (fastest / 2.0..slowest * 4.0).log_scale(),
            (least / 10.0..largest * 10.0).log_scale(),
        )?;
    chart
        .configure_mesh()
        .x_desc("milliseconds per gradient")
        .y_desc("relative error of the gradient")
        .x_label_formatter(&|x| format!("{x}"))
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 15))
        .bold_line_style(RGBColor(220, 220, 220))
        .light_line_style(TRANSPARENT)
        .draw()?;

    let mut front: Vec<&Measurement> =
        pareto_front(measurements).into_iter().map(|i| &measurements[i]).collect();
    front.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    chart.draw_series(LineSeries::new(
        front.iter().map(|m| place(m)),
        RGBColor(90, 90, 90).stroke_width(1),
    ))?;
    for (axis, color) in COLORS {
        let points: Vec<_> =
            measurements.iter().filter(|m| m.axis == axis).map(place).collect();
        if !points.is_empty() {
            chart
                .draw_series(points.iter().map(|&point| Circle::new(point, 4, color.filled())))?
                .label(axis.name())
                .legend(move |(x, y)| Circle::new((x + 9, y), 4, color.filled()));
        }
    }
    chart.draw_series(front.iter().map(|m| {
        EmptyElement::at(place(m))
            + Circle::new((0, 0), 7, RGBColor(0, 0, 0).stroke_width(1))
            + Text::new(m.setting.clone(), (9, -16), ("sans-serif", 13))
    }))?;
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
