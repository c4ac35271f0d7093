//! Lag or lead: the paper's readings of the place of wear beside the exact contact, which needs none.

use std::fmt::Write as _;
use std::sync::LazyLock;

use riffel::Ridge;
use riffel::growth::RidgePoint;

use crate::Row;
use crate::ground::{extent, nominal, ridge, ridge_at};

/// Tractive ratios of the comparison.
pub const TRACTIVE_RATIOS: [f64; 3] = [0.1, 0.6, 0.95];

/// Speed of single values \[m/s\].
pub const SPEED: f64 = 30.0;

/// Name and overrides of each contact over the nominal case; the exact one comes last.
const CONTACTS: [(&str, &str); 4] = [
    ("quasi-static, `lag`", "contact.dissipation_phase=lag"),
    ("quasi-static, `none`", "contact.dissipation_phase=none"),
    ("quasi-static, `lead`", "contact.dissipation_phase=lead"),
    ("**non-steady, exact**", "contact.response=non-steady"),
];

/// The ridge of one contact at one tractive ratio, wavelengths of 20–80 mm and speeds of 5–60 m/s.
pub struct Reading {
    /// The contact, in Markdown.
    pub contact: &'static str,
    /// Tractive ratio τ \[-\].
    pub tractive_ratio: f64,
    /// The ridge, a point every half metre per second.
    pub ridge: Ridge,
    /// The ridge at [`SPEED`].
    pub at_speed: RidgePoint,
}

impl Reading {
    /// Frequency of the ray that fits the ridge best \[Hz\]; not a number without growth.
    pub fn frequency(&self) -> f64 {
        self.ridge.best_fit_frequency().unwrap_or(f64::NAN)
    }

    /// The smallest Re Ŵ₁ \[-\].
    pub fn least_dissipation(&self) -> f64 {
        let points = self.ridge.points.iter();
        extent(points.map(|point| point.normalized_dissipation)).0
    }

    /// The lowest speed at which anything grows \[m/s\].
    pub fn lowest_speed(&self) -> f64 {
        let mut points = self.ridge.points.iter();
        let growing = points.find(|point| point.normalized_dissipation < 0.0);
        growing.map_or(f64::NAN, |point| point.speed)
    }
}

/// Every contact at every tractive ratio, contact by contact.
pub static READINGS: LazyLock<Vec<Reading>> = LazyLock::new(|| {
    let reading = |(contact, assignment): (&'static str, &str), tractive_ratio: f64| {
        let ratio = format!("contact.tractive_ratio={tractive_ratio}");
        let case = nominal(&[assignment, &ratio]);
        Reading { contact, tractive_ratio, ridge: ridge(&case, 5.0, 60.0), at_speed: ridge_at(&case, SPEED) }
    };
    CONTACTS.iter().flat_map(|&contact| TRACTIVE_RATIOS.map(|ratio| reading(contact, ratio))).collect()
});

/// The comparison as a Markdown table.
pub fn table() -> String {
    let mut text = format!(
        "| contact | τ | best-fit frequency | λ at {SPEED} m/s | growth per passage there | Re Ŵ₁ there | least Re Ŵ₁ | grows from |\n\
         |---|---|---|---|---|---|---|---|\n"
    );
    for reading in READINGS.iter() {
        let point = reading.at_speed;
        // Writing to a string does not fail.
        let _ = writeln!(
            text,
            "| {} | {} | {:.0} Hz | {:.1} mm | {:.2}·10⁻⁶ | {:.4} | {:.3} | {:.1} m/s |",
            reading.contact,
            reading.tractive_ratio,
            reading.frequency(),
            1e3 * point.wavelength,
            1e6 * point.growth_rate,
            point.normalized_dissipation,
            reading.least_dissipation(),
            reading.lowest_speed(),
        );
    }
    text
}

// Long: compares every reading of the lag with the exact contact.
pub(crate) fn lag_is_nearest_to_the_exact_contact() -> Row {
    let count = TRACTIVE_RATIOS.len();
    let (readings, exact) = READINGS.split_at(READINGS.len() - count);
    // Distance of frequency and of growth at one speed, from the exact contact at the same ratio.
    let distances: Vec<[f64; 2]> = readings
        .iter()
        .zip(exact.iter().cycle())
        .map(|(reading, exact)| {
            let growth = |reading: &Reading| reading.at_speed.normalized_dissipation;
            [reading.frequency() / exact.frequency() - 1.0, growth(reading) / growth(exact) - 1.0]
        })
        .collect();
    let of = |contact: usize, quantity: usize| {
        let rows = &distances[contact * count..][..count];
        extent(rows.iter().map(|row| row[quantity]))
    };
    let words = |(low, high): (f64, f64)| format!("{:+.0} … {:+.0} %", 100.0 * low, 100.0 * high);
    Row {
        statement: "Of the three readings of the place of wear, `lag` is nearest to the exact non-steady contact: \
                    frequency of the ridge and Ŵ₁ at 30 m/s, τ = 0.1, 0.6, 0.95",
        source: "Kalker's theory, which resolves the patch",
        expected: "0 %".to_owned(),
        got: format!(
            "`lag` {} and {}, `none` {} and {}, `lead` {} and {}",
            words(of(0, 0)),
            words(of(0, 1)),
            words(of(1, 0)),
            words(of(1, 1)),
            words(of(2, 0)),
            words(of(2, 1)),
        ),
        tolerance: "15 % of the frequency for `lag`, at least 20 % and 40 % for `none` and `lead`: the distance of a \
                    quasi-static contact at 3–13 semi-axes",
        holds: of(0, 0).0.abs().max(of(0, 0).1.abs()) < 0.15 && of(1, 0).0 > 0.2 && of(2, 0).0 > 0.4,
    }
}
