//! `riffel axlebox`

use std::path::{Path, PathBuf};

use riffel_answers::axlebox::AxleBoxAnswer;
use riffel_rail::AxleBoxFile;

use super::roughness::limits;
use crate::arguments::{AxleBox, stem};
use crate::messages::print_remarks;
use crate::progress::Progress;
use crate::results::Results;

pub(crate) fn run(arguments: &AxleBox) -> miette::Result<()> {
    let (layout, request) = (arguments.layout()?, arguments.request()?);
    let limits = limits(&arguments.limit)?;
    let case = arguments.case().read()?;
    let mut files = Vec::new();
    for path in &arguments.paths {
        files.push((path.clone(), AxleBoxFile::open(path, &layout)?));
    }
    let sizes = arguments.paths.iter().filter_map(|path| std::fs::metadata(path).ok());
    let size: u64 = sizes.map(|file| file.len()).sum();
    let progress = Progress::new(riffel_keys::say!(progress_listening), size as usize);
    let answer = AxleBoxAnswer::new(&case, &files, &limits, &request, &|by| progress.advance(by))?;
    drop(progress);
    let first = arguments.paths.first().map_or_else(|| Path::new(""), PathBuf::as_path);
    Results::named("axlebox", stem(first), &arguments.results).answer(&answer)?;
    print_remarks(&case.remarks);
    Ok(())
}
