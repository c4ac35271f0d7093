//! A case in a curve of another file, and the keys that give it the mean state it has there without that file.

use std::path::Path;
use std::sync::Arc;

use riffel_keys::CaseError;
use toml::{Table, Value};

use crate::file::setting::{Setting, settings};
use crate::file::{ContactDynamics, CreepLawName, CurveRail, FromCurve};
use crate::keys::substitutes::Substitutes;
use crate::keys::written_keys::WrittenKeys;
use crate::parts::window::Window;
use crate::{Case, CaseKey};

/// Keys that `contact.from` fills in, if they are not written.
const OF_CURVE: [&str; 12] = [
    "contact.creepage",
    "contact.contact_angle",
    "contact.normal_load",
    "contact.stiffness",
    "contact.transverse_radius",
    "contact.longitudinal_radius",
    "contact.lateral_offset",
    "contact.friction",
    "contact.conformity.rail_radius",
    "opposite_contact",
    "wheelset.rail",
    "wheel.rolling_radius",
];
/// What else says where the mean state is.
const IN_ITS_PLACE: [&str; 6] = ["contact.tractive_ratio", "contact.from", "curve", "bogie", "body", "profiles"];
const LAW: &str = "contact.creep_law";

/// The case with the mean state that a wheel of a bogie has in a curve, the low one of the leading wheelset if the loop has one
/// there: `file` is a case of `riffel curve` in `folder`. What the case says of that state itself gives way, and a creep law
/// that ends in sliding to `fastsim`.
///
/// # Errors
/// [`CaseError`] for a curve without equilibrium, and where the loop has a mean state on no wheel.
pub fn on_curve(case: &Case, folder: &Path, file: &str) -> Result<Case, CaseError> {
    let mut text = case.unfilled.clone();
    for key in OF_CURVE.iter().chain(&IN_ITS_PLACE) {
        text.keys.remove(key);
    }
    let law = case.file.contact.creep_law.unwrap_or(CreepLawName::CARTER_3D);
    let is_steady = case.file.contact.response != ContactDynamics::NonSteady;
    if is_steady && law.entry().is_some_and(|law| law.ends_in_sliding) {
        text.write(&[(LAW.to_owned(), "fastsim".into())])?;
    }
    let from =
        FromCurve { curve: Some(file.to_owned()), wheelset: 1, rail: CurveRail::Low, contact: None, patch: None };
    let named = Value::try_from(&from).map_err(|error| case.refuse("", error.to_string()))?;
    text.write(&[("contact.from".to_owned(), named)])?;
    let written = WrittenKeys::read(text, Some(folder))?;
    let given = Substitutes::default();
    let equilibrium = Arc::new(written.equilibrium(&from, &given)?);
    let on_wheel = |(wheelset, rail)| {
        let from = FromCurve { wheelset, rail, ..from.clone() };
        Case::placed(&written, &equilibrium, &from, given.clone(), Window::Map)
    };
    // Where one wheel has no loop another may have one.
    let first = on_wheel((1, CurveRail::Low));
    let others = [(2, CurveRail::Low), (1, CurveRail::High), (2, CurveRail::High)].into_iter();
    first.or_else(|error| others.map(on_wheel).find_map(Result::ok).ok_or(error))
}

/// Keys of the mean state of a curve: what [`keys_of_curve`] does not give is to be left out beside it.
pub fn keys_that_give_way() -> impl Iterator<Item = &'static str> {
    OF_CURVE.into_iter().chain(IN_ITS_PLACE)
}

/// The keys that give a case the mean state that this one has of a curve, with their values in SI.
///
/// # Errors
/// [`CaseError`] for keys that cannot be written.
pub fn keys_of_curve(case: &Case) -> Result<Vec<Setting>, CaseError> {
    let table = Table::try_from(&case.file).map_err(|error| case.refuse("", error.to_string()))?;
    let is_of_curve = |key: &str| {
        let mut known = OF_CURVE.iter().chain([&LAW]);
        known.any(|&table| {
            let rest = key.strip_prefix(table);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        })
    };
    let in_si = |key: &str, value: Value| {
        let quantity = CaseKey::find(key).and_then(|known| known.quantity.as_ref());
        let number = quantity.zip(value.as_str()).and_then(|(quantity, text)| quantity.read(text).ok());
        number.map_or(value, Value::Float)
    };
    let keys = settings(&table).into_iter();
    let keys = keys.filter(|(key, _)| is_of_curve(key));
    let keys = keys.map(|(key, value)| {
        let value = in_si(&key, value);
        (key, value)
    });
    // Numbers in other units lose their last digit, and a band may not be narrower than the contact by as much.
    let band = wider_than_its_band(case).map(|width| {
        let width = Value::Float(width * (1.0 + 1e-12));
        ("wear.band_width".to_owned(), width)
    });
    Ok(keys.chain(band).collect())
}

/// Width \[m\] of a contact of a curve that is wider than the band of wear: wear comes off it in place of the band.
pub(crate) fn wider_than_its_band(case: &Case) -> Option<f64> {
    let [_, width] = case.keys.band_under_wider_contact(case.hertz)?;
    case.is_in_curve().then_some(width)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wheels_of_curve;
    use crate::{CurvingCase, METRO_CURVE_CASE, NOMINAL_CASE};

    /// Every wheel of a curve has the same growth by the keys that are told of it: a lone wheel on either rail, and a wheelset.
    #[test]
    fn the_keys_of_a_wheel_give_its_growth_without_the_curve() {
        let folder = tempfile::tempdir().unwrap();
        for (text, radius) in [(NOMINAL_CASE, "180 m"), (NOMINAL_CASE, "-300 m"), (METRO_CURVE_CASE, "180 m")] {
            let curve = CurvingCase::parse("curve", METRO_CURVE_CASE, &[format!("curve.radius={radius}")]).unwrap();
            std::fs::write(folder.path().join("curve.toml"), curve.toml()).unwrap();
            let case = Case::parse("case", text, &[]).unwrap();
            let found = on_curve(&case, folder.path(), "curve.toml").unwrap();
            let wheels = wheels_of_curve(&found).unwrap().unwrap().wheels;
            let in_loop: Vec<Case> = wheels.into_iter().filter_map(|wheel| wheel.case.ok()).collect();
            assert!(in_loop.len() >= 4);
            for on_wheel in in_loop {
                let mut own = case.unfilled.clone();
                keys_that_give_way().for_each(|key| own.keys.remove(key));
                own.write(&keys_of_curve(&on_wheel).unwrap()).unwrap();
                let own = case.rebuilt(own, Window::Map).unwrap();
                assert!(own.file.contact.from.is_none());
                let growth = |case: &Case| case.point(0.06, 12.5).unwrap().growth_rate;
                let [own, expected] = [&own, &on_wheel].map(growth);
                // Numbers are written in as many decimals as tell them apart; units may cost their last digit.
                assert!((own / expected - 1.0).abs() < 1e-9, "{own:e} {expected:e}");
            }
        }
    }
}
