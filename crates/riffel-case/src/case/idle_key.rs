//! Keys that cannot change growth in a case.

use riffel_keys::{Message, say};

use crate::Case;
use crate::file::CreepLawName;
use crate::file::{ContactDynamics, Rotation, TrackModel, WheelsetModel};

/// Why a key of the case, dotted, cannot change growth under traffic; `None` if it may.
pub fn idle_because(case: &Case, key: &str) -> Option<Message> {
    let (table, inner) = key.split_once('.').unwrap_or((key, ""));
    let file = &case.file;
    let contact = &file.contact;
    let words = match table {
        "track" if inner == "model" => return None,
        "track" | "rail" => return idle_in_track(case, table, inner),
        "curve" | "bogie" | "body" | "profiles" if contact.from.is_some() => return None,
        "curve" | "bogie" | "body" | "profiles" => {
            say!(idle_belongs_to_curve)
        }
        "corrugation" if case.feedback.depends_on_amplitude() => return None,
        "corrugation" => say!(idle_amplitude),
        "train" if inner == "comb" && file.train.as_ref().is_none_or(|train| train.wheels.len() < 2) => {
            say!(idle_one_wheel)
        }
        "wheelset" => return idle_in_wheelset(case, inner),
        "map" => say!(idle_map),
        "wheel" if inner == "inertia" && case.file.wheel.rotation() != Rotation::Inertia => {
            say!(idle_inertia)
        }
        "wheel" if inner == "normal_direction" && case.file.wheel.rotation() != Rotation::Inertia => {
            say!(idle_rotation)
        }
        "contact" if inner.starts_with("conformity") && contact.contact_angle.is_none_or(|angle| angle.si() == 0.0) => {
            say!(idle_contact_angle)
        }
        "contact"
            if inner.starts_with("conformity")
                && file.wheelset.is_none()
                && file.wheel.rotation() == Rotation::ConstantTangentialForce =>
        {
            say!(idle_free_wheel)
        }
        "contact" if inner.starts_with("polach") && case.creep_law() != CreepLawName::POLACH => {
            say!(idle_belongs_to, keys = "contact.creep_law = \"polach\"")
        }
        "contact" if inner == "grid" && case.creep_law() != CreepLawName::HALF_SPACE => {
            say!(idle_belongs_to, keys = "contact.creep_law = \"half-space\"")
        }
        "contact" if inner == "wave_patch" && contact.wave_geometry != Some(true) => {
            say!(idle_belongs_to, keys = "contact.wave_geometry = true")
        }
        "contact" if inner == "wave_patch" && contact.response == ContactDynamics::NonSteady => {
            say!(idle_patch)
        }
        "contact" if inner == "dissipation_phase" && contact.response == ContactDynamics::NonSteady => {
            say!(idle_place_of_wear)
        }
        _ => return None,
    };
    Some(words)
}

fn idle_in_wheelset(case: &Case, key: &str) -> Option<Message> {
    let model = case.file.wheelset.as_ref()?.model;
    let takes: &[WheelsetModel] = match key.split('.').next().unwrap_or_default() {
        "mass" | "roll_inertia" | "spin_inertia" => &[WheelsetModel::Rigid, WheelsetModel::Modal],
        "axle" | "discs" => &[WheelsetModel::Flexible],
        "suspension" => &[WheelsetModel::Rigid, WheelsetModel::Flexible, WheelsetModel::Modal],
        "normal_direction" => &[WheelsetModel::Rigid, WheelsetModel::Flexible],
        "file" => &[WheelsetModel::Modal, WheelsetModel::Measured],
        _ => return None,
    };
    let of_curve = key == "mass" && case.file.contact.from.is_some();
    (!takes.contains(&model) && !of_curve).then(|| {
        let takes: Vec<String> = takes.iter().map(|model| format!("\"{}\"", model.name())).collect();
        let either = |one: Message, other| say!(one_or_other, one, other);
        let takes = takes.into_iter().map(Message::verbatim).reduce(either);
        say!(idle_belongs_to_wheelset, models = takes.unwrap_or_else(|| Message::verbatim("")))
    })
}

fn idle_in_track(case: &Case, table: &str, key: &str) -> Option<Message> {
    let track = &case.file.track;
    if case.keys.given.track.is_some() {
        return Some(say!(idle_receptance_given));
    }
    if track.model == TrackModel::Measured {
        return (!key.starts_with("measurement")).then(|| say!(idle_receptance_measured));
    }
    if table == "rail" {
        let of_twist =
            ["polar_second_moment", "warping_constant", "centroid_height", "head_height", "foot_depth", "foot_width"];
        let twists = case.file.rail.torsion_constant.is_some();
        return (!twists && of_twist.contains(&key)).then(|| say!(idle_twist));
    }
    let layer = key.split('.').next().unwrap_or_default();
    let model = track.model.name();
    let without_support = || say!(idle_without_supports, model);
    match (track.model, layer) {
        (TrackModel::FreeBeam, _) => Some(without_support()),
        (TrackModel::MovingBeam, _) if track.pad.is_none() && track.ballast.is_none() => Some(without_support()),
        (TrackModel::MovingBeam, "sleeper") if track.ballast.is_none() => Some(say!(idle_sleepers, model)),
        (TrackModel::OneLayer | TrackModel::OneLayerPeriodic, "sleeper" | "ballast") => {
            Some(say!(idle_one_layer, model))
        }
        (_, "position") if track.model.is_periodic() => Some(say!(idle_mean_over_bay)),
        (_, "position") => Some(say!(idle_same_everywhere, model)),
        _ => None,
    }
}
