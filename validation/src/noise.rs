//! Rolling noise computed and measured at one site. Nothing is fitted.

use std::sync::LazyLock;

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_answers::noise::{DecayRates, Levels, NoiseQuestion};
use riffel_answers::question::Nobody;
use riffel_case::{Case, MAIN_LINE_CASE};
use riffel_keys::quantity::Quantity;
use riffel_noise::{FrequencyBand, Surroundings, a_weighting};
use riffel_rail::Survey;

use crate::Row;

const PASS_BYS: &str = include_str!("../reference/sbb-track-noise/passby_levels.csv");
const ROUGHNESS: &str = include_str!("../reference/sbb-track-noise/rail_roughness.csv");
const DECAY: &str = include_str!("../reference/sbb-track-noise/track_decay_rate.csv");

const SOURCE: &str = "intercity trains at Niederwangen, `sbb-track-noise`: roughness and decay rates of the section, levels 2.5 m from the \
                      track on a reflecting plate";

/// Mean speed of the intercity trains past B5 \[m/s\].
const SPEED: f64 = 136.0 / 3.6;

/// The wheel whose modes are taken, of which nothing is known but the diameter of 920 mm.
const WHEEL: &str = "straight-web-920";

/// Computed levels of all parts.
struct Computed {
    /// Nominal centres of the bands \[Hz\].
    frequencies: Vec<f64>,
    /// Levels by band \[dB\].
    levels: Vec<Option<f64>>,
    /// Level of all bands \[dB(A)\].
    a_weighted: f64,
}

/// A section of the site.
struct Section {
    /// Computed levels with rigid wheels.
    computed: Computed,
    /// Computed levels with wheels that ring.
    ringing: Computed,
    /// Computed levels by the transfer functions of the directive.
    by_transfer: Computed,
    /// Roughness spectra of both rails and all dates.
    roughness: Vec<Spectrum>,
    /// Vertical decay rates \[dB/m\], one list a band.
    decay: Vec<(FrequencyBand, Vec<f64>)>,
    /// Measured intercity trains.
    measured: Vec<Passage>,
}

/// A train as it was measured; levels are A-weighted.
struct Passage {
    /// Its number, the same at all sections.
    number: u32,
    /// Level of all bands \[dB(A)\].
    total: f64,
    /// Levels by band \[dB\].
    bands: Vec<(FrequencyBand, f64)>,
}

/// The section without dampers.
static B5: LazyLock<Section> = LazyLock::new(|| Section::new("B5"));

/// Rows of a table as cells by the names of its columns.
fn rows(table: &str) -> impl Iterator<Item = impl Fn(&str) -> String> {
    let mut lines = table.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    lines.map(move |line| {
        let cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        let header = header.clone();
        move |name: &str| {
            let place = header.iter().position(|column| *column == name);
            cells[place.expect("a column")].clone()
        }
    })
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / (values.len() - 1) as f64).sqrt()
}

impl Section {
    fn new(name: &str) -> Self {
        let roughness = roughness(name);
        let decay = decay(name);
        let overrides = ["vehicle=passenger-coach".to_owned()];
        let case = Case::parse("main-line.toml", MAIN_LINE_CASE, &overrides).expect("a case");
        let answer = |wheel_modes: Option<&str>| {
            let mean_rate = |rates: &[f64]| {
                let logarithms: Vec<f64> = rates.iter().map(|rate| rate.ln()).collect();
                mean(&logarithms).exp()
            };
            let rates = decay.iter().map(|(band, rates)| (*band, mean_rate(rates)));
            let roughness = Spectrum::energy_mean(&roughness).expect("spectra");
            let question = NoiseQuestion {
                wheel_modes: wheel_modes.map(str::to_owned),
                wheel_roughness: Some("cnossos-disc-brakes".to_owned()),
                decay_rate: Some(rates.collect::<DecayRates>().into()),
                track_transfer: Some("cnossos-monobloc-hard-pads".to_owned()),
                vehicle_transfer: Some("cnossos-wheel-920".to_owned()),
                distance: Quantity::new(2.5).into(),
                surroundings: Surroundings::OnPlate,
                ..NoiseQuestion::of_a_coach(case.clone(), Survey::of_spectrum(roughness), SPEED, "iso-3095-2013")
                    .expect("a question")
            };
            question.answer(&Nobody).expect("levels")
        };
        let rigid = answer(None);
        let transfer = rigid.by_transfer_functions.expect("levels");
        let computed = |frequencies: Vec<f64>, levels, a_weighted: Option<f64>| Computed {
            frequencies,
            levels,
            a_weighted: a_weighted.expect("a level"),
        };
        let of_model = |frequencies, level: Levels| computed(frequencies, level.total_db, level.total_dba);
        let ringing = answer(Some(WHEEL));
        Self {
            ringing: of_model(ringing.frequency_hz, ringing.level),
            by_transfer: computed(transfer.frequency_hz, transfer.total_db, transfer.total_dba),
            computed: of_model(rigid.frequency_hz, rigid.level),
            roughness,
            decay,
            measured: measured(name),
        }
    }

    /// Measured levels of a band.
    fn levels(&self, band: FrequencyBand) -> Vec<f64> {
        let bands = self.measured.iter().flat_map(|passage| &passage.bands);
        bands.filter(|(other, _)| *other == band).map(|(_, level)| *level).collect()
    }

    /// Computed less measured A-weighted level of a band, with the standard deviation that trains, roughness spectra and
    /// decay rates have together \[dB\].
    fn difference(&self, computed: &Computed, band: FrequencyBand) -> (f64, f64) {
        let mut frequencies = computed.frequencies.iter();
        let place = frequencies.position(|centre| *centre == band.nominal());
        let computed = place.and_then(|place| computed.levels[place]).expect("a level");
        let levels = self.levels(band);
        let wave = ThirdOctave::containing(SPEED / band.centre()).expect("a wavelength");
        let roughness: Vec<f64> = self.roughness.iter().filter_map(|one| one.level(wave)).collect();
        let decay = self.decay.iter().find(|(other, _)| *other == band);
        let (_, rates) = decay.expect("decay rates");
        let decay: Vec<f64> = rates.iter().map(|rate| 10.0 * rate.log10()).collect();
        let deviation =
            [&levels, &roughness, &decay].map(|values| deviation(values).powi(2)).iter().sum::<f64>().sqrt();
        let computed = computed + a_weighting(band.centre());
        (computed - mean(&levels), deviation)
    }

    /// Measured levels of all bands \[dB(A)\].
    fn totals(&self) -> Vec<f64> {
        self.measured.iter().map(|passage| passage.total).collect()
    }
}

fn roughness(section: &str) -> Vec<Spectrum> {
    let mut spectra: Vec<(String, Vec<(ThirdOctave, f64)>)> = Vec::new();
    for row in rows(ROUGHNESS) {
        if row("section") != section || row("laboratory") != "MBBM" {
            continue;
        }
        let band = ThirdOctave::centred(1e-3 * number(&row("wavelength_mm"))).expect("a band");
        let level = (band, number(&row("roughness_level_db_re_1um")));
        let spectrum = row("spectrum_id");
        match spectra.iter_mut().find(|(other, _)| *other == spectrum) {
            Some((_, levels)) => levels.push(level),
            None => spectra.push((spectrum, vec![level])),
        }
    }
    let spectra = spectra.into_iter();
    spectra.map(|(_, levels)| Spectrum::new(levels).expect("a spectrum")).collect()
}

/// Vertical decay rates as the section was when trains were measured: B5 without dampers, the others with.
fn decay(section: &str) -> Vec<(FrequencyBand, Vec<f64>)> {
    let dampers = if section == "B5" { "False" } else { "True" };
    let mut bands: Vec<(FrequencyBand, Vec<f64>)> = Vec::new();
    for row in rows(DECAY) {
        let here = row("section") == section && row("direction") == "vertical";
        if !here || row("rail_dampers") != dampers {
            continue;
        }
        let band = FrequencyBand::containing(number(&row("frequency_hz"))).expect("a band");
        let rate = number(&row("decay_rate_db_per_m"));
        match bands.iter_mut().find(|(other, _)| *other == band) {
            Some((_, rates)) => rates.push(rate),
            None => bands.push((band, vec![rate])),
        }
    }
    bands
}

fn measured(section: &str) -> Vec<Passage> {
    let trains = rows(PASS_BYS).filter(|row| row("section") == section && row("train_type") == "IC");
    trains
        .map(|row| {
            let bands = FrequencyBand::all();
            let levels = bands.map(|band| (band, number(&row(&format!("leq.{}", band.nominal())))));
            Passage {
                number: row("passby").parse().expect("a number"),
                total: number(&row("leq.tot")),
                bands: levels.collect(),
            }
        })
        .collect()
}

pub(crate) fn pass_by_level_of_the_site() -> Row {
    total_of("Pass-by level from roughness, receptances, decay rates and radiation, nothing fitted", &B5.computed)
}

pub(crate) fn directive_level_of_the_site() -> Row {
    total_of(
        "Pass-by level by the transfer functions of Directive (EU) 2015/996, hard pads and wheels of 920 mm",
        &B5.by_transfer,
    )
}

fn total_of(statement: &'static str, computed: &Computed) -> Row {
    let totals = B5.totals();
    let (expected, spread) = (mean(&totals), deviation(&totals));
    let got = computed.a_weighted;
    Row {
        statement,
        source: SOURCE,
        expected: format!("{expected:.1} ± {spread:.1} dB(A)"),
        got: format!("{got:.1} dB(A)"),
        tolerance: "two standard deviations between the trains",
        holds: (got - expected).abs() <= 2.0 * spread,
    }
}

/// Bands in which the rail radiates most of what is heard, and one sleeper does not know of the next.
const OF_THE_RAIL: std::ops::RangeInclusive<i32> = 25..=32;

pub(crate) fn pass_by_bands_of_the_rail() -> Row {
    let bands = FrequencyBand::all().filter(|band| OF_THE_RAIL.contains(&band.index()));
    let found: Vec<(f64, f64)> = bands.map(|band| B5.difference(&B5.computed, band)).collect();
    let differences: Vec<String> = found.iter().map(|(difference, _)| format!("{difference:+.1}")).collect();
    let squares: Vec<f64> = found.iter().map(|(difference, _)| difference.powi(2)).collect();
    let spreads: Vec<f64> = found.iter().map(|(_, spread)| spread.powi(2)).collect();
    let (rms, spread) = (mean(&squares).sqrt(), mean(&spreads).sqrt());
    Row {
        statement: "Bands 315–1600 Hz, computed less measured",
        source: SOURCE,
        expected: format!("0 ± {spread:.1} dB"),
        got: format!("rms {rms:.1} dB: {}", differences.join(", ")),
        tolerance: "two standard deviations of trains, roughness spectra and decay rates together, in the mean over the bands",
        holds: rms <= 2.0 * spread,
    }
}

pub(crate) fn wheel_between_rigid_and_ringing() -> Row {
    let above = FrequencyBand::all().filter(|band| band.index() > *OF_THE_RAIL.end());
    let found: Vec<[f64; 2]> =
        above.map(|band| [&B5.computed, &B5.ringing].map(|levels| B5.difference(levels, band).0)).collect();
    let words: Vec<String> = found.iter().map(|[rigid, ringing]| format!("{rigid:+.1} to {ringing:+.1}")).collect();
    Row {
        statement: "Bands 2–5 kHz, computed less measured: a rigid wheel is too quiet, a plain one of 920 mm that rings too loud",
        source: SOURCE,
        expected: "0 dB within".to_owned(),
        got: format!("{} dB", words.join(", ")),
        tolerance: "the signs",
        holds: found.iter().all(|[rigid, ringing]| *rigid < 0.0 && *ringing > 0.0),
    }
}

// Long: computes the noise of three sections of a line with and without dampers.
pub(crate) fn dampers_save_no_more_than_computed() -> Row {
    let mut holds = true;
    let (mut expected, mut got) = (Vec::new(), Vec::new());
    for name in ["B2", "B3", "B4"] {
        let section = Section::new(name);
        let computed = B5.computed.a_weighted - section.computed.a_weighted;
        let savings: Vec<f64> = section
            .measured
            .iter()
            .filter_map(|passage| {
                let mut trains = B5.measured.iter();
                let same = trains.find(|other| other.number == passage.number)?;
                Some(same.total - passage.total)
            })
            .collect();
        let (measured, spread) = (mean(&savings), deviation(&savings));
        holds &= measured <= computed + 2.0 * spread;
        expected.push(format!("{name} {measured:.1} ± {spread:.1}"));
        got.push(format!("{computed:.1}"));
    }
    Row {
        statement: "Sections with rail dampers against the one without: what is computed is the most they save, for \
                    the wheel stays as loud as it was",
        source: SOURCE,
        expected: format!("{} dB(A)", expected.join(", ")),
        got: format!("{} dB(A)", got.join(", ")),
        tolerance: "no more than computed, two standard deviations between the trains",
        holds,
    }
}
