//! How the coordinates of a file stand, and where their origin is.

use riffel_keys::{Message, fixed, say};

use super::reading::{ProfileKind, ProfileOrientation, ProfileReading};
use super::written::WrittenProfile;
use crate::refusal::Refusal;

/// A profile wider than this \[m\] is a wheel: rail heads have 60 to 80 mm, wheels 120 to 150.
const WIDEST_RAIL: f64 = 0.1;
/// Where the tip of a flange is in the coordinates of a wheel \[m\]; elsewhere the origin is not the datum circle.
const TIP: std::ops::RangeInclusive<f64> = -0.068..=-0.035;
/// Distance of the flange back from the datum circle \[m\].
const BACK: f64 = 0.070;
/// How far from the inner end of an outline its tip lies at least if it shows the flange back \[m\].
const BEFORE_TIP: f64 = 0.008;
/// By how much a flange back that was measured may lie elsewhere than it is taken to \[m\]: a tenth of the play of a wheelset.
const OFF_BACK: f64 = 1e-3;
/// Distances of the origin from the crown of a rail, and of its height from the tread of a wheel, beyond which it lies elsewhere \[m\].
const OFF_CROWN: f64 = 0.015;
const OFF_HEIGHT: f64 = 0.010;

/// Turn the points to x positive to the field side and y upward, as it is asked or as it is found, and put the origin in its
/// place.
pub(super) fn turn(written: &mut WrittenProfile, reading: ProfileReading, kind: ProfileKind) -> Result<(), Refusal> {
    let default = match written.of_any_orientation {
        true => ProfileOrientation::Found,
        false => ProfileOrientation::AsWritten,
    };
    let orientation = reading.orientation.unwrap_or(default);
    let is_found = orientation == ProfileOrientation::Found;
    let [across, up] = match orientation {
        ProfileOrientation::AsWritten => [1.0, 1.0],
        ProfileOrientation::Mirrored => [-1.0, 1.0],
        ProfileOrientation::UpsideDown => [1.0, -1.0],
        ProfileOrientation::Turned => [-1.0, -1.0],
        ProfileOrientation::Found if written.points.len() < 3 => return Ok(()),
        ProfileOrientation::Found => match kind {
            ProfileKind::Wheel => of_wheel(&written.points),
            ProfileKind::Rail => of_rail(written),
        },
    };
    written.map(|[x, y]| [across * x, up * y]);
    let [x, y] = written.offset;
    add_offset(written, [across * x, up * y], reading.flange_back, kind);
    match kind {
        ProfileKind::Rail => tell_of_rail(written, is_found, [across, up]),
        ProfileKind::Wheel if is_found => {
            let changes = changes([across, up]);
            written.remarks.push(say!(read_as_wheel, changes));
        }
        ProfileKind::Wheel => {}
    }
    if is_found {
        place_origin(written, kind)?;
    }
    if kind == ProfileKind::Wheel {
        tell_of_flange_back(written, reading.flange_back);
    }
    Ok(())
}

/// Add what the head says is to be added, unless the flange back shows that it is in the coordinates already.
fn add_offset(written: &mut WrittenProfile, offset: [f64; 2], usual: f64, kind: ProfileKind) {
    if offset == [0.0; 2] {
        return;
    }
    let [x, y] = offset.map(|value| fixed(1e3 * value, 2));
    let back = flange_back(&written.points).filter(|_| kind == ProfileKind::Wheel);
    let is_in = |back: f64| {
        let off = (back - usual).abs();
        off < OFF_BACK && off < (back + offset[0] - usual).abs()
    };
    if back.is_some_and(is_in) {
        written.remarks.push(say!(offset_is_in, x));
        return;
    }
    written.map(|[x, y]| [x + offset[0], y + offset[1]]);
    written.remarks.push(say!(offset_added, x, y));
}

/// Where the flange back lies across, if the points reach round to where it is nearly upright.
fn flange_back(points: &[[f64; 2]]) -> Option<f64> {
    /// Slope of 75°, within half a millimetre of the upright for fillets of 12 mm and more.
    const UPRIGHT: f64 = 3.7;
    /// Length across from the innermost point in which the back turns \[m\].
    const NEAR: f64 = 1e-3;
    let inner = points.iter().fold(f64::MAX, |inner, [x, _]| inner.min(*x));
    let is_upright = |pair: &[[f64; 2]]| {
        let [across, up] = [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]];
        let near = pair.iter().all(|point| point[0] - inner < NEAR);
        near && up.abs() > UPRIGHT * across.abs()
    };
    points.windows(2).any(is_upright).then_some(inner)
}

/// Say of a flange back that lies elsewhere than it is taken to lie, for the wheel is then placed wrongly on its axle.
fn tell_of_flange_back(written: &mut WrittenProfile, usual: f64) {
    let Some(back) = flange_back(&written.points) else {
        return;
    };
    if (back - usual).abs() > OFF_BACK {
        let millimetres = |length: f64| fixed(1e3 * length, 1);
        written.remarks.push(say!(
            flange_back_elsewhere,
            back = millimetres(back),
            usual = millimetres(usual),
            off = millimetres((back - usual).abs())
        ));
    }
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
    let ends = points.iter().fold([f64::MAX, f64::MIN], |[low, high], [x, _]| [low.min(*x), high.max(*x)]);
    let middle = 0.5 * (ends[0] + ends[1]);
    let outward = if moment > middle * sum { -1.0 } else { 1.0 };
    [outward, -area.signum()]
}

/// Signs of x and y of a rail: its crown is above its ends, and if it is inclined its head leans to the gauge side.
fn of_rail(written: &WrittenProfile) -> [f64; 2] {
    let points = &written.points;
    let ends = 0.5 * (points[0][1] + points[points.len() - 1][1]);
    let up = if level(points) < ends { -1.0 } else { 1.0 };
    let upright: Vec<[f64; 2]> = points.iter().map(|[x, y]| [*x, up * y]).collect();
    let leans_outward =
        !written.gauge_side_known && matches!(Lean::of(&upright), Some(Lean::Inclined(off)) if off > 0.0);
    [if leans_outward { -1.0 } else { 1.0 }, up]
}

/// How far the middle of a head lies beside its highest point \[m\], below zero towards smaller x, where that is farther than side wear
/// makes it.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Lean {
    /// Lean of the head of an inclined rail to its gauge side.
    Inclined(f64),
    /// Farther than an inclination makes it, so that it tells no side.
    Unclear(f64),
}

impl Lean {
    /// A rail that is inclined by α has its highest point on the arc of its crown, of radius R, R tan α off the middle of its head: 7.5 mm
    /// for 1:40 and 300 mm, 15 mm at most, and the middle lies at the gauge side. Side wear moves the middle by half its depth the
    /// other way, and narrows the head; a few milliradians by which a device stood aslant move the highest point of a flat crown as
    /// far, but the chord 1 mm below it less than an inclination does.
    ///
    /// Points in either order have one answer. Accuracy: test `a_head_shows_its_gauge_side`.
    fn of(points: &[[f64; 2]]) -> Option<Self> {
        /// Below the highest point: of the chords that are the top and the crown, where the middle is looked for, and where a head must
        /// reach to at least \[m\].
        const DEPTHS: [f64; 4] = [1e-4, 1e-3, 14e-3, 5e-3];
        /// Of heads that stand upright: off the middle \[m\], and as an angle, half of an inclination of 1:40.
        const UPRIGHT: (f64, f64) = (5e-3, 1.0 / 80.0);
        /// Farthest that an inclination moves the highest point \[m\].
        const FARTHEST: f64 = 20e-3;
        /// Width of the heads of rails \[m\]; narrower ones are worn.
        const HEAD: f64 = 70e-3;
        let highest = points.iter().map(|point| point[1]).fold(f64::MIN, f64::max);
        let [top, _] = chord(points, highest - DEPTHS[0])?;
        let [crown, wide] = chord(points, highest - DEPTHS[1])?;
        let depth_of_side = |side: f64| {
            let beside = points.iter().filter(|[x, _]| side * (x - top) > 0.0);
            beside.fold(0.0, |deepest: f64, [_, y]| deepest.max(highest - y))
        };
        let depth = depth_of_side(-1.0).min(depth_of_side(1.0)).min(DEPTHS[2]);
        if depth < DEPTHS[3] {
            return None;
        }
        let [middle, width] = chord(points, highest - depth)?;
        let off = middle - top;
        let by_wear = 0.5 * (HEAD - width).max(0.0);
        let radius = wide * wide / (8.0 * DEPTHS[1]);
        let angle = ((middle - crown).abs() - by_wear) / radius;
        if off.abs() < UPRIGHT.0 + by_wear || angle < UPRIGHT.1 || off * (middle - crown) < 0.0 {
            return None;
        }
        Some(match off.abs() > FARTHEST {
            true => Self::Unclear(off),
            false => Self::Inclined(off),
        })
    }
}

/// Middle and width of a head at a height \[m\]; `None` if fewer than two sides come there.
fn chord(points: &[[f64; 2]], height: f64) -> Option<[f64; 2]> {
    let sides = points.windows(2).filter_map(|pair| {
        let [one, other] = [pair[0], pair[1]];
        let crosses = (one[1] - height) * (other[1] - height) <= 0.0 && one[1] != other[1];
        crosses.then(|| one[0] + (height - one[1]) / (other[1] - one[1]) * (other[0] - one[0]))
    });
    let [low, high] = sides.fold([f64::MAX, f64::MIN], |[low, high], x| [low.min(x), high.max(x)]);
    (high > low).then_some([0.5 * (low + high), high - low])
}

/// Median of the heights over the width.
fn level(points: &[[f64; 2]]) -> f64 {
    let mut chords: Vec<(f64, f64)> =
        points.windows(2).map(|pair| (0.5 * (pair[0][1] + pair[1][1]), (pair[1][0] - pair[0][0]).abs())).collect();
    chords.sort_by(|one, other| one.0.total_cmp(&other.0));
    let half = 0.5 * chords.iter().map(|(_, width)| width).sum::<f64>();
    let mut sum = 0.0;
    let at_half = chords.iter().find(|(_, width)| {
        sum += width;
        sum >= half
    });
    at_half.map_or(0.0, |(height, _)| *height)
}

fn changes([across, up]: [f64; 2]) -> Message {
    match (across < 0.0, up < 0.0) {
        (false, false) => say!(coordinates_right),
        (true, false) => say!(coordinates_mirrored),
        (false, true) => say!(coordinates_upside_down),
        (true, true) => say!(coordinates_turned),
    }
}

/// Say how a rail was found to stand, or that its head leans to what is given as its field side.
fn tell_of_rail(written: &mut WrittenProfile, is_found: bool, signs: [f64; 2]) {
    let millimetres = |off: f64| fixed(1e3 * off.abs(), 1);
    let changes = changes(signs);
    written.remarks.extend(match (is_found, Lean::of(&written.points)) {
        (true, Some(Lean::Inclined(off))) if off < 0.0 => {
            Some(say!(read_as_leaning_rail, changes, off = millimetres(off)))
        }
        (true, Some(Lean::Unclear(off))) if !written.gauge_side_known => {
            Some(say!(read_as_undecided_rail, changes, off = millimetres(off)))
        }
        (true, _) => Some(say!(read_as_rail, changes)),
        (false, Some(Lean::Inclined(off))) if off > 0.0 => Some(say!(rail_leans_outward, off = millimetres(off))),
        (false, _) => None,
    });
}

/// Move an origin that lies elsewhere to the datum circle or to the crown.
fn place_origin(written: &mut WrittenProfile, kind: ProfileKind) -> Result<(), Refusal> {
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
                let back = written.points.iter().fold(f64::MAX, |least, [x, _]| least.min(*x));
                if tip - back < BEFORE_TIP {
                    return Err(Refusal::new(
                        None,
                        say!(datum_circle_not_known, tip = fixed(1e3 * tip, 1), back = fixed(1e3 * BACK, 0)),
                    ));
                }
                moved = back + BACK;
                written.map(|[x, y]| [x - moved, y]);
            }
            let nearest = |one: &&[f64; 2], other: &&[f64; 2]| one[0].abs().total_cmp(&other[0].abs());
            let height = written.points.iter().min_by(nearest).map_or(0.0, |point| point[1]);
            let lowered = if height.abs() > OFF_HEIGHT { height } else { 0.0 };
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
    written.remarks.push(say!(origin_moved, place, x = millimetres(x), y = millimetres(y)));
}
