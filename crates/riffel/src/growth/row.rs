//! Ŵ₁ along a row of wavelengths at one speed: the inner loop of every map.

use std::f64::consts::PI;
use std::sync::Arc;

use num_complex::Complex64;

use crate::{Axis, FeedbackLoop, RotationRatio, Tabulated};

/// Relative accuracy of a tabulated track receptance.
const TABLE_TOLERANCE: f64 = 1e-9;

/// Columns worked on at a time: what one tile reads and writes stays in the first-level cache.
const TILE: usize = 64;

/// Evaluates the loop row by row over fixed wavelengths, with all that depends on the wavelength
/// alone done beforehand.
///
/// Holds two joints' worth of scratch for one row; make one per thread with `clone`.
#[derive(Clone)]
pub struct RowEvaluator {
    feedback: FeedbackLoop,
    columns: Arc<[Column]>,
    angular_frequencies: Vec<f64>,
    track: Vec<Complex64>,
    wheel: Vec<Complex64>,
    ratios: Vec<RotationRatio>,
}

/// What a wavelength fixes, whatever the speed.
///
/// With z = impedance and y = lever of the rotation, eliminating Ω₁ from (13), (14) leaves
/// Ŵ₁ = (by_impedance z + by_lever y/V) / ((H + H_w + 1/k_H)(z + slip y/V)).
#[derive(Clone, Copy)]
struct Column {
    /// 2π/λ \[rad/m\].
    wavenumber: f64,
    /// e_P e^{−iθ} Δ/(μP₀ξ₀).
    by_impedance: Complex64,
    /// R (e_P Q_ξ − e_ξ Q_P) e^{−iθ} Δ/(μP₀ξ₀).
    by_lever: Complex64,
    /// R Q_ξ.
    slip: Complex64,
}

impl RowEvaluator {
    /// An evaluator of the loop over the wavelengths \[m\].
    pub fn new(feedback: &FeedbackLoop, wavelengths: &[f64]) -> Self {
        let scale = feedback.amplitude / feedback.contact.steady().full_slip_energy_per_metre();
        let radius = feedback.rolling_radius;
        let column = |&wavelength: &f64| {
            let response = feedback.contact.response(wavelength);
            let phase = Complex64::cis(-feedback.place_of_wear.lag(wavelength)) * scale;
            Column {
                wavenumber: 2.0 * PI / wavelength,
                by_impedance: response.de_dp * phase,
                by_lever: (response.de_dp * response.dq_dxi - response.de_dxi * response.dq_dp)
                    * phase
                    * radius,
                slip: response.dq_dxi * radius,
            }
        };
        let columns: Arc<[Column]> = wavelengths.iter().map(column).collect();
        let blank = RotationRatio {
            lever: Complex64::ZERO,
            impedance: Complex64::ZERO,
        };
        Self {
            feedback: feedback.clone(),
            angular_frequencies: vec![0.0; TILE],
            track: vec![Complex64::ZERO; TILE],
            wheel: vec![Complex64::ZERO; TILE],
            ratios: vec![blank; TILE],
            columns,
        }
    }

    /// An evaluator for a whole map, which reads an expensive track receptance from a table good to
    /// 1e-9 where the map is large enough to repay it.
    pub(crate) fn for_map(feedback: &FeedbackLoop, wavelength: Axis, speed: Axis) -> Self {
        /// Points from which a table of some thousand receptances is a small part of the work.
        const WORTH_A_TABLE: usize = 20_000;
        let mut feedback = feedback.clone();
        if feedback.track.worth_tabulating()
            && wavelength.points() * speed.points() >= WORTH_A_TABLE
        {
            let lowest = 2.0 * PI * speed.min() / wavelength.max();
            let highest = 2.0 * PI * speed.max() / wavelength.min();
            // A resonance too sharp for a table is evaluated point by point.
            if let Ok(table) = Tabulated::new(&*feedback.track, lowest, highest, TABLE_TOLERANCE) {
                feedback.track = Arc::new(table);
            }
        }
        Self::new(&feedback, &wavelength.values())
    }

    /// Ŵ₁ of equation (20) at every wavelength for one speed \[m/s\] into `row`, whose length is
    /// that of the wavelengths.
    pub fn evaluate(&mut self, speed: f64, row: &mut [Complex64]) {
        let columns = self.columns.clone();
        for (columns, row) in columns.chunks(TILE).zip(row.chunks_mut(TILE)) {
            self.evaluate_tile(speed, columns, row);
        }
    }

    fn evaluate_tile(&mut self, speed: f64, columns: &[Column], row: &mut [Complex64]) {
        let count = columns.len();
        let frequencies = &mut self.angular_frequencies[..count];
        let track = &mut self.track[..count];
        let wheel = &mut self.wheel[..count];
        let ratios = &mut self.ratios[..count];
        for (w, column) in frequencies.iter_mut().zip(columns) {
            *w = column.wavenumber * speed;
        }
        self.feedback.track.receptances(frequencies, speed, track);
        self.feedback.wheel.receptances(frequencies, speed, wheel);
        self.feedback.rotation.ratios(frequencies, ratios);

        let contact = self.feedback.contact_stiffness.recip();
        let per_speed = speed.recip();
        for ((((value, column), track), wheel), ratio) in row
            .iter_mut()
            .zip(columns)
            .zip(&*track)
            .zip(&*wheel)
            .zip(&*ratios)
        {
            let lever = ratio.lever * per_speed;
            let numerator = column.by_impedance * ratio.impedance + column.by_lever * lever;
            let denominator = (track + wheel + contact) * (ratio.impedance + column.slip * lever);
            *value = numerator * denominator.conj() * denominator.norm_sqr().recip();
        }
    }
}
