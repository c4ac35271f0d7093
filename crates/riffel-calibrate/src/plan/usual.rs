//! The plan of a case and its tables of measurements, with usual priors.

use std::fmt::Write;
use std::path::{Path, PathBuf};

use riffel_case::file::TrackModel;
use riffel_case::traffic::Traffic;
use riffel_case::{Case, wear_spread};
use riffel_keys::quantity::{Quantity, Ratio};
use riffel_keys::{CaseError, Message, say};

use super::Plan;
use crate::data::table;
use crate::file::Kind;
use crate::model::{Vehicle, VehicleKey};

/// Averages of a frequency response where nothing is said of them: few, so that its errors are rather taken too large.
const AVERAGES: u32 = 4;
/// Pads are stiffer under a wheel than under the clip alone.
const PRELOAD: &str = "name = \"preload_stiffening\"\nmultiplies = \"track.pad.stiffness\"\n";
/// Usual error and spread of speeds \[m/s\], and what they are at most, as a share of the mean.
const OF_SPEED: (f64, f64) = (8.0 / 3.6, 0.1);

/// What a calibration is made of where there is no plan.
pub struct Measured<'a> {
    /// The case file; the plan where there are no tables.
    pub case: &'a Path,
    /// The traffic file.
    pub traffic: Option<&'a Path>,
    /// Tables of measurements.
    pub tables: &'a [PathBuf],
}

impl Measured<'_> {
    /// The plan for results in a folder: the usual one, as it is to stand there; without tables the one that is given in place of
    /// the case.
    ///
    /// # Errors
    /// Errors of [`Plan::read`] and [`Plan::usual`].
    pub fn plan_for(&self, folder: &Path) -> Result<Plan, CaseError> {
        match self.tables {
            [] => Plan::read(self.case),
            _ => Plan::usual(&folder.join("plan.toml"), self),
        }
    }
}

/// A lognormal prior of a key.
#[derive(Clone, Copy)]
struct OfKey {
    key: &'static str,
    /// Its median in SI; none for the value of the case.
    median: Option<f64>,
    factor: f64,
    within: Option<[f64; 2]>,
}

const fn of_key(key: &'static str, median: Option<f64>, factor: f64) -> OfKey {
    OfKey { key, median, factor, within: None }
}

/// Factor of a pad whose make is known.
const KNOWN_PAD: f64 = 1.5;

/// Of the case. Of the wear coefficient of a rail in service 80 % lies within a factor of 3.
const OF_CASE: [OfKey; 11] = [
    of_key("track.pad.stiffness", None, 2.0),
    of_key("track.pad.loss_factor", Some(0.2), 1.6),
    of_key("track.ballast.stiffness", Some(60e6), 1.8),
    of_key("track.ballast.loss_factor", Some(1.0), 1.5),
    of_key("track.sleeper.mass", None, 1.05),
    of_key("rail.loss_factor", Some(0.01), 2.0),
    of_key("wheel.mass", None, 1.15),
    OfKey { within: Some([0.05, 0.8]), ..of_key("contact.friction", Some(0.35), 1.3) },
    of_key("contact.tractive_ratio", Some(0.15), 1.5),
    of_key("contact.transverse_radius", None, 1.3),
    of_key("wear.coefficient", None, 2.36),
];

/// Of a vehicle that says it itself.
const OF_VEHICLE: [OfKey; 2] =
    [of_key("vehicle.wheel_mass", None, 1.15), of_key("vehicle.tractive_ratio", Some(0.15), 1.5)];

/// A prior that may stand in the plan, as text.
struct Candidate {
    /// Its name in the results.
    name: String,
    text: String,
}

impl OfKey {
    /// Of a key that has a value: about it where the usual prior excludes it.
    fn prior(&self, own: f64, factor: f64) -> String {
        let usual = self.median.unwrap_or(own);
        let is_usual = (own / usual).ln().abs() <= super::EXCLUDES * factor.ln();
        let median = written(self.key, if is_usual { usual } else { own });
        let ends = match self.within {
            Some([low, high]) if (low..=high).contains(&own) => {
                format!(", min = {low}, max = {high}")
            }
            _ => String::new(),
        };
        format!("lognormal = {{ median = {median}, factor = {factor}{ends} }}\n")
    }
}

/// Four digits of a number in SI, in the unit in which engineers write the key.
fn written(key: &str, value: f64) -> String {
    let quantity = super::parameter::quantity_of(key, key).ok();
    let (number, unit) = quantity.map_or((value, ""), |it| it.in_engineers_unit(value));
    let number = format!("{number:.3e}").parse().unwrap_or(number);
    let number = Quantity::<Ratio>::new(number);
    match unit {
        "" => number.to_string(),
        unit => format!("\"{number} {unit}\""),
    }
}

impl Kind {
    /// The kind of a table with such columns; of those that fit the one that needs most.
    fn of_columns(names: &[String]) -> Option<Self> {
        let has = |column: &&str| names.iter().any(|name| name == column);
        let fitting = Self::ALL.into_iter();
        fitting.filter(|kind| kind.columns().iter().all(has)).max_by_key(|kind| kind.columns().len())
    }

    /// Whether a train took part, whose weight lay on the pads.
    fn is_of_trains(self) -> bool {
        matches!(self, Self::DatedLevels | Self::AxleBox | Self::PassBy | Self::DatedProfiles | Self::Wear)
    }

    /// What models usually miss of it; `None` if all levels share their error.
    fn usual_discrepancy(self) -> Option<&'static str> {
        let usual = match self {
            Self::FrequencyResponse => "{ kind = \"gaussian-process\", standard_deviation = { half_normal = 0.15 } }",
            Self::DecayRate => "{ kind = \"band\", standard_deviation = { half_normal = 0.2 } }",
            Self::DatedLevels | Self::DatedProfiles => {
                "{ kind = \"gaussian-process\", standard_deviation = { half_normal = 1.0 } }"
            }
            Self::AxleBox => "{ kind = \"band\", standard_deviation = { half_normal = 1.5 } }",
            Self::PassBy | Self::Wear => return None,
        };
        Some(usual)
    }
}

/// A table of measurements.
struct Table {
    name: String,
    kind: Kind,
    path: String,
    has_coherence: bool,
}

impl Table {
    fn all(paths: &[PathBuf], folder: &Path, has_traffic: bool) -> Result<Vec<Self>, CaseError> {
        let mut tables: Vec<Self> = Vec::new();
        for path in paths {
            let refuse = |message: Message, help: Message| CaseError::Data {
                path: path.clone(),
                line: None,
                message,
                help: Some(help),
            };
            let names = table::names(path, |names| Kind::of_columns(names).is_some())?;
            let kind = Kind::of_columns(&names).ok_or_else(|| {
                let kinds = Kind::ALL.map(|kind| format!("{}: {}", kind.name(), kind.columns().join(", ")));
                let message = say!(columns_of_no_kind, columns = names.join(", "));
                refuse(message, Message::verbatim(kinds.join("; ")))
            })?;
            if kind == Kind::AxleBox {
                return Err(refuse(say!(is_run_without_speed), say!(write_run_into_a_plan)));
            }
            if matches!(kind, Kind::DatedLevels | Kind::DatedProfiles | Kind::Wear) && !has_traffic {
                return Err(refuse(say!(dates_without_traffic), say!(give_traffic_of_the_program)));
            }
            let stem = path.file_stem().unwrap_or_default().to_string_lossy();
            let mut numbered = (2..).map(|number| format!("{stem}-{number}"));
            let is_free = |name: &String| tables.iter().all(|table| table.name != *name);
            let own = Some(stem.to_string()).filter(is_free);
            tables.push(Self {
                name: own.or_else(|| numbered.find(is_free)).unwrap_or_default(),
                kind,
                path: from(folder, path),
                has_coherence: names.iter().any(|name| name == "coherence"),
            });
        }
        Ok(tables)
    }

    /// A coherence says nothing of errors without the number of blows.
    fn assumes_averages(&self) -> bool {
        self.kind == Kind::FrequencyResponse && self.has_coherence
    }

    fn text(&self, case: &Case) -> String {
        let mut text =
            format!("\n[[data]]\nname = {:?}\nkind = \"{}\"\nfile = {:?}\n", self.name, self.kind.name(), self.path);
        if self.assumes_averages() {
            _ = writeln!(text, "averages = {AVERAGES}  # assumed: blows in the mean of each line");
        }
        let smeared = match case.file.track.model {
            TrackModel::OneLayerPeriodic => Some(TrackModel::OneLayer),
            TrackModel::TwoLayerPeriodic => Some(TrackModel::TwoLayer),
            _ => None,
        };
        if let Some(model) = smeared.filter(|_| self.kind.is_of_trains()) {
            _ = writeln!(text, "set = {{ \"track.model\" = \"{}\" }}  # wheels pass all places", model.name());
        }
        if let Some(usual) = self.kind.usual_discrepancy() {
            _ = writeln!(text, "discrepancy = {usual}");
        }
        text
    }
}

/// The path of a file as seen from a folder.
pub(super) fn from(folder: &Path, file: &Path) -> String {
    let real = |path: &Path| {
        let there = path.ancestors().find_map(|it| Some((it, it.canonicalize().ok()?)));
        match there {
            Some((base, real)) => real.join(path.strip_prefix(base).unwrap_or(Path::new(""))),
            None => path.to_owned(),
        }
    };
    let absolute = |path: &Path| real(&std::path::absolute(path).unwrap_or_else(|_| path.to_owned()));
    let (folder, file) = (absolute(folder), absolute(file));
    let common = folder.components().zip(file.components()).take_while(|(a, b)| a == b).count();
    let up = folder.components().skip(common).map(|_| "..");
    let down = file.components().skip(common);
    let down = down.map(|part| part.as_os_str().to_string_lossy().into_owned());
    up.map(str::to_owned).chain(down).collect::<Vec<String>>().join("/")
}

/// Priors of what the case and its vehicles have.
fn candidates(case: &Case, vehicles: &[Vehicle], tables: &[Table]) -> Vec<Candidate> {
    let mut candidates = Vec::new();
    for of_key in &OF_CASE {
        let Some(own) = case.number(of_key.key).filter(|own| *own > 0.0) else {
            continue;
        };
        let pad = case.file.track.pad.as_ref();
        let is_known = of_key.key == "track.pad.stiffness"
            && (case.file.track.preset.is_some() || pad.is_some_and(|pad| pad.preset.is_some()));
        let factor = if is_known { KNOWN_PAD } else { of_key.factor };
        let is_wear = of_key.key == "wear.coefficient" && case.file.wear.measured.is_some();
        let factor = match is_wear {
            true => wear_spread(case).factor().max(1.001),
            false => factor,
        };
        candidates.push(Candidate {
            name: of_key.key.to_owned(),
            text: format!("key = \"{}\"\n{}", of_key.key, of_key.prior(own, factor)),
        });
    }
    if let Some(own) = case.number("contact.lateral_offset") {
        let key = "contact.lateral_offset";
        candidates.push(Candidate {
            name: key.to_owned(),
            text: format!(
                "key = \"{key}\"\nnormal = {{ mean = {}, standard_deviation = \"5 mm\" }}\n",
                written(key, own)
            ),
        });
    }
    for vehicle in vehicles {
        let several = vehicles.len() > 1;
        let mut add = |key: &str, prior: String| {
            let name = match several {
                true => format!("{key} ({})", vehicle.name),
                false => key.to_owned(),
            };
            let of = match several {
                true => format!("name = {:?}\n", vehicle.name),
                false => String::new(),
            };
            candidates.push(Candidate { name, text: format!("key = \"{key}\"\n{of}{prior}") });
        };
        let own = |key: &str| vehicle.number(&VehicleKey::of(key)?).filter(|own| *own > 0.0);
        for of_key in &OF_VEHICLE {
            if let Some(own) = own(&of_key.key["vehicle.".len()..]) {
                add(of_key.key, of_key.prior(own, of_key.factor));
            }
        }
        let share = vehicle.traction_share;
        let [low, high] = [share.min(0.05), share.max(0.95)];
        add("vehicle.traction_share", format!("uniform = {{ min = {low}, max = {high} }}\n"));
        if let Some(mean) = own("speed.mean") {
            let spread = OF_SPEED.0.min(OF_SPEED.1 * mean);
            let [mean, spread] = [mean, spread].map(|speed| written("vehicle.speed.mean", speed));
            add("vehicle.speed.mean", format!("normal = {{ mean = {mean}, standard_deviation = {spread} }}\n"));
            add("vehicle.speed.standard_deviation", format!("lognormal = {{ median = {spread}, factor = 1.5 }}\n"));
        }
    }
    let of_trains = |table: &&Table| table.kind.is_of_trains();
    let under_trains: Vec<&Table> = tables.iter().filter(of_trains).collect();
    let has_pad = candidates.iter().any(|it| it.name == "track.pad.stiffness");
    if has_pad && !under_trains.is_empty() && under_trains.len() < tables.len() {
        let names: Vec<&str> = under_trains.iter().map(|table| &*table.name).collect();
        candidates.push(Candidate {
            name: "preload_stiffening".to_owned(),
            text: format!("{PRELOAD}in_data = {names:?}\nlognormal = {{ median = 1.2, factor = 1.3 }}\n"),
        });
    }
    candidates
}

impl Plan {
    /// The plan with usual priors of all that a case and its traffic have and that tables of measurements tell of, as it is to
    /// stand at a path.
    ///
    /// # Errors
    /// [`CaseError`] with the file, what is wrong in it and the rule; that of a plan; where another plan stands there.
    pub fn usual(path: &Path, measured: &Measured<'_>) -> Result<Self, CaseError> {
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        let mut case = Case::read(measured.case, &[])?;
        if let Some(traffic) = measured.traffic {
            case = Traffic::read(traffic)?.wearing_as_measured(&case)?.into_owned();
        }
        let vehicles = match measured.traffic {
            None => Vec::new(),
            Some(traffic) => Vehicle::all(&Traffic::read(traffic)?)
                .map_err(|(index, key)| CaseError::data(traffic, say!(not_for_calibration, index, key)))?,
        };
        let tables = Table::all(measured.tables, folder, measured.traffic.is_some())?;
        let mut head = "# Usual priors: put what you know in their place, and run this plan again.\n".to_owned();
        _ = writeln!(head, "case = {:?}", from(folder, measured.case));
        if let Some(traffic) = measured.traffic {
            _ = writeln!(head, "traffic = {:?}", from(folder, traffic));
        }
        let mut candidates = candidates(&case, &vehicles, &tables);
        let data: String = tables.iter().map(|table| table.text(&case)).collect();
        let plan = |candidates: &[Candidate]| {
            let priors = candidates.iter().map(|it| format!("\n[[parameter]]\n{}", it.text));
            Self::of_text(path, format!("{head}{}{data}", priors.collect::<String>()))
        };
        let of_all = plan(&candidates)?;
        candidates.retain(|it| !of_all.posterior.data_of(&it.name).is_empty());
        let mut plan = plan(&candidates)?;
        let assumed = tables.iter().filter(|table| table.assumes_averages());
        plan.remarks
            .extend(assumed.map(|table| say!(averages_are_assumed, averages = f64::from(AVERAGES)).about(&table.name)));
        match std::fs::read_to_string(path) {
            Ok(there) if there != plan.text => Err(CaseError::Data {
                path: path.to_owned(),
                line: None,
                message: say!(is_another_plan),
                help: Some(say!(run_the_other_plan)),
            }),
            _ => Ok(plan),
        }
    }
}
