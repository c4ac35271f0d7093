//! The rail that levels tell of.

use riffel_numerics::matrix::Matrix;

use super::measured::LevelRow;
use super::{Levels, UNIT};
use crate::linear::{Known, Normal};
use crate::model::Trial;

/// The rail that levels tell of.
pub(crate) struct Rail {
    normal: Normal,
    /// dB per passage that is missed, by what is normal behind the levels.
    missed: Option<Matrix>,
}

impl Levels {
    /// What all levels say of the rail under values of the parameters: generalised least squares of L_b, and of d_b with what was
    /// known of it.
    pub(crate) fn rail(&self, trial: &Trial<'_>, sizes: &[f64]) -> Result<Rail, String> {
        let grown = self.levels(trial)?;
        let data: Vec<f64> = self.rows.iter().zip(grown).map(|(row, grown)| row.level - grown).collect();
        let (of_growth, of_runs) = sizes.split_at(usize::from(self.missed.is_some()));
        let covariance = self.of_rows.covariance(of_runs);
        let missed = self
            .missed
            .as_ref()
            .zip(of_growth.first())
            .map(|(lower, size)| Matrix { values: lower.values.iter().map(|it| it * size / UNIT).collect(), ..*lower });
        let bands = 0..self.bands.len();
        let column = |value: &dyn Fn(&LevelRow) -> f64| self.rows.iter().map(value).collect::<Vec<f64>>();
        let mut columns: Vec<Vec<f64>> = (bands.clone()).map(|band| column(&|row| row.share(band))).collect();
        let mut known = vec![Known::default(); self.bands.len()];
        if let Some(missed) = &missed {
            let of_row = |row: &LevelRow, w: usize| -> f64 {
                let bands = row.bands.iter();
                bands.map(|(band, share)| share * missed.at(*band, w)).sum()
            };
            columns.extend(bands.map(|w| column(&|row| row.passages * of_row(row, w))));
            known.resize(2 * self.bands.len(), Known { mean: 0.0, precision: 1.0 });
        }
        let beyond = "the errors of the levels are beyond numbers";
        let noise = covariance.cholesky().ok_or(beyond)?;
        let normal = Normal::after(&known, &columns, &noise, &data).ok_or(beyond)?;
        Ok(Rail { normal, missed })
    }
}

impl Rail {
    /// One draw, from draws of mean 0 and variance 1: levels at the first date \[dB\], and what is missed of growth \[dB per passage\].
    pub(crate) fn draw(&self, mut normal: impl FnMut() -> f64) -> (Vec<f64>, Vec<f64>) {
        let count = self.normal.mean.len();
        let mut drawn = self.normal.draw(&(0..count).map(|_| normal()).collect::<Vec<f64>>());
        match &self.missed {
            None => {
                let nothing = vec![0.0; count];
                (drawn, nothing)
            }
            Some(missed) => {
                let behind = drawn.split_off(count / 2);
                (drawn, missed.times(&behind))
            }
        }
    }
}
