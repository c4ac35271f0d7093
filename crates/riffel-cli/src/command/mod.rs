//! One file for each command.

pub(crate) mod calibrate;
pub(crate) mod completions;
pub(crate) mod decide;
pub(crate) mod figures;
pub(crate) mod init;
pub(crate) mod man;
pub(crate) mod network;
pub(crate) mod page;
pub(crate) mod presets;
pub(crate) mod question;
pub(crate) mod schema;
pub(crate) mod serve;
pub(crate) mod simulate;
pub(crate) mod study;
pub(crate) mod validate;
