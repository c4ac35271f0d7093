//! `riffel validate`

use riffel_validation::{CHECKS, Check};

use crate::arguments::Validate;
use crate::error::CliError;
use crate::output::{Progress, print, text_table};

pub(crate) fn run(arguments: &Validate) -> miette::Result<u8> {
    let checks = chosen(&arguments.words)?;
    let progress = Progress::new("validation", checks.len());
    let mut table = text_table(&["statement", "source", "expected", "Riffel", "tolerance", ""]);
    let mut failed = 0;
    for check in &checks {
        let row = (check.run)();
        progress.advance(1);
        failed += usize::from(!row.holds);
        let verdict = if row.holds { "holds" } else { "FAILS" };
        table.add_row([
            row.statement,
            row.source,
            &row.expected,
            &row.got,
            row.tolerance,
            verdict,
        ]);
    }
    drop(progress);
    let total = checks.len();
    print(&format!(
        "{table}\n{} of {total} checks hold\n",
        total - failed
    ))?;
    Ok(u8::from(failed > 0))
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
