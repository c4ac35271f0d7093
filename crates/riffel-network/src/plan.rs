//! What to grind of a network with a budget.

use serde::Serialize;

use crate::{Judgement, NetworkError, SectionGrowth, Store, growth, rails_without_growth, worst};

/// What may be spent, in any currency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// Money.
    pub money: f64,
    /// Cost of a metre of track.
    pub per_metre: f64,
    /// Cost of a place where the machine is set up, besides.
    pub per_site: f64,
}

impl Budget {
    /// A budget of so many metres of track.
    pub fn of_length(metres: f64) -> Self {
        Self {
            money: metres,
            per_metre: 1.0,
            per_site: 0.0,
        }
    }

    fn check(&self) -> Result<(), NetworkError> {
        for (what, value, least) in [
            ("the budget", self.money, 0.0),
            ("the cost of a metre", self.per_metre, f64::MIN_POSITIVE),
            ("the cost of a site", self.per_site, 0.0),
        ] {
            if !(value >= least && value.is_finite()) {
                return Err(NetworkError::Value {
                    what,
                    value: value.to_string(),
                    rule: "finite and not below zero; that of a metre above it".to_owned(),
                });
            }
        }
        Ok(())
    }
}

/// A section of track that is ground.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlannedSection {
    /// The line.
    pub line: String,
    /// First place \[m\].
    pub from_m: f64,
    /// Last place \[m\].
    pub to_m: f64,
    /// RMS over limit of the worse rail at the time planned for.
    pub rms_over_limit: f64,
    /// What it costs besides those chosen before it.
    pub cost: f64,
}

/// A plan of grinding.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GrindingPlan {
    /// Months ahead.
    pub months: f64,
    /// What is ground, as sites along the lines: sections that join on are one.
    pub sites: Vec<PlannedSection>,
    /// Length of track that is ground \[m\].
    pub length_m: f64,
    /// What it costs.
    pub cost: f64,
    /// Length of track over its limit at the time planned for, if nothing is done \[m\].
    pub over_limit_m: f64,
    /// Length of that which the budget leaves \[m\].
    pub left_over_limit_m: f64,
    /// What the reader should know.
    pub remarks: Vec<String>,
}

/// The sections of track that will be over their limit so many months behind the latest survey, the worst first, as far as the
/// budget goes.
///
/// Method: greedy. Sections are taken in the order of RMS over limit of their worse rail; one that joins on to those taken
/// before costs no new site; what does not fit any more is passed over, and smaller ones may still fit. That is no optimum, but
/// nobody is passed over for one who is better off at the same cost. Lines with one survey are taken as they are.
///
/// # Errors
/// [`NetworkError::Value`] for a budget below zero; those of the files.
pub fn plan(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    months: f64,
    budget: &Budget,
) -> Result<GrindingPlan, NetworkError> {
    budget.check()?;
    if !(0.0..=1200.0).contains(&months) {
        return Err(NetworkError::Value {
            what: "the number of months",
            value: months.to_string(),
            rule: "between 0 and 1200".to_owned(),
        });
    }
    let mut remarks = Vec::new();
    // A line by line and section by section: the worse rail.
    let mut sections: std::collections::BTreeMap<(String, i64), f64> =
        std::collections::BTreeMap::new();
    let mut worse = |line: &str, from: f64, ratio: f64| {
        let key = (line.to_owned(), (from / length).round() as i64);
        let known = sections.entry(key).or_insert(ratio);
        *known = known.max(ratio);
    };
    for place in worst(store, judgement, length, None, usize::MAX)? {
        worse(&place.line, place.from_m, place.rms_over_limit);
    }
    if months > 0.0 {
        match growth(store, judgement, length, None) {
            Ok(grown) => {
                grown.iter().for_each(|section: &SectionGrowth| {
                    worse(&section.line, section.from_m, section.ratio_after(months));
                });
                remarks.extend(rails_without_growth(store, None)?);
            }
            Err(NetworkError::Nothing(_)) => remarks.push(
                "no line has surveys of two dates: nothing is known of growth, and the plan is for the state of now"
                    .to_owned(),
            ),
            Err(error) => return Err(error),
        }
    }
    let over: Vec<((String, i64), f64)> = sections
        .into_iter()
        .filter(|(_, ratio)| *ratio > 1.0)
        .collect();
    let over_limit_m = over.len() as f64 * length;
    let mut order: Vec<usize> = (0..over.len()).collect();
    order.sort_by(|&a, &b| over[b].1.total_cmp(&over[a].1));
    let mut chosen = std::collections::BTreeMap::new();
    let mut money = budget.money;
    for index in order {
        let ((line, place), ratio) = &over[index];
        let joins = [place - 1, place + 1]
            .iter()
            .filter(|other| chosen.contains_key(&(line.clone(), **other)))
            .count();
        // One that closes a gap makes one site of two.
        let sites = 1.0 - joins as f64;
        let cost = budget.per_metre * length + budget.per_site * sites;
        if cost > money * (1.0 + 1e-12) {
            continue;
        }
        money -= cost;
        chosen.insert((line.clone(), *place), (*ratio, cost));
    }
    let mut sites: Vec<PlannedSection> = Vec::new();
    let count = chosen.len() as f64;
    for ((line, place), (ratio, cost)) in chosen {
        let from = place as f64 * length;
        match sites.last_mut() {
            Some(site) if site.line == line && (site.to_m - from).abs() < 1e-6 * length => {
                site.to_m = from + length;
                site.rms_over_limit = site.rms_over_limit.max(ratio);
                site.cost += cost;
            }
            _ => sites.push(PlannedSection {
                line,
                from_m: from,
                to_m: from + length,
                rms_over_limit: ratio,
                cost,
            }),
        }
    }
    Ok(GrindingPlan {
        months,
        length_m: count * length,
        cost: sites.iter().map(|site| site.cost).sum(),
        over_limit_m,
        left_over_limit_m: over_limit_m - count * length,
        sites,
        remarks,
    })
}
