//! One-third-octave spectra in a table.

use std::collections::BTreeMap;

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::text_file::{printable, text_of};

use crate::date::read_dates;
use crate::format::{DecimalMark, Delimiter};
use crate::heading::{foreign_unit, is_date, length_in, tokens};
use crate::labelled_spectrum::LabelledSpectrum;
use crate::length_unit::metres;
use crate::level_unit::level_shift;
use crate::refusal::Refusal;
use crate::{number, plausibility, rows};

/// Names of the column of wavelengths.
const WAVELENGTH: [&str; 5] = ["wavelength", "lambda", "λ", "wellenlaenge", "wellenlänge"];
/// Names of the column of levels.
const LEVEL: [&str; 5] = ["level", "db", "pegel", "niveau", "roughness"];

/// Where a table of spectra has its wavelengths and levels.
pub(super) enum Columns {
    /// A row for each band.
    Long {
        /// Column of the wavelength.
        wavelength: usize,
        /// Columns of levels.
        levels: Vec<usize>,
    },
    /// A column for each band.
    Wide {
        /// The columns and the numbers in their names.
        bands: Vec<(usize, f64)>,
        /// Size of their unit \[m\]; None if no name has one.
        unit: Option<f64>,
    },
}

/// The rows of a table.
pub(super) struct Rows<'a> {
    /// From the first row on.
    pub(super) text: &'a [u8],
    /// Lines above it.
    pub(super) above: usize,
    /// Names of the columns.
    pub(super) header: &'a [String],
    pub(super) delimiter: Delimiter,
    pub(super) decimal: DecimalMark,
}

impl Columns {
    /// The columns of a table of spectra by their names; None for other tables. `numeric` tells which hold numbers.
    pub(super) fn of(header: &[String], numeric: &[bool], decimal: DecimalMark) -> Option<Self> {
        let named = |index: usize, words: &[&str]| {
            let tokens = tokens(&header[index]);
            tokens.iter().any(|token| words.contains(&token.as_str()))
        };
        let others =
            |wavelength: usize| (0..header.len()).filter(move |&index| index != wavelength);
        if let Some(wavelength) = (0..header.len()).find(|&index| named(index, &WAVELENGTH))
            && numeric.get(wavelength) == Some(&true)
        {
            // The column of wavelengths is none of levels, whatever else its name says.
            let mut levels: Vec<usize> = others(wavelength)
                .filter(|&index| named(index, &LEVEL))
                .collect();
            if levels.is_empty() {
                let holds_numbers = |index: &usize| numeric.get(*index) == Some(&true);
                levels = others(wavelength).filter(holds_numbers).collect();
            }
            return (!levels.is_empty()).then_some(Self::Long { wavelength, levels });
        }
        Self::wide(header, decimal)
    }

    fn wide(header: &[String], decimal: DecimalMark) -> Option<Self> {
        /// Columns of bands with a unit, and without, from which a table is one of spectra.
        const LEAST: (usize, usize) = (3, 5);
        let named: Vec<(usize, f64, Option<f64>)> = header
            .iter()
            .enumerate()
            .filter_map(|(index, name)| {
                band_name(name, decimal).map(|(number, unit)| (index, number, unit))
            })
            .collect();
        // The corner may say it for all, as in "site \ wavelength mm".
        let bands: Vec<usize> = named.iter().map(|band| band.0).collect();
        let corner = header
            .iter()
            .enumerate()
            .filter(|(index, name)| {
                !bands.contains(index)
                    && tokens(name)
                        .iter()
                        .any(|word| WAVELENGTH.contains(&word.as_str()))
            })
            .find_map(|(_, name)| unit(name).ok());
        let unit = named.iter().find_map(|band| band.2).or(corner);
        // Numbers without a unit are names of other things, unless all are those of bands.
        let is_band = |number: f64| {
            let size = unit.unwrap_or(1e-3);
            let band = ThirdOctave::containing(size * number);
            let tolerance = if unit.is_some() { OFF_CENTRE } else { 0.02 };
            band.is_ok_and(|band| (size * number / band.wavelength() - 1.0).abs() < tolerance)
        };
        let least = if unit.is_some() { LEAST.0 } else { LEAST.1 };
        let all = named.len() >= least && named.iter().all(|(_, number, _)| is_band(*number));
        all.then(|| Self::Wide {
            bands: named
                .iter()
                .map(|(index, number, _)| (*index, *number))
                .collect(),
            unit,
        })
    }
}

/// The number in the name of a column that a band has, and its unit if it has one: "31.5 mm", "L_31.5mm", "λ = 20 mm",
/// "25".
fn band_name(name: &str, decimal: DecimalMark) -> Option<(f64, Option<f64>)> {
    let begin = name.find(|c: char| c.is_ascii_digit())?;
    let before = tokens(&name[..begin]);
    let known = [
        "l",
        "lambda",
        "λ",
        "band",
        "w",
        "wavelength",
        "level",
        "pegel",
        "db",
    ];
    if !before.iter().all(|word| known.contains(&word.as_str())) {
        return None;
    }
    let rest = &name[begin..];
    let length = rest
        .find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ','))
        .unwrap_or(rest.len());
    let mark = char::from(decimal.byte());
    let number = rest[..length].replace([mark, ','], ".");
    let behind = tokens(&rest[length..]);
    let unit = match behind.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] | ["db"] => None,
        ["mm"] | ["mm", "db"] => Some(1e-3),
        ["cm"] | ["cm", "db"] => Some(1e-2),
        ["m"] | ["m", "db"] => Some(1.0),
        _ => return None,
    };
    Some((number.parse().ok()?, unit))
}

/// Largest distance of a wavelength from the centre of its band: a nominal one is at most 1.3 % off.
const OFF_CENTRE: f64 = 0.05;

/// The band of a wavelength \[m\].
fn band_of(length: f64) -> Result<ThirdOctave, String> {
    let band = ThirdOctave::containing(length).map_err(|error| error.to_string())?;
    if (length / band.wavelength() - 1.0).abs() > OFF_CENTRE {
        return Err(format!(
            "{} mm is no one-third-octave wavelength; the nearest is {} mm",
            1e3 * length,
            band.nominal_millimetres()
        ));
    }
    Ok(band)
}

impl<'a> Rows<'a> {
    /// Line and cells of each row.
    fn cells(&self) -> impl Iterator<Item = Result<(usize, Vec<&'a [u8]>), Refusal>> {
        let lines = rows::lines(self.text).enumerate();
        lines
            .filter(|(_, line)| !rows::is_comment(line))
            .map(|(index, line)| {
                let line_number = self.above + index + 1;
                let mut cells = rows::cells(line, self.delimiter);
                // An empty label at the end leaves no cell.
                if cells.len() + 1 == self.header.len()
                    && line.trim_ascii_end().ends_with(&[self.delimiter.byte()])
                {
                    cells.push(b"");
                }
                let (has, columns) = (cells.len(), self.header.len());
                if has == columns {
                    return Ok((line_number, cells));
                }
                let message = format!("has {has} columns, the header has {columns}");
                Err(Refusal::new(Some(line_number), message))
            })
    }

    /// A number; not a number where there is none.
    fn number(&self, line: usize, cells: &[&[u8]], index: usize) -> Result<f64, Refusal> {
        number::parse(cells[index], self.decimal.byte())
            .ok_or_else(|| self.no_number(line, cells, index))
    }

    fn no_number(&self, line: usize, cells: &[&[u8]], index: usize) -> Refusal {
        let (name, cell) = (&self.header[index], label(cells[index]));
        Refusal::new(
            Some(line),
            format!("column `{name}` is \"{cell}\", not a finite number"),
        )
    }
}

/// Text of a cell as it is shown.
fn label(cell: &[u8]) -> String {
    let text = text_of(cell);
    let text = text
        .strip_prefix('"')
        .and_then(|text| text.strip_suffix('"'))
        .unwrap_or(&text);
    printable(text.trim()).into_owned()
}

/// Read the rows of a table. With a row for each band, those whose other columns agree make a spectrum.
pub(super) fn read(rows: &Rows<'_>, columns: &Columns) -> Result<Vec<LabelledSpectrum>, Refusal> {
    let mut spectra = match columns {
        Columns::Long { wavelength, levels } => read_long(rows, *wavelength, levels)?,
        Columns::Wide { bands, unit } => read_wide(rows, bands, *unit)?,
    };
    let levels = spectra
        .iter()
        .flat_map(|spectrum| spectrum.spectrum.levels());
    plausibility::check_levels(levels.map(|level| level.level))?;
    write_dates_alike(&mut spectra);
    Ok(spectra)
}

/// A band for each row.
fn read_long(
    rows: &Rows<'_>,
    wavelength: usize,
    levels: &[usize],
) -> Result<Vec<LabelledSpectrum>, Refusal> {
    let header = rows.header;
    let in_header = |message: String| Refusal::new(Some(rows.above), message);
    let metres = unit(&header[wavelength]).map_err(in_header)?;
    let shifts = levels
        .iter()
        .map(|&level| level_shift(&header[level]).map_err(in_header))
        .collect::<Result<Vec<f64>, Refusal>>()?;
    let mut spectra: BTreeMap<usize, Vec<(ThirdOctave, f64)>> = BTreeMap::new();
    let mut known: Vec<Vec<String>> = Vec::new();
    for row in rows.cells() {
        let (line, cells) = row?;
        let length = metres * rows.number(line, &cells, wavelength)?;
        if !length.is_finite() {
            return Err(rows.no_number(line, &cells, wavelength));
        }
        let written = label(cells[wavelength]);
        let band = check_length(length, &written, &header[wavelength])
            .and_then(|()| band_of(length))
            .map_err(|message| Refusal::new(Some(line), message))?;
        for (&level, shift) in levels.iter().zip(&shifts) {
            let value = rows.number(line, &cells, level)? + shift;
            if !value.is_finite() {
                // One of several may have no level in a band.
                if levels.len() > 1 {
                    continue;
                }
                return Err(rows.no_number(line, &cells, level));
            }
            let mut labels: Vec<String> = (0..header.len())
                .filter(|index| *index != wavelength && !levels.contains(index))
                .map(|index| label(cells[index]))
                .collect();
            if levels.len() > 1 {
                labels.push(header[level].clone());
            }
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
                return Err(Refusal::new(Some(line), message));
            }
            levels.push((band, value));
        }
    }
    let mut names: Vec<String> = (0..header.len())
        .filter(|index| *index != wavelength && !levels.contains(index))
        .map(|index| header[index].clone())
        .collect();
    if levels.len() > 1 {
        let taken = names.iter().any(|name| name == "rail");
        names.push(if taken { "column" } else { "rail" }.to_owned());
    }
    spectra
        .into_iter()
        .map(|(place, levels)| labelled(&names, &known[place], levels))
        .collect()
}

/// A spectrum for each row.
fn read_wide(
    rows: &Rows<'_>,
    bands: &[(usize, f64)],
    unit: Option<f64>,
) -> Result<Vec<LabelledSpectrum>, Refusal> {
    let header = rows.header;
    let wrong = |message: String| Refusal::new(Some(rows.above), message);
    let Some(unit) = unit else {
        let (first, last) = (bands[0].0, bands[bands.len() - 1].0);
        return Err(wrong(format!(
            "the columns `{}` to `{}` look like the wavelengths of bands, but have no unit; write {} mm",
            header[first], header[last], header[first]
        )));
    };
    let mut found: Vec<(usize, ThirdOctave)> = Vec::new();
    for &(index, number) in bands {
        let band = band_of(unit * number).map_err(wrong)?;
        if found.iter().any(|(_, other)| *other == band) {
            return Err(wrong(format!(
                "{} mm is there twice",
                band.nominal_millimetres()
            )));
        }
        found.push((index, band));
    }
    let others: Vec<usize> = (0..header.len())
        .filter(|index| found.iter().all(|(band, _)| band != index))
        .collect();
    let names: Vec<String> = others.iter().map(|&index| header[index].clone()).collect();
    rows.cells()
        .map(|row| {
            let (line, cells) = row?;
            let mut levels = Vec::new();
            for &(index, band) in &found {
                let value = rows.number(line, &cells, index)?;
                if value.is_finite() {
                    levels.push((band, value));
                }
            }
            if levels.is_empty() {
                return Err(Refusal::new(Some(line), "has no level in any band"));
            }
            let labels: Vec<String> = others.iter().map(|&index| label(cells[index])).collect();
            labelled(&names, &labels, levels)
        })
        .collect()
}

fn labelled(
    names: &[String],
    labels: &[String],
    levels: Vec<(ThirdOctave, f64)>,
) -> Result<LabelledSpectrum, Refusal> {
    let spectrum = Spectrum::new(levels).map_err(|error| Refusal::new(None, error.to_string()))?;
    Ok(LabelledSpectrum {
        labels: names.iter().cloned().zip(labels.iter().cloned()).collect(),
        spectrum,
    })
}

/// Columns of dates as in 2026-01-31, whatever the file writes, where the whole column leaves no doubt.
fn write_dates_alike(spectra: &mut [LabelledSpectrum]) {
    let columns = spectra.first().map_or(0, |first| first.labels.len());
    for column in 0..columns {
        if !is_date(&spectra[0].labels[column].0) {
            continue;
        }
        let texts = spectra
            .iter()
            .map(|spectrum| spectrum.labels[column].1.as_str());
        if let Ok(dates) = read_dates(texts) {
            for (spectrum, date) in spectra.iter_mut().zip(dates) {
                spectrum.labels[column].1 = date.to_string();
            }
        }
    }
}

/// Size of the unit of the wavelength \[m\] from the name of its column, which must say it.
fn unit(name: &str) -> Result<f64, String> {
    match (length_in(name).and_then(metres), foreign_unit(name)) {
        (Some(size), None) => Ok(size),
        (_, Some(foreign)) => Err(format!(
            "column `{name}` is in {foreign}, which is no length known here; call it wavelength_m or wavelength_mm"
        )),
        (None, None) => Err(format!(
            "column `{name}` has no unit; call it wavelength_m or wavelength_mm"
        )),
    }
}

/// Refuse a wavelength \[m\] that no record of a rail holds: the unit of its column is wrong.
fn check_length(length: f64, written: &str, name: &str) -> Result<(), String> {
    /// Instruments sample every millimetre and are held straight over a few metres; a unit that is wrong is off by ten
    /// and more.
    const KNOWN: (f64, f64) = (1e-3, 10.0);
    if (KNOWN.0..=KNOWN.1).contains(&length) {
        return Ok(());
    }
    Err(format!(
        "column `{name}` is {written}, but roughness has wavelengths between 1 mm and 10 m; is its unit right?"
    ))
}
