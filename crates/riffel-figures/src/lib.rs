//! Figures and tables made of a case: what the program writes and the page shows.
//!
//! `riffel_plot` draws and knows no physics, `riffel_case` knows no drawing; here a case and its growth map
//! become a figure with its caption, or a table.

mod error;
mod growth_table;
mod map;
pub mod paper;
mod track_in_words;

pub use error::FigureError;
pub use growth_table::{branches_csv, map_csv, map_netcdf, ridge_csv};
pub use map::{SIGN, Shown, map_figure, panel, parameters, polach};
pub use track_in_words::place;
