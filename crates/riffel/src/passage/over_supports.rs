//! A track on discrete supports in time: its answer to an impulse where the load is then.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rayon::prelude::*;

use super::ImpulseResponse;
use super::vector_fitting::{PartialFraction, Sampled, residues, shared_poles, starting_lines};
use crate::Error;
use crate::receptance::{Harmonics, MovingLoadOnSupports};

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

    /// Displacement under a load of one newton that does not oscillate, beside its mean over the bay \[m/N\].
    pub(super) fn sag(&self, place: f64) -> f64 {
        let turn = TAU * place / self.spacing;
        let waves = self.at_rest.iter().zip(1..);
        waves
            .map(|(harmonic, n)| {
                2.0 * (harmonic * Complex64::from_polar(1.0, turn * f64::from(n))).re
            })
            .sum()
    }
}

/// Ĥ_n at one frequency.
struct Sample {
    w: f64,
    harmonics: Harmonics,
    /// |Ĥ₀|, and more of it where it is only a hint.
    size: f64,
}

impl Sample {
    /// Parts of the answer to an impulse at x that go with 1, cos 2πnx/d and sin 2πnx/d: all real in time.
    fn parts(&self) -> Vec<Complex64> {
        let mut parts = vec![self.harmonics.at(0)];
        for n in 1..=ImpulseResponse::MOST_HARMONICS as isize {
            let [ahead, back] = [n, -n].map(|n| self.harmonics.at(n));
            parts.push(ahead + back);
            parts.push(Complex64::I * (back - ahead));
        }
        parts
    }
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
    /// poles: those of vector fitting of the mean and of the first two harmonics, 48 to 96; the residues of all are those of
    /// least squares. Frequencies lie 5 to 12 Hz apart, so that lines split by the passing of supports are seen.
    /// [`share_cut`](Self::share_cut) and [`largest_error`](Self::largest_error) are of all coefficients together over
    /// |Ĥ₀|, up to 3 kHz. Accuracy: 5·10⁻⁴ rms on viscous layers, 2·10⁻³ at the worst
    /// frequency (test `response_comes_back`). Cost: some seconds, the
    /// more the less loss the rail has.
    ///
    /// # Errors
    /// [`Error::NotCausal`] if no causal response comes near enough, and those of [`MovingLoadOnSupports::harmonics`].
    pub fn over_supports(track: &MovingLoadOnSupports) -> Result<Self, Error> {
        /// Pairs counted twice.
        const POLES: [usize; 3] = [48, 72, 96];
        /// A share below, 5·10⁻⁴ rms, needs no more poles.
        const FINE: f64 = 2.5e-7;
        let transfer = Transfer::of(track)?;
        let mut best: Option<Fit> = None;
        for order in POLES {
            let fit = transfer.fit(order);
            if best
                .as_ref()
                .is_none_or(|best| fit.share_cut < best.share_cut)
            {
                best = Some(fit);
            }
            if best.as_ref().is_some_and(|best| best.share_cut <= FINE) {
                break;
            }
        }
        // Not a number is no share.
        let mut fit = match best {
            Some(fit) if fit.share_cut <= Self::LARGEST_SHARE_CUT => fit,
            best => {
                return Err(Error::NotCausal {
                    share: best.map_or(f64::NAN, |fit| fit.share_cut),
                    largest: Self::LARGEST_SHARE_CUT,
                });
            }
        };
        let at_rest = track.harmonics(0.0, Self::MOST_HARMONICS)?;
        let waves = fit.parts.split_off(1);
        let residues =
            |fit: &Vec<PartialFraction>| fit.iter().map(PartialFraction::of_term).collect();
        let bay = OverSupports {
            spacing: track.spacing(),
            waves: waves
                .chunks_exact(2)
                .map(|pair| [residues(&pair[0]), residues(&pair[1])])
                .collect(),
            at_rest: (1..=Self::MOST_HARMONICS as isize)
                .map(|n| at_rest.at(n))
                .collect(),
        };
        Ok(Self::new(
            fit.parts.remove(0),
            Some(bay),
            fit.share_cut,
            fit.largest_error,
        ))
    }
}

/// Transfer functions over frequency.
struct Transfer {
    frequencies: Vec<f64>,
    /// Those that go with 1, cos 2πnx/d and sin 2πnx/d.
    parts: Vec<Vec<Complex64>>,
    /// |Ĥ₀|.
    sizes: Vec<f64>,
}

/// Partial fractions of every part, with shared poles.
struct Fit {
    parts: Vec<Vec<PartialFraction>>,
    share_cut: f64,
    largest_error: f64,
}

impl Transfer {
    fn of(track: &MovingLoadOnSupports) -> Result<Self, Error> {
        let samples = samples(track)?;
        let rows: Vec<Vec<Complex64>> = samples.iter().map(Sample::parts).collect();
        Ok(Self {
            frequencies: samples.iter().map(|sample| sample.w).collect(),
            sizes: samples.iter().map(|sample| sample.size).collect(),
            parts: (0..=2 * ImpulseResponse::MOST_HARMONICS)
                .map(|part| rows.iter().map(|row| row[part]).collect())
                .collect(),
        })
    }

    fn fit(&self, order: usize) -> Fit {
        /// The mean and two harmonics give the poles.
        const STRONGEST: usize = 5;
        /// Up to here errors count \[Hz\].
        const JUDGED: f64 = 3e3;
        let discrete = TAU * ImpulseResponse::DISCRETE_AND_EVEN.0;
        let Self {
            frequencies,
            parts,
            sizes,
        } = self;
        let strongest: Vec<Sampled<'_>> = parts[..STRONGEST]
            .iter()
            .map(|values| Sampled { values, sizes })
            .collect();
        let band = [frequencies[0], frequencies[frequencies.len() - 1]];
        let starting = starting_lines(band, discrete, order);
        let poles = shared_poles(frequencies, &strongest, &starting);
        let fits = residues(frequencies, parts, sizes, &poles);
        let judged = frequencies.iter().filter(|&&w| w < TAU * JUDGED).count();
        let (mut share_cut, mut largest_error) = (0.0, 0f64);
        for index in 0..judged {
            let s = Complex64::new(0.0, frequencies[index]);
            let errors = fits.iter().zip(parts).map(|(fit, part)| {
                let value: Complex64 = fit.iter().map(|fraction| fraction.at(s)).sum();
                (value - part[index]).norm_sqr()
            });
            let error = errors.sum::<f64>() / sizes[index].powi(2);
            share_cut += error / judged as f64;
            largest_error = largest_error.max(error.sqrt());
        }
        Fit {
            parts: fits,
            share_cut,
            largest_error,
        }
    }
}

/// Ĥ_n over the band, close enough to each other for lines that the passing of supports splits.
fn samples(track: &MovingLoadOnSupports) -> Result<Vec<Sample>, Error> {
    let (lowest, highest) = ImpulseResponse::BAND;
    /// What an error counts between discrete and even supports.
    const HINT: f64 = 0.05;
    let (discrete, even) = ImpulseResponse::DISCRETE_AND_EVEN;
    let mut hertz = lowest / TAU;
    let mut frequencies = Vec::new();
    while hertz < highest / TAU {
        frequencies.push(hertz);
        hertz += match hertz {
            ..20.0 => f64::max(0.5, 0.1 * hertz),
            ..1700.0 => 5.0,
            _ if hertz < discrete => 12.0,
            _ => 0.05 * hertz,
        };
    }
    frequencies
        .into_par_iter()
        .map(|hertz| {
            let w = TAU * hertz;
            let harmonics = match hertz < discrete {
                true => track.harmonics(w, ImpulseResponse::MOST_HARMONICS)?,
                false => Harmonics::even(track.evenly(w)),
            };
            let size = harmonics.at(0).norm();
            let size = match (discrete..even).contains(&hertz) {
                true => size / HINT,
                false => size,
            };
            Ok(Sample { w, harmonics, size })
        })
        .collect()
}
