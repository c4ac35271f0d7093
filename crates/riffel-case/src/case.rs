//! A case, checked and complete: from keys to the physics.

use std::path::Path;
use std::sync::Arc;

use riffel::{
    Axis, Carter3d, ConstantCreepage, ConstantTangentialForce, ElasticMaterial, EnergyWear,
    EulerBernoulliBeam, FeedbackLoop, FreeBeam, HertzContact, Layer, MovingBeam, PlaceOfWear,
    Receptance, RigidInertia, RigidMass, RollingContact, TwoLayerTrack, WheelRotation,
};

use crate::file::{
    CaseFile, DissipationPhase, Rail, Rotation, Sleeper, Support, Track, TrackModel,
};
use crate::preset::{PresetValues, RailPreset, TrackPreset};
use crate::quantity::{Dimension, Quantity};
use crate::source::Source;
use crate::{CaseError, preset};

/// Most points along one axis of a map.
const MOST_AXIS_POINTS: u64 = 100_000;
/// Most points of a map: 16 bytes each in memory, some 100 in its table on disk.
const MOST_MAP_POINTS: u64 = 100_000_000;

/// A case ready to compute.
#[derive(Clone)]
pub struct Case {
    /// Every key with its value, presets and defaults filled in.
    pub file: CaseFile,
    /// The loop of the case.
    pub feedback: FeedbackLoop,
    /// The contact patch.
    pub hertz: HertzContact,
    /// The creep law at the mean state.
    pub creep_law: Carter3d,
    /// Wavelengths of the map \[m\].
    pub wavelength: Axis,
    /// Speeds of the map \[m/s\].
    pub speed: Axis,
    /// What the reader should know about the validity of the model in the window of the map.
    pub remarks: Vec<String>,
}

impl Case {
    /// Read a case file and apply overrides `key=value` in their order.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        let text = std::fs::read_to_string(path).map_err(|reason| CaseError::Read {
            path: path.to_owned(),
            reason,
        })?;
        Self::parse(&path.display().to_string(), &text, overrides)
    }

    /// Read a case from TOML; `name` is the one shown in errors.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, CaseError> {
        let mut source = Source::parse(name, text)?;
        for assignment in overrides {
            source.set(assignment)?;
        }
        // An override of one of two exclusive keys replaces the other.
        source.replace("contact", "tractive_ratio", "creepage");
        source.replace("contact", "creepage", "tractive_ratio");
        let file = source.deserialize()?;
        Builder { source, file }.build()
    }
}

/// A case file on its way to a case.
struct Builder {
    source: Source,
    file: CaseFile,
}

impl Builder {
    fn build(mut self) -> Result<Case, CaseError> {
        self.fill_in()?;
        let file = &self.file;

        let poisson = file.steel.poisson_ratio.si();
        self.positive("steel.youngs_modulus", file.steel.youngs_modulus)?;
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(self.out_of_range("steel.poisson_ratio", poisson, "between -1 and 0.5"));
        }
        let steel = self.physics(
            "steel",
            ElasticMaterial::new(file.steel.youngs_modulus.si(), poisson),
        )?;

        let contact = &file.contact;
        let radius = self.positive("wheel.rolling_radius", file.wheel.rolling_radius)?;
        let hertz = HertzContact::new(
            steel,
            radius,
            self.positive("contact.transverse_radius", contact.transverse_radius)?,
            self.positive("contact.normal_load", contact.normal_load)?,
        );
        let hertz = self.physics("contact", hertz)?;
        let creep_law = self.creep_law(hertz)?;

        let track = self.track(steel)?;
        let wheel = RigidMass::new(self.positive("wheel.mass", file.wheel.mass)?);
        let wheel = self.physics("wheel.mass", wheel)?;
        let place_of_wear = PlaceOfWear::new(
            match contact.dissipation_phase {
                DissipationPhase::Lag => riffel::DissipationPhase::Lag,
                DissipationPhase::Lead => riffel::DissipationPhase::Lead,
                DissipationPhase::None => riffel::DissipationPhase::None,
            },
            hertz.semi_axis_longitudinal(),
            creep_law.steady().tractive_ratio(),
        );
        let wear = EnergyWear::new(
            self.positive("wear.coefficient", file.wear.coefficient)?,
            self.positive("wear.density", file.wear.density)?,
            hertz.semi_axis_lateral(),
        );
        let feedback = FeedbackLoop {
            track,
            wheel: Arc::new(wheel),
            contact_stiffness: hertz.stiffness(),
            contact: Arc::new(creep_law),
            rotation: self.rotation(radius)?,
            rolling_radius: radius,
            place_of_wear,
            wear: self.physics("wear", wear)?,
            amplitude: self.positive("corrugation.amplitude", file.corrugation.amplitude)?,
        };
        let (wavelength, speed) = self.window()?;
        self.check_moving_beam(steel, wavelength.max(), speed.max())?;
        let remarks = crate::validity::remarks(file, &feedback, hertz, wavelength, speed);
        Ok(Case {
            file: self.file,
            feedback,
            hertz,
            creep_law,
            wavelength,
            speed,
            remarks,
        })
    }

    /// Put presets and dependent defaults in the place of keys left out.
    fn fill_in(&mut self) -> Result<(), CaseError> {
        if let Some(name) = &self.file.rail.section {
            let Some(PresetValues::Rail(preset)) = named(name) else {
                return Err(self.unknown_preset("rail.section", name, "rail"));
            };
            fill_in_rail(&mut self.file.rail, &preset);
        }
        if let Some(name) = &self.file.track.preset {
            let Some(PresetValues::Track(preset)) = named(name) else {
                return Err(self.unknown_preset("track.preset", name, "track"));
            };
            fill_in_track(&mut self.file.track, &preset);
        }
        let wheel = &mut self.file.wheel;
        wheel.inertia.get_or_insert_with(|| {
            let (mass, radius) = (wheel.mass.si(), wheel.rolling_radius.si());
            Quantity::new(RigidInertia::reduced_inertia(mass, radius))
        });
        Ok(())
    }

    fn creep_law(&self, hertz: HertzContact) -> Result<Carter3d, CaseError> {
        let contact = &self.file.contact;
        let friction = self.positive("contact.friction", contact.friction)?;
        let (key, law) = match (contact.tractive_ratio, contact.creepage) {
            (Some(_), Some(_)) => {
                return Err(self.source.invalid(
                    "contact.creepage",
                    "and `contact.tractive_ratio` exclude each other",
                    "give one of the two",
                ));
            }
            (None, None) => {
                return Err(self.source.missing(
                    "contact.tractive_ratio",
                    "give contact.tractive_ratio or contact.creepage",
                ));
            }
            (Some(ratio), None) => {
                let ratio = ratio.si();
                if !(ratio > 0.0 && ratio < 1.0) {
                    return Err(self.out_of_range(
                        "contact.tractive_ratio",
                        ratio,
                        "between 0 and 1, both excluded",
                    ));
                }
                (
                    "contact.tractive_ratio",
                    Carter3d::from_tractive_ratio(hertz, friction, ratio),
                )
            }
            (None, Some(creepage)) => {
                self.positive("contact.creepage", creepage)?;
                (
                    "contact.creepage",
                    Carter3d::from_creepage(hertz, friction, creepage.si()),
                )
            }
        };
        self.physics(key, law)
    }

    fn rotation(&self, radius: f64) -> Result<Arc<dyn WheelRotation>, CaseError> {
        let wheel = &self.file.wheel;
        // Filled in above; the mass it may come from is checked.
        let inertia = self.required("wheel.inertia", wheel.inertia)?;
        let inertia = self.positive("wheel.inertia", inertia)?;
        Ok(match wheel.rotation {
            Rotation::Inertia => {
                let rigid = RigidInertia::new(inertia, radius);
                Arc::new(self.physics("wheel.inertia", rigid)?)
            }
            Rotation::ConstantTangentialForce => Arc::new(ConstantTangentialForce),
            Rotation::ConstantCreepage => Arc::new(ConstantCreepage),
        })
    }

    fn beam(&self, steel: ElasticMaterial) -> Result<EulerBernoulliBeam, CaseError> {
        let rail = &self.file.rail;
        let help = "give it, or name a preset by rail.section";
        let mass_per_length = rail
            .mass_per_length
            .ok_or_else(|| self.source.missing("rail.mass_per_length", help))?;
        let second_moment = rail
            .second_moment
            .ok_or_else(|| self.source.missing("rail.second_moment", help))?;
        let beam = EulerBernoulliBeam::new(
            steel,
            self.positive("rail.second_moment", second_moment)?,
            self.positive("rail.mass_per_length", mass_per_length)?,
        );
        self.physics("rail", beam)
    }

    fn track(&self, steel: ElasticMaterial) -> Result<Arc<dyn Receptance>, CaseError> {
        self.check_track()?;
        let beam = self.beam(steel)?;
        let track = &self.file.track;
        Ok(match track.model {
            TrackModel::FreeBeam => Arc::new(FreeBeam::new(beam)),
            TrackModel::MovingBeam => Arc::new(self.moving_beam(beam)?),
            TrackModel::TwoLayer => {
                let spacing = self.required("track.support_spacing", track.support_spacing)?;
                let spacing = spacing.si();
                let pad = self.layer("track.pad", track.pad.as_ref(), spacing)?;
                let ballast = self.layer("track.ballast", track.ballast.as_ref(), spacing)?;
                let sleeper = self.required("track.sleeper.mass", track.sleeper.as_ref())?;
                let model = TwoLayerTrack::new(beam, pad, sleeper.mass.si() / spacing, ballast);
                Arc::new(self.physics("track", model)?)
            }
        })
    }

    fn moving_beam(&self, beam: EulerBernoulliBeam) -> Result<MovingBeam, CaseError> {
        let damping = self
            .file
            .track
            .rail_damping
            .map_or(0.0, |damping| damping.si());
        self.physics("track.rail_damping", MovingBeam::new(beam, damping))
    }

    fn layer(
        &self,
        key: &str,
        support: Option<&Support>,
        spacing: f64,
    ) -> Result<Layer, CaseError> {
        let support = self.required(key, support)?;
        let stiffness = self.required(&format!("{key}.stiffness"), support.stiffness)?;
        let damping = self.required(&format!("{key}.damping"), support.damping)?;
        let layer = Layer::new(stiffness.si() / spacing, damping.si() / spacing);
        self.physics(key, layer)
    }

    /// Every value of the track that is written, whether its model needs it or not.
    fn check_track(&self) -> Result<(), CaseError> {
        let track = &self.file.track;
        if let Some(spacing) = track.support_spacing {
            self.positive("track.support_spacing", spacing)?;
        }
        for (key, support) in [("track.pad", &track.pad), ("track.ballast", &track.ballast)] {
            let Some(support) = support else { continue };
            if let Some(stiffness) = support.stiffness {
                self.positive(&format!("{key}.stiffness"), stiffness)?;
            }
            if let Some(damping) = support.damping {
                self.not_negative(&format!("{key}.damping"), damping)?;
            }
        }
        if let Some(sleeper) = &track.sleeper {
            self.not_negative("track.sleeper.mass", sleeper.mass)?;
        }
        if let Some(damping) = track.rail_damping {
            self.not_negative("track.rail_damping", damping)?;
        }
        Ok(())
    }

    fn window(&self) -> Result<(Axis, Axis), CaseError> {
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
            return Err(self.source.invalid(
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
        let low = self.positive(&format!("{key}.min"), min)?;
        let high = self.positive(&format!("{key}.max"), max)?;
        if low >= high {
            return Err(self.source.invalid(
                &format!("{key}.max"),
                &format!("is {max}, but the window is empty unless it is above the min of {min}"),
                "",
            ));
        }
        if !(2..=MOST_AXIS_POINTS).contains(&points) {
            return Err(self.source.invalid(
                &format!("{key}.points"),
                &format!("is {points}, but must be between 2 and {MOST_AXIS_POINTS}"),
                "",
            ));
        }
        // At most MOST_AXIS_POINTS, which any usize holds.
        self.physics(key, Axis::new(low, high, points as usize))
    }

    fn check_moving_beam(
        &self,
        steel: ElasticMaterial,
        wavelength: f64,
        speed: f64,
    ) -> Result<(), CaseError> {
        if self.file.track.model != TrackModel::MovingBeam {
            return Ok(());
        }
        let beam = self.moving_beam(self.beam(steel)?)?;
        self.physics("map", beam.check_speed(wavelength, speed))
    }

    fn positive<D: Dimension>(&self, key: &str, value: Quantity<D>) -> Result<f64, CaseError> {
        if value.si() > 0.0 {
            return Ok(value.si());
        }
        Err(self.out_of_range(key, value, "greater than zero"))
    }

    fn not_negative<D: Dimension>(&self, key: &str, value: Quantity<D>) -> Result<f64, CaseError> {
        if value.si() >= 0.0 {
            return Ok(value.si());
        }
        Err(self.out_of_range(key, value, "zero or more"))
    }

    fn out_of_range(&self, key: &str, value: impl std::fmt::Display, rule: &str) -> CaseError {
        self.source
            .invalid(key, &format!("is {value}, but must be {rule}"), "")
    }

    fn required<T>(&self, key: &str, value: Option<T>) -> Result<T, CaseError> {
        value.ok_or_else(|| {
            let model =
                "track.model = \"two-layer\" needs it: give it, or name a preset by track.preset";
            self.source.missing(key, model)
        })
    }

    fn unknown_preset(&self, key: &str, name: &str, kind: &str) -> CaseError {
        let known: Vec<String> = preset::presets()
            .into_iter()
            .filter(|preset| preset.values.kind() == kind)
            .map(|preset| preset.name)
            .collect();
        self.source.invalid(
            key,
            &format!("is \"{name}\", but no {kind} preset has that name"),
            &format!("allowed: {}", known.join(", ")),
        )
    }

    /// An error of the physics, as one of the key that causes it.
    fn physics<T>(&self, key: &str, result: Result<T, riffel::Error>) -> Result<T, CaseError> {
        result.map_err(|error| self.source.invalid(key, &error.to_string(), ""))
    }
}

fn named(name: &str) -> Option<PresetValues> {
    preset::preset(name).ok().map(|preset| preset.values)
}

/// Keys that are written stay; the preset gives the others.
fn fill_in_rail(rail: &mut Rail, preset: &RailPreset) {
    rail.mass_per_length
        .get_or_insert(preset.mass_per_length.quantity);
    rail.second_moment
        .get_or_insert(preset.second_moment.quantity);
}

fn fill_in_track(track: &mut Track, preset: &TrackPreset) {
    track
        .support_spacing
        .get_or_insert(preset.support_spacing.quantity);
    let pad = track.pad.get_or_insert_default();
    pad.stiffness.get_or_insert(preset.pad_stiffness.quantity);
    pad.damping.get_or_insert(preset.pad_damping.quantity);
    let ballast = track.ballast.get_or_insert_default();
    ballast
        .stiffness
        .get_or_insert(preset.ballast_stiffness.quantity);
    ballast
        .damping
        .get_or_insert(preset.ballast_damping.quantity);
    track.sleeper.get_or_insert(Sleeper {
        mass: preset.sleeper_mass.quantity,
    });
}
