//! The design of a plan, checked.

use std::fmt::Write as _;

use riffel_keys::{CaseError, KeyFile};

use super::Plan;
use super::file::{Method, PlanFile};
use crate::design::{Design, Grid, LatinHypercube, Random, Saltelli, Sobol};
use crate::parameter::Parameter;

/// Most samples of a study.
const MOST_SAMPLES: u64 = 100_000_000;

impl Plan {
    pub(super) fn design(source: &KeyFile, file: &PlanFile, parameters: &[Parameter]) -> Result<Design, CaseError> {
        let method = file.design.method;
        let count = parameters.len();
        if method == Method::Grid {
            if file.design.samples.is_some() {
                return Err(source.invalid(
                    "design.samples",
                    "is given, but a grid has as many samples as its parameters have combinations",
                    "leave it out",
                ));
            }
            return Self::grid(source, file, parameters);
        }
        let Some(samples) = file.design.samples else {
            let help = format!("design.method = \"{}\" needs it", method.name());
            return Err(source.missing("design.samples", &help));
        };
        if samples == 0 {
            return Err(source.invalid("design.samples", "is 0, but must be at least 1", ""));
        }
        let rows = match method {
            Method::Saltelli => count as u64 + 2,
            _ => 1,
        };
        let total = samples.saturating_mul(rows);
        if total > MOST_SAMPLES {
            let what = match method {
                Method::Saltelli => format!("{samples} times {rows} samples are"),
                _ => format!("is {samples}: they are"),
            };
            return Err(source.invalid(
                "design.samples",
                format!("{what} more than the {MOST_SAMPLES} of the largest study"),
                "the error of a mean falls with the root of their number: take fewer",
            ));
        }
        let most = match method {
            Method::Sobol => Sobol::MOST_DIMENSIONS,
            Method::Saltelli => Saltelli::MOST_PARAMETERS,
            _ => usize::MAX,
        };
        if count > most {
            let rule = format!("is \"{}\", which reaches {most} parameters, but there are {count}", method.name());
            return Err(source.invalid("design.method", &rule, "choose latin-hypercube or random"));
        }
        let seed = file.design.seed;
        Ok(match method {
            Method::Grid | Method::Random => Design::Random(Random::new(samples, count, seed)),
            Method::LatinHypercube => Design::LatinHypercube(LatinHypercube::new(samples, count, seed)),
            Method::Sobol => Design::Sobol(Sobol::new(samples, count, seed)),
            Method::Saltelli => Design::Saltelli(Saltelli::new(samples, count, seed)),
        })
    }

    fn grid(source: &KeyFile, file: &PlanFile, parameters: &[Parameter]) -> Result<Design, CaseError> {
        let mut levels = Vec::new();
        for (index, parameter) in parameters.iter().enumerate() {
            let Some(count) = parameter.levels() else {
                return Err(source.invalid(
                    &format!("parameter[{index}]"),
                    format!("`{}` has a distribution, but a grid takes values or a range", parameter.key.key),
                    "write values or range, or choose design.method = \"sobol\" or \"latin-hypercube\"",
                ));
            };
            levels.push(count as u64);
        }
        let total = levels.iter().map(|&count| u128::from(count)).product::<u128>();
        if total > u128::from(MOST_SAMPLES) {
            let mut factors = String::new();
            for (index, (written, count)) in file.parameter.iter().zip(&levels).enumerate() {
                let sign = if index == 0 { "" } else { " × " };
                // Writing to a string does not fail.
                let _ = write!(factors, "{sign}{count} of {}", written.key);
            }
            return Err(source.invalid(
                "parameter",
                format!(
                    "{factors} make a grid of {} samples, more than the {MOST_SAMPLES} of the largest study",
                    in_figures(total)
                ),
                "take fewer values, or draw samples instead: design.method = \"sobol\" with some thousand of them",
            ));
        }
        Ok(Design::Grid(Grid::new(levels)))
    }
}

/// A large number in groups of three figures.
fn in_figures(number: u128) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}
