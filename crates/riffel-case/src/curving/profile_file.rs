//! Files of profiles: two columns, lateral coordinate and height, in millimetres or metres.

use std::path::Path;

use riffel::profile::{NominalProfile, Profile, ProfileError, SmoothedPoints};
use riffel_keys::{CaseError, Remark, clipped, text_file};

/// Largest file of a profile \[bytes\].
const LARGEST: u64 = 16 << 20;
/// A profile without a unit is in millimetres if it is wider than this number; none is wider than this in metres.
const WIDEST_IN_METRES: f64 = 1.0;

/// A profile, and what is to be told of its points.
pub struct ProfileOfName {
    /// The profile.
    pub profile: Profile,
    /// Of a file whose points scatter.
    pub remarks: Vec<Remark>,
}

/// A profile of a name or of a file, whose points are smoothed if their scatter \[m\] is given.
///
/// # Errors
/// [`CaseError`] with file and line.
pub fn profile_of(
    name: &str,
    folder: &Path,
    scatter: Option<f64>,
) -> Result<ProfileOfName, CaseError> {
    match NominalProfile::named(name) {
        Some(nominal) => Ok(ProfileOfName {
            profile: nominal.profile(),
            remarks: Vec::new(),
        }),
        None => read_profile(&folder.join(name), scatter),
    }
}

/// The profile of a file of two columns, lateral coordinate (positive to the field side) and height (positive upward), with
/// comma, semicolon or blanks between them. Lines that begin with # are comments. A head such as `x_mm,y_mm` or
/// `x [m]; y [m]` tells the unit; without one a profile of more than 1 across is in millimetres. Numbers may have a decimal comma where
/// something else parts the columns. With the scatter \[m\] of the points the curve is a smooth one, else it goes through them, and a remark
/// tells what that does to its curvature.
///
/// # Errors
/// [`CaseError`] with file and line.
pub fn read_profile(path: &Path, scatter: Option<f64>) -> Result<ProfileOfName, CaseError> {
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
        let numbers: Vec<Option<f64>> = cells.iter().map(|cell| number(cell)).collect();
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
    let refuse = |error: ProfileError| match &error {
        ProfileError::Point { index, .. } => {
            at_fault(lines.get(*index).copied(), error.to_string())
        }
        _ => at_fault(None, error.to_string()),
    };
    let name = path.display();
    let Some(scatter) = scatter else {
        let profile = Profile::through(&points).map_err(refuse)?;
        let remarks = of_scatter(&name.to_string(), &points).into_iter().collect();
        return Ok(ProfileOfName { profile, remarks });
    };
    let smooth = SmoothedPoints::new(&points, scatter).map_err(refuse)?;
    let mut remarks = Vec::new();
    if let Some(&first) = smooth.dropped.first() {
        let (count, line) = (smooth.dropped.len(), lines[first]);
        remarks.push(Remark::new(
            format!("{name}: {count} points far off those beside them are left out, the first in line {line}"),
            format!("{name}: {count} Punkte weit neben ihren Nachbarn sind weggelassen, der erste in Zeile {line}"),
        ));
    }
    let nearest = smooth.points.iter().zip(&smooth.curvature_errors);
    let nearest = nearest.min_by(|one, other| one.0[0].abs().total_cmp(&other.0[0].abs()));
    if let Some((_, error)) = nearest {
        remarks.push(Remark::new(
            format!("{name}: scatter leaves ±{error:.2} 1/m of the curvature at x = 0"),
            format!("{name}: Streuung lässt ±{error:.2} 1/m der Krümmung bei x = 0"),
        ));
    }
    let profile = Profile::through(&smooth.points).map_err(refuse)?;
    Ok(ProfileOfName { profile, remarks })
}

/// That a curve through points bends with their scatter, where that is worth a word.
fn of_scatter(name: &str, points: &[[f64; 2]]) -> Option<Remark> {
    /// Curvature \[1/m\], a third of that of a rail head.
    const WORTH_A_REMARK: f64 = 1.0;
    let scatter = SmoothedPoints::scatter_of(points)?;
    let (first, last) = (points[0], points[points.len() - 1]);
    let length = (last[0] - first[0]).hypot(last[1] - first[1]);
    let step = length / (points.len() - 1) as f64;
    // Of the second difference of three points.
    let curvature = 6f64.sqrt() * scatter / (step * step);
    let micrometres = 1e6 * scatter;
    (curvature > WORTH_A_REMARK).then(|| {
        Remark::new(
            format!(
                "{name}: the points scatter by {micrometres:.2} µm, so that the curvature of a curve through them is off by some \
                 {curvature:.0} 1/m; give that scatter (profiles.scatter, --scatter) for a smooth one"
            ),
            format!(
                "{name}: die Punkte streuen um {micrometres:.2} µm, so dass die Krümmung einer Kurve durch sie um etwa \
                 {curvature:.0} 1/m daneben liegt; geben Sie diese Streuung an (profiles.scatter, --scatter), um zu glätten"
            ),
        )
    })
}

/// A number, with a decimal point or a decimal comma, in quotes or not.
fn number(cell: &str) -> Option<f64> {
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Scatter is told, and smoothed if it is given; a spike is left out with its line.
    #[test]
    fn scatter_is_told_and_smoothed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rail.csv");
        // Alternate by 10 µm: their deviation.
        let mut text = String::from("x_mm,y_mm\n");
        for index in -100..=100 {
            let x = 0.25 * f64::from(index);
            let off = if index % 2 == 0 { 0.01 } else { -0.01 };
            let spike = if index == 40 { 0.4 } else { 0.0 };
            text += &format!("{x},{}\n", -x * x / 600.0 + off + spike);
        }
        std::fs::write(&path, text).unwrap();
        let through = read_profile(&path, None).unwrap();
        let told = through.remarks[0].to_string();
        assert!(
            told.contains("the points scatter by") && told.contains("profiles.scatter"),
            "{told}"
        );
        let smooth = read_profile(&path, Some(10e-6)).unwrap();
        let told: Vec<String> = smooth.remarks.iter().map(ToString::to_string).collect();
        assert!(
            told[0].contains("1 points far off") && told[0].contains("line 142"),
            "{told:?}"
        );
        assert!(told[1].contains("at x = 0"), "{told:?}");
        let of = |profile: &Profile| profile.at(0.1e-3).unwrap().curvature;
        assert!(
            (of(&smooth.profile) + 1.0 / 0.3).abs() < 1.0,
            "{}",
            of(&smooth.profile)
        );
        assert!((of(&through.profile) + 1.0 / 0.3).abs() > 100.0);
    }

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
            read_profile(&path, None).map(|read| read.profile)
        };
        for text in [
            arc(1e3, ","),
            format!("# crown at the origin\nx_mm,y_mm\n{}", arc(1e3, ",")),
            format!("x [m]; y [m]\n{}", arc(1.0, ";")),
            arc(1.0, "  ").replace('\n', "\r\n"),
            arc(1e3, ";").replace('.', ","),
            arc(1e3, "\t").replace('.', ","),
            arc(1e3, " ").replace('.', ","),
            format!(
                "\"x_mm\";\"y_mm\"\n{}",
                arc(1e3, "\";\"")
                    .replace('\n', "\"\n\"")
                    .trim_end_matches('"')
                    .replacen("-20", "\"-20", 1)
            ),
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
