//! Parts that cases are built of and share.

pub(crate) mod shared;
pub(crate) mod short_waves;
pub(crate) mod track;
pub(crate) mod wheelset;
pub(crate) mod window;
