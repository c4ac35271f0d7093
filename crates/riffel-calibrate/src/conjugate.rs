//! The closed forms of `validation/calibration/conjugate.json`, for tests.

use serde_json::Value;

use crate::linear::{Known, Normal};
use crate::matrix::Matrix;

fn at(pointer: &str) -> Value {
    let text = include_str!("../../../validation/calibration/conjugate.json");
    let document: Value = serde_json::from_str(text).unwrap();
    document.pointer(pointer).unwrap().clone()
}

pub(crate) fn number(pointer: &str) -> f64 {
    at(pointer).as_f64().unwrap()
}

pub(crate) fn numbers(pointer: &str) -> Vec<f64> {
    let list = at(pointer);
    let list = list.as_array().unwrap().iter();
    list.map(|number| number.as_f64().unwrap()).collect()
}

/// Three bands at three dates that grow by κ times a slope: y = L_b + κ s_b N + c_t + ε, errors 0.5 dB and 0.3 dB for all of a
/// date.
pub(crate) struct U1 {
    pub(crate) slopes: Vec<f64>,
    passages: Vec<f64>,
    levels: Vec<Vec<f64>>,
}

impl U1 {
    pub(crate) fn read() -> Self {
        let levels = (0..3).map(|date| numbers(&format!("/U1/levels_db/{date}")));
        Self {
            slopes: numbers("/U1/slopes_db_per_1e6"),
            passages: numbers("/U1/passages_1e6"),
            levels: levels.collect(),
        }
    }

    pub(crate) fn numbers(&self, pointer: &str) -> Vec<f64> {
        numbers(&format!("/U1{pointer}"))
    }

    /// κ ~ N(1, 1), L_b ~ N(0, 10²).
    pub(crate) fn proper(&self) -> Vec<Known> {
        self.known(1e-2)
    }

    /// κ ~ N(1, 1), nothing known of L_b.
    pub(crate) fn flat(&self) -> Vec<Known> {
        self.known(0.0)
    }

    fn known(&self, of_levels: f64) -> Vec<Known> {
        let growth = Known {
            mean: 1.0,
            precision: 1.0,
        };
        let level = Known {
            mean: 0.0,
            precision: of_levels,
        };
        vec![growth, level, level, level]
    }

    /// Columns of κ and of the levels, covariance of the errors and data of some dates.
    pub(crate) fn equations(&self, dates: &[usize]) -> (Vec<Vec<f64>>, Matrix, Vec<f64>) {
        let rows: Vec<(usize, usize)> = dates
            .iter()
            .flat_map(|date| (0..3).map(move |band| (*date, band)))
            .collect();
        let growth = rows.iter();
        let growth = growth.map(|(date, band)| self.slopes[*band] * self.passages[*date]);
        let mut columns = vec![growth.collect()];
        columns.extend((0..3).map(|own| {
            let is_own = rows
                .iter()
                .map(|(_, band)| f64::from(u8::from(*band == own)));
            is_own.collect::<Vec<f64>>()
        }));
        let errors = Matrix::of(rows.len(), |i, j| {
            let own = if i == j { 0.25 } else { 0.0 };
            own + if rows[i].0 == rows[j].0 { 0.09 } else { 0.0 }
        });
        let data = rows.iter().map(|(date, band)| self.levels[*date][*band]);
        (columns, errors, data.collect())
    }

    pub(crate) fn after(&self, known: &[Known]) -> Normal {
        self.after_dates(known, &[0, 1, 2])
    }

    pub(crate) fn after_dates(&self, known: &[Known], dates: &[usize]) -> Normal {
        let (columns, errors, data) = self.equations(dates);
        Normal::after(known, &columns, &errors.cholesky().unwrap(), &data).unwrap()
    }
}
