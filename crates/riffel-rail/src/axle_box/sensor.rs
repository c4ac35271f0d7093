//! Whether a sensor of acceleration is well.

use riffel::STANDARD_GRAVITY;
use riffel_keys::{Message, fixed, say};

use super::head::Counting;
use crate::refusal::Refusal;

/// Time for which a channel that is alive keeps no value to the last digit \[s\].
const DEAD: f64 = 0.05;
/// Equal samples at the end of the range from which a channel is clipped.
const CLIPPED_RUN: usize = 3;
/// Share of samples that may be clipped.
const MOST_CLIPPED: f64 = 0.01;
/// How near the mean of a channel is to gravity that it feels, as a share.
const NEAR: f64 = 0.03;

/// A channel as it is listened to, sample by sample.
pub(super) struct Sensor {
    name: String,
    counting: Counting,
    /// Samples for which no value stays.
    patience: usize,
    last: f64,
    same: usize,
    count: usize,
    sum: f64,
    square: f64,
    dead: usize,
    dead_from: usize,
    /// At the highest and at the lowest value.
    ends: [End; 2],
}

/// One end of the range.
#[derive(Clone, Copy)]
struct End {
    /// The value, upward.
    value: f64,
    run: usize,
    clipped: usize,
    line: usize,
}

impl End {
    fn listen(&mut self, value: f64, line: usize) {
        if value > self.value {
            (self.value, self.clipped) = (value, 0);
            self.run = 1;
        } else if value == self.value {
            self.run += 1;
            if self.run == CLIPPED_RUN {
                if self.clipped == 0 {
                    self.line = line;
                }
                self.clipped += CLIPPED_RUN;
            } else if self.run > CLIPPED_RUN {
                self.clipped += 1;
            }
        } else {
            self.run = 0;
        }
    }
}

impl Sensor {
    /// A channel of some name at a sampling rate \[Hz\].
    pub(super) fn new(name: &str, rate: f64, counting: Counting) -> Self {
        let end = End { value: f64::NEG_INFINITY, run: 0, clipped: 0, line: 0 };
        Self {
            name: name.to_owned(),
            counting,
            patience: ((DEAD * rate).round() as usize).max(10),
            last: f64::NAN,
            same: 0,
            count: 0,
            sum: 0.0,
            square: 0.0,
            dead: 0,
            dead_from: 0,
            ends: [end; 2],
        }
    }

    /// Listen to a sample \[m/s²\]; false while the channel keeps one value.
    pub(super) fn listen(&mut self, value: f64, line: usize) -> bool {
        self.same = if value == self.last { self.same + 1 } else { 0 };
        self.last = value;
        self.count += 1;
        self.sum += value;
        self.square += value * value;
        let alive = self.same < self.patience;
        if self.same == self.patience {
            if self.dead == 0 {
                self.dead_from = line - self.patience.min(line - 1);
            }
            self.dead += 1;
        }
        if alive {
            self.ends[0].listen(value, line);
            self.ends[1].listen(-value, line);
        }
        alive
    }

    /// What is to be said of the channel.
    ///
    /// # Errors
    /// A sentence for one that is clipped too often, or in another unit than is said.
    pub(super) fn judged(self) -> Result<Vec<Message>, Refusal> {
        let name = &self.name;
        let mut remarks = Vec::new();
        let count = self.count.max(1) as f64;
        let (mean, rms) = (self.sum / count, (self.square / count).sqrt());
        for (what, other, value) in [("m/s²", "g", 1.0), ("g", "m/s²", STANDARD_GRAVITY * STANDARD_GRAVITY)] {
            if (mean.abs() / value - 1.0).abs() < NEAR {
                let shown = if value == 1.0 { mean } else { mean / STANDARD_GRAVITY };
                return Err(Refusal {
                    line: None,
                    message: say!(mean_is_gravity, mean = fixed(shown, 3), unit = what, other).about(name),
                    help: Some(say!(give_in_unit, unit = other)),
                });
            }
        }
        let clipped: usize = self.ends.iter().map(|end| end.clipped).sum();
        // What keeps one value from its beginning to its end is dead, and has no range to stand at the ends of.
        let varies = self.ends[0].value > -self.ends[1].value;
        if clipped > 0 && varies {
            let share = clipped as f64 / count;
            let percent = fixed(100.0 * share, 2);
            let line = self.ends.iter().filter(|end| end.clipped > 0).map(|end| end.line);
            let line = line.min().unwrap_or(0);
            let at = self.counting.at(line);
            let [high, low] = self.ends;
            let [high_end, low_end] = [high.value, -low.value].map(|end| fixed(end, 4));
            let sentence = match (high.clipped, low.clipped) {
                (1.., 1..) => {
                    say!(clipped_at_ends, high = high_end, low = low_end, count = clipped, share = percent, at)
                }
                (one, _) => say!(
                    clipped_at_end,
                    end = if one > 0 { high_end } else { low_end },
                    count = clipped,
                    share = percent,
                    at
                ),
            };
            if share > MOST_CLIPPED {
                let most = fixed(100.0 * MOST_CLIPPED, 0);
                let too_many = say!(too_many_are_clipped, sentence, most);
                return Err(self.counting.refuse(line, too_many.about(name)));
            }
            remarks.push(say!(levels_too_low_there, sentence).about(name));
        }
        if self.dead > 0 {
            let (time, at) = (fixed(1e3 * DEAD, 0), self.counting.at(self.dead_from));
            let drops_out = match self.dead {
                1 => say!(drops_out_once, time, at),
                count => say!(drops_out_often, count, time, at),
            };
            remarks.push(drops_out.about(name));
        }
        // As rough as the worst corrugation at any speed.
        const MOST: f64 = 2e3;
        if rms > MOST {
            let beyond = say!(vibrates_beyond_any_axle_box, rms = fixed(rms, 0));
            return Err(Refusal::new(None, beyond.about(name)));
        }
        Ok(remarks)
    }
}
