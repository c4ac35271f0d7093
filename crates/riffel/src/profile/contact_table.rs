//! Contact of a wheelset over its lateral shift, as a table.

use rayon::prelude::*;

use super::{EquivalentConicity, ProfileError, WheelsetContact, WheelsetOnTrack};
use crate::Rail;
use crate::curving::{RollingPosition, RunningSurfaces};

/// Farther than this the contact does not move on a wheel between two rows \[m\] unless it jumps.
const JUMP: f64 = 1.5e-3;

/// Contacts of a wheelset without yaw at equal steps of its lateral shift, about the middle.
#[derive(Debug, Clone)]
pub struct ContactTable {
    step: f64,
    /// Row of the centred wheelset.
    middle: usize,
    rows: Vec<WheelsetContact>,
    rolling_radii: [f64; 2],
}

impl ContactTable {
    /// The table of a wheelset up to a lateral shift \[m\] to either side, every `step` \[m\]; it ends where a wheel leaves its
    /// rail before.
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where the centred wheelset does not touch both rails.
    pub fn new(
        wheelset: &WheelsetOnTrack,
        rolling_radii: [f64; 2],
        farthest: f64,
        step: f64,
    ) -> Result<Self, ProfileError> {
        let count = (farthest / step).round() as i32;
        let shifts: Vec<i32> = (-count..=count).collect();
        let rows: Vec<Result<WheelsetContact, ProfileError>> = shifts
            .par_iter()
            .map(|place| wheelset.contact(step * f64::from(*place), 0.0))
            .collect();
        let centre = count as usize;
        if let Err(error) = &rows[centre] {
            return Err(error.clone());
        }
        let from = (0..centre)
            .rev()
            .find(|&row| rows[row].is_err())
            .map_or(0, |row| row + 1);
        let rows: Vec<WheelsetContact> =
            rows.into_iter().skip(from).map_while(Result::ok).collect();
        Ok(Self {
            step,
            middle: centre - from,
            rows,
            rolling_radii,
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

    /// Whether the contact of a wheel jumps between a row and the next.
    fn jumps(&self, rail: usize, index: usize) -> bool {
        let place = |row: usize| self.rows[row].contacts[rail].x_wheel;
        (place(index + 1) - place(index)).abs() > JUMP
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
            self.rolling_radii[1],
        )
    }

    /// Cubic between rows, with the slopes of the rows around; linear where the contact jumps.
    fn interpolate(
        &self,
        rail: usize,
        index: usize,
        share: f64,
        value: impl Fn(usize) -> f64,
    ) -> f64 {
        let (one, other) = (value(index), value(index + 1));
        if self.jumps(rail, index) {
            return one + share * (other - one);
        }
        let secant = other - one;
        let before = (index > 0 && !self.jumps(rail, index - 1)).then(|| one - value(index - 1));
        let after = (index + 2 < self.rows.len() && !self.jumps(rail, index + 1))
            .then(|| value(index + 2) - other);
        let slope = |neighbour: Option<f64>| {
            neighbour.map_or(secant, |neighbour| 0.5 * (neighbour + secant))
        };
        let (p, q) = (slope(before), slope(after));
        one + share * (p + share * ((3.0 * secant - 2.0 * p - q) + share * (p + q - 2.0 * secant)))
    }
}

impl RunningSurfaces for ContactTable {
    fn position(&self, rail: Rail, lateral_shift: f64) -> Option<RollingPosition> {
        let (index, share) = self.place(lateral_shift)?;
        let side = usize::from(rail == Rail::Right);
        let contact = |row: usize| &self.rows[row].contacts[side];
        let of = |value: &dyn Fn(usize) -> f64| self.interpolate(side, index, share, value);
        Some(RollingPosition {
            radius_change: of(&|row| contact(row).rolling_radius - self.rolling_radii[side]),
            contact_angle: of(&|row| contact(row).contact_angle),
            lateral_curvature: Some(of(&|row| {
                contact(row).rail_curvature - contact(row).wheel_curvature
            })),
            on_two_points: self.jumps(side, index),
        })
    }
}
