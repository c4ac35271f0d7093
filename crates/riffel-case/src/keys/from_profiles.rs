//! Where a wheel stands on its rail, from the profiles of a case.

use riffel::Rail;
use riffel_curving::profile::{Profile, ProfileContact, WheelsetContact};
use riffel_keys::CaseError;

use crate::curve::{CurvingCase, Equilibrium};

/// A contact is that of the equilibrium if its angle is within this of it \[rad\]: positions between the rows of the table are
/// interpolated, and those under load lie beside the rigid ones.
const SAME_ANGLE: f64 = 0.02;
/// Around an equilibrium both points of a wheel are looked for \[m\]: past a jump found to 1e-9 m, at which the roll of the wheelset has
/// 1e-7 rad of its own on either point, and no farther than need be, for there contacts run along a wheel by a milliradian in 1e-8 m.
const BESIDE: [f64; 9] = [0.0, -2e-9, 2e-9, -2e-8, 2e-8, -3e-8, 3e-8, -1e-7, 1e-7];

/// A place on the rail.
pub(crate) struct PlaceOnRail {
    /// From the axis of the upright rail, x = 0 of its profile, to the field side \[m\].
    pub(crate) outward: f64,
    /// Curvature of the rail there \[1/m\], positive for a convex head.
    pub(crate) rail_curvature: f64,
}

impl Equilibrium {
    /// Where a wheel of the first state stands on its rail under a contact angle \[rad\]; none on cones, and where no rigid contact has
    /// that angle.
    ///
    /// # Errors
    /// [`CaseError`] for profiles that cannot be read.
    pub(crate) fn place_on_rail(
        &self,
        wheelset: usize,
        rail: Rail,
        contact_angle: f64,
    ) -> Result<Option<PlaceOnRail>, CaseError> {
        let profiles = self.curving.file.profiles.as_ref();
        if profiles.is_none_or(|profiles| profiles.wheel == "cone") {
            return Ok(None);
        }
        let on_track = self.curving.wheelset_on_track()?;
        let beside = self.beside[wheelset].get_or_init(|| {
            let shift = self.states[0].wheelsets[wheelset].lateral_shift;
            on_track.contacts_beside(shift, &BESIDE).flatten().map(|contact| contact.contacts).collect()
        });
        let found = beside.iter().map(|contacts| contacts[usize::from(rail == Rail::Right)]);
        let off = |contact: &ProfileContact| (contact.contact_angle - contact_angle).abs();
        let nearest = found.min_by(|one, other| off(one).total_cmp(&off(other)));
        let Some(contact) = nearest.filter(|contact| off(contact) < SAME_ANGLE) else {
            return Ok(None);
        };
        let [_, across, below] = contact.on_track;
        let outward = self.curving.outward_on_rail(rail, [across, below])?;
        Ok(outward.map(|outward| PlaceOnRail { outward, rail_curvature: contact.rail_curvature }))
    }
}

impl CurvingCase {
    /// From the axis of the upright rail to the field side \[m\], of a point to the right of the middle of the track and below the
    /// crowns \[m\].
    pub(crate) fn outward_on_rail(&self, rail: Rail, [across, below]: [f64; 2]) -> Result<Option<f64>, CaseError> {
        let Some(profiles) = self.file.profiles.as_ref() else {
            return Ok(None);
        };
        let profile = self.profile_of_rail(rail)?;
        let inclination = profiles.inclination.slope.atan();
        let placed = placed_origin(&profile, inclination, profiles.gauge.si(), profiles.gauge_height.si());
        let (sine, cosine) = inclination.sin_cos();
        Ok(placed.map(|[origin, height]| cosine * (across * rail.sign() - origin) + sine * (-below - height)))
    }

    /// Whether a wheelset that stands so touches a rail under a contact angle \[rad\].
    pub(crate) fn is_under(contact: &WheelsetContact, rail: Rail, contact_angle: f64) -> bool {
        let on = &contact.contacts[usize::from(rail == Rail::Right)];
        (on.contact_angle - contact_angle).abs() < SAME_ANGLE
    }
}

/// Where the origin of a profile lies on the track: outward from the middle and above the crowns \[m\].
fn placed_origin(rail: &Profile, inclination: f64, gauge: f64, gauge_height: f64) -> Option<[f64; 2]> {
    let turned = rail.turned(inclination);
    let crown = turned.crown().height;
    let face = turned.inner_face(crown - gauge_height)?;
    Some([0.5 * gauge - face, -crown])
}
