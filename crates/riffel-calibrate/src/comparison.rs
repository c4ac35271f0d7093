//! Models by how well they predict what was left out.

use std::path::Path;

use serde::Serialize;

use crate::chains::Chains;
use crate::data::Group;
use crate::error::CalibrationError;
use crate::folder::Folder;
use crate::gaussian::Conditional;
use crate::held_out::{Score, given_rest};
use crate::names::MODELS;
use crate::plan::Plan;

/// Least difference of ln densities that tells two models apart, however small its error.
const LEAST_NATS: f64 = 4.0;
/// Least difference that tells two models apart, in standard errors.
const LEAST_ERRORS: f64 = 2.0;

/// Draws the chains of a folder, for the model of a title; `None` if it was stopped.
pub type Sampler<'a> = dyn Fn(&Folder<'_>, &str) -> Result<Option<Chains>, CalibrationError> + Sync + 'a;

/// Models of the same data.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// The model of the plan first, then in its order.
    pub models: Vec<ModelScore>,
}

/// How well a model predicts what was left out.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ModelScore {
    /// Its name; none for the model of the plan.
    pub title: Option<String>,
    /// Sum of the ln densities of all that was left out.
    pub log_density: f64,
    /// Of the best of the models less its own.
    pub behind: f64,
    /// Standard error of that: from one group to the next, and by the number of draws.
    pub error: f64,
    /// Whether it predicts worse than the best beyond doubt: by more than two standard errors and 4 nats.
    pub is_worse: bool,
    /// What was left out, one after the other.
    pub scores: Vec<Score>,
    /// Reasons that its chains give against a conclusion.
    pub doubts: usize,
}

impl Comparison {
    /// Compare the models of a plan by chains in folders beside its own. A group is left out of chains of their own where the weights of the draws
    /// cannot be trusted.
    ///
    /// # Errors
    /// Errors of the folders and of `sample`; [`CalibrationError::Plan`]. `None` if `sample` was stopped.
    pub fn of(
        plan: &Plan,
        chains: &Chains,
        folder: &Path,
        restart: bool,
        sample: &Sampler<'_>,
    ) -> Result<Option<Self>, CalibrationError> {
        let folder = folder.join(MODELS);
        let groups = plan.groups()?;
        let mut models = Vec::new();
        for (number, model) in std::iter::once(plan).chain(&plan.models).enumerate() {
            let title = number.checked_sub(1).map(|it| &*plan.file.compare[it].title);
            let draw = |plan: &Plan, name: String| {
                let folder = Folder::begin(plan, &folder.join(name), restart)?;
                sample(&folder, title.unwrap_or_default())
            };
            let own = match title {
                None => None,
                Some(_) => match draw(model, number.to_string())? {
                    None => return Ok(None),
                    own => own,
                },
            };
            let chains = own.as_ref().unwrap_or(chains);
            let mut doubts = chains.summary(model).doubts().len();
            let mut scores = scores_of(model, chains, &groups, false)?;
            for (place, (block, group)) in groups.iter().enumerate() {
                if scores[place].is_told {
                    continue;
                }
                let without = model.without(*block, group.held)?;
                let Some(chains) = draw(&without, format!("{number}-without-{place}"))? else {
                    return Ok(None);
                };
                doubts += chains.summary(&without).doubts().len();
                // The densities are those of the whole data given the rest, over draws of the rest.
                let own = &groups[place..=place];
                scores[place] = scores_of(model, &chains, own, true)?.remove(0);
            }
            models.push(ModelScore {
                title: title.map(str::to_owned),
                log_density: scores.iter().map(|it| it.log_density).sum(),
                behind: 0.0,
                error: 0.0,
                is_worse: false,
                scores,
                doubts,
            });
        }
        Ok(Some(Self::judged(models)))
    }

    /// With differences and verdicts.
    fn judged(mut models: Vec<ModelScore>) -> Self {
        let best = models.iter().max_by(|one, other| one.log_density.total_cmp(&other.log_density));
        let best = best.cloned();
        for model in &mut models {
            let Some(best) = best.as_ref().filter(|best| best.title != model.title) else {
                continue;
            };
            let pairs = || best.scores.iter().zip(&model.scores);
            let count = model.scores.len() as f64;
            let behind = best.log_density - model.log_density;
            let beside = pairs().map(|(best, own)| (best.log_density - own.log_density - behind / count).powi(2));
            let between = match count > 1.0 {
                true => beside.sum::<f64>() * count / (count - 1.0),
                false => 0.0,
            };
            let of_draws: f64 = pairs().map(|(best, own)| best.error.powi(2) + own.error.powi(2)).sum();
            let error = (between + of_draws).sqrt();
            model.behind = behind;
            model.error = error;
            model.is_worse = behind > LEAST_NATS && behind > LEAST_ERRORS * error;
        }
        Self { models }
    }

    /// Data that were left out, and how many of them lie within the bands of 50 and 90 % of a model.
    pub fn coverage(model: &ModelScore) -> [usize; 3] {
        let sum = |of: fn(&Score) -> usize| model.scores.iter().map(of).sum();
        [sum(|it| it.count), sum(|it| it.inside_50), sum(|it| it.inside_90)]
    }
}

fn scores_of(
    plan: &Plan,
    chains: &Chains,
    groups: &[(usize, Group)],
    is_drawn_without: bool,
) -> Result<Vec<Score>, CalibrationError> {
    let given = given_rest(plan, chains, groups)?;
    let scores = groups.iter().enumerate().map(|(place, (block, group))| {
        let own: Vec<&Conditional> = given.iter().map(|of_draw| &of_draw[place]).collect();
        let name = plan.posterior.blocks[*block].names.join(" + ");
        Score::of((name, group.held), &own, chains.draws.len(), is_drawn_without)
    });
    Ok(scores.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chain::Chain;
    use crate::conjugate::U1;
    use crate::data::Held;
    use crate::draw::Draw;
    use rayon::prelude::*;

    fn model(title: &str, logs: &[f64], error: f64) -> ModelScore {
        let score = |log: &f64| Score {
            data: "levels".to_owned(),
            held_out: Held::All,
            log_density: *log,
            error,
            shape: Some(0.1),
            is_told: true,
            count: 8,
            inside_50: 4,
            inside_90: 7,
        };
        ModelScore {
            title: Some(title.to_owned()),
            log_density: logs.iter().sum(),
            behind: 0.0,
            error: 0.0,
            is_worse: false,
            scores: logs.iter().map(score).collect(),
            doubts: 0,
        }
    }

    /// Two errors and 4 nats are needed: 3 nats without any spread, 6 nats with a spread of 4, and one date whose 1.6 nats say
    /// nothing; 9 nats of even differences are told.
    #[test]
    fn models_are_told_apart_by_errors_and_nats() {
        let judged = |one: &[f64], other: &[f64], error: f64| {
            let models = vec![model("a", one, error), model("b", other, error)];
            Comparison::judged(models).models.remove(1)
        };
        let even = judged(&[0.0; 3], &[-3.0, -3.1, -2.9], 0.0);
        assert!((even.behind - 9.0).abs() < 1e-12);
        assert!((even.error - 3f64.sqrt() * 0.1).abs() < 1e-12);
        assert!(even.is_worse);
        assert!(!judged(&[0.0; 3], &[-1.0; 3], 0.0).is_worse);
        let spread = judged(&[0.0; 3], &[-6.0, -4.0, 4.0], 0.0);
        assert!((spread.error - (3.0 * 28.0f64).sqrt()).abs() < 1e-12);
        assert!(!spread.is_worse);
        assert!(!judged(&[-7.1], &[-8.7], 0.1).is_worse);
        // An error of draws alone: 5 nats behind, 3 of error.
        let drawn = judged(&[-7.0], &[-12.0], 3.0 / 2f64.sqrt());
        assert!((drawn.error - 3.0).abs() < 1e-12);
        assert!(!drawn.is_worse);
    }

    /// U1 by our own chains: a date whose weights can be trusted has the closed form by weights, and all have it by draws without
    /// them.
    #[test]
    fn dates_that_are_left_out_have_their_closed_form() {
        let u1 = U1::read();
        let expected = u1.numbers("/log_predictive_leaving_out_a_date");
        let draws = |dates: &[usize]| {
            let posterior = u1.posterior(dates);
            let chain = |index: u64| {
                let mut chain = Chain::begin(&posterior, 3, index, 300).unwrap();
                let draws = (0..2300).map(|_| chain.draw(&posterior));
                draws.skip(300).collect::<Vec<Draw>>()
            };
            (0..2u64).into_par_iter().map(chain).collect::<Vec<_>>()
        };
        let score = |dates: &[usize], left_out: usize| {
            let given: Vec<Conditional> =
                draws(dates).iter().flatten().map(|draw| u1.given_rest(1.0 + draw.place[0], left_out)).collect();
            let held = ("levels".to_owned(), Held::Date(0.0));
            let is_drawn_without = dates.len() < 3;
            Score::of(held, &given.iter().collect::<Vec<_>>(), 2, is_drawn_without)
        };
        for (date, expected) in expected.into_iter().enumerate() {
            let others: Vec<usize> = (0..3).filter(|it| *it != date).collect();
            let without = score(&others, date);
            assert!((without.log_density - expected).abs() < 0.1, "{without:?}");
            assert!((without.log_density - expected).abs() < 4.0 * without.error);
            let weighted = score(&[0, 1, 2], date);
            // What is not told is drawn without the date, as above.
            if weighted.is_told {
                assert!((weighted.log_density - expected).abs() < 0.1, "{weighted:?}");
                assert!((weighted.log_density - expected).abs() < 4.0 * weighted.error);
            }
            assert_eq!((without.count, without.inside_90), (3, 3));
        }
    }
}
