//! Where the models of a case leave their range of validity.

use riffel::{Axis, FeedbackLoop, HertzContact};

use crate::file::{CaseFile, TrackModel};

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

/// Sentences on the validity of the models over the window of the map.
pub(crate) fn remarks(
    file: &CaseFile,
    feedback: &FeedbackLoop,
    hertz: HertzContact,
    wavelength: Axis,
    speed: Axis,
) -> Vec<String> {
    let mut remarks = Vec::new();
    let lowest = speed.min() / wavelength.max();
    let highest = speed.max() / wavelength.min();
    if file.track.model != TrackModel::TwoLayer && lowest < FREE_BEAM_FROM_HZ {
        remarks.push(format!(
            "the rail has no support: below about {FREE_BEAM_FROM_HZ} Hz (the map begins at \
             {lowest:.0} Hz) pads, sleepers and ballast change its receptance"
        ));
    }
    if highest > EULER_BEAM_UP_TO_HZ {
        remarks.push(format!(
            "the rail bends without shear: its receptance is some 9° off at {EULER_BEAM_UP_TO_HZ} Hz, 24° \
             and 14 % at 1500 Hz (the map ends at {highest:.0} Hz)"
        ));
    }
    let shortest = CONTACT_FILTER_LENGTHS * 2.0 * hertz.semi_axis_longitudinal();
    if wavelength.min() < shortest {
        remarks.push(format!(
            "the contact is quasi-static and does not average over its patch: below {:.0} mm growth \
             is overstated",
            1e3 * shortest
        ));
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
        remarks.push(format!(
            "an amplitude of {:.1} µm makes |P₁/P₀| reach {worst:.2}: wheel and rail part; forces are \
             linear up to {limit:.1} µm (growth rates hold for small amplitudes and do not change)",
            1e6 * feedback.amplitude
        ));
    }
    remarks
}
