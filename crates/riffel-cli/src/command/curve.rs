//! `riffel curve`

use riffel_answers::curve::CurveAnswer;
use riffel_case::CurvingCase;

use crate::arguments::Curve;
use crate::error::CliError;
use crate::results::Results;

pub(crate) fn run(arguments: &Curve) -> miette::Result<()> {
    let case = arguments.case.read_curving()?;
    let radii = radii(arguments, &case)?;
    let answer = CurveAnswer::new(&case, radii.as_deref())?;
    Ok(Results::of("curve", &arguments.case, &arguments.results).answer(&answer)?)
}

/// The radii that are listed \[m\]; none where none are.
fn radii(arguments: &Curve, case: &CurvingCase) -> miette::Result<Option<Vec<f64>>> {
    let listed: Vec<f64> = arguments.radius.iter().map(|radius| radius.length.si()).collect();
    let bare = arguments.radius.iter().find(|radius| radius.is_bare);
    let with_unit = arguments.radius.iter().find(|radius| !radius.is_bare);
    if let (Some(bare), Some(_)) = (bare, with_unit) {
        Err(CliError::Argument {
            argument: "--radius",
            value: format!("{} without a unit beside others with one", bare.length.si()),
            rule: "a list whose items all have a unit or none; commas part the items, so that 3,800 m are two"
                .to_owned(),
        })?;
    }
    if let Some((radius, rule)) = case.radius_that_no_curve_has(&listed) {
        Err(CliError::Argument { argument: "--radius", value: format!("{radius} m"), rule })?;
    }
    Ok((!listed.is_empty()).then_some(listed))
}
