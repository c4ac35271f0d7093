//! Traffic files: the vehicles of a line, and how fast corrugation grows under them.

mod file;
mod rail_forecast;
mod reported_growth;
mod wear_report;

use std::path::Path;

use riffel::forecast::{
    STANDARD_GRAVITY, SpeedDistribution, TrafficGrowth, VehicleGrowth, band_lines,
};
use riffel::roughness::ThirdOctave;

pub use file::{Line, NormalSpeed, SpeedShare, TrafficFile, Vehicle};
pub use rail_forecast::RailForecast;
pub use wear_report::{WearDocument, WearReport};

use riffel_keys::quantity::{Dimension, Force, Quantity, Ratio};
use riffel_keys::text_file::read_keys;
use riffel_keys::{CaseError, KeyFile, Remark, overridden_key};
use toml::Value;

use crate::hold::Held;
use crate::variant::assignments;
use crate::{Case, Hold, Variant};

/// Keys of the traffic file that have a range, each with its place in the schema.
pub(crate) const POINTERS: [(&str, &str); 9] = [
    ("vehicle.axle_load", "/$defs/Vehicle/properties/axle_load"),
    ("vehicle.wheel_load", "/$defs/Vehicle/properties/wheel_load"),
    ("vehicle.wheel_mass", "/$defs/Vehicle/properties/wheel_mass"),
    (
        "vehicle.rolling_radius",
        "/$defs/Vehicle/properties/rolling_radius",
    ),
    (
        "vehicle.tractive_ratio",
        "/$defs/Vehicle/properties/tractive_ratio",
    ),
    ("vehicle.creepage", "/$defs/Vehicle/properties/creepage"),
    ("vehicle.speed.mean", "/$defs/NormalSpeed/properties/mean"),
    (
        "vehicle.speed.standard_deviation",
        "/$defs/NormalSpeed/properties/standard_deviation",
    ),
    ("vehicle.speeds.speed", "/$defs/SpeedShare/properties/speed"),
];

/// How far the sum of shares may be from one: shares in tenths of a per cent.
const SHARE_TOLERANCE: f64 = 2e-3;
/// Days of a year in the mean of the calendar.
pub const DAYS_PER_YEAR: f64 = 365.2425;
/// Days of a month in the mean of the calendar.
pub const DAYS_PER_MONTH: f64 = DAYS_PER_YEAR / 12.0;

/// A mix of vehicles, checked.
#[derive(Clone)]
pub struct Traffic {
    source: KeyFile,
    /// The keys as written.
    pub file: TrafficFile,
    /// Speeds of each vehicle.
    speeds: Vec<SpeedDistribution>,
    /// What is to be asked about values that are not usual.
    remarks: Vec<Remark>,
}

/// Traffic on a case: growth rates, and what the reader should know.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficOnCase {
    /// Growth by vehicle and line.
    pub growth: TrafficGrowth,
    /// Axle passages a day, if the file says how much traffic there is.
    pub passages_per_day: Option<f64>,
    /// What the variant holds of the mean state, by vehicle: each kind once, none where friction and load stay.
    pub held: Vec<Hold>,
    /// What the reader should know about the validity of the models.
    pub remarks: Vec<String>,
}

/// One kind of vehicle on a case.
struct VehicleOnCase {
    growth: VehicleGrowth,
    held: Option<Hold>,
    remarks: Vec<String>,
}

impl TrafficOnCase {
    /// Axle passages in a month of the mean calendar, if the file says how much traffic there is.
    pub fn passages_per_month(&self) -> Option<f64> {
        Some(self.passages_per_day? * DAYS_PER_MONTH)
    }
}

/// The one-third-octave bands that a case speaks of: from the one that holds the shortest wavelength of its
/// map to the one that holds the longest.
pub fn bands_of(case: &Case) -> Vec<ThirdOctave> {
    let band = |wavelength: f64| ThirdOctave::containing(wavelength).ok();
    // An axis has wavelengths above zero.
    match (band(case.wavelength.min()), band(case.wavelength.max())) {
        (Some(shortest), Some(longest)) => ThirdOctave::between(shortest, longest).collect(),
        _ => Vec::new(),
    }
}

impl Traffic {
    /// Read a traffic file.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule. Values that go into the case are checked with it, by
    /// [`on`](Self::on).
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        Self::parse(
            &path.display().to_string(),
            &read_keys(path, "traffic file")?,
        )
    }

    /// Read traffic from TOML; `name` is shown in errors.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let source = KeyFile::parse(name, text)?;
        is_a_traffic(&source)?;
        let file: TrafficFile = source.deserialize()?;
        let line = file.line;
        if line.passages_per_day.is_some() && line.mgt_per_year.is_some() {
            return Err(exclusive(
                &source,
                "line.mgt_per_year",
                "line.passages_per_day",
            ));
        }
        for (key, value) in [
            ("line.passages_per_day", line.passages_per_day),
            ("line.mgt_per_year", line.mgt_per_year),
        ] {
            if let Some(value) = value {
                positive(&source, key, value)?;
            }
        }
        if file.vehicle.is_empty() {
            return Err(source.missing("vehicle", "write one [[vehicle]] or more"));
        }
        let (mut speeds, mut remarks) = (Vec::new(), Vec::new());
        for (index, vehicle) in file.vehicle.iter().enumerate() {
            remarks.extend(judged(&source, index, vehicle)?);
            let key = |name: &str| format!("vehicle[{index}].{name}");
            if vehicle.name.trim().is_empty() {
                return Err(source.invalid(&key("name"), "is empty, but tables need a name", ""));
            }
            if file.vehicle[..index]
                .iter()
                .any(|other| other.name == vehicle.name)
            {
                let rule = format!("is \"{}\" a second time", vehicle.name);
                return Err(source.invalid(&key("name"), &rule, ""));
            }
            above_zero(&source, &key("share"), Some(vehicle.share))?;
            if let Some(share) = vehicle.traction_share
                && !(0.0..=1.0).contains(&share.si())
            {
                let rule = format!("is {share}, but must be between 0 and 1");
                return Err(source.invalid(&key("traction_share"), &rule, ""));
            }
            if vehicle.axle_load.is_some() && vehicle.wheel_load.is_some() {
                return Err(exclusive(&source, &key("wheel_load"), &key("axle_load")));
            }
            if vehicle.tractive_ratio.is_some() && vehicle.creepage.is_some() {
                return Err(exclusive(&source, &key("creepage"), &key("tractive_ratio")));
            }
            speeds.push(distribution(&source, index, vehicle)?);
        }
        let shares = file.vehicle.iter().map(|vehicle| vehicle.share.si());
        sums_to_one(&source, "vehicle", shares)?;
        Ok(Self {
            source,
            file,
            speeds,
            remarks,
        })
    }

    /// Nothing but the wheel of the case, at some speeds.
    pub fn of_case(speeds: SpeedDistribution) -> Self {
        Self {
            source: KeyFile::empty("the wheel of the case"),
            file: TrafficFile {
                title: None,
                line: Line::default(),
                vehicle: vec![Vehicle {
                    name: "wheel of the case".to_owned(),
                    share: Quantity::<Ratio>::new(1.0),
                    axle_load: None,
                    wheel_load: None,
                    wheel_mass: None,
                    rolling_radius: None,
                    speed: None,
                    speeds: None,
                    tractive_ratio: None,
                    creepage: None,
                    traction_share: None,
                    set: toml::Table::new(),
                }],
            },
            speeds: vec![speeds],
            remarks: Vec::new(),
        }
    }

    /// The traffic with what a variant changes, on a case: growth in the bands under every vehicle.
    ///
    /// The wheel of each vehicle is that of the case with the keys of the vehicle in place of its own, and
    /// those of the variant in place of both. On discrete supports growth is the mean over the bay.
    /// `progress` is told of each vehicle. Cost: see [`riffel::forecast::MeanGrowth::compute`].
    ///
    /// # Errors
    /// [`CaseError`] with the key of the vehicle or of the variant, the value and the rule.
    pub fn on(
        &self,
        case: &Case,
        bands: &[ThirdOctave],
        variant: &Variant,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<TrafficOnCase, CaseError> {
        let mut vehicles = Vec::new();
        let mut remarks = Vec::new();
        let mut held = Vec::new();
        for index in 0..self.file.vehicle.len() {
            let vehicle = self.vehicle_on(index, case, bands, variant)?;
            vehicles.push(vehicle.growth);
            remarks.push(vehicle.remarks);
            held.extend(vehicle.held.filter(|hold| !held.contains(hold)));
            progress(1);
        }
        let own = self.remarks.iter().chain(&variant.remarks);
        let own: Vec<String> = own.map(Remark::to_string).collect();
        let mut remarks = self.merged(remarks);
        remarks.splice(0..0, own);
        let growth = TrafficGrowth::new(bands.to_vec(), vehicles);
        let growth = growth.map_err(|error| self.source.refuse("vehicle", &error.to_string()))?;
        let line = self.file.line;
        let of_mgt = |mgt: f64| growth.passages(mgt) / DAYS_PER_YEAR;
        let passages_per_day = line.passages_per_day.or(line.mgt_per_year.map(of_mgt));
        let reported =
            passages_per_day.and_then(|per_day| reported_growth::remark(&growth, per_day));
        // It says most of all.
        remarks.splice(0..0, reported);
        Ok(TrafficOnCase {
            growth,
            passages_per_day,
            held,
            remarks,
        })
    }

    /// The remarks on the vehicles, the one with most passages first. A remark that differs from an earlier
    /// one by its numbers alone is left out.
    fn merged(&self, remarks: Vec<Vec<String>>) -> Vec<String> {
        let words =
            |remark: &str| -> String { remark.chars().filter(|c| !c.is_ascii_digit()).collect() };
        let mut of_vehicles: Vec<(&Vehicle, Vec<String>)> =
            self.file.vehicle.iter().zip(remarks).collect();
        of_vehicles.sort_by(|a, b| b.0.share.si().total_cmp(&a.0.share.si()));
        let alone = of_vehicles.len() == 1;
        let mut merged = Vec::new();
        let mut known = Vec::new();
        for (vehicle, remarks) in of_vehicles {
            for remark in remarks {
                let words = words(&remark);
                if !known.contains(&words) {
                    known.push(words);
                    merged.push(match alone {
                        true => remark,
                        false => format!("{}: {remark}", vehicle.name),
                    });
                }
            }
        }
        merged
    }

    fn vehicle_on(
        &self,
        index: usize,
        case: &Case,
        bands: &[ThirdOctave],
        variant: &Variant,
    ) -> Result<VehicleOnCase, CaseError> {
        let vehicle = &self.file.vehicle[index];
        let at = |key: &str| format!("vehicle[{index}]{key}");
        let own = overrides(vehicle);
        let speeds = variant.speed.apply(&self.speeds[index]).map_err(|error| {
            let message = format!("vehicle \"{}\": {error}", vehicle.name);
            self.source.refuse(&at(""), &message)
        })?;
        let lines = band_lines(bands);
        let window = window(&lines, &speeds);
        let own_assignments: Vec<String> = own.iter().map(|(_, text)| text.clone()).collect();
        let held = Held::of(variant, case, &own_assignments, &window)?;
        let held_assignment = Held::assignments(held.as_ref());
        let sets = [
            &own_assignments[..],
            &variant.overrides,
            held_assignment,
            &window,
        ];
        let wheel = case.of_vehicle(&sets).map_err(|error| match error {
            CaseError::Override {
                assignment,
                message,
            } => match own.iter().find(|(_, text)| *text == assignment) {
                _ if held_assignment.contains(&assignment) => {
                    let held = held.as_ref();
                    let why = held.map_or(message.clone(), |held| held.refusal(&message));
                    variant.refuse(&format!(
                        "variant \"{}\" changes friction or load under \"{}\"; {why}",
                        variant.title, vehicle.name
                    ))
                }
                _ if variant.overrides.contains(&assignment) => {
                    variant.explain(CaseError::Override {
                        assignment,
                        message,
                    })
                }
                Some((key, _)) => {
                    let message = format!("`{}`: {message}", at(&format!(".{key}")));
                    self.source.refuse(&at(&format!(".{key}")), &message)
                }
                None => {
                    let message = format!(
                        "speeds and bands of vehicle \"{}\": {message}",
                        vehicle.name
                    );
                    self.source.refuse(&at(""), &message)
                }
            },
            error => error,
        })?;
        let (shortest, longest) = (lines[0], lines[lines.len() - 1]);
        let (lowest, highest) = speeds.range();
        wheel.check_frequencies(lowest / longest, highest / shortest)?;
        let growth = VehicleGrowth::compute(
            &vehicle.name,
            vehicle.share.si(),
            &wheel.places(),
            bands,
            speeds,
        );
        let traction_share = vehicle.traction_share.map_or(1.0, |share| share.si());
        let growth = growth.and_then(|growth| growth.with_traction_on(traction_share));
        let growth = growth.map_err(|error| self.source.refuse(&at(""), &error.to_string()))?;
        // That a preset of the case changes nothing for a vehicle with values of its own is no news.
        let presets = wheel.builder.text.remarks;
        let remarks = wheel.remarks.into_iter();
        Ok(VehicleOnCase {
            growth,
            held: held.map(|held| held.hold),
            remarks: remarks
                .filter(|remark| !presets.contains(remark))
                .map(|remark| remark.to_string())
                .collect(),
        })
    }
}

/// `Ok` unless this is a case file in the place of a traffic file.
fn is_a_traffic(source: &KeyFile) -> Result<(), CaseError> {
    if let Some(Value::Array(_)) = source.table().get("vehicle") {
        return Ok(());
    }
    let tables = ["wheel", "rail", "track", "contact", "steel"];
    match tables.into_iter().find(|table| source.has(table)) {
        Some(table) => Err(source.refuse(
            table,
            &format!(
                "this is a case file, with its table [{table}], and no traffic file; a traffic file lists the \
                 vehicles of a line in [[vehicle]], `riffel init --traffic` writes one"
            ),
        )),
        None => Ok(()),
    }
}

/// Overrides of the case by a vehicle, each with the key of the vehicle that it comes from.
fn overrides(vehicle: &Vehicle) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut add = |key: &str, path: &str, value: Option<f64>| {
        if let Some(value) = value {
            found.push((key.to_owned(), format!("{path}={value:e}")));
        }
    };
    let wheel = |mass: f64| 0.5 * mass * STANDARD_GRAVITY;
    let si = |force: Quantity<Force>| force.si();
    add(
        "axle_load",
        "contact.normal_load",
        vehicle.axle_load.map(|mass| wheel(mass.si())),
    );
    add(
        "wheel_load",
        "contact.normal_load",
        vehicle.wheel_load.map(si),
    );
    add(
        "wheel_mass",
        "wheel.mass",
        vehicle.wheel_mass.map(|mass| mass.si()),
    );
    add(
        "rolling_radius",
        "wheel.rolling_radius",
        vehicle.rolling_radius.map(|radius| radius.si()),
    );
    add(
        "tractive_ratio",
        "contact.tractive_ratio",
        vehicle.tractive_ratio.map(|ratio| ratio.si()),
    );
    add(
        "creepage",
        "contact.creepage",
        vehicle.creepage.map(|creepage| creepage.si()),
    );
    for assignment in assignments(&vehicle.set) {
        found.push((format!("set.{}", overridden_key(&assignment)), assignment));
    }
    found
}

/// The window of wavelengths and speeds, so that the case is checked and tabulated over it; and an amplitude
/// at which no remark on the linear range applies, for the forecast has its own.
fn window(lines: &[f64], speeds: &SpeedDistribution) -> Vec<String> {
    /// A single speed or line is a narrow window.
    const MARGIN: f64 = 1e-6;
    let (low, high) = speeds.range();
    let (shortest, longest) = (lines[0], lines[lines.len() - 1]);
    let axis = |key: &str, low: f64, high: f64| {
        let (low, high) = (low * (1.0 - MARGIN), high * (1.0 + MARGIN));
        format!("map.{key}={{ min = {low:e}, max = {high:e}, points = 2 }}")
    };
    vec![
        axis("wavelength", shortest, longest),
        axis("speed", low, high),
        "corrugation.amplitude=1e-6".to_owned(),
    ]
}

/// What is to be asked about the values of a vehicle that are not usual.
fn judged(source: &KeyFile, index: usize, vehicle: &Vehicle) -> Result<Vec<Remark>, CaseError> {
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
    ];
    let keys = keys.map(str::to_owned).into_iter().chain(speeds);
    keys.filter_map(|key| source.judge(&format!("vehicle[{index}].{key}")).transpose())
        .collect()
}

fn distribution(
    source: &KeyFile,
    index: usize,
    vehicle: &Vehicle,
) -> Result<SpeedDistribution, CaseError> {
    let key = |name: &str| format!("vehicle[{index}].{name}");
    match (&vehicle.speed, &vehicle.speeds) {
        (Some(_), Some(_)) => Err(exclusive(source, &key("speeds"), &key("speed"))),
        (None, None) => Err(source.missing(
            &key("speed"),
            "give speed = { mean = \"100 km/h\", standard_deviation = \"5 km/h\" } or \
             speeds = [{ speed = \"100 km/h\", share = 1 }]",
        )),
        (Some(normal), None) => {
            let deviation = normal
                .standard_deviation
                .map_or(0.0, |deviation| deviation.si());
            SpeedDistribution::normal(normal.mean.si(), deviation).map_err(|error| {
                source.invalid(&key("speed.standard_deviation"), &error.to_string(), "")
            })
        }
        (None, Some(list)) => {
            for (place, entry) in list.iter().enumerate() {
                let key = |name: &str| key(&format!("speeds[{place}].{name}"));
                above_zero(source, &key("share"), Some(entry.share))?;
            }
            let shares = list.iter().map(|entry| entry.share.si());
            sums_to_one(source, &key("speeds"), shares)?;
            let list: Vec<(f64, f64)> = list
                .iter()
                .map(|entry| (entry.speed.si(), entry.share.si()))
                .collect();
            SpeedDistribution::shares(&list)
                .map_err(|error| source.invalid(&key("speeds"), &error.to_string(), ""))
        }
    }
}

fn sums_to_one(
    source: &KeyFile,
    key: &str,
    shares: impl Iterator<Item = f64>,
) -> Result<(), CaseError> {
    let sum: f64 = shares.sum();
    if (sum - 1.0).abs() <= SHARE_TOLERANCE {
        return Ok(());
    }
    let message = format!("the shares of `{key}` sum to {sum:.4}, but must sum to 1");
    Err(source.refuse(&format!("{key}[0].share"), &message))
}

fn exclusive(source: &KeyFile, key: &str, other: &str) -> CaseError {
    let rule = format!("and `{other}` exclude each other");
    source.invalid(key, &rule, "give one of the two")
}

fn above_zero<D: Dimension>(
    source: &KeyFile,
    key: &str,
    value: Option<Quantity<D>>,
) -> Result<(), CaseError> {
    match value.filter(|value| value.si() <= 0.0) {
        Some(value) => {
            let rule = format!("is {value}, but must be greater than zero");
            Err(source.invalid(key, &rule, ""))
        }
        None => Ok(()),
    }
}

fn positive(source: &KeyFile, key: &str, value: f64) -> Result<(), CaseError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    let rule = format!("is {value}, but must be finite and greater than zero");
    Err(source.invalid(key, &rule, ""))
}
