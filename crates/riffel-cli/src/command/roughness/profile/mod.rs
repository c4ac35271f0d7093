//! A measured profile: levels, bands, limits, what to grind.

mod tables;
mod words;

use std::path::Path;

use riffel::roughness::{
    AnalysisSettings, BandSummary, GrindSection, Profile, RailAnalysis, RmsLimit, Spectrum,
    WavelengthBand, grind_sections,
};
use riffel_case::CaseError;
use riffel_case::roughness::{LabelledSpectrum, Limit, LimitTable, Rail, Record, Survey};

pub(crate) use words::{band_row, counted, grind_row, name};

use super::document::{Document, RailDocument, Removed, bands, grind, levels};
use super::verdict::Verdict;
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
    pub(crate) rails: Vec<(String, RailAnalysis)>,
    /// Energy mean over the rails.
    pub(crate) spectrum: Spectrum,
    pub(crate) bands: Vec<BandSummary>,
    pub(crate) sections: Vec<GrindSection>,
    pub(crate) verdicts: Vec<Verdict>,
    pub(crate) warnings: Vec<String>,
    pub(crate) length: f64,
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
        let lengths: Vec<f64> = record.rails.iter().map(Rail::length).collect();
        // The heights are not needed twice.
        let stretches: Vec<Vec<Profile>> = record
            .rails
            .iter_mut()
            .map(|rail| std::mem::take(&mut rail.stretches))
            .collect();
        let steps = stretches.iter().map(|rail| RailAnalysis::steps(rail)).sum();
        let rails: Vec<RailAnalysis> = with_progress("roughness", steps, |advance| {
            stretches
                .into_iter()
                .map(|rail| RailAnalysis::new(rail, &settings, &|| advance(1)))
                .collect::<Result<_, _>>()
        })
        .map_err(|error| CaseError::data(path, error.to_string()))?;
        let spectra: Vec<Spectrum> = rails.iter().map(|rail| rail.spectrum.clone()).collect();
        let spectrum = Spectrum::energy_mean(&spectra)
            .ok_or_else(|| miette::miette!("there is no rail in the file"))?;
        let bands = mean_bands(&rails, &settings);
        let sections = rails
            .iter()
            .flat_map(|rail| rail.over_limit.clone())
            .collect();
        let sections = grind_sections(sections, arguments.merge.si());
        let mut warnings = std::mem::take(&mut record.warnings);
        warnings.extend(remarks(&bands, &settings, record.spacing));
        let names = record.rails.iter().map(|rail| rail.name.clone());
        let length = lengths.iter().sum::<f64>() / lengths.len().max(1) as f64;
        Ok(Self {
            rails: names.zip(rails).collect(),
            verdicts: Verdict::all(limits, &spectrum, &bands),
            record,
            spectrum,
            bands,
            sections,
            warnings,
            length,
        })
    }

    /// The levels of the rails, to be forecast.
    pub(crate) fn survey(&self, path: &Path) -> Result<Survey, CaseError> {
        let rails = self.rails.iter();
        let records =
            rails.map(|(name, rail)| LabelledSpectrum::of_rail(name, rail.spectrum.clone()));
        Survey::new(path, records.collect(), self.warnings.clone())
    }

    pub(crate) fn removed(&self) -> Removed {
        Removed {
            spikes: self.rails.iter().map(|(_, rail)| rail.spikes).sum(),
            pits: self.rails.iter().map(|(_, rail)| rail.pits).sum(),
        }
    }

    fn document(&self, path: &Path) -> Document {
        Document {
            file: path.display().to_string(),
            sample_spacing_m: Some(self.record.spacing),
            length_m: Some(self.length),
            spectrum: levels(&self.spectrum),
            bands: bands(&self.bands),
            removed: self.removed(),
            verdicts: self.verdicts.clone(),
            grind: Some(grind(&self.sections, self.length)),
            rails: self
                .rails
                .iter()
                .map(|(name, rail)| RailDocument {
                    name: name.clone(),
                    length_m: self.length,
                    spectrum: levels(&rail.spectrum),
                    bands: bands(&rail.bands),
                    removed: Removed {
                        spikes: rail.spikes,
                        pits: rail.pits,
                    },
                })
                .collect(),
            arithmetic_mean: None,
            groups: Vec::new(),
            findings: Vec::new(),
            read_as: Some(self.record.format.clone()),
            warnings: self.warnings.clone(),
        }
    }
}

/// Bands over all rails: mean squares and shares weighted by length, the largest extremes.
fn mean_bands(rails: &[RailAnalysis], settings: &AnalysisSettings) -> Vec<BandSummary> {
    let of = |band: WavelengthBand| {
        let found = rails.iter().flat_map(|rail| &rail.bands);
        let found: Vec<&BandSummary> = found.filter(|summary| summary.band == band).collect();
        let length: f64 = found.iter().map(|band| band.length).sum();
        let mean = |value: &dyn Fn(&BandSummary) -> f64| {
            found
                .iter()
                .map(|band| band.length * value(band))
                .sum::<f64>()
                / length
        };
        let most = |value: fn(&BandSummary) -> f64| {
            found.iter().map(|band| value(band)).fold(0.0, f64::max)
        };
        let first = *found.first()?;
        Some(BandSummary {
            length: length / found.len() as f64,
            rms: mean(&|band| band.rms * band.rms).sqrt(),
            window: most(|band| band.window),
            moving_rms_max: most(|band| band.moving_rms_max),
            peak_to_peak_max: most(|band| band.peak_to_peak_max),
            share_over_limit: first
                .limit
                .map(|_| mean(&|band| band.share_over_limit.unwrap_or(0.0))),
            ..*first
        })
    };
    settings.bands.iter().filter_map(|band| of(*band)).collect()
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
    if let Some(band) = bands
        .iter()
        .find(|band| band.band == WavelengthBand::GRINDING[1])
    {
        let rms = band.rms;
        if !(LIKELY_RMS.0..LIKELY_RMS.1).contains(&rms) {
            remarks.push(format!(
                "an rms of {:.3e} µm between 30 and 100 mm is unlike any rail: check the unit of the heights",
                1e6 * rms
            ));
        }
    }
    remarks
}
