//! The plot of the loss over the iterations.

use plotters::prelude::*;
use renderer_core::Error;

use super::Record;
use super::loss_axis::LossAxis;

use crate::palette::CurveColors;

/// Width and height in pixels.
const SIZE: (u32, u32) = (800, 480);

/// A longer history is drawn by the lowest and the highest loss of each of so many stretches:
/// more than two points per pixel cannot be seen.
const STRETCHES: usize = 800;

/// The loss over the iterations as an SVG image, logarithmic where losses span a factor of ten; a
/// circle marks the lowest.
///
/// # Errors
///
/// If the drawing fails.
pub fn loss_svg(history: &[Record]) -> Result<String, Error> {
    let mut svg = String::new();
    draw(history, &mut svg).map_err(|error| Error::new("loss plot", error))?;
    Ok(svg)
}

fn draw(history: &[Record], svg: &mut String) -> Result<(), Box<dyn std::error::Error>> {
    let axis = LossAxis::new(history.iter().map(|record| record.loss));
    let last = history.last().map_or(0, |record| record.iteration);

    let area = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&area)
        .margin(16)
        .margin_right(32)
        .caption(caption(history), ("sans-serif", 18))
        .x_label_area_size(44)
        .y_label_area_size(84)
        .build_cartesian_2d(0..last.max(1), axis.clone())?;
    chart
        .configure_mesh()
        .x_desc("iteration")
        .y_desc(axis.title())
        .x_labels(10)
        .label_style(("sans-serif", 14))
        .axis_desc_style(("sans-serif", 15))
        .axis_style(RGBColor(90, 90, 90))
        .bold_line_style(RGBColor(220, 220, 220))
        .light_line_style(TRANSPARENT)
        .draw()?;

    let position = |record: &Record| (record.iteration, axis.height(record.loss));
    let color = CurveColors::pick(0);
    let points = thin_out(history);
    chart.draw_series(LineSeries::new(points.iter().map(position), color.stroke_width(2)))?;
    let lowest = history.iter().min_by(|a, b| a.loss.total_cmp(&b.loss));
    chart.draw_series(lowest.map(|record| Circle::new(position(record), 4, color.filled())))?;
    area.present()?;
    Ok(())
}

fn caption(history: &[Record]) -> String {
    let lowest = history.iter().min_by(|a, b| a.loss.total_cmp(&b.loss));
    match (history.first(), lowest) {
        (Some(first), Some(lowest)) => format!(
            "initial loss {:.3e}, lowest {:.3e} at iteration {}",
            first.loss, lowest.loss, lowest.iteration
        ),
        _ => "no iterations".to_owned(),
    }
}

/// The records that a plot needs: all of them, or the extremes of equal stretches in order.
fn thin_out(history: &[Record]) -> Vec<Record> {
    if history.len() <= 2 * STRETCHES {
        return history.to_vec();
    }
    let mut points: Vec<Record> = Vec::with_capacity(2 * STRETCHES + 2);
    for stretch in history.chunks(history.len().div_ceil(STRETCHES)) {
        let by_loss = |a: &&Record, b: &&Record| a.loss.total_cmp(&b.loss);
        let extremes = [stretch.iter().min_by(by_loss), stretch.iter().max_by(by_loss)];
        points.extend(extremes.into_iter().flatten());
    }
    points.extend([history.first(), history.last()].into_iter().flatten());
    points.sort_by_key(|record| record.iteration);
    points.dedup_by_key(|record| record.iteration);
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn history(losses: impl IntoIterator<Item = f64>) -> Vec<Record> {
        (0..)
            .zip(losses)
            .map(|(iteration, loss)| Record { iteration, loss, gradient_norm: 1.0, seconds: 0.0 })
            .collect()
    }

    /// The points of the one line that is as thick as the loss's.
    fn line(svg: &str) -> Vec<(i32, i32)> {
        let lines: Vec<&str> = svg
            .split("<polyline")
            .skip(1)
            .filter(|line| line[..line.find("/>").unwrap()].contains("stroke-width=\"2\""))
            .collect();
        assert_eq!(lines.len(), 1, "{svg}");
        let points = lines[0].split("points=\"").nth(1).unwrap().split('"').next().unwrap();
        points
            .split_whitespace()
            .map(|point| {
                let (x, y) = point.split_once(',').unwrap();
                (x.parse().unwrap(), y.parse().unwrap())
            })
            .collect()
    }

    #[test]
    fn exponential_decay_is_a_straight_line() {
        let svg = loss_svg(&history((0..=100).map(|i| 10f64.powf(-0.08 * f64::from(i))))).unwrap();
        let points = line(&svg);
        let (x0, y0) = points[0];
        let (x1, y1) = points[100];
        assert!(x1 - x0 > 500 && y1 - y0 > 300, "{points:?}");
        let middle = points[50];
        assert!((2 * middle.0 - x0 - x1).abs() <= 3 && (2 * middle.1 - y0 - y1).abs() <= 3);
        assert!(svg.contains("1e-8") && svg.contains("iteration"), "{svg}");
    }

    #[test]
    fn every_history_is_drawn() {
        let huge = f64::MAX;
        let cases: [&[f64]; 8] = [
            &[0.0],
            &[0.3],
            &[0.3, 0.3, 0.3],
            &[1.0, 0.1, 0.0, 0.0],
            &[0.0, 0.0],
            &[huge, 1.0, 5e-324],
            &[-1.0, -huge],
            &[2e-20, 1.9e-20],
        ];
        for losses in cases {
            let svg = loss_svg(&history(losses.iter().copied())).unwrap();
            assert!(svg.contains("<circle") && !svg.contains("NaN"), "{losses:?}: {svg}");
            if losses.len() > 1 {
                assert_eq!(line(&svg).len(), losses.len(), "{losses:?}");
            }
        }
        assert!(loss_svg(&[]).unwrap().contains("no iterations"));
    }

    #[test]
    fn long_history_keeps_its_extremes() {
        let mut losses = vec![1.0; 100_000];
        (losses[54_321], losses[77_777]) = (1e5, 1e-5);
        let long = history(losses);
        let points = thin_out(&long);
        assert!(points.len() < 2 * STRETCHES + 3);
        let kept = |i: u64| points.iter().any(|record| record.iteration == i);
        assert!([0, 54_321, 77_777, 99_999].into_iter().all(kept));
        assert!(points.is_sorted_by(|a, b| a.iteration < b.iteration));
    }
}
