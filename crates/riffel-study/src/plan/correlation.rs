//! The correlations of a plan, checked.

use riffel_keys::{CaseError, KeyFile};

use super::Plan;
use super::file::{Method, PlanFile};
use crate::correlation::GaussianCopula;
use crate::parameter::Parameter;

impl Plan {
    pub(super) fn copula(
        source: &KeyFile,
        file: &PlanFile,
        parameters: &[Parameter],
    ) -> Result<Option<GaussianCopula>, CaseError> {
        if file.correlation.is_empty() {
            return Ok(None);
        }
        let method = file.design.method;
        if matches!(method, Method::Grid | Method::Saltelli) {
            let why = match method {
                Method::Grid => "a grid takes every combination of its values",
                _ => "Sobol indices are those of independent parameters",
            };
            return Err(source.invalid(
                "correlation[0]",
                format!("and design.method = \"{}\" exclude each other: {why}", method.name()),
                "choose sobol, latin-hypercube or random, or leave the correlation out",
            ));
        }
        let mut pairs: Vec<([usize; 2], f64)> = Vec::new();
        for (index, written) in file.correlation.iter().enumerate() {
            let place = format!("correlation[{index}]");
            let mut pair = [0; 2];
            for (slot, key) in pair.iter_mut().zip(&written.between) {
                let between = format!("{place}.between");
                *slot = parameters.iter().position(|parameter| parameter.key.key == *key).ok_or_else(|| {
                    let rule = format!("names \"{key}\", which is not the key of a parameter");
                    source.invalid(&between, &rule, "")
                })?;
                if parameters[*slot].levels().is_some() {
                    let rule = format!("names \"{key}\", but only parameters with a distribution vary together");
                    return Err(source.invalid(&between, &rule, ""));
                }
            }
            if pair[0] == pair[1] {
                let rule = "names the same key twice";
                return Err(source.invalid(&format!("{place}.between"), rule, ""));
            }
            let known = |(other, _): &([usize; 2], f64)| *other == pair || *other == [pair[1], pair[0]];
            if pairs.iter().any(known) {
                let rule = "names a pair a second time";
                return Err(source.invalid(&format!("{place}.between"), rule, ""));
            }
            let coefficient = written.coefficient;
            if !(coefficient > -1.0 && coefficient < 1.0) {
                let rule = format!("is {coefficient}, but must be between -1 and 1, both excluded");
                return Err(source.invalid(&format!("{place}.coefficient"), &rule, ""));
            }
            pairs.push((pair, coefficient));
        }
        let copula = GaussianCopula::new(parameters.len(), &pairs).ok_or_else(|| {
            source.invalid(
                "correlation",
                "no parameters can be correlated like this: the matrix of the coefficients is not positive definite",
                "pairs left out are not correlated; lower the coefficients, or give those of the other pairs",
            )
        })?;
        Ok(Some(copula))
    }
}
