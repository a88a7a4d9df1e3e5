//! A small line chart as SVG.

use std::fmt::Write as _;

/// A curve, and the value that it should come to.
pub(super) struct Curve {
    pub points: Vec<(f64, f64)>,
    pub truth: Option<f64>,
}

/// Width and height in units of the drawing, and the room around the curve.
const SIZE: (f64, f64) = (320.0, 170.0);
const LEFT: f64 = 62.0;
const RIGHT: f64 = 10.0;
const TOP: f64 = 26.0;
const BOTTOM: f64 = 22.0;

/// The chart of a curve over the iterations; `title` is escaped already.
pub(super) fn line_chart(title: &str, curve: &Curve) -> String {
    let (width, height) = SIZE;
    let (x_low, x_high) = range(curve.points.iter().map(|point| point.0));
    let (y_low, y_high) = range(curve.points.iter().map(|point| point.1).chain(curve.truth));
    // Each end is divided by itself: a difference of two numbers may be infinite.
    let part = |value: f64, low: f64, high: f64| {
        let scale = low.abs().max(high.abs()).max(f64::MIN_POSITIVE);
        let range = high / scale - low / scale;
        if range > 0.0 { (value / scale - low / scale) / range } else { 0.5 }
    };
    let x = |value: f64| LEFT + part(value, x_low, x_high) * (width - LEFT - RIGHT);
    let y = |value: f64| height - BOTTOM - part(value, y_low, y_high) * (height - TOP - BOTTOM);

    let mut svg = format!(
        "<svg viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}\">\n\
         <text class=\"title\" x=\"{LEFT}\" y=\"16\">{title}</text>\n\
         <rect class=\"axes\" x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/>\n",
        width - LEFT - RIGHT,
        height - TOP - BOTTOM
    );
    // Writing to a string cannot fail.
    for value in [y_low, y_high] {
        let _ = writeln!(
            svg,
            "<text class=\"y\" x=\"{}\" y=\"{:.1}\">{}</text>",
            LEFT - 5.0,
            y(value) + 4.0,
            label(value)
        );
    }
    for value in [x_low, x_high] {
        let _ = writeln!(
            svg,
            "<text class=\"x\" x=\"{:.1}\" y=\"{}\">{value}</text>",
            x(value),
            height - 7.0
        );
    }
    if let Some(truth) = curve.truth {
        let _ = writeln!(
            svg,
            "<line class=\"truth\" x1=\"{LEFT}\" x2=\"{}\" y1=\"{1:.1}\" y2=\"{1:.1}\"/>",
            width - RIGHT,
            y(truth)
        );
    }
    let points: Vec<String> =
        curve.points.iter().map(|&(k, value)| format!("{:.1},{:.1}", x(k), y(value))).collect();
    let _ = writeln!(svg, "<polyline class=\"curve\" points=\"{}\"/>\n</svg>", points.join(" "));
    svg
}

fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let ends = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), ends);
    if low <= high { (low, high) } else { (0.0, 0.0) }
}

/// A number of up to eight characters.
pub(super) fn label(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&size) {
        let decimals = (3.0 - size.log10().floor()).clamp(0.0, 6.0) as usize;
        let text = format!("{value:.decimals$}");
        match text.contains('.') {
            true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
            false => text,
        }
    } else {
        format!("{value:.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let cases = [
            (0.0, "0"),
            (-1.5, "-1.5"),
            (20000.0, "20000"),
            (0.012345, "0.01235"),
            (123456.0, "1.23e5"),
            (-1e-9, "-1.00e-9"),
            (99999.9, "100000"),
        ];
        for (value, text) in cases {
            assert_eq!(label(value), text);
        }
    }

    #[test]
    fn every_curve_is_within_the_drawing() {
        let cases: [&[(f64, f64)]; 5] = [
            &[(0.0, 1.0)],
            &[(0.0, 1.0), (9.0, 1.0)],
            &[(0.0, -f64::MAX), (1.0, f64::MAX)],
            &[(0.0, 1e-310), (1.0, 2e-310)],
            &[],
        ];
        for points in cases {
            for truth in [None, Some(0.5), Some(-1e300)] {
                let svg = line_chart("p", &Curve { points: points.to_vec(), truth });
                assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
                let drawn = svg.split("points=\"").nth(1).unwrap().split('"').next().unwrap();
                for point in drawn.split_whitespace() {
                    let (x, y) = point.split_once(',').unwrap();
                    let (x, y): (f64, f64) = (x.parse().unwrap(), y.parse().unwrap());
                    assert!((LEFT..=SIZE.0).contains(&x) && (TOP..=SIZE.1).contains(&y), "{svg}");
                }
            }
        }
    }
}
