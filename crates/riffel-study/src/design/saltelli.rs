//! Saltelli's cross sample.

use super::Sobol;

/// Two independent samples A and B, and for each parameter the sample A with that column from B: what the
/// estimators of Sobol indices take (Saltelli et al. 2010).
///
/// Rows belong together: for each base point first A, then A with one column of B for each parameter in order,
/// then B, which is the order of SALib. A and B are the two halves of a scrambled Sobol sequence of twice the
/// dimensions, so that a longer design begins with the shorter one.
#[derive(Debug, Clone)]
pub struct Saltelli {
    base: Sobol,
    parameters: usize,
}

impl Saltelli {
    /// Most parameters: half of the dimensions of a Sobol sequence.
    pub const MOST_PARAMETERS: usize = Sobol::MOST_DIMENSIONS / 2;

    /// So many base points for so many parameters, at most [`MOST_PARAMETERS`](Self::MOST_PARAMETERS).
    pub fn new(base_samples: u64, parameters: usize, seed: u64) -> Self {
        Self { base: Sobol::new(base_samples, 2 * parameters, seed), parameters }
    }

    /// Number of points: base points times the number of parameters and two more.
    pub fn samples(&self) -> u64 {
        self.base.samples() * self.rows_per_base()
    }

    /// Number of points that belong to one base point.
    pub fn rows_per_base(&self) -> u64 {
        self.parameters as u64 + 2
    }

    /// The point of a number.
    pub fn point(&self, index: u64) -> Vec<f64> {
        let row = (index % self.rows_per_base()) as usize;
        let mut a = self.base.point(index / self.rows_per_base());
        let b = a.split_off(self.parameters);
        match row {
            0 => a,
            row if row == self.parameters + 1 => b,
            row => {
                a[row - 1] = b[row - 1];
                a
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_exchange_one_column() {
        let design = Saltelli::new(8, 3, 5);
        assert_eq!(design.samples(), 40);
        for base in 0..8 {
            let [a, b] = [0, 4].map(|row| design.point(5 * base + row));
            for column in 0..3 {
                let mixed = design.point(5 * base + 1 + column as u64);
                for place in 0..3 {
                    let from = if place == column { &b } else { &a };
                    assert_eq!(mixed[place], from[place]);
                }
            }
        }
    }
}
