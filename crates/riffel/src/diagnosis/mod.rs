//! From dominant wavelengths of a measured rail to the mechanisms that may have made them.
//!
//! A [`CleanRail`], window by window, or a set of one-third-octave spectra gives [`DominantWavelength`]s; a
//! [`Mechanism`] says which wavelengths it makes at the speeds of the traffic; dated records give a
//! [`LevelTrend`]. [`rank`] holds them together and answers with [`Candidate`]s, each with the reasons for and
//! against it and a share of the belief, and [`tell_apart`] says which measurements would decide between
//! them. Nothing here is a verdict.
//!
//! # What a share means
//!
//! Every mechanism of the list, and one more that is not in it, are equally likely at first. Each is
//! multiplied by how much better it explains the observations than the unlisted one does, for which every
//! wavelength from 5 mm to 2 m is as likely as any other on a logarithmic scale and levels may rise or
//! fall. The products, divided by their sum, are the shares (Bayes' rule). They compare the candidates of
//! one list on the evidence named; they are no probability that a finding is right, for the list may lack
//! the cause and the case may be another track.

mod candidate;
mod dominant;
mod growth_density;
mod level_trend;
mod levels;
mod located;
mod measurement;
mod mechanism;
mod median_line;
mod normal;
mod prediction;
mod traffic_speeds;

pub use candidate::{Candidate, Evidence, Instrument, Reason, rank};
pub use dominant::{DominantWavelength, FineBand, FineSpectrum};
pub use growth_density::GrowthDensity;
pub use level_trend::{FALL_BY_GRINDING, LevelTrend, Slope, TimeUnit, TrendPoint, fall_of_bands, first_since_ground};
pub use levels::dominant_levels;
pub use located::{CleanRail, LocatedWavelength, Place, WINDOW};
pub use measurement::{Measurement, tell_apart};
pub use mechanism::{Expectation, MechanismKind};
pub use prediction::{Mechanism, Prediction};
pub use traffic_speeds::TrafficSpeeds;
