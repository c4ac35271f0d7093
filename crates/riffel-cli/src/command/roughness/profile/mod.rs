//! A measured profile: levels, bands, limits, what to grind.

mod tables;
mod words;

use std::path::Path;

use riffel::roughness::{
    AnalysisSettings, BandSummary, GrindSection, GrindSettings, Profile, RailAnalysis, RmsLimit,
    Spectrum, WavelengthBand, line_length,
};
use riffel_keys::CaseError;
use riffel_rail::{LabelledSpectrum, Limit, LimitTable, Record, Survey};

pub(crate) use words::{band_row, counted, grind_row, name};

use super::document::{Document, Grind, RailDocument, Removed, bands, levels};
use super::verdict::{Judged, Verdict, rail_in_words, worst_first};
use super::{figure, folder, with_progress};
use crate::arguments::{Roughness, Statistics};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, print};
use crate::staging::{Existing, Staging, write_file};

/// RMS \[m\] of a rail between 30 and 100 mm outside which the unit of the heights is doubtful.
const LIKELY_RMS: (f64, f64) = (2e-8, 1e-3);

/// A record with all that was computed of it.
pub(crate) struct Report {
    pub(crate) record: Record,
    /// Each rail on its own, the worst first.
    pub(crate) rails: Vec<RailReport>,
    /// Energy mean over the rails, which is not judged.
    pub(crate) spectrum: Spectrum,
    pub(crate) grinding: GrindSettings,
    pub(crate) warnings: Vec<String>,
    /// Mean length of the rails \[m\].
    pub(crate) length: f64,
}

/// A rail with what is said of it.
pub(crate) struct RailReport {
    pub(crate) name: String,
    pub(crate) analysis: RailAnalysis,
    /// What to grind of it.
    pub(crate) sections: Vec<GrindSection>,
    /// By limit table; sentences name the rail where there are several.
    pub(crate) verdicts: Vec<Verdict>,
}

impl Judged for RailReport {
    fn verdicts(&self) -> &[Verdict] {
        &self.verdicts
    }
}

pub(super) fn run(
    path: &Path,
    record: Record,
    limits: &[LimitTable],
    arguments: &Roughness,
) -> miette::Result<()> {
    let report = Report::new(path, record, limits, &arguments.statistics)?;
    if let Some(format) = &arguments.save_format {
        let existing = Existing::Keep("remove the file first");
        write_file(format, &report.record.format.toml(), existing)?;
    }
    let document = json(&report.document(path));
    if arguments.json {
        print(&document)?;
        print_remarks(&report.warnings);
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = folder(path, arguments.output.as_deref());
    let mut staging = Staging::new("roughness", &folder)?;
    staging.write_figure("roughness", &figure::of_profile(path, &report, limits))?;
    staging.write_with("spectrum.csv", |file| report.spectrum_table(file))?;
    staging.write_with("blocks.csv", |file| report.block_table(file))?;
    staging.write_with("grind.csv", |file| report.grind_table(file))?;
    staging.write("summary.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(report.readable(path) + &place))?;
        print_remarks(&report.warnings);
    }
    Ok(())
}

/// The limit of the moving RMS: there is one at most.
fn rms_limit(limits: &[LimitTable]) -> Result<Option<RmsLimit>, CliError> {
    let mut found = limits.iter().filter_map(|table| match &table.limit {
        Limit::Rms(limit) => Some((table, limit)),
        Limit::Levels(_) => None,
    });
    let first = found.next();
    match found.next() {
        Some((second, _)) => Err(CliError::Argument {
            argument: "--limit",
            value: second.name.clone(),
            rule: "the only table of RMS limits: what to grind follows from one".to_owned(),
        }),
        None => Ok(first.map(|(_, limit)| limit.clone())),
    }
}

impl Report {
    pub(crate) fn new(
        path: &Path,
        mut record: Record,
        limits: &[LimitTable],
        arguments: &Statistics,
    ) -> miette::Result<Self> {
        let longest_stretch = record
            .rails
            .iter()
            .map(|rail| {
                rail.stretches
                    .iter()
                    .map(Profile::length)
                    .fold(0.0, f64::max)
            })
            .fold(f64::INFINITY, f64::min);
        if let Some(asked) = arguments.longest
            && asked.si() > 0.25 * (longest_stretch + record.spacing)
        {
            Err(CliError::Argument {
                argument: "--longest",
                value: asked.to_string(),
                rule: format!(
                    "at most {:.3} m, a quarter of the longest stretch without gaps",
                    0.25 * (longest_stretch + record.spacing)
                ),
            })?;
        }
        let mut settings = AnalysisSettings {
            window: arguments.window.map(|window| window.si()),
            block: arguments.block.si(),
            limit: rms_limit(limits)?,
            ..AnalysisSettings::default()
        };
        if let Some(longest) = arguments.longest {
            settings.longest_wavelength = longest.si();
        }
        // The heights are not needed twice.
        let stretches: Vec<Vec<Profile>> = record
            .rails
            .iter_mut()
            .map(|rail| std::mem::take(&mut rail.stretches))
            .collect();
        let steps = stretches.iter().map(|rail| RailAnalysis::steps(rail)).sum();
        let analyses: Vec<RailAnalysis> = with_progress("roughness", steps, |advance| {
            stretches
                .into_iter()
                .map(|rail| RailAnalysis::new(rail, &settings, &|| advance(1)))
                .collect::<Result<_, _>>()
        })
        .map_err(|error| CaseError::data(path, error.to_string()))?;
        let spectra: Vec<Spectrum> = analyses.iter().map(|rail| rail.spectrum.clone()).collect();
        let spectrum = Spectrum::energy_mean(&spectra)
            .ok_or_else(|| miette::miette!("there is no rail in the file"))?;
        let length =
            analyses.iter().map(RailAnalysis::length).sum::<f64>() / analyses.len().max(1) as f64;
        let grinding = arguments.grinding();
        let several = analyses.len() > 1;
        let names = record.rails.iter().map(|rail| rail.name.clone());
        let mut rails: Vec<RailReport> = names
            .zip(analyses)
            .map(|(name, analysis)| {
                let words = if several {
                    rail_in_words(&name)
                } else {
                    String::new()
                };
                let verdicts = Verdict::all(limits, &analysis.spectrum, &analysis.bands);
                RailReport {
                    sections: analysis.grind(&grinding),
                    verdicts: verdicts
                        .into_iter()
                        .map(|verdict| verdict.on_rail(&name).of(&words))
                        .collect(),
                    name,
                    analysis,
                }
            })
            .collect();
        worst_first(&mut rails);
        let bands: Vec<BandSummary> = rails
            .iter()
            .flat_map(|rail| rail.analysis.bands.iter().copied())
            .collect();
        let mut warnings = std::mem::take(&mut record.warnings);
        warnings.extend(remarks(&bands, &settings, record.spacing));
        Ok(Self {
            rails,
            record,
            spectrum,
            grinding,
            warnings,
            length,
        })
    }

    /// The verdicts on all rails, the worst rail first.
    pub(crate) fn verdicts(&self) -> impl Iterator<Item = &Verdict> {
        self.rails.iter().flat_map(|rail| &rail.verdicts)
    }

    /// Which rail is worst, where there are several.
    pub(crate) fn worst(&self) -> Option<String> {
        let [worst, _, ..] = &self.rails[..] else {
            return None;
        };
        let name = rail_in_words(&worst.name);
        let over = worst.verdicts.iter().filter(|one| !one.within).count();
        Some(match (over, worst.verdicts.len()) {
            (0, _) => format!("worst is {name}; every rail is within the limits"),
            (over, all) => format!("worst is {name}, over {over} of {all} limits"),
        })
    }

    /// Length of line where a rail is to be ground \[m\], and its share of the line that was measured.
    pub(crate) fn line_to_grind(&self) -> (f64, f64) {
        let sections = self.rails.iter().flat_map(|rail| &rail.sections);
        let total = line_length(sections.map(|section| (section.from, section.to)));
        let rails = || self.rails.iter();
        let ground = rails().flat_map(|rail| rail.analysis.measured_within(&rail.sections));
        let measured = rails().flat_map(|rail| rail.analysis.stretches.iter().copied());
        (total, line_length(ground) / line_length(measured))
    }

    /// Whether there is a limit from which follows what to grind.
    pub(crate) fn knows_what_to_grind(&self) -> bool {
        let mut bands = self.rails.iter().flat_map(|rail| &rail.analysis.bands);
        bands.any(|band| band.limit.is_some())
    }

    /// The levels of the rails, to be forecast.
    pub(crate) fn survey(&self, path: &Path) -> Result<Survey, CaseError> {
        let rails = self.rails.iter();
        let records =
            rails.map(|rail| LabelledSpectrum::of_rail(&rail.name, rail.analysis.spectrum.clone()));
        Survey::new(path, records.collect(), self.warnings.clone())
    }

    pub(crate) fn removed(&self) -> Removed {
        let rails = || self.rails.iter();
        Removed {
            spikes: rails().map(|rail| rail.analysis.spikes).sum(),
            pits: rails().map(|rail| rail.analysis.pits).sum(),
        }
    }

    fn document(&self, path: &Path) -> Document {
        let several = self.rails.len() > 1;
        Document {
            file: path.display().to_string(),
            sample_spacing_m: Some(self.record.spacing),
            length_m: Some(self.length),
            worst_rail: several.then(|| self.rails[0].name.clone()),
            spectrum: levels(&self.spectrum),
            bands: self
                .rails
                .iter()
                .flat_map(|rail| bands(&rail.name, &rail.analysis.bands))
                .collect(),
            removed: self.removed(),
            verdicts: self.verdicts().cloned().collect(),
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

/// What the reader should know of the bands.
fn remarks(bands: &[BandSummary], settings: &AnalysisSettings, spacing: f64) -> Vec<String> {
    let mut remarks = Vec::new();
    for band in &settings.bands {
        if bands.iter().all(|found| found.band != *band) {
            let why = if riffel::roughness::BandPass::resolves(*band, spacing) {
                format!(
                    "no stretch is four of its longest waves long, {} m",
                    4.0 * band.to()
                )
            } else {
                format!("samples are {:.3} mm apart", 1e3 * spacing)
            };
            remarks.push(format!("no statistics of {} mm: {why}", name(band)));
        }
    }
    let unlike = |band: &&BandSummary| {
        band.band == WavelengthBand::GRINDING[1]
            && !(LIKELY_RMS.0..LIKELY_RMS.1).contains(&band.rms)
    };
    if let Some(band) = bands.iter().find(unlike) {
        remarks.push(format!(
            "an rms of {:.3e} µm between 30 and 100 mm is unlike any rail: check the unit of the heights",
            1e6 * band.rms
        ));
    }
    remarks
}
