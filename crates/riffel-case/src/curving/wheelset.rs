//! The wheelset of a case on its track.

use std::path::Path;

use riffel::curving::{ContactPlane, Kinematics};
use riffel::profile::{ContactTable, ProfileError, Track, Wheels, WheelsetOnTrack};
use riffel_keys::{CaseError, Remark};
use std::sync::Arc;

use super::CurvingCase;
use super::build::is_cone;
use super::profile_file::{ProfileOfName, profile_of};
use crate::file::{CurvingTheory, Profiles, RailProfiles};

/// Lateral shift \[m\] to either side over which contact is tabulated, and the step.
const FARTHEST: f64 = 0.012;
const STEP: f64 = 1e-4;

impl CurvingCase {
    /// The wheelset of the case on its track.
    ///
    /// # Errors
    /// [`CaseError`] with the key or with file and line: for cones, profiles that cannot be read, are mirrored or upside
    /// down, and a gauge that the rails cannot have.
    pub fn wheelset_on_track(&self) -> Result<WheelsetOnTrack, CaseError> {
        let profiles = self.profiles()?;
        if is_cone(profiles) {
            let rule = "is \"cone\", which has no profile";
            let help = "name a profile such as \"S1002\" or a file";
            return Err(self.text.keys.invalid("profiles.wheel", rule, help));
        }
        let rail = profiles.rail.as_ref().ok_or_else(|| {
            let help = "name a profile such as \"60E1\" or a file";
            self.text.keys.missing("profiles.rail", help)
        })?;
        let names = match rail {
            RailProfiles::Both(name) => [("profiles.rail", name), ("profiles.rail", name)],
            RailProfiles::Each(each) => [
                ("profiles.rail.left", &each.left),
                ("profiles.rail.right", &each.right),
            ],
        };
        let [left, right] = names.map(|(key, name)| self.profile(key, name));
        let (left, right) = (left?.profile, right?.profile);
        let wheel = self.profile("profiles.wheel", &profiles.wheel)?.profile;
        let fits = |key: &str, error: ProfileError| match error {
            ProfileError::Gauge(rule) => self.text.keys.invalid("profiles.gauge", &rule, ""),
            error => self.text.keys.invalid(key, &error.to_string(), ""),
        };
        let track = Track::new(
            [&left, &right],
            profiles.gauge.si(),
            profiles.gauge_height.si(),
            profiles.inclination.slope,
        )
        .map_err(|error| fits("profiles.rail", error))?;
        let wheels = Wheels::new(
            [&wheel, &wheel],
            self.rolling_radii(),
            profiles.flange_back_distance.si(),
            profiles.flange_back_position.si(),
        )
        .map_err(|error| fits("profiles.wheel", error))?;
        Ok(WheelsetOnTrack { wheels, track })
    }

    /// Contact of the wheelset of the case over its lateral shift, every 0.1 mm.
    ///
    /// # Errors
    /// As [`wheelset_on_track`](Self::wheelset_on_track), and where the centred wheelset does not touch both rails.
    pub fn contact_table(&self, wheelset: &WheelsetOnTrack) -> Result<ContactTable, CaseError> {
        ContactTable::new(wheelset, self.rolling_radii(), FARTHEST, STEP)
            .map_err(|error| self.text.keys.invalid("profiles", &error.to_string(), ""))
    }

    /// Rolling radii of the left and the right wheel \[m\].
    pub fn rolling_radii(&self) -> [f64; 2] {
        let wheel = &self.file.wheel;
        let right = wheel.rolling_radius.si();
        [
            wheel.left_rolling_radius.map_or(right, |left| left.si()),
            right,
        ]
    }

    /// What is to be told of the points of profiles that are files.
    ///
    /// # Errors
    /// [`CaseError`] for profiles that cannot be read.
    pub fn remarks_of_profiles(&self) -> Result<Vec<Remark>, CaseError> {
        let Some(profiles) = self.file.profiles.as_ref().filter(|one| !is_cone(one)) else {
            return Ok(Vec::new());
        };
        let mut names = vec![("profiles.wheel", &profiles.wheel)];
        match &profiles.rail {
            None => {}
            Some(RailProfiles::Both(rail)) => names.push(("profiles.rail", rail)),
            Some(RailProfiles::Each(rails)) => names.extend([
                ("profiles.rail.left", &rails.left),
                ("profiles.rail.right", &rails.right),
            ]),
        }
        let mut remarks = Vec::new();
        for (key, name) in names {
            remarks.extend(self.profile(key, name)?.remarks);
        }
        Ok(remarks)
    }

    fn profile(&self, key: &str, name: &str) -> Result<ProfileOfName, CaseError> {
        let profiles = self.file.profiles.as_ref();
        let scatter = profiles.and_then(|profiles| profiles.scatter);
        let scatter = scatter.map(|scatter| scatter.si());
        profile_of(name, &self.folder, scatter).map_err(|error| match error {
            CaseError::Read { reason, .. } => {
                let known = riffel::profile::NOMINAL
                    .map(|profile| profile.name)
                    .join(", ");
                let path = self.folder.join(Path::new(name));
                let rule = format!(
                    "is \"{name}\", but {} cannot be read: {reason}",
                    path.display()
                );
                self.text
                    .keys
                    .invalid(key, &rule, &format!("nominal profiles: {known}"))
            }
            error => error,
        })
    }

    /// Rolling on the profiles of the case.
    pub(super) fn on_profiles(
        &self,
        theory: CurvingTheory,
        profiles: &Profiles,
        contact_plane: ContactPlane,
    ) -> Result<Kinematics, CaseError> {
        if theory == CurvingTheory::Linear {
            let rule = "is a profile, but curve.theory = \"linear\" runs on cones";
            let help = "choose wheel = \"cone\" with the equivalent conicity of `riffel profile CASE --wheelset`";
            return Err(self.text.keys.invalid("profiles.wheel", rule, help));
        }
        let of_cones = [
            ("profiles.conicity", profiles.conicity.is_some()),
            ("profiles.flange", profiles.flange.is_some()),
        ];
        if let Some((key, _)) = of_cones.into_iter().find(|(_, given)| *given) {
            let rule = "is set, but belongs to profiles.wheel = \"cone\"";
            return Err(self.text.keys.invalid(key, rule, ""));
        }
        let wheelset = self.wheelset_on_track()?;
        Ok(Kinematics::Nonlinear {
            surfaces: Arc::new(self.contact_table(&wheelset)?),
            contact_plane,
            flange: None,
        })
    }
}
