//! One file for each command.

mod calibrate;
pub(crate) mod completions;
pub(crate) mod figures;
pub(crate) mod init;
pub(crate) mod man;
pub(crate) mod page;
mod passages;
pub(crate) mod question;
pub(crate) mod schema;
pub(crate) mod serve;
mod study;
pub(crate) mod validate;
