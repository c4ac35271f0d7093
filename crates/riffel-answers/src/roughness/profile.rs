//! A measured profile: levels, bands, limits, what to grind.

use std::path::{Path, PathBuf};

use riffel::roughness::{
    AnalysisSettings, BandSummary, GrindSection, GrindSettings, Profile, RailAnalysis, RmsLimit, Spectrum,
    WavelengthBand,
};
use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{CaseError, Language, Message, fixed, number, say};
use riffel_plot::{LineFigure, LinePanel};
use riffel_rail::{DefectsAre, Limit, LimitTable, LinePlace, ReaderFormat, Record, defects_in_words, rail_in_words};
use serde::Serialize;

use super::band::Band;
use super::grind::Grind;
use super::level::as_levels;
use super::rail::{RailAnswer, Removed};
use super::section_verdict::SectionVerdict;
use super::verdict::{Verdict, worst_first};
use super::words::name;
use super::{figure, tables};
use crate::question::Client;
use crate::{Answer, AnswerError, Existing, OwnText, Result, Table};

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
#[derive(Serialize)]
pub struct ProfileAnswer {
    pub(super) file: String,
    sample_spacing_m: f64,
    /// Mean length of the rails \[m\].
    #[serde(rename = "length_m")]
    pub length: f64,
    /// Where there are several rails. Every list has it first.
    #[serde(skip_serializing_if = "Option::is_none")]
    worst_rail: Option<String>,
    /// Energy mean over the rails; each is judged by its own.
    #[serde(serialize_with = "as_levels")]
    pub spectrum: Spectrum,
    bands: Vec<Band>,
    /// What was taken out of all rails.
    pub removed: Removed,
    /// Those on all rails, the worst rail first.
    pub verdicts: Vec<Verdict>,
    /// Each section of each rail, the worst first.
    #[serde(rename = "sections", skip_serializing_if = "Vec::is_empty")]
    pub sections_judged: Vec<SectionVerdict>,
    /// What lies along the line, by a table.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    along: Vec<LinePlace>,
    pub(crate) grind: Grind,
    /// Each rail on its own, the worst first.
    pub rails: Vec<RailAnswer>,
    read_as: ReaderFormat,
    /// What was put right, and what the reader should know.
    pub warnings: Vec<Message>,
    /// The record; its heights are used up.
    #[serde(skip)]
    pub record: Record,
    /// What is ground as one.
    #[serde(skip)]
    pub grinding: GrindSettings,
    #[serde(skip)]
    pub(super) limits: Vec<LimitTable>,
    /// Where it is saved how the file was read.
    #[serde(skip)]
    pub(super) save_format: Option<PathBuf>,
}

/// The limit of the moving RMS: there is one at most.
pub(crate) fn rms_limit(limits: &[LimitTable]) -> Result<Option<RmsLimit>> {
    let mut found = limits.iter().filter_map(|table| match &table.limit {
        Limit::Rms(limit) => Some((table, limit)),
        Limit::Levels(_) => None,
    });
    let first = found.next();
    match found.next() {
        Some((second, _)) => Err(AnswerError::argument(
            "--limit",
            &second.name,
            "the only table of RMS limits: what to grind follows from one",
        )),
        None => Ok(first.map(|(_, limit)| limit.clone())),
    }
}

/// Whether a table limits levels, those of each section of the rail then too.
pub(crate) fn limit_levels(limits: &[LimitTable]) -> bool {
    let mut limits = limits.iter();
    limits.any(|table| matches!(table.limit, Limit::Levels(_)))
}

impl ProfileAnswer {
    /// A profile held to limits; `path` is the one in errors, `client` is told how far it is.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a longest wavelength that is too long for the record, or two tables of RMS
    /// limits; [`CaseError::Data`] for a record that cannot be judged.
    pub fn new(
        path: &Path,
        mut record: Record,
        limits: &[LimitTable],
        request: &ProfileRequest,
        client: &dyn Client,
    ) -> Result<Self> {
        check_longest(&record, request)?;
        let step = client.begin(say!(progress_roughness), Self::steps(&record));
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
            .map(|rail| RailAnalysis::new(rail, &settings, &|| step(1)))
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
        Ok(Self {
            file: path.display().to_string(),
            sample_spacing_m: record.spacing,
            length,
            worst_rail: several.then(|| rails[0].name.clone()),
            spectrum,
            bands: rails.iter().flat_map(|rail| rail.bands.iter().cloned()).collect(),
            removed: Removed {
                spikes: rails.iter().map(|rail| rail.analysis.spikes).sum(),
                pits: rails.iter().map(|rail| rail.analysis.pits).sum(),
            },
            verdicts: rails.iter().flat_map(|rail| rail.verdicts.iter().cloned()).collect(),
            sections_judged,
            along: Vec::new(),
            grind: Grind::new(&rails, &grinding),
            rails,
            read_as: record.format.clone(),
            warnings,
            record,
            grinding,
            limits: limits.to_vec(),
            save_format: None,
        })
    }

    /// Answer with what lies along the line.
    #[must_use]
    pub fn beside(mut self, along: Vec<LinePlace>) -> Self {
        for section in &mut self.sections_judged {
            section.beside(&along);
        }
        Self { along, ..self }
    }

    /// Steps of the work on a record.
    fn steps(record: &Record) -> usize {
        let rails = record.rails.iter();
        rails.map(|rail| RailAnalysis::steps(&rail.stretches)).sum()
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
            0 => say!(worst_within, rail),
            _ => say!(worst_over, rail, count, all),
        })
    }

    /// Whether there is a limit from which follows what to grind.
    pub fn knows_what_to_grind(&self) -> bool {
        let mut bands = self.rails.iter().flat_map(|rail| &rail.analysis.bands);
        bands.any(|band| band.limit.is_some())
    }

    /// That nothing is to be ground, with the limit from which that follows.
    pub fn nothing_to_grind(&self) -> Message {
        let edition = self.verdicts.iter().find_map(Verdict::edition_of_rms);
        say!(no_band_over_its_limit, edition = edition.unwrap_or_default())
    }

    /// What to grind of all rails, the worst rail first.
    pub fn sections(&self) -> Vec<(&RailAnswer, &GrindSection)> {
        let rails = self.rails.iter();
        rails.flat_map(|rail| rail.sections.iter().map(move |section| (rail, section))).collect()
    }

    /// The sums of what to grind in a sentence.
    pub fn total(&self) -> Message {
        self.grind.in_words(&self.rails)
    }

    /// Which rail is worst, and the verdicts.
    fn judged(&self) -> Vec<Message> {
        let verdicts = self.verdicts.iter().map(|verdict| verdict.sentence.clone());
        self.worst().into_iter().chain(verdicts).collect()
    }

    /// Levels with their limit, and the moving RMS along each rail.
    pub(crate) fn figure_in(&self, language: Language) -> LineFigure {
        figure::of_profile(self, language)
    }

    /// The moving RMS of each band along a rail, each with its limit.
    pub fn moving_rms(&self, rail: &RailAnswer, language: Language) -> LinePanel {
        figure::moving_rms(rail, [self.record.from, self.record.to], language)
    }
}

impl Answer for ProfileAnswer {
    fn name(&self) -> &'static str {
        "roughness"
    }

    fn introduction(&self) -> Vec<Message> {
        let sampled = say!(
            rail_is_sampled,
            from = fixed(self.record.from, 3),
            to = fixed(self.record.to, 3),
            length = fixed(self.length, 3),
            spacing = fixed(1e3 * self.sample_spacing_m, 4),
            spikes = say!(spikes, count = self.removed.spikes),
            pits = say!(pits, count = self.removed.pits)
        );
        vec![Message::verbatim(&self.file), self.understood(), sampled]
    }

    fn tables(&self) -> Vec<Table> {
        let rails = || self.rails.iter();
        let own = rails().map(|rail| (&*rail.name, &rail.analysis.spectrum));
        let mean = (self.rails.len() > 1).then_some(("energy mean", &self.spectrum));
        let shown = self.knows_what_to_grind().then(|| tables::shown_grind(rails(), tables::SHOWN));
        let files = [tables::blocks(rails()), tables::grind(rails())];
        [tables::levels(own.chain(mean)), tables::bands(rails())].into_iter().chain(shown).chain(files).collect()
    }

    fn above(&self, table: &str) -> Vec<Message> {
        match table {
            tables::GRIND => self.judged(),
            _ => Vec::new(),
        }
    }

    fn sentences(&self) -> Vec<Message> {
        match (self.knows_what_to_grind(), self.sections().len()) {
            (false, _) => self.judged(),
            (true, 0) => self.judged().into_iter().chain([self.nothing_to_grind()]).collect(),
            (true, sections) => vec![match tables::more(sections) {
                Some(more) => say!(one_after_other, one = more, other = self.total()),
                None => self.total(),
            }],
        }
    }

    fn figure(&self) -> LineFigure {
        self.figure_in(Language::English)
    }

    fn own_text(&self) -> Option<OwnText<'_>> {
        let (path, text) = (self.save_format.as_deref()?, self.record.format.toml());
        Some(OwnText { path: Some(path), text: text.into(), existing: Existing::Kept, written: None })
    }

    fn remarks(&self) -> &[Message] {
        &self.warnings
    }
}

/// `Ok` if the record is long enough for the longest wavelength that is asked for.
fn check_longest(record: &Record, request: &ProfileRequest) -> Result<()> {
    let longest_stretch = record
        .rails
        .iter()
        .map(|rail| rail.stretches.iter().map(Profile::length).fold(0.0, f64::max))
        .fold(f64::INFINITY, f64::min);
    if let Some(asked) = request.longest
        && asked.si() > 0.25 * (longest_stretch + record.spacing)
    {
        return Err(AnswerError::argument(
            "--longest",
            asked,
            format!(
                "at most {:.3} m, a quarter of the longest stretch without gaps",
                0.25 * (longest_stretch + record.spacing)
            ),
        ));
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
                true => say!(stretches_too_short_for_band, band, length),
                false => say!(samples_too_far_for_band, band, step),
            });
        } else if let Some(window) = settings.window.filter(|window| *window < band.to()) {
            let (window, band) = (number(window), name(band));
            remarks.push(say!(window_shorter_than_wave, window, band));
        }
    }
    let unlike = |band: &&BandSummary| {
        band.band == WavelengthBand::GRINDING[1] && !(LIKELY_RMS.0..LIKELY_RMS.1).contains(&band.rms)
    };
    if let Some(band) = bands.iter().find(unlike) {
        let rms = number(format_args!("{:.3e}", 1e6 * band.rms));
        remarks.push(say!(rms_unlike_any_rail, rms));
    }
    remarks
}
