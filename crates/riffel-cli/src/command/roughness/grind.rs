//! What to grind, for the terminal.

use riffel::roughness::GrindSection;
use riffel_answers::roughness::{RailAnswer, grind_row};

use crate::messages::language;
use crate::output::table;

/// Sections that a terminal shows; the file has all.
const SHOWN: usize = 20;

/// The first sections as a table, and a sentence on those that only the file has.
pub(crate) fn grind_table(sections: &[(&RailAnswer, &GrindSection)]) -> (String, Option<String>) {
    let mut rows = table(&["grind", "rail", "from m", "to m", "length m", "worst band mm", "rms/limit"]);
    for (index, (rail, section)) in sections.iter().take(SHOWN).enumerate() {
        rows.add_row(grind_row(index, rail, section, language()));
    }
    let more = sections.len().saturating_sub(SHOWN);
    (rows.to_string(), (more > 0).then(|| format!("{more} more in grind.csv")))
}
