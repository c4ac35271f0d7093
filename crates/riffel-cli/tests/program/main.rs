//! The program as its users meet it.

mod all_axes;
mod axlebox;
mod book;
mod contact;
mod curving;
mod diagnose;
mod documentation;
mod evolution;
mod files;
mod forecast;
mod habits;
mod models;
mod network;
mod noise;
mod pictures;
mod profiles;
mod rails;
mod reading;
mod report;
mod roughness;
mod sandbox;
mod simulate;
mod study;
mod track;
mod wheelset;
mod writing;
