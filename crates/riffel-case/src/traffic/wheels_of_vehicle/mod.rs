//! The wheels of a vehicle on a case, as loops: one, or all of a curve, for every part of its spreads.

mod across_rail;
mod spread_effects;

use std::collections::HashMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use across_rail::AcrossRail;
use rayon::prelude::*;
use riffel::Loop;
use riffel::forecast::{MeanGrowth, SpeedDistribution, VehicleGrowth};
use riffel::roughness::ThirdOctave;
use riffel_keys::{CaseError, Message, Value, say, shown_speed};
use riffel_numerics::distribution::Distribution;

use super::on_case::VehicleOnCase;
use super::spreads::{LOAD, PartValues, Rules, Spreads};
use super::through_curve::{ThroughCurve, is_of_vehicle};
use super::vehicle_keys::settings_of;
use super::wheel_on_case::{WheelOnCase, window};
use super::{CurveOfVehicle, Traffic};
use crate::ask;
use crate::case::kept_state::KeptState;
use crate::curve::Equilibrium;
use crate::file::FromCurve;
use crate::file::setting::Setting;
use crate::keys::substitutes::Substitutes;
use crate::parts::window::Window;
use crate::traffic::through_curve::before_a_wheel;
use crate::{Case, Hold, Variant};

/// Change of the growth rates between two rules of quadrature, relative to the largest, at which the coarser is taken.
const TOLERANCE: f64 = 5e-3;
/// Standard deviations of the speed from its mean at which a vehicle is balanced in its curve: between them rates are
/// interpolated.
const BALANCED_AT: [f64; 7] = [-4.0, -2.0, -1.0, 0.0, 1.0, 2.0, 4.0];

/// Wheels of a vehicle, each with the share of its part.
type Parts = Vec<(f64, Arc<WheelsOfVehicle>)>;

/// A vehicle balanced at some speeds \[m/s\].
type BalancedAt = Vec<(f64, Arc<Equilibrium>)>;

/// One wheel with its share in the passages of the vehicle.
pub(super) struct WheelOfVehicle {
    share: f64,
    /// Its loops with the weights of their places, at some speeds \[m/s\].
    states: Vec<(f64, Vec<(Loop, f64)>)>,
    speeds: SpeedDistribution,
    /// Where it runs, if that counts.
    across: Option<AcrossRail>,
    /// Mass of an axle of its bogie \[kg\], if it has one.
    axle_mass: Option<f64>,
    /// Growth under it in the bands of the traffic, once it was asked for.
    growth: OnceLock<VehicleGrowth>,
}

/// All wheels of a vehicle with the values of one part of them.
pub(super) struct WheelsOfVehicle {
    wheels: Vec<WheelOfVehicle>,
    held: Option<Hold>,
    remarks: Vec<Message>,
    /// Frequency \[Hz\] at which the loop of one oscillates by itself at its mean speed, if one does.
    unstable: Option<f64>,
}

/// Wheels that were built, by vehicle, speeds and values: of several rules of quadrature and of the effects of spreads the same ones.
#[derive(Default)]
pub(super) struct KeptWheels(Mutex<HashMap<String, Arc<WheelsOfVehicle>>>);

/// What is asked of a vehicle.
#[derive(Clone, Copy)]
pub(super) struct VehicleRequest<'a> {
    pub(super) kept: &'a KeptWheels,
    pub(super) traffic: &'a Traffic,
    pub(super) index: usize,
    pub(super) case: &'a Case,
    pub(super) lines: &'a [f64],
    pub(super) variant: &'a Variant,
    /// In place of its speeds and of those of the variant.
    pub(super) speeds: Option<&'a SpeedDistribution>,
}

impl WheelOfVehicle {
    /// Its loops at each of some speeds \[m/s\].
    fn states(&self) -> Vec<(f64, &[(Loop, f64)])> {
        let states = self.states.iter();
        states.map(|(at, places)| (*at, &places[..])).collect()
    }
}

impl VehicleRequest<'_> {
    fn spreads(&self) -> &Spreads {
        &self.traffic.spreads[self.index]
    }

    fn name(&self) -> &str {
        &self.traffic.file.vehicle[self.index].name
    }

    fn key(&self, key: &str) -> String {
        format!("vehicle[{}]{key}", self.index)
    }

    fn refuse(&self, key: &str, message: impl Into<Message>) -> CaseError {
        self.traffic.source.refuse(&self.key(key), message)
    }

    /// Its wheels with some values.
    fn wheels(&self, values: &PartValues) -> Result<WheelsOfVehicle, CaseError> {
        let (traffic, variant) = (self.traffic, self.variant);
        if self.spreads().lateral_position.is_some() && self.case.file.wear.band_width.is_some() {
            let message = say!(width_excludes_that_of_the_case, key = self.key(".lateral_position"));
            return Err(self.refuse(".lateral_position", &message));
        }
        if let Some(through) = traffic.through_curve(self.index, self.case, variant, values)? {
            return self.wheels_through(&through);
        }
        let WheelOnCase { wheel, speeds, held } =
            traffic.wheel_on(self.index, self.case, self.lines, variant, values)?;
        let speeds = self.speeds.cloned().unwrap_or(speeds);
        self.check_frequencies(&wheel, &speeds)?;
        let remarks = remarks_of(&wheel);
        Ok(WheelsOfVehicle {
            unstable: oscillates(&wheel, speeds.mean()),
            wheels: vec![WheelOfVehicle {
                share: 1.0,
                states: vec![(speeds.mean(), wheel.places())],
                across: self.across(&wheel)?,
                axle_mass: wheel.keys.axle_mass(),
                speeds,
                growth: OnceLock::new(),
            }],
            held: held.map(|held: KeptState| held.hold),
            remarks,
        })
    }

    fn check_frequencies(&self, wheel: &Case, speeds: &SpeedDistribution) -> Result<(), CaseError> {
        let (lowest, highest) = speeds.range();
        let (shortest, longest) = (self.lines[0], self.lines[self.lines.len() - 1]);
        wheel.check_frequencies(lowest / longest, highest / shortest)
    }

    /// Every wheel on the rail under study, at every speed at which the vehicle is balanced.
    fn wheels_through(&self, through: &ThroughCurve) -> Result<WheelsOfVehicle, CaseError> {
        let values = &through.values;
        let own = &self.traffic.speeds[self.index];
        let speeds = match self.speeds {
            Some(speeds) => speeds.clone(),
            None => self.variant.speed.apply(own).map_err(|error| {
                self.refuse("", say!(vehicle, vehicle = self.name(), error = Message::from(&error)))
            })?,
        };
        let window = window(self.case, self.lines, &speeds);
        let own = settings_of(&self.traffic.file.vehicle[self.index]).into_iter();
        // What belongs to the vehicle of another file is set there.
        let of_file = matches!(self.traffic.file.vehicle[self.index].curve, Some(CurveOfVehicle::File(_)));
        let of_case = |(key, _): &Setting| !(of_file && is_of_vehicle(key));
        // Loads go into the bogie.
        let own = own.chain(values.settings()).filter(|(own, (key, _))| key != LOAD || own.starts_with("set."));
        let own = own.map(|(_, setting)| setting);
        let own: Vec<Setting> = own.filter(of_case).collect();
        let of_variant = self.variant.settings.iter().filter(|setting| of_case(setting));
        let of_variant: Vec<Setting> = of_variant.cloned().collect();
        let sets = [&own[..], &of_variant, &window];
        let balanced: Vec<f64> = match speeds.listed() {
            Some(listed) => listed.iter().map(|speed| speed.0).collect(),
            None if speeds.deviation() == 0.0 => vec![speeds.mean()],
            None => {
                let at = |z: f64| speeds.mean() + z * speeds.deviation();
                BALANCED_AT.into_iter().map(at).collect()
            }
        };
        let (equilibria, without) = self.equilibria(through, values, &speeds, &balanced)?;
        let written = before_a_wheel(self.case, &sets);
        let (written, from) = written.map_err(|error| self.at_speed(equilibria[0].0, values, &error))?;
        let given = Substitutes { quick: true, ..self.case.keys.given.clone() };
        let middle = equilibria.len() / 2;
        let at_speed = |(index, (speed, equilibrium)): (usize, &(f64, Arc<Equilibrium>))| {
            let speed = *speed;
            let wheels = (1..).take(through.wheelsets()).map(|wheelset| {
                let window = match (index, wheelset) == (middle, 1) {
                    true => Window::Traffic,
                    false => Window::BesideAnother,
                };
                let from = FromCurve { wheelset, ..from.clone() };
                let wheel = Case::placed(&written, equilibrium, &from, given.clone(), window);
                wheel.map_err(|error| self.at_speed(speed, values, &error))
            });
            wheels.collect()
        };
        let cases: Result<Vec<Vec<Case>>, CaseError> = equilibria.par_iter().enumerate().map(at_speed).collect();
        let (cases, balanced) = (cases?, equilibria.iter().map(|it| it.0));
        let first = &cases[middle];
        for wheel in first {
            self.check_frequencies(wheel, &speeds)?;
        }
        let mut remarks = remarks_of(&first[0]);
        remarks.extend(without);
        let share = (through.wheelsets() as f64).recip();
        let mut wheels = Vec::new();
        for wheelset in 0..through.wheelsets() {
            let at = balanced.clone().zip(&cases);
            let at = at.map(|(speed, cases)| (speed, &cases[wheelset]));
            match speeds.listed() {
                Some(listed) => {
                    for ((speed, wheel), listed) in at.zip(listed) {
                        wheels.push(WheelOfVehicle {
                            share: share * listed.1,
                            states: vec![(speed, wheel.places())],
                            // A speed of a distribution is one.
                            speeds: SpeedDistribution::single(speed).unwrap_or(speeds.clone()),
                            across: self.across(wheel)?,
                            axle_mass: wheel.keys.axle_mass(),
                            growth: OnceLock::new(),
                        });
                    }
                }
                None => wheels.push(WheelOfVehicle {
                    share,
                    states: at.map(|(speed, wheel)| (speed, wheel.places())).collect(),
                    speeds: speeds.clone(),
                    across: self.across(&first[wheelset])?,
                    axle_mass: first[wheelset].keys.axle_mass(),
                    growth: OnceLock::new(),
                }),
            }
        }
        let mean = equilibria[middle].0;
        Ok(WheelsOfVehicle {
            wheels,
            held: None,
            remarks,
            unstable: first.iter().find_map(|wheel| oscillates(wheel, mean)),
        })
    }

    /// The vehicle balanced at each speed, and a word on those of a normal distribution at which it finds no equilibrium: for one in
    /// the tails the nearest speed stands in, for one between two others both.
    fn equilibria(
        &self,
        through: &ThroughCurve,
        values: &PartValues,
        speeds: &SpeedDistribution,
        balanced: &[f64],
    ) -> Result<(BalancedAt, Option<Message>), CaseError> {
        let at: Vec<_> = balanced.par_iter().map(|speed| (*speed, through.at(*speed))).collect();
        // A speed between two that have one is bridged; 95 % of the passages are nearer to the mean than the tails.
        let has = |index: Option<usize>| {
            let at: Option<&(f64, Result<Equilibrium, CaseError>)> = index.and_then(|index| at.get(index));
            at.is_some_and(|(_, equilibrium)| equilibrium.is_ok())
        };
        let stood_in_for = |index: usize| {
            let far = (at[index].0 - speeds.mean()).abs() > 1.9 * speeds.deviation();
            far || has(index.checked_sub(1)) && has(Some(index + 1))
        };
        let stands: Vec<bool> = (0..at.len()).map(stood_in_for).collect();
        let (mut found, mut without) = (Vec::new(), Vec::new());
        for ((speed, equilibrium), stands) in at.into_iter().zip(stands) {
            match equilibrium {
                Ok(equilibrium) => found.push((speed, Arc::new(equilibrium))),
                Err(_) if stands && speeds.listed().is_none() => without.push(speed),
                Err(error) => return Err(self.at_speed(speed, values, &error)),
            }
        }
        let words = (!without.is_empty()).then(|| {
            let speeds = without.iter().map(|&speed| shown_speed(speed, 0));
            say!(no_equilibrium_at_speeds, vehicle = self.name(), speeds = Value::List(speeds.collect()))
        });
        Ok((found, words))
    }

    fn at_speed(&self, speed: f64, values: &PartValues, error: &CaseError) -> CaseError {
        let with = values.settings().map(|(_, (key, value))| match value.as_float() {
            Some(number) => format!(", {key} = {number:.4}"),
            None => format!(", {key} = {value}"),
        });
        let message = format!(
            "`{}`: vehicle \"{}\" at {:.1} km/h{}: {error}",
            self.key(".curve"),
            self.name(),
            3.6 * speed,
            with.collect::<String>()
        );
        self.refuse(".curve", &message)
    }

    /// Its wheels with some values, built once.
    fn kept_wheels(&self, values: &PartValues) -> Result<Arc<WheelsOfVehicle>, CaseError> {
        let speeds = self.speeds.map(|speeds| (speeds.mean(), speeds.deviation()));
        let key = format!("{} {speeds:?} {values:?}", self.index);
        let kept = || self.kept.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(wheels) = kept().get(&key) {
            return Ok(wheels.clone());
        }
        let wheels = Arc::new(self.wheels(values)?);
        kept().insert(key, wheels.clone());
        Ok(wheels)
    }

    /// The wheels of all parts, by a rule of quadrature for each spread, each with the share of its part.
    fn parts(&self, rules: &[Option<usize>]) -> Result<Parts, CaseError> {
        let parts = self.spreads().parts(rules);
        let parts = parts.into_par_iter();
        parts.map(|(share, values)| Ok((share, self.kept_wheels(&values)?))).collect()
    }

    /// Growth under some parts, with the place of their contacts across the rail or as if all ran on the line under study.
    fn growth(
        &self,
        parts: &[(f64, Arc<WheelsOfVehicle>)],
        bands: &[ThirdOctave],
        all_on_line: bool,
    ) -> Result<VehicleGrowth, CaseError> {
        let vehicle = &self.traffic.file.vehicle[self.index];
        let (name, share) = (&vehicle.name, vehicle.share.si());
        let refused = |error: riffel::Error| self.refuse("", &error);
        let mut growths = Vec::new();
        for (part, it) in parts {
            for wheel in &it.wheels {
                let mut growth = match wheel.growth.get() {
                    Some(known) => known.clone(),
                    None => {
                        let speeds = wheel.speeds.clone();
                        let states = wheel.states();
                        let growth = VehicleGrowth::between(name, share, &states, bands, speeds);
                        let mut growth = growth.map_err(refused)?;
                        growth.axle_mass = wheel.axle_mass.unwrap_or(growth.axle_mass);
                        wheel.growth.get_or_init(|| growth).clone()
                    }
                };
                if let ([_], [_], [(_, places)]) = (parts, &it.wheels[..], &wheel.states[..])
                    && let Some(window) = ask::growth_window(self.case)
                {
                    growth = growth.with_spectrum(places, window);
                }
                let growth = match wheel.across {
                    Some(AcrossRail { covering, .. }) if !all_on_line => growth.covering(covering),
                    _ => growth,
                };
                growths.push((part * wheel.share, growth));
            }
        }
        let speeds = match self.speeds {
            Some(speeds) => speeds.clone(),
            None => self.speeds_of(parts),
        };
        VehicleGrowth::of_parts(name, share, speeds, growths).map_err(refused)
    }

    /// Of the vehicle as the variant has it.
    fn speeds_of(&self, parts: &[(f64, Arc<WheelsOfVehicle>)]) -> SpeedDistribution {
        let own = &self.traffic.speeds[self.index];
        match parts {
            [(_, part)] if part.wheels.len() == 1 => part.wheels[0].speeds.clone(),
            _ => self.variant.speed.apply(own).unwrap_or(own.clone()),
        }
    }

    /// Growth under the vehicle with all its spreads: of every spread value the coarsest rule of Gauss that the next finer one
    /// confirms, the others at their means; what is left is in the error.
    pub(super) fn vehicle(&self, bands: &[ThirdOctave]) -> Result<VehicleOnCase, CaseError> {
        let spread = self.spreads().spread_values();
        let (rules, error) = self.rules(&spread, bands)?;
        let parts = self.parts(&rules)?;
        let mut growth = self.growth(&parts, bands, false)?;
        growth.growth.rate_error += error;
        let middle = &parts[parts.len() / 2].1;
        let mut remarks = middle.remarks.clone();
        remarks.extend(self.across_in_words(&parts));
        Ok(VehicleOnCase { growth, held: middle.held, unstable: middle.unstable, remarks })
    }

    fn rules(&self, spread: &[usize], bands: &[ThirdOctave]) -> Result<(Rules, f64), CaseError> {
        let mut rules = self.spreads().means();
        let mut errors = 0.0;
        for &place in spread {
            let along = |rule: usize| {
                let mut rules = self.spreads().means();
                rules[place] = Some(rule);
                Ok::<_, CaseError>(self.growth(&self.parts(&rules)?, bands, false)?.growth.rates)
            };
            if self.spreads().of_keys[place].is_listed() {
                rules[place] = Some(0);
                continue;
            }
            let mut coarse = along(0)?;
            for rule in 1..Distribution::RULES {
                let finer = along(rule)?;
                let changes = coarse.iter().zip(&finer).map(|(a, b)| (a - b).abs());
                let change = changes.fold(0.0, f64::max);
                let largest = finer.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
                rules[place] = Some(rule - 1);
                if change <= TOLERANCE * largest || rule + 1 == Distribution::RULES {
                    if change > TOLERANCE * largest {
                        rules[place] = Some(rule);
                    }
                    errors += change;
                    break;
                }
                coarse = finer;
            }
        }
        Ok((rules, errors))
    }

    /// The fastest growth at wavelengths so fine that no line is missed at one speed.
    fn fastest(&self, parts: &[(f64, Arc<WheelsOfVehicle>)]) -> f64 {
        /// Steps of 5e-4 of a wavelength: lines of wheelsets are 5e-3 wide and wider.
        const STEP: f64 = 5e-4;
        let (shortest, longest) = (self.lines[0], self.lines[self.lines.len() - 1]);
        let steps = ((longest / shortest).ln() / STEP).ceil();
        let fine: Vec<f64> =
            (0..=steps as usize).map(|step| shortest * (longest / shortest).powf(step as f64 / steps)).collect();
        let mut rates = vec![0.0; fine.len()];
        let sum: f64 = parts.iter().map(|part| part.0).sum();
        for (part, it) in parts {
            for wheel in &it.wheels {
                let growth = MeanGrowth::between(&wheel.states(), &fine, &wheel.speeds);
                let share = part / sum * wheel.share * wheel.across.map_or(1.0, |across| across.covering);
                rates.iter_mut().zip(growth.rates).for_each(|(sum, rate)| *sum += share * rate);
            }
        }
        rates.into_iter().fold(f64::NEG_INFINITY, f64::max)
    }
}

/// Frequency \[Hz\] at which the loop of a wheel oscillates by itself at a speed \[m/s\], if it does.
fn oscillates(wheel: &Case, speed: f64) -> Option<f64> {
    ask::stability(wheel, speed)?.frequency
}

/// That a preset of the case changes nothing for a vehicle with values of its own is no news.
fn remarks_of(wheel: &Case) -> Vec<Message> {
    let presets = &wheel.keys.text.remarks;
    let remarks = wheel.remarks.iter().cloned();
    remarks.filter(|remark| !presets.contains(remark)).collect()
}
