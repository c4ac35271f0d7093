//! `riffel figures`

use riffel_answers::{ResultFile, paper};
use riffel_keys::Language;

use crate::arguments::Figures;
use crate::error::CliError;
use crate::output::print;
use crate::progress::Progress;
use crate::session::Session;
use crate::staging::Staging;

pub(crate) fn run(session: &Session, arguments: &Figures) -> miette::Result<()> {
    let mut staging = Staging::new(session, "figures", &arguments.output)?;
    let progress = Progress::new(session.voice, riffel_keys::say!(progress_figures), paper::FIGURES.len());
    let model = arguments.model.into();
    for (number, make) in paper::FIGURES {
        let figure = make(model, Language::English).map_err(CliError::from)?;
        staging.write_picture(&format!("figure-{number}"), &figure.picture().map_err(CliError::from)?)?;
        staging.write_result(ResultFile::TableAs(format!("figure-{number}"), figure.table))?;
        progress.advance(1);
    }
    drop(progress);
    let files = staging.publish()?;
    print(&format!("{}: {}\n", arguments.output.display(), files.join(" ")))?;
    Ok(())
}
