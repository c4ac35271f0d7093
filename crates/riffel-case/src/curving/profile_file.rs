//! Files of profiles: two columns, lateral coordinate and height, in millimetres or metres.

use std::path::Path;

use riffel::profile::{NominalProfile, Profile, ProfileError};
use riffel_keys::{CaseError, clipped, text_file};

/// Largest file of a profile \[bytes\].
const LARGEST: u64 = 16 << 20;
/// A profile without a unit is in millimetres if it is wider than this number; none is wider than this in metres.
const WIDEST_IN_METRES: f64 = 1.0;

/// A profile of a name or of a file.
///
/// # Errors
/// [`CaseError`] with file and line.
pub fn profile_of(name: &str, folder: &Path) -> Result<Profile, CaseError> {
    match NominalProfile::named(name) {
        Some(nominal) => Ok(nominal.profile()),
        None => read_profile(&folder.join(name)),
    }
}

/// The profile of a file of two columns, lateral coordinate (positive to the field side) and height (positive upward), with
/// comma, semicolon or blanks between them. Lines that begin with # are comments. A head such as `x_mm,y_mm` or
/// `x [m]; y [m]` tells the unit; without one a profile of more than 1 across is in millimetres.
///
/// # Errors
/// [`CaseError`] with file and line.
pub fn read_profile(path: &Path) -> Result<Profile, CaseError> {
    let bytes = text_file::read_bounded(path, "profile", LARGEST)?;
    let at_fault = |line: Option<usize>, message: String| CaseError::Data {
        path: path.to_owned(),
        line,
        message,
        help: None,
    };
    let text = text_file::decode(bytes)
        .map_err(|binary| at_fault(Some(binary.line), binary.to_string()))?;
    let mut points: Vec<[f64; 2]> = Vec::new();
    let mut lines = Vec::new();
    let mut unit = None;
    let mut may_be_head = true;
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with(['#', '!', '%']) {
            continue;
        }
        let cells = cells(line);
        let numbers: Vec<Option<f64>> = cells.iter().map(|cell| cell.parse().ok()).collect();
        match numbers[..] {
            [Some(x), Some(height)] => {
                points.push([x, height]);
                lines.push(index + 1);
            }
            _ if may_be_head && numbers.iter().all(Option::is_none) => {
                unit = unit_of_head(&cells).map_err(|rule| at_fault(Some(index + 1), rule))?;
            }
            _ => {
                let shown = clipped(line);
                let message = format!("\"{shown}\" is not a pair of numbers x, y");
                return Err(at_fault(Some(index + 1), message));
            }
        }
        may_be_head = false;
    }
    let width = points
        .iter()
        .fold([f64::MAX, f64::MIN], |[low, high], point| {
            [low.min(point[0]), high.max(point[0])]
        });
    let factor = match unit {
        Some(factor) => factor,
        None if width[1] - width[0] > WIDEST_IN_METRES => 1e-3,
        None => 1.0,
    };
    let across = factor * (width[1] - width[0]);
    if across > WIDEST_IN_METRES {
        let message = format!(
            "the profile is {across:.4} m across, wider than any wheel or rail: check its unit"
        );
        return Err(at_fault(None, message));
    }
    for point in &mut points {
        *point = point.map(|value| factor * value);
    }
    Profile::through(&points).map_err(|error| match &error {
        ProfileError::Point { index, .. } => {
            at_fault(lines.get(*index).copied(), error.to_string())
        }
        _ => at_fault(None, error.to_string()),
    })
}

fn cells(line: &str) -> Vec<&str> {
    let separator = [';', '\t', ',']
        .into_iter()
        .find(|separator| line.contains(*separator));
    let cells: Vec<&str> = match separator {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    };
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

#[cfg(test)]
mod tests {
    use super::*;

    /// An arc of 300 mm in each way of writing is one profile.
    #[test]
    fn every_way_of_writing_is_one_profile() {
        let arc = |factor: f64, separator: &str| {
            (-20..=20)
                .map(|index| {
                    let x = 1e-3 * f64::from(index);
                    format!("{:.9}{separator}{:.9}\n", factor * x, -factor * x * x / 0.6)
                })
                .collect::<String>()
        };
        let folder = tempfile::tempdir().unwrap();
        let read = |text: &str| {
            let path = folder.path().join("rail.csv");
            std::fs::write(&path, text).unwrap();
            read_profile(&path)
        };
        for text in [
            arc(1e3, ","),
            format!("# crown at the origin\nx_mm,y_mm\n{}", arc(1e3, ",")),
            format!("x [m]; y [m]\n{}", arc(1.0, ";")),
            arc(1.0, "  ").replace('\n', "\r\n"),
        ] {
            let point = read(&text).unwrap().at(5e-3).unwrap();
            assert!((point.height + 25e-6 / 0.6).abs() < 1e-9, "{text}");
        }
        let refused = |text: String| read(&text).unwrap_err().to_string();
        let broken = arc(1e3, ",").replacen("-18.0", "-18,0", 1);
        assert!(refused(broken).contains("line 3: "));
        for (head, says) in [
            ("x_um,y_um", "the head says um"),
            ("x [µm], y [µm]", "the head says µm"),
            ("x_mm,y_m", "units of their own"),
            ("y_mm,x_mm", "in the order y, x"),
            ("x_m,y_m", "40.0000 m across"),
        ] {
            let message = refused(format!("{head}\n{}", arc(1e3, ",")));
            assert!(message.contains(says), "{head}: {message}");
        }
        let mut lines: Vec<String> = arc(1e3, ",").lines().map(str::to_owned).collect();
        lines.swap(9, 14);
        let message = refused(lines.join("\n"));
        assert!(
            message.contains("line ") && message.contains("turns back"),
            "{message}"
        );
        assert!(refused("1,2\n3,4\n".to_owned()).contains("8 points or more"));
    }
}
