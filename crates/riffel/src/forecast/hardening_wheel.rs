//! Flow that hardens under the wheels of traffic.

use num_complex::Complex64;

use super::mean_growth::near;
use super::{LINES_PER_BAND, SpeedDistribution};
use crate::damage::Flow;
use crate::feedback::Loop;

/// A wheel under which a rail flows and hardens.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct HardeningWheel {
    /// Its share of the passages \[-\].
    pub(super) share: f64,
    /// Its law, with a hardening depth.
    pub(super) flow: Flow,
    /// X₀.
    pub(super) excess: f64,
    /// u₁/Δ by line \[1/m\], in the mean over its speeds.
    pub(super) gains: Vec<Complex64>,
    /// Drift by the other laws \[rad per passage\], by line.
    pub(super) drifts: Vec<f64>,
}

/// Where flow that hardens takes a wave by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HardeningEnd {
    /// −D_h Re(u₁/Δ) in the mean of the wheels: above one the wave outgrows its hardening.
    pub runaway_number: f64,
    /// What the wave is multiplied by when flow comes to rest; `None` if it runs away.
    pub wave_ratio: Option<f64>,
}

impl HardeningWheel {
    /// That of a wheel whose flow hardens; `states` as in [`MeanGrowth::between`](super::MeanGrowth::between).
    pub(super) fn of(states: &[(f64, &[(Loop, f64)])], lines: &[f64], speeds: &SpeedDistribution) -> Option<Self> {
        let far = |state: &&(f64, &[(Loop, f64)])| (state.0 - speeds.mean()).abs();
        let (_, places) = states.iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
        let damage = places.first()?.0.contacts()[0].damage.as_ref()?;
        let flow = *damage.flow_that_hardens()?;
        let means = speeds.means(lines.chunks(LINES_PER_BAND), |lines, speed| {
            let of_line = |&line: &f64| {
                let mut sum = [0.0; 3];
                for (index, nearness) in near(states, speed) {
                    for (feedback, weight) in states[index].1 {
                        let state = feedback.at(line, speed).contacts[0].damage;
                        let Some(state) = state else { continue };
                        let laws = state.laws().filter(|law| law.name != "flow");
                        let drift: f64 = laws.map(|law| law.growth.im).sum();
                        let values = [state.demand.re, state.demand.im, drift];
                        for (sum, value) in sum.iter_mut().zip(values) {
                            *sum += nearness * weight * value;
                        }
                    }
                }
                sum
            };
            lines.iter().map(of_line).collect()
        });
        let means = &means.values;
        Some(Self {
            share: 1.0,
            flow,
            excess: damage.demand.excess(),
            gains: means.iter().map(|[re, im, _]| Complex64::new(*re, *im)).collect(),
            drifts: means.iter().map(|[_, _, drift]| *drift).collect(),
        })
    }

    /// Wheel with some of its lines under a share of the passages.
    pub(super) fn part(&self, lines: std::ops::Range<usize>, share: f64) -> Self {
        Self {
            share: share * self.share,
            gains: self.gains[lines.clone()].to_vec(),
            drifts: self.drifts[lines].to_vec(),
            ..self.clone()
        }
    }

    /// 1/D_h \[1/m\].
    pub(super) fn softening(&self) -> f64 {
        self.flow.hardening_depth.map_or(0.0, f64::recip)
    }
}

impl HardeningEnd {
    /// Of a band of lines that are equally high under some wheels: it runs away with the line that does, else its lines end together in the
    /// mean of their squares. `None` if nothing flows.
    pub(super) fn of_band(wheels: &[HardeningWheel], lines: usize) -> Option<Self> {
        let ends = (0..lines).map(|line| Self::of(wheels, line));
        let ends = ends.collect::<Option<Vec<Self>>>()?;
        let numbers = ends.iter().map(|end| end.runaway_number);
        let squares = ends.iter().map(|end| end.wave_ratio.map(|ratio| ratio * ratio));
        let square = squares.sum::<Option<f64>>();
        Some(Self {
            runaway_number: numbers.fold(f64::NEG_INFINITY, f64::max),
            wave_ratio: square.map(|sum| (sum / lines as f64).sqrt()),
        })
    }

    /// Of a line under some wheels; `None` if nothing flows.
    ///
    /// With X = X₀ + u₁ − D/D_h and r = r₀ − D a wave ends where its demand is used up, at r₀/(1 + D_h u₁/Δ); of several wheels each
    /// counts by what flows under it.
    pub(super) fn of(wheels: &[HardeningWheel], line: usize) -> Option<Self> {
        let (mut gain, mut hardened) = (Complex64::ZERO, 0.0);
        for wheel in wheels {
            let flows = wheel.share * wheel.flow.depth * wheel.flow.law.slope(wheel.excess);
            gain += flows * wheel.gains[line];
            hardened += flows * wheel.softening();
        }
        let gain = (hardened > 0.0).then(|| gain / hardened)?;
        Some(Self { runaway_number: -gain.re, wave_ratio: (gain.re > -1.0).then(|| (1.0 + gain).norm().recip()) })
    }
}
