//! What the equilibrium of a vehicle says of one contact.

use riffel::contact::Creepages;
use riffel::{HertzContact, Rail};
use riffel_curving::WheelState;
use riffel_keys::{CaseError, number, say};

use super::Placing;
use crate::curve::{CurvingCase, Equilibrium};
use crate::file::{ContactOfWheel, FromCurve};
use crate::keys::from_profiles::PlaceOnRail;

/// What the equilibrium says of one contact.
pub(super) struct MeanContact {
    pub(super) creepages: Creepages,
    pub(super) contact_angle: f64,
    /// r \[m\].
    pub(super) rolling_radius: f64,
    /// Of its wheelset, to the right \[m\].
    pub(super) lateral_shift: f64,
    /// k_H \[N/m\]; none for that of the ellipse.
    pub(super) stiffness: Option<f64>,
    /// r/cos γ: the wheel is a surface of revolution.
    pub(super) longitudinal_radius: f64,
    pub(super) normal_force: f64,
    /// `None` if the case of curving gives no curvature across the track.
    pub(super) transverse_radius: Option<f64>,
    /// None on cones.
    pub(super) place: Option<PlaceOnRail>,
    pub(super) friction: f64,
    pub(super) tractive_ratio: f64,
    /// Share of the normal forces of the wheel that its other point carries.
    pub(super) elsewhere: f64,
}

impl MeanContact {
    /// The ellipse of Hertz; `None` if the profiles do not part.
    pub(super) fn hertz(&self, curving: &CurvingCase) -> Result<Option<HertzContact>, CaseError> {
        let steel = curving.steel()?;
        let across = (self.transverse_radius).filter(|radius| *radius > 0.0 && radius.is_finite());
        let hertz = across
            .and_then(|across| HertzContact::exact(steel, self.longitudinal_radius, across, self.normal_force).ok());
        Ok(hertz)
    }
}

impl Placing<'_> {
    pub(super) fn contact_of(
        &self,
        from: &FromCurve,
        equilibrium: &Equilibrium,
        rail: Rail,
    ) -> Result<MeanContact, CaseError> {
        let (curving, state) = (&equilibrium.curving, &equilibrium.states[0]);
        let is_it = |wheel: &&WheelState| wheel.wheelset == usize::from(from.wheelset) && wheel.rail == rail;
        let Some(wheel) = state.wheels.iter().find(is_it) else {
            unreachable!("every wheelset has a wheel on either rail")
        };
        let file = &curving.file;
        let friction =
            file.contact.as_ref().map_or(0.0, |contact| contact.friction.of_rails()[usize::from(rail == Rail::Right)]);
        let across = file.contact.as_ref().and_then(|contact| contact.transverse_radius);
        let radius_of = |curvature: Option<f64>| match curvature {
            Some(curvature) => Some(curvature.recip()),
            None => across.map(|radius| radius.si()),
        };
        let wheelset = usize::from(from.wheelset) - 1;
        let shift = state.wheelsets[wheelset].lateral_shift;
        let wheel = match from.contact.unwrap_or_default() {
            ContactOfWheel::Tread => *wheel,
            ContactOfWheel::Flange => wheel.from_second_contact().ok_or_else(|| {
                let angle = wheel.contact_angle.to_degrees();
                self.text.keys.invalid(
                    "contact.from.contact",
                    say!(is_flange_but_the_wheel_stands, angle = number(format_args!("{angle:.1}"))),
                    say!(leave_it_out),
                )
            })?,
        };
        Ok(MeanContact {
            creepages: wheel.creepages,
            contact_angle: wheel.contact_angle,
            rolling_radius: wheel.rolling_radius,
            lateral_shift: shift,
            stiffness: None,
            longitudinal_radius: wheel.rolling_radius / wheel.contact_angle.cos(),
            place: equilibrium.place_on_rail(wheelset, rail, wheel.contact_angle)?,
            normal_force: wheel.normal_force,
            transverse_radius: radius_of(wheel.lateral_curvature),
            friction,
            tractive_ratio: wheel.tractive_ratio,
            elsewhere: wheel.share_of_second_contact(),
        })
    }
}
