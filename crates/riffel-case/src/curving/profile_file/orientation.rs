//! How the coordinates of a file stand, and where their origin is.

use riffel_keys::{Message, fixed, say};

use super::written::{Fault, WrittenProfile};
use crate::file::{ProfileKind, ProfileOrientation};

/// A profile wider than this \[m\] is a wheel: rail heads have 60 to 80 mm, wheels 120 to 150.
const WIDEST_RAIL: f64 = 0.1;
/// Where the tip of a flange is in the coordinates of a wheel \[m\]; elsewhere the origin is not the datum circle.
const TIP: std::ops::RangeInclusive<f64> = -0.068..=-0.035;
/// Distance of the flange back from the datum circle \[m\].
const BACK: f64 = 0.070;
/// How far from the inner end of an outline its tip lies at least if it shows the flange back \[m\].
const BEFORE_TIP: f64 = 0.008;
/// Distances of the origin from the crown of a rail, and of its height from the tread of a wheel, beyond which it lies elsewhere \[m\].
const OFF_CROWN: f64 = 0.015;
const OFF_HEIGHT: f64 = 0.010;

/// Turn the points to x positive to the field side and y upward, as it is asked or as it is found.
pub(super) fn turn(
    written: &mut WrittenProfile,
    asked: Option<ProfileOrientation>,
    kind: ProfileKind,
) -> Result<(), Fault> {
    let default = match written.of_any_orientation {
        true => ProfileOrientation::Found,
        false => ProfileOrientation::AsWritten,
    };
    let [across, up] = match asked.unwrap_or(default) {
        ProfileOrientation::AsWritten => return Ok(()),
        ProfileOrientation::Mirrored => [-1.0, 1.0],
        ProfileOrientation::UpsideDown => [1.0, -1.0],
        ProfileOrientation::Turned => [-1.0, -1.0],
        ProfileOrientation::Found => {
            if written.points.len() < 3 {
                return Ok(());
            }
            let signs = match kind {
                ProfileKind::Wheel => of_wheel(&written.points),
                ProfileKind::Rail => of_rail(&written.points),
            };
            tell(written, kind, signs);
            signs
        }
    };
    written.map(|[x, y]| [across * x, up * y]);
    if asked.unwrap_or(default) == ProfileOrientation::Found {
        place_origin(written, kind)?;
    }
    Ok(())
}

/// Wheel or rail, by the width, where nothing else tells.
pub(super) fn kind_by_width(width: f64) -> ProfileKind {
    match width > WIDEST_RAIL {
        true => ProfileKind::Wheel,
        false => ProfileKind::Rail,
    }
}

/// Signs of x and y of a wheel: its flange is most of the area beside the level of the tread, and hangs down at the inner side.
fn of_wheel(points: &[[f64; 2]]) -> [f64; 2] {
    let chords = || {
        points.windows(2).map(|pair| {
            let width = (pair[1][0] - pair[0][0]).abs();
            let middle = |axis: usize| 0.5 * (pair[0][axis] + pair[1][axis]);
            (width, middle(0), middle(1))
        })
    };
    let tread = level(points);
    let area: f64 = chords().map(|(width, _, y)| width * (y - tread)).sum();
    let of_flange = |y: f64| ((y - tread) * area.signum()).max(0.0);
    let (mut sum, mut moment) = (0.0, 0.0);
    for (width, x, y) in chords() {
        sum += width * of_flange(y);
        moment += width * of_flange(y) * x;
    }
    let ends = points
        .iter()
        .fold([f64::MAX, f64::MIN], |[low, high], [x, _]| {
            [low.min(*x), high.max(*x)]
        });
    let middle = 0.5 * (ends[0] + ends[1]);
    let outward = if moment > middle * sum { -1.0 } else { 1.0 };
    [outward, -area.signum()]
}

/// Signs of x and y of a rail: its crown is above its ends; which side is the gauge side does not show.
fn of_rail(points: &[[f64; 2]]) -> [f64; 2] {
    let ends = 0.5 * (points[0][1] + points[points.len() - 1][1]);
    [1.0, if level(points) < ends { -1.0 } else { 1.0 }]
}

/// Median of the heights over the width.
fn level(points: &[[f64; 2]]) -> f64 {
    let mut chords: Vec<(f64, f64)> = points
        .windows(2)
        .map(|pair| {
            (
                0.5 * (pair[0][1] + pair[1][1]),
                (pair[1][0] - pair[0][0]).abs(),
            )
        })
        .collect();
    chords.sort_by(|one, other| one.0.total_cmp(&other.0));
    let half = 0.5 * chords.iter().map(|(_, width)| width).sum::<f64>();
    let mut sum = 0.0;
    let at_half = chords.iter().find(|(_, width)| {
        sum += width;
        sum >= half
    });
    at_half.map_or(0.0, |(height, _)| *height)
}

fn tell(written: &mut WrittenProfile, kind: ProfileKind, [across, up]: [f64; 2]) {
    let changes = match (across < 0.0, up < 0.0) {
        (false, false) => say!(coordinates_right),
        (true, false) => say!(coordinates_mirrored),
        (false, true) => say!(coordinates_upside_down),
        (true, true) => say!(coordinates_turned),
    };
    written.remarks.push(match kind {
        ProfileKind::Wheel => say!(read_as_wheel, changes = changes),
        ProfileKind::Rail => say!(read_as_rail, changes = changes),
    });
}

/// Move an origin that lies elsewhere to the datum circle or to the crown.
fn place_origin(written: &mut WrittenProfile, kind: ProfileKind) -> Result<(), Fault> {
    let higher = |one: &&[f64; 2], other: &&[f64; 2]| one[1].total_cmp(&other[1]);
    match kind {
        ProfileKind::Rail => {
            let Some(&[x, y]) = written.points.iter().max_by(higher) else {
                return Ok(());
            };
            if x.abs() > OFF_CROWN || y.abs() > OFF_HEIGHT {
                written.map(|point| [point[0] - x, point[1] - y]);
                tell_of_origin(written, say!(to_crown), x, y);
            }
        }
        ProfileKind::Wheel => {
            let Some(&[tip, _]) = written.points.iter().min_by(higher) else {
                return Ok(());
            };
            let mut moved = 0.0;
            if !TIP.contains(&tip) {
                let back = written
                    .points
                    .iter()
                    .fold(f64::MAX, |least, [x, _]| least.min(*x));
                if tip - back < BEFORE_TIP {
                    return Err(Fault::of_file(format!(
                        "the tip of the flange lies at x = {:.1} mm and its back is not measured, so that the datum circle is not known: \
                         give coordinates with their origin on it, {:.0} mm from the flange back",
                        1e3 * tip,
                        1e3 * BACK
                    )));
                }
                moved = back + BACK;
                written.map(|[x, y]| [x - moved, y]);
            }
            let nearest =
                |one: &&[f64; 2], other: &&[f64; 2]| one[0].abs().total_cmp(&other[0].abs());
            let height = written
                .points
                .iter()
                .min_by(nearest)
                .map_or(0.0, |point| point[1]);
            let lowered = if height.abs() > OFF_HEIGHT {
                height
            } else {
                0.0
            };
            written.map(|[x, y]| [x, y - lowered]);
            if moved != 0.0 || lowered != 0.0 {
                tell_of_origin(written, say!(to_datum_circle), moved, lowered);
            }
        }
    }
    Ok(())
}

fn tell_of_origin(written: &mut WrittenProfile, place: Message, x: f64, y: f64) {
    let millimetres = |length: f64| fixed(1e3 * length, 2);
    written.remarks.push(say!(
        origin_moved,
        place = place,
        x = millimetres(x),
        y = millimetres(y)
    ));
}
