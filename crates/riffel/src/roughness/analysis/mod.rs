//! Everything about the roughness of one rail, in one call.

use rayon::prelude::*;

use super::few_lines::KeptLines;
use super::judged_section::{Piece, pieces};
use super::method_a::RecordLevels;
use super::{
    BandPass, BandSettings, BandStatistics, GrindSection, GrindSettings, PIT_DEPTH, Profile, RailDefect, RmsLimit,
    SectionSpectrum, Spectrum, SpikeCriterion, ThirdOctave, WHEEL_RADIUS, WavelengthBand, grind_sections, level,
    mean_square, stretch_numbers,
};
use crate::Error;

/// What to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct AnalysisSettings {
    /// Longest wavelength of the spectrum \[m\].
    pub longest_wavelength: f64,
    /// Bands of the statistics.
    pub bands: Vec<WavelengthBand>,
    /// Length of the moving window \[m\]; None takes that of each band.
    pub window: Option<f64>,
    /// Length of the blocks \[m\].
    pub block: f64,
    /// Limit of the moving RMS.
    pub limit: Option<RmsLimit>,
    /// The wavelengths of a profile that is what a wheel has felt of the rail: other bands are left out, no spikes are
    /// removed, and nothing is rolled over once more. None for the rail itself.
    pub known_band: Option<WavelengthBand>,
    /// Whether [defects](RailAnalysis::defects) are left out of the levels; they stay in statistics.
    pub without_defects: bool,
    /// Whether each section of 100 m is given its levels, which cost as much as all else.
    pub section_levels: bool,
}

impl Default for AnalysisSettings {
    /// Wavelengths up to 2 m, the bands of grinding, blocks of 10 m, no limit.
    fn default() -> Self {
        Self {
            longest_wavelength: 2.0,
            bands: WavelengthBand::GRINDING.to_vec(),
            window: None,
            block: 10.0,
            limit: None,
            known_band: None,
            without_defects: false,
            section_levels: false,
        }
    }
}

/// The roughness of one rail.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct RailAnalysis {
    /// Number of spikes removed.
    pub spikes: usize,
    /// Number of pits that the wheel bridges.
    pub pits: usize,
    /// Welds, joints and squats ([`Profile::bridge_defects`]); none are looked for where no band is asked for and levels have
    /// them.
    pub defects: Vec<RailDefect>,
    /// Energy-averaged one-third-octave levels after EN 15610.
    pub spectrum: Spectrum,
    /// The levels of each section of 100 m; empty if there is one section, or they are not asked for.
    pub section_spectra: Vec<SectionSpectrum>,
    /// Length of a segment for the longest wavelengths \[m\].
    pub segment_length: f64,
    /// Number of such segments.
    pub segments: usize,
    /// Statistics of each band that some stretch is long enough for.
    pub bands: Vec<BandSummary>,
    /// RMS of consecutive blocks.
    pub blocks: Vec<BlockRms>,
    /// Where a band is over its limit, each on its own.
    pub over_limit: Vec<GrindSection>,
    /// Where each stretch without gaps begins and ends \[m\], in the order of travel.
    pub stretches: Vec<(f64, f64)>,
}

/// A band over the whole rail.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct BandSummary {
    /// The band.
    pub band: WavelengthBand,
    /// Length of the moving window \[m\].
    pub window: f64,
    /// Length of rail that counts \[m\]: stretches of at least four of the longest wavelength.
    pub length: f64,
    /// RMS over this length \[m\].
    pub rms: f64,
    /// Largest moving RMS \[m\].
    pub moving_rms_max: f64,
    /// Largest moving peak-to-peak value \[m\], one of the longest wavelength away from the ends.
    pub peak_to_peak_max: f64,
    /// Limit of the moving RMS \[m\].
    pub limit: Option<f64>,
    /// Share of the length over the limit \[-\], if there is one.
    pub share_over_limit: Option<f64>,
}

/// RMS of one block.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct BlockRms {
    /// Where it begins \[m\].
    pub from: f64,
    /// Where it ends \[m\].
    pub to: f64,
    /// RMS \[m\] by band, in the order of the settings; `None` if the stretch is too short for the band.
    pub rms: Vec<Option<f64>>,
    /// Largest moving RMS \[m\] by band of windows with their middle in the block.
    pub moving_rms_max: Vec<Option<f64>>,
}

impl RailAnalysis {
    /// Spikes, pits and levels of EN 15610, and the statistics of grinding, for the stretches of one rail.
    ///
    /// Levels are those of the profile without spikes that the wheel has rolled over; band statistics
    /// those of the profile without spikes, pits included, for they are on the rail. `progress` is told
    /// of each of [`steps`](Self::steps).
    ///
    /// # Errors
    /// Errors of [`Spectrum::of_record`].
    pub fn new(
        mut stretches: Vec<Profile>,
        settings: &AnalysisSettings,
        progress: &(dyn Fn() + Sync),
    ) -> Result<Self, Error> {
        let (mut spikes, mut pits) = (0, 0);
        let mut statistics = vec![Vec::new(); settings.bands.len()];
        let mut blocks = Vec::new();
        let (mut over_limit, mut defects) = (Vec::new(), Vec::new());
        let end = |stretch: &Profile| stretch.start() + stretch.length();
        let ends: Vec<(f64, f64)> = stretches.iter().map(|stretch| (stretch.start(), end(stretch))).collect();
        for (stretch, number) in stretches.iter_mut().zip(stretch_numbers(&ends)) {
            if settings.known_band.is_none() {
                spikes += stretch.remove_spikes(SpikeCriterion::EN_15610).len();
            }
            progress();
            let found = band_statistics(stretch, settings)?;
            progress();
            blocks.extend(block_rows(stretch, settings, &found));
            for (index, (band, found)) in settings.bands.iter().zip(found).enumerate() {
                let Some(found) = found else { continue };
                over_limit.extend(sections((stretch, number), *band, &found, settings));
                statistics[index].push(found);
            }
            if settings.known_band.is_none() {
                pits += stretch.roll_over(WHEEL_RADIUS, PIT_DEPTH).len();
            }
            if settings.without_defects {
                defects.extend(stretch.bridge_defects(settings.known_band));
            } else if !settings.bands.is_empty() {
                defects.extend(stretch.clone().bridge_defects(settings.known_band));
            }
            progress();
        }
        let spacing = stretches.first().map_or(0.0, Profile::spacing);
        let kept = KeptLines::default();
        let levels = record_levels(&stretches, settings, &kept)?;
        let section_spectra = match settings.section_levels {
            true => section_spectra(&stretches, &ends, settings, &kept),
            false => Vec::new(),
        };
        progress();
        let summaries = settings.bands.iter().zip(&statistics);
        Ok(Self {
            spikes,
            pits,
            defects,
            spectrum: known(levels.spectrum, settings)?,
            section_spectra,
            segment_length: levels.segment_length,
            segments: levels.segments,
            bands: summaries.filter_map(|(band, statistics)| summary(*band, statistics, spacing, settings)).collect(),
            blocks,
            over_limit,
            stretches: ends,
        })
    }

    /// Parts of a rail as one, in their order; None without a part. Levels and mean squares are averaged by length.
    pub fn joined(parts: Vec<Self>) -> Option<Self> {
        let bands = joined_bands(&parts);
        let spectrum = joined_spectrum(&parts)?;
        let all = || parts.iter();
        let (spikes, pits) = (all().map(|part| part.spikes).sum(), all().map(|part| part.pits).sum());
        let segments = all().map(|part| part.segments).sum();
        let segment_length = all().map(|part| part.segment_length).fold(0.0, f64::max);
        let mut joined = Self {
            spikes,
            pits,
            defects: Vec::new(),
            spectrum,
            section_spectra: Vec::new(),
            segment_length,
            segments,
            bands,
            blocks: Vec::new(),
            over_limit: Vec::new(),
            stretches: Vec::new(),
        };
        for part in parts {
            joined.defects.extend(part.defects);
            joined.blocks.extend(part.blocks);
            // The numbers of the part go on from those of the parts before it.
            let first = joined.stretches.len();
            joined.stretches.extend(part.stretches);
            let number = stretch_numbers(&joined.stretches).get(first).copied();
            let shift = number.unwrap_or(1) - 1;
            joined.section_spectra.extend(part.section_spectra.into_iter().map(|section| {
                let stretch = section.stretch + shift;
                SectionSpectrum { stretch, ..section }
            }));
            joined.over_limit.extend(part.over_limit.into_iter().map(|over| {
                let stretch = over.stretch + shift;
                GrindSection { stretch, ..over }
            }));
        }
        Some(joined)
    }

    /// What to grind, from one end of the rail to the other.
    pub fn grind(&self, settings: &GrindSettings) -> Vec<GrindSection> {
        grind_sections(self.over_limit.clone(), &self.stretches, settings)
    }

    /// Length of rail that was measured \[m\].
    pub fn length(&self) -> f64 {
        self.stretches.iter().map(|(from, to)| to - from).sum()
    }

    /// Where each stretch without gaps begins and ends \[m\], behind its [number](stretch_numbers).
    pub fn numbered_stretches(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let numbers = stretch_numbers(&self.stretches).into_iter();
        let numbered = numbers.zip(&self.stretches);
        numbered.map(|(number, &(from, to))| (number, from, to))
    }

    /// The number of a stretch where places go back, so that a place alone does not say which of two pieces of rail is meant.
    pub fn stretch_to_name(&self, number: usize) -> Option<usize> {
        let goes_back = self.numbered_stretches().any(|(number, ..)| number > 1);
        goes_back.then_some(number)
    }

    /// The parts of some sections that were measured \[m\], behind the [number of their stretch](stretch_numbers): gaps of the record
    /// are no part of them.
    pub fn measured_within(&self, sections: &[GrindSection]) -> Vec<(usize, f64, f64)> {
        let parts = sections.iter().flat_map(|section| {
            let own = self.numbered_stretches();
            let own = own.filter(|(number, ..)| *number == section.stretch);
            own.map(|(number, from, to)| (number, section.from.max(from), section.to.min(to)))
        });
        parts.filter(|(_, from, to)| from < to).collect()
    }

    /// How often [`new`](Self::new) calls its progress.
    pub fn steps(stretches: &[Profile]) -> usize {
        3 * stretches.len() + 1
    }
}

/// The levels of bands that are not too short to be known.
fn record_levels(stretches: &[Profile], settings: &AnalysisSettings, kept: &KeptLines) -> Result<RecordLevels, Error> {
    let shortest = settings.known_band.map_or(0.0, |known_band| known_band.from());
    RecordLevels::new(stretches, shortest, settings.longest_wavelength, kept)
}

/// The levels of each section, on all cores; those too short for any are left out.
fn section_spectra(
    stretches: &[Profile],
    ends: &[(f64, f64)],
    settings: &AnalysisSettings,
    kept: &KeptLines,
) -> Vec<SectionSpectrum> {
    let pieces = pieces(ends);
    if pieces.len() < 2 {
        return Vec::new();
    }
    let numbers = stretch_numbers(ends);
    let levels = |piece: &Piece| {
        let &Piece { stretch, from, to, .. } = piece;
        let own = stretches.iter().zip(&numbers);
        let own = own.filter(|(_, number)| **number == stretch);
        let parts = own.filter_map(|(stretch, _)| stretch.between(from, to));
        let parts: Vec<Profile> = parts.collect();
        let levels = record_levels(&parts, settings, kept).ok()?;
        Some(SectionSpectrum { stretch, from, to, spectrum: known(levels.spectrum, settings).ok()? })
    };
    pieces.par_iter().filter_map(levels).collect()
}

/// The one-third octaves that the wheel felt from edge to edge; all of a rail's own profile.
fn known(spectrum: Spectrum, settings: &AnalysisSettings) -> Result<Spectrum, Error> {
    let Some(known_band) = settings.known_band else {
        return Ok(spectrum);
    };
    let within = spectrum.levels().iter().filter(|level| {
        let (shortest, longest) = level.band.wavelength_range();
        known_band.from() <= shortest && longest <= known_band.to()
    });
    Spectrum::new(within.map(|level| (level.band, level.level)))
}

/// Statistics of each band; `None` if the stretch is too short or its samples too far apart.
fn band_statistics(stretch: &Profile, settings: &AnalysisSettings) -> Result<Vec<Option<BandStatistics>>, Error> {
    let spacing = stretch.spacing();
    let length = stretch.length();
    let fits = |band: &WavelengthBand| {
        let is_known = settings
            .known_band
            .is_none_or(|known_band| known_band.from() <= band.from() && band.to() <= known_band.to());
        is_known && band.fits_into(length) && BandPass::resolves(*band, spacing)
    };
    let samples = |length: f64| (length / spacing).round().max(1.0) as usize;
    let fitting: Vec<BandSettings> = settings
        .bands
        .iter()
        .filter(|band| fits(band))
        .map(|band| BandSettings {
            band: *band,
            window: samples(settings.window.unwrap_or_else(|| band.default_window())),
            limit: settings.limit.as_ref().and_then(|limit| limit.of(*band)),
            block: samples(settings.block),
            margin: samples(band.to()),
        })
        .collect();
    let mut found = BandStatistics::of_profile(stretch, &fitting)?.into_iter();
    let bands = settings.bands.iter();
    Ok(bands.map(|band| fits(band).then(|| found.next()).flatten()).collect())
}

/// Mean squares of each band that any part has, weighted by the length of the parts that have it.
fn joined_spectrum(parts: &[RailAnalysis]) -> Option<Spectrum> {
    let levels = parts.iter().flat_map(|part| part.spectrum.levels());
    let mut bands: Vec<ThirdOctave> = levels.map(|level| level.band).collect();
    bands.sort();
    bands.dedup();
    let means = bands.into_iter().map(|band| {
        let having = parts.iter().filter_map(|part| Some((part.length(), part.spectrum.level(band)?)));
        let (length, sum) =
            having.fold((0.0, 0.0), |(length, sum), (own, level)| (length + own, sum + own * mean_square(level)));
        (band, level(sum / length))
    });
    Spectrum::new(means).ok()
}

fn joined_bands(parts: &[RailAnalysis]) -> Vec<BandSummary> {
    let mut joined: Vec<BandSummary> = Vec::new();
    for own in parts.iter().flat_map(|part| &part.bands) {
        let Some(band) = joined.iter_mut().find(|band| band.band == own.band) else {
            joined.push(*own);
            continue;
        };
        let length = band.length + own.length;
        let mean = |one: f64, other: f64| (one * band.length + other * own.length) / length;
        *band = BandSummary {
            band: band.band,
            window: band.window.max(own.window),
            length,
            rms: mean(band.rms.powi(2), own.rms.powi(2)).sqrt(),
            moving_rms_max: band.moving_rms_max.max(own.moving_rms_max),
            peak_to_peak_max: band.peak_to_peak_max.max(own.peak_to_peak_max),
            limit: band.limit,
            share_over_limit: band.share_over_limit.zip(own.share_over_limit).map(|(one, other)| mean(one, other)),
        };
    }
    joined.sort_by(|a, b| a.band.from().total_cmp(&b.band.from()));
    joined
}

fn block_rows<'a>(
    stretch: &'a Profile,
    settings: &'a AnalysisSettings,
    statistics: &'a [Option<BandStatistics>],
) -> impl Iterator<Item = BlockRms> + 'a {
    let block = (settings.block / stretch.spacing()).round().max(1.0) as usize;
    let samples = stretch.heights().len();
    (0..samples.div_ceil(block)).map(move |index| BlockRms {
        from: stretch.position(index * block),
        to: stretch.position(((index + 1) * block).min(samples)),
        rms: statistics.iter().map(|band| band.as_ref().map(|band| band.block_rms[index])).collect(),
        moving_rms_max: statistics
            .iter()
            .map(|band| band.as_ref().map(|band| band.block_moving_rms_max[index]))
            .collect(),
    })
}

fn sections(
    (stretch, number): (&Profile, usize),
    band: WavelengthBand,
    statistics: &BandStatistics,
    settings: &AnalysisSettings,
) -> Vec<GrindSection> {
    let Some(limit) = settings.limit.as_ref().and_then(|limit| limit.of(band)) else {
        return Vec::new();
    };
    statistics
        .exceedances
        .iter()
        .map(|over| GrindSection {
            stretch: number,
            from: stretch.position(over.samples.start),
            to: stretch.position(over.samples.end),
            band,
            ratio: over.rms_max / limit,
        })
        .collect()
}

fn summary(
    band: WavelengthBand,
    statistics: &[BandStatistics],
    spacing: f64,
    settings: &AnalysisSettings,
) -> Option<BandSummary> {
    let samples: usize = statistics.iter().map(|stretch| stretch.samples).sum();
    let window = statistics.iter().map(|stretch| stretch.window).max()?;
    let sum: f64 = statistics.iter().map(|stretch| stretch.samples as f64 * stretch.mean_square).sum();
    let over: usize = statistics.iter().map(BandStatistics::samples_over_limit).sum();
    let largest = |value: fn(&BandStatistics) -> f64| statistics.iter().map(value).fold(0.0, f64::max);
    let limit = settings.limit.as_ref().and_then(|limit| limit.of(band));
    Some(BandSummary {
        band,
        window: window as f64 * spacing,
        length: samples as f64 * spacing,
        rms: (sum / samples as f64).sqrt(),
        moving_rms_max: largest(|stretch| stretch.moving_rms_max),
        peak_to_peak_max: largest(|stretch| stretch.peak_to_peak_max),
        limit,
        share_over_limit: limit.map(|_| over as f64 / samples as f64),
    })
}

#[cfg(test)]
mod tests;
