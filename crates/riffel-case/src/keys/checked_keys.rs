//! The keys of a case, checked one by one.

use riffel_keys::{CaseError, Message, Value, number, say};
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use riffel::wheelset::RigidInertia;
use riffel::{Axis, ElasticMaterial};
use riffel_keys::quantity::{Dimension, Quantity};

use crate::file::{BeamModel, CaseFile, ContactDynamics, CreepLawName, HertzTheory};
use crate::keys::mean::Mean;
use crate::keys::substitutes::Substitutes;
use crate::keys::written_keys::WrittenKeys;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

/// Most points along one axis of a map.
const MOST_AXIS_POINTS: u64 = 100_000;
/// Most points of a map: 16 bytes each in memory, some 100 in its table on disk.
const MOST_MAP_POINTS: u64 = 100_000_000;

/// The keys of a case with presets and defaults filled in, and what was given with them. Every quantity that is
/// written lies in its physical range.
#[derive(Clone)]
pub(crate) struct CheckedKeys {
    pub(crate) text: Arc<CaseText>,
    /// Folder to which file names in the case are relative; without one the case may not name any.
    pub(crate) folder: Option<PathBuf>,
    pub(crate) file: CaseFile,
    /// Where the mean state comes from.
    pub(crate) mean: Mean,
    /// Structures in place of those of the file.
    pub(crate) given: Substitutes,
    /// What wavelengths and speeds of the file are a window of.
    pub(crate) window: Window,
}

impl CheckedKeys {
    /// The keys of a text, presets and defaults filled in, with the mean state of a curve where they ask for it. `folder` is the one to
    /// which files are relative; without it the case may not name any.
    pub(crate) fn of_text(
        unfilled: CaseText,
        folder: Option<&Path>,
        given: Substitutes,
        window: Window,
    ) -> Result<Self, CaseError> {
        let written = WrittenKeys::read(unfilled, folder)?;
        let Some(from) = &written.from else {
            return Self::complete(&written, written.file.clone(), Mean::Given, given, window);
        };
        let equilibrium = written.equilibrium(from, &given)?;
        written.on_wheel(&Arc::new(equilibrium), from, given, window)
    }

    /// Written keys with their values and their mean state, where these go together.
    pub(crate) fn complete(
        written: &WrittenKeys,
        mut file: CaseFile,
        mean: Mean,
        given: Substitutes,
        window: Window,
    ) -> Result<Self, CaseError> {
        if let Some((measured, coefficient)) = given.wear
            && file.wear.measured == Some(measured)
        {
            file.wear.coefficient = Quantity::new(coefficient);
        }
        let wheel = &mut file.wheel;
        if let Some(mass) = wheel.mass.filter(|_| file.wheelset.is_none()) {
            let radius = wheel.rolling_radius.si();
            let reduced = RigidInertia::reduced_inertia(mass.si(), radius);
            wheel.inertia.get_or_insert(Quantity::new(reduced));
            wheel.rotation.get_or_insert_default();
        }
        let keys = Self { text: written.text.clone(), folder: written.folder.clone(), file, mean, given, window };
        keys.check_wheel()?;
        keys.check_measured_wear()?;
        keys.general()?;
        Ok(keys)
    }

    /// The creep law: as written, or the exact one with a non-steady response, or the paper's.
    pub(crate) fn creep_law_name(&self) -> CreepLawName {
        let contact = &self.file.contact;
        contact.creep_law.unwrap_or(match contact.response {
            ContactDynamics::NonSteady => CreepLawName::HALF_SPACE,
            _ => CreepLawName::CARTER_3D,
        })
    }

    /// The theory of the ellipse: as written, or the one that goes with the creep law.
    pub(crate) fn hertz_theory(&self) -> HertzTheory {
        let contact = &self.file.contact;
        contact.hertz.unwrap_or(match self.creep_law_name() {
            CreepLawName::CARTER_3D => HertzTheory::Paper,
            _ => HertzTheory::Exact,
        })
    }

    /// How the rail bends: as written, or with shear where supports are discrete.
    pub(crate) fn beam_model(&self) -> BeamModel {
        self.file.rail.beam.unwrap_or({
            if self.file.track.model.is_periodic() { BeamModel::Timoshenko } else { BeamModel::EulerBernoulli }
        })
    }

    /// The material of wheel and rail.
    pub(crate) fn steel(&self) -> Result<ElasticMaterial, CaseError> {
        let steel = &self.file.steel;
        let steel = ElasticMaterial::new(steel.youngs_modulus.si(), steel.poisson_ratio.si());
        self.physics("steel", steel)
    }

    /// Wavelengths and speeds of the map.
    pub(crate) fn window(&self) -> Result<(Axis, Axis), CaseError> {
        let map = &self.file.map;
        let (wavelength, speed) = (&map.wavelength, &map.speed);
        let wavelength_axis = self.axis("map.wavelength", wavelength.min, wavelength.max, wavelength.points)?;
        let speed_axis = self.axis("map.speed", speed.min, speed.max, speed.points)?;
        if wavelength.points * speed.points > MOST_MAP_POINTS {
            return Err(self.text.keys.invalid(
                "map",
                format!(
                    "{} wavelengths at {} speeds are more than the {MOST_MAP_POINTS} points of the \
                     largest map",
                    wavelength.points, speed.points
                ),
                say!(lower_points),
            ));
        }
        Ok((wavelength_axis, speed_axis))
    }

    fn axis<D: Dimension>(
        &self,
        key: &str,
        min: Quantity<D>,
        max: Quantity<D>,
        points: u64,
    ) -> Result<Axis, CaseError> {
        let (low, high) = (min.si(), max.si());
        if low >= high {
            return Err(self.text.keys.invalid(&format!("{key}.max"), say!(is_empty_window, max, min), ""));
        }
        if !(2..=MOST_AXIS_POINTS).contains(&points) {
            return Err(self.text.keys.invalid(
                &format!("{key}.points"),
                say!(is_outside, value = points, low = 2u64, high = MOST_AXIS_POINTS),
                "",
            ));
        }
        // At most MOST_AXIS_POINTS, which any usize holds.
        self.physics(key, Axis::new(low, high, points as usize))
    }

    pub(crate) fn out_of_range(&self, key: &str, value: impl Display, rule: impl Into<Message>) -> CaseError {
        let rule = say!(is_but_must_be, value = number(value), rule = rule.into());
        self.text.keys.invalid(key, rule, "")
    }

    /// A value that the model of the track cannot do without.
    pub(crate) fn required<T>(&self, key: &str, value: Option<T>) -> Result<T, CaseError> {
        value.ok_or_else(|| {
            let model = self.file.track.model.name();
            let preset = if key == "track.measurement" { Value::from("") } else { say!(or_name_a_preset).into() };
            let help = say!(track_model_needs_it, model, preset);
            self.text.keys.missing(key, help)
        })
    }

    /// An error of the physics, as one of the key that causes it.
    pub(crate) fn physics<T>(&self, key: &str, result: Result<T, riffel::Error>) -> Result<T, CaseError> {
        result.map_err(|error| {
            let help = match key {
                "contact.creepage" if self.mean.wheel().is_some() => {
                    "it is the creepage of the curve of contact.from; contact.creep_law = \"fastsim\" keeps a little stick where there is spin, \
                     \"full-sliding\" is made for none"
                }
                _ => "",
            };
            let invalid = self.text.keys.invalid(key, &error, help);
            match error {
                riffel::Error::NotConverged { .. } => CaseError::NotConverged(Box::new(invalid)),
                _ => invalid,
            }
        })
    }
}
