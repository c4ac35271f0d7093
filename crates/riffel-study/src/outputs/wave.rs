//! Wheels over a wave in time, as an output of a study.

use riffel::passage::{Evolution, EvolutionStep, PassageModel, PassingWheel, Settled, Sinusoid};
use riffel_case::{Case, ask};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Variable;
use super::file::WaveFile;

/// What wheels do over a wave, of the first contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WaveQuantity {
    /// First harmonic of the normal force, complex.
    NormalForceN,
    /// Least normal force.
    MinimumNormalForceN,
    /// Largest normal force.
    MaximumNormalForceN,
    /// Share of the time without contact.
    ContactLossFraction,
    /// Mean creepage along the rail.
    MeanCreepage,
    /// Mean energy dissipated per metre.
    MeanDissipationJPerM,
    /// Amplitude of the wave after the passages.
    AmplitudeM,
}

impl WaveQuantity {
    /// Its key, unit, and what it is.
    fn words(self) -> [&'static str; 3] {
        match self {
            Self::NormalForceN => ["normal_force_n", "N", "first harmonic of the normal force"],
            Self::MinimumNormalForceN => ["minimum_normal_force_n", "N", "least normal force"],
            Self::MaximumNormalForceN => ["maximum_normal_force_n", "N", "largest normal force"],
            Self::ContactLossFraction => ["contact_loss_fraction", "1", "share of the time without contact"],
            Self::MeanCreepage => ["mean_creepage", "1", "mean creepage along the rail"],
            Self::MeanDissipationJPerM => ["mean_dissipation_j_per_m", "J/m", "mean energy dissipated per metre"],
            Self::AmplitudeM => ["amplitude_m", "m", "amplitude of the wave"],
        }
    }
}

impl WaveFile {
    /// The arrays of a wave whose names begin with `name`.
    pub(super) fn variables(&self, name: &str) -> impl Iterator<Item = Variable> {
        let after = match self.passages {
            Some(passages) => format!(" worn by {passages} passages"),
            None => String::new(),
        };
        self.quantities.iter().map(move |quantity| {
            let [key, unit, words] = quantity.words();
            Variable {
                name: format!("{name}_{key}"),
                dimensions: Vec::new(),
                complex: *quantity == WaveQuantity::NormalForceN,
                unit,
                description: format!(
                    "{words} over a wave of {} and {}{after} at {}",
                    self.wavelength, self.amplitude, self.speed
                ),
            }
        })
    }

    /// Its numbers on a case, or why there are none.
    pub(super) fn evaluate(&self, case: &Case, values: &mut Vec<f64>) -> Result<(), String> {
        let speed = self.speed.si();
        let mut wave = Sinusoid { amplitude: self.amplitude.si(), wavelength: self.wavelength.si() };
        let steps = wave.usual_steps(speed);
        if steps > Sinusoid::MOST_STEPS {
            return Err(
                "the wave passes in more than 0.65 s: what is slower is followed by the whole vehicle".to_owned()
            );
        }
        let model = match self.passages {
            None => ask::in_time(case, speed).map_err(|error| error.to_string())?,
            Some(passages) => {
                let wheel = ask::passing_wheel(case, speed);
                let wheel = wheel.map_err(|error| error.to_string())?;
                let worn = worn(&wheel, wave, steps, passages);
                wave.amplitude = worn.map_err(|error| error.to_string())?;
                wheel.model
            }
        };
        let needs_time = |quantity: &WaveQuantity| *quantity != WaveQuantity::AmplitudeM;
        let settled = match self.quantities.iter().any(needs_time) {
            true => Some(first(&model, wave, steps).map_err(|error| error.to_string())?),
            false => None,
        };
        for quantity in &self.quantities {
            match (quantity, &settled) {
                (WaveQuantity::AmplitudeM, _) | (_, None) => values.push(wave.amplitude),
                (WaveQuantity::NormalForceN, Some(settled)) => {
                    let force = settled.harmonics[1].normal_force;
                    values.extend([force.re, force.im]);
                }
                (WaveQuantity::MinimumNormalForceN, Some(settled)) => {
                    values.push(settled.normal_force[0]);
                }
                (WaveQuantity::MaximumNormalForceN, Some(settled)) => {
                    values.push(settled.normal_force[1]);
                }
                (WaveQuantity::ContactLossFraction, Some(settled)) => {
                    values.push(settled.contact_loss);
                }
                (WaveQuantity::MeanCreepage, Some(settled)) => {
                    values.push(settled.harmonics[0].creepage.re);
                }
                (WaveQuantity::MeanDissipationJPerM, Some(settled)) => {
                    values.push(settled.harmonics[0].dissipation.re);
                }
            }
        }
        Ok(())
    }
}

/// The settled state of the first contact.
fn first(model: &PassageModel, wave: Sinusoid, steps: usize) -> Result<Settled, riffel::Error> {
    Ok(model.settle(wave, steps)?.swap_remove(0))
}

/// Amplitude of the first harmonic of a wave after some passages \[m\], on a [ring](Sinusoid::ring). A wheel that is in the air for more
/// than half of a passage ends it.
fn worn(wheel: &PassingWheel, wave: Sinusoid, steps: usize, passages: u64) -> Result<f64, riffel::Error> {
    let ring = wave.ring(wheel.model.structures.support_spacing())?;
    let mut rail = Evolution::new(&ring);
    let length = rail.heights().len() as f64 * rail.spacing();
    let waves = (length / wave.wavelength).round() as usize;
    let step =
        EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: wave.wavelength / steps as f64 };
    while rail.passages() < passages {
        let extremes = rail.advance(&[wheel], &step, passages - rail.passages())?;
        if extremes.contact_loss > Evolution::MOST_CONTACT_LOSS {
            break;
        }
    }
    Ok(rail.waves()[waves - 1].1.norm())
}
