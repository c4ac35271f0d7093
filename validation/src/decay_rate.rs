//! Track decay rates measured at one site, and those of a track with two fitted numbers.

use std::sync::LazyLock;
use std::thread;

use riffel::Direction;
use riffel::receptance::DecayRate;

use crate::Row;
use crate::ground::{extent, nominal};

const CURVES: &str = include_str!("../reference/decay-rate/niederwangen.csv");

/// Keys over the nominal case that make it the assumed track; the pad is fitted.
const ASSUMED: [&str; 6] = [
    "steel.youngs_modulus=210 GPa",
    "rail.section=60E1",
    "rail.loss_factor=0.02",
    "track.model=two-layer-periodic",
    "track.preset=ballasted-stiff-pads",
    "track.sleeper.mass=145 kg",
];

/// Pad stiffness \[N/m\] of the preset above, the origin of the search.
const PRESET_STIFFNESS: f64 = 300e6;
/// Pad loss factor \[-\] of the preset above, the origin of the search.
const PRESET_LOSS_FACTOR: f64 = 0.25;
/// Finest steps of the search to a factor of two: 1.1 % each.
const STEPS_PER_OCTAVE: i32 = 64;

/// What the measured curves say of one band.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredBand {
    /// Nominal centre frequency \[Hz\].
    pub nominal_frequency: f64,
    /// Decay rates \[dB/m\]: least, lower quartile, median, upper quartile, greatest.
    pub quartiles: [f64; 5],
}

impl MeasuredBand {
    /// Median decay rate \[dB/m\].
    pub fn median(&self) -> f64 {
        self.quartiles[2]
    }

    /// 10 lg of a decay rate over the median \[dB\].
    pub fn level(&self, decay_rate: f64) -> f64 {
        10.0 * (decay_rate / self.median()).log10()
    }
}

/// The vertical decay rates measured at Niederwangen on rails without dampers.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// Decay rates \[dB/m\] by band, one list a curve: a section, a rail and a date.
    pub curves: Vec<Vec<f64>>,
    /// The bands of EN 15461.
    pub bands: Vec<MeasuredBand>,
}

/// A pad, and how near its track comes to the measured median.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// Pad stiffness \[N/m\] per rail seat.
    pub pad_stiffness: f64,
    /// Pad loss factor \[-\].
    pub pad_loss_factor: f64,
    /// Computed decay rates \[dB/m\] by band.
    pub decay_rates: Vec<f64>,
    /// Root mean square over the bands of 10 lg(computed/median) \[dB\].
    pub residual: f64,
}

/// The measured curves.
pub static MEASUREMENT: LazyLock<Measurement> = LazyLock::new(|| {
    let bands = DecayRate::NOMINAL_FREQUENCIES;
    let mut curves: Vec<(&str, Vec<f64>)> = Vec::new();
    for line in CURVES.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let (curve, rate) = (cells[0], cells[6].parse().expect("a number"));
        match curves.last_mut() {
            Some((last, rates)) if *last == curve => rates.push(rate),
            _ => curves.push((curve, vec![rate])),
        }
    }
    let curves: Vec<Vec<f64>> = curves.into_iter().map(|(_, rates)| rates).collect();
    let bands = bands
        .iter()
        .enumerate()
        .map(|(band, &nominal_frequency)| {
            let mut rates: Vec<f64> = curves.iter().map(|curve| curve[band]).collect();
            rates.sort_by(f64::total_cmp);
            MeasuredBand {
                nominal_frequency,
                quartiles: [0.0, 0.25, 0.5, 0.75, 1.0].map(|share| quantile(&rates, share)),
            }
        })
        .collect();
    Measurement { curves, bands }
});

/// The fit under the assumptions of the book.
pub static FIT: LazyLock<Fit> = LazyLock::new(|| {
    let wide = Search { changes: &[], directions: &STIFFNESS_AND_LOSS };
    wide.best_from(wide.best_of_grid(), STEPS_PER_OCTAVE / 2).fit()
});

/// Value below which the given share of sorted values lies, linear between two of them.
fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let (below, above) = (place.floor() as usize, place.ceil() as usize);
    sorted[below] + (place - place.floor()) * (sorted[above] - sorted[below])
}

/// Root mean square over the bands of 10 lg(decay rate/median) \[dB\].
fn distance(decay_rates: &[f64]) -> f64 {
    let bands = &MEASUREMENT.bands;
    let squares: f64 = bands.iter().zip(decay_rates).map(|(band, &rate)| band.level(rate).powi(2)).sum();
    (squares / bands.len() as f64).sqrt()
}

/// Stiffness and loss factor of the pad as steps of 1/64 octave from those of the preset. Whole
/// steps give the same fit on every machine.
type Pad = (i32, i32);

const STIFFNESS_ONLY: [Pad; 2] = [(1, 0), (-1, 0)];
const STIFFNESS_AND_LOSS: [Pad; 4] = [(1, 0), (-1, 0), (0, 1), (0, -1)];

/// Least squares of 10 lg(computed/median) over the bands.
struct Search {
    /// Keys that differ from [`ASSUMED`].
    changes: &'static [&'static str],
    /// Steps the search may take.
    directions: &'static [Pad],
}

/// A pad with its track.
struct Trial {
    pad: Pad,
    decay_rates: Vec<f64>,
    residual: f64,
}

impl Search {
    fn trial(&self, pad: Pad) -> Trial {
        let keys = [
            format!("track.pad.stiffness={} N/m", stiffness(pad)),
            format!("track.pad.loss_factor={}", loss_factor(pad)),
        ];
        let mut overrides = ASSUMED.to_vec();
        overrides.extend(self.changes);
        overrides.extend(keys.iter().map(String::as_str));
        let track = nominal(&overrides).track_in(Direction::Vertical);
        let structure = track.expect("a vertical track").structure;
        let rates = DecayRate::of_track(&*structure.expect("a track on supports"));
        let decay_rates: Vec<f64> = rates.iter().map(|rate| rate.decay_rate).collect();
        Trial { pad, residual: distance(&decay_rates), decay_rates }
    }

    /// The best of 25 pads an octave apart, 75–1200 MN/m and 0.125–2.
    fn best_of_grid(&self) -> Trial {
        let octaves = (-2..=2).flat_map(|i| (-1..=3).map(move |j| (i, j)));
        octaves
            .map(|(i, j)| self.trial((i * STEPS_PER_OCTAVE, j * STEPS_PER_OCTAVE)))
            .min_by(|a, b| a.residual.total_cmp(&b.residual))
            .expect("a grid")
    }

    /// Steps to a better neighbour until there is none, then halves the step, down to one.
    fn best_from(&self, start: Trial, step: i32) -> Trial {
        let mut best = start;
        let mut step = step;
        while step > 0 {
            let pad = best.pad;
            let better = self
                .directions
                .iter()
                .map(|(i, j)| self.trial((pad.0 + i * step, pad.1 + j * step)))
                .find(|trial| trial.residual < best.residual);
            match better {
                Some(trial) => best = trial,
                None => step /= 2,
            }
        }
        best
    }
}

impl Trial {
    fn fit(self) -> Fit {
        Fit {
            pad_stiffness: stiffness(self.pad),
            pad_loss_factor: loss_factor(self.pad),
            decay_rates: self.decay_rates,
            residual: self.residual,
        }
    }
}

fn stiffness(pad: Pad) -> f64 {
    PRESET_STIFFNESS * octaves(pad.0)
}

fn loss_factor(pad: Pad) -> f64 {
    PRESET_LOSS_FACTOR * octaves(pad.1)
}

fn octaves(steps: i32) -> f64 {
    (f64::from(steps) / f64::from(STEPS_PER_OCTAVE)).exp2()
}

/// The fit in one sentence of Markdown.
pub fn fit_in_words() -> String {
    let typical = typical_distance();
    format!(
        "Fitted: **pad stiffness {:.0} MN/m, pad loss factor {:.2}**, root mean square residual {:.2} dB over\n\
         the 18 bands. A single measured curve is {typical:.2} dB from the median (the middle one of the {}).\n",
        FIT.pad_stiffness / 1e6,
        FIT.pad_loss_factor,
        FIT.residual,
        MEASUREMENT.curves.len(),
    )
}

/// Measured and computed decay rates by band, as a Markdown table.
pub fn table_by_band() -> String {
    let mut text = String::from(
        "| band Hz | median dB/m | quartiles | all curves | computed dB/m | residual dB | lies |\n\
         |---:|---:|---:|---:|---:|---:|---|\n",
    );
    for (band, &computed) in MEASUREMENT.bands.iter().zip(&FIT.decay_rates) {
        let [least, lower, median, upper, greatest] = band.quartiles;
        let place = if (lower..=upper).contains(&computed) {
            "within the quartiles"
        } else if (least..=greatest).contains(&computed) {
            "within the curves"
        } else {
            "**outside all curves**"
        };
        text.push_str(&format!(
            "| {} | {median:.2} | {lower:.1} … {upper:.1} | {least:.1} … {greatest:.1} | {computed:.1} | {:+.1} \
             | {place} |\n",
            band.nominal_frequency,
            band.level(computed),
        ));
    }
    text
}

/// What is fitted where one assumption is another, as a Markdown table.
///
/// Cost: some 350 tracks, ten seconds on one processor.
pub fn table_by_assumption() -> String {
    let pads_fitted = |changes| Search { changes, directions: &STIFFNESS_AND_LOSS };
    let variants = [
        ("rail loss factor 0.01", pads_fitted(&["rail.loss_factor=0.01"])),
        ("rail loss factor 0.001", pads_fitted(&["rail.loss_factor=0.001"])),
        ("rail 54E1", pads_fitted(&["rail.section=54E1"])),
        ("spacing 0.63 m", pads_fitted(&["track.support_spacing=0.63 m"])),
        ("sleeper 177.5 kg (B90)", pads_fitted(&["track.sleeper.mass=177.5 kg"])),
        ("ballast 100 MN/m", pads_fitted(&["track.ballast.stiffness=100 MN/m"])),
        (
            "ballast 40 MN/m, viscous 47 kNs/m",
            pads_fitted(&[
                "track.ballast.stiffness=40 MN/m",
                "track.ballast.damping=47 kNs/m",
                "track.ballast.loss_factor=0",
            ]),
        ),
        ("pad loss factor held at 0.25", Search { changes: &[], directions: &STIFFNESS_ONLY }),
    ];
    let fits = thread::scope(|scope| {
        let running: Vec<_> = variants
            .iter()
            .map(|(words, search)| {
                scope.spawn(move || {
                    // A loss factor that is held stays that of the preset.
                    let held = search.directions == STIFFNESS_ONLY;
                    let near = FIT.pad();
                    let start = (near.0, if held { 0 } else { near.1 });
                    let trial = search.best_from(search.trial(start), STEPS_PER_OCTAVE / 4);
                    (*words, trial.fit())
                })
            })
            .collect();
        let finished = running.into_iter().map(|thread| thread.join());
        finished.collect::<Result<Vec<_>, _>>().expect("threads that do not panic")
    });
    let mut text = String::from(
        "| assumption | pad MN/m | pad loss factor | residual dB rms | 100 Hz | 1000 Hz | 1250 Hz | 2000 Hz |\n\
         |---|---:|---:|---:|---:|---:|---:|---:|\n",
    );
    let book = ("as in the figure", FIT.clone());
    for (words, fit) in std::iter::once(book).chain(fits) {
        let levels = [100.0, 1000.0, 1250.0, 2000.0].map(|frequency| {
            let mut bands = MEASUREMENT.bands.iter().zip(&fit.decay_rates);
            let (band, &rate) =
                bands.find(|(band, _)| band.nominal_frequency == frequency).expect("a band of EN 15461");
            format!("{:+.1}", band.level(rate))
        });
        text.push_str(&format!(
            "| {words} | {:.0} | {:.2} | {:.2} | {} |\n",
            fit.pad_stiffness / 1e6,
            fit.pad_loss_factor,
            fit.residual,
            levels.join(" | "),
        ));
    }
    text
}

impl Fit {
    fn pad(&self) -> Pad {
        let steps = |ratio: f64| (ratio.log2() * f64::from(STEPS_PER_OCTAVE)).round() as i32;
        (steps(self.pad_stiffness / PRESET_STIFFNESS), steps(self.pad_loss_factor / PRESET_LOSS_FACTOR))
    }
}

/// Median over the measured curves of their own distance from the median curve \[dB\].
fn typical_distance() -> f64 {
    let mut distances: Vec<f64> = MEASUREMENT.curves.iter().map(|curve| distance(curve)).collect();
    distances.sort_by(f64::total_cmp);
    quantile(&distances, 0.5)
}

/// Nominal frequencies \[Hz\] of the greatest rate, and of the first band above it that is lower than
/// both its neighbours.
fn peak_and_dip(decay_rates: &[f64]) -> Option<[f64; 2]> {
    let bands = DecayRate::NOMINAL_FREQUENCIES;
    let peak = (0..bands.len()).max_by(|&a, &b| decay_rates[a].total_cmp(&decay_rates[b]))?;
    let lower = |a: usize, b: usize| decay_rates[a] < decay_rates[b];
    let dip = (peak + 1..bands.len() - 1).find(|&n| lower(n, n - 1) && lower(n, n + 1))?;
    Some([bands[peak], bands[dip]])
}

pub(crate) fn decay_rate_peak_and_dip() -> Row {
    let medians: Vec<f64> = MEASUREMENT.bands.iter().map(MeasuredBand::median).collect();
    let expected = peak_and_dip(&medians);
    let got = peak_and_dip(&FIT.decay_rates);
    let words = |found: Option<[f64; 2]>| match found {
        Some([peak, dip]) => format!("peak at {peak} Hz, dip at {dip} Hz"),
        None => "no dip".to_owned(),
    };
    Row {
        statement: "Vertical decay rates of a Swiss track: the band of the greatest rate, and that of the \
                    pinned-pinned dip",
        source: "`decay-rate/niederwangen.csv`, median of 16 curves",
        expected: words(expected),
        got: words(got),
        tolerance: "none: the same bands. Pad stiffness is fitted; rail, spacing and sleeper, which place the dip, \
                    are assumed beforehand",
        holds: got.is_some() && got == expected,
    }
}

pub(crate) fn decay_rate_residual() -> Row {
    let typical = typical_distance();
    Row {
        statement: "… and a track with two fitted numbers is as near to their median as a measured curve is",
        source: "`decay-rate/niederwangen.csv`, 16 curves of 18 bands",
        expected: format!("root mean square of 10 lg(rate/median) ≤ {typical:.2} dB"),
        got: format!(
            "{:.2} dB with pads of {:.0} MN/m, loss factor {:.2}",
            FIT.residual,
            FIT.pad_stiffness / 1e6,
            FIT.pad_loss_factor
        ),
        tolerance: "the middle one of the curves' own distances: sections, rails and dates differ by as much",
        holds: FIT.residual <= typical,
    }
}

pub(crate) fn decay_rate_within_the_curves() -> Row {
    let outside: Vec<String> = MEASUREMENT
        .bands
        .iter()
        .zip(&FIT.decay_rates)
        .filter(|(band, computed)| {
            let (least, greatest) = extent(band.quartiles);
            !(least..=greatest).contains(*computed)
        })
        .map(|(band, &computed)| {
            let level = band.level(computed);
            format!("{} Hz ({level:+.1} dB)", band.nominal_frequency)
        })
        .collect();
    Row {
        statement: "… and between the least and the greatest measured rate in every band but that above the dip",
        source: "`decay-rate/niederwangen.csv`, 16 curves",
        expected: "outside: 1250 Hz".to_owned(),
        got: format!("outside: {}", outside.join(", ")),
        tolerance: "the spread of the curves; 1250 Hz is a known distance of the model, held where it is",
        holds: outside.len() == 1 && outside[0].starts_with("1250 Hz"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The copy is whole: 16 curves, each with the 18 bands in order.
    #[test]
    fn sixteen_curves_of_eighteen_bands() {
        let bands = DecayRate::NOMINAL_FREQUENCIES;
        assert_eq!(MEASUREMENT.curves.len(), 16);
        assert!(MEASUREMENT.curves.iter().all(|curve| curve.len() == 18));
        for (line, expected) in CURVES.lines().skip(1).zip(bands.iter().cycle()) {
            let frequency: f64 = line.split(',').nth(5).unwrap().parse().unwrap();
            assert_eq!(frequency, *expected);
        }
    }

    /// The fit is a minimum: no pad within 5 % or 20 %, in any direction, comes nearer.
    #[test]
    fn no_neighbour_fits_better() {
        let search = Search { changes: &[], directions: &STIFFNESS_AND_LOSS };
        let (i, j) = FIT.pad();
        assert_eq!(search.trial((i, j)).residual, FIT.residual);
        for step in [5, 17] {
            for (di, dj) in [(1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (0, 1)] {
                let neighbour = search.trial((i + di * step, j + dj * step));
                assert!(neighbour.residual > FIT.residual, "{di} {dj} {step}");
            }
        }
    }
}
