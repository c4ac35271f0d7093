//! One parameter at a time.

use rayon::prelude::*;

use crate::parameter::ParameterValue;
use crate::study::Study;

/// What each parameter does alone: from its low to its high quantile, all others at their median.
#[derive(Debug, Clone, PartialEq)]
pub struct Tornado {
    /// Shares of the low and the high quantile.
    pub shares: [f64; 2],
    /// All outputs with every parameter at its median, or why there are none.
    pub middle: Result<Vec<f64>, String>,
    /// One entry for each parameter, in their order.
    pub swings: Vec<Swing>,
}

/// What one parameter does.
#[derive(Debug, Clone, PartialEq)]
pub struct Swing {
    /// Its low and its high value.
    pub values: [ParameterValue; 2],
    /// All outputs at both, or why there are none.
    pub outputs: [Result<Vec<f64>, String>; 2],
}

impl Tornado {
    /// Evaluate a study at its medians and with one parameter after the other at the quantiles of two shares, such
    /// as 0.1 and 0.9: twice the number of parameters and one more samples, on the current rayon pool.
    ///
    /// The median of a list is its middle value. What parameters do together does not show: see
    /// [`SobolIndices`](super::SobolIndices).
    pub fn new(study: &Study, shares: [f64; 2]) -> Self {
        let parameters = study.parameters();
        let medians: Vec<ParameterValue> = parameters.iter().map(|p| p.value(0.5)).collect();
        let middle = study.evaluate(&medians);
        let swings = parameters
            .par_iter()
            .enumerate()
            .map(|(index, parameter)| {
                let values = shares.map(|share| parameter.value(share));
                let outputs = values.clone().map(|value| {
                    let mut all = medians.clone();
                    all[index] = value;
                    study.evaluate(&all)
                });
                Swing { values, outputs }
            })
            .collect();
        Self { shares, middle, swings }
    }
}
