//! What is computed for each sample.

mod band;
pub(crate) mod file;
mod variable;
mod wave;

use riffel::Complex64;
use riffel::growth::{RidgeSearch, RowEvaluator};
use riffel_case::traffic::{Traffic, UsualTraffic, bands_of};
use riffel_case::{Case, Setting, Variant, ask};
use riffel_keys::{CaseError, KeyFile, Message, say};

pub use band::Band;
use band::bands;
use file::{MapQuantity, OutputsFile};
use variable::RIDGE_FREQUENCY;
pub use variable::{Dimension, Variable};
pub use wave::WaveQuantity;

/// What is computed for each sample of a study.
#[derive(Debug, Clone)]
pub struct Outputs {
    file: OutputsFile,
    /// Wavelengths of the map \[m\].
    wavelengths: Vec<f64>,
    /// Speeds of the map \[m/s\].
    speeds: Vec<f64>,
    bands: Vec<Band>,
    /// That under which the fastest growth is asked for.
    traffic: Option<Traffic>,
    variables: Vec<Variable>,
    /// Numbers of each variable in one sample.
    lengths: Vec<usize>,
}

impl Outputs {
    /// What a plan asks for on the window of its case, with what is to be asked about points that are not usual.
    pub(crate) fn new(source: &KeyFile, file: &OutputsFile, case: &Case) -> Result<(Self, Vec<Message>), CaseError> {
        let mut remarks = Vec::new();
        let mut outputs = Self {
            file: file.clone(),
            wavelengths: case.wavelength.values(),
            speeds: case.speed.values(),
            bands: bands(source, file, case)?,
            traffic: traffic(source, file, case)?,
            variables: Vec::new(),
            lengths: Vec::new(),
        };
        for (index, point) in file.point.iter().enumerate() {
            let key = |name: &str| format!("outputs.point[{index}].{name}");
            for name in ["wavelength", "speed"] {
                remarks.extend(source.judge(&key(name))?);
            }
            if point.quantities.is_empty() {
                return Err(source.invalid(&key("quantities"), say!(is_an_empty_list), ""));
            }
            if !is_plain(point.name.as_deref()) {
                let name = point.name.as_deref().unwrap_or_default();
                return Err(source.invalid(&key("name"), not_plain(name), ""));
            }
        }
        for (index, wave) in file.wave.iter().enumerate() {
            let key = |name: &str| format!("outputs.wave[{index}].{name}");
            for name in ["wavelength", "speed", "amplitude"] {
                remarks.extend(source.judge(&key(name))?);
            }
            let refuse = |name: &str, rule: Message, help: &str| Err(source.invalid(&key(name), rule, help));
            if wave.quantities.is_empty() {
                return refuse("quantities", say!(is_an_empty_list), "");
            }
            if !is_plain(wave.name.as_deref()) {
                let name = wave.name.as_deref().unwrap_or_default();
                return refuse("name", not_plain(name), "");
            }
            let asks_for_amplitude = wave.quantities.contains(&WaveQuantity::AmplitudeM);
            match wave.passages {
                Some(0) => {
                    let rule = say!(is_but_must_be, value = 0.0, rule = say!(one_or_more));
                    return refuse("passages", rule, "");
                }
                None if asks_for_amplitude => {
                    let rule = Message::verbatim("asks for amplitude_m, but no passages are given");
                    return refuse("quantities", rule, "without passages it is outputs.wave.amplitude");
                }
                _ => {}
            }
        }
        outputs.variables = outputs.describe();
        if outputs.variables.is_empty() {
            let help = "ask for something, as in ridge = true";
            return Err(source.invalid("outputs", "is empty: nothing would be computed", help));
        }
        for (index, variable) in outputs.variables.iter().enumerate() {
            if outputs.variables[..index].iter().any(|other| other.name == variable.name) {
                let rule = format!("asks for {} twice", variable.name);
                return Err(source.invalid("outputs", &rule, "give each point a name of its own"));
            }
        }
        outputs.lengths = outputs.variables.iter().map(|variable| outputs.length(variable)).collect();
        Ok((outputs, remarks))
    }

    /// The arrays, in their order.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Numbers of an array in one sample; a complex value counts as two.
    pub fn length(&self, variable: &Variable) -> usize {
        let values: usize = variable.dimensions.iter().map(|&dimension| self.size(dimension)).product();
        values * if variable.complex { 2 } else { 1 }
    }

    /// Length of a dimension.
    pub fn size(&self, dimension: Dimension) -> usize {
        match dimension {
            Dimension::Speed => self.speeds.len(),
            Dimension::Wavelength => self.wavelengths.len(),
            Dimension::Band => self.bands.len(),
        }
    }

    /// Wavelengths of the map \[m\].
    pub fn wavelengths(&self) -> &[f64] {
        &self.wavelengths
    }

    /// Speeds of the map \[m/s\].
    pub fn speeds(&self) -> &[f64] {
        &self.speeds
    }

    /// Bands of wavelength.
    pub fn bands(&self) -> &[Band] {
        &self.bands
    }

    /// The dimensions that the arrays have.
    pub fn dimensions(&self) -> Vec<Dimension> {
        let all = [Dimension::Speed, Dimension::Wavelength, Dimension::Band];
        let used = |dimension: &Dimension| self.variables.iter().any(|v| v.dimensions.contains(dimension));
        all.into_iter().filter(used).collect()
    }

    /// Whether an array has the axes of the map, or bands of them.
    pub(crate) fn has_axes(&self) -> bool {
        !self.dimensions().is_empty()
    }

    /// Whether the whole window is computed.
    fn uses_window(&self) -> bool {
        let file = &self.file;
        file.ridge || self.has_axes()
    }

    /// The arrays that are asked for, in their order.
    fn describe(&self) -> Vec<Variable> {
        let file = &self.file;
        let asked = [
            (file.ridge, variable::RIDGE),
            (file.ridge_over_speed, variable::RIDGE_OVER_SPEED),
            (file.growth_by_wavelength, variable::GROWTH_BY_WAVELENGTH),
            (!self.bands.is_empty(), variable::GROWTH_BY_BAND),
        ];
        let asked = asked.into_iter().filter(|(is_asked, _)| *is_asked);
        let on_window = asked.flat_map(|(_, rows)| rows.iter().map(Variable::of));
        let maps = file.map.iter().map(Variable::of_map);
        let traffic = match self.traffic {
            Some(_) => variable::UNDER_TRAFFIC,
            None => &[],
        };
        let mut variables: Vec<Variable> = on_window.chain(maps).collect();
        variables.extend(traffic.iter().map(Variable::of));
        for (index, point) in file.point.iter().enumerate() {
            let usual = || format!("point_{}", index + 1);
            let name = point.name.clone().unwrap_or_else(usual);
            variables.extend(point.variables(&name));
        }
        for (index, wave) in file.wave.iter().enumerate() {
            let usual = || format!("wave_{}", index + 1);
            let name = wave.name.clone().unwrap_or_else(usual);
            variables.extend(wave.variables(&name));
        }
        variables
    }

    /// The case with settings, if everything asked for can be computed on it.
    pub(crate) fn on(&self, case: &Case, settings: &[Setting]) -> Result<Case, CaseError> {
        let case = case.with(settings)?;
        if self.uses_window() {
            case.check_window()?;
        }
        for point in &self.file.point {
            case.check_points([point.wavelength.si(); 2], [point.speed.si(); 2])?;
        }
        for wave in &self.file.wave {
            case.check_points([wave.wavelength.si(); 2], [wave.speed.si(); 2])?;
        }
        Ok(case)
    }

    /// All values on a case in the order of the variables, the parts of a complex value one after the other; or
    /// why there are none.
    pub(crate) fn evaluate(&self, case: &Case) -> Result<Vec<f64>, String> {
        let mut values = Vec::with_capacity(self.lengths.iter().sum());
        if self.uses_window() {
            self.evaluate_window(case, &mut values);
        }
        if let Some(traffic) = &self.traffic {
            let on = traffic.on(case, &bands_of(case), &Variant::none(""), &|_| ());
            let growth = on.map_err(|error| error.to_string())?.growth;
            let (wavelength, rate, at_edge) =
                ask::fastest_under(case, &growth).ok_or("no wavelength is in the window")?;
            values.extend([rate, wavelength, f64::from(u8::from(at_edge))]);
        }
        for point in &self.file.point {
            let (wavelength, speed) = (point.wavelength.si(), point.speed.si());
            let state = case.point(wavelength, speed).map_err(|error| error.to_string())?;
            for &quantity in &point.quantities {
                let value = quantity
                    .number(case, &state)
                    .ok_or_else(|| format!("{} is none of this creep law", quantity.key()))?;
                values.push(value.re);
                if quantity.is_complex() {
                    values.push(value.im);
                }
            }
        }
        for wave in &self.file.wave {
            wave.evaluate(case, &mut values)?;
        }
        self.check_finite(&values)?;
        Ok(values)
    }

    fn evaluate_window(&self, case: &Case, values: &mut Vec<f64>) {
        let file = &self.file;
        let (wavelength, speed) = (case.wavelength, case.speed);
        let feedback = &case.feedback;
        let rate = feedback.growth_rate_per_dissipation();
        let mut evaluator = RowEvaluator::for_map(feedback, &wavelength.values(), &speed.values());
        // Every sample has as many values.
        let told = ask::growth_window(case).unwrap_or(wavelength);
        let mut search = RidgeSearch::new(feedback, told, &speed.values());
        let mut row = vec![Complex64::ZERO; wavelength.points()];
        let (mut ridge, mut map) = (Vec::new(), Vec::new());
        let with_mean = file.growth_by_wavelength || !self.bands.is_empty();
        let mut mean = vec![0.0; if with_mean { row.len() } else { 0 }];
        for index in 0..speed.points() {
            let speed = speed.value(index);
            evaluator.evaluate(speed, &mut row);
            if file.ridge || file.ridge_over_speed {
                ridge.push(search.row(speed));
            }
            for (mean, value) in mean.iter_mut().zip(&row) {
                *mean += rate * value.re;
            }
            if !file.map.is_empty() {
                map.extend_from_slice(&row);
            }
        }
        mean.iter_mut().for_each(|mean| *mean /= speed.points() as f64);
        let ridge = search.ridge(&ridge, 1);
        let flag = |is: bool| if is { 1.0 } else { 0.0 };
        if file.ridge {
            values.push(ridge.best_fit_frequency().unwrap_or(f64::NAN));
            // A window has speeds.
            if let Some(highest) = ridge.highest() {
                // A lower or a higher speed would grow faster.
                let at_end_of_speeds = [speed.min(), speed.max()].contains(&highest.speed);
                values.extend([
                    highest.growth_rate,
                    highest.wavelength,
                    highest.speed,
                    highest.frequency,
                    flag(highest.at_edge || at_end_of_speeds),
                ]);
            }
        }
        if file.ridge_over_speed {
            values.extend(ridge.points.iter().map(|point| point.wavelength));
            values.extend(ridge.points.iter().map(|point| point.growth_rate));
            values.extend(ridge.points.iter().map(|point| flag(point.at_edge)));
        }
        if file.growth_by_wavelength {
            values.extend(&mean);
        }
        values.extend(self.bands.iter().map(|band| {
            let lines = mean[band.lines.clone()].iter().copied();
            lines.fold(f64::NEG_INFINITY, f64::max)
        }));
        for quantity in &file.map {
            match quantity {
                MapQuantity::GrowthRate => values.extend(map.iter().map(|value| rate * value.re)),
                MapQuantity::NormalizedDissipation => {
                    values.extend(map.iter().flat_map(|value| [value.re, value.im]));
                }
            }
        }
    }

    fn check_finite(&self, values: &[f64]) -> Result<(), String> {
        let mut rest = values;
        for (variable, &length) in self.variables.iter().zip(&self.lengths) {
            let (own, others) = rest.split_at(length);
            rest = others;
            if variable.name != RIDGE_FREQUENCY && !own.iter().all(|value| value.is_finite()) {
                return Err(format!("{} is not a finite number", variable.name));
            }
        }
        Ok(())
    }
}

/// The traffic of a plan.
fn traffic(source: &KeyFile, file: &OutputsFile, case: &Case) -> Result<Option<Traffic>, CaseError> {
    match &file.traffic {
        Some(_) if file.usual_traffic => Err(source.refuse(
            "outputs.usual_traffic",
            "`outputs.usual_traffic` and `outputs.traffic` exclude each other; give one of the two",
        )),
        Some(keys) => Traffic::of_keys("outputs.traffic", keys).map(Some),
        None if file.usual_traffic => UsualTraffic::of(case).traffic().map(Some),
        None => Ok(None),
    }
}

/// What is wrong with a name that is not plain.
fn not_plain(name: &str) -> Message {
    format!("is \"{name}\", but must be of letters, figures and _ alone").into()
}

/// Whether a name, if there is one, can be that of an array.
fn is_plain(name: Option<&str>) -> bool {
    name.is_none_or(|name| !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'))
}
