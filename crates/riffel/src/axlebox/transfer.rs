//! From roughness to the acceleration of the wheel.

use num_complex::Complex64;

use crate::Loop;

/// T = a/r \[1/s²\]: upward acceleration of the wheel by the roughness between wheel and rail, upward as well.
///
/// The force P = r/(H_r + H_w + 1/k_H) presses the rail down by H_rP and the wheel up by H_wP, so that
///
/// ```text
/// T = −ω² H_w/(H_r + H_w + 1/k_H)
/// ```
///
/// Limits: T → −ω² where the wheel is the softest of the three, at low frequencies: it follows the rail. T → 1/(m_w(H_r +
/// 1/k_H)) for a mass m_w far above its resonance on contact and rail. The axle box is taken to move as the wheel does at
/// the contact, which a rigid wheel does; modes of the wheel's web, of the axle and of the box are no part of it.
///
/// Where supports are discrete, |T|² is its mean over a bay, and the phase that of the mean of T.
#[derive(Clone)]
pub struct AxleBoxTransfer {
    /// The loop at places of a bay, with weights that sum to one.
    places: Vec<(Loop, f64)>,
    /// \[Hz\].
    known: (f64, f64),
}

impl AxleBoxTransfer {
    /// The transfer of a loop at some places with their weights, which sum to one. `known` are the lowest and highest
    /// frequency \[Hz\] at which the receptances are known.
    pub fn new(places: Vec<(Loop, f64)>, known: (f64, f64)) -> Self {
        Self { places, known }
    }

    /// Lowest and highest frequency \[Hz\] at which the transfer is known.
    pub fn known(&self) -> (f64, f64) {
        self.known
    }

    /// T \[1/s²\] at an angular frequency \[rad/s\] and a speed \[m/s\].
    pub fn at(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        let (mut mean, mut square) = (Complex64::ZERO, 0.0);
        for (feedback, weight) in &self.places {
            let [rail, wheel] = feedback.normal_receptances(angular_frequency, speed);
            let compliance = rail + wheel + feedback.contacts()[0].stiffness.recip();
            let transfer = -angular_frequency.powi(2) * wheel / compliance;
            mean += *weight * transfer;
            square += weight * transfer.norm_sqr();
        }
        match mean.norm() {
            0.0 => Complex64::ZERO,
            size => mean * (square.sqrt() / size),
        }
    }
}
