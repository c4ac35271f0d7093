//! The wheelset as a rigid body.

use num_complex::Complex64;

use super::free_motion::FreeMotion;
use super::rigid_motions::{RigidMotions, RigidPlane};
use super::section::{Between, SectionReceptances};
use super::{ContactGeometry, ContactReceptances, RigidMotion, Suspension, Wheelset, WheelsetWithHubs};
use crate::{Direction, Error};

/// Mass and moments of inertia of a wheelset, which is symmetric about the line of its axle and about its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBody {
    /// Mass M \[kg\].
    pub mass: f64,
    /// Roll inertia J_x about the direction of travel through the middle of the axle, and yaw inertia \[kg m²\].
    pub roll_inertia: f64,
    /// Inertia J_y about the axle \[kg m²\].
    pub spin_inertia: f64,
}

/// A rigid wheelset, free or on its primary suspension.
///
/// With u = u_c + θ × r at r = (0, ±s, R), the springs of the suspension at (0, ±s_b, 0) and the displacement of each
/// motion of the body per force or moment h = 1/D:
///
/// ```text
/// D_{x,y,z} = −ω²M + 2(k + iωc)      D_roll = −ω²J_x + 2s_b²(k_z + iωc_z)
/// D_spin = −ω²J_y                    D_yaw  = −ω²J_x + 2s_b²(k_x + iωc_x)
/// H_xx = h_x + R² h_spin + y y' h_yaw        H_yy = h_y + R² h_roll
/// H_zz = h_z + y y' h_roll                   H_zy = −R y h_roll                 y, y' = ±s: at, from
/// ```
///
/// The rest is zero. Range of validity: below the first torsion of the axle (40–90 Hz) and its first bending (60–100 Hz).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidWheelset {
    body: RigidBody,
    contacts: ContactGeometry,
    suspension: Option<Suspension>,
}

impl RigidWheelset {
    /// A free wheelset.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless every value is positive.
    pub fn new(body: RigidBody, contacts: ContactGeometry) -> Result<Self, Error> {
        Error::unless_positive("wheelset mass", body.mass, "kg")?;
        Error::unless_positive("roll inertia", body.roll_inertia, "kg m2")?;
        Error::unless_positive("spin inertia", body.spin_inertia, "kg m2")?;
        Ok(Self { body, contacts: contacts.checked()?, suspension: None })
    }

    /// Wheelset on a primary suspension.
    pub fn with_suspension(self, suspension: Suspension) -> Self {
        Self { suspension: Some(suspension), ..self }
    }

    /// Mass and moments of inertia.
    pub fn body(&self) -> RigidBody {
        self.body
    }

    /// Natural angular frequencies on the suspension without its damping \[rad/s\], lowest first: √(2k/M) along each axis,
    /// √(2s_b²k/J_x) in roll and yaw. A motion without springs has none, and spin never has.
    pub fn natural_frequencies(&self) -> Vec<(f64, RigidMotion)> {
        let Some(suspension) = &self.suspension else {
            return Vec::new();
        };
        let [along, across, upward] = Direction::ALL.map(|axis| 2.0 * suspension.along(axis)[0]);
        let lever = suspension.half_spacing().powi(2);
        let (mass, turning) = (self.body.mass, self.body.roll_inertia);
        let mut frequencies = vec![
            ((along / mass).sqrt(), RigidMotion::Longitudinal),
            ((across / mass).sqrt(), RigidMotion::Lateral),
            ((upward / mass).sqrt(), RigidMotion::Bounce),
            ((lever * upward / turning).sqrt(), RigidMotion::Roll),
            ((lever * along / turning).sqrt(), RigidMotion::Yaw),
        ];
        frequencies.retain(|&(frequency, _)| frequency > 0.0);
        frequencies.sort_by(|a, b| a.0.total_cmp(&b.0));
        frequencies
    }
}

impl Wheelset for RigidWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        let sections = self.sections(angular_frequency);
        sections.at_contacts(self.contacts.rolling_radius)
    }

    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        self.free_motion().at_contacts()
    }
}

impl WheelsetWithHubs for RigidWheelset {
    fn hubs(&self, angular_frequency: f64) -> Between {
        self.sections(angular_frequency).forward
    }

    fn receptances_and_hubs(&self, angular_frequency: f64) -> (ContactReceptances, Between) {
        (self.receptances(angular_frequency), self.hubs(angular_frequency))
    }

    fn free_hubs(&self) -> [[f64; 2]; 2] {
        self.free_motion().of_hubs()
    }
}

impl RigidWheelset {
    fn sections(&self, angular_frequency: f64) -> SectionReceptances {
        let w = angular_frequency;
        let inertia = |inertia: f64| Complex64::from(-w * w * inertia);
        let springs = |direction| match &self.suspension {
            Some(suspension) => 2.0 * suspension.dynamic_stiffness(direction, w),
            None => Complex64::ZERO,
        };
        let arm = self.suspension.map_or(0.0, |suspension| suspension.half_spacing().powi(2));
        let along = |direction| (inertia(self.body.mass) + springs(direction)).inv();
        let turning = |direction| (inertia(self.body.roll_inertia) + arm * springs(direction)).inv();
        let plane =
            |direction| RigidPlane { shift: along(direction), coupling: Complex64::ZERO, turn: turning(direction) };
        let motions = RigidMotions {
            horizontal: plane(Direction::Longitudinal),
            sideward: along(Direction::Lateral),
            vertical: plane(Direction::Vertical),
            spin: inertia(self.body.spin_inertia).inv(),
        };
        motions.sections(self.contacts)
    }

    fn free_motion(&self) -> FreeMotion {
        FreeMotion::new(self.body, 0.0, self.suspension.as_ref(), self.contacts)
    }
}
