//! Files of Vampire, `.whe` of wheels and `.rai` of rails: WHEELPROFILE or RAILPROFILE, a title, TREADDATUM or GAUGEPOINT, FLANGEBACK
//! or GAUGE, then four columns in millimetres, y and z of the left and of the right one, y from the middle of the track to the right.
//!
//! Source: what CONTACT's open source says of these files.

use riffel::Rail;
use riffel_keys::table::number_in;
use riffel_keys::{clipped, fixed, say};

use super::reading::ProfileKind;
use super::table::without_comment;
use super::written::WrittenProfile;
use crate::refusal::Refusal;

/// Millimetres of an inch.
const INCH: f64 = 25.4;

/// Whether the first line is that of such a file.
pub(super) fn is_first_line(line: &str) -> bool {
    kind_of(line).is_some()
}

fn kind_of(line: &str) -> Option<ProfileKind> {
    match line.trim().to_uppercase().as_str() {
        "WHEELPROFILE" => Some(ProfileKind::Wheel),
        "RAILPROFILE" => Some(ProfileKind::Rail),
        _ => None,
    }
}

/// The profile of one side; the right one is drawn as it is, the left one turned over.
///
/// `flange_back` \[mm\] is where the flange back lies in the coordinates of a wheel, by which it is placed on its axle; heights are
/// from the file's own datum.
pub(super) fn read(text: &str, side: Rail, flange_back: f64) -> Result<WrittenProfile, Refusal> {
    let mut written = WrittenProfile { of_any_orientation: true, gauge_side_known: true, ..WrittenProfile::default() };
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line.trim()));
    let first = lines.find(|(_, line)| !line.is_empty());
    written.kind = first.and_then(|(_, line)| kind_of(line));
    // The title.
    let _ = lines.next();
    // Millimetres: TREADDATUM or GAUGEPOINT, and FLANGEBACK or GAUGE.
    let (mut datum, mut distance) = (None, None);
    for (line, text) in lines {
        let text = without_comment(text);
        if text.is_empty() {
            continue;
        }
        let numbers: Vec<Option<f64>> =
            text.split([' ', '\t', ',']).filter(|cell| !cell.is_empty()).map(number_in).collect();
        match numbers[..] {
            [Some(left), Some(left_z), Some(right), Some(right_z), ..] => {
                let point = match side {
                    Rail::Left => [-left, left_z],
                    Rail::Right => [right, right_z],
                };
                written.push(point, line);
                continue;
            }
            [Some(_), ..] => {
                let other = say!(line_without_both_sides, text = clipped(text));
                return Err(Refusal::new(Some(line), other));
            }
            _ => {}
        }
        let upper = text.to_uppercase();
        let (key, value) = upper.split_once([' ', '\t', '=']).unwrap_or((&upper, ""));
        let value = value.trim();
        let asked = || {
            let number = value.rsplit([' ', '\t']).next().and_then(number_in);
            number.ok_or_else(|| Refusal::new(Some(line), say!(value_not_known, name = key, value = clipped(value))))
        };
        match key {
            "TREADDATUM" => {
                datum = Some(match value {
                    "EUROPEAN" => 70.0,
                    "US1" => (2.0 + 27.0 / 32.0) * INCH,
                    "US2" => (3.0 + 1.0 / 16.0) * INCH,
                    _ => asked()?,
                });
            }
            "GAUGEPOINT" => {
                datum = Some(match value {
                    "EUROPEAN" => 14.0,
                    "US" => 5.0 / 8.0 * INCH,
                    _ => asked()?,
                });
            }
            "FLANGEBACK" | "GAUGE" => distance = Some(asked()?),
            _ => {
                return Err(Refusal::new(Some(line), say!(line_of_no_head, text = clipped(text))));
            }
        }
    }
    place(&mut written, datum, distance, flange_back);
    written.scale(1e-3);
    Ok(written)
}

/// Put the origin of a wheel where its flange back says, and tell of the gauge of rails; all in millimetres.
fn place(written: &mut WrittenProfile, datum: Option<f64>, distance: Option<f64>, flange_back: f64) {
    let Some(distance) = distance else { return };
    if written.kind != Some(ProfileKind::Wheel) {
        let depth = datum.unwrap_or(14.0);
        written.remarks.push(say!(gauge_of_file, distance = fixed(distance, 1), depth = fixed(depth, 1)));
        return;
    }
    let origin = 0.5 * distance - flange_back;
    written.map(|[y, z]| [y - origin, z]);
    written.remarks.push(say!(flange_backs_apart, distance = fixed(distance, 1)));
    if let Some(datum) = datum.filter(|datum| (datum + flange_back).abs() > 0.05) {
        written.remarks.push(say!(tread_datum_elsewhere, datum = fixed(datum, 2), origin = fixed(-flange_back, 2)));
    }
}
