//! Two columns of lateral coordinate and height.

use riffel_keys::clipped;

use super::written::{Fault, WIDEST_IN_METRES, WrittenProfile};

/// The points of two columns, x and y, in millimetres or metres as a head says or their size.
pub(super) fn read(text: &str) -> Result<WrittenProfile, Fault> {
    let mut written = WrittenProfile::default();
    let mut unit = None;
    let mut may_be_head = true;
    for (index, line) in text.lines().enumerate() {
        let line = without_comment(line);
        if line.is_empty() {
            continue;
        }
        let cells = cells(line);
        let numbers: Vec<Option<f64>> = cells.iter().map(|cell| number(cell)).collect();
        match numbers[..] {
            [Some(x), Some(height)] => written.push([x, height], index + 1),
            _ if may_be_head && numbers.iter().all(Option::is_none) => {
                unit = unit_of_head(&cells).map_err(|rule| Fault::at(index + 1, rule))?;
            }
            _ => {
                let shown = clipped(line);
                return Err(Fault::at(
                    index + 1,
                    format!("\"{shown}\" is not a pair of numbers x, y"),
                ));
            }
        }
        may_be_head = false;
    }
    let factor = match unit {
        Some(factor) => factor,
        None if written.width() > WIDEST_IN_METRES => 1e-3,
        None => 1.0,
    };
    written.scale(factor);
    Ok(written)
}

/// A line without what follows #, ! or %, and without blanks around it.
pub(super) fn without_comment(line: &str) -> &str {
    let end = line.find(['#', '!', '%']).unwrap_or(line.len());
    line[..end].trim()
}

/// A number, with a decimal point or a decimal comma, in quotes or not.
pub(super) fn number(cell: &str) -> Option<f64> {
    match cell.split_once(',') {
        Some((whole, part)) if !part.contains([',', '.']) && !whole.contains('.') => {
            format!("{whole}.{part}").parse().ok()
        }
        _ => cell.parse().ok(),
    }
}

fn cells(line: &str) -> Vec<&str> {
    let separator = [';', '\t', ',']
        .into_iter()
        .find(|separator| line.contains(*separator));
    let blanks: Vec<&str> = line.split_whitespace().collect();
    // Two numbers with decimal commas and a blank between them.
    let with_commas = matches!(blanks[..], [x, y] if number(x).is_some() && number(y).is_some() && x.contains(','));
    let cells: Vec<&str> = match separator {
        Some(separator) if !with_commas => line.split(separator).map(str::trim).collect(),
        _ => blanks,
    };
    let cells: Vec<&str> = cells
        .into_iter()
        .map(|cell| cell.trim_matches('"').trim())
        .collect();
    // A separator at the end of a line makes no column.
    let filled = cells
        .iter()
        .rposition(|cell| !cell.is_empty())
        .map_or(0, |last| last + 1);
    cells[..filled].to_vec()
}

/// Millimetres or metres, if a head says so, of columns named x and then y or another height.
fn unit_of_head(cells: &[&str]) -> Result<Option<f64>, String> {
    let words = |cell: &str| -> Vec<String> {
        let words = cell.split(|character: char| !character.is_alphabetic());
        words
            .filter(|word| !word.is_empty())
            .map(str::to_lowercase)
            .collect()
    };
    let columns: Vec<Vec<String>> = cells.iter().map(|cell| words(cell)).collect();
    let begins = |column: usize, names: &[&str]| {
        let first = columns.get(column).and_then(|words| words.first());
        first.is_some_and(|first| names.contains(&first.as_str()))
    };
    if begins(1, &["x"]) && !begins(0, &["x"]) {
        return Err("the columns are in the order y, x: the lateral coordinate x comes first, the height second".to_owned());
    }
    let units = columns
        .iter()
        .flatten()
        .filter_map(|word| match word.as_str() {
            "mm" => Some(Ok(1e-3)),
            "m" => Some(Ok(1.0)),
            "um" | "µm" | "μm" | "cm" | "dm" | "nm" | "km" | "in" | "inch" | "inches" | "ft"
            | "mil" => Some(Err(format!(
                "the head says {word}: give a profile in mm or m"
            ))),
            _ => None,
        });
    let units: Vec<f64> = units.collect::<Result<_, _>>()?;
    match units[..] {
        [one, other] if one != other => Err(
            "the head gives both columns units of their own: give a profile in mm or m throughout"
                .to_owned(),
        ),
        _ => Ok(units.first().copied()),
    }
}
