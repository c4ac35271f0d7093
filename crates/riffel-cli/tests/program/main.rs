//! The program as its users meet it.

mod contact;
mod documentation;
mod files;
mod forecast;
mod roughness;
mod sandbox;
mod track;
