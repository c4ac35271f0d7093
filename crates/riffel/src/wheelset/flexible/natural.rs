//! Natural modes of a flexible wheelset.

use std::f64::consts::TAU;

use super::FlexibleWheelset;
use super::beam::BeamSection;
use super::chain::Chain;
use super::mode::Mode;
use super::name::{BendingPlane, DiscMotion, ModeName, RigidMotion};
use super::rod::RodSection;
use super::span::Section;
use crate::Error;

/// A natural mode without loss, of a generalised mass of 1 kg.
#[derive(Debug, Clone, PartialEq)]
pub struct NaturalMode {
    /// Angular frequency ω \[rad/s\].
    pub angular_frequency: f64,
    /// What moves.
    pub name: ModeName,
    shape: Shape,
}

/// Motion of a section of the axle in a mode, mass-normalised.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SectionMotion {
    /// Displacement of its middle along x, y, z \[1/√kg\].
    pub displacement: [f64; 3],
    /// Rotation about x, y, z \[1/(m √kg)\].
    pub rotation: [f64; 3],
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Vertical(Mode<BeamSection, 2>),
    Horizontal(Mode<BeamSection, 2>),
    Torsion(Mode<RodSection, 1>),
    Stretch(Mode<RodSection, 1>),
}

impl NaturalMode {
    /// How often the frequency occurs by this mode: twice for one in both planes.
    pub fn multiplicity(&self) -> usize {
        match self.name {
            ModeName::Bending { plane: BendingPlane::Both, .. } => 2,
            _ => 1,
        }
    }

    /// Motion of the axle at a place y \[m\] from its middle, the ends' beyond them; in the vertical plane for a
    /// mode of both planes. Its sign is any.
    pub fn motion_at(&self, place: f64) -> SectionMotion {
        let (mut displacement, mut rotation) = ([0.0; 3], [0.0; 3]);
        match &self.shape {
            Shape::Vertical(mode) => [displacement[2], rotation[0]] = mode.at(place),
            Shape::Horizontal(mode) => {
                let [forward, slope] = mode.at(place);
                (displacement[0], rotation[2]) = (forward, -slope);
            }
            Shape::Torsion(mode) => [rotation[1]] = mode.at(place),
            Shape::Stretch(mode) => [displacement[1]] = mode.at(place),
        }
        SectionMotion { displacement, rotation }
    }
}

impl SectionMotion {
    /// Displacement along x, y, z of the point a rigid radius R \[m\] below the section: u + θ × (0, 0, R).
    pub fn below(&self, radius: f64) -> [f64; 3] {
        let ([x, y, z], [tilt, spin, _]) = (self.displacement, self.rotation);
        [x + radius * spin, y - radius * tilt, z]
    }
}

/// Modes of a chain up to a frequency.
fn modes_of<S: Section<N> + PartialEq, const N: usize>(chain: &Chain<S, N>, highest: f64) -> Vec<Mode<S, N>> {
    /// Slower motions have no restoring force: a spring of 1 N/m under a wheelset makes 5 mHz.
    const LOWEST: f64 = TAU * 1e-3;
    /// A radian between nodes, for which the sums over a mode are exact to 1e-9.
    const PHASE: f64 = 1.0;
    let chain = chain.refined(highest, PHASE);
    let frequencies = chain.natural_frequencies([LOWEST.min(0.5 * highest), highest]);
    frequencies.into_iter().map(|w| Mode::of(&chain, w)).collect()
}

/// All modes of a wheelset up to a frequency.
pub(super) fn modes(wheelset: &FlexibleWheelset, highest: f64) -> Result<Vec<NaturalMode>, Error> {
    let axle = &wheelset.axle;
    // √(κGA/ρI) = 4√(κG/ρ)/d of a circle.
    let shear_speed = (axle.shear_coefficient * axle.material.shear_modulus() / axle.density).sqrt();
    let thickest = axle.segments.iter().map(|segment| segment.diameter).fold(0.0, f64::max);
    if !(highest > 0.0 && highest < 4.0 * shear_speed / thickest) {
        return Err(Error::OutOfRange {
            quantity: "highest natural frequency",
            value: highest / TAU,
            unit: "Hz",
            rule: "must be above zero and below that of shear across the axle's thickness",
        });
    }

    let motions = &wheelset.motions;
    let planes = match motions.horizontal {
        None => vec![(&motions.vertical, BendingPlane::Both)],
        Some(ref horizontal) => {
            vec![(&motions.vertical, BendingPlane::Vertical), (horizontal, BendingPlane::Horizontal)]
        }
    };
    let mut modes = Vec::new();
    for (chain, plane) in planes {
        let mut orders = [0, 0];
        for mode in modes_of(chain, highest) {
            let symmetric = mode.is_symmetric();
            let name = if mode.share_of_springs() > 0.5 {
                ModeName::RigidBody(match (plane, symmetric) {
                    (BendingPlane::Horizontal, true) => RigidMotion::Longitudinal,
                    (BendingPlane::Horizontal, false) => RigidMotion::Yaw,
                    (_, true) => RigidMotion::Bounce,
                    (_, false) => RigidMotion::Roll,
                })
            } else {
                let order = &mut orders[usize::from(symmetric)];
                *order += 1;
                ModeName::Bending { symmetric, order: *order, plane }
            };
            let angular_frequency = mode.natural;
            let shape = match plane {
                BendingPlane::Horizontal => Shape::Horizontal(mode),
                BendingPlane::Both | BendingPlane::Vertical => Shape::Vertical(mode),
            };
            modes.push(NaturalMode { angular_frequency, name, shape });
        }
    }
    for (index, mode) in modes_of(&motions.torsion, highest).into_iter().enumerate() {
        modes.push(NaturalMode {
            angular_frequency: mode.natural,
            name: ModeName::Torsion { order: index + 1, discs: disc_motion(&mode, wheelset) },
            shape: Shape::Torsion(mode),
        });
    }
    let mut order = 0;
    for mode in modes_of(&motions.stretch, highest) {
        let name = if mode.share_of_springs() > 0.5 {
            ModeName::RigidBody(RigidMotion::Lateral)
        } else {
            order += 1;
            ModeName::Stretch { order }
        };
        modes.push(NaturalMode { angular_frequency: mode.natural, name, shape: Shape::Stretch(mode) });
    }
    modes.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
    Ok(modes)
}

/// How the discs between the wheels move in torsion, where they have more energy than the wheels and the axle each.
fn disc_motion(mode: &Mode<RodSection, 1>, wheelset: &FlexibleWheelset) -> Option<DiscMotion> {
    /// A disc as near as this to a contact is a wheel \[m\]: half the width of a tyre.
    const TYRE: f64 = 0.07;
    let is_wheel = |place: f64| {
        let places = wheelset.contacts.places();
        places.iter().any(|contact| (place - contact).abs() <= TYRE)
    };
    let (mut wheels, mut discs) = (0.0, 0.0);
    let (mut together, mut apart) = (0.0, 0.0);
    for (index, place) in mode.places().enumerate() {
        if is_wheel(place) {
            wheels += mode.mass_of_node(index);
        } else {
            discs += mode.mass_of_node(index);
            let momentum = mode.momentum_of_node(index);
            together += momentum;
            apart += momentum.abs();
        }
    }
    if discs <= wheels || discs <= mode.mass_of_axle() {
        return None;
    }
    Some(if 2.0 * f64::abs(together) > apart { DiscMotion::AgainstWheels } else { DiscMotion::AgainstEachOther })
}
