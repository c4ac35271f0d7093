//! How far wheels roll until they have forgotten the rail.

use std::f64::consts::PI;

use super::PassageModel;
use super::over_supports::ONSET_BAYS;
use crate::Error;

/// \[s\]: a fiftieth of the period of the contact's own oscillations.
const STEP: f64 = 2e-5;
/// \[s\]
const PATIENCE: f64 = 2.0;
/// Small beside any approach \[m\].
const HEIGHT: f64 = 1e-8;

impl PassageModel {
    /// Distance \[m\] after which the rail is forgotten by the normal forces of all contacts, and the length of the train twice. On
    /// discrete supports the change is that of the forces which passing them makes, and the distance over which their sag sets in is added.
    ///
    /// Of free wheels on a track a step of the rail is forgotten where forces stay within 10⁻⁴ of their largest change, which is that of
    /// the contact's spring, ten times that of the wheel on the track. Of wheels that are [fitted](super::StructuresInTime) with all that
    /// holds them it is a bump of a millisecond, to 10⁻³: the slow motion on primary suspensions, which a step begins, is below.
    ///
    /// # Errors
    /// [`Error::NotConverged`] where two seconds of rolling do not suffice, as where the loop is unstable.
    pub fn memory(&self) -> Result<f64, Error> {
        const BUMP: f64 = 1e-3;
        let spacing = self.structures.support_spacing();
        let onset = spacing.map_or(0.0, |spacing| ONSET_BAYS * spacing);
        let last = match self.structures.are_fitted_together() {
            false => last_remembered(
                &self.changes(|_| HEIGHT)?,
                1e-4,
                "motion of the wheel after a step of the rail, two seconds later,",
                "give the rail more loss, or damping in N s/m in the place of loss factors: what is nearly free of \
                 loss may swing up in time",
            )?,
            true => last_remembered(
                &self.changes(|time| HEIGHT * (PI * (time / BUMP).min(1.0)).sin().powi(2))?,
                1e-3,
                "motion of the wheels after a bump of the rail, two seconds later,",
                "give rail, wheelset and suspension more loss: what is nearly free of loss may swing up in time",
            )?,
        };
        let behind = self.contacts.iter().map(|contact| -contact.along);
        let train = behind.fold(0.0, f64::max);
        Ok(onset + 2.0 * train + (last + 2) as f64 * STEP * self.speed)
    }

    /// Largest change of any normal force that a rail makes in each step, whose height under all wheels is told at a time \[s\].
    fn changes(&self, height: impl Fn(f64) -> f64) -> Result<Vec<f64>, Error> {
        let mut march = self.march(STEP * self.speed)?;
        let spacing = self.structures.support_spacing();
        let mut smooth = spacing.map(|_| march.clone());
        let mut without: Vec<f64> = self.contacts.iter().map(|contact| contact.spring.normal_force()).collect();
        let mut heights = vec![0.0; self.contacts.len()];
        let even = heights.clone();
        let steps = (PATIENCE / STEP) as usize;
        let change = |step: usize| {
            heights.fill(height(step as f64 * STEP));
            if let Some(smooth) = &mut smooth {
                for (without, now) in without.iter_mut().zip(smooth.advance(&even)) {
                    *without = now.normal_force;
                }
            }
            let now = march.advance(&heights).iter().zip(&without);
            now.map(|(now, without)| (now.normal_force - without).abs()).fold(0.0, f64::max)
        };
        Ok((1..=steps).map(change).collect())
    }
}

/// The last of some changes that is above a share of the largest.
///
/// # Errors
/// [`Error::NotConverged`] with the problem and its remedy, if that is the last of all.
fn last_remembered(changes: &[f64], share: f64, problem: &'static str, remedy: &'static str) -> Result<usize, Error> {
    let largest = changes.iter().copied().fold(0.0, f64::max);
    let remembered = |change: &f64| *change > share * largest;
    let last = changes.iter().rposition(remembered).unwrap_or(0);
    if last + 1 < changes.len() {
        return Ok(last);
    }
    Err(Error::NotConverged { problem, residual: changes[last] / largest, tolerance: share, remedy })
}
