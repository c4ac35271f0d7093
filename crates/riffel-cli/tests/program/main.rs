//! The program as its users meet it.

mod documentation;
mod files;
mod sandbox;
mod track;
