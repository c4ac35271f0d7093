//! What a variant holds of the mean state of a wheel.

use riffel::contact::MeanRolling;
use riffel_keys::quantity::Quantity;
use riffel_keys::{CaseError, Message, number, say};
use toml::Value;

use crate::file::setting::Setting;
use crate::file::{CaseFile, Creepage};
use crate::parts::window::Window;
use crate::{Case, Hold, Variant};

/// What a variant holds of the mean state of one wheel.
pub(crate) struct KeptState {
    pub(crate) hold: Hold,
    /// The mean state before the change.
    steady: MeanRolling,
    /// Friction times load μP₀ \[N\] after it.
    limit: f64,
    /// What holds it; `None` if it is what the case gives.
    setting: Option<Setting>,
}

impl KeptState {
    /// On the wheel that the settings `own` make of that of the case, in a window; `None` if friction and load
    /// stay, or the variant gives the mean state itself.
    ///
    /// # Errors
    /// Errors of [`Case::with`] for the wheel before the change; force or ratio of a creepage that is not along the rail
    /// alone, for no tractive ratio brings it back.
    pub(crate) fn of(
        variant: &Variant,
        case: &Case,
        own: &[Setting],
        window: &[Setting],
    ) -> Result<Option<Self>, CaseError> {
        if case.is_in_curve() {
            // The curve gives the mean state of every variant.
            return match variant.hold {
                None => Ok(None),
                Some(hold) => Err(variant.refuse(format!(
                    "holds the {hold}, but the mean state is that of the curve of contact.from, which changes with what the \
                     variant changes; leave --hold out, or give contact.creepage with the change"
                ))),
            };
        }
        let keys = [keys_with(case, &[own]), keys_with(case, &[own, &variant.settings])];
        // What is wrong with the keys is said where the case is built of them.
        let [Ok(before), Ok(after)] = keys else {
            return Ok(None);
        };
        let Some(hold) = variant.holds(&before, &after) else {
            return Ok(None);
        };
        let vector = before.contact.creepage.filter(Creepage::is_vector);
        if vector.is_some() && hold != Hold::Creepage {
            let rule = "contact.creepage of the case is a table; choose --hold creepage, or give contact.creepage with \
                          the change";
            return Err(variant.refuse(format!("holds the {hold} of longitudinal creepage alone, but {rule}")));
        }
        let steady = case.rebuilt(case.text_with(&[own, window])?, Window::Traffic)?.steady;
        let limit = after.contact.friction.si() * after.contact.normal_load.si();
        let ratio = |ratio: f64| ("contact.tractive_ratio".to_owned(), Value::Float(ratio));
        let setting = variant.hold.map(|hold| match hold {
            Hold::Force => ratio(steady.forces.longitudinal / limit),
            Hold::Ratio => ratio(steady.tractive_ratio()),
            Hold::Creepage => {
                vector.unwrap_or(Creepage::Longitudinal(Quantity::new(steady.creepages.longitudinal))).setting()
            }
        });
        Ok(Some(Self { hold, steady, limit, setting }))
    }

    /// What holds it, if anything is held.
    pub(crate) fn settings(held: Option<&Self>) -> &[Setting] {
        held.map_or(&[], |held| held.setting.as_slice())
    }

    /// Why it cannot be held, where its setting is refused for a reason.
    pub(crate) fn refusal(&self, reason: &Message) -> String {
        let state = match self.hold {
            Hold::Force => say!(
                the_traction_force_of_kn_on,
                force = number(format_args!("{:.3}", 1e-3 * self.steady.forces.longitudinal)),
                ratio = number(format_args!("{:.2}", self.steady.forces.longitudinal / self.limit)),
                most = number(format_args!("{:.3}", 1e-3 * self.limit))
            ),
            Hold::Ratio if self.steady.slides() => say!(slides_without_creepage),
            Hold::Ratio => say!(
                at_the_tractive_ratio_of,
                ratio = number(format_args!("{:.3}", self.steady.tractive_ratio())),
                reason
            ),
            Hold::Creepage => {
                say!(
                    at_the_creepage_of,
                    creepage = number(format_args!("{:.3}", 1e2 * self.steady.creepages.longitudinal)),
                    reason
                )
            }
        };
        // A wheel that slides keeps its creepage alone.
        let (holds, key) = match self.steady.slides() {
            true => (&[Hold::Creepage][..], "contact.creepage"),
            false => (&[Hold::Force, Hold::Ratio, Hold::Creepage][..], "contact.tractive_ratio"),
        };
        let others: Vec<&str> = holds.iter().filter(|hold| **hold != self.hold).map(|hold| hold.name()).collect();
        let choose = match others.is_empty() {
            true => String::new(),
            false => format!("choose --hold {}, or ", others.join(" or --hold ")),
        };
        format!("what it holds is out of reach: {state}; {choose}give {key} with the change")
    }
}

/// The keys of a case with settings, presets filled in, before anything is built of them.
fn keys_with(case: &Case, sets: &[&[Setting]]) -> Result<CaseFile, CaseError> {
    let mut text = case.text_with(sets)?;
    text.fill_in()?;
    text.deserialize()
}

impl Variant {
    /// The case that the variant makes, with what it holds of the mean state.
    ///
    /// # Errors
    /// [`CaseError`] with the key of the file of changes that is at fault.
    pub fn applied_to(&self, case: &Case) -> Result<Case, CaseError> {
        let held = KeptState::of(self, case, &[], &[])?;
        case.text_with(&[&self.settings, KeptState::settings(held.as_ref())])
            .and_then(|text| case.rebuilt(text, Window::Map))
            .map_err(|error| self.explain(error))
    }
}
