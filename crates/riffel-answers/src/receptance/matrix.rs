//! Track and wheel along all axes over frequency.

use std::f64::consts::TAU;

use riffel::Complex64;
use riffel_case::Case;
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure, LinePanel, Scale, Series};
use serde::Serialize;

use crate::complex::as_matrices;
use crate::parameters::parameters;
use crate::{Answer, Column, Rows, Table};

const AXES: [&str; 3] = ["x", "y", "z"];

/// Receptance matrices of track and wheel at the contact under study, axes x, y, z of the track: serialised, what
/// `riffel receptance --matrix --json` prints.
#[derive(Serialize)]
pub struct MatrixAnswer {
    frequency_hz: Vec<f64>,
    /// By frequency.
    #[serde(rename = "track_receptance_matrix_m_per_n", serialize_with = "as_matrices")]
    track: Vec<[[Complex64; 3]; 3]>,
    /// By frequency.
    #[serde(rename = "wheel_receptance_matrix_m_per_n", serialize_with = "as_matrices")]
    wheel: Vec<[[Complex64; 3]; 3]>,
    #[serde(skip)]
    case: Case,
}

impl MatrixAnswer {
    /// The matrices at frequencies \[Hz\], under a load that travels at the speed \[m/s\].
    ///
    /// # Errors
    /// [`CaseError`] where the track is not known at a frequency, and for a wheel without inertia, which no receptance
    /// tells.
    pub fn new(case: &Case, speed: f64, frequencies: Vec<f64>) -> Result<Self, CaseError> {
        let ends = frequencies
            .iter()
            .fold([f64::INFINITY, 0.0], |[low, high], &frequency| [frequency.min(low), frequency.max(high)]);
        case.check_frequencies(ends[0], ends[1])?;
        let matrices = frequencies.iter().map(|frequency| {
            let matrices = case.feedback.receptances(TAU * frequency, speed);
            matrices.ok_or_else(|| {
                let message = "`wheel.rotation` is \"constant-tangential-force\", a wheel without inertia: no receptance tells it";
                case.refuse("wheel.rotation", message)
            })
        });
        let matrices: Vec<_> = matrices.collect::<Result<_, _>>()?;
        let of = |body: usize| matrices.iter().map(|pair| pair[body]).collect();
        Ok(Self { track: of(0), wheel: of(1), frequency_hz: frequencies, case: case.clone() })
    }
}

impl Answer for MatrixAnswer {
    fn name(&self) -> &'static str {
        "matrix"
    }

    /// One row for each frequency, the entries of both bodies on and above the diagonal.
    fn tables(&self) -> Vec<Table> {
        let mut columns = vec![self.frequency_hz.exact("frequency_hz", |&value| value)];
        for (body, matrices) in [("track", &self.track), ("wheel", &self.wheel)] {
            for (row, column) in upper() {
                let name = format!("{body}_{}{}_m_per_n", AXES[row], AXES[column]);
                columns.extend(Column::complex(&name, matrices.iter().map(|matrix| matrix[row][column])));
            }
        }
        vec![Table { name: "matrix", columns }]
    }

    /// Moduli of the entries that are not zero.
    fn figure(&self) -> LineFigure {
        let panel = |subtitle: &str, matrices: &[[[Complex64; 3]; 3]]| {
            LinePanel::new(
                "frequency f [Hz]",
                "|H| [m/N]",
                upper()
                    .map(|(row, column)| {
                        Series::new(
                            format!("{}{}", AXES[row], AXES[column]),
                            self.frequency_hz.clone(),
                            matrices.iter().map(|matrix| matrix[row][column].norm()).collect(),
                        )
                    })
                    .filter(|series| series.y.iter().any(|&modulus| modulus > 0.0)),
            )
            .titled(subtitle)
            .scaled(Scale::Log, Scale::Log)
        };
        LineFigure::new(
            "Receptances at the contact, all axes",
            format!(
                "x along the rail, y to the right, z downward; displacement per force, exp(+iωt). {}",
                parameters(&self.case)
            ),
            [panel("track", &self.track), panel("wheel", &self.wheel)],
        )
        .arranged(Arrangement::Stacked)
    }

    fn remarks(&self) -> &[Message] {
        &self.case.remarks
    }
}

/// Rows and columns on and above the diagonal.
fn upper() -> impl Iterator<Item = (usize, usize)> {
    (0..3).flat_map(|row| (row..3).map(move |column| (row, column)))
}
