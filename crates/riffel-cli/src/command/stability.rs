//! `riffel stability`

use riffel_answers::stability_map::StabilityMap;

use super::roughness::with_progress;
use crate::arguments::Stability;
use crate::results::Results;

pub(crate) fn run(arguments: &Stability) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let friction = match arguments.friction.is_empty() {
        true => StabilityMap::frictions(),
        false => arguments.friction.iter().map(|value| value.si()).collect(),
    };
    let answer = with_progress(riffel_keys::say!(progress_stability), friction.len(), |advance| {
        StabilityMap::new(&case, &friction, advance)
    })?;
    Results::of("stability", &arguments.case, &arguments.results).answer(&answer)?;
    Ok(())
}
