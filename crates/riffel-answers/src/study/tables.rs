//! What matters in a study, as tables.

use riffel_keys::{Message, number, say};
use riffel_study::sensitivity::{Estimate, ParameterIndices, SobolIndices};
use riffel_study::{Parameter, ParameterValue};

use super::{Analysis, SensitivityAnswer, four_figures};
use crate::number_alone;
use crate::{Column, Rows, Table};

/// Sobol indices of an output with their intervals.
pub(super) fn indices(answer: &SensitivityAnswer, analysis: &Analysis, indices: &SobolIndices) -> Table {
    let keys = answer.study.parameters().iter().map(|parameter| Message::verbatim(&parameter.key.key));
    let percent = format!("{:.4}", 100.0 * answer.confidence).replace(".0000", "");
    let rows = &indices.parameters;
    let values = |head, of: fn(&ParameterIndices) -> Estimate| rows.digits(head, 3, |it| of(it).value);
    let three = |value: f64| number(format!("{value:.3}"));
    let intervals = |of: fn(&ParameterIndices) -> Estimate| {
        rows.shown(say!(interval_column, percent = number(&percent)), |it| {
            let Estimate { low, high, .. } = of(it);
            say!(from_to, from = three(low), to = three(high))
        })
    };
    Table {
        name: "sobol-indices",
        columns: vec![
            Column::shown(Message::verbatim(&analysis.name), keys.collect()),
            values(say!(first_order_column), |it| it.first),
            intervals(|it| it.first),
            values(say!(total_column), |it| it.total),
            intervals(|it| it.total),
        ],
    }
}

/// An output with each parameter alone from its low to its high quantile.
pub(super) fn tornado(answer: &SensitivityAnswer, analysis: &Analysis) -> Table {
    let rows: Vec<_> = answer.study.parameters().iter().zip(&answer.tornado.swings).collect();
    let values = |head, end: usize| rows.shown(head, |(parameter, swing)| value(parameter, &swing.values[end]));
    let outputs = |percent: u8, end: usize| {
        rows.shown(say!(at_percent, percent = number(percent)), |(_, swing)| at(analysis, &swing.outputs[end]))
    };
    Table {
        name: "tornado",
        columns: vec![
            rows.shown(say!(parameter_alone, output = analysis.name.as_str()), |(parameter, _)| {
                Message::verbatim(&parameter.key.key)
            }),
            values(number_alone("10 %"), 0),
            values(number_alone("90 %"), 1),
            outputs(10, 0),
            outputs(90, 1),
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

/// Value of a parameter as a message.
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
