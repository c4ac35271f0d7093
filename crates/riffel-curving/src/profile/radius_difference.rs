//! Difference of the rolling radii of a wheelset over its lateral shift, as a table.

use super::{EquivalentConicity, ProfileError, WheelsetOnTrack};

/// Rolling radius difference of a wheelset without yaw at equal steps of its lateral shift, about the middle.
#[derive(Debug, Clone)]
pub struct RadiusDifference {
    step: f64,
    /// Row of the centred wheelset.
    middle: usize,
    /// \[m\].
    rows: Vec<f64>,
    rolling_radius: f64,
}

impl RadiusDifference {
    /// That of a wheelset which rolls about its own length so that both wheels touch; its right wheel has this radius
    /// \[m\]. Up to a lateral shift \[m\] to either side, every `step` \[m\]; it ends where a wheel leaves its rail before.
    ///
    /// Cost: some 0.1 ms a step, shared by all threads.
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where the centred wheelset does not touch both rails.
    pub fn rolling(
        wheelset: &WheelsetOnTrack,
        rolling_radius: f64,
        farthest: f64,
        step: f64,
    ) -> Result<Self, ProfileError> {
        let places: Vec<(f64, f64)> = shifts(farthest, step).map(|shift| (shift, 0.0)).collect();
        let rows = wheelset.contacts(&places).into_iter();
        let rows = rows.map(|contact| Ok(contact?.rolling_radius_difference()));
        Self::of(rows.collect(), rolling_radius, step)
    }

    /// That of EN 15302: the axle stays level, and each wheel touches where it comes nearest to its rail by itself. On
    /// flanks the two differ, for there the roll of the axle moves the contacts. Arguments, cost and errors are those of
    /// [`rolling`](Self::rolling).
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where the centred wheelset does not touch both rails.
    pub fn level(
        wheelset: &WheelsetOnTrack,
        rolling_radius: f64,
        farthest: f64,
        step: f64,
    ) -> Result<Self, ProfileError> {
        let rows = shifts(farthest, step).map(|shift| wheelset.level_radius_difference(shift));
        Self::of(rows.collect(), rolling_radius, step)
    }

    fn of(rows: Vec<Result<f64, ProfileError>>, rolling_radius: f64, step: f64) -> Result<Self, ProfileError> {
        let (rows, middle) = around_middle(rows)?;
        Ok(Self { step, middle, rows, rolling_radius })
    }

    /// Right less left \[m\], linear between rows; that of the nearest row outside them.
    pub fn at(&self, lateral_shift: f64) -> f64 {
        let place = lateral_shift / self.step + self.middle as f64;
        let last = self.rows.len() - 1;
        let place = place.clamp(0.0, last as f64);
        let index = (place as usize).min(last.saturating_sub(1));
        let (one, other) = (self.rows[index], self.rows[(index + 1).min(last)]);
        one + (place - index as f64) * (other - one)
    }

    /// Equivalent conicity at an amplitude \[m\]; `None` if no motion of the table swings so far.
    pub fn equivalent_conicity(&self, amplitude: f64, contact_spacing: f64) -> Option<EquivalentConicity> {
        let rows_behind = self.rows.len() - 1 - self.middle;
        let range = [-self.step * self.middle as f64, self.step * rows_behind as f64];
        EquivalentConicity::at(|shift| self.at(shift), range, amplitude, contact_spacing, self.rolling_radius)
    }
}

/// From the left to the right \[m\].
fn shifts(farthest: f64, step: f64) -> impl Iterator<Item = f64> {
    let count = (farthest / step).round() as i32;
    (-count..=count).map(move |place| step * f64::from(place))
}

/// Rows about the one in the middle, as far as a wheel is on its rail, and the place of that one among them.
///
/// # Errors
/// That of the row in the middle.
pub(super) fn around_middle<T>(rows: Vec<Result<T, ProfileError>>) -> Result<(Vec<T>, usize), ProfileError> {
    let centre = rows.len() / 2;
    if let Err(error) = &rows[centre] {
        return Err(error.clone());
    }
    let from = (0..centre).rev().find(|&row| rows[row].is_err()).map_or(0, |row| row + 1);
    let rows = rows.into_iter().skip(from).map_while(Result::ok).collect();
    Ok((rows, centre - from))
}
