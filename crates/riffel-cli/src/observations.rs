//! Measured corrugation to lay over a map.

use std::path::Path;

use riffel_case::quantity::{Dimension, Length, Quantity, Speed};
use riffel_plot::Observation;

use crate::error::CliError;

/// Read a CSV with the columns wavelength, speed and (optional) label, in any order; the names may
/// end in their SI units, as in `wavelength_m`.
pub(crate) fn read(path: &Path) -> Result<Vec<Observation>, CliError> {
    let cannot_read = |reason| CliError::ReadObservations {
        path: path.to_owned(),
        reason,
    };
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .comment(Some(b'#'))
        .from_path(path)
        .map_err(cannot_read)?;
    let headers = reader.headers().map_err(cannot_read)?.clone();
    let column = |names: [&str; 2]| {
        headers
            .iter()
            .position(|header| names.iter().any(|name| header.eq_ignore_ascii_case(name)))
    };
    let required = |names: [&str; 2]| {
        column(names).ok_or_else(|| CliError::Observation {
            path: path.to_owned(),
            line: 1,
            message: format!(
                "no column \"{}\"; there must be wavelength, speed and, if wanted, label",
                names[0]
            ),
        })
    };
    let wavelength = required(["wavelength", "wavelength_m"])?;
    let speed = required(["speed", "speed_m_per_s"])?;
    let label = column(["label", "name"]);

    let mut observations = Vec::new();
    for record in reader.records() {
        let record = record.map_err(cannot_read)?;
        let line = record.position().map_or(0, csv::Position::line);
        let wrong = |message: String| CliError::Observation {
            path: path.to_owned(),
            line,
            message,
        };
        observations.push(Observation {
            wavelength_m: positive::<Length>("wavelength", &record[wavelength]).map_err(wrong)?,
            speed_m_per_s: positive::<Speed>("speed", &record[speed]).map_err(wrong)?,
            label: label.map_or("measured", |label| &record[label]).to_owned(),
        });
    }
    Ok(observations)
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
