//! The track of a case in words, for captions.

use riffel_case::Case;
use riffel_case::file::{BeamModel, Support, TrackModel};
use riffel_keys::quantity::{Dimension, Quantity};
use riffel_keys::{Language, say};

/// A value in a unit of the given size, or "?" where the case has none.
fn value<D: Dimension>(quantity: Option<Quantity<D>>, unit: f64, decimals: usize) -> String {
    quantity.map_or_else(|| "?".to_owned(), |quantity| format!("{:.decimals$}", quantity.si() / unit))
}

/// The rail, if the model has one: "rail 56.0 kg/m, I = 2350 cm⁴; ".
pub(crate) fn rail(case: &Case, language: Language) -> String {
    let rail = &case.file.rail;
    if case.file.track.model == TrackModel::Measured {
        return String::new();
    }
    let moment = rail.second_moment.map_or(f64::NAN, |moment| moment.si());
    let mut words = format!(
        "{} {} kg/m, I = {:.0} cm⁴",
        say!(rail_word).text(language),
        value(rail.mass_per_length, 1.0, 1),
        1e8 * moment // m⁴ in cm⁴, as the catalogues of rails have it
    );
    if let Some(loss_factor) = rail.loss_factor {
        words.push_str(&format!(", η = {loss_factor}"));
    }
    words + "; "
}

/// Stiffness, damping and loss factor of a layer.
fn layer(support: Option<&Support>) -> String {
    let Some(support) = support else {
        return "?".to_owned();
    };
    let mut words = format!("{} MN/m", value(support.stiffness, 1e6, 0));
    if support.damping.is_some() {
        words.push_str(&format!(", {} kNs/m", value(support.damping, 1e3, 0)));
    }
    if let Some(loss_factor) = support.loss_factor {
        words.push_str(&format!(", η = {loss_factor}"));
    }
    words
}

/// The track of a case.
pub(crate) fn track(case: &Case, language: Language) -> String {
    let track = &case.file.track;
    let beam = match case.beam_model() {
        BeamModel::EulerBernoulli => "Euler",
        BeamModel::Timoshenko => "Timoshenko",
    };
    let moving =
        if track.model == TrackModel::MovingBeam { say!(under_moving_load).text(language) } else { String::new() };
    if let (TrackModel::Measured, Some(measurement)) = (track.model, &track.measurement) {
        let file = &measurement.file;
        return say!(receptance_from_file, file).text(language);
    }
    if case.track.support.is_none() {
        return say!(free_beam, beam, moving).text(language);
    }
    let pad = layer(track.pad.as_ref());
    let mut words = say!(rail_on_pads, beam, moving, pad).text(language);
    if matches!(case.track.support, Some(riffel::receptance::Support::TwoLayer { .. })) {
        let mass = track.sleeper.as_ref().and_then(|sleeper| sleeper.mass);
        let (mass, ballast) = (value(mass, 1.0, 0), layer(track.ballast.as_ref()));
        words += &say!(sleepers_and_ballast, mass, ballast).text(language);
    }
    let spacing = value(track.support_spacing, 1.0, 2);
    words += &say!(spacing, spacing).text(language);
    words +=
        &if track.model.is_periodic() { say!(discrete).text(language) } else { say!(spread_evenly).text(language) };
    if let Some(name) = &track.preset {
        words += &say!(from_preset, name).text(language);
    }
    words
}

/// Where the wheel stands on discrete supports, as a sentence; nothing on others.
pub fn place(case: &Case) -> String {
    let track = &case.file.track;
    if !track.model.is_periodic() {
        return String::new();
    }
    let position = track.position.map_or(0.0, |position| position.si());
    format!(" Wheel {position:.2} m from a support.")
}
