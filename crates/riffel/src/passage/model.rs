//! Track, wheels and contacts of a march.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::{DamageInTime, HertzSpring, LateContact, March, StructuresInTime, WaveInTime};
use crate::contact::{ContactFilter, CreepLaw, MeanRolling};
use crate::feedback::Contact;
use crate::wheelset::Motion;
use crate::{Error, Rail};

/// A contact of a wheel with a rail in time.
#[derive(Clone)]
pub struct ContactInTime {
    /// The spring along its normal.
    pub spring: HertzSpring,
    /// The creep law.
    pub law: Arc<dyn CreepLaw>,
    /// What of load and longitudinal creepage the law is asked about, where the contact answers late.
    pub late: Option<Arc<LateContact>>,
    /// The geometry of the waves under it; `None` if that has no part in its motion.
    pub wave: Option<WaveInTime>,
    /// The mean state, at which a march begins.
    pub mean: MeanRolling,
    /// The rail.
    pub rail: Rail,
    /// Distance along the rail \[m\], zero for the first wheel, negative behind it.
    pub along: f64,
    /// The profile under it over that of the rail under study.
    pub profile: f64,
    /// Along the rail and across it: true where the creepage is held.
    pub held: [bool; 2],
    /// What damages the rail beside wear; `None` if wear is alone.
    pub damage: Option<DamageInTime>,
}

/// The loop in time, at one speed: any number of contacts on all axes.
///
/// * Displacements u = ∫ g(t − τ) (f − f₀) dτ of track and wheels together, f = (Q_x, Q_t, P) at all contacts, from
///   their position under the mean forces.
/// * Normal: δ = δ₀ − u_n + r for a profile of height r along the normal, P = C_H δ^{3/2} or none.
/// * Creep: (ξ, η) = ((ξ₀, η₀) − (du_x/dt, du_t/dt)/V)(1 + κ), κ of the [geometry of the wave](WaveInTime), zero without; forces of a steady law at the P and creepages of the instant, or what a contact
///   that answers [late](LateContact) feels of them along the rail, none without contact; spin as in the mean state.
///
/// On discrete supports g is that of the place of the first wheel at τ, and what the mean forces make of the rail between supports is
/// added. Signs and axes are those of the linear loop. Mean forces follow of themselves where nothing holds a wheel: one that turns
/// freely keeps its mean longitudinal force, and its creepage finds its own.
/// Range of validity: that of the steady law, waves much longer than the patch, unless the contact answers late; the profile is averaged
/// over the patch only by a contact filter; the contact angle stays.
#[derive(Clone)]
pub struct PassageModel {
    /// Track and wheels.
    pub structures: StructuresInTime,
    /// Contacts in the order of the loop, that of the first wheel on the rail under study first.
    pub contacts: Vec<ContactInTime>,
    /// The mean of the profile over the patch that the wheels feel in the place of its height, H = sin(ka)/(ka); none for contacts in a
    /// point.
    pub contact_filter: Option<ContactFilter>,
    /// Speed V \[m/s\].
    pub speed: f64,
}

impl ContactInTime {
    /// A contact of the linear loop in time, with the creep law whose slopes that has.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless load and stiffness are positive.
    pub fn new(contact: &Contact, law: Arc<dyn CreepLaw>) -> Result<Self, Error> {
        let mean = contact.rolling.steady();
        let held = |motion: &Motion<()>| matches!(motion, Motion::Held);
        Ok(Self {
            rail: contact.rail,
            along: contact.along,
            profile: contact.profile,
            held: contact.motion.each_ref().map(held),
            wave: WaveInTime::of(contact),
            ..Self::of_one_wheel(mean, contact.stiffness, law)?
        })
    }

    /// The contact of one wheel about a mean state, with the linearised stiffness k_H \[N/m\] there: its creepage along the rail is that
    /// of the wheel's rotation, and held across it.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn of_one_wheel(mean: MeanRolling, stiffness: f64, law: Arc<dyn CreepLaw>) -> Result<Self, Error> {
        Ok(Self {
            spring: HertzSpring::new(mean.normal_force, stiffness)?,
            law,
            late: None,
            wave: None,
            mean,
            rail: Rail::Right,
            along: 0.0,
            profile: 1.0,
            held: [false, true],
            damage: None,
        })
    }
}

impl PassageModel {
    /// A march from steady rolling on, in steps of the given length \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless step and speed are positive.
    pub fn march(&self, step: f64) -> Result<March<'_>, Error> {
        self.march_before(step, 0.0)
    }

    /// March with the first wheel a distance before one of the supports \[m\], if they are discrete.
    ///
    /// # Errors
    /// Errors of [`march`](Self::march).
    pub fn march_before(&self, step: f64, distance: f64) -> Result<March<'_>, Error> {
        Error::unless_positive("step", step, "m")?;
        Error::unless_positive("speed", self.speed, "m/s")?;
        Ok(March::new(self, step, distance))
    }

    /// What the patch leaves of a wave \[m\]: its contact filter, one without.
    pub fn patch_average(&self, wavelength: f64) -> f64 {
        let filter = self.contact_filter;
        filter.map_or(1.0, |filter| filter.amplitude(TAU / wavelength, 0.0))
    }

    /// Numbers and places \[m\] of the contacts on the rail under study.
    pub(super) fn on_rail_under_study(&self) -> Vec<(usize, f64)> {
        let contacts = self.contacts.iter().enumerate();
        contacts
            .filter(|(_, contact)| contact.rail == self.contacts[0].rail)
            .map(|(index, contact)| (index, contact.along))
            .collect()
    }
}
