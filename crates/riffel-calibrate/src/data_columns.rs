//! What a model was given beside what was measured: the tables of the data, column by column.

use riffel_arrays::Array;
use serde_json::{Map, Value, json};

use crate::data::table;
use crate::error::CalibrationError;
use crate::file::{DataFile, Kind};
use crate::plan::{Plan, name_of};

/// A column with the numbers of its rows.
pub(crate) type Column = (Array, Vec<f64>);

/// The columns of the tables of a plan, as arrays of a group: frequencies, wavelengths, passages, errors. What a plan says of data
/// itself, speed, averages and gain, are attributes of each.
pub(crate) fn columns(plan: &Plan, group: &str) -> Result<Vec<Column>, CalibrationError> {
    let folder = plan.inputs[0].parent().unwrap_or("".as_ref());
    let mut all = Vec::new();
    for (data, dimension) in plan.file.data.iter().zip(DIMENSIONS.iter().cycle()) {
        let path = folder.join(&data.file);
        let mut needed = data.kind.columns();
        if data.kind == Kind::DatedProfiles {
            // The others are names of files.
            needed = &needed[..1];
        }
        let has_all = |names: &[String]| needed.iter().all(|it| names.iter().any(|own| own == it));
        let names = table::names(&path, has_all)?;
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let own = |name: &&str| !needed.contains(name);
        let others: Vec<&str> = names.iter().copied().filter(own).collect();
        let attributes = said(data);
        // A column of words is none of numbers.
        let mut add = |name: &str, values: Vec<f64>| {
            let array = Array {
                name: format!("{group}/{}.{name}", name_of(data)),
                attributes: attributes.clone(),
                ..Array::axis("", dimension, values.len() as u64, "", "")
            };
            all.push((array, values));
        };
        let numbers = table::read(&path, needed, &[])?;
        needed.iter().zip(numbers.needed).for_each(|(name, values)| add(name, values));
        for name in others {
            if let Ok(numbers) = table::read(&path, needed, &[name])
                && let Some(Some(values)) = numbers.others.into_iter().next()
            {
                add(name, values);
            }
        }
    }
    Ok(all)
}

/// What a plan says of data, in SI.
fn said(data: &DataFile) -> Value {
    let numbers = [
        ("speed_m_per_s", data.speed.as_ref().map(|it| it.si())),
        ("averages", data.averages),
        ("gain_error", data.gain_error),
        ("student_degrees", data.student_degrees),
    ];
    let numbers = numbers.into_iter();
    let said: Map<String, Value> = numbers.filter_map(|(key, value)| Some((key.to_owned(), json!(value?)))).collect();
    Value::Object(said)
}

/// Rows of the tables.
const DIMENSIONS: [&str; 6] = ["row", "row_2", "row_3", "row_4", "row_5", "row_6"];
