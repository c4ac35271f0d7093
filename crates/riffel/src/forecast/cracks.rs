//! Contact fatigue beside wear along a wave, under the wheels of traffic.

use num_complex::Complex64;
use rayon::prelude::*;

use super::mean_growth::near;
use super::{LINES_PER_BAND, SpeedDistribution, band_lines};
use crate::feedback::Loop;
use crate::roughness::ThirdOctave;

/// What a passage does at one phase of a wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WavePhase {
    /// FI_surf \[-\].
    pub fatigue_index: f64,
    /// D(Tγ), below zero where wear removes cracks \[-\].
    pub damage: f64,
    /// Depth of wear \[m\].
    pub wear: f64,
    /// Growth of a crack, c_D⟨D⟩ less the wear over sin α \[m\].
    pub crack_growth: f64,
}

impl WavePhase {
    /// Names of the four phases: a wheel runs up the rising flank.
    pub const NAMES: [&'static str; 4] = ["crest", "falling-flank", "trough", "rising-flank"];

    /// All of a wave from four numbers each.
    pub(super) fn all(phases: &Phases) -> [Self; 4] {
        std::array::from_fn(|phase| Self::of(&phases[4 * phase..4 * phase + 4]))
    }

    fn of(numbers: &[f64]) -> Self {
        Self { fatigue_index: numbers[0], damage: numbers[1], wear: numbers[2], crack_growth: numbers[3] }
    }
}

/// A phase of a wave after some passages.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CrackedPhase {
    /// What a passage does there now.
    pub now: WavePhase,
    /// Length of a crack that began with none \[m\]; wear keeps it at zero if it takes off more than grows.
    pub length: f64,
}

/// All phases: four numbers each.
pub(super) type Phases = [f64; 16];

/// Cracks of the wave in the middle of each band, in the mean over the speeds of a wheel.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Cracks {
    /// Band by band, amplitude by amplitude.
    phases: Vec<Phases>,
}

/// From a smooth rail on, ten to each power of ten from 1 µm.
const AMPLITUDES: usize = 42;

fn amplitude(index: usize) -> f64 {
    match index {
        0 => 0.0,
        _ => 1e-6 * 10f64.powf((index as f64 - 1.0) / 10.0),
    }
}

impl Cracks {
    /// Crack rates of a wheel; `None` if its laws have no fatigue. `states` as in [`MeanGrowth::between`](super::MeanGrowth::between).
    pub(super) fn of(
        states: &[(f64, &[(Loop, f64)])],
        bands: &[ThirdOctave],
        speeds: &SpeedDistribution,
    ) -> Option<Self> {
        let damage = |feedback: &Loop| feedback.contacts()[0].damage.clone();
        let mut loops = states.iter().flat_map(|(_, places)| *places);
        loops.find(|(feedback, _)| damage(feedback).is_some_and(|it| it.fatigue().is_some()))?;
        let lines = band_lines(bands);
        let middles = lines.iter().skip(LINES_PER_BAND / 2).step_by(LINES_PER_BAND);
        let middles: Vec<f64> = middles.copied().collect();
        let means = speeds.means([&middles[..]], |middles, speed| {
            let of_band = |&line: &f64| -> Vec<Phases> {
                let mut sums = vec![[0.0; 16]; AMPLITUDES];
                for (index, nearness) in near(states, speed) {
                    for (feedback, weight) in states[index].1 {
                        for (index, sum) in phases(feedback, line, speed).enumerate() {
                            for (own, value) in sums[index].iter_mut().zip(sum) {
                                *own += nearness * weight * value;
                            }
                        }
                    }
                }
                sums
            };
            middles.par_iter().flat_map_iter(of_band).collect()
        });
        Some(Self { phases: means.values })
    }

    /// The mean by shares, of which those without cracks have none; `None` if all are so.
    pub(super) fn mean<'a>(parts: impl Iterator<Item = (f64, Option<&'a Self>)>) -> Option<Self> {
        let parts = parts.filter_map(|(share, it)| Some(it?.clone().covering(share)));
        parts.reduce(|mut sum, other| {
            for (own, other) in sum.phases.iter_mut().flatten().zip(other.phases.iter().flatten()) {
                *own += other;
            }
            sum
        })
    }

    /// In a share of the passages.
    pub(super) fn covering(mut self, share: f64) -> Self {
        self.phases.iter_mut().flatten().for_each(|own| *own *= share);
        self
    }

    /// The phases of a band, by its place, at an amplitude \[m\]: on straight lines between those that are known.
    pub(super) fn at(&self, band: usize, size: f64) -> Phases {
        let above = (1..AMPLITUDES - 1).find(|index| amplitude(*index) >= size);
        let above = above.unwrap_or(AMPLITUDES - 1);
        let [low, high] = [above - 1, above].map(amplitude);
        let share = ((size - low) / (high - low)).clamp(0.0, 1.0);
        let of = |index: usize| &self.phases[band * AMPLITUDES + index];
        let (low, high) = (of(above - 1), of(above));
        std::array::from_fn(|i| low[i] + share * (high[i] - low[i]))
    }
}

/// Phases of a loop at all amplitudes.
fn phases(feedback: &Loop, wavelength: f64, speed: f64) -> impl Iterator<Item = Phases> {
    let contact = feedback.contacts()[0].clone();
    let state = feedback.at(wavelength, speed).contacts[0];
    let mean = contact.mean_of_damage();
    let energy = state.energy_at_rail / feedback.amplitude();
    let index = state.damage.map_or(Complex64::ZERO, |it| it.fatigue_index);
    (0..AMPLITUDES).map(move |place| {
        let size = amplitude(place);
        let damage = contact.damage.as_ref();
        let fatigue = damage.and_then(|damage| Some((damage, damage.fatigue()?)));
        let mut phases = [0.0; 16];
        // Crest, falling flank, trough, rising flank: e^{iθ} in quarters of a turn.
        for (quarter, numbers) in phases.chunks_exact_mut(4).enumerate() {
            let turn = Complex64::I.powu(quarter as u32) * size;
            let energy = (mean.energy + (energy * turn).re).max(0.0);
            let wear = mean.wear * energy;
            if let Some((damage, fatigue)) = fatigue {
                let grown = fatigue.crack_growth * fatigue.growing().value(energy);
                numbers.copy_from_slice(&[
                    damage.demand.fatigue_index + (index * turn).re,
                    fatigue.damage().value(energy),
                    wear,
                    grown - wear / fatigue.crack_angle.sin(),
                ]);
            }
        }
        phases
    })
}
