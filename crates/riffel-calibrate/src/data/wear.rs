//! Wear of the head of the rail as it was measured.

use std::path::Path;

use riffel::forecast::WearSpread;
use riffel_case::file::MeasuredWear;
use riffel_keys::CaseError;
use riffel_numerics::matrix::Matrix;

use super::{Block, Observable, Place, table};
use crate::file::Kind;
use crate::gaussian::Gaussian;
use crate::model::Trial;

/// Depths worn off under some gross mass: ln of what is lost per 100 million tonnes, with normal errors, rows independent.
#[derive(Clone)]
pub(crate) struct Wear {
    view: usize,
    /// Under which it was worn off \[million gross tonnes\].
    mgt: Vec<f64>,
    /// ln of the depth per 100 million gross tonnes \[ln m\].
    depth: Vec<f64>,
    errors: Gaussian,
}

impl Wear {
    /// `None` if a factor of one leaves no error.
    ///
    /// # Errors
    /// [`CaseError::Read`], or [`CaseError::Data`] with the line, the column and the rule.
    pub(crate) fn read(path: &Path, view: usize) -> Result<Option<Self>, CaseError> {
        let numbers = table::Numbers::of(path, Kind::Wear)?;
        let [depth, mgt] = [0, 1].map(|column| &numbers.needed[column]);
        let factor = match &numbers.others[0] {
            Some(factors) => factors.clone(),
            None => vec![MeasuredWear::FACTOR; depth.len()],
        };
        let above_zero = "must be greater than zero";
        numbers.check(path, "depth_mm", depth, above_zero, |depth| depth > 0.0)?;
        numbers.check(path, "mgt", mgt, above_zero, |mgt| mgt > 0.0)?;
        numbers.check(path, "factor", &factor, "must be one or more", |factor| factor >= 1.0)?;
        let rows: Vec<[f64; 3]> =
            (depth.iter().zip(mgt).zip(&factor)).map(|((depth, mgt), factor)| [*depth, *mgt, *factor]).collect();
        numbers.unless_doubled(path, &rows, |one, other| one == other)?;
        let deviation = |row: usize| WearSpread::of_factor(factor[row]).factor().ln();
        let noise = Matrix::of(rows.len(), |row, column| match row == column {
            true => deviation(row).powi(2),
            false => 0.0,
        });
        let of_100_mgt = rows.iter().map(|[depth, mgt, _]| (1e-3 * depth * 100.0 / mgt).ln());
        Ok(Gaussian::new(noise, Vec::new()).map(|errors| Self {
            view,
            depth: of_100_mgt.collect(),
            mgt: mgt.clone(),
            errors,
        }))
    }
}

impl Block for Wear {
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        let depth = trial.mean_wear(self.view)?.depth_per_100_mgt();
        match depth > 0.0 {
            true => Ok(vec![depth.ln(); self.depth.len()]),
            false => Err("nothing slides, and the rail does not wear".to_owned()),
        }
    }

    fn gaussian(&self) -> Option<&Gaussian> {
        Some(&self.errors)
    }

    fn with_data(&self, data: &[f64]) -> Option<Box<dyn Block>> {
        Some(Box::new(Self { depth: data.to_vec(), ..self.clone() }))
    }

    fn views(&self) -> Vec<usize> {
        vec![self.view]
    }

    fn observed(&self) -> Vec<f64> {
        self.depth.clone()
    }

    fn places(&self) -> Vec<Place> {
        let place = |mgt: &f64| Place { measured: Observable::WearMPer100Mgt, at: *mgt, of: None };
        self.mgt.iter().map(place).collect()
    }

    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        let all = self.errors.covariance(sizes);
        Matrix::of(self.depth.len(), |row, column| all.row(row)[column] / times)
    }
}
