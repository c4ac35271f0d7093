//! Ŵ₁ along a row of wavelengths at one speed: the inner loop of every map.

use std::f64::consts::PI;
use std::ops::Range;
use std::sync::Arc;

use num_complex::Complex64;
use pulp::Arch;

use crate::{Axis, FeedbackLoop, RotationRatio, Tabulated};

/// Relative accuracy of a tabulated track receptance.
const TABLE_TOLERANCE: f64 = 1e-9;

/// Columns worked on at a time: what one tile reads and writes stays in the first-level cache.
const TILE: usize = 64;

/// Evaluates the loop row by row over fixed wavelengths, with all that depends on the wavelength
/// alone done beforehand.
///
/// Method: tiles of some dozen wavelengths; in each, one dynamic call to every joint, then one pass
/// of real arithmetic over separate real and imaginary parts, which the compiler turns into the
/// widest vector instructions the machine has. Cost: below ten nanoseconds a point for the free beam.
/// Holds scratch for one tile; make one evaluator per thread with `clone`.
#[derive(Clone)]
pub struct RowEvaluator {
    feedback: FeedbackLoop,
    columns: Arc<Columns>,
    angular_frequencies: Vec<f64>,
    track: Vec<Complex64>,
    wheel: Vec<Complex64>,
    ratios: Vec<RotationRatio>,
    arch: Arch,
}

/// What each wavelength fixes, whatever the speed.
///
/// With z = impedance and y = lever of the rotation, eliminating Ω₁ from (13), (14) leaves
/// Ŵ₁ = (by_impedance z + by_lever y/V) / ((H + H_w + 1/k_H)(z + slip y/V)).
struct Columns {
    /// 2π/λ \[rad/m\].
    wavenumber: Vec<f64>,
    /// e_P e^{−iθ} Δ/(μP₀ξ₀).
    by_impedance: Parts,
    /// R (e_P Q_ξ − e_ξ Q_P) e^{−iθ} Δ/(μP₀ξ₀).
    by_lever: Parts,
    /// R Q_ξ.
    slip: Parts,
}

/// Complex numbers as two rows of real ones.
#[derive(Default)]
struct Parts {
    re: Vec<f64>,
    im: Vec<f64>,
}

impl Parts {
    fn push(&mut self, value: Complex64) {
        self.re.push(value.re);
        self.im.push(value.im);
    }

    fn tile(&self, tile: Range<usize>) -> (&[f64], &[f64]) {
        (&self.re[tile.clone()], &self.im[tile])
    }
}

impl Columns {
    fn new(feedback: &FeedbackLoop, wavelengths: &[f64]) -> Self {
        let scale = feedback.amplitude / feedback.contact.steady().full_slip_energy_per_metre();
        let radius = feedback.rolling_radius;
        let mut columns = Self {
            wavenumber: wavelengths.iter().map(|wavelength| 2.0 * PI / wavelength).collect(),
            by_impedance: Parts::default(),
            by_lever: Parts::default(),
            slip: Parts::default(),
        };
        for &wavelength in wavelengths {
            let response = feedback.contact.response(wavelength);
            let phase = Complex64::cis(-feedback.place_of_wear.lag(wavelength)) * scale;
            let cross = response.de_dp * response.dq_dxi - response.de_dxi * response.dq_dp;
            columns.by_impedance.push(response.de_dp * phase);
            columns.by_lever.push(cross * phase * radius);
            columns.slip.push(response.dq_dxi * radius);
        }
        columns
    }
}

impl RowEvaluator {
    /// An evaluator of the loop over the wavelengths \[m\].
    pub fn new(feedback: &FeedbackLoop, wavelengths: &[f64]) -> Self {
        let blank = RotationRatio {
            lever: Complex64::ZERO,
            impedance: Complex64::ZERO,
        };
        Self {
            columns: Arc::new(Columns::new(feedback, wavelengths)),
            feedback: feedback.clone(),
            angular_frequencies: vec![0.0; TILE],
            track: vec![Complex64::ZERO; TILE],
            wheel: vec![Complex64::ZERO; TILE],
            ratios: vec![blank; TILE],
            arch: Arch::new(),
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
        for (index, row) in row.chunks_mut(TILE).enumerate() {
            self.evaluate_tile(speed, index * TILE, row);
        }
    }

    fn evaluate_tile(&mut self, speed: f64, start: usize, row: &mut [Complex64]) {
        let count = row.len();
        let tile = start..start + count;
        let frequencies = &mut self.angular_frequencies[..count];
        let track = &mut self.track[..count];
        let wheel = &mut self.wheel[..count];
        let ratios = &mut self.ratios[..count];
        for (w, wavenumber) in frequencies.iter_mut().zip(&self.columns.wavenumber[tile.clone()]) {
            *w = wavenumber * speed;
        }
        self.feedback.track.receptances(frequencies, speed, track);
        self.feedback.wheel.receptances(frequencies, speed, wheel);
        self.feedback.rotation.ratios(frequencies, ratios);

        let (by_impedance_re, by_impedance_im) = self.columns.by_impedance.tile(tile.clone());
        let (by_lever_re, by_lever_im) = self.columns.by_lever.tile(tile.clone());
        let (slip_re, slip_im) = self.columns.slip.tile(tile);
        let contact = self.feedback.contact_stiffness.recip();
        let per_speed = speed.recip();
        self.arch.dispatch(
            #[inline(always)]
            || {
                for j in 0..count {
                    let by_impedance = Complex64::new(by_impedance_re[j], by_impedance_im[j]);
                    let by_lever = Complex64::new(by_lever_re[j], by_lever_im[j]);
                    let slip = Complex64::new(slip_re[j], slip_im[j]);
                    let RotationRatio { lever, impedance } = ratios[j];
                    let lever = lever * per_speed;
                    let numerator = by_impedance * impedance + by_lever * lever;
                    let denominator =
                        (track[j] + wheel[j] + contact) * (impedance + slip * lever);
                    row[j] = numerator * denominator.conj() * denominator.norm_sqr().recip();
                }
            },
        );
    }
}
