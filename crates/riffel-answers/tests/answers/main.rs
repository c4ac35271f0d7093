//! What answers say.

mod all_axes;
mod axlebox;
mod branches;
mod comparison;
mod forecast;
mod line_growth;
mod motions;
mod shakedown;
