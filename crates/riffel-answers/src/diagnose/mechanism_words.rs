//! What is known of the mechanisms, in words.

use riffel::diagnosis::MechanismKind;
use riffel_keys::{Message, say};

use crate::ridge::mechanism_name;

/// Where a mechanism stands in the literature, and where Riffel takes its number from.
pub(crate) fn source(kind: MechanismKind) -> Message {
    match kind {
        MechanismKind::GrowthRidge => say!(source_of_growth_ridge),
        MechanismKind::P2 => say!(source_of_p2),
        MechanismKind::FullTrack => say!(source_of_full_track),
        MechanismKind::SleeperAntiresonance => say!(source_of_sleeper_antiresonance),
        MechanismKind::RailOnPad => say!(source_of_rail_on_pad),
        MechanismKind::PinnedPinned => say!(source_of_pinned_pinned),
        MechanismKind::LateralPinnedPinned => say!(source_of_lateral_pinned_pinned),
        MechanismKind::MeasuredPeak | MechanismKind::MeasuredDip => say!(source_of_measured_peak),
        MechanismKind::FunctionPeak | MechanismKind::FunctionDip => say!(source_of_given_peak),
        MechanismKind::WheelsetTorsion => say!(source_of_wheelset_torsion),
        MechanismKind::WheelsetBending => say!(source_of_wheelset_bending),
        MechanismKind::GrindingMark => say!(source_of_grinding_mark),
        MechanismKind::SupportSpacing => say!(source_of_support_spacing),
        MechanismKind::WheelCircumference => say!(source_of_wheel_circumference),
        MechanismKind::Unlisted => say!(source_of_unlisted),
    }
}

/// Where it stops being a good description.
pub(crate) fn validity(kind: MechanismKind) -> Message {
    match kind {
        MechanismKind::GrowthRidge => say!(validity_of_growth_ridge),
        MechanismKind::P2 => say!(validity_of_p2),
        MechanismKind::FullTrack | MechanismKind::SleeperAntiresonance => {
            say!(validity_of_full_track)
        }
        MechanismKind::RailOnPad => say!(validity_of_rail_on_pad),
        MechanismKind::PinnedPinned | MechanismKind::LateralPinnedPinned => {
            say!(validity_of_pinned_pinned)
        }
        MechanismKind::MeasuredPeak
        | MechanismKind::MeasuredDip
        | MechanismKind::FunctionPeak
        | MechanismKind::FunctionDip => say!(validity_of_measured_peak),
        MechanismKind::WheelsetTorsion | MechanismKind::WheelsetBending => {
            say!(validity_of_wheelset_torsion)
        }
        MechanismKind::GrindingMark => say!(validity_of_grinding_mark),
        MechanismKind::SupportSpacing => say!(validity_of_support_spacing),
        MechanismKind::WheelCircumference => say!(validity_of_wheel_circumference),
        MechanismKind::Unlisted => say!(validity_of_unlisted),
    }
}

/// The measurement that is its own.
fn own_measurement(kind: MechanismKind) -> Message {
    match kind {
        MechanismKind::GrowthRidge => say!(measurement_of_growth_ridge),
        MechanismKind::P2 => say!(measurement_of_p2),
        MechanismKind::FullTrack => say!(measurement_of_full_track),
        MechanismKind::SleeperAntiresonance => say!(measurement_of_sleeper_antiresonance),
        MechanismKind::RailOnPad => say!(measurement_of_rail_on_pad),
        MechanismKind::PinnedPinned => say!(measurement_of_pinned_pinned),
        MechanismKind::LateralPinnedPinned => say!(measurement_of_lateral_pinned_pinned),
        MechanismKind::MeasuredPeak | MechanismKind::FunctionPeak => {
            say!(measurement_of_measured_peak)
        }
        MechanismKind::MeasuredDip | MechanismKind::FunctionDip => say!(measurement_of_measured_dip),
        MechanismKind::WheelsetTorsion => say!(measurement_of_wheelset_torsion),
        MechanismKind::WheelsetBending => say!(measurement_of_wheelset_bending),
        MechanismKind::GrindingMark => say!(measurement_of_grinding_mark),
        MechanismKind::SupportSpacing => say!(measurement_of_support_spacing),
        MechanismKind::WheelCircumference => say!(measurement_of_wheel_circumference),
        MechanismKind::Unlisted => say!(measurement_of_unlisted),
    }
}

/// Its name with the measurement that would settle it.
pub(crate) fn settled_by(kind: MechanismKind) -> Message {
    own_measurement(kind).about(mechanism_name(kind))
}
