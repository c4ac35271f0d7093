//! Constants that laws, units and files share.

/// Standard acceleration of free fall \[m/s²\] (3rd General Conference on Weights and Measures, 1901), which turns a
/// mass into a load.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Density of the steel of rails, wheels and axles \[kg/m³\].
pub const STEEL_DENSITY: f64 = 7850.0;

/// Lateral shift \[m\] at which a wheel has left its rail: half the width of a tread of 135 mm less its flange.
pub const FARTHEST_SHIFT: f64 = 0.06;

/// Yaw \[rad\] beyond which the springs and the geometry of the contacts are no longer those of the equations.
pub const LARGEST_YAW: f64 = 0.1;
