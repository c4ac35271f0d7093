//! A measured profile: levels, bands, limits, what to grind.

use std::path::Path;

use riffel::roughness::{
    AnalysisSettings, BandSummary, GrindSection, GrindSettings, Profile, RailAnalysis, RmsLimit, Spectrum,
    WavelengthBand, line_length,
};
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{CaseError, Language, Message, fixed, number, say};
use riffel_plot::{LineFigure, LinePanel};
use riffel_rail::{DefectsAre, Limit, LimitTable, LinePlace, Record, defects_in_words, rail_in_words};

use super::document::{Grind, RailDocument, Removed, RoughnessDocument, bands, levels};
use super::figure;
use super::section_verdict::SectionVerdict;
use super::verdict::{Judged, Verdict, worst_first};
use super::words::name;
use crate::AnswerError;

/// RMS \[m\] of a rail between 30 and 100 mm outside which the unit of the heights is doubtful.
const LIKELY_RMS: (f64, f64) = (2e-8, 1e-3);

/// What is asked of a profile besides its limits.
#[derive(Debug, Clone, Copy)]
pub struct ProfileRequest {
    /// Longest wavelength of the spectrum; by default that of the standard.
    pub longest: Option<Quantity<Length>>,
    /// Window of the moving RMS \[m\]; by default that of each band.
    pub window: Option<f64>,
    /// Length of a block \[m\].
    pub block: f64,
    /// What is ground as one.
    pub grinding: GrindSettings,
}

/// A record with all that was computed of it.
pub struct ProfileAnswer {
    /// The record; its heights are used up.
    pub record: Record,
    /// Each rail on its own, the worst first.
    pub rails: Vec<RailAnswer>,
    /// Each section of each rail, the worst first.
    pub sections_judged: Vec<SectionVerdict>,
    /// What lies along the line, by a table.
    along: Vec<LinePlace>,
    /// Energy mean over the rails, which is not judged.
    pub spectrum: Spectrum,
    /// What is ground as one.
    pub grinding: GrindSettings,
    /// What was put right, and what the reader should know.
    pub warnings: Vec<Message>,
    /// Mean length of the rails \[m\].
    pub length: f64,
}

/// A rail with what is said of it.
pub struct RailAnswer {
    /// Its name.
    pub name: String,
    /// What was computed of it.
    pub analysis: RailAnalysis,
    /// What to grind of it.
    pub sections: Vec<GrindSection>,
    /// By limit table; sentences name the rail where there are several.
    pub verdicts: Vec<Verdict>,
}

impl RailAnswer {
    /// One rail, or one of several, held to limits.
    fn new(
        name: String,
        analysis: RailAnalysis,
        is_of_several: bool,
        limits: &[LimitTable],
        grinding: &GrindSettings,
    ) -> Self {
        let words = is_of_several.then(|| rail_in_words(&name));
        let verdicts = Verdict::all(limits, &analysis.spectrum, Some(&analysis)).into_iter();
        Self {
            sections: analysis.grind(grinding),
            verdicts: verdicts.map(|verdict| verdict.on_rail(&name).of(words.as_ref())).collect(),
            name,
            analysis,
        }
    }
}

impl Judged for RailAnswer {
    fn verdicts(&self) -> &[Verdict] {
        &self.verdicts
    }
}

/// The limit of the moving RMS: there is one at most.
pub(crate) fn rms_limit(limits: &[LimitTable]) -> Result<Option<RmsLimit>, AnswerError> {
    let mut found = limits.iter().filter_map(|table| match &table.limit {
        Limit::Rms(limit) => Some((table, limit)),
        Limit::Levels(_) => None,
    });
    let first = found.next();
    match found.next() {
        Some((second, _)) => Err(AnswerError::Argument {
            argument: "--limit",
            value: second.name.clone(),
            rule: "the only table of RMS limits: what to grind follows from one".to_owned(),
        }),
        None => Ok(first.map(|(_, limit)| limit.clone())),
    }
}

/// Whether a table limits levels, those of each section of the rail then too.
pub(crate) fn limit_levels(limits: &[LimitTable]) -> bool {
    let mut limits = limits.iter();
    limits.any(|table| matches!(table.limit, Limit::Levels(_)))
}

impl ProfileAnswer {
    /// A profile held to limits; `path` is the one in errors, `progress` is told of [`steps`](Self::steps) done.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a longest wavelength that is too long for the record, or two tables of RMS
    /// limits; [`CaseError::Data`] for a record that cannot be judged.
    pub fn new(
        path: &Path,
        mut record: Record,
        limits: &[LimitTable],
        request: &ProfileRequest,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, AnswerError> {
        check_longest(&record, request)?;
        let mut settings = AnalysisSettings {
            window: request.window,
            block: request.block,
            limit: rms_limit(limits)?,
            section_levels: limit_levels(limits),
            ..AnalysisSettings::default()
        };
        if let Some(longest) = request.longest {
            settings.longest_wavelength = longest.si();
        }
        // The heights are not needed twice.
        let stretches: Vec<Vec<Profile>> =
            record.rails.iter_mut().map(|rail| std::mem::take(&mut rail.stretches)).collect();
        let analyses: Vec<RailAnalysis> = stretches
            .into_iter()
            .map(|rail| RailAnalysis::new(rail, &settings, &|| progress(1)))
            .collect::<Result<_, _>>()
            .map_err(|error| CaseError::data(path, error.to_string()))?;
        let spectra: Vec<Spectrum> = analyses.iter().map(|rail| rail.spectrum.clone()).collect();
        let spectrum =
            Spectrum::energy_mean(&spectra).ok_or_else(|| CaseError::data(path, "there is no rail in the file"))?;
        let length = analyses.iter().map(RailAnalysis::length).sum::<f64>() / analyses.len().max(1) as f64;
        let grinding = request.grinding;
        let several = analyses.len() > 1;
        let names = record.rails.iter().map(|rail| rail.name.clone());
        let mut rails: Vec<RailAnswer> = names
            .zip(analyses)
            .map(|(name, analysis)| RailAnswer::new(name, analysis, several, limits, &grinding))
            .collect();
        worst_first(&mut rails);
        let sections =
            rails.iter().flat_map(|rail| SectionVerdict::of_rail(&rail.name, &rail.analysis, &rail.sections, limits));
        let mut sections_judged: Vec<SectionVerdict> = sections.collect();
        SectionVerdict::worst_first(&mut sections_judged);
        let bands: Vec<BandSummary> = rails.iter().flat_map(|rail| rail.analysis.bands.iter().copied()).collect();
        let mut warnings = std::mem::take(&mut record.warnings);
        let defects =
            rails.iter().flat_map(|rail| defects_in_words(&rail.name, &rail.analysis.defects, DefectsAre::Judged));
        warnings.extend(defects);
        warnings.extend(remarks(&bands, &settings, record.spacing));
        Ok(Self { rails, sections_judged, along: Vec::new(), record, spectrum, grinding, warnings, length })
    }

    /// The same, with what lies along the line.
    #[must_use]
    pub fn beside(mut self, along: Vec<LinePlace>) -> Self {
        for section in &mut self.sections_judged {
            section.beside(&along);
        }
        Self { along, ..self }
    }

    /// Steps of the work on a record.
    pub fn steps(record: &Record) -> usize {
        let rails = record.rails.iter();
        rails.map(|rail| RailAnalysis::steps(&rail.stretches)).sum()
    }

    /// The verdicts on all rails, the worst rail first.
    pub fn verdicts(&self) -> impl Iterator<Item = &Verdict> {
        self.rails.iter().flat_map(|rail| &rail.verdicts)
    }

    /// Which rail is worst, where there are several.
    pub fn worst(&self) -> Option<Message> {
        let [worst, _, ..] = &self.rails[..] else {
            return None;
        };
        let rail = rail_in_words(&worst.name);
        let over = worst.verdicts.iter().filter(|one| !one.within).count();
        let (count, all) = (number(over), number(worst.verdicts.len()));
        Some(match over {
            0 => say!(worst_within, rail = rail),
            _ => say!(worst_over, rail = rail, count = count, all = all),
        })
    }

    /// Length of line where a rail is to be ground \[m\], and its share of the line that was measured.
    pub(crate) fn line_to_grind(&self) -> (f64, f64) {
        let sections = self.rails.iter().flat_map(|rail| &rail.sections);
        let total = line_length(sections.map(|section| (section.stretch, section.from, section.to)));
        let rails = || self.rails.iter();
        let ground = rails().flat_map(|rail| rail.analysis.measured_within(&rail.sections));
        let measured = rails().flat_map(|rail| rail.analysis.numbered_stretches());
        (total, line_length(ground) / line_length(measured))
    }

    /// Whether there is a limit from which follows what to grind.
    pub fn knows_what_to_grind(&self) -> bool {
        let mut bands = self.rails.iter().flat_map(|rail| &rail.analysis.bands);
        bands.any(|band| band.limit.is_some())
    }

    /// That nothing is to be ground, with the limit from which that follows.
    pub fn nothing_to_grind(&self) -> Message {
        let edition = self.verdicts().find_map(Verdict::edition_of_rms);
        say!(no_band_over_its_limit, edition = edition.unwrap_or_default())
    }

    /// What was taken out of all rails.
    pub fn removed(&self) -> Removed {
        let rails = || self.rails.iter();
        Removed {
            spikes: rails().map(|rail| rail.analysis.spikes).sum(),
            pits: rails().map(|rail| rail.analysis.pits).sum(),
        }
    }

    /// Levels with their limit, and the moving RMS along each rail.
    pub fn figure(&self, path: &Path, limits: &[LimitTable], language: Language) -> LineFigure {
        figure::of_profile(path, self, limits, language)
    }

    /// The moving RMS of each band along a rail, each with its limit.
    pub fn moving_rms(&self, rail: &RailAnswer, language: Language) -> LinePanel {
        figure::moving_rms(rail, [self.record.from, self.record.to], language)
    }

    /// What was computed as data: what `riffel roughness --json` prints.
    pub fn document(&self, path: &Path) -> RoughnessDocument {
        let several = self.rails.len() > 1;
        RoughnessDocument {
            file: path.display().to_string(),
            sample_spacing_m: Some(self.record.spacing),
            length_m: Some(self.length),
            worst_rail: several.then(|| self.rails[0].name.clone()),
            spectrum: levels(&self.spectrum),
            bands: self.rails.iter().flat_map(|rail| bands(&rail.name, &rail.analysis.bands)).collect(),
            removed: self.removed(),
            verdicts: self.verdicts().cloned().collect(),
            sections: self.sections_judged.clone(),
            along: self.along.clone(),
            grind: Some(Grind::new(self)),
            rails: self.rails.iter().map(RailDocument::new).collect(),
            arithmetic_mean: None,
            groups: Vec::new(),
            findings: Vec::new(),
            read_as: Some(self.record.format.clone()),
            warnings: self.warnings.clone(),
        }
    }
}

/// `Ok` if the record is long enough for the longest wavelength that is asked for.
fn check_longest(record: &Record, request: &ProfileRequest) -> Result<(), AnswerError> {
    let longest_stretch = record
        .rails
        .iter()
        .map(|rail| rail.stretches.iter().map(Profile::length).fold(0.0, f64::max))
        .fold(f64::INFINITY, f64::min);
    if let Some(asked) = request.longest
        && asked.si() > 0.25 * (longest_stretch + record.spacing)
    {
        return Err(AnswerError::Argument {
            argument: "--longest",
            value: asked.to_string(),
            rule: format!(
                "at most {:.3} m, a quarter of the longest stretch without gaps",
                0.25 * (longest_stretch + record.spacing)
            ),
        });
    }
    Ok(())
}

/// What the reader should know of the bands.
fn remarks(bands: &[BandSummary], settings: &AnalysisSettings, spacing: f64) -> Vec<Message> {
    let mut remarks = Vec::new();
    for band in &settings.bands {
        if bands.iter().all(|found| found.band != *band) {
            let resolves = riffel::roughness::BandPass::resolves(*band, spacing);
            let (length, step) = (number(4.0 * band.to()), fixed(1e3 * spacing, 3));
            let band = name(band);
            remarks.push(match resolves {
                true => say!(stretches_too_short_for_band, band = band, length = length),
                false => say!(samples_too_far_for_band, band = band, step = step),
            });
        } else if let Some(window) = settings.window.filter(|window| *window < band.to()) {
            let (window, band) = (number(window), name(band));
            remarks.push(say!(window_shorter_than_wave, window = window, band = band));
        }
    }
    let unlike = |band: &&BandSummary| {
        band.band == WavelengthBand::GRINDING[1] && !(LIKELY_RMS.0..LIKELY_RMS.1).contains(&band.rms)
    };
    if let Some(band) = bands.iter().find(unlike) {
        let rms = number(format_args!("{:.3e}", 1e6 * band.rms));
        remarks.push(say!(rms_unlike_any_rail, rms = rms));
    }
    remarks
}
