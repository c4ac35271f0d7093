//! # The German of what Riffel says
//!
//! Physics and answers speak English and know of no other language. What leaves the program is put into German at its
//! edge, by [`in_german`]: where it is printed and beside each answer to the page.
//!
//! The identity of a sentence is its English wording with a name in braces for every value. The catalogue has the German
//! wording below it, with the same names:
//!
//! ```text
//! {place} leads: {sentence}
//! {place} liegt vorn: {sentence}
//! ```
//!
//! A value may be a sentence of the catalogue itself; else it stays, with the decimal comma. What somebody wrote stays in
//! any case: a path, a key, a single word in quotation marks. Of several wordings that fit, the one with the most letters
//! of its own is meant.
//!
//! ```
//! use riffel_words::in_german;
//!
//! let sentence = "`contact.friction` is 3, but must be between 0.001 and 2";
//! assert_eq!(in_german(sentence).unwrap(), "`contact.friction` ist 3, muss aber zwischen 0,001 und 2 liegen");
//! assert_eq!(in_german("cannot be found in it"), None);
//! ```
//!
//! A test holds the catalogue against the sources: no wording is left that nobody says any more, and the crates that
//! speak to people say nothing that the catalogue lacks, but for what is English in every language.

mod catalogue;
mod numbers;
mod wording;

pub use catalogue::{in_german, wordings};
pub use numbers::with_comma;
