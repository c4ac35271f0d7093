//! The rate of a clipped power about one mean state, read from a table over the amplitude.

use riffel_numerics::chebyshev::{Cell, Cut};

use super::ClippedPower;

/// Equal parts of the range, each of which knows the cell that it begins in.
const PARTS: usize = 256;
const CUT: Cut = Cut { first_cells: 16, most_halvings: 12, checks: [-0.95, -0.5, 0.1, 0.6, 0.97] };
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
    cells: Vec<Cell<f64>>,
    /// Numbers of the cells in which equal parts begin.
    parts: Vec<usize>,
}

impl RateTable {
    /// Of a law whose rate has no short closed form; none about a sharp limit itself, where the rate is a power of the amplitude.
    pub(super) fn new(law: ClippedPower, excess: f64) -> Option<Self> {
        let scale = excess.abs() + law.spread();
        let short = !law.is_spread() && (law.exponent() == 1.0 || law.exponent() == 2.0);
        (!short && scale > 0.0).then(|| {
            let mut table = Self { law, excess, scale, cells: Vec::new(), parts: Vec::new() };
            let at_limit = excess.abs() / (excess.abs() + scale);
            let size = law.slope(scale);
            let holds = |exact: f64, value: f64| (value - exact).abs() <= TOLERANCE * size;
            let ranges = [[0.0, at_limit], [at_limit, 1.0]].into_iter().filter(|[from, to]| to > from);
            let cells = ranges.flat_map(|ends| Cell::table(|place| table.exact(place), ends, &CUT, holds));
            table.cells = cells.collect::<Vec<_>>();
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
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table is the law to 1e-9 of its slope, from no amplitude to a thousand times the limit; without a spread too.
    // Long: tabulates the law for 34 pairs of its exponent and spread with an excess.
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
