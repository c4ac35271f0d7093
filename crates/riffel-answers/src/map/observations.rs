//! Measured corrugation to lay over a map.

use std::path::Path;

use riffel_keys::quantity::{Dimension, Length, Speed};
use riffel_keys::table::{HeadedTable, NoHead, is_one_of, number_in};
use riffel_keys::text_file::{LARGEST_KEYS, decode, read_bounded};
use riffel_keys::{CaseError, PhysicalRange};
use riffel_plot::Observation;

use crate::{AnswerError, Result};

const WAVELENGTH: &str = "wavelength|lambda|wellenlänge|wellenlaenge";
const SPEED: &str = "speed|velocity|geschwindigkeit";
const LABEL: &str = "label|name|bezeichnung|ort";

/// Read a table with the columns wavelength, speed and (optional) label, in any order, divided by commas, semicolons or
/// tabulators. A cell has its unit with it, or its column in the head, as in `wavelength_mm` or `speed [km/h]`; bare
/// numbers are SI. Where commas do not divide cells, they may be decimal marks.
pub(crate) fn read(path: &Path) -> Result<Vec<Observation>> {
    let bytes = read_bounded(path, "file of observations", LARGEST_KEYS)?;
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return Err(CaseError::data(path, "the file is empty").into());
    }
    let text = decode(bytes).map_err(|byte| CaseError::Data {
        path: path.to_owned(),
        line: Some(byte.line),
        message: byte.into(),
        help: None,
    })?;
    parse(path, &text)
}

fn parse(path: &Path, text: &str) -> Result<Vec<Observation>> {
    let wrong = |line: usize, message: String| AnswerError::Observation { path: path.to_owned(), line, message };
    let find = |names: &[String]| {
        let column = |known: &str| names.iter().position(|name| is_one_of(&word(name).0, known));
        let required = |known: &'static str| {
            let first = known.split('|').next().unwrap_or_default();
            column(known)
                .ok_or_else(|| format!("no column \"{first}\"; there must be wavelength, speed and, if wanted, label"))
        };
        Ok((required(WAVELENGTH)?, required(SPEED)?, column(LABEL)))
    };
    let nothing = || wrong(1, "no observation stands below the head".to_owned());
    let table = HeadedTable::find(text, find, |_, row| !row.is_empty());
    let table = table.map_err(|reason| match reason {
        NoHead::Names(message) => wrong(1, message),
        NoHead::Numbers => wrong(1, find(&[]).err().unwrap_or_default()),
        NoHead::NoRows => nothing(),
    })?;
    let (wavelength, speed, label) = table.columns;
    let observations = table.rows().map(|row| {
        let cell = |index: usize| {
            let text = row.text(index).replace(',', ".");
            // What has a unit of its own needs none of the head.
            match (number_in(&text), &*word(&table.names[index]).1) {
                (Some(number), unit) if !unit.is_empty() => format!("{number} {unit}"),
                (Some(number), _) => number.to_string(),
                _ => text,
            }
        };
        let wrong = |message: String| wrong(row.line, message);
        Ok(Observation {
            wavelength_m: in_range::<Length>("wavelength", &cell(wavelength)).map_err(wrong)?,
            speed_m_per_s: in_range::<Speed>("speed", &cell(speed)).map_err(wrong)?,
            label: label.map_or_else(|| "measured".to_owned(), |label| row.text(label)),
        })
    });
    let observations: Vec<Observation> = observations.collect::<Result<_>>()?;
    match observations.is_empty() {
        true => Err(nothing()),
        false => Ok(observations),
    }
}

/// Name and unit of a column: "speed" and "km/h" of "Speed [km/h]", "speed_km_h" or "speed_km_per_h".
fn word(header: &str) -> (String, String) {
    let header = header.to_lowercase();
    let end = header.find(|c: char| !c.is_alphabetic()).unwrap_or(header.len());
    let (name, unit) = header.split_at(end);
    let unit = unit.trim_matches(|c: char| " _[]()/".contains(c));
    let unit = unit.replace("_per_", "/").replace('_', "/");
    let unit = if unit == "kmh" { "km/h".to_owned() } else { unit };
    (name.to_owned(), unit)
}

fn in_range<D: Dimension>(name: &str, text: &str) -> Result<f64, String> {
    let read = PhysicalRange::read::<D>(&format!("--{name}"), text);
    read.map(|(si, _)| si).map_err(|rule| match rule.to_string().starts_with("is ") {
        true => format!("{name} {rule}"),
        false => format!("{name}: {rule}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn observations_are_checked_as_points_are() {
        let sentence = |text: &str| parse(Path::new("o.csv"), text).unwrap_err().to_string();
        let wrong = sentence("wavelength,speed\n42 mm,80 km/h\n38,72 km/h\n");
        assert!(wrong.contains("line 3: wavelength is 38"), "{wrong}");
        let wrong = sentence("wavelength,speed\n42 mm,800 km/h\n");
        assert!(wrong.contains("line 2: speed is 800 km/h"), "{wrong}");
        let wrong = sentence("wavelength,speed\n");
        assert!(wrong.contains("no observation"), "{wrong}");
    }

    #[test]
    fn tables_of_other_countries_and_units_are_read_alike() {
        for text in [
            "wavelength,speed,label\n0.0315,20,A\n",
            "wavelength,speed,label\n31.5 mm,72 km/h,A\n",
            "# measured in spring\nlabel;speed_km_h;wavelength_mm\nA;72;31,5\n",
            "Bezeichnung;Geschwindigkeit [km/h];Wellenlänge [mm]\nA;72,0;31,5\n",
            "wavelength (mm)\tspeed (m/s)\tname\n31.5\t20\tA\n",
            "\"wavelength_mm\",\"speed\",\"label\"\n\"31,5\",\"72 km/h\",\"A\"\n",
            "wavelength_mm,speed_m_per_s,label\n3.15D+1,2.0D+1,A\n",
        ] {
            let found = parse(Path::new("o.csv"), text).unwrap();
            assert_eq!(found.len(), 1);
            assert!((found[0].wavelength_m - 0.0315).abs() < 1e-12, "{text}");
            assert!((found[0].speed_m_per_s - 20.0).abs() < 1e-12, "{text}");
            assert_eq!(found[0].label, "A");
        }
    }
}
