//! A case on discrete supports with the wheel passing them, and on supports that were not laid at equal distances.

use riffel::Loop;
use riffel::growth::{GrowthOnIrregularSupports, GrowthWithNeighbours};
use riffel::receptance::{Beam, IrregularTrack, MovingLoadOnSupports};
use riffel_keys::{CaseError, say};

use crate::Case;

/// A stretch of supports at distances that are drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DrawnSupports {
    /// Standard deviation of the distance \[m\].
    pub deviation: f64,
    /// How many, 8 to 200.
    pub supports: usize,
    /// Of the draw.
    pub seed: u64,
}

impl DrawnSupports {
    /// How many may be drawn.
    const SUPPORTS: std::ops::RangeInclusive<usize> =
        GrowthOnIrregularSupports::LEAST_SUPPORTS..=IrregularTrack::<Beam>::MOST_SUPPORTS;

    /// Supports of a stretch that leave a mean of the growth rate some per cent of its scatter along the track.
    pub const USUAL_SUPPORTS: usize = 60;
}

/// Growth of a wave \[m\] at a speed \[m/s\] together with so many neighbours on each side, 1/λ ± n/d, which the passing of
/// supports makes of it.
///
/// # Errors
/// [`CaseError`] for a case without discrete supports, for a loop on all axes or of several wheels, and for more
/// neighbours than have a wavelength.
pub fn growth_with_neighbours(
    case: &Case,
    wavelength: f64,
    speed: f64,
    neighbours: usize,
) -> Result<GrowthWithNeighbours, CaseError> {
    let feedback = on_supports(case, "growth with neighbours")?;
    let track = moving_load_on_supports(case, speed)?;
    GrowthWithNeighbours::at(feedback, &track, wavelength, neighbours)
        .map_err(|error| CaseError::Physics { input: "--neighbours".to_owned(), error })
}

/// Growth of a wave \[m\] at a speed \[m/s\] along a stretch of supports whose distances are drawn.
///
/// # Errors
/// [`CaseError`] for a case without discrete supports, for a loop on all axes or of several wheels, and for what
/// [`IrregularTrack::drawn`] and [`GrowthOnIrregularSupports::new`] refuse.
pub fn growth_on_irregular_supports(
    case: &Case,
    wavelength: f64,
    speed: f64,
    drawn: DrawnSupports,
) -> Result<GrowthOnIrregularSupports, CaseError> {
    let feedback = on_supports(case, "growth on irregular supports")?;
    let physics = |input: &str, error| CaseError::Physics { input: input.to_owned(), error };
    let DrawnSupports { deviation, supports, seed } = drawn;
    if !DrawnSupports::SUPPORTS.contains(&supports) {
        return Err(physics(
            "--supports",
            riffel::Error::OutOfRange {
                quantity: "number of supports of the stretch",
                value: supports as f64,
                unit: "",
                rule: "must be between 8 and 200",
            },
        ));
    }
    let track = IrregularTrack::drawn(case.keys.periodic_track()?, deviation, supports, seed)
        .map_err(|error| physics("--spacing-deviation", error))?;
    GrowthOnIrregularSupports::new(feedback, &track, wavelength, speed).map_err(|error| physics("--supports", error))
}

/// The loop of one wheel along one axis on discrete supports, which alone has `what`.
fn on_supports<'a>(case: &'a Case, what: &str) -> Result<&'a Loop, CaseError> {
    if !case.feedback.is_along_one_axis() {
        let message = say!(takes_one_wheel_of_wheel_with, what);
        return Err(case.refuse("contact.creepage", &message));
    }
    if case.track.support_spacing().is_none() {
        let message = say!(track_model_is_but_is_of, model = case.file.track.model.name(), what);
        return Err(case.refuse("track.model", &message));
    }
    Ok(&case.feedback)
}

/// The vertical track of a case with discrete supports, under a load that passes them.
pub(crate) fn moving_load_on_supports(case: &Case, speed: f64) -> Result<MovingLoadOnSupports, CaseError> {
    let track = case.keys.periodic_track()?;
    let moving = MovingLoadOnSupports::new(&track, speed);
    case.keys.physics("track", moving)
}
