//! The contact of a case by all theories.

use std::io::{self, Write};

use riffel::{Carter3d, ContactElement, HalfSpace, HalfSpaceRolling, HertzContact};
use riffel_case::{Case, CreepLaws};

use super::refused;
use crate::error::CliError;

/// The contact of the case by all theories, and its mean state by the exact one.
pub(super) struct Patch {
    pub(super) hertz: HertzContact,
    pub(super) friction: f64,
    pub(super) carter: Carter3d,
    pub(super) laws: CreepLaws,
    pub(super) half_space: HalfSpace,
    pub(super) state: HalfSpaceRolling,
}

impl Patch {
    pub(super) fn new(case: &Case) -> miette::Result<Self> {
        let (hertz, friction) = (case.hertz, case.steady.friction);
        let ratio = case.steady.tractive_ratio();
        if ratio > HalfSpace::LARGEST_TRACTIVE_RATIO {
            Err(CliError::Argument {
                argument: "the tractive ratio of the case",
                value: format!("{ratio:.4}"),
                rule: format!(
                    "at most {} for a frequency response: nearer to full slip the creep curve has no \
                     slope",
                    HalfSpace::LARGEST_TRACTIVE_RATIO
                ),
            })?;
        }
        let carter = Carter3d::from_tractive_ratio(hertz, friction, ratio)
            .map_err(refused("the mean state of the case"))?;
        let laws = case.creep_laws()?;
        let across = usize::try_from(case.file.contact.grid).unwrap_or(usize::MAX);
        let half_space =
            HalfSpace::new(hertz, friction, across).map_err(refused("contact.grid"))?;
        let state = half_space
            .roll_at_tractive_ratio(ratio)
            .map_err(refused("the mean state of the case"))?;
        Ok(Self {
            hertz,
            friction,
            carter,
            laws,
            half_space,
            state,
        })
    }

    /// The larger of the creepages at which Johnson & Vermeulen and the paper see full slip.
    pub(super) fn full_slip_creepage(&self) -> f64 {
        let law = &self.laws.johnson_vermeulen;
        let by_ellipse = law.limit(self.hertz.normal_force()).creepage();
        by_ellipse.max(self.carter.saturation_creepage())
    }

    pub(super) fn tractive_ratio(&self, force: f64) -> f64 {
        force / (self.friction * self.hertz.normal_force())
    }

    pub(super) fn elements(&self) -> impl Iterator<Item = ContactElement> + '_ {
        self.half_space.elements(&self.state)
    }

    pub(super) fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "x_m",
            "y_m",
            "traction_longitudinal_pa",
            "traction_lateral_pa",
            "bound_pa",
            "slips",
        ])?;
        for element in self.elements() {
            writer.serialize((
                element.centre,
                element.traction,
                element.bound,
                element.slips,
            ))?;
        }
        writer.flush()
    }
}
