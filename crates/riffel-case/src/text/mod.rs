//! Cases as texts: keys as they were written, overridden and filled in by presets.

pub(crate) mod case_text;
pub(crate) mod description;
pub(crate) mod fill_in;
pub(crate) mod preset;
