//! Where the models of a case leave their range of validity.

use std::f64::consts::TAU;

use riffel::contact::{CurvatureFilter, EllipticContact};
use riffel::feedback::Stability;
use riffel::{Axis, Direction, Error, HertzContact, Loop};
use riffel_keys::{Message, Value, fixed, number, say, shown_speed};

use super::stability;
use crate::file::{BeamModel, ContactDynamics, CreepLawName, HertzTheory, TrackModel};
use crate::keys::checked_keys::CheckedKeys;
use crate::parts::short_waves::{shorter_than_patch, shortest_not_averaged};
use crate::parts::track::{Track, known_range};
use crate::parts::wheelset::CaseWheelset;

/// Frequency from which a rail on its supports moves like a free one \[Hz\]; Afferrante & Ciavarella
/// (2009), section 2.
const FREE_BEAM_FROM_HZ: f64 = 500.0;

/// Frequency from which the shear of a rail shows \[Hz\]: against a free Timoshenko beam of the same
/// rail (shear coefficient 0.4) the phase is 9° off at 500 Hz, 17° at 1000 Hz and 24° at 1500 Hz, the
/// modulus 2, 7 and 14 %.
const EULER_BEAM_UP_TO_HZ: f64 = 500.0;

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
    wheelset: Option<&CaseWheelset>,
    feedback: &Loop,
    hertz: HertzContact,
    [wavelength, speed]: [Axis; 2],
) -> Vec<Message> {
    let mut remarks = Vec::new();
    let file = &keys.file;
    let lowest = speed.min() / wavelength.max();
    let highest = speed.max() / wavelength.min();
    let measured = keys.given.track.is_some() || file.track.model == TrackModel::Measured;
    if !measured && track.support.is_none() && lowest < FREE_BEAM_FROM_HZ {
        remarks.push(say!(
            rail_without_support,
            free_beam_from_hz = number(FREE_BEAM_FROM_HZ),
            window = keys.window.name(),
            lowest = fixed(lowest, 0)
        ));
    }
    let bends_only = keys.beam_model() == BeamModel::EulerBernoulli;
    if !measured && bends_only && highest > EULER_BEAM_UP_TO_HZ {
        remarks.push(say!(
            rail_without_shear,
            euler_beam_up_to_hz = number(EULER_BEAM_UP_TO_HZ),
            window = keys.window.name(),
            highest = fixed(highest, 0)
        ));
    }
    if let Some([band, contact]) = keys.band_under_wider_contact(hertz) {
        remarks.push(say!(band_narrower_than_contact, band = fixed(1e3 * band, 0), contact = fixed(1e3 * contact, 1)));
    }
    if !measured && bends_only && file.track.model.is_periodic() {
        remarks.push(say!(pinned_pinned_without_shear));
    }
    if let Some(pinned) = evenly_supported_pinned_pinned(keys).filter(|_| !measured)
        && highest > EVEN_SUPPORT_UP_TO * pinned
    {
        remarks.push(say!(
            supports_spread_evenly,
            pinned = fixed(pinned, 0),
            window = keys.window.name(),
            highest = fixed(highest, 0)
        ));
    }
    remarks.extend(of_contact(keys, hertz, wavelength.min()));
    remarks.extend(unstable(feedback, keys.track_known_to(), speed));
    remarks.extend(of_waves(keys, feedback, hertz, [wavelength, speed]));
    if let Some(wheelset) = wheelset {
        remarks.extend(wheelset.beyond_its_modes(highest));
    }
    // Outside the frequencies of a measurement there is nothing to look at.
    let of_track = known_range(&*track.receptance);
    let of_wheelset = wheelset.map_or((0.0, f64::INFINITY), CaseWheelset::frequency_range);
    let known_from = of_track.0.max(of_wheelset.0);
    let known_to = of_track.1.min(of_wheelset.1);
    let (lowest, highest) = (lowest.max(known_from), highest.min(known_to));
    if lowest >= highest {
        return remarks;
    }
    // The force amplitude has one smooth maximum over frequency or few; a coarse look suffices.
    let worst = (0..=200)
        .map(|step| lowest * (highest / lowest).powf(f64::from(step) / 200.0))
        .map(|frequency| {
            let state = feedback.at(speed.max() / frequency, speed.max());
            state.normal_force().norm()
        })
        .fold(0.0, f64::max)
        / hertz.normal_force();
    if worst > 1.0 {
        let limit = 1e6 * feedback.amplitude() / worst;
        let amplitude = 1e6 * feedback.amplitude();
        remarks.push(say!(
            wheel_and_rail_part,
            amplitude = fixed(amplitude, 1),
            worst = fixed(worst, 2),
            limit = fixed(limit, 1)
        ));
    }
    remarks
}

/// Sentences on the validity of the models of the contact, down to the shortest wavelength asked for \[m\].
pub(crate) fn of_contact(keys: &CheckedKeys, hertz: HertzContact, shortest_asked: f64) -> Vec<Message> {
    let mut remarks = Vec::new();
    let file = &keys.file;
    let shortest = shortest_not_averaged(hertz);
    let resolved = file.contact.response == ContactDynamics::NonSteady;
    if !resolved && shortest_asked < shortest {
        let shortest = 1e3 * shortest;
        remarks.push(say!(no_average_over_patch, shortest = fixed(shortest, 0)));
    }
    let width = 2.0 * hertz.semi_axis_lateral();
    if width > EllipticContact::WIDEST {
        let width = 1e3 * width;
        remarks.push(say!(ellipse_too_wide, width = fixed(width, 0)));
    }
    if keys.hertz_theory() == HertzTheory::Paper
        && let Ok(exact) = HertzContact::exact(
            hertz.material(),
            hertz.rolling_radius(),
            file.contact.transverse_radius.si(),
            hertz.normal_force(),
        )
        .and_then(|exact| exact.with_longitudinal_radius(hertz.longitudinal_radius()))
    {
        let error = hertz.semi_axis_lateral() / exact.semi_axis_lateral() - 1.0;
        if error.abs() > CLOSED_FORM_UP_TO {
            let percent = 100.0 * error.abs();
            remarks.push(say!(closed_form_of_ellipse, percent = fixed(percent, 0)));
        }
    }
    let polach = file.contact.polach.as_ref();
    if keys.creep_law_name() == CreepLawName::POLACH
        && let Some(rolling) = polach.and_then(|polach| polach.speed)
    {
        remarks.push(say!(falling_friction_at_one_speed, rolling = rolling.to_string(), window = keys.window.name()));
    }
    remarks
}

/// What the wave's own geometry would take where the case does not speak of it, and where it leaves its range.
fn of_waves(keys: &CheckedKeys, feedback: &Loop, hertz: HertzContact, [wavelength, speed]: [Axis; 2]) -> Vec<Message> {
    let amplitude = feedback.amplitude();
    let curvature = |wavelength: f64| {
        let wavenumber = TAU / wavelength;
        hertz.longitudinal_radius() * wavenumber * wavenumber
    };
    let mut remarks = Vec::new();
    if keys.feels_waves() {
        remarks.extend(shorter_than_patch(hertz, wavelength.min()));
        // Growth does not depend on an amplitude that nobody chose.
        let chosen = keys.text.is_written("corrugation.amplitude");
        if chosen && amplitude * curvature(wavelength.min()) >= 1.0 {
            let bridged = TAU * (hertz.longitudinal_radius() * amplitude).sqrt();
            remarks.push(say!(
                troughs_bridged,
                amplitude = fixed(1e6 * amplitude, 1),
                bridged = fixed(1e3 * bridged, 0)
            ));
        }
    }
    if keys.file.contact.wave_geometry.is_none() {
        /// Wavelengths to look at for the fastest growth.
        const LOOKS: i32 = 60;
        let speed = 0.5 * (speed.min() + speed.max());
        let per_metre = 1.0 / (feedback.steady().energy_per_metre() * amplitude);
        let ratio = wavelength.max() / wavelength.min();
        let looks = (0..=LOOKS).map(|step| wavelength.min() * ratio.powf(f64::from(step) / f64::from(LOOKS))).map(
            |wavelength| {
                let state = feedback.at(wavelength, speed);
                (wavelength, -state.contacts[0].energy_at_rail.re * per_metre)
            },
        );
        let fastest = looks.filter(|(_, growth)| *growth > 0.0).max_by(|one, other| one.1.total_cmp(&other.1));
        if let Some((wavelength, growth)) = fastest {
            let share = CurvatureFilter::of(&hertz).map_or(1.0, |filter| filter.share(TAU / wavelength));
            remarks.push(say!(
                wave_geometry_left_out,
                takes = to_three_digits(share * curvature(wavelength)),
                growth = to_three_digits(growth),
                wavelength = fixed(1e3 * wavelength, 0),
                speed = shown_speed(speed, 0)
            ));
        }
    }
    remarks
}

/// A growth to three digits \[1/m\].
fn to_three_digits(growth: f64) -> Value {
    let place = 10f64.powf(growth.log10().floor() - 2.0);
    number((growth / place).round() * place)
}

/// A loop on all axes that oscillates by itself at a speed of the window, or of which that cannot be told, for want of any loss or
/// of measured frequencies; only these can.
fn unstable(feedback: &Loop, known_to: f64, speed: Axis) -> Option<Message> {
    type Judged = (f64, Result<Stability, Error>);
    let judged: Vec<Judged> = stability::over(feedback, known_to, speed).collect();
    let grows = |found: &Result<Stability, Error>| found.as_ref().is_ok_and(|found| found.frequency.is_some());
    let unknown = |found: &Result<Stability, Error>| found.is_err();
    // From the slowest speed of which that is so to the last one in a row.
    let first = |is: &dyn Fn(&Result<Stability, Error>) -> bool| {
        let from = judged.iter().position(|(_, found)| is(found))?;
        let last = judged[from..].iter().take_while(|(_, found)| is(found)).last()?;
        stability::said([judged[from].0, last.0], &judged[from].1)
    };
    first(&grows).or_else(|| first(&unknown))
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
