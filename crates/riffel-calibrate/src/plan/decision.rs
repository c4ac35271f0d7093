//! What a plan says of actions, measurements and costs.

use riffel::error::as_typed;
use riffel_case::Variant;
use riffel_case::traffic::DAYS_PER_MONTH;
use riffel_keys::message::number;
use riffel_keys::{CaseError, Message, money, say};
use toml::Value;

use super::{Plan, name_of};
use crate::file::{ActionFile, CostFile, MeasurementFile};

/// Months of a year.
pub(crate) const MONTHS: f64 = 12.0;
/// Rise of a band from what grinding leaves to the limit, where nothing else is said \[dB\].
pub const USUAL_RISE: f64 = 6.0;
/// Longest interval between two grindings, where nothing else is said \[months\].
pub const USUAL_HORIZON: f64 = 20.0 * MONTHS;

/// Something that could be done.
pub(crate) struct Action {
    pub(crate) title: String,
    /// Of investment and upkeep, each year.
    pub(crate) annual: f64,
    /// Months from one grinding to the next; `None` if the limit asks for it.
    pub(crate) every: Option<f64>,
    pub(crate) changes: Option<Variant>,
    /// Hours for which it closes the line each year, without those of grinding.
    pub(crate) hours: f64,
    /// Factors of parameters, by their places.
    pub(crate) factors: Vec<(usize, f64)>,
}

/// Something that could be measured.
pub(crate) struct Planned {
    pub(crate) title: String,
    pub(crate) price: f64,
    pub(crate) of: PlannedData,
}

pub(crate) enum PlannedData {
    /// A block of data once more, by its place.
    Block(usize),
    /// A parameter, by its place, with the standard deviation of its ln.
    Parameter(usize, f64),
}

/// Limits that an action must keep; none if nothing is asked.
pub(crate) struct Constraints {
    /// Most that it costs a year.
    pub(crate) budget: Option<f64>,
    /// Highest level of a band above the limit when grinding comes \[dB\].
    pub(crate) noise_limit: Option<f64>,
    /// Most hours for which it closes the line a year.
    pub(crate) possession_hours: Option<f64>,
}

/// What a decision goes by.
pub(crate) struct Choices {
    /// To leave all as it is comes first.
    pub(crate) actions: Vec<Action>,
    pub(crate) measurements: Vec<Planned>,
    pub(crate) currency: String,
    /// Of one grinding, with its possession.
    pub(crate) grinding: f64,
    /// Of a month over the limit.
    pub(crate) over_limit: f64,
    /// Rise of a band from grinding to the limit \[dB\].
    pub(crate) rise: f64,
    /// \[months\]
    pub(crate) horizon: f64,
    /// What one a year over the horizon is worth now.
    pub(crate) present: f64,
    /// Hours for which grinding once closes the line.
    pub(crate) grinding_hours: f64,
    pub(crate) constraints: Constraints,
    /// Whether what the model misses of growth is in the intervals.
    pub(crate) growth_discrepancy: bool,
}

/// A number of zero or more in front of one of some units, times what goes with it.
fn amount(value: &Value, units: &[(&str, f64)]) -> Option<f64> {
    let Value::String(text) = value else {
        return None;
    };
    let (number, unit) = text.trim().split_once(char::is_whitespace)?;
    let (_, factor) = units.iter().find(|(own, _)| *own == unit.trim())?;
    let number: f64 = number.parse().ok()?;
    number.is_finite().then_some(number * factor)
}

/// How long something lasts, in months.
const DURATIONS: [(&str, f64); 5] =
    [("a", MONTHS), ("years", MONTHS), ("months", 1.0), ("month", 1.0), ("days", 1.0 / DAYS_PER_MONTH)];

/// Sums of money, all in one currency.
struct Purse<'a> {
    plan: &'a Plan,
    currency: String,
}

impl Purse<'_> {
    fn sum(&self, key: &str, value: Option<&Value>) -> Result<f64, CaseError> {
        let Some(value) = value else { return Ok(0.0) };
        let (sum, currency) = self.plan.money(key, value)?;
        if sum >= 0.0 && currency == self.currency {
            return Ok(sum);
        }
        let rule = say!(sum_of_zero_or_more, currency = &self.currency);
        let rule = say!(is_but_must_be, value = value.to_string(), rule);
        Err(self.plan.source.invalid(key, rule, ""))
    }
}

impl Plan {
    fn hours(&self, key: &str, value: Option<&Value>) -> Result<Option<f64>, CaseError> {
        let Some(value) = value else { return Ok(None) };
        let hours = amount(value, &[("h", 1.0)]).filter(|hours| *hours >= 0.0);
        hours.map(Some).ok_or_else(|| {
            let rule = say!(is_but_must_be, value = value.to_string(), rule = say!(hours_of_zero_or_more));
            self.source.invalid(key, rule, "")
        })
    }

    fn constraints(&self, cost: &CostFile, purse: &Purse<'_>) -> Result<Constraints, CaseError> {
        let possession_hours = self.hours("cost.possession_hours", cost.possession_hours.as_ref())?;
        if possession_hours.is_some() && cost.grinding_hours.is_none() {
            let help = say!(say_for_how_long_grinding_closes);
            return Err(self.source.missing("cost.grinding_hours", help));
        }
        let noise_limit = match &cost.noise_limit {
            None => None,
            Some(value) => Some(amount(value, &[("dB", 1.0)]).filter(|level| *level >= 0.0).ok_or_else(|| {
                let rule = say!(level_above_limit);
                let rule = say!(is_but_must_be, value = value.to_string(), rule);
                self.source.invalid("cost.noise_limit", rule, "")
            })?),
        };
        let budget = match &cost.budget {
            None => None,
            budget => Some(purse.sum("cost.budget", budget.as_ref())?),
        };
        Ok(Constraints { budget, noise_limit, possession_hours })
    }

    fn duration(&self, key: &str, value: &Value) -> Result<f64, CaseError> {
        let months = amount(value, &DURATIONS).filter(|months| *months > 0.0);
        months.ok_or_else(|| {
            let rule = say!(is_but_must_be, value = value.to_string(), rule = say!(time_above_zero));
            self.source.invalid(key, rule, "")
        })
    }

    /// What could be done and measured, and what it costs.
    ///
    /// # Errors
    /// [`CaseError`] with the key of the plan or of a file of changes, the value and the rule.
    pub(crate) fn choices(&self) -> Result<Choices, CaseError> {
        let Some(cost) = &self.file.cost else {
            let help = say!(give_cost_of_grinding);
            return Err(self.source.missing("cost", help));
        };
        if self.file.action.is_empty() {
            let help = say!(write_one_action_or_more);
            return Err(self.source.missing("action", help));
        }
        let purse = self.purse(cost)?;
        let grinding = purse.sum("cost.grinding", Some(&cost.grinding))?;
        if grinding == 0.0 {
            let value = cost.grinding.to_string();
            let rule = say!(is_but_must_be, value, rule = say!(greater_than_zero));
            return Err(self.source.invalid("cost.grinding", rule, ""));
        }
        let rate = cost.discount_rate.map_or(0.03, |rate| rate.si());
        if !(0.0..1.0).contains(&rate) {
            let value = say!(rate_in_per_cent, rate = number(as_typed(100.0 * rate)));
            let rule = say!(is_but_must_be, value, rule = say!(rate_of_interest));
            return Err(self.source.invalid("cost.discount_rate", rule, ""));
        }
        let below = match &cost.from_limit {
            None => -USUAL_RISE,
            Some(value) => amount(value, &[("dB", 1.0)]).filter(|it| *it < 0.0).ok_or_else(|| {
                let rule = say!(level_below_zero);
                let rule = say!(is_but_must_be, value = value.to_string(), rule);
                self.source.invalid("cost.from_limit", rule, "")
            })?,
        };
        let horizon = match &cost.horizon {
            None => USUAL_HORIZON,
            Some(value) => self.duration("cost.horizon", value)?,
        };
        let mut actions = vec![Action {
            title: "as it is".to_owned(),
            annual: 0.0,
            every: None,
            changes: None,
            hours: 0.0,
            factors: Vec::new(),
        }];
        for (index, written) in self.file.action.iter().enumerate() {
            let action = self.action(index, written, &purse, rate)?;
            if let (Some(every), Some(value)) = (action.every, &written.grind_every)
                && every > horizon
            {
                let rule = say!(at_most_the_horizon, months = number(as_typed(horizon)));
                let rule = say!(is_but_must_be, value = value.to_string(), rule);
                let key = format!("action[{index}].grind_every");
                return Err(self.source.invalid(&key, rule, ""));
            }
            if actions.iter().any(|other| other.title == action.title) {
                let rule = say!(is_a_second_time, text = action.title);
                let key = format!("action[{index}].title");
                return Err(self.source.invalid(&key, rule, say!(give_each_its_title)));
            }
            actions.push(action);
        }
        let measurements = self.file.measurement.iter().enumerate();
        let measurements = measurements.map(|(index, written)| self.measurement(index, written, &purse));
        Ok(Choices {
            actions,
            measurements: measurements.collect::<Result<_, CaseError>>()?,
            grinding: grinding + purse.sum("cost.possession", cost.possession.as_ref())?,
            over_limit: purse.sum("cost.over_limit", cost.over_limit.as_ref())?,
            rise: -below,
            grinding_hours: self.hours("cost.grinding_hours", cost.grinding_hours.as_ref())?.unwrap_or(0.0),
            constraints: self.constraints(cost, &purse)?,
            growth_discrepancy: cost.growth_discrepancy,
            present: annuity(1.0, rate, horizon / MONTHS).recip(),
            horizon,
            currency: purse.currency,
        })
    }

    /// A sum of money and its currency.
    fn money<'a>(&self, key: &str, value: &'a Value) -> Result<(f64, &'a str), CaseError> {
        let text = value.as_str().unwrap_or_default();
        let wrong = |rule| self.source.invalid(key, rule, "");
        match money::read(text) {
            Ok((sum, currency)) if !currency.is_empty() => Ok((sum, currency)),
            Err(rule) if text.starts_with(|c: char| c.is_ascii_digit()) => Err(wrong(rule)),
            _ => {
                let rule = say!(sum_with_currency);
                Err(wrong(say!(is_but_must_be, value = value.to_string(), rule)))
            }
        }
    }

    /// The currency is that of grinding.
    fn purse(&self, cost: &CostFile) -> Result<Purse<'_>, CaseError> {
        let (_, currency) = self.money("cost.grinding", &cost.grinding)?;
        Ok(Purse { plan: self, currency: currency.to_owned() })
    }

    fn action(&self, index: usize, written: &ActionFile, purse: &Purse<'_>, rate: f64) -> Result<Action, CaseError> {
        let key = |key: &str| format!("action[{index}].{key}");
        if written.changes.is_none() && written.multiplies.is_empty() && written.grind_every.is_none() {
            let help = say!(give_what_an_action_does);
            return Err(self.source.missing(&key("changes"), help));
        }
        let folder = self.inputs[0].parent().unwrap_or_else(|| std::path::Path::new(""));
        let changes = match &written.changes {
            Some(name) => Some(Variant::read(&folder.join(name))?),
            None => None,
        };
        let parameters = self.posterior.parameters();
        let mut factors = Vec::new();
        for (name, factor) in &written.multiplies {
            let place = parameters.iter().position(|parameter| parameter.name == *name);
            let at = key(&format!("multiplies.\"{name}\""));
            let place = place.ok_or_else(|| {
                let names: Vec<&str> = parameters.iter().map(|it| &*it.name).collect();
                let rule = say!(is_no_parameter, names = names.join(", "));
                let message = say!(key_as_subject, key = &at, rule);
                self.source.refuse(&key("multiplies"), message)
            })?;
            if !(factor.is_finite() && *factor > 0.0) {
                let rule = say!(is_but_must_be, value = *factor, rule = say!(finite_and_above_zero));
                let message = say!(key_as_subject, key = at, rule);
                return Err(self.source.refuse(&key("multiplies"), message));
            }
            factors.push((place, *factor));
        }
        let upkeep = purse.sum(&key("upkeep"), written.upkeep.as_ref())?;
        let investment = purse.sum(&key("investment"), written.investment.as_ref())?;
        let a_year = match (&written.life, investment > 0.0) {
            (None, false) => 0.0,
            (None, true) => {
                let help = say!(say_how_long_the_investment_lasts);
                return Err(self.source.missing(&key("life"), help));
            }
            (Some(life), _) => annuity(investment, rate, self.duration(&key("life"), life)? / MONTHS),
        };
        let every = match &written.grind_every {
            Some(value) => Some(self.duration(&key("grind_every"), value)?),
            None => None,
        };
        let title = match (&written.title, &changes) {
            (Some(title), _) => title.clone(),
            (None, Some(changes)) => changes.title.clone(),
            (None, None) => return Err(self.source.missing(&key("title"), say!(name_the_action))),
        };
        Ok(Action {
            title,
            annual: a_year + upkeep,
            every,
            changes,
            hours: self.hours(&key("possession_hours"), written.possession_hours.as_ref())?.unwrap_or(0.0),
            factors,
        })
    }

    fn measurement(&self, index: usize, written: &MeasurementFile, purse: &Purse<'_>) -> Result<Planned, CaseError> {
        let key = |key: &str| format!("measurement[{index}].{key}");
        let price = purse.sum(&key("price"), Some(&written.price))?;
        let wrong = |at: &str, rule: Message, help: Message| self.source.invalid(&key(at), rule, help);
        let (of, name) = match (written.kind, &written.key) {
            (Some(_), Some(_)) => {
                let rule = say!(and_exclude_each_other, other = "kind");
                return Err(wrong("key", rule, say!(give_one_of_the_two)));
            }
            (None, None) => {
                let help = say!(give_what_is_measured);
                return Err(self.source.missing(&key("kind"), help));
            }
            (Some(kind), None) => {
                let is_own = |data: &&crate::file::DataFile| {
                    data.kind == kind && written.name.as_ref().is_none_or(|name| name == name_of(data))
                };
                let data = self.file.data.iter().find(is_own);
                let block = data.and_then(|data| {
                    let mut blocks = self.posterior.blocks.iter();
                    blocks.position(|block| block.names[0] == name_of(data))
                });
                let block = block.ok_or_else(|| {
                    let rule = say!(is_no_data_to_repeat, kind = kind.name());
                    wrong("kind", rule, say!(weigh_one_value))
                })?;
                (PlannedData::Block(block), kind.name().to_owned())
            }
            (None, Some(name)) => {
                let parameters = self.posterior.parameters();
                let place = parameters.iter().position(|parameter| parameter.name == *name);
                let place =
                    place.ok_or_else(|| wrong("key", say!(is_name_of_no_parameter, name), Message::verbatim("")))?;
                let factor =
                    written.factor.ok_or_else(|| self.source.missing(&key("factor"), say!(say_how_good_it_is)))?;
                if !(factor.is_finite() && factor > 1.0) {
                    let rule = say!(is_but_must_be, value = factor, rule = say!(more_than_one));
                    return Err(wrong("factor", rule, say!(factor_of_ten_per_cent)));
                }
                (PlannedData::Parameter(place, factor.ln()), name.clone())
            }
        };
        let title = written.title.clone().unwrap_or(name);
        Ok(Planned { title, price, of })
    }
}

/// What an investment costs each year of its life \[a\] at a rate of interest.
fn annuity(investment: f64, rate: f64, life: f64) -> f64 {
    match rate > 0.0 {
        true => investment * rate / (1.0 - (1.0 + rate).powf(-life)),
        false => investment / life,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 1000 over ten years at 3 %: 117.2305 a year; without interest a tenth.
    #[test]
    fn an_investment_is_paid_in_equal_years() {
        assert!((annuity(1000.0, 0.03, 10.0) - 117.230_506_6).abs() < 1e-6);
        assert_eq!(annuity(1000.0, 0.0, 10.0), 100.0);
    }
}
