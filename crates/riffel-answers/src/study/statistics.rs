//! Outputs over the samples.

use riffel_keys::{Message, say};
use riffel_study::{ResultFolder, Study, StudyError};
use serde::Serialize;

use crate::number_alone;
use crate::{Rows, Table};

/// Most samples that are read for the table: 80 MB for each output.
const MOST_SAMPLES: u64 = 10_000_000;

/// An output that is one number for each sample, over the samples that have it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Statistics {
    /// Name of the output.
    name: String,
    /// Its unit, 1 for a ratio.
    unit: &'static str,
    /// How many samples have it.
    samples: usize,
    /// Arithmetic mean.
    mean: f64,
    /// 5 % quantile.
    quantile_05: f64,
    /// Median.
    median: f64,
    /// 95 % quantile.
    quantile_95: f64,
}

impl Statistics {
    /// The outputs of a study that are one real number for each sample; none of a study of very many samples.
    ///
    /// # Errors
    /// [`StudyError`] for results that cannot be read.
    pub(super) fn of(study: &Study, folder: &ResultFolder) -> Result<Vec<Self>, StudyError> {
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

/// The outputs as a reader sees them; without columns where there are none.
pub(super) fn table(outputs: &[Statistics]) -> Table {
    let figures = |head: Message, of: fn(&Statistics) -> f64| outputs.numbers(head, |output| four_figures(of(output)));
    let columns = match outputs.is_empty() {
        true => Vec::new(),
        false => vec![
            outputs.shown(say!(over_the_samples_column), |output| Message::verbatim(&output.name)),
            outputs.shown(say!(unit_column), |output| {
                Message::verbatim(if output.unit == "1" { "" } else { output.unit })
            }),
            figures(say!(mean_column), |output| output.mean),
            figures(number_alone("5 %"), |output| output.quantile_05),
            figures(say!(median), |output| output.median),
            figures(number_alone("95 %"), |output| output.quantile_95),
            outputs.numbers(say!(samples_column), |output| output.samples),
        ],
    };
    Table { name: "statistics", columns }
}

/// A number with four figures.
pub(super) fn four_figures(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        let before = value.abs().log10().floor().max(0.0) as usize;
        return format!("{value:.*}", 4usize.saturating_sub(before + 1).max(usize::from(value.abs() < 1.0) * 4));
    }
    format!("{value:.3e}")
}
