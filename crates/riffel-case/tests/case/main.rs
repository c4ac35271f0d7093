//! Case files as users write them.

mod case_file;
mod contact;
mod measurement;
mod remarks;
mod track;
mod traffic;
