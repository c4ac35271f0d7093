//! From keys to the physics: every value checked, every joint of the loop built.

mod contact;
mod track;

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use riffel::{
    Axis, ElasticMaterial, EnergyWear, FeedbackLoop, PlaceOfWear, Receptance,
    wheelset::{ConstantCreepage, ConstantTangentialForce, RigidInertia, RigidMass, WheelRotation},
};
use riffel_keys::CaseError;
use riffel_keys::quantity::{Dimension, Quantity};

use crate::case::Case;
use crate::case_text::CaseText;
use crate::file::{CaseFile, DissipationPhase, Rotation};
use crate::given::Given;
use crate::measurement;
use crate::track::{Direction, Track};
use crate::validity::{self, Window};

/// Most points along one axis of a map.
const MOST_AXIS_POINTS: u64 = 100_000;
/// Most points of a map: 16 bytes each in memory, some 100 in its table on disk.
const MOST_MAP_POINTS: u64 = 100_000_000;

/// A case file on its way to a case. Every quantity that is written lies in its physical range.
#[derive(Clone)]
pub(crate) struct Builder {
    pub(crate) text: CaseText,
    /// Folder to which file names in the case are relative; without one the case may not name any.
    folder: Option<PathBuf>,
    pub(crate) file: CaseFile,
    /// Structures in place of those of the file.
    pub(crate) given: Given,
    /// What wavelengths and speeds of the file are a window of.
    pub(crate) window: Window,
}

impl Builder {
    pub(crate) fn new(
        text: CaseText,
        folder: Option<PathBuf>,
        mut file: CaseFile,
        given: Given,
        window: Window,
    ) -> Self {
        let wheel = &mut file.wheel;
        wheel.inertia.get_or_insert_with(|| {
            let (mass, radius) = (wheel.mass.si(), wheel.rolling_radius.si());
            Quantity::new(RigidInertia::reduced_inertia(mass, radius))
        });
        Self {
            text,
            folder,
            file,
            given,
            window,
        }
    }

    pub(crate) fn folder(&self) -> Option<&Path> {
        self.folder.as_deref()
    }

    /// The error of a case that names a file and may not.
    pub(crate) fn names_a_file(text: &CaseText) -> CaseError {
        text.keys.invalid(
            "track.measurement.file",
            "is a file, and this case may not name any",
            "use it in a case file with the program, `riffel map CASE`",
        )
    }

    /// The case; `written` are its keys before presets.
    pub(crate) fn build(self, written: CaseText) -> Result<Case, CaseError> {
        let file = &self.file;
        let steel = self.steel()?;

        let hertz = self.hertz(steel)?;
        let contact = self.contact(hertz)?;
        let steady = contact.rolling.steady();

        let (wavelength, speed) = self.window()?;
        let track = self.track(Direction::Vertical)?;
        let wheel = RigidMass::new(file.wheel.mass.si());
        let mut wheel: Arc<dyn Receptance> = Arc::new(self.physics("wheel.mass", wheel)?);
        if let Some(given) = &self.given.wheel {
            wheel = given.receptance.clone();
        }
        let place_of_wear = PlaceOfWear::new(
            match file.contact.dissipation_phase {
                DissipationPhase::Lag => riffel::DissipationPhase::Lag,
                DissipationPhase::Lead => riffel::DissipationPhase::Lead,
                DissipationPhase::None => riffel::DissipationPhase::None,
            },
            hertz.semi_axis_longitudinal(),
            steady.tractive_ratio(),
        );
        let wear = EnergyWear::new(
            file.wear.coefficient.si(),
            file.wear.density.si(),
            hertz.semi_axis_lateral(),
        );
        let feedback = FeedbackLoop {
            track: track.receptance.clone(),
            wheel,
            contact_stiffness: hertz.stiffness(),
            contact: contact.rolling,
            rotation: self.rotation(hertz.rolling_radius())?,
            rolling_radius: hertz.rolling_radius(),
            place_of_wear,
            wear: self.physics("wear", wear)?,
            amplitude: file.corrugation.amplitude.si(),
        };
        let mut remarks = self.text.remarks.clone();
        remarks.extend(track.remarks.iter().cloned());
        remarks.extend(
            self.given
                .wheel
                .iter()
                .flat_map(|given| given.remarks.clone()),
        );
        let axes = [wavelength, speed];
        remarks.extend(validity::remarks(&self, &track, &feedback, hertz, axes));
        Ok(Case {
            file: self.file.clone(),
            builder: self,
            written,
            feedback,
            track,
            hertz,
            steady,
            carter: contact.carter,
            wavelength,
            speed,
            remarks,
        })
    }

    fn steel(&self) -> Result<ElasticMaterial, CaseError> {
        let steel = &self.file.steel;
        let steel = ElasticMaterial::new(steel.youngs_modulus.si(), steel.poisson_ratio.si());
        self.physics("steel", steel)
    }

    /// `Ok` if track and wheel are known over the frequencies \[Hz\].
    pub(crate) fn check_frequencies(
        &self,
        track: &Track,
        lowest: f64,
        highest: f64,
    ) -> Result<(), CaseError> {
        /// Frequencies come from V/λ and pass through ω: some roundings.
        const ROUNDING: f64 = 1e-9;
        let outside = |receptance: &dyn Receptance| {
            let (low, high) = measurement::range(receptance);
            let within = lowest >= low * (1.0 - ROUNDING) && highest <= high * (1.0 + ROUNDING);
            (!within).then_some((low, high))
        };
        let wheel = self.given.wheel.as_ref();
        let (key, (low, high)) = if let Some(range) = outside(&*track.receptance) {
            match self.given.track {
                Some(_) => ("receptance of the track", range),
                None => ("track.measurement.file", range),
            }
        } else if let Some(range) = wheel.and_then(|wheel| outside(&*wheel.receptance)) {
            ("receptance of the wheel", range)
        } else {
            return Ok(());
        };
        let asked = if lowest == highest {
            format!("{lowest:.4} Hz is")
        } else {
            format!("{lowest:.4} to {highest:.4} Hz are")
        };
        Err(self.text.keys.invalid(
            key,
            &format!("is known from {low:.4} to {high:.4} Hz and is not extrapolated, but {asked} asked for"),
            "narrow the window, or measure further",
        ))
    }

    fn rotation(&self, radius: f64) -> Result<Arc<dyn WheelRotation>, CaseError> {
        let wheel = &self.file.wheel;
        // Filled in above; the mass it may come from is checked.
        let inertia = self.required("wheel.inertia", wheel.inertia)?.si();
        Ok(match wheel.rotation {
            Rotation::Inertia => {
                let rigid = RigidInertia::new(inertia, radius);
                Arc::new(self.physics("wheel.inertia", rigid)?)
            }
            Rotation::ConstantTangentialForce => Arc::new(ConstantTangentialForce),
            Rotation::ConstantCreepage => Arc::new(ConstantCreepage),
        })
    }

    pub(crate) fn window(&self) -> Result<(Axis, Axis), CaseError> {
        let map = &self.file.map;
        let (wavelength, speed) = (&map.wavelength, &map.speed);
        let wavelength_axis = self.axis(
            "map.wavelength",
            wavelength.min,
            wavelength.max,
            wavelength.points,
        )?;
        let speed_axis = self.axis("map.speed", speed.min, speed.max, speed.points)?;
        if wavelength.points * speed.points > MOST_MAP_POINTS {
            return Err(self.text.keys.invalid(
                "map",
                &format!(
                    "{} wavelengths at {} speeds are more than the {MOST_MAP_POINTS} points of the \
                     largest map",
                    wavelength.points, speed.points
                ),
                "lower map.wavelength.points or map.speed.points",
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
            return Err(self.text.keys.invalid(
                &format!("{key}.max"),
                &format!("is {max}, but the window is empty unless it is above the min of {min}"),
                "",
            ));
        }
        if !(2..=MOST_AXIS_POINTS).contains(&points) {
            return Err(self.text.keys.invalid(
                &format!("{key}.points"),
                &format!("is {points}, but must be between 2 and {MOST_AXIS_POINTS}"),
                "",
            ));
        }
        // At most MOST_AXIS_POINTS, which any usize holds.
        self.physics(key, Axis::new(low, high, points as usize))
    }

    pub(crate) fn out_of_range(&self, key: &str, value: impl Display, rule: &str) -> CaseError {
        self.text
            .keys
            .invalid(key, &format!("is {value}, but must be {rule}"), "")
    }

    fn required<T>(&self, key: &str, value: Option<T>) -> Result<T, CaseError> {
        value.ok_or_else(|| {
            let model = self.file.track.model.name();
            let preset = if key == "track.measurement" {
                ""
            } else {
                ", or name a preset by track.preset"
            };
            let help = format!("track.model = \"{model}\" needs it: give it{preset}");
            self.text.keys.missing(key, &help)
        })
    }

    /// An error of the physics, as one of the key that causes it.
    pub(crate) fn physics<T>(
        &self,
        key: &str,
        result: Result<T, riffel::Error>,
    ) -> Result<T, CaseError> {
        result.map_err(|error| {
            let invalid = self.text.keys.invalid(key, &error.to_string(), "");
            match error {
                riffel::Error::NotConverged { .. } => CaseError::NotConverged(Box::new(invalid)),
                _ => invalid,
            }
        })
    }
}
