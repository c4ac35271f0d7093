//! The keys of the wheelset, checked and complete.

use riffel_keys::{CaseError, say};
use std::path::PathBuf;

use riffel::wheelset::{ContactGeometry, FlexibleWheelset, RigidBody};
use riffel_keys::quantity::Quantity;

use super::or;
use crate::file::{Axle, Disc, Suspension, Wheelset, WheelsetModel};
use crate::keys::checked_keys::CheckedKeys;

/// A wheelset.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct WheelsetKeys {
    /// Distance of the contacts 2s \[m\].
    pub(crate) contact_spacing: f64,
    /// Primary suspension, if any.
    pub(crate) suspension: Option<Suspension>,
    /// Its model.
    pub(crate) model: WheelsetModelKeys,
}

/// A model of a wheelset.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum WheelsetModelKeys {
    /// One rigid body.
    Rigid(RigidBodyKeys),
    /// A flexible axle with discs.
    Flexible {
        /// The axle.
        axle: AxleKeys,
        /// The discs.
        discs: Vec<Disc>,
    },
    /// Modes from a file.
    Modal {
        /// The file.
        file: PathBuf,
        /// The motions without deformation.
        body: RigidBodyKeys,
    },
    /// Frequency responses from a file.
    Measured {
        /// The file.
        file: PathBuf,
    },
}

/// A wheelset as a rigid body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RigidBodyKeys {
    /// M \[kg\].
    pub(crate) mass: f64,
    /// J_x \[kg m²\].
    pub(crate) roll_inertia: f64,
    /// J_y \[kg m²\].
    pub(crate) spin_inertia: f64,
}

/// A flexible axle.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct AxleKeys {
    /// Length and diameter of each segment \[m\], from left to right.
    pub(crate) segments: Vec<[f64; 2]>,
    /// ρ \[kg/m³\].
    pub(crate) density: f64,
    /// E \[Pa\].
    pub(crate) youngs_modulus: f64,
    /// ν \[-\].
    pub(crate) poisson_ratio: f64,
    /// κ \[-\].
    pub(crate) shear_coefficient: f64,
    /// η \[-\].
    pub(crate) loss_factor: f64,
}

impl AxleKeys {
    /// Its length \[m\].
    pub(crate) fn length(&self) -> f64 {
        self.segments.iter().map(|[length, _]| length).sum()
    }
}

impl CheckedKeys {
    pub(super) fn wheelset_keys(&self, wheelset: &Wheelset) -> Result<WheelsetKeys, CaseError> {
        let model = match wheelset.model {
            WheelsetModel::Rigid => WheelsetModelKeys::Rigid(self.rigid_body(wheelset)?),
            WheelsetModel::Flexible => {
                let axle = self.of_wheelset("wheelset.axle", wheelset.axle.as_ref())?;
                let axle = self.axle_keys(axle)?;
                self.check_places(wheelset, axle.length())?;
                WheelsetModelKeys::Flexible { axle, discs: wheelset.discs.clone() }
            }
            WheelsetModel::Modal => {
                WheelsetModelKeys::Modal { file: self.wheelset_file(wheelset)?, body: self.rigid_body(wheelset)? }
            }
            WheelsetModel::Measured => WheelsetModelKeys::Measured { file: self.wheelset_file(wheelset)? },
        };
        Ok(WheelsetKeys {
            contact_spacing: wheelset.contact_spacing.si(),
            suspension: wheelset.suspension.clone(),
            model,
        })
    }

    fn rigid_body(&self, wheelset: &Wheelset) -> Result<RigidBodyKeys, CaseError> {
        let written = [wheelset.mass.is_some(), wheelset.roll_inertia.is_some(), wheelset.spin_inertia.is_some()];
        // A preset tells axle and discs, of which the body consists.
        if let (true, Some(body)) = (written.contains(&false), self.body_of_axle(wheelset)?) {
            return Ok(RigidBodyKeys {
                mass: or(wheelset.mass, body.mass),
                roll_inertia: or(wheelset.roll_inertia, body.roll_inertia),
                spin_inertia: or(wheelset.spin_inertia, body.spin_inertia),
            });
        }
        Ok(RigidBodyKeys {
            mass: self.of_wheelset("wheelset.mass", wheelset.mass)?.si(),
            roll_inertia: self.of_wheelset("wheelset.roll_inertia", wheelset.roll_inertia)?.si(),
            spin_inertia: self.of_wheelset("wheelset.spin_inertia", wheelset.spin_inertia)?.si(),
        })
    }

    /// Mass and inertias of axle and discs; none without them.
    fn body_of_axle(&self, wheelset: &Wheelset) -> Result<Option<RigidBody>, CaseError> {
        let Some(axle) = wheelset.axle.as_ref().filter(|_| !wheelset.discs.is_empty()) else {
            return Ok(None);
        };
        let contacts = ContactGeometry {
            contact_spacing: wheelset.contact_spacing.si(),
            rolling_radius: self.file.wheel.rolling_radius.si(),
        };
        let axle = self.axle(&self.axle_keys(axle)?)?;
        let discs = wheelset.discs.iter().map(Into::into).collect();
        let flexible = FlexibleWheelset::new(axle, discs, contacts);
        Ok(Some(self.physics("wheelset", flexible)?.rigid_body()))
    }

    fn wheelset_file(&self, wheelset: &Wheelset) -> Result<PathBuf, CaseError> {
        let file = self.of_wheelset("wheelset.file", wheelset.file.as_ref())?;
        // Without a folder a case that names a file has been refused.
        Ok(self.folder.as_ref().map_or_else(PathBuf::new, |folder| folder.join(file)))
    }

    /// A value that the model of the wheelset cannot do without.
    fn of_wheelset<T>(&self, key: &str, value: Option<T>) -> Result<T, CaseError> {
        value.ok_or_else(|| {
            let model = self.file.wheelset.as_ref().map_or("", |wheelset| wheelset.model.name());
            let help = say!(wheelset_model_needs_it, model);
            self.text.keys.missing(key, &help)
        })
    }

    fn axle_keys(&self, axle: &Axle) -> Result<AxleKeys, CaseError> {
        let steel = &self.file.steel;
        let poisson_ratio = or(axle.poisson_ratio, steel.poisson_ratio.si());
        // Of a solid circle; Cowper (1966).
        let of_a_circle = 6.0 * (1.0 + poisson_ratio) / (7.0 + 6.0 * poisson_ratio);
        Ok(AxleKeys {
            segments: self.axle_segments(axle)?,
            density: axle.density.si(),
            youngs_modulus: or(axle.youngs_modulus, steel.youngs_modulus.si()),
            poisson_ratio,
            shear_coefficient: or(axle.shear_coefficient, of_a_circle),
            loss_factor: axle.loss_factor.si(),
        })
    }

    /// Length and diameter of each segment \[m\].
    fn axle_segments(&self, axle: &Axle) -> Result<Vec<[f64; 2]>, CaseError> {
        let keys = &self.text.keys;
        if let Some(segments) = &axle.segments {
            let one = [("length", axle.length), ("diameter", axle.diameter)];
            if let Some((name, _)) = one.iter().find(|(_, value)| value.is_some()) {
                return Err(keys.invalid(
                    "wheelset.axle.segments",
                    format!("and `wheelset.axle.{name}` exclude each other"),
                    say!(give_length_and_diameter_of_an),
                ));
            }
            if segments.is_empty() {
                return Err(keys.invalid("wheelset.axle.segments", say!(is_an_empty_list_an_axle), ""));
            }
            let segments = segments.iter();
            return Ok(segments.map(|segment| [segment.length.si(), segment.diameter.si()]).collect());
        }
        let need = |name: &str, value: Option<Quantity<_>>| {
            value.ok_or_else(|| keys.missing(&format!("wheelset.axle.{name}"), say!(give_length_and_diameter_of_an)))
        };
        let length = need("length", axle.length)?.si();
        Ok(vec![[length, need("diameter", axle.diameter)?.si()]])
    }

    /// `Ok` if contacts, discs and suspension are on an axle of the length \[m\].
    fn check_places(&self, wheelset: &Wheelset, length: f64) -> Result<(), CaseError> {
        /// The sum of the lengths is rounded.
        const ROUNDING: f64 = 1e-9;
        let most = length * (1.0 + ROUNDING);
        let suspension = wheelset.suspension.as_ref();
        let spacings = [
            ("wheelset.contact_spacing", Some(wheelset.contact_spacing)),
            ("wheelset.suspension.spacing", suspension.map(|suspension| suspension.spacing)),
        ];
        for (key, spacing) in spacings {
            if let Some(spacing) = spacing.filter(|spacing| spacing.si() > most) {
                let rule = say!(at_most_the_length_of_the, length);
                return Err(self.out_of_range(key, spacing, &rule));
            }
        }
        for (index, disc) in wheelset.discs.iter().enumerate() {
            if 2.0 * disc.position.si().abs() > most {
                let end = 0.5 * length;
                return Err(self.out_of_range(
                    &format!("wheelset.discs[{index}].position"),
                    disc.position,
                    say!(between_m_and_m_the_ends, end),
                ));
            }
        }
        Ok(())
    }
}
