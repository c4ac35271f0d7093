//! A measured profile: levels, bands, limits, what to grind.

use std::io::{self, Write};
use std::path::Path;

use riffel::roughness::{
    AnalysisSettings, BandSummary, GrindSection, Profile, RailAnalysis, RmsLimit, Spectrum,
    WavelengthBand, grind_sections,
};
use riffel_case::CaseError;
use riffel_case::roughness::{Limit, LimitTable, Rail, Record};

use super::document::{Document, RailDocument, Removed, bands, grind, levels};
use super::verdict::Verdict;
use super::{figure, folder, with_progress};
use crate::arguments::Roughness;
use crate::error::CliError;
use crate::output::{json, print, print_remarks, table};
use crate::staging::{Staging, write_file};

/// Longest wavelength of the spectrum \[m\] where nothing is asked for.
const LONGEST: f64 = 2.0;
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
    let report = Report::new(path, record, limits, arguments)?;
    if let Some(format) = &arguments.save_format {
        write_file(format, &report.record.format.toml(), true)?;
    }
    let document = json(&report.document(path));
    if arguments.json {
        print(&document);
        print_remarks(&report.warnings);
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = folder(path, arguments.output.as_deref());
    let mut staging = Staging::new(&folder)?;
    staging.write_figure("roughness", &figure::of_profile(path, &report, limits))?;
    staging.write_with("spectrum.csv", |file| report.spectrum_table(file))?;
    staging.write_with("blocks.csv", |file| report.block_table(file))?;
    staging.write_with("grind.csv", |file| report.grind_table(file))?;
    staging.write("summary.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(report.readable(path) + &place));
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
        arguments: &Roughness,
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
                    "at most a quarter of the longest stretch without gaps, {longest_stretch:.3} m"
                ),
            })?;
        }
        let settings = AnalysisSettings {
            longest_wavelength: arguments.longest.map_or(LONGEST, |longest| longest.si()),
            window: arguments.window.map(|window| window.si()),
            block: arguments.block.si(),
            limit: rms_limit(limits)?,
            ..AnalysisSettings::default()
        };
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
        .map_err(|error| CaseError::Data {
            path: path.to_owned(),
            line: None,
            message: error.to_string(),
            help: None,
        })?;
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

    /// What was understood of the file.
    pub(crate) fn understood(&self) -> String {
        let format = &self.record.format;
        let header = match format.header_lines {
            0 => "no header".to_owned(),
            1 => "a header of one line".to_owned(),
            lines => format!("a header of {lines} lines"),
        };
        let position = match &format.position {
            Some(column) => {
                let order = if self.record.falling { ", falling" } else { "" };
                format!(
                    "position in column {} [{}]{order}",
                    column.column, column.unit
                )
            }
            None => "no position".to_owned(),
        };
        let rails: Vec<String> = format
            .rails
            .iter()
            .zip(&self.record.rails)
            .map(|(column, rail)| {
                format!(
                    "{} in column {} [{}]",
                    rail.name, column.column, column.unit
                )
            })
            .collect();
        format!(
            "read as: {}, {}, {header}; {position}; {}\n",
            format.delimiter.words(),
            format.decimal.words(),
            rails.join(", ")
        )
    }

    fn readable(&self, path: &Path) -> String {
        let removed = self.removed();
        let mut text = format!("{}\n{}", path.display(), self.understood());
        text += &format!(
            "{:.3} m to {:.3} m, {:.3} m of rail sampled every {:.4} mm; {} and {} removed\n",
            self.record.from,
            self.record.to,
            self.length,
            1e3 * self.record.spacing,
            counted(removed.spikes, "spike"),
            counted(removed.pits, "pit"),
        );
        let mut rows = table(&[
            "band mm",
            "rms µm",
            "highest moving rms µm",
            "highest peak-to-peak µm",
            "window m",
            "limit µm",
            "over limit",
        ]);
        for band in &self.bands {
            rows.add_row(band_row(band));
        }
        text += &format!("{rows}\n");
        for verdict in &self.verdicts {
            text += &format!("{}\n", verdict.sentence);
        }
        text + &self.grind_in_words()
    }

    fn grind_in_words(&self) -> String {
        /// Sections that a terminal shows; the file has all.
        const SHOWN: usize = 20;
        if self.bands.iter().all(|band| band.limit.is_none()) {
            return String::new();
        }
        if self.sections.is_empty() {
            return "nothing to grind: no band is over its limit anywhere\n".to_owned();
        }
        let mut rows = table(&[
            "grind",
            "from m",
            "to m",
            "length m",
            "worst band mm",
            "rms/limit",
        ]);
        for (index, section) in self.sections.iter().take(SHOWN).enumerate() {
            rows.add_row(grind_row(index, section));
        }
        let total: f64 = self.sections.iter().map(GrindSection::length).sum();
        let more = match self.sections.len().saturating_sub(SHOWN) {
            0 => String::new(),
            more => format!("{more} more in grind.csv; "),
        };
        let share = 100.0 * total / self.length;
        format!("{rows}\n{more}in all {total:.2} m to grind, {share:.1} % of the length\n")
    }

    fn spectrum_table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = vec!["wavelength_m".to_owned(), "level_db".to_owned()];
        header.extend(
            self.rails
                .iter()
                .map(|(name, _)| format!("{name} level_db")),
        );
        writer.write_record(&header)?;
        for level in self.spectrum.levels() {
            let mut row = vec![Some(level.band.wavelength()), Some(level.level)];
            row.extend(
                self.rails
                    .iter()
                    .map(|(_, rail)| rail.spectrum.level(level.band)),
            );
            writer.serialize(row)?;
        }
        writer.flush()
    }

    fn block_table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = ["rail", "from_m", "to_m"].map(str::to_owned).to_vec();
        header.extend(WavelengthBand::GRINDING.map(|band| format!("rms_m {} mm", name(&band))));
        writer.write_record(&header)?;
        for (name, rail) in &self.rails {
            for block in &rail.blocks {
                writer.serialize((name, block.from, block.to, &block.rms))?;
            }
        }
        writer.flush()
    }

    fn grind_table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["from_m", "to_m", "worst_band_mm", "rms_over_limit"])?;
        for section in &self.sections {
            writer.serialize((section.from, section.to, name(&section.band), section.ratio))?;
        }
        writer.flush()
    }
}

/// A band in the table of a reader: name, RMS values \[µm\], window \[m\], limit and share.
pub(crate) fn band_row(band: &BandSummary) -> [String; 7] {
    [
        name(&band.band),
        format!("{:.2}", 1e6 * band.rms),
        format!("{:.2}", 1e6 * band.moving_rms_max),
        format!("{:.1}", 1e6 * band.peak_to_peak_max),
        format!("{:.1}", band.window),
        band.limit
            .map_or_else(String::new, |limit| format!("{:.0}", 1e6 * limit)),
        band.share_over_limit
            .map_or_else(String::new, |share| format!("{:.1} %", 100.0 * share)),
    ]
}

/// A section in the table of a reader: number, places and length \[m\], worst band and its ratio.
pub(crate) fn grind_row(index: usize, section: &GrindSection) -> [String; 6] {
    [
        format!("{}", index + 1),
        format!("{:.2}", section.from),
        format!("{:.2}", section.to),
        format!("{:.2}", section.length()),
        name(&section.band),
        format!("{:.2}", section.ratio),
    ]
}

pub(crate) fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// A band in millimetres.
pub(crate) fn name(band: &WavelengthBand) -> String {
    format!("{:.0}–{:.0}", 1e3 * band.from(), 1e3 * band.to())
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
