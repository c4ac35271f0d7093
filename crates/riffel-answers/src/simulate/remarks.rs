//! What the reader of a march should know.

use riffel::passage::{Outcome, PassageModel, Settled, Sinusoid, SmoothRail, TransientContact};
use riffel::roughness::Profile;
use riffel_keys::{Message, fixed, say};
use riffel_rail::{Rail, unlike_a_rail};

/// A share above which a reader would see it in a first harmonic: one per cent rms.
const WORTH_A_REMARK: f64 = 1e-4;

/// Share for track and wheels together, whose errors meet: a twentieth of a per cent rms leaves some 10⁻³ of a harmonic.
const WORTH_A_REMARK_TOGETHER: f64 = 2.5e-7;

/// That heights are unlike a rail: they may be in another unit.
pub(super) fn of_profile(profile: &Profile) -> Option<Message> {
    let rail = Rail { name: "profile".to_owned(), stretches: vec![profile.clone()] };
    unlike_a_rail(&[rail])
}

/// That receptances in time are not those of the case, where that is worth a word.
pub(super) fn of_track(model: &PassageModel) -> Option<Message> {
    let structures = &model.structures;
    let share = structures.share_cut();
    let per_cent = 100.0 * share.sqrt();
    match structures.are_fitted_together() {
        false => (share > WORTH_A_REMARK).then(|| say!(loss_factors_not_causal, per_cent = fixed(per_cent, 1))),
        true => (share > WORTH_A_REMARK_TOGETHER).then(|| {
            let most = 100.0 * structures.largest_error();
            say!(fitted_receptances_off, per_cent = fixed(per_cent, 2), most = fixed(most, 1))
        }),
    }
}

/// That a linear loop and what follows a push do not say the same, if so.
pub(super) fn of_linear_loop(motion: &SmoothRail, unstable_roots: Option<usize>) -> Option<Message> {
    /// Of the normal force: below it nothing is seen to move.
    const STILL: f64 = 1e-4;
    let still = motion.contacts.iter().all(|swing| {
        let [least, most] = swing.normal_force;
        let ranges = [swing.normal_force, swing.tangential_force, swing.lateral_force];
        ranges.iter().all(|[from, to]| to - from < STILL * least.max(most))
    });
    match (motion.outcome, unstable_roots) {
        (Outcome::Irregular, Some(1..)) if still => Some(say!(unstable_but_still)),
        (Outcome::LimitCycle, Some(0)) => Some(say!(stable_but_limit_cycle)),
        _ => None,
    }
}

/// That supports shake the wheel with a wave much as long as the profile's.
pub(super) fn of_supports(model: &PassageModel, profile: &Sinusoid) -> Option<Message> {
    let spacing = model.structures.support_spacing()?;
    let line = profile.shares_lines_with(spacing)?;
    let length = 1e3 * spacing / line as f64;
    Some(say!(support_passing_close_to_wave, length = fixed(length, 1)))
}

/// That a run ended before it was done, since the wheel was in the air.
pub(super) fn of_air(passages: u64) -> Message {
    say!(airborne_run_ends, passages)
}

/// That wheels on a smooth rail slide off.
pub(super) fn of_sliding() -> Message {
    say!(wheels_slide_as_they_roll)
}

/// That the wheel is too large for the troughs of a sinusoid of amplitude Δ and wavelength λ, Δ > λ²/(4π²R).
pub(super) fn of_troughs(amplitude: f64, wavelength: f64, rolling_radius: f64) -> Option<Message> {
    let wavenumber = std::f64::consts::TAU / wavelength;
    let largest = 1.0 / (wavenumber * wavenumber * rolling_radius);
    (amplitude > largest).then(|| {
        let largest = 1e6 * largest;
        say!(wheel_bridges_trough, largest = fixed(largest, 0))
    })
}

/// That the edge of a contact made of elements moves by too few of them.
pub(super) fn of_elements(contact: &TransientContact, settled: &Settled, profile: Sinusoid) -> Option<Message> {
    /// From which on the errors of a first harmonic are 2 to 3 %.
    const RESOLVED: f64 = 1.4;
    let moves = contact.elements_of_edge(settled, profile);
    (moves < RESOLVED).then(|| {
        let across = contact.across;
        say!(edge_of_patch_not_resolved, moves = fixed(moves, 2), across, resolved = RESOLVED)
    })
}
