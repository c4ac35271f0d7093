//! Responses at many wavenumbers: each begins with what those before it have found.

use num_complex::Complex64;
use riffel_numerics::hermitian::solve_hermitian;

use super::Grid;
use super::friction::{Slip, halves};
use super::gmres::gmres;
use super::influence::Convolution;
use super::input::Input;
use super::on_waves::OnWaves;
use super::patch::Field;
use super::response::{Oscillation, Response, Tangent};
use super::scalar::{add_multiple, dot, norm};
use crate::contact::Creepages;

/// Residual of the linear equations, as a share of their right-hand side.
pub(super) const TOLERANCE: f64 = 1e-5;
const MOST_PRODUCTS: usize = 400;

/// The responses of one grid about a steady state to some inputs, from one wavenumber to the next.
///
/// Method: a reduced basis (Hesthaven, Rozza & Stamm 2016, chapter 3). The matrix of the equations is a sum of three
/// fixed ones, A(k) = A₀ + e^{ik dx/2} A₁ + e^{−ik dx/2} A₂, and their solution is smooth in k. So the tractions are sought
/// first among the sums of those already found, where the residual is least; what that leaves above the tolerance is
/// solved by [`gmres`], and joins the basis. The residual is held to the same tolerance either way. Cost: some twenty
/// products with A for the first wavenumber, less for each further one, and none if ten of them lie around it.
pub(super) struct GridSweep<'a> {
    tangent: Tangent<'a>,
    convolution: Convolution<'a>,
    on_waves: Option<OnWaves>,
    bases: Vec<(Input, Basis)>,
}

impl<'a> GridSweep<'a> {
    pub(super) fn new(grid: &'a Grid, steady: &'a Slip, creepages: Creepages, inputs: &[Input]) -> Self {
        let basis = |&input| (input, Basis::default());
        Self {
            tangent: Tangent::new(grid, steady, creepages),
            convolution: Convolution::new(&grid.influence, &grid.patch),
            on_waves: inputs.contains(&Input::Profile).then(|| OnWaves::new(grid, steady)),
            bases: inputs.iter().map(basis).collect(),
        }
    }

    /// Begin anew with what some other wavenumbers have found.
    pub(super) fn begin_with(&mut self, found: &[&Found]) {
        for (index, (_, basis)) in self.bases.iter_mut().enumerate() {
            *basis = Basis::default();
            for found in found {
                for tractions in &found.0[index] {
                    basis.learn(&self.tangent, &mut self.convolution, tractions.clone());
                }
            }
        }
    }

    /// All that has been found since the beginning.
    pub(super) fn found(&self) -> Found {
        let of_basis = |(_, basis): &(Input, Basis)| {
            let members = basis.members.iter();
            members.map(|member| member.tractions.clone()).collect()
        };
        Found(self.bases.iter().map(of_basis).collect())
    }

    /// The response to each input at a wavenumber \[rad/m\]; the residual reached if one does not converge.
    pub(super) fn at(&mut self, wavenumber: f64) -> Result<Vec<Response>, f64> {
        let Self { tangent, convolution, on_waves, bases } = self;
        if let Some(on_waves) = on_waves {
            on_waves.prepare(wavenumber, tangent.grid, tangent.steady, convolution);
        }
        let oscillation = tangent.at(wavenumber);
        let response = |(input, basis): &mut (Input, Basis)| {
            let forcing = oscillation.forcing(*input, on_waves.as_ref());
            let right = oscillation.right(&forcing);
            let (mut shares, rest) = basis.nearest(&oscillation, &right);
            let allowed = TOLERANCE * norm(&right);
            let reached = norm(&rest);
            if reached > allowed {
                let strips = oscillation.strips();
                let inverse = strips.inverse(|index, part| oscillation.diagonal(index, part));
                let change = gmres(
                    |tractions: &[Complex64]| oscillation.product(tractions, convolution),
                    |values: &mut [Complex64]| inverse.solve(values),
                    &rest,
                    allowed / reached,
                    MOST_PRODUCTS,
                )
                .map_err(|left| left * reached / norm(&right))?;
                basis.learn(tangent, convolution, change);
                (shares, _) = basis.nearest(&oscillation, &right);
            }
            let tractions = basis.tractions(&shares, right.len());
            let moved = basis.moved(&shares, &oscillation, tangent.grid.patch.steps.len());
            Ok(oscillation.response(&forcing, &tractions, &moved))
        };
        bases.iter_mut().map(response).collect()
    }
}

/// Tractions that a [`GridSweep`] has found, by its inputs.
pub(super) struct Found(Vec<Vec<Vec<Complex64>>>);

/// Orthonormal tractions, and what the matrix of the equations makes of them at any wavenumber.
#[derive(Default)]
struct Basis {
    members: Vec<Member>,
    /// Inner products of the images of a member with those of itself and of each one before it.
    products: Vec<Vec<[[Complex64; TERMS]; TERMS]>>,
}

/// Terms of the matrix: alone, and with the factors of the displacement here and ahead.
const TERMS: usize = 3;

struct Member {
    tractions: Vec<Complex64>,
    /// Displacement u(x) and u(x + dx) of every step of the material.
    here: Field<Complex64>,
    ahead: Field<Complex64>,
    images: [Vec<Complex64>; TERMS],
}

impl Basis {
    fn learn(&mut self, tangent: &Tangent, convolution: &mut Convolution, found: Vec<Complex64>) {
        /// Of what lies in the span already, no more than rounding is left.
        const NOTHING_NEW: f64 = 1e-12;
        let before = norm(&found);
        let mut tractions = found;
        for member in &self.members {
            let share = dot(&member.tractions, &tractions);
            add_multiple(&mut tractions, -share, &member.tractions);
        }
        let size = norm(&tractions);
        if size <= NOTHING_NEW * before {
            return;
        }
        for value in &mut tractions {
            *value /= size;
        }
        let field = halves(&tractions);
        let here = convolution.complex(field, [Complex64::ONE, Complex64::ZERO]);
        let ahead = convolution.complex(field, [Complex64::ZERO, Complex64::ONE]);
        let weight = tangent.weight();
        let mut alone = tangent.projected(|part, index| -field[part][index]);
        add_multiple(&mut alone, Complex64::ONE, &tractions);
        let images = [
            alone,
            tangent.projected(|part, index| weight * here[part][index]),
            tangent.projected(|part, index| weight * ahead[part][index]),
        ];
        let with = |other: &[Vec<Complex64>; TERMS]| {
            [0, 1, 2].map(|row| [0, 1, 2].map(|column| dot(&images[row], &other[column])))
        };
        let mut products: Vec<_> = self.members.iter().map(|m| with(&m.images)).collect();
        products.push(with(&images));
        self.products.push(products);
        self.members.push(Member { tractions, here, ahead, images });
    }

    /// The shares of the members that together leave the least of a right-hand side, and what they leave.
    fn nearest(&self, oscillation: &Oscillation, right: &[Complex64]) -> (Vec<Complex64>, Vec<Complex64>) {
        let [here, ahead] = oscillation.difference();
        let factors = [Complex64::ONE, here, ahead];
        let sum = |terms: &dyn Fn(usize) -> Complex64| -> Complex64 { (0..TERMS).map(terms).sum() };
        let lower: Vec<Vec<Complex64>> = self
            .products
            .iter()
            .map(|row| {
                let entry = |products: &[[Complex64; TERMS]; TERMS]| {
                    sum(&|a| factors[a].conj() * sum(&|b| products[a][b] * factors[b]))
                };
                row.iter().map(entry).collect()
            })
            .collect();
        let with_right =
            self.members.iter().map(|member| sum(&|term| factors[term].conj() * dot(&member.images[term], right)));
        let shares = solve_hermitian(lower, with_right.collect());
        let mut rest = right.to_vec();
        for (member, share) in self.members.iter().zip(&shares) {
            for (image, factor) in member.images.iter().zip(factors) {
                add_multiple(&mut rest, -share * factor, image);
            }
        }
        (shares, rest)
    }

    fn tractions(&self, shares: &[Complex64], count: usize) -> Vec<Complex64> {
        let mut sum = vec![Complex64::ZERO; count];
        for (member, &share) in self.members.iter().zip(shares) {
            add_multiple(&mut sum, share, &member.tractions);
        }
        sum
    }

    /// The displacement over every step.
    fn moved(&self, shares: &[Complex64], oscillation: &Oscillation, steps: usize) -> Field<Complex64> {
        let [of_here, of_ahead] = oscillation.difference();
        [0, 1].map(|part| {
            let mut sum = vec![Complex64::ZERO; steps];
            for (member, &share) in self.members.iter().zip(shares) {
                add_multiple(&mut sum, share * of_here, &member.here[part]);
                add_multiple(&mut sum, share * of_ahead, &member.ahead[part]);
            }
            sum
        })
    }
}
