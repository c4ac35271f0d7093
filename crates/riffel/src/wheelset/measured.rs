//! The wheelset as it was measured.

use num_complex::Complex64;

use super::{ContactReceptances, Port, Wheelset, passivity_error, reciprocity_error};
use crate::receptance::MeasuredReceptance;
use crate::{Direction, Error, Rail, Receptance};

/// A measured entry of the receptances of a wheelset: the displacement of one port by a force at another.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredEntry {
    /// Where the displacement was measured.
    pub at: Port,
    /// Where the force acted.
    pub from: Port,
    /// The receptance \[m/N\].
    pub receptance: MeasuredReceptance,
}

/// A wheelset by its measured receptances, entry by entry; what was not measured is zero.
///
/// An entry measured one way alone holds for the other way too; of one measured both ways it has the mean. Between lines
/// it is interpolated as [`MeasuredReceptance`] is, and outside the range of any of its entries it is not a number:
/// ask [`frequency_range`](Self::frequency_range) first.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredWheelset {
    entries: Vec<MeasuredEntry>,
}

/// Where measured receptances are furthest from what a wheelset can have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Violation {
    /// How far, relative to the receptances there \[-\].
    pub size: f64,
    /// At which angular frequency \[rad/s\].
    pub angular_frequency: f64,
    /// Between which ports: displacement and force.
    pub ports: [Port; 2],
}

impl MeasuredWheelset {
    /// A wheelset of measured entries, at one contact or both.
    ///
    /// # Errors
    /// [`Error::Measurement`] if there is none, one is given twice, or no frequency lies within all of them.
    pub fn new(entries: Vec<MeasuredEntry>) -> Result<Self, Error> {
        let wrong = |index: usize, rule: &'static str| Err(Error::Measurement { index, rule });
        if entries.is_empty() {
            return wrong(0, "a measured wheelset needs one receptance or more");
        }
        for (index, entry) in entries.iter().enumerate() {
            let same = |other: &MeasuredEntry| other.at == entry.at && other.from == entry.from;
            if entries[..index].iter().any(same) {
                return wrong(index, "a receptance of the wheelset is given twice");
            }
        }
        let wheelset = Self { entries };
        let (lowest, highest) = wheelset.frequency_range();
        if lowest > highest {
            return wrong(0, "the receptances of a wheelset must have frequencies in common");
        }
        Ok(wheelset)
    }

    /// A wheelset of which one wheel was measured: displacement, force, and receptance \[m/N\]. The other is its mirror
    /// image and does not feel it.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn from_one_wheel(rail: Rail, entries: Vec<(Direction, Direction, MeasuredReceptance)>) -> Result<Self, Error> {
        let opposite = rail.opposite();
        let mut both = Vec::with_capacity(2 * entries.len());
        for (at, from, receptance) in entries {
            let entry =
                |rail, receptance| MeasuredEntry { at: Port::new(rail, at), from: Port::new(rail, from), receptance };
            // Lateral motion changes sign in a mirror.
            let crossed = (at == Direction::Lateral) != (from == Direction::Lateral);
            let mirrored = if crossed { receptance.negated() } else { receptance.clone() };
            both.push(entry(rail, receptance));
            both.push(entry(opposite, mirrored));
        }
        Self::new(both)
    }

    /// Lowest and highest angular frequency \[rad/s\] at which all entries are known.
    pub fn frequency_range(&self) -> (f64, f64) {
        let ranges = self.entries.iter().map(|entry| entry.receptance.frequency_range());
        ranges.fold((0.0, f64::INFINITY), |(low, high), (lowest, highest)| (low.max(lowest), high.min(highest)))
    }

    /// Where entries that were measured both ways differ most, |H_ij − H_ji| over the larger of the two; none if they are
    /// equal, or none were.
    ///
    /// A wheelset that does not rotate is reciprocal: accelerometer, hammer, or the sign of an axis is at fault.
    pub fn reciprocity_violation(&self) -> Option<Violation> {
        self.worst(|w| {
            let (size, ports) = reciprocity_error(&self.as_measured(w));
            (size, ports)
        })
    }

    /// Where the measured receptances would most give energy away: the largest eigenvalue of (H − Hᴴ)/2i over the largest
    /// |H|; none if they never do.
    pub fn passivity_violation(&self) -> Option<Violation> {
        self.worst(|w| {
            let (size, port) = passivity_error(&self.receptances(w));
            (size, [port, port])
        })
    }

    /// Greatest error at the lines of all entries that are known to all; `None` if it is zero.
    fn worst(&self, error: impl Fn(f64) -> (f64, [Port; 2])) -> Option<Violation> {
        let (lowest, highest) = self.frequency_range();
        let lines = self.entries.iter().flat_map(|entry| entry.receptance.lines());
        let known = lines.filter(|(w, _)| (lowest..=highest).contains(w));
        let violations = known.map(|(w, _)| {
            let (size, ports) = error(w);
            Violation { size, angular_frequency: w, ports }
        });
        let worst = violations.max_by(|a, b| a.size.total_cmp(&b.size));
        worst.filter(|worst| worst.size > 0.0)
    }

    /// Entries measured both ways as they are, the others as their counterpart.
    fn as_measured(&self, w: f64) -> ContactReceptances {
        let mut receptances = [[Complex64::ZERO; 6]; 6];
        let mut measured = [[false; 6]; 6];
        for entry in &self.entries {
            let (at, from) = (entry.at.index(), entry.from.index());
            let receptance = entry.receptance.receptance(w, 0.0);
            receptances[at][from] = receptance;
            measured[at][from] = true;
            if !measured[from][at] {
                receptances[from][at] = receptance;
            }
        }
        receptances
    }
}

impl Wheelset for MeasuredWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        let measured = self.as_measured(angular_frequency);
        std::array::from_fn(|at| std::array::from_fn(|from| 0.5 * (measured[at][from] + measured[from][at])))
    }
}
