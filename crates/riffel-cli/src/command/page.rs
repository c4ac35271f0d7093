//! `riffel page`

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use riffel_web::{FILE_GENERATOR, PAGE_MODULE, page_file};

use crate::arguments::Page;
use crate::error::CliError;
use crate::output::print;
use crate::staging::{Existing, write_file};

/// Bytes at the beginning of a page in which it says what wrote it.
const HEAD: u64 = 1024;

pub(crate) fn run(arguments: &Page) -> miette::Result<()> {
    let case = arguments.read()?;
    let module = match &arguments.module {
        Some(path) => fs::read(path).map_err(|reason| CliError::ReadModule {
            path: path.clone(),
            reason,
        })?,
        None => PAGE_MODULE.ok_or(CliError::NoModule)?.to_vec(),
    };
    let page = page_file(&case.portable().keys, &module).map_err(|error| CliError::Page {
        message: error.to_string(),
        help: error.help().map(str::to_owned),
    })?;
    let existing = match arguments.force || is_page(&arguments.output) {
        true => Existing::Replace,
        false => Existing::Keep("--force to replace it"),
    };
    write_file(&arguments.output, &page, existing)?;
    print(&format!(
        "wrote {}, {:.1} MB; open it in a browser: it needs no server and no network\n",
        arguments.output.display(),
        page.len() as f64 / 1e6
    ))?;
    Ok(())
}

/// True if a file is a page that was written before: it is written anew, as a report is.
fn is_page(path: &Path) -> bool {
    let mut head = Vec::new();
    File::open(path)
        .and_then(|file| file.take(HEAD).read_to_end(&mut head))
        .is_ok_and(|_| String::from_utf8_lossy(&head).contains(FILE_GENERATOR))
}
