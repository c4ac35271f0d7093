//! What matters in a study, as tables.

use riffel_keys::{Message, number, say};
use riffel_study::sensitivity::{Estimate, SobolIndices};
use riffel_study::{Parameter, ParameterValue};

use super::{Analysis, SensitivityAnswer, four_figures};
use crate::number_alone;
use crate::{Column, Table};

/// Sobol indices of an output with their intervals.
pub(super) fn indices(answer: &SensitivityAnswer, analysis: &Analysis, indices: &SobolIndices) -> Table {
    let keys = answer.study.parameters().iter().map(|parameter| Message::verbatim(&parameter.key.key));
    let percent = format!("{:.4}", 100.0 * answer.confidence).replace(".0000", "");
    let three = |value: f64| number(format!("{value:.3}"));
    let values = |of: &dyn Fn(usize) -> Estimate| -> Vec<Message> {
        (0..indices.parameters.len()).map(|place| say!(number_alone, number = three(of(place).value))).collect()
    };
    let intervals = |of: &dyn Fn(usize) -> Estimate| -> Vec<Message> {
        let estimates = (0..indices.parameters.len()).map(of);
        estimates.map(|Estimate { low, high, .. }| say!(from_to, from = three(low), to = three(high))).collect()
    };
    let first = |place: usize| indices.parameters[place].first;
    let total = |place: usize| indices.parameters[place].total;
    let interval = || say!(interval_column, percent = number(&percent));
    Table {
        name: "sobol-indices",
        columns: vec![
            Column::shown(Message::verbatim(&analysis.name), keys.collect()),
            Column::shown(say!(first_order_column), values(&first)),
            Column::shown(interval(), intervals(&first)),
            Column::shown(say!(total_column), values(&total)),
            Column::shown(interval(), intervals(&total)),
        ],
    }
}

/// An output with each parameter alone from its low to its high quantile.
pub(super) fn tornado(answer: &SensitivityAnswer, analysis: &Analysis) -> Table {
    let rows = || answer.study.parameters().iter().zip(&answer.tornado.swings);
    let keys = rows().map(|(parameter, _)| Message::verbatim(&parameter.key.key));
    let values = |end: usize| -> Vec<Message> {
        rows().map(|(parameter, swing)| value(parameter, &swing.values[end])).collect()
    };
    let outputs = |end: usize| -> Vec<Message> { rows().map(|(_, swing)| at(analysis, &swing.outputs[end])).collect() };
    Table {
        name: "tornado",
        columns: vec![
            Column::shown(say!(parameter_alone, output = analysis.name.as_str()), keys.collect()),
            Column::shown(number_alone("10 %"), values(0)),
            Column::shown(number_alone("90 %"), values(1)),
            Column::shown(say!(at_percent, percent = number(10)), outputs(0)),
            Column::shown(say!(at_percent, percent = number(90)), outputs(1)),
        ],
    }
}

/// An output among those of a sample, if that has any.
pub(super) fn at(analysis: &Analysis, outputs: &Result<Vec<f64>, String>) -> Message {
    match outputs {
        Ok(values) => number_alone(four_figures(values[analysis.place])),
        Err(_) => say!(output_fails),
    }
}

/// The same as a message.
fn value(parameter: &Parameter, value: &ParameterValue) -> Message {
    match value {
        ParameterValue::Number(_) => number_alone(with_unit(parameter, value)),
        ParameterValue::Text(text) => Message::verbatim(text),
    }
}

/// A value of a parameter in the unit in which engineers write it.
pub(super) fn with_unit(parameter: &Parameter, value: &ParameterValue) -> String {
    match (value, parameter.key.quantity) {
        (ParameterValue::Number(number), Some(kind)) => {
            let (number, unit) = kind.in_engineers_unit(*number);
            format!("{} {unit}", four_figures(number)).trim_end().to_owned()
        }
        (value, _) => value.to_string(),
    }
}
