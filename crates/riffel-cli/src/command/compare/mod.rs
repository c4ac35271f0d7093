//! `riffel compare`

mod document;
mod figure;

use riffel::forecast::SpeedDistribution;
use riffel::roughness::LevelLimit;
use riffel_case::traffic::{RailForecast, Traffic};
use riffel_case::what_if::{Comparison, Effect, FastestLine, Outcome};
use riffel_case::{Case, Hold, Variant};
use riffel_keys::CaseError;
use riffel_rail::{GroundRail, LimitTable, RailSpectrum, Survey};

use super::forecast::{
    ground_rail, level_limit, not_forecast, number, outside, per_million, reached, when,
};
use super::roughness::survey;
use super::roughness::verdict::rail_in_words;
use crate::arguments::Compare;
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{Progress, json, print, table};
use crate::staging::Staging;

/// Everything that is reported.
pub(super) struct Report {
    pub(super) case: Case,
    /// What was asked to be held.
    hold: Option<Hold>,
    pub(super) speeds: String,
    pub(super) comparison: Comparison,
    /// What the rail will be ground to, if that is where the spectrum comes from.
    pub(super) ground: Option<GroundRail>,
    /// What is to be said of the records.
    warnings: Vec<String>,
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
        print(&document)?;
    }
    if !arguments.json || arguments.output.is_some() {
        let folder = arguments
            .case
            .folder(arguments.output.as_deref(), "compare");
        let mut staging = Staging::new("compare", &folder)?;
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
            ))?;
        }
    }
    print_remarks(report.warnings());
    print_remarks(&report.effects());
    print_remarks(&report.comparison.base().remarks);
    Ok(())
}

impl Report {
    /// The comparison; `survey` holds all spectra of `--spectrum`.
    pub(super) fn new(arguments: &Compare, survey: Option<Survey>) -> miette::Result<Self> {
        let case = arguments.case.read()?;
        let hold = arguments.hold.map(Hold::from);
        let variants: Result<Vec<Variant>, CaseError> = arguments
            .variants
            .iter()
            .map(|path| {
                let mut variant = Variant::read(path)?;
                variant.hold = hold;
                Ok(variant)
            })
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
        let ground = ground_rail(&arguments.ground, &table, &limit)?;
        let mut warnings = Vec::new();
        let rails: Vec<RailSpectrum> = match (&ground, survey) {
            (Some(ground), _) => vec![ground.spectrum.clone().into()],
            (None, Some(survey)) => {
                let survey = survey.choose(&arguments.choose)?;
                warnings.extend(survey.warnings.iter().cloned());
                survey.rail_means()
            }
            (None, None) => Vec::new(),
        };
        if !rails.is_empty() {
            let bands = riffel_case::traffic::bands_of(&case);
            let known = |rail: &RailSpectrum| {
                let mut bands = bands.iter();
                bands.any(|band| rail.spectrum.level(*band).is_some())
            };
            if !rails.iter().any(known) {
                let error = riffel::Error::Measurement {
                    index: 0,
                    rule: "no band of the spectrum lies there",
                };
                let path = arguments.spectrum.as_deref();
                Err(outside(&arguments.ground, path, &case, error))?;
            }
        }
        let steps = (1 + variants.len()) * traffic.file.vehicle.len();
        let progress = Progress::new("growth of the variants", steps);
        let comparison =
            Comparison::compute(&case, &variants, &traffic, &rails, Some(&limit), &|by| {
                progress.advance(by)
            })?;
        drop(progress);
        warnings.extend(not_forecast(&rails, &comparison.base().rails, &case));
        Ok(Self {
            case,
            hold,
            speeds,
            comparison,
            ground,
            warnings,
            table,
            limit,
        })
    }

    /// The figure of what is reported.
    pub(super) fn figure(&self) -> riffel_plot::LineFigure {
        figure::figure(self)
    }

    /// What the reader should know of variants: that a part or all has no effect, that less friction means less
    /// traction.
    pub(super) fn effects(&self) -> Vec<String> {
        let outcomes = self.comparison.outcomes.iter();
        outcomes
            .flat_map(|outcome| {
                let kept = (self.hold.is_none() && outcome.held.contains(&Hold::Ratio)).then(|| {
                    format!(
                        "\"{}\" keeps the tractive ratio: the traction force changes with friction and load; \
                         --hold force keeps the force",
                        outcome.title
                    )
                });
                outcome.effect.sentence().map(str::to_owned).into_iter().chain(kept)
            })
            .collect()
    }

    /// Heads of the table without that of the titles: those of what is known of some outcome.
    pub(super) fn header(&self) -> Vec<&'static str> {
        let mut header = vec!["fastest mm", "dB per 10⁶ passages", "change"];
        if self.holds() {
            header.push("held");
        }
        header.push("ridge Hz");
        if self.names_rails() {
            header.push("rail");
        }
        if self.leading().is_some() {
            header.extend(["passages to limit", "MGT to limit"]);
        }
        if self.counts_months() {
            header.push("months to limit");
        }
        header
    }

    /// The cells of an outcome under the [`header`](Self::header).
    pub(super) fn row(&self, outcome: &Outcome) -> Vec<String> {
        let FastestLine {
            wavelength,
            rate,
            at_edge,
        } = outcome.fastest;
        let edge = if at_edge { " (edge)" } else { "" };
        let change = outcome.change_from(self.comparison.base());
        let mut row = vec![
            format!("{:.1}{edge}", 1e3 * wavelength),
            format!("{:+.3}", per_million(rate)),
            match &outcome.effect {
                Effect::CannotAct(_) => "cannot act".to_owned(),
                Effect::ChangesNothing(_) => "changes nothing".to_owned(),
                _ => change.map_or_else(String::new, |change| format!("{:+.0} %", 100.0 * change)),
            },
        ];
        if self.holds() {
            row.push(outcome.held_name().unwrap_or_default().to_owned());
        }
        let ridge = outcome.ridge_frequency;
        row.push(ridge.map_or_else(String::new, |f| format!("{f:.0}")));
        if self.names_rails() {
            let rail = outcome.leading().and_then(RailForecast::name);
            row.push(rail.unwrap_or_default().to_owned());
        }
        if let Some(reach) = outcome.reach() {
            let mgt = reach
                .passages()
                .map(|passages| outcome.growth.mgt(passages));
            row.push(reached(reach));
            row.push(mgt.map_or_else(String::new, number));
        }
        if self.counts_months() {
            let months = outcome.months_to_limit();
            row.push(months.map_or_else(String::new, number));
        }
        row
    }

    /// The rail that leads in the case as it is; none where no spectrum was given.
    pub(super) fn leading(&self) -> Option<&RailForecast> {
        self.comparison.base().leading()
    }

    /// Whether there are several rails, of which each outcome names the one that leads.
    pub(super) fn names_rails(&self) -> bool {
        self.comparison.base().rails.len() > 1
    }

    /// What is to be said of the records.
    pub(super) fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// A rail in front of words on it, where there are several.
    pub(super) fn prefix(&self, rail: &RailForecast) -> String {
        match rail.name() {
            Some(name) if self.names_rails() => format!("{} ", rail_in_words(name)),
            _ => String::new(),
        }
    }

    /// " on rail low", where there are several.
    pub(super) fn on(&self, rail: &RailForecast) -> String {
        match self.prefix(rail).trim_end() {
            "" => String::new(),
            name => format!(" on {name}"),
        }
    }

    /// Whether some variant holds a part of the mean state.
    fn holds(&self) -> bool {
        let mut outcomes = self.comparison.outcomes.iter();
        outcomes.any(|outcome| !outcome.held.is_empty())
    }

    fn counts_months(&self) -> bool {
        self.leading().is_some() && self.comparison.base().passages_per_day.is_some()
    }

    fn readable(&self) -> String {
        let title = self.case.file.title.as_deref().unwrap_or("Comparison");
        let mut text = format!("{title}, {}\n", self.speeds);
        if let Some(ground) = &self.ground {
            text += &format!("from {} to {}\n", ground.words, self.table.edition);
        }
        let mut header = vec![""];
        header.extend(self.header());
        let mut rows = table(&header);
        for outcome in &self.comparison.outcomes {
            let mut row = vec![outcome.title.clone()];
            row.extend(self.row(outcome));
            rows.add_row(row);
        }
        text += &format!("{rows}\n");
        if self.names_rails() {
            text += "passages, MGT and months are those of the rail named, which leads; summary.json has every rail\n";
        }
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

/// Speeds of the wheel of the case: as asked for, or the middle of its map.
fn speeds(case: &Case, arguments: &Compare) -> Result<SpeedDistribution, CliError> {
    let mean = match &arguments.speed {
        Some(speed) => speed.within("--speed")?,
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
