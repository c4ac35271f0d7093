//! A measured receptance, read from a file that the case names.

mod columns;
mod layout;
mod response_unit;
mod smoothing;
mod table;
mod universal;
mod universal_function;
mod wheelset_modes;
mod wheelset_receptances;

use std::path::Path;

use riffel::receptance::MeasuredReceptance;
use riffel::{Complex64, Receptance};
use riffel_keys::{Exponents, Message, fixed, number, say, text_file};

use crate::file::{Measurement, Response};
pub use universal_function::UniversalFunction;
pub(crate) use wheelset_modes::WheelsetModes;
pub(crate) use wheelset_receptances::WheelsetReceptances;

/// Widest step between two frequencies, as a ratio: beyond it the file says nothing of what lies
/// between.
const WIDEST_STEP: f64 = 2.0;

/// Receptances that a rail may have \[m/N\]: those of tracks under `presets/` are 1e-11 to 3e-8 from 20 Hz to 5 kHz. The
/// median of a table lies between these, or its unit is another one.
const OF_A_RAIL: (f64, f64) = (1e-14, 1e-4);

/// Receptances \[m/N\] of which every measured rail has some: those of the presets, with room for softer tracks.
const USUAL: (f64, f64) = (1e-11, 1e-7);

/// What is wrong with a measurement.
#[derive(Debug)]
pub(crate) struct MeasurementError {
    /// Key below `track.measurement` that is at fault, or whose file is; of a file of a wheelset it is always `file`.
    pub(crate) key: &'static str,
    /// The sentence.
    pub(crate) message: String,
}

impl MeasurementError {
    fn new(key: &'static str, message: impl Into<String>) -> Self {
        Self {
            key,
            message: message.into(),
        }
    }

    fn file(message: impl Into<String>) -> Self {
        Self::new("file", message)
    }
}

/// A frequency response as it stands in a file, in SI.
struct FrequencyResponse {
    response: Response,
    /// \[Hz\].
    frequencies: Vec<f64>,
    values: Vec<Complex64>,
    /// Coherence γ² of each value, if the file has it.
    coherence: Option<Vec<f64>>,
    /// Where each value stands, as "line 12".
    places: Vec<String>,
}

/// A receptance, and what the reader of the case should know of it.
pub(crate) struct Measured {
    pub(crate) receptance: MeasuredReceptance,
    pub(crate) remarks: Vec<Message>,
}

/// Read the measurement; file names are relative to `folder`.
pub(crate) fn read(measurement: &Measurement, folder: &Path) -> Result<Measured, MeasurementError> {
    let path = folder.join(&measurement.file);
    let bytes = bytes_of(&path, "measurement")?;
    let remedy = Remedy::SetKey;
    if is_universal_file(&path) {
        let universal::Chosen { response, remarks } = universal::read(&bytes, measurement)?;
        let mut measured = response.measured(measurement.conjugate, remedy)?;
        measured.remarks.splice(0..0, remarks);
        return Ok(measured);
    }
    let text = decoded(bytes)?;
    let table::Table { response, remarks } = table::read(&text, measurement)?;
    let mut measured = response.measured(measurement.conjugate, remedy)?;
    measured.remarks.splice(0..0, remarks);
    let unusual = check_size(&measured.receptance)?;
    measured.remarks.extend(unusual);
    Ok(measured)
}

fn bytes_of(path: &Path, what: &'static str) -> Result<Vec<u8>, MeasurementError> {
    text_file::read_bounded(path, what, text_file::LARGEST_RESPONSES)
        .map_err(|error| MeasurementError::file(error.to_string()))
}

fn decoded(bytes: Vec<u8>) -> Result<String, MeasurementError> {
    text_file::decode(bytes).map_err(|byte| MeasurementError::file(byte.to_string()))
}

/// A function that was read elsewhere.
pub(crate) fn of_universal(function: &UniversalFunction) -> Result<Measured, MeasurementError> {
    universal::of_function(function)?.measured(false, Remedy::Conjugate)
}

fn is_universal_file(path: &Path) -> bool {
    path.extension().is_some_and(|extension| {
        ["uff", "unv", "u58", "uf"]
            .iter()
            .any(|known| extension.eq_ignore_ascii_case(known))
    })
}

impl FrequencyResponse {
    /// Checked, as a receptance at a point; `remedy` as for [`activity`].
    fn measured(self, conjugate: bool, remedy: Remedy) -> Result<Measured, MeasurementError> {
        let mut measured = self.read(conjugate)?;
        measured
            .remarks
            .extend(activity(&measured.receptance, remedy));
        Ok(measured)
    }

    /// Checked, as a receptance between any two points.
    fn read(mut self, conjugate: bool) -> Result<Measured, MeasurementError> {
        let mut remarks = Vec::new();
        remarks.extend(self.leave_out_zero());
        self.check()?;
        let (angular, mut receptances) = self.receptances(conjugate);
        if let Some(coherence) = &self.coherence {
            remarks.extend(smoothing::smooth(&angular, &mut receptances, coherence));
        }
        let receptance = MeasuredReceptance::new(&angular, receptances)
            .map_err(|error| MeasurementError::file(error.to_string()))?;
        Ok(Measured {
            receptance,
            remarks,
        })
    }

    /// A Fourier transform begins at 0 Hz, where mobility and accelerance are zero whatever the receptance is, and
    /// which has no place on a logarithmic axis.
    fn leave_out_zero(&mut self) -> Option<Message> {
        if self.frequencies.first() != Some(&0.0) {
            return None;
        }
        self.frequencies.remove(0);
        self.values.remove(0);
        self.places.remove(0);
        if let Some(coherence) = &mut self.coherence {
            coherence.remove(0);
        }
        Some(say!(value_at_zero_left_out))
    }

    /// Frequencies positive, rising and without gaps, values finite.
    fn check(&self) -> Result<(), MeasurementError> {
        let mut before: Option<f64> = None;
        for ((&frequency, value), place) in
            self.frequencies.iter().zip(&self.values).zip(&self.places)
        {
            let wrong = |rule: String| Err(MeasurementError::file(format!("{place}: {rule}")));
            if !frequency.is_finite() || !value.is_finite() {
                return wrong("a value is not finite".to_owned());
            }
            if frequency <= 0.0 {
                return wrong(format!(
                    "the frequency is {frequency} Hz, but must be greater than zero"
                ));
            }
            if let Some(before) = before {
                if frequency == before {
                    return wrong(format!("the frequency {frequency} Hz is there twice"));
                }
                if frequency < before {
                    return wrong(format!(
                        "the frequency falls from {before} Hz to {frequency} Hz, but must rise"
                    ));
                }
                if frequency > WIDEST_STEP * before {
                    return wrong(format!(
                        "nothing between {before} Hz and {frequency} Hz, more than an octave"
                    ));
                }
            }
            before = Some(frequency);
        }
        Ok(())
    }

    /// Angular frequencies \[rad/s\] and receptances \[m/N\].
    fn receptances(&self, conjugate: bool) -> (Vec<f64>, Vec<Complex64>) {
        let angular: Vec<f64> = self
            .frequencies
            .iter()
            .map(|frequency| std::f64::consts::TAU * frequency)
            .collect();
        let power = match self.response {
            Response::Receptance => 0,
            Response::Mobility => 1,
            Response::Accelerance => 2,
        };
        let receptances = angular
            .iter()
            .zip(&self.values)
            .map(|(&w, &value)| {
                let value = if conjugate { value.conj() } else { value };
                value / Complex64::new(0.0, w).powi(power)
            })
            .collect();
        (angular, receptances)
    }
}

/// What is to be asked of a receptance that was measured on a rail: whether it has the size of one, and is passive.
///
/// # Errors
/// The sentence for one that no rail has.
pub fn doubts_about_rail(receptance: &MeasuredReceptance) -> Result<Vec<Message>, String> {
    let size = check_size(receptance).map_err(|error| error.message)?;
    let passive = activity(receptance, Remedy::Conjugate);
    Ok(size.into_iter().chain(passive).collect())
}

/// `Ok` where the median of the modulus is one that a rail may have, with a remark where none of its lines is one
/// that rails do have.
fn check_size(receptance: &MeasuredReceptance) -> Result<Option<Message>, MeasurementError> {
    let mut moduli: Vec<f64> = receptance.lines().map(|(_, h)| h.norm()).collect();
    let middle = moduli.len() / 2;
    let (_, &mut median, _) = moduli.select_nth_unstable_by(middle, f64::total_cmp);
    if (OF_A_RAIL.0..=OF_A_RAIL.1).contains(&median) {
        let least = moduli.iter().copied().fold(f64::INFINITY, f64::min);
        let most = moduli.iter().copied().fold(0.0, f64::max);
        let unusual = least > USUAL.1 || most < USUAL.0;
        return Ok(unusual.then(|| {
            say!(
                receptance_unlike_rail,
                least = number(format_args!("{least:.0e}")),
                most = number(format_args!("{most:.0e}"))
            )
        }));
    }
    Err(MeasurementError::file(format!(
        "half of its receptances are above {median:.1e} m/N, but those of rails are some 1e-11 to 1e-7 m/N: check \
             track.measurement.quantity and unit (a modulus in decibels has unit = \"dB re 1 m/N\")"
    )))
}

/// What helps against a receptance that follows exp(−iωt).
#[derive(Clone, Copy)]
pub(crate) enum Remedy {
    /// A key of the case.
    SetKey,
    /// Whoever has the values can do it.
    Conjugate,
}

impl Remedy {
    fn message(self) -> Message {
        match self {
            Self::SetKey => say!(set_conjugate),
            Self::Conjugate => say!(conjugate_it),
        }
    }
}

/// Where a receptance is not passive, in one sentence.
pub(crate) fn activity(receptance: &MeasuredReceptance, remedy: Remedy) -> Option<Message> {
    let active: Vec<f64> = receptance
        .active()
        .map(|w| w / std::f64::consts::TAU)
        .collect();
    let (first, last) = (active.first()?, active.last()?);
    let (count, points) = (active.len(), receptance.points());
    Some(say!(
        receptance_gives_energy,
        count = count,
        points = points,
        first = fixed(*first, 0),
        last = fixed(*last, 0),
        remedy = remedy.message()
    ))
}

impl Response {
    /// Dimension per force.
    fn exponents(self) -> Exponents {
        match self {
            Self::Receptance => Exponents::new(-1, 0, 2),
            Self::Mobility => Exponents::new(-1, 0, 1),
            Self::Accelerance => Exponents::new(-1, 0, 0),
        }
    }

    /// Unit in SI.
    fn si_unit(self) -> &'static str {
        match self {
            Self::Receptance => "m/N",
            Self::Mobility => "m/s/N",
            Self::Accelerance => "m/s2/N",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Receptance => "a receptance in m/N",
            Self::Mobility => "a mobility in m/s/N",
            Self::Accelerance => "an accelerance in m/s2/N",
        }
    }
}

/// Lowest and highest frequency \[Hz\].
pub(crate) fn range(receptance: &dyn Receptance) -> (f64, f64) {
    let (low, high) = receptance.frequency_range();
    (low / std::f64::consts::TAU, high / std::f64::consts::TAU)
}
