//! Each method against closed forms, identities and other methods.

mod bisection;
mod chebyshev;
mod cubic;
mod distribution;
mod eigenvalues;
mod elimination;
mod gauss;
mod golden_section;
mod hermitian;
mod least_squares;
mod matrix;
mod normal_distribution;
mod random_numbers;
mod simpson;
mod simultaneous_roots;
mod spherical_bessel;
mod square_root;
