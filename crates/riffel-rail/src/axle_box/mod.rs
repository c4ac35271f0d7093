//! Runs of axle-box acceleration: text in columns, WAV, universal files and arrays, read sample by sample.

mod arrays;
mod clock;
mod columns;
mod file;
mod head;
mod listener;
mod riff;
mod run_end;
mod sensor;
mod table;
mod universal;
mod wave;
mod witness;

pub use arrays::AxleBoxPlace;
pub use file::{AxleBoxFile, AxleBoxReading};
pub use head::AxleBoxLayout;
pub use run_end::RunEnd;

#[cfg(test)]
mod tests;
