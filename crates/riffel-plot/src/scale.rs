//! The spacing of an axis, and round steps.

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
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
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

/// Smallest step of the series 1, 2, 5 × 10ⁿ that needs at most `count` intervals for `span`.
pub(crate) fn nice_step(span: f64, count: usize) -> f64 {
    let rough = span / count.max(1) as f64;
    let decade = 10f64.powi(rough.log10().floor() as i32);
    let factor = [1.0, 2.0, 5.0, 10.0].into_iter().find(|factor| factor * decade >= rough * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * decade
}
