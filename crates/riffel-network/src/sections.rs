//! Cells of a survey taken together to sections of a length.

use crate::NetworkError;
use crate::record::{RailRecord, SurveyRecord};
use crate::store::{ROWS, Store};

/// Share of a section that must be known.
const ENOUGH: f64 = 0.5;

/// A section of a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Number along the line: it begins at so many lengths of a section.
    pub index: i64,
    /// First place \[m\].
    pub from: f64,
    /// Last place \[m\].
    pub to: f64,
    /// RMS in each band \[m\]; NaN where less than half of the section is known.
    pub rms: Vec<f64>,
}

/// Sections of a rail along a survey, of those lengths on which the network is judged.
///
/// The mean square of a section is that of its cells. Sections begin at whole multiples of their length, so that those of all
/// dates are the same. Memory: a chunk of cells and a row for each section.
#[derive(Debug, Clone, PartialEq)]
pub struct Sections {
    /// The rail.
    pub rail: String,
    /// Along the line; those of which nothing is known are left out.
    pub sections: Vec<Section>,
}

impl Sections {
    /// The sections of a rail of a survey, of some length \[m\].
    ///
    /// # Errors
    /// [`NetworkError::Value`] for a length below a cell of the store; [`NetworkError::Read`], [`NetworkError::Damaged`].
    pub fn of(
        store: &Store,
        survey: &SurveyRecord,
        rail: &RailRecord,
        length: f64,
    ) -> Result<Self, NetworkError> {
        let (resolution, bands) = (store.resolution()?, store.bands()?.len());
        if !(length >= resolution && length.is_finite()) {
            return Err(NetworkError::Value {
                what: "the length of a section",
                value: format!("{length} m"),
                rule: format!("at least a cell of the store, {resolution} m"),
            });
        }
        let mut sections: Vec<Section> = Vec::new();
        let mut sums: Vec<(f64, u64)> = vec![(0.0, 0); bands];
        let mut present = i64::MIN;
        let cells_each = (length / resolution).max(1.0);
        let mut close = |index: i64, sums: &mut [(f64, u64)]| {
            let rms: Vec<f64> = sums
                .iter()
                .map(
                    |&(square, count)| match count as f64 >= ENOUGH * cells_each {
                        true => (square / count as f64).sqrt(),
                        false => f64::NAN,
                    },
                )
                .collect();
            if rms.iter().any(|value| value.is_finite()) {
                let from = index as f64 * length;
                sections.push(Section {
                    index,
                    from,
                    to: from + length,
                    rms,
                });
            }
            sums.fill((0.0, 0));
        };
        for chunk in 0..survey.cells.div_ceil(ROWS) {
            let Some(values) = store.chunk(survey, rail, bands, chunk)? else {
                continue;
            };
            for (row, cell) in values.chunks(bands).enumerate() {
                let middle = (chunk * ROWS + row as u64) as f64 + 0.5;
                let index = ((survey.start_m + middle * resolution) / length).floor() as i64;
                if index != present {
                    if present != i64::MIN {
                        close(present, &mut sums);
                    }
                    present = index;
                }
                for (sum, &rms) in sums.iter_mut().zip(cell) {
                    if rms.is_finite() {
                        sum.0 += rms * rms;
                        sum.1 += 1;
                    }
                }
            }
        }
        if present != i64::MIN {
            close(present, &mut sums);
        }
        Ok(Self {
            rail: rail.name.clone(),
            sections,
        })
    }
}
