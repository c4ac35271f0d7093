//! `riffel map`

use riffel_answers::map::{BayGrowth, MapAnswer, ObservationCount, growth_in_words, growth_over, map_csv, map_netcdf};
use riffel_answers::ridge::{BranchDocument, branches_csv, ridge_csv};
use riffel_answers::{LineGrowth, capital, for_whom};
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_plot::Observation;

use crate::arguments::{Map, covering};
use crate::error::CliError;
use crate::messages::{language, print_remarks};
use crate::observations;
use crate::output::{json, table};
use crate::posterior::over;
use crate::progress::Progress;
use crate::results::Results;
use crate::staging::Staging;

/// Rows of the table on the terminal.
const TABLE_ROWS: usize = 9;

pub(crate) fn run(arguments: &Map) -> miette::Result<()> {
    if arguments.wheels {
        return super::wheels::run(arguments);
    }
    let case = arguments.case.read_at(arguments.position)?;
    case.check_window()?;
    let curve = match (&arguments.wavelength, &arguments.speed) {
        (Some(wavelength), Some(speed)) => Some((wavelength.within("--wavelength")?, speed.within("--speed")?)),
        _ => None,
    };
    let case = match curve {
        Some((wavelength, _)) => covering(&case, wavelength, wavelength)?,
        None => case,
    };
    let observations = match &arguments.observations {
        Some(path) => observations::read(path)?,
        None => Vec::new(),
    };
    let progress = Progress::new(riffel_keys::say!(progress_growth_map), case.speed.points());
    let mut answer = MapAnswer::new(&case, |rows| progress.advance(rows));
    drop(progress);
    let traffic = arguments.traffic.as_deref().map(Traffic::read).transpose()?;
    let draws = arguments.posterior.draws(&arguments.case)?;
    let over = over(draws.as_ref(), growth_over)?;
    // The calibration knows more than the case says.
    if over.is_none() {
        answer.under_traffic = Some(LineGrowth::new(&case, traffic.as_ref())?);
    }
    answer.over_posterior = over;
    if arguments.bay {
        let rows = case.speed.points() * BayGrowth::map_count();
        let progress = Progress::new(riffel_keys::say!(progress_bay), rows);
        let bay = BayGrowth::new(&case, curve, |rows| progress.advance(rows))?;
        answer.bay = Some(bay);
    }
    if arguments.observations.is_some() {
        answer.observations = Some(ObservationCount::new(&case, &observations));
    }
    let document = json(&answer.document(&case));
    let results = Results::of("map", &arguments.case, &arguments.results);
    results.hand_out(
        || document.clone(),
        |staging| {
            write_files(staging, &case, &answer, observations, &document)?;
            match &answer.bay {
                Some(bay) => write_bay(staging, &case, bay),
                None => Ok(()),
            }
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&case.remarks);
    Ok(())
}

fn write_files(
    staging: &mut Staging,
    case: &Case,
    answer: &MapAnswer,
    observations: Vec<Observation>,
    document: &str,
) -> Result<(), CliError> {
    let figure = answer.figure(case, observations);
    let MapAnswer { map, ridge, .. } = answer;
    staging.write_picture("map", &figure.picture()?)?;
    staging.write("map.html", figure.html()?)?;
    let progress = Progress::new(riffel_keys::say!(progress_writing_map), case.speed.points());
    staging.write_with("map.csv", |file| map_csv(map, file, |rows| progress.advance(rows)))?;
    drop(progress);
    map_netcdf(map, &figure.title, &staging.path("map.nc"))?;
    staging.write_with("ridge.csv", |file| ridge_csv(ridge, file))?;
    staging.write_with("branches.csv", |file| branches_csv(ridge, file))?;
    if let Some(over) = &answer.over_posterior {
        staging.write_with("posterior.csv", |file| over.table().csv(file))?;
    }
    staging.write("summary.json", document)
}

fn write_bay(staging: &mut Staging, case: &Case, bay: &BayGrowth) -> Result<(), CliError> {
    let (maps, curves) = (bay.map_figure(case), bay.curve_figure(case));
    for (name, picture, html) in
        [("bay-map", maps.picture()?, maps.html()?), ("bay", curves.picture()?, curves.html()?)]
    {
        staging.write_picture(name, &picture)?;
        staging.write(&format!("{name}.html"), html)?;
    }
    staging.write_with("bay.csv", |file| bay.position_csv(file))?;
    staging.write_with("bay-wavelength.csv", |file| bay.wavelength_csv(file))?;
    let (mean, ridge) = bay.mean();
    let progress = Progress::new(riffel_keys::say!(progress_writing_bay), case.speed.points());
    staging.write_with("bay-mean.csv", |file| map_csv(mean, file, |rows| progress.advance(rows)))?;
    drop(progress);
    map_netcdf(mean, "Mean over the bay", &staging.path("bay-mean.nc"))?;
    staging.write_with("bay-mean-ridge.csv", |file| ridge_csv(ridge, file))?;
    staging.write_with("bay-mean-branches.csv", |file| branches_csv(ridge, file))
}

/// The ridge at a few speeds, and its branches in a sentence.
fn readable(case: &Case, answer: &MapAnswer) -> String {
    let ridge = &answer.ridge;
    let branches = BranchDocument::sentence(&answer.branches);
    let mut table = table(&[
        "speed km/h",
        "wavelength mm",
        "frequency Hz",
        "Re Ŵ₁",
        "growth rate per passage",
        "passages to double",
        "",
    ]);
    let last = ridge.points.len().saturating_sub(1);
    let rows = TABLE_ROWS.min(ridge.points.len());
    // As many digits as tell the rows apart.
    let step = 3.6 * (case.speed.max() - case.speed.min()) / rows as f64;
    let digits = (1.0 - step.log10()).floor().clamp(0.0, 3.0) as usize;
    for row in 0..rows {
        let point = &ridge.points[row * last / (rows - 1).max(1)];
        let grows = point.growth_rate > 0.0;
        table.add_row([
            format!("{:.digits$}", 3.6 * point.speed),
            format!("{:.1}", 1e3 * point.wavelength),
            format!("{:.0}", point.frequency),
            format!("{:.4}", point.normalized_dissipation),
            format!("{:.2e}", point.growth_rate),
            match grows {
                true => format!("{:.1e}", std::f64::consts::LN_2 / point.growth_rate),
                false => "decays".to_owned(),
            },
            if point.at_edge { "edge" } else { "" }.to_owned(),
        ]);
    }
    let bay = answer.bay.as_ref();
    let bay = bay.map_or_else(String::new, |bay| bay.sentence() + "\n");
    let observations = answer.observations;
    let observations = observations.map_or_else(String::new, |count| count.sentence() + "\n");
    let remarks = answer.under_traffic.iter().flat_map(|it| it.remarks.clone());
    let over = answer.over_posterior.iter().flat_map(growth_in_words);
    let remarks: String = remarks.chain(over).map(|remark| capital(&remark.text(language())) + ".\n").collect();
    format!(
        "{}\n{remarks}highest growth at each speed, {:.0}–{:.0} mm\n{table}\n{}\n{branches}\n{bay}{observations}",
        case.file.title.as_deref().unwrap_or("Growth map"),
        1e3 * case.wavelength.min(),
        1e3 * case.wavelength.max(),
        for_whom(case),
    )
}
