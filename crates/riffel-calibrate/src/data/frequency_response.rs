//! Frequency responses of the rail under a hammer.

use std::f64::consts::TAU;
use std::path::Path;

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel::Complex64;
use riffel::receptance::MeasuredReceptance;
use riffel_case::{Case, doubts_about_rail};
use riffel_keys::{CaseError, Message};

use super::{Block, Group, Held, Observable, Place, differences, sums, table};
use crate::file::Kind;
use crate::gaussian::{Density, Gaussian};
use crate::kernel::Kernel;
use crate::matrix::Matrix;
use crate::model::Trial;
use crate::nuts::normal;

/// Highest frequency of a hammer test at least \[Hz\]: below it a rail rests on its bed, and no hammer is so soft.
const LEAST_HIGHEST: f64 = 20.0;
/// Relative error of a line of which nothing is said.
const USUAL_ERROR: f64 = 0.05;

/// Receptances Ĥ at some places. ln Ĥ − ln H = gain + δ + ε on the real part, δ + ε on the imaginary part, modulo 2πi, with
/// ε ~ N(0, (1 − γ²)/2nγ²) on each, one gain for all lines and places, δ independent between places and parts.
///
/// Source: Bendat & Piersol (2010), *Random Data*, section 9.2, for ε: first order, n averages of equal blows. Range: lines
/// that are independent.
pub(crate) struct FrequencyResponses {
    view: usize,
    angular_frequency: Vec<f64>,
    position: Option<Vec<f64>>,
    response: Vec<Complex64>,
    parts: [Gaussian; 2],
    /// Whether nothing is said of the errors of the lines.
    pub(crate) usual_errors: bool,
    /// What is to be asked of the responses.
    pub(crate) doubts: Vec<Message>,
}

impl FrequencyResponses {
    /// Whether a line was measured at a place.
    fn is_at(&self, row: usize, place: f64) -> bool {
        let position = self.position.as_ref();
        position.is_some_and(|position| position[row] == place)
    }

    pub(crate) fn read(
        path: &Path,
        view: (usize, &Case),
        averages: Option<f64>,
        gain_error: f64,
        missed: Option<Kernel>,
    ) -> Result<Self, CaseError> {
        let columns = Kind::FrequencyResponse.columns();
        let numbers = table::read(path, columns, &["position_m", "coherence"])?;
        let [frequency, real, imaginary] = [0, 1, 2].map(|column| &numbers.needed[column]);
        let rule = "must be greater than zero";
        numbers.check(path, "frequency_hz", frequency, rule, |f| f > 0.0)?;
        let highest = frequency.iter().copied().fold(0.0, f64::max);
        if highest < LEAST_HIGHEST {
            let message = format!(
                "`frequency_hz` goes up to {highest}, but a hammer goes beyond {LEAST_HIGHEST} Hz; are they kHz?"
            );
            return Err(numbers.refuse(path, 0, &message));
        }
        let response: Vec<Complex64> = real
            .iter()
            .zip(imaginary)
            .map(|(re, im)| Complex64::new(*re, *im))
            .collect();
        if let Some(row) = response.iter().position(|value| value.norm() == 0.0) {
            return Err(numbers.refuse(
                path,
                row,
                "the receptance is zero, which has no logarithm",
            ));
        }
        let position = numbers.others[0].clone();
        let doubts = doubts(frequency, &response, position.as_deref());
        let doubts = doubts.map_err(|message| numbers.refuse(path, 0, &message.to_string()))?;
        let coherence = numbers.others[1].as_ref();
        if let Some(coherence) = coherence {
            let rule = "must be above 0 and below 1";
            numbers.check(path, "coherence", coherence, rule, |c| c > 0.0 && c < 1.0)?;
            if averages.is_none() {
                let message = "has a column `coherence`, but `averages` of the plan is missing, the number of blows of each mean";
                return Err(numbers.refuse(path, 0, message));
            }
        }
        let (low, high) = view.1.known_frequencies();
        let rule = format!("the track is known from {low:.4} to {high:.4} Hz only");
        numbers.check(path, "frequency_hz", frequency, &rule, |f| {
            f >= low && f <= high
        })?;
        if view.1.track.structure.is_none() && position.is_some() {
            let message = "the track of the case is no model and has no places, but there is a column `position_m`";
            return Err(numbers.refuse(path, 0, message));
        }
        let variance = |row: usize| match (coherence, averages) {
            (Some(coherence), Some(averages)) => {
                let square = coherence[row];
                (1.0 - square) / (2.0 * averages * square)
            }
            _ => USUAL_ERROR * USUAL_ERROR,
        };
        let count = response.len();
        let place = |row: usize| position.as_ref().map_or(0.0, |position| position[row]);
        let kernel = missed.unwrap_or(Kernel::Band);
        let covariance = Matrix::of(count, |row, column| {
            let same = place(row) == place(column);
            let distance = (frequency[row] / frequency[column]).ln();
            if same { kernel.at(distance) } else { 0.0 }
        });
        let gaussian = |gain: f64| {
            let noise = Matrix::of(count, |row, column| {
                let own = if row == column { variance(row) } else { 0.0 };
                own + gain * gain
            });
            Gaussian::new(noise, vec![covariance.clone()])
        };
        let parts = gaussian(gain_error).zip(gaussian(0.0));
        let (real, imaginary) = parts.ok_or_else(|| {
            numbers.refuse(path, 0, "the errors of the lines are zero within rounding")
        })?;
        Ok(Self {
            view: view.0,
            angular_frequency: frequency.iter().map(|f| TAU * f).collect(),
            position,
            response,
            parts: [real, imaginary],
            usual_errors: coherence.is_none(),
            doubts,
        })
    }
}

/// What is to be asked of the responses of each place: unit and phase. Of lines at one frequency the first is looked at.
fn doubts(
    frequency: &[f64],
    response: &[Complex64],
    position: Option<&[f64]>,
) -> Result<Vec<Message>, Message> {
    let place = |row: usize| position.map_or(0.0, |position| position[row]);
    let mut rows: Vec<usize> = (0..frequency.len()).collect();
    rows.sort_by(|a, b| {
        let of = |row: usize| (place(row), frequency[row]);
        let ((at, f), (other, g)) = (of(*a), of(*b));
        at.total_cmp(&other).then(f.total_cmp(&g))
    });
    let mut doubts: Vec<Message> = Vec::new();
    rows.dedup_by(|b, a| place(*a) == place(*b) && frequency[*a] == frequency[*b]);
    for rows in rows.chunk_by(|a, b| place(*a) == place(*b)) {
        let angular: Vec<f64> = rows.iter().map(|row| TAU * frequency[*row]).collect();
        let values = rows.iter().map(|row| response[*row]).collect();
        let Ok(measured) = MeasuredReceptance::new(&angular, values) else {
            continue;
        };
        let new = doubts_about_rail(&measured)?.into_iter();
        let new: Vec<Message> = new
            .filter(|doubt| doubts.iter().all(|known| known.id() != doubt.id()))
            .collect();
        doubts.extend(new);
    }
    Ok(doubts)
}

impl Block for FrequencyResponses {
    /// ln |H| of all lines, then arg H next to that of the datum.
    fn predict(&self, trial: &Trial<'_>) -> Result<Vec<f64>, String> {
        let case = trial.case(self.view)?;
        let lines = self
            .angular_frequency
            .iter()
            .zip(&self.response)
            .enumerate();
        let ratios: Vec<(Complex64, Complex64)> = lines
            .map(|(row, (w, measured))| {
                let place = self.position.as_ref().map(|position| position[row]);
                let receptance = match (&case.track.structure, place) {
                    (Some(structure), Some(x)) => structure.cross_receptance(*w, x, x),
                    _ => case.track.receptance.receptance(*w, 0.0),
                };
                (receptance, measured / receptance)
            })
            .collect();
        let moduli = ratios.iter().map(|(receptance, _)| receptance.norm().ln());
        let phases = ratios.iter().zip(&self.response);
        let phases = phases.map(|((_, ratio), measured)| measured.arg() - ratio.arg());
        Ok(moduli.chain(phases).collect())
    }

    fn density(&self, predicted: &[f64], sizes: &[f64]) -> Option<Density> {
        let residuals = differences(&self.observed(), predicted);
        let (real, imaginary) = residuals.split_at(self.response.len());
        let real = self.parts[0].density(real, sizes)?;
        let imaginary = self.parts[1].density(imaginary, sizes)?;
        Some(Density {
            value: real.value + imaginary.value,
            by_prediction: [real.by_prediction, imaginary.by_prediction].concat(),
            by_size: vec![real.by_size[0] + imaginary.by_size[0]],
        })
    }

    fn of_each(&self, predicted: &[f64], sizes: &[f64]) -> Option<Vec<f64>> {
        let residuals = differences(&self.observed(), predicted);
        let (real, imaginary) = residuals.split_at(self.response.len());
        let real = self.parts[0].of_each(real, sizes)?;
        Some([real, self.parts[1].of_each(imaginary, sizes)?].concat())
    }

    fn replicate(
        &self,
        predicted: &[f64],
        sizes: &[f64],
        random: &mut Xoshiro256PlusPlus,
    ) -> Option<Vec<f64>> {
        let real = self.parts[0].draw(sizes, || normal(random))?;
        let imaginary = self.parts[1].draw(sizes, || normal(random))?;
        Some(sums(predicted, &[real, imaginary].concat()))
    }

    fn with_data(&self, data: &[f64]) -> Option<Box<dyn Block>> {
        let (moduli, phases) = data.split_at(self.response.len());
        let lines = moduli.iter().zip(phases);
        Some(Box::new(Self {
            angular_frequency: self.angular_frequency.clone(),
            position: self.position.clone(),
            response: lines
                .map(|(ln, phase)| Complex64::from_polar(ln.exp(), *phase))
                .collect(),
            parts: self.parts.clone(),
            doubts: Vec::new(),
            ..*self
        }))
    }

    fn views(&self) -> Vec<usize> {
        vec![self.view]
    }

    fn observed(&self) -> Vec<f64> {
        let moduli = self.response.iter().map(|measured| measured.norm().ln());
        let phases = self.response.iter().map(|measured| measured.arg());
        moduli.chain(phases).collect()
    }

    fn places(&self) -> Vec<Place> {
        let parts = [Observable::ReceptanceMPerN, Observable::ReceptancePhaseRad];
        let of_part = |measured: Observable| {
            let lines = self.angular_frequency.iter().enumerate();
            lines.map(move |(row, w)| Place {
                measured,
                at: w / TAU,
                of: self.position.as_ref().map(|position| position[row]),
            })
        };
        parts.into_iter().flat_map(of_part).collect()
    }

    /// The places of the blows, where there are several.
    fn groups(&self) -> Vec<Group> {
        let count = self.response.len();
        let all = Group::all(2 * count);
        let mut places = self.position.clone().unwrap_or_default();
        places.sort_by(f64::total_cmp);
        places.dedup();
        if places.len() < 2 {
            return vec![all];
        }
        let group = |place: &f64| {
            let own = (0..2 * count).filter(|datum| self.is_at(datum % count, *place));
            Group {
                held: Held::Place(*place),
                own: own.collect(),
                ..all.clone()
            }
        };
        places.iter().map(group).collect()
    }

    fn without(&self, held: Held) -> Option<Box<dyn Block>> {
        let Held::Place(place) = held else {
            return None;
        };
        let rest = (0..self.response.len()).filter(|row| !self.is_at(*row, place));
        let rest: Vec<usize> = rest.collect();
        let picked = |values: &[f64]| rest.iter().map(|row| values[*row]).collect::<Vec<f64>>();
        let [real, imaginary] = self.parts.each_ref().map(|part| part.picked(&rest));
        Some(Box::new(Self {
            angular_frequency: picked(&self.angular_frequency),
            position: self.position.as_deref().map(picked),
            response: rest.iter().map(|row| self.response[*row]).collect(),
            parts: [real?, imaginary?],
            doubts: Vec::new(),
            ..*self
        }))
    }

    fn covariance(&self, sizes: &[f64], times: f64) -> Matrix {
        let count = self.response.len();
        let parts = self
            .parts
            .each_ref()
            .map(|part| part.covariance_of_mean(sizes, times));
        Matrix::of(2 * count, |row, column| {
            match row / count == column / count {
                true => parts[row / count].at(row % count, column % count),
                false => 0.0,
            }
        })
    }
}
