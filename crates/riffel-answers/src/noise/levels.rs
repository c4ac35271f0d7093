//! Levels beside the track.

use riffel::noise::{FrequencyBand, a_weighting, pressure_level};

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

    /// Name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rail => "rail",
            Self::Sleepers => "sleepers",
            Self::Wheel => "wheel",
            Self::Total => "total",
        }
    }
}

/// Mean square pressures of a band \[Pa²\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BandPressure {
    /// The band.
    pub band: FrequencyBand,
    /// Of the rail.
    pub rail: f64,
    /// Of the sleepers.
    pub sleepers: f64,
    /// Of the wheel.
    pub wheel: f64,
}

impl BandPressure {
    /// Mean square pressure of a part \[Pa²\].
    pub fn of(&self, part: Part) -> f64 {
        match part {
            Part::Rail => self.rail,
            Part::Sleepers => self.sleepers,
            Part::Wheel => self.wheel,
            Part::Total => self.rail + self.sleepers + self.wheel,
        }
    }

    /// Level of a part \[dB\]; none where it radiates nothing.
    pub fn level(&self, part: Part) -> Option<f64> {
        Some(pressure_level(self.of(part))).filter(|level| level.is_finite())
    }
}

/// Equivalent levels over the passage of a train, by band.
#[derive(Debug, Clone, PartialEq)]
pub struct PassByLevels {
    bands: Vec<BandPressure>,
}

impl PassByLevels {
    pub(super) fn new(bands: Vec<BandPressure>) -> Self {
        Self { bands }
    }

    /// The bands, the lowest first.
    pub fn bands(&self) -> &[BandPressure] {
        &self.bands
    }

    /// A-weighted level of a part over all bands \[dB(A)\]; −∞ where it radiates nothing.
    pub fn a_weighted(&self, part: Part) -> f64 {
        let bands = self.bands.iter();
        let sum: f64 = bands
            .map(|band| band.of(part) * 10f64.powf(0.1 * a_weighting(band.band.centre())))
            .sum();
        pressure_level(sum)
    }

    /// The bands that others have, too.
    pub(super) fn within(&self, others: &Self) -> Self {
        let has = |band: FrequencyBand| others.bands.iter().any(|other| other.band == band);
        let bands = self.bands.iter().copied();
        Self::new(bands.filter(|band| has(band.band)).collect())
    }

    /// The same with rail and sleepers at some share of their sound power.
    pub(super) fn with_track_at(&self, share: f64) -> Self {
        let bands = self.bands.iter();
        Self::new(
            bands
                .map(|band| BandPressure {
                    rail: share * band.rail,
                    sleepers: share * band.sleepers,
                    ..*band
                })
                .collect(),
        )
    }
}
