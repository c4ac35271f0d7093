//! What grinding costs, where the user says what a shift costs.

use riffel_keys::quantity::{Length, Quantity};
use riffel_keys::{CaseError, KeyFile, Message, fixed, money, say};
use serde::Deserialize;

/// The table `[cost]` of a site.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GrindingCost {
    /// Currency, as EUR.
    pub currency: String,
    /// Cost of a grinding shift, possession included.
    pub grinding_shift: f64,
    /// Length of line that is ground in a shift.
    pub length_a_shift: Quantity<Length>,
}

impl GrindingCost {
    /// Refuse what is not above zero.
    pub(super) fn check(&self, file: &KeyFile) -> Result<(), CaseError> {
        let length = self.length_a_shift;
        let values = [
            ("grinding_shift", self.grinding_shift, self.grinding_shift.to_string(), "give the cost of one shift"),
            (
                "length_a_shift",
                length.si(),
                length.to_string(),
                "give the length of line that is ground in a shift, as \"800 m\"",
            ),
        ];
        if let Some(written) = file.value_as_written("cost.grinding_shift")
            && let Err(rule) = money::read(written)
        {
            return Err(file.invalid("cost.grinding_shift", rule, ""));
        }
        for (key, value, written, help) in values {
            if !(value > 0.0 && value.is_finite()) {
                let rule = say!(is_but_must_be, value = written, rule = say!(greater_than_zero));
                return Err(file.invalid(&format!("cost.{key}"), rule, help));
            }
        }
        Ok(())
    }

    /// What it costs to grind a length of line \[m\] now, in whole shifts, and a year where that is to be done again after so many months.
    pub(super) fn words(&self, length: f64, months: Option<f64>) -> Message {
        let shifts = (length / self.length_a_shift.si()).ceil();
        let cost = shifts * self.grinding_shift;
        let (length, currency, shown) = (fixed(length, 0), &self.currency, fixed(cost, 0));
        let shifts = say!(grinding_shifts, count = shifts as u64);
        match months.filter(|months| *months > 0.0) {
            Some(months) => say!(
                grinding_costs_a_year,
                length,
                shifts,
                cost = shown,
                currency,
                yearly = fixed(cost * 12.0 / months, 0),
                months = fixed(months, 0)
            ),
            None => say!(grinding_costs, length, shifts, cost = shown, currency),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1240 m at 800 m a shift are two shifts; twice 15 000 every 18 months are 20 000 a year.
    #[test]
    fn shifts_are_whole() {
        let cost =
            GrindingCost { currency: "EUR".to_owned(), grinding_shift: 15e3, length_a_shift: Quantity::new(800.0) };
        assert_eq!(
            cost.words(1240.0, Some(18.0)).to_string(),
            "to grind 1240 m of line takes 2 grinding shifts and 30000 EUR, 20000 EUR a year if repeated every 18 months"
        );
        assert_eq!(cost.words(90.0, None).to_string(), "to grind 90 m of line takes 1 grinding shift and 15000 EUR");
    }
}
