//! Whether the case takes the values of a plan, before anything runs.

use riffel_case::{Case, Setting};
use riffel_keys::{CaseError, KeyFile};
use riffel_numerics::distribution::Distribution;

use super::Plan;
use crate::parameter::{Parameter, Spread};

/// Most values of one list that are tried; beyond it the ends and evenly spaced ones between.
const MOST_TRIED: usize = 100;
/// The share next to an end that stands for it.
const NEXT_TO_AN_END: f64 = 1e-9;
/// The share at which an infinite tail is looked at: one sample in a thousand lies beyond.
const TAIL: f64 = 1e-3;

/// Try every list and the ends of every distribution with all other parameters in their middle.
///
/// A refused value is an error of the plan. An infinite tail that the case refuses is a remark: its samples will
/// fail one by one.
pub(super) fn check(source: &KeyFile, plan: &mut Plan, case: &Case) -> Result<(), CaseError> {
    let middle: Vec<Setting> = plan.parameters.iter().map(|p| p.setting(&p.value(0.5))).collect();
    let mut remarks = Vec::new();
    for (index, parameter) in plan.parameters.iter().enumerate() {
        for (share, place) in trials(parameter) {
            let value = parameter.value(share);
            let mut settings = middle.clone();
            settings[index] = parameter.setting(&value);
            let Err(error) = plan.outputs.on(case, &settings) else {
                continue;
            };
            // Beside other values it may be right, and the middle of all ranges is no sample.
            let beside_others = |number: u32| {
                let mut settings = elsewhere(plan, number);
                settings[index] = parameter.setting(&value);
                plan.outputs.on(case, &settings).is_ok()
            };
            if plan.parameters.len() > 1 && (0..ELSEWHERE).any(beside_others) {
                let sentence = format!("{error}{}", beside(&middle, index));
                remarks.push(format!(
                    "the case takes {}={value} beside some values of the others only: {sentence}; samples that it refuses fail",
                    parameter.key.key
                ));
                continue;
            }
            // The end itself reads better than the number next to it, where it is refused as well.
            settings[index] = parameter.setting(&parameter.value(share.round()));
            let at_end = plan.outputs.on(case, &settings).err().filter(|_| NEXT_TO_AN_END == share.min(1.0 - share));
            let sentence = at_end.unwrap_or(error).to_string();
            let sentence = format!("{sentence}{}", beside(&middle, index));
            match place {
                Some(place) => {
                    return Err(source.refuse(&format!("parameter[{index}].{place}"), &sentence));
                }
                None => remarks.push(format!(
                    "one value of {} in a thousand is beyond {value}, where the case says: {sentence}; such \
                     samples fail (cut the distribution off by min and max)",
                    parameter.key.key
                )),
            }
        }
    }
    plan.remarks.extend(remarks);
    Ok(())
}

/// Places in the ranges of the others at which a value is tried that the case refuses in their middle.
const ELSEWHERE: u32 = 32;

/// The parameters at the place of a number, spread over their ranges evenly: multiples of the powers of the root of
/// x^(n + 1) = x + 1 (Roberts 2018), modulo 1.
fn elsewhere(plan: &Plan, number: u32) -> Vec<Setting> {
    let count = plan.parameters.len() as i32;
    let root = (0..60).fold(2.0f64, |root, _| (1.0 + root).powf(1.0 / f64::from(count + 1)));
    let shares = (1..=count).map(|axis| (f64::from(number + 1) * root.powi(-axis)).fract());
    let settings = plan.parameters.iter().zip(shares);
    settings.map(|(parameter, share)| parameter.setting(&parameter.value(share))).collect()
}

/// Most other parameters that are named.
const MOST_NAMED: usize = 4;

/// What the other parameters are where one is tried: they may be what makes its value impossible.
fn beside(middle: &[Setting], tried: usize) -> String {
    let others = (0..middle.len()).filter(|index| *index != tried);
    let named = others.clone().take(MOST_NAMED).map(|index| {
        let (key, value) = &middle[index];
        match value.as_str() {
            Some(text) => format!("{key}={text}"),
            None => format!("{key}={value}"),
        }
    });
    let named: Vec<String> = named.collect();
    match named.len() {
        0 => String::new(),
        _ => format!(
            " (here with {}{})",
            named.join(", "),
            match others.count() > MOST_NAMED {
                true => ", …",
                false => "",
            }
        ),
    }
}

/// Shares to try, each with the key of the plan that is at fault if it is refused; none for a tail.
fn trials(parameter: &Parameter) -> Vec<(f64, Option<String>)> {
    let ends = |table: &str| {
        vec![(NEXT_TO_AN_END, Some(format!("{table}.min"))), (1.0 - NEXT_TO_AN_END, Some(format!("{table}.max")))]
    };
    match &parameter.spread {
        Spread::Values(values) => {
            let count = values.len();
            let tried = count.min(MOST_TRIED);
            (0..tried)
                .map(|k| match tried {
                    1 => 0,
                    tried => k * (count - 1) / (tried - 1),
                })
                .map(|level| {
                    let share = (level as f64 + 0.5) / count as f64;
                    (share, Some(format!("values[{level}]")))
                })
                .collect()
        }
        Spread::Distribution(Distribution::Uniform { .. }) => ends("uniform"),
        Spread::Distribution(Distribution::Triangular { .. }) => ends("triangular"),
        Spread::Distribution(Distribution::Normal { min, max, .. }) => {
            tails("normal", "mean", (min.is_finite(), max.is_finite()))
        }
        Spread::Distribution(Distribution::Lognormal { min, max, .. }) => {
            tails("lognormal", "median", (*min > 0.0, max.is_finite()))
        }
    }
}

fn tails(table: &str, middle: &str, cut: (bool, bool)) -> Vec<(f64, Option<String>)> {
    let side = |cut: bool, end: &str, share: f64, tail: f64| match cut {
        true => (share, Some(format!("{table}.{end}"))),
        false => (tail, None),
    };
    vec![
        (0.5, Some(format!("{table}.{middle}"))),
        side(cut.0, "min", NEXT_TO_AN_END, TAIL),
        side(cut.1, "max", 1.0 - NEXT_TO_AN_END, 1.0 - TAIL),
    ]
}
