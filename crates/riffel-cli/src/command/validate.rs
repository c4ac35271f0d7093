//! `riffel validate`

use riffel_answers::Banded;
use riffel_validation::field::{self, Measured, SiteDocument};
use riffel_validation::{CHECKS, Check};

use crate::arguments::Validate;
use crate::error::CliError;
use crate::output::{print, print_json, text_table};
use crate::progress::Progress;

pub(crate) fn run(arguments: &Validate) -> miette::Result<u8> {
    if arguments.field {
        return run_field(arguments);
    }
    let checks = chosen(&arguments.words)?;
    let progress = Progress::new(riffel_keys::say!(progress_validation), checks.len());
    let mut table = text_table(&["statement", "source", "expected", "Riffel", "tolerance", ""]);
    let mut failed = 0;
    for check in &checks {
        let row = (check.run)();
        progress.advance(1);
        failed += usize::from(!row.holds);
        let verdict = if row.holds { "holds" } else { "FAILS" };
        table.add_row([row.statement, row.source, &row.expected, &row.got, row.tolerance, verdict]);
    }
    drop(progress);
    let total = checks.len();
    print(&format!("{table}\n{} of {total} checks hold\n", total - failed))?;
    Ok(u8::from(failed > 0))
}

/// The sites of the field.
fn run_field(arguments: &Validate) -> miette::Result<u8> {
    let samples = arguments.samples as usize;
    let progress = Progress::new(riffel_keys::say!(progress_field), field::runs(samples)?);
    let document = field::field(samples, arguments.seed, &|count| progress.advance(count))?;
    drop(progress);
    if arguments.json {
        print_json(&document)?;
        return Ok(0);
    }
    let mut table = text_table(&["site", "what", "unit", "median", "80 %", "measured", "inside"]);
    for site in &document.cases {
        for row in rows_of(site) {
            table.add_row(row);
        }
    }
    let mut text = format!("{table}\n");
    for site in &document.cases {
        if let Some(reason) = &site.reason {
            text += &format!("{}: {reason}\n", site.name);
        }
    }
    if let (Some(share), Some(score)) = (document.inside_share, document.log_score) {
        text += &format!(
            "{:.0} % of the published outcomes lie inside their bands of 80 %; logarithmic score {score:.2}\n",
            100.0 * share
        );
    }
    print(&text)?;
    Ok(0)
}

/// What is predicted of a site, then its outcomes.
fn rows_of(site: &SiteDocument) -> Vec<Vec<String>> {
    let row = |what: &str, unit: &str, predicted: Option<Banded>, measured: String, inside: &str| {
        let number = |value: f64| format!("{value:.3e}").parse().map_or(String::new(), plain);
        let [median, band] = predicted.map_or_else(Default::default, |it| {
            let [low, high] = it.band_80.map(number);
            [number(it.median), format!("{low} to {high}")]
        });
        vec![site.name.clone(), what.to_owned(), unit.to_owned(), median, band, measured, inside.to_owned()]
    };
    let of = [("", &site.predicted), (", no wave geometry", &site.without_wave_geometry)];
    let mut rows = Vec::new();
    for (how, it) in of {
        let quantities = [
            ("wavelength", "mm", it.wavelength_mm),
            ("frequency", "Hz", it.frequency_hz),
            ("growth", "dB per million axles", it.growth_db_per_million_axles),
            ("growth", "dB a month", it.growth_db_per_month),
            ("mean wear", "mm per 100 MGT", it.mean_wear_mm_per_100_mgt),
        ];
        rows.extend(
            quantities
                .into_iter()
                .map(|(what, unit, predicted)| row(&format!("{what}{how}"), unit, predicted, String::new(), "")),
        );
    }
    rows.extend(site.outcomes.iter().map(|outcome| {
        let measured = match outcome.measured {
            Measured::Number(number) => plain(number),
            Measured::Ends([Some(low), Some(high)]) => format!("{} to {}", plain(low), plain(high)),
            Measured::Ends([Some(low), None]) => format!("from {}", plain(low)),
            Measured::Ends([None, high]) => format!("up to {}", high.map_or(String::new(), plain)),
        };
        let inside = if outcome.inside { "inside" } else { "OUTSIDE" };
        row(&outcome.what, &outcome.unit, outcome.predicted, measured, inside)
    }));
    rows
}

/// A number as it is written.
fn plain(number: f64) -> String {
    format!("{number}")
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
