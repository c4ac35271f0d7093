//! The joints of a case over frequency.

mod curves;
mod matrix;
mod question;
mod words;

use std::cell::OnceCell;
use std::f64::consts::TAU;

use riffel::receptance::{DecayRate, MassOnRail, Resonance, ResonanceKind};
use riffel::{Complex64, Direction};
use riffel_case::{Case, Track, ask};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Mark, Scale, Series};
use serde::{Serialize, Serializer};

pub use curves::{ReceptanceCurve, ReceptanceCurves};
pub use matrix::MatrixAnswer;
pub use question::ReceptanceQuestion;

use crate::complex::pairs;
use crate::parameters::parameters;
use crate::{Answer, Column, ResultFile, Rows, Table};

/// What is asked of the receptances of a case.
#[derive(Debug, Clone)]
pub struct ReceptanceRequest {
    /// Direction of force and displacement.
    pub direction: Direction,
    /// Speed of the load \[m/s\].
    pub speed: f64,
    /// \[Hz\].
    pub frequencies: Vec<f64>,
}

/// The joints of a case over frequency, with the resonances of its track: serialised, what `riffel receptance --json` prints.
#[derive(Serialize)]
pub struct ReceptanceAnswer {
    frequency_hz: Vec<f64>,
    /// Lowest first.
    resonances: Vec<NamedResonance>,
    /// Of P2 vertically, as a check; of a model of the track.
    #[serde(skip_serializing_if = "Option::is_none")]
    p2_closed_form: Option<ClosedForm>,
    /// Across the track, where the rail moves so in the loop.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    lateral_resonances: Vec<LateralResonance>,
    #[serde(flatten, serialize_with = "by_joint")]
    joints: Vec<ReceptanceCurve>,
    #[serde(skip)]
    places: Vec<ReceptanceCurve>,
    /// In the direction asked for.
    #[serde(skip)]
    track: Track,
    #[serde(skip)]
    case: Case,
    #[serde(skip)]
    speed: f64,
    #[serde(skip)]
    direction: Direction,
    /// Only files and words tell it.
    #[serde(skip)]
    decay: OnceCell<Option<Vec<DecayRate>>>,
}

/// One that is known by its frequency alone, without damping.
#[derive(Serialize)]
struct LateralResonance {
    #[serde(rename = "resonance", serialize_with = "name")]
    kind: ResonanceKind,
    frequency_hz: f64,
}

/// P2 of the unsprung mass on the static shape of the rail.
#[derive(Serialize)]
struct ClosedForm {
    frequency_hz: f64,
    unsprung_mass_kg: f64,
    track_mass_kg: f64,
    stiffness_n_per_m: f64,
}

impl From<MassOnRail> for ClosedForm {
    fn from(closed: MassOnRail) -> Self {
        Self {
            frequency_hz: closed.angular_frequency() / TAU,
            unsprung_mass_kg: closed.mass,
            track_mass_kg: closed.track_mass,
            stiffness_n_per_m: closed.stiffness,
        }
    }
}

/// One resonance; damping and resolution where the receptance has no model.
#[derive(Serialize)]
struct NamedResonance {
    #[serde(rename = "resonance", serialize_with = "name")]
    kind: ResonanceKind,
    frequency_hz: f64,
    receptance_m_per_n: [f64; 2],
    damping_ratio: Option<f64>,
    resolution_hz: Option<f64>,
}

fn name<S: Serializer>(kind: &ResonanceKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(kind)
}

fn by_joint<S: Serializer>(joints: &[ReceptanceCurve], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(joints.iter().map(|joint| (joint.key, pairs(&joint.values))))
}

impl From<Resonance> for NamedResonance {
    fn from(resonance: Resonance) -> Self {
        Self {
            kind: resonance.kind,
            frequency_hz: resonance.angular_frequency / TAU,
            receptance_m_per_n: [resonance.receptance.re, resonance.receptance.im],
            damping_ratio: resonance.damping_ratio,
            resolution_hz: resonance.resolution.map(|resolution| resolution / TAU),
        }
    }
}

impl NamedResonance {
    fn modulus(&self) -> f64 {
        let [re, im] = self.receptance_m_per_n;
        Complex64::new(re, im).norm()
    }
}

impl ReceptanceAnswer {
    /// The receptances asked for.
    ///
    /// # Errors
    /// [`CaseError`] where the case lacks a value for the direction, its model has no such direction, or the track is
    /// not known at a frequency.
    pub fn new(case: &Case, request: ReceptanceRequest) -> Result<Self, CaseError> {
        let ReceptanceRequest { direction, speed, frequencies } = request;
        let track = case.track_in(direction)?;
        if let (Some(from), Some(to)) = (frequencies.first(), frequencies.last()) {
            case.check_frequencies(*from, *to)?;
        }
        let curves = ReceptanceCurves::new(case, &track, direction, speed, frequencies);
        let ReceptanceCurves { frequencies, joints, places } = curves;
        let resonances = match direction {
            Direction::Vertical => ask::resonances(case),
            _ => track.resonances(),
        };
        let closed = (direction == Direction::Vertical).then(|| ask::p2_closed_form(case)).flatten();
        let lateral = case.lateral_resonances.iter();
        let lateral = lateral.map(|(kind, w)| LateralResonance { kind: *kind, frequency_hz: w / TAU });
        Ok(Self {
            frequency_hz: frequencies,
            resonances: resonances.into_iter().map(NamedResonance::from).collect(),
            p2_closed_form: closed.map(ClosedForm::from),
            lateral_resonances: lateral.collect(),
            joints,
            places,
            track,
            case: case.clone(),
            speed,
            direction,
            decay: OnceCell::new(),
        })
    }

    /// Decay rates in one-third octaves; none for a rail without support, which hardly decays, and where supports are
    /// not known.
    fn decay(&self) -> Option<&[DecayRate]> {
        let rates = || {
            let structure = self.track.structure.as_deref();
            let structure = structure.filter(|_| self.track.support.is_some());
            structure.map(DecayRate::of_track)
        };
        self.decay.get_or_init(rates).as_deref()
    }

    /// One row for each frequency.
    fn curves(&self) -> Table {
        let frequency = self.frequency_hz.exact("frequency_hz", |&value| value);
        let curves = self.joints.iter().chain(&self.places);
        let curves = curves.flat_map(|curve| Column::complex(curve.key, curve.values.iter().copied()));
        Table { name: "receptance", columns: [frequency].into_iter().chain(curves).collect() }
    }

    /// Decay rates over frequency.
    fn decay_figure(&self, rates: &[DecayRate]) -> LineFigure {
        LineFigure::new(
            "Track decay rate",
            format!("One-third octaves of EN 15461, force in mid-span. {}", parameters(&self.case)),
            [LinePanel::new(
                "frequency f [Hz]",
                "decay rate [dB/m]",
                [Series::new(
                    "",
                    rates.iter().map(|rate| rate.nominal_frequency).collect(),
                    rates.iter().map(|rate| rate.decay_rate).collect(),
                )],
            )
            .scaled(Scale::Log, Scale::Log)],
        )
        .arranged(Arrangement::Stacked)
    }

    /// Discrete supports show the rail at both of its typical places instead of at one.
    fn drawn(&self) -> Vec<&ReceptanceCurve> {
        let Self { joints, places, .. } = self;
        let rail = match places.is_empty() {
            true => &joints[..1],
            false => &places[..],
        };
        rail.iter().chain(&joints[1..]).collect()
    }
}

impl Answer for ReceptanceAnswer {
    fn name(&self) -> &'static str {
        "receptance"
    }

    fn introduction(&self) -> Vec<Message> {
        words::introduction(self)
    }

    fn tables(&self) -> Vec<Table> {
        let decay = self.decay().map(words::decay);
        [self.curves(), words::resonances(self)].into_iter().chain(decay).collect()
    }

    fn sentences(&self) -> Vec<Message> {
        words::sentences(self)
    }

    /// Modulus and phase over frequency, resonances marked.
    fn figure(&self) -> LineFigure {
        // Names stand in the first panel only.
        let panel = |named: bool, y_label: &str, y_scale, value: fn(Complex64) -> f64| LinePanel {
            marks: self.resonances.iter().map(|resonance| mark(resonance, named)).collect(),
            ..LinePanel::new(
                "frequency f [Hz]",
                y_label,
                self.drawn().into_iter().map(|curve| {
                    Series::new(
                        if named { curve.label.to_owned() } else { String::new() },
                        self.frequency_hz.clone(),
                        curve.values.iter().map(|&receptance| value(receptance)).collect(),
                    )
                    .styled(style(curve))
                }),
            )
            .scaled(Scale::Log, y_scale)
        };
        let (title, force) = match self.direction {
            Direction::Vertical => ("Receptances at the contact", "both downward"),
            Direction::Lateral => ("Lateral receptance of the rail", "both across the track"),
            Direction::Longitudinal => ("Receptance along the rail", "both along the rail"),
        };
        LineFigure::new(
            title,
            format!(
                "Displacement per force, {force}, exp(+iωt), load at {:.1} m/s. {}",
                self.speed,
                parameters(&self.case)
            ),
            [
                panel(true, "|H| [m/N]", Scale::Log, |h| h.norm()),
                panel(false, "arg H [°]", Scale::Linear, |h| {
                    // −180 … 0°: a passive structure never leads; −0.0 turns a real negative H to −180°.
                    let degrees = h.arg().to_degrees();
                    if degrees > 90.0 { degrees - 360.0 } else { degrees }
                }),
            ],
        )
        .arranged(Arrangement::Stacked)
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let picture = self.decay().map(|rates| ResultFile::Picture("decay-rate", self.decay_figure(rates)));
        let own = ResultFile::Lines(self.name(), self.figure());
        [own].into_iter().chain(ResultFile::tables(self.tables())).chain(picture).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.case.remarks
    }
}

/// The rail and the sum of all are solid.
fn style(curve: &ReceptanceCurve) -> LineStyle {
    match curve.key {
        "wheel_m_per_n" => LineStyle::Dashed,
        "contact_m_per_n" => LineStyle::Dotted,
        _ => LineStyle::Solid,
    }
}

fn mark(resonance: &NamedResonance, named: bool) -> Mark {
    let frequency = resonance.frequency_hz;
    let name = match resonance.kind {
        ResonanceKind::MeasuredPeak | ResonanceKind::FunctionPeak => "peak".to_owned(),
        ResonanceKind::MeasuredDip | ResonanceKind::FunctionDip => "dip".to_owned(),
        kind => kind.to_string(),
    };
    Mark {
        x: frequency,
        label: if named {
            // In a picture the index of P2 is one.
            format!("{} {frequency:.0} Hz", name.replace("P2", "P₂"))
        } else {
            String::new()
        },
    }
}
