//! The rail that a wheel rolls along: of a file, or made.

use std::path::Path;

use riffel::roughness::{Profile, Spectrum, Weld};
use riffel_case::Case;
use riffel_keys::{CaseError, fixed, number, say};
use riffel_rail::{GroundRail, LabelledSpectrum, RoughnessFile, Survey};

use super::refused;
use crate::question::{Client, RecordLayout};
use crate::{AnswerError, Result};

/// A length of whole bays, the next longer one.
pub(super) fn whole_bays(length: f64, bay: f64, client: &dyn Client) -> f64 {
    let whole = (length / bay - 1e-6).ceil() * bay;
    if (whole / length - 1.0).abs() > 1e-6 {
        client.say(say!(rail_of_whole_bays, length = fixed(whole, 3), bay = number(bay)));
    }
    whole
}

/// A rail with the levels of a limit or a file, but those of waves that the patch covers.
pub(super) fn drawn(
    (name, seed): (&str, u64),
    case: &Case,
    [length, step]: [f64; 2],
    client: &dyn Client,
) -> Result<Profile> {
    let spectrum = match GroundRail::is_table(name) {
        true => GroundRail::of_table(name)?.spectrum,
        false => at_the_end(RecordLayout::default().survey(Path::new(name), client)?, client)?.mean(),
    };
    let patch = 2.0 * case.hertz.semi_axis_longitudinal();
    let longer = spectrum.levels().iter().filter(|level| level.band.wavelength_range().0 >= patch);
    let kept = Spectrum::new(longer.map(|level| (level.band, level.level)));
    let kept = kept.map_err(|_| {
        let message = format!("the spectrum has no band above {:.1} mm, the length of the contact", 1e3 * patch);
        CaseError::data(name, message)
    })?;
    let left = spectrum.levels().len() - kept.levels().len();
    if left > 0 {
        client.say(say!(bands_below_patch_left_out, bands = number(left), length = fixed(1e3 * patch, 1)));
    }
    let longest = kept.levels().last().map_or(0.0, |level| level.band.wavelength());
    kept.drawn(length, step, seed).map_err(|error| match error {
        riffel::Error::OutOfRange { quantity: "length of the profile", .. } => AnswerError::argument(
            "--length",
            format!("{length} m"),
            format!(
                "at least {:.1} m, thirteen of the longest waves of the spectrum, {longest:.3} m, so that every \
                 band has three waves",
                13.0 * longest
            ),
        ),
        error => refused("--spectrum")(error).into(),
    })
}

/// Of levels over passages, such as `bands.csv`, those after the most; of others all.
fn at_the_end(levels: Survey, client: &dyn Client) -> Result<Survey, CaseError> {
    const COLUMN: &str = "passages";
    let number = |label: &str| label.parse::<f64>().unwrap_or(f64::NEG_INFINITY);
    let stages = levels.records.iter().map(|record| record.label(COLUMN));
    let last = stages.flatten().max_by(|one, other| number(one).total_cmp(&number(other)));
    let Some(last) = last.map(str::to_owned) else {
        return Ok(levels.latest().0);
    };
    client.say(say!(levels_after_passages_taken, passages = &last));
    let mut choices = vec![format!("{COLUMN}={last}")];
    // Two columns of levels stand beside each other there, as of two rails.
    let is_own = |record: &LabelledSpectrum| record.label("rail") == Some("level_db");
    if levels.records.iter().any(is_own) {
        choices.push("rail=level_db".to_owned());
    }
    levels.choose(&choices)
}

/// A rail with a weld in its middle.
pub(super) fn dipped(weld: Weld, [length, step]: [f64; 2]) -> Result<Profile> {
    Ok(weld.profile(length, step).map_err(refused("--weld"))?)
}

/// The profile of a file: one rail, its longest stretch without a gap.
pub(super) fn record(path: &Path, layout: &RecordLayout, length: Option<f64>, client: &dyn Client) -> Result<Profile> {
    let refuse = |message: String| CaseError::data(path, message);
    let RoughnessFile::Profile(record) = layout.read(path, client)? else {
        Err(refuse("the file is a table of levels, but a wheel rolls along a profile".to_owned()))?
    };
    let rail = match &record.rails[..] {
        [rail] => rail,
        rails => {
            let names: Vec<&str> = rails.iter().map(|rail| rail.name.as_str()).collect();
            Err(refuse(format!("the file has the rails {}; choose one by --rail", names.join(", "))))?
        }
    };
    let longest = rail.stretches.iter().max_by(|one, other| one.length().total_cmp(&other.length()));
    let profile = longest.ok_or_else(|| refuse("the rail has no heights".to_owned()))?;
    if rail.stretches.len() > 1 {
        client.say(say!(
            longest_stretch_taken,
            stretches = number(rail.stretches.len()),
            start = fixed(profile.start(), 3)
        ));
    }
    record.warnings.iter().for_each(|warning| client.say(warning.clone()));
    let Some(length) = length else {
        return Ok(profile.clone());
    };
    let start = profile.start();
    if length > profile.length() + profile.spacing() {
        Err(refuse(format!("--length is {length} m, but the profile has {:.3} m without a gap", profile.length())))?;
    }
    let part = profile.between(start, start + length);
    Ok(part.ok_or_else(|| refuse(format!("--length is {length} m, less than two samples")))?)
}
