//! What rail, sleepers and wheel give in each band, and its levels.

use super::{FrequencyBand, a_weighting, power_level, pressure_level};

/// What radiates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Rail.
    Rail,
    /// Sleepers.
    Sleepers,
    /// Wheel.
    Wheel,
    /// All of it.
    Total,
}

impl Part {
    /// All parts, their sum last.
    pub const ALL: [Self; 4] = [Self::Rail, Self::Sleepers, Self::Wheel, Self::Total];
}

/// What the energies of parts are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Energy {
    /// Sound power \[W\]; levels re 1 pW.
    Power,
    /// Mean square pressure \[Pa²\]; levels re 20 µPa.
    Pressure,
}

/// Energies of the parts in a band, as [`Energy`] says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandEnergies {
    /// The band.
    pub band: FrequencyBand,
    /// Of the rail.
    pub rail: f64,
    /// Of the sleepers.
    pub sleepers: f64,
    /// Of the wheel.
    pub wheel: f64,
}

impl BandEnergies {
    fn of(&self, part: Part) -> f64 {
        match part {
            Part::Rail => self.rail,
            Part::Sleepers => self.sleepers,
            Part::Wheel => self.wheel,
            Part::Total => self.rail + self.sleepers + self.wheel,
        }
    }
}

/// Energies of rail, sleepers and wheel by band, the lowest first.
#[derive(Debug, Clone, PartialEq)]
pub struct Energies {
    /// What they are.
    pub energy: Energy,
    /// The bands.
    pub bands: Vec<BandEnergies>,
}

impl Energies {
    fn level(&self, energy: f64) -> Option<f64> {
        let level = match self.energy {
            Energy::Power => power_level(energy),
            Energy::Pressure => pressure_level(energy),
        };
        Some(level).filter(|level| level.is_finite())
    }

    /// Level of a part in each band \[dB\]; `None` if it radiates nothing.
    pub fn levels(&self, part: Part) -> Vec<Option<f64>> {
        let bands = self.bands.iter();
        bands.map(|band| self.level(band.of(part))).collect()
    }

    /// A-weighted level of a part over all bands \[dB(A)\]; `None` if it radiates nothing.
    pub fn a_weighted(&self, part: Part) -> Option<f64> {
        let weighted = |band: &BandEnergies| band.of(part) * 10f64.powf(0.1 * a_weighting(band.band.centre()));
        self.level(self.bands.iter().map(weighted).sum())
    }

    /// The bands that others have, too.
    pub fn within(&self, others: &Self) -> Self {
        let has = |band: FrequencyBand| others.bands.iter().any(|other| other.band == band);
        let bands = self.bands.iter().copied();
        Self { bands: bands.filter(|band| has(band.band)).collect(), ..*self }
    }

    /// Energies with rail and sleepers at some share of theirs.
    pub fn with_track_at(&self, share: f64) -> Self {
        let bands = self.bands.iter().map(|band| BandEnergies {
            rail: share * band.rail,
            sleepers: share * band.sleepers,
            ..*band
        });
        Self { bands: bands.collect(), ..*self }
    }
}
