//! # Files of keys
//!
//! What reading any of Riffel's TOML files needs, whatever its keys are: quantities with units and physical ranges,
//! the text with the place of each key, errors that show the line, messages in several languages.
//!
//! ```
//! use riffel_keys::quantity::{Length, Quantity};
//! use riffel_keys::{KeyFile};
//!
//! #[derive(serde::Deserialize)]
//! struct Wheel {
//!     radius: Quantity<Length>,
//! }
//! let file = KeyFile::parse("wheel.toml", "radius = \"460 mm\"")?;
//! assert_eq!(file.deserialize::<Wheel>()?.radius.si(), 0.46);
//!
//! let wrong = KeyFile::parse("wheel.toml", "radius = \"460 kg\"")?.deserialize::<Wheel>().err();
//! assert!(wrong.is_some_and(|error| error.to_string().starts_with("`radius`")));
//! # Ok::<(), riffel_keys::CaseError>(())
//! ```

mod binary_format;
mod error;
mod excerpt;
mod json;
mod key_file;
mod language;
pub mod message;
pub mod money;
mod physics_in_words;
mod printable;
mod profile_in_words;
pub mod quantity;
pub mod question;
mod range;
pub mod seal;
mod standard_input;
pub mod table;
pub mod text_file;
mod texts_in_memory;
mod unit;
pub mod universal_file;

pub use binary_format::BinaryFormat;
pub use error::CaseError;
pub use excerpt::clipped;
pub use key_file::{KeyFile, overridden_key};
pub use language::Language;
pub use message::{
    Message, Value, Words, decimal, fixed, number, range, shown_speed, shown_speeds, significant, significant_digits,
};
pub use physics_in_words::physics_in_words;
pub use range::{PhysicalRange, bound};
pub use unit::{Exponents, Unit};
