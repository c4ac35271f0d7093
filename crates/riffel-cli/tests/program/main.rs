//! The program as its users meet it.

mod contact;
mod documentation;
mod files;
mod sandbox;
mod track;
