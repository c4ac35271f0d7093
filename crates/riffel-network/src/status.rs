//! What is in a store.

use rayon::prelude::*;
use serde::Serialize;

use crate::NetworkError;
use crate::store::{ROWS, Store};

/// What a store holds.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Status {
    /// Length of a cell of the grid \[m\].
    pub resolution_m: f64,
    /// Shortest and longest wavelength of each band \[m\].
    pub bands_m: Vec<[f64; 2]>,
    /// Surveys of all lines.
    pub surveys: usize,
    /// The lines.
    pub lines: Vec<LineStatus>,
}

/// A line of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LineStatus {
    /// The line.
    pub line: String,
    /// Days of its surveys, the oldest first.
    pub dates: Vec<String>,
    /// First and last place of the latest \[m\].
    pub ends_m: [f64; 2],
    /// Length that is measured of each rail by the latest \[m\].
    pub measured_m: Vec<(String, f64)>,
    /// RMS over all that is measured by the latest, in each band \[m\]; `None` if nothing is.
    pub rms_m: Vec<Option<f64>>,
}

/// Lines, dates, kilometres and the RMS of the latest survey.
///
/// # Errors
/// Errors of the files.
pub fn status(store: &Store) -> Result<Status, NetworkError> {
    let (resolution, bands) = (store.resolution()?, store.bands()?);
    let surveys = store.surveys()?;
    let lines: Result<Vec<LineStatus>, NetworkError> = store
        .latest(None)?
        .par_iter()
        .map(|latest| {
            let mut sums = vec![(0.0, 0.0); bands.len()];
            for rail in &latest.rails {
                for chunk in 0..latest.cells.div_ceil(ROWS) {
                    let values = store.chunk(latest, rail, bands.len(), chunk)?;
                    for cell in values.iter().flat_map(|values| values.chunks(bands.len())) {
                        for (sum, rms) in sums.iter_mut().zip(cell) {
                            if rms.is_finite() {
                                sum.0 += rms * rms;
                                sum.1 += 1.0;
                            }
                        }
                    }
                }
            }
            let of_line = surveys.iter().filter(|survey| survey.line == latest.line);
            let rails = latest.rails.iter();
            Ok(LineStatus {
                line: latest.line.clone(),
                dates: of_line.map(|survey| survey.date.to_string()).collect(),
                ends_m: [latest.start_m, latest.start_m + latest.cells as f64 * resolution],
                measured_m: rails.map(|rail| (rail.name.clone(), rail.measured as f64 * resolution)).collect(),
                rms_m: sums.iter().map(|&(square, count)| (count > 0.0).then(|| (square / count).sqrt())).collect(),
            })
        })
        .collect();
    Ok(Status {
        resolution_m: resolution,
        bands_m: bands.iter().map(|band| [band.from(), band.to()]).collect(),
        surveys: surveys.len(),
        lines: lines?,
    })
}
