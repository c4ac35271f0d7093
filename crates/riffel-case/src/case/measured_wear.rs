//! The wear coefficient that gives the wear of a rail as it was measured.

use riffel::MeanWear;
use riffel::forecast::WearSpread;
use riffel_keys::quantity::Quantity;
use riffel_keys::{CaseError, Message, say, significant};

use crate::Case;
use crate::file::{MeasuredWear, WearLaw};
use crate::keys::checked_keys::CheckedKeys;

impl CheckedKeys {
    /// `Ok` unless wear is measured and given otherwise, too.
    pub(crate) fn check_measured_wear(&self) -> Result<(), CaseError> {
        if self.file.wear.measured.is_none() {
            return Ok(());
        }
        let keys = &self.text.keys;
        for other in ["wear.coefficient", "wear.natural_lubrication"] {
            if keys.has(other) {
                return Err(keys.invalid(
                    "wear.measured",
                    say!(and_exclude_each_other, other),
                    say!(give_one_of_the_two),
                ));
            }
        }
        if self.file.wear.law != WearLaw::Energy {
            let rule = say!(is_of_wear_by_energy);
            return Err(keys.invalid("wear.measured", rule, ""));
        }
        Ok(())
    }
}

impl Case {
    /// Mean wear of the rail under its wheel, whose axle has the mass that its bogie says, if it has one.
    pub fn mean_wear(&self) -> MeanWear {
        self.feedback.mean_wear().under_axle(self.keys.axle_mass())
    }
}

/// The case whose wear coefficient gives the wear that was measured, if one was: all wheels are like its own then.
pub(crate) fn with_measured_wear(case: Case) -> Result<Case, CaseError> {
    if case.file.wear.measured.is_none() || case.keys.given.wear.is_some() {
        return Ok(case);
    }
    if case.has_other_damage() {
        let rule = say!(is_of_wear_by_energy);
        return Err(case.keys.text.keys.invalid("wear.measured", rule, ""));
    }
    let depth = case.mean_wear().depth_per_100_mgt();
    let mut case = wearing(case, depth)?;
    let told = measured_coefficient_in_words(&case);
    case.remarks.extend(told.map(|told| say!(measured_wear_of_the_case, coefficient = told)));
    Ok(case)
}

/// The case whose wear coefficient gives the wear that was measured, where the present one gives a depth \[m\] under 100 million
/// gross tonnes.
///
/// # Errors
/// [`CaseError::Invalid`] where that depth is none: nothing slides.
pub(crate) fn wearing(mut case: Case, depth: f64) -> Result<Case, CaseError> {
    let Some(measured) = case.file.wear.measured else {
        return Ok(case);
    };
    if depth <= 0.0 {
        let rule = say!(is_measured_but_nothing_slides, depth = per_100_mgt(&measured));
        return Err(case.keys.text.keys.invalid("wear.measured", rule, ""));
    }
    let factor = measured.depth_per_100_mgt() / depth;
    let coefficient = factor * case.file.wear.coefficient.si();
    let feedback = case.feedback.with_wear_times(factor);
    case.feedback = case.keys.physics("wear.measured", feedback)?;
    case.keys.given.wear = Some((measured, coefficient));
    for file in [&mut case.file, &mut case.keys.file] {
        file.wear.coefficient = Quantity::new(coefficient);
    }
    Ok(case)
}

/// How well the wear coefficient is known: as the wear was measured, or as that of rails in service.
pub fn wear_spread(case: &Case) -> WearSpread {
    let measured = case.file.wear.measured.as_ref();
    measured.map_or(WearSpread::UNMEASURED, |measured| WearSpread::of_factor(measured.factor.si()))
}

/// The coefficient that the measured wear makes, if it was measured: "1.2 mm per 100 MGT make 2.1e-10 kg/J (80 %: …)".
pub(crate) fn measured_coefficient_in_words(case: &Case) -> Option<Message> {
    let measured = case.file.wear.measured.as_ref()?;
    let coefficient = case.file.wear.coefficient.si();
    let [low, high] = wear_spread(case).band_80(coefficient);
    let scientific = |value: f64| riffel_keys::number(format_args!("{value:.2e}"));
    Some(say!(
        measured_wear_makes,
        depth = per_100_mgt(measured),
        coefficient = scientific(coefficient),
        low = scientific(low),
        high = scientific(high)
    ))
}

/// Millimetres under 100 million gross tonnes.
fn per_100_mgt(measured: &MeasuredWear) -> riffel_keys::Value {
    significant(1e3 * measured.depth_per_100_mgt(), 3)
}
