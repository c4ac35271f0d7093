//! Traffic whose wheels are followed through time.

use rayon::prelude::*;
use riffel::forecast::SpeedDistribution;
use riffel::passage::PassingWheel;
use riffel::roughness::ThirdOctave;
use riffel_keys::{CaseError, Message, say, shown_speed};

use super::spreads::{PartValues, place_of};
use super::vehicle_keys::settings_of;
use super::{Traffic, bands_of};
use crate::ask::passage::wheels_in_time;
use crate::file::ContactDynamics;
use crate::{Case, Variant};

/// The wheel of a vehicle at the speeds of its distribution.
pub struct VehicleInTime {
    /// Name of the vehicle.
    pub name: String,
    /// Its share of the passages \[-\], of all vehicles one.
    pub share: f64,
    /// Mean and standard deviation of its speed \[m/s\].
    pub speed: [f64; 2],
    /// The case with its wheel.
    pub case: Case,
    /// Its wheels at each speed, with their shares of all passages.
    pub wheels: Vec<PassingWheel>,
}

impl Traffic {
    /// The wheels of every vehicle on a case, at each of the [`nodes`](riffel::forecast::SpeedDistribution::nodes) of its speed.
    ///
    /// Cost: that of [`ask::in_time`](crate::ask::in_time) for each, on all threads.
    ///
    /// # Errors
    /// [`CaseError`] with the key of the vehicle, and those of [`ask::passing_wheel`](crate::ask::passing_wheel).
    pub fn in_time(&self, case: &Case) -> Result<Vec<VehicleInTime>, CaseError> {
        let case = &*self.wearing_as_measured(case)?;
        let bands = bands_of(case);
        // To the edges of the bands, as far as the linear loop is asked beside.
        let edges = bands.iter().copied().map(ThirdOctave::wavelength_range);
        let lines: Vec<f64> = edges.flat_map(|(low, high)| [low, high]).collect();
        let all: f64 = self.file.vehicle.iter().map(|vehicle| vehicle.share.si()).sum();
        let vehicles = self.file.vehicle.iter().enumerate();
        vehicles
            .map(|(index, vehicle)| {
                let speeds = &self.speeds[index];
                self.check_followed(index)?;
                self.check_keys_on(index, case)?;
                self.check_traction_share(index, case)?;
                let wheel =
                    match settings_of(vehicle).is_empty() && case.file.contact.response != ContactDynamics::NonSteady {
                        true => case.clone(),
                        false => self.wheel_on(index, case, &lines, &Variant::none(""), &PartValues::default())?.wheel,
                    };
                let share = vehicle.share.si() / all;
                let traction_share = vehicle.traction_share.map_or(1.0, |share| share.si());
                let prepared = wheels_in_time(&wheel)?.at_any_speed()?;
                let at = |&(speed, part): &(f64, f64)| {
                    Ok(PassingWheel { share: share * part, traction_share, ..prepared.passing_wheel(speed)? })
                };
                // Which of several wheels it is about.
                let named = |node: &(f64, f64)| {
                    at(node).map_err(|error: CaseError| match self.source.table().contains_key("vehicle") {
                        false => error,
                        true => self.source.refuse(
                            &format!("vehicle[{index}]"),
                            say!(
                                vehicle_at_km_h,
                                vehicle = &vehicle.name,
                                speed = shown_speed(node.0, 1),
                                error = error.message()
                            ),
                        ),
                    })
                };
                let nodes = speeds.nodes();
                let wheels: Result<Vec<PassingWheel>, CaseError> = nodes.par_iter().map(named).collect();
                Ok(VehicleInTime {
                    name: vehicle.name.clone(),
                    share,
                    speed: [speeds.mean(), speeds.deviation()],
                    wheels: wheels?,
                    case: wheel,
                })
            })
            .collect()
    }

    /// `Ok` if a vehicle is one wheel that can be followed through time.
    fn check_followed(&self, index: usize) -> Result<(), CaseError> {
        let vehicle = &self.file.vehicle[index];
        let spreads = &self.spreads[index];
        let key = if vehicle.curve.is_some() {
            "curve"
        } else if let Some(first) = spreads.of_keys.first() {
            &first.own
        } else if spreads.lateral_position.is_some() {
            "lateral_position"
        } else {
            return Ok(());
        };
        let key = place_of(index, key);
        let rule = "is given, but a simulation in time follows one wheel of each vehicle, at each of its speeds";
        let help = "leave it out; `riffel forecast` takes it";
        Err(self.source.invalid(&key, rule, help))
    }

    /// Speeds of each vehicle.
    pub fn speeds(&self) -> &[SpeedDistribution] {
        &self.speeds
    }

    /// What is to be asked about values of the file that are not usual.
    pub fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
