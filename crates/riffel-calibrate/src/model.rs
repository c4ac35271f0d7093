//! What a case predicts for values of its uncertain keys.

use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

use riffel::forecast::SpeedDistribution;
use riffel::growth::RowEvaluator;
use riffel::{Complex64, Error, MeanWear, STANDARD_GRAVITY};
use riffel_case::traffic::Traffic;
use riffel_case::{Case, LoopOnTrack, Setting, SpeedChange, TrackRadiator, Variant};
use riffel_keys::CaseError;
use riffel_noise::{BandRadiation, FrequencyBand};

use crate::prior::Prior;

/// The slowest speed that an action may spread to \[m/s\].
const SLOWEST: f64 = 1.0;

/// An uncertain value.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Its name in the results.
    pub name: String,
    /// Its unit, SI.
    pub unit: String,
    /// What was known of it before.
    pub prior: Prior,
    /// What can be computed.
    pub(crate) ends: [f64; 2],
    pub(crate) role: Role,
    /// Names of the data in which it acts; none for all.
    pub(crate) in_data: Option<Vec<String>>,
}

impl Parameter {
    /// The key of the case whose value it is; none of what is of vehicles, of factors and of what the model misses.
    pub fn key_of_case(&self) -> Option<&str> {
        match &self.role {
            Role::Key(key) => Some(key),
            _ => None,
        }
    }

    /// Whether it is the size of what the model misses, and no value of a case or its traffic.
    pub fn is_size(&self) -> bool {
        self.role == Role::Size
    }
}

/// What a value does.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Role {
    /// It is that of a key of the case.
    Key(String),
    /// It multiplies that of a key of the case.
    Multiplies(String),
    /// It is that of a key of a vehicle.
    Vehicle(usize, VehicleKey),
    /// It is the size of what the model misses in some data.
    Size,
}

/// A key of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum VehicleKey {
    MeanSpeed,
    SpeedDeviation,
    TractionShare,
    /// A key of the case, and the factor between the two.
    OfCase(String, f64),
}

impl VehicleKey {
    /// That of a key after `vehicle.`.
    pub(crate) fn of(key: &str) -> Option<Self> {
        let of_case = |key: &str| Some(Self::OfCase(key.to_owned(), 1.0));
        match key {
            "speed.mean" => Some(Self::MeanSpeed),
            "speed.standard_deviation" => Some(Self::SpeedDeviation),
            "traction_share" => Some(Self::TractionShare),
            "tractive_ratio" => of_case("contact.tractive_ratio"),
            "creepage" => of_case("contact.creepage"),
            "wheel_load" => of_case("contact.normal_load"),
            "wheel_mass" => of_case("wheel.mass"),
            "rolling_radius" => of_case("wheel.rolling_radius"),
            "axle_load" => Some(Self::OfCase("contact.normal_load".to_owned(), 0.5 * STANDARD_GRAVITY)),
            key => of_case(key.strip_prefix("set.")?),
        }
    }
}

/// A kind of vehicle.
#[derive(Debug, Clone)]
pub(crate) struct Vehicle {
    pub(crate) name: String,
    pub(crate) share: f64,
    pub(crate) traction_share: f64,
    pub(crate) speeds: Speeds,
    pub(crate) settings: Vec<Setting>,
}

/// How fast a kind of vehicle runs.
#[derive(Debug, Clone)]
pub(crate) enum Speeds {
    Normal {
        mean: f64,
        deviation: f64,
    },
    /// Speeds with their shares.
    Listed(Vec<(f64, f64)>),
}

impl Vehicle {
    /// The vehicles of a traffic; why not, with the index of the one that is at fault.
    pub(crate) fn all(traffic: &Traffic) -> Result<Vec<Self>, (usize, &'static str)> {
        let vehicles = traffic.file.vehicle.iter().enumerate();
        let all: f64 = traffic.file.vehicle.iter().map(|it| it.share.si()).sum();
        let vehicle = |(index, vehicle): (usize, &riffel_case::traffic::Vehicle)| {
            let spread = [
                ("curve", vehicle.curve.is_some()),
                ("lateral_position", vehicle.lateral_position.is_some()),
                ("wheel_radius", vehicle.wheel_radius.is_some()),
                ("load", vehicle.load.is_some()),
                ("friction", vehicle.friction.is_some()),
            ];
            if let Some((key, _)) = spread.into_iter().find(|(_, is)| *is) {
                return Err((index, key));
            }
            let speeds = match (&vehicle.speed, &vehicle.speeds) {
                (Some(normal), _) => Speeds::Normal {
                    mean: normal.mean.si(),
                    deviation: normal.standard_deviation.map_or(0.0, |it| it.si()),
                },
                (None, listed) => {
                    let listed = listed.iter().flatten();
                    Speeds::Listed(listed.map(|it| (it.speed.si(), it.share.si())).collect())
                }
            };
            Ok(Self {
                name: vehicle.name.clone(),
                share: vehicle.share.si() / all,
                traction_share: vehicle.traction_share.map_or(1.0, |share| share.si()),
                speeds,
                settings: traffic.settings(index),
            })
        };
        vehicles.map(vehicle).collect()
    }
}

impl Speeds {
    fn mean(&self) -> f64 {
        match self {
            Self::Normal { mean, .. } => *mean,
            Self::Listed(listed) => {
                let sum: f64 = listed.iter().map(|(speed, share)| speed * share).sum();
                sum / listed.iter().map(|(_, share)| share).sum::<f64>()
            }
        }
    }

    /// What an action makes of them; a normal distribution is cut where its slowest would be below 1 m/s.
    fn changed(&self, change: &SpeedChange) -> Self {
        let factor = match (change.factor, change.mean) {
            (Some(factor), _) => factor.si(),
            (None, Some(mean)) => mean.si() / self.mean(),
            (None, None) => 1.0,
        };
        let scaled = match self {
            Self::Normal { mean, deviation } => Self::Normal { mean: factor * mean, deviation: factor * deviation },
            Self::Listed(listed) => {
                let listed = listed.iter().map(|(speed, share)| (factor * speed, *share));
                Self::Listed(listed.collect())
            }
        };
        let given =
            change.standard_deviation.map(|deviation| Self::Normal { mean: scaled.mean(), deviation: deviation.si() });
        match given.unwrap_or(scaled) {
            Self::Normal { mean, deviation } => Self::Normal {
                mean,
                deviation: deviation.min((mean - SLOWEST) / SpeedDistribution::LEAST_MEAN_IN_DEVIATIONS).max(0.0),
            },
            listed => listed,
        }
    }

    /// Speeds with weights that sum to one, of a normal distribution 17: within 0.1 % of the largest rate of 65 speeds.
    fn nodes(&self) -> Result<Vec<(f64, f64)>, Error> {
        let speeds = match self {
            Self::Listed(listed) => SpeedDistribution::shares(listed),
            Self::Normal { mean, deviation } => SpeedDistribution::normal(*mean, *deviation),
        };
        Ok(speeds?.nodes())
    }
}

/// A case as some of the data see it.
#[derive(Clone)]
pub(crate) struct View {
    /// With what differs for these data.
    pub(crate) case: Case,
    /// Cases of the vehicles, each with its own keys.
    pub(crate) wheels: Vec<Case>,
    /// Which of the parameters act.
    pub(crate) acting: Vec<usize>,
}

/// A case, its traffic and what is uncertain of both.
#[derive(Clone)]
pub(crate) struct Model {
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) views: Vec<View>,
    pub(crate) vehicles: Vec<Vehicle>,
    /// What an action makes of the speeds; none for the model as it is.
    pub(crate) speed: Option<SpeedChange>,
}

/// The model with one set of values.
pub(crate) struct Trial<'a> {
    model: &'a Model,
    /// Of all parameters, in SI.
    pub(crate) values: &'a [f64],
    cases: Vec<OnceCell<Result<LoopOnTrack, String>>>,
    settled: Rc<RefCell<Vec<Settled>>>,
}

/// A vehicle with the values of a trial.
struct Tried {
    wheel: LoopOnTrack,
    speeds: Speeds,
    traction_share: f64,
}

/// A vehicle of a view with the numbers that its mean state follows from.
struct Settled {
    view: usize,
    vehicle: usize,
    numbers: Vec<(String, f64)>,
    case: Case,
}

impl Model {
    /// With keys of one view changed, whatever is uncertain of them, and the speeds.
    pub(crate) fn changed(&self, view: usize, variant: &Variant) -> Result<Self, CaseError> {
        let mut model = self.clone();
        let explain = |error| variant.explain(error);
        let View { case, wheels, acting } = &mut model.views[view];
        *case = case.with(&variant.settings[..]).map_err(explain)?;
        for (wheel, vehicle) in wheels.iter_mut().zip(&self.vehicles) {
            let settings = [&vehicle.settings[..], &variant.settings].concat();
            *wheel = case.with(&settings[..]).map_err(explain)?;
        }
        let is_changed = |key: &str| {
            variant.keys().any(|own| {
                let rest = key.strip_prefix(own);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
            })
        };
        acting.retain(|index| match &self.parameters[*index].role {
            Role::Key(key) | Role::Vehicle(_, VehicleKey::OfCase(key, _)) => !is_changed(key),
            _ => true,
        });
        model.speed = Some(variant.speed);
        Ok(model)
    }

    pub(crate) fn trial<'a>(&'a self, values: &'a [f64]) -> Trial<'a> {
        Trial {
            model: self,
            values,
            cases: self.views.iter().map(|_| OnceCell::new()).collect(),
            settled: Rc::default(),
        }
    }
}

impl<'a> Trial<'a> {
    /// Other values, beside which vehicles that stand as they did are not settled anew.
    pub(crate) fn moved<'b>(&self, values: &'b [f64]) -> Trial<'b>
    where
        'a: 'b,
    {
        Trial { settled: Rc::clone(&self.settled), ..self.model.trial(values) }
    }

    /// The loop of a vehicle with other numbers.
    fn wheel(&self, (view, vehicle): (usize, usize), numbers: &[(&str, f64)]) -> Result<LoopOnTrack, CaseError> {
        let wheel = &self.model.views[view].wheels[vehicle];
        if !wheel.is_in_curve() {
            return wheel.with_numbers(numbers);
        }
        let (beside, of_state): (Vec<_>, Vec<_>) =
            numbers.iter().copied().partition(|(key, _)| Case::is_beside_mean_state(key));
        let mut settled = self.settled.borrow_mut();
        let is_it = |it: &Settled| {
            let known = it.numbers.iter().map(|(key, value)| (&**key, *value));
            (it.view, it.vehicle) == (view, vehicle) && known.eq(of_state.iter().copied())
        };
        if let Some(known) = settled.iter().find(|it| is_it(it)) {
            return known.case.with_numbers(&beside);
        }
        let case = wheel.settled(&of_state)?;
        let found = case.with_numbers(&beside);
        let owned = of_state.iter().map(|(key, value)| ((*key).to_owned(), *value));
        settled.push(Settled { view, vehicle, numbers: owned.collect(), case });
        found
    }

    /// The case that a view has of it, or why there is none.
    pub(crate) fn case(&self, view: usize) -> Result<&LoopOnTrack, String> {
        let case = self.cases[view].get_or_init(|| {
            let case = self.model.views[view].case.with_numbers(&self.numbers(view));
            case.map_err(|error| error.to_string())
        });
        case.as_ref().map_err(Clone::clone)
    }

    /// What the parameters give the keys of the case.
    pub(crate) fn numbers(&self, view: usize) -> Vec<(&'a str, f64)> {
        let View { case, acting, .. } = &self.model.views[view];
        let mut numbers: Vec<(&str, f64)> = Vec::new();
        for &index in acting {
            if let Role::Key(key) = &self.model.parameters[index].role {
                numbers.push((key, self.values[index]));
            }
        }
        for &index in acting {
            if let Role::Multiplies(key) = &self.model.parameters[index].role {
                match numbers.iter_mut().find(|number| number.0 == *key) {
                    Some(number) => number.1 *= self.values[index],
                    None => {
                        let own = case.number(key).unwrap_or(f64::NAN);
                        numbers.push((key, own * self.values[index]));
                    }
                }
            }
        }
        numbers
    }

    /// What any roughness makes of the rail and a wheel on it at a speed \[m/s\], in some bands.
    pub(crate) fn radiation(
        &self,
        view: usize,
        speed: f64,
        bands: &[FrequencyBand],
    ) -> Result<Vec<BandRadiation>, String> {
        let LoopOnTrack { feedback, track, .. } = self.case(view)?;
        let case = &self.model.views[view].case;
        let bands = bands.iter().copied();
        let bands = TrackRadiator::default().bands(case, feedback, track, None, speed, bands);
        bands.map_err(|error| error.to_string())
    }

    /// Growth rates of the amplitude per axle at some wavelengths \[m\], in the mean over the traffic.
    pub(crate) fn growth_rates(&self, view: usize, lines: &[f64]) -> Result<Vec<f64>, String> {
        let rates = self.complex_growth_rates(view, lines)?;
        Ok(rates.into_iter().map(|rate| rate.re).collect())
    }

    /// Growth rates of complex amplitudes, of waves along the direction of travel.
    pub(crate) fn complex_growth_rates(&self, view: usize, lines: &[f64]) -> Result<Vec<Complex64>, String> {
        let mut rates = vec![Complex64::ZERO; lines.len()];
        for (index, vehicle) in self.model.vehicles.iter().enumerate() {
            let Tried { wheel, speeds, traction_share } = self.vehicle(view, index)?;
            let nodes = speeds.nodes().map_err(|_| "the slowest of the vehicles would stand")?;
            for (feedback, weight) in wheel.places() {
                let rate = feedback.growth_rate_per_dissipation();
                let factor = vehicle.share * traction_share * weight * rate;
                let mut row = vec![Complex64::ZERO; lines.len()];
                let mut evaluator = RowEvaluator::new(feedback, lines);
                for (speed, share) in &nodes {
                    evaluator.evaluate(*speed, &mut row);
                    for (rate, value) in rates.iter_mut().zip(&row) {
                        *rate += factor * share * value;
                    }
                }
            }
        }
        Ok(rates)
    }

    /// Mean wear of the rail per axle, in the mean over the traffic.
    pub(crate) fn mean_wear(&self, view: usize) -> Result<MeanWear, String> {
        let mut all = MeanWear { depth: 0.0, axle_mass: 0.0, bounds_growth: true };
        for (index, vehicle) in self.model.vehicles.iter().enumerate() {
            let tried = self.vehicle(view, index)?;
            let own = tried.wheel.mean_wear();
            all.depth += vehicle.share * tried.traction_share * own.depth;
            all.axle_mass += vehicle.share * own.axle_mass;
            all.bounds_growth &= own.bounds_growth;
        }
        Ok(all)
    }

    /// A vehicle with the values of the trial.
    fn vehicle(&self, view: usize, index: usize) -> Result<Tried, String> {
        let vehicle = &self.model.vehicles[index];
        let mut numbers = self.numbers(view);
        // What the vehicle says itself, the case does not say.
        numbers.retain(|(key, _)| !vehicle.settings.iter().any(|(own, _)| own == key));
        let mut speeds = vehicle.speeds.clone();
        let mut traction_share = vehicle.traction_share;
        for &acting in &self.model.views[view].acting {
            let Role::Vehicle(of, key) = &self.model.parameters[acting].role else {
                continue;
            };
            if *of != index {
                continue;
            }
            let value = self.values[acting];
            match (key, &mut speeds) {
                (VehicleKey::MeanSpeed, Speeds::Normal { mean, .. }) => *mean = value,
                (VehicleKey::SpeedDeviation, Speeds::Normal { deviation, .. }) => {
                    *deviation = value;
                }
                (VehicleKey::TractionShare, _) => traction_share = value,
                (VehicleKey::OfCase(key, factor), _) => numbers.push((key, factor * value)),
                (VehicleKey::MeanSpeed | VehicleKey::SpeedDeviation, Speeds::Listed(_)) => {}
            }
        }
        if let Some(change) = &self.model.speed {
            speeds = speeds.changed(change);
        }
        let wheel = self.wheel((view, index), &numbers);
        Ok(Tried { wheel: wheel.map_err(|error| error.to_string())?, speeds, traction_share })
    }
}
