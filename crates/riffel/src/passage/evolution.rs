//! A profile that wears under many passages.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rayon::prelude::*;

use super::along_profile::{Roll, faded};
use super::fourier_series::{series, spectrum};
use super::patch_average::PatchAverage;
use super::{ContactInTime, ContactInstant, PassageModel};
use crate::feedback::later_of_wave;
use crate::roughness::Profile;
use crate::{EnergyWear, Error, PlaceOfWear};

/// What a passage takes off the rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WearOfPassages {
    /// Depth by energy.
    pub wear: EnergyWear,
    /// Where the energy of the wheel is left: [`PlaceOfWear`] of the linear loop, for which it is a pure shift. Not asked where
    /// the contact answers late and tells what the rail receives.
    pub place: PlaceOfWear,
    /// Waves shorter than this do not wear \[m\]: the patch, 2a, covers them.
    pub shortest: f64,
}

/// One of the wheels that pass a rail again and again, or several that are coupled: then a passage is that of one of
/// them, and takes off the mean of what they do.
#[derive(Clone)]
pub struct PassingWheel {
    /// Wheels, track and contacts, at their speed.
    pub model: PassageModel,
    /// What a wheel takes off the rail under study.
    pub wear: WearOfPassages,
    /// [`memory`](PassageModel::memory) of the model \[m\].
    pub memory: f64,
    /// Its share of the passages \[-\], of all one.
    pub share: f64,
    /// Part of these that run under traction \[-\]; the others roll free and wear nothing.
    pub traction_share: f64,
}

/// How far a rail goes at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EvolutionStep {
    /// Share by which no band of the profile changes at once \[-\].
    pub largest_change: f64,
    /// Longest step of a march \[m\].
    pub largest_step: f64,
}

impl EvolutionStep {
    /// A share of change at once that leaves a part of 10⁻³ of a growth rate: its square over six.
    pub const USUAL_CHANGE: f64 = 0.08;
}

/// A rail under one wheel after another.
///
/// The profile is a ring: the wheel that leaves its end comes to its beginning. So it has no ends to be tapered, and its
/// waves are those of a Fourier series. The energy e(x) = Qξ of a passage lowers it by k_w/(ρ 2b), and its forces by the
/// [laws of damage](super::DamageInTime) of the contact, times the part that oscillates; the mean is only counted, as [`mean_depth`](Self::mean_depth). Many passages are taken at once, by Heun's
/// method, as many as change no third-octave band by more than a share, or one at least. A band below a hundredth of
/// the profile's rms counts as that. Of several wheels the mean by their shares is taken, which is what many passages in
/// any order leave; N of them drawn one by one would scatter about it like 1/√N.
///
/// The state is the profile, what has flowed and hardened at each of its points, and the number of passages alone: every march begins
/// anew, with a run-in around the ring.
#[derive(Debug, Clone, PartialEq)]
pub struct Evolution {
    heights: Vec<f64>,
    spacing: f64,
    passages: u64,
    mean_depth: f64,
    /// What has flowed and hardened at each height \[m\]; empty for nothing.
    outflow: Vec<f64>,
}

/// Loss of contact and forces of a passage, or of one of each wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassageExtremes {
    /// Share of the time without contact \[-\], in the mean of the passages.
    pub contact_loss: f64,
    /// Least and largest normal force \[N\].
    pub normal_force: [f64; 2],
}

impl Evolution {
    /// Share of the time without contact \[-\] above which the model ends: steel yields where the wheel comes down, and the
    /// wheel does not reach the troughs.
    pub const MOST_CONTACT_LOSS: f64 = 0.5;

    /// A rail before any wheel. The profile is taken as one turn of the ring.
    pub fn new(profile: &Profile) -> Self {
        Self::resumed(profile, 0, 0.0)
    }

    /// A rail that a number of wheels have passed, which wore the mean depth given \[m\].
    pub fn resumed(profile: &Profile, passages: u64, mean_depth: f64) -> Self {
        let heights = profile.heights();
        let mean = heights.iter().sum::<f64>() / heights.len() as f64;
        Self {
            heights: match passages {
                0 => heights.iter().map(|height| height - mean).collect(),
                // To the last digit as it was.
                _ => heights.to_vec(),
            },
            spacing: profile.spacing(),
            passages,
            mean_depth,
            outflow: Vec::new(),
        }
    }

    /// Rail on which so much has flowed and hardened at each height \[m\]; empty for nothing.
    #[must_use]
    pub fn with_outflow(self, outflow: Vec<f64>) -> Self {
        Self { outflow, ..self }
    }

    /// What has flowed and hardened at each height \[m\]; empty for nothing.
    pub fn outflow(&self) -> &[f64] {
        &self.outflow
    }

    /// Heights \[m\].
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// Distance of the heights \[m\].
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Wheels so far.
    pub fn passages(&self) -> u64 {
        self.passages
    }

    /// Depth worn off everywhere \[m\].
    pub fn mean_depth(&self) -> f64 {
        self.mean_depth
    }

    /// Wavelengths \[m\] and complex amplitudes \[m\] for exp(+i2πx/λ) of the Fourier series, longest first, without the
    /// mean.
    pub fn waves(&self) -> Vec<(f64, Complex64)> {
        let length = self.heights.len() as f64 * self.spacing;
        let scale = 2.0 / self.heights.len() as f64;
        let waves = spectrum(&self.heights).into_iter().enumerate().skip(1);
        waves.map(|(n, value)| (length / n as f64, scale * value)).collect()
    }

    /// On by as many passages as the share of change allows, at most `most`; returns what the first of them was like.
    ///
    /// Cost: two marches around the ring, and over the run-in before it, for each of the wheels, on all threads.
    ///
    /// # Errors
    /// Errors of a march, and [`Error::OutOfRange`] for a ring on discrete supports that is not of whole bays;
    /// [`Error::Airborne`] is not among them: a wheel may fly.
    pub fn advance(
        &mut self,
        wheels: &[&PassingWheel],
        step: &EvolutionStep,
        most: u64,
    ) -> Result<PassageExtremes, Error> {
        for wheel in wheels {
            if let Some(spacing) = wheel.model.structures.support_spacing() {
                self.check_bays(spacing)?;
            }
        }
        let begin = [&self.heights[..], &self.outflow];
        let before = self.change(begin, wheels, step.largest_step)?;
        let contacts = wheels.iter().flat_map(|wheel| &wheel.model.contacts);
        let damages = contacts.filter_map(|contact| contact.damage.as_ref()?.hardening_rate());
        let hardens = step.largest_change / damages.fold(0.0, f64::max);
        let passages =
            self.at_once(&before.profile, step.largest_change).min(hardens.floor()).clamp(1.0, most.max(1) as f64);
        let moved = |from: &[f64], by: &[f64]| -> Vec<f64> {
            let from = from.iter().chain(std::iter::repeat(&0.0));
            let pairs = from.zip(by);
            pairs.map(|(from, rate)| from + passages * rate).collect()
        };
        let then = [moved(&self.heights, &before.profile), moved(&self.outflow, &before.outflow)];
        let after = self.change([&then[0], &then[1]], wheels, step.largest_step)?;
        let mean = |one: &[f64], other: &[f64]| -> Vec<f64> {
            let pairs = one.iter().zip(other);
            pairs.map(|(one, other)| 0.5 * (one + other)).collect()
        };
        self.heights = moved(&self.heights, &mean(&before.profile, &after.profile));
        self.outflow = moved(&self.outflow, &mean(&before.outflow, &after.outflow));
        self.mean_depth += 0.5 * passages * (before.depth + after.depth);
        self.passages += passages as u64;
        Ok(before.extremes)
    }

    /// `Ok` if the ring is of whole bays of the length given \[m\], to a part of 10⁻⁶.
    fn check_bays(&self, spacing: f64) -> Result<(), Error> {
        let bays = self.heights.len() as f64 * self.spacing / spacing;
        if (bays - bays.round()).abs() <= 1e-6 && bays > 0.5 {
            return Ok(());
        }
        Err(Error::OutOfRange {
            quantity: "length of the ring over the support spacing",
            value: bays,
            unit: "",
            rule: "must be a whole number",
        })
    }

    /// What a passage changes, in the mean of the wheels.
    fn change(&self, rail: [&[f64]; 2], wheels: &[&PassingWheel], largest_step: f64) -> Result<Change, Error> {
        let changes = wheels.par_iter().map(|wheel| self.change_by(rail, wheel, largest_step));
        let mut mean = Change {
            profile: vec![0.0; rail[0].len()],
            outflow: Vec::new(),
            depth: 0.0,
            extremes: PassageExtremes { contact_loss: 0.0, normal_force: [f64::INFINITY, f64::NEG_INFINITY] },
        };
        // One after the other, so that sums do not depend on threads.
        for (wheel, change) in wheels.iter().zip(changes.collect::<Vec<_>>()) {
            let change = change?;
            let worn = wheel.share * wheel.traction_share;
            for (sum, rate) in mean.profile.iter_mut().zip(&change.profile) {
                *sum += worn * rate;
            }
            let flowed = mean.outflow.len().max(change.outflow.len());
            mean.outflow.resize(flowed, 0.0);
            for (sum, rate) in mean.outflow.iter_mut().zip(&change.outflow) {
                *sum += worn * rate;
            }
            mean.depth += worn * change.depth;
            mean.extremes.contact_loss += wheel.share * change.extremes.contact_loss;
            let ([least, largest], [own_least, own_largest]) =
                (mean.extremes.normal_force, change.extremes.normal_force);
            mean.extremes.normal_force = [least.min(own_least), largest.max(own_largest)];
        }
        Ok(mean)
    }

    fn change_by(
        &self,
        [heights, outflow]: [&[f64]; 2],
        wheel: &PassingWheel,
        largest_step: f64,
    ) -> Result<Change, Error> {
        let PassingWheel { model, wear, .. } = wheel;
        let run_in = (wheel.memory / self.spacing).ceil();
        let substeps = (self.spacing / largest_step).ceil().max(1.0);
        let mut march = model.march_before(self.spacing / substeps, run_in * self.spacing)?;
        let count = heights.len() as isize;
        let contacts = model.contacts.iter();
        let under: Vec<Vec<PatchAverage>> =
            contacts.map(|contact| model.averages_around(contact, heights, self.spacing)).collect();
        let averaged = |contact: usize, index: isize| under[contact][index.rem_euclid(count) as usize];
        let mut roll = Roll::new(&mut march, substeps as usize, self.spacing);
        let share = |index: isize| faded(1.0 + 2.0 * (index as f64 / run_in + 0.5));
        roll.along(|contact, index| averaged(contact, index).times(share(index)), -(run_in as isize), 0, |_| ());
        roll.begin_to_count();
        let worn = model.on_rail_under_study();
        let mut instants = vec![Vec::with_capacity(heights.len()); worn.len()];
        roll.along(averaged, 0, count, |contacts| {
            for (instants, (contact, _)) in instants.iter_mut().zip(&worn) {
                instants.push(contacts[*contact]);
            }
        });
        // The first of them is at the second height, the last at the first.
        for instants in &mut instants {
            instants.rotate_right(1);
        }
        let length = heights.len() as f64 * self.spacing;
        let mut change = vec![Complex64::ZERO; heights.len() / 2 + 1];
        let mut flowed = Vec::new();
        let mut depth = 0.0;
        for (instants, (index, along)) in instants.iter().zip(&worn) {
            let contact = &model.contacts[*index];
            let energy = energy_at_rail(contact, wear, instants, &under[*index], length);
            let bent = patch_curvature(contact, heights, length);
            let mut waves = match &contact.damage {
                Some(damage) if !damage.wears() => vec![Complex64::ZERO; energy.len()],
                _ => depth_of_wear(contact, wear, instants, [&energy, &bent], length),
            };
            if let Some(damage) = &contact.damage {
                let under = moved_along(outflow, *along, length);
                let bent = match bent.is_empty() {
                    true => Vec::new(),
                    false => series(bent, heights.len()),
                };
                let [others, hardening] = damage.waves(instants, &energy, [&under, &bent], [length, model.speed]);
                for (wave, other) in waves.iter_mut().zip(others) {
                    *wave += other;
                }
                flowed.resize(hardening.len().max(flowed.len()), Complex64::ZERO);
                for (n, (sum, wave)) in flowed.iter_mut().zip(hardening).enumerate() {
                    let turn = Complex64::cis(-TAU * along * n as f64 / length);
                    if n == 0 || length / n as f64 >= wear.shortest {
                        *sum += wave * turn / worn.len() as f64;
                    }
                }
            }
            let share = (worn.len() as f64).recip();
            depth += share * waves[0].re / heights.len() as f64;
            for (n, (sum, wave)) in change.iter_mut().zip(waves).enumerate().skip(1) {
                let wavelength = length / n as f64;
                if wavelength >= wear.shortest {
                    *sum -= share * wave * Complex64::cis(-TAU * along / wavelength);
                }
            }
        }
        Ok(Change {
            profile: series(change, heights.len()),
            outflow: match flowed.is_empty() {
                true => Vec::new(),
                false => series(flowed, heights.len()),
            },
            depth,
            extremes: PassageExtremes { contact_loss: roll.contact_loss(), normal_force: roll.normal_force },
        })
    }

    /// Passages after which the first third-octave band has changed by a share.
    fn at_once(&self, rate: &[f64], share: f64) -> f64 {
        let bands = |values: &[f64]| {
            let mut bands: Vec<f64> = Vec::new();
            for (n, wave) in spectrum(values).into_iter().enumerate().skip(1) {
                let band = (10.0 * (n as f64).log10()).round() as usize;
                bands.resize(bands.len().max(band + 1), 0.0);
                bands[band] += wave.norm_sqr();
            }
            bands.into_iter().map(f64::sqrt).collect::<Vec<f64>>()
        };
        let (of_heights, of_rate) = (bands(&self.heights), bands(rate));
        let whole = of_heights.iter().map(|band| band * band).sum::<f64>().sqrt();
        let pairs = of_heights.iter().zip(&of_rate);
        pairs.map(|(height, rate)| share * height.max(0.01 * whole) / rate).fold(f64::INFINITY, f64::min).floor()
    }
}

/// Values around a ring of some length \[m\] as they are further along by a distance \[m\].
fn moved_along(values: &[f64], distance: f64, length: f64) -> Vec<f64> {
    if distance == 0.0 || values.is_empty() {
        return values.to_vec();
    }
    let waves = spectrum(values).into_iter().enumerate();
    let moved = waves.map(|(n, wave)| wave * Complex64::cis(TAU * distance * n as f64 / length));
    series(moved.collect(), values.len())
}

/// Waves of the energy that a contact leaves at the points of a ring \[J/m\], in the time of the contact; the mean as the first.
fn energy_at_rail(
    contact: &ContactInTime,
    wear: &WearOfPassages,
    instants: &[ContactInstant],
    under: &[PatchAverage],
    length: f64,
) -> Vec<Complex64> {
    let energies: Vec<f64> = instants.iter().map(|at| at.energy_at_rail).collect();
    // What of the energy is that of the wave's own geometry at constant load and slip speed, at the phase of the profile there.
    let at_once = contact.wave.as_ref().filter(|_| contact.late.is_none());
    let own: Option<Vec<Complex64>> = at_once.map(|wave| {
        let bent: Vec<f64> = under.iter().map(|averaged| averaged.curvature).collect();
        let waves = spectrum(&bent).into_iter();
        waves.map(|bent| wave.energy() * contact.profile * bent).collect()
    });
    let waves = spectrum(&energies).into_iter().enumerate();
    waves
        .map(|(n, wave)| {
            if n == 0 {
                return wave;
            }
            let wavelength = length / n as f64;
            let by_place = Complex64::cis(TAU * contact.along / wavelength);
            let own = own.as_ref().map_or(Complex64::ZERO, |own| own[n] * by_place);
            let own_later = match at_once.is_some_and(|wave| wave.is_sliding()) {
                true => Complex64::ONE,
                false => later_of_wave(wear.place.lag(wavelength)),
            };
            (wave - own) * later(contact, wear, wavelength) + own * own_later
        })
        .collect()
}

/// How what oscillates at a contact comes to the points of the rail.
fn later(contact: &ContactInTime, wear: &WearOfPassages, wavelength: f64) -> Complex64 {
    match (&contact.late, &contact.wave) {
        (Some(late), _) => Complex64::cis(TAU * late.behind() / wavelength),
        (None, Some(wave)) if wave.is_sliding() => wave.pressed(wavelength).into(),
        _ => Complex64::cis(-wear.place.lag(wavelength)),
    }
}

/// Waves of the curvature κ by which the patch of a contact changes its shape over the heights of a ring \[m\], in the time of the contact;
/// empty where the wave's own geometry has no part.
fn patch_curvature(contact: &ContactInTime, heights: &[f64], length: f64) -> Vec<Complex64> {
    let Some(wave) = &contact.wave else {
        return Vec::new();
    };
    let waves = spectrum(heights).into_iter().enumerate();
    waves
        .map(|(n, height)| {
            if n == 0 {
                return Complex64::ZERO;
            }
            let wavelength = length / n as f64;
            let by_place = Complex64::cis(TAU * contact.along / wavelength);
            wave.patch_per_metre(wavelength) * contact.profile * height * by_place
        })
        .collect()
}

/// Waves of the depth of wear \[m\] of those of the energy at the rail \[J/m\] and of the curvature of the patch; a law of regimes is linear
/// about the mean state.
fn depth_of_wear(
    contact: &ContactInTime,
    wear: &WearOfPassages,
    instants: &[ContactInstant],
    [energy, bent]: [&[Complex64]; 2],
    length: f64,
) -> Vec<Complex64> {
    let mut waves = energy.to_vec();
    if let Some(regime) = wear.wear.regime() {
        let loads: Vec<f64> = instants.iter().map(|at| at.normal_force).collect();
        let loads = spectrum(&loads).into_iter().enumerate().skip(1);
        for (wave, (n, load)) in waves[1..].iter_mut().zip(loads) {
            let later = later(contact, wear, length / n as f64);
            let own_later = match &contact.wave {
                Some(own) if own.is_sliding() => Complex64::ONE,
                _ => later,
            };
            let bent = bent.get(n).copied().unwrap_or(Complex64::ZERO);
            *wave = *wave * regime.by_energy + load * regime.by_load * later + bent * regime.by_curvature * own_later;
        }
    }
    let per_energy = wear.wear.depth_per_energy();
    waves.iter().map(|wave| wave * per_energy).collect()
}

/// What a passage changes.
struct Change {
    /// Heights \[m\].
    profile: Vec<f64>,
    /// What flows and hardens \[m\]; empty for nothing.
    outflow: Vec<f64>,
    /// Depth worn off everywhere \[m\].
    depth: f64,
    extremes: PassageExtremes,
}
