//! Acoustic roughness of a rail: from a measured profile to levels, statistics and limits.
//!
//! A [`Profile`] is cleaned of [spikes](Profile::remove_spikes) and rolled over by the
//! [wheel](Profile::roll_over) as EN 15610 asks, and becomes a [`Spectrum`] of one-third-octave levels
//! or a [`BandStatistics`] of what grinding is judged by; [`RailAnalysis`] does it all. Heights are positive upward, out of the rail;
//! levels are in dB re 1 µm, L = 10 lg(mean square / 1 µm²).
//!
//! ```
//! use riffel::roughness::{Profile, Spectrum, ThirdOctave};
//!
//! # fn main() -> Result<(), riffel::Error> {
//! // Ten metres of a sinusoid of 3 µm and 100 mm.
//! let wave = |i: i32| 3e-6 * (0.01 * std::f64::consts::TAU * f64::from(i)).sin();
//! let profile = Profile::new(0.0, 1e-3, (0..10_000).map(wave).collect())?;
//! let spectrum = Spectrum::of_record(&[profile], 1.0)?;
//! let level = spectrum.level(ThirdOctave::containing(0.1)?);
//! assert!((level.unwrap() - 6.53).abs() < 0.01);
//! # Ok(())
//! # }
//! ```

mod analysis;
mod band_pass;
mod band_statistics;
mod curvature;
mod defect;
mod drawn;
mod few_lines;
mod grinding;
mod hann_window;
mod judged_section;
mod level;
mod limit;
mod method_a;
mod moving;
mod power_spectrum;
mod profile;
mod spectrum;
mod spike;
mod synthesis;
mod third_octave;
mod wave_growth;
mod wavelength_band;
mod weld;

pub use analysis::{AnalysisSettings, BandSummary, BlockRms, RailAnalysis};
pub use band_pass::BandPass;
pub use band_statistics::{BandSettings, BandStatistics, Exceedance};
pub use curvature::{PIT_DEPTH, WHEEL_RADIUS};
pub use defect::RailDefect;
pub use grinding::{GrindSection, GrindSettings, grind_sections, line_length, stretch_numbers};
pub use judged_section::{JUDGED_LENGTH, JudgedSection, SectionSpectrum};
pub use level::{REFERENCE_ROUGHNESS, level, mean_square};
pub use limit::{LevelExcess, LevelLimit, RmsLimit};

pub use moving::{largest_peak_to_peak, moving_peak_to_peak, moving_rms};
pub use power_spectrum::PowerSpectrum;
pub use profile::Profile;
pub use spectrum::{BandLevel, Spectrum};
pub use spike::SpikeCriterion;
pub use synthesis::{ColouredNoise, Dropout, Irregularity, Recipe, Sinusoid};
pub use third_octave::{NOMINAL_OF_DECADE, ThirdOctave};
pub use wave_growth::{WaveGrowth, WaveGrowths};
pub use wavelength_band::WavelengthBand;
pub use weld::Weld;
