//! A measured profile on the command line.

use std::path::Path;

use riffel_answers::roughness::ProfileAnswer;
use riffel_rail::{LimitTable, LinePlace, Record};

use super::{results, with_progress};
use crate::arguments::{Roughness, Statistics};
use crate::staging::{Existing, write_file};

pub(super) fn run(path: &Path, record: Record, limits: &[LimitTable], arguments: &Roughness) -> miette::Result<()> {
    // A table that is none is told of before the work.
    let along = arguments.along.as_deref().map(LinePlace::read);
    let along = along.transpose()?.unwrap_or_default();
    let profile = judged(path, record, limits, &arguments.statistics)?.beside(along);
    if let Some(format) = &arguments.save_format {
        let existing = Existing::Keep("remove the file first");
        write_file(format, &profile.record.format.toml(), existing)?;
    }
    Ok(results(path, arguments).answer(&profile)?)
}

/// A profile held to limits, with a bar of how far the work is.
pub(crate) fn judged(
    path: &Path,
    record: Record,
    limits: &[LimitTable],
    statistics: &Statistics,
) -> miette::Result<ProfileAnswer> {
    let request = statistics.request();
    let steps = ProfileAnswer::steps(&record);
    let profile = with_progress(riffel_keys::say!(progress_roughness), steps, |advance| {
        ProfileAnswer::new(path, record, limits, &request, advance)
    });
    Ok(profile?)
}
