//! `riffel map`

use std::path::Path;

use riffel::growth::RidgePoint;
use riffel::{GrowthMap, Ridge};
use riffel_case::{BranchDocument, Case};
use riffel_figures::{branches_csv, map_csv, map_figure, map_netcdf, ridge_csv};
use riffel_keys::Remark;
use riffel_plot::Observation;
use serde::Serialize;

use crate::arguments::{Map, covering};
use crate::bay::{BayGrowth, BaySummary};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::observations;
use crate::output::{Progress, json, print, table};
use crate::staging::Staging;

/// Rows of the table on the terminal.
const TABLE_ROWS: usize = 9;

/// `summary.json`.
#[derive(Serialize)]
struct Summary<'a> {
    riffel_version: &'static str,
    /// The case after presets, defaults and overrides; reads back as a case.
    inputs: &'a riffel_case::file::CaseFile,
    derived: Derived,
    ridge: RidgeSummary<'a>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bay: Option<BaySummary>,
    remarks: &'a [Remark],
}

#[derive(Serialize)]
struct Derived {
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    /// Of the paper's creep law only.
    #[serde(skip_serializing_if = "Option::is_none")]
    creep_coefficient: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    saturation_creepage: Option<f64>,
    creepage: f64,
    tractive_ratio: f64,
    contact_stiffness_n_per_m: f64,
    mean_dissipation_j_per_m: f64,
}

#[derive(Serialize)]
struct RidgeSummary<'a> {
    /// That of the strongest branch.
    best_fit_frequency_hz: Option<f64>,
    /// The strongest first.
    branches: &'a [BranchDocument],
    highest: Option<RidgeEntry>,
    speeds_that_grow: usize,
    speeds_at_edge: usize,
    speeds: usize,
}

#[derive(Serialize)]
struct RidgeEntry {
    speed_m_per_s: f64,
    wavelength_m: f64,
    frequency_hz: f64,
    normalized_dissipation_re: f64,
    growth_rate_per_passage: f64,
    at_edge: bool,
}

impl From<&RidgePoint> for RidgeEntry {
    fn from(point: &RidgePoint) -> Self {
        Self {
            speed_m_per_s: point.speed,
            wavelength_m: point.wavelength,
            frequency_hz: point.frequency,
            normalized_dissipation_re: point.normalized_dissipation,
            growth_rate_per_passage: point.growth_rate,
            at_edge: point.at_edge,
        }
    }
}

impl<'a> Summary<'a> {
    fn new(
        case: &'a Case,
        ridge: &Ridge,
        branches: &'a [BranchDocument],
        bay: Option<&BayGrowth>,
    ) -> Self {
        let steady = case.steady;
        let grows = |point: &&RidgePoint| point.growth_rate > 0.0;
        Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            inputs: &case.file,
            derived: Derived {
                semi_axis_longitudinal_m: case.hertz.semi_axis_longitudinal(),
                semi_axis_lateral_m: case.hertz.semi_axis_lateral(),
                creep_coefficient: case.carter.map(|law| law.creep_coefficient()),
                saturation_creepage: case.carter.map(|law| law.saturation_creepage()),
                creepage: steady.creepages.longitudinal,
                tractive_ratio: steady.tractive_ratio(),
                contact_stiffness_n_per_m: case.feedback.contact_stiffness,
                mean_dissipation_j_per_m: steady.energy_per_metre(),
            },
            ridge: RidgeSummary {
                best_fit_frequency_hz: ridge.best_fit_frequency(),
                branches,
                highest: ridge.highest().filter(grows).map(RidgeEntry::from),
                speeds_that_grow: ridge.points.iter().filter(grows).count(),
                speeds_at_edge: ridge.points.iter().filter(|point| point.at_edge).count(),
                speeds: ridge.points.len(),
            },
            bay: bay.map(BayGrowth::summary),
            remarks: &case.remarks,
        }
    }
}

pub(crate) fn run(arguments: &Map) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    case.check_window()?;
    let curve = match (&arguments.wavelength, &arguments.speed) {
        (Some(wavelength), Some(speed)) => {
            Some((wavelength.within("--wavelength")?, speed.within("--speed")?))
        }
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
    let folder = arguments.case.folder(arguments.output.as_deref(), "map");

    let staging = Staging::new("map", &folder)?;
    let progress = Progress::new("growth map", case.speed.points());
    let map = GrowthMap::compute(&case.feedback, case.wavelength, case.speed, |rows| {
        progress.advance(rows);
    });
    drop(progress);
    let ridge = Ridge::of_map(&case.feedback, &map);
    let bay = arguments
        .bay
        .then(|| BayGrowth::compute(&case, curve))
        .transpose()?;
    let branches = BranchDocument::all(&case, &ridge);
    let summary = json(&Summary::new(&case, &ridge, &branches, bay.as_ref()));
    let mut staging = write_files(staging, &case, &map, &ridge, observations, &summary)?;
    if let Some(bay) = &bay {
        bay.write(&case, &mut staging)?;
    }
    let files = staging.publish()?;

    if arguments.json {
        print(&summary)?;
    } else {
        let sentence = BranchDocument::sentence(&branches).to_string();
        print(&readable(
            &case,
            &ridge,
            &sentence,
            bay.as_ref(),
            &folder,
            &files,
        ))?;
    }
    print_remarks(&case.remarks);
    Ok(())
}

fn write_files(
    mut staging: Staging,
    case: &Case,
    map: &GrowthMap,
    ridge: &Ridge,
    observations: Vec<Observation>,
    summary: &str,
) -> Result<Staging, CliError> {
    let figure = map_figure(case, map, ridge, observations);
    staging.write_picture("map", &figure.svg()?)?;
    staging.write("map.html", figure.html()?)?;
    let progress = Progress::new("writing map.csv", case.speed.points());
    staging.write_with("map.csv", |file| {
        map_csv(map, file, |rows| progress.advance(rows))
    })?;
    drop(progress);
    map_netcdf(map, &figure.title, &staging.path("map.nc"))?;
    staging.write_with("ridge.csv", |file| ridge_csv(ridge, file))?;
    staging.write_with("branches.csv", |file| branches_csv(ridge, file))?;
    staging.write("summary.json", summary)?;
    Ok(staging)
}

/// The ridge at a few speeds, its branches in a sentence, and where the files are.
fn readable(
    case: &Case,
    ridge: &Ridge,
    branches: &str,
    bay: Option<&BayGrowth>,
    folder: &Path,
    files: &[String],
) -> String {
    let mut table = table(&[
        "speed km/h",
        "wavelength mm",
        "frequency Hz",
        "Re Ŵ₁",
        "growth rate per passage",
        "passages to double",
        "",
    ]);
    let last = ridge.points.len() - 1;
    let rows = TABLE_ROWS.min(last + 1);
    for row in 0..rows {
        let point = &ridge.points[row * last / (rows - 1)];
        let grows = point.growth_rate > 0.0;
        table.add_row([
            format!("{:.0}", 3.6 * point.speed),
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
    let bay = bay.map_or_else(String::new, |bay| bay.sentence() + "\n");
    format!(
        "{}\nhighest growth at each speed, {:.0}–{:.0} mm\n{table}\n{branches}\n{bay}{}: {}\n",
        case.file.title.as_deref().unwrap_or("Growth map"),
        1e3 * case.wavelength.min(),
        1e3 * case.wavelength.max(),
        folder.display(),
        files.join(" "),
    )
}
