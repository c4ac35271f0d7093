//! Positions of an odometer that counts in steps, or is read more seldom than the accelerations.

use super::sample::Sample;

/// Longest time from one step of an odometer to the next \[s\]; beyond it the train stands.
pub const LONGEST_STEP: f64 = 2.0;

/// Samples whose position stands still, until it leaps.
pub(super) struct CountedSteps {
    /// Most samples from one leap to the next; beyond them the train stands.
    most: usize,
    /// Samples at the present position, the first of them that of the leap.
    held: Vec<Sample>,
    /// Length of the last step for each of its samples \[m\].
    slope: f64,
}

impl CountedSteps {
    pub(super) fn new(most: usize) -> Self {
        Self { most, held: Vec::new(), slope: 0.0 }
    }

    /// The next sample; those whose positions are known by now go into `known`.
    pub(super) fn push(&mut self, sample: Sample, known: &mut Vec<Sample>) {
        if let Some(first) = self.held.first() {
            let step = sample.position - first.position;
            if step != 0.0 || self.held.len() == self.most {
                self.slope = step / self.held.len() as f64;
                self.hand_on(known);
            }
        }
        self.held.push(sample);
    }

    /// A gap, or the end: the train runs on as before.
    pub(super) fn end(&mut self, known: &mut Vec<Sample>) {
        self.hand_on(known);
        self.slope = 0.0;
    }

    fn hand_on(&mut self, known: &mut Vec<Sample>) {
        let held = self.held.drain(..).enumerate();
        known.extend(
            held.map(|(index, sample)| Sample { position: sample.position + index as f64 * self.slope, ..sample }),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn positions(read: impl Iterator<Item = f64>, most: usize) -> Vec<f64> {
        let (mut steps, mut known) = (CountedSteps::new(most), Vec::new());
        for position in read {
            let acceleration = 0.0;
            steps.push(Sample { acceleration, position }, &mut known);
        }
        steps.end(&mut known);
        known.iter().map(|sample| sample.position).collect()
    }

    /// 20 m/s at 1 kHz: read five times a second, and in steps of half a metre, it is the same run.
    #[test]
    fn seldom_readings_and_steps_are_an_even_run() {
        let exact = |index: usize| 0.02 * index as f64;
        let seldom = positions((0..5000).map(|index| exact(index / 200 * 200)), 2000);
        let steps = positions((0..5000).map(|index| (index / 25) as f64 * 0.5), 2000);
        for found in [seldom, steps] {
            assert_eq!(found.len(), 5000);
            for (index, position) in found.iter().enumerate() {
                assert!((position - exact(index)).abs() < 1e-9, "{index}: {position}");
            }
        }
    }

    /// A position for each sample stays as it is; one that is held for longer than a step can last is a train that stands.
    #[test]
    fn what_is_exact_and_what_stands_stays() {
        let runs: Vec<f64> = (0..100).map(|index| (f64::from(index) * 0.1).sin() + f64::from(index)).collect();
        assert_eq!(positions(runs.iter().copied(), 50), runs);
        let stands = positions(std::iter::repeat_n(7.0, 500).chain([8.0]), 50);
        assert!(stands[..450].iter().all(|position| *position == 7.0));
        assert_eq!(stands.len(), 501);
    }
}
