//! One-third-octave spectra in a table.

use std::collections::BTreeMap;

use riffel::roughness::{Spectrum, ThirdOctave};

use super::record::Refusal;
use super::sniff::tokens;

/// Names of the column of wavelengths.
const WAVELENGTH: [&str; 4] = ["wavelength", "lambda", "wellenlaenge", "wellenlänge"];
/// Names of the column of levels.
const LEVEL: [&str; 5] = ["level", "db", "pegel", "niveau", "roughness"];

/// A spectrum with what the file says of it.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelledSpectrum {
    /// The other columns of its rows and what they hold, in the order of the file.
    pub labels: Vec<(String, String)>,
    /// The spectrum.
    pub spectrum: Spectrum,
}

impl LabelledSpectrum {
    /// The spectrum of one rail of a profile.
    pub fn of_rail(name: &str, spectrum: Spectrum) -> Self {
        Self {
            labels: vec![("rail".to_owned(), name.to_owned())],
            spectrum,
        }
    }

    /// What a column holds.
    pub fn label(&self, column: &str) -> Option<&str> {
        let same = |label: &&(String, String)| label.0 == column;
        self.labels.iter().find(same).map(|label| label.1.as_str())
    }
}

/// Whether these are the names of the columns of a table of spectra: a wavelength and a level.
pub(super) fn is_header(names: &[String]) -> bool {
    column(names, &WAVELENGTH).is_some() && column(names, &LEVEL).is_some()
}

fn column(names: &[String], words: &[&str]) -> Option<usize> {
    let named = |name: &String| {
        tokens(name)
            .iter()
            .any(|token| words.contains(&token.as_str()))
    };
    names.iter().position(named)
}

/// Read the rows of a table, one for each band; those whose other columns agree make a spectrum. `above` lines
/// stand before the first.
pub(super) fn read(
    bytes: &[u8],
    above: usize,
    header: &[String],
    delimiter: u8,
    decimal_comma: bool,
) -> Result<Vec<LabelledSpectrum>, Refusal> {
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .has_headers(false)
        .from_reader(bytes);
    let line_of = |position: Option<&csv::Position>| position.map(|at| above + at.line() as usize);
    let missing = || {
        Refusal::new(
            Some(above),
            "there is no column of wavelengths, or none of levels",
        )
    };
    let wavelength = column(header, &WAVELENGTH).ok_or_else(missing)?;
    // The column of wavelengths is none of levels, whatever else its name says.
    let level = (0..header.len())
        .find(|&index| index != wavelength && column(&header[index..=index], &LEVEL).is_some())
        .ok_or_else(missing)?;
    let metres = unit(&header[wavelength]).map_err(|message| Refusal::new(Some(above), message))?;
    let mut spectra: BTreeMap<usize, Vec<(ThirdOctave, f64)>> = BTreeMap::new();
    let mut known: Vec<Vec<String>> = Vec::new();
    for record in reader.records() {
        let record = record.map_err(|error| {
            Refusal::new(line_of(error.position()), not_a_row(&error, header.len()))
        })?;
        let line = line_of(record.position());
        if record.len() != header.len() {
            let message = format!(
                "has {} columns, the header has {}",
                record.len(),
                header.len()
            );
            return Err(Refusal::new(line, message));
        }
        let number = |index: usize| {
            let cell = &record[index];
            let text = if decimal_comma {
                cell.replace(',', ".")
            } else {
                cell.to_owned()
            };
            let value = text.parse::<f64>().ok().filter(|value| value.is_finite());
            value.ok_or_else(|| {
                let name = &header[index];
                Refusal::new(
                    line,
                    format!("column `{name}` is \"{cell}\", not a finite number"),
                )
            })
        };
        let length = metres * number(wavelength)?;
        let band = ThirdOctave::containing(length)
            .map_err(|error| Refusal::new(line, error.to_string()))?;
        // A nominal wavelength is at most 1.3 % from its centre.
        let off = (length / band.wavelength() - 1.0).abs();
        if off > 0.05 {
            return Err(Refusal::new(
                line,
                format!(
                    "{} mm is no one-third-octave wavelength; the nearest is {} mm",
                    1e3 * length,
                    band.nominal_millimetres()
                ),
            ));
        }
        let value = number(level)?;
        let labels: Vec<String> = (0..header.len())
            .filter(|&index| index != wavelength && index != level)
            .map(|index| record[index].to_owned())
            .collect();
        let place = known
            .iter()
            .position(|other| *other == labels)
            .unwrap_or_else(|| {
                known.push(labels);
                known.len() - 1
            });
        let levels = spectra.entry(place).or_default();
        if levels.iter().any(|(other, _)| *other == band) {
            let wavelength = band.nominal_millimetres();
            let message = format!("{wavelength} mm is there twice in one spectrum");
            return Err(Refusal::new(line, message));
        }
        levels.push((band, value));
    }
    let names: Vec<&String> = header
        .iter()
        .enumerate()
        .filter(|(index, _)| *index != wavelength && *index != level)
        .map(|(_, name)| name)
        .collect();
    spectra
        .into_iter()
        .map(|(place, levels)| {
            let labels = names
                .iter()
                .copied()
                .cloned()
                .zip(known[place].iter().cloned());
            let spectrum =
                Spectrum::new(levels).map_err(|error| Refusal::new(None, error.to_string()))?;
            Ok(LabelledSpectrum {
                labels: labels.collect(),
                spectrum,
            })
        })
        .collect()
}

/// Why a line is no row, without the line that the reader counts from the first row.
fn not_a_row(error: &csv::Error, columns: usize) -> String {
    match error.kind() {
        csv::ErrorKind::UnequalLengths { len, .. } => {
            format!("has {len} columns, the header has {columns}")
        }
        csv::ErrorKind::Utf8 { .. } => "is not text in UTF-8".to_owned(),
        _ => error.to_string(),
    }
}

/// Unit of the wavelength from the name of its column, which must say it.
fn unit(name: &str) -> Result<f64, String> {
    let tokens = tokens(name);
    let has = |unit: &str| tokens.iter().any(|token| token == unit);
    match (has("mm"), has("cm"), has("m")) {
        (true, _, _) => Ok(1e-3),
        (_, true, _) => Ok(1e-2),
        (_, _, true) => Ok(1.0),
        _ => Err(format!(
            "column `{name}` has no unit; call it wavelength_m or wavelength_mm"
        )),
    }
}
