//! A mix of vehicles, read and checked.

use riffel_keys::{CaseError, KeyFile, Message, say};
use std::fmt;
use std::path::{Path, PathBuf};

use riffel::forecast::SpeedDistribution;
use riffel_keys::quantity::{Dimension, Force, Kind, Quantity};
use riffel_keys::text_file::read_keys;
use toml::Value;

use super::shares::sums_to_one;
use super::spreads::Spreads;
use super::vehicle_keys::said_once;
use super::{Line, TrafficFile, Vehicle};

/// A mix of vehicles, checked.
#[derive(Clone)]
pub struct Traffic {
    pub(super) source: KeyFile,
    /// The keys as written.
    pub file: TrafficFile,
    /// Speeds of each vehicle.
    pub(super) speeds: Vec<SpeedDistribution>,
    /// What else is spread over the wheels of each vehicle.
    pub(super) spreads: Vec<Spreads>,
    /// Folder to which files of curves are relative.
    pub(super) folder: PathBuf,
    /// What is to be asked about values that are not usual.
    pub(super) remarks: Vec<Message>,
}

impl fmt::Debug for Traffic {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.file.fmt(formatter)
    }
}

impl Traffic {
    /// Read a traffic file.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule. Values that go into the case are checked with it, by
    /// [`on`](Self::on).
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let mut traffic = Self::parse(&path.display().to_string(), &read_keys(path, "traffic file")?)?;
        traffic.folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(traffic)
    }

    /// The traffic with some keys changed, checked as [`read`](Self::read) does.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn edit(&self, change: impl FnOnce(&mut TrafficFile)) -> Result<Self, CaseError> {
        let mut file = self.file.clone();
        change(&mut file);
        let text = toml::to_string(&file).map_err(|error| self.source.refuse("vehicle", error.to_string()))?;
        let mut traffic = Self::parse(self.source.name(), &text)?;
        traffic.folder.clone_from(&self.folder);
        Ok(traffic)
    }

    /// Read traffic from TOML; `name` is shown in errors. Files that it names are relative to the present folder.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = KeyFile::parse(name, text)?;
        is_a_traffic(&source)?;
        no_forces_as_axle_loads(&source)?;
        let no_curve =
            |key: &str| key.ends_with("].curve").then(|| source.invalid(key, say!(is_no_curve_of_a_vehicle), ""));
        let file: TrafficFile = source.deserialize_or(no_curve)?;
        let line = file.line;
        if line.passages_per_day.is_some() && line.mgt_per_year.is_some() {
            return Err(exclusive(&source, "line.mgt_per_year", "line.passages_per_day"));
        }
        for (key, value) in [("line.passages_per_day", line.passages_per_day), ("line.mgt_per_year", line.mgt_per_year)]
        {
            if let Some(value) = value {
                positive(&source, key, value)?;
            }
        }
        if file.vehicle.is_empty() {
            return Err(source.missing("vehicle", say!(write_one_vehicle_or_more)));
        }
        let (mut speeds, mut spreads) = (Vec::new(), Vec::new());
        let of_line =
            ["passages_per_day", "mgt_per_year", "measured_line", "friction_days.mean", "friction_days.factor"];
        let mut remarks = of_line
            .into_iter()
            .filter_map(|key| source.judge(&format!("line.{key}")).transpose())
            .collect::<Result<Vec<Message>, CaseError>>()?;
        for (index, vehicle) in file.vehicle.iter().enumerate() {
            remarks.extend(judged(&source, index, vehicle)?);
            let key = |name: &str| format!("vehicle[{index}].{name}");
            if vehicle.name.trim().is_empty() {
                return Err(source.invalid(&key("name"), say!(is_empty_but_tables_need_a), ""));
            }
            if file.vehicle[..index].iter().any(|other| other.name == vehicle.name) {
                let rule = say!(is_a_second_time, text = &vehicle.name);
                return Err(source.invalid(&key("name"), &rule, ""));
            }
            if line.measured_line.is_some() && !vehicle.brings_curve() {
                let message = say!(line_measured_line_needs_for_without, key = key("curve"), name = &vehicle.name);
                return Err(source.refuse("line.measured_line", &message));
            }
            above_zero(&source, &key("share"), Some(vehicle.share))?;
            if let Some(share) = vehicle.traction_share
                && !(0.0..=1.0).contains(&share.si())
            {
                let rule = say!(is_outside, value = share, low = 0.0, high = 1.0);
                return Err(source.invalid(&key("traction_share"), rule, ""));
            }
            speeds.push(distribution(&source, index, vehicle)?);
            let of_vehicle = Spreads::of(&source, line.friction_days, index, vehicle)?;
            said_once(&source, index, vehicle, &of_vehicle)?;
            spreads.push(of_vehicle);
        }
        let shares = file.vehicle.iter().map(|vehicle| vehicle.share.si());
        sums_to_one(&source, "vehicle", shares)?;
        Ok(Self { source, file, speeds, spreads, folder: PathBuf::new(), remarks })
    }

    /// Nothing but the wheel of the case, at some speeds.
    pub fn of_case(speeds: SpeedDistribution) -> Self {
        Self {
            source: KeyFile::empty("the wheel of the case"),
            file: TrafficFile {
                title: None,
                line: Line::default(),
                vehicle: vec![Vehicle::named("wheel of the case")],
            },
            speeds: vec![speeds],
            spreads: vec![Spreads::default()],
            folder: PathBuf::new(),
            remarks: Vec::new(),
        }
    }

    /// Traffic of keys that are not written anywhere; `name` is shown in errors.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read).
    pub fn of_keys(name: &str, file: &TrafficFile) -> Result<Self, CaseError> {
        // Digits hold every bit of a number, and a traffic file has nothing that TOML cannot say.
        Self::parse(name, &toml::to_string(file).unwrap_or_default())
    }
}

/// `Ok` unless this is a case file in the place of a traffic file.
fn is_a_traffic(source: &KeyFile) -> Result<(), CaseError> {
    if let Some(Value::Array(_)) = source.table().get("vehicle") {
        return Ok(());
    }
    let tables = ["wheel", "rail", "track", "contact", "steel"];
    match tables.into_iter().find(|table| source.has(table)) {
        Some(table) => Err(source.refuse(table, say!(this_is_a_case_file_with, table))),
        None => Ok(()),
    }
}

/// Refuse an axle load that is written as a force: the key takes the mass on both wheels.
fn no_forces_as_axle_loads(source: &KeyFile) -> Result<(), CaseError> {
    let vehicles = source.table().get("vehicle").and_then(Value::as_array);
    for (index, vehicle) in vehicles.into_iter().flatten().enumerate() {
        let written = vehicle.get("axle_load").and_then(Value::as_str);
        let is_force = |text: &&str| text.trim().parse::<f64>().is_err() && Kind::of::<Force>().read(text).is_ok();
        if let Some(force) = written.filter(is_force) {
            let rule = say!(is_a_force_but_must_be, force);
            return Err(source.invalid(&format!("vehicle[{index}].axle_load"), &rule, ""));
        }
    }
    Ok(())
}

/// What is to be asked about the values of a vehicle that are not usual.
fn judged(source: &KeyFile, index: usize, vehicle: &Vehicle) -> Result<Vec<Message>, CaseError> {
    let speeds = 0..vehicle.speeds.as_ref().map_or(0, Vec::len);
    let speeds = speeds.map(|place| format!("speeds[{place}].speed"));
    let keys = [
        "axle_load",
        "wheel_load",
        "wheel_mass",
        "rolling_radius",
        "speed.mean",
        "speed.standard_deviation",
        "tractive_ratio",
        "creepage",
        "wheel_radius.mean",
        "wheel_radius.min",
        "wheel_radius.max",
        "load.mean",
        "load.min",
        "load.max",
        "friction.mean",
        "friction.min",
        "friction.max",
    ];
    let keys = keys.map(str::to_owned).into_iter().chain(speeds);
    keys.filter_map(|key| source.judge(&format!("vehicle[{index}].{key}")).transpose()).collect()
}

fn distribution(source: &KeyFile, index: usize, vehicle: &Vehicle) -> Result<SpeedDistribution, CaseError> {
    let key = |name: &str| format!("vehicle[{index}].{name}");
    match (&vehicle.speed, &vehicle.speeds) {
        (Some(_), Some(_)) => Err(exclusive(source, &key("speeds"), &key("speed"))),
        (None, None) => Err(source.missing(
            &key("speed"),
            "give speed = { mean = \"100 km/h\", standard_deviation = \"5 km/h\" } or \
             speeds = [{ speed = \"100 km/h\", share = 1 }]",
        )),
        (Some(normal), None) => {
            let deviation = normal.standard_deviation.map_or(0.0, |deviation| deviation.si());
            SpeedDistribution::normal(normal.mean.si(), deviation)
                .map_err(|error| source.invalid(&key("speed.standard_deviation"), &error, ""))
        }
        (None, Some(list)) => {
            if list.is_empty() {
                return Err(source.invalid(
                    &key("speeds"),
                    say!(is_an_empty_list),
                    "give one { speed, share } or more",
                ));
            }
            for (place, entry) in list.iter().enumerate() {
                let key = |name: &str| key(&format!("speeds[{place}].{name}"));
                above_zero(source, &key("share"), Some(entry.share))?;
            }
            let shares = list.iter().map(|entry| entry.share.si());
            sums_to_one(source, &key("speeds"), shares)?;
            let list: Vec<(f64, f64)> = list.iter().map(|entry| (entry.speed.si(), entry.share.si())).collect();
            SpeedDistribution::shares(&list).map_err(|error| source.invalid(&key("speeds"), &error, ""))
        }
    }
}

fn exclusive(source: &KeyFile, key: &str, other: &str) -> CaseError {
    let rule = say!(and_exclude_each_other, other);
    source.invalid(key, &rule, say!(give_one_of_the_two))
}

fn above_zero<D: Dimension>(source: &KeyFile, key: &str, value: Option<Quantity<D>>) -> Result<(), CaseError> {
    match value.filter(|value| value.si() <= 0.0) {
        Some(value) => {
            let rule = say!(is_but_must_be, value, rule = say!(greater_than_zero));
            Err(source.invalid(key, rule, ""))
        }
        None => Ok(()),
    }
}

fn positive(source: &KeyFile, key: &str, value: f64) -> Result<(), CaseError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    let rule = say!(is_but_must_be, value, rule = say!(finite_and_above_zero));
    Err(source.invalid(key, rule, ""))
}
