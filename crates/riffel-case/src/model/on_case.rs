//! A model of the field on a case: which keys it replaces, and what the case lacks for it.

use std::f64::consts::PI;

use rayon::prelude::*;
use riffel::Loop;
use riffel::contact::{ContactFilter, LoadWear};
use riffel::feedback::Contact;
use riffel::forecast::{MeanGrowth, SpeedDistribution};
use riffel::growth::Bay;
use riffel::receptance::RigidGround;
use riffel::wheelset::{Motion, SprungMass};
use riffel_curving::GRAVITY;
use riffel_keys::{CaseError, say};
use toml::{Table, Value};

use super::joints::{ContactJoint, CreepageJoint, Joints, PlaceOfWearJoint, TrackJoint, WearJoint, WheelJoint};
use crate::Case;
use crate::file::CreepLawName;
use crate::file::{Rotation, Support, TrackModel, Wheelset, WheelsetModel};
use crate::keys::substitutes::{SubstituteReceptance, Substitutes};
use crate::parts::window::Window;
use crate::text::case_text::{CaseText, REPLACED_BY_WHEELSET};

/// The creep law of a contact beyond saturation.
const FULL_SLIDING: &str = "full-sliding";

/// Tractive ratio that stands for a contact near saturation.
const NEAR_SATURATION: f64 = 0.95;

/// A case as a model of the field reads it.
#[derive(Clone)]
pub struct ModelOnCase {
    /// The case with the joints of the model.
    pub case: Case,
    filter: Option<ContactFilter>,
    /// Whether growth is the mean over the bay.
    mean: bool,
}

/// Why a model cannot be built on a case, as the end of a sentence: "needs a wheelset with an elastic axle".
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NotOnCase(pub String);

impl NotOnCase {
    fn needs(what: &str) -> Self {
        Self(format!("needs {what}"))
    }
}

impl From<CaseError> for NotOnCase {
    fn from(error: CaseError) -> Self {
        Self(error.to_string())
    }
}

impl ModelOnCase {
    /// The case with what stands at the joints.
    ///
    /// # Errors
    /// [`NotOnCase`] with the keys that the case lacks, or with what is wrong with a value under these joints.
    pub fn new(case: &Case, joints: Joints) -> Result<Self, NotOnCase> {
        let mut keys = ModelKeys { case, text: case.unfilled.clone(), given: case.keys.given.clone() };
        keys.track(joints.track)?;
        keys.wheel(joints.wheel)?;
        if joints.creepage == CreepageJoint::AcrossTheRail {
            keys.moves_across()?;
        }
        keys.creepage(joints.creepage)?;
        keys.contact(joints.contact)?;
        // No author has these laws beside wear.
        keys.remove(&["damage"]);
        if !joints.conformity {
            keys.remove(&["contact.conformity"]);
        }
        keys.set("contact.wave_geometry", joints.wave_geometry)?;
        if !joints.wave_geometry {
            keys.remove(&["wheel.normal_direction", "wheelset.normal_direction"]);
        }
        match joints.place_of_wear {
            PlaceOfWearJoint::Own => {}
            PlaceOfWearJoint::Lag => keys.set("contact.dissipation_phase", "lag")?,
            PlaceOfWearJoint::WheelCentre => keys.set("contact.dissipation_phase", "none")?,
        }
        let ModelKeys { text, given, .. } = keys;
        let folder = case.keys.folder.as_deref();
        let mut built = Case::of_text(text, folder, given, Window::Map)?;
        if case.file.damage.is_some() {
            built.remarks.push(say!(models_leave_damage_out));
        }
        let even = joints.wheel == WheelJoint::EvenlyTurningWheelset;
        built.feedback = adjusted(built.feedback, even, joints.wear == WearJoint::NormalForce)
            .map_err(|error| NotOnCase(error.to_string()))?;
        Ok(Self {
            filter: joints.contact_filter.then(|| ContactFilter::of(&built.hertz)),
            mean: joints.track == TrackJoint::DiscreteMean,
            case: built,
        })
    }

    /// Whether its growth is filtered by the contact, beside what the response of the case does.
    pub fn has_filter(&self) -> bool {
        self.filter.is_some()
    }

    /// Growth rates per passage at wavelengths \[m\] and one speed \[m/s\].
    pub fn growth_rates(&self, wavelengths: &[f64], speed: f64) -> Vec<f64> {
        let rate = self.growth_rate(speed);
        wavelengths.par_iter().map(|&wavelength| rate(wavelength)).collect()
    }

    /// The growth rate per passage over the wavelength \[m\] at one speed \[m/s\].
    pub fn growth_rate(&self, speed: f64) -> impl Fn(f64) -> f64 + Sync + '_ {
        let places = self.places();
        move |wavelength| {
            let rates = places.iter().map(|(feedback, weight)| weight * feedback.at(wavelength, speed).growth_rate);
            self.filtered(wavelength) * rates.sum::<f64>()
        }
    }

    /// Growth rates at wavelengths \[m\], in the mean over the speeds of a traffic.
    pub fn mean_growth_rates(&self, wavelengths: &[f64], speeds: &SpeedDistribution) -> Vec<f64> {
        let mean = MeanGrowth::compute(&self.places(), wavelengths, speeds);
        let rates = wavelengths.iter().zip(mean.rates);
        rates.map(|(&wavelength, rate)| self.filtered(wavelength) * rate).collect()
    }

    fn places(&self) -> Vec<(Loop, f64)> {
        match self.mean {
            true => self.case.places(),
            false => vec![(self.case.feedback.clone(), 1.0)],
        }
    }

    /// What the filter of the contact leaves of growth at a wavelength.
    fn filtered(&self, wavelength: f64) -> f64 {
        let filter = self.filter.iter();
        filter.map(|filter| filter.amplitude(2.0 * PI / wavelength, 0.0)).product()
    }

    /// The loop over a support and in mid-span; `None` if supports are not discrete.
    pub fn over_support_and_mid_span(&self) -> Option<[Loop; 2]> {
        let structure = self.case.track.structure.clone()?;
        let bay = Bay::new(&self.case.feedback, structure)?;
        Some([bay.at(0.0), bay.at(0.5 * bay.spacing())])
    }
}

/// The loop with what no key says: creepage along the rail held, and wear by the normal force.
fn adjusted(feedback: Loop, even: bool, by_force: bool) -> Result<Loop, riffel::Error> {
    let contacts = feedback.contacts().iter().cloned().map(|contact| {
        let [along, across] = contact.motion;
        Contact {
            motion: [if even { Motion::Held } else { along }, across],
            rolling: match by_force {
                true => std::sync::Arc::new(LoadWear::new(contact.rolling)),
                false => contact.rolling,
            },
            ..contact
        }
    });
    let contacts = contacts.collect();
    feedback.with_contacts(contacts)
}

/// The keys of a case on their way to those of a model.
struct ModelKeys<'a> {
    case: &'a Case,
    text: CaseText,
    given: Substitutes,
}

impl ModelKeys<'_> {
    fn set(&mut self, key: &str, value: impl Into<Value>) -> Result<(), CaseError> {
        self.text.write(&[(key.to_owned(), value.into())])
    }

    fn remove(&mut self, keys: &[&str]) {
        for key in keys {
            self.text.keys.remove(key);
        }
    }

    fn track(&mut self, joint: TrackJoint) -> Result<(), NotOnCase> {
        match joint {
            TrackJoint::Own => {}
            TrackJoint::FreeBeam => {
                self.given.track = None;
                self.set("track.model", "free-beam")?;
                self.set("rail.beam", "euler-bernoulli")?;
                self.remove(&["rail.loss_factor", "rail.torsion_constant", "track.position"]);
            }
            TrackJoint::Continuous => {
                let spread = matches!(self.case.file.track.model, TrackModel::OneLayer | TrackModel::TwoLayer);
                if !spread || self.given.track.is_some() {
                    self.supports("one-layer", "two-layer")?;
                }
                self.remove(&["track.position"]);
            }
            TrackJoint::Discrete | TrackJoint::DiscreteMean => {
                if !self.case.file.track.model.is_periodic() || self.given.track.is_some() {
                    self.supports("one-layer-periodic", "two-layer-periodic")?;
                }
            }
            TrackJoint::Rigid => {
                let ground = SubstituteReceptance::new(std::sync::Arc::new(RigidGround));
                self.given.track = Some(ground);
            }
        }
        Ok(())
    }

    /// Choose a model with the supports of the case: of one layer where it has no ballast.
    fn supports(&mut self, one_layer: &str, two_layers: &str) -> Result<(), NotOnCase> {
        let track = &self.case.file.track;
        let mut lacks = Vec::new();
        if track.support_spacing.is_none() {
            lacks.push("track.support_spacing");
        }
        if track.pad.as_ref().is_none_or(|pad| pad.stiffness.is_none()) {
            lacks.push("track.pad");
        }
        if !lacks.is_empty() {
            return Err(NotOnCase::needs(&format!("supports of the rail: {} or a track.preset", lacks.join(", "))));
        }
        let ballast = track.ballast.as_ref();
        let model = match ballast.is_some_and(|ballast| ballast.stiffness.is_some()) {
            true => two_layers,
            false => one_layer,
        };
        self.given.track = None;
        Ok(self.set("track.model", model)?)
    }

    fn wheel(&mut self, joint: WheelJoint) -> Result<(), NotOnCase> {
        match joint {
            WheelJoint::Own => {}
            WheelJoint::Alone(rotation) => {
                self.alone()?;
                let rotation = match rotation {
                    Rotation::Inertia => "inertia",
                    Rotation::ConstantCreepage => "constant-creepage",
                    Rotation::ConstantTangentialForce => "constant-tangential-force",
                };
                self.set("wheel.rotation", rotation)?;
            }
            WheelJoint::Wheelset | WheelJoint::EvenlyTurningWheelset => {
                if self.case.file.wheelset.is_none() {
                    self.pair()?;
                }
            }
            WheelJoint::ElasticWheelset => self.elastic()?,
            WheelJoint::ElasticWheelsetOnBothRails => {
                self.elastic()?;
                if !self.text.keys.has("wheelset.opposite_rail") {
                    self.set("wheelset.opposite_rail", "smooth")?;
                }
            }
            WheelJoint::Sprung => {
                let suspension = self.case.file.wheelset.as_ref();
                let suspension = suspension.and_then(|wheelset| wheelset.suspension.as_ref());
                let Some(suspension) = suspension.filter(|suspension| suspension.vertical_stiffness.si() > 0.0) else {
                    return Err(NotOnCase::needs("wheelset.suspension with a vertical_stiffness"));
                };
                let (stiffness, damping) = (suspension.vertical_stiffness.si(), suspension.vertical_damping.si());
                let [mass, _] = self.alone()?;
                let load = self.case.file.contact.normal_load.si();
                let sprung = SprungMass::new(load / GRAVITY - mass, stiffness, damping)
                    .map_err(|error| NotOnCase(error.to_string()))?;
                let sprung = SubstituteReceptance::new(std::sync::Arc::new(sprung));
                self.given.wheel = Some(sprung);
                self.set("wheel.rotation", "constant-creepage")?;
            }
        }
        Ok(())
    }

    /// One wheel in the place of wheelsets and trains: its mass and inertia.
    fn alone(&mut self) -> Result<[f64; 2], NotOnCase> {
        let wheel = &self.case.file.wheel;
        let found = match &self.case.file.wheelset {
            None => wheel.mass.zip(wheel.inertia).map(|(mass, inertia)| [mass.si(), inertia.si()]),
            Some(wheelset) => wheelset.half(),
        };
        let Some([mass, inertia]) = found else {
            return Err(NotOnCase::needs("the mass of the wheelset, which its receptances do not tell"));
        };
        self.remove(&[
            "wheelset",
            "opposite_contact",
            "train",
            "contact.contact_angle",
            "contact.longitudinal_radius",
            "contact.lateral_offset",
            "contact.conformity",
            "rail.torsion_constant",
        ]);
        if self.case.file.wheelset.is_some() {
            self.set("wheel.mass", mass)?;
            self.set("wheel.inertia", inertia)?;
            // The wheelset may have brought its own.
            let radius = wheel.rolling_radius.si();
            self.set("wheel.rolling_radius", radius)?;
        }
        Ok([mass, inertia])
    }

    /// Two wheels of the case on a rigid axle without mass: downward each moves as it did alone.
    fn pair(&mut self) -> Result<(), NotOnCase> {
        let wheel = &self.case.file.wheel;
        let (Some(mass), Some(inertia)) = (wheel.mass, wheel.inertia) else {
            return Err(NotOnCase::needs("wheel.mass"));
        };
        if self.given.wheel.is_some() {
            return Err(NotOnCase::needs("a wheelset: the receptance given for the wheel is vertical only"));
        }
        let half_spacing = 0.5 * Wheelset::default_contact_spacing().si();
        let mass = 2.0 * mass.si();
        self.remove(&REPLACED_BY_WHEELSET);
        self.set("wheelset.model", "rigid")?;
        self.set("wheelset.mass", mass)?;
        let roll = mass * half_spacing * half_spacing;
        self.set("wheelset.roll_inertia", roll)?;
        Ok(self.set("wheelset.spin_inertia", 2.0 * inertia.si())?)
    }

    fn elastic(&self) -> Result<(), NotOnCase> {
        match self.case.file.wheelset.as_ref().map(|wheelset| wheelset.model) {
            None | Some(WheelsetModel::Rigid) => Err(NotOnCase::needs(
                "a wheelset with an elastic axle: wheelset.model = \"flexible\", \"modal\" or \"measured\"",
            )),
            Some(_) => Ok(()),
        }
    }

    /// `Ok` if the rail of the case moves across the track where it lies on supports.
    fn moves_across(&self) -> Result<(), NotOnCase> {
        let (rail, track) = (&self.case.file.rail, &self.case.file.track);
        let moves = |support: &Option<Support>| {
            let support = support.as_ref();
            support.is_none_or(|support| support.lateral_stiffness.is_some())
        };
        let known = [
            ("rail.lateral_second_moment", rail.lateral_second_moment.is_some()),
            ("track.pad.lateral_stiffness", moves(&track.pad)),
            ("track.ballast.lateral_stiffness", moves(&track.ballast)),
        ];
        let lacks: Vec<&str> = known.iter().filter_map(|&(key, known)| (!known).then_some(key)).collect();
        match lacks.is_empty() {
            true => Ok(()),
            false => Err(NotOnCase::needs(&format!("a rail that moves across the track: {}", lacks.join(", ")))),
        }
    }

    fn creepage(&mut self, joint: CreepageJoint) -> Result<(), CaseError> {
        let steady = self.case.steady.creepages;
        let size = steady.magnitude();
        let vector = self.case.file.contact.creepage;
        match joint {
            CreepageJoint::Own => Ok(()),
            CreepageJoint::AlongTheRail => {
                if vector.is_some_and(|creepage| creepage.is_vector()) {
                    self.set("contact.creepage", size)?;
                }
                Ok(())
            }
            CreepageJoint::AcrossTheRail => {
                self.remove(&["opposite_contact.creepage"]);
                let lateral = size.copysign(if steady.lateral == 0.0 { 1.0 } else { steady.lateral });
                let lateral = Table::from_iter([("lateral".to_owned(), Value::Float(lateral))]);
                self.set("contact.creepage", lateral)
            }
            CreepageJoint::NearSaturation => {
                self.remove(&["opposite_contact.creepage"]);
                self.set("contact.tractive_ratio", NEAR_SATURATION)
            }
        }
    }

    fn contact(&mut self, joint: ContactJoint) -> Result<(), CaseError> {
        match joint {
            // Beyond saturation the exact theory is full sliding, too.
            ContactJoint::Exact if self.case.creep_law().name() == FULL_SLIDING => {
                self.set("contact.response", "quasi-static")
            }
            ContactJoint::Exact => {
                self.remove(&["contact.hertz"]);
                self.set("contact.creep_law", "half-space")?;
                self.set("contact.response", "non-steady")
            }
            ContactJoint::QuasiStatic => {
                let law: CreepLawName = self.case.creep_law();
                self.set("contact.creep_law", law.name())?;
                self.set("contact.response", "quasi-static")
            }
            ContactJoint::Carter | ContactJoint::SpringDashpot => {
                for table in ["contact", "opposite_contact"] {
                    self.remove(&[&format!("{table}.creepage.spin")]);
                }
                self.set("contact.creep_law", "carter-3d")?;
                self.set("contact.hertz", "paper")?;
                let response = match joint {
                    ContactJoint::SpringDashpot => "spring-dashpot",
                    _ => "quasi-static",
                };
                self.set("contact.response", response)
            }
        }
    }
}
