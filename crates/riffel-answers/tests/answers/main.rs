//! What answers say.

mod branches;
mod comparison;
mod forecast;
