//! The contact ellipse: Hertz's theory, Kalker's creep coefficients, and what the patch averages out of a rough rail.

mod contact_filter;
mod creep_coefficient;
mod curvature_filter;
mod elliptic_contact;
mod elliptic_integrals;
mod hertz;
mod kalker_coefficients;
mod kalker_table;
mod polynomial_punch;
mod unit_ellipse;

pub use contact_filter::ContactFilter;
pub use creep_coefficient::creep_coefficient;
pub use curvature_filter::CurvatureFilter;
pub(super) use elliptic_contact::contact_modulus;
pub use elliptic_contact::{ContactBody, EllipticContact};
pub use elliptic_integrals::EllipticIntegrals;
pub use hertz::HertzContact;
pub use kalker_coefficients::KalkerCoefficients;
pub(super) use polynomial_punch::{PolynomialPunch, TERMS};
