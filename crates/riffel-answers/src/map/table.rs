//! Growth maps as files of numbers.

use std::io::{self, Write};

use riffel::growth::RidgePoint;
use riffel::{Complex64, GrowthMap, Ridge};
use riffel_case::Case;
use riffel_keys::{Message, say};

use crate::netcdf::{Grid, Variable};
use crate::number_alone;
use crate::{Rows, Table};

/// A quantity of every point of a map.
struct MapOutput {
    /// Its column in the table.
    column: &'static str,
    /// Its variable on the grid.
    variable: &'static str,
    /// What it is.
    long_name: &'static str,
    /// From Ŵ₁ and the growth rate that belongs to Ŵ₁ = 1.
    value: fn(Complex64, f64) -> f64,
}

/// What a map gives at every point, all without dimension. A new output is an entry here.
const OUTPUTS: [MapOutput; 3] = [
    MapOutput {
        column: "normalized_dissipation_re",
        variable: "normalized_dissipation_re",
        long_name: "real part of W1/(mu P0 V xi0), growth where negative",
        value: |dissipation, _| dissipation.re,
    },
    MapOutput {
        column: "normalized_dissipation_im",
        variable: "normalized_dissipation_im",
        long_name: "imaginary part of W1/(mu P0 V xi0)",
        value: |dissipation, _| dissipation.im,
    },
    MapOutput {
        column: "growth_rate_per_passage",
        variable: "growth_rate",
        long_name: "growth rate of the amplitude per passage of a wheel",
        value: |dissipation, rate| rate * dissipation.re,
    },
];

/// One row for each point of the map; `progress` is told of each speed that is written.
///
/// # Errors
/// Errors of the file.
pub fn map_csv(map: &GrowthMap, file: &mut impl Write, progress: impl Fn(usize)) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let outputs = OUTPUTS.iter().map(|output| output.column);
    writer.write_record(["wavelength_m", "speed_m_per_s"].into_iter().chain(outputs))?;
    let wavelengths = map.wavelength().values();
    let rate = map.growth_rate_per_dissipation();
    for (speed, row) in map.rows() {
        for (wavelength, &value) in wavelengths.iter().zip(row) {
            writer.serialize((wavelength, speed, OUTPUTS.map(|output| (output.value)(value, rate))))?;
        }
        progress(1);
    }
    writer.flush()
}

/// The map on its grid with coordinates, units and long names.
pub(super) fn grid(map: &GrowthMap, title: String) -> Grid<'_> {
    let rate = map.growth_rate_per_dissipation();
    let axis = |name, axes, unit, long_name, axis: riffel::Axis| {
        let values = axis.values();
        Variable::new(name, axes, unit, long_name, move || values.clone())
    };
    let mut variables = vec![
        axis("wavelength", &["wavelength"], "m", "wavelength of the corrugation", map.wavelength()),
        axis("speed", &["speed"], "m/s", "speed of the vehicle", map.speed()),
    ];
    variables.extend(OUTPUTS.iter().map(|output| {
        Variable::new(output.variable, &["speed", "wavelength"], "1", output.long_name, move || {
            let points = map.rows().flat_map(|(_, row)| row);
            points.map(|&value| (output.value)(value, rate)).collect()
        })
    }));
    let axes = vec![("speed", map.speed().points()), ("wavelength", map.wavelength().points())];
    Grid { title, axes, variables }
}

/// The ridge at a few speeds, for a reader.
pub(super) fn shown(case: &Case, ridge: &Ridge) -> Table {
    /// Rows of the table.
    const ROWS: usize = 9;
    let last = ridge.points.len().saturating_sub(1);
    let rows = ROWS.min(ridge.points.len());
    // As many digits as tell the rows apart.
    let step = 3.6 * (case.speed.max() - case.speed.min()) / rows as f64;
    let digits = (1.0 - step.log10()).floor().clamp(0.0, 3.0) as usize;
    let points: Vec<&RidgePoint> = (0..rows).map(|row| &ridge.points[row * last / (rows - 1).max(1)]).collect();
    Table {
        name: "ridge",
        columns: vec![
            points.digits(say!(speed_column), digits, |point| 3.6 * point.speed),
            points.digits(say!(wavelength_of_band), 1, |point| 1e3 * point.wavelength),
            points.digits(say!(frequency_in_hertz), 0, |point| point.frequency),
            points.digits(Message::verbatim("Re Ŵ₁"), 4, |point| point.normalized_dissipation),
            points.numbers(say!(growth_rate_per_passage_column), |point| format!("{:.2e}", point.growth_rate)),
            points.shown(say!(passages_to_double_column), |point| match point.growth_rate > 0.0 {
                true => number_alone(format_args!("{:.1e}", std::f64::consts::LN_2 / point.growth_rate)),
                false => say!(decays_in_table),
            }),
            points.shown(Message::verbatim(""), |point| match point.at_edge {
                true => say!(edge_in_table),
                false => Message::verbatim(""),
            }),
        ],
    }
}
