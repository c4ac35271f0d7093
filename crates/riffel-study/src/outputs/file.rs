//! The keys of what a plan wants, as written.

use riffel_case::PointQuantity;
use riffel_case::traffic::TrafficFile;
use riffel_keys::quantity::{Length, Quantity, Speed};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::WaveQuantity;

/// What is computed for each sample. The window is `map` of the case.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct OutputsFile {
    /// The highest growth of the window with its wavelength, speed and frequency, and the frequency that the ridge
    /// follows.
    pub ridge: bool,
    /// Wavelength and growth of the ridge at each speed.
    pub ridge_over_speed: bool,
    /// Growth rate at each wavelength, in the mean over the speeds of the window.
    pub growth_by_wavelength: bool,
    /// The highest of these in each band.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub growth_by_band: Option<BandSet>,
    /// Highest growth in each band of one's own.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub band: Vec<BandFile>,
    /// Quantities at one wavelength and speed.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub point: Vec<PointFile>,
    /// Wheels over a wave in time.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub wave: Vec<WaveFile>,
    /// Quantities over the whole window.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub map: Vec<MapQuantity>,
    /// The fastest growth of the window under this traffic, with its wavelength: the keys of a traffic file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub traffic: Option<TrafficFile>,
    /// Fastest growth under the usual traffic of the line of the case.
    pub usual_traffic: bool,
}

/// Bands of wavelength with a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BandSet {
    /// One-third octaves with wavelengths in the window.
    OneThirdOctaves,
    /// 10–30, 30–100, 100–300 and 300–1000 mm, those with wavelengths in the window.
    Grinding,
}

/// A band of wavelengths.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BandFile {
    /// Shortest wavelength.
    pub from: Quantity<Length>,
    /// Longest wavelength.
    pub to: Quantity<Length>,
}

/// Quantities at one wavelength and speed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointFile {
    /// What their names begin with; left out, `point_1` and so on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Wavelength.
    pub wavelength: Quantity<Length>,
    /// Speed.
    pub speed: Quantity<Speed>,
    /// The quantities, as `riffel point --json` names them.
    pub quantities: Vec<PointQuantity>,
}

/// Wheels over a wave in time, as `riffel simulate --sinusoid` settles them, at once or after the wave was worn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WaveFile {
    /// What their names begin with; left out, `wave_1` and so on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Wavelength.
    pub wavelength: Quantity<Length>,
    /// Amplitude, before any passage.
    pub amplitude: Quantity<Length>,
    /// Speed.
    pub speed: Quantity<Speed>,
    /// Wheels that wear the wave first; left out, none do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passages: Option<u64>,
    /// The quantities.
    pub quantities: Vec<WaveQuantity>,
}

/// A quantity over the whole window.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum MapQuantity {
    /// Growth rate per passage.
    GrowthRate,
    /// Ŵ₁ of equation (20), complex.
    NormalizedDissipation,
}
