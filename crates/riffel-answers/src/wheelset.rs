//! The wheelset of a case: natural frequencies, mode shapes, receptances at the contacts.

use std::f64::consts::TAU;
use std::sync::Arc;

use riffel::Direction;
use riffel::wheelset::{BendingPlane, ContactReceptances, ModeName, Port, Wheelset};
use riffel_case::{Case, CaseWheelset, WheelsetMode, ask};
use riffel_keys::quantity::Frequency;
use riffel_keys::{CaseError, Message, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};

use crate::answer::titled;
use crate::complex::as_matrices;
use crate::parameters::parameters;
use crate::question::{AsWritten, CaseSource, Client, Question};
use crate::receptance::ReceptanceCurves;
use crate::{Answer, Column, Result, ResultFile, Rows, Table, mode_in_words};

/// Up to which natural frequencies are listed \[Hz\].
pub(crate) const HIGHEST: f64 = 2000.0;

/// Frequencies of the receptances where none are listed: the lowest \[Hz\], and how many.
const USUAL: (f64, u32) = (20.0, 600);

/// Shapes drawn of each kind of motion, the lowest.
const DRAWN: usize = 4;

/// Points along the axle in a picture.
const ALONG: usize = 121;

/// The wheelset: natural frequencies with their names, mode shapes, receptances at the contacts.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct WheelsetQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Frequencies of the receptances, separated by commas, in Hz or with their unit [default: 600 from 20 Hz to
    /// 2 kHz].
    #[schemars(extend("value_name" = "LIST", "separator" = ","))]
    frequencies: Vec<AsWritten<Frequency>>,
}

impl Question for WheelsetQuestion {
    const NAME: &'static str = "wheelset";
    const EXAMPLE: &'static str = "Example: riffel wheelset case.toml --frequencies 80,250,\"1 kHz\" --json";

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let case = self.case.read(client)?;
        let frequencies = match &self.frequencies[..] {
            [] => {
                let wheelset = case.wheelset.as_ref();
                let (lowest, highest) = wheelset.map_or((0.0, f64::INFINITY), |wheelset| wheelset.frequency_range());
                ReceptanceCurves::frequencies(USUAL.0.max(lowest), HIGHEST.min(highest), USUAL.1)
            }
            listed => AsWritten::all_within(listed, "--frequencies", client)?,
        };
        Ok(Box::new(WheelsetAnswer::new(&case, frequencies)?))
    }
}

/// The wheelset of a case over frequency: serialised, what `riffel wheelset --json` prints.
#[derive(Serialize)]
pub struct WheelsetAnswer {
    /// Natural frequencies up to 2 kHz, lowest first.
    #[serde(rename = "natural_frequencies", serialize_with = "natural_frequencies")]
    pub modes: Vec<WheelsetMode>,
    frequency_hz: Vec<f64>,
    /// At the contacts, by frequency.
    #[serde(rename = "receptance_m_per_n", serialize_with = "as_matrices")]
    receptances: Vec<ContactReceptances>,
    #[serde(skip)]
    wheelset: Arc<CaseWheelset>,
    #[serde(skip)]
    case: Case,
}

#[derive(Serialize)]
struct NaturalFrequency {
    frequency_hz: f64,
    name: Message,
}

fn natural_frequencies<S: Serializer>(modes: &[WheelsetMode], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        modes.iter().map(|mode| NaturalFrequency { frequency_hz: mode.frequency, name: mode_in_words(&mode.name) }),
    )
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
        let modes = ask::wheelset_modes(case, &wheelset, HIGHEST)?;
        let receptances = frequencies.iter();
        Ok(Self {
            receptances: receptances.map(|frequency| wheelset.receptances(TAU * frequency)).collect(),
            wheelset,
            modes,
            frequency_hz: frequencies,
            case: case.clone(),
        })
    }

    /// One row for each natural frequency.
    fn natural_frequencies(&self) -> Table {
        let modes = &self.modes;
        let mut columns =
            vec![modes.exact("frequency_hz", |mode| mode.frequency), modes.names("name", |mode| &mode.name)];
        if !self.modes.is_empty() {
            columns.extend([
                modes.digits(say!(natural_frequency_column), 2, |mode| mode.frequency),
                modes.shown(say!(mode_column), |mode| mode_in_words(&mode.name)),
            ]);
        }
        Table { name: "modes", columns }
    }

    /// One row for each frequency, the entries on and above the diagonal.
    fn entries(&self) -> Table {
        let mut columns = vec![self.frequency_hz.exact("frequency_hz", |&value| value)];
        for (row, column) in (0..6).flat_map(|row| (row..6).map(move |column| (row, column))) {
            let name = format!("{}_{}_m_per_n", key(Port::ALL[row]), key(Port::ALL[column]));
            columns.extend(Column::complex(&name, self.receptances.iter().map(|matrix| matrix[row][column])));
        }
        Table { name: "receptance", columns }
    }

    /// Shapes of the lowest modes along the axle, bending and torsion; `None` if there is no model of an axle.
    fn shapes(&self) -> Option<LineFigure> {
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
                Some(Series::new(
                    format!("{:.1} Hz {}", mode.frequency, mode.name),
                    places.clone(),
                    values.iter().map(|value| value / largest).collect(),
                ))
            });
            LinePanel::new("place along the axle y [m]", "over its largest value [-]", series).titled(subtitle)
        };
        let bends = |name: &ModeName| {
            matches!(name, ModeName::Bending { plane: BendingPlane::Both | BendingPlane::Vertical, .. })
        };
        Some(
            LineFigure::new(
                "Mode shapes of the wheelset",
                "Displacement of the axle in bending, its angle in torsion; without loss and damping, not rotating.",
                [
                    panel("bending", bends, false),
                    panel("torsion", |name| matches!(name, ModeName::Torsion { .. }), true),
                ],
            )
            .arranged(Arrangement::Stacked),
        )
    }
}

impl Answer for WheelsetAnswer {
    fn name(&self) -> &'static str {
        "receptance"
    }

    fn introduction(&self) -> Vec<Message> {
        let why = || match &*self.wheelset {
            CaseWheelset::Measured(_) => say!(wheelset_was_measured),
            _ => say!(wheelset_is_rigid),
        };
        let title = titled(self.case.file.title.as_ref(), say!(wheelset_title));
        [title].into_iter().chain(self.modes.is_empty().then(why)).collect()
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.natural_frequencies(), self.entries()]
    }

    /// Moduli at one contact over frequency.
    fn figure(&self) -> LineFigure {
        let entries = [
            ("along the rail, xx", 3, 3),
            ("across the track, yy", 4, 4),
            ("downward, zz", 5, 5),
            ("across by downward, yz", 4, 5),
        ];
        let series = entries.into_iter().map(|(label, row, column)| {
            Series::new(
                label,
                self.frequency_hz.clone(),
                self.receptances.iter().map(|matrix| matrix[row][column].norm()).collect(),
            )
            .styled(match row == column {
                true => LineStyle::Solid,
                false => LineStyle::Dashed,
            })
        });
        LineFigure::new(
            "Wheelset at its contacts",
            format!("Displacement per force at the right contact, exp(+iωt). {}", parameters(&self.case)),
            [LinePanel::new("frequency f [Hz]", "|H| [m/N]", series).scaled(Scale::Log, Scale::Log)],
        )
        .arranged(Arrangement::Stacked)
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let own = ResultFile::Lines(self.name(), self.figure());
        let shapes = self.shapes().map(|shapes| ResultFile::Lines("modes", shapes));
        [own].into_iter().chain(shapes).chain(ResultFile::tables(self.tables())).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.case.remarks
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
