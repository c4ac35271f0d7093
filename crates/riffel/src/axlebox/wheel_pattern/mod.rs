//! What of a felt roughness turns with the wheel.

mod expected;
mod lines;

use std::ops::RangeInclusive;

use lines::Lines;

use super::PatchAverageProfile;
use crate::Error;
use crate::roughness::Profile;

/// Part of the circumference by which a wheel may differ from its case: wear.
const WORN: f64 = 0.04;
/// Fewest turns in which a pattern can be told from a rail.
const LEAST_TURNS: f64 = 16.0;
/// Most turns to either side over which a pattern is averaged: positions of an odometer drift, and 48 turns leave a
/// fiftieth of the rail's power in their mean.
const MOST_TURNS: usize = 24;
/// Part of the whitened power that repeats from which there is a pattern: rails of no wheel have 0.003 or less.
const LEAST_SHARE: f64 = 0.015;
/// Part of the power about an order that repeats from which the order stands out.
const ORDER_SHARE: f64 = 0.3;
/// Part of what repeats about an order from which it is the rail's where other wheels felt it.
const SHARE_OF_OTHERS: f64 = 0.5;
/// Orders of a pattern from which it is no wave of the rail: a wave that keeps its phase over all turns has one.
const LEAST_ORDERS: usize = 4;
/// Depth of a pattern in its RMS from which it is a flat: a wave of one order has 1.4.
const FLAT: f64 = 4.0;
/// Part by which a distance may differ from that of supports.
const SAME: f64 = 0.01;

/// What a wheel feels once a turn, all along a piece of line.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelPattern {
    /// Distance after which it repeats \[m\]: 2πR as the odometer counts.
    pub circumference: f64,
    /// Orders that stand out, the lowest first, each with its amplitude \[m\].
    pub orders: Vec<(usize, f64)>,
    /// RMS \[m\].
    pub rms: f64,
    /// Deepest place below the mean \[m\], in the middle of all turns.
    pub depth: f64,
    /// Whether it can be no wave of the rail.
    pub is_wheel: bool,
    /// Heights without a pattern that may be a wave of the rail, and stays in what the wheel felt; `None` if it can be none.
    pub without: Option<Profile>,
}

impl WheelPattern {
    /// What repeats in what wheels felt of one rail at the same time by their circumference \[m\], 4 % more or less, a pattern
    /// or none for each; a pattern that is the wheel's is taken off its heights.
    ///
    /// Method: power is made even over octaves, so that long waves do not hide the rest; the distance is that at which the
    /// autocorrelation at all multiples is the greatest, and then that of the highest lines of the orders that stand out. The pattern at a
    /// place is the parabola through the heights a whole number of turns away, up to 12 to either side and without the height of the place
    /// itself: it may change slowly, as it does with the speed where the transfer is not quite that of the track, and a rail without a
    /// pattern has none but by chance. It is taken in the bands of the orders that stand out, and in those of all known
    /// orders where four or more do. An order that repeats half as strongly under most of the other wheels is the rail's. Where there is
    /// no other wheel, a pattern of fewer than four orders may be a wave of the rail that keeps its phase, and stays in the heights; what
    /// repeats by the distance of supports \[m\], if there are any, is the track's.
    ///
    /// Range: 16 turns or more, wavelengths that are known. Accuracy, on 16 made-up rails of 300 m, half of them corrugated (tests of this
    /// module): rails, their waves and supports have no pattern; flats of 60 to 155 µm and waves of 18 µm around the wheel are found on
    /// all, and what is left has the rail's levels within 0.5 dB. Cost: two transforms, and two more where there is a pattern.
    ///
    /// # Errors
    /// None for heights that are finite.
    pub fn take_off(
        patch_averages: &mut [PatchAverageProfile],
        circumference: f64,
        supports: Option<f64>,
    ) -> Result<Vec<Option<Self>>, Error> {
        let lines: Vec<Lines> = patch_averages
            .iter()
            .map(|patch_average| {
                let (heights, spacing) = (patch_average.profile.heights(), patch_average.profile.spacing());
                Lines::of(heights, spacing, 1 + usize::from(patch_average.is_told_by_half()))
            })
            .collect();
        let mut found = Vec::new();
        for (index, patch_average) in patch_averages.iter_mut().enumerate() {
            let turning = Turning::find(&lines, index, patch_average, circumference, supports);
            found.push(match turning {
                Some(turning) => Some(turning.taken_off(&lines[index], patch_average)?),
                None => None,
            });
        }
        Ok(found)
    }

    /// Whether it is a flat, and no wave around the wheel.
    pub fn is_flat(&self) -> bool {
        self.orders.len() >= LEAST_ORDERS && self.depth > FLAT * self.rms
    }
}

/// Orders that stand out, before their course is known.
struct Turning {
    circumference: f64,
    turns: usize,
    orders: Vec<usize>,
    /// Orders that the rail has.
    of_rail: Vec<usize>,
    is_wheel: bool,
}

impl Turning {
    fn find(
        lines: &[Lines],
        index: usize,
        patch_average: &PatchAverageProfile,
        nominal: f64,
        supports: Option<f64>,
    ) -> Option<Self> {
        let spacing = patch_average.profile.spacing();
        let turns = patch_average.profile.length() / nominal;
        if turns < LEAST_TURNS || nominal < 8.0 * spacing {
            return None;
        }
        let own = &lines[index];
        let (steps, share) = best_distance(own, nominal / spacing)?;
        if share < LEAST_SHARE {
            return None;
        }
        let turns = MOST_TURNS.min((0.4 * turns) as usize);
        let mut circumference = steps * spacing;
        let mut orders = standing_out(own, patch_average, circumference, turns);
        // The first distance is too coarse for the highest orders, which tell it best.
        for _ in 0..3 {
            let before = circumference;
            circumference = own.refined(&orders, circumference);
            if circumference == before {
                break;
            }
            orders = standing_out(own, patch_average, circumference, turns);
        }
        // Other circumferences nearby have a single wave as another order.
        if let [order] = &mut orders[..] {
            let nearest = (*order as f64 * nominal / circumference).round().max(1.0);
            circumference *= nearest / *order as f64;
            *order = nearest as usize;
        }
        let of_rail: Vec<usize> =
            orders.iter().copied().filter(|&order| is_of_rail(lines, index, order, circumference, turns)).collect();
        let is_wheel = lines.len() > 1 || orders.len() >= LEAST_ORDERS;
        orders.retain(|order| !of_rail.contains(order));
        let supports = supports.filter(|_| lines.len() == 1);
        if orders.is_empty() || is_of_supports(&orders, circumference, supports) {
            return None;
        }
        Some(Self { circumference, turns, orders, of_rail, is_wheel })
    }

    /// The pattern, its course taken off the heights if it is the wheel's.
    fn taken_off(self, lines: &Lines, patch_average: &mut PatchAverageProfile) -> Result<WheelPattern, Error> {
        let circumference = self.circumference;
        let amplitude = |order| {
            let [_, repeating] = lines.about(order, circumference, self.turns);
            (2.0 * repeating.max(0.0)).sqrt()
        };
        // A flat that stands out of some waves is in all, and what does not repeat keeps its power.
        let taken: Vec<usize> = match self.orders.len() >= LEAST_ORDERS {
            true => known_orders(patch_average, circumference).filter(|order| !self.of_rail.contains(order)).collect(),
            false => self.orders.clone(),
        };
        let course = lines.repeating(&taken, circumference, self.turns);
        let square = course.iter().map(|height| height * height).sum::<f64>();
        let steps = (circumference / patch_average.profile.spacing()).round() as usize;
        let left = patch_average.profile.heights().iter().zip(&course);
        let left = left.map(|(height, wheel)| height - wheel).collect();
        let mut without = Some(Profile::new(patch_average.profile.start(), patch_average.profile.spacing(), left)?);
        if let Some(rail) = without.take_if(|_| self.is_wheel) {
            patch_average.profile = rail;
        }
        let orders = self.orders.into_iter();
        Ok(WheelPattern {
            circumference,
            orders: orders.map(|order| (order, amplitude(order))).collect(),
            rms: (square / course.len() as f64).sqrt(),
            depth: depth(&course, steps),
            is_wheel: self.is_wheel,
            without,
        })
    }
}

/// Known orders whose power repeats.
fn standing_out(lines: &Lines, patch_average: &PatchAverageProfile, circumference: f64, turns: usize) -> Vec<usize> {
    let stands_out = |&order: &usize| {
        let [all, repeating] = lines.about(order, circumference, turns);
        repeating > ORDER_SHARE * all
    };
    known_orders(patch_average, circumference).filter(stands_out).collect()
}

/// Orders of wavelengths that are known.
fn known_orders(patch_average: &PatchAverageProfile, circumference: f64) -> RangeInclusive<usize> {
    let first = ((circumference / patch_average.known.to()).ceil() as usize).max(1);
    first..=(circumference / patch_average.known.from()) as usize
}

/// Whether most other wheels felt an order that repeats.
fn is_of_rail(lines: &[Lines], own: usize, order: usize, circumference: f64, turns: usize) -> bool {
    let repeating = |lines: &Lines| lines.about(order, circumference, turns)[1];
    let least = SHARE_OF_OTHERS * repeating(&lines[own]);
    let others = lines.iter().enumerate().filter(|(index, _)| *index != own);
    let agreeing = others.filter(|(_, other)| repeating(other) > least).count();
    2 * agreeing > lines.len() - 1
}

/// The distance at which a course repeats the most, in its steps, and how much of it: the mean of the autocorrelation at
/// all multiples of the distance, more of them each time, beside the best before.
fn best_distance(lines: &Lines, about: f64) -> Option<(f64, f64)> {
    /// Distances that are looked at more closely.
    const KEPT: usize = 24;
    let most = ((0.5 * lines.count() as f64 / about) as usize).min(2 * MOST_TURNS);
    // Distances change by less than two steps while they are looked at.
    let longest = about * (1.0 + WORN) + 2.0;
    let repeats = lines.whitened_autocorrelation((most as f64 * longest) as usize + 2);
    let at = |lag: f64| {
        let (low, share) = (lag as usize, lag.fract());
        match repeats.get(low..low + 2) {
            Some(pair) => pair[0] + share * (pair[1] - pair[0]),
            None => 0.0,
        }
    };
    let judged = |distance: f64, multiples: usize| {
        let sum: f64 = (1..=multiples).map(|m| at(m as f64 * distance)).sum();
        (distance, sum / multiples as f64)
    };
    let from = 2.0 * about * (1.0 - WORN);
    let count = (4.0 * about * WORN) as usize;
    let mut best: Vec<(f64, f64)> = (0..=count).map(|step| judged(0.5 * (from + step as f64), 1)).collect();
    let mut multiples = 1;
    loop {
        best.sort_by(|one, other| other.1.total_cmp(&one.1));
        best.truncate(KEPT);
        let more = (2 * multiples).min(most);
        if more == multiples {
            return best.first().copied();
        }
        let step = 0.5 / more as f64;
        multiples = more;
        let near = best.iter();
        let near = near.flat_map(|(at, _)| (-3..=3).map(move |k| at + step * f64::from(k)));
        let mut near: Vec<f64> = near.collect();
        // Most are near several, and would crowd out others.
        near.sort_by(f64::total_cmp);
        near.dedup_by(|next, own| *next - *own < 0.5 * step);
        let judged = near.into_iter().map(|at| judged(at, multiples));
        best = judged.collect();
    }
}

/// Depth below the mean that half of the turns reach.
fn depth(course: &[f64], steps: usize) -> f64 {
    let turn = |turn: &[f64]| -turn.iter().copied().fold(f64::INFINITY, f64::min);
    let mut depths: Vec<f64> = course.chunks_exact(steps).map(turn).collect();
    depths.sort_by(f64::total_cmp);
    depths.get(depths.len() / 2).copied().unwrap_or(0.0)
}

/// Whether orders are those of supports, or of a part of their distance.
fn is_of_supports(orders: &[usize], circumference: f64, supports: Option<f64>) -> bool {
    let divisor = orders.iter().copied().fold(0, |one, other| {
        let (mut one, mut other) = (one, other);
        while other > 0 {
            (one, other) = (other, one % other);
        }
        one
    });
    supports.is_some_and(|supports| {
        let waves = supports * divisor as f64 / circumference;
        waves.round() >= 1.0 && (waves / waves.round() - 1.0).abs() < SAME
    })
}

#[cfg(test)]
mod tests;
