//! The contact of a case: its ellipse, and how it creeps.

use riffel_keys::{CaseError, say};
use std::sync::Arc;

use riffel::contact::{
    CreepLaw, CurvatureFilter, HalfSpace, HalfSpaceCurve, HalfSpaceRolling, MeanState, NonSteady, Oscillating,
    OscillatingCreepages, QuasiStatic, QuasiStaticHalfSpace, SpringDashpot, WaveGeometry,
};
use riffel::passage::{LateContact, WaveInTime};
use riffel::{ElasticMaterial, HertzContact, RollingContact};

use crate::file::{ContactDynamics, CreepLawName, HertzTheory, WavePatch};
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::general_keys::{ContactKeys, contact};

/// Elements over a diameter; the half grid has half as many.
const GRIDS: std::ops::RangeInclusive<u64> = 16..=200;

/// The key that gives a mean state.
pub(crate) fn mean_key(mean: MeanState) -> &'static str {
    match mean {
        MeanState::TractiveRatio(_) => "contact.tractive_ratio",
        MeanState::Creepages(_) => "contact.creepage",
    }
}

/// A contact, built.
pub(crate) struct BuiltContact {
    pub(crate) rolling: Arc<dyn RollingContact>,
    /// The creep law; none for the exact theory.
    pub(crate) law: Option<Arc<dyn CreepLaw>>,
}

/// How a contact creeps in time.
pub(crate) struct CreepInTime {
    pub(crate) law: Arc<dyn CreepLaw>,
    /// What it makes of the past.
    pub(crate) late: Option<Arc<LateContact>>,
    /// What a contact that answers late makes of waves, where their geometry has a part.
    pub(crate) wave: Option<WaveInTime>,
}

impl CheckedKeys {
    pub(crate) fn hertz(&self, steel: ElasticMaterial) -> Result<HertzContact, CaseError> {
        self.hertz_of(steel, &contact(&self.file.contact))
    }

    /// The ellipse of a contact; its radius along the rail is the rolling radius by default, its stiffness that of Hertz.
    pub(crate) fn hertz_of(&self, steel: ElasticMaterial, keys: &ContactKeys) -> Result<HertzContact, CaseError> {
        let radius = self.file.wheel.rolling_radius.si();
        let (across, load) = (keys.transverse_radius, keys.normal_load);
        let hertz = match self.hertz_theory() {
            HertzTheory::Paper => HertzContact::new(steel, radius, across, load),
            HertzTheory::Exact => HertzContact::exact(steel, radius, across, load),
        };
        // Both others are positive: what is left is a contact that is no ellipse.
        let mut hertz = self.physics("contact.transverse_radius", hertz)?;
        if let Some(along) = keys.longitudinal_radius {
            let other = hertz.with_longitudinal_radius(along);
            hertz = self.physics("contact.longitudinal_radius", other)?;
        }
        match keys.stiffness {
            Some(stiffness) => self.physics("contact.stiffness", hertz.with_stiffness(stiffness)),
            None => Ok(hertz),
        }
    }

    pub(crate) fn contact(&self, hertz: HertzContact) -> Result<BuiltContact, CaseError> {
        let friction = self.file.contact.friction.si();
        self.contact_of(hertz, friction, self.mean_state()?, OscillatingCreepages::Longitudinal)
    }

    /// `Ok` if the keys of the contact go together.
    pub(crate) fn check_contact(&self) -> Result<(), CaseError> {
        let contact = &self.file.contact;
        if contact.response == ContactDynamics::NonSteady && self.creep_law_name() != CreepLawName::HALF_SPACE {
            return Err(self.text.keys.invalid(
                "contact.creep_law",
                "and `contact.response` exclude each other: a non-steady response is that of the exact \
                 theory",
                say!(choose_contact_creep_law_half_space),
            ));
        }
        if !GRIDS.contains(&contact.grid) || !contact.grid.is_multiple_of(2) {
            return Err(self.out_of_range("contact.grid", contact.grid, "an even number from 16 to 200"));
        }
        // Checked whatever the law is, so that a comparison changes one line.
        self.polach(contact.friction.si()).map(|_| ())
    }

    /// The creep law of the case on a contact; none for the exact theory.
    pub(crate) fn creep_law(&self, hertz: HertzContact, friction: f64) -> Result<Option<Arc<dyn CreepLaw>>, CaseError> {
        let Some(entry) = self.creep_law_name().entry() else {
            return Ok(None);
        };
        let inputs = self.creep_law_inputs(hertz, friction)?;
        let law = entry.build(&inputs);
        if law.is_err() {
            // An ellipse beyond their table has its own key.
            self.kalker(hertz)?;
        }
        self.physics("contact", law).map(Some)
    }

    /// How a contact with that friction creeps about a mean state, for a loop in which these creepages oscillate.
    pub(crate) fn contact_of(
        &self,
        hertz: HertzContact,
        friction: f64,
        mean: MeanState,
        oscillating: OscillatingCreepages,
    ) -> Result<BuiltContact, CaseError> {
        self.check_contact()?;
        let load = hertz.normal_force();
        let law = self.creep_law(hertz, friction)?;
        let rolling = match law.clone() {
            None => {
                let key = || {
                    let contact = &self.file.contact;
                    format!(
                        "{hertz:?} {friction:?} {mean:?} {:?} {:?} {:?} {oscillating:?} {}",
                        self.file.map.wavelength,
                        contact.grid,
                        contact.response,
                        self.feels_waves()
                    )
                };
                let tables = &self.given.tables;
                tables.get(key, || self.half_space(hertz, friction, mean, oscillating))?
            }
            Some(law) => {
                let mut rolling = self.physics(mean_key(mean), QuasiStatic::new(law, load, mean))?;
                if self.feels_waves() {
                    rolling = rolling.on_waves(|curvature| {
                        let law = self.creep_law(self.curved(hertz, curvature)?, friction)?;
                        Ok::<_, CaseError>(law.expect("a formula on any ellipse"))
                    })?;
                }
                self.answering(rolling, hertz)
            }
        };
        Ok(BuiltContact { rolling, law })
    }

    /// A law that answers at once, or late by a spring.
    fn answering(&self, law: impl RollingContact + 'static, hertz: HertzContact) -> Arc<dyn RollingContact> {
        match self.file.contact.response {
            ContactDynamics::SpringDashpot => Arc::new(SpringDashpot::new(law, hertz)),
            _ => Arc::new(law),
        }
    }

    /// Whether the wave's own geometry has a part.
    pub(crate) fn feels_waves(&self) -> bool {
        self.file.contact.wave_geometry == Some(true)
    }

    /// A contact on a wheel of the radius R/(1 + κ).
    fn curved(&self, hertz: HertzContact, curvature: f64) -> Result<HertzContact, CaseError> {
        self.physics("contact.longitudinal_radius", hertz.curved(curvature))
    }

    /// The geometry of waves under a contact; `None` if it has no part.
    pub(crate) fn wave(&self, hertz: HertzContact) -> Result<Option<WaveGeometry>, CaseError> {
        if !self.feels_waves() {
            return Ok(None);
        }
        let filter = self.physics("contact", CurvatureFilter::of(&hertz))?;
        let patch = match self.file.contact.wave_patch {
            _ if self.file.contact.response == ContactDynamics::NonSteady => {
                riffel::contact::WavePatch::Resolved(Arc::new(filter))
            }
            WavePatch::Point => riffel::contact::WavePatch::Point,
            WavePatch::Patch => riffel::contact::WavePatch::Ellipse(Arc::new(filter)),
        };
        let wave = WaveGeometry::new(hertz.longitudinal_radius(), patch);
        let wave = self.physics("contact.longitudinal_radius", wave)?;
        Ok(Some(match self.creep_law_name().name() {
            "full-sliding" => wave.sliding(&hertz),
            _ => wave,
        }))
    }

    /// A contact by the exact theory.
    pub(crate) fn half_space_of(&self, hertz: HertzContact, friction: f64) -> Result<HalfSpace, CaseError> {
        let across = usize::try_from(self.file.contact.grid).unwrap_or(usize::MAX);
        self.physics("contact.grid", HalfSpace::new(hertz, friction, across))
    }

    /// A mean state by the exact theory, with a slope or without.
    pub(crate) fn exact_state(&self, contact: &HalfSpace, mean: MeanState) -> Result<HalfSpaceRolling, CaseError> {
        let state = match mean {
            MeanState::TractiveRatio(ratio) => contact.roll_at_tractive_ratio(ratio),
            MeanState::Creepages(creepages) => contact.roll_with(creepages),
        };
        self.physics(mean_key(mean), state)
    }

    /// The exact theory as a law that is asked at every step in time, and what it makes of the past where it answers late.
    pub(crate) fn exact_in_time(&self, hertz: HertzContact, friction: f64) -> Result<CreepInTime, CaseError> {
        /// Longest wave of a response, in semi-axes, from where on it is that of slow changes.
        const LONGEST: f64 = 100.0;
        /// Shortest, as far as the grid resolves one so short: no wave of a profile that is shorter moves the wheel as a point does.
        const SHORTEST: f64 = 1.0;
        let contact = self.half_space_of(hertz, friction)?;
        let state = self.exact_state(&contact, self.mean_state()?)?;
        let law = self.physics("contact", HalfSpaceCurve::new(&contact, &state))?;
        let (mut late, mut wave) = (None, None);
        if self.file.contact.response == ContactDynamics::NonSteady {
            let a = hertz.semi_axis_longitudinal();
            let shortest = contact.shortest_wavelength().max(SHORTEST * a);
            let range = [shortest, LONGEST * a];
            let table = NonSteady::new(
                &contact,
                &state,
                self.with_waves(OscillatingCreepages::Longitudinal),
                range[0],
                range[1],
                NonSteady::DEFAULT_TOLERANCE,
            );
            let table = self.physics("contact.grid", table)?;
            let filters = LateContact::new(&table, &law, a, range);
            let filters = self.physics("contact.grid", filters)?;
            wave = self.wave(hertz)?.map(|geometry| WaveInTime::late_of(geometry, Arc::new(table), &filters, range));
            late = Some(Arc::new(filters));
        }
        Ok(CreepInTime { law: Arc::new(law), late, wave })
    }

    /// What oscillates, with the waves where their geometry has a part.
    fn with_waves(&self, creepages: OscillatingCreepages) -> Oscillating {
        match self.feels_waves() {
            true => creepages.on_waves(),
            false => creepages.into(),
        }
    }

    fn half_space(
        &self,
        hertz: HertzContact,
        friction: f64,
        mean: MeanState,
        oscillating: OscillatingCreepages,
    ) -> Result<Arc<dyn RollingContact>, CaseError> {
        let contact = self.half_space_of(hertz, friction)?;
        let state = self.exact_state(&contact, mean)?;
        if self.file.contact.response != ContactDynamics::NonSteady {
            let all = self.with_waves(OscillatingCreepages::All);
            let slow = QuasiStaticHalfSpace::new(&contact, &state, all);
            let slow = self.physics("contact", slow)?;
            return Ok(self.answering(slow, hertz));
        }
        let (wavelength, _) = self.window()?;
        let table = NonSteady::new(
            &contact,
            &state,
            self.with_waves(oscillating),
            wavelength.min(),
            wavelength.max(),
            NonSteady::DEFAULT_TOLERANCE,
        );
        Ok(Arc::new(self.physics("map.wavelength.min", table)?))
    }

    /// Tractive ratio or creepage: just one of them.
    pub(crate) fn mean_state(&self) -> Result<MeanState, CaseError> {
        let contact = &self.file.contact;
        match (contact.tractive_ratio, contact.creepage) {
            (Some(_), Some(_)) => Err(self.text.keys.invalid(
                "contact.creepage",
                "and `contact.tractive_ratio` exclude each other",
                say!(give_one_of_the_two),
            )),
            (None, None) => {
                Err(self.text.keys.missing("contact.tractive_ratio", say!(give_contact_tractive_ratio_or_contact)))
            }
            (Some(ratio), None) => Ok(MeanState::TractiveRatio(ratio.si())),
            (None, Some(creepage)) => self.creeping("contact.creepage", creepage).map(MeanState::Creepages),
        }
    }
}
