//! What holds the wheelsets, from its keys.

use riffel_curving::{Axle, Body, BogieFrame, FollowingFrame, RunningGear};
use riffel_keys::{CaseError, Message, say};

use super::CurvingCase;
use crate::file;

impl CurvingCase {
    /// The wheelsets of the case with what each carries.
    pub(super) fn axle(&self, bogie: &file::Bogie, contact_spacing: f64) -> Result<Axle, CaseError> {
        Ok(Axle {
            primary_spacing: bogie.primary_spacing.si(),
            primary_longitudinal_stiffness: bogie.primary_longitudinal_stiffness.si(),
            primary_lateral_stiffness: bogie.primary_lateral_stiffness.si(),
            mass_per_axle: bogie.mass_per_axle.si(),
            wheelset_mass: self.required("wheelset.mass", self.file.wheelset.mass)?,
            rolling_radii: self.rolling_radii(),
            contact_spacing,
            centre_of_mass_height: bogie.centre_of_mass_height.si(),
        })
    }

    /// A lone wheelset, a bogie, or two under a body.
    pub(super) fn running_gear(&self, bogie: &file::Bogie) -> Result<RunningGear, CaseError> {
        let keys = &self.text.keys;
        let foreign = |key: &str, belongs: &str| {
            let rule = say!(is_set_but_belongs_to, belongs);
            Err(keys.invalid(key, &rule, say!(leave_it_out)))
        };
        if bogie.wheelsets == 1 {
            let of_two = "bogie.wheelsets = 2";
            if bogie.wheelbase.is_some() {
                return foreign("bogie.wheelbase", of_two);
            }
            if bogie.frame_yaw_moment.is_some() {
                return foreign("bogie.frame_yaw_moment", of_two);
            }
            if self.file.body.is_some() {
                let rule = "is set, but a body lies on two bogies of two wheelsets each";
                let help = "leave [body] out, or bogie.wheelsets = 1";
                return Err(keys.invalid("body", rule, help));
            }
            return Ok(RunningGear::Wheelset(FollowingFrame {
                yaw: bogie.frame_yaw.map_or(0.0, |yaw| yaw.si()),
                held_at: bogie.frame_lateral_shift.map(|shift| shift.si()),
            }));
        }
        if bogie.wheelsets != 2 {
            let rule = format!("is {}, but must be 1 or 2", bogie.wheelsets);
            let help = "a vehicle of four wheelsets has a [body] on two bogies";
            return Err(keys.invalid("bogie.wheelsets", &rule, help));
        }
        let of_one = "bogie.wheelsets = 1, a lone wheelset";
        if bogie.frame_yaw.is_some() {
            return foreign("bogie.frame_yaw", of_one);
        }
        if bogie.frame_lateral_shift.is_some() {
            return foreign("bogie.frame_lateral_shift", of_one);
        }
        let help = "two wheelsets need it; a lone one has bogie.wheelsets = 1";
        let wheelbase = bogie.wheelbase.ok_or_else(|| keys.missing("bogie.wheelbase", help))?;
        let frame = BogieFrame {
            wheelbase: wheelbase.si(),
            yaw_moment: bogie.frame_yaw_moment.map_or(0.0, |moment| moment.si()),
        };
        let Some(body) = &self.file.body else {
            return Ok(RunningGear::Bogie(frame));
        };
        if body.bogie_spacing.si() <= frame.wheelbase {
            let rule = format!("is {}, but must be larger than the wheelbase of {wheelbase}", body.bogie_spacing);
            return Err(keys.invalid("body.bogie_spacing", &rule, ""));
        }
        Ok(RunningGear::Vehicle {
            bogies: frame,
            body: Body {
                bogie_spacing: body.bogie_spacing.si(),
                mass: body.mass.si(),
                secondary_lateral_stiffness: body.secondary_lateral_stiffness.si(),
                secondary_yaw_stiffness: body.secondary_yaw_stiffness.si(),
            },
        })
    }

    /// Torques of the wheelsets \[N m\].
    pub(super) fn drive_torque(&self, bogie: &file::Bogie, wheelsets: usize) -> Result<Vec<f64>, CaseError> {
        let torques = &bogie.drive_torque;
        if torques.is_empty() {
            return Ok(vec![0.0; wheelsets]);
        }
        if torques.len() != wheelsets {
            let (given, plural) = (torques.len(), if wheelsets == 1 { "" } else { "s" });
            let rule = format!("has {given} torques, but there are {wheelsets} wheelset{plural}");
            let help = "give one for each wheelset, the leading one first";
            return Err(self.text.keys.invalid("bogie.drive_torque", &rule, help));
        }
        Ok(torques.iter().map(|torque| torque.si()).collect())
    }

    /// The distance \[m\] that a curve's radius must be above, in words and as a number.
    pub fn shortest_radius(&self) -> (Message, f64) {
        let spacing = self.file.wheelset.contact_spacing;
        let wheelbase = self.file.bogie.as_ref().and_then(|bogie| bogie.wheelbase);
        match (&self.file.body, wheelbase) {
            (Some(body), _) => (say!(distance_of_the_bogies), body.bogie_spacing.si()),
            (None, Some(wheelbase)) => (say!(wheelbase_of_the_bogie), wheelbase.si()),
            (None, None) => (say!(distance_of_the_contacts), spacing.map_or(1.5, |spacing| spacing.si())),
        }
    }
}
