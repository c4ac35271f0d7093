//! An axis: where a value lies on the sheet, and which values are marked on it.

use crate::text;

/// Spacing of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scale {
    /// Equal steps are equally long.
    #[default]
    Linear,
    /// Equal ratios are equally long; values that are not positive are left out.
    Log,
}

impl Scale {
    /// Whether a value can be drawn on an axis of this spacing.
    pub(crate) fn admits(self, value: f64) -> bool {
        value.is_finite() && (self == Scale::Linear || value > 0.0)
    }

    /// The spacing in words.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Scale::Linear => "linear",
            Scale::Log => "logarithmic",
        }
    }

    /// Smallest range that holds all values this spacing admits; never empty.
    pub(crate) fn range_of(self, values: impl Iterator<Item = f64>) -> (f64, f64) {
        let (low, high) = values
            .filter(|&value| self.admits(value))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                (low.min(value), high.max(value))
            });
        match self {
            _ if low < high * (1.0 - 1e-12 * high.signum()) => (low, high),
            Scale::Linear if low > high => (0.0, 1.0),
            Scale::Linear if low == 0.0 => (-1.0, 1.0),
            Scale::Linear => (low - 0.5 * low.abs(), high + 0.5 * high.abs()),
            Scale::Log if low > high => (1.0, 10.0),
            Scale::Log => (low / 3.0, high * 3.0),
        }
    }

    /// A range with a little air at both ends.
    pub(crate) fn with_air(self, (low, high): (f64, f64)) -> (f64, f64) {
        const SHARE: f64 = 0.05;
        match self {
            Scale::Linear => (low - SHARE * (high - low), high + SHARE * (high - low)),
            Scale::Log => {
                let factor = (high / low).powf(SHARE);
                (low / factor, high * factor)
            }
        }
    }
}

/// A marked value of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub(crate) value: f64,
    /// Words beside the tick; a minor tick has none.
    pub(crate) label: Option<String>,
}

/// The ticks of an axis.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Ticks {
    pub(crate) ticks: Vec<Tick>,
    /// The labels are to be multiplied by ten to this power.
    pub(crate) exponent: i32,
}

impl Ticks {
    /// An axis title with the power of ten, if there is one.
    pub(crate) fn title(&self, title: &str) -> String {
        if self.exponent == 0 {
            title.to_owned()
        } else {
            format!("{title}  (×{})", text::power_of_ten(self.exponent))
        }
    }

    /// Labels of the major ticks.
    pub(crate) fn labels(&self) -> impl Iterator<Item = &str> {
        self.ticks.iter().filter_map(|tick| tick.label.as_deref())
    }
}

/// An axis from `low` at the sheet position `start` to `high` at `end`, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axis {
    pub(crate) scale: Scale,
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) start: f64,
    pub(crate) end: f64,
}

impl Axis {
    /// Sheet position of a value, pixels.
    pub(crate) fn at(&self, value: f64) -> f64 {
        let fraction = match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Log => (value / self.low).ln() / (self.high / self.low).ln(),
        };
        self.start + fraction * (self.end - self.start)
    }

    /// Ticks of which about `count` carry a label.
    pub(crate) fn ticks(&self, count: usize) -> Ticks {
        match self.scale {
            Scale::Linear => {
                linear_ticks(self.low, self.high, nice_step(self.high - self.low, count))
            }
            Scale::Log => log_ticks(self.low, self.high, count),
        }
    }

    /// Ticks of an angle in degrees, at divisions of a full turn.
    pub(crate) fn degree_ticks(&self, count: usize) -> Ticks {
        match degree_step(self.high - self.low, count).filter(|_| self.scale == Scale::Linear) {
            Some(step) => linear_ticks(self.low, self.high, step),
            None => self.ticks(count),
        }
    }
}

/// Smallest step of the series 1, 2, 5 × 10ⁿ that needs at most `count` intervals for `span`.
pub(crate) fn nice_step(span: f64, count: usize) -> f64 {
    let rough = span / count.max(1) as f64;
    let decade = 10f64.powi(rough.log10().floor() as i32);
    let factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|factor| factor * decade >= rough * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * decade
}

/// Smallest customary division of a turn that needs at most `count` intervals for `span` degrees.
pub(crate) fn degree_step(span: f64, count: usize) -> Option<f64> {
    [5.0, 10.0, 15.0, 30.0, 45.0, 90.0, 180.0]
        .into_iter()
        .find(|step| step * count.max(1) as f64 >= span)
}

/// More ticks than this would mean a step lost in rounding.
const MOST_TICKS: usize = 100;

fn linear_ticks(low: f64, high: f64, step: f64) -> Ticks {
    let largest = low.abs().max(high.abs());
    // Plain numbers from 0.001 to 99999, a common power of ten outside.
    let magnitude = largest.log10().floor() as i32;
    let exponent = if (-2..=4).contains(&magnitude) {
        0
    } else {
        magnitude
    };
    let unit = 10f64.powi(exponent);
    let decimals = (exponent - (step * (1.0 + 1e-9)).log10().floor() as i32).clamp(0, 15) as usize;
    let first = (low / step - 1e-9).ceil();
    let last = (high / step + 1e-9).floor();
    let mut ticks = Vec::new();
    let mut index = first;
    while index <= last && ticks.len() < MOST_TICKS {
        let value = index * step;
        ticks.push(Tick {
            value,
            label: Some(text::fixed(value / unit, decimals)),
        });
        index += 1.0;
    }
    Ticks { ticks, exponent }
}

fn log_ticks(low: f64, high: f64, count: usize) -> Ticks {
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let inside = |value: f64| value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
    let decades = (first..=last).filter(|&n| inside(10f64.powi(n))).count();
    // Few decades leave room for labels between them, many ask for gaps.
    let factors: &[u32] = match decades {
        0 | 1 => &[1, 2, 3, 4, 5, 6, 7, 8, 9],
        2 if count >= 5 => &[1, 2, 5],
        _ => &[1],
    };
    let every = decades.div_ceil(count.max(1)).max(1) as i32;
    let plain = first >= -2 && last <= 5;
    let mut ticks = Vec::new();
    for n in first..=last {
        for factor in 1..10u32 {
            let value = f64::from(factor) * 10f64.powi(n);
            if !inside(value) || (factor > 1 && every > 1) {
                continue;
            }
            let labelled = factors.contains(&factor) && n.rem_euclid(every) == 0;
            let label = labelled.then(|| match (plain, factor) {
                (true, _) => text::fixed(value, (-n).max(0) as usize),
                (false, 1) => text::power_of_ten(n),
                (false, _) => format!("{factor}·{}", text::power_of_ten(n)),
            });
            ticks.push(Tick { value, label });
        }
    }
    Ticks { ticks, exponent: 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(scale: Scale, low: f64, high: f64, count: usize) -> Vec<String> {
        let axis = Axis {
            scale,
            low,
            high,
            start: 0.0,
            end: 100.0,
        };
        axis.ticks(count).labels().map(str::to_owned).collect()
    }

    #[test]
    fn linear_labels_are_short() {
        assert_eq!(
            labels(Scale::Linear, 20.0, 80.0, 6),
            ["20", "30", "40", "50", "60", "70", "80"]
        );
        assert_eq!(
            labels(Scale::Linear, 18.0, 216.0, 5),
            ["50", "100", "150", "200"]
        );
        assert_eq!(
            labels(Scale::Linear, -0.25, 0.05, 6),
            ["−0.25", "−0.20", "−0.15", "−0.10", "−0.05", "0.00", "0.05"]
        );
    }

    #[test]
    fn angles_divide_a_turn() {
        let axis = Axis {
            scale: Scale::Linear,
            low: -180.0,
            high: 0.0,
            start: 0.0,
            end: 1.0,
        };
        assert_eq!(
            axis.degree_ticks(6).labels().collect::<Vec<_>>(),
            ["−180", "−150", "−120", "−90", "−60", "−30", "0"]
        );
        assert_eq!(
            axis.degree_ticks(4).labels().collect::<Vec<_>>(),
            ["−180", "−135", "−90", "−45", "0"]
        );
    }

    #[test]
    fn tiny_numbers_share_a_power_of_ten() {
        let axis = Axis {
            scale: Scale::Linear,
            low: 0.0,
            high: 3e-9,
            start: 0.0,
            end: 1.0,
        };
        let ticks = axis.ticks(3);
        assert_eq!(ticks.exponent, -9);
        assert_eq!(ticks.labels().collect::<Vec<_>>(), ["0", "1", "2", "3"]);
        assert_eq!(ticks.title("growth"), "growth  (×10⁻⁹)");
    }

    #[test]
    fn decades_carry_powers() {
        assert_eq!(
            labels(Scale::Log, 1e-11, 1e-8, 6),
            ["10⁻¹¹", "10⁻¹⁰", "10⁻⁹", "10⁻⁸"]
        );
        assert_eq!(labels(Scale::Log, 10.0, 5000.0, 3), ["10", "100", "1000"]);
        assert_eq!(labels(Scale::Log, 1e-30, 1.0, 4).len(), 4);
    }

    #[test]
    fn ranges_are_never_empty() {
        for scale in [Scale::Linear, Scale::Log] {
            for values in [
                &[][..],
                &[0.0],
                &[5.0],
                &[-5.0],
                &[f64::NAN, f64::INFINITY],
                &[3.0, 3.0],
                &[-1.0, 2.0],
            ] {
                let (low, high) = scale.with_air(scale.range_of(values.iter().copied()));
                assert!(
                    low < high && scale.admits(low) && scale.admits(high),
                    "{scale:?} {values:?}: {low} {high}"
                );
            }
        }
    }

    #[test]
    fn positions_are_exact_at_the_ends_and_the_middle() {
        let axis = Axis {
            scale: Scale::Log,
            low: 1.0,
            high: 100.0,
            start: 200.0,
            end: 0.0,
        };
        assert!((axis.at(1.0) - 200.0).abs() < 1e-12);
        assert!((axis.at(10.0) - 100.0).abs() < 1e-12);
        assert!((axis.at(100.0)).abs() < 1e-12);
    }
}
