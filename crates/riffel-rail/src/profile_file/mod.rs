//! Files of profiles: columns, and the text formats of devices and of programs for vehicle dynamics.

mod mini_prof;
mod orientation;
mod reading;
mod simpack;
mod table;
mod vampire;
mod written;

use std::path::Path;

use riffel_curving::profile::{NominalProfile, Profile, ProfileError, SmoothedPoints};
use riffel_keys::{CaseError, Message, Value, fixed, say, text_file};

pub use self::reading::{ProfileKind, ProfileOrientation, ProfileReading};
use self::written::{NARROWEST, WIDEST_IN_METRES, WrittenProfile};
use crate::refusal::Refusal;

/// Largest file of a profile \[bytes\].
const LARGEST: u64 = 16 << 20;

/// Fewer points are no profile of any width.
const FEWEST: usize = 8;

/// A profile, and what is to be told of its points.
pub struct ProfileOfName {
    /// The profile.
    pub profile: Profile,
    /// Wheel or rail, as the file or the case says, or by its width.
    pub kind: ProfileKind,
    /// Of a file whose points scatter, or whose coordinates were turned.
    pub remarks: Vec<Message>,
}

/// A profile of a name or of a file.
///
/// # Errors
/// [`CaseError`] with file and line.
pub fn profile_of(name: &str, folder: &Path, reading: ProfileReading) -> Result<ProfileOfName, CaseError> {
    match NominalProfile::named(name) {
        Some(nominal) => Ok(ProfileOfName {
            profile: nominal.profile(),
            kind: match nominal.is_wheel {
                true => ProfileKind::Wheel,
                false => ProfileKind::Rail,
            },
            remarks: Vec::new(),
        }),
        None => read_profile(&folder.join(name), reading),
    }
}

/// The profile of a file, told apart by its first line: that of MiniProf (lines `key=value`, then columns X and Y), of Simpack
/// (`header.begin`), of Vampire (`WHEELPROFILE`, `RAILPROFILE`), or else two columns, lateral coordinate (positive to the field side) and
/// height (positive upward), with comma, semicolon or blanks between them. What follows #, ! or % is a comment. A head such as
/// `x_mm,y_mm` or `x [m]; y [m]` tells the unit of columns; without one a profile of more than 1 across is in millimetres. Numbers may
/// have a decimal comma where something else parts the columns.
///
/// The coordinates of columns stand as they are written; those of the other formats are turned to field side and up as they are found, and an origin
/// off the datum circle or the crown is moved there, each with a remark. With the scatter \[m\] of the points the curve is a smooth one,
/// else it goes through them, and a remark tells what that does to its curvature.
///
/// # Errors
/// [`CaseError`] with file and line.
pub fn read_profile(path: &Path, reading: ProfileReading) -> Result<ProfileOfName, CaseError> {
    let bytes = text_file::read_bounded(path, "profile", LARGEST)?;
    let at_fault = |line: Option<usize>, message: Message| Refusal::new(line, message).of(path);
    let of_fault = |fault: Refusal| fault.of(path);
    let text = text_file::decode(bytes).map_err(|binary| at_fault(Some(binary.line), binary.into()))?;
    let extension = path.extension().and_then(|extension| extension.to_str());
    let extension = extension.unwrap_or_default().to_lowercase();
    let mut written = of_format(&text, &extension, reading).map_err(of_fault)?;
    let kind = match (reading.kind, written.kind) {
        (Some(asked), Some(kind)) if asked != kind => {
            let other = match kind {
                ProfileKind::Wheel => say!(is_profile_of_wheel),
                ProfileKind::Rail => say!(is_profile_of_rail),
            };
            return Err(at_fault(None, other));
        }
        (asked, kind) => asked.or(kind).unwrap_or_else(|| orientation::kind_by_width(written.width())),
    };
    check_width(&written).map_err(|message| at_fault(None, message))?;
    orientation::turn(&mut written, reading, kind).map_err(of_fault)?;
    let WrittenProfile { points, lines, remarks: of_format, .. } = written;
    let refuse = |error: ProfileError| match &error {
        ProfileError::Point { index, .. } => at_fault(lines.get(*index).copied(), (&error).into()),
        _ => at_fault(None, (&error).into()),
    };
    let name = path.display().to_string();
    let named = |remark: &Message| say!(about, subject = &name, remark = remark.clone());
    let mut remarks: Vec<Message> = of_format.iter().map(named).collect();
    remarks.extend(of_gaps(&name, &points));
    let Some(scatter) = reading.scatter else {
        let profile = Profile::through(&points).map_err(refuse)?;
        remarks.extend(of_scatter(&name, &points));
        return Ok(ProfileOfName { profile, kind, remarks });
    };
    let smooth = SmoothedPoints::new(&points, scatter).map_err(refuse)?;
    remarks.extend(of_smoothing(&name, &smooth, &lines));
    // The line of a point that is left: dropped ones are not counted.
    let left: Vec<usize> = (0..points.len()).filter(|index| smooth.dropped.binary_search(index).is_err()).collect();
    let profile = Profile::through(&smooth.points).map_err(|error| match error {
        ProfileError::Point { index, fault } => {
            refuse(ProfileError::Point { index: left.get(index).copied().unwrap_or(index), fault })
        }
        error => refuse(error),
    })?;
    Ok(ProfileOfName { profile, kind, remarks })
}

/// Why a profile is too wide or too narrow for a wheel or a rail, if it is.
fn check_width(written: &WrittenProfile) -> Result<(), Message> {
    let across = written.width();
    if across > WIDEST_IN_METRES {
        return Err(say!(wider_than_any, across = fixed(across, 4)));
    }
    if across < NARROWEST && written.points.len() >= FEWEST {
        return Err(say!(narrower_than_any, across = fixed(1e3 * across, 3)));
    }
    Ok(())
}

/// Where a profile has no points for so long that what is drawn there was not measured.
fn of_gaps(name: &str, points: &[[f64; 2]]) -> Option<Message> {
    /// Longest distance across of two points of a profile that was measured \[m\], and how much more than the others have: a flange back
    /// or a side needs no point between its ends.
    const LONGEST: (f64, f64) = (5e-3, 5.0);
    let steps = points.windows(2);
    let steps: Vec<f64> = steps.map(|pair| (pair[1][0] - pair[0][0]).abs()).collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let longest = LONGEST.0.max(LONGEST.1 * sorted.get(sorted.len() / 2)?);
    let gaps = points.windows(2).zip(&steps);
    let gaps = gaps.filter(|(_, step)| **step > longest);
    let gaps: Vec<Value> = gaps
        .map(|(pair, _)| {
            let [from, to] = [pair[0][0], pair[1][0]].map(|across| fixed(1e3 * across, 1));
            say!(between_millimetres, from, to).into()
        })
        .collect();
    (!gaps.is_empty()).then(|| say!(profile_has_gaps, name, gaps = Value::List(gaps)))
}

/// Points left out of a smooth curve, and how well its curvature is known.
fn of_smoothing(name: &str, smooth: &SmoothedPoints, lines: &[usize]) -> Vec<Message> {
    let mut remarks = Vec::new();
    if let Some(&first) = smooth.dropped.first() {
        let (count, line) = (smooth.dropped.len(), lines[first]);
        remarks.push(say!(outlying_points_left_out, name, count, line));
    }
    let nearest = smooth.points.iter().zip(&smooth.curvature_errors);
    let nearest = nearest.min_by(|one, other| one.0[0].abs().total_cmp(&other.0[0].abs()));
    if let Some((_, error)) = nearest {
        remarks.push(say!(scatter_of_curvature, name, error = fixed(*error, 2)));
    }
    remarks
}

/// The points of a text, by its format.
fn of_format(text: &str, extension: &str, reading: ProfileReading) -> Result<WrittenProfile, Refusal> {
    if matches!(extension, "slcs" | "slcw") {
        return Err(Refusal::new(None, say!(is_list_of_slices)));
    }
    let first = text.lines().map(table::without_comment).find(|line| !line.is_empty());
    let written = match first.unwrap_or_default() {
        line if simpack::is_first_line(line) => simpack::read(text)?,
        line if vampire::is_first_line(line) => vampire::read(text, reading.side, 1e3 * reading.flange_back)?,
        line if mini_prof::is_first_line(line) => mini_prof::read(text, extension)?,
        _ => table::read(text)?,
    };
    Ok(written)
}

/// That a curve through points bends with their scatter, where that is worth a word.
fn of_scatter(name: &str, points: &[[f64; 2]]) -> Option<Message> {
    /// Curvature \[1/m\], a third of that of a rail head.
    const WORTH_A_REMARK: f64 = 1.0;
    let scatter = SmoothedPoints::scatter_of(points)?;
    let (first, last) = (points[0], points[points.len() - 1]);
    let length = (last[0] - first[0]).hypot(last[1] - first[1]);
    let step = length / (points.len() - 1) as f64;
    // Of the second difference of three points.
    let curvature = 6f64.sqrt() * scatter / (step * step);
    let micrometres = 1e6 * scatter;
    (curvature > WORTH_A_REMARK)
        .then(|| say!(points_scatter, name, micrometres = fixed(micrometres, 2), curvature = fixed(curvature, 0)))
}

#[cfg(test)]
mod tests;
