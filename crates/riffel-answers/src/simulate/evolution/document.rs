//! What `riffel simulate --passages --json` prints.

use riffel::roughness::level;
use serde::Serialize;

use super::linear::LinearBand;
use super::{EvolutionAnswer, PassingVehicle};

/// A rail after many wheels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EvolutionDocument {
    /// Mean speed of the passages.
    pub speed_m_per_s: f64,
    /// The wheels that passed.
    pub vehicles: Vec<PassingVehicle>,
    /// Step of the marches.
    pub step_m: f64,
    /// Length of the ring.
    pub length_m: f64,
    /// Wheels.
    pub passages: u64,
    /// Depth worn off everywhere.
    pub mean_depth_m: f64,
    /// Wheels before the first passage that is known to have lost contact, of those at the stages; none where none has.
    pub first_contact_loss_passages: Option<u64>,
    /// Mean square of the relative error of the track in time.
    pub track_share_cut: f64,
    /// Stages of the run.
    pub stages: StagesDocument,
    /// Bands, the shortest wavelength first.
    pub bands: Vec<BandDocument>,
}

/// Stages of the run, quantity by quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StagesDocument {
    /// Wheels so far.
    pub passages: Vec<u64>,
    /// Depth worn off everywhere.
    pub mean_depth_m: Vec<f64>,
    /// Level of the waves that fit between two supports, d/n; left out on an even track.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub support_pattern_level_db: Option<Vec<f64>>,
    /// Share of the time without contact of the passage before; none before any.
    pub contact_loss_fraction: Vec<Option<f64>>,
    /// Least normal force of that passage.
    pub minimum_normal_force_n: Vec<Option<f64>>,
    /// Largest normal force of that passage.
    pub maximum_normal_force_n: Vec<Option<f64>>,
}

/// A one-third octave.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BandDocument {
    /// Centre.
    pub wavelength_m: f64,
    /// Level at each stage.
    pub level_db: Vec<f64>,
    /// Level at each stage as the linear loop has it, wave by wave.
    pub linear_level_db: Vec<f64>,
    /// Growth rate of the amplitude over the first step.
    pub first_growth_per_passage: Option<f64>,
    /// That of the linear loop over the same passages.
    pub first_linear_growth_per_passage: Option<f64>,
    /// Growth rate over the last quarter of the passages.
    pub last_growth_per_passage: Option<f64>,
    /// Level at the end, where growth over the last quarter of the passages is below a tenth of what the linear loop has for
    /// the rail before any wheel, and that would be 1 dB or more.
    pub saturation_level_db: Option<f64>,
    /// How far the waves have moved in the direction of travel.
    pub shift_m: Vec<f64>,
    /// Shift in a passage over the first step.
    pub first_shift_m_per_passage: Option<f64>,
    /// That of the linear loop, of the rail before any wheel.
    pub linear_shift_m_per_passage: f64,
}

impl EvolutionAnswer {
    /// The run as data.
    pub fn document(&self) -> EvolutionDocument {
        let stages = &self.stages;
        let extremes = |of: fn(&super::Extremes) -> f64| {
            let each = stages.iter().map(|stage| stage.extremes.as_ref().map(of));
            each.collect()
        };
        let last = &stages[stages.len() - 1];
        // Extremes of a stage are those of the first passage after the one before.
        let lifted = stages.windows(2).find(|pair| {
            let after = pair[1].extremes.as_ref();
            after.is_some_and(|passage| passage.contact_loss_fraction > 0.0)
        });
        EvolutionDocument {
            first_contact_loss_passages: lifted.map(|pair| pair[0].passages),
            speed_m_per_s: self.mean_speed,
            vehicles: self.vehicles.clone(),
            step_m: self.step,
            length_m: self.profiles[0].heights_m.len() as f64 * self.spacing,
            passages: last.passages,
            mean_depth_m: last.mean_depth_m,
            track_share_cut: self.share_cut,
            stages: StagesDocument {
                passages: stages.iter().map(|stage| stage.passages).collect(),
                mean_depth_m: stages.iter().map(|stage| stage.mean_depth_m).collect(),
                support_pattern_level_db: stages.iter().map(|stage| stage.bay_mean_square_m2.map(level)).collect(),
                contact_loss_fraction: extremes(|passage| passage.contact_loss_fraction),
                minimum_normal_force_n: extremes(|passage| passage.minimum_normal_force_n),
                maximum_normal_force_n: extremes(|passage| passage.maximum_normal_force_n),
            },
            bands: self.bands(),
        }
    }

    /// The bands, the shortest wavelength first.
    pub(super) fn bands(&self) -> Vec<BandDocument> {
        let bands = self.linear.bands().iter().enumerate();
        bands.map(|(index, linear)| self.band(index, linear)).collect()
    }

    fn band(&self, index: usize, linear: &LinearBand) -> BandDocument {
        /// Part of linear growth below which a band has stopped growing.
        const STOPPED: f64 = 0.1;
        /// Level of rounding, such as of the harmonics of a sinusoid \[dB\]: a hundredth of a picometre.
        const NOTHING: f64 = -160.0;
        /// Growth below which nothing can be said \[dB\].
        const LEAST: f64 = 1.0;
        let stages = &self.stages;
        let (first, last) = (&stages[0], &stages[stages.len() - 1]);
        let power = |stage: &super::Stage| stage.mean_squares_m2[index];
        let rate = |from: f64, to: f64, passages: u64| {
            let known = passages > 0 && level(from) > NOTHING;
            known.then(|| 0.5 * (to / from).ln() / passages as f64)
        };
        let second = stages.get(1);
        let per_passage = |of: &dyn Fn(&super::Stage) -> Option<f64>| second.and_then(of);
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
        BandDocument {
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
