//! Wheels that are not round over a corrugated rail.

use std::f64::consts::TAU;

use riffel::roughness::Profile;
use riffel_answers::axlebox::{AxleBoxAnswer, AxleBoxRequest, WheelMarkKind};
use riffel_rail::{AxleBoxFile, AxleBoxPlace, LimitTable};

use super::{Journey, QUIET, case, rail, signal};

/// Length of rail \[m\].
const LENGTH: f64 = 220.0;
/// A tenth of all heights, whose acceleration is a tenth: at full height a flat lifts the wheel off the rail.
const SHARE: f64 = 0.1;

/// One of 160 waves of 45 to 56 mm, together 18 µm RMS, closer than 40 m tell apart: their phase is lost within a turn, as that of corrugation is.
fn wave_of_50_mm(wave: u32, x: f64) -> f64 {
    let wave = f64::from(wave);
    2e-6 * (TAU * (18.0 + 0.0259 * wave) * x + wave * wave).sin()
}

/// What axle boxes feel of one rail whose last 60 m have waves of about 50 mm, each with its wheel; one whose name ends in `/ 5` writes
/// a fifth of that.
fn answer_of(channels: &[(&str, &dyn Fn(f64) -> f64)]) -> AxleBoxAnswer {
    let case = case();
    let journey = Journey { length: LENGTH, rate: 5000.0, ..QUIET };
    let smooth = rail(LENGTH + 1.0);
    let channels = channels.iter().map(|(name, wheel)| {
        let heights = smooth.heights().iter().enumerate().map(|(index, height)| {
            let x = 1e-3 * index as f64;
            let waves: f64 = match x > 160.0 {
                true => (0..160u32).map(|wave| wave_of_50_mm(wave, x)).sum(),
                false => 0.0,
            };
            SHARE * (0.5 * height + waves + wheel(x))
        });
        let profile = Profile::new(0.0, 1e-3, heights.collect()).unwrap();
        let samples = signal(&case, &journey, &profile);
        let part = if name.ends_with("/ 5") { 0.2 } else { 1.0 };
        let accelerations = samples.iter().map(|sample| part * sample.acceleration / SHARE);
        ((*name).to_owned(), accelerations.collect())
    });
    let place = AxleBoxPlace::Constant(journey.speed);
    let file = AxleBoxFile::of_arrays("run", channels.collect(), journey.rate, place).unwrap();
    let (files, limits) = ([("run".into(), file.into())], LimitTable::all());
    AxleBoxAnswer::new(&case, &files, &limits, &AxleBoxRequest::default(), &|_| ()).unwrap()
}

/// A flat of 120 µm and 18 µm in 18 waves, on wheels worn by 2 and 1 %, are those of their wheels: what is left has the levels of the
/// rail within 0.5 dB, no welds, and as much to grind as under a round wheel.
// Long: takes marks of wheels off four channels of a run.
#[test]
fn wheels_that_are_not_round_are_no_rail() {
    let radius = 0.98 * case().hertz.rolling_radius();
    let flat = |x: f64| {
        // Its edges are rounded: those of a chord are shorter than two samples.
        let away = (radius * ((x / radius).rem_euclid(TAU) - 3.0) / 0.015).clamp(-1.0, 1.0);
        -60e-6 * (1.0 + (0.5 * TAU * away).cos())
    };
    let polygon = |x: f64| 18e-6 * (18.0 * x / (1.01 * radius)).cos();
    let round = |_: f64| 0.0;
    let answer = answer_of(&[("left 1", &flat), ("left 2", &round), ("left 3", &polygon), ("right", &flat)]);
    let in_one_language = answer.remarks.iter().find(|said| said.id() == "verbatim");
    assert_eq!(in_one_language, None);
    let of = |name: &str| answer.rails.iter().find(|rail| rail.rail.name == name);
    let there = of("left 2").unwrap();
    let ground = |name: &str| -> f64 {
        let sections = of(name).unwrap().rail.sections.iter();
        sections.map(|section| section.to - section.from).sum()
    };
    assert!((30.0..75.0).contains(&ground("left 2")), "{}", ground("left 2"));
    for name in ["left 1", "left 3", "right"] {
        let found = of(name).unwrap();
        for (found, there) in found.levels.iter().zip(&there.levels) {
            let more = found.level - there.level;
            let wavelength = there.band.nominal_millimetres();
            assert!(more.abs() < 0.5, "{name}, {wavelength} mm: {more} dB");
        }
        assert_eq!(found.rail.analysis.defects.len(), 0, "{name}");
        let more = ground(name) - ground("left 2");
        assert!(more.abs() <= 10.0, "{name}: {more} m");
    }
    let marks: Vec<_> = answer.wheels.iter().map(|mark| (&*mark.name, mark)).collect();
    let [("left 1", flat), ("left 3", waves), ("right", other)] = marks[..] else {
        panic!("{marks:?}");
    };
    for flat in [flat, other] {
        let depth = flat.flat_depth_m.unwrap();
        assert_eq!((flat.kind, flat.order), (WheelMarkKind::Flat, None));
        // Waves shorter than 10 mm and longer than 400 mm are missing.
        assert!((80e-6..130e-6).contains(&depth), "{depth}");
    }
    assert_eq!((waves.kind, waves.order), (WheelMarkKind::Polygon, Some(18)));
    let amplitude = waves.amplitude_m.unwrap();
    assert!((amplitude / 18e-6 - 1.0).abs() < 0.1, "{amplitude}");
    let said = |part: &str| answer.remarks.iter().any(|remark| remark.to_string().contains(part));
    assert!(said("left 1: the wheel has a flat") && said("left 3: the wheel has 18 waves"));
}

/// Under one wheel alone nobody knows whose waves are that keep their phase: it is said, and they stay.
#[test]
fn a_wave_of_one_wheel_alone_is_left() {
    let radius = case().hertz.rolling_radius();
    let polygon = |x: f64| 18e-6 * (18.0 * x / radius).cos();
    // A fifth of a channel is no second axle box.
    let answer = answer_of(&[("left", &polygon), ("right", &|_| 0.0), ("left / 5", &polygon)]);
    assert!(answer.wheels.is_empty(), "{:?}", answer.wheels);
    let said = answer.remarks.iter().map(ToString::to_string).find(|said| said.contains("second axle box"));
    assert!(said.is_some_and(|said| said.starts_with("left: ")), "{:?}", answer.remarks);
    let near_160_mm = |name: &str| {
        let mut rails = answer.rails.iter();
        let rail = rails.find(|rail| rail.rail.name == name).unwrap();
        let mut levels = rail.levels.iter();
        *levels.find(|level| level.band.nominal_millimetres() == 160.0).unwrap()
    };
    let (with, without) = (near_160_mm("left"), near_160_mm("right"));
    assert!(with.level > without.level + 3.0);
    // The lower end is the rail but for 0.7 dB, likely of the first and the last turn of these 220 m.
    let more = with.range[0] - without.range[0];
    assert!(more.abs() < 0.8, "{more} dB");
    let said = format!("and {:.1} dB, as these waves may be the wheel's", with.level);
    let mut remarks = answer.remarks.iter().map(ToString::to_string);
    assert!(remarks.any(|remark| remark.contains(&said)), "{said}");
}
