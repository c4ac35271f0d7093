//! Contact of a wheelset over its lateral shift, as a table.

use super::{EquivalentConicity, ProfileError, WheelsetContact, WheelsetOnTrack};

/// Contacts of a wheelset without yaw at equal steps of the lateral shift of its axle, about the middle.
#[derive(Debug, Clone)]
pub struct ContactTable {
    step: f64,
    /// Row of the centred wheelset.
    middle: usize,
    rows: Vec<WheelsetContact>,
    rolling_radius: f64,
}

impl ContactTable {
    /// The table of a wheelset whose right wheel has this radius \[m\], up to a lateral shift \[m\] to either side, every
    /// `step` \[m\]; it ends where a wheel leaves its rail before.
    ///
    /// Cost: some 0.1 ms a step, shared by all threads.
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where the centred wheelset does not touch both rails.
    pub fn new(
        wheelset: &WheelsetOnTrack,
        rolling_radius: f64,
        farthest: f64,
        step: f64,
    ) -> Result<Self, ProfileError> {
        let count = (farthest / step).round() as i32;
        let places: Vec<(f64, f64)> = (-count..=count)
            .map(|place| (step * f64::from(place), 0.0))
            .collect();
        let (rows, middle) = around_middle(wheelset.contacts(&places))?;
        Ok(Self {
            step,
            middle,
            rows,
            rolling_radius,
        })
    }

    /// The rows, from the left to the right.
    pub fn rows(&self) -> &[WheelsetContact] {
        &self.rows
    }

    /// Place of a shift among the rows.
    fn place(&self, lateral_shift: f64) -> Option<(usize, f64)> {
        let place = lateral_shift / self.step + self.middle as f64;
        let last = self.rows.len() - 1;
        if !(place >= 0.0 && place <= last as f64) {
            return None;
        }
        let index = (place as usize).min(last - 1);
        Some((index, place - index as f64))
    }

    /// Rolling radius difference, right less left \[m\], linear between rows; that of the nearest row outside them.
    pub fn rolling_radius_difference(&self, lateral_shift: f64) -> f64 {
        let difference = |row: usize| self.rows[row].rolling_radius_difference();
        match self.place(lateral_shift) {
            Some((index, share)) => {
                difference(index) + share * (difference(index + 1) - difference(index))
            }
            None if lateral_shift > 0.0 => difference(self.rows.len() - 1),
            None => difference(0),
        }
    }

    /// Equivalent conicity at an amplitude \[m\]; none beyond the table.
    pub fn equivalent_conicity(
        &self,
        amplitude: f64,
        contact_spacing: f64,
    ) -> Option<EquivalentConicity> {
        self.place(amplitude)?;
        self.place(-amplitude)?;
        EquivalentConicity::at(
            |shift| self.rolling_radius_difference(shift),
            amplitude,
            contact_spacing,
            self.rolling_radius,
        )
    }
}

/// Rows about the one in the middle, as far as a wheel is on its rail, and the place of that one among them.
///
/// # Errors
/// That of the row in the middle.
pub(super) fn around_middle<T>(
    rows: Vec<Result<T, ProfileError>>,
) -> Result<(Vec<T>, usize), ProfileError> {
    let centre = rows.len() / 2;
    if let Err(error) = &rows[centre] {
        return Err(error.clone());
    }
    let from = (0..centre)
        .rev()
        .find(|&row| rows[row].is_err())
        .map_or(0, |row| row + 1);
    let rows = rows.into_iter().skip(from).map_while(Result::ok).collect();
    Ok((rows, centre - from))
}
