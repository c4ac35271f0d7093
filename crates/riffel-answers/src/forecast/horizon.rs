//! How far a forecast goes.

use riffel_case::traffic::TrafficOnCase;

use crate::{AnswerError, Result};

/// How far to look ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ForecastHorizon {
    /// So many axle passages.
    Passages(f64),
    /// So many million gross tonnes.
    MillionGrossTonnes(f64),
    /// So many months, where the traffic says how much of it there is.
    Months(f64),
}

impl ForecastHorizon {
    /// `Ok` for a number above zero and no more than a thousand years and their traffic.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for any other.
    pub fn check(self) -> Result<()> {
        let (argument, value, most) = match self {
            Self::Passages(passages) => ("--passages", passages, 1e12),
            Self::MillionGrossTonnes(mgt) => ("--mgt", mgt, 1e6),
            Self::Months(months) => ("--months", months, 12_000.0),
        };
        if value > 0.0 && value <= most {
            return Ok(());
        }
        Err(AnswerError::argument(argument, value, format!("above zero and at most {most}")))
    }

    /// The horizon in axle passages.
    ///
    /// # Errors
    /// [`AnswerError::NoPassagesPerDay`] for months under a traffic of unknown amount.
    pub fn passages(self, on: &TrafficOnCase) -> Result<f64> {
        match self {
            Self::Passages(passages) => Ok(passages),
            Self::MillionGrossTonnes(mgt) => Ok(on.growth.passages(mgt)),
            Self::Months(months) => {
                on.passages_per_month().map(|per_month| per_month * months).ok_or(AnswerError::NoPassagesPerDay)
            }
        }
    }
}
