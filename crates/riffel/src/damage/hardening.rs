//! Flow that hardens, passage after passage.

use num_complex::Complex64;

use crate::Error;

/// A profile that flows, every point of it hardening by what has left it:
/// dD/dn = H⟨X₀ + Re Σ G_j r_j e^{ijθ} − D/D_h⟩, r = r(0) − D, r_j the harmonics of r and G_j their demand per metre.
#[derive(Debug, Clone)]
pub struct Hardening {
    /// H \[m\].
    pub depth: f64,
    /// D_h \[m\].
    pub hardening_depth: f64,
    /// X₀.
    pub excess: f64,
    /// G_1, G_2 … \[1/m\].
    pub gains: Vec<Complex64>,
}

impl Hardening {
    /// Points over a wave.
    pub const POINTS: usize = 64;

    /// Outflow D \[m\] at every point after each of some rising numbers of passages, of a profile r(0) \[m\] over one wave.
    ///
    /// Method: Dormand & Prince's pair of order five, steps to the relative error 1e-10 of the largest outflow.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where steps become too many.
    pub fn march(&self, profile: &[f64], passages: &[f64]) -> Result<Vec<Vec<f64>>, Error> {
        const MOST_STEPS: usize = 1_000_000;
        const TOLERANCE: f64 = 1e-10;
        let (mut now, mut outflow) = (0.0, vec![0.0; profile.len()]);
        let mut step = 1e-3 * passages.last().copied().unwrap_or(1.0);
        let mut answers = Vec::with_capacity(passages.len());
        let mut steps = 0;
        for &until in passages {
            while now < until {
                steps += 1;
                if steps > MOST_STEPS {
                    return Err(Error::NotConverged {
                        problem: "a profile that flows and hardens",
                        residual: f64::NAN,
                        tolerance: TOLERANCE,
                        remedy: "ask for fewer passages",
                    });
                }
                let length = step.min(until - now);
                let (next, error) = self.step(profile, &outflow, length);
                let size = next.iter().fold(self.depth, |most, &d| most.max(d.abs()));
                let share = error / (TOLERANCE * size);
                if share <= 1.0 {
                    now = match length < until - now {
                        true => now + length,
                        false => until,
                    };
                    outflow = next;
                }
                step = length * (0.9 * share.max(1e-10).powf(-0.2)).clamp(0.2, 5.0);
            }
            answers.push(outflow.clone());
        }
        Ok(answers)
    }

    /// Harmonic j of values over a wave, the amplitude of e^{ijθ}.
    pub fn harmonic(values: &[f64], order: usize) -> Complex64 {
        let count = values.len();
        let turn = std::f64::consts::TAU * order as f64 / count as f64;
        let places = values.iter().enumerate();
        let sum: Complex64 = places.map(|(index, value)| value * Complex64::cis(-turn * index as f64)).sum();
        sum * (2.0 / count as f64)
    }

    fn slope(&self, profile: &[f64], outflow: &[f64]) -> Vec<f64> {
        let count = profile.len();
        let now: Vec<f64> = profile.iter().zip(outflow).map(|(r, d)| r - d).collect();
        let demands: Vec<Complex64> =
            (self.gains.iter().enumerate()).map(|(index, gain)| gain * Self::harmonic(&now, index + 1)).collect();
        let turn = std::f64::consts::TAU / count as f64;
        (outflow.iter().enumerate())
            .map(|(place, out)| {
                let wave: f64 = (demands.iter().enumerate())
                    .map(|(index, demand)| {
                        let phase = turn * ((index + 1) * place % count) as f64;
                        (demand * Complex64::cis(phase)).re
                    })
                    .sum();
                self.depth * (self.excess + wave - out / self.hardening_depth).max(0.0)
            })
            .collect()
    }

    /// One step and its error.
    fn step(&self, profile: &[f64], from: &[f64], length: f64) -> (Vec<f64>, f64) {
        const STAGES: [&[f64]; 7] = [
            &[],
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
            &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
            &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
        ];
        const ERROR: [f64; 7] =
            [71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339_200.0, 22.0 / 525.0, -1.0 / 40.0];
        let mut slopes: Vec<Vec<f64>> = Vec::with_capacity(7);
        let mut at = from.to_vec();
        for weights in STAGES {
            for (place, value) in at.iter_mut().enumerate() {
                let sum: f64 = (weights.iter().zip(&slopes)).map(|(weight, slope)| weight * slope[place]).sum();
                *value = from[place] + length * sum;
            }
            slopes.push(self.slope(profile, &at));
        }
        let error = (0..at.len()).map(|place| {
            let sum: f64 = (ERROR.iter().zip(&slopes)).map(|(weight, slope)| weight * slope[place]).sum();
            (length * sum).abs()
        });
        let error = error.fold(0.0, f64::max);
        (at, error)
    }
}
