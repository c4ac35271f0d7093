//! Samples as they come, cut into pieces that fit into memory.

use super::counted_steps::{CountedSteps, LONGEST_STEP};
use super::sample::Sample;
use super::segment::Segment;
use super::{AxleBoxTransfer, PatchAverageProfile};
use crate::Error;
use crate::contact::ContactFilter;

/// Most samples of a segment besides its edges.
const LONGEST: usize = 1 << 18;
/// Highest over lowest speed of a segment.
const SPEEDS: f64 = 1.3;
/// Length of an edge in the longest wavelengths, at the lowest speed.
const EDGE: f64 = 10.0;
/// Time to either side over which positions are averaged \[s\]: an odometer counts in steps.
const SMOOTHING: f64 = 0.25;
/// Lowest and highest of no speeds.
const NOTHING_SEEN: (f64, f64) = (f64::INFINITY, 0.0);
/// Heights to the shortest wavelength.
const HEIGHTS: f64 = 5.0;

/// How a run is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunSettings {
    /// Samples per second \[Hz\].
    pub sampling_rate: f64,
    /// Shortest wavelength \[m\].
    pub shortest: f64,
    /// Longest wavelength \[m\].
    pub longest: f64,
    /// Lowest speed at which the train is listened to \[m/s\].
    pub slowest: f64,
    /// The contact patch, where roughness is to be that of the rail and not what the patch lets through of it.
    pub contact_filter: Option<ContactFilter>,
}

impl RunSettings {
    /// Wavelengths of 10 to 400 mm above 20 km/h, as the patch lets them through, at a sampling rate \[Hz\].
    pub fn at_rate(sampling_rate: f64) -> Self {
        Self { sampling_rate, shortest: 0.010, longest: 0.400, slowest: 20.0 / 3.6, contact_filter: None }
    }

    /// Step between heights \[m\].
    pub fn spacing(&self) -> f64 {
        self.shortest / HEIGHTS
    }

    /// Length at either end of a stretch that is lost at a speed \[m/s\]: \[m\].
    pub fn lost_at_ends(&self, speed: f64) -> f64 {
        speed * (EDGE * self.longest / self.slowest + SMOOTHING)
    }

    fn check(&self) -> Result<(), Error> {
        /// Longest wavelength of any axle box \[m\], and seconds in which the ends of a stretch must go by.
        const MOST: (f64, f64) = (100.0, 3600.0);
        /// Shortest wavelength: a hundredth of a patch \[m\].
        const SHORTEST: f64 = 1e-4;
        Error::unless_positive("sampling rate", self.sampling_rate, "Hz")?;
        if self.shortest.is_nan() || self.shortest < SHORTEST {
            return Err(Error::OutOfRange {
                quantity: "shortest wavelength",
                value: self.shortest,
                unit: "m",
                rule: "must be at least 0.0001 m",
            });
        }
        Error::unless_positive("lowest speed", self.slowest, "m/s")?;
        if !(self.longest <= MOST.0 && self.longest >= 2.0 * self.shortest) {
            return Err(Error::OutOfRange {
                quantity: "longest wavelength",
                value: self.longest,
                unit: "m",
                rule: "must be at least twice the shortest and at most 100 m",
            });
        }
        if EDGE * self.longest > MOST.1 * self.slowest {
            return Err(Error::OutOfRange {
                quantity: "lowest speed",
                value: self.slowest,
                unit: "m/s",
                rule: "must be such that ten of the longest waves go by within an hour",
            });
        }
        Ok(())
    }
}

/// A run of a train: samples in, roughness out.
///
/// Method: a position that stands still and then leaps is an odometer that counts in steps or is read seldom; between two leaps
/// no more than two seconds apart the train is taken to run evenly. Positions are averaged over half a second. What is slower than the lowest
/// speed parts the run into stretches. A stretch is cut into segments of at most 2¹⁸ samples within which the speed changes
/// by no more than a factor of 1.3, each divided by the transfer at its mean speed with ten of the longest waves before
/// and behind it, and laid out along the rail. The first and last ten of the longest waves of a stretch (at the lowest speed)
/// are lost. Memory: some 60 MB, however long the run. Cost: two transforms of a segment, a microsecond a sample.
pub struct Run<'a> {
    transfer: &'a AxleBoxTransfer,
    settings: RunSettings,
    /// Samples to either side over which positions are averaged.
    half: usize,
    /// Samples of an edge.
    edge: usize,
    counted: CountedSteps,
    raw: Vec<Sample>,
    stretch: Stretch,
    finished: Vec<PatchAverageProfile>,
}

/// Samples without a gap, from the edge before the present segment on.
struct Stretch {
    accelerations: Vec<f64>,
    positions: Vec<f64>,
    speeds: Vec<f64>,
    /// Samples of the segment looked at so far.
    seen: usize,
    /// Lowest and highest speed of these.
    range: (f64, f64),
    /// Samples of the segment, once that is known.
    own: Option<usize>,
}

impl<'a> Run<'a> {
    /// A run that has not begun.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a setting that is not above zero, or wavelengths less than an octave apart.
    pub fn new(transfer: &'a AxleBoxTransfer, settings: RunSettings) -> Result<Self, Error> {
        settings.check()?;
        let count = |time: f64| (time * settings.sampling_rate).ceil().max(1.0) as usize;
        Ok(Self {
            transfer,
            half: count(SMOOTHING),
            edge: count(EDGE * settings.longest / settings.slowest),
            counted: CountedSteps::new(count(LONGEST_STEP)),
            settings,
            raw: Vec::new(),
            stretch: Stretch::default(),
            finished: Vec::new(),
        })
    }

    /// The next sample.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a sampling rate too low for any wavelength at the speed.
    pub fn push(&mut self, sample: Sample) -> Result<(), Error> {
        self.counted.push(sample, &mut self.raw);
        // Many at a time, as sums of positions are begun anew each time.
        if self.raw.len() < 8 * self.half {
            return Ok(());
        }
        self.smooth()
    }

    /// The next sample of some channels, each with its acceleration; whether a segment of any is whole.
    ///
    /// # Errors
    /// Errors of [`push`](Self::push).
    pub fn push_each(runs: &mut [Self], accelerations: &[f64], position: f64) -> Result<bool, Error> {
        let mut is_whole = false;
        for (run, &acceleration) in runs.iter_mut().zip(accelerations) {
            run.push(Sample { acceleration, position })?;
            is_whole |= !run.finished.is_empty();
        }
        Ok(is_whole)
    }

    /// A gap, or the end: what comes next does not join on.
    ///
    /// # Errors
    /// Errors of [`push`](Self::push).
    pub fn interrupt(&mut self) -> Result<(), Error> {
        self.counted.end(&mut self.raw);
        self.smooth()?;
        self.raw.clear();
        self.end_stretch()
    }

    /// The roughness of segments that are whole by now, each handed out once.
    pub fn finished(&mut self) -> Vec<PatchAverageProfile> {
        std::mem::take(&mut self.finished)
    }

    /// Average the positions of all raw samples that have enough of them to either side.
    fn smooth(&mut self) -> Result<(), Error> {
        let (half, raw) = (self.half, std::mem::take(&mut self.raw));
        if raw.len() <= 2 * half {
            self.raw = raw;
            return Ok(());
        }
        let origin = raw[0].position;
        let window = (2 * half + 1) as f64;
        let time = 2.0 * half as f64 / self.settings.sampling_rate;
        let mut sum: f64 = raw[..2 * half].iter().map(|sample| sample.position - origin).sum();
        for middle in half..raw.len() - half {
            let (first, last) = (raw[middle - half].position, raw[middle + half].position);
            sum += last - origin;
            let (position, speed) = (origin + sum / window, (last - first) / time);
            sum -= first - origin;
            if speed < self.settings.slowest {
                self.end_stretch()?;
                continue;
            }
            let stretch = &mut self.stretch;
            stretch.accelerations.push(raw[middle].acceleration);
            stretch.positions.push(position);
            stretch.speeds.push(speed);
            self.cut()?;
        }
        self.raw.extend_from_slice(&raw[raw.len() - 2 * half..]);
        Ok(())
    }

    /// Look at the newest sample of the stretch, and hand on the segment that it completes.
    fn cut(&mut self) -> Result<(), Error> {
        while let Some(own) = self.stretch.own(self.edge)
            && self.stretch.speeds.len() >= own + 2 * self.edge
        {
            self.hand_on(own)?;
        }
        Ok(())
    }

    fn end_stretch(&mut self) -> Result<(), Error> {
        while let Some(left) = self.stretch.speeds.len().checked_sub(2 * self.edge)
            && left > 0
        {
            let own = self.stretch.own(self.edge).unwrap_or(left);
            self.hand_on(own.min(left))?;
        }
        self.stretch = Stretch::default();
        Ok(())
    }

    /// Divide so many samples behind the edge, and forget them but for the next edge.
    fn hand_on(&mut self, own: usize) -> Result<(), Error> {
        let end = own + 2 * self.edge;
        let segment = Segment {
            accelerations: &self.stretch.accelerations[..end],
            positions: &self.stretch.positions[..end],
            speeds: &self.stretch.speeds[..end],
            edge: self.edge,
        };
        self.finished.extend(segment.averaged_profile(self.transfer, &self.settings)?);
        self.stretch.forget(own);
        Ok(())
    }
}

impl Stretch {
    /// Samples of the present segment, if its end has been seen.
    fn own(&mut self, edge: usize) -> Option<usize> {
        let (mut slowest, mut fastest) = self.range;
        while self.own.is_none() && edge + self.seen < self.speeds.len() {
            let speed = self.speeds[edge + self.seen];
            (slowest, fastest) = (speed.min(slowest), speed.max(fastest));
            if fastest > SPEEDS * slowest || self.seen == LONGEST {
                self.own = Some(self.seen);
            } else {
                self.range = (slowest, fastest);
                self.seen += 1;
            }
        }
        self.own
    }

    fn forget(&mut self, count: usize) {
        self.accelerations.drain(..count);
        self.positions.drain(..count);
        self.speeds.drain(..count);
        (self.seen, self.range, self.own) = (0, NOTHING_SEEN, None);
    }
}

impl Default for Stretch {
    fn default() -> Self {
        Self {
            accelerations: Vec::new(),
            positions: Vec::new(),
            speeds: Vec::new(),
            seen: 0,
            range: NOTHING_SEEN,
            own: None,
        }
    }
}
