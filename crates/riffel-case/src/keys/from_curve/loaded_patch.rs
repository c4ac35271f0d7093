//! The patch of a contact by its own profiles under load.

use std::f64::consts::PI;

use riffel::{HertzContact, Rail};
use riffel_curving::profile::{ContactSurface, LoadedContact, ProfileError};
use riffel_keys::{CaseError, Message, Value, fixed, number, say};

use super::Placing;
use super::curve_remarks::on_rail;
use super::mean_contact::MeanContact;
use crate::curve::CurvingCase;
use crate::file::{CreepLawName, HertzTheory, Patch};

/// A patch that is no ellipse, and what is like it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadedPatch {
    /// k_H \[N/m\].
    pub(crate) stiffness: f64,
    /// Semi-axes along and across \[m\] of the ellipse with the area of the patch and with the ratio of axes that the second
    /// moments of its pressure have.
    pub(crate) semi_axes: [f64; 2],
    /// Angle of its plane γ \[rad\].
    pub(crate) contact_angle: f64,
    /// Across the track from its middle, and below the crowns \[m\].
    pub(crate) on_track: [f64; 2],
}

impl CurvingCase {
    /// Elements of the grid of a contact under load, across a patch that is as long as wide: approach, pressure and stiffness to
    /// 3·10⁻³ of those of 96, the area to 3 %.
    pub const ELEMENTS_UNDER_LOAD: usize = 48;

    /// The contact of a wheel by its profiles under a normal force \[N\], where a rigid one stands at a lateral shift \[m\] under a
    /// contact angle \[rad\]; within, why there is no such patch, as the end of a sentence.
    ///
    /// # Errors
    /// [`CaseError`] for cones and for profiles that cannot be read.
    pub(crate) fn loaded_patch(
        &self,
        rail: Rail,
        lateral_shift: f64,
        contact_angle: f64,
        normal_force: f64,
        surface: ContactSurface,
    ) -> Result<Result<LoadedPatch, Message>, CaseError> {
        let wheelset = self.wheelset_on_track()?;
        let steel = self.steel()?;
        let Some(contact) =
            wheelset.contact(lateral_shift, 0.0).ok().filter(|contact| Self::is_under(contact, rail, contact_angle))
        else {
            let degrees = contact_angle.to_degrees();
            return Ok(Err(say!(no_rigid_contact_at_angle, degrees = fixed(degrees, 2))));
        };
        let elements = Self::ELEMENTS_UNDER_LOAD;
        let loaded = wheelset.under_load(&contact, rail, steel, normal_force, surface, elements);
        Ok(loaded
            .map_err(|error| match error {
                ProfileError::Contact(riffel::Error::GridTooSmall { .. }) => say!(patches_join),
                error => Message::from(&error),
            })
            .and_then(|loaded| LoadedPatch::of(&loaded).map_err(|error| Message::from(&error))))
    }
}

impl LoadedPatch {
    fn of(loaded: &LoadedContact) -> Result<Self, riffel::Error> {
        let gap = loaded.gap();
        let [_, across, below] = gap.on_track();
        Ok(Self {
            stiffness: loaded.stiffness()?,
            semi_axes: like(loaded),
            contact_angle: gap.contact_angle(),
            on_track: [across, below],
        })
    }
}

/// A difference in per cent, with its sign.
fn signed(percent: f64) -> Value {
    number(format_args!("{percent:+.0}"))
}

/// Semi-axes of the ellipse like a patch.
fn like(loaded: &LoadedContact) -> [f64; 2] {
    let [a, b] = loaded.equivalent_semi_axes();
    let scale = (loaded.state().contact_area() / (PI * a * b)).sqrt();
    [scale * a, scale * b]
}

impl Placing<'_> {
    /// Put the patch of the profiles under load in the place of Hertz's, if the case asks for it; else tell how far that is off,
    /// unless it must be quick.
    pub(super) fn take_patch(
        &mut self,
        patch: Patch,
        curving: &CurvingCase,
        rail: Rail,
        contact: &mut MeanContact,
        quick: bool,
    ) -> Result<(), CaseError> {
        let (name, surface) = match patch {
            Patch::Hertz if quick => return Ok(()),
            Patch::Hertz => return self.tell_of_conformal(curving, rail, contact),
            Patch::NonElliptic => ("non-elliptic", ContactSurface::Flat),
            Patch::Conformal => ("conformal", ContactSurface::Curved),
        };
        let file = &self.file.contact;
        let paper = match file.hertz {
            Some(theory) => theory == HertzTheory::Paper,
            None => file.creep_law == Some(CreepLawName::CARTER_3D),
        };
        if paper {
            let rule = say!(is_but_the_ellipse_like_it, name);
            let help = "choose contact.hertz = \"exact\", or leave contact.from.patch out";
            return Err(self.text.keys.invalid("contact.from.patch", &rule, help));
        }
        let loaded = match contact.elsewhere > 0.0 {
            true => Err(say!(two_points_join_under_load)),
            false => curving.loaded_patch(
                rail,
                contact.lateral_shift,
                contact.contact_angle,
                contact.normal_force,
                surface,
            )?,
        };
        let loaded = match loaded {
            Ok(loaded) => loaded,
            Err(reason) => {
                self.remarks.push(say!(ellipse_in_place_of_patch, rail = on_rail(rail), reason));
                return Ok(());
            }
        };
        let steel = curving.steel()?;
        let refused = |error: riffel::Error| self.text.keys.refuse("contact.from.patch", &error);
        let radii = HertzContact::radii_of_ellipse(steel, loaded.semi_axes, contact.normal_force);
        let radii = radii.map_err(refused)?;
        let hertz = contact.hertz(curving)?;
        self.tell_of_patch(rail, contact, &loaded, hertz.as_ref());
        let sine = loaded.contact_angle.sin() - contact.contact_angle.sin();
        // φ = ∓ sin γ/r, upper sign on the right rail.
        contact.creepages.spin -= rail.sign() * sine / contact.rolling_radius;
        contact.contact_angle = loaded.contact_angle;
        [contact.longitudinal_radius, _] = radii;
        contact.transverse_radius = Some(radii[1]);
        contact.stiffness = Some(loaded.stiffness);
        if let Some(place) = &mut contact.place
            && let Some(outward) = curving.outward_on_rail(rail, loaded.on_track)?
        {
            place.outward = outward;
        }
        Ok(())
    }

    /// That the ellipse is wide beside the radius of the rail, with what the profiles under load have in its place.
    fn tell_of_conformal(&mut self, curving: &CurvingCase, rail: Rail, contact: &MeanContact) -> Result<(), CaseError> {
        /// Semi-axis over the radius of the rail, up to which patches count as flat.
        const FLAT: f64 = 0.2;
        let Some(place) = &contact.place else {
            return Ok(());
        };
        let Some(hertz) = contact.hertz(curving)? else {
            return Ok(());
        };
        let share = hertz.semi_axis_lateral() * place.rail_curvature;
        if share <= FLAT {
            return Ok(());
        }
        let loaded = match contact.elsewhere > 0.0 {
            true => None,
            false => curving
                .loaded_patch(
                    rail,
                    contact.lateral_shift,
                    contact.contact_angle,
                    contact.normal_force,
                    ContactSurface::Curved,
                )?
                .ok(),
        };
        let percent = loaded.map(|loaded| {
            [
                loaded.stiffness / hertz.stiffness(),
                loaded.semi_axes[0] / hertz.semi_axis_longitudinal(),
                loaded.semi_axes[1] / hertz.semi_axis_lateral(),
            ]
            .map(|ratio| 100.0 * (ratio - 1.0))
        });
        let under_load = match percent {
            Some([stiffer, longer, wider]) => Value::from(say!(
                patch_under_load_against_hertz,
                stiffer = signed(stiffer),
                longer = signed(longer),
                wider = signed(wider)
            )),
            None => Value::from(""),
        };
        self.remarks.push(say!(
            contact_is_conformal,
            semi_axis = fixed(1e3 * hertz.semi_axis_lateral(), 1),
            share = fixed(share, 2),
            rail = match rail {
                Rail::Left => say!(of_left),
                Rail::Right => say!(of_right),
            },
            under_load
        ));
        Ok(())
    }

    fn tell_of_patch(&mut self, rail: Rail, contact: &MeanContact, loaded: &LoadedPatch, hertz: Option<&HertzContact>) {
        let [a, b] = loaded.semi_axes.map(|axis| 1e3 * axis);
        let stiffness = 1e-6 * loaded.stiffness;
        let angle = loaded.contact_angle.to_degrees();
        let turned = (loaded.contact_angle - contact.contact_angle).to_degrees();
        let over_hertz = |value: f64, of_hertz: f64| signed(100.0 * (value / of_hertz - 1.0));
        let turned = number(format_args!("{turned:+.2}"));
        self.remarks.push(match hertz {
            Some(hertz) => say!(
                patch_of_profiles,
                rail = on_rail(rail),
                stiffness = fixed(stiffness, 0),
                stiffer = over_hertz(loaded.stiffness, hertz.stiffness()),
                along = fixed(a, 1),
                longer = over_hertz(loaded.semi_axes[0], hertz.semi_axis_longitudinal()),
                across = fixed(b, 1),
                wider = over_hertz(loaded.semi_axes[1], hertz.semi_axis_lateral()),
                angle = fixed(angle, 2),
                turned
            ),
            None => say!(
                patch_of_profiles_alone,
                rail = on_rail(rail),
                stiffness = fixed(stiffness, 0),
                along = fixed(a, 1),
                across = fixed(b, 1),
                angle = fixed(angle, 2),
                turned
            ),
        });
    }
}
