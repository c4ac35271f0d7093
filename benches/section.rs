//! A section of the report: its text, and how far the results of the contestants agree.

use std::fmt;

/// A section as it is written.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    text: String,
    comparisons: Vec<Comparison>,
}

/// The largest difference of results that should be the same.
struct Comparison {
    what: &'static str,
    /// Difference over the result.
    difference: f64,
    tolerance: f64,
}

impl Comparison {
    fn agrees(&self) -> bool {
        self.difference <= self.tolerance
    }
}

impl Section {
    pub(crate) fn new(title: &'static str) -> Self {
        Self { title, text: String::new(), comparisons: Vec::new() }
    }

    /// Compare a result with the one expected; a difference above the tolerance is told in the section, and by [`agrees`](Self::agrees).
    pub(crate) fn compare(&mut self, what: &'static str, (found, expected): (f64, f64), tolerance: f64) {
        let difference = ((found - expected) / expected).abs();
        // A difference that is no number is the largest.
        let difference = if found == expected { 0.0 } else { difference };
        match self.comparisons.iter_mut().find(|known| known.what == what) {
            Some(known) if difference > known.difference || difference.is_nan() => known.difference = difference,
            Some(_) => {}
            None => self.comparisons.push(Comparison { what, difference, tolerance }),
        }
    }

    /// What was compared, and how far it differs, in one line.
    pub(crate) fn comparisons(&self) -> String {
        let each = self.comparisons.iter().map(|one| {
            let verdict = if one.agrees() { "" } else { ", more than it may" };
            format!("{} to {:.0e}{verdict}", one.what, one.difference)
        });
        match each.collect::<Vec<_>>() {
            none if none.is_empty() => "done".to_owned(),
            all => all.join("; "),
        }
    }

    /// Whether all results that were compared agree.
    pub(crate) fn agrees(&self) -> bool {
        self.comparisons.iter().all(Comparison::agrees)
    }
}

impl fmt::Write for Section {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.text.write_str(text)
    }
}

/// The section below its title, with a table of what was compared.
impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.text)?;
        if self.comparisons.is_empty() {
            return Ok(());
        }
        writeln!(f, "\n| results of | differ by | at most | |\n|---|---|---|---|")?;
        for comparison in &self.comparisons {
            let Comparison { what, difference, tolerance } = comparison;
            let verdict = if comparison.agrees() { "" } else { "**they disagree** " };
            writeln!(f, "| {what} | {difference:.0e} | {tolerance:.0e} | {verdict}|")?;
        }
        Ok(())
    }
}
