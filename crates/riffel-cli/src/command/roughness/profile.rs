//! A measured profile on the command line.

use std::path::Path;

use riffel_answers::roughness::ProfileAnswer;
use riffel_keys::{Language, say};
use riffel_rail::{LimitTable, LinePlace, Record};

use super::{bands_table, folder, grind_table, with_progress};
use crate::arguments::{Roughness, Statistics};
use crate::messages::{language, print_remarks};
use crate::output::{json, print};
use crate::staging::{Existing, Staging, write_file};

pub(super) fn run(path: &Path, record: Record, limits: &[LimitTable], arguments: &Roughness) -> miette::Result<()> {
    // A table that is none is told of before the work.
    let along = arguments.along.as_deref().map(LinePlace::read);
    let along = along.transpose()?.unwrap_or_default();
    let profile = judged(path, record, limits, &arguments.statistics)?.beside(along);
    if let Some(format) = &arguments.save_format {
        let existing = Existing::Keep("remove the file first");
        write_file(format, &profile.record.format.toml(), existing)?;
    }
    let document = json(&profile.document(path));
    if arguments.json {
        print(&document)?;
        print_remarks(&profile.warnings);
        if arguments.output.is_none() {
            return Ok(());
        }
    }
    let folder = folder(path, arguments.output.as_deref());
    let mut staging = Staging::new("roughness", &folder)?;
    staging.write_figure("roughness", &profile.figure(path, limits, Language::English))?;
    staging.write_with("spectrum.csv", |file| profile.spectrum_csv(file))?;
    staging.write_with("blocks.csv", |file| profile.block_csv(file))?;
    staging.write_with("grind.csv", |file| profile.grind_csv(file))?;
    staging.write("summary.json", document)?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(readable(&profile, path) + &place))?;
        print_remarks(&profile.warnings);
    }
    Ok(())
}

/// A profile held to limits, with a bar of how far the work is.
pub(crate) fn judged(
    path: &Path,
    record: Record,
    limits: &[LimitTable],
    statistics: &Statistics,
) -> miette::Result<ProfileAnswer> {
    let request = statistics.request();
    let steps = ProfileAnswer::steps(&record);
    let profile = with_progress(riffel_keys::say!(progress_roughness), steps, |advance| {
        ProfileAnswer::new(path, record, limits, &request, advance)
    });
    Ok(profile?)
}

/// What was computed of a profile, for the terminal.
fn readable(profile: &ProfileAnswer, path: &Path) -> String {
    let removed = profile.removed();
    let mut text = format!("{}\n{}\n", path.display(), profile.understood());
    text += &format!(
        "{:.3} m to {:.3} m, {:.3} m of rail sampled every {:.4} mm; {} and {} removed\n",
        profile.record.from,
        profile.record.to,
        profile.length,
        1e3 * profile.record.spacing,
        say!(spikes, count = removed.spikes),
        say!(pits, count = removed.pits),
    );
    text += &bands_table(profile.rails.iter());
    if let Some(worst) = profile.worst() {
        text += &format!("{}\n", worst.text(language()));
    }
    for verdict in profile.verdicts() {
        text += &format!("{}\n", verdict.sentence.text(language()));
    }
    text + &grind_in_words(profile)
}

fn grind_in_words(profile: &ProfileAnswer) -> String {
    if !profile.knows_what_to_grind() {
        return String::new();
    }
    let sections = profile.sections();
    if sections.is_empty() {
        return format!("{}\n", profile.nothing_to_grind().text(language()));
    }
    let (rows, more) = grind_table(&sections);
    let more = more.map_or_else(String::new, |more| format!("{more}; "));
    format!("{rows}\n{more}{}\n", profile.total().text(language()))
}
