//! What a train on a rail radiates, and what is heard of it.

use riffel::contact::ContactFilter;
use riffel::roughness::Spectrum;
use riffel_case::Case;
use riffel_noise::{
    Air, BandEnergies, BandRadiation, Energies, Energy, Excitation, FrequencyBand, SoundPower, WheelModes,
};
use riffel_rail::TransferTable;

use super::train::Train;
use crate::Result;

/// Sound powers of the parts.
pub(super) fn powers_of_parts(powers: &[SoundPower]) -> Energies {
    let bands = powers.iter().map(|power| BandEnergies {
        band: power.band,
        rail: power.rail,
        sleepers: power.sleepers,
        wheel: power.wheel,
    });
    Energies { energy: Energy::Power, bands: bands.collect() }
}

/// What a train makes of any roughness of a case at a speed.
pub(super) struct Radiation<'a> {
    case: &'a Case,
    speed: f64,
    bands: Vec<BandRadiation>,
}

impl Train {
    /// Pressures beside the track of some sound powers of a wheel on one rail.
    pub(super) fn levels_at_receiver(&self, powers: &[SoundPower]) -> Energies {
        let air = Air::default();
        let bands = powers.iter().map(|power| BandEnergies {
            band: power.band,
            rail: self.pass.of_wheels(&air, power.rail),
            sleepers: self.pass.of_wheels(&air, power.sleepers),
            wheel: self.pass.of_wheels(&air, power.wheel),
        });
        Energies { energy: Energy::Pressure, bands: bands.collect() }
    }

    /// Levels with some roughness of the rail.
    pub(super) fn levels(&self, radiation: &Radiation<'_>, roughness: &Spectrum) -> Result<Energies> {
        Ok(self.levels_at_receiver(&self.powers(radiation, roughness)?))
    }

    /// Sound powers of a wheel on one rail, in the bands that are known.
    pub(super) fn powers(&self, radiation: &Radiation<'_>, roughness: &Spectrum) -> Result<Vec<SoundPower>> {
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
    ) -> Result<Radiation<'a>> {
        Ok(Radiation {
            case,
            speed,
            bands: self.radiator.bands(case, &case.feedback, &case.track, modes, speed, FrequencyBand::all())?,
        })
    }

    /// Levels by transfer functions: those of the track are the rail's, those of the vehicle the wheel's.
    pub(super) fn levels_by_transfer(&self, case: &Case, [track, vehicle]: [&TransferTable; 2]) -> Result<Energies> {
        let excitation = self.excitation(case, &self.roughness, self.speed)?;
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
        Ok(Energies { energy: Energy::Pressure, bands })
    }

    fn excitation(&self, case: &Case, roughness: &Spectrum, speed: f64) -> Result<Excitation> {
        let wheel = self.wheel_roughness.as_ref().map(|(_, spectrum)| spectrum);
        let filter = ContactFilter::of(&case.hertz);
        Ok(Excitation::new(roughness, wheel, filter, speed)?)
    }
}
