//! The rail that `riffel simulate` rolls along.

use std::path::Path;

use riffel::roughness::{Profile, Spectrum, Weld};
use riffel_answers::question::RecordLayout;
use riffel_answers::simulate::Surface;
use riffel_case::Case;
use riffel_keys::{CaseError, fixed, number, say as message};
use riffel_rail::{GroundRail, LabelledSpectrum, RoughnessFile, Survey};

use crate::arguments::{Layout, LengthPair, Simulate, positive};
use crate::error::CliError;
use crate::messages::say;
use crate::terminal::Terminal;

/// Length of a rail that is made, where none is asked for \[m\].
const USUAL_LENGTH: f64 = 20.0;

/// Longest rail that is made \[m\]: two million heights.
const MOST_LENGTH: f64 = 1000.0;

/// The rail asked for, whose heights lie no farther apart than a step \[m\] where they are made.
pub(super) fn surface(arguments: &Simulate, case: &Case, step: f64) -> miette::Result<Surface> {
    let length = arguments.length.map(|length| positive("--length", length)).transpose()?;
    if arguments.profile.is_none() {
        arguments.only_for_profiles(arguments.layout.given())?;
        if let Some(length) = length.filter(|length| *length > MOST_LENGTH) {
            Err(CliError::Argument {
                argument: "--length",
                value: format!("{length} m"),
                rule: format!("at most {MOST_LENGTH} m for a rail that is made"),
            })?;
        }
    }
    if arguments.spectrum.is_none() && arguments.seed.is_some() {
        Err(CliError::Argument {
            argument: "--seed",
            value: "given".to_owned(),
            rule: "left out: it is for --spectrum".to_owned(),
        })?;
    }
    let made = || {
        let length = length.unwrap_or(USUAL_LENGTH);
        match case.track.support_spacing() {
            Some(bay) if arguments.passages.is_some() => whole_bays(length, bay),
            _ => length,
        }
    };
    if let Some(name) = &arguments.spectrum {
        let length = made();
        return Ok(Surface::Ring(drawn(name, arguments.seed.unwrap_or(1), case, length, step)?));
    }
    if let Some(weld) = &arguments.weld {
        return Ok(Surface::Ring(dipped(weld, made(), step)?));
    }
    // The parser asks for one of them.
    let path = arguments.profile.as_deref().unwrap_or_else(|| Path::new(""));
    Ok(Surface::Record(record(path, &arguments.layout, length)?))
}

/// A length of whole bays, the next longer one.
fn whole_bays(length: f64, bay: f64) -> f64 {
    let whole = (length / bay - 1e-6).ceil() * bay;
    if (whole / length - 1.0).abs() > 1e-6 {
        say(message!(rail_of_whole_bays, length = fixed(whole, 3), bay = number(bay)));
    }
    whole
}

/// A rail with the levels of a limit or a file, but those of waves that the patch covers.
fn drawn(name: &str, seed: u64, case: &Case, length: f64, step: f64) -> miette::Result<Profile> {
    let spectrum = match GroundRail::is_table(name) {
        true => GroundRail::of_table(name)?.spectrum,
        false => at_the_end(RecordLayout::default().survey(Path::new(name), &Terminal)?)?.mean(),
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
        say(message!(bands_below_patch_left_out, bands = number(left), length = fixed(1e3 * patch, 1)));
    }
    let longest = kept.levels().last().map_or(0.0, |level| level.band.wavelength());
    Ok(kept.drawn(length, step, seed).map_err(|error| match error {
        riffel::Error::OutOfRange {
            quantity: "length of the profile",
            ..
        } => CliError::Argument {
            argument: "--length",
            value: format!("{length} m"),
            rule: format!(
                "at least {:.1} m, thirteen of the longest waves of the spectrum, {longest:.3} m, so that every band has \
                 three waves",
                13.0 * longest
            ),
        },
        error => of("--spectrum", error),
    })?)
}

/// Of levels over passages, such as `bands.csv`, those after the most; of others all.
fn at_the_end(levels: Survey) -> Result<Survey, CaseError> {
    const COLUMN: &str = "passages";
    let number = |label: &str| label.parse::<f64>().unwrap_or(f64::NEG_INFINITY);
    let stages = levels.records.iter().map(|record| record.label(COLUMN));
    let last = stages.flatten().max_by(|one, other| number(one).total_cmp(&number(other)));
    let Some(last) = last.map(str::to_owned) else {
        return Ok(levels.latest().0);
    };
    say(message!(levels_after_passages_taken, passages = &last));
    let mut choices = vec![format!("{COLUMN}={last}")];
    // Two columns of levels stand beside each other there, as of two rails.
    let is_own = |record: &LabelledSpectrum| record.label("rail") == Some("level_db");
    if levels.records.iter().any(is_own) {
        choices.push("rail=level_db".to_owned());
    }
    levels.choose(&choices)
}

/// A rail with a weld in its middle.
fn dipped(weld: &LengthPair, length: f64, step: f64) -> miette::Result<Profile> {
    let [depth, length_of_weld] = weld.positive("--weld")?;
    let weld = Weld { depth, length: length_of_weld };
    Ok(weld.profile(length, step).map_err(|error| of("--weld", error))?)
}

fn of(argument: &str, error: riffel::Error) -> CliError {
    CliError::Physics { input: argument.to_owned(), error }
}

/// The profile of a file: one rail, its longest stretch without a gap.
fn record(path: &Path, layout: &Layout, length: Option<f64>) -> miette::Result<Profile> {
    let refuse = |message: String| CaseError::data(path, message);
    let RoughnessFile::Profile(record) = layout.records().read(path, &Terminal)? else {
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
        say(message!(
            longest_stretch_taken,
            stretches = number(rail.stretches.len()),
            start = fixed(profile.start(), 3)
        ));
    }
    for warning in &record.warnings {
        say(warning);
    }
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
