//! What answers say.

mod all_axes;
mod branches;
mod comparison;
mod forecast;
