//! Numerical methods that several laws and crates share, one of each.
//!
//! Lengths and units are those of the arguments. A tolerance is absolute, and zero means rounding.

pub mod bisection;
pub mod chebyshev;
pub mod cubic;
pub mod distribution;
pub mod eigenvalues;
pub mod elimination;
pub mod fourier;
pub mod gauss;
pub mod golden_section;
pub mod hermitian;
pub mod least_squares;
pub mod matrix;
pub mod normal_distribution;
pub mod random_numbers;
pub mod simpson;
pub mod simultaneous_roots;
pub mod spherical_bessel;
pub mod square;
pub mod square_root;
