//! From the acceleration of the wheel back to roughness.

use num_complex::Complex64;

use super::AxleBoxTransfer;
use crate::contact::ContactFilter;

/// The share ε of the root mean square of the transfer over an octave from which a smaller one is raised.
pub const REGULARISATION: f64 = 0.1;

/// Step between two frequencies, as their ratio less one: a fifth of the width of a resonance of 2.5 %.
const STEP: f64 = 0.005;

/// The regularised inverse of a transfer over frequency at one speed \[s²\].
///
/// ```text
/// G = T*/(|T|² + ε²T₀²),   T₀² = mean of |T|² over the octave about the frequency,   ε = 0.1
/// ```
///
/// Where the wheel hardly moves, on a rail that gives way in its stead, 1/T makes roughness of whatever else the sensor
/// has. G is 1/T but for 1 % where |T| is T₀, 0.09 dB; it takes 6 dB off a line at which |T| is 20 dB below T₀, and more
/// below. Levels of one-third octaves can only become lower by it. Of a contact filter |F|², T is taken with √|F|².
///
/// Method: a table in steps of 0.5 %, between which G is linear; cost some thousand transfers.
#[derive(Debug, Clone)]
pub struct Inverse {
    /// Natural logarithm of the first frequency \[Hz\].
    first: f64,
    gains: Vec<Complex64>,
}

impl Inverse {
    /// The inverse from one frequency \[Hz\] to another, at a speed \[m/s\].
    pub fn new(transfer: &AxleBoxTransfer, filter: Option<ContactFilter>, speed: f64, (low, high): (f64, f64)) -> Self {
        let half_octave = (0.5 * std::f64::consts::LN_2 / STEP).round() as usize;
        let steps = ((high / low).ln() / STEP).ceil().max(1.0) as usize;
        let (lowest, highest) = transfer.known();
        let transfers: Vec<Complex64> = (0..=steps)
            .map(|step| {
                let frequency = (low * (STEP * step as f64).exp()).clamp(lowest, highest);
                let patch = filter.and_then(|filter| filter.approximate(speed / frequency).ok());
                let response = transfer.at(std::f64::consts::TAU * frequency, speed);
                response * patch.unwrap_or(1.0).sqrt()
            })
            .collect();
        let squares: Vec<f64> = transfers.iter().map(Complex64::norm_sqr).collect();
        let gains = transfers.iter().enumerate().map(|(place, transfer)| {
            let octave = place.saturating_sub(half_octave)..(place + half_octave + 1).min(steps + 1);
            let mean = squares[octave.clone()].iter().sum::<f64>() / octave.len() as f64;
            transfer.conj() / (squares[place] + REGULARISATION.powi(2) * mean)
        });
        Self { first: low.ln(), gains: gains.collect() }
    }

    /// G \[s²\] at a frequency \[Hz\]; that of the nearest end outside the table.
    pub fn gain(&self, frequency: f64) -> Complex64 {
        let last = self.gains.len() - 1;
        let place = ((frequency.ln() - self.first) / STEP).clamp(0.0, last as f64);
        let below = (place as usize).min(last.saturating_sub(1));
        let above = (below + 1).min(last);
        self.gains[below] + (self.gains[above] - self.gains[below]) * (place - below as f64)
    }
}
