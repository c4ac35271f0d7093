//! Searches along one axis for the place where something changes.

use std::convert::Infallible;

/// The ends of the bracket in which `is_beyond` changes from false at `ends[0]` to true at `ends[1]`; the first may be the
/// higher of the two. Neither end is asked.
///
/// Method: bisection. Stopping rule: the bracket is no longer than the absolute `tolerance`, or no number is left inside it;
/// a hundred halvings, 8·10⁻³¹ of the first bracket, end a search for zero itself. With several changes inside it finds one of
/// them. Cost: one call a halving, some 53 for a tolerance of zero.
pub fn bisection(ends: [f64; 2], tolerance: f64, mut is_beyond: impl FnMut(f64) -> bool) -> [f64; 2] {
    let Ok(found) = fallible_bisection(ends, tolerance, |place| Ok::<_, Infallible>(is_beyond(place)));
    found
}

/// [`bisection`] with a question that may fail.
///
/// # Errors
/// The first error of `is_beyond`.
pub fn fallible_bisection<E>(
    [mut before, mut beyond]: [f64; 2],
    tolerance: f64,
    mut is_beyond: impl FnMut(f64) -> Result<bool, E>,
) -> Result<[f64; 2], E> {
    const MOST_HALVINGS: usize = 100;
    for _ in 0..MOST_HALVINGS {
        let middle = 0.5 * (before + beyond);
        if (beyond - before).abs() <= tolerance || middle == before || middle == beyond {
            break;
        }
        match is_beyond(middle)? {
            true => beyond = middle,
            false => before = middle,
        }
    }
    Ok([before, beyond])
}
