//! The page of the book that lists the physical ranges.

use std::fmt::Write as _;

use riffel_keys::PhysicalRange;

/// Every range with its keys and its reason.
pub(crate) fn page() -> String {
    let mut text = String::from(
        "# Physical ranges\n\n\
         Written by `cargo xtask generate` from the table of the program. A value outside the range that is *computed* is\n\
         an error, and nothing is written. A value outside the *usual* range is computed with a remark that asks for the\n\
         unit, which is the most frequent mistake: `friction = 40` may be 40 %, `rolling_radius = 460` 460 mm. A speed\n\
         above 40 without a unit is read in m/s, as everywhere, and asked about: it may be in km/h.\n\n\
         What is computed leaves room for roller rigs, twin discs of steel or polymer, and for the limits of thought\n\
         experiments. The schemas have these bounds as `minimum` and `maximum` of bare numbers. Keys that begin with\n\
         `vehicle` are those of the traffic file, with `speed` those of a file of changes, with `outputs` those of a plan.\n\n\
         | keys | computed | usual | reason |\n|---|---|---|---|\n",
    );
    for range in PhysicalRange::all() {
        let keys: Vec<String> = range.keys.iter().map(|key| format!("`{key}`")).collect();
        let words = |ends| range.in_words(ends).join(" to ");
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} |",
            keys.join(", "),
            words(range.hard),
            words(range.usual),
            range.reason
        );
    }
    text
}
