//! A track on discrete supports in time: its answer to an impulse where the load is then.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rayon::prelude::*;

use super::ImpulseResponse;
use super::pole_search::{PoleFit, PoleSearch};
use super::vector_fitting::{PartialFraction, Sampled, residues, shared_poles, starting_lines};
use crate::Error;
use crate::receptance::{Harmonics, MovingLoadOnSupports};

/// Bays over which the sag of the rail between supports sets in, so that a march does not begin with a blow.
pub(super) const ONSET_BAYS: f64 = 4.0;

/// What the place of the load between two supports changes of an [`ImpulseResponse`].
#[derive(Debug, Clone, PartialEq)]
pub(super) struct OverSupports {
    /// d \[m\].
    pub(super) spacing: f64,
    /// Residues of the parts that go with cos 2πnx/d and sin 2πnx/d, n = 1 … N, one for each term.
    waves: Vec<[Vec<Complex64>; 2]>,
    /// Ĥ_n(0) of a load that does not oscillate, n = 1 … N \[m/N\].
    at_rest: Vec<Complex64>,
}

impl OverSupports {
    /// Residue of a term at a place, beside its mean.
    pub(super) fn residue(&self, term: usize, place: f64) -> Complex64 {
        let turn = TAU * place / self.spacing;
        let waves = self.waves.iter().zip(1..);
        waves
            .map(|([cosines, sines], n)| {
                let (sine, cosine) = (turn * f64::from(n)).sin_cos();
                cosines[term] * cosine + sines[term] * sine
            })
            .sum()
    }

    /// Displacement under a load of one newton that does not oscillate, beside its mean over the bay \[m/N\], and its slope
    /// along the rail \[1/N\].
    pub(super) fn sag(&self, place: f64) -> [f64; 2] {
        let wavenumber = TAU / self.spacing;
        let (mut sag, mut slope) = (0.0, 0.0);
        for (harmonic, n) in self.at_rest.iter().zip(1..) {
            let wavenumber = wavenumber * f64::from(n);
            let wave = 2.0 * harmonic * Complex64::cis(wavenumber * place);
            sag += wave.re;
            slope -= wavenumber * wave.im;
        }
        [sag, slope]
    }
}

/// The answer to an impulse at x over frequency, by the parts that go with 1, cos 2πnx/d and sin 2πnx/d: all real in time.
pub(super) struct AlongBay {
    /// \[rad/s\]
    frequencies: Vec<f64>,
    parts: Vec<Vec<Complex64>>,
    /// What an error counts over.
    sizes: Vec<f64>,
}

impl ImpulseResponse {
    /// Harmonics of the bay, n = 1 … 8, that a response keeps: where the rail shears they fall like n⁻², and those left
    /// out are some 10⁻³ of the receptance.
    pub const MOST_HARMONICS: usize = 8;

    /// Frequencies \[Hz\] up to which the response is that of discrete supports, and from which on that of supports spread
    /// evenly; between them it leans on the even one, of which an error counts a twentieth there: what is free may give energy instead
    /// of taking it, and a rail of little loss swings up under a wheel. The models of the rail end at some 3 kHz.
    pub const DISCRETE_AND_EVEN: (f64, f64) = (3.5e3, 40e3);

    /// The response of a track on discrete supports under a load that passes them: where the load is at x when the impulse
    /// comes, and at x + Vt when the displacement is taken, Σ r_j(x) e^{p_j t} with r_j(x) of the period of the supports.
    ///
    /// The Fourier coefficients of x have the transfer functions Ĥ₋ₙ(ω) of [`MovingLoadOnSupports`], which share their
    /// poles: those of vector fitting of the mean and of the first two harmonics, 48 to 96, with pairs where these are off most; the residues of all are those of
    /// least squares. Frequencies lie 5 to 12 Hz apart, so that lines split by the passing of supports are seen.
    /// [`share_cut`](Self::share_cut) and [`largest_error`](Self::largest_error) are of all coefficients together over
    /// |Ĥ₀|, up to 3 kHz. Accuracy: 5·10⁻⁴ rms on viscous layers, 2·10⁻³ at the worst
    /// frequency (test `response_comes_back`). Cost: some seconds, the
    /// more the less loss the rail has.
    ///
    /// # Errors
    /// [`Error::NotCausal`] if no causal response comes near enough, and those of [`MovingLoadOnSupports::harmonics`].
    pub fn over_supports(track: &MovingLoadOnSupports) -> Result<Self, Error> {
        let transfer = AlongBay::of(track)?;
        let at_rest = track.harmonics(0.0, Self::MOST_HARMONICS)?;
        let ahead = (1..=Self::MOST_HARMONICS as isize).map(|n| at_rest.at(n));
        Self::along_bay(&transfer, ahead.collect(), track.spacing())
    }

    /// Response of an answer by its parts, with Ĥ_n(0), n = 1 …, and the support spacing \[m\].
    ///
    /// # Errors
    /// [`Error::NotCausal`] likewise.
    pub(super) fn along_bay(transfer: &AlongBay, at_rest: Vec<Complex64>, spacing: f64) -> Result<Self, Error> {
        /// Pairs counted twice.
        const POLES: [usize; 3] = [48, 72, 96];
        /// A share below, 5·10⁻⁴ rms, needs no more poles.
        const FINE: f64 = 2.5e-7;
        let discrete = TAU * Self::DISCRETE_AND_EVEN.0;
        let fit = |starting: &[Complex64]| transfer.fit(starting);
        let first = POLES.map(|order| starting_lines(transfer.band(), discrete, order));
        let search = PoleSearch::among(first.iter().map(|starting| fit(starting)), FINE, None);
        let mut fit = search.refined(fit).found()?;
        let waves = fit.parts.split_off(1);
        let residues = |fit: &Vec<PartialFraction>| fit.iter().map(PartialFraction::of_term).collect();
        let bay = OverSupports {
            spacing,
            waves: waves.chunks_exact(2).map(|pair| [residues(&pair[0]), residues(&pair[1])]).collect(),
            at_rest,
        };
        Ok(Self::new(fit.parts.remove(0), Some(bay), fit.share_cut, fit.largest_error))
    }
}

/// Partial fractions of every part, with shared poles.
struct Fit {
    parts: Vec<Vec<PartialFraction>>,
    share_cut: f64,
    largest_error: f64,
}

impl AlongBay {
    fn of(track: &MovingLoadOnSupports) -> Result<Self, Error> {
        let most = ImpulseResponse::MOST_HARMONICS;
        let samples = frequencies().into_par_iter().map(|w| {
            let harmonics = match is_discrete(w) {
                true => track.harmonics(w, most)?,
                false => Harmonics::even(track.evenly(w)),
            };
            // The coefficients of x are those of the opposite sign.
            let parts = Self::parts(|n| harmonics.at(-n));
            Ok((w, parts, harmonics.at(0).norm()))
        });
        Ok(Self::new(samples.collect::<Result<Vec<_>, Error>>()?))
    }

    /// Of frequencies \[rad/s\], the parts there and the size that an error counts over.
    pub(super) fn new(samples: Vec<(f64, Vec<Complex64>, f64)>) -> Self {
        /// What an error counts between discrete and even supports.
        const HINT: f64 = 0.05;
        let (discrete, even) = ImpulseResponse::DISCRETE_AND_EVEN;
        let mut of_bay = Self {
            frequencies: Vec::new(),
            parts: vec![Vec::new(); 2 * ImpulseResponse::MOST_HARMONICS + 1],
            sizes: Vec::new(),
        };
        for (w, parts, size) in samples {
            of_bay.frequencies.push(w);
            of_bay.sizes.push(match (discrete..even).contains(&(w / TAU)) {
                true => size / HINT,
                false => size,
            });
            for (values, value) in of_bay.parts.iter_mut().zip(parts) {
                values.push(value);
            }
        }
        of_bay
    }

    /// Parts of the answer that go with 1, cos 2πnx/d and sin 2πnx/d, by its coefficients of e^{2πinx/d}.
    pub(super) fn parts(coefficient: impl Fn(isize) -> Complex64) -> Vec<Complex64> {
        let mut parts = vec![coefficient(0)];
        for n in 1..=ImpulseResponse::MOST_HARMONICS as isize {
            let [ahead, back] = [n, -n].map(&coefficient);
            parts.push(ahead + back);
            parts.push(Complex64::I * (ahead - back));
        }
        parts
    }

    /// Whether any part is more than a share of what errors count over.
    pub(super) fn exceeds(&self, share: f64) -> bool {
        let most = share * share;
        self.parts.iter().any(|values| {
            let mut pairs = values.iter().zip(&self.sizes);
            pairs.any(|(value, size)| value.norm_sqr() > most * size * size)
        })
    }

    /// Whether another is the same, number for number.
    pub(super) fn is(&self, other: &Self) -> bool {
        self.parts == other.parts && self.sizes == other.sizes
    }

    /// Lowest and highest frequency \[rad/s\].
    fn band(&self) -> [f64; 2] {
        [self.frequencies[0], self.frequencies[self.frequencies.len() - 1]]
    }

    fn fit(&self, starting: &[Complex64]) -> PoleFit<Fit> {
        /// The mean and two harmonics give the poles.
        const STRONGEST: usize = 5;
        /// Up to here errors count \[Hz\].
        const JUDGED: f64 = 3e3;
        let Self { frequencies, parts, sizes } = self;
        let strongest: Vec<Sampled<'_>> = parts[..STRONGEST].iter().map(|values| Sampled { values, sizes }).collect();
        let poles = shared_poles(frequencies, &strongest, starting);
        let fits = residues(frequencies, parts, sizes, &poles);
        let judged = frequencies.iter().filter(|&&w| w < TAU * JUDGED).count();
        let (mut share_cut, mut largest_error) = (0.0, 0f64);
        let mut errors_there = Vec::with_capacity(judged);
        for index in 0..judged {
            let s = Complex64::new(0.0, frequencies[index]);
            let errors = fits.iter().zip(parts).map(|(fit, part)| {
                let value: Complex64 = fit.iter().map(|fraction| fraction.at(s)).sum();
                (value - part[index]).norm_sqr()
            });
            let error = errors.sum::<f64>() / sizes[index].powi(2);
            share_cut += error / judged as f64;
            largest_error = largest_error.max(error.sqrt());
            errors_there.push((frequencies[index], error.sqrt()));
        }
        PoleFit { share_cut, poles, errors: errors_there, fit: Fit { parts: fits, share_cut, largest_error } }
    }
}

/// Whether supports count one by one at an angular frequency \[rad/s\].
pub(super) fn is_discrete(angular_frequency: f64) -> bool {
    angular_frequency < TAU * ImpulseResponse::DISCRETE_AND_EVEN.0
}

/// Angular frequencies over the band \[rad/s\], close enough to each other for lines that the passing of supports splits.
pub(super) fn frequencies() -> Vec<f64> {
    let (lowest, highest) = ImpulseResponse::BAND;
    let mut hertz = lowest / TAU;
    let mut frequencies = Vec::new();
    while hertz < highest / TAU {
        frequencies.push(TAU * hertz);
        hertz += match hertz {
            ..20.0 => f64::max(0.5, 0.1 * hertz),
            ..1700.0 => 5.0,
            _ if is_discrete(TAU * hertz) => 12.0,
            _ => 0.05 * hertz,
        };
    }
    frequencies
}
