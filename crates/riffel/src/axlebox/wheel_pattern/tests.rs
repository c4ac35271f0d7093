use std::f64::consts::TAU;

use super::lines::Lines;
use super::{MOST_TURNS, WORN, WheelPattern, best_distance};
use crate::axlebox::PatchAverageProfile;
use crate::roughness::{Profile, Spectrum, ThirdOctave, WavelengthBand};

const STEP: f64 = 0.002;
const LENGTH: f64 = 300.0;
const RADIUS: f64 = 0.42;
const RAILS: u64 = 8;

/// A rail of 5 dB at 100 mm that rises by 15 dB a decade, with 20 dB more about 50 mm where it is corrugated.
fn rail(seed: u64, is_corrugated: bool) -> Vec<f64> {
    let levels = (-19..=-5).map(|index| {
        let band = ThirdOctave::new(index);
        let hump = if is_corrugated && index == -13 { 20.0 } else { 0.0 };
        (band, 5.0 + 15.0 * (band.wavelength() / 0.1).log10() + hump)
    });
    let spectrum = Spectrum::new(levels).unwrap();
    spectrum.drawn(LENGTH, STEP, seed).unwrap().heights().to_vec()
}

fn with(rail: &[f64], wheel: impl Fn(f64) -> f64) -> PatchAverageProfile {
    let places = rail.iter().enumerate();
    let heights = places.map(|(index, height)| height + wheel(index as f64 * STEP));
    PatchAverageProfile {
        profile: Profile::new(0.0, STEP, heights.collect()).unwrap(),
        known: WavelengthBand::new(0.014, 0.3).unwrap(),
        speeds: [20.0; 3],
    }
}

/// A flat of a depth [m] on a wheel of a radius [m]: the chord.
fn flat(radius: f64, depth: f64) -> impl Fn(f64) -> f64 {
    move |x| {
        let turn = TAU * radius;
        let away = (x + 0.7).rem_euclid(turn);
        let away = away.min(turn - away);
        -(depth - away * away / (2.0 * radius)).max(0.0)
    }
}

fn polygon(radius: f64, order: usize, amplitude: f64) -> impl Fn(f64) -> f64 {
    move |x| amplitude * (order as f64 * x / radius).cos()
}

/// The largest difference of levels between two rails [dB].
fn difference(one: &Profile, other: &Profile) -> f64 {
    let [one, other] = [one, other].map(|profile| Spectrum::of_record(std::slice::from_ref(profile), 0.3).unwrap());
    // Bands that the rail has.
    let known = one.levels().iter().filter(|level| (-18..=-6).contains(&level.band.index()));
    let differences = known.map(|level| (level.level - other.level(level.band).unwrap()).abs());
    differences.fold(0.0, f64::max)
}

/// Each rail with and without corrugation; the wheel is up to 4 % smaller than its case says.
fn rails() -> impl Iterator<Item = (u64, bool, f64)> {
    let of = |seed| [(seed, false), (seed, true)];
    (0..RAILS).flat_map(of).map(|(seed, is_corrugated)| (seed, is_corrugated, RADIUS * (1.0 - 0.005 * seed as f64)))
}

/// What the first of some wheels has, and the heights without it.
fn found(mut patch_averages: Vec<PatchAverageProfile>, circumference: f64) -> (Option<WheelPattern>, Profile) {
    let found = WheelPattern::take_off(&mut patch_averages, circumference, Some(0.6)).unwrap();
    let first = patch_averages.swap_remove(0);
    (found.into_iter().next().unwrap(), first.profile)
}

// Long: looks for wheels on sixteen rails of 300 m, five times each.
#[test]
fn rails_have_no_pattern_of_a_wheel() {
    for (seed, is_corrugated, radius) in rails() {
        let rail = rail(seed, is_corrugated);
        let found_of = |patch_averages| found(patch_averages, TAU * RADIUS).0;
        assert_eq!(found_of(vec![with(&rail, |_| 0.0)]), None, "{seed}");
        // A wave that keeps its phase, of which another wheel feels as much.
        let wavy = with(&rail, polygon(radius, 17, 10e-6));
        assert_eq!(found_of(vec![wavy.clone(), wavy.clone()]), None, "{seed}");
        // Of one wheel alone nobody can tell: it stays, and is said but where it fits the supports.
        let (one, left) = found(vec![wavy.clone()], TAU * RADIUS);
        assert!(one.is_none_or(|one| !one.is_wheel), "{seed}");
        assert_eq!(left, wavy.profile);
        // Supports of 0.6 m whose every fifth is a turn of a wheel of 0.4775 m, all harmonics alike; known, and felt by
        // another wheel.
        let bays = |every: f64| {
            with(&rail, |x| {
                let waves = (1..6).map(|k| (f64::from(k) * TAU * x / every).cos());
                3e-6 * waves.sum::<f64>()
            })
        };
        assert_eq!(found(vec![bays(0.6)], 3.0).0, None, "{seed}");
        let unknown = vec![bays(0.65), bays(0.65)];
        assert_eq!(found_of(unknown), None, "{seed}");
    }
}

/// Of what is left at worst 0.3 dB is the mean of the rail over the turns.
// Long: takes flats off sixteen rails of 300 m.
#[test]
fn flats_are_found_and_taken_off() {
    for (seed, is_corrugated, radius) in rails() {
        let rail = rail(seed, is_corrugated);
        let depth = 1e-6 * (60.0 + 12.0 * seed as f64);
        let smooth = with(&rail, |_| 0.0);
        let (flat, left) = found(vec![with(&rail, flat(radius, depth))], TAU * RADIUS);
        let flat = flat.unwrap_or_else(|| panic!("{seed}"));
        let error = flat.circumference / (TAU * radius) - 1.0;
        assert!(error.abs() < 2e-5, "{seed}: {error}");
        assert!(flat.is_wheel && flat.is_flat(), "{seed}: {flat:?}");
        let share = flat.depth / depth;
        // The shortest flat is as long as the shortest wave that is known.
        assert!((0.65..=1.05).contains(&share), "{seed}: {share} of {depth}");
        let left = difference(&left, &smooth.profile);
        assert!(left < 0.5, "{seed}: {left} dB");
    }
}

// Long: takes wheels off sixteen rails of 300 m, twice each.
#[test]
fn polygons_are_told_by_another_wheel_on_the_rail() {
    for (seed, is_corrugated, radius) in rails() {
        let rail = rail(seed, is_corrugated);
        let order = 9 + 3 * seed as usize;
        let beside = with(&rail, |_| 0.0);
        let patch_average = with(&rail, polygon(radius, order, 18e-6));
        let (wheel, left) = found(vec![patch_average.clone(), beside.clone()], TAU * RADIUS);
        // A wheel turned on the same lathe is no rail that a third does not feel.
        let (twin, _) = found(vec![patch_average.clone(), patch_average, beside.clone()], TAU * RADIUS);
        assert_eq!(twin, wheel, "{seed}");
        let wheel = wheel.unwrap_or_else(|| panic!("{seed}"));
        assert!(wheel.is_wheel && !wheel.is_flat(), "{seed}");
        let [(found, amplitude)] = wheel.orders[..] else {
            panic!("{seed}: {wheel:?}");
        };
        let error = wheel.circumference * order as f64 / (found as f64 * TAU * radius) - 1.0;
        assert!(error.abs() < 2e-5, "{seed}: {found}, {error}");
        assert!((amplitude / 18e-6 - 1.0).abs() < 0.1, "{seed}: {amplitude}");
        let left = difference(&left, &beside.profile);
        assert!(left < 0.5, "{seed}: {left} dB");
    }
}

/// Where the transfer is not quite that of the track, or the odometer not quite true, a pattern changes along the line: here by 4 mm and a
/// tenth of its height over 200 to 270 m. Of 40 records the worst error of any band is 0.15 dB, but for waves around the wheel that are 22 dB
/// above all that the rail has: of these up to 0.73 dB are left, likely in the first and the last turn.
// Long: takes wheels off 40 records of 300 m, as many as its bounds are of.
#[test]
fn patterns_that_change_slowly_are_taken_off() {
    type Wheel = Box<dyn Fn(f64) -> f64>;
    let mut records = 0;
    for (seed, is_corrugated, radius) in rails().filter(|(seed, ..)| seed % 2 == 0) {
        let rail = rail(seed, is_corrugated);
        let changing = |wheel: &dyn Fn(f64) -> f64, x: f64| {
            let moved = x + 4e-3 * (TAU * x / 270.0 + seed as f64).sin();
            wheel(moved) * (1.0 + 0.1 * (TAU * x / 200.0).cos())
        };
        let round = || Box::new(|_| 0.0) as Wheel;
        let flat = || Box::new(flat(radius, 120e-6)) as Wheel;
        let waves = |order| Box::new(polygon(radius, order, 18e-6)) as Wheel;
        let near_the_rails = (TAU * radius / 0.051).round() as usize;
        let both: Wheel = {
            let (flat, waves) = (flat(), waves(20));
            Box::new(move |x| flat(x) + waves(x))
        };
        let kinds: [Vec<Wheel>; 5] = [
            vec![flat()],
            vec![both],
            vec![waves(18), round()],
            vec![waves(near_the_rails), round()],
            vec![flat(), waves(20), round()],
        ];
        let smooth = with(&rail, |_| 0.0).profile;
        for (kind, wheels) in kinds.iter().enumerate() {
            let patch_averages = wheels.iter().map(|wheel| with(&rail, |x| changing(wheel, x)));
            let (pattern, left) = found(patch_averages.collect(), TAU * RADIUS);
            assert!(pattern.is_some_and(|one| one.is_wheel), "{kind}, {seed}");
            let error = difference(&left, &smooth);
            let most = if kind == 3 && !is_corrugated { 0.8 } else { 0.2 };
            assert!(error < most, "{kind}, {seed}: {error} dB");
            records += 1;
        }
    }
    assert_eq!(records, 40);
}

/// Of small waves, which hide among those of the rail, the distance that is found by few looks repeats as a scan of all of them has it.
#[test]
fn the_best_distance_is_that_of_all() {
    for (seed, is_corrugated, radius) in rails() {
        let patch_average = with(&rail(seed, is_corrugated), polygon(radius, 18, 4e-6));
        let lines = Lines::of(patch_average.profile.heights(), STEP, 1);
        let about = TAU * RADIUS / STEP;
        let (_, found) = best_distance(&lines, about).unwrap();
        let most = ((0.5 * patch_average.profile.heights().len() as f64 / about) as usize).min(2 * MOST_TURNS);
        let repeats = lines.whitened_autocorrelation((most as f64 * (about * (1.0 + WORN) + 2.0)) as usize + 2);
        let at = |lag: f64| {
            let (low, share) = (lag as usize, lag.fract());
            repeats[low] + share * (repeats[low + 1] - repeats[low])
        };
        let step = 0.25 / most as f64;
        let first = about * (1.0 - WORN);
        let all = (0..(2.0 * about * WORN / step) as usize).map(|index| first + step * index as f64);
        let highest = all.map(|distance| (1..=most).map(|m| at(m as f64 * distance)).sum::<f64>() / most as f64);
        let highest = highest.fold(0.0, f64::max);
        // A rail on which no distance repeats has none; else a step of the last look may lie beside the top.
        assert!(highest == 0.0 || found > 0.97 * highest, "{seed}: {found} of {highest}");
    }
}
