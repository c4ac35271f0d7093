//! Outputs over the samples.

use riffel_study::{ResultFolder, Study, StudyError};
use serde::Serialize;

/// Most samples that are read for the table: 80 MB for each output.
const MOST_SAMPLES: u64 = 10_000_000;

/// An output that is one number for each sample, over the samples that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Statistics {
    /// Name of the output.
    pub name: String,
    /// Its unit, 1 for a ratio.
    pub unit: &'static str,
    /// How many samples have it.
    pub samples: usize,
    /// Arithmetic mean.
    pub mean: f64,
    /// 5 % quantile.
    pub quantile_05: f64,
    /// Median.
    pub median: f64,
    /// 95 % quantile.
    pub quantile_95: f64,
}

impl Statistics {
    /// The outputs of a study that are one real number for each sample; none of a study of very many samples.
    ///
    /// # Errors
    /// [`StudyError`] for results that cannot be read.
    pub fn of(study: &Study, folder: &ResultFolder) -> Result<Vec<Self>, StudyError> {
        if study.samples() > MOST_SAMPLES {
            return Ok(Vec::new());
        }
        let outputs = study.outputs().variables().iter();
        let scalars = outputs.filter(|variable| variable.dimensions.is_empty() && !variable.complex);
        let mut all = Vec::new();
        for variable in scalars {
            let mut values = folder.output(&variable.name)?;
            values.retain(|value| !value.is_nan());
            values.sort_by(f64::total_cmp);
            if values.is_empty() {
                continue;
            }
            let quantile = |share| riffel_study::sensitivity::quantile(&values, share);
            all.push(Self {
                name: variable.name.clone(),
                unit: variable.unit,
                samples: values.len(),
                mean: values.iter().sum::<f64>() / values.len() as f64,
                quantile_05: quantile(0.05),
                median: quantile(0.5),
                quantile_95: quantile(0.95),
            });
        }
        Ok(all)
    }
}

/// A number with four figures.
pub fn four_figures(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        let before = value.abs().log10().floor().max(0.0) as usize;
        return format!("{value:.*}", 4usize.saturating_sub(before + 1).max(usize::from(value.abs() < 1.0) * 4));
    }
    format!("{value:.3e}")
}
