//! A measured receptance, read from a file that the case names.

mod table;
mod universal;
mod universal_file;

use std::path::Path;

use riffel::{Complex64, MeasuredReceptance, Receptance};

use crate::file::{Measurement, Response};
use crate::unit::Exponents;
use crate::{Language, Remark, UniversalFunction};

/// Widest step between two frequencies, as a ratio: beyond it the file says nothing of what lies
/// between.
const WIDEST_STEP: f64 = 2.0;

/// What is wrong with a measurement.
#[derive(Debug)]
pub(crate) struct MeasurementError {
    /// Key below `track.measurement` that is at fault, or whose file is.
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
    /// Where each value stands, as "line 12".
    places: Vec<String>,
}

/// A receptance, and what the reader of the case should know of it.
pub(crate) struct Measured {
    pub(crate) receptance: MeasuredReceptance,
    pub(crate) remarks: Vec<Remark>,
}

/// Read the measurement; file names are relative to `folder`.
pub(crate) fn read(measurement: &Measurement, folder: &Path) -> Result<Measured, MeasurementError> {
    let path = folder.join(&measurement.file);
    let bytes = std::fs::read(&path).map_err(|reason| {
        MeasurementError::file(format!("cannot read {}: {reason}", path.display()))
    })?;
    let remedy = Remedy::SetKey;
    if is_universal_file(&path) {
        let response = universal::read(&bytes, measurement)?;
        transformed(response, measurement.conjugate, remedy)
    } else {
        let response = table::read(&bytes, measurement)?;
        response.measured(measurement.conjugate, remedy)
    }
}

/// A function that was read elsewhere.
pub(crate) fn of_universal(function: &UniversalFunction) -> Result<Measured, MeasurementError> {
    transformed(universal::of_function(function)?, false, Remedy::Conjugate)
}

/// A response of a Fourier transform, whose even abscissa begins at zero; no receptance does.
fn transformed(
    mut response: FrequencyResponse,
    conjugate: bool,
    remedy: Remedy,
) -> Result<Measured, MeasurementError> {
    let from_zero = response.frequencies.first() == Some(&0.0);
    if from_zero {
        response.frequencies.remove(0);
        response.values.remove(0);
        response.places.remove(0);
    }
    let mut measured = response.measured(conjugate, remedy)?;
    if from_zero {
        let remark = Remark::new(
            "the measured value at 0 Hz is left out",
            "der gemessene Wert bei 0 Hz bleibt weg",
        );
        measured.remarks.insert(0, remark);
    }
    Ok(measured)
}

fn is_universal_file(path: &Path) -> bool {
    path.extension().is_some_and(|extension| {
        ["uff", "unv", "u58", "uf"]
            .iter()
            .any(|known| extension.eq_ignore_ascii_case(known))
    })
}

impl FrequencyResponse {
    /// Checked, as a receptance; `remedy` as for [`activity`].
    fn measured(self, conjugate: bool, remedy: Remedy) -> Result<Measured, MeasurementError> {
        self.check()?;
        let receptance = self.receptance(conjugate)?;
        Ok(Measured {
            remarks: activity(&receptance, remedy).into_iter().collect(),
            receptance,
        })
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

    fn receptance(&self, conjugate: bool) -> Result<MeasuredReceptance, MeasurementError> {
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
        MeasuredReceptance::new(&angular, receptances)
            .map_err(|error| MeasurementError::file(error.to_string()))
    }
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
    fn words(self, language: Language) -> &'static str {
        match self {
            Self::SetKey => language.pick(
                "set track.measurement.conjugate",
                "track.measurement.conjugate setzen",
            ),
            Self::Conjugate => language.pick("conjugate it", "konjugieren"),
        }
    }
}

/// Where a receptance is not passive, in one sentence.
pub(crate) fn activity(receptance: &MeasuredReceptance, remedy: Remedy) -> Option<Remark> {
    let active: Vec<f64> = receptance
        .active()
        .map(|w| w / std::f64::consts::TAU)
        .collect();
    let (first, last) = (active.first()?, active.last()?);
    let (count, points) = (active.len(), receptance.points());
    Some(Remark::new(
        format!(
            "the measured receptance gives energy away (Im H > 0) at {count} of {points} frequencies, between {first:.0} \
             and {last:.0} Hz: check its phase, its noise, and whether it follows exp(+iωt) (else {})",
            remedy.words(Language::English),
        ),
        format!(
            "die gemessene Rezeptanz gibt Energie ab (Im H > 0), bei {count} von {points} Frequenzen zwischen \
             {first:.0} und {last:.0} Hz: Phase und Rauschen prüfen, und ob sie exp(+iωt) folgt (sonst {})",
            remedy.words(Language::German),
        ),
    )
    .in_short(format!(
        "the measured receptance gives energy away (Im H > 0) at {count} of {points} frequencies: check its phase"
    )))
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
