//! Files of MiniProf (Greenwood Engineering): lines `key=value`, an empty line, then columns in millimetres.
//!
//! The columns are those of `ColumnDef`, X and Y among them; a line that begins with a quotation mark is a point that was masked at the
//! device. `XOffset` and `YOffset` are added to the columns. Files `.mpt` have heads in brackets and `[…Points]` before the columns. What X and Y point to depends on how the device was
//! set up: it is found. Sources: the manual of Gensys' converter of such files, and the files of the Manchester contact benchmark that
//! CONTACT ships.

use riffel_keys::table::number_in;
use riffel_keys::{clipped, say};

use super::reading::ProfileKind;
use super::table::without_comment;
use super::written::WrittenProfile;
use crate::refusal::Refusal;

/// Keys that a wheel or a rail alone has, if a value follows.
const OF_WHEELS: [&str; 6] = ["sd", "sh", "qr", "wheelid", "diameterflange", "diametertaperline"];
const OF_RAILS: [&str; 5] = ["w1", "w2", "w3", "railaligntype", "railangle"];

/// Whether the first line is that of such a file.
pub(super) fn is_first_line(line: &str) -> bool {
    let key = line.split_once('=').map(|(key, _)| key.trim());
    let is_key = key.is_some_and(|key| key.starts_with(|first: char| first.is_ascii_alphabetic()));
    is_key || line.eq_ignore_ascii_case("[FileInfo]") || line.to_uppercase().contains("MINIPROF")
}

pub(super) fn read(text: &str, extension: &str) -> Result<WrittenProfile, Refusal> {
    let mut written = WrittenProfile { of_any_orientation: true, ..WrittenProfile::default() };
    let (mut masked, mut announced, mut sections) = (0, None, 0);
    let mut columns = [0, 1];
    let (mut is_head, mut has_keys) = (true, false);
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.starts_with('"') {
            masked += 1;
            continue;
        }
        let line = without_comment(line);
        if line.is_empty() {
            is_head &= !has_keys;
            continue;
        }
        if line.starts_with('[') {
            if line.to_lowercase().ends_with("points]") {
                sections += 1;
                is_head = false;
            }
            if sections > 1 {
                return Err(Refusal::new(Some(index + 1), say!(file_of_several_profiles)));
            }
            continue;
        }
        if let Some((key, value)) = line.split_once('=') {
            has_keys = true;
            let (key, value) = (key.trim().to_lowercase(), value.trim());
            match key.as_str() {
                "columndef" => {
                    columns = columns_of(value).ok_or_else(|| {
                        let other = say!(column_def_without_x_and_y, value = clipped(value));
                        Refusal::new(Some(index + 1), other)
                    })?;
                }
                "xoffset" | "yoffset" => {
                    written.offset[usize::from(key == "yoffset")] = offset(line, value, index + 1)?;
                }
                "xypoints" => announced = value.parse::<usize>().ok(),
                key if !value.is_empty() && OF_WHEELS.contains(&key) => {
                    written.kind = Some(ProfileKind::Wheel);
                }
                key if !value.is_empty() && OF_RAILS.contains(&key) => {
                    written.kind = Some(ProfileKind::Rail);
                }
                _ => {}
            }
            continue;
        }
        let cells = line.split([' ', '\t', ',', ';']).filter(|cell| !cell.is_empty());
        let cells: Vec<&str> = cells.collect();
        let of = |column: usize| cells.get(column).and_then(|cell| number_in(cell));
        match (of(columns[0]), of(columns[1])) {
            (Some(x), Some(y)) => {
                is_head = false;
                written.push([x, y], index + 1);
            }
            // The title of an old file.
            _ if is_head => {}
            _ => {
                let none = say!(line_without_x_and_y, text = clipped(line));
                return Err(Refusal::new(Some(index + 1), none));
            }
        }
    }
    let count = written.points.len();
    if let Some(announced) = announced.filter(|&announced| announced != count + masked) {
        written.remarks.push(say!(points_missing, announced, count = count + masked));
    }
    if masked > 0 {
        written.remarks.push(say!(masked_points_left_out, masked));
    }
    match extension {
        "whl" => written.kind = Some(ProfileKind::Wheel),
        "ban" => written.kind = Some(ProfileKind::Rail),
        _ => {}
    }
    written.scale(1e-3);
    Ok(written)
}

/// The millimetres of an offset.
fn offset(line: &str, value: &str, number: usize) -> Result<f64, Refusal> {
    number_in(value).ok_or_else(|| Refusal::new(Some(number), say!(line_without_millimetres, text = clipped(line))))
}

/// Where X and Y are among the columns.
fn columns_of(definition: &str) -> Option<[usize; 2]> {
    let names: Vec<String> = definition.split([',', ';']).map(|name| name.trim().to_uppercase()).collect();
    let of = |name: &str| names.iter().position(|known| known == name);
    Some([of("X")?, of("Y")?])
}
