//! Which action pays, over the posterior of a calibration.

mod question;

use riffel_calibrate::{ActionOutcome, Breaks, CalibrationError, Chains, Decision, Plan, Worth};
use riffel_keys::{Message, fixed, say};
use riffel_plot::{LineFigure, LinePanel, Mark, Series};
use serde::Serialize;

pub use question::DecideQuestion;

use crate::{Answer, Column, Rows, Table};

/// The ranking of actions, with what it says of measurements.
#[derive(Serialize)]
pub struct DecideAnswer {
    riffel_version: &'static str,
    title: Option<String>,
    #[serde(flatten)]
    decision: Decision,
    sentences: Vec<Message>,
    remarks: Vec<Message>,
}

impl DecideAnswer {
    /// Rank the actions of a plan over its chains.
    ///
    /// # Errors
    /// Errors of [`Decision::of`].
    pub fn new(plan: &Plan, chains: &Chains) -> Result<Self, CalibrationError> {
        let doubts = chains.summary(plan).doubts().len();
        let cost = plan.file.cost.as_ref();
        let mut remarks = Vec::new();
        if doubts > 0 {
            remarks.push(say!(decision_on_doubtful_chains, doubts));
        }
        if cost.is_some_and(|cost| cost.from_limit.is_none()) {
            remarks.push(say!(rise_after_grinding_assumed));
        }
        let at_intervals = plan.file.action.iter().any(|it| it.grind_every.is_some());
        if at_intervals && cost.is_some_and(|cost| cost.over_limit.is_none()) {
            remarks.push(say!(over_limit_costs_nothing));
        }
        let decision = Decision::of(plan, chains)?;
        Ok(Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            title: plan.file.title.clone(),
            sentences: sentences(&decision),
            decision,
            remarks,
        })
    }

    /// A table of what it is worth to know things.
    fn worth(&self, name: &'static str, what: Message, worth: &[Worth]) -> Table {
        let currency = &*self.decision.currency;
        let mut columns = vec![
            worth.words("title", what, |it| Message::verbatim(&it.title)),
            worth.fixed("worth_per_year", say!(worth_per_year, currency), 0, |it| it.per_year),
        ];
        if worth.iter().any(|it| it.price.is_some()) {
            columns.push(worth.fixed("price", say!(price_in, currency), 0, |it| it.price));
            columns.push(worth.fixed("net", say!(net_worth_in, currency), 0, |it| it.net));
        }
        Table { name, columns }
    }
}

/// Names of the actions.
fn names(decision: &Decision) -> Vec<Message> {
    let actions = decision.actions.iter().enumerate();
    let name = |(index, action): (usize, &ActionOutcome)| match index {
        0 => say!(action_none),
        _ => Message::verbatim(&action.title),
    };
    actions.map(name).collect()
}

/// What the ranking says.
fn sentences(decision: &Decision) -> Vec<Message> {
    let actions = decision.actions.iter().zip(names(decision));
    let best = actions.min_by_key(|(action, _)| action.rank);
    let currency = &*decision.currency;
    let mut sentences = Vec::new();
    if let Some((action, name)) = best {
        sentences.push(say!(
            cheapest_in_the_mean,
            action = name,
            cost = fixed(action.mean_cost_per_year, 0),
            currency,
            share = fixed(100.0 * action.probability_cheapest, 0)
        ));
    }
    let breaking = decision.actions.iter().filter(|it| !it.breaks.holds()).count();
    if breaking == decision.actions.len() {
        sentences.push(say!(all_actions_break));
    } else if breaking > 0 {
        sentences.push(say!(actions_break, count = breaking));
    }
    sentences.push(say!(worth_of_knowing_all, worth = fixed(decision.evpi_per_year, 0), currency));
    let pays = decision.measurements.iter().filter(|it| it.net.is_some_and(|net| net > 0.0));
    match (pays.collect::<Vec<&Worth>>().first(), decision.measurements.is_empty()) {
        (Some(first), _) => sentences.push(say!(measure_first, measurement = &first.title)),
        (None, false) => sentences.push(say!(no_measurement_pays)),
        (None, true) => {}
    }
    sentences
}

impl Answer for DecideAnswer {
    fn name(&self) -> &'static str {
        "decision"
    }

    fn document_name(&self) -> &'static str {
        "decision.json"
    }

    fn introduction(&self) -> Vec<Message> {
        let title = self.title.as_deref().map(Message::verbatim);
        let decision = &self.decision;
        let about = say!(
            decision_is_over,
            draws = decision.draws,
            rise = fixed(decision.rise_db, 1),
            horizon = fixed(decision.horizon_months, 0)
        );
        title.into_iter().chain([about]).collect()
    }

    fn tables(&self) -> Vec<Table> {
        let decision = &self.decision;
        let currency = &*decision.currency;
        let actions = &decision.actions;
        let mut columns = vec![Column::words("action", say!(action_column), names(&self.decision))];
        for (place, name, head) in [
            (2, "months_q50", say!(months_to_limit_median)),
            (0, "months_q05", say!(five_per_cent)),
            (4, "months_q95", say!(ninety_five_per_cent)),
        ] {
            columns.push(actions.fixed(name, head, 1, |it| it.months_to_limit.quantiles[place]));
        }
        columns.push(
            actions.fixed("never_percent", say!(never_percent), 1, |it| 100.0 * it.months_to_limit.probability_never),
        );
        let head = say!(mean_cost_per_year, currency);
        columns.push(actions.fixed("mean_cost_per_year", head, 0, |it| it.mean_cost_per_year));
        for (place, name, head) in [
            (0, "saving_q05", Some(say!(saving_from))),
            (1, "saving_q25", None),
            (2, "saving_q50", None),
            (3, "saving_q75", None),
            (4, "saving_q95", Some(say!(saving_to))),
        ] {
            let value = |it: &ActionOutcome| it.saving_per_year[place];
            columns.push(match head {
                Some(head) => actions.fixed(name, head, 0, value),
                None => actions.plain(name, value),
            });
        }
        columns.push(actions.fixed("longer_percent", say!(longer_percent), 0, |it| 100.0 * it.probability_longer));
        columns
            .push(actions.fixed("cheapest_percent", say!(cheapest_percent), 0, |it| 100.0 * it.probability_cheapest));
        for (name, head, of) in [
            ("over_budget_percent", say!(over_budget_percent), (|it| it.budget) as fn(&Breaks) -> Option<f64>),
            ("too_loud_percent", say!(too_loud_percent), |it| it.noise_limit),
            ("without_possession_percent", say!(without_possession_percent), |it| it.possession_hours),
        ] {
            if actions.iter().any(|action| of(&action.breaks).is_some()) {
                columns.push(actions.fixed(name, head, 0, |it| Some(100.0 * of(&it.breaks)?)));
            }
        }
        columns.push(actions.fixed("rank", say!(rank_of_action), 0, |it| it.rank as f64));
        let head = say!(regret_per_year, currency);
        columns.push(actions.fixed("expected_regret_per_year", head, 0, |it| it.expected_regret_per_year));
        let mut tables = vec![
            Table { name: "actions", columns },
            self.worth("worth_of_values", say!(value_known), &decision.evppi_per_year),
        ];
        if !decision.measurements.is_empty() {
            tables.push(self.worth("worth_of_measurements", say!(measurement_first), &decision.measurements));
        }
        tables
    }

    fn sentences(&self) -> Vec<Message> {
        self.sentences.clone()
    }

    fn figure(&self) -> LineFigure {
        let decision = &self.decision;
        let line = |name: &Message, values: &[f64]| {
            Series::new(
                name.text(riffel_keys::Language::English),
                values.to_vec(),
                (1..20).map(|part| 5.0 * f64::from(part)).collect(),
            )
        };
        let names = names(&self.decision);
        let actions = || decision.actions.iter().zip(&names);
        let panel = |subtitle: &str, x_label: String, series: Vec<Series>, marks: Vec<Mark>| LinePanel {
            y_range: Some((0.0, 100.0)),
            marks,
            ..LinePanel::new(x_label, "share of the draws below [%]", series).titled(subtitle)
        };
        let months = actions().map(|(action, name)| line(name, &action.curves[0]));
        let costs = actions().map(|(action, name)| line(name, &action.curves[1]));
        let best = actions().min_by_key(|(action, _)| action.rank);
        let mark = best.map(|(action, name)| Mark {
            x: action.mean_cost_per_year,
            label: name.text(riffel_keys::Language::English),
        });
        LineFigure::new(
            self.title.clone().unwrap_or_else(|| "Decision".to_owned()),
            format!(
                "{} draws of the posterior, 5 to 95 %. Months from grinding until the first band has \
                 risen by {} dB; costs of a year. The line marks the least mean cost. Knowing \
                  everything is worth {:.0} {} a year.",
                decision.draws, decision.rise_db, decision.evpi_per_year, decision.currency
            ),
            [
                panel("interval", "months to the limit".to_owned(), months.collect(), Vec::new()),
                panel(
                    "cost",
                    format!("cost of a year [{}]", decision.currency),
                    costs.collect(),
                    mark.into_iter().collect(),
                ),
            ],
        )
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
