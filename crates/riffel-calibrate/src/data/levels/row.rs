//! One level of roughness that was measured.

use std::path::Path;

use riffel::roughness::ThirdOctave;
use riffel_case::Case;
use riffel_keys::CaseError;

use super::table;

/// One level.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Row {
    pub(crate) band: ThirdOctave,
    /// Since the first date.
    pub(crate) passages: f64,
    /// \[dB\]
    pub(crate) level: f64,
    pub(super) error: f64,
}

/// Factor within which the nominal centre of a band lies of its exact one: 20 mm is 19.95 mm.
const NOMINAL: f64 = 1.02;

/// That the wavelengths of a table lie in the window of the case, as bands.
fn bands(numbers: &table::Numbers, path: &Path, case: &Case) -> Result<Vec<ThirdOctave>, CaseError> {
    let (shortest, longest) = (case.wavelength.min(), case.wavelength.max());
    let bands = numbers.needed[0].iter().enumerate();
    bands
        .map(|(row, millimetres)| {
            let refuse = |message: String| numbers.refuse(path, row, &message);
            let band = ThirdOctave::centred(1e-3 * millimetres);
            let band = band.map_err(|_| {
                refuse(format!("`wavelength_mm` is {millimetres}, but must be the centre of a one-third octave"))
            })?;
            let centre = band.wavelength();
            if centre * NOMINAL < shortest || centre > longest * NOMINAL {
                return Err(refuse(format!(
                    "`wavelength_mm` is {millimetres}, outside the window of the case, map.wavelength from {:.1} to {:.1} mm",
                    1e3 * shortest,
                    1e3 * longest
                )));
            }
            Ok(band)
        })
        .collect()
}

/// The levels of a table, each with its passages.
pub(super) fn rows(
    numbers: &table::Numbers,
    path: &Path,
    case: &Case,
    passages: impl Fn(usize) -> f64,
) -> Result<Vec<Row>, CaseError> {
    let bands = bands(numbers, path, case)?;
    let [level, error] = [1, 2].map(|column| &numbers.needed[column]);
    let rule = "must be greater than zero";
    numbers.check(path, "standard_error_db", error, rule, |e| e > 0.0)?;
    let row = |(row, band)| Row { band, passages: passages(row), level: level[row], error: error[row] };
    let rows: Vec<Row> = bands.into_iter().enumerate().map(row).collect();
    numbers.unless_doubled(path, &rows, |one, other| (one.band, one.passages) == (other.band, other.passages))?;
    Ok(rows)
}
