//! Track and wheel along all axes over frequency.

use std::f64::consts::TAU;
use std::io::{self, Write};

use riffel::Complex64;
use riffel_case::Case;
use riffel_keys::CaseError;
use riffel_plot::{Arrangement, LineFigure, LinePanel, Scale, Series};
use serde::Serialize;

use crate::parameters::parameters;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Receptance matrices of track and wheel at the contact under study, axes x, y, z of the track.
pub struct MatrixAnswer {
    /// \[Hz\].
    pub frequencies: Vec<f64>,
    /// Of the track \[m/N\], by frequency.
    pub track: Vec<[[Complex64; 3]; 3]>,
    /// Of the wheel \[m/N\], by frequency.
    pub wheel: Vec<[[Complex64; 3]; 3]>,
}

/// What `riffel receptance --matrix --json` prints.
#[derive(Serialize)]
pub struct MatrixDocument {
    frequency_hz: Vec<f64>,
    track_receptance_matrix_m_per_n: Vec<[[[f64; 2]; 3]; 3]>,
    wheel_receptance_matrix_m_per_n: Vec<[[[f64; 2]; 3]; 3]>,
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
        Ok(Self { track: of(0), wheel: of(1), frequencies })
    }

    /// The matrices as data.
    pub fn document(&self) -> MatrixDocument {
        let pairs = |matrices: &[[[Complex64; 3]; 3]]| {
            let matrices = matrices.iter();
            matrices.map(|matrix| matrix.map(|row| row.map(|entry| [entry.re, entry.im]))).collect()
        };
        MatrixDocument {
            frequency_hz: self.frequencies.clone(),
            track_receptance_matrix_m_per_n: pairs(&self.track),
            wheel_receptance_matrix_m_per_n: pairs(&self.wheel),
        }
    }

    /// One row for each frequency, the entries of both bodies on and above the diagonal.
    ///
    /// # Errors
    /// Those of the file.
    pub fn csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = vec!["frequency_hz".to_owned()];
        for body in ["track", "wheel"] {
            for (row, column) in upper() {
                let entry = format!("{body}_{}{}_m_per_n", AXES[row], AXES[column]);
                header.extend(["re", "im"].map(|part| format!("{entry}_{part}")));
            }
        }
        writer.write_record(&header)?;
        for (index, &frequency) in self.frequencies.iter().enumerate() {
            let mut values = vec![frequency];
            for matrix in [&self.track[index], &self.wheel[index]] {
                let entries = upper().map(|(row, column)| matrix[row][column]);
                values.extend(entries.flat_map(|entry| [entry.re, entry.im]));
            }
            writer.serialize(values)?;
        }
        writer.flush()
    }

    /// Moduli of the entries that are not zero.
    pub fn figure(&self, case: &Case) -> LineFigure {
        let panel = |subtitle: &str, matrices: &[[[Complex64; 3]; 3]]| LinePanel {
            subtitle: subtitle.to_owned(),
            x_label: "frequency f [Hz]".to_owned(),
            y_label: "|H| [m/N]".to_owned(),
            x_scale: Scale::Log,
            y_scale: Scale::Log,
            series: upper()
                .map(|(row, column)| Series {
                    label: format!("{}{}", AXES[row], AXES[column]),
                    x: self.frequencies.clone(),
                    y: matrices.iter().map(|matrix| matrix[row][column].norm()).collect(),
                    ..Series::default()
                })
                .filter(|series| series.y.iter().any(|&modulus| modulus > 0.0))
                .collect(),
            ..LinePanel::default()
        };
        LineFigure {
            title: "Receptances at the contact, all axes".to_owned(),
            caption: format!(
                "x along the rail, y to the right, z downward; displacement per force, exp(+iωt). {}",
                parameters(case)
            ),
            panels: vec![panel("track", &self.track), panel("wheel", &self.wheel)],
            arrangement: Arrangement::Stacked,
        }
    }
}

/// Rows and columns on and above the diagonal.
fn upper() -> impl Iterator<Item = (usize, usize)> {
    (0..3).flat_map(|row| (row..3).map(move |column| (row, column)))
}
