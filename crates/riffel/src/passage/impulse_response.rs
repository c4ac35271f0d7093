//! A track in time: its answer to an impulse.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::over_supports::OverSupports;
use super::pole_search::{PoleFit, PoleSearch};
use super::vector_fitting::{PartialFraction, partial_fractions};
use crate::{Error, Receptance};

/// Displacement after a force impulse, g(t) \[m/(N s)\], as a sum of decaying oscillations
/// Σ r_j e^{p_j t}, Re p_j < 0: the causal function whose receptance Σ r_j/(iω − p_j) comes nearest to that of a
/// structure.
///
/// Any receptance will do, and each term makes a convolution that needs no memory but one number, so that nothing wraps
/// round and nothing grows with the length of the run. Poles and residues are those of vector fitting over
/// [`BAND`](Self::BAND), as many as bring the rms of the relative error below 10⁻⁵, at most
/// [`MOST_POLES`](Self::MOST_POLES). Accuracy: rms 10⁻⁶ to 10⁻⁵ on tracks with viscous layers and on free beams, the √t of
/// the free beam included (tests `receptance_comes_back`, `square_root_of_the_free_beam`).
///
/// A loss factor is not causal: a structure with one moves before it is struck. No function of time has its
/// receptance; the fit then is the nearest causal one, and the mean square of the relative error, the
/// [`share_cut`](Self::share_cut), does not fall with more poles. Above [`LARGEST_SHARE_CUT`](Self::LARGEST_SHARE_CUT)
/// there is no answer. A loss factor of 0.02 in the rail cuts some 4·10⁻⁵ (0.6 % rms), one of 0.1 in
/// pad and ballast 10⁻³.
#[derive(Debug, Clone, PartialEq)]
pub struct ImpulseResponse {
    fractions: Vec<PartialFraction>,
    bay: Option<OverSupports>,
    share_cut: f64,
    largest_error: f64,
}

impl ImpulseResponse {
    /// Angular frequencies \[rad/s\] of the fit: from half a hertz, below which only slow waves of the profile move the
    /// wheel, to far above what any step of a march resolves.
    pub const BAND: (f64, f64) = (TAU * 0.5, 2e6);

    /// Poles of the largest fit, pairs counted twice.
    pub const MOST_POLES: usize = 48;

    /// Largest mean square of the relative error of the receptance.
    pub const LARGEST_SHARE_CUT: f64 = 1e-3;

    /// The response of a structure under a load at the given speed \[m/s\].
    ///
    /// # Errors
    /// [`Error::NotCausal`] if no causal response comes near enough, and [`Error::OutOfRange`] for a receptance that is not
    /// known over the band.
    pub fn of(structure: &dyn Receptance, speed: f64) -> Result<Self, Error> {
        /// Frequencies to a decade; every other one is fitted, all are compared.
        const TO_A_DECADE: f64 = 120.0;
        const LEAST_POLES: usize = 24;
        /// An rms below needs no more poles; nor does one that eight more poles do not halve.
        const FINE: f64 = 1e-5;
        const GAIN: f64 = 0.25;
        let (lowest, highest) = Self::BAND;
        let (low, high) = structure.frequency_range();
        if low > lowest || high < highest {
            return Err(Error::OutOfRange {
                quantity: "highest frequency at which the receptance is known",
                value: high / TAU,
                unit: "Hz",
                rule: "motion in time needs all frequencies: a model of the track in place of a table",
            });
        }
        let decades = (highest / lowest).log10();
        let count = (decades * TO_A_DECADE).ceil();
        let frequencies: Vec<f64> =
            (0..=count as usize).map(|index| lowest * 10f64.powf(decades * index as f64 / count)).collect();
        let values: Vec<Complex64> = frequencies.iter().map(|&w| structure.receptance(w, speed)).collect();
        if let Some(index) = values.iter().position(|value| !value.is_finite() || *value == Complex64::ZERO) {
            return Err(Error::OutOfRange {
                quantity: "frequency of a receptance that is not finite",
                value: frequencies[index] / TAU,
                unit: "Hz",
                rule: "motion in time needs all frequencies: give the track some damping",
            });
        }
        let frequencies_fitted: Vec<f64> = frequencies.iter().copied().step_by(2).collect();
        let values_fitted: Vec<Complex64> = values.iter().copied().step_by(2).collect();
        let fit = |order: usize| {
            let fractions = partial_fractions(&frequencies_fitted, &values_fitted, order);
            let mut fit = Self::new(fractions, None, 0.0, 0.0);
            let errors = frequencies.iter().zip(&values);
            for (w, value) in errors {
                let error = (fit.receptance(*w) - value).norm_sqr() / value.norm_sqr();
                fit.share_cut += error / frequencies.len() as f64;
                fit.largest_error = fit.largest_error.max(error.sqrt());
            }
            PoleFit { share_cut: fit.share_cut, poles: Vec::new(), errors: Vec::new(), fit }
        };
        let orders = (LEAST_POLES..=Self::MOST_POLES).step_by(8);
        PoleSearch::among(orders.map(fit), FINE * FINE, Some(GAIN)).found()
    }

    pub(super) fn new(
        fractions: Vec<PartialFraction>,
        bay: Option<OverSupports>,
        share_cut: f64,
        largest_error: f64,
    ) -> Self {
        Self { fractions, bay, share_cut, largest_error }
    }

    /// Its receptance \[m/N\] at the angular frequency ω \[rad/s\], on discrete supports the mean over the places of the load.
    pub fn receptance(&self, angular_frequency: f64) -> Complex64 {
        let s = Complex64::new(0.0, angular_frequency);
        self.fractions.iter().map(|fraction| fraction.at(s)).sum()
    }

    /// g \[m/(N s)\] at the time t ≥ 0 \[s\] after the impulse, on discrete supports likewise.
    pub fn at(&self, time: f64) -> f64 {
        self.terms().map(|(pole, residue)| (residue * (pole * time).exp()).re).sum()
    }

    /// Poles p and residues r of g = Σ Re(r e^{pt}), one for each pair.
    pub(super) fn terms(&self) -> impl Iterator<Item = (Complex64, Complex64)> + '_ {
        self.fractions.iter().map(|fraction| (fraction.pole, fraction.of_term()))
    }

    /// What the place of the load changes; `None` if the track is even.
    pub(super) fn bay(&self) -> Option<&OverSupports> {
        self.bay.as_ref()
    }

    /// Distance of the supports \[m\] that pass under the load.
    pub fn support_spacing(&self) -> Option<f64> {
        self.bay.as_ref().map(|bay| bay.spacing)
    }

    /// Mean square of the relative error of its receptance, over frequencies that are even on a logarithmic scale: the
    /// share of the structure's answer that is not causal, or that the fit misses.
    pub fn share_cut(&self) -> f64 {
        self.share_cut
    }

    /// Largest relative error of its receptance at any of these frequencies.
    pub fn largest_error(&self) -> f64 {
        self.largest_error
    }
}
