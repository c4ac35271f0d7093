//! Which model of a plan predicts best what was left out.

use riffel_calibrate::{CalibrationError, Chains, Comparison, Held, ModelScore, Plan, Sampler, Score};
use riffel_keys::{CaseError, Message, Value, fixed, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Series};
use serde::Serialize;

use crate::{Answer, Rows, Table};

/// The models of a plan by what they predict.
#[derive(Serialize)]
pub struct CompetingModels {
    riffel_version: &'static str,
    title: Option<String>,
    #[serde(flatten)]
    comparison: Comparison,
    remarks: Vec<Message>,
}

impl CompetingModels {
    /// Compare the models of a plan, whose chains go to a folder beside those of the plan; `None` if `sample` was stopped.
    ///
    /// # Errors
    /// Errors of [`Comparison::of`].
    pub fn new(
        plan: &Plan,
        chains: &Chains,
        (folder, restart): (&std::path::Path, bool),
        sample: &Sampler<'_>,
    ) -> Result<Option<Self>, CalibrationError> {
        let found = Comparison::of(plan, chains, folder, restart, sample)?;
        Ok(found.map(|comparison| Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            title: plan.file.title.clone(),
            remarks: remarks(&comparison),
            comparison,
        }))
    }

    fn best(&self) -> Option<&ModelScore> {
        let models = self.comparison.models.iter();
        models.max_by(|one, other| one.log_density.total_cmp(&other.log_density))
    }

    /// The best is one that all others are told apart from.
    fn verdict(&self, model: &ModelScore) -> Message {
        let models = &self.comparison.models;
        let not_worse = models.iter().filter(|other| !other.is_worse).count();
        match (models.len(), model.is_worse) {
            (1, _) => Message::verbatim("–"),
            (_, true) => say!(verdict_worse),
            (_, false) if not_worse == 1 => say!(verdict_best),
            (_, false) => say!(verdict_not_told_apart),
        }
    }

    /// Each model with its score.
    fn by_model(&self) -> Table {
        let models = &self.comparison.models;
        let share = |name: &str, head, place: usize| {
            models.fixed(name, head, 0, |model| {
                let counts = Comparison::coverage(model);
                (counts[0] > 0).then(|| 100.0 * counts[place] as f64 / counts[0] as f64)
            })
        };
        Table {
            name: "models",
            columns: vec![
                models.words("model", say!(model_column), name),
                models.fixed("log_density", say!(log_density), 2, |model| model.log_density),
                models.fixed("behind", say!(behind_the_best), 2, |it| it.behind),
                models.fixed("standard_error", say!(error_of_behind), 2, |it| it.error),
                models.words("verdict", say!(verdict_on_model), |model| self.verdict(model)),
                share("inside_50_percent", say!(inside_50_percent), 1),
                share("inside_90_percent", say!(inside_90_percent), 2),
            ],
        }
    }

    /// Each model with what was left out.
    fn by_group(&self) -> Table {
        let models = self.comparison.models.iter();
        let rows: Vec<_> = models.flat_map(|model| model.scores.iter().map(move |score| (model, score))).collect();
        Table {
            name: "left_out",
            columns: vec![
                rows.words("model", say!(model_column), |(model, _)| name(model)),
                rows.words("left_out", say!(left_out_column), |(_, score)| left_out(score)),
                rows.fixed("log_density", say!(log_density), 2, |(_, it)| it.log_density),
                rows.fixed("standard_error_of_draws", say!(error_of_behind), 2, |(_, it)| it.error),
                rows.fixed("k_hat", say!(shape_of_weights), 2, |(_, it)| it.shape),
                rows.fixed("data", say!(data_left_out), 0, |(_, it)| it.count as f64),
                rows.fixed("inside_50", say!(inside_50), 0, |(_, it)| it.inside_50 as f64),
                rows.fixed("inside_90", say!(inside_90), 0, |(_, it)| it.inside_90 as f64),
            ],
        }
    }
}

fn name(model: &ModelScore) -> Message {
    titled(model.title.as_deref())
}

fn titled(title: Option<&str>) -> Message {
    match title {
        None => say!(model_of_the_plan),
        Some(title) => Message::verbatim(title),
    }
}

/// The models of a plan that compares some, and what it will leave out of the data.
///
/// # Errors
/// [`CaseError`] where nothing can be left out.
pub fn what_is_compared(plan: &Plan) -> Result<Vec<Message>, CaseError> {
    if !plan.compares() {
        return Ok(Vec::new());
    }
    let others = plan.file.compare.iter().map(|other| Some(&*other.title));
    let models = [None].into_iter().chain(others).map(titled);
    let held = plan.left_out_of_data()?.into_iter();
    let held = held.map(|(data, held)| held_out(&data, held));
    let list = |messages: Vec<Message>| Value::List(messages.into_iter().map(Value::from).collect());
    Ok(vec![
        say!(all_models_see, models = list(models.collect())),
        say!(left_out_to_compare, held = list(held.collect())),
    ])
}

fn left_out(score: &Score) -> Message {
    held_out(&score.data, score.held_out)
}

/// What is left out of data with some names.
fn held_out(data: &str, held: Held) -> Message {
    match held {
        Held::All => Message::verbatim(data),
        Held::Date(passages) => say!(left_out_date, data, passages = fixed(passages, 0)),
        Held::Place(place) => say!(left_out_place, data, place = fixed(place, 3)),
    }
}

fn remarks(comparison: &Comparison) -> Vec<Message> {
    let mut remarks = Vec::new();
    if let [score] = &comparison.models[0].scores[..] {
        remarks.push(say!(one_group_left_out, held = left_out(score)));
    }
    for model in &comparison.models {
        if model.doubts > 0 {
            remarks.push(say!(models_on_doubtful_chains, model = name(model), doubts = model.doubts));
        }
    }
    remarks
}

impl Answer for CompetingModels {
    fn name(&self) -> &'static str {
        "models"
    }

    fn document_name(&self) -> &'static str {
        "models.json"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![say!(models_by_what_they_predict)]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.by_model(), self.by_group()]
    }

    fn sentences(&self) -> Vec<Message> {
        let Some(best) = self.best() else {
            return Vec::new();
        };
        let others = self.comparison.models.iter();
        let others = others.filter(|model| model.title != best.title);
        let sentence = |model: &ModelScore| {
            let (behind, error) = (fixed(model.behind, 1), fixed(model.error, 1));
            match model.is_worse {
                true => {
                    say!(model_predicts_worse, model = name(model), best = name(best), behind, error)
                }
                false => {
                    say!(model_not_told_apart, model = name(model), best = name(best), behind, error)
                }
            }
        };
        others.map(sentence).collect()
    }

    fn figure(&self) -> LineFigure {
        let text = |message: Message| message.text(riffel_keys::Language::English);
        let series = self.comparison.models.iter().map(|model| {
            Series::new(
                text(name(model)),
                (1..=model.scores.len()).map(|number| number as f64).collect(),
                model.scores.iter().map(|score| score.log_density).collect(),
            )
            .styled(LineStyle::Markers)
        });
        let groups = self.comparison.models[0].scores.iter().enumerate();
        let groups = groups.map(|(place, score)| format!("{} {}", place + 1, text(left_out(score))));
        let groups: Vec<String> = groups.collect();
        LineFigure::new(
            self.title.clone().unwrap_or_else(|| "Models".to_owned()),
            format!("ln of the density that each model gives to what was left out: {}.", groups.join("; ")),
            [LinePanel {
                x_range: Some((0.5, groups.len() as f64 + 0.5)),
                ..LinePanel::new("left out, by its number", "ln density", series)
            }],
        )
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A lead of 0.01 makes no winner; one that all others are told apart from is the best.
    #[test]
    fn the_best_is_told_apart_from_all_others() {
        let model = |behind: f64, is_worse: bool| ModelScore {
            title: None,
            log_density: -behind,
            behind,
            error: 0.1,
            is_worse,
            scores: Vec::new(),
            doubts: 0,
        };
        let verdicts = |models: Vec<ModelScore>| {
            let answer = CompetingModels {
                riffel_version: "",
                title: None,
                comparison: Comparison { models },
                remarks: Vec::new(),
            };
            let models = answer.comparison.models.iter();
            let verdicts = models.map(|model| answer.verdict(model).to_string());
            verdicts.collect::<Vec<String>>()
        };
        let (first, close, far) = (model(0.0, false), model(0.01, false), model(9.0, true));
        let found = verdicts(vec![close, first.clone(), far.clone()]);
        assert_eq!(found, ["not told apart", "not told apart", "worse"]);
        assert_eq!(verdicts(vec![far, first.clone()]), ["worse", "best"]);
        assert_eq!(verdicts(vec![first]), ["–"]);
    }
}
