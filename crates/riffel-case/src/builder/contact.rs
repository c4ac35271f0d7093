//! The contact of a case: its ellipse, and how it creeps.

use std::sync::Arc;

use riffel::{
    Carter2d, Carter3d, CreepEllipse, CreepLaw, ElasticMaterial, FallingFriction, Fastsim,
    HalfSpace, HalfSpaceRolling, HertzContact, JohnsonVermeulen, KalkerCoefficients, NonSteady,
    Polach, QuasiStatic, RollingContact, ShenHedrickElkins, SlopeReduction, SlowHalfSpace,
    SpringDashpot, TractionBound,
};

use super::Builder;
use crate::CaseError;
use crate::file::{ContactDynamics, CreepLawName, HertzTheory};

/// The mean state, as the case gives it.
#[derive(Clone, Copy)]
enum MeanState {
    TractiveRatio(f64),
    Creepage(f64),
}

impl MeanState {
    fn key(self) -> &'static str {
        match self {
            Self::TractiveRatio(_) => "contact.tractive_ratio",
            Self::Creepage(_) => "contact.creepage",
        }
    }
}

/// A contact, built.
pub(super) struct BuiltContact {
    pub(super) rolling: Arc<dyn RollingContact>,
    /// The paper's law, where it is the one of the case.
    pub(super) carter: Option<Carter3d>,
}

impl Builder {
    /// The creep law: as written, or the exact one with a non-steady response, or the paper's.
    pub(crate) fn creep_law_name(&self) -> CreepLawName {
        let contact = &self.file.contact;
        contact.creep_law.unwrap_or(match contact.response {
            ContactDynamics::NonSteady => CreepLawName::HalfSpace,
            _ => CreepLawName::Carter3d,
        })
    }

    pub(super) fn hertz(&self, steel: ElasticMaterial) -> Result<HertzContact, CaseError> {
        let contact = &self.file.contact;
        let radius = self.positive("wheel.rolling_radius", self.file.wheel.rolling_radius)?;
        let across = self.positive("contact.transverse_radius", contact.transverse_radius)?;
        let load = self.positive("contact.normal_load", contact.normal_load)?;
        let theory = contact.hertz.unwrap_or(match self.creep_law_name() {
            CreepLawName::Carter3d => HertzTheory::Paper,
            _ => HertzTheory::Exact,
        });
        let hertz = match theory {
            HertzTheory::Paper => HertzContact::new(steel, radius, across, load),
            HertzTheory::Exact => HertzContact::exact(steel, radius, across, load),
        };
        self.physics("contact", hertz)
    }

    pub(super) fn contact(&self, hertz: HertzContact) -> Result<BuiltContact, CaseError> {
        let friction = self.positive("contact.friction", self.file.contact.friction)?;
        let mean = self.mean_state()?;
        let name = self.creep_law_name();
        if self.file.contact.response == ContactDynamics::NonSteady
            && name != CreepLawName::HalfSpace
        {
            return Err(self.source.invalid(
                "contact.creep_law",
                "and `contact.response` exclude each other: a non-steady response is that of the exact \
                 theory",
                "choose contact.creep_law = \"half-space\", or leave it out",
            ));
        }
        if name == CreepLawName::Carter3d {
            let law = match mean {
                MeanState::TractiveRatio(ratio) => {
                    Carter3d::from_tractive_ratio(hertz, friction, ratio)
                }
                MeanState::Creepage(creepage) => Carter3d::from_creepage(hertz, friction, creepage),
            };
            let law = self.physics(mean.key(), law)?;
            return Ok(BuiltContact {
                rolling: self.answering(law, hertz),
                carter: Some(law),
            });
        }
        let rolling = if name == CreepLawName::HalfSpace {
            self.half_space(hertz, friction, mean)?
        } else {
            let law = self.simple_law(name, hertz, friction)?;
            let load = hertz.normal_force();
            let law = match mean {
                MeanState::TractiveRatio(ratio) => {
                    QuasiStatic::from_tractive_ratio(law, load, ratio)
                }
                MeanState::Creepage(creepage) => QuasiStatic::from_creepage(law, load, creepage),
            };
            self.answering(self.physics(mean.key(), law)?, hertz)
        };
        Ok(BuiltContact {
            rolling,
            carter: None,
        })
    }

    /// A law that answers at once, or late by a spring.
    fn answering(
        &self,
        law: impl RollingContact + 'static,
        hertz: HertzContact,
    ) -> Arc<dyn RollingContact> {
        match self.file.contact.response {
            ContactDynamics::SpringDashpot => Arc::new(SpringDashpot::new(law, hertz)),
            _ => Arc::new(law),
        }
    }

    fn simple_law(
        &self,
        name: CreepLawName,
        hertz: HertzContact,
        friction: f64,
    ) -> Result<Arc<dyn CreepLaw>, CaseError> {
        let material = hertz.material();
        let kalker = KalkerCoefficients::new(material.poisson_ratio(), hertz.axis_ratio());
        let kalker = self.physics("contact", kalker)?;
        let ellipse = CreepEllipse::new(hertz, kalker);
        fn shared<L: CreepLaw + 'static>(law: L) -> Arc<dyn CreepLaw> {
            Arc::new(law)
        }
        let law = match name {
            CreepLawName::Carter2d => {
                Carter2d::of_ellipse(ellipse, material.poisson_ratio(), friction).map(shared)
            }
            CreepLawName::ShenHedrickElkins => {
                ShenHedrickElkins::new(ellipse, friction).map(shared)
            }
            CreepLawName::Polach => {
                // Dry and constant: with k_A = k_S = 1 the law does not depend on the speed.
                let full = SlopeReduction {
                    adhesion: 1.0,
                    slip: 1.0,
                };
                Polach::new(ellipse, FallingFriction::constant(friction), full, 1.0).map(shared)
            }
            CreepLawName::Fastsim => {
                let divisions = Fastsim::DEFAULT_DIVISIONS;
                Fastsim::new(ellipse, friction, TractionBound::Parabolic, divisions).map(shared)
            }
            CreepLawName::JohnsonVermeulen | CreepLawName::Carter3d | CreepLawName::HalfSpace => {
                JohnsonVermeulen::new(ellipse, friction).map(shared)
            }
        };
        self.physics("contact.creep_law", law)
    }

    fn half_space(
        &self,
        hertz: HertzContact,
        friction: f64,
        mean: MeanState,
    ) -> Result<Arc<dyn RollingContact>, CaseError> {
        let grid = self.file.contact.grid;
        let across = usize::try_from(grid).unwrap_or(usize::MAX);
        let contact = self.physics("contact.grid", HalfSpace::new(hertz, friction, across))?;
        let state: HalfSpaceRolling = match mean {
            MeanState::TractiveRatio(ratio) => {
                self.physics(mean.key(), contact.roll_at_tractive_ratio(ratio))?
            }
            MeanState::Creepage(creepage) => {
                let state = self.physics(mean.key(), contact.roll(creepage))?;
                let ratio = contact.steady(&state).tractive_ratio();
                if ratio > HalfSpace::LARGEST_TRACTIVE_RATIO {
                    return Err(self.out_of_range(
                        mean.key(),
                        creepage,
                        "so small that a region of stick is left: this one is full slip",
                    ));
                }
                state
            }
        };
        if self.file.contact.response != ContactDynamics::NonSteady {
            let slow = self.physics("contact", SlowHalfSpace::new(&contact, &state))?;
            return Ok(self.answering(slow, hertz));
        }
        let (wavelength, _) = self.window()?;
        let table = NonSteady::new(&contact, &state, wavelength.min(), wavelength.max());
        Ok(Arc::new(self.physics("map.wavelength.min", table)?))
    }

    /// Tractive ratio or creepage: just one of them.
    fn mean_state(&self) -> Result<MeanState, CaseError> {
        let contact = &self.file.contact;
        match (contact.tractive_ratio, contact.creepage) {
            (Some(_), Some(_)) => Err(self.source.invalid(
                "contact.creepage",
                "and `contact.tractive_ratio` exclude each other",
                "give one of the two",
            )),
            (None, None) => Err(self.source.missing(
                "contact.tractive_ratio",
                "give contact.tractive_ratio or contact.creepage",
            )),
            (Some(ratio), None) => {
                let ratio = ratio.si();
                if !(ratio > 0.0 && ratio < 1.0) {
                    return Err(self.out_of_range(
                        "contact.tractive_ratio",
                        ratio,
                        "between 0 and 1, both excluded",
                    ));
                }
                Ok(MeanState::TractiveRatio(ratio))
            }
            (None, Some(creepage)) => Ok(MeanState::Creepage(
                self.positive("contact.creepage", creepage)?,
            )),
        }
    }
}
