//! Rolling contact that answers late: the exact response, from a table over wavelength.

use std::f64::consts::PI;

use num_complex::Complex64;

use super::half_space::REMEDY;
use super::{
    ContactResponse, HalfSpace, HalfSpaceRolling, RailDissipation, RollingContact, SteadyRolling,
};
use crate::Error;

/// Accuracy of the table, relative to the largest value of each derivative.
const TOLERANCE: f64 = 1e-4;
/// Fewest and most nodes of the table.
const FEWEST_NODES: usize = 8;
const MOST_NODES: usize = 64;

/// The response of a [`HalfSpace`] about one mean state, for a loop.
///
/// Method: six complex derivatives at Chebyshev's nodes in the logarithm of the wavelength, as a
/// polynomial; the nodes are doubled until 1e-4 of the largest value holds halfway between them. Outside
/// its wavelengths the table is not a number. Cost: some 0.3 s to make, a microsecond to ask.
pub struct NonSteady {
    steady: SteadyRolling,
    /// Middle and half of the range of ln λ.
    range: (f64, f64),
    /// Chebyshev coefficients of each derivative.
    coefficients: Vec<[Complex64; DERIVATIVES]>,
}

/// A [`HalfSpace`] that answers at once, by the slopes of its creep curve.
pub struct SlowHalfSpace {
    steady: SteadyRolling,
    response: ContactResponse,
}

impl SlowHalfSpace {
    /// The slopes about a state.
    ///
    /// # Errors
    /// Those of [`HalfSpace::response`].
    pub fn new(contact: &HalfSpace, state: &HalfSpaceRolling) -> Result<Self, Error> {
        let response = contact.response(state, f64::INFINITY)?;
        Ok(Self {
            steady: contact.steady(state),
            response: ContactResponse {
                at_rail: None,
                ..response
            },
        })
    }
}

impl RollingContact for SlowHalfSpace {
    fn steady(&self) -> SteadyRolling {
        self.steady
    }

    fn response(&self, _wavelength: f64) -> ContactResponse {
        self.response
    }
}

const DERIVATIVES: usize = 6;

fn listed(response: ContactResponse) -> [Complex64; DERIVATIVES] {
    let rail = response.at_rail(0.0);
    [
        response.dq_dp,
        response.dq_dxi,
        response.de_dp,
        response.de_dxi,
        rail.de_dp,
        rail.de_dxi,
    ]
}

impl NonSteady {
    /// The response of the contact about a state, for wavelengths from `shortest` to `longest` \[m\].
    ///
    /// # Errors
    /// Those of [`HalfSpace::response`]; [`Error::NotConverged`] if 64 nodes do not do.
    pub fn new(
        contact: &HalfSpace,
        state: &HalfSpaceRolling,
        shortest: f64,
        longest: f64,
    ) -> Result<Self, Error> {
        contact.check_wavelength(shortest)?;
        let middle = 0.5 * (shortest.ln() + longest.ln());
        let half = 0.5 * (longest.ln() - shortest.ln());
        let value = |t: f64| -> Result<[Complex64; DERIVATIVES], Error> {
            // The ends themselves, not a rounding beyond them.
            let wavelength = (middle + half * t).exp().clamp(shortest, longest);
            contact.response(state, wavelength).map(listed)
        };
        let mut nodes = FEWEST_NODES;
        loop {
            let table = Self {
                steady: contact.steady(state),
                range: (middle, half),
                coefficients: chebyshev(nodes, &value)?,
            };
            let error = table.error(nodes, &value)?;
            if error <= TOLERANCE {
                return Ok(table);
            }
            if nodes == MOST_NODES {
                return Err(Error::NotConverged {
                    problem: "table of the contact's response",
                    residual: error,
                    tolerance: TOLERANCE,
                    remedy: REMEDY,
                });
            }
            nodes *= 2;
        }
    }

    /// Clenshaw's sum at t ∈ \[−1, 1\].
    fn at(&self, t: f64) -> [Complex64; DERIVATIVES] {
        std::array::from_fn(|derivative| {
            let (mut next, mut after) = (Complex64::ZERO, Complex64::ZERO);
            for coefficients in self.coefficients.iter().skip(1).rev() {
                (next, after) = (coefficients[derivative] + 2.0 * t * next - after, next);
            }
            self.coefficients[0][derivative] + t * next - after
        })
    }

    /// Largest error at three places between nodes, as a share of the largest value there.
    fn error(
        &self,
        nodes: usize,
        value: &impl Fn(f64) -> Result<[Complex64; DERIVATIVES], Error>,
    ) -> Result<f64, Error> {
        let mut worst: f64 = 0.0;
        // Halfway between two nodes near the short end, in the middle and near the long end.
        for place in [1, nodes / 2, nodes - 1] {
            let t = (PI * place as f64 / nodes as f64).cos();
            let (got, exact) = (self.at(t), value(t)?);
            for (got, exact) in got.iter().zip(exact) {
                worst = worst.max((got - exact).norm() / exact.norm().max(f64::MIN_POSITIVE));
            }
        }
        Ok(worst)
    }
}

/// Coefficients of the polynomial through Chebyshev's nodes.
fn chebyshev(
    nodes: usize,
    value: &impl Fn(f64) -> Result<[Complex64; DERIVATIVES], Error>,
) -> Result<Vec<[Complex64; DERIVATIVES]>, Error> {
    let angle = |j: usize| PI * (j as f64 + 0.5) / nodes as f64;
    let values: Vec<_> = (0..nodes)
        .map(|j| value(angle(j).cos()))
        .collect::<Result<_, _>>()?;
    let coefficient = |k: usize| {
        let scale = if k == 0 { 1.0 } else { 2.0 } / nodes as f64;
        std::array::from_fn(|derivative| {
            values
                .iter()
                .enumerate()
                .map(|(j, value)| value[derivative] * (scale * (k as f64 * angle(j)).cos()))
                .sum()
        })
    };
    Ok((0..nodes).map(coefficient).collect())
}

impl RollingContact for NonSteady {
    fn steady(&self) -> SteadyRolling {
        self.steady
    }

    fn response(&self, wavelength: f64) -> ContactResponse {
        /// A wavelength at the end may come back a rounding outside.
        const ROUNDING: f64 = 1e-9;
        let (middle, half) = self.range;
        let t = (wavelength.ln() - middle) / half;
        let [dq_dp, dq_dxi, de_dp, de_dxi, rail_de_dp, rail_de_dxi] = if t.abs() <= 1.0 + ROUNDING {
            self.at(t)
        } else {
            [Complex64::new(f64::NAN, f64::NAN); DERIVATIVES]
        };
        ContactResponse {
            dq_dp,
            dq_dxi,
            de_dp,
            de_dxi,
            at_rail: Some(RailDissipation {
                de_dp: rail_de_dp,
                de_dxi: rail_de_dxi,
            }),
        }
    }
}
