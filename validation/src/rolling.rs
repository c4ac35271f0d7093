//! The exact theory of rolling contact against CONTACT.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use riffel::contact::{
    ContactDerivative, ContactResponse, Creepages, HalfSpace, HalfSpaceRolling, OscillatingCreepages,
};
use riffel::{Complex64, ElasticMaterial, HertzContact};

use crate::Row;

const CREEP_CURVE: &str = include_str!("../reference/contact/creep_curve.csv");
const FREQUENCY_RESPONSE: &str = include_str!("../reference/contact/frequency_response.csv");
const FREQUENCY_RESPONSE_LATERAL: &str = include_str!("../reference/contact/frequency_response_lateral.csv");
const CREEP_FORCES_VECTOR: &str = include_str!("../reference/contact/creep_forces_vector.csv");
const RESPONSE_LIMITS: &str = include_str!("../reference/contact/response_limits.csv");
const RAIL_DISSIPATION: &str = include_str!("../reference/contact/rail_fixed_dissipation.csv");

/// The contact of the references.
fn hertz(load: f64) -> HertzContact {
    let steel = ElasticMaterial::new(207e9, 0.3).expect("a steel");
    HertzContact::exact(steel, 0.46, 0.23, load).expect("a contact")
}

/// Contact cut into elements.
fn contact(load: f64, across: usize) -> HalfSpace {
    HalfSpace::new(hertz(load), 0.4, across).expect("a grid")
}

fn cells(line: &str) -> Vec<&str> {
    line.split(',').collect()
}

fn number(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

pub(crate) fn half_space_creep_curve() -> Row {
    let mut worst: f64 = 0.0;
    let mut compared = 0;
    for load in [45e3, 50e3] {
        let contact = contact(load, 36);
        let rows = CREEP_CURVE.lines().skip(1).map(cells);
        for row in rows.filter(|row| number(row[0]) == load) {
            let state = contact.roll(number(row[1])).expect("a steady state");
            let ratio = state.tangential_force() / (0.4 * load);
            let error = (ratio / number(row[2]) - 1.0).abs();
            worst = if error <= worst { worst } else { error };
            compared += 1;
        }
    }
    Row {
        statement: "Creep curve of the exact theory, 36 elements across",
        source: "CONTACT, `contact/creep_curve.csv`",
        expected: format!("{compared} tractive ratios"),
        got: format!("within {:.1} %", 100.0 * worst),
        tolerance: "0.7 %: 0.5 % of the reference's own extrapolation, and 0.2 % of this one",
        holds: worst <= 0.007 && compared >= 18,
    }
}

/// Wavelengths of the references about longitudinal creepage \[semi-axes\].
const WAVELENGTHS: [f64; 9] = [2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 20.0, 40.0, 100.0];

/// Responses about one steady state.
struct Responses {
    tractive_ratio: f64,
    slow: ContactResponse,
    /// By the wavelength in semi-axes.
    waves: Vec<(f64, ContactResponse)>,
}

impl Responses {
    fn new(
        contact: &HalfSpace,
        state: &HalfSpaceRolling,
        wavelengths: &[f64],
        creepages: OscillatingCreepages,
    ) -> Self {
        let semi_axis = hertz(50e3).semi_axis_longitudinal();
        let ratios = [&[f64::INFINITY], wavelengths].concat();
        let places: Vec<f64> = ratios.iter().map(|ratio| ratio * semi_axis).collect();
        let responses = contact.responses(state, &places, creepages, || ());
        let mut responses = responses.into_iter().map(|response| response.expect("a response"));
        Self {
            tractive_ratio: contact.steady(state).tractive_ratio(),
            slow: responses.next().expect("the slow response"),
            waves: wavelengths.iter().copied().zip(responses).collect(),
        }
    }

    /// The response at a wavelength of so many semi-axes.
    fn at(&self, ratio: f64) -> &ContactResponse {
        let wave = self.waves.iter().find(|wave| wave.0 == ratio);
        &wave.expect("a wavelength of the references").1
    }
}

/// The responses about longitudinal creepage, which three checks look at.
static ALONG: LazyLock<[Responses; 2]> = LazyLock::new(|| {
    let contact = contact(50e3, HalfSpace::DEFAULT_ELEMENTS);
    [0.1, 0.6].map(|ratio| {
        let state = contact.roll_at_tractive_ratio(ratio).expect("a steady state");
        let creepages = OscillatingCreepages::Longitudinal;
        Responses::new(&contact, &state, &WAVELENGTHS, creepages)
    })
});

/// Those at a tractive ratio.
fn along(tractive_ratio: f64) -> &'static Responses {
    let is_near = |responses: &&Responses| (responses.tractive_ratio - tractive_ratio).abs() < 1e-5;
    ALONG.iter().find(is_near).expect("0.1 or 0.6")
}

/// A response at a wavelength of so many semi-axes over another at none.
fn normalized(
    responses: &Responses,
    ratio: f64,
    value: fn(&ContactResponse) -> Complex64,
    slow: fn(&ContactResponse) -> Complex64,
) -> Complex64 {
    value(responses.at(ratio)) / slow(&responses.slow)
}

/// Largest errors of modulus (relative) and phase \[rad\] of the responses with one input.
fn compare(input: &str) -> (f64, f64, f64, usize) {
    let (mut modulus, mut phase, mut absolute): (f64, f64, f64) = (0.0, 0.0, 0.0);
    let mut compared = 0;
    type Value = fn(&ContactResponse) -> Complex64;
    let values: [(usize, Value); 2] = if input == "xi" {
        [(4, |response| response.by_longitudinal.force[0]), (8, |response| response.by_longitudinal.energy)]
    } else {
        [(4, |response| response.by_load.force[0]), (8, |response| response.by_load.energy)]
    };
    for row in FREQUENCY_RESPONSE.lines().skip(1).map(cells) {
        if row[0] != input {
            continue;
        }
        let responses = along(number(row[1]));
        for (column, value) in values {
            let expected = Complex64::new(number(row[column]), number(row[column + 1]));
            let got = normalized(responses, number(row[3]), value, value);
            compared += 1;
            if expected.norm() < 0.1 {
                absolute = absolute.max((got - expected).norm());
            } else {
                modulus = modulus.max((got.norm() / expected.norm() - 1.0).abs());
                phase = phase.max((got / expected).arg().abs());
            }
        }
    }
    (modulus, phase, absolute, compared)
}

fn response_row(
    statement: &'static str,
    input: &str,
    tolerance: &'static str,
    (modulus_limit, phase_limit): (f64, f64),
) -> Row {
    let (modulus, phase, absolute, compared) = compare(input);
    Row {
        statement,
        source: "CONTACT stepped through time, `contact/frequency_response.csv`",
        expected: format!("{compared} complex responses of creep force and dissipation"),
        got: format!("within {:.1} % and {phase:.3} rad; {absolute:.3} where small", 100.0 * modulus),
        tolerance,
        holds: modulus <= modulus_limit && phase <= phase_limit && absolute <= 0.01 && compared >= 32,
    }
}

pub(crate) fn frequency_response_to_creepage() -> Row {
    response_row(
        "Frequency response of rolling contact to creepage, wavelengths of 2–100 a, τ = 0.1 and 0.6",
        "xi",
        "2 % and 0.02 rad, 0.01 where |H| < 0.1: 1 % and 0.01 rad of the reference, the rest for the default of 60 elements",
        (0.02, 0.02),
    )
}

pub(crate) fn frequency_response_to_load() -> Row {
    response_row(
        "The same to load",
        "P",
        "2 % and 0.02 rad, 0.01 where |H| < 0.1: less than the reference's own error, and that of the default of 60 elements",
        (0.02, 0.02),
    )
}

// Long: computes the response of a loop at every row of its reference.
pub(crate) fn dissipation_at_the_rail() -> Row {
    let (mut by_creepage, mut by_load): (f64, f64) = (0.0, 0.0);
    let mut compared = 0;
    for row in RAIL_DISSIPATION.lines().skip(1).map(cells) {
        let responses = along(number(row[1]));
        let expected = Complex64::new(number(row[3]), number(row[4]));
        let ratio = number(row[2]);
        compared += 1;
        if row[0] == "xi" {
            let at_rail = |response: &ContactResponse| response.by_longitudinal.at_rail(0.0);
            let got = normalized(responses, ratio, at_rail, |slow| slow.by_longitudinal.energy);
            by_creepage = by_creepage.max((got - expected).norm());
        } else {
            let at_rail = |response: &ContactResponse| response.by_load.at_rail(0.0);
            let got = normalized(responses, ratio, at_rail, |slow| slow.by_load.energy);
            by_load = by_load.max((got - expected).norm());
        }
    }
    Row {
        statement: "Dissipation that a point of the rail receives over the passage",
        source: "CONTACT stepped through time, `contact/rail_fixed_dissipation.csv`",
        expected: format!("{compared} complex responses"),
        got: format!("within {by_creepage:.3} for creepage, {by_load:.3} for load"),
        tolerance: "0.03 and 0.05, absolute: the reference's own error of up to 0.02, the rest for the default of 60 elements",
        holds: by_creepage <= 0.03 && by_load <= 0.05 && compared >= 30,
    }
}

/// Creep forces with lateral creepage and spin, and their work with that of the moment.
pub(crate) fn half_space_creep_forces() -> Row {
    let contact = contact(50e3, HalfSpace::DEFAULT_ELEMENTS);
    let (mut of_force, mut of_energy): (f64, f64) = (0.0, 0.0);
    let mut compared = 0;
    for row in CREEP_FORCES_VECTOR.lines().skip(1).map(cells) {
        let creepages = Creepages { longitudinal: number(row[10]), lateral: number(row[11]), spin: number(row[12]) };
        let state = contact.roll_with(creepages).expect("a steady state");
        let force = state.forces();
        let error = (force.longitudinal / 20e3 - number(row[13])).hypot(force.lateral / 20e3 - number(row[14]));
        of_force = of_force.max(error / number(row[15]));
        let energy = creepages.longitudinal * force.longitudinal
            + creepages.lateral * force.lateral
            + creepages.spin * state.spin_moment();
        of_energy = of_energy.max((energy / number(row[17]) - 1.0).abs());
        compared += 1;
    }
    Row {
        statement: "Creep forces of the exact theory with lateral creepage and spin, 60 elements across",
        source: "CONTACT, `contact/creep_forces_vector.csv`",
        expected: format!("{compared} forces along and across the rail, and their energy per metre"),
        got: format!("forces within {:.1} %, energy within {:.1} %", 100.0 * of_force, 100.0 * of_energy),
        tolerance: "1 % and 1.5 %: up to 1 % of the reference's own extrapolation, and 0.2 % of this one",
        holds: of_force <= 0.01 && of_energy <= 0.015 && compared >= 22,
    }
}

/// Responses to creepage about a steady state with lateral creepage. Those to load contradict themselves, see the README.
pub(crate) fn frequency_response_across_the_rail() -> Row {
    let contact = contact(50e3, HalfSpace::DEFAULT_ELEMENTS);
    let rows = FREQUENCY_RESPONSE_LATERAL.lines().skip(1).map(cells);
    let rows: Vec<Vec<&str>> = rows.filter(|row| row[1] != "P").collect();
    // One steady state throughout.
    let creepages = Creepages { lateral: number(rows[0][2]), spin: number(rows[0][3]), ..Creepages::default() };
    let state = contact.roll_with(creepages).expect("a steady state");
    let wavelengths: BTreeSet<&str> = rows.iter().map(|row| row[5]).collect();
    let wavelengths: Vec<f64> = wavelengths.into_iter().map(number).collect();
    let in_plane = OscillatingCreepages::InPlane;
    let responses = Responses::new(&contact, &state, &wavelengths, in_plane);
    let mut worst: f64 = 0.0;
    let mut compared = 0;
    for row in rows {
        assert_eq!([number(row[2]), number(row[3])], [creepages.lateral, creepages.spin]);
        let by = |response: &ContactResponse| -> ContactDerivative {
            match row[1] {
                "xi" => response.by_longitudinal,
                _ => response.by_lateral.expect("both creepages"),
            }
        };
        let (got, slow) = (by(responses.at(number(row[5]))), by(&responses.slow));
        for (column, got) in
            [(6, got.force[0] / slow.force[0]), (12, got.force[1] / slow.force[1]), (18, got.energy / slow.energy)]
        {
            if row[column].is_empty() {
                continue;
            }
            let expected = Complex64::new(number(row[column]), number(row[column + 1]));
            worst = worst.max((got - expected).norm());
            compared += 1;
        }
    }
    Row {
        statement: "Frequency response about lateral creepage, τ = 0.3, wavelengths of 3–20 a, to both creepages",
        source: "CONTACT stepped through time, `contact/frequency_response_lateral.csv`",
        expected: format!("{compared} complex responses of creep force and dissipation"),
        got: format!("within {worst:.3}"),
        tolerance: "0.01, absolute: the reference's own error of up to 0.007",
        holds: worst <= 0.01 && compared >= 18,
    }
}

/// The default number of elements against the limit of finer grids, of a contact that no number of the method was
/// chosen by.
// Long: solves the contact on 60 elements across at every state of the reference.
pub(crate) fn frequency_response_at_the_default() -> Row {
    let steel = ElasticMaterial::new(207e9, 0.3).expect("a steel");
    let hertz = HertzContact::exact(steel, 0.4, 0.7, 80e3).expect("a contact");
    let contact = HalfSpace::new(hertz, 0.3, HalfSpace::DEFAULT_ELEMENTS).expect("a grid");
    let rows: Vec<Vec<&str>> = RESPONSE_LIMITS.lines().skip(1).map(cells).collect();
    let mut worst = Misses::default();
    let mut compared = 0;
    for rows in rows.chunk_by(|a, b| a[..3] == b[..3]) {
        let [longitudinal, lateral, spin] = [0, 1, 2].map(|column| number(rows[0][column]));
        let creepages = Creepages { longitudinal, lateral, spin };
        let state = contact.roll_with(creepages).expect("a steady state");
        let oscillating = match lateral == 0.0 {
            true => OscillatingCreepages::Longitudinal,
            false => OscillatingCreepages::All,
        };
        let waves: Vec<&[Vec<&str>]> = rows.chunk_by(|a, b| a[3] == b[3]).collect();
        let wavelengths: Vec<f64> =
            waves.iter().map(|rows| number(rows[0][3]) * hertz.semi_axis_longitudinal()).collect();
        let responses = contact.responses(&state, &wavelengths, oscillating, || ());
        for (wave, response) in waves.iter().zip(responses) {
            let response = response.expect("a response");
            for (row, slow) in wave.iter().zip(waves[0]) {
                let by = match row[4] {
                    "load" => Some(response.by_load),
                    "longitudinal" => Some(response.by_longitudinal),
                    "lateral" => response.by_lateral,
                    _ => response.by_spin,
                };
                worst.take(&by.expect("an input that oscillates"), row, slow);
                compared += 1;
            }
        }
    }
    let Misses { of_scale, of_modulus, at_rail_by_load } = worst;
    Row {
        statement: "Frequency response of rolling contact, 60 elements across, τ = 0.07 to 0.97 along the rail, 0.2 and 0.8 \
                    with lateral creepage and spin, wavelengths of 2–20 a, against the limit of grids of 96 to 144",
        source: "Riffel, `contact/response_limits.csv`",
        expected: format!("{compared} responses to load, both creepages and spin"),
        got: format!(
            "within {:.1} % of the larger of the response and its quasi-static value; of its own modulus, or a tenth \
             of that value, within {:.1} %, the energy at the rail by load {:.1} %",
            100.0 * of_scale,
            100.0 * of_modulus,
            100.0 * at_rail_by_load
        ),
        tolerance: "2 %; energy at the rail by load, which passes zero, 10 % of the modulus",
        holds: of_scale <= 0.02 && of_modulus <= 0.02 && at_rail_by_load <= 0.1 && compared == rows.len(),
    }
}

/// Largest misses of a response.
#[derive(Default)]
struct Misses {
    /// Relative to the larger of the response and its quasi-static value.
    of_scale: f64,
    /// Relative to the larger of the response and a tenth of that value; but for the next.
    of_modulus: f64,
    /// Response of the energy at the rail by load.
    at_rail_by_load: f64,
}

impl Misses {
    /// Take in a derivative, of which a row of the reference has the limit and another one the quasi-static value.
    fn take(&mut self, by: &ContactDerivative, row: &[&str], slow: &[&str]) {
        let values =
            |row: &[&str]| [5, 7, 9, 11].map(|column| Complex64::new(number(row[column]), number(row[column + 1])));
        let (limit, slow) = (values(row), values(slow));
        let got = [by.force[0], by.force[1], by.energy, by.at_rail(0.0)];
        let size = |values: &[Complex64]| values.iter().map(Complex64::norm_sqr).sum::<f64>().sqrt();
        let outputs: [std::ops::Range<usize>; 3] = [0..2, 2..3, 3..4];
        for (output, range) in outputs.into_iter().enumerate() {
            let (limit, slow) = (&limit[range.clone()], size(&slow[range.clone()]));
            let gaps: Vec<Complex64> = got[range].iter().zip(limit).map(|(a, b)| a - b).collect();
            let (gap, limit) = (size(&gaps), size(limit));
            let of_modulus = gap / limit.max(0.1 * slow);
            self.of_scale = self.of_scale.max(gap / limit.max(slow));
            let worst = match (row[4], output) {
                ("load", 2) => &mut self.at_rail_by_load,
                _ => &mut self.of_modulus,
            };
            *worst = worst.max(of_modulus);
        }
    }
}
