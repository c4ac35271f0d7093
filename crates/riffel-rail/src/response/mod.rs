//! Frequency responses of rails and wheelsets in files: tables and universal files, as a receptance or as modes.

mod columns;
mod doubts;
mod keys;
mod layout;
mod response_unit;
mod smoothing;
mod table;
mod universal;
mod universal_function;
mod wheelset_modes;
mod wheelset_receptances;

use std::path::Path;

use riffel::Complex64;
use riffel::receptance::MeasuredReceptance;
use riffel_keys::{Exponents, Message, say, text_file};

pub use doubts::{Remedy, doubts, doubts_about_rail};
pub use keys::{AngleUnit, Measurement, Response, VerticalAxis};
pub use universal_function::UniversalFunction;
pub use wheelset_modes::WheelsetModes;
pub use wheelset_receptances::WheelsetReceptances;

/// Widest step between two frequencies, as a ratio: beyond it the file says nothing of what lies
/// between.
const WIDEST_STEP: f64 = 2.0;

/// What is wrong with a measurement.
#[derive(Debug)]
pub struct MeasurementError {
    /// Key below `track.measurement` that is at fault, or whose file is; of a file of a wheelset it is always `file`.
    pub key: &'static str,
    /// The sentence.
    pub message: Message,
}

impl MeasurementError {
    fn new(key: &'static str, message: impl Into<Message>) -> Self {
        Self { key, message: message.into() }
    }

    fn file(message: impl Into<Message>) -> Self {
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
pub struct Measured {
    /// The receptance \[m/N\].
    pub receptance: MeasuredReceptance,
    /// What was left out, smoothed or taken for granted, and what is to be asked of it.
    pub remarks: Vec<Message>,
}

/// Read the measurement; file names are relative to `folder`.
///
/// # Errors
/// [`MeasurementError`] for a file that cannot be read, a key that does not fit it, and a response that no rail has.
pub fn read(measurement: &Measurement, folder: &Path) -> Result<Measured, MeasurementError> {
    let path = folder.join(&measurement.file);
    let bytes = bytes_of(&path, "measurement")?;
    let Measurement { conjugate, negate, .. } = *measurement;
    let remedy = Remedy::Keys { conjugate, negate };
    let is_universal = is_universal_file(&path);
    let (response, remarks) = match is_universal {
        true => universal::read(&bytes, measurement)?,
        false => table::read(&decoded(bytes)?, measurement)?,
    };
    let mut read = response.turned(conjugate, negate).read()?;
    read.remarks.splice(0..0, remarks);
    if !is_universal {
        let unusual = doubts::doubts_about_size(&read.receptance);
        read.remarks.extend(unusual.map_err(MeasurementError::file)?);
    }
    read.doubted(remedy)
}

fn bytes_of(path: &Path, what: &'static str) -> Result<Vec<u8>, MeasurementError> {
    text_file::read_bounded(path, what, text_file::LARGEST_RESPONSES)
        .map_err(|error| MeasurementError::file(error.to_string()))
}

fn decoded(bytes: Vec<u8>) -> Result<String, MeasurementError> {
    text_file::decode(bytes).map_err(MeasurementError::file)
}

/// A function that was read elsewhere.
///
/// # Errors
/// [`MeasurementError`] for another function, a unit that does not fit, or frequencies with gaps.
pub fn of_universal(function: &UniversalFunction) -> Result<Measured, MeasurementError> {
    universal::of_function(function)?.read()?.doubted(Remedy::Values)
}

fn is_universal_file(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| ["uff", "unv", "u58", "uf"].iter().any(|known| extension.eq_ignore_ascii_case(known)))
}

impl Measured {
    /// With what is to be asked of a receptance at a point.
    fn doubted(mut self, remedy: Remedy) -> Result<Self, MeasurementError> {
        let doubts = doubts(&self.receptance, remedy).map_err(MeasurementError::file)?;
        self.remarks.extend(doubts);
        Ok(self)
    }
}

impl FrequencyResponse {
    /// The conjugate or the negative of every value, or both.
    fn turned(mut self, conjugate: bool, negate: bool) -> Self {
        let sign = if negate { -1.0 } else { 1.0 };
        for value in &mut self.values {
            *value = sign * if conjugate { value.conj() } else { *value };
        }
        self
    }

    /// Checked, as a receptance between any two points.
    fn read(mut self) -> Result<Measured, MeasurementError> {
        let mut remarks = Vec::new();
        remarks.extend(self.leave_out_zero());
        self.check()?;
        let (angular, mut receptances) = self.receptances();
        if let Some(coherence) = &self.coherence {
            remarks.extend(smoothing::smooth(&angular, &mut receptances, coherence));
        }
        let receptance = MeasuredReceptance::new(&angular, receptances)
            .map_err(|error| MeasurementError::file(error.to_string()))?;
        Ok(Measured { receptance, remarks })
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
        for ((&frequency, value), place) in self.frequencies.iter().zip(&self.values).zip(&self.places) {
            let wrong = |rule: String| Err(MeasurementError::file(format!("{place}: {rule}")));
            if !frequency.is_finite() || !value.is_finite() {
                return wrong("a value is not finite".to_owned());
            }
            if frequency <= 0.0 {
                return wrong(format!("the frequency is {frequency} Hz, but must be greater than zero"));
            }
            if let Some(before) = before {
                if frequency == before {
                    return wrong(format!("the frequency {frequency} Hz is there twice"));
                }
                if frequency < before {
                    return wrong(format!("the frequency falls from {before} Hz to {frequency} Hz, but must rise"));
                }
                if frequency > WIDEST_STEP * before {
                    return wrong(format!("nothing between {before} Hz and {frequency} Hz, more than an octave"));
                }
            }
            before = Some(frequency);
        }
        Ok(())
    }

    /// Angular frequencies \[rad/s\] and receptances \[m/N\].
    fn receptances(&self) -> (Vec<f64>, Vec<Complex64>) {
        let angular: Vec<f64> = self.frequencies.iter().map(|frequency| std::f64::consts::TAU * frequency).collect();
        let power = match self.response {
            Response::Receptance => 0,
            Response::Mobility => 1,
            Response::Accelerance => 2,
        };
        let receptances =
            angular.iter().zip(&self.values).map(|(&w, &value)| value / Complex64::new(0.0, w).powi(power)).collect();
        (angular, receptances)
    }
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

#[cfg(test)]
mod tests;
