//! `riffel compare`

mod document;
mod figure;

use riffel::forecast::SpeedDistribution;
use riffel::roughness::{LevelLimit, Spectrum};
use riffel_case::roughness::{LimitTable, Survey};
use riffel_case::traffic::Traffic;
use riffel_case::what_if::{Comparison, FastestLine, Outcome};
use riffel_case::{Case, Variant};

use super::forecast::{DAYS_PER_MONTH, level_limit, number, outside, per_million, when};
use super::roughness::survey;
use crate::arguments::{Compare, positive};
use crate::error::CliError;
use crate::output::{Progress, json, print, print_remarks, table};
use crate::staging::Staging;

/// Everything that is reported.
pub(super) struct Report {
    pub(super) case: Case,
    pub(super) speeds: String,
    pub(super) comparison: Comparison,
    pub(super) spectrum: Option<Spectrum>,
    pub(super) table: LimitTable,
    pub(super) limit: LevelLimit,
}

pub(crate) fn run(arguments: &Compare) -> miette::Result<()> {
    let survey = match &arguments.spectrum {
        Some(path) => Some(survey(path, &arguments.layout)?),
        None => None,
    };
    let report = Report::new(arguments, survey)?;
    let document = json(&document::document(&report));
    if arguments.json {
        print(&document);
    }
    if !arguments.json || arguments.output.is_some() {
        let folder = arguments
            .case
            .folder(arguments.output.as_deref(), "compare");
        let mut staging = Staging::new(&folder)?;
        staging.write_figure("compare", &report.figure())?;
        staging.write_with("bands.csv", |file| document::band_table(&report, file))?;
        staging.write_with("growth.csv", |file| document::line_table(&report, file))?;
        staging.write("summary.json", document)?;
        let files = staging.publish()?;
        if !arguments.json {
            let text = report.readable();
            print(&format!(
                "{text}{}: {}\n",
                folder.display(),
                files.join(" ")
            ));
        }
    }
    print_remarks(&report.comparison.base().remarks);
    Ok(())
}

impl Report {
    /// The comparison; `survey` holds all spectra of `--spectrum`.
    pub(super) fn new(arguments: &Compare, survey: Option<Survey>) -> miette::Result<Self> {
        let case = arguments.case.read()?;
        let variants: Result<Vec<Variant>, _> = arguments
            .variants
            .iter()
            .map(|path| Variant::read(path))
            .collect();
        let variants = variants?;
        let traffic = match &arguments.traffic {
            Some(path) => Traffic::read(path)?,
            None => Traffic::of_case(speeds(&case, arguments)?),
        };
        let speeds = match &arguments.traffic {
            Some(_) => traffic
                .file
                .title
                .clone()
                .unwrap_or_else(|| "traffic".to_owned()),
            None => speeds(&case, arguments).map(|speeds| in_words(&speeds))?,
        };
        let (table, limit) = level_limit(&arguments.limit)?;
        let spectrum = survey
            .map(|survey| survey.choose(&arguments.choose))
            .transpose()?
            .map(|survey| survey.mean());
        if let (Some(spectrum), Some(path)) = (&spectrum, &arguments.spectrum) {
            let bands = riffel_case::traffic::bands_of(&case);
            if !bands.iter().any(|band| spectrum.level(*band).is_some()) {
                let error = riffel::Error::Measurement {
                    index: 0,
                    rule: "no band of the spectrum lies there",
                };
                Err(outside(path, &case, error))?;
            }
        }
        let steps = (1 + variants.len()) * traffic.file.vehicle.len();
        let progress = Progress::new("growth of the variants", steps);
        let comparison = Comparison::compute(
            &case,
            &variants,
            &traffic,
            spectrum.as_ref(),
            Some(&limit),
            &|by| progress.advance(by),
        )?;
        drop(progress);
        Ok(Self {
            case,
            speeds,
            comparison,
            spectrum,
            table,
            limit,
        })
    }

    /// The figure of what is reported.
    pub(super) fn figure(&self) -> riffel_plot::LineFigure {
        figure::figure(self)
    }

    fn readable(&self) -> String {
        let title = self.case.file.title.as_deref().unwrap_or("Comparison");
        let mut text = format!("{title}, {}\n", self.speeds);
        let mut header = vec![
            "",
            "fastest mm",
            "dB per 10⁶ passages",
            "change",
            "ridge Hz",
        ];
        if self.spectrum.is_some() {
            header.extend(["passages to limit", "MGT to limit"]);
        }
        let mut rows = table(&header);
        let base = self.comparison.base();
        for outcome in &self.comparison.outcomes {
            let FastestLine {
                wavelength,
                rate,
                at_edge,
            } = outcome.fastest;
            let change = 100.0 * (rate / base.fastest.rate - 1.0);
            let compared = base.fastest.rate > 0.0 && !std::ptr::eq(outcome, base);
            let edge = if at_edge { " (edge)" } else { "" };
            let mut row = vec![
                outcome.title.clone(),
                format!("{:.1}{edge}", 1e3 * wavelength),
                format!("{:+.3}", per_million(rate)),
                match compared {
                    true => format!("{change:+.0} %"),
                    false => String::new(),
                },
                outcome
                    .ridge_frequency
                    .map_or_else(String::new, |f| format!("{f:.0}")),
            ];
            if self.spectrum.is_some() {
                let mgt = outcome
                    .passages_to_limit
                    .map(|passages| outcome.growth.mgt(passages));
                row.push(when(outcome.passages_to_limit));
                row.push(mgt.map_or_else(String::new, number));
            }
            rows.add_row(row);
        }
        text += &format!("{rows}\n");
        text += &self.bands();
        text
    }

    /// Growth by band.
    fn bands(&self) -> String {
        let mut header = vec!["wavelength mm"];
        header.extend(
            self.comparison
                .outcomes
                .iter()
                .map(|outcome| outcome.title.as_str()),
        );
        let mut rows = table(&header);
        for (place, band) in self.comparison.bands.iter().enumerate().rev() {
            let mut row = vec![format!("{}", band.nominal_millimetres())];
            row.extend(
                self.comparison
                    .outcomes
                    .iter()
                    .map(|outcome| format!("{:+.3}", per_million(outcome.growth.band_rate(place)))),
            );
            rows.add_row(row);
        }
        format!("growth of the bands, dB per 10⁶ passages\n{rows}\n")
    }
}

/// Months that an outcome takes to its limit, if known.
pub(super) fn months_to_limit(outcome: &Outcome) -> Option<f64> {
    Some(outcome.passages_to_limit? / outcome.passages_per_day? / DAYS_PER_MONTH)
}

/// Speeds of the wheel of the case: as asked for, or the middle of its map.
fn speeds(case: &Case, arguments: &Compare) -> Result<SpeedDistribution, CliError> {
    let mean = match arguments.speed {
        Some(speed) => positive("--speed", speed)?,
        None => 0.5 * (case.speed.min() + case.speed.max()),
    };
    let deviation = arguments
        .speed_deviation
        .map_or(0.0, |deviation| deviation.si());
    SpeedDistribution::normal(mean, deviation).map_err(|error| CliError::Physics {
        input: "--speed-deviation".to_owned(),
        error,
    })
}

fn in_words(speeds: &SpeedDistribution) -> String {
    let kmh = 3.6 * speeds.mean();
    match 3.6 * speeds.deviation() {
        0.0 => format!("{kmh:.1} km/h"),
        deviation => format!("{kmh:.1} km/h with a standard deviation of {deviation:.1} km/h"),
    }
}
