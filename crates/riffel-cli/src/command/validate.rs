//! `riffel validate`

use riffel_validation::{CHECKS, Check, Checked, field};

use crate::arguments::Validate;
use crate::error::CliError;
use crate::output::{print, print_json};
use crate::progress::Progress;
use crate::results::in_words;
use crate::session::Session;

pub(crate) fn run(session: &Session, arguments: &Validate) -> miette::Result<u8> {
    if arguments.field {
        return run_field(session, arguments);
    }
    let checks = chosen(&arguments.words)?;
    let progress = Progress::new(session.voice, riffel_keys::say!(progress_validation), checks.len());
    let rows = checks.iter().map(|check| {
        let row = (check.run)();
        progress.advance(1);
        row
    });
    let checked = Checked(rows.collect());
    drop(progress);
    print(&in_words(session.voice, &checked))?;
    Ok(u8::from(checked.failed() > 0))
}

/// The sites of the field.
fn run_field(session: &Session, arguments: &Validate) -> miette::Result<u8> {
    let samples = arguments.samples as usize;
    let progress = Progress::new(session.voice, riffel_keys::say!(progress_field), field::runs(samples)?);
    let document = field::field(samples, arguments.seed, &|count| progress.advance(count))?;
    drop(progress);
    match arguments.json {
        true => print_json(session.voice, &document)?,
        false => print(&in_words(session.voice, &document))?,
    }
    Ok(0)
}

/// The checks with one of the words in their names, or all; a word that finds none is told.
fn chosen(words: &[String]) -> Result<Vec<&'static Check>, CliError> {
    let named = |check: &Check, word: &String| check.name.contains(&word.replace('-', "_"));
    for word in words {
        if !CHECKS.iter().any(|check| named(check, word)) {
            return Err(CliError::Argument {
                argument: "WORD",
                value: format!("{word:?}"),
                rule: "part of the name of a check, as ridge is of ridge_low_traction".to_owned(),
            });
        }
    }
    let wanted = |check: &&Check| words.is_empty() || words.iter().any(|word| named(check, word));
    Ok(CHECKS.iter().filter(wanted).collect())
}
