//! Checked keys, the mean state of a curve among them.

pub(crate) mod checked_keys;
pub(crate) mod from_curve;
pub(crate) mod from_profiles;
pub(crate) mod general_keys;
pub(crate) mod mean;
pub(crate) mod substitutes;
pub(crate) mod written_keys;
