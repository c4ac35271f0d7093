//! The steps of growth of a map.

use crate::color::{Rgb, growth_color};

/// More steps than this cannot be told apart.
const MOST_STEPS: usize = 50;

/// The equal steps of growth of a map.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Steps {
    /// Smallest value of the map, negative.
    pub(crate) least: f64,
    /// Number of steps from 0 to `least`.
    pub(crate) count: usize,
}

impl Steps {
    /// Value at the boundary `index`, from 0 at 0 to `least` at `count`.
    pub(crate) fn value(&self, index: usize) -> f64 {
        self.least * (index as f64 / self.count as f64)
    }

    /// The steps of a map, none if nothing grows. The count is kept within 1 to [`MOST_STEPS`].
    pub(crate) fn new(least: Option<f64>, count: usize) -> Option<Self> {
        least.filter(|least| -least > f64::MIN_POSITIVE).map(|least| Steps { least, count: count.clamp(1, MOST_STEPS) })
    }

    /// Colour of the step between the boundaries `index` and `index + 1`.
    pub(crate) fn color(&self, index: usize) -> Rgb {
        growth_color(index as f64 / (self.count.max(2) - 1) as f64)
    }

    /// Values at which regions of growth begin, as positive numbers; the first is just above 0, for
    /// a value of exactly 0 is no growth.
    pub(crate) fn growth_levels(&self) -> Vec<f64> {
        (0..self.count).map(|index| if index == 0 { -self.least * 1e-9 } else { -self.value(index) }).collect()
    }
}
