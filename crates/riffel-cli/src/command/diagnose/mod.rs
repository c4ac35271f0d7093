//! `riffel diagnose`

mod request;
mod words;

use riffel_keys::Language;

use super::roughness::read;
use crate::arguments::Diagnose;
use crate::messages::print_remarks;
use crate::output::{json, print};
use crate::staging::Staging;

pub(crate) use request::diagnosis;

pub(crate) fn run(arguments: &Diagnose) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let record = read(&arguments.roughness, &arguments.record.layout)?;
    let diagnosis = diagnosis(&case, &arguments.roughness, &record, &arguments.record)?;
    let file = arguments.roughness.display().to_string();
    let document = json(&diagnosis.document(&file));
    if arguments.results.json {
        print(&document)?;
        print_remarks(&diagnosis.warnings);
        if arguments.results.output.is_none() {
            return Ok(());
        }
    }
    let folder = arguments.case.folder(arguments.results.output.as_deref(), "diagnosis");
    let mut staging = Staging::new("diagnose", &folder)?;
    staging.write_figure("diagnosis", &diagnosis.figure(&file, Language::English))?;
    staging.write_with("candidates.csv", |file| diagnosis.candidates_csv(file))?;
    staging.write_with("places.csv", |file| diagnosis.places_csv(file))?;
    staging.write("diagnosis.json", document)?;
    let files = staging.publish()?;
    if !arguments.results.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(words::readable(&diagnosis, &file, &case) + &place))?;
        print_remarks(&diagnosis.warnings);
    }
    Ok(())
}
