//! Which column of a table is that of the dates.

use jiff::civil::Date;
use riffel_keys::table::{is_one_of, words};
use riffel_keys::{Message, say};

use crate::LabelledSpectrum;
use crate::date::{NoDate, looks_like_date, looks_like_point, of_day_number, read_date, read_dates};

/// Words for a date at the head of a column.
const DATE: &str = "date|dates|datum|datums|dato|fecha|dátum|päivämäärä|pvm|kuupäev|tarih|datetime|timestamp|zeitstempel|\
                    epoch|messdatum|messtag|aufnahmedatum";
/// Words for a part of a date, which is no day.
const PART: &str = "year|jahr|messjahr|année|annee|año|anno|jaar|år|rok|month|monat|mois|mes|mese|maand|week|woche|kw|\
                    kalenderwoche|semaine|semana|settimana|quarter|quartal|trimestre|day|tag|jour|día|dia|giorno|dag";
/// Words for one of several measurements, which may be called by its date.
const OCCASION: &str = "survey|surveys|campaign|kampagne|campagne|campaña|campagna|measured|measurement|gemessen|messung|mesuré|\
                        mesure|medido|misurato|when|wann|quand|cuando|quando|recorded|recording|aufgenommen|aufnahme|inspection|\
                        befahrung|inspektion|zeitpunkt|run|runs|fahrt|messfahrt|lauf|messlauf";
/// Words for what has a date besides the measurement.
const OTHER: &str = "built|build|installed|installation|laid|commissioned|renewed|renewal|ground|grinding|manufactured|\
                     calibrated|calibration|processed|exported|printed|einbau|einbaudatum|verlegt|baujahr|schliff|geschliffen|\
                     schleifen|kalibriert|kalibrierung|pose|meulage|made|birth";

/// Whether the head of a column is a word for the date of a measurement or a part of one.
pub fn is_of_time(head: &str) -> bool {
    let words = words(head);
    let is = |list: &str| words.iter().any(|word| is_one_of(word, list));
    !is(OTHER) && (is(DATE) || is(PART))
}

/// Whether a column tells measurements apart by their days or years.
pub(super) fn names_occasions(head: &str, cells: &[String]) -> bool {
    let mut words = words(head).into_iter();
    words.any(|word| is_one_of(&word, OCCASION)) && cells.iter().all(|cell| looks_like_point(cell))
}

/// The place of the column of dates by heads and cells: the first with a word for a date at its head, else the first whose
/// cells all look like dates, else the first with several words for a part of one, or with years or day numbers under a word for one
/// of several measurements. Such a column is read, or its table is
/// refused.
pub(super) fn date_column(heads: &[&str], cells: &dyn Fn(usize) -> Vec<String>) -> Option<usize> {
    let is = |column: usize, list: &str| {
        let words = words(heads[column]);
        words.iter().any(|word| is_one_of(word, list))
    };
    let mut columns: Vec<(usize, Vec<String>)> =
        (0..heads.len()).filter(|&column| !is(column, OTHER)).map(|column| (column, cells(column))).collect();
    columns.retain(|(_, cells)| cells.iter().any(|cell| !cell.is_empty()));
    let find = |fits: &dyn Fn(usize, &[String]) -> bool| {
        let mut columns = columns.iter();
        let found = columns.find(|(column, cells)| fits(*column, cells));
        found.map(|(column, _)| *column)
    };
    let has_digit = |cell: &String| cell.contains(|c: char| c.is_ascii_digit());
    find(&|column, _| is(column, DATE))
        .or_else(|| find(&|_, cells| cells.iter().all(|cell| looks_like_date(cell))))
        .or_else(|| {
            find(&|column, cells| {
                let differ = cells.iter().any(|cell| *cell != cells[0]);
                // A date in Italian, anything in English.
                let is_part = is(column, PART) || is(column, "data");
                let is_day = names_occasions(heads[column], cells);
                differ && (is_day || is_part && cells.iter().any(has_digit))
            })
        })
}

/// First and last date of a column, if it is one of dates.
///
/// # Errors
/// The place of the first cell that is no date, or may be two, with a sentence.
pub fn ends_of_dates(head: &str, cells: &[String]) -> Result<Option<[Date; 2]>, (usize, Message)> {
    if date_column(&[head], &|_| cells.to_vec()).is_none() {
        return Ok(None);
    }
    let mut dates = read_dates(cells.iter().map(String::as_str)).map_err(|no_date| {
        let NoDate { place, message } = no_date.of(head);
        (place, message)
    })?;
    dates.sort_unstable();
    Ok(dates.first().zip(dates.last()).map(|(first, last)| [*first, *last]))
}

/// The dates in the heads of columns that stand beside each other, each with what else its head says; `None` where one has no
/// date.
pub(super) fn dates_of_heads(heads: &[&str]) -> Option<Vec<(Date, String)>> {
    let dated = |head: &&str| {
        let parts: Vec<&str> = head.split([' ', '_', '[', ']', '(', ')']).collect();
        let place = parts.iter().position(|part| looks_like_date(part))?;
        let mut rest = parts.clone();
        let date = read_date(rest.remove(place)).ok()?;
        let mut rest = words(&rest.join(" "));
        rest.retain(|word| !is_one_of(word, "db|um|µm|mm|m"));
        let rest = rest.join(" ");
        Some((date, if rest.is_empty() { "rail".to_owned() } else { rest }))
    };
    (heads.len() > 1).then(|| heads.iter().map(dated).collect())?
}

/// The column of dates among the labels of spectra.
pub(super) fn of_spectra(spectra: &[LabelledSpectrum]) -> Option<usize> {
    let labels = spectra.first()?.labels.iter();
    let heads: Vec<&str> = labels.map(|(head, _)| head.as_str()).collect();
    let cells = |column: usize| -> Vec<String> {
        let cells = spectra.iter().map(|one| one.labels.get(column));
        cells.map(|cell| cell.map_or_else(String::new, |cell| cell.1.clone())).collect()
    };
    date_column(&heads, &cells)
}

/// Write the dates of spectra as in 2026-01-31, whatever their table writes; a remark on the days of a spreadsheet.
///
/// # Errors
/// The first spectrum whose date is none, or may be two.
pub(super) fn write_dates_alike(spectra: &mut [LabelledSpectrum]) -> Result<Option<Message>, NoDate> {
    let Some(column) = of_spectra(spectra) else {
        return Ok(None);
    };
    let head = spectra[0].labels[column].0.clone();
    let texts: Vec<String> = spectra.iter().map(|spectrum| spectrum.labels[column].1.clone()).collect();
    let dates = read_dates(texts.iter().map(String::as_str)).map_err(|no_date| no_date.of(&head))?;
    for (spectrum, date) in spectra.iter_mut().zip(dates) {
        spectrum.labels[column].1 = date.to_string();
    }
    Ok(day_numbers(&head, texts.iter().map(String::as_str)))
}

/// What is said of a column whose dates are the days of a spreadsheet.
pub(super) fn day_numbers<'a>(head: &str, mut cells: impl Iterator<Item = &'a str>) -> Option<Message> {
    let (cell, date) = cells.find_map(|cell| Some((cell, of_day_number(cell)?)))?;
    Some(say!(dates_are_day_numbers, column = head, cell, date = date.to_string()))
}

impl NoDate {
    /// Column with its head, if it has one.
    pub(super) fn of(self, head: &str) -> Self {
        let message = match head {
            "" => self.message,
            head => say!(of_column, column = head, sentence = self.message),
        };
        Self { message, ..self }
    }
}

#[cfg(test)]
mod tests;
