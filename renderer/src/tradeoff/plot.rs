//! Plots with logarithmic axes, as SVG.

use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::combinators::LogCoord;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use super::axis::Axis;
use super::measurement::Measurement;
use super::table::pareto_front;
use crate::Error;
use crate::palette::CurveColors;

/// Width and height in pixels.
const SIZE: (u32, u32) = (900, 560);

/// Pixels of a dash, between dashes, and of the line in a legend.
const DASH: u32 = 5;
const GAP: u32 = 4;
const LEGEND_LINE: u32 = 18;

/// Errors are drawn from rounding in double precision up to 1: what is beyond, is drawn there.
const ERRORS: (f64, f64) = (1e-16, 1.0);

/// One line of a plot: errors over something.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The name of the curve in the legend.
    pub label: String,
    /// Something, and the error there. What is not above 0 is left out of a plot.
    pub points: Vec<(f64, f64)>,
    /// The index of its colour among [`CurveColors`].
    pub color: usize,
    /// Whether the line is dashed.
    pub is_dashed: bool,
}

impl Curve {
    fn drawable(&self) -> impl Iterator<Item = (f64, f64)> + Clone {
        let above = self.points.iter().filter(|(x, _)| *x > 0.0);
        above.map(|&(x, error)| (x, error.clamp(ERRORS.0, ERRORS.1)))
    }
}

/// What a plot and its axes are called.
pub struct Titles<'a> {
    /// Above the plot.
    pub caption: &'a str,
    /// Below the horizontal axis.
    pub horizontal: &'a str,
    /// Beside the vertical axis.
    pub vertical: &'a str,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<LogCoord<f64>, LogCoord<f64>>>;
type Drawn<T> = Result<T, Box<dyn std::error::Error>>;

/// The error of the gradient against the time that it takes. A line joins the Pareto front, whose
/// settings are named.
///
/// # Errors
///
/// If the drawing fails.
pub fn tradeoff_svg(caption: &str, measurements: &[Measurement]) -> Result<String, Error> {
    let vertical = "relative error of the gradient";
    let titles = Titles { caption, horizontal: "milliseconds per gradient", vertical };
    svg(|area| {
        let points: Vec<_> = measurements.iter().map(place).collect();
        let mut chart = axes(area, &titles, &points)?;
        draw_measurements(&mut chart, measurements)?;
        legend(&mut chart, SeriesLabelPosition::UpperMiddle)
    })
}

/// Curves between their points.
///
/// # Errors
///
/// If the drawing fails.
pub fn curves_svg(titles: &Titles<'_>, curves: &[Curve]) -> Result<String, Error> {
    svg(|area| {
        let points: Vec<_> = curves.iter().flat_map(Curve::drawable).collect();
        let mut chart = axes(area, titles, &points)?;
        for curve in curves {
            let style = CurveColors::pick(curve.color).stroke_width(2);
            let series = if curve.is_dashed {
                chart.draw_series(DashedLineSeries::new(curve.drawable(), DASH, GAP, style))?
            } else {
                chart.draw_series(LineSeries::new(curve.drawable(), style))?
            };
            let dash = if curve.is_dashed { DASH } else { LEGEND_LINE };
            series.label(&curve.label).legend(move |(x, y)| {
                DashedPathElement::new([(x, y), (x + LEGEND_LINE as i32, y)], dash, GAP, style)
            });
        }
        legend(&mut chart, SeriesLabelPosition::UpperRight)
    })
}

fn svg(draw: impl FnOnce(&Area<'_>) -> Drawn<()>) -> Result<String, Error> {
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
    let drawn = draw(&area).and_then(|()| Ok(area.present()?));
    drawn.map_err(|error| Error::new("plot", error))?;
    drop(area);
    Ok(svg)
}

/// Axes around some points, with room for a legend above them.
fn axes<'a, 'b>(
    area: &'a Area<'b>,
    titles: &Titles<'_>,
    points: &[(f64, f64)],
) -> Drawn<Chart<'a, 'b>> {
    let extent = |of: fn(&(f64, f64)) -> f64| {
        let numbers = points.iter().map(of);
        numbers.fold((f64::MAX, f64::MIN_POSITIVE), |(low, high), x| (low.min(x), high.max(x)))
    };
    let ((left, right), (low, high)) = (extent(|point| point.0), extent(|point| point.1));
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(area)
        .margin(16)
        .margin_right(32)
        .caption(titles.caption, ("sans-serif", 18))
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(
            (left / 1.5..right * 1.5).log_scale(),
            (low / 3.0..high * (high / low).powf(0.25) * 3.0).log_scale(),
        )?;
    // Places on logarithmic axes are powers of ten but for rounding.
    let label = |x: &f64| match *x {
        0.5..1e4 => format!("{}", (x * 1e3).round() / 1e3),
        x => format!("{x:.0e}"),
    };
    chart
        .configure_mesh()
        .x_desc(titles.horizontal)
        .y_desc(titles.vertical)
        .x_label_formatter(&label)
        .y_label_formatter(&|y| format!("{y:.0e}"))
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 15))
        .bold_line_style(RGBColor(220, 220, 220))
        .light_line_style(TRANSPARENT)
        .draw()?;
    Ok(chart)
}

fn legend<'a, 'b: 'a>(chart: &mut Chart<'a, 'b>, position: SeriesLabelPosition) -> Drawn<()> {
    chart
        .configure_series_labels()
        .position(position)
        .background_style(WHITE.mix(0.8))
        .border_style(RGBColor(180, 180, 180))
        .label_font(("sans-serif", 14))
        .draw()?;
    Ok(())
}

fn place(measurement: &Measurement) -> (f64, f64) {
    (1e3 * measurement.seconds, measurement.gradient_error.clamp(ERRORS.0, ERRORS.1))
}

fn draw_measurements<'a, 'b: 'a>(
    chart: &mut Chart<'a, 'b>,
    measurements: &[Measurement],
) -> Drawn<()> {
    let mut front: Vec<&Measurement> =
        pareto_front(measurements).into_iter().map(|i| &measurements[i]).collect();
    front.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    let grey = RGBColor(90, 90, 90);
    chart.draw_series(LineSeries::new(front.iter().map(|m| place(m)), grey.stroke_width(1)))?;
    for (index, axis) in Axis::ALL.into_iter().enumerate() {
        let color = CurveColors::pick(index);
        let points: Vec<_> = measurements.iter().filter(|m| m.axis == axis).map(place).collect();
        if !points.is_empty() {
            let dots = points.iter().map(|&point| Circle::new(point, 4, color.filled()));
            chart
                .draw_series(dots)?
                .label(axis.name())
                .legend(move |(x, y)| Circle::new((x + 9, y), 4, color.filled()));
        }
    }
    chart.draw_series(front.iter().map(|m| {
        EmptyElement::at(place(m))
            + Circle::new((0, 0), 7, BLACK.stroke_width(1))
            + Text::new(m.setting.clone(), (9, -16), ("sans-serif", 13))
    }))?;
    Ok(())
}
