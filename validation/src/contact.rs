//! Contact patch and creep law against the exact theory.

use riffel::contact::{CreepLaw, Creepages, KalkerCoefficients};

use riffel::{ElasticMaterial, HertzContact};

use crate::Row;
use crate::ground::{extent, nominal};
use crate::linear_theory;

pub(crate) fn hertz_semi_axis() -> Row {
    let exact = 5.94369e-3;
    let a = nominal(&[]).hertz.semi_axis_longitudinal();
    Row {
        statement: "(22) overstates the exact Hertz semi-axis by 0.7 %",
        source: "exact elliptic integrals, `hertz.csv`",
        expected: "5.944 mm exact, 5.986 mm by (22)".to_owned(),
        got: format!("{:.3} mm", 1e3 * a),
        tolerance: "1e-3 of the ratio 1.0071: a known distance of the model, held where it is",
        holds: (a / exact - 1.0071).abs() < 1e-3,
    }
}

pub(crate) fn creep_curve() -> Row {
    let case = nominal(&[]);
    let law = case.law.expect("the paper's law");
    let limit = law.friction() * case.steady.normal_force;
    let (low, high) = extent(include_str!("../reference/contact/creep_curve.csv").lines().skip(1).filter_map(|line| {
        let cells: Vec<f64> = line.split(',').map_while(|c| c.parse().ok()).collect();
        let (load, creepage, exact) = (cells[0], cells[1], cells[2]);
        // Beyond 0.4 % both saturate and the comparison says nothing.
        (creepage <= 4e-3).then(|| {
            let creepages = Creepages::longitudinal(creepage);
            law.forces(load, creepages).longitudinal / (limit * exact) - 1.0
        })
    }));
    Row {
        statement: "The creep law (5) is 1.5–3 % low against the exact theory at the paper's ellipse",
        source: "CONTACT (Kalker's half-space theory), `creep_curve.csv`",
        expected: "−1.5 … −3 %".to_owned(),
        got: format!("{:.1} … {:.1} % for ξ ≤ 0.4 %", 100.0 * low, 100.0 * high),
        tolerance: "0.5 % to either side: the accuracy of the reference; the distance is the model's",
        holds: low > -0.035 && high < -0.010,
    }
}

pub(crate) fn saturation_creepage() -> Row {
    let law = nominal(&[]).law.expect("the paper's law");
    let got = law.own_slope().expect("one of its own").saturation_creepage;
    Row {
        statement: "Saturation creepage ξ_max of the nominal contact",
        source: "(6), (7), 40-digit arithmetic",
        expected: "0.70363 %".to_owned(),
        got: format!("{:.5} %", 100.0 * got),
        tolerance: "the printed digits",
        holds: (100.0 * got - 0.70363).abs() < 5e-6,
    }
}

pub(crate) fn creepage_of_four_per_mille() -> Row {
    let case = nominal(&["contact.creepage=0.4 %"]);
    let ratio = case.steady.tractive_ratio();
    Row {
        statement: "The nominal creepage of 0.4 % means a tractive ratio of 0.920",
        source: "section 4 with (5)",
        expected: "τ = 0.920".to_owned(),
        got: format!("τ = {ratio:.3}"),
        tolerance: "the printed digits",
        holds: (ratio - 0.920).abs() < 5e-4,
    }
}

/// The comma-separated numbers of a table, without its head; cells that are no numbers end a row.
fn rows(table: &str) -> impl Iterator<Item = Vec<f64>> {
    table.lines().skip(1).map(|line| line.split(',').map_while(|c| c.parse().ok()).collect())
}

pub(crate) fn exact_hertz_ellipse() -> Row {
    let table = include_str!("../reference/contact/hertz.csv");
    let mut got = Vec::new();
    let mut worst = [0.0_f64; 2];
    for cells in rows(table) {
        let Some(contact) =
            ElasticMaterial::new(207e9, 0.3).and_then(|steel| HertzContact::exact(steel, 0.46, 0.23, cells[0])).ok()
        else {
            continue;
        };
        let (a, b) = (contact.semi_axis_longitudinal(), contact.semi_axis_lateral());
        let (pressure, approach) = (contact.peak_pressure(), contact.approach());
        for (value, exact) in [(a, 1e-3 * cells[3]), (b, 1e-3 * cells[4]), (pressure, 1e6 * cells[5])] {
            worst[0] = worst[0].max((value / exact - 1.0).abs());
        }
        worst[1] = worst[1].max((approach / (1e-6 * cells[7]) - 1.0).abs());
        got.push(format!("{:.5} mm, {:.5} mm, {:.3} MPa, {:.3} µm", 1e3 * a, 1e3 * b, 1e-6 * pressure, 1e6 * approach));
    }
    Row {
        statement: "Exact Hertz contact at 45 and 50 kN: a, b, p₀, δ",
        source: "exact elliptic integrals, `hertz.csv`",
        expected: "5.73857 mm, 3.61872 mm, 1034.656 MPa, 64.262 µm; \
                   5.94369 mm, 3.74806 mm, 1071.639 MPa, 68.938 µm"
            .to_owned(),
        got: got.join("; "),
        tolerance: "1.5e-6, of the approach 8e-6: half of the last digit of the reference",
        holds: got.len() == 2 && worst[0] < 1.5e-6 && worst[1] < 8e-6,
    }
}

fn kalker(poisson_ratio: f64, axis_ratio: f64) -> [f64; 4] {
    KalkerCoefficients::new(poisson_ratio, axis_ratio)
        .map_or([f64::NAN; 4], |KalkerCoefficients { c11, c22, c23, c33 }| [c11, c22, c23, c33])
}

/// Largest of the distances; not a number if one is not.
fn worst(distances: impl Iterator<Item = f64>) -> f64 {
    distances.fold(
        0.0,
        |worst, distance| {
            if distance.abs() > worst || distance.is_nan() { distance.abs() } else { worst }
        },
    )
}

// Long: solves the boundary-value problem of Kalker for 49 pairs of ratios.
pub(crate) fn kalker_coefficients_linear_theory() -> Row {
    let distance = worst([-4, -2, -1, 0, 1, 2, 4].into_iter().flat_map(|quarter| {
        let axis_ratio = 10_f64.powf(f64::from(quarter) / 4.0);
        [0.0, 0.125, 0.2, 0.25, 0.3, 0.375, 0.5].into_iter().flat_map(move |poisson_ratio| {
            let exact = linear_theory::coefficients(poisson_ratio, axis_ratio, 24);
            kalker(poisson_ratio, axis_ratio).into_iter().zip(exact).map(|(value, exact)| value / exact - 1.0)
        })
    }));
    Row {
        statement: "Kalker's coefficients are those of his linear theory, 0.1 ≤ a/b ≤ 10",
        source: "boundary-value problem of Kalker (1967), solved here",
        expected: "0 %".to_owned(),
        got: format!("at most {:.3} %", 100.0 * distance),
        tolerance: "0.03 %: convergence of the solution with 24 degrees, and interpolation in the table",
        holds: distance < 3e-4,
    }
}

pub(crate) fn kalker_coefficients_printed() -> Row {
    let table = include_str!("../reference/contact/kalker_table_e3.csv");
    let [c11, c22, c23] = [0, 1, 2].map(|coefficient| {
        worst(rows(table).flat_map(move |cells| {
            [0.0, 0.25, 0.5]
                .into_iter()
                .enumerate()
                .map(move |(column, poisson_ratio)| {
                    let printed = cells[1 + 3 * coefficient + column];
                    kalker(poisson_ratio, cells[0])[coefficient] / printed - 1.0
                })
                .collect::<Vec<_>>()
        }))
    });
    Row {
        statement: "Kalker's coefficients against his printed table, C₁₁, C₂₂, C₂₃",
        source: "Kalker (1990), table E.3, as in CONTACT",
        expected: "0 %".to_owned(),
        got: format!("at most {:.2} %, {:.2} %, {:.2} %", 100.0 * c11, 100.0 * c22, 100.0 * c23),
        tolerance: "1.3 %: error of the printed table, largest at a/b = 0.1 and 10",
        holds: c11 < 0.013 && c22 < 0.013 && c23 < 0.013,
    }
}

pub(crate) fn kalker_coefficients_contact() -> Row {
    let table = include_str!("../reference/contact/kalker_coefficients.csv");
    let [c11, c22, c23, c33, slender] = [0, 1, 2, 3, 4].map(|case| {
        let coefficient = case.min(3);
        worst(
            rows(table)
                // C₃₃ of CONTACT is taken apart where the ellipse is longer than 3.4 times its width.
                .filter(|cells| case < 3 || (case == 4) == (cells[1] > 3.4))
                .map(|cells| kalker(cells[0], cells[1])[coefficient] / cells[2 + coefficient] - 1.0),
        )
    });
    Row {
        statement: "Kalker's coefficients against CONTACT in the linear limit, 0.1 ≤ a/b ≤ 10: C₁₁, \
                    C₂₂, C₂₃, C₃₃ for a/b ≤ 10/3, C₃₃ beyond",
        source: "CONTACT, `kalker_coefficients.csv`",
        expected: "0 %".to_owned(),
        got: format!(
            "at most {:.2} %, {:.2} %, {:.2} %, {:.2} %, {:.1} %",
            100.0 * c11,
            100.0 * c22,
            100.0 * c23,
            100.0 * c33,
            100.0 * slender
        ),
        tolerance: "1.1 %, the last 7 %: discretisation of CONTACT, by its own estimate up to 0.8 % \
                    and 6 % (C₃₃ at a/b = 10, ν = 0.5)",
        holds: [c11, c22, c23, c33].into_iter().all(|c| c < 0.011) && slender < 0.07,
    }
}
