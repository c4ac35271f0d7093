//! FASTSIM against CONTACT's: what is the theory's, what is the grid's.

use riffel::contact::{CreepEllipse, CreepLaw, Creepages, Fastsim, HalfSpace, KalkerCoefficients, TractionBound};
use riffel::{ElasticMaterial, HertzContact};
use riffel_numerics::bisection::bisection;

use crate::Row;
use crate::ground::extent;

const TRACTION_CURVE: &str = include_str!("../reference/contact/traction_curve.csv");

/// CONTACT's example tractcurv, after Polach (2005).
const LOAD: f64 = 106.7e3;
const FRICTION: f64 = 0.33;
const POISSON_RATIO: f64 = 0.28;
const SHEAR_MODULUS: f64 = 82e9;
/// Elements along and across in a box 1.1 times the ellipse.
const CELLS: [u32; 2] = [48, 44];
const BOX_OVER_ELLIPSE: f64 = 1.1;

/// Creepage and Q/μP of the cases from `first` on, thirty to a series.
fn series(first: usize) -> impl Iterator<Item = [f64; 2]> {
    let number = |cell: &str| cell.parse::<f64>().expect("a number");
    TRACTION_CURVE.lines().skip(first).take(30).map(move |line| {
        let cells: Vec<&str> = line.split(',').collect();
        [number(cells[1]), -number(cells[2])]
    })
}

/// The ellipse of twice the width, by its transverse radius.
fn locomotive() -> HertzContact {
    let youngs_modulus = 2.0 * SHEAR_MODULUS * (1.0 + POISSON_RATIO);
    let steel = ElasticMaterial::new(youngs_modulus, POISSON_RATIO).expect("a steel");
    let contact = |radius| HertzContact::exact(steel, 0.625, radius, LOAD).expect("a contact");
    let [radius, _] = bisection([0.625, 6.25], 0.0, |radius| contact(radius).axis_ratio() <= 0.5);
    contact(radius)
}

fn creep_ellipse(contact: HertzContact) -> CreepEllipse {
    let kalker = KalkerCoefficients::new(POISSON_RATIO, contact.axis_ratio());
    CreepEllipse::new(contact, kalker.expect("coefficients"))
}

fn fastsim(ellipse: CreepEllipse) -> Fastsim {
    let divisions = Fastsim::DEFAULT_DIVISIONS;
    Fastsim::new(ellipse, FRICTION, TractionBound::Parabolic, divisions).expect("a law")
}

fn tractive_ratio(law: &Fastsim, creepage: f64) -> f64 {
    let force = law.forces(LOAD, Creepages::longitudinal(creepage));
    force.longitudinal / (FRICTION * LOAD)
}

fn percent((low, high): (f64, f64)) -> String {
    format!("{:+.1} … {:+.1} %", 100.0 * low, 100.0 * high)
}

pub(crate) fn fastsim_against_the_exact_theory() -> Row {
    let contact = locomotive();
    let law = fastsim(creep_ellipse(contact));
    let half_space = HalfSpace::new(contact, FRICTION, 36).expect("a grid");
    let rows: Vec<[f64; 3]> = series(1)
        .map(|[creepage, printed]| {
            let state = half_space.roll(creepage).expect("a steady state");
            let exact = state.tangential_force() / (FRICTION * LOAD);
            [tractive_ratio(&law, creepage), printed, exact]
        })
        .collect();
    let distance = |of: usize, from: usize| extent(rows.iter().map(|row| row[of] / row[from] - 1.0));
    let (law_to_print, law_to_exact, print_to_exact) = (distance(0, 1), distance(0, 2), distance(1, 2));
    let within = |(low, high): (f64, f64), limit: f64| low > -limit && high < limit;
    Row {
        statement: "FASTSIM against the exact theory: creep curve of a locomotive, a/b = 0.5",
        source: "CONTACT, `contact/traction_curve.csv`, cases 1–30, on 48 × 44 elements",
        expected: "30 tractive ratios, within 5 %".to_owned(),
        got: format!(
            "{} of CONTACT's print, {} of the half-space here, of which that print is {}",
            percent(law_to_print),
            percent(law_to_exact),
            percent(print_to_exact)
        ),
        tolerance: "5.5 % of the print, 4.8 % of the half-space: the simplified theory's own distance; 1.6 % between \
                    the two: CONTACT's elements are first order and not extrapolated",
        holds: rows.len() == 30
            && within(law_to_print, 0.055)
            && within(law_to_exact, 0.048)
            && within(print_to_exact, 0.016),
    }
}

/// FASTSIM as CONTACT cuts it: cells of one size with their middle inside the ellipse, each with the
/// traction at its end, as if the material had entered a whole cell before.
fn on_first_order_cells(ellipse: CreepEllipse, creepage: f64) -> f64 {
    let spacing = CELLS.map(|cells| 2.0 * BOX_OVER_ELLIPSE / f64::from(cells));
    let middle = |index: u32, axis: usize| (f64::from(index) + 0.5) * spacing[axis] - BOX_OVER_ELLIPSE;
    // Growth over a cell, over the bound in the middle, 2μP/πab; L₁ = 8a/(3C₁₁G).
    let area = std::f64::consts::PI * ellipse.semi_axis_longitudinal * ellipse.semi_axis_lateral;
    let growth =
        3.0 / 8.0 * ellipse.c11 * ellipse.shear_modulus * creepage * spacing[0] / (2.0 * FRICTION * LOAD / area);
    let mut sum = 0.0;
    for across in 0..CELLS[1] {
        let mut traction: f64 = 0.0;
        for along in (0..CELLS[0]).rev() {
            let bound = 1.0 - middle(along, 0).powi(2) - middle(across, 1).powi(2);
            if bound > 0.0 {
                traction = (traction + growth).min(bound);
                sum += traction * spacing[0] * spacing[1];
            }
        }
    }
    2.0 * sum / std::f64::consts::PI
}

pub(crate) fn fastsim_on_first_order_cells() -> Row {
    // C₁₁ as CONTACT interpolates the printed table; ours is 0.2 % larger.
    let ellipse = CreepEllipse { c11: 3.733_5, ..creep_ellipse(locomotive()) };
    let law = fastsim(ellipse);
    let linear = |creepage: f64| {
        let force = ellipse.linear_forces(Creepages::longitudinal(creepage));
        force.longitudinal / (FRICTION * LOAD)
    };
    let rows: Vec<[f64; 4]> = series(61)
        .map(|[creepage, printed]| {
            [
                on_first_order_cells(ellipse, creepage) / printed - 1.0,
                tractive_ratio(&law, creepage) / printed - 1.0,
                tractive_ratio(&law, creepage) / linear(creepage) - 1.0,
                printed / linear(creepage) - 1.0,
            ]
        })
        .collect();
    let column = |index: usize| extent(rows.iter().map(|row| row[index]));
    let (cells, converged) = (column(0), column(1));
    // The first row has the smallest creepage, 1e-5.
    let [_, _, slope, printed_slope] = rows[0];
    Row {
        statement: "FASTSIM against CONTACT's FASTSIM, same curve",
        source: "CONTACT, `contact/traction_curve.csv`, cases 61–90, on 48 × 44 elements",
        expected: "30 tractive ratios, within 1 % on the same cells; Kalker's slope at no creepage".to_owned(),
        got: format!(
            "{:+.2} … {:+.2} % on the same cells, {} as it is; at ξ = 10⁻⁵ {:+.2} % of Kalker's linear theory, CONTACT's {:+.1} %",
            100.0 * cells.0,
            100.0 * cells.1,
            percent(converged),
            100.0 * slope,
            100.0 * printed_slope
        ),
        tolerance: "0.1 % on the same cells: four printed digits; 3.1 % else: tractions at the end of cells are 1/n too far on",
        holds: rows.len() == 30
            && cells.0 > -1e-3
            && cells.1 < 1e-3
            && converged.0 > -0.031
            && converged.1 < 1e-3
            && slope.abs() < 2e-3,
    }
}

/// What values on 40 and on 200 cells over a diameter tend to, if their error is of first order.
fn extrapolated([coarse, fine]: [f64; 2]) -> f64 {
    fine + (fine - coarse) / 4.0
}

pub(crate) fn fastsim_with_spin() -> Row {
    /// Flexibilities that the output prints \[mm³/N\], taken at an ellipse fitted to its cells.
    const FLEXIBILITIES: [f64; 3] = [4.914e-5, 5.122e-5, 4.095e-5];
    const DIVISIONS: usize = 400;
    let (a, b, modulus): (f64, f64, f64) = (8.0, 4.0, 82e3);
    let ellipse = CreepEllipse {
        normal_force: 82e3,
        semi_axis_longitudinal: 1e-3 * a,
        semi_axis_lateral: 1e-3 * b,
        shear_modulus: 1e6 * modulus,
        c11: 8.0 * a / (3.0 * FLEXIBILITIES[0] * modulus),
        c22: 8.0 * a / (3.0 * FLEXIBILITIES[1] * modulus),
        c23: std::f64::consts::PI * a * (a / b).sqrt() / (4.0 * FLEXIBILITIES[2] * modulus),
    };
    // As in CONTACT, where the same creepages drive a force of the opposite sign.
    let creepages = Creepages { longitudinal: 0.0, lateral: -6.25e-4, spin: 0.625 };
    let speed = 30.0;
    let got = [TractionBound::Parabolic, TractionBound::Elliptic].map(|bound| {
        let law = Fastsim::new(ellipse, 0.3, bound, DIVISIONS).expect("a law");
        let energy = law.distribution(82e3, creepages).energy_per_metre();
        [law.forces(82e3, creepages).lateral / (0.3 * 82e3), speed * energy]
    });
    // |F_y|/μP and power, each on both grids.
    let expected =
        [[[0.6098, 0.6338], [506.1, 557.1]].map(extrapolated), [[0.6008, 0.5948], [688.3, 730.9]].map(extrapolated)];
    let words = |values: [[f64; 2]; 2]| {
        let [[parabolic, power], [elliptic, more_power]] = values;
        format!("{parabolic:.4} and {power:.0} W (parabolic bound), {elliptic:.4} and {more_power:.0} W (elliptic)")
    };
    let close = |bound: usize, quantity: usize, limit: f64| {
        (got[bound][quantity] / expected[bound][quantity] - 1.0).abs() < limit
    };
    Row {
        statement: "FASTSIM with lateral creepage and spin: modulus of F_y/μP, and frictional power",
        source: "CONTACT, example fastsim, output of 2023-05-10, extrapolated from 40 and 200 cells to none, with the \
                 flexibilities it prints",
        expected: words(expected),
        got: words(got),
        tolerance: "0.1 % of the force, 0.3 % and 1.5 % of the power: four digits, and an extrapolation of first order, \
                    which the edge of the elliptic bound is not",
        holds: close(0, 0, 1e-3) && close(1, 0, 1e-3) && close(0, 1, 3e-3) && close(1, 1, 0.015),
    }
}
