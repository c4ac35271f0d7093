//! Designs of experiments: points of the unit cube, each by its number alone.
//!
//! A point is a share between 0 and 1, both excluded, for each parameter; [`Parameter::value`](crate::Parameter)
//! turns it into a value. No design is held in memory: the point of a number is made when it is asked for, so that
//! a million samples on a thousand machines cost nothing but themselves.

mod grid;
mod latin_hypercube;
mod permutation;
mod random;
mod saltelli;
mod sobol;

pub use grid::Grid;
pub use latin_hypercube::LatinHypercube;
pub use random::Random;
pub use saltelli::Saltelli;
pub use sobol::Sobol;

/// Points of the unit cube in order.
#[derive(Debug, Clone)]
pub enum Design {
    /// Every combination of the values.
    Grid(Grid),
    /// Independent points.
    Random(Random),
    /// One point in each of as many strata as there are points, for each parameter.
    LatinHypercube(LatinHypercube),
    /// A scrambled Sobol sequence.
    Sobol(Sobol),
    /// Saltelli's cross sample for Sobol indices.
    Saltelli(Saltelli),
}

impl Design {
    /// Number of points.
    pub fn samples(&self) -> u64 {
        match self {
            Self::Grid(design) => design.samples(),
            Self::Random(design) => design.samples(),
            Self::LatinHypercube(design) => design.samples(),
            Self::Sobol(design) => design.samples(),
            Self::Saltelli(design) => design.samples(),
        }
    }

    /// The point of a number below [`samples`](Self::samples).
    pub fn point(&self, index: u64) -> Vec<f64> {
        match self {
            Self::Grid(design) => design.point(index),
            Self::Random(design) => design.point(index),
            Self::LatinHypercube(design) => design.point(index),
            Self::Sobol(design) => design.point(index),
            Self::Saltelli(design) => design.point(index),
        }
    }
}

/// The number in the middle of one of 2⁵² equal parts between 0 and 1: never 0, never 1, exact.
fn unit(bits: u64) -> f64 {
    ((bits >> 12) as f64 + 0.5) / (1u64 << 52) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_bits_reach_an_end() {
        assert!(unit(0) > 0.0 && unit(u64::MAX) < 1.0);
        assert_eq!(unit(1 << 63), 0.5 + 0.5 / (1u64 << 52) as f64);
    }
}
