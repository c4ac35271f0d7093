//! `riffel page`

use std::fs;

use riffel_web::{FILE_GENERATOR, PAGE_MODULE, page_file};

use crate::arguments::Page;
use crate::error::CliError;
use crate::output::print;
use crate::session::Session;
use crate::staging::{Existing, write_file};

pub(crate) fn run(session: &Session, arguments: &Page) -> miette::Result<()> {
    let case = arguments.read(session)?;
    let module = match &arguments.module {
        Some(path) => fs::read(path).map_err(|reason| CliError::ReadModule { path: path.clone(), reason })?,
        None => PAGE_MODULE.ok_or(CliError::NoModule)?.to_vec(),
    };
    let page = page_file(&riffel_case::PortableCase::of(&case).keys, &module)
        .map_err(|error| CliError::Page { message: error.to_string(), help: error.help().map(str::to_owned) })?;
    let existing = match arguments.force {
        true => Existing::Replace,
        false => Existing::known(&arguments.output, &page, Some(FILE_GENERATOR)),
    };
    write_file(session, &arguments.output, &page, existing)?;
    print(&format!(
        "wrote {}, {:.1} MB; open it in a browser: it needs no server and no network\n",
        arguments.output.display(),
        page.len() as f64 / 1e6
    ))?;
    Ok(())
}
