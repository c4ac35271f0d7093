//! Case files as users write them.

mod case_file;
mod measurement;
mod track;
