//! What a store says of itself and of its surveys.

use jiff::civil::Date;
use riffel::roughness::WavelengthBand;
use serde::{Deserialize, Serialize};

use crate::survey_file::FARTHEST;

/// Version of the layout of a store.
pub(crate) const FORMAT: u32 = 1;
/// Most cells of a survey: a line of 10 000 km at 0.1 m.
pub(crate) const MOST_CELLS: f64 = 1e8;
/// Wavelengths that a band may end at \[m\]: farther than any instrument goes.
const WAVELENGTHS: std::ops::RangeInclusive<f64> = 1e-4..=1e3;

/// `network.json`
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct NetworkRecord {
    pub(crate) format: u32,
    pub(crate) riffel_version: String,
    /// Length of a cell of the grid \[m\].
    pub(crate) resolution_m: f64,
    /// Shortest and longest wavelength of each band \[m\].
    pub(crate) bands_m: Vec<[f64; 2]>,
}

/// A survey of a line at a date: the file beside its arrays, without which they are not there.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SurveyRecord {
    /// The line.
    pub line: String,
    /// The day.
    #[serde(with = "day")]
    pub date: Date,
    /// Name of the file it came from.
    pub source: String,
    /// SHA-256 of that file, or of it and the names of its rails, where the line has others.
    pub sha256: String,
    /// Folder of the arrays, beside this record.
    pub(crate) folder: String,
    /// Where the first cell begins \[m\].
    pub start_m: f64,
    /// Cells of the grid from there on.
    pub cells: u64,
    /// The instruments that measured it, where its file names them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub devices: Vec<String>,
    /// The rails.
    pub rails: Vec<RailRecord>,
}

/// A rail of a survey.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RailRecord {
    /// What it is called.
    pub name: String,
    /// Name of its array.
    pub(crate) array: String,
    /// Cells that are measured, in one band or more.
    pub measured: u64,
    /// Where its welds, joints and squats are, in order \[m\]; `None` if the survey does not say it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub defects_m: Option<Vec<f64>>,
}

impl SurveyRecord {
    /// `Ok` if a survey on a grid of cells of a length \[m\] may be so.
    pub(crate) fn check(&self, resolution: f64) -> Result<(), &'static str> {
        let end = self.start_m + self.cells as f64 * resolution;
        let cell = self.start_m / resolution;
        let mut names: Vec<&str> = self.rails.iter().map(|rail| &*rail.name).collect();
        names.sort_unstable();
        names.dedup();
        if self.cells as f64 > MOST_CELLS {
            Err("no survey is so long")
        } else if !(self.start_m >= -FARTHEST && end <= FARTHEST) {
            Err("no line has such places")
        } else if (cell - cell.round()).abs() > 1e-3 {
            Err("it does not begin with a cell of the store")
        } else if self.rails.iter().any(|rail| rail.measured > self.cells) {
            Err("it has fewer cells than were measured")
        } else if names.is_empty() || names.len() != self.rails.len() {
            Err("it names no rail, or one twice")
        } else {
            Ok(())
        }
    }
}

impl NetworkRecord {
    /// `Ok` if a store may be so.
    pub(crate) fn check(&self) -> Result<(), String> {
        if self.format != FORMAT {
            return Err(format!("its format is {}, not {FORMAT}", self.format));
        }
        if !(0.1..=1e3).contains(&self.resolution_m) {
            return Err(format!("its cells are {} m long", self.resolution_m));
        }
        let mut ends = self.bands_m.iter().flatten();
        if ends.any(|end| !WAVELENGTHS.contains(end)) {
            return Err("a band has wavelengths of no corrugation".to_owned());
        }
        let place = |band: &[f64; 2]| self.place_of(*band);
        if (self.bands_m.iter().enumerate()).any(|(index, band)| place(band) != Some(index)) {
            return Err("it has a band twice".to_owned());
        }
        match self.bands() {
            Ok(bands) if bands.is_empty() => Err("it has no band of wavelength".to_owned()),
            Ok(_) => Ok(()),
            Err(error) => Err(error.to_string()),
        }
    }

    /// The bands; what was written is valid.
    pub(crate) fn bands(&self) -> Result<Vec<WavelengthBand>, riffel::Error> {
        let bands = self.bands_m.iter();
        bands.map(|&[from, to]| WavelengthBand::new(from, to)).collect()
    }

    /// The place of a band with these ends \[m\] among those of the store; none for another.
    pub(crate) fn place_of(&self, band: [f64; 2]) -> Option<usize> {
        let is_it = |held: &[f64; 2]| {
            let mut ends = held.iter().zip(band);
            ends.all(|(held, asked)| (held / asked - 1.0).abs() < 1e-9)
        };
        self.bands_m.iter().position(is_it)
    }
}

/// A day as its text, 2026-01-31.
mod day {
    use jiff::civil::Date;
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    pub(super) fn serialize<S: Serializer>(date: &Date, to: S) -> Result<S::Ok, S::Error> {
        to.collect_str(date)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Date, D::Error> {
        String::deserialize(from)?.parse().map_err(D::Error::custom)
    }
}
