//! What the reader of an equilibrium should know.

use riffel::Rail;
use riffel::contact::EllipticContact;
use riffel::curving::{Creep, VehicleInCurve, VehicleState, WheelState};
use riffel_case::CurvingCase;
use riffel_keys::Remark;

/// Lateral shift \[m\] beyond the play that wheelsets have to their flanges.
const PLAY: f64 = 0.01;

/// A flange that yaw lets meet its rail earlier by this is told of \[m\]: gauges are kept to some tenths of a millimetre.
const EARLIER: f64 = 1e-4;

/// Remarks on an equilibrium.
pub(super) fn of(
    case: &CurvingCase,
    vehicle: &VehicleInCurve,
    state: &VehicleState,
) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let profiles = case.file.profiles.as_ref();
    let without_flange =
        profiles.is_some_and(|profiles| profiles.wheel == "cone" && profiles.flange.is_none());
    let farthest = state
        .wheelsets
        .iter()
        .map(|wheelset| wheelset.lateral_shift)
        .fold(0.0_f64, |most, shift| {
            if shift.abs() > most.abs() {
                shift
            } else {
                most
            }
        });
    if without_flange && farthest.abs() > PLAY {
        let shift = 1e3 * farthest;
        remarks.push(Remark::new(
            format!("a wheelset is shifted by {shift:.1} mm: flanges leave 5 to 10 mm of play, and this case has none"),
            format!("ein Radsatz ist um {shift:.1} mm verschoben: Spurkränze lassen 5 bis 10 mm Spiel, dieser Fall hat keine"),
        ));
    }
    let linear = vehicle
        .creep
        .iter()
        .any(|creep| matches!(creep, Creep::Linear { .. }));
    let most = state
        .wheels
        .iter()
        .flat_map(|wheel| {
            let second = wheel.second_contact.map(|second| second.tractive_ratio);
            [Some(wheel.tractive_ratio), second]
        })
        .flatten()
        .fold(0.0, f64::max);
    if linear && most > 1.0 {
        remarks.push(Remark::new(
            format!("creep_law = \"linear\" knows no friction: creep forces reach {most:.2} of μP"),
            format!("creep_law = \"linear\" kennt keine Reibung: Schlupfkräfte erreichen {most:.2} von μP"),
        ));
    }
    let wear_of = |wheel: &WheelState| {
        let second = wheel.second_contact.map_or(0.0, |second| second.t_gamma);
        wheel.t_gamma.min(second)
    };
    let least = state
        .wheels
        .iter()
        .min_by(|one, other| wear_of(one).total_cmp(&wear_of(other)));
    if let Some(wheel) = least.filter(|wheel| wear_of(wheel) < 0.0) {
        let (wheelset, rail, wear) = (wheel.wheelset, wheel.rail.name(), wear_of(wheel));
        remarks.push(Remark::new(
            format!(
                "Tγ of wheel {wheelset} {rail} is {wear:.3} N: it is Qx ξx + Qy ξy without the moment of spin, and spin, not \
                 creepage, makes the lateral force there"
            ),
            format!(
                "Tγ von Rad {wheelset} {} ist {wear:.3} N: es ist Qx ξx + Qy ξy ohne das Bohrmoment, und die Querkraft kommt \
                 dort vom Bohren, nicht vom Schlupf",
                if rail == "left" { "links" } else { "rechts" }
            ),
        ));
    }
    remarks.extend(wide_ellipse(case, state));
    remarks.extend(flange_under_yaw(case, state));
    remarks
}

/// The widest ellipse, where it is wider than a profile keeps its curvature.
fn wide_ellipse(case: &CurvingCase, state: &VehicleState) -> Option<Remark> {
    let material = case.steel().ok()?;
    let width = |wheel: &WheelState| -> Option<f64> {
        let along = wheel.contact_angle.cos() / wheel.rolling_radius;
        let curvatures = [along, wheel.lateral_curvature?];
        let hertz = EllipticContact::of_wheel_on_rail(material, curvatures, wheel.normal_force);
        let hertz = hertz.ok()?;
        Some(2.0 * hertz.semi_axis_lateral())
    };
    let widths = state
        .wheels
        .iter()
        .filter_map(|wheel| Some((wheel, width(wheel)?)));
    let (wheel, width) = widths.max_by(|one, other| one.1.total_cmp(&other.1))?;
    (width > EllipticContact::WIDEST).then(|| {
        let (number, rail, width) = (wheel.wheelset, wheel.rail.name(), 1e3 * width);
        Remark::new(
            format!(
                "the ellipse of wheel {number} {rail} is {width:.0} mm wide: over that no profile has one curvature, Hertz's theory ends, and \
                 creep laws differ most"
            ),
            format!(
                "die Ellipse von Rad {number} {} ist {width:.0} mm breit: darüber hat kein Profil eine einzige Krümmung, die Theorie von Hertz \
                 endet, und Schlupfgesetze weichen am meisten voneinander ab",
                if rail == "left" { "links" } else { "rechts" }
            ),
        )
    })
}

/// The geometry of the contacts is that without yaw: what yaw does to the play of the most yawed wheelset.
fn flange_under_yaw(case: &CurvingCase, state: &VehicleState) -> Option<Remark> {
    let wheelset_on_track = case.wheelset_on_track().ok()?;
    let (index, wheelset) = state
        .wheelsets
        .iter()
        .enumerate()
        .max_by(|one, other| one.1.yaw.abs().total_cmp(&other.1.yaw.abs()))?;
    let rail = match wheelset.lateral_shift > 0.0 {
        true => Rail::Right,
        false => Rail::Left,
    };
    let straight = wheelset_on_track.flange_shift(rail, 0.0)?;
    let yawed = wheelset_on_track.flange_shift(rail, wheelset.yaw)?;
    (straight - yawed > EARLIER).then(|| {
        let (number, yaw) = (index + 1, 1e3 * wheelset.yaw.abs());
        let (straight, yawed) = (1e3 * straight, 1e3 * yawed);
        Remark::new(
            format!(
                "with its yaw of {yaw:.0} mrad wheelset {number} has {yawed:.1} mm to its flange, not the {straight:.1} mm of the tables: \
                 contacts are placed as without yaw"
            ),
            format!(
                "mit seinem Gierwinkel von {yaw:.0} mrad hat Radsatz {number} {yawed:.1} mm bis zum Spurkranz, nicht die {straight:.1} mm \
                 der Tabellen: Kontakte liegen, wo sie ohne Gieren liegen"
            ),
        )
    })
}
