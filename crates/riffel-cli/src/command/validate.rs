//! `riffel validate`

use riffel_validation::CHECKS;

use crate::output::{Progress, print, text_table};

pub(crate) fn run() -> miette::Result<u8> {
    let progress = Progress::new("validation", CHECKS.len());
    let mut table = text_table(&["statement", "source", "expected", "Riffel", "tolerance", ""]);
    let mut failed = 0;
    for check in CHECKS {
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
    let total = CHECKS.len();
    print(&format!(
        "{table}\n{} of {total} checks hold\n",
        total - failed
    ))?;
    Ok(u8::from(failed > 0))
}
