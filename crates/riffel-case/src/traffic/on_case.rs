//! Traffic on a case: the wheel of each vehicle, and growth under all of them.

use std::borrow::Cow;
use std::collections::BTreeSet;

use riffel::forecast::{TrafficGrowth, VehicleGrowth, band_lines};
use riffel::roughness::ThirdOctave;
use riffel_keys::{CaseError, Message, fixed, say};

use super::wheels_of_vehicle::{KeptWheels, VehicleRequest};
use super::{DAYS_PER_MONTH, DAYS_PER_YEAR, Traffic, Vehicle, bands_of, reported_growth, vehicle_in_words};
use crate::case::measured_wear::{measured_coefficient_in_words, wearing};
use crate::{Case, Hold, Variant};

/// Traffic on a case: growth rates, and what the reader should know.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficOnCase {
    /// Growth by vehicle and line.
    pub growth: TrafficGrowth,
    /// Frequency \[Hz\] at which the loop of a vehicle oscillates by itself at its mean speed, if one does: growth rates mean nothing then.
    pub unstable: Option<f64>,
    /// Wear coefficient that growth goes by \[kg/J\].
    pub wear_coefficient: f64,
    /// Axle passages a day, if the file says how much traffic there is.
    pub passages_per_day: Option<f64>,
    /// What the variant holds of the mean state, by vehicle: each kind once; empty if friction and load stay.
    pub held: Vec<Hold>,
    /// What the reader should know about the validity of the models.
    pub remarks: Vec<Message>,
}

/// One kind of vehicle on a case.
pub(super) struct VehicleOnCase {
    pub(super) growth: VehicleGrowth,
    pub(super) held: Option<Hold>,
    /// Frequency \[Hz\] at which one of its wheels oscillates by itself, if one does.
    pub(super) unstable: Option<f64>,
    pub(super) remarks: Vec<Message>,
}

impl TrafficOnCase {
    /// Axle passages in a month of the mean calendar, if the file says how much traffic there is.
    pub fn passages_per_month(&self) -> Option<f64> {
        self.passages_in(DAYS_PER_MONTH)
    }

    /// Axle passages in so many days, if the file says how much traffic there is.
    pub fn passages_in(&self, days: f64) -> Option<f64> {
        Some(self.passages_per_day? * days)
    }
}

impl Traffic {
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
        self.on_keeping(&KeptWheels::default(), case, bands, variant, progress)
    }

    pub(super) fn on_keeping(
        &self,
        kept: &KeptWheels,
        case: &Case,
        bands: &[ThirdOctave],
        variant: &Variant,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<TrafficOnCase, CaseError> {
        let given = case.file.wear.coefficient;
        let case = &*self.wearing_as_measured(case)?;
        let mut vehicles = Vec::new();
        let mut unstable = None;
        let mut remarks = Vec::new();
        let mut held = Vec::new();
        for index in 0..self.file.vehicle.len() {
            let vehicle = self.vehicle_on(index, kept, case, bands, variant)?;
            vehicles.push(vehicle.growth);
            unstable = unstable.or(vehicle.unstable);
            remarks.push(vehicle.remarks);
            held.extend(vehicle.held.filter(|hold| !held.contains(hold)));
            progress(1);
        }
        let own = self.remarks.iter().chain(&variant.remarks);
        let mut remarks = self.merged(remarks);
        remarks.splice(0..0, own.cloned());
        let growth = self.of_vehicles(bands, vehicles)?;
        let line = self.file.line;
        let of_mgt = |mgt: f64| growth.passages(mgt) / DAYS_PER_YEAR;
        let passages_per_day = line.passages_per_day.or(line.mgt_per_year.map(of_mgt));
        let reported = passages_per_day.and_then(|per_day| reported_growth::remark(case, &growth, per_day));
        if growth.depends_on_amplitude() {
            let amplitude = 1e6 * case.feedback.amplitude();
            remarks.push(say!(rates_follow_amplitude, amplitude = fixed(amplitude, 1)));
        }
        if case.has_other_damage() {
            remarks.push(say!(fit_scales_all_damage));
        }
        // It says most of all.
        remarks.splice(0..0, reported);
        if case.file.wear.coefficient != given {
            let told = measured_coefficient_in_words(case);
            remarks.extend(told.map(|told| say!(measured_wear_of_traffic, coefficient = told)));
        }
        Ok(TrafficOnCase {
            growth,
            unstable,
            wear_coefficient: case.file.wear.coefficient.si(),
            passages_per_day,
            held,
            remarks,
        })
    }

    /// The case whose wear coefficient gives the wear that was measured under this traffic, as it is, if one was.
    ///
    /// # Errors
    /// Errors of [`on`](Self::on), and where nothing slides.
    pub fn wearing_as_measured<'a>(&self, case: &'a Case) -> Result<Cow<'a, Case>, CaseError> {
        let bands = bands_of(case);
        let [band, ..] = &bands[..] else {
            return Ok(Cow::Borrowed(case));
        };
        if case.file.wear.measured.is_none() {
            return Ok(Cow::Borrowed(case));
        }
        // Wear does not ask for wavelengths.
        let (kept, band) = (&KeptWheels::default(), std::slice::from_ref(band));
        let as_it_is = &Variant::none("");
        let vehicles = 0..self.file.vehicle.len();
        let vehicles = vehicles.map(|index| Ok(self.vehicle_on(index, kept, case, band, as_it_is)?.growth));
        let growth = self.of_vehicles(band, vehicles.collect::<Result<_, CaseError>>()?)?;
        let depth = growth.mean_wear().depth_per_100_mgt();
        Ok(Cow::Owned(wearing(case.clone(), depth)?))
    }

    fn of_vehicles(&self, bands: &[ThirdOctave], vehicles: Vec<VehicleGrowth>) -> Result<TrafficGrowth, CaseError> {
        let growth = TrafficGrowth::new(bands.to_vec(), vehicles);
        growth.map_err(|error| self.source.refuse("vehicle", &error))
    }

    /// The remarks on the vehicles, the one with most passages first. Of several that say the same with other values the
    /// first is kept.
    fn merged(&self, remarks: Vec<Vec<Message>>) -> Vec<Message> {
        let mut of_vehicles: Vec<(&Vehicle, Vec<Message>)> = self.file.vehicle.iter().zip(remarks).collect();
        of_vehicles.sort_by(|a, b| b.0.share.si().total_cmp(&a.0.share.si()));
        let alone = of_vehicles.len() == 1;
        let mut said = BTreeSet::new();
        let mut merged = Vec::new();
        for (vehicle, remarks) in of_vehicles {
            let new = remarks.into_iter().filter(|remark| said.insert(remark.id()));
            merged.extend(new.map(|remark| match alone {
                true => remark,
                false => remark.about(vehicle_in_words(&vehicle.name)),
            }));
        }
        merged
    }

    fn vehicle_on(
        &self,
        index: usize,
        kept: &KeptWheels,
        case: &Case,
        bands: &[ThirdOctave],
        variant: &Variant,
    ) -> Result<VehicleOnCase, CaseError> {
        let vehicle = &self.file.vehicle[index];
        let asked =
            VehicleRequest { kept, traffic: self, index, case, lines: &band_lines(bands), variant, speeds: None };
        self.check_keys_on(index, case)?;
        let on_case = asked.vehicle(bands)?;
        let traction_share = vehicle.traction_share.map_or(1.0, |share| share.si());
        let at = format!("vehicle[{index}]");
        self.check_traction_share(index, case)?;
        let growth = on_case.growth.with_traction_on(traction_share);
        Ok(VehicleOnCase { growth: growth.map_err(|error| self.source.refuse(&at, &error))?, ..on_case })
    }

    /// `Ok` unless a share of the axles of a vehicle is said to roll without damage, where laws beside wear damage under all.
    pub(super) fn check_traction_share(&self, index: usize, case: &Case) -> Result<(), CaseError> {
        let share = self.file.vehicle[index].traction_share;
        if share.is_none_or(|share| share.si() >= 1.0) || !case.has_other_damage() {
            return Ok(());
        }
        let key = format!("vehicle[{index}].traction_share");
        let message = say!(axles_that_roll_free, key = &key);
        Err(self.source.refuse(&key, &message))
    }
}
