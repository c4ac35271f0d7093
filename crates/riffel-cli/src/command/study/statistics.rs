//! Outputs over the samples.

use riffel_study::{ResultFolder, Study, StudyError};
use serde::Serialize;

use crate::output::table;

/// Most samples that are read for the table: 80 MB for each output.
const MOST_SAMPLES: u64 = 10_000_000;

/// An output that is one number for each sample, over the samples that have it.
#[derive(Serialize)]
pub(super) struct Statistics {
    name: String,
    unit: &'static str,
    samples: usize,
    mean: f64,
    quantile_05: f64,
    median: f64,
    quantile_95: f64,
}

impl Statistics {
    pub(super) fn of(study: &Study, folder: &ResultFolder) -> Result<Vec<Self>, StudyError> {
        if study.samples() > MOST_SAMPLES {
            return Ok(Vec::new());
        }
        let outputs = study.outputs().variables().iter();
        let scalars =
            outputs.filter(|variable| variable.dimensions.is_empty() && !variable.complex);
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

/// The outputs as a table, nothing where there are none.
pub(super) fn table_of(outputs: &[Statistics]) -> String {
    if outputs.is_empty() {
        return String::new();
    }
    let mut table = table(&[
        "over the samples",
        "unit",
        "mean",
        "5 %",
        "median",
        "95 %",
        "samples",
    ]);
    for output in outputs {
        let numbers = [
            output.mean,
            output.quantile_05,
            output.median,
            output.quantile_95,
        ];
        let [mean, low, median, high] = numbers.map(figures);
        let samples = output.samples.to_string();
        let unit = if output.unit == "1" { "" } else { output.unit };
        table.add_row([
            output.name.clone(),
            unit.to_owned(),
            mean,
            low,
            median,
            high,
            samples,
        ]);
    }
    format!("{table}\n")
}

/// A number with four figures.
pub(super) fn figures(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        let before = value.abs().log10().floor().max(0.0) as usize;
        return format!(
            "{value:.*}",
            4usize
                .saturating_sub(before + 1)
                .max(usize::from(value.abs() < 1.0) * 4)
        );
    }
    format!("{value:.3e}")
}
