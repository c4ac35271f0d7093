//! Where the wheels of a wheelset on profiles run, as a table over its shift at the level of the rails.

use rayon::prelude::*;
use riffel::Rail;

use super::radius_difference::around_middle;
use super::{ProfileError, WheelsetContact, WheelsetOnTrack};
use crate::{RollingPosition, RunningSurfaces, TwoPoints};

/// Farther than this the contact of a wheel that jumps moves on the wheel \[m\]. Shorter jumps are bridged by the cubic.
const JUMP: f64 = 1.5e-3;
/// The shift of a jump is found to this \[m\].
const PLACE_OF_JUMP: f64 = 1e-9;
/// Pieces into which the way from a row to a jump is cut: before a jump contacts run along the wheel and angles change fast.
const PIECES_BESIDE_JUMP: usize = 16;

/// Running surfaces of profiles without yaw: contacts at equal steps of the shift η at the level of the rails, with nodes of
/// their own beside jumps.
///
/// Over η, and not over the shift of the axle, because on steep flanges the axle turns back as the wheelset climbs
/// ([`WheelsetOnTrack::contact_at_rail_level`]).
#[derive(Debug, Clone)]
pub struct RollingTable {
    /// From jump to jump of either wheel; each begins where the one before it ends.
    stretches: Vec<Vec<Node>>,
    jumps: Vec<TwoPoints>,
}

/// Where a wheelset stands.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// Shift η at the level of the rails \[m\].
    shift: f64,
    axle_shift: f64,
    /// Left, right.
    positions: [RollingPosition; 2],
}

impl RollingTable {
    /// The table of a wheelset with these radii on the datum circles \[m\], left and right, every `step` \[m\] up to a shift \[m\] to
    /// either side; it ends where a wheel leaves its rail before.
    ///
    /// Cost: some 0.1 ms a step, shared by all threads.
    ///
    /// # Errors
    /// [`ProfileError::NoContact`] where the centred wheelset does not touch both rails.
    pub fn new(
        wheelset: &WheelsetOnTrack,
        rolling_radii: [f64; 2],
        farthest: f64,
        step: f64,
    ) -> Result<Self, ProfileError> {
        let surfaces = Surfaces { wheelset, rolling_radii };
        let count = (farthest / step).round() as i32;
        let places: Vec<i32> = (-count..=count).collect();
        let rows = places.par_iter().map(|place| surfaces.row(step * f64::from(*place)));
        let (rows, _) = around_middle(rows.collect())?;
        let ways: Vec<Way> = rows.par_windows(2).map(|pair| surfaces.way(&pair[0], &pair[1])).collect();
        let mut stretches = Vec::new();
        let mut stretch = vec![surfaces.node(&rows[0])];
        for way in &ways {
            let (last, before) = way.stretches.split_last().expect("a way has a stretch");
            for ended in before {
                stretch.extend(ended);
                stretches.push(std::mem::take(&mut stretch));
            }
            stretch.extend(last);
        }
        stretches.push(stretch);
        Ok(Self { stretches, jumps: ways.into_iter().flat_map(|way| way.jumps).collect() })
    }

    /// The nodes around a shift and what each of them weighs there: cubic between two nodes, its slopes those of the parabola
    /// through a node and its neighbours, at the ends of a stretch that of the chord.
    fn weights(&self, shift: f64) -> Option<[(&Node, f64); 4]> {
        if self.stretches.first()?.first()?.shift > shift {
            return None;
        }
        let nodes = self.stretches.iter().find(|stretch| stretch.last().is_some_and(|end| end.shift >= shift))?;
        let above = nodes.partition_point(|node| node.shift < shift);
        if nodes[above].shift == shift || above == 0 {
            let zero = (&nodes[above], 0.0);
            return Some([(&nodes[above], 1.0), zero, zero, zero]);
        }
        let (low, high) = (&nodes[above - 1], &nodes[above]);
        let width = high.shift - low.shift;
        let share = (shift - low.shift) / width;
        let rest = 1.0 - share;
        let far = share * share * (3.0 - 2.0 * share);
        let mut of_ends = [1.0 - far, far];
        let mut weights = [(low, 0.0); 4];
        let ends = [(above.checked_sub(2).map(|index| &nodes[index]), 0), (nodes.get(above + 1), 1)];
        for (beyond, end) in ends {
            // What a unit of the slope at this end adds.
            let of_slope = [share * rest * rest, -share * share * rest][end] * width;
            let beyond = beyond.map(|node| (node, (node.shift - [low, high][end].shift).abs()));
            let reach = beyond.map_or(f64::INFINITY, |(_, reach)| reach);
            let of_chord = of_slope / (1.0 + width / reach) / width;
            of_ends[0] -= of_chord;
            of_ends[1] += of_chord;
            if let Some((node, reach)) = beyond {
                let outside = of_slope * width / (width + reach) / reach * [-1.0, 1.0][end];
                weights[2 + end] = (node, outside);
                of_ends[end] -= outside;
            }
        }
        weights[0] = (low, of_ends[0]);
        weights[1] = (high, of_ends[1]);
        Some(weights)
    }
}

impl RunningSurfaces for RollingTable {
    fn position(&self, rail: Rail, shift: f64) -> Option<RollingPosition> {
        let weights = self.weights(shift)?;
        let side = side_of(rail);
        let of = |value: fn(&RollingPosition) -> f64| {
            let terms = weights.iter().map(|(node, weight)| weight * value(&node.positions[side]));
            terms.sum::<f64>()
        };
        Some(RollingPosition {
            radius_change: of(|position| position.radius_change),
            contact_angle: of(|position| position.contact_angle),
            lateral_curvature: Some(of(|position| position.lateral_curvature.unwrap_or(f64::NAN))),
        })
    }

    fn axle_shift(&self, shift: f64) -> Option<f64> {
        let weights = self.weights(shift)?;
        Some(weights.iter().map(|(node, weight)| weight * node.axle_shift).sum())
    }

    fn two_points(&self) -> &[TwoPoints] {
        &self.jumps
    }
}

/// A shift η \[m\] with the contacts there.
type Row = (f64, WheelsetContact);

/// From a row to the next: stretches parted by jumps, the first without the row it begins at.
struct Way {
    stretches: Vec<Vec<Node>>,
    jumps: Vec<TwoPoints>,
}

/// A wheelset on its track, with the radii of its datum circles.
struct Surfaces<'a> {
    wheelset: &'a WheelsetOnTrack,
    rolling_radii: [f64; 2],
}

impl Surfaces<'_> {
    fn row(&self, shift: f64) -> Result<Row, ProfileError> {
        Ok((shift, self.wheelset.contact_at_rail_level(shift, 0.0)?))
    }

    fn node(&self, (shift, contact): &Row) -> Node {
        Node {
            shift: *shift,
            axle_shift: contact.lateral_shift,
            positions: [0, 1].map(|side| {
                let on = &contact.contacts[side];
                RollingPosition {
                    radius_change: on.rolling_radius - self.rolling_radii[side],
                    contact_angle: on.contact_angle,
                    lateral_curvature: Some(on.rail_curvature - on.wheel_curvature),
                }
            }),
        }
    }

    fn way(&self, low: &Row, high: &Row) -> Way {
        let mut pairs = Vec::new();
        self.find_jumps(low, high, &mut pairs);
        let mut way = Way { stretches: Vec::new(), jumps: Vec::new() };
        let mut from = *low;
        for (below, above) in &pairs {
            let mut stretch = self.between(&from, below);
            stretch.push(self.node(below));
            way.stretches.push(stretch);
            // The stretch after the jump begins at the same shift.
            from = (below.0, above.1);
            let positions = [self.node(below), self.node(&from)];
            let of_rail = Rail::BOTH.into_iter().filter(|rail| jumps(*rail, below, above));
            way.jumps.extend(of_rail.map(|rail| TwoPoints {
                rail,
                shift: below.0,
                positions: positions.map(|node| node.positions[side_of(rail)]),
            }));
        }
        let mut last = Vec::new();
        if !pairs.is_empty() {
            last.push(self.node(&from));
            last.extend(self.between(&from, high));
        }
        last.push(self.node(high));
        way.stretches.push(last);
        way
    }

    /// The pairs of rows between which a wheel jumps, by halving.
    fn find_jumps(&self, low: &Row, high: &Row, found: &mut Vec<(Row, Row)>) {
        if !Rail::BOTH.into_iter().any(|rail| jumps(rail, low, high)) {
            return;
        }
        if high.0 - low.0 > PLACE_OF_JUMP
            && let Ok(middle) = self.row(0.5 * (low.0 + high.0))
        {
            self.find_jumps(low, &middle, found);
            self.find_jumps(&middle, high, found);
        } else {
            found.push((*low, *high));
        }
    }

    /// Nodes inside the way from a row to a jump, or from a jump to a row.
    fn between(&self, from: &Row, to: &Row) -> Vec<Node> {
        let width = to.0 - from.0;
        if width <= 1e2 * PLACE_OF_JUMP {
            return Vec::new();
        }
        let inside = (1..PIECES_BESIDE_JUMP).filter_map(|piece| {
            let shift = from.0 + width * piece as f64 / PIECES_BESIDE_JUMP as f64;
            self.row(shift).ok()
        });
        inside.map(|row| self.node(&row)).collect()
    }
}

/// Whether the contact of a wheel moves by more than [`JUMP`] from a row to another.
fn jumps(rail: Rail, low: &Row, high: &Row) -> bool {
    let place = |row: &Row| row.1.contacts[side_of(rail)].x_wheel;
    (place(high) - place(low)).abs() > JUMP
}

fn side_of(rail: Rail) -> usize {
    usize::from(rail == Rail::Right)
}
