//! What to grind of a network with a budget.

use std::collections::{BTreeMap, BTreeSet};

use serde::Serialize;

use crate::growth::growth_by_band;
use crate::judgement::DefectKind;
use crate::most_track::{OverLimit, brought_below, most_track};
use crate::{Judgement, NetworkError, SectionGrowth, Store, left_out_of_growth, worst};

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
        Self { money: metres, per_metre: 1.0, per_site: 0.0 }
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

/// What a plan is after.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Aim {
    /// The worst sections.
    #[default]
    WorstFirst,
    /// Sections that bring as much track below its limit as the money reaches.
    MostTrack,
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
    /// What it costs.
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
    /// Length of track over its limit at the time planned for, if nothing is done, by what grinding takes off \[m\].
    pub over_limit_m: f64,
    /// Length of track that is over its limit by single places alone, as joints, welds and squats, which is not planned \[m\].
    pub single_places_m: f64,
    /// Length of that which the plan leaves \[m\].
    pub left_over_limit_m: f64,
    /// No plan for this budget leaves less \[m\].
    pub least_left_over_limit_m: f64,
    /// What the reader should know.
    pub remarks: Vec<String>,
}

/// A section by its line and its number along it.
type Key = (String, i64);

/// Sections of track that will be over their limit so many months behind the latest survey, as far as the budget goes.
///
/// What counts is what grinding takes off: sections that are rough at joints and other single places alone are not planned, and told.
///
/// Method: for [`Aim::WorstFirst`] sections are taken in the order of RMS over limit of their worse rail; one that joins on to
/// those taken before costs no new site; what does not fit any more is passed over, and smaller ones may still fit. Nobody is passed
/// over for one who is better off at the same cost. For [`Aim::MostTrack`] sites are chosen that bring the most track below its
/// limit, by a Lagrangian price and a pass over each line, through sections below their limit where that is cheaper than a new site;
/// how far either may be from the optimum is told by `least_left_over_limit_m`. Lines with one survey are taken as they are.
///
/// # Errors
/// [`NetworkError::Value`] for a budget below zero; those of the files.
pub fn plan(
    store: &Store,
    judgement: &Judgement,
    length: f64,
    months: f64,
    budget: &Budget,
    aim: Aim,
) -> Result<GrindingPlan, NetworkError> {
    budget.check()?;
    if !(0.0..=1200.0).contains(&months) {
        return Err(NetworkError::Value {
            what: "the number of months",
            value: months.to_string(),
            rule: "between 0 and 1200".to_owned(),
        });
    }
    let mut remarks: Vec<String> = judgement.remark().into_iter().collect();
    // A line by line and section by section: the worse rail.
    let mut sections: BTreeMap<Key, f64> = BTreeMap::new();
    let mut worse = |line: &str, from: f64, ratio: f64| {
        let key = (line.to_owned(), (from / length).round() as i64);
        let known = sections.entry(key).or_insert(ratio);
        *known = known.max(ratio);
    };
    let mut single: BTreeSet<Key> = BTreeSet::new();
    for place in worst(store, judgement, length, None, usize::MAX)? {
        match place.kind {
            Some(DefectKind::Joint | DefectKind::Weld) => {
                single.insert((place.line.clone(), (place.from_m / length).round() as i64));
                // Known, and nothing to grind.
                worse(&place.line, place.from_m, 0.0);
            }
            _ => worse(&place.line, place.from_m, place.rms_over_limit),
        }
    }
    if months > 0.0 {
        match growth_by_band(store, judgement, length, None) {
            Ok(grown) => {
                grown.iter().for_each(|section: &SectionGrowth| {
                    worse(&section.line, section.from_m, section.lasting_after(months));
                });
            }
            Err(NetworkError::Nothing(_)) => remarks.push(
                "no line has surveys of two dates to compare: nothing is known of growth, and the plan is for the state of now"
                    .to_owned(),
            ),
            Err(error) => return Err(error),
        }
        remarks.extend(left_out_of_growth(store, None)?);
    }
    single.retain(|key| sections.get(key).is_none_or(|ratio| *ratio <= 1.0));
    if !single.is_empty() {
        let length = 1e-3 * length * single.len() as f64;
        remarks.push(format!(
            "{length:.3} km are over the limit at single places alone, as joints, welds or squats, which grinding does not take off: \
             they are not planned (`riffel network worst` names them)"
        ));
    }
    let over = sections.values().filter(|ratio| **ratio > 1.0).count() as f64;
    let stretches = stretches(sections);
    let over_limit: Vec<OverLimit> =
        stretches.iter().map(|stretch| stretch.iter().map(|(_, ratio)| *ratio > 1.0).collect()).collect();
    let per_section = budget.per_metre * length;
    let best = most_track(&over_limit, budget.money, per_section, budget.per_site);
    let ground = match aim {
        Aim::WorstFirst => worst_first(&stretches, length, budget),
        Aim::MostTrack => best.ground,
    };
    let brought_below = brought_below(&over_limit, &ground) as f64;
    let sites = sites(&stretches, &ground, length, budget);
    Ok(GrindingPlan {
        months,
        // The sum of nothing is −0.
        length_m: 0.0 + sites.iter().map(|site| site.to_m - site.from_m).sum::<f64>(),
        cost: 0.0 + sites.iter().map(|site| site.cost).sum::<f64>(),
        over_limit_m: over * length,
        single_places_m: single.len() as f64 * length,
        left_over_limit_m: (over - brought_below) * length,
        // Sections are whole.
        least_left_over_limit_m: (over - (best.bound + 1e-9).floor()) * length,
        sites,
        remarks,
    })
}

/// Sections that join on, with RMS over limit of the worse rail.
type Stretch = Vec<(Key, f64)>;

/// Sections as stretches without a gap.
fn stretches(sections: BTreeMap<Key, f64>) -> Vec<Stretch> {
    let mut found: Vec<Stretch> = Vec::new();
    for ((line, place), ratio) in sections {
        let joins =
            |stretch: &Stretch| stretch.last().is_some_and(|((before, last), _)| *before == line && last + 1 == place);
        match found.last_mut().filter(|stretch| joins(stretch)) {
            Some(stretch) => stretch.push(((line, place), ratio)),
            None => found.push(vec![((line, place), ratio)]),
        }
    }
    found
}

/// The worst sections that the money reaches.
fn worst_first(stretches: &[Stretch], length: f64, budget: &Budget) -> Vec<Vec<bool>> {
    let mut ground: Vec<Vec<bool>> = stretches.iter().map(|one| vec![false; one.len()]).collect();
    let all = stretches.iter().enumerate();
    let mut order: Vec<(f64, usize, usize)> = all
        .flat_map(|(stretch, sections)| {
            let sections = sections.iter().enumerate();
            sections.map(move |(index, (_, ratio))| (*ratio, stretch, index))
        })
        .filter(|(ratio, ..)| *ratio > 1.0)
        .collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut money = budget.money;
    for (_, stretch, index) in order {
        let ground = &mut ground[stretch];
        let beside = [index.checked_sub(1), Some(index + 1)];
        let there = |at: &usize| ground.get(*at) == Some(&true);
        let joins = beside.into_iter().flatten().filter(there).count();
        // One that closes a gap makes one site of two.
        let cost = budget.per_metre * length + budget.per_site * (1.0 - joins as f64);
        if cost <= money * (1.0 + 1e-12) {
            money -= cost;
            ground[index] = true;
        }
    }
    ground
}

/// What is ground as sites along the lines.
fn sites(stretches: &[Stretch], ground: &[Vec<bool>], length: f64, budget: &Budget) -> Vec<PlannedSection> {
    let mut sites: Vec<PlannedSection> = Vec::new();
    for (stretch, ground) in stretches.iter().zip(ground) {
        for (index, ((line, place), ratio)) in stretch.iter().enumerate() {
            if !ground[index] {
                continue;
            }
            let from = *place as f64 * length;
            match sites.last_mut() {
                Some(site) if index > 0 && ground[index - 1] => {
                    site.to_m = from + length;
                    site.rms_over_limit = site.rms_over_limit.max(*ratio);
                    site.cost += budget.per_metre * length;
                }
                _ => sites.push(PlannedSection {
                    line: line.clone(),
                    from_m: from,
                    to_m: from + length,
                    rms_over_limit: *ratio,
                    cost: budget.per_metre * length + budget.per_site,
                }),
            }
        }
    }
    sites
}
