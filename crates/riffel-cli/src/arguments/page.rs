//! `riffel page`

use std::path::PathBuf;
use std::sync::Arc;

use clap::Args;
use riffel_answers::question::{CaseSource, Source};
use riffel_case::{Case, NOMINAL_CASE};

use crate::session::Session;
use crate::terminal::Terminal;

#[derive(Args)]
#[command(after_help = "Example: riffel page cases/metro.toml -o metro.html")]
pub(crate) struct Page {
    /// Case file to put into the page, or - for standard input [default: the nominal case].
    #[arg(value_name = "CASE")]
    pub(crate) case: Option<PathBuf>,

    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// Page to write.
    #[arg(short, long, value_name = "HTML", default_value = "riffel.html")]
    pub(crate) output: PathBuf,

    /// Replace the file if it is there and is no such page of an earlier run.
    #[arg(long)]
    pub(crate) force: bool,

    /// The answers as a compressed WebAssembly module, as `cargo xtask page` builds it [default: the one inside the
    /// program].
    #[arg(long, value_name = "WASM.GZ")]
    pub(crate) module: Option<PathBuf>,
}

impl Page {
    /// The case to put into the page.
    pub(crate) fn read(&self, session: &Session) -> miette::Result<Case> {
        match &self.case {
            Some(path) => {
                let case = CaseSource::new(Source::File(path.clone()), self.overrides.clone());
                Ok(Arc::unwrap_or_clone(case.read(&Terminal(session))?))
            }
            None => Ok(Case::parse("nominal.toml", NOMINAL_CASE, &self.overrides)?),
        }
    }
}
