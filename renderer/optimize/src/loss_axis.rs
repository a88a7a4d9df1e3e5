//! The vertical axis of the loss plot.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Maps losses to heights from 0 (bottom) to 1 (top) and says where the ticks are.
///
/// Logarithmic if the losses span a factor of ten or more, linear if they lie closer together or
/// some are negative. The range that plotters sees is that of the heights, since its own axes loop
/// without end on steps below 1e-16.
#[derive(Clone)]
pub(super) struct LossAxis {
    scale: Scale,
    low: f64,
    high: f64,
    /// Height and label of each tick, from the bottom up.
    ticks: Vec<(f64, String)>,
}

#[derive(Clone, Copy)]
enum Scale {
    /// Heights follow `log10(loss)`; a loss of 0 lies on the bottom, whose label is then `0`.
    Logarithmic,
    /// Heights follow `loss / 10^exponent`.
    Linear { exponent: i32 },
}

/// About so many labels fit.
const TICKS: f64 = 8.0;

impl LossAxis {
    /// An axis that holds all of `losses`, which are finite; if there are none, around 0.
    pub fn new(losses: impl Iterator<Item = f64> + Clone) -> Self {
        let min = losses.clone().fold(f64::INFINITY, f64::min);
        let max = losses.clone().fold(f64::NEG_INFINITY, f64::max);
        if min > max {
            return Self::linear(0.0, 0.0);
        }
        let min_positive = losses.filter(|&loss| loss > 0.0).fold(f64::INFINITY, f64::min);
        if min >= 0.0 && max > 0.0 && max >= 10.0 * min {
            Self::logarithmic(min_positive, max, min == 0.0)
        } else {
            Self::linear(min, max)
        }
    }

    fn logarithmic(min_positive: f64, max: f64, has_zero: bool) -> Self {
        let high = max.log10().ceil();
        let lowest = min_positive.log10().floor().min(high - 1.0);
        let stride = ((high - lowest) / TICKS).ceil();
        let mut low = high - ((high - lowest) / stride).ceil() * stride;
        if has_zero {
            // Zero gets a line of its own below everything positive.
            low -= stride;
        }
        let mantissas: &[u32] = if high - low <= 2.0 { &[1, 2, 5] } else { &[1] };
        let mut ticks = Vec::new();
        let decades = ((high - low) / stride).round() as i32;
        for decade in 0..=decades {
            let exponent = low + f64::from(decade) * stride;
            for &mantissa in mantissas {
                let height = (exponent - low + f64::from(mantissa).log10()) / (high - low);
                let is_zero = has_zero && decade == 0;
                if height <= 1.0 && !(is_zero && mantissa > 1) {
                    let label =
                        if is_zero { "0".to_owned() } else { format!("{mantissa}e{exponent}") };
                    ticks.push((height, label));
                }
            }
        }
        Self { scale: Scale::Logarithmic, low, high, ticks }
    }

    fn linear(min: f64, max: f64) -> Self {
        let magnitude = min.abs().max(max.abs());
        let exponent = if magnitude > 0.0 { magnitude.log10().floor() as i32 } else { 0 };
        let scale = Scale::Linear { exponent };
        let (mut low, mut high) = (scale.apply(min), scale.apply(max));
        // Losses that agree to the last digits get a range that can be told on the labels.
        if high - low < 1e-9 {
            (low, high) = (low - 0.1, high + 0.1);
        }
        let step = round_step((high - low) / TICKS);
        // A limit that is a tick but for its rounding takes no further one.
        let (first, last) = ((low / step + 1e-9).floor(), (high / step - 1e-9).ceil());
        (low, high) = (first * step, last * step);

        let plain = (-3..=3).contains(&exponent);
        let shown_exponent = if plain { exponent } else { 0 };
        let digits = (-step.log10().floor() - f64::from(shown_exponent)).max(0.0) as usize;
        let factor = 10f64.powi(shown_exponent);
        let count = (last - first).round() as i32;
        let ticks = (0..=count)
            .map(|i| {
                let mantissa = (first + f64::from(i)) * step * factor;
                let number = format!("{mantissa:.digits$}");
                let label = if plain { number } else { format!("{number}e{exponent}") };
                (f64::from(i) / f64::from(count), label)
            })
            .collect();
        Self { scale, low, high, ticks }
    }

    /// The height of a loss.
    pub fn height(&self, loss: f64) -> f64 {
        ((self.scale.apply(loss) - self.low) / (self.high - self.low)).clamp(0.0, 1.0)
    }

    /// What the axis shows.
    pub fn title(&self) -> &'static str {
        match self.scale {
            Scale::Logarithmic => "loss (log scale)",
            Scale::Linear { .. } => "loss",
        }
    }
}

impl Ranged for LossAxis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, height: &f64, limit: (i32, i32)) -> i32 {
        limit.0 + (height * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        self.ticks.iter().map(|(height, _)| *height).collect()
    }

    fn range(&self) -> Range<f64> {
        0.0..1.0
    }
}

impl ValueFormatter<f64> for LossAxis {
    /// The label of the tick at a height.
    fn format_ext(&self, height: &f64) -> String {
        let tick = self.ticks.iter().find(|(at, _)| at == height);
        tick.map_or_else(String::new, |(_, label)| label.clone())
    }
}

impl Scale {
    fn apply(self, loss: f64) -> f64 {
        match self {
            Scale::Logarithmic => loss.log10(),
            // Halved powers, since 10^-320 has lost its digits.
            Scale::Linear { exponent } => {
                let half = exponent / 2;
                loss / 10f64.powi(half) / 10f64.powi(exponent - half)
            }
        }
    }
}

/// The least of 1, 2, 5 times a power of ten that is at least `step`.
fn round_step(step: f64) -> f64 {
    let power = 10f64.powf(step.log10().floor());
    let mantissa = [1.0, 2.0, 5.0].into_iter().find(|m| m * power >= step).unwrap_or(10.0);
    mantissa * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(losses: &[f64]) -> Vec<String> {
        let axis = LossAxis::new(losses.iter().copied());
        for &loss in losses {
            let height = axis.height(loss);
            assert!((0.0..=1.0).contains(&height), "{losses:?}: {loss} at {height}");
        }
        assert!(axis.ticks.is_sorted_by(|a, b| a.0 < b.0), "{losses:?}: {:?}", axis.ticks);
        let labels: Vec<String> = axis.ticks.iter().map(|(at, _)| axis.format_ext(at)).collect();
        assert!((2..=20).contains(&labels.len()), "{losses:?}: {labels:?}");
        assert!(labels.iter().all(|label| label.len() < 16), "{losses:?}: {labels:?}");
        let mut distinct = labels.clone();
        distinct.dedup();
        assert_eq!(distinct, labels, "{losses:?}");
        labels
    }

    #[test]
    fn decades() {
        assert_eq!(labels(&[0.5, 2e-3, 4e-4]), ["1e-4", "1e-3", "1e-2", "1e-1", "1e0"]);
        assert_eq!(labels(&[0.5, 0.02]), ["1e-2", "2e-2", "5e-2", "1e-1", "2e-1", "5e-1", "1e0"]);
        assert_eq!(labels(&[1.0, 1e-300]).len(), 9);
    }

    #[test]
    fn heights_are_logarithmic() {
        let axis = LossAxis::new([1.0, 1e-2, 1e-4].into_iter());
        assert_eq!([1.0, 1e-2, 1e-4].map(|loss| axis.height(loss)), [1.0, 0.5, 0.0]);
    }

    #[test]
    fn zero_lies_on_the_bottom() {
        assert_eq!(labels(&[0.5, 3e-3, 0.0])[..3], ["0", "1e-3", "1e-2"]);
        let axis = LossAxis::new([0.5, 3e-3, 0.0].into_iter());
        assert_eq!(axis.height(0.0), 0.0);
        assert!(axis.height(3e-3) > 0.2);
    }

    #[test]
    fn close_losses_are_linear() {
        assert_eq!(
            labels(&[0.35, 0.31]),
            ["0.310", "0.315", "0.320", "0.325", "0.330", "0.335", "0.340", "0.345", "0.350"]
        );
        assert_eq!(labels(&[3.5e-20, 3.1e-20])[..2], ["3.10e-20", "3.15e-20"]);
        assert_eq!(labels(&[20.0, 90.0])[..2], ["20", "30"]);
    }

    #[test]
    fn any_range_is_shown() {
        labels(&[0.0]);
        labels(&[0.7]);
        labels(&[1e-310, 2e-310]);
        labels(&[f64::MAX, f64::MAX]);
        labels(&[f64::MIN, f64::MAX]);
        labels(&[f64::MAX, 5e-324]);
        labels(&[f64::MAX, 5e-324, 0.0]);
        labels(&[-3.0, 0.0]);
        labels(&[1.0, 1.0 + 1e-15]);
    }
}
