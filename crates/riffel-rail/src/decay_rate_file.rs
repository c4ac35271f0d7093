//! Measured track decay rates in a table.

use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::table::{HeadedTable, Row, words};
use riffel_keys::text_file::{LARGEST_KEYS, decode, read_bounded};
use riffel_noise::FrequencyBand;

use crate::refusal::Refusal;

/// Decay rates \[dB/m\] by one-third octave, from a table with a head that has a column of frequencies \[Hz\] and one of
/// decay rates \[dB/m\]; `riffel receptance` writes such a table. Other columns are left alone.
///
/// # Errors
/// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line and the rule if it is no such table.
pub fn read_decay_rates(path: &Path) -> Result<Vec<(FrequencyBand, f64)>, CaseError> {
    let refuse = |refusal: Refusal| refusal.of(path);
    let text = decode(read_bounded(path, "file", LARGEST_KEYS)?);
    let text = text.map_err(|byte| refuse(Refusal::new(Some(byte.line), byte)))?;
    parse(&text).map_err(refuse)
}

fn parse(text: &str) -> Result<Vec<(FrequencyBand, f64)>, Refusal> {
    let column = |names: &[String], word: &str| {
        let is_named = |name: &String| words(name).iter().any(|own| own == word);
        names.iter().position(is_named)
    };
    let find = |names: &[String]| {
        let columns = column(names, "frequency").zip(column(names, "decay"));
        columns.ok_or(())
    };
    let is_row = |&(frequency, _): &(usize, usize), row: &Row<'_>| row.number(frequency).is_ok();
    let table = HeadedTable::find(text, find, is_row).map_err(|_| {
        Refusal::new(
            None,
            "a table of decay rates has a head with a column `frequency_hz` and one `decay_rate_db_per_m`",
        )
    })?;
    let (frequency, rate) = table.columns;
    let mut rates: Vec<(FrequencyBand, f64)> = Vec::new();
    for row in table.rows() {
        let at = |message: String| Refusal::new(Some(row.line), message);
        let value = |column: usize| {
            let name = &table.names[column];
            let value = row.number(column);
            value.map_err(|rule| at(format!("column {}, `{name}`, {rule}", column + 1)))
        };
        let hertz = value(frequency)?;
        let band = FrequencyBand::containing(hertz)
            .filter(|band| (hertz / band.centre() - 1.0).abs() <= 0.05)
            .ok_or_else(|| at(format!("the frequency is {hertz} Hz, but must be the centre of a one-third octave")))?;
        let decibels = value(rate)?;
        if decibels <= 0.0 {
            return Err(at(format!("the decay rate is {decibels} dB/m, but must be greater than zero")));
        }
        if rates.iter().any(|(other, _)| *other == band) {
            return Err(at(format!("the band of {} Hz is there already: a table holds one curve", band.nominal())));
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
        parse(&text).map_err(|refusal| refusal.message.to_string())
    }

    /// Of two columns divided by a comma the first row could be one number with a decimal comma.
    #[test]
    fn a_comma_in_the_head_divides_the_rows() {
        let read = parse("frequency_hz,decay_rate_db_per_m\n500,2\n630,1.5\n");
        let rates = read.map_err(|refusal| refusal.message.to_string()).unwrap();
        let rates: Vec<f64> = rates.into_iter().map(|(_, rate)| rate).collect();
        assert_eq!(rates, [2.0, 1.5]);
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
            ("B5,100,3.0\nB5,125,4.5 dB/m\n", "column 3, `decay_rate_db_per_m`, is \"4.5 dB/m\", not a number"),
            ("B5,100,3.0\nB5,,4.5\n", "column 2, `frequency_hz`, is empty"),
            ("B5,100,3.0\nB5,125,NaN\n", "column 3, `decay_rate_db_per_m`, is NaN"),
        ] {
            let refusal = of(rows).unwrap_err();
            assert!(refusal.contains(part), "{refusal}");
        }
        let refusal = parse("a,b\n1,2\n3,4\n").unwrap_err();
        assert!(refusal.message.to_string().contains("decay_rate_db_per_m"));
    }
}
