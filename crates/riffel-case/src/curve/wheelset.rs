//! The wheelset of a case on its track.

use riffel_keys::{CaseError, Message, number, say};
use std::path::Path;

use riffel::{ElasticMaterial, Rail};
use riffel_curving::profile::{
    NOMINAL, NominalProfile, Profile, ProfileError, RadiusDifference, RollingTable, Track, WheelDimensions, Wheels,
    WheelsetOnTrack,
};
use riffel_curving::{ContactPlane, Kinematics};
use riffel_rail::{ProfileKind, ProfileOfName, ProfileReading, profile_of};
use std::sync::Arc;

use super::CurvingCase;
use super::build::is_cone;
use crate::file::{CurvingTheory, LEFT_WHEEL, Profiles, RailProfiles};
use crate::parts::shared::Shared;

/// Lateral shift \[m\] to either side over which contact is tabulated, and the step.
const FARTHEST: f64 = 0.012;
const STEP: f64 = 1e-4;
/// How far beyond the shift at which a wheel comes to its flange contact is tabulated at least \[m\]: on a wide gauge that is
/// beyond [`FARTHEST`].
const BEYOND_FLANGE: f64 = 5e-3;

/// Wheelsets on their tracks, and tables of how they roll there, of cases that differ in other keys.
#[derive(Clone, Default)]
pub(crate) struct SharedProfiles {
    wheelsets: Shared<Arc<WheelsetOnTrack>>,
    surfaces: Shared<Arc<RollingTable>>,
}

impl SharedProfiles {
    /// Those that are kept as long as any case that shares them.
    pub(crate) fn kept() -> Self {
        Self { wheelsets: Shared::kept(), surfaces: Shared::kept() }
    }

    /// These, or others that are kept where these are not.
    pub(crate) fn or_kept(&self) -> Self {
        if self.wheelsets.is_kept() { self.clone() } else { Self::kept() }
    }
}

/// Lateral shift \[m\] over which the contact of a wheelset is tabulated.
fn farthest(wheelset: &WheelsetOnTrack) -> f64 {
    let flanges = Rail::BOTH.map(|rail| wheelset.flange_shift(rail, 0.0));
    let flanges = flanges.into_iter().flatten();
    flanges.fold(FARTHEST, |farthest, flange| farthest.max(flange + BEYOND_FLANGE))
}

impl CurvingCase {
    /// The steel of wheels and rails.
    ///
    /// # Errors
    /// [`CaseError`] for constants that no material has.
    pub fn steel(&self) -> Result<ElasticMaterial, CaseError> {
        let steel = &self.file.steel;
        ElasticMaterial::new(steel.youngs_modulus.si(), steel.poisson_ratio.si())
            .map_err(|error| self.physics("steel", error))
    }

    /// The wheelset of the case on its track.
    ///
    /// # Errors
    /// [`CaseError`] with the key or with file and line: for cones, profiles that cannot be read, are mirrored or upside
    /// down, and a gauge that the rails cannot have.
    pub fn wheelset_on_track(&self) -> Result<Arc<WheelsetOnTrack>, CaseError> {
        let make = || Ok(Arc::new(self.new_wheelset_on_track()?));
        self.shared.wheelsets.get(|| self.of_profiles(), make)
    }

    /// All that a wheelset on its track depends on.
    fn of_profiles(&self) -> String {
        let Self { file, folder, .. } = self;
        format!("{:?} {:?} {folder:?}", file.profiles, file.wheel)
    }

    fn new_wheelset_on_track(&self) -> Result<WheelsetOnTrack, CaseError> {
        let profiles = self.profiles()?;
        if is_cone(profiles) {
            let help = say!(name_a_profile, name = "S1002");
            let rule = say!(is_cone_without_profile);
            return Err(self.text.keys.invalid("profiles.wheel", rule, help));
        }
        let (left, right) = (self.profile_of_rail(Rail::Left)?, self.profile_of_rail(Rail::Right)?);
        let wheel = self.profile("profiles.wheel", &profiles.wheel)?.profile;
        let left_wheel = match &profiles.left_wheel {
            Some(left) => self.profile(LEFT_WHEEL, left)?.profile,
            None => wheel.clone(),
        };
        let fits = |key: &str, error: ProfileError| match error {
            ProfileError::Gauge { .. } | ProfileError::GaugeHeight { .. } => {
                self.text.keys.invalid("profiles.gauge", &error, "")
            }
            error => self.text.keys.invalid(key, &error, ""),
        };
        let track =
            Track::new([&left, &right], profiles.gauge.si(), profiles.gauge_height.si(), profiles.inclination.slope)
                .map_err(|error| fits("profiles.rail", error))?;
        let wheels = Wheels::new(
            [&left_wheel, &wheel],
            self.rolling_radii(),
            profiles.flange_back_distance.si(),
            profiles.flange_back_position.si(),
        )
        .map_err(|error| fits("profiles.wheel", error))?;
        let wheelset = WheelsetOnTrack { wheels, track };
        self.check_gauge(profiles, [&left_wheel, &wheel], &wheelset)?;
        Ok(wheelset)
    }

    /// `Ok` if the wheelset goes between the rails and stands on both.
    fn check_gauge(
        &self,
        profiles: &Profiles,
        wheels: [&Profile; 2],
        wheelset: &WheelsetOnTrack,
    ) -> Result<(), CaseError> {
        let gauge = &profiles.gauge;
        let refuse = |rule: Message| {
            let help = say!(check_places_of_flanges);
            Err(self.text.keys.invalid("profiles.gauge", &rule, help))
        };
        let flange_back = profiles.flange_back_position.si();
        let thickness = |wheel| WheelDimensions::new(wheel, flange_back).ok()?.flange_thickness;
        if let [Some(left), Some(right)] = wheels.map(thickness) {
            let flanges = left + right;
            let over = profiles.flange_back_distance.si() + flanges;
            if over > gauge.si() {
                return refuse(say!(
                    is_but_the_wheelset_is_mm,
                    gauge,
                    width = number(format_args!("{:.1}", 1e3 * over))
                ));
            }
        }
        if wheelset.contact(0.0, 0.0).is_err() {
            let ends: f64 = wheels.iter().map(|wheel| wheel.range()[1]).sum();
            return refuse(say!(
                is_but_the_wheels_mm_wide,
                gauge,
                width = number(format_args!("{:.1}", 1e3 * (wheelset.wheels.spacing() + ends)))
            ));
        }
        Ok(())
    }

    /// Rolling radius difference of the wheelset of the case over its lateral shift, every 0.1 mm: of an axle that stays level, as
    /// EN 15302 has it, and of one that rolls as both wheels touch.
    ///
    /// # Errors
    /// Errors of [`wheelset_on_track`](Self::wheelset_on_track), and where the centred wheelset does not touch both rails.
    pub fn radius_differences(&self, wheelset: &WheelsetOnTrack) -> Result<[RadiusDifference; 2], CaseError> {
        let [_, right] = self.rolling_radii();
        let farthest = farthest(wheelset);
        let of = |table: Result<RadiusDifference, ProfileError>| {
            table.map_err(|error| self.text.keys.invalid("profiles", &error, ""))
        };
        Ok([
            of(RadiusDifference::level(wheelset, right, farthest, STEP))?,
            of(RadiusDifference::rolling(wheelset, right, farthest, STEP))?,
        ])
    }

    /// Rolling radii of the left and the right wheel \[m\].
    pub fn rolling_radii(&self) -> [f64; 2] {
        let wheel = &self.file.wheel;
        let right = wheel.rolling_radius.si();
        [wheel.left_rolling_radius.map_or(right, |left| left.si()), right]
    }

    /// What is to be told of the points of profiles that are files.
    ///
    /// # Errors
    /// [`CaseError`] for profiles that cannot be read.
    pub fn remarks_of_profiles(&self) -> Result<Vec<Message>, CaseError> {
        let Some(profiles) = self.file.profiles.as_ref().filter(|one| !is_cone(one)) else {
            return Ok(Vec::new());
        };
        let mut remarks = Vec::new();
        for (key, name) in profiles.names() {
            remarks.extend(self.profile(key, name)?.remarks);
        }
        Ok(remarks)
    }

    /// The profile of a rail of the case.
    pub(crate) fn profile_of_rail(&self, rail: Rail) -> Result<Profile, CaseError> {
        let rails = self.profiles()?.rail.as_ref().ok_or_else(|| {
            let help = say!(name_a_profile, name = "60E1");
            self.text.keys.missing("profiles.rail", help)
        })?;
        let (key, name) = match (rails, rail) {
            (RailProfiles::Both(name), _) => ("profiles.rail", name),
            (RailProfiles::Each(each), Rail::Left) => ("profiles.rail.left", &each.left),
            (RailProfiles::Each(each), Rail::Right) => ("profiles.rail.right", &each.right),
        };
        Ok(self.profile(key, name)?.profile)
    }

    fn profile(&self, key: &str, name: &str) -> Result<ProfileOfName, CaseError> {
        let profiles = self.file.profiles.as_ref();
        let is_wheel = key == "profiles.wheel" || key == LEFT_WHEEL;
        if let Some(nominal) = NominalProfile::named(name).filter(|one| one.is_wheel != is_wheel) {
            let of_kind = NOMINAL.iter().filter(|one| one.is_wheel == is_wheel);
            let known = of_kind.map(|one| one.name).collect::<Vec<_>>().join(", ");
            let (name, known) = (nominal.name, known.as_str());
            let [rule, help] = match is_wheel {
                true => [say!(is_nominal_rail, name), say!(nominal_wheels, known)],
                false => [say!(is_nominal_wheel, name), say!(nominal_rails, known)],
            };
            return Err(self.text.keys.invalid(key, rule, help));
        }
        let reading = ProfileReading {
            kind: Some(match is_wheel {
                true => ProfileKind::Wheel,
                false => ProfileKind::Rail,
            }),
            side: match key {
                "profiles.rail.left" | LEFT_WHEEL => Rail::Left,
                _ => Rail::Right,
            },
            orientation: profiles.and_then(|profiles| match is_wheel {
                true => profiles.wheel_orientation,
                false => profiles.rail_orientation,
            }),
            scatter: profiles.and_then(|profiles| profiles.scatter).map(|scatter| scatter.si()),
            flange_back: profiles
                .map_or(ProfileReading::default().flange_back, |profiles| profiles.flange_back_position.si()),
        };
        profile_of(name, &self.folder, reading).map_err(|error| match error {
            CaseError::Read { reason, .. } => {
                let known = NOMINAL.map(|profile| profile.name).join(", ");
                let path = self.folder.join(Path::new(name));
                let rule = say!(is_but_cannot_be_read, name, path = path.display(), reason = reason.to_string());
                self.text.keys.invalid(key, &rule, say!(nominal_profiles, known))
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
            let (rule, help) = (say!(is_profile_in_linear_theory), say!(choose_cone));
            return Err(self.text.keys.invalid("profiles.wheel", rule, help));
        }
        let of_cones =
            [("profiles.conicity", profiles.conicity.is_some()), ("profiles.flange", profiles.flange.is_some())];
        if let Some((key, _)) = of_cones.into_iter().find(|(_, given)| *given) {
            let rule = say!(is_set_but_of_cones);
            return Err(self.text.keys.invalid(key, rule, ""));
        }
        let make = || {
            let wheelset = self.wheelset_on_track()?;
            let farthest = farthest(&wheelset);
            let table = RollingTable::new(&wheelset, self.rolling_radii(), farthest, STEP)
                .map_err(|error| self.text.keys.invalid("profiles", &error, ""))?;
            Ok(Arc::new(table))
        };
        Ok(Kinematics::Nonlinear {
            surfaces: self.shared.surfaces.get(|| self.of_profiles(), make)?,
            contact_plane,
            flange: None,
        })
    }
}
