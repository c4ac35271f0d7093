//! Ridges as tables.

use std::io::{self, Write};

use riffel::Ridge;

use super::RidgePointDocument;

/// One row for each speed.
///
/// # Errors
/// Those of the file.
pub fn ridge_csv(ridge: &Ridge, file: &mut impl Write) -> io::Result<()> {
    let mut writer = writer(file);
    writer.write_record(RidgePointDocument::COLUMNS)?;
    for point in &ridge.points {
        writer.serialize(RidgePointDocument::from(point))?;
    }
    writer.flush()
}

/// One row for each point of each branch, counted from zero, the strongest.
///
/// # Errors
/// Those of the file.
pub fn branches_csv(ridge: &Ridge, file: &mut impl Write) -> io::Result<()> {
    let mut writer = writer(file);
    writer.write_record(["branch"].iter().chain(&RidgePointDocument::COLUMNS))?;
    for (index, branch) in ridge.branches.iter().enumerate() {
        for point in branch.points() {
            writer.serialize((index, RidgePointDocument::from(point)))?;
        }
    }
    writer.flush()
}

/// A writer of rows below a header that stands even where there are none.
fn writer<W: Write>(file: W) -> csv::Writer<W> {
    csv::WriterBuilder::new().has_headers(false).from_writer(file)
}
