//! What to do: actions ranked by what they cost over the posterior, and what it is worth to know more.

mod worth;

use rayon::prelude::*;
use riffel_case::Variant;
use riffel_study::sensitivity::quantile;
use serde::Serialize;

use crate::chains::Chains;
use crate::error::CalibrationError;
use crate::information::{mean, of_everything};
use crate::plan::Plan;
use crate::plan::decision::{Action, Choices, MONTHS};
use crate::rail_draw::{RailDraw, growing_bands};
use crate::summary::SHARES;

pub(crate) use worth::moments_of;
use worth::{LinearDraws, worth_of_measurements, worth_of_values};

/// The ranking of actions; costs are sums of a year.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Decision {
    /// Currency of all sums.
    pub currency: String,
    /// Rise of a band from grinding to the limit.
    pub rise_db: f64,
    /// Longest interval.
    pub horizon_months: f64,
    /// Draws of the posterior, the same for all actions.
    pub draws: usize,
    /// To leave all as it is first, then in the order of the plan.
    pub actions: Vec<ActionOutcome>,
    /// What it is worth a year to know everything.
    pub evpi_per_year: f64,
    /// What it is worth a year to know one value, the most first.
    pub evppi_per_year: Vec<Worth>,
    /// What measurements are worth, the most first by what is left of it over the horizon, at the rate of interest.
    pub measurements: Vec<Worth>,
}

/// What an action leads to.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ActionOutcome {
    /// Its name.
    pub title: String,
    /// Of investment and upkeep.
    pub fixed_cost_per_year: f64,
    /// Months and costs of 5, 10 … 95 % of the draws, for curves.
    #[serde(skip)]
    pub curves: [Vec<f64>; 2],
    /// From grinding to the limit.
    pub months_to_limit: Months,
    /// In the mean over the draws.
    pub mean_cost_per_year: f64,
    /// 5, 25, 50, 75 and 95 % of the draws.
    pub cost_per_year: [f64; 5],
    /// Quantiles of what it saves against leaving all as it is.
    pub saving_per_year: [f64; 5],
    /// That the interval is longer than if all is left as it is.
    pub probability_longer: f64,
    /// That it is the cheapest.
    pub probability_cheapest: f64,
    /// What it costs more than the cheapest, in the mean.
    pub expected_regret_per_year: f64,
    /// Its place by mean cost, from one, behind all that hold to what is asked.
    pub rank: usize,
    /// How likely it breaks what is asked.
    pub breaks: Breaks,
}

/// Probabilities that an action breaks what is asked; `None` if that is not asked.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Breaks {
    /// That it costs more than the budget.
    pub budget: Option<f64>,
    /// That a band is louder than the limit of noise when grinding comes.
    pub noise_limit: Option<f64>,
    /// That it closes the line for more hours than there are.
    pub possession_hours: Option<f64>,
}

impl Breaks {
    /// Whether the action holds to all of it, in 95 % of the draws or more.
    pub fn holds(&self) -> bool {
        const MOST: f64 = 0.05;
        let all = [self.budget, self.noise_limit, self.possession_hours];
        all.iter().flatten().all(|probability| *probability <= MOST)
    }
}

/// Months until a limit is reached.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Months {
    /// 5, 25, 50, 75 and 95 % of the draws; `None` if that share does not reach it within the horizon.
    pub quantiles: [Option<f64>; 5],
    /// That it is not reached within the horizon.
    pub probability_never: f64,
}

/// What it is worth to know something.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Worth {
    /// What is known or measured.
    pub title: String,
    /// A year.
    pub per_year: f64,
    /// What the measurement costs; none for a value that is merely known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub price: Option<f64>,
    /// What is left of its worth over the horizon.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub net: Option<f64>,
}

impl Months {
    pub(crate) fn of(months: impl Iterator<Item = Option<f64>>) -> Self {
        let mut all: Vec<f64> = months.map(|it| it.unwrap_or(f64::INFINITY)).collect();
        all.sort_by(f64::total_cmp);
        let never = all.iter().filter(|it| it.is_infinite()).count();
        // Between a number and never is never.
        let at = |share: f64| Some(quantile(&all, share)).filter(|it| it.is_finite());
        Self { quantiles: SHARES.map(at), probability_never: never as f64 / all.len() as f64 }
    }
}

/// Months from grinding to the limit, none beyond the horizon, and the highest level of a band above the limit when grinding comes
/// \[dB\].
type GrindingOutcome = (Option<f64>, f64);

impl Decision {
    /// Rank the actions of a plan over the draws of its chains.
    ///
    /// The interval of an action in a draw is the time in which the first band rises from what grinding leaves to the limit, and
    /// its cost a year that of grinding as often as the interval asks, or as the action says. What the model misses of growth
    /// is in every interval, the same for all actions.
    ///
    /// # Errors
    /// [`CalibrationError::Plan`] with the key at fault; [`CalibrationError::Refused`] where the case refuses what an action makes
    /// of a draw.
    pub fn of(plan: &Plan, chains: &Chains) -> Result<Self, CalibrationError> {
        let choices = plan.choices()?;
        let (_, levels) = plan.levels()?;
        let per_month = plan.passages_per_month()?;
        let draws = plan.rail_draws(chains)?;
        let end = choices.horizon * per_month;
        let mut courses = Vec::new();
        for action in &choices.actions {
            let changes = action.changes.clone();
            let changes = changes.unwrap_or_else(|| Variant::none(""));
            let model = plan.posterior.model.changed(levels.view(), &changes)?;
            let of_draw = |draw: &RailDraw| {
                let rates = match action.changes.is_none() && action.factors.is_empty() {
                    true => draw.rates.clone(),
                    false => {
                        let values = multiplied(plan, action, &draw.values)?;
                        levels.rates(&model.trial(&values))?
                    }
                };
                let missed = match choices.growth_discrepancy {
                    true => draw.missed.clone(),
                    false => vec![0.0; draw.missed.len()],
                };
                let rise = 10f64.powf(0.1 * choices.rise);
                let reached = growing_bands(&rates, &missed)
                    .filter_map(|band| band.passages_to(rise))
                    .filter(|passages| *passages <= end);
                let reached = reached.min_by(f64::total_cmp).map(|passages| passages / per_month);
                // Grinding at the limit leaves no band above it.
                let highest = action.every.map_or(0.0, |every| {
                    let rises = growing_bands(&rates, &missed);
                    let rises = rises.map(|band| band.level_change(every * per_month));
                    rises.fold(f64::NEG_INFINITY, f64::max) - choices.rise
                });
                Ok((reached, highest))
            };
            let of_draws: Result<Vec<GrindingOutcome>, String> = draws.par_iter().map(of_draw).collect();
            courses.push(of_draws.map_err(|reason| {
                let title = &action.title;
                CalibrationError::Refused(format!(
                    "in a draw of the posterior the case does not take the action \"{title}\": {reason}"
                ))
            })?);
        }
        let costs = courses.iter().zip(&choices.actions);
        let costs: Vec<Vec<f64>> = costs
            .map(|(courses, action)| {
                let costs = courses.iter().map(|(months, _)| choices.cost(action, *months));
                costs.collect()
            })
            .collect();
        let actions = outcomes(&choices, &courses, &costs);
        // What breaks what is asked is no choice, unless all do.
        let holds = |(action, _): &(&ActionOutcome, &Vec<f64>)| action.breaks.holds();
        let allowed = actions.iter().zip(&costs).filter(holds);
        let allowed: Vec<Vec<f64>> = allowed.map(|(_, costs)| costs.clone()).collect();
        let costs = if allowed.is_empty() { costs } else { allowed };
        let places: Vec<Vec<f64>> = draws.into_iter().map(|draw| draw.place).collect();
        let linear = LinearDraws::of(&places, &costs);
        let values = worth_of_values(plan, &places, &costs);
        Ok(Self {
            rise_db: choices.rise,
            horizon_months: choices.horizon,
            draws: places.len(),
            actions,
            evpi_per_year: of_everything(&costs),
            measurements: worth_of_measurements(plan, &choices, &linear, &values)?,
            evppi_per_year: values,
            currency: choices.currency,
        })
    }
}

/// The values of a draw after an action; why not, where one leaves what can be computed.
fn multiplied(plan: &Plan, action: &Action, values: &[f64]) -> Result<Vec<f64>, String> {
    let mut values = values.to_vec();
    for (place, factor) in &action.factors {
        values[*place] *= factor;
        let parameter = &plan.posterior.parameters()[*place];
        let [low, high] = parameter.ends;
        if !(low..=high).contains(&values[*place]) {
            let value = values[*place];
            let value = match value.abs() < 1e4 {
                true => format!("{value:.3}"),
                false => format!("{value:.3e}"),
            };
            let unit = &parameter.unit;
            let rule = format!("must be between {low} and {high} {unit}");
            return Err(format!("`{}` becomes {value}, but {}", parameter.name, rule.trim_end()));
        }
    }
    Ok(values)
}

impl Choices {
    /// How likely an action breaks what is asked.
    fn breaks(&self, action: &Action, courses: &[GrindingOutcome], costs: &[f64]) -> Breaks {
        let share = |limit: Option<f64>, of: &dyn Fn(usize) -> f64| {
            let over = |limit: f64| (0..costs.len()).filter(|draw| of(*draw) > limit).count();
            limit.map(|limit| over(limit) as f64 / costs.len() as f64)
        };
        let hours = |draw: usize| {
            let interval = action.every.or(courses[draw].0).unwrap_or(self.horizon);
            action.hours + MONTHS / interval * self.grinding_hours
        };
        let asked = &self.constraints;
        Breaks {
            budget: share(asked.budget, &|draw| costs[draw]),
            noise_limit: share(asked.noise_limit, &|draw| courses[draw].1),
            possession_hours: share(asked.possession_hours, &hours),
        }
    }

    /// What an action costs a year where the limit is reached after so many months, if it is within the horizon.
    fn cost(&self, action: &Action, months: Option<f64>) -> f64 {
        let a_year = match action.every {
            None => MONTHS / months.unwrap_or(self.horizon) * self.grinding,
            Some(every) => {
                let over = months.map_or(0.0, |months| (every - months).max(0.0));
                MONTHS / every * (self.grinding + self.over_limit * over)
            }
        };
        action.annual + a_year
    }
}

fn outcomes(choices: &Choices, courses: &[Vec<GrindingOutcome>], costs: &[Vec<f64>]) -> Vec<ActionOutcome> {
    let draws = costs[0].len();
    let share = |is: &dyn Fn(usize) -> bool| (0..draws).filter(|draw| is(*draw)).count() as f64 / draws as f64;
    let quantiles = |values: &mut dyn Iterator<Item = f64>| {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        SHARES.map(|share| quantile(&values, share))
    };
    let curve = |values: &mut dyn Iterator<Item = f64>| {
        let mut values: Vec<f64> = values.collect();
        values.sort_by(f64::total_cmp);
        (1..20).map(|part| quantile(&values, 0.05 * f64::from(part))).collect()
    };
    let breaks: Vec<Breaks> = (choices.actions.iter().zip(courses).zip(costs))
        .map(|((action, courses), costs)| choices.breaks(action, courses, costs))
        .collect();
    let all_break = !breaks.iter().any(Breaks::holds);
    let is_allowed = |place: usize| all_break || breaks[place].holds();
    let rank = |place: usize| {
        let key = |place: usize| (!is_allowed(place), mean(&costs[place]));
        let better = |other: &usize| {
            let (own, other) = (key(place), key(*other));
            other.0.cmp(&own.0).then(other.1.total_cmp(&own.1)).is_lt()
        };
        1 + (0..costs.len()).filter(better).count()
    };
    let cheapest: Vec<f64> = (0..draws)
        .map(|draw| {
            let allowed = (0..costs.len()).filter(|place| is_allowed(*place));
            allowed.map(|place| costs[place][draw]).fold(f64::INFINITY, f64::min)
        })
        .collect();
    let first = |draw: usize| {
        let mut places = 0..costs.len();
        places.find(|place| is_allowed(*place) && costs[*place][draw] == cheapest[draw])
    };
    let length = |months: Option<f64>| months.unwrap_or(f64::INFINITY);
    let outcome = |(place, action): (usize, &Action)| ActionOutcome {
        title: action.title.clone(),
        fixed_cost_per_year: action.annual,
        curves: [curve(&mut courses[place].iter().map(|it| length(it.0))), curve(&mut costs[place].iter().copied())],
        months_to_limit: Months::of(courses[place].iter().map(|it| it.0)),
        mean_cost_per_year: mean(&costs[place]),
        cost_per_year: quantiles(&mut costs[place].iter().copied()),
        saving_per_year: quantiles(&mut (0..draws).map(|draw| costs[0][draw] - costs[place][draw])),
        probability_longer: share(&|draw| length(courses[place][draw].0) > length(courses[0][draw].0)),
        probability_cheapest: share(&|draw| first(draw) == Some(place)),
        expected_regret_per_year: mean(&costs[place]) - mean(&cheapest),
        rank: rank(place),
        breaks: breaks[place].clone(),
    };
    choices.actions.iter().enumerate().map(outcome).collect()
}
