//! A plan of grinding, told.

use riffel_keys::{Message, Value, number, say};
use riffel_network::GrindingPlan;
use serde::Serialize;

use super::words::{hundredths, kilometres};
use crate::{Answer, Rows, Table};

/// Sites that the table shows.
const SITES: usize = 40;

/// A plan of grinding.
#[derive(Serialize)]
#[serde(transparent)]
pub struct PlanAnswer {
    plan: GrindingPlan,
    /// Whether costs are money.
    #[serde(skip)]
    money: bool,
    #[serde(skip)]
    remarks: Vec<Message>,
}

impl PlanAnswer {
    /// Of a plan for a length, or for money.
    pub fn new(plan: GrindingPlan, money: bool) -> Self {
        let remarks = plan.remarks.iter().map(Message::verbatim).collect();
        Self { plan, money, remarks }
    }
}

impl Answer for PlanAnswer {
    fn name(&self) -> &'static str {
        "plan"
    }

    fn tables(&self) -> Vec<Table> {
        let sites = &self.plan.sites[..self.plan.sites.len().min(SITES)];
        if sites.is_empty() {
            return Vec::new();
        }
        let mut columns = vec![
            sites.shown(say!(line_column), |site| Message::verbatim(&site.line)),
            sites.shown(say!(from_kilometre_column), |site| kilometres(site.from_m)),
            sites.shown(say!(to_kilometre_column), |site| kilometres(site.to_m)),
            sites.shown(say!(over_limit_column), |site| hundredths(site.rms_over_limit)),
        ];
        if self.money {
            columns.push(sites.numbers(say!(cost_column), |site| format!("{:.0}", site.cost)));
        }
        vec![Table { name: "sites", columns }]
    }

    fn sentences(&self) -> Vec<Message> {
        let plan = &self.plan;
        let more = plan.sites.len().saturating_sub(SITES);
        let more = (more > 0).then(|| say!(and_more_sites, count = number(more)));
        let cost = match self.money {
            true => say!(for_money, cost = number(format!("{:.0}", plan.cost))).into(),
            false => Value::from(""),
        };
        let least = match plan.least_left_over_limit_m < plan.left_over_limit_m {
            true => say!(no_plan_leaves_less, length = kilometres(plan.least_left_over_limit_m)).into(),
            false => Value::from(""),
        };
        let planned = say!(
            grinding_is_planned,
            months = number(plan.months),
            over = kilometres(plan.over_limit_m),
            ground = kilometres(plan.length_m),
            cost,
            left = kilometres(plan.left_over_limit_m),
            least
        );
        more.into_iter().chain([planned]).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
