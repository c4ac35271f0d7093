//! Measured corrugation to lay over a map.

use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::quantity::{Dimension, Length, Quantity, Speed};
use riffel_keys::text_file::{LARGEST_KEYS, decode, printable, read_bounded};
use riffel_plot::Observation;

use crate::error::CliError;

const WAVELENGTH: [&str; 4] = ["wavelength", "lambda", "wellenlänge", "wellenlaenge"];
const SPEED: [&str; 3] = ["speed", "velocity", "geschwindigkeit"];
const LABEL: [&str; 4] = ["label", "name", "bezeichnung", "ort"];

/// Read a table with the columns wavelength, speed and (optional) label, in any order, divided by commas, semicolons or
/// tabulators. A cell has its unit with it, or its column in the head, as in `wavelength_mm` or `speed [km/h]`; bare
/// numbers are SI. Where commas do not divide cells, they may be decimal marks.
pub(crate) fn read(path: &Path) -> miette::Result<Vec<Observation>> {
    let bytes = read_bounded(path, "file of observations", LARGEST_KEYS)?;
    let text = decode(bytes).map_err(|byte| CaseError::Data {
        path: path.to_owned(),
        line: Some(byte.line),
        message: byte.to_string(),
        help: None,
    })?;
    Ok(parse(path, &text)?)
}

fn parse(path: &Path, text: &str) -> Result<Vec<Observation>, CliError> {
    let cannot_read = |reason| CliError::ReadObservations {
        path: path.to_owned(),
        reason,
    };
    let delimiter = delimiter(text);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_reader(text.as_bytes());
    let headers = reader.headers().map_err(cannot_read)?.clone();
    let column = |names: &[&str]| {
        headers
            .iter()
            .position(|header| names.contains(&&*word(header).0))
    };
    let required = |names: &[&str]| {
        column(names).ok_or_else(|| CliError::Observation {
            path: path.to_owned(),
            line: 1,
            message: format!(
                "no column \"{}\"; there must be wavelength, speed and, if wanted, label",
                names[0]
            ),
        })
    };
    let (wavelength, speed, label) = (required(&WAVELENGTH)?, required(&SPEED)?, column(&LABEL));
    let mut observations = Vec::new();
    for record in reader.records() {
        let record = record.map_err(cannot_read)?;
        let line = record.position().map_or(0, csv::Position::line);
        let wrong = |message: String| CliError::Observation {
            path: path.to_owned(),
            line,
            message,
        };
        let cell = |index: usize| {
            let text = match delimiter {
                b',' => record[index].to_owned(),
                _ => record[index].replace(',', "."),
            };
            // What has a unit of its own needs none of the head.
            match (text.parse::<f64>(), &*word(&headers[index]).1) {
                (Ok(_), unit) if !unit.is_empty() => format!("{text} {unit}"),
                _ => text,
            }
        };
        observations.push(Observation {
            wavelength_m: positive::<Length>("wavelength", &cell(wavelength)).map_err(wrong)?,
            speed_m_per_s: positive::<Speed>("speed", &cell(speed)).map_err(wrong)?,
            label: printable(label.map_or("measured", |label| &record[label])).into_owned(),
        });
    }
    Ok(observations)
}

/// What divides the cells of the first line that is no remark.
fn delimiter(text: &str) -> u8 {
    let mut lines = text.lines().map(str::trim);
    let head = lines.find(|line| !line.is_empty() && !line.starts_with('#'));
    let head = head.unwrap_or_default();
    [b';', b'\t']
        .into_iter()
        .find(|&mark| head.contains(char::from(mark)))
        .unwrap_or(b',')
}

/// Name and unit of a column: "speed" and "km/h" of "Speed [km/h]", "speed_km_h" or "speed_km_per_h".
fn word(header: &str) -> (String, String) {
    let header = header.to_lowercase();
    let end = header
        .find(|c: char| !c.is_alphabetic())
        .unwrap_or(header.len());
    let (name, unit) = header.split_at(end);
    let unit = unit.trim_matches(|c: char| " _[]()/".contains(c));
    let unit = unit.replace("_per_", "/").replace('_', "/");
    let unit = if unit == "kmh" {
        "km/h".to_owned()
    } else {
        unit
    };
    (name.to_owned(), unit)
}

fn positive<D: Dimension>(name: &str, text: &str) -> Result<f64, String> {
    let quantity: Quantity<D> = text.parse().map_err(|error| format!("{name}: {error}"))?;
    if quantity.si() > 0.0 {
        return Ok(quantity.si());
    }
    Err(format!(
        "{name} is {quantity}, but must be greater than zero"
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_other_countries_and_units_are_read_alike() {
        for text in [
            "wavelength,speed,label\n0.0315,20,A\n",
            "wavelength,speed,label\n31.5 mm,72 km/h,A\n",
            "# measured in spring\nlabel;speed_km_h;wavelength_mm\nA;72;31,5\n",
            "Bezeichnung;Geschwindigkeit [km/h];Wellenlänge [mm]\nA;72,0;31,5\n",
            "wavelength (mm)\tspeed (m/s)\tname\n31.5\t20\tA\n",
        ] {
            let found = parse(Path::new("o.csv"), text).unwrap();
            assert_eq!(found.len(), 1);
            assert!((found[0].wavelength_m - 0.0315).abs() < 1e-12, "{text}");
            assert!((found[0].speed_m_per_s - 20.0).abs() < 1e-12, "{text}");
            assert_eq!(found[0].label, "A");
        }
    }
}
