//! What a sensor on an axle box reads.

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Acceleration of the axle box \[m/s²\], upward.
    pub acceleration: f64,
    /// Position of the wheel along the rail \[m\], by the odometer or by the integral of the speed; it does not fall.
    pub position: f64,
}
