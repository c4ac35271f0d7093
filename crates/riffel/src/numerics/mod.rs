//! Numerical methods that several laws and crates share, one of each.
//!
//! Lengths and units are those of the arguments. A tolerance is absolute, and zero means rounding.

pub mod bisection;
pub(crate) mod chebyshev;
pub mod cubic;
pub mod distribution;
pub(crate) mod eigenvalues;
pub(crate) mod elimination;
pub(crate) mod gauss;
pub(crate) mod golden_section;
pub(crate) mod hermitian;
pub mod least_squares;
pub mod matrix;
pub mod normal_distribution;
pub mod random_numbers;
pub(crate) mod simpson;
pub(crate) mod simultaneous_roots;
pub(crate) mod spherical_bessel;
pub(crate) mod square;
pub(crate) mod square_root;
