//! Roughness of made profiles whose answer is known, and of the rails of one Swiss site.

use std::f64::consts::TAU;

use riffel::contact::ContactFilter;
use riffel::diagnosis::{
    Evidence, Expectation, GrowthDensity, Instrument, LevelTrend, Mechanism, MechanismKind, TimeUnit, TrafficSpeeds,
    TrendPoint, dominant_levels, rank,
};
use riffel::roughness::{
    BandPass, ColouredNoise, Irregularity, Profile, Recipe, Spectrum, SpikeCriterion, ThirdOctave, WHEEL_RADIUS,
    WavelengthBand, moving_peak_to_peak, moving_rms,
};
use riffel_case::traffic;

use crate::Row;

const SPECTRA: &str = include_str!("../reference/sbb-track-noise/rail_roughness.csv");
const PASS_BYS: &str = include_str!("../reference/sbb-track-noise/passby_levels.csv");

const SPACING: f64 = 1e-3;

fn recipe(length: f64) -> Recipe {
    Recipe { length, spacing: SPACING, seed: 15610, ..Recipe::default() }
}

fn profile(heights: Vec<f64>) -> Profile {
    Profile::new(0.0, SPACING, heights).expect("finite heights")
}

fn wave(samples: usize, amplitude: f64, wavelength: f64) -> Vec<f64> {
    let height = |i: usize| amplitude * (TAU * i as f64 * SPACING / wavelength + 0.4).sin();
    (0..samples).map(height).collect()
}

fn spectrum(heights: Vec<f64>, longest: f64) -> Spectrum {
    Spectrum::of_record(&[profile(heights)], longest).expect("a record of some metres")
}

/// Wavelengths of 20 to 400 mm in the middles of their bands, and between.
fn wavelengths() -> impl Iterator<Item = f64> {
    (-68..=-16).step_by(4).map(|quarter| 10f64.powf(f64::from(quarter) / 40.0))
}

pub(crate) fn sinusoid_level() -> Row {
    let errors = wavelengths().map(|wavelength| {
        let band = ThirdOctave::containing(wavelength).expect("a wavelength");
        let level = spectrum(wave(50_000, 3e-6, wavelength), 0.4).level(band);
        (level.expect("a band of the spectrum") - 10.0 * 4.5f64.log10()).abs()
    });
    let worst = errors.fold(0.0, f64::max);
    Row {
        statement: "A sinusoid of 3 µm has its level in its band, 20–400 mm",
        source: "10 lg(A²/2) dB re 1 µm",
        expected: "6.53 dB".to_owned(),
        got: format!("6.53 dB within {worst:.3} dB"),
        tolerance: "0.02 dB: waves that do not fit the segment a whole number of times",
        holds: worst <= 0.02,
    }
}

pub(crate) fn sinusoid_leakage() -> Row {
    let highest = wavelengths()
        .flat_map(|wavelength| {
            let own = ThirdOctave::containing(wavelength).expect("a wavelength").index();
            let spectrum = spectrum(wave(50_000, 3e-6, wavelength), 0.4);
            let far = spectrum.levels().to_vec().into_iter();
            far.filter(move |level| (level.band.index() - own).abs() >= 2).map(|level| level.level)
        })
        .fold(f64::NEG_INFINITY, f64::max);
    Row {
        statement: "The same leaks nothing into bands two away",
        source: "EN 15610:2009, method A",
        expected: "nothing".to_owned(),
        got: format!("at most {highest:.0} dB re 1 µm"),
        tolerance: "below −30 dB, 36 dB under the wave: side lobes of the Hann window",
        holds: highest < -30.0,
    }
}

fn noise(slope: f64) -> f64 {
    let noise = ColouredNoise { level: 0.0, wavelength: 0.1, slope, longest: 3.0 };
    let made = Recipe { noise: Some(noise), ..recipe(1000.0) };
    let heights = made.heights().expect("a recipe");
    let spectrum = spectrum(heights, 0.4);
    let bands = spectrum.levels().iter();
    bands
        .filter(|level| level.band.wavelength() < 0.17)
        .map(|level| (level.level - noise.level_at(level.band.wavelength())).abs())
        .fold(0.0, f64::max)
}

fn noise_row(statement: &'static str, slope: f64) -> Row {
    let worst = noise(slope);
    Row {
        statement,
        source: "noise of 1 km made with this spectrum",
        expected: format!("0 dB at 100 mm, {slope} dB a decade of wavelength"),
        got: format!("within {worst:.2} dB, 2.5–160 mm"),
        tolerance: "0.3 dB: chance of a band of 1 400 lines, 0.12 dB, and its worst in 19 bands",
        holds: worst <= 0.3,
    }
}

pub(crate) fn white_noise_spectrum() -> Row {
    noise_row("White noise returns its spectrum", -10.0)
}

pub(crate) fn coloured_noise_spectrum() -> Row {
    noise_row("Coloured noise returns its spectrum", 20.0)
}

pub(crate) fn spikes_and_pits() -> Row {
    let at = |first: f64, height: f64, width: f64| {
        let place = move |k: u32| first + 2.0 * f64::from(k);
        (0..20).map(move |k| Irregularity { at: place(k), height, width })
    };
    let dirty =
        Recipe { spikes: at(1.0, 80e-6, 4e-3).collect(), pits: at(2.0, 120e-6, 8e-3).collect(), ..recipe(45.0) };
    let heights = dirty.heights().expect("a recipe");
    let clean = wave(heights.len(), 3e-6, 0.1);
    let heights = heights.iter().zip(&clean).map(|(dirt, wave)| dirt + wave).collect();
    let mut profile = profile(heights);
    let spikes = profile.remove_spikes(SpikeCriterion::EN_15610).len();
    let pits = profile.roll_over(WHEEL_RADIUS, riffel::roughness::PIT_DEPTH).len();
    let left = profile.heights().iter().zip(&clean);
    let left = left.map(|(found, clean)| (found - clean).abs()).fold(0.0, f64::max);
    // The wheel sags into a pit of 8 mm by w²/8R.
    let sag = 8e-3f64.powi(2) / (8.0 * WHEEL_RADIUS);
    Row {
        statement: "20 spikes of 80 µm and 4 mm go, 20 pits of 120 µm and 8 mm are bridged by the wheel",
        source: "EN 15610:2009, spikes and curvature",
        expected: format!("20, 20, {:.1} µm left: the sag w²/8R of the wheel", 1e6 * sag),
        got: format!("{spikes}, {pits}, {:.1} µm left", 1e6 * left),
        tolerance: "0.8 µm: the rise of the wave of 3 µm and 100 mm over half a pit",
        holds: spikes == 20 && pits == 20 && (left - sag).abs() < 0.8e-6,
    }
}

pub(crate) fn sinusoids_are_left_alone() -> Row {
    let mut untouched = 0;
    let waves = [(3e-6, 0.02), (10e-6, 0.05), (30e-6, 0.15), (100e-6, 0.5)];
    for (amplitude, wavelength) in waves {
        let heights = wave(20_000, amplitude, wavelength);
        let mut profile = profile(heights.clone());
        let spikes = profile.remove_spikes(SpikeCriterion::EN_15610);
        let pits = profile.roll_over(WHEEL_RADIUS, riffel::roughness::PIT_DEPTH);
        untouched += usize::from(spikes.is_empty() && pits.is_empty() && profile.heights() == heights);
    }
    Row {
        statement: "Sinusoids of 3 µm at 20 mm to 100 µm at 500 mm are left alone by both",
        source: "EN 15610:2009; slopes below half a step over R",
        expected: "4 of 4, to the last bit".to_owned(),
        got: format!("{untouched} of 4"),
        tolerance: "none",
        holds: untouched == 4,
    }
}

pub(crate) fn moving_statistics() -> Row {
    let made = Recipe {
        noise: Some(ColouredNoise { level: 10.0, wavelength: 0.1, slope: 20.0, longest: 3.0 }),
        ..recipe(20.0)
    };
    let heights = made.heights().expect("a recipe");
    let window = 1000;
    let (rms, peaks) = (moving_rms(&heights, window), moving_peak_to_peak(&heights, window));
    let (mut worst, mut same) = (0f64, 0);
    // Every seventh window: the double loop is slow.
    for (index, values) in heights.windows(window).enumerate().step_by(7) {
        let (mut sum, mut low, mut high) = (0.0, f64::INFINITY, f64::NEG_INFINITY);
        for &value in values {
            sum += value * value;
            low = low.min(value);
            high = high.max(value);
        }
        let expected = (sum / window as f64).sqrt();
        worst = worst.max((rms[index] / expected - 1.0).abs());
        same += usize::from(peaks[index] == high - low);
    }
    let compared = heights.windows(window).step_by(7).count();
    Row {
        statement: "Moving RMS and peak-to-peak value over 1 m are those of two nested loops",
        source: "their definition",
        expected: format!("{compared} windows"),
        got: format!("RMS within {worst:.0e}, {same} peak-to-peak values the same"),
        tolerance: "1e-10 of the RMS, rounding of sums of 16384; nothing for the other",
        holds: worst <= 1e-10 && same == compared,
    }
}

pub(crate) fn band_pass_error() -> Row {
    let samples = 60_000;
    let bands = &WavelengthBand::GRINDING[..3];
    let mut truth = vec![vec![0.0; samples]; bands.len()];
    let mut heights = vec![0.0; samples];
    // A rough rail, 5 dB at 100 mm and 15 dB a decade, ten waves to a band at wavelengths that no
    // transform has, and corrugation of 15 µm at 43 mm.
    let waves = (-230..=0).map(|place| {
        let wavelength = 10f64.powf((f64::from(place) + 0.37) / 100.0);
        let level = 5.0 + 15.0 * (wavelength / 0.1).log10() - 10.0;
        (wavelength, 1e-6 * (2.0 * 10f64.powf(level / 10.0)).sqrt())
    });
    for (index, (wavelength, amplitude)) in waves.chain([(0.043, 15e-6)]).enumerate() {
        let phase = 2.4 * index as f64;
        let own = bands.iter().position(|band| band.from() <= wavelength && wavelength < band.to());
        for (sample, height) in heights.iter_mut().enumerate() {
            let value = amplitude * (TAU * sample as f64 * SPACING / wavelength + phase).sin();
            *height += value;
            if let Some(own) = own {
                truth[own][sample] += value;
            }
        }
    }
    let bank = BandPass::new(SPACING, samples, bands).expect("bands above two samples");
    let inside = 2000..samples - 2000;
    let errors: Vec<f64> = bank
        .filter(&profile(heights))
        .iter()
        .zip(&truth)
        .map(|(found, truth)| {
            let squares = inside.clone().map(|i| (found[i] - truth[i]).powi(2));
            (squares.sum::<f64>() / inside.len() as f64).sqrt()
        })
        .collect();
    let words: Vec<String> = errors.iter().map(|error| format!("{:.2}", 1e6 * error)).collect();
    Row {
        statement: "RMS error of the band-passes 10–30, 30–100, 100–300 mm on a rough, corrugated rail made of \
                    sinusoids",
        source: "what a calibrated trolley is held to",
        expected: "≤ 1, 1, 2 µm".to_owned(),
        got: format!("{} µm", words.join(", ")),
        tolerance: "the bound; what is left are the slopes of the filter at the edges of the bands",
        holds: errors.iter().zip([1e-6, 1e-6, 2e-6]).all(|(error, bound)| *error <= bound),
    }
}

/// Bands with their levels.
type Levels = Vec<(ThirdOctave, f64)>;

/// Spectra of the laboratory MBBM by campaign.
pub(crate) fn campaigns() -> Vec<Vec<Spectrum>> {
    let mut spectra: Vec<(&str, usize, Levels)> = Vec::new();
    for line in SPECTRA.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        if cells[4] != "MBBM" {
            continue;
        }
        let number = |cell: &str| cell.parse::<f64>().expect("a number");
        let band = ThirdOctave::containing(1e-3 * number(cells[7])).expect("a wavelength");
        let level = (band, number(cells[8]));
        match spectra.last_mut() {
            Some((id, _, levels)) if *id == cells[0] => levels.push(level),
            _ => spectra.push((cells[0], cells[5].parse().expect("a campaign"), vec![level])),
        }
    }
    (1..=4)
        .map(|campaign| {
            let own = spectra.iter().filter(|spectrum| spectrum.1 == campaign);
            own.map(|spectrum| Spectrum::new(spectrum.2.clone()).expect("a spectrum")).collect()
        })
        .collect()
}

pub(crate) fn grinding_mark_fades() -> Row {
    let band = ThirdOctave::new(-17);
    let level = |mean: fn(&[Spectrum]) -> Option<Spectrum>| -> Vec<f64> {
        let means = campaigns();
        let levels = means.iter().filter_map(|spectra| mean(spectra)?.level(band));
        levels.collect()
    };
    let words = |levels: &[f64]| -> String {
        let words: Vec<String> = levels.iter().map(|level| format!("{level:.1}")).collect();
        words.join(", ")
    };
    let (arithmetic, energy) = (level(Spectrum::arithmetic_mean), level(Spectrum::energy_mean));
    let expected = [-4.2, -8.4, -9.4, -10.7];
    let same = arithmetic.len() == 4
        && arithmetic.iter().zip(expected).all(|(level, expected)| (level - expected).abs() <= 0.05);
    Row {
        statement: "Niederwangen: the mean level at 20 mm falls over four campaigns, so it is a fading grinding \
                    mark and not growing corrugation",
        source: "32 spectra of Müller-BBM, 2014–2015, `sbb-track-noise/rail_roughness.csv`",
        expected: format!("{} dB, mean of levels", words(&expected)),
        got: format!("{} dB; mean of energies {} dB", words(&arithmetic), words(&energy)),
        tolerance: "half of the last digit",
        holds: same && arithmetic.windows(2).all(|pair| pair[1] < pair[0]),
    }
}

/// The rail held against the case of discrete supports, as in the book.
pub(crate) fn grinding_mark_is_diagnosed() -> Row {
    let case = include_str!("../cases/discrete-supports.toml");
    let case = riffel_case::Case::parse("discrete-supports", case, &[]).expect("a case");
    let means = campaigns();
    let band = ThirdOctave::new(-17);
    let peak = means
        .iter()
        .flat_map(|spectra| dominant_levels(spectra))
        .max_by(|a, b| a.prominence.total_cmp(&b.prominence))
        .expect("a band that stands out");
    // Days from the first campaign.
    let points = means.iter().zip([0.0, 214.0, 365.0, 579.0]).map(|(spectra, days)| {
        let levels: Vec<f64> = spectra.iter().filter_map(|one| one.level(band)).collect();
        let count = levels.len() as f64;
        let mean = levels.iter().sum::<f64>() / count;
        let squares: f64 = levels.iter().map(|level| (level - mean).powi(2)).sum();
        TrendPoint {
            label: String::new(),
            time: days / 365.25,
            level: mean,
            scatter: Some((squares / (count - 1.0) / count).sqrt()),
        }
    });
    let course = LevelTrend::new(points.collect(), TimeUnit::Year).expect("four campaigns");
    let speeds = TrafficSpeeds::new([(136.0 / 3.6, 1.0)]).expect("a speed");
    let (mut mechanisms, _) = traffic::mechanisms(&case);
    let growth =
        GrowthDensity::new(&case.feedback, peak.wavelength.min(case.wavelength.min()), case.wavelength.max(), &speeds);
    mechanisms.push(Mechanism::growth_ridge(growth));
    let filter = ContactFilter::of(&case.hertz);
    let candidates = rank(
        &Evidence {
            peak: &peak,
            course: Some(&course),
            speeds: &speeds,
            filter: &filter,
            instrument: Instrument::Trolley,
        },
        &mechanisms,
    );
    let first = &candidates[0];
    let corrugation: f64 = candidates
        .iter()
        .filter(|candidate| candidate.kind.expectation() == Expectation::Grows)
        .map(|candidate| candidate.share)
        .sum();
    let slope = course.slope.expect("a rail that was not ground");
    let rises = course.probability_of_rise().unwrap_or(0.5);
    Row {
        statement: "Niederwangen diagnosed: 20 mm stands out, a grinding mark leads, and all growing corrugation \
                    together has less than a tenth of the share",
        source: "32 spectra of Müller-BBM; `cases/discrete-supports.toml` at 136 km/h",
        expected: "20 mm, grinding mark".to_owned(),
        got: format!(
            "{:.0} mm, {} with {:.2}; corrugation {corrugation:.3}; {:+.1} ± {:.1} dB a year",
            1e3 * peak.wavelength,
            first.kind.name(),
            first.share,
            slope.mean,
            slope.scatter
        ),
        tolerance: "a rise no likelier than 1 %, corrugation below 0.1",
        holds: ThirdOctave::containing(peak.wavelength).is_ok_and(|found| found == band)
            && first.kind == MechanismKind::GrindingMark
            && corrugation < 0.1
            && rises < 0.01,
    }
}

pub(crate) fn grinding_mark_is_heard() -> Row {
    let frequency = 136.0 / 3.6 / 0.02;
    let mut lines = PASS_BYS.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let mut energies = vec![0.0; header.len()];
    for line in lines {
        for (index, cell) in line.split(',').enumerate().skip(6) {
            let level: f64 = cell.parse().expect("a level");
            energies[index] += 10f64.powf(level / 10.0);
        }
    }
    let loudest = (6..header.len()).max_by(|&a, &b| energies[a].total_cmp(&energies[b]));
    let band: f64 = loudest
        .and_then(|index| header[index].strip_prefix("leq."))
        .and_then(|band| band.parse().ok())
        .expect("a band");
    let half = 10f64.powf(0.05);
    Row {
        statement: "Niederwangen: at 136 km/h 20 mm is 1889 Hz, in the loudest band of the pass-bys",
        source: "60 pass-bys, `sbb-track-noise/passby_levels.csv`, mean of energies",
        expected: "1889 Hz, 2000 Hz".to_owned(),
        got: format!("{frequency:.0} Hz, {band:.0} Hz"),
        tolerance: "the band from 1778 to 2239 Hz",
        holds: band == 2000.0 && (band / half..band * half).contains(&frequency),
    }
}
