//! Wheels along a given profile.

use riffel_numerics::cubic::{cubic, cubic_at, hermite};

use super::patch_average::PatchAverage;
use super::{ContactInTime, ContactInstant, March, PassageModel};
use crate::Error;
use crate::roughness::Profile;

/// What wheels did along a profile.
#[derive(Debug, Clone, PartialEq)]
pub struct Passage {
    /// The contact of the first wheel at every height of the profile.
    pub contacts: Vec<ContactInstant>,
    /// All other contacts at the same times, where there are several, in their order.
    pub others: Vec<Vec<ContactInstant>>,
    /// Share of the time without contact \[-\], in the mean of all contacts.
    pub contact_loss: f64,
    /// Least and largest normal force of any at any step \[N\].
    pub normal_force: [f64; 2],
    /// Step of the march \[m\].
    pub step: f64,
    /// Length of the run-in before the profile \[m\].
    pub run_in: f64,
}

impl PassageModel {
    /// All wheels along a profile, in steps of at most the length given \[m\]; heights between samples are those of cubics through four of
    /// them. The first wheel stands at the heights, the others behind it; contacts on the opposite rail follow what their rail has of the
    /// same profile.
    ///
    /// With a contact filter the wheels feel the mean over the patch; beyond the ends of the profile its last heights go on.
    /// On discrete supports the profile begins over one of them. The wheels come from a smooth rail: before the profile lies
    /// its own beginning, mirrored on the straight line through it and faded in over [`memory`](Self::memory), so that the
    /// motion is that of a rail which was rough before. A rail that slopes where it begins has a kink there: over the first
    /// length of the memory forces may be off by a tenth of their range.
    ///
    /// # Errors
    /// [`Error::ProfileTooShort`] for a profile shorter than the memory, and those of memory and march.
    pub fn pass(&self, profile: &Profile, largest_step: f64) -> Result<Passage, Error> {
        let spacing = profile.spacing();
        let pressed = |contact: &ContactInTime| match self.filter_of(contact) {
            Some(filter) => averaged(profile, filter.semi_axis_longitudinal()),
            None => profile.heights().to_vec(),
        };
        let pressed: Vec<Vec<f64>> = self.contacts.iter().map(pressed).collect();
        let heights = &pressed[0];
        let memory = self.memory()?;
        let run_in = (memory / spacing).ceil() as usize;
        if run_in + 1 >= heights.len() {
            return Err(Error::ProfileTooShort { length: profile.length(), memory });
        }
        let trend = Line::through(&heights[..=run_in]);
        let rail = |heights: &[f64], index: isize| match usize::try_from(index) {
            // Past the end the last height goes on, which only the cubic before it sees.
            Ok(index) => heights[index.min(heights.len() - 1)] - trend.at(0.0),
            Err(_) => {
                let before = index.unsigned_abs().min(run_in);
                let rough = heights[before] - trend.at(before as f64);
                let share = 1.0 - before as f64 / run_in as f64;
                (trend.slope * index as f64 + rough) * faded(share)
            }
        };
        let contacts = self.contacts.iter();
        let beside: Vec<Vec<PatchAverage>> = contacts.map(|contact| self.averages_along(contact, profile)).collect();
        let averaged = |contact: usize, index: isize| PatchAverage {
            height: rail(&pressed[contact], index),
            ..match usize::try_from(index) {
                Ok(index) => beside[contact][index.min(heights.len() - 1)],
                Err(_) => {
                    let before = index.unsigned_abs().min(run_in);
                    let share = 1.0 - before as f64 / run_in as f64;
                    let there = beside[contact][before].times(faded(share));
                    // What was mirrored falls where it rose.
                    PatchAverage { slope: -there.slope, ..there }
                }
            }
        };
        let substeps = (spacing / largest_step).ceil().max(1.0);
        let mut march = self.march_before(spacing / substeps, run_in as f64 * spacing)?;
        let mut roll = Roll::new(&mut march, substeps as usize, spacing);
        roll.along(averaged, -(run_in as isize), 0, |_| ());
        roll.begin_to_count();
        let first = roll.march.now();
        let mut contacts: Vec<Vec<ContactInstant>> = first.iter().map(|&first| vec![first]).collect();
        roll.along(averaged, 0, heights.len() as isize - 1, |now| {
            for (contacts, now) in contacts.iter_mut().zip(now) {
                contacts.push(*now);
            }
        });
        Ok(Passage {
            contact_loss: roll.contact_loss(),
            normal_force: roll.normal_force,
            step: spacing / substeps,
            run_in: run_in as f64 * spacing,
            contacts: contacts.remove(0),
            others: contacts,
        })
    }
}

/// The mean of a profile from a semi-axis \[m\] behind each height to one before it, (I(x + a) − I(x − a))/2a.
///
/// I is the integral by the cubic through four heights, and between heights the cubic with the heights as its slopes: fourth order in
/// the spacing.
fn averaged(profile: &Profile, semi_axis: f64) -> Vec<f64> {
    let heights = profile.heights();
    let last = heights.len() as isize - 1;
    let height = |index: isize| heights[index.clamp(0, last) as usize];
    let reach = semi_axis / profile.spacing();
    let beyond = reach.ceil() as isize + 1;
    // In numbers of heights, from `beyond` before the first on.
    let mut integral = vec![0.0];
    for index in -beyond..last + beyond {
        let [a, b, c, d] = [-1, 0, 1, 2].map(|by| height(index + by));
        integral.push(integral[integral.len() - 1] + (13.0 * (b + c) - a - d) / 24.0);
    }
    let integral_at = |place: f64| {
        let from = place.floor();
        let (index, t) = (from as isize, place - from);
        let [one, other] = [0, 1].map(|by| integral[(index + by + beyond) as usize]);
        cubic_at(hermite([one, other], [height(index), height(index + 1)]), t)
    };
    (0..=last)
        .map(|index| {
            let place = index as f64;
            (integral_at(place + reach) - integral_at(place - reach)) / (2.0 * reach)
        })
        .collect()
}

/// A straight line over the number of a height.
struct Line {
    mean: f64,
    middle: f64,
    slope: f64,
}

impl Line {
    /// That of least squares.
    fn through(heights: &[f64]) -> Self {
        let count = heights.len() as f64;
        let mean = heights.iter().sum::<f64>() / count;
        let middle = 0.5 * (count - 1.0);
        let numbered = heights.iter().enumerate();
        let moment: f64 = numbered.map(|(index, height)| (index as f64 - middle) * (height - mean)).sum();
        Self { mean, middle, slope: moment * 12.0 / (count * (count * count - 1.0)) }
    }

    fn at(&self, index: f64) -> f64 {
        self.mean + self.slope * (index - self.middle)
    }
}

/// From zero at or below zero to one at or above one, without a kink.
pub(super) fn faded(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}

/// Its slope.
pub(super) fn slope_of_faded(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    6.0 * share * (1.0 - share)
}

/// A march along heights at equal distances, with steps between them, and what is counted of it.
pub(super) struct Roll<'a, 'm> {
    march: &'a mut March<'m>,
    substeps: usize,
    /// Distance of the heights \[m\].
    spacing: f64,
    steps: usize,
    lost: usize,
    pub(super) normal_force: [f64; 2],
}

impl<'a, 'm> Roll<'a, 'm> {
    pub(super) fn new(march: &'a mut March<'m>, substeps: usize, spacing: f64) -> Self {
        Self { march, substeps, spacing, steps: 0, lost: 0, normal_force: [f64::INFINITY, f64::NEG_INFINITY] }
    }

    /// Forget what was counted so far.
    pub(super) fn begin_to_count(&mut self) {
        self.steps = 0;
        self.lost = 0;
        self.normal_force = [f64::INFINITY, f64::NEG_INFINITY];
    }

    /// Share of the time without contact \[-\], in the mean of all contacts.
    pub(super) fn contact_loss(&self) -> f64 {
        self.lost as f64 / self.steps as f64
    }

    /// On from one height to another, at which contacts by their numbers feel what is told; `visit` is shown the contacts when the first
    /// wheel is at each height after the first.
    pub(super) fn along(
        &mut self,
        averaged: impl Fn(usize, isize) -> PatchAverage,
        from: isize,
        to: isize,
        mut visit: impl FnMut(&[ContactInstant]),
    ) {
        let beside: Vec<bool> = self.march.feel_more_than_height().collect();
        for index in from..to {
            for step in 1..=self.substeps {
                let share = step as f64 / self.substeps as f64;
                let place = |ahead: f64| {
                    let place = share + ahead / self.spacing;
                    (index + place.floor() as isize, place - place.floor())
                };
                self.march.advance_along(|contact, ahead| {
                    // To the last bit of the share.
                    let (index, share) = match ahead == 0.0 {
                        true => (index, share),
                        false => place(ahead),
                    };
                    let around = [-1, 0, 1, 2].map(|by| averaged(contact, index + by));
                    PatchAverage::between(around, |four| cubic(four, share), beside[contact])
                });
                for contact in self.march.now() {
                    let [least, largest] = &mut self.normal_force;
                    *least = least.min(contact.normal_force);
                    *largest = largest.max(contact.normal_force);
                    self.steps += 1;
                    self.lost += usize::from(contact.normal_force <= 0.0);
                }
            }
            visit(self.march.now());
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    #[test]
    fn lines_are_found() {
        let line = Line::through(&[1.0, 3.5, 6.0, 8.5]);
        assert!((line.at(0.0) - 1.0).abs() < 1e-14 && (line.slope - 2.5).abs() < 1e-14);
    }

    /// sin(ka)/(ka) of a wave of 24 heights, to the fourth power of 2π/24 over 30; a straight line stays.
    #[test]
    fn the_mean_over_the_patch_is_the_contact_filter() -> Result<(), Error> {
        let k = TAU / 24.0;
        for semi_axis in [0.4, 3.0, 7.7, 12.0] {
            let wave = (0..400).map(|index| (k * f64::from(index) + 0.3).cos());
            let mean = averaged(&Profile::new(0.0, 1.0, wave.collect())?, semi_axis);
            let filter = (k * semi_axis).sin() / (k * semi_axis);
            for (index, got) in mean.iter().enumerate().take(380).skip(20) {
                let exact = filter * (k * index as f64 + 0.3).cos();
                assert!((got - exact).abs() < 2e-4, "{semi_axis} {index}: {got} {exact}");
            }
            let line = (0..100).map(f64::from).collect();
            let mean = averaged(&Profile::new(0.0, 1.0, line)?, semi_axis);
            assert!((mean[50] - 50.0).abs() < 1e-10);
        }
        Ok(())
    }
}
