//! The vehicle in its curve from its keys.

use riffel_keys::{CaseError, number, say};
use std::sync::Arc;

use riffel::contact::{CreepEllipse, HertzContact, KalkerCoefficients, ShenHedrickElkins};
use riffel_curving::{
    Axle, Cone, ConeWithFlangePlane, ContactPlane, Creep, Curve, FlangeSpring, GRAVITY, Kinematics, LawOnEllipse,
    RunningSurfaces, VehicleInCurve,
};
use riffel_keys::quantity::{Dimension, Quantity};

use super::CurvingCase;
use crate::file::{self, CurvingContact, CurvingLaw, CurvingTheory, Profiles};

/// A spacing of the contacts is that of the profiles to this difference \[m\]: it is measured to tenths of a millimetre.
const SAME_SPACING: f64 = 1e-4;

impl CurvingCase {
    pub(super) fn build_vehicle(&self) -> Result<VehicleInCurve, CaseError> {
        let curve = self.table("curve", &self.file.curve, "radius and speed")?;
        let bogie = self.table(
            "bogie",
            &self.file.bogie,
            "wheelbase, primary_spacing, both primary stiffnesses, mass_per_axle and centre_of_mass_height",
        )?;
        let profiles = self.profiles()?;
        let contact = self.table("contact", &self.file.contact, "friction")?;
        let running_gear = self.running_gear(bogie)?;
        let (what, shortest) = self.shortest_radius();
        if curve.radius.si().abs() < shortest {
            let rule = say!(larger_than, what, length = shortest);
            let rule = say!(is_but_must_be, value = curve.radius, rule);
            return Err(self.text.keys.invalid("curve.radius", rule, ""));
        }
        let kinematics = self.kinematics(curve.theory, profiles)?;
        let axle = self.axle(bogie, self.contact_spacing(profiles)?)?;
        Ok(VehicleInCurve {
            curve: Curve { radius: curve.radius.si(), cant: curve.cant.si(), speed: curve.speed.si() },
            kinematics,
            creep: self.creep(curve.theory, profiles, contact, &axle)?,
            drive_torque: self.drive_torque(bogie, running_gear.wheelsets())?,
            running_gear,
            axle,
        })
    }

    fn table<'a, T>(&self, key: &str, table: &'a Option<T>, needs: &str) -> Result<&'a T, CaseError> {
        let help = say!(give_with, key, needs);
        table.as_ref().ok_or_else(|| self.text.keys.missing(key, &help))
    }

    pub(super) fn profiles(&self) -> Result<&Profiles, CaseError> {
        self.table("profiles", &self.file.profiles, "wheel and rail, or wheel = \"cone\" and conicity")
    }

    pub(super) fn required<D: Dimension>(&self, key: &str, value: Option<Quantity<D>>) -> Result<f64, CaseError> {
        let value = value.ok_or_else(|| self.text.keys.missing(key, ""))?;
        Ok(value.si())
    }

    fn contact_spacing(&self, profiles: &Profiles) -> Result<f64, CaseError> {
        let key = "wheelset.contact_spacing";
        let given = self.file.wheelset.contact_spacing;
        if is_cone(profiles) {
            let help = "cones need it: the distance of the contacts, 1.5 m at standard gauge";
            let given = given.ok_or_else(|| self.text.keys.missing(key, help))?;
            return Ok(given.si());
        }
        let placed = profiles.flange_back_distance.si() - 2.0 * profiles.flange_back_position.si();
        match given {
            Some(given) if (given.si() - placed).abs() > SAME_SPACING => {
                let rule = say!(is_but_the_profiles_lie_m, given, placed = number(format_args!("{placed:.4}")));
                let help = "leave it out, or change flange_back_distance";
                Err(self.text.keys.invalid(key, &rule, help))
            }
            _ => Ok(placed),
        }
    }

    fn kinematics(&self, theory: CurvingTheory, profiles: &Profiles) -> Result<Kinematics, CaseError> {
        let keys = &self.text.keys;
        let plane = match (profiles.contact_plane, profiles.contact_shift_moment) {
            (file::ContactPlane::Horizontal, Some(true)) => {
                let rule = "is true, but belongs to profiles.contact_plane = \"tilted\"";
                return Err(keys.invalid("profiles.contact_shift_moment", rule, ""));
            }
            (file::ContactPlane::Horizontal, _) => ContactPlane::Horizontal,
            (file::ContactPlane::Tilted, shift_moment) => {
                ContactPlane::Tilted { shift_moment: shift_moment.unwrap_or(is_cone(profiles)) }
            }
        };
        if !is_cone(profiles) {
            return self.on_profiles(theory, profiles, plane);
        }
        if profiles.left_wheel.is_some() {
            let rule = "is set, but profiles.wheel = \"cone\" stands for both wheels";
            return Err(keys.invalid(file::LEFT_WHEEL, rule, ""));
        }
        let conicity =
            profiles.conicity.ok_or_else(|| keys.missing("profiles.conicity", say!(profiles_wheel_cone_needs_it)))?;
        let conicity = conicity.si();
        if theory == CurvingTheory::Linear {
            return match profiles.flange {
                None => Ok(Kinematics::Linear { conicity }),
                Some(_) => Err(keys.invalid(
                    "profiles.flange",
                    say!(is_set_but_curve_theory_linear),
                    say!(leave_it_out_or_choose_curve),
                )),
            };
        }
        let key = |name: &str| format!("profiles.flange.{name}");
        let mut spring = None;
        let mut surfaces: Arc<dyn RunningSurfaces> = Arc::new(Cone { conicity });
        if let Some(flange) = profiles.flange {
            let is_spring = profiles.contact_plane == file::ContactPlane::Horizontal;
            let (needed, foreign, name) = match is_spring {
                true => (&["clearance", "stiffness"][..], &["slope", "shift", "width"][..], "horizontal"),
                false => (&["slope", "shift", "width"][..], &["clearance", "stiffness"][..], "tilted"),
            };
            if let Some(wrong) = foreign.iter().find(|name| keys.has(&key(name))) {
                let rule = say!(is_set_but_profiles_contact_plane, name, keys = needed.join(", "));
                return Err(keys.invalid(&key(wrong), &rule, ""));
            }
            if is_spring {
                spring = Some(FlangeSpring {
                    clearance: self.required(&key("clearance"), flange.clearance)?,
                    stiffness: self.required(&key("stiffness"), flange.stiffness)?,
                });
            } else {
                surfaces = Arc::new(ConeWithFlangePlane {
                    conicity,
                    slope: self.required(&key("slope"), flange.slope)?,
                    shift: self.required(&key("shift"), flange.shift)?,
                    width: self.required(&key("width"), flange.width)?,
                });
            }
        }
        Ok(Kinematics::Nonlinear { surfaces, contact_plane: plane, flange: spring })
    }

    /// Creep on both rails.
    fn creep(
        &self,
        theory: CurvingTheory,
        profiles: &Profiles,
        contact: &CurvingContact,
        axle: &Axle,
    ) -> Result<[Creep; 2], CaseError> {
        let keys = &self.text.keys;
        let usual = match theory {
            CurvingTheory::Linear => CurvingLaw::Linear,
            CurvingTheory::Nonlinear => CurvingLaw::ShenHedrickElkins,
        };
        let law = contact.creep_law.unwrap_or(usual);
        if theory == CurvingTheory::Linear && law != CurvingLaw::Linear {
            let rule = "is not \"linear\", the law of curve.theory = \"linear\"";
            return Err(keys.invalid("contact.creep_law", rule, ""));
        }
        let material = || self.steel();
        let physics = |error| self.physics("contact", error);
        let transverse_radius = || {
            let help = "the ellipse of cones needs it; or give contact.creep_coefficients";
            contact
                .transverse_radius
                .map(|radius| radius.si())
                .ok_or_else(|| keys.missing("contact.transverse_radius", help))
        };
        let ellipse = match contact.creep_coefficients {
            Some(given) => Some(
                CreepEllipse::of_coefficients(
                    given.longitudinal.si(),
                    given.lateral.si(),
                    given.spin.si(),
                    given.load.si(),
                )
                .map_err(physics)?,
            ),
            None if law == CurvingLaw::Linear => {
                let radius = self.file.wheel.rolling_radius.si();
                let load = 0.5 * axle.mass_per_axle * GRAVITY;
                let material = material()?;
                let across = match is_cone(profiles) {
                    true => transverse_radius()?,
                    false => {
                        let help = "creep_law = \"linear\" on profiles needs it";
                        return Err(keys.missing("contact.creep_coefficients", help));
                    }
                };
                let hertz = HertzContact::exact(material, radius, across, load).map_err(physics)?;
                let ratio = hertz.semi_axis_longitudinal() / hertz.semi_axis_lateral();
                let kalker = KalkerCoefficients::new(material.poisson_ratio(), ratio).map_err(physics)?;
                Some(CreepEllipse::new(hertz, kalker))
            }
            None => None,
        };
        if law == CurvingLaw::Fastsim && ellipse.is_some() {
            let rule = "is set, but creep_law = \"fastsim\" needs the ellipse itself, which coefficients do not tell";
            let help = "leave it out, or choose contact.creep_law = \"shen-hedrick-elkins\"";
            return Err(keys.invalid("contact.creep_coefficients", rule, help));
        }
        let [left, right] = contact.friction.of_rails().map(|friction| match (law, ellipse) {
            (CurvingLaw::Linear, Some(ellipse)) => Ok(Creep::Linear { ellipse, friction }),
            (_, Some(ellipse)) => {
                ShenHedrickElkins::new(ellipse, friction).map(|law| Creep::Law(Arc::new(law))).map_err(physics)
            }
            (_, None) => Ok(Creep::Local {
                law: match law {
                    CurvingLaw::Fastsim => LawOnEllipse::Fastsim,
                    _ => LawOnEllipse::ShenHedrickElkins,
                },
                material: material()?,
                rolling_radius: self.file.wheel.rolling_radius.si(),
                lateral_curvature: match is_cone(profiles) {
                    true => transverse_radius()?.recip(),
                    // Profiles tell theirs.
                    false => f64::NAN,
                },
                friction,
            }),
        });
        Ok([left?, right?])
    }
}

/// True for wheels that are cones.
pub(super) fn is_cone(profiles: &Profiles) -> bool {
    profiles.wheel == "cone"
}
