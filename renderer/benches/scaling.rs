//! How the cost grows with pixels, triangles, lights and derivatives.
//!
//! Prints CSV, one row for each size: the series, the size, milliseconds of an image, of a gradient
//! by everything, of an update of all vertices, and of the first preparation. An argument names an SVG
//! file to draw.

use std::path::Path;

use plotters::prelude::*;
use renderer::{Error, ImageLoss, LossKind, Renderer, Scene, Settings};

use super::sphere::{bumpy_sphere, scene};
use super::timing::{median, seconds};

const REPETITIONS: usize = 5;

/// What was measured of one size.
struct Row {
    series: &'static str,
    size: f64,
    /// In milliseconds.
    image: f64,
    gradient: f64,
}

/// Measures all series.
pub fn run(arguments: &[String]) {
    println!("series,size,image_ms,gradient_ms,update_ms,preparation_ms");
    let drawn = rows().map_err(Into::into).and_then(|rows| match arguments.first() {
        Some(path) => draw(&rows, Path::new(path)),
        None => Ok(()),
    });
    if let Err(error) = drawn {
        eprintln!("error: {error}");
    }
}

fn rows() -> Result<Vec<Row>, Error> {
    let mut rows = Vec::new();
    let mut add = |series, size: u32, scene: Result<Scene, Error>| -> Result<(), Error> {
        rows.push(measure(series, size.into(), scene?)?);
        Ok(())
    };
    for size in [64, 128, 256, 512, 1024, 2048, 4096] {
        add("pixels", size * size, scene(bumpy_sphere(140), size, 1))?;
    }
    for rings in [16, 50, 158, 500, 1581] {
        add("triangles", 4 * rings * rings, scene(bumpy_sphere(rings), 512, 1))?;
    }
    for lights in [1, 2, 4, 8, 16] {
        add("lights", lights, scene(bumpy_sphere(140), 512, lights))?;
    }
    Ok(rows)
}

fn measure(series: &'static str, size: f64, mut scene: Scene) -> Result<Row, Error> {
    let settings = Settings::default();
    let preparation = seconds(|| Renderer::new(&scene, &settings));
    let mut renderer = Renderer::new(&scene, &settings)?;
    let mut image = renderer.render();
    let mut target = image.clone();
    target.pixels.as_flattened_mut().iter_mut().for_each(|value| *value *= 0.9);
    let loss = ImageLoss::new(LossKind::MeanSquared, &target, false);
    let ids = scene.parameters();
    let vertices = scene.parameter("mesh.sphere.vertices")?;
    let mut samples = [Vec::new(), Vec::new(), Vec::new()];
    for repetition in 0..REPETITIONS {
        samples[0].push(seconds(|| renderer.render_into(&mut image)));
        samples[1].push(seconds(|| renderer.loss_and_gradient(&scene, &loss, &ids)));
        let factor = 1.0 + 1e-9 * (repetition + 1) as f64;
        let moved: Vec<f64> = scene.get(vertices).iter().map(|x| x * factor).collect();
        scene.set(vertices, &moved)?;
        samples[2].push(seconds(|| renderer.update(&scene)));
    }
    let [image, gradient, update] = samples.map(|samples| 1e3 * median(samples));
    let preparation = 1e3 * preparation;
    println!("{series},{size},{image:.3},{gradient:.3},{update:.3},{preparation:.3}");
    Ok(Row { series, size, image, gradient })
}

/// Milliseconds against size, both logarithmic, one panel for each series.
fn draw(rows: &[Row], path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let mut names: Vec<_> = rows.iter().map(|row| row.series).collect();
    names.dedup();
    let area = SVGBackend::new(path, (1200, 400)).into_drawing_area();
    area.fill(&WHITE)?;
    let panels = area.split_evenly((1, names.len()));
    for (name, panel) in names.into_iter().zip(&panels) {
        let rows: Vec<_> = rows.iter().filter(|row| row.series == name).collect();
        let sizes = rows[0].size..rows[rows.len() - 1].size;
        let times = rows.iter().flat_map(|row| [row.image, row.gradient]);
        let (least, most) = times
            .fold((f64::MAX, 0.0_f64), |(least, most), time| (least.min(time), most.max(time)));
        let mut chart = ChartBuilder::on(panel)
            .margin(12)
            .caption(format!("milliseconds against {name}"), ("sans-serif", 16))
            .x_label_area_size(36)
            .y_label_area_size(56)
            .build_cartesian_2d(sizes.log_scale(), (least / 1.5..most * 1.5).log_scale())?;
        chart.configure_mesh().x_labels(6).y_labels(6).draw()?;
        for (label, color, is_gradient) in
            [("image", RGBColor(31, 119, 180), false), ("gradient", RGBColor(214, 39, 40), true)]
        {
            let time = |row: &Row| if is_gradient { row.gradient } else { row.image };
            let points = rows.iter().map(|row| (row.size, time(row)));
            chart
                .draw_series(LineSeries::new(points, color.stroke_width(2)).point_size(3))?
                .label(label)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 16, y)], color));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .background_style(WHITE)
            .border_style(BLACK)
            .draw()?;
    }
    area.present()?;
    Ok(())
}
