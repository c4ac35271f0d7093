//! The rate of a clipped power about one mean state, read from a table over the amplitude.

use super::ClippedPower;
use crate::numerics::chebyshev::{NODES, polynomial_at, through_nodes};

/// Equal cells to begin with.
const FIRST_CELLS: usize = 16;
/// Equal parts of the range, each of which knows the cell that it begins in.
const PARTS: usize = 256;
/// How often a cell may be halved.
const MOST_HALVINGS: u32 = 12;
/// Largest error between the nodes of a cell, over the largest rate that the amplitude could have.
const TOLERANCE: f64 = 1e-10;

/// [`ClippedPower::rate`] for one X₀.
///
/// Method: over s = U/(U + |X₀| + σ), from none to any amplitude, polynomials of degree 7 through Chebyshev's nodes of cells that are
/// halved until the value in between holds to 1e-10; times (1 − s)^(m−1), which stays finite. A cell ends where the wave reaches the limit:
/// the rate is not smooth there. Cost: some hundred waves to make, a glance at a few cells and seven multiply-adds to read,
/// 25 ns.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct RateTable {
    law: ClippedPower,
    excess: f64,
    /// |X₀| + σ.
    scale: f64,
    cells: Vec<Cell>,
    /// Numbers of the cells in which equal parts begin.
    parts: Vec<usize>,
}

#[derive(Debug, Clone, PartialEq)]
struct Cell {
    end: f64,
    middle: f64,
    /// One over half its width.
    per_half: f64,
    /// In t ∈ \[−1, 1\], lowest power first.
    polynomial: [f64; NODES],
}

impl RateTable {
    /// Of a law whose rate has no short closed form; none about a sharp limit itself, where the rate is a power of the amplitude.
    pub(super) fn new(law: ClippedPower, excess: f64) -> Option<Self> {
        let scale = excess.abs() + law.spread();
        let short = !law.is_spread() && (law.exponent() == 1.0 || law.exponent() == 2.0);
        (!short && scale > 0.0).then(|| {
            let mut table = Self { law, excess, scale, cells: Vec::new(), parts: Vec::new() };
            let at_limit = excess.abs() / (excess.abs() + scale);
            for [from, to] in [[0.0, at_limit], [at_limit, 1.0]] {
                let end = |cell: usize| from + (to - from) * cell as f64 / FIRST_CELLS as f64;
                for cell in (0..FIRST_CELLS).filter(|_| to > from) {
                    table.divide(end(cell), end(cell + 1), MOST_HALVINGS);
                }
            }
            let begin = |part: usize| part as f64 / PARTS as f64;
            let cell = |part| table.cells.partition_point(|cell| cell.end < begin(part));
            table.parts = (0..PARTS).map(cell).collect();
            table
        })
    }

    /// Rate at an amplitude U.
    pub(super) fn rate(&self, amplitude: f64) -> f64 {
        let sum = amplitude + self.scale;
        let place = amplitude / sum;
        let part = place * PARTS as f64;
        let begin = self.parts[(part as usize).min(PARTS - 1)];
        let mut cell = begin.min(self.cells.len() - 1);
        while self.cells[cell].end < place && cell + 1 < self.cells.len() {
            cell += 1;
        }
        let rate = self.cells[cell].at(place);
        match self.law.exponent() {
            1.0 => rate,
            2.0 => rate * (sum / self.scale),
            exponent => rate * (self.scale / sum).powf(1.0 - exponent),
        }
    }

    /// (1 − s)^(m−1) times the rate at s.
    fn exact(&self, place: f64) -> f64 {
        let rest = 1.0 - place;
        let amplitude = self.scale * place / rest;
        self.law.rate(self.excess, amplitude) * rest.powf(self.law.exponent() - 1.0)
    }

    fn divide(&mut self, begin: f64, end: f64, halvings: u32) {
        let at = |t: f64| 0.5 * (begin + end + t * (end - begin));
        let cell = Cell {
            end,
            middle: 0.5 * (begin + end),
            per_half: 2.0 / (end - begin),
            polynomial: through_nodes(|t| self.exact(at(t))),
        };
        let size = self.law.slope(self.scale);
        let holds = [-0.95, -0.5, 0.1, 0.6, 0.97].iter().all(|t| {
            let place = at(*t);
            (cell.at(place) - self.exact(place)).abs() <= TOLERANCE * size
        });
        if holds || halvings == 0 {
            self.cells.push(cell);
            return;
        }
        let middle = 0.5 * (begin + end);
        self.divide(begin, middle, halvings - 1);
        self.divide(middle, end, halvings - 1);
    }
}

impl Cell {
    fn at(&self, place: f64) -> f64 {
        polynomial_at(&self.polynomial, (place - self.middle) * self.per_half)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table is the law to 1e-9 of its slope, from no amplitude to a thousand times the limit; without a spread too.
    #[test]
    fn is_the_law() {
        for (exponent, spread) in [(1.0, 0.02), (1.5, 0.1), (2.0, 0.1), (3.0, 0.05), (1.5, 0.0), (3.0, 0.0), (4.2, 0.0)]
        {
            for excess in [-0.5, -0.08, 0.0, 0.03, 0.4] {
                let law = ClippedPower::new(exponent, spread);
                let Some(table) = RateTable::new(law, excess) else {
                    assert!(excess == 0.0 && spread == 0.0);
                    continue;
                };
                for step in (0..200).step_by(3) {
                    let amplitude = (excess.abs() + 0.02) * (f64::from(step) * 0.036).exp_m1();
                    let size = law.slope(excess.abs() + spread + amplitude);
                    let off = (table.rate(amplitude) - law.rate(excess, amplitude)) / size;
                    assert!(off.abs() < 1e-9, "{exponent} {excess} {spread} {amplitude}: {off:e}");
                }
            }
        }
        assert!(RateTable::new(ClippedPower::new(1.0, 0.0), 0.1).is_none());
    }
}
