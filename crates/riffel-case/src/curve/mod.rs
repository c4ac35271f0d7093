//! Cases of curving: a file of which only the tables of curve, bogie, body, profiles, wheels and contacts are read.

mod build;
mod equilibrium;
mod keys;
mod running_gear;
mod wheelset;

pub(crate) use equilibrium::Equilibrium;
pub(crate) use wheelset::SharedProfiles;

use std::path::{Path, PathBuf};

use riffel_curving::profile::NominalProfile;
use riffel_curving::{VehicleInCurve, VehicleState};
use riffel_keys::quantity::{Mass, Quantity};
use riffel_keys::{CaseError, Message, say, text_file};
use serde::Deserialize;

use self::build::is_cone;
use crate::file::{CreepLawName, CurvingFile, CurvingLaw, Wheelset};
use crate::text::case_text::CaseText;

/// What a loop of growth knows of the mass of a wheelset.
#[derive(Deserialize)]
struct MassOfLoop {
    wheelset: Option<Wheelset>,
    wheel: Option<MassOfWheel>,
}

#[derive(Deserialize)]
struct MassOfWheel {
    mass: Option<Quantity<Mass>>,
}

impl MassOfLoop {
    /// That of axle and discs, or of two wheels \[kg\].
    fn of_a_wheelset(self) -> Option<f64> {
        let [mass, _] = match self.wheelset {
            Some(wheelset) => wheelset.half()?,
            None => [self.wheel?.mass?.si(), 0.0],
        };
        Some(2.0 * mass)
    }
}

/// A case of curving, its keys checked. What is built of them is built where it is asked for: a wheelset on its track
/// needs no bogie.
#[derive(Clone)]
pub struct CurvingCase {
    pub(super) text: CaseText,
    /// Folder to which file names are relative.
    pub(super) folder: PathBuf,
    /// The keys with their values.
    pub file: CurvingFile,
    /// What is to be asked about values that are not usual.
    pub remarks: Vec<Message>,
    /// What it shares with other cases.
    pub(crate) shared: SharedProfiles,
}

impl CurvingCase {
    /// Read a case file, or standard input for the path `-`, and apply overrides `key=value` in their order.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let text = text_file::read_keys(path, "case file")?;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        Self::build(&path.display().to_string(), folder, &text, overrides)
    }

    /// Read a case from TOML; `name` is the one shown in errors. Files that the case names are relative to the present
    /// folder.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, CaseError> {
        Self::build(name, Path::new(""), text, overrides)
    }

    /// The tables of curving of a text; without a folder its profiles may be no files.
    pub(crate) fn of_tables(text: CaseText, folder: Option<&Path>) -> Result<Self, CaseError> {
        let case = Self::of_text(text, folder.unwrap_or(Path::new("")))?;
        match (folder, case.key_of_a_profile_file()) {
            (None, Some(key)) => Err(case.text.names_a_file(key)),
            _ => Ok(case),
        }
    }

    /// The first key that names the file of a profile.
    fn key_of_a_profile_file(&self) -> Option<&'static str> {
        let profiles = self.file.profiles.as_ref()?;
        let file = |(_, name): &(_, &str)| NominalProfile::named(name).is_none();
        profiles.names().into_iter().find(file).map(|(key, _)| key)
    }

    fn build(name: &str, folder: &Path, text: &str, overrides: &[String]) -> Result<Self, CaseError> {
        let mut text = CaseText::parse(name, text)?;
        text.apply(overrides)?;
        Self::of_text(text, folder)
    }

    pub(crate) fn of_text(mut text: CaseText, folder: &Path) -> Result<Self, CaseError> {
        const KEY: &str = "contact.creep_law";
        text.fill_in()?;
        keys::refuse_unknown(&text.keys)?;
        // The law of the loop, in a file that is of both.
        let mut of_loop = None;
        if text.keys.has("track")
            && let Some(law) = text.keys.text_of(KEY)
            && CreepLawName::named(law).is_some()
            && CurvingLaw::named(law).is_none()
        {
            of_loop = Some(say!(creep_law_of_growth_only, law));
            text.keys.remove(KEY);
        }
        let mut file: CurvingFile = text.keys.deserialize()?;
        if file.wheelset.mass.is_none() {
            // Of what the keys of a loop say of it, if anything.
            let of_loop: Option<MassOfLoop> = text.keys.deserialize().ok();
            let mass = of_loop.and_then(|of_loop| of_loop.of_a_wheelset());
            file.wheelset.mass = mass.map(Quantity::new);
        }
        let mut remarks = keys::judge(&text.keys)?;
        remarks.extend(of_loop);
        Ok(Self { text, folder: folder.to_owned(), file, remarks, shared: SharedProfiles::default() })
    }

    /// The case with more overrides `key=value`.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub(crate) fn with(&self, overrides: &[String]) -> Result<Self, CaseError> {
        let mut text = self.text.clone();
        text.apply(overrides)?;
        Self::of_text(text, &self.folder)
    }

    /// The case as a file, with its overrides and presets.
    pub fn toml(&self) -> String {
        self.text.keys.table().to_string()
    }

    /// The vehicle of the case in its curve, or its bogie or wheelset.
    ///
    /// # Errors
    /// [`CaseError`] for a key that is missing or has a value that is not allowed, and for profiles that do not touch.
    pub fn vehicle_in_curve(&self) -> Result<VehicleInCurve, CaseError> {
        self.build_vehicle()
    }

    /// The first of radii \[m\] in which the vehicle of the case does not fit, or that is no number, with the rule.
    pub fn radius_that_no_curve_has(&self, radii: &[f64]) -> Option<(f64, String)> {
        const WIDEST: f64 = 1e7;
        let (what, shortest) = self.shortest_radius();
        let fits = |radius: &f64| radius.abs() > shortest && radius.abs() <= WIDEST;
        let radius = radii.iter().copied().find(|radius| !fits(radius))?;
        let rule = say!(larger_than_the_to_either_side, what);
        Some((radius, rule.to_string()))
    }

    /// The equilibrium of a vehicle of this case to which straight track leads.
    ///
    /// # Errors
    /// [`CaseError`] where none is found.
    pub(crate) fn equilibrium(&self, vehicle: &VehicleInCurve) -> Result<VehicleState, CaseError> {
        vehicle.equilibrium().map_err(|error| self.no_equilibrium(error))
    }

    /// Every equilibrium found of a vehicle of this case, first that to which straight track leads.
    ///
    /// # Errors
    /// [`CaseError`] where none is found.
    pub fn equilibria(&self, vehicle: &VehicleInCurve) -> Result<Vec<VehicleState>, CaseError> {
        vehicle.equilibria().map_err(|error| self.no_equilibrium(error))
    }

    fn no_equilibrium(&self, error: riffel::Error) -> CaseError {
        let profiles = self.file.profiles.as_ref();
        let endless = profiles.is_some_and(|profiles| is_cone(profiles) && profiles.flange.is_none());
        match error {
            riffel::Error::OffTheRails { .. } if endless => {
                let help = "cones without profiles.flange have no end; give a flange, or take a wider curve";
                self.text.keys.invalid("profiles.wheel", &error, help)
            }
            riffel::Error::OffTheRails { .. } => {
                let help = "take a wider curve, less moment or softer springs";
                self.text.keys.invalid("curve.radius", &error, help)
            }
            riffel::Error::TorqueBeyondFriction { .. } => {
                let help = "take less torque or more friction";
                self.text.keys.invalid("bogie.drive_torque", &error, help)
            }
            error @ riffel::Error::NoEquilibrium { .. } => {
                let invalid = self.text.keys.invalid("curve", &error, "");
                CaseError::NotConverged(Box::new(invalid))
            }
            error => self.physics("curve", error),
        }
    }

    pub(super) fn physics(&self, key: &str, error: riffel::Error) -> CaseError {
        let invalid = self.text.keys.invalid(key, &error, "");
        match error {
            riffel::Error::NotConverged { .. } => CaseError::NotConverged(Box::new(invalid)),
            _ => invalid,
        }
    }
}
