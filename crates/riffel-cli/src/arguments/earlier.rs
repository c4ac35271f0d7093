//! Earlier records of a rail.

use std::path::PathBuf;

use clap::Args;
use jiff::civil::Date;
use riffel_answers::question::{EarlierRecords, Source};

/// Earlier records of the rail that is measured.
#[derive(Args, Clone, Default)]
pub(crate) struct Earlier {
    /// An earlier record of the same rail, by which it goes on growing; may be repeated, the oldest first.
    #[arg(long = "earlier", value_name = "FILE")]
    pub(crate) files: Vec<PathBuf>,

    /// Dates of all records, as 2026-01-31 or 31.01.2026, separated by commas, the oldest first and that of now last.
    #[arg(long, value_name = "DATES", value_delimiter = ',', requires = "files", value_parser = date)]
    pub(crate) dates: Vec<Date>,
}

impl Earlier {
    /// The same in a question.
    pub(crate) fn records(&self) -> EarlierRecords {
        EarlierRecords { earlier: self.files.iter().cloned().map(Source::File).collect(), dates: self.dates.clone() }
    }
}

/// A date on the command line.
fn date(text: &str) -> Result<Date, String> {
    riffel_rail::read_date(text).map_err(|said| said.to_string())
}
