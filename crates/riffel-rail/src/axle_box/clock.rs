//! The clock of a run: samples per second by its times, and where these leave the line.

use riffel_keys::{Message, fixed, say};

/// Share by which samples per second may differ along a run that has one sampling rate.
const STEADY: f64 = 0.02;
/// Share from which a drift is said: a quartz keeps a ten thousandth, and no wave is misread for ten of them.
const DRIFT: f64 = 1e-3;
/// Rows of a block whose own rate is looked at.
const BLOCK: usize = 1024;
/// Parts of a run that are held against each other.
const PARTS: usize = 8;
/// Share of a deviation by which the expected time follows.
const FOLLOW: f64 = 1.0 / 16.0;

/// What is known of a clock.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Clock {
    /// Samples per second \[Hz\].
    pub(super) rate: f64,
    /// How far times lie apart that should lie on one line \[s\]: they are rounded, or stamped packet by packet.
    pub(super) jitter: f64,
}

/// How the time of a row follows that of the row before.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Tick {
    Steady,
    /// Later than a row: some are lost.
    Leap,
    /// Rows without time between them.
    Still,
    /// Earlier than before.
    Back,
}

impl Clock {
    /// By the times of some rows \[s\]; `None` if they do not rise.
    ///
    /// Method: the median of the differences over an eighth of the rows, which leaps between them do not move.
    pub(super) fn of(times: &[f64]) -> Option<Self> {
        let width = (times.len() / 8).max(1);
        let median = |mut values: Vec<f64>| {
            values.sort_by(f64::total_cmp);
            values.get(values.len() / 2).copied()
        };
        let ends = times.iter().zip(times.iter().skip(width));
        let step = median(ends.map(|(from, to)| (to - from) / width as f64).collect())?;
        if !(step > 0.0 && step.is_finite()) {
            return None;
        }
        let ranges = times.chunks_exact(width).map(|chunk| {
            let off = chunk.iter().zip(0u32..);
            let (low, high) = off
                .map(|(time, row)| time - chunk[0] - f64::from(row) * step)
                .fold((0.0f64, 0.0f64), |(low, high), off| (low.min(off), high.max(off)));
            high - low
        });
        Some(Self { rate: step.recip(), jitter: median(ranges.collect())? })
    }

    /// Farthest that a time may be from where it is expected \[s\].
    fn tolerance(&self) -> f64 {
        0.5 / self.rate + self.jitter
    }
}

/// Times of day over midnight.
#[derive(Debug, Default)]
pub(super) struct Midnights {
    last: f64,
    days: f64,
}

impl Midnights {
    /// A time of day \[s\], as the time since the first midnight: where it falls by more than half a day, another day has begun.
    pub(super) fn after(&mut self, time: f64) -> f64 {
        const DAY: f64 = 86_400.0;
        if time < self.last - 0.5 * DAY {
            self.days += 1.0;
        }
        if time.is_finite() {
            self.last = time;
        }
        time + self.days * DAY
    }
}

/// Times as they come, against the line on which they should lie.
#[derive(Debug)]
pub(super) struct Ticking {
    clock: Clock,
    expected: Option<f64>,
    last: f64,
}

impl Ticking {
    pub(super) fn new(clock: Clock) -> Self {
        Self { clock, expected: None, last: f64::NEG_INFINITY }
    }

    /// The time before \[s\].
    pub(super) fn last(&self) -> f64 {
        self.last
    }

    /// The next row, of which the time \[s\] may be missing.
    pub(super) fn tick(&mut self, time: f64) -> Tick {
        let expected = self.expected.map(|before| before + 1.0 / self.clock.rate);
        if !time.is_finite() {
            self.expected = expected;
            return Tick::Steady;
        }
        let last = std::mem::replace(&mut self.last, time);
        let Some(expected) = expected else {
            self.expected = Some(time);
            return Tick::Steady;
        };
        let (off, tolerance) = (time - expected, self.clock.tolerance());
        let tick = if time < last - self.clock.jitter {
            Tick::Back
        } else if off > tolerance {
            Tick::Leap
        } else if off < -tolerance {
            Tick::Still
        } else {
            Tick::Steady
        };
        self.expected = Some(match tick {
            Tick::Steady => expected + FOLLOW * off,
            _ => time,
        });
        tick
    }
}

/// Sums of a regression of times on the numbers of their rows, about their means.
#[derive(Debug, Clone, Copy, Default)]
struct Sums {
    count: f64,
    mean_row: f64,
    mean_time: f64,
    rows: f64,
    times: f64,
}

impl Sums {
    fn add(&mut self, row: f64, time: f64) {
        self.count += 1.0;
        let (from_row, from_time) = (row - self.mean_row, time - self.mean_time);
        self.mean_row += from_row / self.count;
        self.mean_time += from_time / self.count;
        self.rows += from_row * (row - self.mean_row);
        self.times += from_row * (time - self.mean_time);
    }
}

/// The rate of a whole run: the slope that lines through all its rows have in common, one line between two leaps.
#[derive(Debug)]
pub(super) struct Regression {
    clock: Clock,
    ticking: Ticking,
    row: f64,
    stretch: Sums,
    block: Sums,
    /// Sums over stretches: rows with rows, and rows with times.
    all: (f64, f64),
    /// Sums over each block, with its rows.
    blocks: Vec<(f64, f64)>,
    rows: f64,
}

impl Regression {
    pub(super) fn new(clock: Clock) -> Self {
        Self {
            clock,
            ticking: Ticking::new(clock),
            row: 0.0,
            stretch: Sums::default(),
            block: Sums::default(),
            all: (0.0, 0.0),
            blocks: Vec::new(),
            rows: 0.0,
        }
    }

    /// The time of the next row \[s\].
    pub(super) fn add(&mut self, time: f64) {
        self.row += 1.0;
        let tick = self.ticking.tick(time);
        if tick != Tick::Steady {
            self.close(true);
        }
        if time.is_finite() && matches!(tick, Tick::Steady | Tick::Leap) {
            self.stretch.add(self.row, time);
            self.block.add(self.row, time);
            if self.block.count as usize == BLOCK {
                self.close(false);
            }
        }
    }

    fn close(&mut self, stretch: bool) {
        let block = std::mem::take(&mut self.block);
        if block.count as usize >= BLOCK / 2 {
            self.blocks.push((block.rows, block.times));
        }
        if stretch {
            let sums = std::mem::take(&mut self.stretch);
            self.all.0 += sums.rows;
            self.all.1 += sums.times;
            self.rows = self.rows.max(sums.count);
        }
    }

    /// The clock of the whole run, with a sentence where it drifts.
    ///
    /// # Errors
    /// A sentence for times without one sampling rate.
    pub(super) fn finish(mut self) -> Result<(Clock, Option<Message>), Message> {
        self.close(true);
        let slope = |(rows, times): (f64, f64)| rows / times;
        let rate = slope(self.all);
        if !(rate > 0.0 && rate.is_finite()) {
            return Ok((self.clock, None));
        }
        // The error of a slope by rounded times, of which no more digits are known than it leaves.
        let error = |rows: f64| 3.0 * self.clock.jitter * rate / rows.powf(1.5);
        let rounded = |rate: f64, error: f64| {
            let certain = (-error.max(1e-9).log10()).floor() as i32;
            let digits = 10f64.powi(certain.max(3) - 1 - rate.log10().floor() as i32);
            (rate * digits).round() / digits
        };
        let clock = Clock { rate: rounded(rate, error(self.rows)), jitter: self.clock.jitter };
        let part = self.blocks.len().div_ceil(PARTS).max(1);
        let parts = self.blocks.chunks(part).map(|blocks| {
            let sum = |sum: (f64, f64), one: &(f64, f64)| (sum.0 + one.0, sum.1 + one.1);
            slope(blocks.iter().fold((0.0, 0.0), sum))
        });
        let (slowest, fastest) = parts.fold((rate, rate), |(low, high), rate| (low.min(rate), high.max(rate)));
        let drift = fastest / slowest - 1.0;
        let unsure = error(BLOCK as f64 / 2.0);
        if drift.is_nan() || drift <= DRIFT + unsure {
            return Ok((clock, None));
        }
        let [slowest, fastest] = [slowest, fastest].map(|rate| rounded(rate, unsure.max(1e-5)));
        match drift > STEADY {
            true => Err(say!(clock_without_one_rate, slowest, fastest, percent = fixed(100.0 * STEADY, 0))),
            false => {
                let drifts = say!(clock_drifts, slowest, fastest, rate = clock.rate);
                Ok((clock, Some(drifts)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rate of times, and what is said of them.
    fn rate(times: &[f64]) -> Result<(f64, Option<String>), String> {
        let clock = Clock::of(&times[..times.len().min(2500)]).unwrap();
        let mut regression = Regression::new(clock);
        times.iter().for_each(|time| regression.add(*time));
        let shown = |said: Message| said.to_string();
        let found = regression.finish().map_err(shown)?;
        Ok((found.0.rate, found.1.map(shown)))
    }

    fn rounded(time: f64, step: f64) -> f64 {
        (time / step).round() * step
    }

    /// Rounded to steps longer and shorter than a sample, whose mean over neighbours says 5321 Hz for 6000.
    #[test]
    fn rounded_times_have_the_rate_of_all_rows() {
        for hertz in [1000.0, 2500.0, 4096.0, 6000.0, 6250.0, 20_000.0] {
            for step in [1e-6, 1e-4, 1e-3, 1e-2] {
                let times: Vec<f64> = (0..20_000).map(|n| rounded(f64::from(n) / hertz, step)).collect();
                let (found, said) = rate(&times).unwrap();
                assert!((found / hertz - 1.0).abs() < 1e-4, "{hertz} {step} {found}");
                assert_eq!(said, None, "{hertz} {step}");
            }
        }
        // Five thousand rows tell the fifth digit.
        let times: Vec<f64> = (0..5000).map(|n| rounded(f64::from(n) / 6000.0, 1e-4)).collect();
        assert_eq!(rate(&times).unwrap().0, 6000.0);
    }

    /// 37 ms lost each 0.4 s are leaps, and no slower clock.
    #[test]
    fn lost_packets_do_not_slow_the_clock() {
        let time = |n: u32| f64::from(n) / 6000.0 + 0.037 * f64::from(n / 2400);
        let times: Vec<f64> = (0..24_000).map(time).collect();
        assert_eq!(rate(&times).unwrap(), (6000.0, None));
        let mut ticking = Ticking::new(Clock::of(&times[..2500]).unwrap());
        let leaps = times.iter().filter(|time| ticking.tick(**time) == Tick::Leap);
        assert_eq!(leaps.count(), 9);
    }

    #[test]
    fn a_time_that_is_repeated_stands_still() {
        let mut times: Vec<f64> = (0..3000).map(|n| f64::from(n) / 1000.0).collect();
        times.insert(1500, times[1499]);
        let mut ticking = Ticking::new(Clock::of(&times).unwrap());
        let ticks: Vec<Tick> = times.iter().map(|time| ticking.tick(*time)).collect();
        let odd = ticks.iter().filter(|tick| **tick != Tick::Steady);
        assert_eq!((odd.count(), ticks[1500]), (1, Tick::Still));
        assert_eq!(rate(&times).unwrap(), (1000.0, None));
    }

    /// A clock that runs faster and faster by half a per cent is said, by three per cent refused.
    #[test]
    fn a_drift_is_said() {
        let drifting = |share: f64| -> Vec<f64> {
            let time = |n: i32| {
                let at = f64::from(n) / 16_000.0;
                8.0 * (at - 0.5 * share * at * at)
            };
            (0..16_000).map(time).collect()
        };
        let (found, said) = rate(&drifting(0.005)).unwrap();
        assert!((found / 2005.0 - 1.0).abs() < 2e-4, "{found}");
        let said = said.unwrap();
        // The means of the first and the last eighth.
        assert!(said.contains("2001 to 2009 samples"), "{said}");
        assert_eq!(rate(&drifting(0.0005)).unwrap().1, None);
        let refused = rate(&drifting(0.03)).unwrap_err();
        assert!(refused.contains("must make one rate to 2 %"), "{refused}");
    }
}
