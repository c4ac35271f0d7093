//! What would slow growth under a traffic: the remedies that a case has keys for, ranked by what they do.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use riffel::forecast::SpeedDistribution;
use riffel_case::traffic::{Traffic, UsualTraffic};
use riffel_case::{Case, CaseKey, Hold, Variant};
use riffel_keys::quantity::{Kind, Speed};
use riffel_keys::{CaseError, Language, Message, fixed, number, say, significant_digits};
use riffel_plot::{LineFigure, Series};
use serde::Serialize;

use crate::forecast::{per_million, rate_panel, zero};
use crate::{Answer, AnswerError, Column, FastestGrowth, GrindingInterval, LineGrowth, Table};

/// Friction of a treated rail: chosen, that of a friction modifier which works well.
const TREATED_FRICTION: f64 = 0.25;
/// What rail dampers add to the loss factor of the rail: chosen.
const RAIL_DAMPERS: f64 = 0.1;
/// How much more widely speeds are spread: chosen.
const WIDER: f64 = 1.5;
/// Standard deviation of a speed as a share of the mean, at most: a normal distribution with more reaches standstill.
const WIDEST: f64 = 0.24;

/// The remedies of a case under a traffic, the one that helps most first.
#[derive(Serialize)]
pub struct RemediesAnswer {
    riffel_version: &'static str,
    /// As it is.
    pub under_traffic: LineGrowth,
    /// As it is; none where it is not known how many axles run.
    pub grinding_interval: Option<GrindingInterval>,
    /// What the remedies do; none where nothing grows.
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
    /// What then grows fastest; none where nothing does.
    pub fastest: Option<FastestGrowth>,
    /// In what growth then doubles, in the unit of the case as it is.
    #[serde(skip)]
    pub doubles_in: Message,
    /// From one grinding to the next; none where it is not known how many axles run.
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

/// A key with its value.
#[derive(Clone, Serialize)]
pub struct Change {
    key: &'static str,
    value: f64,
}

/// A remedy that the case has no number for.
#[derive(Serialize)]
pub struct LeftOut {
    /// What would be done.
    pub title: Message,
    /// Why it is left out.
    pub reason: Message,
}

/// One key changed, or why it cannot be.
struct Step {
    title: Message,
    key: &'static str,
    value: Result<f64, Message>,
}

impl Step {
    /// What it changes, and what becomes of growth.
    fn taken(&self, case: &Case, traffic: &Traffic) -> Result<(Vec<Change>, LineGrowth), Message> {
        let (key, value) = (self.key, self.value.clone()?);
        if case.idle_because(key).is_some() {
            return Err(say!(remedy_has_no_effect, key = key));
        }
        let mut changes = vec![Change { key, value }];
        let variant = Variant::parse("remedy", &format!("{key} = {value:?}\n"));
        let growth = variant.and_then(|mut variant| {
            if key == "contact.friction" && keeps_force(case) {
                variant.hold = Some(Hold::Force);
                changes.extend(kept_ratio(case, traffic, value));
            }
            LineGrowth::under(case, traffic, &variant)
        });
        match growth {
            Ok(growth) => Ok((changes, growth)),
            Err(_) => Err(say!(remedy_is_refused)),
        }
    }
}

/// The tractive ratio with which trains pull as before on another friction, where they all have one.
fn kept_ratio(case: &Case, traffic: &Traffic, treated: f64) -> Option<Change> {
    let common = |key, of_case| traffic.common_value(key, Some(of_case)).ok().flatten();
    let key = "contact.tractive_ratio";
    let friction = common("contact.friction", case.file.contact.friction.si())?;
    let ratio = common(key, case.steady.tractive_ratio())?;
    let value = ratio * friction / treated;
    Some(Change { key, value })
}

/// Trains pull and brake as before on another friction, unless a curve or the case itself sets the creepage.
fn keeps_force(case: &Case) -> bool {
    case.file.contact.creepage.is_none() && case.file.contact.from.is_none()
}

impl RemediesAnswer {
    /// The remedies of a case under a traffic, or else under the usual one of its line. `progress` is called at each.
    ///
    /// # Errors
    /// [`CaseError`] as of [`LineGrowth::new`].
    pub fn new(
        case: &Case,
        traffic: Option<&Traffic>,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, CaseError> {
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
                let reason = say!(remedy_has_no_effect, key = key);
                answer.left_out.push(LeftOut { title, reason });
                continue;
            }
            answer
                .remarks
                .extend((changes.len() > 1).then(|| say!(treatment_keeps_force)));
            let interval = GrindingInterval::new(case, &growth);
            let intervals = interval.zip(answer.grinding_interval);
            answer.remedies.push(Remedy {
                id: title.id(),
                title,
                changes,
                change_of_fastest_growth: change,
                doubles_in: growth.fastest.map_or_else(
                    || say!(nothing_grows_then),
                    |fastest| fastest.time_beside(&before),
                ),
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
            reason: say!(grinding_leaves_growth, time = before.time()),
        });
        let interval = answer.grinding_interval;
        answer
            .remarks
            .extend(interval.map(|it| say!(ground_as_it_is, time = it.time_beside(&it))));
        answer.remarks.push(say!(steps_are_chosen));
        Ok(answer)
    }

    /// The same with costs by the ids of remedies: what lengthens the grinding interval and has a cost comes first, by the months that
    /// it gains for that; all else follows by its effect. The cost of a remedy that is left out here stands aside.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a cost that is not above zero, or of what no remedy is called.
    pub fn with_costs(mut self, costs: &BTreeMap<String, f64>) -> Result<Self, AnswerError> {
        if let Some((id, cost)) = costs
            .iter()
            .find(|(_, cost)| !(**cost > 0.0 && cost.is_finite()))
        {
            return Err(AnswerError::Argument {
                argument: "cost",
                value: format!("{id} = {cost}"),
                rule: "finite and above zero".to_owned(),
            });
        }
        let left_out = self.left_out.iter().map(|it| it.title.id());
        let known = self.remedies.iter().map(|it| it.id).chain(left_out);
        let known: Vec<&str> = known.collect();
        if let Some(id) = costs.keys().find(|id| !known.contains(&id.as_str())) {
            return Err(AnswerError::Argument {
                argument: "cost",
                value: format!("that of \"{id}\""),
                rule: format!("that of one of {}", known.join(", ")),
            });
        }
        for remedy in &mut self.remedies {
            remedy.cost = costs.get(remedy.id).copied();
        }
        let worth = |remedy: &Remedy| remedy.months_per_cost().unwrap_or(0.0);
        self.remedies
            .sort_by(|a, b| worth(b).total_cmp(&worth(a)).then(a.by_effect(b)));
        Ok(self)
    }

    /// How many steps there are at most, for whom waits.
    pub fn steps(case: &Case) -> usize {
        UsualTraffic::of(case)
            .traffic()
            .map_or(0, |usual| steps(case, &usual).len())
    }

    /// What helps most, in one sentence; none where nothing grows.
    pub fn helps_most(&self) -> Option<Message> {
        self.under_traffic.fastest?;
        let best = self.remedies.iter().min_by(|a, b| a.by_effect(b));
        let Some(best) = best.filter(|best| best.change_of_fastest_growth < 0.0) else {
            return Some(say!(helps_nothing));
        };
        let title = best.title.clone();
        Some(match best.fastest {
            Some(fastest) => say!(
                helps_most,
                title = title,
                percent = fixed(-100.0 * best.change_of_fastest_growth, 0),
                time = fastest.time()
            ),
            None => say!(helps_most_of_all, title = title),
        })
    }
}

impl Remedy {
    /// What it does to growth, the most first.
    fn by_effect(&self, other: &Self) -> Ordering {
        let [own, other] = [self, other].map(|it| it.change_of_fastest_growth);
        own.total_cmp(&other)
    }

    /// Months that are gained for one of the currency; none without a cost, and where none are gained.
    pub fn months_per_cost(&self) -> Option<f64> {
        Some(self.months_gained.filter(|months| *months > 0.0)? / self.cost?)
    }
}

/// Keys and values, to four digits: "track.pad.stiffness = 30 MN/m".
fn in_words(changes: &[Change]) -> String {
    let words = changes.iter().map(|Change { key, value }| {
        let kind = match *key {
            "speed.standard_deviation" => Some(Kind::of::<Speed>()),
            key => CaseKey::find(key).and_then(|known| known.quantity),
        };
        let (number, unit) = kind.map_or((*value, ""), |kind| kind.in_engineers_unit(*value));
        // Without zeros at the end.
        let rounded: f64 = significant_digits(number, 4).parse().unwrap_or(number);
        format!("{key} = {rounded} {unit}").trim_end().to_owned()
    });
    words.collect::<Vec<_>>().join(", ")
}

/// What is changed, one key at a time.
fn steps(case: &Case, traffic: &Traffic) -> Vec<Step> {
    let file = &case.file;
    let common = |key: &'static str, of_case: Option<f64>| {
        let value = traffic.common_value(key, of_case)?;
        value.ok_or_else(|| say!(remedy_lacks_key, key = key))
    };
    let times = |title: Message, key: &'static str, of_case: Option<f64>, factor: f64| Step {
        title,
        key,
        value: common(key, of_case).map(|value| factor * value),
    };
    let stiffness = |support: &Option<riffel_case::file::Support>| {
        support.as_ref()?.stiffness.map(|stiffness| stiffness.si())
    };
    let pad = stiffness(&file.track.pad);
    let (mass_key, mass) = match &file.wheelset {
        Some(wheelset) => ("wheelset.mass", wheelset.mass),
        None => ("wheel.mass", file.wheel.mass),
    };
    let loss = file.rail.loss_factor.map_or(0.0, |loss| loss.si());
    let friction = common("contact.friction", Some(file.contact.friction.si()));
    vec![
        times(say!(softer_pads), "track.pad.stiffness", pad, 0.5),
        times(say!(stiffer_pads), "track.pad.stiffness", pad, 2.0),
        times(
            say!(softer_ballast),
            "track.ballast.stiffness",
            stiffness(&file.track.ballast),
            0.5,
        ),
        Step {
            title: say!(more_rail_loss, loss = number(RAIL_DAMPERS)),
            key: "rail.loss_factor",
            value: common("rail.loss_factor", Some(loss)).map(|loss| loss + RAIL_DAMPERS),
        },
        Step {
            title: say!(friction_treatment, friction = number(TREATED_FRICTION)),
            key: "contact.friction",
            value: friction.and_then(|friction| match friction > TREATED_FRICTION {
                true => Ok(TREATED_FRICTION),
                false => Err(say!(friction_is_low, friction = number(friction))),
            }),
        },
        times(
            say!(lighter_wheel),
            mass_key,
            mass.map(|mass| mass.si()),
            0.8,
        ),
        wider_speeds(traffic),
        Step {
            title: say!(slower_trains),
            key: "speed.factor",
            value: Ok(0.8),
        },
    ]
}

/// All speeds spread by one factor, as far as the widest can be; where none are spread, by one deviation.
fn wider_speeds(traffic: &Traffic) -> Step {
    let speeds = traffic.speeds();
    let slowest = speeds.iter().map(SpeedDistribution::mean);
    let slowest = slowest.fold(f64::INFINITY, f64::min);
    let widths = speeds.iter().map(|it| it.deviation() / it.mean());
    let factor = WIDER.min(WIDEST / widths.fold(0.0, f64::max));
    let deviation = speeds[0].deviation();
    let all_alike = speeds.iter().all(|it| it.deviation() == deviation);
    let (key, value) = match all_alike {
        true if deviation == 0.0 => ("speed.standard_deviation", 0.1 * slowest),
        true => ("speed.standard_deviation", factor * deviation),
        false => ("speed.standard_deviation_factor", factor),
    };
    Step {
        title: say!(wider_speeds),
        key,
        value: match factor > 1.05 {
            true => Ok(value),
            false => Err(say!(speeds_are_wide)),
        },
    }
}

impl Answer for RemediesAnswer {
    const NAME: &'static str = "remedies";

    fn introduction(&self) -> Vec<Message> {
        self.under_traffic.remarks.clone()
    }

    fn tables(&self) -> Vec<Table> {
        let of = |value: &dyn Fn(&Remedy) -> Message| self.remedies.iter().map(value).collect();
        let numbers = |value: fn(&Remedy) -> Option<f64>| self.remedies.iter().map(value);
        let change = numbers(|it| Some(100.0 * it.change_of_fastest_growth));
        let months = numbers(|it| it.fastest?.doubling_months).collect();
        let rates = numbers(|it| Some(it.fastest?.growth_rate_per_passage)).collect();
        let grinding = numbers(|it| it.grinding_interval?.months).collect();
        let unknown = || Message::verbatim("");
        let ground_after = |it: &Remedy| it.ground_after.clone().unwrap_or_else(unknown);
        let mut costs = Vec::new();
        if self.remedies.iter().any(|it| it.cost.is_some()) {
            let by_cost = numbers(Remedy::months_per_cost).collect();
            costs.push(Column::optional("cost", numbers(|it| it.cost).collect()));
            costs.push(Column::optional("months_per_cost", by_cost));
        }
        vec![Table {
            name: "remedies",
            columns: [
                Column::words("remedy", say!(remedy_column), of(&|it| it.title.clone())),
                Column::words(
                    "change",
                    say!(remedy_changes_column),
                    of(&|it| Message::verbatim(in_words(&it.changes))),
                ),
                Column::fixed(
                    "growth_change_percent",
                    say!(growth_change_column),
                    change,
                    0,
                ),
                Column::shown(say!(doubles_in_column), of(&|it| it.doubles_in.clone())),
                Column::shown(say!(ground_after_column), of(&ground_after)),
                Column::optional("grinding_interval_months", grinding),
                Column::optional("doubling_months", months),
                Column::optional("growth_rate_per_passage", rates),
            ]
            .into_iter()
            .chain(costs)
            .collect(),
        }]
    }

    fn sentences(&self) -> Vec<Message> {
        let left_out = self.left_out.iter().map(|LeftOut { title, reason }| {
            say!(left_out_for, title = title.clone(), reason = reason.clone())
        });
        self.helps_most().into_iter().chain(left_out).collect()
    }

    fn figure(&self) -> LineFigure {
        let line = |label: String, curve: &[[f64; 2]]| Series {
            label,
            x: curve
                .iter()
                .map(|[wavelength, _]| 1e3 * wavelength)
                .collect(),
            y: curve.iter().map(|[_, rate]| per_million(*rate)).collect(),
            ..Series::default()
        };
        let as_it_is = line("as it is".to_owned(), &self.under_traffic.curve);
        let floor = zero(&as_it_is.x);
        let remedies = self.remedies.iter();
        let remedies = remedies.map(|it| line(it.title.to_string(), &it.curve));
        let series = std::iter::once(as_it_is).chain(remedies).chain([floor]);
        LineFigure {
            title: "Remedies".to_owned(),
            caption: "Growth of the level by wavelength, positive where corrugation grows."
                .to_owned(),
            panels: vec![rate_panel(series.collect(), Language::English)],
            ..LineFigure::default()
        }
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
        assert_eq!(
            refused.to_string(),
            "cost is a = 0, but must be finite and above zero"
        );
        let answer = RemediesAnswer::new(&case, None, &|_| ()).unwrap();
        let refused = answer.with_costs(&costs(&[("soft-pads", 1.0)])).err();
        let said = refused.unwrap().to_string();
        assert!(
            said.contains("\"soft-pads\"") && said.contains("softer-pads"),
            "{said}"
        );
    }
}
