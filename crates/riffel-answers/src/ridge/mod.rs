//! The ridge of growth: its points, its branches, in words and as tables.

mod branches;
mod point;
mod table;

pub use branches::{BranchDocument, best_fit_frequency, ridge_in, ridge_of};
pub(crate) use branches::{NEAR, mechanism_name, modes_of_axle, nearest, resonances};
pub use point::RidgePointDocument;
pub(crate) use table::{branches_table, ridge_table};
