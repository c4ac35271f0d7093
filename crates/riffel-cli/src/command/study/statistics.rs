//! Outputs over the samples, for the terminal.

use riffel_answers::study::{Statistics, four_figures};

use crate::output::table;

/// The outputs as a table, nothing where there are none.
pub(super) fn table_of(outputs: &[Statistics]) -> String {
    if outputs.is_empty() {
        return String::new();
    }
    let mut table = table(&["over the samples", "unit", "mean", "5 %", "median", "95 %", "samples"]);
    for output in outputs {
        let numbers = [output.mean, output.quantile_05, output.median, output.quantile_95];
        let [mean, low, median, high] = numbers.map(four_figures);
        let samples = output.samples.to_string();
        let unit = if output.unit == "1" { "" } else { output.unit };
        table.add_row([output.name.clone(), unit.to_owned(), mean, low, median, high, samples]);
    }
    format!("{table}\n")
}
