//! Constants that laws, units and files share.

/// Standard acceleration of free fall \[m/s²\] (3rd General Conference on Weights and Measures, 1901), which turns a
/// mass into a load.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Density of the steel of rails, wheels and axles \[kg/m³\].
pub const STEEL_DENSITY: f64 = 7850.0;
