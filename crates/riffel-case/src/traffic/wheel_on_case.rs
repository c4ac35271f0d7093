//! The wheel of a vehicle on a case.

use riffel::forecast::SpeedDistribution;
use riffel_keys::{CaseError, Message, say};
use toml::Value;

use super::Traffic;
use super::spreads::{PartValues, place_of};
use super::vehicle_keys::settings_of;
use crate::case::kept_state::KeptState;
use crate::file::setting::Setting;
use crate::parts::window::Window;
use crate::{Case, CaseKey, Variant};

/// The wheel of a vehicle, and how fast it runs.
pub(super) struct WheelOnCase {
    pub(super) wheel: Case,
    pub(super) speeds: SpeedDistribution,
    pub(super) held: Option<KeptState>,
}

impl Traffic {
    /// What the vehicle of an index gives the keys of a case, in their order.
    pub fn settings(&self, vehicle: usize) -> Vec<Setting> {
        let own = settings_of(&self.file.vehicle[vehicle]).into_iter();
        own.map(|(_, setting)| setting).collect()
    }

    /// The value in SI that all vehicles have for a key: their own, or that of the case.
    ///
    /// # Errors
    /// That they differ, or that the value is spread over the wheels of one: no one value is "half of it" then.
    pub fn common_value(&self, key: &str, of_case: Option<f64>) -> Result<Option<f64>, Message> {
        let mut values = (0..self.file.vehicle.len()).map(|index| self.own_value(index, key));
        let differ = || say!(vehicles_differ, key);
        let first = values.next().unwrap_or(Some(None)).ok_or_else(differ)?;
        let all_alike = values.all(|value| value.is_some_and(|it| it.or(of_case) == first.or(of_case)));
        all_alike.then(|| first.or(of_case)).ok_or_else(differ)
    }

    /// What a vehicle has for a key, if anything; `None` if it is spread, or the vehicle has none of that kind.
    fn own_value(&self, index: usize, key: &str) -> Option<Option<f64>> {
        let number = |value: &Value| match value {
            Value::Float(number) => Some(*number),
            Value::Integer(number) => Some(*number as f64),
            Value::String(text) => CaseKey::at(key)?.quantity?.read(text).ok(),
            _ => None,
        };
        let settings = self.settings(index);
        // A wheelset takes the place of the wheel.
        let has_wheelset = || settings.iter().any(|(own, _)| own.starts_with("wheelset"));
        let none = self.spreads[index].of_case(key).is_some() || key == "wheel.mass" && has_wheelset();
        let own = settings.iter().find(|(own, _)| own == key);
        (!none).then(|| own.and_then(|(_, value)| number(value)))
    }

    /// The wheel of a vehicle: the case with its keys, over the window of its speeds and the bands.
    pub(super) fn wheel_on(
        &self,
        index: usize,
        case: &Case,
        lines: &[f64],
        variant: &Variant,
        values: &PartValues,
    ) -> Result<WheelOnCase, CaseError> {
        let vehicle = &self.file.vehicle[index];
        let at = |key: &str| format!("vehicle[{index}]{key}");
        let mut own = settings_of(vehicle);
        own.extend(values.settings());
        let speeds = variant.speed.apply(&self.speeds[index]).map_err(|error| {
            let message = say!(vehicle, vehicle = &vehicle.name, error = Message::from(&error));
            self.source.refuse(&at(""), &message)
        })?;
        let window = window(case, lines, &speeds);
        let settings: Vec<Setting> = own.iter().map(|(_, setting)| setting.clone()).collect();
        let held = KeptState::of(variant, case, &settings, &window)?;
        let held_setting = KeptState::settings(held.as_ref());
        let sets = [&settings[..], &variant.settings, held_setting, &window];
        let wheel = case.text_with(&sets).and_then(|text| case.rebuilt(text, Window::Traffic));
        let wheel = wheel.map_err(|error| match error {
            CaseError::Changed { key, message } => {
                // The last that set the key is at fault.
                let sets = |(own, _): &Setting| *own == key;
                if held_setting.iter().any(sets) {
                    let held = held.as_ref();
                    let why = held.map_or_else(|| message.to_string(), |held| held.refusal(&message));
                    return variant.refuse(say!(
                        variant_changes_friction_or_load_under,
                        title = &variant.title,
                        vehicle = &vehicle.name,
                        why
                    ));
                }
                if window.iter().any(sets) {
                    let name = &vehicle.name;
                    let message = say!(speeds_and_bands_of_vehicle, name, message);
                    return self.source.refuse(&at(""), &message);
                }
                match own.iter().find(|(_, setting)| sets(setting)) {
                    Some((own, _)) if !variant.settings.iter().any(sets) => {
                        let message = say!(key_and_rule, key = place_of(index, own), rule = message);
                        self.source.refuse(&place_of(index, own), &message)
                    }
                    _ => variant.explain(CaseError::Changed { key, message }),
                }
            }
            error => error,
        })?;
        Ok(WheelOnCase { wheel, speeds, held })
    }
}

/// The window of wavelengths and speeds, so that the case is checked and tabulated over it; and an amplitude
/// at which no remark on the linear range applies, for the forecast has its own, but where growth depends on it.
pub(super) fn window(case: &Case, lines: &[f64], speeds: &SpeedDistribution) -> Vec<Setting> {
    /// A single speed or line is a narrow window.
    const MARGIN: f64 = 1e-6;
    let axis = |key: &str, low: f64, high: f64| {
        let range = [
            ("min", Value::Float(low * (1.0 - MARGIN))),
            ("max", Value::Float(high * (1.0 + MARGIN))),
            ("points", Value::Integer(2)),
        ];
        let range = range.map(|(name, value)| (name.to_owned(), value));
        (key.to_owned(), Value::Table(range.into_iter().collect()))
    };
    let (low, high) = speeds.range();
    let mut window = vec![axis("map.wavelength", lines[0], lines[lines.len() - 1]), axis("map.speed", low, high)];
    if !case.feedback.depends_on_amplitude() {
        window.push(("corrugation.amplitude".to_owned(), Value::Float(1e-6)));
    }
    window
}
