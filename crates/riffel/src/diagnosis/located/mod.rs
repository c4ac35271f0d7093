//! Where along a rail its dominant wavelengths stand.

use std::ops::Range;

use rayon::prelude::*;

use super::dominant::{MOST, harmonic};
use super::{DominantWavelength, FineSpectrum};
use crate::Error;
use crate::roughness::{
    BandPass, PIT_DEPTH, Profile, RailDefect, SpikeCriterion, WHEEL_RADIUS, WavelengthBand, moving_rms,
};

/// Length of the windows in which a dominant wavelength is looked for \[m\]: five segments of 10 m, of which nine
/// that overlap are averaged, so that wavelengths differ by 0.1/m and levels scatter by 1 dB.
pub const WINDOW: f64 = 50.0;
/// Windows shorter than this, at stretches that are, say too little \[m\].
const SHORTEST_WINDOW: f64 = 10.0;
/// Length over which the power of a wavelength is averaged to find its ends \[m\]: no place is told shorter.
const SMOOTHING: f64 = 5.0;
/// Length of averaging in wavelengths, so that the power of noise scatters by a quarter.
const SMOOTHED_WAVES: f64 = 50.0;
/// How far the wavelengths of a peak are widened to filter it out of the profile.
const WIDENED: f64 = 1.1;
/// Share of a rail on which a wavelength stands all along.
const ALL_ALONG: f64 = 0.9;
/// Waves over which the power of a wave is averaged to see whether it lasts.
const LASTING_WAVES: f64 = 3.0;
/// Share of a place on which this must be a quarter of its mean or more: a single event has its power in one spot.
const LASTING: f64 = 0.5;
/// Waves with that power that are enough on a place of any length: corrugation may stand in bursts.
const LASTING_IN_BURSTS: f64 = 20.0;
/// Good length between two places of one wavelength that are one \[m\].
const APART: f64 = 10.0;

/// A length of rail on which a wavelength stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Where it begins \[m\].
    pub from: f64,
    /// Where it ends \[m\].
    pub to: f64,
    /// Level of the wavelength there \[dB re 1 µm\].
    pub level: f64,
}

impl Place {
    /// Whether two lists of places have a length of rail in common.
    pub fn any_shared(some: &[Self], others: &[Self]) -> bool {
        let shares = |a: &Self| others.iter().any(|b| a.from < b.to && b.from < a.to);
        some.iter().any(shares)
    }
}

/// A dominant wavelength with where it stands.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct LocatedWavelength {
    /// Wavelength and level at the first place; prominence and false peaks are those of the window, or of the
    /// whole rail, that shows it best.
    pub peak: DominantWavelength,
    /// The places, the highest level first; the whole rail where it stands all along.
    pub places: Vec<Place>,
    /// Whether it stands all along the rail.
    pub all_along: bool,
}

/// Decibels of a peak over its level on the rail from which the wheel makes it: twice the power.
const MADE_BY_WHEEL: f64 = 3.0;

/// A rail without spikes and single defects, and what the wheel sees of it after EN 15610.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct CleanRail {
    on_rail: Vec<Profile>,
    on_wheel: Vec<Profile>,
    defects: Vec<RailDefect>,
}

/// A peak of a window.
struct Seed {
    peak: DominantWavelength,
    stretch: usize,
    samples: Range<usize>,
}

impl CleanRail {
    /// The stretches of one rail, cleaned of spikes and of [defects](Self::defects), and the same rolled over by the wheel.
    pub fn new(stretches: Vec<Profile>) -> Self {
        let mut clean = Self::with_defects(stretches);
        for (on_rail, on_wheel) in clean.on_rail.iter_mut().zip(&mut clean.on_wheel) {
            // What the wheel bridges is no defect to it.
            let defects = on_wheel.bridge_defects(None);
            for defect in &defects {
                on_rail.bridge_between(defect.from, defect.to);
            }
            clean.defects.extend(defects);
        }
        clean
    }

    /// Stretches of one rail with its welds, joints and squats.
    pub fn with_defects(mut stretches: Vec<Profile>) -> Self {
        for stretch in &mut stretches {
            stretch.remove_spikes(SpikeCriterion::EN_15610);
        }
        let mut on_wheel = stretches.clone();
        for stretch in &mut on_wheel {
            stretch.roll_over(WHEEL_RADIUS, PIT_DEPTH);
        }
        Self { on_rail: stretches, on_wheel, defects: Vec::new() }
    }

    /// The welds, joints and squats that were replaced by straight lines ([`Profile::bridge_defects`]), in order.
    pub fn defects(&self) -> &[RailDefect] {
        &self.defects
    }

    /// The stretches of the rail itself, so cleaned.
    pub fn into_stretches(self) -> Vec<Profile> {
        self.on_rail
    }

    /// Length of rail \[m\].
    pub fn length(&self) -> f64 {
        self.on_wheel.iter().map(Profile::length).sum()
    }

    /// The spectrum of the whole rail as the wheel sees it.
    ///
    /// # Errors
    /// Errors of [`FineSpectrum::of_record`].
    pub fn spectrum(&self) -> Result<FineSpectrum, Error> {
        FineSpectrum::of_record(&self.on_wheel)
    }

    /// The spectrum between two positions \[m\]; `None` if less than half of that length was measured.
    pub fn spectrum_between(&self, from: f64, to: f64) -> Option<FineSpectrum> {
        let stretches = self.on_wheel.iter();
        let parts: Vec<Profile> = stretches.filter_map(|stretch| stretch.between(from, to)).collect();
        let length: f64 = parts.iter().map(Profile::length).sum();
        (length >= 0.5 * (to - from)).then(|| FineSpectrum::of_record(&parts).ok()).flatten()
    }

    /// The wavelengths that stand out, along the whole rail or on a part of it; the most prominent first, six at
    /// most.
    ///
    /// Method: peaks of the spectrum of the whole rail ([`FineSpectrum::dominant`]), and of windows of 50 m every
    /// 25 m where the rail is 100 m long or longer, so far out that noise has such a peak in one rail of a
    /// hundred. Where one stands follows from the profile, filtered about its wavelengths: the length around the
    /// highest mean square, over 5 m or fifty waves, on which this is more than half of its own mean over that
    /// length, and each other length with half of the highest such mean or more. A wavelength is told by its places
    /// unless these are nine tenths of the rail. It must last there: its power over three waves is a quarter of its
    /// mean or more on half of the place or on twenty waves, and it must stand out of a place longer than a window as well as of the window that showed it. A peak must stand out of the rail as well as of what the wheel sees, at half the
    /// power there or more: edges of pits have waves of their
    /// own, which the wheel bridges, and the wheel rounds the troughs of corrugation, which makes harmonics of its
    /// own. Ends of a place are found to a metre or so, and places shorter than 5 m are shown as long as that.
    ///
    /// # Errors
    /// Errors of [`FineSpectrum::of_record`].
    pub fn dominant(&self) -> Result<Vec<LocatedWavelength>, Error> {
        let whole = self.spectrum()?;
        let mut overall = on_both(&FineSpectrum::of_record(&self.on_rail)?, &whole, 1);
        let mut found = Vec::new();
        for group in self.groups() {
            let leader = &group[0].peak;
            let same = overall.iter().position(|peak| overlap(peak, leader));
            let along = same.map(|index| overall.swap_remove(index));
            let places = self.places(leader, &group)?;
            found.extend(self.told(leader, along, places));
        }
        for peak in overall {
            let places = self.places(&peak, &[])?;
            found.extend(self.told(&peak.clone(), Some(peak), places));
        }
        found.sort_by(|a, b| b.peak.prominence.total_cmp(&a.peak.prominence));
        found.truncate(MOST);
        let all = found.clone();
        for one in &mut found {
            let beside = (all.iter()).filter(|other| Place::any_shared(&other.places, &one.places));
            let peaks: Vec<DominantWavelength> = beside.map(|other| other.peak.clone()).collect();
            one.peak.harmonic_of = harmonic(&one.peak, &peaks);
        }
        Ok(found)
    }

    /// Peaks of the windows by wavelength, the most prominent first.
    fn groups(&self) -> Vec<Vec<Seed>> {
        let windows = self.windows();
        let count = windows.len();
        let seeds = windows.into_par_iter().flat_map_iter(|(stretch, samples)| {
            let part = |of: &[Profile]| {
                let profile = &of[stretch];
                let heights = profile.heights()[samples.clone()].to_vec();
                let part = Profile::new(profile.position(samples.start), profile.spacing(), heights);
                part.and_then(|part| FineSpectrum::of_record(&[part])).ok()
            };
            // The rail itself is looked at where the wheel sees something.
            let wheel = part(&self.on_wheel).filter(|wheel| !wheel.dominant_among(count).is_empty());
            let both = wheel.and_then(|wheel| Some(on_both(&part(&self.on_rail)?, &wheel, count)));
            let samples = samples.clone();
            both.unwrap_or_default().into_iter().map(move |peak| Seed { peak, stretch, samples: samples.clone() })
        });
        let mut seeds: Vec<Seed> = seeds.collect();
        seeds.sort_by(|a, b| b.peak.prominence.total_cmp(&a.peak.prominence));
        let mut groups: Vec<Vec<Seed>> = Vec::new();
        for seed in seeds {
            match groups.iter_mut().find(|group| overlap(&group[0].peak, &seed.peak)) {
                Some(group) => group.push(seed),
                None => groups.push(vec![seed]),
            }
        }
        groups.truncate(MOST);
        groups
    }

    /// Windows by stretch, half overlapping; the last ends where its stretch ends.
    fn windows(&self) -> Vec<(usize, Range<usize>)> {
        if self.length() < 2.0 * WINDOW {
            return Vec::new();
        }
        let mut windows = Vec::new();
        for (index, stretch) in self.on_wheel.iter().enumerate() {
            let count = stretch.heights().len();
            let window = ((WINDOW / stretch.spacing()).round() as usize).clamp(1, count);
            if stretch.length() < SHORTEST_WINDOW {
                continue;
            }
            let last = count - window;
            let starts = (0..last).step_by(window.div_ceil(2)).chain([last]);
            windows.extend(starts.map(|start| (index, start..start + window)));
        }
        windows
    }

    /// Where a wavelength stands, the highest level first: around the highest power in each of its windows, or on
    /// the whole rail if it has none.
    fn places(&self, peak: &DominantWavelength, seeds: &[Seed]) -> Result<Vec<Place>, Error> {
        let spacing = self.on_wheel[0].spacing();
        let band = WavelengthBand::new(peak.from / WIDENED, peak.to * WIDENED)?;
        let samples = (SMOOTHING.max(SMOOTHED_WAVES * peak.wavelength) / spacing).round() as usize;
        let wave = peak.wavelength / spacing;
        let (mut powers, mut filtered_rails) = (Vec::new(), Vec::new());
        for stretch in &self.on_wheel {
            let bank = BandPass::new(spacing, stretch.heights().len(), &[band])?;
            let filtered = bank.filter(stretch).swap_remove(0);
            powers.push(smoothed(&filtered, samples));
            filtered_rails.push(filtered);
        }
        let mut found: Vec<(usize, Range<usize>)> = Vec::new();
        let mut highest_mean = 0.0;
        for seed in seeds {
            let (power, stretch) = (&powers[seed.stretch], seed.stretch);
            let at = seed.samples.start + highest(&power[seed.samples.clone()]);
            let place = around(power, at);
            highest_mean = f64::max(highest_mean, mean(&power[place.clone()]));
            found.push((stretch, place));
        }
        for seed in seeds {
            let window = seed.samples.clone();
            let more = runs(&powers[seed.stretch], window, 0.5 * highest_mean);
            found.extend(more.into_iter().map(|run| (seed.stretch, run)));
        }
        if seeds.is_empty() {
            let tops = powers.iter().enumerate().map(|(stretch, power)| {
                let at = highest(power);
                (stretch, at, power[at])
            });
            let top = tops.max_by(|a, b| a.2.total_cmp(&b.2));
            found.extend(top.map(|(stretch, at, _)| (stretch, around(&powers[stretch], at))));
        }
        let mut places: Vec<Place> = joined(found, (APART / spacing) as usize)
            .into_iter()
            .filter(|(stretch, samples)| lasts(&filtered_rails[*stretch][samples.clone()], wave))
            .map(|(stretch, samples)| {
                let profile = &self.on_wheel[stretch];
                let (from, to) = (profile.position(samples.start), profile.position(samples.end));
                let level = self.level(from, to, peak);
                Place { from, to, level }
            })
            .collect();
        places.sort_by(|a, b| b.level.total_cmp(&a.level));
        Ok(places)
    }

    /// Level of a peak at a place \[dB re 1 µm\].
    fn level(&self, from: f64, to: f64, peak: &DominantWavelength) -> f64 {
        let spectrum = self.spectrum_between(from, to);
        spectrum.map_or(f64::NEG_INFINITY, |spectrum| {
            let own = peak_near(&spectrum, peak);
            own.map_or_else(|| spectrum.level_between(peak.from, peak.to).0, |own| own.level)
        })
    }

    /// A peak with the places that tell most of it: its own, or the whole rail.
    fn told(
        &self,
        peak: &DominantWavelength,
        along: Option<DominantWavelength>,
        places: Vec<Place>,
    ) -> Option<LocatedWavelength> {
        let covered: f64 = places.iter().map(|place| place.to - place.from).sum();
        let highest = *places.first()?;
        let all_along = covered >= ALL_ALONG * self.length();
        if let Some(along) = along.filter(|_| all_along) {
            let first = self.on_wheel.first()?;
            let last = self.on_wheel.last()?;
            return Some(LocatedWavelength {
                places: vec![Place { from: first.start(), to: last.start() + last.length(), level: along.level }],
                peak: along,
                all_along: true,
            });
        }
        let there = self.spectrum_between(highest.from, highest.to)?;
        let own = peak_near(&there, peak);
        if own.is_none() && highest.to - highest.from > WINDOW {
            return None;
        }
        let own = own.unwrap_or_else(|| peak.clone());
        Some(LocatedWavelength {
            peak: DominantWavelength {
                level: highest.level,
                prominence: peak.prominence,
                scatter: peak.scatter,
                false_peaks: peak.false_peaks,
                ..own
            },
            places,
            all_along: false,
        })
    }
}

/// The peak of a spectrum at the wavelengths of another.
fn peak_near(spectrum: &FineSpectrum, peak: &DominantWavelength) -> Option<DominantWavelength> {
    let peaks = spectrum.dominant();
    peaks.into_iter().find(|own| overlap(own, peak))
}

/// Peaks of what the wheel sees that stand out of the rail as well, and are there at no more than twice the power: what is more, the
/// wheel makes.
fn on_both(rail: &FineSpectrum, wheel: &FineSpectrum, spectra: usize) -> Vec<DominantWavelength> {
    let on_rail = rail.dominant_among(spectra);
    let mut peaks = wheel.dominant_among(spectra);
    peaks.retain(|peak| {
        let there = rail.level_between(peak.from, peak.to).0;
        on_rail.iter().any(|other| overlap(other, peak)) && peak.level <= there + MADE_BY_WHEEL
    });
    peaks
}

/// Whether two peaks are one: spectra of other segments have other bands, so that half powers differ by a band.
fn overlap(one: &DominantWavelength, other: &DominantWavelength) -> bool {
    /// Ratio of the edges of a band of 1/24 octave.
    const BAND: f64 = 1.03;
    one.from <= BAND * other.to && other.from <= BAND * one.to
}

/// Mean squares over so many samples around each sample; those of the first and last window hold to the ends.
fn smoothed(heights: &[f64], window: usize) -> Vec<f64> {
    let window = window.clamp(1, heights.len());
    let rms = moving_rms(heights, window);
    let before = (window - 1) / 2;
    (0..heights.len()).map(|index| rms[index.saturating_sub(before).min(rms.len() - 1)].powi(2)).collect()
}

/// Whether a filtered wave lasts over a place, or for twenty waves: moving power over three waves against its mean. `wave` is its length
/// in samples.
fn lasts(heights: &[f64], wave: f64) -> bool {
    let power = smoothed(heights, (LASTING_WAVES * wave).round() as usize);
    let mean = mean(&power);
    let lasting = power.iter().filter(|power| **power >= 0.25 * mean).count();
    lasting as f64 >= (LASTING * power.len() as f64).min(LASTING_IN_BURSTS * wave)
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn highest(values: &[f64]) -> usize {
    let places = 0..values.len();
    places.max_by(|&a, &b| values[a].total_cmp(&values[b])).unwrap_or(0)
}

/// The samples around a highest one on which the power is more than half of its mean over all of them.
fn around(power: &[f64], at: usize) -> Range<usize> {
    /// Rounds, of which each lowers the mean and widens the place; two or three are usual.
    const ROUNDS: usize = 50;
    let (mut place, mut mean) = (at..at + 1, power[at]);
    for _ in 0..ROUNDS {
        let low = |value: &f64| *value < 0.5 * mean;
        let from = power[..at].iter().rposition(low).map_or(0, |low| low + 1);
        let to = power[at..].iter().position(low).map_or(power.len(), |low| at + low.max(1));
        if place == (from..to) {
            break;
        }
        place = from..to;
        mean = self::mean(&power[place.clone()]);
    }
    place
}

/// Runs of samples with enough power that have a sample in a window; told from end to end, also beyond the window.
fn runs(power: &[f64], window: Range<usize>, enough: f64) -> Vec<Range<usize>> {
    let is_low = |value: &f64| *value < enough;
    let mut runs = Vec::new();
    let mut next = window.start;
    while let Some(at) = (next..window.end).find(|&at| !is_low(&power[at])) {
        let from = power[..at].iter().rposition(is_low).map_or(0, |low| low + 1);
        let low = power[at..].iter().position(is_low);
        let to = low.map_or(power.len(), |low| at + low);
        runs.push(from..to);
        next = to;
    }
    runs
}

/// Places of one stretch that lie no further apart than some samples as one.
fn joined(mut places: Vec<(usize, Range<usize>)>, gap: usize) -> Vec<(usize, Range<usize>)> {
    places.sort_by_key(|(stretch, samples)| (*stretch, samples.start));
    let mut joined: Vec<(usize, Range<usize>)> = Vec::new();
    for (stretch, samples) in places {
        match joined.last_mut() {
            Some((last, known)) if *last == stretch && samples.start <= known.end + gap => {
                known.end = known.end.max(samples.end);
            }
            _ => joined.push((stretch, samples)),
        }
    }
    joined
}

#[cfg(test)]
mod tests;
