//! The report of a rail.

mod site;

pub use site::Site;
