//! Rolling contact that answers late: the exact response, from a table over wavelength.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::half_space::REMEDY;
use super::{
    ContactDerivative, ContactResponse, HalfSpace, HalfSpaceRolling, MeanRolling, RollingContact,
};
use crate::Error;

/// Fewest and most intervals between the nodes of an octave.
const FEWEST_INTERVALS: usize = 2;
const MOST_INTERVALS: usize = 64;

/// The response of a [`HalfSpace`] about one mean state, for a loop.
///
/// Method: six complex derivatives in octaves of wavelength that begin at the shortest one that the grid of the contact
/// resolves. In each octave a polynomial in the logarithm of the wavelength through Chebyshev's points, the ends
/// included; the intervals between them are halved until the last polynomial misses the new points by less than the
/// tolerance, relative to their values. An octave does not depend on the wavelengths that are asked for, so that a point and a map of any
/// window agree bit for bit. Returns NaN outside its octaves. Cost: some 0.1 s an octave, a microsecond to ask.
pub struct NonSteady {
    steady: MeanRolling,
    /// Shortest wavelength that the grid resolves \[m\].
    resolved: f64,
    /// Number of the first octave from there.
    first: f64,
    octaves: Vec<Octave>,
}

/// Derivatives at Chebyshev's points, from the longest wavelength to the shortest.
struct Octave(Vec<[Complex64; DERIVATIVES]>);

const DERIVATIVES: usize = 6;

/// The derivatives by load and by longitudinal creepage, each of the force along the rail and of the energy at both
/// places. The force across it vanishes: the contact rolls straight on, and is symmetric.
fn listed(response: ContactResponse) -> [Complex64; DERIVATIVES] {
    let (load, creepage) = (response.by_load, response.by_longitudinal);
    [
        load.force[0],
        creepage.force[0],
        load.energy,
        creepage.energy,
        load.at_rail(0.0),
        creepage.at_rail(0.0),
    ]
}

impl NonSteady {
    /// The tolerance of cases: a hundredth of the error of the half-space itself.
    pub const DEFAULT_TOLERANCE: f64 = 1e-4;

    /// The response of the contact about a state, for wavelengths from `shortest` to `longest` \[m\], each derivative
    /// to a relative `tolerance` \[-\]; below 1e-4 what the iteration of the response leaves, 1e-5, stands in the way.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] with lateral creepage, of which there is no table; those of [`HalfSpace::response`];
    /// [`Error::NotConverged`] if 64 intervals of an octave do not do.
    pub fn new(
        contact: &HalfSpace,
        state: &HalfSpaceRolling,
        shortest: f64,
        longest: f64,
        tolerance: f64,
    ) -> Result<Self, Error> {
        let lateral = contact.steady(state).creepages.lateral;
        if lateral != 0.0 {
            return Err(Error::OutOfRange {
                quantity: "lateral creepage",
                value: lateral,
                unit: "",
                rule: "must be zero: the table is that of longitudinal rolling",
            });
        }
        contact.check_wavelength(shortest)?;
        let resolved = contact.shortest_wavelength();
        let below = (shortest / resolved).log2().floor();
        let above = (longest / resolved).log2().ceil().max(below + 1.0);
        let mut octaves = Vec::new();
        for octave in below as i32..above as i32 {
            let value = |t: f64| {
                let wavelength = resolved * (f64::from(octave) + 0.5 * (1.0 + t)).exp2();
                contact.response(state, wavelength).map(listed)
            };
            octaves.push(Octave::new(value, tolerance)?);
        }
        Ok(Self {
            steady: contact.steady(state),
            resolved,
            first: below,
            octaves,
        })
    }
}

/// Chebyshev's point of an index, from 1 to −1.
fn place(index: usize, intervals: usize) -> f64 {
    (PI * index as f64 / intervals as f64).cos()
}

impl Octave {
    /// The octave of a function of t from −1, its shortest wavelength, to 1, its longest.
    fn new(
        value: impl Fn(f64) -> Result<[Complex64; DERIVATIVES], Error>,
        tolerance: f64,
    ) -> Result<Self, Error> {
        let mut intervals = FEWEST_INTERVALS;
        let at = |index, intervals| value(place(index, intervals));
        let values = (0..=intervals).map(|index| at(index, intervals));
        let mut octave = Self(values.collect::<Result<_, _>>()?);
        loop {
            let between = (0..intervals).map(|index| at(2 * index + 1, 2 * intervals));
            let between: Vec<_> = between.collect::<Result<_, _>>()?;
            let mut worst: f64 = 0.0;
            for (index, exact) in between.iter().enumerate() {
                let got = octave.at(place(2 * index + 1, 2 * intervals));
                for (got, exact) in got.iter().zip(exact) {
                    worst = worst.max((got - exact).norm() / exact.norm().max(f64::MIN_POSITIVE));
                }
            }
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

    /// The polynomial at t ∈ \[−1, 1\], by the barycentric formula (Berrut & Trefethen 2004, equations 4.2 and 5.4).
    fn at(&self, t: f64) -> [Complex64; DERIVATIVES] {
        let intervals = self.0.len() - 1;
        let (mut above, mut below) = ([Complex64::ZERO; DERIVATIVES], 0.0);
        for (index, values) in self.0.iter().enumerate() {
            let distance = t - place(index, intervals);
            if distance == 0.0 {
                return *values;
            }
            let sign = if index % 2 == 0 { 1.0 } else { -1.0 };
            let share = if index == 0 || index == intervals {
                0.5
            } else {
                1.0
            };
            let weight = sign * share / distance;
            below += weight;
            for (above, value) in above.iter_mut().zip(values) {
                *above += weight * value;
            }
        }
        above.map(|above| above / below)
    }
}

impl RollingContact for NonSteady {
    fn steady(&self) -> MeanRolling {
        self.steady
    }

    fn response(&self, wavelength: f64) -> ContactResponse {
        /// A wavelength at the end may come back a rounding outside.
        const ROUNDING: f64 = 1e-9;
        // Counted from the same wavelength by every table: equal roundings.
        let place = (wavelength / self.resolved).log2();
        let (first, end) = (self.first, self.first + self.octaves.len() as f64);
        let values = if (first - ROUNDING..=end + ROUNDING).contains(&place) {
            let octave = place.floor().clamp(first, end - 1.0);
            let t = 2.0 * (place - octave) - 1.0;
            self.octaves[(octave - first) as usize].at(t.clamp(-1.0, 1.0))
        } else {
            [Complex64::new(f64::NAN, f64::NAN); DERIVATIVES]
        };
        let derivative = |input: usize| ContactDerivative {
            force: [values[input], Complex64::ZERO],
            energy: values[2 + input],
            energy_at_rail: Some(values[4 + input]),
        };
        ContactResponse {
            by_load: derivative(0),
            by_longitudinal: derivative(1),
            by_lateral: None,
            by_spin: None,
        }
    }
}
