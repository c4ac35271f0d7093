//! # Arrays and whole files
//!
//! Arrays in zarr, version 3, that `xarray.open_zarr` opens, and files that are there whole or not at all. What
//! the arrays mean is known by who writes them: studies and networks.
//!
//! ```
//! use riffel_arrays::{Array, Values};
//!
//! let speed = Array::axis("speed", "speed", 3, "m/s", "speed of the vehicle");
//! let bytes = speed.encode(&Values::Numbers(vec![20.0, 30.0, 40.0]));
//! assert_eq!(bytes.len(), 3 * 8 + 4); // and the checksum
//! assert_eq!(speed.file(0), "speed/c/0");
//! ```

mod array;
mod band_axes;
mod group;
mod in_use;
mod together;
pub mod whole_file;

pub use array::{Array, DataType, Values};
pub use band_axes::band_axes;
pub use group::group;
pub use in_use::InUse;
pub use together::Together;

/// A document as a file of JSON that people read: indented, with a line end. Empty if it cannot be written as JSON,
/// which no document of numbers, texts and maps with texts as keys is.
pub fn json(document: &impl serde::Serialize) -> Vec<u8> {
    let mut text = serde_json::to_vec_pretty(document).unwrap_or_default();
    text.push(b'\n');
    text
}
