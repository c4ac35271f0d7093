//! `riffel forecast`

mod dated;
mod document;
mod figure;
mod ground;
mod wear;

use dated::Dated;
use jiff::ToSpan;
use jiff::civil::Date;
use riffel::forecast::{ForecastBand, Reach, TrafficGrowth};
use riffel::roughness::LevelLimit;
use riffel_case::traffic::{
    DAYS_PER_MONTH, RailForecast, Traffic, TrafficOnCase, WearReport, bands_of,
};
use riffel_case::{Case, Variant};
use riffel_rail::{GroundRail, Limit, LimitTable, RailSpectrum, Survey};
use wear::wear_report;

use crate::arguments::{Forecast as Arguments, Ground, Horizon};
use crate::command::roughness::survey;
use crate::command::roughness::verdict::rail_in_words;
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{Progress, json, print, table};
use crate::staging::Staging;

pub(crate) use figure::{rate_panel, zero};
pub(crate) use ground::ground_rail;

/// What stands in the place of a number that the linear loop cannot give.
pub(crate) const BEYOND: &str = "beyond the linear range";

/// Everything that is reported.
pub(super) struct Report {
    pub(super) case: Case,
    pub(super) traffic: Traffic,
    pub(super) on: TrafficOnCase,
    /// The records of what was measured; none for a rail that will be ground.
    pub(super) survey: Option<Survey>,
    /// What the rail will be ground to.
    pub(super) ground: Option<GroundRail>,
    /// The rails, the one that leads first; there is one in every report.
    pub(super) rails: Vec<RailForecast>,
    /// Axle passages of the forecast.
    pub(super) passages: f64,
    pub(super) table: LimitTable,
    pub(super) limit: LevelLimit,
    /// Date of the spectrum.
    pub(super) date: Option<Date>,
    wear: Option<WearReport>,
    /// What is to be said of the records.
    warnings: Vec<String>,
}

/// A band that reaches its limit.
pub(super) struct Crossing<'a> {
    pub(super) band: &'a ForecastBand,
    pub(super) limit: f64,
    pub(super) passages: f64,
}

pub(crate) fn run(arguments: &Arguments) -> miette::Result<()> {
    let spectra = &arguments.spectra;
    let survey = match &spectra.spectrum {
        Some(path) => Some(survey(path, &spectra.layout)?),
        None => None,
    };
    let report = Report::new(arguments, survey)?;
    let document = json(&document::document(&report, arguments));
    if arguments.json {
        print(&document)?;
    }
    if !arguments.json || arguments.output.is_some() {
        let folder = arguments
            .case
            .folder(arguments.output.as_deref(), "forecast");
        let files = report.write(&folder, &document)?;
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
    print_remarks(&report.on.remarks);
    Ok(())
}

impl Report {
    /// The forecast of the rail that will be ground, or else of what was measured; `survey` holds all spectra of
    /// `--spectrum`.
    pub(super) fn new(arguments: &Arguments, survey: Option<Survey>) -> miette::Result<Self> {
        let case = arguments.case.read()?;
        let traffic = Traffic::read(&arguments.traffic)?;
        let (table, limit) = level_limit(&arguments.limit)?;
        let ground = ground_rail(&arguments.ground, &table, &limit)?;
        let dated = match (&ground, survey) {
            (None, Some(survey)) => Some(Dated::new(&arguments.spectra, survey)?),
            _ => None,
        };
        let progress = Progress::new("growth under traffic", traffic.file.vehicle.len());
        let on = traffic.on(&case, &bands_of(&case), &Variant::none(""), &|by| {
            progress.advance(by);
        })?;
        drop(progress);
        let measured: Vec<RailSpectrum> = match (&ground, &dated) {
            (Some(ground), _) => vec![ground.spectrum.clone().into()],
            (None, Some(dated)) => dated.now.rail_means(),
            (None, None) => Err(CliError::Argument {
                argument: "--spectrum",
                value: "left out".to_owned(),
                rule: "given, or else --ground or --from-limit".to_owned(),
            })?,
        };
        let rails =
            RailForecast::of_rails(&measured, &on.growth, Some(&limit)).map_err(|error| {
                let path = arguments.spectra.spectrum.as_deref();
                outside(&arguments.ground, path, &case, error)
            })?;
        let mut warnings = dated
            .as_ref()
            .map_or_else(Vec::new, |dated| dated.now.warnings.clone());
        warnings.extend(not_forecast(&measured, &rails, &case));
        let passages = passages(&arguments.horizon, &on)?;
        let measured_on = dated.as_ref().and_then(|dated| dated.date);
        let date = arguments.date.or(measured_on);
        let wear = match &dated {
            Some(dated) => wear_report(&arguments.spectra, dated, &on, &case)?,
            None => None,
        };
        Ok(Self {
            survey: dated.map(|dated| dated.now),
            ground,
            case,
            traffic,
            on,
            rails,
            passages,
            table,
            limit,
            date,
            wear,
            warnings,
        })
    }

    /// What is to be said of the records.
    pub(super) fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// Months that some passages take, if the traffic says how much of it there is.
    pub(super) fn months(&self, passages: f64) -> Option<f64> {
        Some(passages / self.on.passages_per_day? / DAYS_PER_MONTH)
    }

    /// The date after some passages, if it is before the year 10000.
    pub(super) fn date_after(&self, passages: f64) -> Option<Date> {
        let days = (passages / self.on.passages_per_day?).round();
        // Any date of the calendar is within four million days of any other.
        (days < 4e6)
            .then(|| self.date?.checked_add((days as i64).days()).ok())
            .flatten()
    }

    /// The rail that leads: its limit is reached first.
    pub(super) fn leading(&self) -> &RailForecast {
        &self.rails[0]
    }

    /// A rail in front of words on it, where there are several.
    pub(super) fn prefix(&self, rail: &RailForecast) -> String {
        match rail.name() {
            Some(name) if self.rails.len() > 1 => format!("{} ", rail_in_words(name)),
            _ => String::new(),
        }
    }

    /// Growth under the traffic, the same for every rail.
    pub(super) fn growth(&self) -> &TrafficGrowth {
        &self.on.growth
    }

    /// Crossings of the limit by a rail, the earliest first.
    pub(super) fn crossings<'a>(&self, rail: &'a RailForecast) -> Vec<Crossing<'a>> {
        let mut crossings: Vec<Crossing<'a>> = rail
            .forecast
            .reaches(&self.limit)
            .into_iter()
            .filter_map(|(band, limit, reach)| {
                Some(Crossing {
                    band,
                    limit,
                    passages: reach.passages()?,
                })
            })
            .collect();
        crossings.sort_by(|a, b| {
            let excess = |crossing: &Crossing<'_>| crossing.band.now.level - crossing.limit;
            a.passages
                .total_cmp(&b.passages)
                .then(excess(b).total_cmp(&excess(a)))
        });
        crossings
    }

    /// Passages in every unit that is known.
    pub(super) fn amount(&self, passages: f64) -> String {
        let mgt = self.growth().mgt(passages);
        let mut text = format!("{passages:.3e} axle passages = {} MGT", number(mgt));
        if let Some(months) = self.months(passages) {
            text += &format!(" = {} months", number(months));
        }
        if let Some(date) = self.date_after(passages) {
            text += &format!(" ({date})");
        }
        text
    }

    fn write(&self, folder: &std::path::Path, document: &str) -> miette::Result<Vec<String>> {
        let mut staging = Staging::new("forecast", folder)?;
        staging.write_figure("forecast", &self.figure())?;
        staging.write_with("bands.csv", |file| document::band_table(self, file))?;
        staging.write_with("growth.csv", |file| document::line_table(self, file))?;
        staging.write("summary.json", document)?;
        Ok(staging.publish()?)
    }

    /// The figure of what is reported.
    pub(super) fn figure(&self) -> riffel_plot::LineFigure {
        figure::figure(self)
    }

    fn readable(&self) -> String {
        let title = self.case.file.title.as_deref().unwrap_or("Growth forecast");
        let traffic = self.traffic.file.title.as_deref().unwrap_or("traffic");
        let mut text = format!("{title}, {traffic}\nafter {}\n", self.amount(self.passages));
        let mut header = vec![
            "wavelength mm",
            "now dB",
            "then dB",
            "limit dB",
            "dB per 10⁶ passages",
            "passages to limit",
            "wheel leaves rail",
        ];
        if self.names_rails() {
            header.insert(0, "rail");
        }
        let mut rows = table(&header);
        for row in self.rows() {
            rows.add_row(row);
        }
        text += &format!("{rows}\n");
        for sentence in self.findings() {
            text += &format!("{sentence}\n");
        }
        if let Some(wear) = &self.wear {
            text += &wear::readable(wear);
        }
        text
    }

    /// Whether the table by band has a column of rails.
    pub(super) fn names_rails(&self) -> bool {
        self.rails.len() > 1
    }

    /// The cells of the table by band, the rail that leads first and of each the longest wavelength; the name of the
    /// rail first, where there are several.
    pub(super) fn rows(&self) -> Vec<Vec<String>> {
        self.rails
            .iter()
            .flat_map(|rail| self.rows_of(rail))
            .collect()
    }

    fn rows_of(&self, rail: &RailForecast) -> Vec<Vec<String>> {
        let forecast = &rail.forecast;
        let limits = forecast.reaches(&self.limit);
        let name = rail.name().filter(|_| self.names_rails());
        let row = |band: &ForecastBand| {
            let limit = limits.iter().find(|limit| limit.0 == band);
            let then = forecast.level(band, self.passages);
            let cells = [
                format!("{}", band.now.band.nominal_millimetres()),
                format!("{:.1}", band.now.level),
                then.map_or_else(|| BEYOND.to_owned(), |level| format!("{level:.1}")),
                limit.map_or_else(String::new, |limit| format!("{:.1}", limit.1)),
                format!("{:+.3}", per_million(forecast.growth_rate(band))),
                limit.map_or_else(String::new, |limit| reached(limit.2)),
                when(forecast.linear_range([band]).passages),
            ];
            name.map(str::to_owned).into_iter().chain(cells).collect()
        };
        forecast.bands().iter().rev().map(row).collect()
    }

    /// What follows, in sentences; those on the rail that leads first.
    pub(super) fn findings(&self) -> Vec<String> {
        let mut findings: Vec<String> = self
            .rails
            .iter()
            .enumerate()
            .map(|(place, rail)| {
                let sentence = self.interval(rail);
                match (self.prefix(rail).trim_end(), place) {
                    ("", _) => sentence,
                    (name, 0) => format!("{name} leads: {sentence}"),
                    (name, _) => format!("{name}: {sentence}"),
                }
            })
            .collect();
        findings.extend(self.rails.iter().map(|rail| {
            let sentence = self.linear_range(rail);
            match self.prefix(rail).trim_end() {
                "" => sentence,
                name => format!("{name}: {sentence}"),
            }
        }));
        let decays = |rail: &RailForecast| {
            let mut bands = rail.forecast.bands().iter();
            bands.any(|band| rail.forecast.growth_rate(band) < 0.0)
        };
        if self.rails.iter().any(decays) {
            findings.push(
                "bands that decay: nothing in the model makes new roughness, so that in truth they fall to a \
                 floor and not for ever"
                    .to_owned(),
            );
        }
        let left_out = self.left_out();
        if let (Some(first), Some(last)) = (left_out.first(), left_out.last()) {
            findings.push(format!(
                "not forecast: {} bands from {first} to {last} mm that lie outside map.wavelength of the case",
                left_out.len()
            ));
        }
        findings
    }

    /// When a rail reaches the limit.
    fn interval(&self, rail: &RailForecast) -> String {
        let edition = &self.table.edition;
        let from = match &self.ground {
            Some(ground) => format!(" from {}", ground.words),
            None => String::new(),
        };
        match (self.crossings(rail).first(), rail.reach) {
            (Some(first), _) if first.passages == 0.0 => format!(
                "over the limit now: {edition} at {} mm by {:.1} dB",
                first.band.now.band.nominal_millimetres(),
                first.band.now.level - first.limit
            ),
            (Some(first), _) => format!(
                "grinding interval{from}: {edition} is reached at {} mm after {}",
                first.band.now.band.nominal_millimetres(),
                self.amount(first.passages)
            ),
            (None, Some(Reach::Never)) => format!("no band forecast ever reaches {edition}"),
            (None, _) => format!(
                "grinding interval{from}: {edition} is not reached before the wheel leaves the rail, where the forecast \
                 ends"
            ),
        }
    }

    /// How far the linear loop holds on a rail.
    fn linear_range(&self, rail: &RailForecast) -> String {
        let linear = rail.forecast.linear_range(rail.forecast.bands());
        let vehicle = &self.growth().vehicles()[linear.vehicle].name;
        match linear.passages {
            Some(0.0) => format!(
                "beyond the linear range now: |P₁| is {:.2} P₀ under \"{vehicle}\", so that wheel and rail part; \
                 corrugation then grows otherwise than the linear loop says, and nothing is forecast",
                linear.force_ratio
            ),
            Some(passages) => format!(
                "linear range: |P₁| is {:.2} P₀ now and reaches P₀ under \"{vehicle}\" after {}; there the wheel \
                 leaves the rail, and the forecast ends",
                linear.force_ratio,
                self.amount(passages)
            ),
            None => format!(
                "linear range: |P₁| is {:.2} P₀ now under \"{vehicle}\" and never reaches P₀",
                linear.force_ratio
            ),
        }
    }

    /// Nominal wavelengths of bands of the leading rail that were measured and are not forecast \[mm\], the shortest first.
    pub(super) fn left_out(&self) -> Vec<f64> {
        let rail = self.leading();
        let levels = rail.measured.spectrum.levels().iter();
        levels
            .map(|level| level.band)
            .filter(|band| {
                !rail
                    .forecast
                    .bands()
                    .iter()
                    .any(|own| own.now.band == *band)
            })
            .map(|band| band.nominal_millimetres())
            .collect()
    }
}

/// The limit of levels of a name or a file.
pub(crate) fn level_limit(name: &str) -> miette::Result<(LimitTable, LevelLimit)> {
    let table = LimitTable::find(name)?;
    match &table.limit {
        Limit::Levels(limit) => {
            let limit = limit.clone();
            Ok((table, limit))
        }
        Limit::Rms(_) => Err(CliError::Argument {
            argument: "--limit",
            value: name.to_owned(),
            rule:
                "a table of one-third-octave levels: an RMS along the rail does not follow from a \
                   spectrum"
                    .to_owned(),
        })?,
    }
}

/// Axle passages of the forecast: as asked for, or a year.
pub(crate) fn passages(horizon: &Horizon, on: &TrafficOnCase) -> Result<f64, CliError> {
    for (argument, value) in [
        ("--passages", horizon.passages),
        ("--mgt", horizon.mgt),
        ("--months", horizon.months),
    ] {
        if let Some(value) = value.filter(|value| !(value.is_finite() && *value > 0.0)) {
            return Err(CliError::Argument {
                argument,
                value: value.to_string(),
                rule: "finite and greater than zero".to_owned(),
            });
        }
    }
    if let Some(passages) = horizon.passages {
        return Ok(passages);
    }
    if let Some(mgt) = horizon.mgt {
        return Ok(on.growth.passages(mgt));
    }
    on.passages_per_month()
        .map(|per_month| per_month * horizon.months.unwrap_or(12.0))
        .ok_or_else(|| CliError::Argument {
            argument: "--months",
            value: horizon
                .months
                .map_or("left out".to_owned(), |months| months.to_string()),
            rule:
                "replaced by --passages or --mgt, for the traffic file says under [line] neither \
                   passages_per_day nor mgt_per_year"
                    .to_owned(),
        })
}

/// A spectrum without a band in the window of the case.
pub(crate) fn outside(
    ground: &Ground,
    spectrum: Option<&std::path::Path>,
    case: &Case,
    error: riffel::Error,
) -> CliError {
    let (argument, value) = match (&ground.ground, &ground.from_limit, spectrum) {
        (Some(name), _, _) => ("--ground", name.clone()),
        (_, Some(decibels), _) => ("--from-limit", decibels.clone()),
        (_, _, spectrum) => (
            "--spectrum",
            spectrum.map_or_else(String::new, |path| path.display().to_string()),
        ),
    };
    CliError::Argument {
        argument,
        value,
        rule: format!(
            "of bands between {:.0} and {:.0} mm, map.wavelength of the case: {error}",
            1e3 * case.wavelength.min(),
            1e3 * case.wavelength.max()
        ),
    }
}

/// A sentence on each rail that has no band in the window of the case, beside others that have.
pub(crate) fn not_forecast<'a>(
    measured: &'a [RailSpectrum],
    rails: &'a [RailForecast],
    case: &'a Case,
) -> impl Iterator<Item = String> + 'a {
    let names = measured.iter().filter_map(|rail| rail.rail.as_deref());
    names
        .filter(|name| rails.iter().all(|rail| rail.name() != Some(name)))
        .map(|name| {
            format!(
                "{} has no band between {:.0} and {:.0} mm, map.wavelength of the case, and is left out",
                rail_in_words(name),
                1e3 * case.wavelength.min(),
                1e3 * case.wavelength.max()
            )
        })
}

/// Change of level in a million passages \[dB\].
pub(crate) fn per_million(rate: f64) -> f64 {
    20.0 / std::f64::consts::LN_10 * 1e6 * rate
}

/// Passages to an event.
pub(crate) fn when(passages: Option<f64>) -> String {
    match passages {
        Some(0.0) => "now".to_owned(),
        Some(passages) => format!("{passages:.2e}"),
        None => "never".to_owned(),
    }
}

/// When a limit is reached.
pub(crate) fn reached(reach: Reach) -> String {
    match reach {
        Reach::BeyondLinearRange => BEYOND.to_owned(),
        reach => when(reach.passages()),
    }
}

/// Three digits, as one writes them.
pub(crate) fn number(value: f64) -> String {
    match value.abs() {
        size if size >= 1e5 => format!("{value:.2e}"),
        size if size >= 100.0 => format!("{value:.0}"),
        size if size >= 10.0 => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}
