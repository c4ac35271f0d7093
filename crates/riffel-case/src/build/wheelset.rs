//! From the keys of a wheelset to its model.

use std::sync::Arc;

use riffel::wheelset::{
    Axle, ContactGeometry, FlexibleWheelset, RememberingWheelset, RigidBody, RigidWheelset, Segment, Suspension,
};
use riffel::{ElasticMaterial, Rail};
use riffel_keys::{CaseError, Message};
use riffel_rail::response::{MeasurementError, WheelsetModes, WheelsetReceptances};

use crate::file;
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::general_keys::{AxleKeys, RigidBodyKeys, WheelsetKeys, WheelsetModelKeys};
use crate::parts::wheelset::{BuiltWheelset, CaseWheelset};

impl CheckedKeys {
    /// The wheelset, whose wheels have the rolling radius \[m\] and of which that on `rail` is under study; beside it, where the
    /// case shares its parts, the same with its memory.
    pub(crate) fn wheelset(
        &self,
        keys: &WheelsetKeys,
        rolling_radius: f64,
        rail: Rail,
        remarks: &mut Vec<Message>,
    ) -> Result<BuiltWheelset, CaseError> {
        let mut new = || self.new_wheelset(keys, rolling_radius, rail, remarks);
        match &keys.model {
            // A table has nothing to remember, and its remarks belong to each case.
            WheelsetModelKeys::Measured { .. } => Ok((Arc::new(new()?), None)),
            _ => {
                let wheelsets = &self.given.wheelsets;
                wheelsets.get(
                    || format!("{keys:?} {rolling_radius:?}"),
                    || {
                        let wheelset = Arc::new(new()?);
                        let remembering = || Arc::new(RememberingWheelset::new(wheelset.clone(), wheelset.with_hubs()));
                        let remembering = wheelsets.is_kept().then(remembering);
                        Ok((wheelset, remembering))
                    },
                )
            }
        }
    }

    fn new_wheelset(
        &self,
        keys: &WheelsetKeys,
        rolling_radius: f64,
        rail: Rail,
        remarks: &mut Vec<Message>,
    ) -> Result<CaseWheelset, CaseError> {
        let contacts = ContactGeometry { contact_spacing: keys.contact_spacing, rolling_radius };
        let suspension = keys.suspension.as_ref();
        let suspension = suspension.map(|suspension| self.suspension(suspension)).transpose()?;
        match &keys.model {
            WheelsetModelKeys::Rigid(body) => {
                let rigid = self.rigid_wheelset(body, contacts, suspension)?;
                Ok(CaseWheelset::Rigid(rigid))
            }
            WheelsetModelKeys::Flexible { axle, discs } => {
                let discs = discs.iter().map(Into::into).collect();
                let flexible = FlexibleWheelset::new(self.axle(axle)?, discs, contacts);
                let mut flexible = self.physics("wheelset", flexible)?;
                if let Some(suspension) = suspension {
                    let sprung = flexible.with_suspension(suspension);
                    flexible = self.physics("wheelset.suspension", sprung)?;
                }
                Ok(CaseWheelset::Flexible(Box::new(flexible)))
            }
            WheelsetModelKeys::Modal { file, body } => {
                let rigid = self.rigid_wheelset(body, contacts, suspension)?;
                let modal = WheelsetModes::read(file).and_then(|modes| modes.wheelset(rigid));
                let modal = modal.map_err(|error| self.wheelset_file_error(&error))?;
                Ok(CaseWheelset::Modal(Box::new(modal), rigid))
            }
            WheelsetModelKeys::Measured { file } => {
                let measured =
                    WheelsetReceptances::read(file, rail).map_err(|error| self.wheelset_file_error(&error))?;
                remarks.extend(measured.remarks);
                Ok(CaseWheelset::Measured(measured.wheelset))
            }
        }
    }

    fn wheelset_file_error(&self, error: &MeasurementError) -> CaseError {
        self.text.keys.invalid("wheelset.file", &error.message, "")
    }

    fn rigid_wheelset(
        &self,
        body: &RigidBodyKeys,
        contacts: ContactGeometry,
        suspension: Option<Suspension>,
    ) -> Result<RigidWheelset, CaseError> {
        let body = RigidBody { mass: body.mass, roll_inertia: body.roll_inertia, spin_inertia: body.spin_inertia };
        let rigid = self.physics("wheelset", RigidWheelset::new(body, contacts))?;
        Ok(match suspension {
            Some(suspension) => rigid.with_suspension(suspension),
            None => rigid,
        })
    }

    fn suspension(&self, keys: &file::Suspension) -> Result<Suspension, CaseError> {
        let stiffness = [keys.longitudinal_stiffness, keys.lateral_stiffness, keys.vertical_stiffness];
        let damping = [keys.longitudinal_damping, keys.lateral_damping, keys.vertical_damping];
        let suspension = Suspension::new(
            stiffness.map(|stiffness| stiffness.si()),
            damping.map(|damping| damping.si()),
            keys.spacing.si(),
        );
        self.physics("wheelset.suspension", suspension)
    }

    pub(crate) fn axle(&self, keys: &AxleKeys) -> Result<Axle, CaseError> {
        let material = ElasticMaterial::new(keys.youngs_modulus, keys.poisson_ratio);
        let material = self.physics("wheelset.axle", material)?;
        let segments = keys.segments.iter();
        let segments = segments.map(|&[length, diameter]| Segment { length, diameter });
        let axle = Axle::new(material, keys.density, segments.collect())
            .and_then(|axle| axle.with_shear_coefficient(keys.shear_coefficient))
            .and_then(|axle| axle.with_loss_factor(keys.loss_factor));
        self.physics("wheelset.axle", axle)
    }
}
