//! `riffel wheelset`

use riffel_answers::receptance::ReceptanceCurves;
use riffel_answers::wheelset::{HIGHEST, WheelsetAnswer};

use super::receptance::within;
use crate::arguments::Wheelset;
use crate::results::Results;

/// Frequencies of the receptances where none are listed: the lowest \[Hz\], and how many.
const USUAL: (f64, u32) = (20.0, 600);

pub(crate) fn run(arguments: &Wheelset) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let frequencies = match &arguments.frequencies[..] {
        [] => {
            let wheelset = case.wheelset.as_ref();
            let (lowest, highest) = wheelset.map_or((0.0, f64::INFINITY), |wheelset| wheelset.frequency_range());
            ReceptanceCurves::frequencies(USUAL.0.max(lowest), HIGHEST.min(highest), USUAL.1)
        }
        listed => within("--frequencies", listed)?,
    };
    let answer = WheelsetAnswer::new(&case, frequencies)?;
    Ok(Results::of("wheelset", &arguments.case, &arguments.results).answer(&answer)?)
}
