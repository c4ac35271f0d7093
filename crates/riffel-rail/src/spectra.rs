//! One-third-octave spectra in a table.

use std::collections::BTreeMap;

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_keys::table::{DecimalMark, Kind, Row, Table, foreign_unit, is_mark, is_one_of, length_in, rows, words};
use riffel_keys::{Message, say};

use crate::date_column::{dates_of_heads, write_dates_alike};
use crate::labelled_spectrum::LabelledSpectrum;
use crate::length_unit::metres;
use crate::level_unit::level_shift;
use crate::no_rail::is_statistic;
use crate::plausibility;
use crate::profile_columns::{left_out_sentence, names_a_rail};
use crate::refusal::Refusal;

/// Names of the column of wavelengths.
const WAVELENGTH: &str = "wavelength|lambda|λ|wellenlaenge|wellenlänge|longueur|longitud|lunghezza|golflengte";
/// Names of the column of levels.
const LEVEL: &str = "level|db|pegel|niveau|roughness";
/// Names of what lies about the levels of a rail, and is no level if there are others.
const EXTREME: &str = "min|max|minimum|maximum";

/// Where a table of spectra has its wavelengths and levels.
pub(super) enum Columns {
    /// A row for each band.
    Long {
        /// Column of the wavelength.
        wavelength: usize,
        /// Columns of levels.
        levels: Vec<usize>,
        /// Columns that tell spectra apart.
        labels: Vec<usize>,
        /// Columns of numbers that are neither.
        others: Vec<usize>,
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
    text: &'a [u8],
    table: &'a Table,
    /// Names of the columns.
    header: &'a [String],
}

impl Columns {
    /// The columns of a table of spectra by their names; None for other tables.
    pub(super) fn of(header: &[String], table: &Table) -> Option<Self> {
        // Text under the head of a rail is refused with its first cell.
        let is_numeric = |index: usize| {
            table.kind(index).is_of_numbers() || table.kind(index) == Kind::Text && names_a_rail(table, index)
        };
        let named = |index: usize, known: &str| {
            let own = words(&header[index]);
            own.iter().any(|word| is_one_of(word, known))
        };
        let wavelength = (0..header.len()).find(|&index| named(index, WAVELENGTH));
        let Some(wavelength) = wavelength.filter(|&index| is_numeric(index)) else {
            return Self::wide(header, table.decimal);
        };
        // The column of wavelengths is none of levels, whatever else its name says.
        let others: Vec<usize> =
            (0..header.len()).filter(|&index| index != wavelength && !table.is_index(index)).collect();
        let of = |is: &dyn Fn(usize) -> bool, columns: &[usize]| -> Option<Vec<usize>> {
            let kept: Vec<usize> = columns.iter().copied().filter(|&index| is(index)).collect();
            (!kept.is_empty()).then_some(kept)
        };
        let is_level = |index: usize| named(index, LEVEL) || is_numeric(index) && names_a_rail(table, index);
        let levels = of(&is_level, &others).or_else(|| of(&|index| is_numeric(index), &others))?;
        // Limits, scatter and extremes stand beside the levels of rails.
        let levels = of(&|index| !is_statistic(&words(&header[index])), &levels).unwrap_or(levels);
        let levels = of(&|index| !named(index, EXTREME), &levels).unwrap_or(levels);
        let is_left_out =
            |index: usize| is_numeric(index) && (is_statistic(&words(&header[index])) || named(index, EXTREME));
        let labels = others.into_iter();
        let labels = labels.filter(|&index| !levels.contains(&index) && !is_left_out(index));
        let labels: Vec<usize> = labels.collect();
        let is_other = |index: &usize| *index != wavelength && !levels.contains(index) && !labels.contains(index);
        Some(Self::Long { wavelength, others: (0..header.len()).filter(is_other).collect(), levels, labels })
    }

    /// Columns of numbers that were left out, a sentence for each.
    fn left_out(&self, rows: &Rows<'_>) -> Vec<Message> {
        let Self::Long { others, .. } = self else {
            return Vec::new();
        };
        let sentences = others.iter().map(|&column| {
            let why = match rows.table.is_index(column) {
                true => say!(it_numbers_the_rows),
                false => say!(it_is_a_statistic),
            };
            left_out_sentence(column, &rows.header[column], why)
        });
        sentences.collect()
    }

    fn wide(header: &[String], decimal: DecimalMark) -> Option<Self> {
        /// Columns of bands with a unit, and without, from which a table is one of spectra.
        const LEAST: (usize, usize) = (3, 5);
        let named: Vec<(usize, f64, Option<f64>)> = header
            .iter()
            .enumerate()
            .filter_map(|(index, name)| band_name(name, decimal).map(|(number, unit)| (index, number, unit)))
            .collect();
        // The corner may say it for all, as in "site \ wavelength mm".
        let bands: Vec<usize> = named.iter().map(|band| band.0).collect();
        let corner = header
            .iter()
            .enumerate()
            .filter(|(index, name)| {
                !bands.contains(index) && words(name).iter().any(|word| is_one_of(word, WAVELENGTH))
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
        all.then(|| Self::Wide { bands: named.iter().map(|(index, number, _)| (*index, *number)).collect(), unit })
    }
}

/// The number in the name of a column that a band has, and its unit if it has one: "31.5 mm", "L_31.5mm", "λ = 20 mm",
/// "25".
fn band_name(name: &str, decimal: DecimalMark) -> Option<(f64, Option<f64>)> {
    let begin = name.find(|c: char| c.is_ascii_digit())?;
    const KNOWN: &str = "l|lambda|λ|band|w|wavelength|level|pegel|db";
    if !words(&name[..begin]).iter().all(|word| is_one_of(word, KNOWN)) {
        return None;
    }
    let rest = &name[begin..];
    let length = rest.find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ',')).unwrap_or(rest.len());
    let mark = char::from(decimal.byte());
    let number = rest[..length].replace([mark, ','], ".");
    let behind = words(&rest[length..]);
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
    /// `text` is that in which the table was found under a header.
    pub(super) fn new(text: &'a [u8], table: &'a Table, header: &'a [String]) -> Self {
        Self { text, table, header }
    }

    fn rows(&self) -> impl Iterator<Item = Result<Row<'a>, Refusal>> {
        let (table, columns) = (self.table, self.header.len());
        let rows = rows(self.text, table.header_lines, table.delimiter, Some(table.decimal));
        rows.map(move |mut row| {
            while row.cells.len() > columns && row.cells.last().is_some_and(|cell| cell.is_empty()) {
                row.cells.pop();
            }
            let has = row.cells.len();
            if has == columns {
                return Ok(row);
            }
            let message = format!("has {has} columns, the header has {columns}");
            Err(Refusal::new(Some(row.line), message))
        })
    }

    /// A number; NaN where there is none, or the mark of a missing one, which no level is.
    fn number(&self, row: &Row<'_>, index: usize) -> Result<f64, Refusal> {
        let value = row.value(index).ok_or_else(|| self.no_number(row, index))?;
        Ok(if is_mark(value) { f64::NAN } else { value })
    }

    fn no_number(&self, row: &Row<'_>, index: usize) -> Refusal {
        let (name, cell) = (&self.header[index], row.text(index));
        Refusal::new(Some(row.line), format!("column `{name}` is \"{cell}\", not a finite number"))
    }

    /// A refusal of the header.
    fn in_header(&self, message: String) -> Refusal {
        Refusal::new(Some(self.table.header_lines), message)
    }
}

/// Read the rows of a table, and what is said of its columns. With a row for each band, those whose other columns agree make
/// a spectrum.
pub(super) fn read(rows: &Rows<'_>, columns: &Columns) -> Result<(Vec<LabelledSpectrum>, Vec<Message>), Refusal> {
    let (lines, mut spectra): (Vec<usize>, Vec<LabelledSpectrum>) = match columns {
        Columns::Long { wavelength, levels, labels, .. } => read_long(rows, *wavelength, levels, labels)?,
        Columns::Wide { bands, unit } => read_wide(rows, bands, *unit)?,
    }
    .into_iter()
    .unzip();
    refuse_octaves(&spectra)?;
    let levels = spectra.iter().flat_map(|spectrum| spectrum.spectrum.levels());
    plausibility::check_levels(levels.map(|level| level.level))?;
    let dates =
        write_dates_alike(&mut spectra).map_err(|no_date| Refusal::new(Some(lines[no_date.place]), no_date.message))?;
    let remarks = columns.left_out(rows).into_iter().chain(dates);
    Ok((spectra, remarks.collect()))
}

/// Octaves are no one-third octaves: each of their levels is the sum of three.
fn refuse_octaves(spectra: &[LabelledSpectrum]) -> Result<(), Refusal> {
    const FEWEST: usize = 4;
    let are_octaves = |spectrum: &LabelledSpectrum| {
        let bands = spectrum.spectrum.levels().iter().map(|level| level.band.index());
        let mut bands: Vec<i32> = bands.collect();
        bands.sort_unstable();
        bands.len() >= FEWEST && bands.windows(2).all(|pair| pair[1] - pair[0] == 3)
    };
    if !spectra.is_empty() && spectra.iter().all(are_octaves) {
        let message = "the wavelengths are those of octaves, but limits and spectra are of one-third octaves, whose levels \
                       are lower";
        return Err(Refusal::new(None, message));
    }
    Ok(())
}

/// A band for each row: spectra with the line on which each begins.
fn read_long(
    rows: &Rows<'_>,
    wavelength: usize,
    levels: &[usize],
    labels: &[usize],
) -> Result<Vec<(usize, LabelledSpectrum)>, Refusal> {
    let header = rows.header;
    let metres = unit(&header[wavelength]).map_err(|message| rows.in_header(message))?;
    let shifts = levels
        .iter()
        .map(|&level| level_shift(&header[level]).map_err(|message| rows.in_header(message)))
        .collect::<Result<Vec<f64>, Refusal>>()?;
    let mut spectra: BTreeMap<usize, Vec<(ThirdOctave, f64)>> = BTreeMap::new();
    let mut known: Vec<(usize, Vec<String>)> = Vec::new();
    let heads: Vec<&str> = levels.iter().map(|&level| header[level].as_str()).collect();
    let dated = dates_of_heads(&heads);
    for row in rows.rows() {
        let row = row?;
        let at = |message: String| Refusal::new(Some(row.line), message);
        let length = metres * rows.number(&row, wavelength)?;
        if !length.is_finite() {
            return Err(rows.no_number(&row, wavelength));
        }
        let band = check_length(length, &row.text(wavelength), &header[wavelength])
            .and_then(|()| band_of(length))
            .map_err(at)?;
        for (column, (&level, shift)) in levels.iter().zip(&shifts).enumerate() {
            let value = rows.number(&row, level)? + shift;
            if !value.is_finite() {
                // One of several may have no level in a band.
                if levels.len() > 1 {
                    continue;
                }
                return Err(rows.no_number(&row, level));
            }
            let mut own: Vec<String> = labels.iter().map(|&label| row.text(label)).collect();
            match (&dated, levels.len()) {
                (Some(dated), _) => {
                    let (date, rest) = &dated[column];
                    own.extend([rest.clone(), date.to_string()]);
                }
                (None, 1) => {}
                (None, _) => own.push(header[level].clone()),
            }
            let place = known.iter().position(|(_, other)| *other == own);
            let place = place.unwrap_or_else(|| {
                known.push((row.line, own));
                known.len() - 1
            });
            let levels = spectra.entry(place).or_default();
            if levels.iter().any(|(other, _)| *other == band) {
                let wavelength = band.nominal_millimetres();
                return Err(at(format!("{wavelength} mm is there twice in one spectrum")));
            }
            levels.push((band, value));
        }
    }
    let mut names: Vec<String> = labels.iter().map(|&label| header[label].clone()).collect();
    if levels.len() > 1 {
        let taken = names.iter().any(|name| name == "rail");
        names.push(if taken { "column" } else { "rail" }.to_owned());
    }
    names.extend(dated.map(|_| "date".to_owned()));
    spectra
        .into_iter()
        .map(|(place, levels)| {
            let (line, labels) = &known[place];
            Ok((*line, labelled(&names, labels, levels)?))
        })
        .collect()
}

/// A spectrum for each row, with its line.
fn read_wide(
    rows: &Rows<'_>,
    bands: &[(usize, f64)],
    unit: Option<f64>,
) -> Result<Vec<(usize, LabelledSpectrum)>, Refusal> {
    let header = rows.header;
    let wrong = |message: String| rows.in_header(message);
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
            return Err(wrong(format!("{} mm is there twice", band.nominal_millimetres())));
        }
        found.push((index, band));
    }
    let others: Vec<usize> = (0..header.len()).filter(|index| found.iter().all(|(band, _)| band != index)).collect();
    let names: Vec<String> = others.iter().map(|&index| header[index].clone()).collect();
    rows.rows()
        .map(|row| {
            let row = row?;
            let mut levels = Vec::new();
            for &(index, band) in &found {
                let value = rows.number(&row, index)?;
                if value.is_finite() {
                    levels.push((band, value));
                }
            }
            if levels.is_empty() {
                return Err(Refusal::new(Some(row.line), "has no level in any band"));
            }
            let labels: Vec<String> = others.iter().map(|&index| row.text(index)).collect();
            Ok((row.line, labelled(&names, &labels, levels)?))
        })
        .collect()
}

fn labelled(names: &[String], labels: &[String], levels: Vec<(ThirdOctave, f64)>) -> Result<LabelledSpectrum, Refusal> {
    let spectrum = Spectrum::new(levels).map_err(|error| Refusal::new(None, error.to_string()))?;
    Ok(LabelledSpectrum { labels: names.iter().cloned().zip(labels.iter().cloned()).collect(), spectrum })
}

/// Size of the unit of the wavelength \[m\] from the name of its column, which must say it.
fn unit(name: &str) -> Result<f64, String> {
    match (length_in(name).and_then(metres), foreign_unit(name)) {
        (Some(size), None) => Ok(size),
        (_, Some(foreign)) => Err(format!(
            "column `{name}` is in {foreign}, which is no length known here; call it wavelength_m or wavelength_mm"
        )),
        (None, None) => Err(format!("column `{name}` has no unit; call it wavelength_m or wavelength_mm")),
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
