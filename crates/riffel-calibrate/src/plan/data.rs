//! What a plan says of data.

use riffel::diagnosis::FALL_BY_GRINDING;
use riffel_case::{Case, settings};
use riffel_keys::{CaseError, Message, say};
use riffel_rail::levels_unlike_a_rail;
use statrs::distribution::StudentsT;
use toml::Value;

use super::{Reading, beside, name_of};
use crate::data::{
    AxleBoxRun, Block, Comparison, DatedLevels, DatedProfiles, DecayRates, FrequencyResponses, Levels, MeasuredRail,
    SinceGround, Size, Travel, Wear, table,
};
use crate::file::{DataFile, Kind, SizeFile};
use crate::model::{Parameter, Role, View};
use crate::posterior::Named;

impl Reading<'_> {
    /// The view of some data: that of others where the same holds for both.
    pub(super) fn view(&mut self, index: usize) -> Result<usize, CaseError> {
        let data = &self.file.data[index];
        let acts = |parameter: &Parameter| match &parameter.in_data {
            _ if parameter.role == Role::Size => false,
            None => true,
            Some(names) => names.iter().any(|name| name == name_of(data)),
        };
        let acting: Vec<usize> = (0..self.parameters.len()).filter(|it| acts(&self.parameters[*it])).collect();
        let mut set = settings(&data.set);
        // It is the same rail: with shear where the case has it, whatever these data have under it.
        if set.iter().any(|(key, _)| key == "track.model")
            && !set.iter().any(|(key, _)| key == "rail.beam")
            && let Ok(beam) = Value::try_from(self.case.beam_model())
        {
            set.push(("rail.beam".to_owned(), beam));
        }
        let case = self.case.with(&set[..]).map_err(|error| match error {
            CaseError::Changed { key, message } => self.source.refuse(&format!("data[{index}].set.{key}"), &message),
            error => error,
        })?;
        let same = |view: &View| view.acting == acting && view.case.file == case.file;
        if let Some(view) = self.views.iter().position(same) {
            return Ok(view);
        }
        let wheels = self.vehicles.iter().map(|vehicle| {
            let wheel = case.with(&vehicle.settings[..]);
            wheel.map_err(|error| {
                let error = error.message();
                let message = say!(vehicle, vehicle = &vehicle.name, error);
                self.source.refuse("traffic", message)
            })
        });
        let wheels = wheels.collect::<Result<Vec<Case>, CaseError>>()?;
        self.views.push(View { case, wheels, acting });
        Ok(self.views.len() - 1)
    }

    /// The case as it is with the values that act in all data.
    pub(super) fn view_of_all(&mut self) -> usize {
        let parameters = self.parameters.iter().enumerate();
        let acting = parameters.filter(|(_, it)| it.in_data.is_none() && it.role != Role::Size);
        let acting = acting.map(|(index, _)| index).collect();
        self.views.push(View { case: self.case.clone(), wheels: Vec::new(), acting });
        self.views.len() - 1
    }

    /// The data, those that share errors together.
    pub(super) fn blocks(&mut self) -> Result<Vec<Named>, CaseError> {
        for (index, data) in self.file.data.iter().enumerate() {
            let same = |other: &DataFile| name_of(other) == name_of(data);
            if self.file.data[..index].iter().any(same) {
                let rule = say!(is_a_second_time, text = name_of(data));
                let help = say!(give_each_its_name);
                return Err(self.invalid(index, "name", rule, help));
            }
            self.check_keys(index, data)?;
            let columns = table::unused(&beside(self.folder, &data.file), data.kind)?;
            if !columns.is_empty() {
                let columns: riffel_keys::Value = columns.into_iter().collect();
                let said = say!(unused_columns, file = &data.file, columns);
                self.remarks.push(said);
            }
        }
        let of_kind = |kind: Kind| {
            let data = self.file.data.iter().enumerate();
            data.filter(|(_, data)| data.kind == kind).map(|(index, _)| index).collect::<Vec<usize>>()
        };
        let (dated, runs) = (of_kind(Kind::DatedLevels), of_kind(Kind::AxleBox));
        let (pass_bys, profiles) = (of_kind(Kind::PassBy), of_kind(Kind::DatedProfiles));
        if let (Some(own), true) = (runs.iter().chain(&pass_bys).min(), dated.len() != 1) {
            let kind = self.file.data[*own].kind;
            let rule = say!(is_kind_that_needs_levels, kind = kind.name());
            let help = match kind {
                Kind::PassBy => say!(pass_by_without_levels),
                _ => say!(axle_box_without_levels),
            };
            return Err(self.invalid(*own, "kind", rule, help));
        }
        let wear = of_kind(Kind::Wear);
        let growing = dated.iter().chain(&profiles).chain(&wear).min();
        if let (Some(index), true) = (growing, self.vehicles.is_empty()) {
            let kind = self.file.data[*index].kind.name();
            let rule = say!(is_kind_without_traffic, kind);
            return Err(self.invalid(*index, "kind", rule, say!(give_traffic)));
        }
        let mut blocks = Vec::new();
        for index in 0..self.file.data.len() {
            let data = &self.file.data[index];
            let (block, indices): (Option<Box<dyn Block>>, Vec<usize>) = match data.kind {
                Kind::AxleBox | Kind::PassBy => continue,
                Kind::FrequencyResponse => (Some(self.frequency_response(index)?), vec![index]),
                Kind::DecayRate => (Some(self.decay_rate(index)?), vec![index]),
                Kind::DatedProfiles => (Some(self.profiles(index)?), vec![index]),
                Kind::Wear => (self.wear(index)?, vec![index]),
                Kind::DatedLevels => {
                    let block = self.levels(index, &runs, &pass_bys)?;
                    let others = runs.iter().chain(&pass_bys).copied();
                    (block, std::iter::once(index).chain(others).collect())
                }
            };
            let block =
                block.ok_or_else(|| self.source.refuse(&format!("data[{index}].file"), say!(errors_are_zero)))?;
            let names: Vec<String> = indices.iter().map(|index| name_of(&self.file.data[*index]).to_owned()).collect();
            let sized = |name: &String| {
                let size = format!("{name}.discrepancy");
                self.size_of(
                    &size,
                    indices.iter().map(|index| &self.file.data[*index]).find(|data| name_of(data) == name),
                )
            };
            let sizes: Vec<Size> = names.iter().filter_map(sized).collect();
            let sizes = match (sizes.is_empty(), data.kind) {
                (true, Kind::FrequencyResponse | Kind::DecayRate) => vec![Size::Known(0.0)],
                _ => sizes,
            };
            blocks.push(Named { names, block, sizes, touched_by: Vec::new() });
        }
        Ok(blocks)
    }

    /// The size that was read for some data.
    fn size_of(&self, name: &str, data: Option<&DataFile>) -> Option<Size> {
        match data?.discrepancy.as_ref()?.standard_deviation {
            SizeFile::Known(size) => Some(Size::Known(size)),
            SizeFile::HalfNormal { .. } => {
                let place = self.parameters.iter().position(|parameter| parameter.name == name);
                place.map(Size::Unknown)
            }
        }
    }

    /// That data have no keys of other kinds.
    fn check_keys(&self, index: usize, data: &DataFile) -> Result<(), CaseError> {
        use Kind::{AxleBox, DatedLevels, DatedProfiles, DecayRate, FrequencyResponse, PassBy};
        let keys: [(&str, bool, &[Kind]); 16] = [
            ("averages", data.averages.is_some(), &[FrequencyResponse]),
            ("gain_error", data.gain_error.is_some(), &[FrequencyResponse]),
            ("student_degrees", data.student_degrees.is_some(), &[DecayRate]),
            ("common_error", data.common_error.is_some(), &[DatedLevels, DatedProfiles, AxleBox, PassBy]),
            ("first_level", data.first_level.is_some(), &[DatedLevels]),
            ("at_date", data.at_date.is_some(), &[AxleBox]),
            ("speed", data.speed.is_some(), &[AxleBox, PassBy]),
            ("wheels", data.wheels.is_some(), &[PassBy]),
            ("train_length", data.train_length.is_some(), &[PassBy]),
            ("distance", data.distance.is_some(), &[PassBy]),
            ("height", data.height.is_some(), &[PassBy]),
            ("wheel_roughness", data.wheel_roughness.is_some(), &[PassBy]),
            ("roughness", data.roughness.is_some(), &[PassBy]),
            ("rail", data.rail.is_some(), &[DatedProfiles]),
            ("travel", data.travel.is_some(), &[DatedProfiles]),
            (
                "discrepancy",
                data.discrepancy.is_some(),
                &[FrequencyResponse, DecayRate, DatedLevels, DatedProfiles, AxleBox],
            ),
        ];
        for (key, given, kinds) in keys {
            if given && !kinds.contains(&data.kind) {
                let kinds = kinds.iter().map(|kind| kind.name());
                let kinds: riffel_keys::Value = kinds.collect();
                let rule = say!(is_set_but_belongs_to_kinds, kinds, kind = data.kind.name());
                return Err(self.invalid(index, key, rule, say!(leave_it_out)));
            }
        }
        Ok(())
    }

    pub(super) fn positive(&self, index: usize, key: &str, value: f64) -> Result<f64, CaseError> {
        if value.is_finite() && value > 0.0 {
            return Ok(value);
        }
        let rule = say!(is_but_must_be, value, rule = say!(finite_and_above_zero));
        Err(self.invalid(index, key, rule, ""))
    }

    /// A key of some data whose value is not allowed, as [`KeyFile::invalid`](riffel_keys::KeyFile::invalid).
    pub(super) fn invalid(&self, index: usize, key: &str, rule: Message, help: impl Into<Message>) -> CaseError {
        self.source.invalid(&format!("data[{index}].{key}"), rule, help)
    }

    fn frequency_response(&mut self, index: usize) -> Result<Box<dyn Block>, CaseError> {
        let data = &self.file.data[index];
        if let Some(averages) = data.averages {
            self.positive(index, "averages", averages)?;
        }
        let gain_error = data.gain_error.unwrap_or(0.03);
        if !(gain_error.is_finite() && gain_error >= 0.0) {
            let rule = say!(is_but_must_be, value = gain_error, rule = say!(zero_or_more));
            return Err(self.invalid(index, "gain_error", rule, ""));
        }
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = beside(self.folder, &data.file);
        let of_view = (view, &self.views[view].case);
        let block = FrequencyResponses::read(&path, of_view, data.averages, gain_error, missed)?;
        if block.usual_errors {
            self.remarks.push(say!(no_coherence, file = &data.file));
        }
        if block.data() < block.lines {
            self.remarks.push(say!(
                lines_are_taken_together,
                file = &data.file,
                lines = block.lines,
                bands = block.data()
            ));
        }
        let doubts = block.doubts.iter().cloned();
        self.remarks.extend(doubts.map(|doubt| doubt.about(&data.file)));
        Ok(Box::new(block))
    }

    fn decay_rate(&mut self, index: usize) -> Result<Box<dyn Block>, CaseError> {
        let data = &self.file.data[index];
        let degrees = self.positive(index, "student_degrees", data.student_degrees.unwrap_or(5.0))?;
        let student = StudentsT::new(0.0, 1.0, degrees);
        let student = student
            .map_err(|error| self.source.refuse(&format!("data[{index}].student_degrees"), error.to_string()))?;
        if let Some(discrepancy) = &data.discrepancy
            && discrepancy.kind != "band"
        {
            let rule = say!(is_kind_but_decay_rates_take_bands, kind = &discrepancy.kind);
            return Err(self.invalid(index, "discrepancy.kind", rule, ""));
        }
        self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = beside(self.folder, &data.file);
        let block = DecayRates::read(&path, (view, &self.views[view].case), student)?;
        Ok(Box::new(block))
    }

    /// `None` if a factor of one leaves no error.
    fn wear(&mut self, index: usize) -> Result<Option<Box<dyn Block>>, CaseError> {
        let view = self.view(index)?;
        let path = beside(self.folder, &self.file.data[index].file);
        let block = Wear::read(&path, view)?;
        Ok(block.map(|block| Box::new(block) as Box<dyn Block>))
    }

    fn profiles(&mut self, index: usize) -> Result<Box<dyn Block>, CaseError> {
        let travel = match self.file.data[index].travel.as_deref() {
            None => None,
            Some("rising") => Some(Travel::Rising),
            Some("falling") => Some(Travel::Falling),
            Some(other) => {
                let rule = say!(this_or_that, this = "rising", that = "falling");
                let rule = say!(is_name_but_must_be, name = other, rule);
                return Err(self.invalid(index, "travel", rule, ""));
            }
        };
        let common_error = self.decibels(index, 0.3)?;
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let data = &self.file.data[index];
        let comparison = Comparison { rail: data.rail.as_deref(), travel, common_error, missed };
        let path = beside(self.folder, &data.file);
        let of_view = (view, &self.views[view].case);
        let (block, remarks, files) = DatedProfiles::read(&path, of_view, &comparison)?;
        self.remarks.extend(remarks);
        self.inputs.extend(files);
        Ok(Box::new(block))
    }

    fn levels(
        &mut self,
        index: usize,
        runs: &[usize],
        pass_bys: &[usize],
    ) -> Result<Option<Box<dyn Block>>, CaseError> {
        let data = &self.file.data[index];
        if let Some(first) = &data.first_level
            && first != "flat"
        {
            let rule = say!(is_name_but_must_be, name = first, rule = "\"flat\"");
            return Err(self.invalid(index, "first_level", rule, ""));
        }
        let common_error = self.decibels(index, 0.3)?;
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = beside(self.folder, &data.file);
        let SinceGround { rows, begins, before } = DatedLevels::rows(&path, &self.views[view].case)?;
        if before > 0.0 {
            let (file, fall) = (&data.file, FALL_BY_GRINDING);
            let said = say!(ground_between_dates, file, passages = begins, fall);
            self.remarks.push(said);
        }
        let doubt = levels_unlike_a_rail(rows.iter().map(|row| row.level));
        self.remarks.extend(doubt.map(|doubt| doubt.about(&data.file)));
        let dated = DatedLevels { view, rows, begins, before, common_error, missed };
        let (mut of_runs, mut of_pass_bys) = (Vec::new(), Vec::new());
        for &index in runs {
            of_runs.push(self.run(index, &dated)?);
        }
        for &index in pass_bys {
            of_pass_bys.push(self.pass_bys(index, &dated)?);
        }
        let levels = Levels::new(&MeasuredRail { dated, runs: of_runs, pass_bys: of_pass_bys });
        Ok(levels.map(|levels| Box::new(levels) as Box<dyn Block>))
    }

    fn run(&mut self, index: usize, dated: &DatedLevels) -> Result<AxleBoxRun, CaseError> {
        let data = &self.file.data[index];
        let speed = data
            .speed
            .ok_or_else(|| self.source.missing(&format!("data[{index}].speed"), say!(give_the_speed_of_the_run)))?;
        let speed = self.positive(index, "speed", speed.si())?;
        let dates = dated.rows.iter().map(|row| row.passages);
        let last = dates.clone().fold(0.0, f64::max);
        let passages = match &data.at_date {
            None => last,
            Some(Value::String(date)) if date == "last" => last,
            Some(Value::String(date)) if date == "first" => 0.0,
            Some(Value::Integer(passages)) if *passages as f64 >= dated.before => *passages as f64 - dated.before,
            Some(Value::Float(passages)) if *passages >= dated.before => *passages - dated.before,
            Some(other) => {
                let rule = say!(date_of_a_run);
                let rule = say!(is_but_must_be, value = other.to_string(), rule);
                return Err(self.invalid(index, "at_date", rule, ""));
            }
        };
        let begins = dated.begins - dated.before;
        if let (Some(Value::Integer(_) | Value::Float(_)), true) = (&data.at_date, begins != 0.0) {
            let (since, counted) = (passages + dated.before, passages + dated.begins);
            let said = say!(run_since_first_date, since, counted);
            self.remarks.push(said.about(&data.file));
        }
        let common_error = self.decibels(index, 0.5)?;
        let missed = self.discrepancy(index)?;
        let view = self.view(index)?;
        let path = beside(self.folder, &data.file);
        let rows = AxleBoxRun::rows(&path, &self.views[view].case, passages)?;
        Ok(AxleBoxRun { view, rows, speed, common_error, missed })
    }

    /// The common error of some levels.
    pub(super) fn decibels(&self, index: usize, left_out: f64) -> Result<f64, CaseError> {
        let Some(value) = &self.file.data[index].common_error else {
            return Ok(left_out);
        };
        let number = match value {
            Value::Float(number) => Some(*number),
            Value::Integer(number) => Some(*number as f64),
            Value::String(text) => text.strip_suffix("dB").and_then(|text| text.trim().parse().ok()),
            _ => None,
        };
        number.filter(|number: &f64| number.is_finite() && *number >= 0.0).ok_or_else(|| {
            let rule = say!(level_of_zero_or_more);
            let rule = say!(is_but_must_be, value = value.to_string(), rule);
            self.invalid(index, "common_error", rule, "")
        })
    }
}
