//! What a train on a rail radiates, and what is heard of it.

use riffel::STEEL_DENSITY;
use riffel::contact::ContactFilter;
use riffel::noise::{
    Air, BandEnergies, BandRadiation, Energies, Energy, Excitation, FrequencyBand,
    OscillatingCylinder, OscillatingSphere, Piston, RailDecay, RollingSource, Sleepers, SoundPower,
    WheelModes,
};
use riffel::roughness::Spectrum;
use riffel_case::Case;
use riffel_rail::TransferTable;

use super::Train;
use crate::AnswerError;

/// Width of a wheel across its tread \[m\], that of the profiles of EN 13715.
const WHEEL_WIDTH: f64 = 0.135;
/// Area of the 60E1 section \[m²\], for a rail of which nothing is known but its receptance.
const RAIL_AREA: f64 = 76.7e-4;
/// Distance of sleepers \[m\] where a model has them spread evenly.
const SLEEPER_SPACING: f64 = 0.6;

/// Why a track has no level of its own, if it has none: nothing is known of how far its rail carries vibration, or it carries it
/// further than a length can be told, at every frequency, so that the level would be that of where the length is cut.
pub fn without_decay(case: &Case) -> Option<String> {
    let model = case.file.track.model.name();
    let Some(track) = case.track.structure.as_deref() else {
        return Some(format!(
            "track.model = \"{model}\" says what the rail does under the wheel alone, not how far its vibration runs"
        ));
    };
    let runs_on = FrequencyBand::all().all(|band| RailDecay::runs_on(track, band.centre()));
    runs_on.then(|| {
        format!("the rail of track.model = \"{model}\" carries its vibration on without end at every frequency")
    })
}

/// Sound powers of the parts.
pub(super) fn powers_of_parts(powers: &[SoundPower]) -> Energies {
    let bands = powers.iter().map(|power| BandEnergies {
        band: power.band,
        rail: power.rail,
        sleepers: power.sleepers,
        wheel: power.wheel,
    });
    Energies {
        energy: Energy::Power,
        bands: bands.collect(),
    }
}

/// What a train makes of any roughness of a case at a speed.
pub(super) struct Radiation<'a> {
    case: &'a Case,
    speed: f64,
    bands: Vec<BandRadiation>,
}

impl Train<'_> {
    /// Pressures beside the track of some sound powers of a wheel on one rail.
    pub(super) fn heard(&self, powers: &[SoundPower]) -> Energies {
        let air = Air::default();
        let bands = powers.iter().map(|power| BandEnergies {
            band: power.band,
            rail: self.pass.of_wheels(&air, power.rail),
            sleepers: self.pass.of_wheels(&air, power.sleepers),
            wheel: self.pass.of_wheels(&air, power.wheel),
        });
        Energies {
            energy: Energy::Pressure,
            bands: bands.collect(),
        }
    }

    /// Levels with some roughness of the rail.
    pub(super) fn levels(
        &self,
        radiation: &Radiation<'_>,
        roughness: &Spectrum,
    ) -> Result<Energies, AnswerError> {
        Ok(self.heard(&self.powers(radiation, roughness)?))
    }

    /// Sound powers of a wheel on one rail, in the bands that are known.
    pub(super) fn powers(
        &self,
        radiation: &Radiation<'_>,
        roughness: &Spectrum,
    ) -> Result<Vec<SoundPower>, AnswerError> {
        let excitation = self.excitation(radiation.case, roughness, radiation.speed)?;
        let mut powers = Vec::new();
        for band in &radiation.bands {
            powers.extend(band.power(&excitation)?);
        }
        Ok(powers)
    }

    /// What the train makes of any roughness at a speed, with some modes of its wheels.
    pub(super) fn radiation<'a>(
        &self,
        case: &'a Case,
        modes: Option<&WheelModes>,
        speed: f64,
    ) -> Result<Radiation<'a>, AnswerError> {
        let file = &case.file;
        let area = match (file.rail.area, case.track.rail_mass) {
            (Some(area), _) => area.si(),
            (None, Some(mass)) => mass / file.rail.density.map_or(STEEL_DENSITY, |rho| rho.si()),
            (None, None) => RAIL_AREA,
        };
        let spacing = file.track.support_spacing.map(|spacing| spacing.si());
        let face = Piston::new(self.question.sleeper_area)?;
        let source = RollingSource {
            feedback: &case.feedback,
            decay: match (&self.question.decay_rate, case.track.structure.as_deref()) {
                (None, Some(track)) => RailDecay::Track(track),
                (rates, track) => RailDecay::Rates {
                    rates: rates.clone().unwrap_or_default(),
                    track,
                },
            },
            rail: OscillatingCylinder::of_rail(self.question.rail_foot, area)?,
            sleepers: case.track.support.map(|support| Sleepers {
                support,
                face,
                spacing: spacing.unwrap_or(SLEEPER_SPACING),
            }),
            wheel: OscillatingSphere::of_wheel(case.hertz.rolling_radius(), WHEEL_WIDTH)?,
            wheel_modes: modes,
            air: Air::default(),
        };
        let (lowest, highest) = case.known_frequencies();
        let known = FrequencyBand::all().filter(|band| {
            let (low, high) = band.range();
            low >= lowest && high <= highest
        });
        Ok(Radiation {
            case,
            speed,
            bands: known
                .filter_map(|band| source.radiation(band, speed))
                .collect(),
        })
    }

    /// Levels by transfer functions: those of the track are the rail's, those of the vehicle the wheel's.
    pub(super) fn levels_by_transfer(
        &self,
        case: &Case,
        [track, vehicle]: [&TransferTable; 2],
    ) -> Result<Energies, AnswerError> {
        let excitation = self.excitation(case, &self.question.roughness, self.question.speed)?;
        let air = Air::default();
        let mut bands = Vec::new();
        for band in FrequencyBand::all().filter(|band| excitation.covers(*band)) {
            let (low, high) = band.range();
            let roughness = excitation.mean_square(low, high)?;
            let powers = [track, vehicle].map(|table| table.function.power(band, roughness));
            if let [Some(track), Some(vehicle)] = powers {
                bands.push(BandEnergies {
                    band,
                    rail: self.pass.of_wheelsets(&air, track),
                    sleepers: 0.0,
                    wheel: self.pass.of_wheelsets(&air, vehicle),
                });
            }
        }
        Ok(Energies {
            energy: Energy::Pressure,
            bands,
        })
    }

    fn excitation(
        &self,
        case: &Case,
        roughness: &Spectrum,
        speed: f64,
    ) -> Result<Excitation, AnswerError> {
        let wheel = self.wheels.as_ref().map(|(_, spectrum)| spectrum);
        let filter = ContactFilter::of(&case.hertz);
        Ok(Excitation::new(roughness, wheel, filter, speed)?)
    }
}
