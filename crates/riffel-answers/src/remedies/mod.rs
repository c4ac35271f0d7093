//! What would slow growth under a traffic: the remedies that a case has keys for, ranked by what they do.

mod step;

use std::cmp::Ordering;
use std::collections::BTreeMap;

use riffel_case::Case;
use riffel_case::traffic::{Traffic, UsualTraffic};
use riffel_keys::{CaseError, Language, Message, fixed, say};
use riffel_plot::{LineFigure, Series};
use serde::Serialize;

pub use step::Change;

use crate::forecast::{per_million, rate_panel, zero};
use crate::{Answer, AnswerError, FastestGrowth, GrindingInterval, LineGrowth, Result, Rows, Table};
use step::{Step, in_words, steps};

/// The remedies of a case under a traffic, the one that helps most first.
#[derive(Serialize)]
pub struct RemediesAnswer {
    riffel_version: &'static str,
    /// Growth of the case without any remedy.
    pub under_traffic: LineGrowth,
    /// Grinding interval of the case without any remedy; `None` if it is not known how many axles run.
    pub grinding_interval: Option<GrindingInterval>,
    /// What the remedies do; empty if nothing grows.
    pub remedies: Vec<Remedy>,
    /// What is no remedy here, and why.
    pub left_out: Vec<LeftOut>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

/// A remedy with what it does to growth.
#[derive(Serialize)]
pub struct Remedy {
    /// Which it is, as costs name it.
    pub id: &'static str,
    /// What is done.
    pub title: Message,
    /// Keys of a file of changes, dotted, with their values in SI: of the case, or of the speeds.
    pub changes: Vec<Change>,
    /// Of the growth rate of the fastest wavelength, relative to the case as it is; −1 where nothing grows.
    pub change_of_fastest_growth: f64,
    /// What then grows fastest; `None` if nothing does.
    pub fastest: Option<FastestGrowth>,
    /// In what growth then doubles, in the unit of the case as it is.
    #[serde(skip)]
    pub doubles_in: Message,
    /// From one grinding to the next; `None` if it is not known how many axles run.
    pub grinding_interval: Option<GrindingInterval>,
    /// That it is longer than in the case as it is.
    pub months_gained: Option<f64>,
    /// The interval, in the unit of the case as it is.
    #[serde(skip)]
    pub ground_after: Option<Message>,
    /// What it costs, in any currency that is that of all.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<f64>,
    #[serde(skip)]
    curve: Vec<[f64; 2]>,
}

/// A remedy that the case has no number for.
#[derive(Serialize)]
pub struct LeftOut {
    /// What would be done.
    pub title: Message,
    /// Why it is left out.
    pub reason: Message,
}

impl RemediesAnswer {
    /// The remedies of a case under a traffic, or else under the usual one of its line. `progress` is called at each.
    ///
    /// # Errors
    /// [`CaseError`] as of [`LineGrowth::new`].
    pub fn new(case: &Case, traffic: Option<&Traffic>, progress: &(dyn Fn(usize) + Sync)) -> Result<Self, CaseError> {
        let under_traffic = LineGrowth::new(case, traffic)?;
        let mut answer = Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            remedies: Vec::new(),
            left_out: Vec::new(),
            remarks: Vec::new(),
            grinding_interval: GrindingInterval::new(case, &under_traffic),
            under_traffic,
        };
        let Some(before) = answer.under_traffic.fastest else {
            return Ok(answer);
        };
        let usual = match traffic {
            Some(traffic) => traffic.clone(),
            None => UsualTraffic::of(case).traffic()?,
        };
        for step in steps(case, &usual) {
            progress(1);
            let taken = step.taken(case, &usual);
            let Step { title, key, .. } = step;
            let (changes, growth) = match taken {
                Ok(taken) => taken,
                Err(reason) => {
                    answer.left_out.push(LeftOut { title, reason });
                    continue;
                }
            };
            let after = |fastest: FastestGrowth| fastest.growth_rate_per_passage;
            let change = growth.fastest.map_or(0.0, after) / before.growth_rate_per_passage - 1.0;
            if change == 0.0 {
                let reason = say!(remedy_has_no_effect, key);
                answer.left_out.push(LeftOut { title, reason });
                continue;
            }
            answer.remarks.extend((changes.len() > 1).then(|| say!(treatment_keeps_force)));
            let interval = GrindingInterval::new(case, &growth);
            let intervals = interval.zip(answer.grinding_interval);
            answer.remedies.push(Remedy {
                id: title.id(),
                title,
                changes,
                change_of_fastest_growth: change,
                doubles_in: growth
                    .fastest
                    .map_or_else(|| say!(nothing_grows_then), |fastest| fastest.time_beside(&before)),
                grinding_interval: interval,
                months_gained: intervals.map(|(own, before)| own.gained_on(&before)),
                ground_after: intervals.map(|(own, before)| own.time_beside(&before)),
                cost: None,
                fastest: growth.fastest,
                curve: growth.curve,
            });
        }
        answer.remedies.sort_by(Remedy::by_effect);
        answer.left_out.push(LeftOut {
            title: say!(more_grinding),
            reason: match before.has_times() {
                true => say!(grinding_leaves_growth, time = before.time()),
                false => say!(grinding_leaves_fast_growth),
            },
        });
        let interval = answer.grinding_interval;
        answer.remarks.extend(interval.map(|it| say!(ground_as_it_is, time = it.time_beside(&it))));
        answer.remarks.push(say!(steps_are_chosen));
        Ok(answer)
    }

    /// Answer with costs by the ids of remedies: what lengthens the grinding interval and has a cost comes first, by the months that
    /// it gains for that; all else follows by its effect. The cost of a remedy that is left out here stands aside.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a cost that is not above zero, or of what no remedy is called.
    pub fn with_costs(mut self, costs: &BTreeMap<String, f64>) -> Result<Self> {
        if let Some((id, cost)) = costs.iter().find(|(_, cost)| !(**cost > 0.0 && cost.is_finite())) {
            return Err(AnswerError::argument("cost", format!("{id} = {cost}"), "finite and above zero"));
        }
        let left_out = self.left_out.iter().map(|it| it.title.id());
        let known = self.remedies.iter().map(|it| it.id).chain(left_out);
        let known: Vec<&str> = known.collect();
        if let Some(id) = costs.keys().find(|id| !known.contains(&id.as_str())) {
            return Err(AnswerError::argument(
                "cost",
                format!("that of \"{id}\""),
                format!("that of one of {}", known.join(", ")),
            ));
        }
        for remedy in &mut self.remedies {
            remedy.cost = costs.get(remedy.id).copied();
        }
        let worth = |remedy: &Remedy| remedy.months_per_cost().unwrap_or(0.0);
        self.remedies.sort_by(|a, b| worth(b).total_cmp(&worth(a)).then(a.by_effect(b)));
        Ok(self)
    }

    /// How many steps there are at most, for whom waits.
    pub fn steps(case: &Case) -> usize {
        UsualTraffic::of(case).traffic().map_or(0, |usual| steps(case, &usual).len())
    }

    /// What helps most, in one sentence; `None` if nothing grows, or the loop oscillates by itself.
    pub fn helps_most(&self) -> Option<Message> {
        self.under_traffic.fastest.filter(|fastest| !fastest.oscillates)?;
        let best = self.remedies.iter().min_by(|a, b| a.by_effect(b));
        let helps =
            |best: &&Remedy| best.change_of_fastest_growth < 0.0 && best.fastest.is_none_or(|it| !it.oscillates);
        let Some(best) = best.filter(helps) else {
            return Some(say!(helps_nothing));
        };
        let title = best.title.clone();
        let percent = fixed(-100.0 * best.change_of_fastest_growth, 0);
        Some(match best.fastest {
            Some(fastest) if fastest.faster_than_known => {
                say!(helps_most_in_order, title, percent)
            }
            Some(fastest) => say!(helps_most, title, percent, time = fastest.time()),
            None => say!(helps_most_of_all, title),
        })
    }
}

impl Remedy {
    /// What it does to growth, the most first; one under which the loop oscillates by itself is last.
    fn by_effect(&self, other: &Self) -> Ordering {
        let oscillates = |it: &Self| it.fastest.is_some_and(|fastest| fastest.oscillates);
        let changes = [self, other].map(|it| it.change_of_fastest_growth);
        oscillates(self).cmp(&oscillates(other)).then(changes[0].total_cmp(&changes[1]))
    }

    /// Months that are gained for one of the currency; none without a cost, and where none are gained.
    pub fn months_per_cost(&self) -> Option<f64> {
        Some(self.months_gained.filter(|months| *months > 0.0)? / self.cost?)
    }
}

impl Answer for RemediesAnswer {
    fn name(&self) -> &'static str {
        "remedies"
    }

    fn folder_name(&self) -> Option<&'static str> {
        Some("remedies")
    }

    fn introduction(&self) -> Vec<Message> {
        self.under_traffic.remarks.clone()
    }

    fn tables(&self) -> Vec<Table> {
        let remedies = &self.remedies;
        let mut columns = vec![
            remedies.words("remedy", say!(remedy_column), |it| it.title.clone()),
            remedies.words("change", say!(remedy_changes_column), |it| Message::verbatim(in_words(&it.changes))),
            remedies.fixed("growth_change_percent", say!(growth_change_column), 0, |it| {
                100.0 * it.change_of_fastest_growth
            }),
            remedies.shown(say!(doubles_in_column), |it| it.doubles_in.clone()),
            remedies.shown(say!(ground_after_column), |it| {
                it.ground_after.clone().unwrap_or_else(|| Message::verbatim(""))
            }),
            remedies.plain("grinding_interval_months", |it| it.grinding_interval?.months),
            remedies.plain("doubling_months", |it| it.fastest?.doubling_months),
            remedies.plain("growth_rate_per_passage", |it| Some(it.fastest?.growth_rate_per_passage)),
        ];
        if remedies.iter().any(|it| it.cost.is_some()) {
            columns.push(remedies.plain("cost", |it| it.cost));
            columns.push(remedies.plain("months_per_cost", Remedy::months_per_cost));
        }
        vec![Table { name: "remedies", columns }]
    }

    fn sentences(&self) -> Vec<Message> {
        let left_out = self
            .left_out
            .iter()
            .map(|LeftOut { title, reason }| say!(left_out_for, title = title.clone(), reason = reason.clone()));
        self.helps_most().into_iter().chain(left_out).collect()
    }

    fn figure(&self) -> LineFigure {
        let line = |label: String, curve: &[[f64; 2]]| {
            Series::new(
                label,
                curve.iter().map(|[wavelength, _]| 1e3 * wavelength).collect(),
                curve.iter().map(|[_, rate]| per_million(*rate)).collect(),
            )
        };
        let as_it_is = line("as it is".to_owned(), &self.under_traffic.curve);
        let floor = zero(&as_it_is.x);
        let remedies = self.remedies.iter();
        let remedies = remedies.map(|it| line(it.title.to_string(), &it.curve));
        let series = std::iter::once(as_it_is).chain(remedies).chain([floor]);
        LineFigure::new(
            "Remedies",
            "Growth of the level by wavelength, positive where corrugation grows.",
            [rate_panel(series.collect(), Language::English)],
        )
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_case::NOMINAL_CASE;

    /// 12 months for 6 are 2 for one, 9 for 3 are 3; a cost does not help what loses months, nor is it one of what has none.
    #[test]
    fn months_per_cost_go_before_effect() {
        let case = Case::parse("nominal", NOMINAL_CASE, &[]).unwrap();
        let mut answer = RemediesAnswer::new(&case, None, &|_| ()).unwrap();
        let made_up = [
            ("a", -0.5, Some(12.0)),
            ("b", -0.4, Some(9.0)),
            ("c", -0.6, Some(30.0)),
            ("d", 0.1, Some(-2.0)),
            ("e", -0.1, None),
        ];
        assert!(answer.remedies.len() >= made_up.len());
        answer.remedies.truncate(made_up.len());
        for (remedy, (id, change, gained)) in answer.remedies.iter_mut().zip(made_up) {
            remedy.id = id;
            remedy.change_of_fastest_growth = change;
            remedy.months_gained = gained;
        }
        let costs = |costs: &[(&str, f64)]| {
            let costs = costs.iter().map(|(id, cost)| ((*id).to_owned(), *cost));
            costs.collect::<BTreeMap<_, _>>()
        };
        let given = costs(&[
            ("a", 6.0),
            ("b", 3.0),
            ("d", 1.0),
            ("e", 1.0),
            // Left out in this case.
            ("softer-pads", 1.0),
        ]);
        let answer = answer.with_costs(&given).unwrap();
        let ids: Vec<&str> = answer.remedies.iter().map(|remedy| remedy.id).collect();
        assert_eq!(ids, ["b", "a", "c", "e", "d"]);
        assert_eq!(answer.remedies[0].months_per_cost(), Some(3.0));
        // What helps most is still that which does the most to growth.
        let said = answer.helps_most().unwrap().to_string();
        assert!(said.contains("60 %"), "{said}");
        let refused = answer.with_costs(&costs(&[("a", 0.0)])).err().unwrap();
        assert_eq!(refused.to_string(), "cost is a = 0, but must be finite and above zero");
        let answer = RemediesAnswer::new(&case, None, &|_| ()).unwrap();
        let refused = answer.with_costs(&costs(&[("soft-pads", 1.0)])).err();
        let said = refused.unwrap().to_string();
        assert!(said.contains("\"soft-pads\"") && said.contains("softer-pads"), "{said}");
    }
}
