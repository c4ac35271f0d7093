//! Keys that cannot change growth in a case.

use crate::Case;
use crate::file::CreepLawName;
use crate::file::{ContactDynamics, Rotation, TrackModel, WheelsetModel};

impl Case {
    /// Why a key of the case, dotted, cannot change growth under traffic; none where it may.
    pub fn idle_because(&self, key: &str) -> Option<String> {
        let (table, inner) = key.split_once('.').unwrap_or((key, ""));
        let file = &self.file;
        let contact = &file.contact;
        let words = match table {
            "track" if inner == "model" => return None,
            "track" | "rail" => return self.idle_in_track(table, inner),
            "curve" | "bogie" | "body" | "profiles" if contact.from.is_some() => return None,
            "curve" | "bogie" | "body" | "profiles" => {
                "it belongs to `riffel curve` and `riffel profile`"
            }
            "corrugation" if self.feedback.depends_on_amplitude() => return None,
            "corrugation" => "growth rates do not depend on the amplitude",
            "train"
                if inner == "comb"
                    && file
                        .train
                        .as_ref()
                        .is_none_or(|train| train.wheels.len() < 2) =>
            {
                "there is one wheel, which interferes with no other"
            }
            "wheelset" => return self.idle_in_wheelset(inner),
            "map" => "the bands are those of the case, and the speeds those of the traffic",
            "wheel" if inner == "inertia" && self.file.wheel.rotation() != Rotation::Inertia => {
                "wheel.rotation is the limit of no inertia or of infinite inertia"
            }
            "wheel"
                if inner == "normal_direction"
                    && self.file.wheel.rotation() != Rotation::Inertia =>
            {
                "wheel.rotation holds the creepage or the force along the rail"
            }
            "contact"
                if inner.starts_with("conformity")
                    && contact.contact_angle.is_none_or(|angle| angle.si() == 0.0) =>
            {
                "under a contact angle of zero the wheel has the same radius everywhere"
            }
            "contact"
                if inner.starts_with("conformity")
                    && file.wheelset.is_none()
                    && file.wheel.rotation() == Rotation::ConstantTangentialForce =>
            {
                "a wheel that turns freely takes any radius"
            }
            "contact"
                if inner.starts_with("polach") && self.creep_law() != CreepLawName::POLACH =>
            {
                "it belongs to contact.creep_law = \"polach\""
            }
            "contact" if inner == "grid" && self.creep_law() != CreepLawName::HALF_SPACE => {
                "it belongs to contact.creep_law = \"half-space\""
            }
            "contact" if inner == "wave_patch" && contact.wave_geometry != Some(true) => {
                "it belongs to contact.wave_geometry = true"
            }
            "contact"
                if inner == "wave_patch" && contact.response == ContactDynamics::NonSteady =>
            {
                "a non-steady contact resolves its patch"
            }
            "contact"
                if inner == "dissipation_phase"
                    && contact.response == ContactDynamics::NonSteady =>
            {
                "a non-steady contact finds the place of wear itself"
            }
            _ => return None,
        };
        Some(words.to_owned())
    }

    fn idle_in_wheelset(&self, key: &str) -> Option<String> {
        let model = self.file.wheelset.as_ref()?.model;
        let takes: &[WheelsetModel] = match key.split('.').next().unwrap_or_default() {
            "mass" | "roll_inertia" | "spin_inertia" => {
                &[WheelsetModel::Rigid, WheelsetModel::Modal]
            }
            "axle" | "discs" => &[WheelsetModel::Flexible],
            "suspension" => &[
                WheelsetModel::Rigid,
                WheelsetModel::Flexible,
                WheelsetModel::Modal,
            ],
            "normal_direction" => &[WheelsetModel::Rigid, WheelsetModel::Flexible],
            "file" => &[WheelsetModel::Modal, WheelsetModel::Measured],
            _ => return None,
        };
        let of_curve = key == "mass" && self.file.contact.from.is_some();
        (!takes.contains(&model) && !of_curve).then(|| {
            let takes: Vec<String> = takes
                .iter()
                .map(|model| format!("\"{}\"", model.name()))
                .collect();
            format!("it belongs to wheelset.model = {}", takes.join(" or "))
        })
    }

    fn idle_in_track(&self, table: &str, key: &str) -> Option<String> {
        let track = &self.file.track;
        if self.keys.given.track.is_some() {
            return Some("the track is a receptance given in place of the model".to_owned());
        }
        if track.model == TrackModel::Measured {
            return (!key.starts_with("measurement")).then(|| {
                "the track is a measured receptance, with the rail and the supports that were measured".to_owned()
            });
        }
        if table == "rail" {
            let of_twist = [
                "polar_second_moment",
                "warping_constant",
                "centroid_height",
                "head_height",
                "foot_depth",
                "foot_width",
            ];
            let twists = self.file.rail.torsion_constant.is_some();
            return (!twists && of_twist.contains(&key))
                .then(|| "without rail.torsion_constant the rail does not twist".to_owned());
        }
        let layer = key.split('.').next().unwrap_or_default();
        let model = track.model.name();
        let without_support = || format!("track.model = \"{model}\" is a rail without supports");
        match (track.model, layer) {
            (TrackModel::FreeBeam, _) => Some(without_support()),
            (TrackModel::MovingBeam, _) if track.pad.is_none() && track.ballast.is_none() => {
                Some(without_support())
            }
            (TrackModel::MovingBeam, "sleeper") if track.ballast.is_none() => Some(format!(
                "track.model = \"{model}\" has no sleepers without ballast"
            )),
            (TrackModel::OneLayer | TrackModel::OneLayerPeriodic, "sleeper" | "ballast") => {
                Some(format!("track.model = \"{model}\" has one layer, the pads"))
            }
            (_, "position") if track.model.is_periodic() => {
                Some("growth is the mean over the bay".to_owned())
            }
            (_, "position") => Some(format!(
                "track.model = \"{model}\" is the same everywhere along the rail"
            )),
            _ => None,
        }
    }
}
