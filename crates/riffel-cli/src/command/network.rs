//! `riffel network`

use riffel_answers::ExpectedRates;
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::range;
use riffel_network::{
    Aim, Budget, DefectKind, ExpectedGrowth, GrindingPlan, Judgement, NetworkError, SectionGrowth, Status, Store,
    StoreSettings, StripChart, SurveyFile, WorstPlace, growth, left_out_of_growth, plan, status, worst,
};
use riffel_rail::{LimitTable, read_date};
use serde::Serialize;

use crate::arguments::{CaseArguments, Judged, Network, NetworkCommand, Posterior, network, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{json, print, table};
use crate::progress::Progress;
use crate::staging::Staging;

/// Sites of a plan that the table shows.
const SITES: usize = 40;

pub(crate) fn run(arguments: &Network) -> miette::Result<()> {
    match &arguments.command {
        NetworkCommand::Ingest(arguments) => ingest(arguments),
        NetworkCommand::Status(arguments) => {
            let store = Store::open(&arguments.store)?;
            let found = status(&store)?;
            say(arguments.json, &found, || status_in_words(&found))?;
            tell_left_out(&store)
        }
        NetworkCommand::Worst(arguments) => {
            let (store, judgement, section) = judged(&arguments.judged)?;
            let until = arguments.until.as_deref().map(|text| day("--until", text));
            let most = arguments.most as usize;
            let found = worst(&store, &judgement, section, until.transpose()?, most)?;
            say(arguments.judged.json, &found, || worst_in_words(&found))?;
            print_remarks(judgement.remark().as_slice());
            tell_left_out(&store)
        }
        NetworkCommand::Growth(arguments) => {
            let (store, judgement, section) = judged(&arguments.judged)?;
            let judgement = expecting(&store, judgement, &arguments.expected)?;
            let between = match (&arguments.from, &arguments.to) {
                (Some(from), Some(to)) => Some([day("--from", from)?, day("--to", to)?]),
                _ => None,
            };
            let mut found = growth(&store, &judgement, section, between)?;
            found.truncate(arguments.most as usize);
            say(arguments.judged.json, &found, || growth_in_words(&found))?;
            print_remarks(judgement.remark().as_slice());
            print_remarks(&left_out_of_growth(&store, between)?);
            tell_left_out(&store)
        }
        NetworkCommand::Chart(arguments) => chart(arguments),
        NetworkCommand::Plan(arguments) => {
            let (store, judgement, section) = judged(&arguments.judged)?;
            let judgement = expecting(&store, judgement, &arguments.expected)?;
            let budget = match (arguments.length, arguments.money, arguments.cost_per_metre) {
                (Some(length), ..) => Budget::of_length(positive("--length", length)?),
                (None, money, per_metre) => Budget {
                    money: money.unwrap_or(0.0),
                    per_metre: per_metre.unwrap_or(1.0),
                    per_site: arguments.cost_per_site,
                },
            };
            let aim = match arguments.most_track {
                true => Aim::MostTrack,
                false => Aim::WorstFirst,
            };
            let found = plan(&store, &judgement, section, arguments.months, &budget, aim)?;
            say(arguments.judged.json, &found, || plan_in_words(&found, arguments.money.is_some()))?;
            print_remarks(&found.remarks);
            tell_left_out(&store)
        }
        NetworkCommand::Check(arguments) => {
            let store = Store::open(&arguments.store)?;
            tell_left_out(&store)?;
            match store.damaged().count() {
                0 => Ok(print(&format!("{} surveys are whole\n", store.surveys()?.len()))?),
                damaged => Err(NetworkError::NotWhole { damaged }.into()),
            }
        }
    }
}

/// Name the surveys of which something is lost or damaged.
fn tell_left_out(store: &Store) -> miette::Result<()> {
    let damaged = store.damaged();
    let remarks: Vec<String> = damaged.map(|error| format!("{error}; the survey is left out")).collect();
    print_remarks(&remarks);
    Ok(())
}

fn say(as_json: bool, found: &impl Serialize, words: impl FnOnce() -> String) -> miette::Result<()> {
    let text = if as_json { json(found) } else { words() };
    Ok(print(&text)?)
}

fn ingest(arguments: &network::Ingest) -> miette::Result<()> {
    let resolution = arguments.resolution;
    let settings = StoreSettings { resolution: resolution.map(|length| positive("--resolution", length)).transpose()? };
    let store = Store::create_or_open(&arguments.store, settings)?;
    let file = SurveyFile::check(&arguments.path)?;
    let file = file.rename(arguments.rename.iter().cloned().collect())?;
    let progress = Progress::new(riffel_keys::say!(progress_taking_in_blocks), file.rows() as usize);
    let (line, date) = (&arguments.line, &arguments.date);
    let found = store.ingest(line, date, &file, arguments.replace, &|by| progress.advance(by))?;
    drop(progress);
    say(arguments.json, &found, || {
        if found.there_already {
            return format!("{}, {}: is there already\n", found.line, found.date);
        }
        let rails = found.measured.iter();
        let rails: Vec<String> = rails.map(|(rail, cells)| format!("{rail} {cells} cells")).collect();
        format!("{}, {}: {}, each {} m long\n", found.line, found.date, rails.join(", "), found.resolution_m)
    })?;
    let twice = found.goes_back.iter().map(|goes_back| {
        format!(
            "line {}: {}: places go back from {:.3} m to {:.3} m, as at a long kilometre; cells of both stretches hold the mean of their energies",
            goes_back.line, goes_back.rail, goes_back.end_m, goes_back.from_m
        )
    });
    print_remarks(&twice.collect::<Vec<String>>());
    let renamed = found.renamed.iter();
    let renamed = renamed.map(|(old, new)| format!("rail {old} of the file is rail {new} of the line"));
    print_remarks(&renamed.collect::<Vec<_>>());
    if let [_, ..] = &found.new_rails[..] {
        print_remarks(&[format!(
            "the line has not had rail {} before; if it has another name there, ingest the file again with --rename OLD=NEW --replace",
            found.new_rails.join(", ")
        )]);
    }
    if let Some(alike) = &found.alike {
        print_remarks(&[format!(
            "the store has a line \"{alike}\", and \"{}\" is another one; if the same was meant, delete the folder of this one in \
             the store and ingest the file under that name",
            found.line
        )]);
    }
    Ok(())
}

fn chart(arguments: &network::Chart) -> miette::Result<()> {
    let (store, judgement, section) = judged(&arguments.judged)?;
    let (line, rail) = (arguments.line.as_deref(), arguments.rail.as_deref());
    let chart = StripChart::new(&store, &judgement, section, line, rail)?;
    tell_left_out(&store)?;
    if chart.lines.is_empty() {
        return Ok(print("no survey is in the store\n")?);
    }
    if arguments.judged.json {
        print(&json(&chart))?;
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = match &arguments.output {
        Some(folder) => folder.clone(),
        None => {
            let mut name = arguments.judged.store.file_name().unwrap_or_default().to_owned();
            name.push("-chart");
            name.into()
        }
    };
    let mut staging = Staging::new("network", &folder)?;
    staging.write_picture("chart", &chart.figure().picture().map_err(CliError::from)?)?;
    staging.write_with("chart.csv", |file| chart.csv(file))?;
    let files = staging.publish()?.join(" ");
    if arguments.judged.json {
        return Ok(());
    }
    print(&format!("{}{}: {files}\n", chart_in_words(&chart), folder.display()))?;
    if let left_out @ 1.. = chart.lines_not_drawn() {
        print_remarks(&[format!(
            "the picture holds the longest lines; {left_out} more are in chart.csv (--line draws one)"
        )]);
    }
    Ok(())
}

fn chart_in_words(chart: &StripChart) -> String {
    let mut rows = table(&["line", "date", "km", "km over limit", "worst", "at km"]);
    for line in &chart.lines {
        for survey in &line.surveys {
            let length = |over: bool| -> f64 {
                let sections = survey.sections.iter();
                sections
                    .filter(|section| !over || section.rms_over_limit > 1.0)
                    .fold(0.0, |sum, section| sum + section.to_m - section.from_m)
            };
            let worst = survey.sections.iter().max_by(|one, other| one.rms_over_limit.total_cmp(&other.rms_over_limit));
            rows.add_row([
                line.line.clone(),
                survey.date.clone(),
                kilometres(length(false)),
                kilometres(length(true)),
                worst.map_or_else(String::new, |worst| format!("{:.2}", worst.rms_over_limit)),
                worst.map_or_else(String::new, |worst| kilometres(worst.from_m)),
            ]);
        }
    }
    format!("{rows}\n")
}

/// Store, limit and length of a section.
fn judged(arguments: &Judged) -> miette::Result<(Store, Judgement, f64)> {
    let store = Store::open(&arguments.store)?;
    let judgement = Judgement::new(&store, &LimitTable::find(&arguments.limit)?)?;
    Ok((store, judgement, positive("--section", arguments.section)?))
}

/// The same with the growth that the traffic of a line is expected to make.
fn expecting(store: &Store, judgement: Judgement, expected: &network::Expected) -> miette::Result<Judgement> {
    let Some(case) = &expected.case else {
        return Ok(judgement);
    };
    let bands = judgement.ends_of_bands();
    let posterior = Posterior { posterior: expected.posterior.clone() };
    let growth = match posterior.draws(&CaseArguments::of(case, &[]))? {
        Some(draws) => {
            let progress = Progress::new(riffel_keys::say!(progress_draws_of_calibration), draws.count());
            ExpectedRates::over(&draws, &bands, &|by| progress.advance(by))
        }
        None => {
            let case = Case::read(case, &[])?;
            let traffic = expected.traffic.as_deref().map(Traffic::read).transpose()?;
            ExpectedRates::new(&case, traffic.as_ref(), &bands)
        }
    };
    let growth = growth.map_err(CliError::from)?;
    print_remarks(growth.without_rate.as_slice());
    let growth = growth.of_bands.into_iter().map(|growth| {
        growth.map(|growth| ExpectedGrowth { median: growth.median, band_50: growth.band_50, band_80: growth.band_80 })
    });
    Ok(judgement.expecting(store, expected.line.as_deref(), growth.collect())?)
}

fn day(argument: &'static str, text: &str) -> Result<jiff::civil::Date, CliError> {
    read_date(text).map_err(|sentence| CliError::Range { argument, message: format!(": {sentence}") })
}

/// Between what months: "9.1–14.2", "more than 9.1" where there may be no end.
fn months_of([early, late]: [f64; 2]) -> String {
    match late.is_finite() {
        true => range([early, late], |months| format!("{months:.1}")),
        false => format!("more than {early:.1}"),
    }
}

fn millimetres(band: [f64; 2]) -> String {
    range(band, |end| format!("{:.0}", 1e3 * end))
}

/// With its sign, which nought does not have.
fn tenths(value: f64) -> String {
    match format!("{value:+.1}").as_str() {
        "-0.0" | "+0.0" => "0.0".to_owned(),
        text => text.to_owned(),
    }
}

fn kilometres(metres: f64) -> String {
    format!("{:.3}", 1e-3 * metres)
}

fn status_in_words(status: &Status) -> String {
    let mut header = vec!["line", "surveys", "latest", "from km", "to km", "rails km"]
        .into_iter()
        .map(str::to_owned)
        .collect::<Vec<_>>();
    let bands = status.bands_m.iter();
    header.extend(bands.map(|&band| format!("rms {} mm µm", millimetres(band))));
    let mut rows = table(&header);
    for line in &status.lines {
        let measured: f64 = line.measured_m.iter().map(|(_, length)| length).sum();
        let mut row = vec![
            line.line.clone(),
            line.dates.len().to_string(),
            line.dates.last().cloned().unwrap_or_default(),
            kilometres(line.ends_m[0]),
            kilometres(line.ends_m[1]),
            kilometres(measured),
        ];
        let cell = |rms: &Option<f64>| rms.map_or_else(String::new, |rms| format!("{:.2}", 1e6 * rms));
        row.extend(line.rms_m.iter().map(cell));
        rows.add_row(row);
    }
    format!("{rows}\nsurveys: {}, in cells of {} m\n", status.surveys, status.resolution_m)
}

fn worst_in_words(places: &[WorstPlace]) -> String {
    if places.is_empty() {
        return "no section is known in a band that has a limit\n".to_owned();
    }
    let mut rows =
        table(&["line", "date", "rail", "from km", "to km", "band mm", "rms µm", "over limit", "kind", "dB a year"]);
    for place in places {
        rows.add_row([
            place.line.clone(),
            place.date.clone(),
            place.rail.clone(),
            kilometres(place.from_m),
            kilometres(place.to_m),
            millimetres(place.band_m),
            format!("{:.2}", 1e6 * place.rms_m),
            format!("{:.2}", place.rms_over_limit),
            place.kind.map_or("", DefectKind::name).to_owned(),
            place.growth_db_per_year.map_or_else(String::new, tenths),
        ]);
    }
    format!("{rows}\n")
}

fn growth_in_words(sections: &[SectionGrowth]) -> String {
    let expected = sections.iter().any(|section| section.expected_growth_db_per_year.is_some());
    let mut header = vec![
        "line",
        "rail",
        "from km",
        "to km",
        "band mm",
        "between",
        "rms µm",
        "dB a year",
        "surveys",
        "over limit",
        "kind",
        "months to limit (80 %)",
    ];
    header.extend(expected.then_some("expected dB a year (80 %)"));
    let mut rows = table(&header);
    for section in sections {
        let [before, after] = section.rms_m.map(|rms| 1e6 * rms);
        let mut row = vec![
            section.line.clone(),
            section.rail.clone(),
            kilometres(section.from_m),
            kilometres(section.to_m),
            millimetres(section.band_m),
            section.dates.join(" "),
            format!("{before:.2} → {after:.2}"),
            match (section.growth_db_per_year, section.growth_error_db_per_year) {
                (None, _) => String::new(),
                _ if section.ground => "ground".to_owned(),
                (Some(growth), Some(error)) => format!("{} ± {error:.1}", tenths(growth)),
                (Some(growth), None) => tenths(growth),
            },
            section.surveys.to_string(),
            format!("{:.2}", section.rms_over_limit),
            section.kind.map_or("", DefectKind::name).to_owned(),
            section.months_to_limit.map_or_else(
                || match section.ground {
                    true => "not known".to_owned(),
                    false => "no growth".to_owned(),
                },
                |months| match (months > 0.0, section.months_to_limit_band_80) {
                    (true, Some(band)) => format!("{months:.1} ({})", months_of(band)),
                    (true, None) => format!("{months:.1}"),
                    (false, _) => "over it".to_owned(),
                },
            ),
        ];
        row.extend(section.expected_growth_db_per_year.map(|expected| {
            let [low, high] = expected.band_80.map(tenths);
            format!("{} ({low} to {high})", tenths(expected.median))
        }));
        rows.add_row(row);
    }
    format!("{rows}\n")
}

fn plan_in_words(plan: &GrindingPlan, money: bool) -> String {
    let mut header = vec!["line", "from km", "to km", "over limit"];
    header.extend(money.then_some("cost"));
    let mut rows = table(&header);
    for site in plan.sites.iter().take(SITES) {
        let mut row = vec![
            site.line.clone(),
            kilometres(site.from_m),
            kilometres(site.to_m),
            format!("{:.2}", site.rms_over_limit),
        ];
        row.extend(money.then(|| format!("{:.0}", site.cost)));
        rows.add_row(row);
    }
    let mut text = match plan.sites.is_empty() {
        true => String::new(),
        false => format!("{rows}\n"),
    };
    if plan.sites.len() > SITES {
        text += &format!("and {} more sites: --json has them all\n", plan.sites.len() - SITES);
    }
    let cost = match money {
        true => format!(" for {:.0}", plan.cost),
        false => String::new(),
    };
    let least = match plan.least_left_over_limit_m < plan.left_over_limit_m {
        true => format!(", and no plan for this leaves less than {} km", kilometres(plan.least_left_over_limit_m)),
        false => String::new(),
    };
    text + &format!(
        "in {} months {} km of track are over the limit; {} km are ground{cost}, {} km are left{least}\n",
        plan.months,
        kilometres(plan.over_limit_m),
        kilometres(plan.length_m),
        kilometres(plan.left_over_limit_m)
    )
}
