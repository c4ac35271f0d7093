//! A band of a rail under many wheels, as documents hold it.

use riffel::roughness::level;
use serde::Serialize;

use super::Stage;
use super::linear::LinearBand;

/// A one-third octave.
#[derive(Serialize)]
pub(super) struct Band {
    /// Centre.
    pub(super) wavelength_m: f64,
    /// Level at each stage.
    pub(super) level_db: Vec<f64>,
    /// Level at each stage as the linear loop has it, wave by wave.
    pub(super) linear_level_db: Vec<f64>,
    /// Growth rate of the amplitude over the first step.
    pub(super) first_growth_per_passage: Option<f64>,
    /// That of the linear loop over the same passages.
    pub(super) first_linear_growth_per_passage: Option<f64>,
    /// Growth rate over the last quarter of the passages.
    pub(super) last_growth_per_passage: Option<f64>,
    /// Level at the end, where growth over the last quarter of the passages is below a tenth of what the linear loop has for
    /// the rail before any wheel, and that would be 1 dB or more.
    pub(super) saturation_level_db: Option<f64>,
    /// How far the waves have moved in the direction of travel.
    pub(super) shift_m: Vec<f64>,
    /// Shift in a passage over the first step.
    pub(super) first_shift_m_per_passage: Option<f64>,
    /// That of the linear loop, of the rail before any wheel.
    pub(super) linear_shift_m_per_passage: f64,
}

impl Band {
    /// The band of a number at the stages of a run.
    pub(super) fn new(index: usize, stages: &[Stage], linear: &LinearBand) -> Self {
        /// Part of linear growth below which a band has stopped growing.
        const STOPPED: f64 = 0.1;
        /// Level of rounding, such as of the harmonics of a sinusoid \[dB\]: a hundredth of a picometre.
        const NOTHING: f64 = -160.0;
        /// Growth below which nothing can be said \[dB\].
        const LEAST: f64 = 1.0;
        let (first, last) = (&stages[0], &stages[stages.len() - 1]);
        let power = |stage: &Stage| stage.mean_squares_m2[index];
        let rate = |from: f64, to: f64, passages: u64| {
            let known = passages > 0 && level(from) > NOTHING;
            known.then(|| 0.5 * (to / from).ln() / passages as f64)
        };
        let second = stages.get(1);
        let per_passage = |of: &dyn Fn(&Stage) -> Option<f64>| second.and_then(of);
        let quarter = stages.iter().rev().find(|stage| 4 * stage.passages <= 3 * last.passages);
        let last_growth = quarter.and_then(|from| rate(power(from), power(last), last.passages - from.passages));
        let linear_growth = rate(linear.mean_square(0), linear.mean_square(last.passages), last.passages);
        let end = level(power(last));
        let stopped = quarter.zip(last_growth).zip(linear_growth);
        let stopped = stopped.is_some_and(|((from, own), linear)| {
            let passages = (last.passages - from.passages) as f64;
            let decibels = 20.0 * std::f64::consts::LOG10_E * linear * passages;
            decibels >= LEAST && own < STOPPED * linear
        });
        Self {
            wavelength_m: linear.band.wavelength(),
            level_db: stages.iter().map(|stage| level(power(stage))).collect(),
            linear_level_db: stages.iter().map(|stage| linear.level(stage.passages)).collect(),
            first_growth_per_passage: per_passage(&|stage| rate(power(first), power(stage), stage.passages)),
            first_linear_growth_per_passage: per_passage(&|stage| {
                rate(linear.mean_square(0), linear.mean_square(stage.passages), stage.passages)
            }),
            last_growth_per_passage: last_growth,
            saturation_level_db: stopped.then_some(end),
            shift_m: stages.iter().map(|stage| stage.shifts_m[index]).collect(),
            first_shift_m_per_passage: per_passage(&|stage| {
                (stage.passages > 0 && level(power(first)) > NOTHING)
                    .then(|| stage.shifts_m[index] / stage.passages as f64)
            }),
            linear_shift_m_per_passage: linear.shift(),
        }
    }
}
