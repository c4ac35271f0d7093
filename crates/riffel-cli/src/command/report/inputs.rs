//! The files that a report is made of, with their fingerprints.

use std::path::Path;

use riffel_answers::report::Inputs;
use riffel_keys::text_file::is_standard_input;
use riffel_keys::{CaseError, Message, question, say};

use super::GivenCase;
use crate::arguments::Report;
use crate::fingerprint::fingerprint;

/// The files that the report is made of; `understood` is what that of the rail was understood as.
pub(super) fn inputs(
    arguments: &Report,
    given: Option<&GivenCase<'_>>,
    understood: Option<Message>,
) -> Result<Inputs, CaseError> {
    let mut inputs = Inputs::default();
    let record = &arguments.record;
    if let (Some(path), Some(understood)) = (&arguments.roughness, understood) {
        add(&mut inputs, say!(input_roughness), path, understood)?;
        for earlier in &record.earlier.files {
            let origin = say!(input_of_the_same_rail);
            add(&mut inputs, say!(input_earlier_record), earlier, origin)?;
        }
    }
    if let Some(given) = given {
        let file = &given.case.file;
        let title = file.title.as_deref();
        let title = title.map_or_else(|| say!(a_case), Message::verbatim);
        let words = match &given.overrides[..] {
            [] => title,
            overrides => say!(input_with, title = title, values = overrides.join(", ")),
        };
        add(&mut inputs, say!(input_case), given.path, words)?;
        if let Some(measurement) = &file.track.measurement {
            let folder = given.path.parent().unwrap_or_else(|| Path::new(""));
            let file = folder.join(&measurement.file);
            add(&mut inputs, say!(input_track_receptance), &file, say!(measured_word))?;
        }
    }
    if let Some(traffic) = &record.traffic {
        add(&mut inputs, say!(input_traffic), traffic, say!(input_vehicles))?;
    }
    for variant in &arguments.variants {
        add(&mut inputs, say!(variant_head), variant, say!(input_changes))?;
    }
    if let Some(format) = &record.layout.format {
        add(&mut inputs, say!(input_reader_profile), format, say!(input_layout))?;
    }
    for name in arguments.limit.iter().filter(|name| name.ends_with(".toml")) {
        add(&mut inputs, say!(input_limit_table), name.as_ref(), say!(input_of_your_own))?;
    }
    if let Some(site) = &arguments.site {
        add(&mut inputs, say!(input_site), site, say!(input_words_at_the_top))?;
    }
    Ok(inputs)
}

/// Put a file among the inputs, with its fingerprint.
fn add(inputs: &mut Inputs, role: Message, path: &Path, origin: Message) -> Result<(), CaseError> {
    let hash = match is_standard_input(path) || question::holds(path) {
        true => say!(standard_input),
        false => Message::verbatim(
            fingerprint(path).map_err(|reason| CaseError::data(path, format!("cannot read the file: {reason}")))?,
        ),
    };
    inputs.add(role, path, origin, hash);
    Ok(())
}
