//! Measurements as text.

use super::measurement::Measurement;

/// The measurements that no other one beats in both time and error of the gradient, by index.
pub fn pareto_front(measurements: &[Measurement]) -> Vec<usize> {
    let beats = |a: &Measurement, b: &Measurement| {
        a.seconds <= b.seconds
            && a.gradient_error <= b.gradient_error
            && (a.seconds, a.gradient_error) != (b.seconds, b.gradient_error)
    };
    let best = |i: &usize| {
        let this = &measurements[*i];
        this.gradient_error.is_finite() && !measurements.iter().any(|other| beats(other, this))
    };
    (0..measurements.len()).filter(best).collect()
}

/// A table for people. A star marks the Pareto front.
pub fn table(measurements: &[Measurement]) -> String {
    let front = pareto_front(measurements);
    let mut lines = vec![format!(
        "{:<17} {:<28} {:>12} {:>5} {:>11} {:>11} {:>13}",
        "", "", "gradient, ms", "runs", "memory, kB", "image off", "gradient off"
    )];
    for (index, measurement) in measurements.iter().enumerate() {
        let Measurement {
            axis, setting, seconds, runs, bytes, image_error, gradient_error, ..
        } = measurement;
        let bytes = bytes.map_or("-".into(), |bytes| format!("{:.1}", bytes as f64 / 1e3));
        let image_error = image_error.map_or("-".into(), |error| format!("{error:.1e}"));
        let star = if front.contains(&index) { " *" } else { "" };
        lines.push(format!(
            "{:<17} {setting:<28} {:>12.4} {runs:>5} {bytes:>11} {image_error:>11} {gradient_error:>13.1e}{star}",
            axis.name(),
            1e3 * seconds,
        ));
    }
    lines.join("\n")
}

/// The measurements as comma-separated values: seconds, bytes, relative errors; what there is not is empty.
pub fn csv(measurements: &[Measurement]) -> String {
    let front = pareto_front(measurements);
    let mut lines =
        vec!["axis,setting,seconds,runs,bytes,image_error,gradient_error,pareto".to_owned()];
    for (index, measurement) in measurements.iter().enumerate() {
        let Measurement {
            axis, setting, seconds, runs, bytes, image_error, gradient_error, ..
        } = measurement;
        let bytes = bytes.map_or(String::new(), |bytes| bytes.to_string());
        let image_error = image_error.map_or(String::new(), |error| format!("{error:e}"));
        lines.push(format!(
            "\"{}\",\"{setting}\",{seconds:e},{runs},{bytes},{image_error},{gradient_error:e},{}",
            axis.name(),
            front.contains(&index)
        ));
    }
    lines.join("\n") + "\n"
}
