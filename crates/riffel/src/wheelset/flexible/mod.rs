//! The wheelset as an elastic axle with rigid discs.

mod axle;
mod beam;
mod chain;
mod disc;
mod mode;
mod name;
mod natural;
mod rod;
mod span;

pub use axle::{Axle, Segment};
pub use disc::{CoupledInertia, Disc};
pub use name::{BendingPlane, DiscMotion, ModeName, RigidMotion};
pub use natural::{NaturalMode, SectionMotion};

use beam::BeamSection;
use chain::{Chain, Node};
use riffel_numerics::square::Square;
use rod::RodSection;

use super::free_motion::FreeMotion;
use super::section::{Between, SectionReceptances};
use super::{ContactGeometry, ContactReceptances, RigidBody, Suspension, Wheelset, WheelsetWithHubs};
use crate::{Direction, Error};

/// An elastic axle with rigid discs: wheels, brake discs, gear, axle boxes; free, or on its primary suspension.
///
/// The axle bends in both planes as a Timoshenko beam, twists (2GI, Saint-Venant) and stretches; the four motions do not
/// feel each other in the axle, and meet at the contacts, a rigid radius R below the sections at y = ±s, disc or not:
///
/// ```text
/// H_xx = A + R²Θ     H_yy = S + R²A_θθ     H_zz = A_ww     H_zy = −R A_wθ     H_xy = H_xz = 0
/// ```
///
/// with A the receptances of bending, Θ of torsion and S of stretch between the two sections. E and G take the loss
/// factor, E(1 + iη).
///
/// Method: exact, by the dynamic stiffness of the segments, carried along the axle; to rounding from rigid motion to any
/// frequency. Cost: one microsecond a frequency for all 36 receptances of a uniform axle, three of one of seven segments and
/// five discs; half as much again on a suspension that tells the two planes apart.
///
/// Range of validity: the axle does not rotate (rotation splits its bending modes by ± 5–10 Hz and couples x with y and
/// z); discs are rigid, while the web of a wheel bends from some 300–400 Hz under lateral forces, and from 1–2 kHz
/// under vertical and longitudinal ones.
#[derive(Debug, Clone, PartialEq)]
pub struct FlexibleWheelset {
    axle: Axle,
    discs: Vec<Disc>,
    contacts: ContactGeometry,
    suspension: Option<Suspension>,
    motions: Motions,
}

/// The motions of the axle, each with nodes of its own inertias.
#[derive(Debug, Clone, PartialEq)]
struct Motions {
    /// Nodes over the left and the right contact.
    contacts: [usize; 2],
    vertical: Chain<BeamSection, 2>,
    /// `None` if it is like the vertical plane.
    horizontal: Option<Chain<BeamSection, 2>>,
    torsion: Chain<RodSection, 1>,
    stretch: Chain<RodSection, 1>,
}

impl FlexibleWheelset {
    /// A free wheelset.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for values without a physical meaning, and for a disc or a contact that is not on the axle.
    pub fn new(axle: Axle, discs: Vec<Disc>, contacts: ContactGeometry) -> Result<Self, Error> {
        Self::build(axle, discs, contacts, None)
    }

    /// Wheelset on a primary suspension.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if its springs are not on the axle.
    pub fn with_suspension(self, suspension: Suspension) -> Result<Self, Error> {
        Self::build(self.axle, self.discs, self.contacts, Some(suspension))
    }

    fn build(
        axle: Axle,
        discs: Vec<Disc>,
        contacts: ContactGeometry,
        suspension: Option<Suspension>,
    ) -> Result<Self, Error> {
        let contacts = contacts.checked()?;
        let length = axle.length();
        let on_axle = |quantity: &'static str, spacing: f64| {
            if spacing <= length {
                return Ok(());
            }
            Err(Error::OutOfRange {
                quantity,
                value: spacing,
                unit: "m",
                rule: "must not exceed the length of the axle",
            })
        };
        on_axle("contact spacing", contacts.contact_spacing)?;
        if let Some(suspension) = &suspension {
            on_axle("suspension spacing", 2.0 * suspension.half_spacing())?;
        }
        discs.iter().try_for_each(|disc| disc.check(length))?;
        let motions = Motions::new(&axle, &discs, contacts, suspension.as_ref());
        Ok(Self { axle, discs, contacts, suspension, motions })
    }

    /// The axle.
    pub fn axle(&self) -> &Axle {
        &self.axle
    }

    /// What sits on the axle.
    pub fn discs(&self) -> &[Disc] {
        &self.discs
    }

    /// Where it touches the rails.
    pub fn contacts(&self) -> ContactGeometry {
        self.contacts
    }

    /// Mass and moments of inertia about the middle of the axle, what is coupled through springs included.
    pub fn rigid_body(&self) -> RigidBody {
        let mut body = RigidBody { mass: 0.0, roll_inertia: 0.0, spin_inertia: 0.0 };
        let ends = self.axle.joints();
        for (segment, ends) in self.axle.segments.iter().zip(ends.windows(2)) {
            let per_length = self.axle.density * segment.area();
            let turning = self.axle.density * segment.second_moment();
            body.mass += per_length * segment.length;
            body.roll_inertia += per_length * (ends[1].powi(3) - ends[0].powi(3)) / 3.0 + turning * segment.length;
            body.spin_inertia += 2.0 * turning * segment.length;
        }
        for disc in &self.discs {
            body.mass += disc.mass;
            body.roll_inertia += disc.diametral_inertia + disc.mass * disc.position.powi(2);
            body.spin_inertia += disc.polar_inertia + disc.coupled.map_or(0.0, |coupled| coupled.polar_inertia);
        }
        body
    }

    fn free_motion(&self) -> FreeMotion {
        let ends = self.axle.joints();
        let segments = self
            .axle
            .segments
            .iter()
            .zip(ends.windows(2))
            .map(|(segment, ends)| 0.5 * self.axle.density * segment.area() * (ends[1].powi(2) - ends[0].powi(2)));
        let discs = self.discs.iter().map(|disc| disc.mass * disc.position);
        let first_moment = segments.chain(discs).sum();
        FreeMotion::new(self.rigid_body(), first_moment, self.suspension.as_ref(), self.contacts)
    }

    /// Natural modes without loss and damping up to an angular frequency \[rad/s\], in the order of their frequencies,
    /// each with its name and shape; rigid motions without a restoring force are none.
    ///
    /// None is missed: frequencies are bisected on the number of them below. To a relative 1e-12.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the frequency is positive and below that at which the thickest segment of the axle
    /// shears across its thickness (6 kHz at a diameter of 0.3 m).
    pub fn natural_modes(&self, highest: f64) -> Result<Vec<NaturalMode>, Error> {
        natural::modes(self, highest)
    }
}

impl Motions {
    fn new(axle: &Axle, discs: &[Disc], geometry: ContactGeometry, suspension: Option<&Suspension>) -> Self {
        /// Places closer than this are one \[m\].
        const SAME: f64 = 1e-9;
        let mut places = axle.joints();
        places.extend(discs.iter().map(|disc| disc.position));
        places.extend(geometry.places());
        let springs = suspension.map(|suspension| {
            let half = suspension.half_spacing();
            [-half, half]
        });
        places.extend(springs.into_iter().flatten());
        places.sort_by(f64::total_cmp);
        places.dedup_by(|later, earlier| *later - *earlier < SAME);
        let nearest = |place: f64| {
            let distance = |index: &usize| (places[*index] - place).abs();
            (0..places.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
        };

        let bending = |direction| {
            let mut nodes: Vec<Node<2>> = places.iter().map(|&place| Node::bare(place)).collect();
            for disc in discs {
                let node = &mut nodes[nearest(disc.position)];
                node.inertia[0] += disc.mass;
                node.inertia[1] += disc.diametral_inertia;
            }
            spring(&mut nodes, suspension, direction, &nearest);
            let section = |place| BeamSection::new(axle, axle.segment_at(place));
            Chain::new(nodes, section, axle.loss_factor)
        };
        let vertical = bending(Direction::Vertical);
        let horizontal = bending(Direction::Longitudinal);

        let mut turning: Vec<Node<1>> = places.iter().map(|&place| Node::bare(place)).collect();
        let mut sliding = turning.clone();
        for disc in discs {
            let index = nearest(disc.position);
            turning[index].inertia[0] += disc.polar_inertia;
            turning[index].coupled.extend(disc.coupled);
            sliding[index].inertia[0] += disc.mass;
        }
        spring(&mut sliding, suspension, Direction::Lateral, &nearest);
        let torsion = |place| RodSection::torsion(axle, axle.segment_at(place));
        let stretch = |place| RodSection::stretch(axle, axle.segment_at(place));
        Self {
            contacts: geometry.places().map(nearest),
            horizontal: (horizontal != vertical).then_some(horizontal),
            vertical,
            torsion: Chain::new(turning, torsion, axle.loss_factor),
            stretch: Chain::new(sliding, stretch, axle.loss_factor),
        }
    }
}

/// Puts the springs of the suspension along an axis on the first displacement of their nodes.
fn spring<const N: usize>(
    nodes: &mut [Node<N>],
    suspension: Option<&Suspension>,
    direction: Direction,
    nearest: &impl Fn(f64) -> usize,
) {
    let Some(suspension) = suspension else { return };
    let [stiffness, damping] = suspension.along(direction);
    for side in [-1.0, 1.0] {
        let node = &mut nodes[nearest(side * suspension.half_spacing())];
        node.stiffness[0] += stiffness;
        node.damping[0] += damping;
    }
}

/// One entry of the receptances between two nodes.
fn entry<const N: usize>(between: &[[Square<N>; 2]; 2], row: usize, column: usize) -> Between {
    between.map(|at| at.map(|from| from.0[row][column]))
}

impl Wheelset for FlexibleWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        self.receptances_and_hubs(angular_frequency).0
    }

    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        self.free_motion().at_contacts()
    }
}

impl WheelsetWithHubs for FlexibleWheelset {
    fn hubs(&self, angular_frequency: f64) -> Between {
        let motions = &self.motions;
        let bending = motions.horizontal.as_ref().unwrap_or(&motions.vertical);
        let cuts = bending.cuts(angular_frequency);
        entry(&bending.between(motions.contacts, angular_frequency, &cuts), 0, 0)
    }

    fn receptances_and_hubs(&self, angular_frequency: f64) -> (ContactReceptances, Between) {
        let (motions, w) = (&self.motions, angular_frequency);
        let contacts = motions.contacts;
        // Both planes bend the same spans.
        let cuts = motions.vertical.cuts(w);
        let vertical = motions.vertical.between(contacts, w, &cuts);
        let horizontal = motions.horizontal.as_ref().map(|chain| chain.between(contacts, w, &cuts));
        let of_rod = |chain: &Chain<RodSection, 1>| entry(&chain.between(contacts, w, &chain.cuts(w)), 0, 0);
        let sections = SectionReceptances {
            forward: entry(horizontal.as_ref().unwrap_or(&vertical), 0, 0),
            downward: entry(&vertical, 0, 0),
            downward_by_tilt: entry(&vertical, 0, 1),
            tilt: entry(&vertical, 1, 1),
            twist: of_rod(&motions.torsion),
            sideward: of_rod(&motions.stretch),
        };
        (sections.at_contacts(self.contacts.rolling_radius), sections.forward)
    }

    fn free_hubs(&self) -> [[f64; 2]; 2] {
        self.free_motion().of_hubs()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Complex64;
    use crate::fixtures::steel;

    const INERTIA: f64 = 38.0;

    /// Wheels at the ends of a shaft without mass, which leaves its stiffness GJ/s from either wheel to the middle; and that
    /// stiffness.
    fn torsion(coupled: Option<CoupledInertia>) -> (FlexibleWheelset, f64) {
        let segment = Segment { length: 1.5, diameter: 0.16 };
        let steel = steel();
        let axle = Axle::new(steel, 1e-9, vec![segment]).unwrap();
        let wheel = |position| Disc { position, mass: 330.0, polar_inertia: INERTIA, diametral_inertia: 20.0, coupled };
        let contacts = ContactGeometry { contact_spacing: 1.5, rolling_radius: 0.46 };
        let wheelset = FlexibleWheelset::new(axle, vec![wheel(-0.75), wheel(0.75)], contacts);
        let stiffness = steel.shear_modulus() * 2.0 * segment.second_moment() / 0.75;
        (wheelset.unwrap(), stiffness)
    }

    /// Rotation of the wheels per moment on both of them, alike and opposite.
    fn patterns(wheelset: &FlexibleWheelset, w: f64) -> [Complex64; 2] {
        let motions = &wheelset.motions;
        let between = entry(&motions.torsion.between(motions.contacts, w, &motions.torsion.cuts(w)), 0, 0);
        [1.0, -1.0].map(|sign| between[1][1] + sign * between[1][0])
    }

    /// Alike −1/Iω², whatever the shaft, opposite 1/(GJ/s − Iω²): infinite at √(GJ/sI), a rigid wheel far above. To the
    /// rounding of the difference.
    #[test]
    fn torsion_of_a_shaft_without_mass() {
        let (wheelset, stiffness) = torsion(None);
        let natural = (stiffness / INERTIA).sqrt();
        for factor in [0.1, 0.5, 0.99, 1.01, 2.0, 30.0] {
            let w = factor * natural;
            let [alike, opposite] = patterns(&wheelset, w);
            let free = -1.0 / (INERTIA * w * w);
            assert!((alike / free - 1.0).norm() < 1e-11, "{alike} {free}");
            let expected = (stiffness - INERTIA * w * w).recip();
            assert!((opposite / expected - 1.0).norm() < 1e-11, "{opposite} {expected}");
        }
        let [_, resonant] = patterns(&wheelset, natural);
        assert!(resonant.norm() * stiffness > 1e10, "{resonant}");
    }

    /// The first torsion with an absorber on each wheel (Den Hartog, Mechanical Vibrations, section 3.3): tuned to
    /// 1/(1 + μ) both fixed points stand at √(1 + 2/μ) of the static rotation whatever the damping, and with the
    /// damping ratio √(3μ/8(1 + μ)³) of the wheel's frequency no peak is much above them.
    #[test]
    fn torsion_with_an_absorber() {
        let natural = {
            let (_, stiffness) = torsion(None);
            (stiffness / INERTIA).sqrt()
        };
        for ratio in [0.02, 0.1, 0.3f64] {
            let tuned = natural / (1.0 + ratio);
            let inertia = ratio * INERTIA;
            let best = (0.375 * ratio / (1.0 + ratio).powi(3)).sqrt();
            let expected = (1.0 + 2.0 / ratio).sqrt();
            let amplification = |damping: f64, w: f64| {
                let (wheelset, stiffness) = torsion(Some(CoupledInertia {
                    polar_inertia: inertia,
                    stiffness: inertia * tuned * tuned,
                    damping: damping * 2.0 * inertia * natural,
                }));
                let [_, opposite] = patterns(&wheelset, w);
                stiffness * opposite.norm()
            };
            for sign in [-1.0, 1.0] {
                let fixed = (1.0 + sign * (ratio / (2.0 + ratio)).sqrt()) / (1.0 + ratio);
                let fixed = natural * fixed.sqrt();
                for damping in [0.0, best, 1.0] {
                    let got = amplification(damping, fixed);
                    assert!((got / expected - 1.0).abs() < 1e-9, "{got} {expected}");
                }
            }
            let peak = (0..=4000)
                .map(|step| amplification(best, natural * (0.5 + f64::from(step) / 4000.0)))
                .fold(0.0, f64::max);
            // The mean of the two dampings that make either fixed point a peak: Den Hartog's figure, to half a per cent.
            assert!(peak / expected < 1.005, "{peak} {expected}");
        }
    }

    /// Two absorbers without damping on two wheels add two torsional modes to the first, none of which is missed.
    #[test]
    fn modes_of_absorbers_are_counted() {
        let coupled = CoupledInertia { polar_inertia: 4.0, stiffness: 4.0 * 400f64.powi(2), damping: 10.0 };
        let (wheelset, stiffness) = torsion(Some(coupled));
        let modes = wheelset.natural_modes(1e3).unwrap();
        let modes = modes.iter().filter(|mode| matches!(mode.name, ModeName::Torsion { .. }));
        let got: Vec<f64> = modes.map(|mode| mode.angular_frequency).collect();
        // Alike: I and I_a on the spring between them; opposite: with the shaft, two roots.
        let square = coupled.stiffness * (1.0 / INERTIA + 1.0 / coupled.polar_inertia);
        let sum = (stiffness + coupled.stiffness) / INERTIA + coupled.stiffness / coupled.polar_inertia;
        let product = stiffness * coupled.stiffness / (INERTIA * coupled.polar_inertia);
        let root = (0.25 * sum * sum - product).sqrt();
        let mut expected = [square, 0.5 * sum - root, 0.5 * sum + root].map(f64::sqrt);
        expected.sort_by(f64::total_cmp);
        assert_eq!(got.len(), 3);
        for (got, expected) in got.iter().zip(expected) {
            assert!((got / expected - 1.0).abs() < 1e-10, "{got} {expected}");
        }
    }
}
