//! Plans: what is uncertain, what was measured, read and checked.

use std::path::{Path, PathBuf};

use riffel_case::traffic::Traffic;
use riffel_case::{Case, CaseKey, settings};
use riffel_keys::quantity::{self, Quantity, Ratio};
use riffel_keys::{CaseError, KeyFile, PhysicalRange, text_file};
use riffel_study::Distribution;
use statrs::distribution::StudentsT;
use toml::Value;

use crate::data::{AxleBoxRun, Block, DatedLevels, DecayRates, FrequencyResponses, Levels, Size};
use crate::file::{DataFile, DiscrepancyFile, Kind, PlanFile, SizeFile, UncertainFile};
use crate::kernel::Kernel;
use crate::model::{Model, Parameter, Role, Vehicle, VehicleKey, View, number_of};
use crate::posterior::{Named, Posterior};
use crate::prior::Prior;

/// Standard deviations of a prior from its median beyond which it excludes what the case says.
const EXCLUDES: f64 = 4.0;
/// Keys of a plan that are for decisions and comparisons, which `calibrate` leaves alone.
const OF_OTHERS: [&str; 5] = ["compare", "hold_out", "action", "measurement", "cost"];

/// A plan, read and checked against its case and its data.
pub struct Plan {
    /// The keys as written.
    pub file: PlanFile,
    /// What it asks for.
    pub posterior: Posterior,
    /// What the reader should know.
    pub remarks: Vec<String>,
    /// The text of the plan.
    pub text: String,
    /// Every file that the numbers follow from, the plan first.
    pub inputs: Vec<PathBuf>,
}

/// A plan while it is being read.
struct Reading<'a> {
    source: &'a KeyFile,
    file: &'a PlanFile,
    folder: &'a Path,
    case: &'a Case,
    vehicles: &'a [Vehicle],
    parameters: Vec<Parameter>,
    views: Vec<View>,
    remarks: Vec<String>,
}

impl Plan {
    /// Read a plan, its case, its traffic and its data.
    ///
    /// # Errors
    /// [`CaseError`] with the key or the file, the value and the rule.
    pub fn read(path: &Path) -> Result<Self, CaseError> {
        let text = text_file::read_keys(path, "plan")?;
        let mut source = KeyFile::parse(&path.display().to_string(), &text)?;
        let written = source.clone();
        OF_OTHERS.iter().for_each(|key| source.remove(key));
        let file: PlanFile = source.deserialize()?;
        let source = written;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        check_sampler(&source, &file)?;
        let case_path = folder.join(&file.case);
        let case =
            Case::read_with(&case_path, &settings(&file.set)).map_err(|error| match error {
                CaseError::Changed { key, message } => {
                    source.refuse(&format!("set.{key}"), &message)
                }
                error => error,
            })?;
        let mut inputs = vec![path.to_owned(), case_path];
        let vehicles = match &file.traffic {
            None => Vec::new(),
            Some(name) => {
                inputs.push(folder.join(name));
                let traffic = Traffic::read(&folder.join(name))?;
                Vehicle::all(&traffic).map_err(|(index, key)| {
                    let message = format!(
                        "vehicle[{index}] of {name} has `{key}`, which calibration does not take; give one wheel at a distribution of speeds"
                    );
                    source.refuse("traffic", &message)
                })?
            }
        };
        inputs.extend(file.data.iter().map(|data| folder.join(&data.file)));
        let mut reading = Reading {
            source: &source,
            file: &file,
            folder,
            case: &case,
            vehicles: &vehicles,
            parameters: Vec::new(),
            views: Vec::new(),
            remarks: Vec::new(),
        };
        for (index, parameter) in file.parameter.iter().enumerate() {
            let parameter = reading.parameter(index, parameter)?;
            if reading
                .parameters
                .iter()
                .any(|other| other.name == parameter.name)
            {
                let rule = format!("is \"{}\" a second time", parameter.name);
                return Err(source.invalid(&format!("parameter[{index}]"), &rule, ""));
            }
            reading.parameters.push(parameter);
        }
        let mut blocks = reading.blocks()?;
        if reading.parameters.is_empty() {
            return Err(source.missing("parameter", "write one [[parameter]] or more"));
        }
        let Reading {
            parameters,
            views,
            remarks,
            ..
        } = reading;
        let model = Model {
            parameters,
            views,
            vehicles,
        };
        touch(&source, &model, &mut blocks)?;
        let posterior = Posterior { model, blocks };
        Ok(Self {
            file,
            posterior,
            remarks,
            text,
            inputs,
        })
    }
}

fn check_sampler(source: &KeyFile, file: &PlanFile) -> Result<(), CaseError> {
    let sampler = &file.sampler;
    if sampler.kind != "nuts" {
        let rule = format!("is \"{}\", but must be \"nuts\"", sampler.kind);
        return Err(source.invalid("sampler.kind", &rule, ""));
    }
    for (key, value, least, most) in [
        ("sampler.chains", sampler.chains, 1, 1000),
        ("sampler.warmup", sampler.warmup, 100, 1_000_000),
        ("sampler.draws", sampler.draws, 10, 1_000_000),
    ] {
        if !(least..=most).contains(&value) {
            let rule = format!("is {value}, but must be between {least} and {most}");
            return Err(source.invalid(key, &rule, ""));
        }
    }
    Ok(())
}

impl Reading<'_> {
    fn parameter(&self, index: usize, written: &UncertainFile) -> Result<Parameter, CaseError> {
        let vehicles = self.vehicles;
        let at = format!("parameter[{index}]");
        let place = |key: &str| format!("{at}.{key}");
        let wrong =
            |key: &str, rule: &str, help: &str| self.source.invalid(&place(key), rule, help);
        for (number, name) in written.in_data.iter().flatten().enumerate() {
            let known = |data: &DataFile| name_of(data) == name;
            if !self.file.data.iter().any(known) {
                let rule = format!("is \"{name}\", but no [[data]] has this name or kind");
                return Err(wrong(&format!("in_data[{number}]"), &rule, ""));
            }
        }
        let (key, role, name) = match (&written.key, &written.multiplies) {
            (Some(_), Some(_)) => {
                let rule = format!("and `{}` exclude each other", place("key"));
                return Err(wrong("multiplies", &rule, "give one of the two"));
            }
            (None, None) => {
                let help = "give the key of the case, or multiplies = \"…\" with a name";
                return Err(self.source.missing(&place("key"), help));
            }
            (None, Some(key)) => {
                let name = written.name.clone().ok_or_else(|| {
                    self.source.missing(
                        &place("name"),
                        "name the factor, as in \"preload_stiffening\"",
                    )
                })?;
                (key, Role::Multiplies(key.clone()), name)
            }
            (Some(key), None) => match key.strip_prefix("vehicle.") {
                Some(rest) => {
                    let vehicle = self.vehicle(&at, written)?;
                    let of = VehicleKey::of(rest).ok_or_else(|| {
                        let rule = format!("is \"{key}\", which a vehicle does not have or which cannot be uncertain");
                        wrong("key", &rule, "take speed.mean, speed.standard_deviation, traction_share, tractive_ratio, creepage, wheel_load, axle_load, wheel_mass, rolling_radius or set.… after vehicle.")
                    })?;
                    let several = vehicles.len() > 1;
                    let name = match several {
                        true => format!("{key} ({})", vehicles[vehicle].name),
                        false => key.clone(),
                    };
                    (key, Role::Vehicle(vehicle, of), name)
                }
                None => (
                    key,
                    Role::Key(key.clone()),
                    written.name.clone().unwrap_or_else(|| key.clone()),
                ),
            },
        };
        let of_key = match &role {
            Role::Vehicle(_, VehicleKey::OfCase(of, _)) if key.starts_with("vehicle.set.") => of,
            _ => key,
        };
        let quantity = match (key.strip_prefix("vehicle."), PhysicalRange::of(of_key)) {
            (Some(_), Some(range)) => Some(range.kind),
            (Some("traction_share"), None) => Some(quantity::Kind::of::<Ratio>()),
            _ => match CaseKey::find_with_curving(of_key) {
                Some(known) => known.quantity,
                None => {
                    let rule = format!("is \"{key}\", but the case file has no such key");
                    let help = format!("did you mean {}?", CaseKey::nearest(of_key));
                    let which = if written.key.is_some() {
                        "key"
                    } else {
                        "multiplies"
                    };
                    return Err(wrong(which, &rule, &help));
                }
            },
        };
        let which = if written.key.is_some() {
            "key"
        } else {
            "multiplies"
        };
        let quantity = quantity.ok_or_else(|| {
            let rule = format!("is \"{key}\", which takes a choice, a name or a whole number");
            wrong(which, &rule, "only quantities can be uncertain")
        })?;
        let multiplies = matches!(role, Role::Multiplies(_));
        let kind = match multiplies {
            true => quantity::Kind::of::<Ratio>(),
            false => quantity,
        };
        let distribution = riffel_study::distribution(self.source, &at, kind, &written.prior())?;
        let distribution = distribution.ok_or_else(|| {
            let help = "give one of lognormal, normal, uniform and triangular";
            self.source.missing(&place("lognormal"), help)
        })?;
        let ends = match (&role, PhysicalRange::of(of_key)) {
            (Role::Multiplies(_), _) => [0.0, f64::INFINITY],
            (Role::Vehicle(_, VehicleKey::TractionShare), _) => [0.0, 1.0],
            (_, Some(range)) => range.hard,
            (_, None) => [f64::NEG_INFINITY, f64::INFINITY],
        };
        let prior = Prior::within(distribution, ends).ok_or_else(|| {
            let rule = format!(
                "leaves nothing of the range that can be computed, {} to {}",
                ends[0], ends[1]
            );
            self.source.invalid(&at, &rule, "")
        })?;
        let own = match &role {
            Role::Multiplies(_) => None,
            Role::Vehicle(vehicle, of) => vehicles[*vehicle].number(of),
            _ => number_of(self.case, key),
        };
        if let Some(own) = own
            && excludes(&prior, own)
        {
            let rule = format!(
                "excludes {}, the value of the case for `{key}`: it lies beyond the ends or four standard deviations of the prior",
                Quantity::<Ratio>::new(own)
            );
            return Err(self
                .source
                .invalid(&at, &rule, "widen the prior, or correct the case"));
        }
        Ok(Parameter {
            name,
            unit: kind.unit.to_owned(),
            prior,
            role,
            in_data: written.in_data.clone(),
        })
    }

    /// The vehicle that a parameter is of.
    fn vehicle(&self, at: &str, written: &UncertainFile) -> Result<usize, CaseError> {
        let vehicles = self.vehicles;
        let key = format!("{at}.key");
        if vehicles.is_empty() {
            let rule = "is a key of a vehicle, but the plan names no traffic";
            return Err(self
                .source
                .invalid(&key, rule, "give traffic = \"traffic.toml\""));
        }
        match &written.name {
            None if vehicles.len() == 1 => Ok(0),
            None => {
                let names: Vec<&str> = vehicles.iter().map(|vehicle| &*vehicle.name).collect();
                let help = format!("the traffic has several vehicles: {}", names.join(", "));
                Err(self.source.missing(&format!("{at}.name"), &help))
            }
            Some(name) => vehicles
                .iter()
                .position(|vehicle| vehicle.name == *name)
                .ok_or_else(|| {
                    let rule =
                        format!("is \"{name}\", but no vehicle of the traffic has this name");
                    self.source.invalid(&format!("{at}.name"), &rule, "")
                }),
        }
    }

    /// The view of some data: that of others where the same holds for both.
    fn view(&mut self, index: usize) -> Result<usize, CaseError> {
        let data = &self.file.data[index];
        let acts = |parameter: &Parameter| match &parameter.in_data {
            _ if parameter.role == Role::Size => false,
            None => true,
            Some(names) => names.iter().any(|name| name == name_of(data)),
        };
        let acting: Vec<usize> = (0..self.parameters.len())
            .filter(|it| acts(&self.parameters[*it]))
            .collect();
        let mut set = settings(&data.set);
        // It is the same rail: with shear where the case has it, whatever these data have under it.
        if set.iter().any(|(key, _)| key == "track.model")
            && !set.iter().any(|(key, _)| key == "rail.beam")
            && let Ok(beam) = Value::try_from(self.case.beam_model())
        {
            set.push(("rail.beam".to_owned(), beam));
        }
        let case = self.case.with_settings(&set).map_err(|error| match error {
            CaseError::Changed { key, message } => self
                .source
                .refuse(&format!("data[{index}].set.{key}"), &message),
            error => error,
        })?;
        let same = |view: &View| view.acting == acting && view.case.file == case.file;
        if let Some(view) = self.views.iter().position(same) {
            return Ok(view);
        }
        let wheels = self.vehicles.iter().map(|vehicle| {
            let wheel = case.with_settings(&vehicle.settings);
            wheel.map_err(|error| {
                let message = format!("vehicle \"{}\": {error}", vehicle.name);
                self.source.refuse("traffic", &message)
            })
        });
        let wheels = wheels.collect::<Result<Vec<Case>, CaseError>>()?;
        self.views.push(View {
            case,
            wheels,
            acting,
        });
        Ok(self.views.len() - 1)
    }

    /// The data, those that share errors together.
    fn blocks(&mut self) -> Result<Vec<Named>, CaseError> {
        for (index, data) in self.file.data.iter().enumerate() {
            let same = |other: &DataFile| name_of(other) == name_of(data);
            if self.file.data[..index].iter().any(same) {
                let rule = format!("is \"{}\" a second time", name_of(data));
                return Err(self.source.invalid(
                    &format!("data[{index}].name"),
                    &rule,
                    "give each its name",
                ));
            }
            self.check_keys(index, data)?;
        }
        let of_kind = |kind: Kind| {
            let data = self.file.data.iter().enumerate();
            data.filter(|(_, data)| data.kind == kind)
                .map(|(index, _)| index)
                .collect::<Vec<usize>>()
        };
        let (dated, runs) = (of_kind(Kind::DatedLevels), of_kind(Kind::AxleBox));
        if let (Some(run), true) = (runs.first(), dated.len() != 1) {
            let rule = "is \"axle-box\", which needs just one [[data]] of kind \"dated-levels\" of the same rail";
            let help = "without levels of a trolley an axle box tells the shape of a spectrum only";
            return Err(self
                .source
                .invalid(&format!("data[{run}].kind"), rule, help));
        }
        if let (Some(index), true) = (dated.first(), self.vehicles.is_empty()) {
            let rule = "is \"dated-levels\", but the plan names no traffic that made them grow";
            return Err(self.source.invalid(
                &format!("data[{index}].kind"),
                rule,
                "give traffic = \"traffic.toml\"",
            ));
        }
        let mut blocks = Vec::new();
        for index in 0..self.file.data.len() {
            let data = &self.file.data[index];
            let (block, indices): (Option<Box<dyn Block>>, Vec<usize>) = match data.kind {
                Kind::AxleBox => continue,
                Kind::FrequencyResponse => (Some(self.frequency_response(index)?), vec![index]),
                Kind::DecayRate => (Some(self.decay_rate(index)?), vec![index]),
                Kind::DatedLevels => {
                    let block = self.levels(index, &runs)?;
                    let others = runs.iter().copied();
                    (block, std::iter::once(index).chain(others).collect())
                }
            };
            let block = block.ok_or_else(|| {
                self.source.refuse(
                    &format!("data[{index}].file"),
                    "the errors of the data are zero within rounding",
                )
            })?;
            let names: Vec<String> = indices
                .iter()
                .map(|index| name_of(&self.file.data[*index]).to_owned())
                .collect();
            let sized = |name: &String| {
                let size = format!("{name}.discrepancy");
                self.size_of(
                    &size,
                    indices
                        .iter()
                        .map(|index| &self.file.data[*index])
                        .find(|data| name_of(data) == name),
                )
            };
            let sizes: Vec<Size> = names.iter().filter_map(sized).collect();
            let sizes = match (sizes.is_empty(), data.kind) {
                (true, Kind::FrequencyResponse | Kind::DecayRate) => vec![Size::Known(0.0)],
                _ => sizes,
            };
            blocks.push(Named {
                names,
                block,
                sizes,
                touched_by: Vec::new(),
            });
        }
        Ok(blocks)
    }

    /// The size that was read for some data.
    fn size_of(&self, name: &str, data: Option<&DataFile>) -> Option<Size> {
        match data?.discrepancy.as_ref()?.standard_deviation {
            SizeFile::Known(size) => Some(Size::Known(size)),
            SizeFile::HalfNormal { .. } => {
                let place = self
                    .parameters
                    .iter()
                    .position(|parameter| parameter.name == name);
                place.map(Size::Unknown)
            }
        }
    }

    /// That data have no keys of other kinds.
    fn check_keys(&self, index: usize, data: &DataFile) -> Result<(), CaseError> {
        use Kind::{AxleBox, DatedLevels, DecayRate, FrequencyResponse};
        let keys: [(&str, bool, &[Kind]); 7] = [
            ("averages", data.averages.is_some(), &[FrequencyResponse]),
            (
                "gain_error",
                data.gain_error.is_some(),
                &[FrequencyResponse],
            ),
            (
                "student_degrees",
                data.student_degrees.is_some(),
                &[DecayRate],
            ),
            (
                "common_error",
                data.common_error.is_some(),
                &[DatedLevels, AxleBox],
            ),
            ("first_level", data.first_level.is_some(), &[DatedLevels]),
            ("at_date", data.at_date.is_some(), &[AxleBox]),
            ("speed", data.speed.is_some(), &[AxleBox]),
        ];
        for (key, given, kinds) in keys {
            if given && !kinds.contains(&data.kind) {
                let kinds: Vec<&str> = kinds.iter().map(|kind| kind.name()).collect();
                let rule = format!(
                    "belongs to {}, not to {}",
                    kinds.join(" and "),
                    data.kind.name()
                );
                return Err(self
                    .source
                    .invalid(&format!("data[{index}].{key}"), &rule, ""));
            }
        }
        Ok(())
    }

    fn positive(&self, index: usize, key: &str, value: f64) -> Result<f64, CaseError> {
        if value.is_finite() && value > 0.0 {
            return Ok(value);
        }
        let rule = format!("is {value}, but must be finite and greater than zero");
        Err(self
            .source
            .invalid(&format!("data[{index}].{key}"), &rule, ""))
    }

    fn frequency_response(&mut self, index: usize) -> Result<Box<dyn Block>, CaseError> {
        let data = &self.file.data[index];
        if let Some(averages) = data.averages {
            self.positive(index, "averages", averages)?;
        }
        let gain_error = data.gain_error.unwrap_or(0.03);
        if !(gain_error.is_finite() && gain_error >= 0.0) {
            let rule = format!("is {gain_error}, but must be zero or more");
            return Err(self
                .source
                .invalid(&format!("data[{index}].gain_error"), &rule, ""));
        }
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = self.folder.join(&data.file);
        let of_view = (view, &self.views[view].case);
        let block = FrequencyResponses::read(&path, of_view, data.averages, gain_error, missed)?;
        if block.usual_errors {
            self.remarks.push(format!(
                "{} has no column `coherence`: every line is taken as good to 5 %",
                data.file
            ));
        }
        Ok(Box::new(block))
    }

    fn decay_rate(&mut self, index: usize) -> Result<Box<dyn Block>, CaseError> {
        let data = &self.file.data[index];
        let degrees = self.positive(
            index,
            "student_degrees",
            data.student_degrees.unwrap_or(5.0),
        )?;
        let student = StudentsT::new(0.0, 1.0, degrees);
        let student = student.map_err(|error| {
            self.source.refuse(
                &format!("data[{index}].student_degrees"),
                &error.to_string(),
            )
        })?;
        if let Some(discrepancy) = &data.discrepancy
            && discrepancy.kind != "band"
        {
            let rule = format!(
                "is \"{}\", but decay rates take \"band\": their bands are independent",
                discrepancy.kind
            );
            return Err(self
                .source
                .invalid(&format!("data[{index}].discrepancy.kind"), &rule, ""));
        }
        self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = self.folder.join(&data.file);
        let block = DecayRates::read(&path, (view, &self.views[view].case), student)?;
        Ok(Box::new(block))
    }

    fn levels(
        &mut self,
        index: usize,
        runs: &[usize],
    ) -> Result<Option<Box<dyn Block>>, CaseError> {
        let data = &self.file.data[index];
        if let Some(first) = &data.first_level
            && first != "flat"
        {
            let rule = format!("is \"{first}\", but must be \"flat\"");
            return Err(self
                .source
                .invalid(&format!("data[{index}].first_level"), &rule, ""));
        }
        let common_error = self.decibels(index, 0.3)?;
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let rows = DatedLevels::rows(&self.folder.join(&data.file), &self.views[view].case)?;
        let dated = DatedLevels {
            view,
            rows,
            common_error,
            missed,
        };
        let mut felt = Vec::new();
        for &index in runs {
            felt.push(self.run(index, &dated)?);
        }
        let levels = Levels::new(&dated, &felt);
        Ok(levels.map(|levels| Box::new(levels) as Box<dyn Block>))
    }

    fn run(&mut self, index: usize, dated: &DatedLevels) -> Result<AxleBoxRun, CaseError> {
        let data = &self.file.data[index];
        let speed = data.speed.ok_or_else(|| {
            self.source.missing(
                &format!("data[{index}].speed"),
                "give the speed of the run, as in speed = \"100 km/h\"",
            )
        })?;
        let speed = self.positive(index, "speed", speed.si())?;
        let dates = dated.rows.iter().map(|row| row.passages);
        let last = dates.clone().fold(0.0, f64::max);
        let passages = match &data.at_date {
            None => last,
            Some(Value::String(date)) if date == "last" => last,
            Some(Value::String(date)) if date == "first" => 0.0,
            Some(Value::Integer(passages)) if *passages >= 0 => *passages as f64,
            Some(Value::Float(passages)) if *passages >= 0.0 => *passages,
            Some(other) => {
                let rule = format!(
                    "is {other}, but must be \"first\", \"last\" or the passages since the first date"
                );
                return Err(self
                    .source
                    .invalid(&format!("data[{index}].at_date"), &rule, ""));
            }
        };
        let common_error = self.decibels(index, 0.5)?;
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = self.folder.join(&data.file);
        let rows = AxleBoxRun::rows(&path, &self.views[view].case, passages)?;
        Ok(AxleBoxRun {
            view,
            rows,
            speed,
            common_error,
            missed,
        })
    }

    /// The common error of some levels.
    fn decibels(&self, index: usize, left_out: f64) -> Result<f64, CaseError> {
        let Some(value) = &self.file.data[index].common_error else {
            return Ok(left_out);
        };
        let number = match value {
            Value::Float(number) => Some(*number),
            Value::Integer(number) => Some(*number as f64),
            Value::String(text) => text
                .strip_suffix("dB")
                .and_then(|text| text.trim().parse().ok()),
            _ => None,
        };
        number
            .filter(|number: &f64| number.is_finite() && *number >= 0.0)
            .ok_or_else(|| {
                let rule =
                    format!("is {value}, but must be a level of zero or more, as in \"0.3 dB\"");
                self.source
                    .invalid(&format!("data[{index}].common_error"), &rule, "")
            })
    }

    /// What the model misses of some data; its size becomes a parameter where it is unknown.
    fn discrepancy(&mut self, index: usize) -> Result<Option<Kernel>, CaseError> {
        let data = &self.file.data[index];
        let Some(written) = &data.discrepancy else {
            self.remarks.push(format!(
                "\"{}\" has no `discrepancy`: the model is taken as exact, and intervals will be too narrow",
                name_of(data)
            ));
            return Ok(None);
        };
        let place = |key: &str| format!("data[{index}].discrepancy.{key}");
        let kernel = self.kernel(written, data.kind, &place)?;
        let unit = match data.kind {
            Kind::FrequencyResponse => "Np",
            Kind::DecayRate => "ln",
            Kind::DatedLevels => "dB per 1e6 passages",
            Kind::AxleBox => "dB",
        };
        for (key, given, only) in [
            ("unit", &written.unit, unit),
            ("grows", &written.grows, "with passages"),
        ] {
            if let Some(given) = given
                && (given != only || key == "grows" && data.kind != Kind::DatedLevels)
            {
                let rule = format!(
                    "is \"{given}\", but must be \"{only}\" for {}",
                    data.kind.name()
                );
                return Err(self.source.invalid(&place(key), &rule, "or left out"));
            }
        }
        match written.standard_deviation {
            SizeFile::Known(size) if size.is_finite() && size >= 0.0 => {}
            SizeFile::HalfNormal { half_normal }
                if half_normal.is_finite() && half_normal > 0.0 =>
            {
                self.parameters.push(Parameter {
                    name: format!("{}.discrepancy", name_of(data)),
                    unit: unit.to_owned(),
                    prior: Prior::HalfNormal(half_normal),
                    role: Role::Size,
                    in_data: None,
                });
            }
            _ => {
                let rule = "must be a number of zero or more, or { half_normal = … } above zero";
                return Err(self.source.invalid(&place("standard_deviation"), rule, ""));
            }
        }
        Ok(Some(kernel))
    }

    fn kernel(
        &self,
        written: &DiscrepancyFile,
        kind: Kind,
        place: &impl Fn(&str) -> String,
    ) -> Result<Kernel, CaseError> {
        let wrong = |key: &str, rule: String| self.source.invalid(&place(key), &rule, "");
        match &*written.kind {
            "band" => return Ok(Kernel::Band),
            "gaussian-process" => {}
            other => {
                let rule = format!("is \"{other}\", but must be \"band\" or \"gaussian-process\"");
                return Err(wrong("kind", rule));
            }
        }
        let over = match kind {
            Kind::FrequencyResponse | Kind::DecayRate => "ln frequency",
            Kind::DatedLevels | Kind::AxleBox => "ln wavelength",
        };
        if let Some(given) = &written.over
            && given != over
        {
            let rule = format!("is \"{given}\", but must be \"{over}\" for {}", kind.name());
            return Err(wrong("over", rule));
        }
        let usual = match kind {
            Kind::FrequencyResponse | Kind::DecayRate => ("matern-3/2", 0.5),
            Kind::DatedLevels | Kind::AxleBox => ("exponential", 0.35),
        };
        let length = written.length.unwrap_or(usual.1);
        if !(length.is_finite() && length > 0.0) {
            return Err(wrong(
                "length",
                format!("is {length}, but must be greater than zero"),
            ));
        }
        let name = written.kernel.as_deref().unwrap_or(usual.0);
        Kernel::of(name, length).ok_or_else(|| {
            let rule = format!(
                "is \"{name}\", but must be one of {}",
                Kernel::NAMES.join(", ")
            );
            wrong("kernel", rule)
        })
    }
}

impl Vehicle {
    /// The number that a vehicle has for one of its keys, in SI.
    fn number(&self, key: &VehicleKey) -> Option<f64> {
        use crate::model::Speeds;
        match (key, &self.speeds) {
            (VehicleKey::TractionShare, _) => Some(self.traction_share),
            (VehicleKey::MeanSpeed, Speeds::Normal { mean, .. }) => Some(*mean),
            (VehicleKey::SpeedDeviation, Speeds::Normal { deviation, .. }) => Some(*deviation),
            (VehicleKey::OfCase(key, factor), _) => {
                let own = self.settings.iter().find(|setting| setting.0 == *key)?;
                Some(own.1.as_float()? / factor)
            }
            _ => None,
        }
    }
}

/// The name of data in the results.
fn name_of(data: &DataFile) -> &str {
    data.name.as_deref().unwrap_or(data.kind.name())
}

/// Whether a value lies beyond the ends or far out in the tails of a prior.
fn excludes(prior: &Prior, value: f64) -> bool {
    let [low, high] = prior.ends();
    let far = match *prior {
        Prior::Of(Distribution::Normal { .. }) => prior.place(value).abs(),
        Prior::Of(Distribution::Lognormal {
            log_mean,
            log_deviation,
            ..
        }) if value > 0.0 => ((value.ln() - log_mean) / log_deviation).abs(),
        _ => 0.0,
    };
    value < low || value > high || far > EXCLUDES
}

/// Whether predictions differ by rounding alone.
fn is_same(here: &[f64], there: &[f64]) -> bool {
    const ROUNDING: f64 = 1e-10;
    let mut pairs = here.iter().zip(there);
    pairs.all(|(here, there)| (here - there).abs() <= ROUNDING * (1.0 + here.abs()))
}

/// Find which parameters each block depends on: those whose change by a tenth in z changes a prediction at one of some places.
fn touch(source: &KeyFile, model: &Model, blocks: &mut [Named]) -> Result<(), CaseError> {
    const PLACES: [f64; 3] = [0.5, 0.35, 0.7];
    const CHANGE: f64 = 0.1;
    for named in blocks {
        let acting: Vec<usize> = named
            .block
            .views()
            .into_iter()
            .flat_map(|view| model.views[view].acting.clone())
            .collect();
        let mut reason = None;
        for share in PLACES {
            let values: Vec<f64> = model
                .parameters
                .iter()
                .map(|it| it.prior.quantile(share))
                .collect();
            let here = match named.block.predict(&model.trial(&values)) {
                Ok(here) => here,
                Err(error) => {
                    reason = Some(error);
                    continue;
                }
            };
            for &index in &acting {
                if named.touched_by.contains(&index) {
                    continue;
                }
                let prior = &model.parameters[index].prior;
                let mut moved = values.clone();
                moved[index] = prior.value(prior.place(values[index]) + CHANGE);
                let there = named.block.predict(&model.trial(&moved));
                if !there.is_ok_and(|there| is_same(&here, &there)) {
                    named.touched_by.push(index);
                }
            }
        }
        if let (Some(reason), true) = (reason, named.touched_by.is_empty()) {
            let message = format!("in the middle of the priors the case says: {reason}");
            return Err(source.refuse("parameter", &message));
        }
        named.touched_by.sort_unstable();
    }
    Ok(())
}
