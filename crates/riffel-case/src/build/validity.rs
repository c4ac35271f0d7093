//! Where the models of a case leave their range of validity.

use riffel::{Axis, Direction, FeedbackLoop, HertzContact};
use riffel_keys::{Language, Remark};

use crate::checked_keys::CheckedKeys;
use crate::file::{BeamModel, ContactDynamics, CreepLawName, HertzTheory, TrackModel};
use crate::measurement;
use crate::track::Track;

/// Frequency from which a rail on its supports moves like a free one \[Hz\]; Afferrante & Ciavarella
/// (2009), section 2.
const FREE_BEAM_FROM_HZ: f64 = 500.0;

/// Frequency from which the shear of a rail shows \[Hz\]: against a free Timoshenko beam of the same
/// rail (shear coefficient 0.4) the phase is 9° off at 500 Hz, 17° at 1000 Hz and 24° at 1500 Hz, the
/// modulus 2, 7 and 14 %.
const EULER_BEAM_UP_TO_HZ: f64 = 500.0;

/// Shortest wavelength in contact lengths 2a₀ at which averaging over the patch may be left out;
/// Afferrante & Ciavarella (2009), introduction, quoting Frederick (1987).
const CONTACT_FILTER_LENGTHS: f64 = 1.5;

/// Share of the pinned-pinned frequency up to which supports may be taken as spread evenly without a
/// remark. Even then the receptance of five of the tracks under `presets/` (rail 60E1) is up to 9 to
/// 48 % off somewhere below, where the resonance of the rail on its pads shifts, and 80 % on pads of
/// 1 GN/m.
const EVEN_SUPPORT_UP_TO: f64 = 0.5;

/// Error of a semi-axis by the closed form of Hertz up to which nothing is said; that of the nominal
/// contact is 1 %.
const CLOSED_FORM_UP_TO: f64 = 0.05;

/// Sentences on the validity of the models over the window.
pub(crate) fn remarks(
    keys: &CheckedKeys,
    track: &Track,
    feedback: &FeedbackLoop,
    hertz: HertzContact,
    [wavelength, speed]: [Axis; 2],
) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let file = &keys.file;
    let window = keys.window.name(Language::English);
    let window_de = keys.window.name(Language::German);
    let lowest = speed.min() / wavelength.max();
    let highest = speed.max() / wavelength.min();
    let measured = keys.given.track.is_some() || file.track.model == TrackModel::Measured;
    if !measured && track.support.is_none() && lowest < FREE_BEAM_FROM_HZ {
        remarks.push(Remark::new(
            format!(
                "the rail has no support: below about {FREE_BEAM_FROM_HZ} Hz (lowest of the \
                 {window}: {lowest:.0} Hz) pads, sleepers and ballast change its receptance"
            ),
            format!(
                "die Schiene liegt nirgends auf: unter etwa {FREE_BEAM_FROM_HZ} Hz ({window_de}: ab \
                 {lowest:.0} Hz) ändern Zwischenlagen, Schwellen und Schotter ihre Rezeptanz"
            ),
        ).in_short(format!("the rail has no support: wrong below about {FREE_BEAM_FROM_HZ} Hz ({window} from {lowest:.0} Hz)")));
    }
    let bends_only = keys.beam_model() == BeamModel::EulerBernoulli;
    if !measured && bends_only && highest > EULER_BEAM_UP_TO_HZ {
        remarks.push(Remark::new(
            format!(
                "the rail bends without shear: its receptance is some 9° off at {EULER_BEAM_UP_TO_HZ} Hz, 24° \
                 and 14 % at 1500 Hz (highest of the {window}: {highest:.0} Hz)"
            ),
            format!(
                "die Schiene biegt sich ohne Schub: ihre Rezeptanz weicht bei {EULER_BEAM_UP_TO_HZ} Hz um etwa 9° \
                 ab, bei 1500 Hz um 24° und 14 % ({window_de}: bis {highest:.0} Hz)"
            ),
        ).in_short(format!("the rail bends without shear: 24° and 14 % off at 1500 Hz ({window} to {highest:.0} Hz)")));
    }
    if !measured && bends_only && file.track.model.is_periodic() {
        remarks.push(Remark::new(
            "the rail bends without shear: its pinned-pinned frequency is overstated by 20 to 35 % or more and \
             not named (choose rail.beam = \"timoshenko\")",
            "die Schiene biegt sich ohne Schub: ihre Pinned-pinned-Frequenz ist um 20 bis 35 % oder mehr zu hoch \
             und wird nicht genannt (rail.beam = \"timoshenko\" wählen)",
        ).in_short("the rail bends without shear: its pinned-pinned frequency is too high and not named"));
    }
    if let Some(pinned) = evenly_supported_pinned_pinned(keys).filter(|_| !measured)
        && highest > EVEN_SUPPORT_UP_TO * pinned
    {
        remarks.push(Remark::new(
            format!(
                "supports are spread evenly along the rail: the pinned-pinned resonance near {pinned:.0} Hz is \
                 missing, and below it the receptance is 10 to 50 % off, more on very stiff pads (highest of the {window}: {highest:.0} Hz; \
                 choose a model that ends in -periodic)"
            ),
            format!(
                "die Stützpunkte sind gleichmäßig über die Schiene verteilt: die Pinned-pinned-Resonanz nahe \
                 {pinned:.0} Hz fehlt, und darunter weicht die Rezeptanz um 10 bis 50 % ab, auf sehr steifen \
                 Zwischenlagen um mehr ({window_de}: bis {highest:.0} Hz; ein Modell wählen, das auf -periodic endet)"
            ),
        ).in_short(format!("supports are spread evenly: no pinned-pinned resonance near {pinned:.0} Hz ({window} to {highest:.0} Hz)")));
    }
    let shortest = CONTACT_FILTER_LENGTHS * 2.0 * hertz.semi_axis_longitudinal();
    let resolved = file.contact.response == ContactDynamics::NonSteady;
    if !resolved && wavelength.min() < shortest {
        let shortest = 1e3 * shortest;
        remarks.push(Remark::new(
            format!(
                "the contact is quasi-static and does not average over its patch: below {shortest:.0} mm growth \
                 is overstated"
            ),
            format!(
                "der Kontakt ist quasistatisch und mittelt nicht über seine Fläche: unter {shortest:.0} mm ist das \
                 Wachstum zu hoch"
            ),
        ).in_short(format!("the contact does not average over its patch: growth is overstated below {shortest:.0} mm")));
    }
    if keys.hertz_theory() == HertzTheory::Paper
        && let Ok(exact) = HertzContact::exact(
            hertz.material(),
            hertz.rolling_radius(),
            file.contact.transverse_radius.si(),
            hertz.normal_force(),
        )
    {
        let error = hertz.semi_axis_lateral() / exact.semi_axis_lateral() - 1.0;
        if error.abs() > CLOSED_FORM_UP_TO {
            let percent = 100.0 * error.abs();
            remarks.push(Remark::new(
                format!(
                    "the radii of wheel and rail differ much: the closed form of the contact ellipse is {percent:.0} % off \
                     across the rail (choose contact.hertz = \"exact\")"
                ),
                format!(
                    "die Radien von Rad und Schiene sind sehr verschieden: die geschlossene Formel der \
                     Kontaktellipse weicht quer zur Schiene um {percent:.0} % ab (contact.hertz = \"exact\" wählen)"
                ),
            ).in_short(format!("the closed form of the contact ellipse is {percent:.0} % off (contact.hertz = \"exact\" is not)")));
        }
    }
    let polach = file.contact.polach.as_ref();
    if keys.creep_law_name() == CreepLawName::POLACH
        && let Some(rolling) = polach.and_then(|polach| polach.speed)
    {
        remarks.push(Remark::new(
            format!(
                "falling friction is that of the slip at {rolling}, contact.polach.speed, at every speed of the {window}"
            ),
            format!(
                "die fallende Reibung ist die beim Schlupf bei {rolling}, contact.polach.speed, bei jeder \
                 Geschwindigkeit ({window_de})"
            ),
        ).in_short(format!("falling friction is that at {rolling} at every speed of the {window}")));
    }
    // Outside the frequencies of a measurement there is nothing to look at.
    let (known_from, known_to) = measurement::range(&*feedback.track);
    let (lowest, highest) = (lowest.max(known_from), highest.min(known_to));
    if lowest >= highest {
        return remarks;
    }
    // The force amplitude has one smooth maximum over frequency or few; a coarse look suffices.
    let worst = (0..=200)
        .map(|step| lowest * (highest / lowest).powf(f64::from(step) / 200.0))
        .map(|frequency| {
            let state = feedback.at(speed.max() / frequency, speed.max());
            state.normal_force.norm()
        })
        .fold(0.0, f64::max)
        / hertz.normal_force();
    if worst > 1.0 {
        let limit = 1e6 * feedback.amplitude / worst;
        let amplitude = 1e6 * feedback.amplitude;
        remarks.push(Remark::new(
            format!(
                "an amplitude of {amplitude:.1} µm makes |P₁/P₀| reach {worst:.2}: wheel and rail part; forces are \
                 linear up to {limit:.1} µm (growth rates hold for small amplitudes and do not change)"
            ),
            format!(
                "bei einer Amplitude von {amplitude:.1} µm erreicht |P₁/P₀| {worst:.2}: Rad und Schiene trennen \
                 sich; Kräfte sind bis {limit:.1} µm linear (Wachstumsraten gelten für kleine Amplituden und \
                 ändern sich nicht)"
            ),
        ).in_short(format!("{amplitude:.1} µm make wheel and rail part (|P₁/P₀| = {worst:.2}); forces are linear up to {limit:.1} µm")));
    }
    remarks
}

/// Pinned-pinned frequency \[Hz\] that an evenly supported track of Timoshenko's rail would have on
/// the supports of the case.
fn evenly_supported_pinned_pinned(keys: &CheckedKeys) -> Option<f64> {
    let mut discrete = keys.clone();
    discrete.file.track.model = match keys.file.track.model {
        TrackModel::OneLayer => TrackModel::OneLayerPeriodic,
        TrackModel::TwoLayer => TrackModel::TwoLayerPeriodic,
        _ => return None,
    };
    discrete.file.rail.beam = Some(BeamModel::Timoshenko);
    let w = discrete.track(Direction::Vertical).ok()?.pinned_pinned?;
    Some(w / std::f64::consts::TAU)
}
