//! Points of the sheet.

/// A point in pixels, x to the right and y downward.
pub(crate) type Point = (f64, f64);
