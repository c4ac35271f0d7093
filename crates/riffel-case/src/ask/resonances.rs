//! The resonances of a case, vertically.

use std::f64::consts::TAU;

use riffel::receptance::{Extremum, MassOnRail, Resonance, ResonanceKind};
use riffel::{Complex64, Direction, Receptance};

use crate::Case;
use crate::parts::track::Origin;

/// How near a peak must be to the pinned-pinned frequency of the rail on the supports of the case to bear its name, as
/// a ratio.
const PINNED_PINNED_WITHIN: f64 = 1.1;

/// How far below P2 a rail must be a spring \[-\], as a ratio of frequencies.
const SPRING_DOWN_TO: f64 = 0.5;

/// What stands out vertically, lowest first: the modes of the track, and the wheel on it (P2).
///
/// A receptance without a model has peaks and dips. They bear the name of a mode only where the case
/// says enough to tell: a peak is pinned-pinned if the rail of the case on its support spacing has that
/// frequency, within 10 %.
pub fn resonances(case: &Case) -> Vec<Resonance> {
    let mut resonances = match case.track.origin {
        Origin::Model => case.track.resonances(),
        Origin::Measured(_) | Origin::Given => peaks_and_dips(case),
    };
    resonances.extend(p2(case));
    resonances.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
    resonances
}

/// The P2 resonance of the wheel on the track. None on a rail without support, or where damping leaves no
/// resonance.
///
/// The contact force per roughness is 1/(H_rail + H_wheel + 1/k_H). At P2 the spring of the track and the mass of the
/// wheel balance: the real part of the sum passes zero upward, and its modulus is least. On a model that is
/// looked for above 10 Hz and below the frequency at which the track moves on its own, on another receptance
/// below its first peak and where the rail is a spring, Re H_rail > 0, down to half the frequency: at the
/// least sum near a dip of the rail it is a mass below. Where the wheel does not move as its unsprung mass, within a
/// factor of two, the sum is least for another reason: a suspension or an axle that holds the wheel still.
pub fn p2(case: &Case) -> Option<Resonance> {
    if !matches!(case.track.origin, Origin::Model) {
        return p2_of_lines(case);
    }
    let rail_mass = case.track.rail_mass?;
    let cut_on = case.track.support?.cut_on_frequencies(rail_mass);
    let &highest = cut_on.first()?;
    Resonance::p2(|w| total(case, w), |w| inertia(case, w), [TAU * 10.0, highest])
}

/// The closed form of P2 beside it: the unsprung mass on the static shape of an evenly supported rail that bends alone.
/// None without a model of the track, or a mass of the wheel.
pub fn p2_closed_form(case: &Case) -> Option<MassOnRail> {
    let rail = case.keys.vertical_bending_stiffness()?;
    let contact = case.feedback.contacts()[0].stiffness;
    let (support, rail_mass) = (case.track.support?, case.track.rail_mass?);
    MassOnRail::new(unsprung_mass(case)?, rail, rail_mass, support, contact).ok()
}

/// Mass \[kg\] that a contact feels of the wheel, or of the wheelset whose other wheel is free; `None` if no key tells it.
fn unsprung_mass(case: &Case) -> Option<f64> {
    if let (Some(wheelset), Some(keys)) = (&case.wheelset, &case.file.wheelset) {
        return wheelset.mass_at_contact(0.5 * keys.contact_spacing.si());
    }
    let mass = case.file.wheel.mass.map(|mass| mass.si());
    mass.filter(|_| case.keys.given.wheel.is_none())
}

/// Inertia that the wheel has at an angular frequency over its unsprung mass, −1/(ω² m_u Re H_wheel); one where that is not
/// known.
fn inertia(case: &Case, w: f64) -> f64 {
    let [_, wheel] = case.feedback.normal_receptances(w, case.speed.max());
    unsprung_mass(case).map_or(1.0, |mass| -(w * w * mass * wheel.re).recip())
}

/// H_rail + H_wheel + 1/k_H \[m/N\].
fn total(case: &Case, w: f64) -> Complex64 {
    let [rail, wheel] = case.feedback.normal_receptances(w, case.speed.max());
    rail + wheel + case.feedback.contacts()[0].stiffness.recip()
}

fn p2_of_lines(case: &Case) -> Option<Resonance> {
    let rail = lines(case);
    let wheel = case.keys.given.wheel.as_ref();
    let (lowest, highest) = wheel.map_or((0.0, f64::INFINITY), |wheel| known(case, &*wheel.receptance));
    let total: Vec<(f64, Complex64)> = rail
        .iter()
        .map(|line| line.0)
        .filter(|&w| lowest <= w && w <= highest)
        .map(|w| (w, total(case, w)))
        .filter(|(_, total)| total.is_finite())
        .collect();
    let first_peak = Extremum::peaks(&rail).first().map_or(f64::INFINITY, |peak| peak.angular_frequency);
    let dips =
        Extremum::dips(&total).into_iter().take_while(|least| least.angular_frequency < first_peak).filter(|least| {
            let w = least.angular_frequency;
            let below = rail.iter().filter(|line| SPRING_DOWN_TO * w <= line.0 && line.0 <= w);
            below.map(|(_, h)| h.re).sum::<f64>() > 0.0
        });
    dips.filter(|least| Resonance::is_as_mass(inertia(case, least.angular_frequency)))
        .min_by(|a, b| a.receptance.norm().total_cmp(&b.receptance.norm()))
        .map(|least| named(case, ResonanceKind::P2, least))
}

fn peaks_and_dips(case: &Case) -> Vec<Resonance> {
    let rail = lines(case);
    let (peak_kind, dip_kind) = match case.track.origin {
        Origin::Given => (ResonanceKind::FunctionPeak, ResonanceKind::FunctionDip),
        _ => (ResonanceKind::MeasuredPeak, ResonanceKind::MeasuredDip),
    };
    let mut peaks: Vec<Resonance> =
        Extremum::peaks(&rail).into_iter().map(|peak| named(case, peak_kind, peak)).collect();
    if let Some(expected) = case.keys.pinned_pinned(Direction::Vertical) {
        let distance = |peak: &Resonance| (peak.angular_frequency / TAU / expected).ln().abs();
        let nearest = peaks
            .iter_mut()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .filter(|peak| distance(peak) < PINNED_PINNED_WITHIN.ln());
        if let Some(peak) = nearest {
            peak.kind = ResonanceKind::PinnedPinned;
        }
    }
    let dips = Extremum::dips(&rail).into_iter();
    peaks.extend(dips.map(|dip| named(case, dip_kind, dip)));
    peaks
}

fn named(case: &Case, kind: ResonanceKind, extremum: Extremum) -> Resonance {
    let is_table = matches!(case.track.origin, Origin::Measured(_));
    Resonance {
        kind,
        angular_frequency: extremum.angular_frequency,
        receptance: extremum.receptance,
        damping_ratio: extremum.damping_ratio,
        resolution: is_table.then_some(extremum.resolution),
    }
}

/// Angular frequencies \[rad/s\] and receptances \[m/N\] of the rail: the lines of a measurement, or 400 a decade
/// of another receptance.
fn lines(case: &Case) -> Vec<(f64, Complex64)> {
    const A_DECADE: f64 = 400.0;
    if let Origin::Measured(table) = &case.track.origin {
        return table.lines().collect();
    }
    let (from, to) = known(case, &*case.track.receptance);
    if from >= to {
        return Vec::new();
    }
    let steps = (A_DECADE * (to / from).log10()).ceil();
    (0..=steps as usize)
        .map(|step| from * (to / from).powf(step as f64 / steps))
        .map(|w| (w, case.track.receptance.receptance(w, case.speed.max())))
        .filter(|(_, h)| h.is_finite())
        .collect()
}

/// Angular frequencies \[rad/s\] at which a receptance may be asked: where it says itself, else those of the map, for
/// one that the caller gives may know no others.
fn known(case: &Case, receptance: &dyn Receptance) -> (f64, f64) {
    let (from, to) = receptance.frequency_range();
    let is_given = case.keys.given.track.is_some() || case.keys.given.wheel.is_some();
    if to.is_finite() || !is_given {
        return (from, to);
    }
    let lowest = TAU * case.speed.min() / case.wavelength.max();
    let highest = TAU * case.speed.max() / case.wavelength.min();
    (from.max(lowest), highest)
}
