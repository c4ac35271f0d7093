//! Levels of what a train radiates, and of what is heard beside the track.

use riffel::noise::{FrequencyBand, SoundPower, a_weighting, power_level, pressure_level};

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
        finite(pressure_level(self.of(part)))
    }
}

/// Sound power levels of one wheel with the rail and the sleepers under it, by band.
#[derive(Debug, Clone, PartialEq)]
pub struct PowerLevels {
    bands: Vec<SoundPower>,
}

impl PowerLevels {
    pub(super) fn new(bands: Vec<SoundPower>) -> Self {
        Self { bands }
    }

    /// Level of a part in each band \[dB re 1 pW\], the lowest first; none where it radiates nothing.
    pub fn levels(&self, part: Part) -> Vec<Option<f64>> {
        let bands = self.bands.iter();
        bands
            .map(|power| finite(power_level(of(power, part))))
            .collect()
    }

    /// A-weighted level of a part over all bands \[dB(A) re 1 pW\]; −∞ where it radiates nothing.
    pub fn a_weighted(&self, part: Part) -> f64 {
        let bands = self.bands.iter();
        power_level(weighted_sum(
            bands.map(|power| (power.band, of(power, part))),
        ))
    }
}

/// A level; none where a part radiates nothing.
pub(super) fn finite(level: f64) -> Option<f64> {
    Some(level).filter(|level| level.is_finite())
}

/// Sound power of a part \[W\].
fn of(power: &SoundPower, part: Part) -> f64 {
    match part {
        Part::Rail => power.rail,
        Part::Sleepers => power.sleepers,
        Part::Wheel => power.wheel,
        Part::Total => power.total(),
    }
}

/// Sum of what bands hold, as the ear weighs them.
fn weighted_sum(bands: impl Iterator<Item = (FrequencyBand, f64)>) -> f64 {
    bands
        .map(|(band, energy)| energy * 10f64.powf(0.1 * a_weighting(band.centre())))
        .sum()
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
        pressure_level(weighted_sum(bands.map(|band| (band.band, band.of(part)))))
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
