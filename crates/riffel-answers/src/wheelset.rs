//! The wheelset of a case: natural frequencies, mode shapes, receptances at the contacts.

use std::f64::consts::TAU;
use std::io::{self, Write};
use std::sync::Arc;

use riffel::Direction;
use riffel::wheelset::{BendingPlane, ContactReceptances, ModeName, Port, Wheelset};
use riffel_case::{Case, CaseWheelset, WheelsetMode};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};
use serde::Serialize;

use crate::mode_in_words;
use crate::parameters::parameters;

/// Up to which natural frequencies are listed \[Hz\].
pub const HIGHEST: f64 = 2000.0;

/// Shapes drawn of each kind of motion, the lowest.
const DRAWN: usize = 4;

/// Points along the axle in a picture.
const ALONG: usize = 121;

/// The wheelset of a case over frequency.
pub struct WheelsetAnswer {
    wheelset: Arc<CaseWheelset>,
    /// Natural frequencies up to [`HIGHEST`], lowest first.
    pub modes: Vec<WheelsetMode>,
    /// \[Hz\].
    pub frequencies: Vec<f64>,
    /// Receptances at the contacts \[m/N\], by frequency.
    pub receptances: Vec<ContactReceptances>,
}

/// What `riffel wheelset --json` prints.
#[derive(Serialize)]
pub struct WheelsetDocument {
    natural_frequencies: Vec<NaturalFrequency>,
    frequency_hz: Vec<f64>,
    receptance_m_per_n: Vec<[[[f64; 2]; 6]; 6]>,
}

#[derive(Serialize)]
struct NaturalFrequency {
    frequency_hz: f64,
    name: Message,
}

impl WheelsetAnswer {
    /// The wheelset at frequencies \[Hz\].
    ///
    /// # Errors
    /// [`CaseError`] for a case without a wheelset, and for frequencies at which a measured one is not known.
    pub fn new(case: &Case, frequencies: Vec<f64>) -> Result<Self, CaseError> {
        let wheelset = case.wheelset.clone().ok_or_else(|| {
            let message = "`wheelset` is missing: a lone wheel has no axle; give [wheelset] with its model";
            case.refuse("wheelset", message)
        })?;
        let ends = frequencies.iter();
        let ends = ends
            .fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], &frequency| [low.min(frequency), high.max(frequency)]);
        case.check_wheelset_frequencies(ends[0], ends[1])?;
        let modes = case.wheelset_modes(&wheelset, HIGHEST)?;
        let receptances = frequencies.iter();
        Ok(Self {
            receptances: receptances.map(|frequency| wheelset.receptances(TAU * frequency)).collect(),
            wheelset,
            modes,
            frequencies,
        })
    }

    /// Natural frequencies and receptances as data: what `riffel wheelset --json` prints.
    pub fn document(&self) -> WheelsetDocument {
        let modes = self.modes.iter();
        let receptances = self.receptances.iter();
        WheelsetDocument {
            natural_frequencies: modes
                .map(|mode| NaturalFrequency { frequency_hz: mode.frequency, name: mode_in_words(&mode.name) })
                .collect(),
            frequency_hz: self.frequencies.clone(),
            receptance_m_per_n: receptances
                .map(|matrix| matrix.map(|row| row.map(|entry| [entry.re, entry.im])))
                .collect(),
        }
    }

    /// One row for each natural frequency.
    ///
    /// # Errors
    /// Those of the file.
    pub fn modes_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["frequency_hz", "name"])?;
        for mode in &self.modes {
            writer.serialize((mode.frequency, mode.name.to_string()))?;
        }
        writer.flush()
    }

    /// One row for each frequency, the entries on and above the diagonal.
    ///
    /// # Errors
    /// Those of the file.
    pub fn receptances_csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let entries = || (0..6).flat_map(|row| (row..6).map(move |column| (row, column)));
        let mut header = vec!["frequency_hz".to_owned()];
        for (row, column) in entries() {
            let entry = format!("{}_{}_m_per_n", key(Port::ALL[row]), key(Port::ALL[column]));
            header.extend(["re", "im"].map(|part| format!("{entry}_{part}")));
        }
        writer.write_record(&header)?;
        for (frequency, matrix) in self.frequencies.iter().zip(&self.receptances) {
            let mut values = vec![*frequency];
            let entries = entries().map(|(row, column)| matrix[row][column]);
            values.extend(entries.flat_map(|entry| [entry.re, entry.im]));
            writer.serialize(values)?;
        }
        writer.flush()
    }

    /// Moduli at one contact over frequency.
    pub fn figure(&self, case: &Case) -> LineFigure {
        let entries = [
            ("along the rail, xx", 3, 3),
            ("across the track, yy", 4, 4),
            ("downward, zz", 5, 5),
            ("across by downward, yz", 4, 5),
        ];
        let series = entries.into_iter().map(|(label, row, column)| Series {
            label: label.to_owned(),
            x: self.frequencies.clone(),
            y: self.receptances.iter().map(|matrix| matrix[row][column].norm()).collect(),
            style: match row == column {
                true => LineStyle::Solid,
                false => LineStyle::Dashed,
            },
            color: None,
        });
        LineFigure {
            title: "Wheelset at its contacts".to_owned(),
            caption: format!("Displacement per force at the right contact, exp(+iωt). {}", parameters(case)),
            panels: vec![LinePanel {
                x_label: "frequency f [Hz]".to_owned(),
                y_label: "|H| [m/N]".to_owned(),
                x_scale: Scale::Log,
                y_scale: Scale::Log,
                series: series.collect(),
                ..LinePanel::default()
            }],
            arrangement: Arrangement::Stacked,
        }
    }

    /// Shapes of the lowest modes along the axle, bending and torsion; none where there is no model of an axle.
    pub fn shapes(&self) -> Option<LineFigure> {
        let CaseWheelset::Flexible(flexible) = &*self.wheelset else {
            return None;
        };
        let half = 0.5 * flexible.axle().length();
        let places: Vec<f64> = (0..ALONG).map(|index| half * (2.0 * index as f64 / (ALONG - 1) as f64 - 1.0)).collect();
        let panel = |subtitle: &str, wanted: fn(&ModeName) -> bool, torsion: bool| {
            let modes = self.modes.iter().filter(|mode| wanted(&mode.name));
            let series = modes.take(DRAWN).filter_map(|mode| {
                let shape = mode.shape.as_ref()?;
                let motion = |&place: &f64| {
                    let motion = shape.motion_at(place);
                    match torsion {
                        true => motion.rotation[1],
                        false => motion.displacement[2] + motion.displacement[0],
                    }
                };
                let values: Vec<f64> = places.iter().map(motion).collect();
                let largest = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
                Some(Series {
                    label: format!("{:.1} Hz {}", mode.frequency, mode.name),
                    x: places.clone(),
                    y: values.iter().map(|value| value / largest).collect(),
                    ..Series::default()
                })
            });
            LinePanel {
                subtitle: subtitle.to_owned(),
                x_label: "place along the axle y [m]".to_owned(),
                y_label: "over its largest value [-]".to_owned(),
                x_scale: Scale::Linear,
                y_scale: Scale::Linear,
                series: series.collect(),
                ..LinePanel::default()
            }
        };
        let bends = |name: &ModeName| {
            matches!(name, ModeName::Bending { plane: BendingPlane::Both | BendingPlane::Vertical, .. })
        };
        Some(LineFigure {
            title: "Mode shapes of the wheelset".to_owned(),
            caption:
                "Displacement of the axle in bending, its angle in torsion; without loss and damping, not rotating."
                    .to_owned(),
            panels: vec![
                panel("bending", bends, false),
                panel("torsion", |name| matches!(name, ModeName::Torsion { .. }), true),
            ],
            arrangement: Arrangement::Stacked,
        })
    }
}

/// A port in the heads of tables.
fn key(port: Port) -> String {
    let rail = port.rail.name();
    let axis = match port.direction {
        Direction::Longitudinal => "x",
        Direction::Lateral => "y",
        Direction::Vertical => "z",
    };
    format!("{rail}_{axis}")
}
