//! Rolling contact that answers late: the exact response, from a table over wavelength.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::half_space::{FoundResponses, REMEDY, ResponseSweep};
use super::{
    ContactDerivative, ContactResponse, GridError, HalfSpace, HalfSpaceRolling, MeanRolling, Oscillating,
    OscillatingCreepages, RollingContact,
};
use crate::Error;

/// Most intervals between the nodes of an octave.
const MOST_INTERVALS: usize = 64;

/// The response of a [`HalfSpace`] about one mean state, for a loop: to load, longitudinal creepage, and the other
/// creepages and the curvature of a wave as far as they are asked for.
///
/// Method: four complex derivatives of each input in octaves of wavelength that begin at the shortest one that the grid of the
/// contact resolves. In each octave a polynomial in the logarithm of the wavelength through Chebyshev's points, the ends
/// included; the intervals between them are halved until the last polynomial misses the new points by less than the
/// tolerance, relative to the force and to the energy of each input. An octave does not depend on the wavelengths that
/// are asked for, so that a point and a map of any window agree bit for bit. The error of the grid is the larger one
/// of the two nearest points. Returns NaN outside its octaves. Each octave is a sweep of its own,
/// about its two ends. Cost: some 0.1 s an octave and input, a microsecond to ask.
pub struct NonSteady {
    steady: MeanRolling,
    oscillating: Oscillating,
    /// Shortest wavelength that the grid resolves \[m\].
    resolved: f64,
    /// Number of the first octave from there.
    first: f64,
    octaves: Vec<Octave>,
}

/// Responses at Chebyshev's points, from the longest wavelength to the shortest.
struct Octave(Vec<Node>);

#[derive(Clone, Copy)]
struct Node {
    values: [Complex64; DERIVATIVES],
    errors: [GridError; INPUTS],
}

const INPUTS: usize = 5;
/// Of one input: force along and across the rail, energy at the wheel and at the rail.
const OUTPUTS: usize = 4;
const DERIVATIVES: usize = INPUTS * OUTPUTS;

impl Node {
    fn new(response: ContactResponse) -> Self {
        let mut node =
            Self { values: [Complex64::ZERO; DERIVATIVES], errors: [GridError { force: 0.0, energy: 0.0 }; INPUTS] };
        let inputs = [
            Some(response.by_load),
            Some(response.by_longitudinal),
            response.by_lateral,
            response.by_spin,
            response.by_curvature,
        ];
        let places = node.values.chunks_exact_mut(OUTPUTS).zip(&mut node.errors);
        for ((values, error), by) in places.zip(inputs) {
            let Some(by) = by else { continue };
            values.copy_from_slice(&[by.force[0], by.force[1], by.energy, by.at_rail(0.0)]);
            *error = by.error.unwrap_or(*error);
        }
        node
    }

    /// Largest error of other values, relative to the force and the energy of each input; energy that vanishes by
    /// symmetry counts by the force and the mean creepage, and a force that vanishes in full sliding by a tenth of the energy over
    /// that creepage: the iteration leaves a tenth of the tolerance.
    fn missed_by(&self, values: &[Complex64; DERIVATIVES], creepage: f64) -> f64 {
        let inputs = self.values.chunks_exact(OUTPUTS).zip(&self.errors);
        let inputs = inputs.zip(values.chunks_exact(OUTPUTS));
        let misses = inputs.flat_map(|((exact, error), got)| {
            let force = exact[0].norm().hypot(exact[1].norm());
            let energy = exact[2].norm().max(exact[3].norm());
            let force = match creepage > 0.0 {
                true => force.max(0.1 * energy / creepage),
                false => force,
            };
            let energy = energy.max(creepage * force).max(error.energy);
            let sizes = [force, force, energy, energy];
            let missed =
                move |output: usize| (got[output] - exact[output]).norm() / sizes[output].max(f64::MIN_POSITIVE);
            (0..OUTPUTS).map(missed)
        });
        misses.fold(0.0, f64::max)
    }
}

/// The response at an end of an octave, and what that found.
type End = (Node, FoundResponses);

impl NonSteady {
    /// The tolerance of cases: a hundredth of the error of the half-space itself.
    pub const DEFAULT_TOLERANCE: f64 = 1e-4;

    /// The response of the contact about a state to the load and what else oscillates, for wavelengths from `shortest` to
    /// `longest` \[m\], each derivative to a relative `tolerance` \[-\]; below 1e-4 what the iteration of the response leaves, 1e-5, stands in the way.
    ///
    /// # Errors
    /// Errors of [`HalfSpace::response`]; [`Error::NotConverged`] if 64 intervals of the longest octave do not do. Where those of
    /// a shorter one do not, the table begins above it, [`known_from`](RollingContact::known_from).
    pub fn new(
        contact: &HalfSpace,
        state: &HalfSpaceRolling,
        oscillating: impl Into<Oscillating>,
        shortest: f64,
        longest: f64,
        tolerance: f64,
    ) -> Result<Self, Error> {
        contact.check_wavelength(shortest)?;
        let oscillating = oscillating.into();
        let steady = contact.steady(state);
        let resolved = contact.shortest_wavelength();
        let below = (shortest / resolved).log2().floor();
        let above = (longest / resolved).log2().ceil().max(below + 1.0);
        let wavelength = |place: f64| resolved * place.exp2();
        let creepage = steady.creepages.magnitude();
        let mut sweep = contact.sweep(state, oscillating);
        // The ends of the octaves from nothing, so that neither depends on the other octaves.
        let end = |sweep: &mut ResponseSweep<'_>, place: f64| -> Result<End, Error> {
            sweep.begin_with(&[]);
            Ok((Node::new(sweep.at(wavelength(place))?), sweep.found()))
        };
        let mut last = end(&mut sweep, above)?;
        let (mut first, mut octaves) = (above, Vec::new());
        while first > below {
            let begin = first - 1.0;
            let octave = end(&mut sweep, begin).and_then(|end| {
                sweep.begin_with(&[&end.1, &last.1]);
                let node = |t: f64| {
                    let response = sweep.at(wavelength(begin + 0.5 * (1.0 + t)));
                    response.map(Node::new)
                };
                Ok((Octave::new([last.0, end.0], node, creepage, tolerance)?, end))
            });
            match octave {
                Ok((octave, end)) => {
                    octaves.push(octave);
                    (first, last) = (begin, end);
                }
                // What is longer holds.
                Err(Error::NotConverged { .. }) if !octaves.is_empty() => break,
                Err(error) => return Err(error),
            }
        }
        octaves.reverse();
        Ok(Self { steady, oscillating, resolved, first, octaves })
    }
}

/// Chebyshev's point of an index, from 1 to −1.
fn place(index: usize, intervals: usize) -> f64 {
    (PI * index as f64 / intervals as f64).cos()
}

impl Octave {
    /// The octave of a function of t from −1, its shortest wavelength, to 1, its longest, both of which are known.
    fn new(
        [longest, shortest]: [Node; 2],
        mut node: impl FnMut(f64) -> Result<Node, Error>,
        creepage: f64,
        tolerance: f64,
    ) -> Result<Self, Error> {
        let mut intervals = 2;
        let mut octave = Self(vec![longest, node(0.0)?, shortest]);
        loop {
            let between = (0..intervals).map(|index| node(place(2 * index + 1, 2 * intervals)));
            let between: Vec<Node> = between.collect::<Result<_, _>>()?;
            let misses = between.iter().enumerate().map(|(index, exact)| {
                let got = octave.at(place(2 * index + 1, 2 * intervals));
                exact.missed_by(&got.values, creepage)
            });
            let worst = misses.fold(0.0, f64::max);
            let mut finer = Vec::with_capacity(2 * intervals + 1);
            for (known, new) in octave.0.iter().zip(&between) {
                finer.extend([*known, *new]);
            }
            finer.extend(octave.0.last());
            (octave, intervals) = (Self(finer), 2 * intervals);
            if worst <= tolerance {
                return Ok(octave);
            }
            if intervals >= MOST_INTERVALS {
                return Err(Error::NotConverged {
                    problem: "table of the contact's response",
                    residual: worst,
                    tolerance,
                    remedy: REMEDY,
                });
            }
        }
    }

    /// The polynomial at t ∈ \[−1, 1\], by the barycentric formula (Berrut & Trefethen 2004, equations 4.2 and 5.4), and
    /// the larger errors of the points on both sides.
    fn at(&self, t: f64) -> Node {
        let intervals = self.0.len() - 1;
        let (mut above, mut below) = ([Complex64::ZERO; DERIVATIVES], 0.0);
        let mut after = 1;
        for (index, node) in self.0.iter().enumerate() {
            let distance = t - place(index, intervals);
            if distance == 0.0 {
                return *node;
            }
            if distance < 0.0 {
                after = index + 1;
            }
            let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
            let share = if index == 0 || index == intervals { 0.5 } else { 1.0 };
            let weight = sign * share / distance;
            below += weight;
            for (above, value) in above.iter_mut().zip(&node.values) {
                *above += weight * value;
            }
        }
        let (before, after) = (self.0[after - 1].errors, self.0[after.min(intervals)].errors);
        Node {
            values: above.map(|above| above / below),
            errors: std::array::from_fn(|input| GridError {
                force: before[input].force.max(after[input].force),
                energy: before[input].energy.max(after[input].energy),
            }),
        }
    }
}

impl RollingContact for NonSteady {
    fn steady(&self) -> MeanRolling {
        self.steady
    }

    fn known_from(&self) -> f64 {
        self.resolved * self.first.exp2()
    }

    fn response(&self, wavelength: f64) -> ContactResponse {
        /// A wavelength at the end may come back a rounding outside.
        const ROUNDING: f64 = 1e-9;
        const OUTSIDE: Node = Node {
            values: [Complex64::new(f64::NAN, f64::NAN); DERIVATIVES],
            errors: [GridError { force: f64::NAN, energy: f64::NAN }; INPUTS],
        };
        // Counted from the same wavelength by every table: equal roundings.
        let place = (wavelength / self.resolved).log2();
        let (first, end) = (self.first, self.first + self.octaves.len() as f64);
        let node = if (first - ROUNDING..=end + ROUNDING).contains(&place) {
            let octave = place.floor().clamp(first, end - 1.0);
            let t = 2.0 * (place - octave) - 1.0;
            self.octaves[(octave - first) as usize].at(t.clamp(-1.0, 1.0))
        } else {
            OUTSIDE
        };
        let derivative = |input: usize| {
            let outputs = &node.values[input * OUTPUTS..(input + 1) * OUTPUTS];
            ContactDerivative {
                force: [outputs[0], outputs[1]],
                energy: outputs[2],
                energy_at_rail: Some(outputs[3]),
                error: Some(node.errors[input]),
            }
        };
        let Oscillating { creepages, profile } = self.oscillating;
        ContactResponse {
            by_load: derivative(0),
            by_longitudinal: derivative(1),
            by_lateral: (creepages != OscillatingCreepages::Longitudinal).then(|| derivative(2)),
            by_spin: (creepages == OscillatingCreepages::All).then(|| derivative(3)),
            by_curvature: profile.then(|| derivative(4)),
        }
    }
}
