//! What the reader of a march should know.

use riffel::passage::{LoopInTime, Outcome, Settled, Sinusoid, TransientContact};
use riffel_keys::Remark;

/// A share above which a reader would see it in a first harmonic: one per cent rms.
const WORTH_A_REMARK: f64 = 1e-4;

/// The same for track and wheels together, whose errors meet: a twentieth of a per cent rms leaves some 10⁻³ of a harmonic.
const WORTH_A_REMARK_TOGETHER: f64 = 2.5e-7;

/// That receptances in time are not those of the case, where that is worth a word.
pub(super) fn of_track(model: &LoopInTime) -> Option<Remark> {
    let share = model.share_cut();
    let per_cent = 100.0 * share.sqrt();
    match model {
        LoopInTime::Longitudinal(_) => (share > WORTH_A_REMARK).then(|| {
            Remark::new(
                format!(
                    "loss factors are not causal: in time the track is the nearest causal one, {per_cent:.1} % rms off in \
                     receptance"
                ),
                format!(
                    "Verlustfaktoren sind nicht kausal: in der Zeit ist das Gleis das nächste kausale, Rezeptanz im Mittel \
                     {per_cent:.1} % daneben"
                ),
            )
        }),
        LoopInTime::General(general) => (share > WORTH_A_REMARK_TOGETHER).then(|| {
            let most = 100.0 * general.structures.largest_error();
            Remark::new(
                format!(
                    "in time receptances of track and wheels are {per_cent:.2} % rms off up to 3 kHz, {most:.1} % at worst: loss \
                     factors are not causal, and waves between wheels far apart take more oscillations than are fitted"
                ),
                format!(
                    "in der Zeit liegen die Rezeptanzen von Gleis und Rädern bis 3 kHz im Mittel {per_cent:.2} % daneben, höchstens \
                     {most:.1} %: Verlustfaktoren sind nicht kausal, und Wellen zwischen weit entfernten Rädern brauchen mehr \
                     Schwingungen, als angepasst werden"
                ),
            )
        }),
    }
}

/// That a linear loop and what follows a push do not say the same, if so.
pub(super) fn of_linear_loop(outcome: Outcome, unstable_roots: Option<usize>) -> Option<Remark> {
    match (outcome, unstable_roots) {
        (Outcome::AtRest, Some(1..)) => Some(Remark::new(
            "the linear loop is unstable, but what the push began has died out: what grows does so more slowly than this run shows",
            "linear ist der Kreis instabil, doch der Anstoß ist abgeklungen: was wächst, wächst langsamer, als diese Rechnung zeigt",
        )),
        (Outcome::LimitCycle, Some(0)) => Some(Remark::new(
            "the linear loop is stable, but the push is large enough for a limit cycle beside the state of rest",
            "linear ist der Kreis stabil, doch der Anstoß reicht für einen Grenzzyklus neben der Ruhelage",
        )),
        _ => None,
    }
}

/// That supports shake the wheel with a wave much as long as the profile's.
pub(super) fn of_supports(model: &LoopInTime, profile: &Sinusoid) -> Option<Remark> {
    let spacing = model.support_spacing()?;
    let line = profile.shares_lines_with(spacing)?;
    let length = 1e3 * spacing / line as f64;
    Some(Remark::new(
        format!(
            "passing the supports shakes the wheel every {length:.1} mm as well, too close to this wave to tell them apart: \
             harmonics hold both"
        ),
        format!(
            "auch die Überfahrt der Stützpunkte regt das Rad alle {length:.1} mm an, zu nahe an dieser Welle, um beide zu \
             trennen: die Harmonischen enthalten beides"
        ),
    ))
}

/// That a run ended before it was done, since the wheel was in the air.
pub(super) fn of_air(passages: u64) -> Remark {
    Remark::new(
        format!(
            "after {passages} passages the wheel is in the air for more than half of the time, and the run ends there: steel \
             yields where it comes down"
        ),
        format!(
            "nach {passages} Überrollungen ist das Rad mehr als die halbe Zeit in der Luft, und dort endet die Rechnung: wo es \
             aufschlägt, fließt der Stahl"
        ),
    )
}

/// That wheels on a smooth rail slide off.
pub(super) fn of_sliding() -> Remark {
    Remark::new(
        "the wheels slide as fast as they roll: with so much creepage the creep forces fall short of those of the mean state, and \
         nothing else holds the wheels; give them wheelset.suspension, or less creepage",
        "die Räder gleiten so schnell, wie sie rollen: bei so viel Schlupf bleiben die Kraftschlusskräfte unter denen des \
         mittleren Zustands, und sonst hält die Räder nichts; wheelset.suspension oder weniger Schlupf hilft",
    )
}

/// That the wheel is too large for the troughs of a sinusoid of amplitude Δ and wavelength λ, Δ > λ²/(4π²R).
pub(super) fn of_troughs(amplitude: f64, wavelength: f64, rolling_radius: f64) -> Option<Remark> {
    let wavenumber = std::f64::consts::TAU / wavelength;
    let largest = 1.0 / (wavenumber * wavenumber * rolling_radius);
    (amplitude > largest).then(|| {
        let largest = 1e6 * largest;
        Remark::new(
            format!(
                "a wheel of this radius does not reach the troughs of such waves above {largest:.0} µm: it would touch in \
                 two places, and here touches in one"
            ),
            format!(
                "ein Rad von diesem Halbmesser erreicht über {largest:.0} µm die Täler solcher Wellen nicht: es berührte an \
                 zwei Stellen, hier an einer"
            ),
        )
    })
}

/// That the edge of a contact made of elements moves by too few of them.
pub(super) fn of_elements(contact: &TransientContact, settled: &Settled) -> Option<Remark> {
    /// From which on the errors of a first harmonic are 2 to 3 %.
    const RESOLVED: f64 = 1.4;
    let moves = contact.elements_of_edge(settled);
    (moves < RESOLVED).then(|| {
        let across = contact.across;
        Remark::new(
            format!(
                "the load moves the edge of the patch by {moves:.2} elements: harmonics of the creep force may be tens of per cent off; take a \
                 larger amplitude, or more than {across} elements across (contact.grid), until it is {RESOLVED}"
            ),
            format!(
                "die Last bewegt den Rand der Kontaktfläche um {moves:.2} Elemente: Harmonische der Schlupfkraft liegen bis zu einigen zehn \
                 Prozent daneben; eine größere Amplitude oder mehr als {across} Elemente (contact.grid) nehmen, bis es {RESOLVED} sind"
            ),
        )
    })
}
