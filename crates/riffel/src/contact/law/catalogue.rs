//! Every creep law that is a formula of the contact ellipse, by name.

use std::sync::Arc;

use super::{
    Carter2d, Carter3d, CreepEllipse, CreepLaw, FallingFriction, Fastsim, FullSliding, JohnsonVermeulen, Polach,
    ShenHedrickElkins, SlopeReduction, TractionBound,
};
use crate::Error;
use crate::contact::{HertzContact, KalkerCoefficients};

/// A creep law of the [`CATALOGUE`].
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct CreepLawEntry {
    /// Name in case files, documents and tables.
    pub name: &'static str,
    /// Name in figures.
    pub label: &'static str,
    /// What it is, in one sentence.
    pub description: &'static str,
    /// Whether it knows lateral creepage; one that does not ignores it.
    pub lateral: bool,
    /// Whether it knows spin; one that does not ignores it.
    pub spin: bool,
    /// Whether it ends in sliding: the force is μP from some creepage on, in any direction and with spin.
    pub ends_in_sliding: bool,
    build: fn(&CreepLawInputs) -> Result<Arc<dyn CreepLaw>, Error>,
}

/// What the laws of the [`CATALOGUE`] are made of; each takes what it needs.
#[derive(Debug, Clone, Copy)]
pub struct CreepLawInputs {
    /// The contact.
    pub hertz: HertzContact,
    /// Coefficient of friction μ \[-\].
    pub friction: f64,
    /// Friction that falls with slip velocity, for Polach's law.
    pub falling_friction: FallingFriction,
    /// Reduced slopes, for Polach's law.
    pub slope_reduction: SlopeReduction,
    /// Rolling speed V \[m/s\] of the slip velocity, for Polach's law.
    pub speed: f64,
}

impl CreepLawInputs {
    /// The ellipse with Kalker's coefficients, whose table ends.
    fn ellipse(&self) -> Result<CreepEllipse, Error> {
        let poisson_ratio = self.hertz.material().poisson_ratio();
        let kalker = KalkerCoefficients::new(poisson_ratio, self.hertz.axis_ratio())?;
        Ok(CreepEllipse::new(self.hertz, kalker))
    }
}

impl CreepLawEntry {
    /// The law on a contact.
    ///
    /// # Errors
    /// Errors of its constructor.
    pub fn build(&self, inputs: &CreepLawInputs) -> Result<Arc<dyn CreepLaw>, Error> {
        (self.build)(inputs)
    }
}

/// The laws, in the order of figures and tables. A new law is a file beside this one and an entry here.
pub static CATALOGUE: [CreepLawEntry; 7] = [
    CreepLawEntry {
        name: "carter-3d",
        label: "Carter 3D (paper)",
        description: "The paper's, equation (5).",
        lateral: true,
        spin: false,
        ends_in_sliding: true,
        build: |on| Ok(Arc::new(Carter3d::new(on.hertz, on.friction)?)),
    },
    CreepLawEntry {
        name: "carter-2d",
        label: "Carter 2D",
        description: "Carter (1926), a line contact as long and as large as the ellipse.",
        lateral: false,
        spin: false,
        ends_in_sliding: true,
        build: |on| {
            let poisson_ratio = on.hertz.material().poisson_ratio();
            let law = Carter2d::of_ellipse(on.ellipse()?, poisson_ratio, on.friction)?;
            Ok(Arc::new(law))
        },
    },
    CreepLawEntry {
        name: "johnson-vermeulen",
        label: "Johnson–Vermeulen",
        description: "Vermeulen & Johnson (1964), with Kalker's slope.",
        lateral: true,
        spin: false,
        ends_in_sliding: true,
        build: |on| Ok(Arc::new(JohnsonVermeulen::new(on.ellipse()?, on.friction)?)),
    },
    CreepLawEntry {
        name: "shen-hedrick-elkins",
        label: "Shen–Hedrick–Elkins",
        description: "Shen, Hedrick & Elkins (1983).",
        lateral: true,
        spin: true,
        ends_in_sliding: true,
        build: |on| Ok(Arc::new(ShenHedrickElkins::new(on.ellipse()?, on.friction)?)),
    },
    CreepLawEntry {
        name: "polach",
        label: "Polach",
        description: "Polach (2000), with the parameters of `polach`.",
        lateral: true,
        spin: false,
        ends_in_sliding: false,
        build: |on| {
            let (friction, reduction) = (on.falling_friction, on.slope_reduction);
            let law = Polach::new(on.ellipse()?, friction, reduction, on.speed)?;
            Ok(Arc::new(law))
        },
    },
    CreepLawEntry {
        name: "fastsim",
        label: "FASTSIM",
        description: "Kalker's simplified theory (1982).",
        lateral: true,
        spin: true,
        ends_in_sliding: false,
        build: |on| {
            let divisions = Fastsim::DEFAULT_DIVISIONS;
            let law = Fastsim::new(on.ellipse()?, on.friction, TractionBound::Parabolic, divisions)?;
            Ok(Arc::new(law))
        },
    },
    CreepLawEntry {
        name: "full-sliding",
        label: "full sliding",
        description: "Coulomb friction along the slip, beyond full slip.",
        lateral: true,
        spin: false,
        ends_in_sliding: false,
        build: |on| Ok(Arc::new(FullSliding::new(on.friction)?)),
    },
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::{Creepages, MeanState, QuasiStatic, RollingContact};
    use crate::fixtures::steel;

    /// Every entry builds, under a name of its own; far in full slip the force is most of friction times load.
    #[test]
    fn every_law_is_built_by_its_name() {
        let steel = steel();
        let hertz = HertzContact::exact(steel, 0.46, 0.23, 50e3).unwrap();
        let inputs = CreepLawInputs {
            hertz,
            friction: 0.4,
            falling_friction: FallingFriction::constant(0.4),
            slope_reduction: SlopeReduction::NONE,
            speed: 1.0,
        };
        for (index, entry) in CATALOGUE.iter().enumerate() {
            assert!(CATALOGUE[..index].iter().all(|other| other.name != entry.name));
            let law = entry.build(&inputs).unwrap();
            let force = law.forces(50e3, Creepages::longitudinal(0.05)).longitudinal;
            assert!((15e3..=20e3 * (1.0 + 1e-12)).contains(&force), "{}: {force}", entry.name);
            let across = |lateral, spin| {
                let creepages = Creepages { longitudinal: 1e-3, lateral, spin };
                law.forces(50e3, creepages).lateral != 0.0
            };
            let knows = [across(1e-3, 0.0), across(0.0, 0.1)];
            assert_eq!(knows, [entry.lateral, entry.spin], "{}", entry.name);
            let sliding = Creepages { longitudinal: 0.05, lateral: 0.05, spin: 1.0 };
            let about = QuasiStatic::new(law, 50e3, MeanState::Creepages(sliding)).unwrap();
            let ends = entry.ends_in_sliding || entry.name == "full-sliding";
            assert_eq!(about.steady().slides(), ends, "{}", entry.name);
            let nothing =
                CreepLawInputs { friction: -1.0, falling_friction: FallingFriction::constant(-1.0), ..inputs };
            assert!(entry.build(&nothing).is_err(), "{}", entry.name);
        }
    }
}
