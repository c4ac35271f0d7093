//! Contact of a wheelset over its lateral shift, as a table.

use std::collections::BTreeMap;

use rayon::prelude::*;

use super::{EquivalentConicity, ProfileError, WheelsetContact, WheelsetOnTrack};
use crate::Rail;
use crate::curving::{RollingPosition, RunningSurfaces, TwoPoints};

/// Farther than this the contact of a wheel that jumps moves on the wheel \[m\]. Shorter jumps are bridged by the cubic of the
/// rows.
const JUMP: f64 = 1.5e-3;
/// The lateral shift of a jump is found to this \[m\].
const PLACE_OF_JUMP: f64 = 1e-9;
/// Pieces into which the way from a row to a jump is cut: before a jump contacts run along the wheel and angles change fast.
const PIECES_BESIDE_JUMP: usize = 16;

/// Contacts of a wheelset without yaw at equal steps of its lateral shift, about the middle.
#[derive(Debug, Clone)]
pub struct ContactTable {
    step: f64,
    /// Row of the centred wheelset.
    middle: usize,
    rows: Vec<WheelsetContact>,
    rolling_radii: [f64; 2],
    /// Jumps of either wheel in the order of their shifts.
    jumps: Vec<TwoPoints>,
    /// Between rows with jumps, by the first of them, for the left and the right wheel.
    between: BTreeMap<(usize, usize), Vec<Stretch>>,
}

/// Positions at lateral shifts \[m\] from a row or a jump to the next, in their order.
#[derive(Debug, Clone)]
struct Stretch(Vec<(f64, RollingPosition)>);

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
        let places: Vec<(usize, Rail)> = (0..rows.len() - 1)
            .flat_map(|row| Rail::BOTH.map(|rail| (row, rail)))
            .collect();
        let found: Vec<_> = places
            .par_iter()
            .filter_map(|&(row, rail)| {
                let search = Jumps {
                    wheelset,
                    rail,
                    rolling_radii,
                };
                let mut jumps = Vec::new();
                search.between(&rows[row], &rows[row + 1], &mut jumps);
                if jumps.is_empty() {
                    return None;
                }
                let stretches = search.stretches(&rows[row], &rows[row + 1], &jumps);
                Some(((row, side_of(rail)), jumps, stretches))
            })
            .collect();
        let mut jumps = Vec::new();
        let mut between = BTreeMap::new();
        for (place, at, stretches) in found {
            jumps.extend(at);
            between.insert(place, stretches);
        }
        jumps.sort_by(|one: &TwoPoints, other| one.lateral_shift.total_cmp(&other.lateral_shift));
        Ok(Self {
            step,
            middle: centre - from,
            rows,
            rolling_radii,
            jumps,
            between,
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
            self.rolling_radii[1],
        )
    }

    /// The place of a wheel at a row.
    fn at_row(&self, rail: Rail, row: usize) -> RollingPosition {
        rolling_position(&self.rows[row], rail, self.rolling_radii)
    }

    /// Cubic between rows, with the slopes of the rows around.
    fn cubic(&self, rail: Rail, index: usize, share: f64) -> RollingPosition {
        let jumps = |index: usize| self.between.contains_key(&(index, side_of(rail)));
        let (one, other) = (self.at_row(rail, index), self.at_row(rail, index + 1));
        let before = (index > 0 && !jumps(index - 1)).then(|| self.at_row(rail, index - 1));
        let after = (index + 2 < self.rows.len() && !jumps(index + 1))
            .then(|| self.at_row(rail, index + 2));
        combined(|value| {
            let (from, to) = (value(&one), value(&other));
            let secant = to - from;
            let slope = |neighbour: Option<f64>| {
                neighbour.map_or(secant, |neighbour| 0.5 * (neighbour + secant))
            };
            let p = slope(before.as_ref().map(|before| from - value(before)));
            let q = slope(after.as_ref().map(|after| value(after) - to));
            from + share
                * (p + share * ((3.0 * secant - 2.0 * p - q) + share * (p + q - 2.0 * secant)))
        })
    }
}

impl RunningSurfaces for ContactTable {
    /// Cubic between rows; linear in sixteenths of the way from a row to a jump beside it.
    fn position(&self, rail: Rail, lateral_shift: f64) -> Option<RollingPosition> {
        let (index, share) = self.place(lateral_shift)?;
        let Some(stretches) = self.between.get(&(index, side_of(rail))) else {
            return Some(self.cubic(rail, index, share));
        };
        let ends_beyond =
            |stretch: &&Stretch| stretch.0.last().is_some_and(|end| end.0 >= lateral_shift);
        let stretch = stretches.iter().find(ends_beyond).or(stretches.last())?;
        let after = stretch.0.partition_point(|node| node.0 < lateral_shift);
        let after = after.clamp(1, stretch.0.len() - 1);
        let (low, high) = (&stretch.0[after - 1], &stretch.0[after]);
        let share = match high.0 - low.0 {
            width if width > 0.0 => (lateral_shift - low.0) / width,
            _ => 0.0,
        };
        Some(combined(|value| {
            value(&low.1) + share * (value(&high.1) - value(&low.1))
        }))
    }

    fn two_points(&self) -> &[TwoPoints] {
        &self.jumps
    }
}

/// A position each of whose values is combined of those of others.
fn combined(of: impl Fn(&dyn Fn(&RollingPosition) -> f64) -> f64) -> RollingPosition {
    RollingPosition {
        radius_change: of(&|position| position.radius_change),
        contact_angle: of(&|position| position.contact_angle),
        lateral_curvature: Some(of(&|position| {
            position.lateral_curvature.unwrap_or(f64::NAN)
        })),
    }
}

fn rolling_position(
    contact: &WheelsetContact,
    rail: Rail,
    rolling_radii: [f64; 2],
) -> RollingPosition {
    let side = side_of(rail);
    let on = &contact.contacts[side];
    RollingPosition {
        radius_change: on.rolling_radius - rolling_radii[side],
        contact_angle: on.contact_angle,
        lateral_curvature: Some(on.rail_curvature - on.wheel_curvature),
    }
}

/// The search for jumps of the contact of a wheel, by halving.
struct Jumps<'a> {
    wheelset: &'a WheelsetOnTrack,
    rail: Rail,
    rolling_radii: [f64; 2],
}

impl Jumps<'_> {
    fn between(&self, low: &WheelsetContact, high: &WheelsetContact, jumps: &mut Vec<TwoPoints>) {
        let side = side_of(self.rail);
        let place = |contact: &WheelsetContact| contact.contacts[side].x_wheel;
        if (place(high) - place(low)).abs() <= JUMP {
            return;
        }
        let lateral_shift = 0.5 * (low.lateral_shift + high.lateral_shift);
        if high.lateral_shift - low.lateral_shift > PLACE_OF_JUMP
            && let Ok(middle) = self.wheelset.contact(lateral_shift, 0.0)
        {
            self.between(low, &middle, jumps);
            self.between(&middle, high, jumps);
            return;
        }
        jumps.push(TwoPoints {
            rail: self.rail,
            lateral_shift,
            positions: [low, high]
                .map(|contact| rolling_position(contact, self.rail, self.rolling_radii)),
        });
    }
    /// The ways from a row to the first jump, from jump to jump, and from the last one to the next row.
    fn stretches(
        &self,
        low: &WheelsetContact,
        high: &WheelsetContact,
        jumps: &[TwoPoints],
    ) -> Vec<Stretch> {
        let at =
            |contact: &WheelsetContact| rolling_position(contact, self.rail, self.rolling_radii);
        let mut ends = vec![(low.lateral_shift, at(low))];
        for jump in jumps {
            ends.extend(
                jump.positions
                    .map(|position| (jump.lateral_shift, position)),
            );
        }
        ends.push((high.lateral_shift, at(high)));
        let stretch = |pair: &[(f64, RollingPosition)]| {
            let (from, to) = (pair[0].0, pair[1].0);
            let mut nodes = vec![pair[0]];
            for piece in 1..PIECES_BESIDE_JUMP {
                let shift = from + (to - from) * piece as f64 / PIECES_BESIDE_JUMP as f64;
                let inside = to - from > 1e2 * PLACE_OF_JUMP;
                let contact = inside.then(|| self.wheelset.contact(shift, 0.0));
                if let Some(Ok(contact)) = contact {
                    nodes.push((shift, at(&contact)));
                }
            }
            nodes.push(pair[1]);
            Stretch(nodes)
        };
        ends.chunks_exact(2).map(stretch).collect()
    }
}

fn side_of(rail: Rail) -> usize {
    usize::from(rail == Rail::Right)
}
