//! Two columns of lateral coordinate and height.

use riffel_keys::clipped;
use riffel_keys::table::{Delimiter, cells, is_one_of, label, number_in, words};

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
        let cells = cells_of(line);
        let numbers: Vec<Option<f64>> = cells.iter().map(|cell| number_in(cell)).collect();
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

/// The cells of a line.
fn cells_of(line: &str) -> Vec<String> {
    let marks = [Delimiter::Semicolon, Delimiter::Tab, Delimiter::Comma];
    let is_in_line = |mark: &Delimiter| line.as_bytes().contains(&mark.byte());
    let mark = marks.into_iter().find(is_in_line);
    let blanks: Vec<&str> = line.split_whitespace().collect();
    // Two numbers with decimal commas and a blank between them.
    let with_commas = matches!(blanks[..], [x, y] if number_in(x).is_some() && number_in(y).is_some() && x.contains(','));
    let delimiter = mark.filter(|_| !with_commas).unwrap_or(Delimiter::Space);
    let mut cells: Vec<String> = cells(line.as_bytes(), delimiter)
        .into_iter()
        .map(label)
        .collect();
    // A delimiter at the end of a line makes no column.
    while cells.last().is_some_and(String::is_empty) {
        cells.pop();
    }
    cells
}

/// Millimetres or metres, if a head says so, of columns named x and then y or another height.
fn unit_of_head(cells: &[String]) -> Result<Option<f64>, String> {
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
            word => is_one_of(word, "um|µm|μm|cm|dm|nm|km|in|inch|inches|ft|mil")
                .then(|| Err(format!("the head says {word}: give a profile in mm or m"))),
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
