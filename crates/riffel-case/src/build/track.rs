//! The track of a case, in each direction.

use riffel_keys::{CaseError, say};
use std::sync::Arc;

use riffel::receptance::{
    Bar, Beam, ContinuousTrack, EulerBernoulliBeam, FreeBeam, Layer, MovingBeam, MovingLoadTrack, PeriodicTrack,
    ShearSection, Waveguide,
};
use riffel::{Direction, ElasticMaterial, STEEL_DENSITY};
use riffel_keys::quantity::{Dimension, Quantity};
use riffel_rail::response;

use crate::file::{BeamModel, Support, TrackModel};
use crate::keys::checked_keys::CheckedKeys;
use crate::parts::track::{Origin, Track};

impl CheckedKeys {
    /// The track in one direction, over a support or where the case says.
    pub(crate) fn track(&self, direction: Direction) -> Result<Track, CaseError> {
        self.check_position()?;
        let steel = self.steel()?;
        let model = self.file.track.model;
        if let Some(given) = &self.given.track {
            if direction != Direction::Vertical {
                let message = "the receptance given for the track is vertical only";
                return Err(self.text.keys.refuse("track.model", message));
            }
            return Ok(Track {
                receptance: given.receptance.clone(),
                origin: given.origin(),
                structure: None,
                support: None,
                rail_mass: None,
                pinned_pinned: None,
                remarks: given.remarks.clone(),
            });
        }
        if direction != Direction::Vertical && matches!(model, TrackModel::MovingBeam | TrackModel::Measured) {
            return Err(self.text.keys.invalid(
                "track.model",
                format!("is \"{}\", which is vertical only", model.name()),
                "",
            ));
        }
        match (model, direction) {
            (TrackModel::Measured, _) => self.measured(),
            (TrackModel::MovingBeam, _) => self.moving(steel),
            (_, Direction::Longitudinal) => self.on_supports(self.bar(steel)?, direction),
            (TrackModel::FreeBeam, Direction::Vertical) if self.is_papers_rail() => {
                let rail = self.papers_rail(steel)?;
                let mut track = self.on_supports(Beam::from(rail), direction)?;
                track.receptance = Arc::new(FreeBeam::new(rail));
                Ok(track)
            }
            _ => {
                let beam = self.beam(steel, direction)?;
                let mut track = self.on_supports(beam, direction)?;
                track.pinned_pinned = track
                    .support_spacing()
                    .filter(|_| beam.shears())
                    .map(|spacing| beam.pinned_pinned_frequency(spacing, 1));
                Ok(track)
            }
        }
    }

    /// A rail on the supports of the model.
    fn on_supports(&self, rail: impl Waveguide + Copy + 'static, direction: Direction) -> Result<Track, CaseError> {
        let track = &self.file.track;
        let rail_mass = Some(rail.mass_per_length());
        let built = |receptance, structure, support| Track {
            receptance,
            origin: Origin::Model,
            structure: Some(structure),
            support,
            rail_mass,
            pinned_pinned: None,
            remarks: Vec::new(),
        };
        if track.model == TrackModel::FreeBeam {
            let free = Arc::new(ContinuousTrack::free(rail));
            return Ok(built(free.clone(), free, None));
        }
        let two_layers = matches!(track.model, TrackModel::TwoLayer | TrackModel::TwoLayerPeriodic);
        let (support, spacing) = self.support(two_layers, direction)?;
        let per_metre = self.physics("track.support_spacing", support.per_metre(spacing))?;
        if track.model.is_periodic() {
            let periodic = PeriodicTrack::new(rail, support, spacing);
            let periodic = self.physics("track.support_spacing", periodic)?;
            let position = track.position.map_or(0.0, |position| position.si());
            let receptance = Arc::new(periodic.at(position));
            return Ok(built(receptance, Arc::new(periodic), Some(per_metre)));
        }
        let even = Arc::new(ContinuousTrack::new(rail, per_metre));
        Ok(built(even.clone(), even, Some(per_metre)))
    }

    /// Rail and supports of a periodic model, vertical.
    pub(crate) fn periodic_track(&self) -> Result<PeriodicTrack<Beam>, CaseError> {
        let steel = self.steel()?;
        let rail = self.beam(steel, Direction::Vertical)?;
        let two_layers = self.file.track.model == TrackModel::TwoLayerPeriodic;
        let (support, spacing) = self.support(two_layers, Direction::Vertical)?;
        let track = PeriodicTrack::new(rail, support, spacing);
        self.physics("track.support_spacing", track)
    }

    /// A load that moves over a free rail, or over one on the layers that are given.
    fn moving(&self, steel: ElasticMaterial) -> Result<Track, CaseError> {
        let track = &self.file.track;
        let support = if track.ballast.is_some() {
            Some(self.support(true, Direction::Vertical)?)
        } else if track.pad.is_some() {
            Some(self.support(false, Direction::Vertical)?)
        } else {
            None
        };
        let support = support
            .map(|(support, spacing)| self.physics("track.support_spacing", support.per_metre(spacing)))
            .transpose()?;
        let beam = self.beam(steel, Direction::Vertical)?;
        let mut built = Track {
            receptance: Arc::new(MovingLoadTrack::new(beam, support)),
            origin: Origin::Model,
            structure: None,
            support,
            rail_mass: Some(beam.mass_per_length()),
            pinned_pinned: None,
            remarks: Vec::new(),
        };
        // The critical speed is lowest for long waves and high speeds.
        let (wavelength, speed) = self.window()?;
        let track = MovingLoadTrack::new(beam, support);
        self.physics("map", track.check_speed(wavelength.max(), speed.max()))?;
        if support.is_none() && self.is_papers_rail() {
            built.receptance = Arc::new(MovingBeam::new(self.papers_rail(steel)?));
        }
        Ok(built)
    }

    fn measured(&self) -> Result<Track, CaseError> {
        let measurement = self.required("track.measurement", self.file.track.measurement.as_ref())?;
        let folder = self.folder.as_ref().ok_or_else(|| self.text.names_a_file("track.measurement.file"))?;
        let measured = response::read(measurement, folder).map_err(|error| {
            let key = match error.key {
                "" => "track.measurement".to_owned(),
                key => format!("track.measurement.{key}"),
            };
            self.text.keys.invalid(&key, &error.message, "")
        })?;
        let table = Arc::new(measured.receptance);
        Ok(Track {
            receptance: table.clone(),
            origin: Origin::Measured(table),
            structure: None,
            support: None,
            rail_mass: None,
            pinned_pinned: None,
            remarks: measured.remarks,
        })
    }

    /// Frequency \[Hz\] at which the rail of the case, with shear, bends with nodes at its supports, however the
    /// model spreads them; None without a spacing or without the section of the rail.
    pub(crate) fn pinned_pinned(&self, direction: Direction) -> Option<f64> {
        let spacing = self.file.track.support_spacing?.si();
        let mut sheared = self.clone();
        sheared.file.rail.beam = Some(BeamModel::Timoshenko);
        let beam = sheared.beam(self.steel().ok()?, direction).ok()?;
        Some(beam.pinned_pinned_frequency(spacing, 1) / std::f64::consts::TAU)
    }

    /// Vertical bending stiffness of the rail \[N m²\]; `None` if no key tells it.
    pub(crate) fn vertical_bending_stiffness(&self) -> Option<f64> {
        let beam = self.beam(self.steel().ok()?, Direction::Vertical).ok()?;
        Some(beam.bending_stiffness())
    }

    /// True for a rail without shear and without loss, which has closed forms of its own.
    fn is_papers_rail(&self) -> bool {
        self.beam_model() == BeamModel::EulerBernoulli
            && self.file.rail.loss_factor.is_none_or(|loss| loss.si() == 0.0)
            && self.file.track.rail_damping.is_none_or(|damping| damping.si() == 0.0)
    }

    fn papers_rail(&self, steel: ElasticMaterial) -> Result<EulerBernoulliBeam, CaseError> {
        let second_moment = self.of_rail("rail.second_moment", self.file.rail.second_moment)?;
        let beam = EulerBernoulliBeam::new(steel, second_moment, self.mass_per_length()?);
        self.physics("rail", beam)
    }

    pub(crate) fn beam(&self, steel: ElasticMaterial, direction: Direction) -> Result<Beam, CaseError> {
        let rail = &self.file.rail;
        let (second_moment, shear_coefficient) = match direction {
            Direction::Lateral => (
                ("rail.lateral_second_moment", rail.lateral_second_moment),
                ("rail.lateral_shear_coefficient", rail.lateral_shear_coefficient),
            ),
            _ => (("rail.second_moment", rail.second_moment), ("rail.shear_coefficient", rail.shear_coefficient)),
        };
        let second_moment = self.of_rail(second_moment.0, second_moment.1)?;
        let mass_per_length = self.mass_per_length()?;
        let beam = match self.beam_model() {
            BeamModel::EulerBernoulli => EulerBernoulliBeam::new(steel, second_moment, mass_per_length).map(Beam::from),
            BeamModel::Timoshenko => {
                let shear = ShearSection {
                    area: self.of_rail("rail.area", rail.area)?,
                    shear_coefficient: self.of_rail(shear_coefficient.0, shear_coefficient.1)?,
                    shear_modulus: match rail.shear_modulus {
                        Some(modulus) => modulus.si(),
                        None => steel.shear_modulus(),
                    },
                    density: match rail.density {
                        Some(density) => density.si(),
                        None => STEEL_DENSITY,
                    },
                };
                Beam::timoshenko(steel, second_moment, mass_per_length, shear)
            }
        };
        let (loss_factor, damping) = self.rail_loss();
        let beam = beam.and_then(|beam| beam.with_loss_factor(loss_factor)).and_then(|beam| beam.with_damping(damping));
        self.physics("rail", beam)
    }

    pub(crate) fn bar(&self, steel: ElasticMaterial) -> Result<Bar, CaseError> {
        let area = self.of_rail("rail.area", self.file.rail.area)?;
        let (loss_factor, damping) = self.rail_loss();
        let bar = Bar::new(steel, area, self.mass_per_length()?)
            .and_then(|bar| bar.with_loss_factor(loss_factor))
            .and_then(|bar| bar.with_damping(damping));
        self.physics("rail", bar)
    }

    /// Loss factor and viscous damping of the rail.
    fn rail_loss(&self) -> (f64, f64) {
        let loss_factor = self.file.rail.loss_factor.map_or(0.0, |loss| loss.si());
        let damping = self.file.track.rail_damping.map_or(0.0, |damping| damping.si());
        (loss_factor, damping)
    }

    fn mass_per_length(&self) -> Result<f64, CaseError> {
        self.of_rail("rail.mass_per_length", self.file.rail.mass_per_length)
    }

    /// A value of the rail that its model cannot do without.
    fn of_rail<D: Dimension>(&self, key: &str, value: Option<Quantity<D>>) -> Result<f64, CaseError> {
        let help = match key {
            "rail.area" | "rail.shear_coefficient" => {
                "Timoshenko's beam needs it: give it, name a preset by rail.section, or choose \
                 rail.beam = \"euler-bernoulli\""
            }
            _ => "give it, or name a preset by rail.section",
        };
        let value = value.ok_or_else(|| self.text.keys.missing(key, help))?;
        Ok(value.si())
    }

    /// One support, values per support, and their distance \[m\].
    pub(crate) fn support(
        &self,
        two_layers: bool,
        direction: Direction,
    ) -> Result<(riffel::receptance::Support, f64), CaseError> {
        let track = &self.file.track;
        let spacing = self.required("track.support_spacing", track.support_spacing)?;
        let pad = self.layer("track.pad", track.pad.as_ref(), direction)?;
        if !two_layers {
            return Ok((riffel::receptance::Support::one_layer(pad), spacing.si()));
        }
        let sleeper = track.sleeper.as_ref().and_then(|sleeper| sleeper.mass);
        let mass = self.required("track.sleeper.mass", sleeper)?;
        let ballast = self.layer("track.ballast", track.ballast.as_ref(), direction)?;
        let support = riffel::receptance::Support::two_layer(pad, mass.si(), ballast);
        Ok((self.physics("track", support)?, spacing.si()))
    }

    /// A layer in one direction; its damping is in proportion to its stiffness in all of them.
    fn layer(&self, key: &str, support: Option<&Support>, direction: Direction) -> Result<Layer, CaseError> {
        let support = self.required(key, support)?;
        let vertical = self.required(&format!("{key}.stiffness"), support.stiffness)?;
        let stiffness = match direction {
            Direction::Vertical => vertical,
            Direction::Lateral => self.required(&format!("{key}.lateral_stiffness"), support.lateral_stiffness)?,
            Direction::Longitudinal => {
                self.required(&format!("{key}.longitudinal_stiffness"), support.longitudinal_stiffness)?
            }
        };
        if support.damping.is_none() && support.loss_factor.is_none() {
            return Err(self.text.keys.missing(&format!("{key}.damping"), say!(give_damping_loss_factor_or_both, key)));
        }
        let damping = support.damping.map_or(0.0, |damping| damping.si());
        let loss_factor = support.loss_factor.map_or(0.0, |loss| loss.si());
        let share = stiffness.si() / vertical.si();
        let layer = Layer::new(stiffness.si(), damping * share).and_then(|layer| layer.with_loss_factor(loss_factor));
        self.physics(key, layer)
    }

    /// The position, if there is one, lies within one bay, whether its model needs it or not.
    fn check_position(&self) -> Result<(), CaseError> {
        let track = &self.file.track;
        match (track.position, track.support_spacing) {
            (Some(position), Some(spacing)) if track.model.is_periodic() && position.si() > spacing.si() => {
                let rule = say!(at_most_the_support_spacing, spacing);
                Err(self.out_of_range("track.position", position, &rule))
            }
            _ => Ok(()),
        }
    }
}
