//! The keys of the loop on all axes, checked and complete.

mod wheelset;

use riffel::contact::{CREEP_LAWS, CreepLawEntry, Creepages, MeanState, ShiftEffects};
use riffel_keys::CaseError;
use riffel_keys::quantity::{Dimension, Quantity};

use crate::file::{Comb, Contact, CreepLawName, Creepage, OppositeContact, OppositeRail, TrackModel};
use crate::keys::checked_keys::CheckedKeys;
use crate::text::case_text::REPLACED_BY_WHEELSET;

pub(crate) use wheelset::{AxleKeys, RigidBodyKeys, WheelsetKeys, WheelsetModelKeys};

/// Wheels that are nearer to one another than this stand at one place \[m\].
const ONE_PLACE: f64 = 1e-3;

/// Most wheels of a train: the equations of a point grow with the third power of their number.
const MOST_WHEELS: usize = 400;

/// Creepage \[-\] and spin \[1/m\] below which a contact does not creep, as for the creepage that is a number.
const LEAST_CREEPAGE: f64 = 1e-9;

/// What the loop on all axes is built of besides the track, in SI. Defaults are filled in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GeneralKeys {
    /// The contact on the rail under study.
    pub(crate) contact: ContactKeys,
    /// Its mean state.
    pub(crate) mean: MeanState,
    /// The wheelset; `None` if the wheel is that of `[wheel]`, alone.
    pub(crate) wheelset: Option<WheelsetKeys>,
    /// The rail under study.
    pub(crate) rail: riffel::Rail,
    /// The contact on the opposite rail; `None` if that is absent.
    pub(crate) opposite: Option<OppositeKeys>,
    /// How the rail twists; `None` if it does not.
    pub(crate) twist: Option<TwistKeys>,
    /// Distances of the wheels behind the first one \[m\], its own zero first, as written.
    pub(crate) wheels: Vec<f64>,
    /// What is made of their interference.
    pub(crate) comb: Comb,
}

/// A contact without its creepage.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactKeys {
    /// R_r \[m\].
    pub(crate) longitudinal_radius: Option<f64>,
    pub(crate) transverse_radius: f64,
    /// P₀ \[N\].
    pub(crate) normal_load: f64,
    /// k_H \[N/m\]; none for that of the ellipse.
    pub(crate) stiffness: Option<f64>,
    /// μ \[-\].
    pub(crate) friction: f64,
    /// γ \[rad\].
    pub(crate) contact_angle: f64,
    /// e \[m\], to the right of the shear centre.
    pub(crate) lateral_offset: f64,
    /// How it moves across the profiles; `None` if it stays.
    pub(crate) conformity: Option<ConformityKeys>,
}

/// How a contact moves across the profiles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ConformityKeys {
    /// R_c \[m\].
    pub(crate) rail_radius: f64,
    /// κ \[1/m\], outward.
    pub(crate) cross_slope: f64,
    /// What of it enters the loop.
    pub(crate) effects: ShiftEffects,
}

/// The contact on the opposite rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct OppositeKeys {
    /// Profile Δ there in terms of that under study: 0, 1 or −1.
    pub(crate) profile: f64,
    /// The contact.
    pub(crate) contact: ContactKeys,
    /// Its creepages; `None` if they are the longitudinal creepage that the contact on the rail under study has at its
    /// tractive ratio.
    pub(crate) creepages: Option<Creepages>,
}

/// How the rail twists.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TwistKeys {
    /// J \[m⁴\].
    pub(crate) torsion_constant: f64,
    /// I_p \[m⁴\].
    pub(crate) polar_second_moment: f64,
    /// I_ω \[m⁶\].
    pub(crate) warping_constant: f64,
    /// c \[m\].
    pub(crate) centroid_height: f64,
    /// h \[m\].
    pub(crate) head_height: f64,
    /// Depth d \[m\] and width B \[m\] of the foot; none for a rail without supports.
    pub(crate) foot: Option<[f64; 2]>,
}

impl CheckedKeys {
    /// The first key that asks for the loop on all axes; none in a case of one wheel, one rail and one axis.
    pub(crate) fn general_key(&self) -> Option<&'static str> {
        let contact = &self.file.contact;
        let given = [
            ("wheelset", self.file.wheelset.is_some()),
            ("train", self.file.train.is_some()),
            ("contact.creepage", contact.creepage.is_some_and(|creepage| creepage.is_vector())),
            ("contact.contact_angle", contact.contact_angle.is_some()),
            ("contact.lateral_offset", contact.lateral_offset.is_some()),
            ("contact.conformity", contact.conformity.is_some()),
            // A section that could twist does not yet make a case one of twist.
            ("rail.torsion_constant", self.text.is_written("rail.torsion_constant")),
        ];
        given.into_iter().find_map(|(key, is)| is.then_some(key))
    }

    /// The keys of the loop on all axes; `None` if the case does not ask for it.
    ///
    /// # Errors
    /// [`CaseError`] for what is missing, and for keys that do not go together.
    pub(crate) fn general(&self) -> Result<Option<GeneralKeys>, CaseError> {
        let wheelset = self.file.wheelset.as_ref();
        let opposite = self.opposite()?;
        if self.general_key().is_none() {
            return Ok(None);
        }
        let (wheels, comb) = self.train()?;
        Ok(Some(GeneralKeys {
            contact: contact(&self.file.contact),
            mean: self.mean_state()?,
            wheelset: wheelset.map(|wheelset| self.wheelset_keys(wheelset)).transpose()?,
            rail: (wheelset.map(|wheelset| wheelset.rail).unwrap_or_default()).of_track(),
            opposite,
            twist: self.twist()?,
            wheels,
            comb,
        }))
    }

    /// `Ok` if the wheel is described once, by itself or by its wheelset.
    pub(crate) fn check_wheel(&self) -> Result<(), CaseError> {
        if self.file.wheelset.is_none() {
            return match self.file.wheel.mass {
                Some(_) => Ok(()),
                None => Err(self.text.keys.missing("wheel.mass", "")),
            };
        }
        let written = |key: &&&str| self.text.keys.has(key);
        REPLACED_BY_WHEELSET.iter().find(written).map_or(Ok(()), |key| {
            Err(self.text.keys.invalid(
                key,
                "and `wheelset` exclude each other",
                format!("leave {key} out: the wheel is part of the wheelset"),
            ))
        })
    }

    /// The contact on the opposite rail, if there is such a rail.
    fn opposite(&self) -> Result<Option<OppositeKeys>, CaseError> {
        let rail = self.file.wheelset.as_ref().map(|wheelset| wheelset.opposite_rail);
        let profile = match rail {
            None | Some(OppositeRail::Absent) => {
                if self.file.opposite_contact.is_none() {
                    return Ok(None);
                }
                let without = match rail {
                    None => "there is no [wheelset]",
                    Some(_) => "wheelset.opposite_rail is \"absent\"",
                };
                return Err(self.text.keys.invalid(
                    "opposite_contact",
                    format!("is given, but {without}"),
                    "choose wheelset.opposite_rail = \"smooth\", \"in-phase\" or \"antiphase\"",
                ));
            }
            Some(OppositeRail::Smooth) => 0.0,
            Some(OppositeRail::InPhase) => 1.0,
            Some(OppositeRail::Antiphase) => -1.0,
        };
        let here = contact(&self.file.contact);
        let written = self.file.opposite_contact.clone().unwrap_or_default();
        let OppositeContact {
            transverse_radius,
            longitudinal_radius,
            normal_load,
            stiffness,
            friction,
            creepage,
            contact_angle,
            lateral_offset,
            rail_radius,
        } = written;
        let of_its_own = transverse_radius.is_some() || longitudinal_radius.is_some() || normal_load.is_some();
        let creepages = match (creepage, self.mean_state()?) {
            (Some(creepage), _) => Some(self.creeping("opposite_contact.creepage", creepage)?),
            (None, MeanState::Creepages(creepages)) => Some(Creepages { spin: -creepages.spin, ..creepages }),
            (None, MeanState::TractiveRatio(_)) => None,
        };
        Ok(Some(OppositeKeys {
            profile,
            contact: ContactKeys {
                longitudinal_radius: longitudinal_radius.map(|radius| radius.si()).or(here.longitudinal_radius),
                transverse_radius: or(transverse_radius, here.transverse_radius),
                normal_load: or(normal_load, here.normal_load),
                stiffness: match stiffness {
                    // Another ellipse has another stiffness.
                    None if of_its_own => None,
                    None => here.stiffness,
                    Some(stiffness) => Some(stiffness.si()),
                },
                friction: or(friction, here.friction),
                contact_angle: or(contact_angle, here.contact_angle),
                lateral_offset: or(lateral_offset, -here.lateral_offset),
                conformity: here.conformity.map(|conformity| ConformityKeys {
                    rail_radius: or(rail_radius, conformity.rail_radius),
                    ..conformity
                }),
            },
            creepages,
        }))
    }

    /// Creepages that do not vanish and that the creep law knows.
    pub(crate) fn creeping(&self, key: &str, creepage: Creepage) -> Result<Creepages, CaseError> {
        let creepages = creepage.components();
        let Creepages { longitudinal, lateral, spin } = creepages;
        let largest = longitudinal.abs().max(lateral.abs()).max(spin.abs());
        if creepage.is_vector() && largest < LEAST_CREEPAGE {
            return Err(self.text.keys.invalid(
                key,
                format!(
                    "is longitudinal {longitudinal}, lateral {lateral} and spin {spin} rad/m, but one of them must be \
                     at least {LEAST_CREEPAGE:e}: a wheel that does not creep does not wear the rail"
                ),
                "",
            ));
        }
        let Some(law) = self.creep_law_name().entry() else {
            // The exact theory knows all.
            return Ok(creepages);
        };
        let unknown = |component: &str, value: String, knows: fn(&CreepLawEntry) -> bool| {
            let others = CREEP_LAWS.iter().filter(|law| knows(law));
            let others = others.map(|law| law.name);
            let others: Vec<&str> = others.chain([CreepLawName::HALF_SPACE.name()]).collect();
            self.text.keys.invalid(
                &format!("{key}.{component}"),
                format!("is {value}, but contact.creep_law = \"{}\" does not know it", law.name),
                format!("laws that do: {}", others.join(", ")),
            )
        };
        if lateral != 0.0 && !law.lateral {
            return Err(unknown("lateral", lateral.to_string(), |law| law.lateral));
        }
        if spin != 0.0 && !law.spin {
            return Err(unknown("spin", format!("{spin} rad/m"), |law| law.spin));
        }
        Ok(creepages)
    }

    /// Places of the wheels, and what is made of their interference.
    fn train(&self) -> Result<(Vec<f64>, Comb), CaseError> {
        let train = self.file.train.clone().unwrap_or_default();
        let key = "train.wheels";
        if train.wheels.is_empty() || train.wheels.len() > MOST_WHEELS {
            let rule = format!("one to {MOST_WHEELS} distances");
            return Err(self.out_of_range(key, format!("a list of {}", train.wheels.len()), &rule));
        }
        let wheels: Vec<f64> = train.wheels.iter().map(Quantity::si).collect();
        if wheels[0] != 0.0 {
            let rule = "0 m, for distances are those behind the first wheel";
            return Err(self.out_of_range(&format!("{key}[0]"), train.wheels[0], rule));
        }
        for (index, wheel) in wheels.iter().enumerate() {
            let at_one_place = |other: &f64| (wheel - other).abs() < ONE_PLACE;
            if let Some(other) = wheels[..index].iter().position(at_one_place) {
                return Err(self.text.keys.invalid(
                    &format!("{key}[{index}]"),
                    format!(
                        "is {}, where wheel {} stands: two wheels must not be at one place",
                        train.wheels[index],
                        other + 1
                    ),
                    "",
                ));
            }
        }
        Ok((wheels, train.comb))
    }

    /// How the rail twists, if it does.
    fn twist(&self) -> Result<Option<TwistKeys>, CaseError> {
        let rail = &self.file.rail;
        let Some(torsion_constant) = rail.torsion_constant else {
            return Ok(None);
        };
        let polar_second_moment = self.of_twist("rail.polar_second_moment", rail.polar_second_moment)?;
        let head_height = self.of_twist("rail.head_height", rail.head_height)?;
        let foot = match self.file.track.model {
            TrackModel::FreeBeam | TrackModel::MovingBeam | TrackModel::Measured => None,
            _ => Some([
                self.of_twist("rail.foot_depth", rail.foot_depth)?,
                self.of_twist("rail.foot_width", rail.foot_width)?,
            ]),
        };
        Ok(Some(TwistKeys {
            torsion_constant: torsion_constant.si(),
            polar_second_moment,
            warping_constant: or(rail.warping_constant, 0.0),
            centroid_height: or(rail.centroid_height, 0.0),
            head_height,
            foot,
        }))
    }

    /// A value that a rail needs to twist.
    fn of_twist<D: Dimension>(&self, key: &str, value: Option<Quantity<D>>) -> Result<f64, CaseError> {
        let help = "a rail with torsion_constant needs it: give it, or leave rail.torsion_constant out";
        let value = value.ok_or_else(|| self.text.keys.missing(key, help))?;
        Ok(value.si())
    }
}

fn or<D: Dimension>(written: Option<Quantity<D>>, otherwise: f64) -> f64 {
    written.map_or(otherwise, |quantity| quantity.si())
}

/// The contact on the rail under study, without its creepage.
pub(crate) fn contact(contact: &Contact) -> ContactKeys {
    ContactKeys {
        longitudinal_radius: contact.longitudinal_radius.map(|radius| radius.si()),
        transverse_radius: contact.transverse_radius.si(),
        normal_load: contact.normal_load.si(),
        stiffness: contact.stiffness.map(|stiffness| stiffness.si()),
        friction: contact.friction.si(),
        contact_angle: or(contact.contact_angle, 0.0),
        lateral_offset: or(contact.lateral_offset, 0.0),
        conformity: contact.conformity.map(|conformity| ConformityKeys {
            rail_radius: conformity.rail_radius.si(),
            cross_slope: or(conformity.cross_slope, 0.0),
            effects: ShiftEffects {
                rolling_radius: conformity.rolling_radius,
                contact_angle: conformity.contact_angle,
                spin: conformity.spin,
                rail_roll: conformity.rail_roll,
            },
        }),
    }
}

#[cfg(test)]
mod tests;
