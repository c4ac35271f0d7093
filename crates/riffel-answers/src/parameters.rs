//! The parameters of a case in a sentence, for captions.

use riffel::contact::Creepages;
use riffel_case::Case;
use riffel_case::file::{CaseFile, ContactDynamics, CreepLawName, DissipationPhase, Rotation};
use riffel_keys::{Language, say};

use crate::track_in_words::{rail, track};

/// A value that a complete case always has.
fn si(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}

/// The parameters of Polach's law in words, where the case has any.
pub(crate) fn polach(file: &CaseFile) -> String {
    let Some(polach) = &file.contact.polach else {
        return String::new();
    };
    let reduction = format!("k_A = {}, k_S = {}", polach.adhesion_reduction, polach.slip_reduction);
    match (polach.limit_friction_ratio, polach.friction_decay, polach.speed) {
        (Some(ratio), Some(decay), Some(speed)) => {
            format!(" (A = {ratio}, B = {decay}, V = {speed}, {reduction})")
        }
        _ => format!(" ({reduction})"),
    }
}

/// The parameters of a case in one sentence, in English.
pub fn parameters(case: &Case) -> String {
    parameters_in(case, Language::English)
}

/// Parameters without the amplitude of the profile, for pictures of a rail that has another.
pub(crate) fn parameters_on_rail(case: &Case) -> String {
    written(case, Language::English, None)
}

/// The parameters of a case in one sentence.
pub(crate) fn parameters_in(case: &Case, language: Language) -> String {
    written(case, language, Some(case.feedback.amplitude()))
}

fn written(case: &Case, language: Language, amplitude: Option<f64>) -> String {
    let file = &case.file;
    let steady = case.steady;
    let rotation = match file.wheel.rotation() {
        Rotation::Inertia => format!("I_w = {:.2} kg m²", si(file.wheel.inertia.map(|inertia| inertia.si()))),
        Rotation::ConstantTangentialForce => say!(constant_tangential_force).text(language),
        Rotation::ConstantCreepage => say!(constant_creepage).text(language),
    };
    let wheel = match (&file.wheelset, file.wheel.mass) {
        (Some(wheelset), _) => {
            let name = say!(wheelset).text(language);
            format!("{name} {}", wheelset.model.name())
        }
        (None, mass) => format!("m_w = {:.0} kg, {rotation}", si(mass.map(|mass| mass.si()))),
    };
    let phase = match file.contact.dissipation_phase {
        _ if file.contact.response == ContactDynamics::NonSteady => say!(non_steady_contact).text(language),
        DissipationPhase::Lag => say!(phase_lag).text(language),
        DissipationPhase::Lead => say!(phase_lead).text(language),
        DissipationPhase::None => say!(phase_none).text(language),
    };
    let law = say!(creep_law).text(language);
    let law = match case.creep_law() {
        CreepLawName::CARTER_3D => String::new(),
        CreepLawName::POLACH => format!("{law} polach{}; ", polach(&case.file)),
        name => format!("{law} {}; ", name.name()),
    };
    let dynamics = match file.contact.response {
        ContactDynamics::SpringDashpot => say!(spring_and_dashpot).text(language),
        _ => String::new(),
    };
    let amplitude = amplitude.map_or(String::new(), |amplitude| format!("Δ = {:.1} µm; ", 1e6 * amplitude));
    let words = format!(
        "{}: {}. E = {:.0} GPa, ν = {}; R = {:.2} m, R_r = {:.2} m, {wheel}; {}P₀ = {:.0} kN, μ = {}, τ = {:.3}, {}; {amplitude}{law}{dynamics}{phase}.",
        say!(track).text(language),
        track(case, language),
        1e-9 * file.steel.youngs_modulus.si(),
        file.steel.poisson_ratio,
        file.wheel.rolling_radius.si(),
        file.contact.transverse_radius.si(),
        rail(case, language),
        1e-3 * steady.normal_force,
        steady.friction,
        steady.tractive_ratio(),
        creepage(steady.creepages),
    );
    language.numbers(&words)
}

/// The mean creepage: along the rail, or as a vector with its spin.
pub(crate) fn creepage(creepages: Creepages) -> String {
    let Creepages { longitudinal, lateral, spin } = creepages;
    // With the minus of the axes beside them.
    let written = |value: f64| format!("{value:.3}").replace('-', "−");
    let [longitudinal, lateral_percent] = [longitudinal, lateral].map(|it| written(100.0 * it));
    if lateral == 0.0 && spin == 0.0 {
        return format!("ξ₀ = {longitudinal} %");
    }
    let mut text = format!("ξ₀ = ({longitudinal}, {lateral_percent}) %");
    if spin != 0.0 {
        text += &format!(", φ₀ = {} 1/m", written(spin));
    }
    text
}
