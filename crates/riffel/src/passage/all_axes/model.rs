//! Track, wheels and contacts of a march on all axes.

use std::f64::consts::PI;
use std::sync::Arc;

use super::{GeneralMarch, StructuresInTime};
use crate::contact::{ContactFilter, CreepLaw, MeanRolling};
use crate::feedback::Contact;
use crate::passage::along_profile::{last_remembered, pass};
use crate::passage::over_supports::ONSET_BAYS;
use crate::passage::{HertzSpring, Passage};
use crate::roughness::Profile;
use crate::wheelset::Motion;
use crate::{Error, Rail};

/// A contact of a wheel with a rail in time.
#[derive(Clone)]
pub struct ContactInTime {
    /// The spring along its normal.
    pub spring: HertzSpring,
    /// The creep law.
    pub law: Arc<dyn CreepLaw>,
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
}

/// The loop of [`GeneralLoop`](crate::feedback::GeneralLoop) in time, at one speed.
///
/// * Displacements u = ∫ g(t − τ) (f − f₀) dτ of track and wheels together, f = (Q_x, Q_t, P) at all contacts, from
///   their position under the mean forces.
/// * Normal: δ = δ₀ − u_n + r for a profile of height r along the normal, P = C_H δ^{3/2} or none.
/// * Creep: (ξ, η) = (ξ₀, η₀) − (du_x/dt, du_t/dt)/V; forces of a steady law at the P and creepages of the instant; spin as in the mean
///   state.
///
/// On discrete supports g is that of the place of the first wheel at τ, and what the mean forces make of the rail between supports is
/// added. Signs and axes are those of the linear loop. Mean forces follow of themselves where nothing holds a wheel: one that turns
/// freely keeps its mean longitudinal force, and its creepage finds its own.
/// Range of validity: that of the steady law, waves much longer than the patch; the contact angle stays.
#[derive(Clone)]
pub struct GeneralPassage {
    /// Track and wheels.
    pub structures: StructuresInTime,
    /// Contacts in the order of the loop, that of the first wheel on the rail under study first.
    pub contacts: Vec<ContactInTime>,
    /// The mean of the profile over the patch that the wheels feel in the place of its height; none for contacts in a point.
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
        Ok(Self {
            spring: HertzSpring::new(mean.normal_force, contact.stiffness)?,
            law,
            mean,
            rail: contact.rail,
            along: contact.along,
            profile: contact.profile,
            held: contact
                .motion
                .each_ref()
                .map(|motion| matches!(motion, Motion::Held)),
        })
    }
}

impl GeneralPassage {
    /// A march from steady rolling on, in steps of the given length \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless step and speed are positive.
    pub fn march(&self, step: f64) -> Result<GeneralMarch<'_>, Error> {
        self.march_before(step, 0.0)
    }

    /// The same march, the first wheel a distance before one of the supports \[m\], where they are discrete.
    ///
    /// # Errors
    /// Those of [`march`](Self::march).
    pub fn march_before(&self, step: f64, distance: f64) -> Result<GeneralMarch<'_>, Error> {
        Error::unless_positive("step", step, "m")?;
        Error::unless_positive("speed", self.speed, "m/s")?;
        Ok(GeneralMarch::new(self, step, distance))
    }

    /// Distance \[m\] after which a bump of the rail of a millisecond is forgotten by the normal forces of all contacts, to
    /// 10⁻³ of their largest change, and the length of the train twice. The slow motion on primary suspensions is below. On
    /// discrete supports the change is that of the forces which passing them makes, and the distance over which their sag sets in is
    /// added.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where two seconds of rolling do not suffice, as where the loop is unstable.
    pub fn memory(&self) -> Result<f64, Error> {
        /// \[s\]
        const STEP: f64 = 2e-5;
        const PATIENCE: f64 = 2.0;
        const BUMP: f64 = 1e-3;
        const FORGOTTEN: f64 = 1e-3;
        /// Small beside any approach \[m\].
        const HEIGHT: f64 = 1e-8;
        let mut march = self.march(STEP * self.speed)?;
        let spacing = self.structures.support_spacing();
        let mut smooth = spacing.map(|_| march.clone());
        let steps = (PATIENCE / STEP) as usize;
        let bump = (BUMP / STEP) as usize;
        let mut heights = vec![0.0; self.contacts.len()];
        let even = vec![0.0; self.contacts.len()];
        let at_rest = self.contacts.iter();
        let mut without: Vec<f64> = at_rest
            .map(|contact| contact.spring.normal_force())
            .collect();
        let changes = (1..=steps).map(|step| {
            let angle = PI * (step as f64 / bump as f64).min(1.0);
            heights.fill(HEIGHT * angle.sin().powi(2));
            if let Some(smooth) = &mut smooth {
                for (without, now) in without.iter_mut().zip(smooth.advance(&even)) {
                    *without = now.normal_force;
                }
            }
            let now = march.advance(&heights).iter().zip(&without);
            now.map(|(now, without)| (now.normal_force - without).abs())
                .fold(0.0, f64::max)
        });
        let changes: Vec<f64> = changes.collect();
        let last = last_remembered(
            &changes,
            FORGOTTEN,
            "motion of the wheels after a bump of the rail, two seconds later,",
            "give rail, wheelset and suspension more loss: what is nearly free of loss may swing up in time",
        )?;
        let behind = self.contacts.iter().map(|contact| -contact.along);
        let train = behind.fold(0.0, f64::max);
        let onset = spacing.map_or(0.0, |spacing| ONSET_BAYS * spacing);
        Ok(onset + 2.0 * train + (last + 2) as f64 * STEP * self.speed)
    }

    /// All wheels along a profile, as [`PassageModel::pass`](crate::passage::PassageModel::pass) takes one: the first stands at
    /// the heights, the others behind it. Contacts on the opposite rail follow what their rail has of the same profile.
    ///
    /// # Errors
    /// [`Error::ProfileTooShort`] for a profile shorter than the memory, and those of memory and march.
    pub fn pass(&self, profile: &Profile, largest_step: f64) -> Result<Passage, Error> {
        let start = |step, before| self.march_before(step, before);
        pass(
            profile,
            largest_step,
            self.memory()?,
            self.contact_filter,
            start,
        )
    }
}
