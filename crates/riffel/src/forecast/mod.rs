//! From a measured spectrum and a mix of traffic to the spectrum after so many passages.
//!
//! One loop gives the growth rate g of one wavelength under one wheel at one speed. Traffic is many
//! wheels at many speeds: [`MeanGrowth`] is the mean over a [`SpeedDistribution`], [`TrafficGrowth`] the sum
//! over vehicles by their shares of the axle passages. A one-third-octave level holds many wavelengths,
//! and each grows exponentially at its own rate, so a band is a sum of lines, [`GrowingSum`], and a
//! [`Forecast`] one such sum for each band:
//!
//! ```text
//! L(N) = 10 lg( Σ_j r_j² exp(2 g_j N) / r₀² ),   for one line ΔL = (20/ln 10) g N
//! ```
//!
//! N counts passages of axles, each a passage of one wheel over every point of each rail; g > 0 grows.
//! [`WearFit`] finds the wear coefficient of which two dated measurements speak, if they do.

mod bend;
mod cracks;
mod growing_sum;
mod hardening_wheel;
mod jackknife;
mod lines;
mod marched;
mod mean_growth;
mod measured_growth;
mod passages_until;
mod prediction;
mod speed_distribution;
mod traffic;
mod wear_fit;
mod wear_spread;
mod wheel_values;

pub use cracks::{CrackedPhase, WavePhase};
pub use growing_sum::GrowingSum;
pub use hardening_wheel::HardeningEnd;
pub use lines::{LINES_PER_BAND, band_lines};
pub use mean_growth::MeanGrowth;
pub use measured_growth::{MeasuredBand, MeasuredGrowth};
pub use prediction::{Forecast, ForecastBand, LinearRange, Reach};
pub use speed_distribution::SpeedDistribution;
pub use traffic::{TrafficGrowth, VehicleGrowth};
pub use wear_fit::{FittedBand, LARGE_CHANGE, LEAST_PASSAGES, MeasuredChange, WearFit, WearVerdict};
pub use wear_spread::WearSpread;
pub use wheel_values::WheelValues;
