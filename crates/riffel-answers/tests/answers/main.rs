//! What answers say.

mod all_axes;
mod axlebox;
mod branches;
mod cause;
mod comparison;
mod forecast;
mod line_growth;
mod motions;
mod pass_by;
mod remedies;
mod shakedown;
