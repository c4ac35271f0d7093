//! Growth of corrugation over wavelength and speed: whole maps, and the ridge of highest growth.

mod bay;
mod branch;
mod closing;
mod fine_row;
mod growth_spectrum;
mod map;
mod on_irregular_supports;
mod ridge;
mod row;
mod with_neighbours;

pub use bay::{Bay, BayMaps};
pub use branch::RidgeBranch;
pub use growth_spectrum::GrowthSpectrum;
pub use map::GrowthMap;
pub use on_irregular_supports::GrowthOnIrregularSupports;
pub use ridge::{Ridge, RidgePoint, RidgeRow, RidgeSearch};
pub use row::RowEvaluator;
pub use with_neighbours::GrowthWithNeighbours;

use crate::Error;

/// Equally spaced values, both ends included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    min: f64,
    max: f64,
    points: usize,
}

impl Axis {
    /// The values min, …, max in equal steps.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless 0 < min < max and there are two points or more.
    pub fn new(min: f64, max: f64, points: usize) -> Result<Self, Error> {
        Error::unless_positive("lower end of an axis", min, "")?;
        if !(max.is_finite() && max > min) {
            return Err(Error::OutOfRange {
                quantity: "upper end of an axis",
                value: max,
                unit: "",
                rule: "must be finite and greater than the lower end",
            });
        }
        if points < 2 {
            return Err(Error::OutOfRange {
                quantity: "number of points of an axis",
                value: points as f64,
                unit: "",
                rule: "must be two or more",
            });
        }
        Ok(Self { min, max, points })
    }

    /// Lower end.
    pub fn min(&self) -> f64 {
        self.min
    }

    /// Upper end.
    pub fn max(&self) -> f64 {
        self.max
    }

    /// Number of values.
    pub fn points(&self) -> usize {
        self.points
    }

    /// The value of the given index; the last is the upper end itself.
    pub fn value(&self, index: usize) -> f64 {
        if index + 1 == self.points {
            return self.max;
        }
        self.min + (self.max - self.min) / (self.points - 1) as f64 * index as f64
    }

    /// All values.
    pub fn values(&self) -> Vec<f64> {
        (0..self.points).map(|index| self.value(index)).collect()
    }
}
