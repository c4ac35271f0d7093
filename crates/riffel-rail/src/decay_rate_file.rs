//! Measured track decay rates in a table.

use std::path::Path;

use riffel::noise::FrequencyBand;
use riffel_keys::CaseError;

use crate::heading::tokens;
use crate::refusal::Refusal;
use crate::sniff::Table;
use crate::{input, number, rows};

/// Decay rates \[dB/m\] by one-third octave, from a table with a head that has a column of frequencies \[Hz\] and one of
/// decay rates \[dB/m\]; `riffel receptance` writes such a table. Other columns are left alone.
///
/// # Errors
/// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line and the rule if it is no such table.
pub fn read_decay_rates(path: &Path) -> Result<Vec<(FrequencyBand, f64)>, CaseError> {
    let bytes = input::read(path, &|_| Ok(()))?;
    parse(&bytes).map_err(|refusal| refusal.of(path))
}

fn parse(bytes: &[u8]) -> Result<Vec<(FrequencyBand, f64)>, Refusal> {
    let refuse = |line: Option<usize>, message: String| Refusal::new(line, message);
    let missing = || {
        refuse(
            None,
            "a table of decay rates has a head with a column `frequency_hz` and one `decay_rate_db_per_m`"
                .to_owned(),
        )
    };
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let table = Table::find(bytes).ok_or_else(missing)?;
    let header = table.heading.names.as_deref().ok_or_else(missing)?;
    let column = |word: &str| {
        let named = |name: &String| tokens(name).iter().any(|token| token == word);
        header.iter().position(named).ok_or_else(missing)
    };
    let (frequency, rate) = (column("frequency")?, column("decay")?);
    let mut rates: Vec<(FrequencyBand, f64)> = Vec::new();
    for (index, line) in rows::lines(bytes).enumerate().skip(table.header_lines) {
        if rows::is_comment(line) {
            continue;
        }
        let at = |message: String| refuse(Some(index + 1), message);
        let cells = rows::cells(line, table.delimiter);
        let value = |column: usize, what: &str| {
            cells
                .get(column)
                .and_then(|cell| number::parse(cell, table.decimal.byte()))
                .ok_or_else(|| at(format!("the {what} is no number")))
        };
        let hertz = value(frequency, "frequency")?;
        let band = FrequencyBand::containing(hertz)
            .filter(|band| (hertz / band.centre() - 1.0).abs() <= 0.05)
            .ok_or_else(|| {
                at(format!(
                    "the frequency is {hertz} Hz, but must be the centre of a one-third octave"
                ))
            })?;
        let decibels = value(rate, "decay rate")?;
        if !(decibels > 0.0 && decibels.is_finite()) {
            return Err(at(format!(
                "the decay rate is {decibels} dB/m, but must be greater than zero"
            )));
        }
        if rates.iter().any(|(other, _)| *other == band) {
            return Err(at(format!(
                "the band of {} Hz is there already: a table holds one curve",
                band.nominal()
            )));
        }
        rates.push((band, decibels));
    }
    Ok(rates)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(rows: &str) -> Result<Vec<(FrequencyBand, f64)>, String> {
        let text = format!("section,frequency_hz,decay_rate_db_per_m\n{rows}");
        parse(text.as_bytes()).map_err(|refusal| refusal.message)
    }

    #[test]
    fn a_curve_is_read_and_others_are_refused() {
        let rates = of("B5,100,3.0\nB5,125,4.5\nB5,160,5.4\n").unwrap();
        assert_eq!(rates.len(), 3);
        assert_eq!(rates[1], (FrequencyBand::new(21), 4.5));
        for (rows, part) in [
            ("B5,100,3.0\nB5,100,4.5\nB5,160,5.4\n", "there already"),
            ("B5,100,3.0\nB5,125,-4.5\nB5,160,5.4\n", "greater than zero"),
            ("B5,110,3.0\nB5,125,4.5\nB5,160,5.4\n", "110 Hz"),
        ] {
            let refusal = of(rows).unwrap_err();
            assert!(refusal.contains(part), "{refusal}");
        }
        let refusal = parse(b"a,b\n1,2\n3,4\n").unwrap_err();
        assert!(refusal.message.contains("decay_rate_db_per_m"));
    }
}
