//! How a level changes from record to record.

use super::normal;
use crate::Error;

/// What time is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TimeUnit {
    /// Years between dated records.
    Year,
    /// Steps between records in their order, for records without dates.
    Record,
}

impl TimeUnit {
    /// In words: "year", "record".
    pub fn name(self) -> &'static str {
        match self {
            Self::Year => "year",
            Self::Record => "record",
        }
    }
}

/// A level at one time.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct CoursePoint {
    /// Name or date of the record.
    pub label: String,
    /// Time in the unit of the course.
    pub time: f64,
    /// Level \[dB re 1 µm\].
    pub level: f64,
    /// Standard deviation of the level by chance \[dB\]; unknown for a single spectrum.
    pub scatter: Option<f64>,
}

/// A straight line through the levels of several records.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Course {
    /// The records, by time.
    pub points: Vec<CoursePoint>,
    /// What time is counted in.
    pub unit: TimeUnit,
    /// Change of the level in a unit of time \[dB\].
    pub slope: f64,
    /// Standard deviation of the slope \[dB\].
    pub slope_scatter: f64,
}

impl Course {
    /// Least squares through two records or more, of equal weight.
    ///
    /// The scatter of the slope is the larger of that which follows from the scatter of the levels and that
    /// which follows from their distance from the line (three records or more). A level whose scatter is
    /// unknown is taken to be good to `ASSUMED_SCATTER`.
    ///
    /// # Errors
    /// [`Error::Measurement`] for less than two records, or where all are of one time.
    pub fn new(mut points: Vec<CoursePoint>, unit: TimeUnit) -> Result<Self, Error> {
        points.sort_by(|a, b| a.time.total_cmp(&b.time));
        let count = points.len() as f64;
        let mean =
            |value: &dyn Fn(&CoursePoint) -> f64| points.iter().map(value).sum::<f64>() / count;
        let (time, level) = (mean(&|point| point.time), mean(&|point| point.level));
        let squares: f64 = points.iter().map(|point| (point.time - time).powi(2)).sum();
        if points.len() < 2 || squares <= 0.0 {
            return Err(Error::Measurement {
                index: points.len().saturating_sub(1),
                rule: "a course must have records of two times",
            });
        }
        let slope = points
            .iter()
            .map(|point| (point.time - time) * (point.level - level))
            .sum::<f64>()
            / squares;
        let known: f64 = points
            .iter()
            .map(|point| {
                let scatter = point.scatter.unwrap_or(Self::ASSUMED_SCATTER);
                ((point.time - time) * scatter).powi(2)
            })
            .sum::<f64>()
            .sqrt()
            / squares;
        let residual: f64 = points
            .iter()
            .map(|point| (point.level - level - slope * (point.time - time)).powi(2))
            .sum();
        let left = if points.len() > 2 {
            (residual / (count - 2.0) / squares).sqrt()
        } else {
            0.0
        };
        Ok(Self {
            points,
            unit,
            slope,
            slope_scatter: known.max(left),
        })
    }

    /// Scatter of a one-third-octave level of which there is one spectrum only \[dB\]: some dozen metres of
    /// rail at 30 mm. Riffel's choice.
    pub const ASSUMED_SCATTER: f64 = 1.0;

    /// Probability that the level rises, for errors that are normal.
    pub fn probability_of_rise(&self) -> f64 {
        normal::above(-self.slope / self.slope_scatter.max(1e-6))
    }

    /// True where each record is below the one before.
    pub fn falls_every_time(&self) -> bool {
        self.points
            .windows(2)
            .all(|pair| pair[1].level < pair[0].level)
    }

    /// True where each record is above the one before.
    pub fn rises_every_time(&self) -> bool {
        self.points
            .windows(2)
            .all(|pair| pair[1].level > pair[0].level)
    }

    /// Time until the level has moved by three times the scatter of one record, in the unit of the course:
    /// when to measure again. None where the slope is not known better than its own scatter.
    pub fn until_visible(&self) -> Option<f64> {
        let scatter = self.points.last()?.scatter.unwrap_or(Self::ASSUMED_SCATTER);
        (self.slope.abs() > self.slope_scatter).then(|| 3.0 * scatter / self.slope.abs())
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Levels of one record after the other.
    pub(in crate::diagnosis) fn course(levels: &[f64], scatter: Option<f64>) -> Course {
        let points = levels
            .iter()
            .enumerate()
            .map(|(index, &level)| CoursePoint {
                label: index.to_string(),
                time: index as f64,
                level,
                scatter,
            });
        Course::new(points.collect(), TimeUnit::Record).unwrap()
    }

    #[test]
    fn a_line_is_found_with_its_scatter() {
        let rising = course(&[1.0, 3.0, 5.0, 7.0], Some(0.5));
        assert!((rising.slope - 2.0).abs() < 1e-12);
        // σ/√Σ(t − t̄)² = 0.5/√5.
        assert!((rising.slope_scatter - 0.5 / 5f64.sqrt()).abs() < 1e-12);
        assert!(rising.probability_of_rise() > 0.999_999 && rising.rises_every_time());
        assert!((rising.until_visible().unwrap() - 0.75).abs() < 1e-12);
        // Residuals ±1 of a flat line scatter more than 0.01 dB lets expect.
        let flat = course(&[1.0, -1.0, 1.0, -1.0], Some(0.01));
        assert!(flat.slope_scatter > 0.3);
        assert!(!flat.rises_every_time() && !flat.falls_every_time());
        let even = course(&[0.0, 0.0], None);
        assert!((even.probability_of_rise() - 0.5).abs() < 1e-12 && even.until_visible().is_none());
    }

    #[test]
    fn one_time_is_no_course() {
        let point = CoursePoint {
            label: String::new(),
            time: 1.0,
            level: 0.0,
            scatter: None,
        };
        assert!(Course::new(vec![point.clone()], TimeUnit::Year).is_err());
        assert!(Course::new(vec![point.clone(), point], TimeUnit::Year).is_err());
    }
}
