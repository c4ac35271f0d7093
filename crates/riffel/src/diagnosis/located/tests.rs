use super::*;
use crate::roughness::{ColouredNoise, Recipe, Sinusoid};

/// Noise with sinusoids of a wavelength, an amplitude and two ends \[m\].
fn rail(length: f64, seed: u64, waves: &[(f64, f64, f64, f64)]) -> CleanRail {
    let recipe = Recipe {
        length,
        spacing: 2e-3,
        seed,
        sinusoids: waves
            .iter()
            .map(|&(wavelength, amplitude, from, to)| Sinusoid { wavelength, amplitude, phase: 0.3, from, to })
            .collect(),
        noise: Some(ColouredNoise { level: -10.0, wavelength: 0.1, slope: 10.0, longest: 3.0 }),
        ..Recipe::default()
    };
    let profile = Profile::new(5000.0, 2e-3, recipe.heights().unwrap()).unwrap();
    CleanRail::new(vec![profile])
}

/// 40 m of 2 km: the level there is 10 lg(A²/2), and not 17 dB less; its ends are known to 1 m, which is 0.1
/// dB of the level, and noise and the window take 0.3 dB.
#[test]
fn a_local_corrugation_is_found_with_its_level_and_place() {
    let found = rail(2000.0, 1, &[(0.0559, 7.77e-6, 1213.0, 1253.0)]).dominant().unwrap();
    assert_eq!(found.len(), 1, "{found:?}");
    let one = &found[0];
    assert!(!one.all_along && one.places.len() == 1, "{one:?}");
    assert!((one.peak.wavelength / 0.0559 - 1.0).abs() < 0.01, "{one:?}");
    let expected = 10.0 * (7.77f64.powi(2) / 2.0).log10();
    assert!((one.peak.level - expected).abs() < 0.4, "{one:?}");
    let place = one.places[0];
    assert!((place.from - 6213.0).abs() < 1.0 && (place.to - 6253.0).abs() < 1.0, "{one:?}");
}

/// Two places of one wavelength, and another wavelength all along.
#[test]
fn places_are_told_from_what_is_everywhere() {
    let found =
        rail(600.0, 2, &[(0.0559, 8e-6, 100.0, 130.0), (0.0559, 4e-6, 400.0, 460.0), (0.0312, 3e-6, 0.0, 600.0)])
            .dominant()
            .unwrap();
    assert_eq!(found.len(), 2, "{found:?}");
    let near = |wavelength: f64| {
        let near = |one: &&LocatedWavelength| (one.peak.wavelength / wavelength - 1.0).abs() < 0.01;
        found.iter().find(near).unwrap()
    };
    let local = near(0.0559);
    assert_eq!(local.places.len(), 2, "{local:?}");
    for (place, (from, to, amplitude)) in local.places.iter().zip([(5100.0, 5130.0, 8.0f64), (5400.0, 5460.0, 4.0)]) {
        let level = 10.0 * (amplitude.powi(2) / 2.0).log10();
        assert!((place.level - level).abs() < 0.5, "{local:?}");
        assert!((place.from - from).abs() < 1.0 && (place.to - to).abs() < 1.0, "{local:?}");
    }
    let everywhere = near(0.0312);
    assert!(everywhere.all_along, "{everywhere:?}");
    assert_eq!(everywhere.places[0].from, 5000.0);
}

/// Troughs of 150 µm at 40 mm are narrower than the wheel, which makes 20 mm of them, 20 dB over a faint wave that is on the rail.
/// That is no finding; a wave of the same length that is as high on the rail is one.
#[test]
fn a_harmonic_that_the_wheel_makes_is_no_finding() {
    let strong = (0.04, 150e-6, 0.0, 200.0);
    let wavelengths = |waves: &[(f64, f64, f64, f64)]| -> Vec<f64> {
        let found = rail(200.0, 5, waves).dominant().unwrap();
        let found = found.iter().map(|one| 1e3 * one.peak.wavelength);
        found.map(f64::round).collect()
    };
    let faint = rail(200.0, 5, &[strong, (0.02, 0.3e-6, 0.0, 200.0)]);
    let [on_rail, on_wheel] = [&faint.on_rail, &faint.on_wheel].map(|profile| {
        let spectrum = FineSpectrum::of_record(profile).unwrap();
        let peaks = spectrum.dominant().into_iter();
        let mut short = peaks.filter(|peak| (peak.wavelength / 0.02 - 1.0).abs() < 0.02);
        short.next().unwrap().level
    });
    assert!(on_wheel > on_rail + 20.0, "{on_wheel} over {on_rail}");
    assert_eq!(wavelengths(&[strong, (0.02, 0.3e-6, 0.0, 200.0)]), [40.0]);
    assert_eq!(wavelengths(&[(0.02, 6e-6, 0.0, 200.0)]), [20.0]);
    let mut both = wavelengths(&[(0.04, 15e-6, 0.0, 200.0), (0.02, 6e-6, 0.0, 200.0)]);
    both.sort_by(f64::total_cmp);
    assert_eq!(both, [20.0, 40.0]);
}

/// Two thirds of a rail are no whole: the place is told, with the level there.
#[test]
fn a_wave_on_two_thirds_is_not_all_along() {
    let found = rail(200.0, 6, &[(0.06, 8e-6, 20.0, 150.0)]).dominant().unwrap();
    let one = &found[0];
    assert!(!one.all_along, "{found:?}");
    let (place, level) = (one.places[0], 10.0 * 32f64.log10());
    assert!((place.from - 5020.0).abs() < 1.0 && (place.to - 5150.0).abs() < 1.0, "{one:?}");
    assert!((place.level - level).abs() < 0.5, "{one:?}");
}

/// Two weld dips are no wave and hide none: the corrugation beside them is found, the welds are listed.
#[test]
fn welds_are_no_wave() {
    let dip = |at: f64, x: f64| {
        let u = (x - at) / 0.8;
        let inside = if u.abs() < 0.5 { 1.0 } else { 0.0 };
        -200e-6 * inside * (std::f64::consts::TAU * u).cos().mul_add(0.5, 0.5)
    };
    for waves in [&[][..], &[(0.07, 5e-6, 30.0, 90.0)]] {
        let profile = rail(120.0, 7, waves).on_rail.swap_remove(0);
        let mut heights = Vec::new();
        for index in 0..profile.heights().len() {
            let x = profile.position(index) - 5000.0;
            heights.push(profile.heights()[index] + dip(25.3, x) + dip(97.1, x));
        }
        let profile = Profile::new(5000.0, 2e-3, heights).unwrap();
        let clean = CleanRail::new(vec![profile]);
        assert_eq!(clean.defects().len(), 2, "{:?}", clean.defects());
        let found = clean.dominant().unwrap();
        assert_eq!(found.len(), waves.len(), "{found:?}");
        for one in found {
            assert!((one.peak.wavelength / 0.07 - 1.0).abs() < 0.02, "{one:?}");
            assert!((one.places[0].from - 5030.0).abs() < 1.5, "{one:?}");
        }
    }
}

/// One dip or twelve, 50 to 300 mm long and 0.1 to 0.6 mm deep, on long rails and short ones: the wavelength found is that of
/// the corrugation, all along or on a third, or there is none.
#[test]
fn dips_make_no_wavelength() {
    for (seed, length, count) in [(11, 60.0, 1), (12, 120.0, 2), (13, 250.0, 5), (14, 120.0, 12)] {
        for (amplitude, from, to) in [(0.0, 0.0, 1.0), (4e-6, 0.0, 1.0), (15e-6, 0.5, 0.83)] {
            let waves = (0.047, amplitude, from * length, to * length);
            let profile = rail(length, seed, &[waves]).on_rail.swap_remove(0);
            let mut heights = profile.heights().to_vec();
            for dip in 0..count {
                let share = f64::from(dip) / f64::from(count);
                let (at, long) = (length * (share + 0.31 / f64::from(count)), 0.05 + 0.25 * share);
                for (index, height) in heights.iter_mut().enumerate() {
                    let u = (index as f64 * 2e-3 - at) / long;
                    let shape = (1.0 - 2.0 * u.abs()).max(0.0);
                    *height -= (100e-6 + 500e-6 * (1.0 - share)) * shape;
                }
            }
            let profile = Profile::new(5000.0, 2e-3, heights).unwrap();
            let found = CleanRail::new(vec![profile]).dominant().unwrap();
            let expected = usize::from(amplitude > 0.0);
            assert_eq!(found.len(), expected, "{seed} {amplitude}: {found:?}");
            for one in found {
                assert!((one.peak.wavelength / 0.047 - 1.0).abs() < 0.02, "{one:?}");
                assert_eq!(one.all_along, to == 1.0, "{one:?}");
            }
        }
    }
}

/// Bursts of 64 waves whose amplitude swells and fades, with a metre or three between them, are corrugation, whatever share of the
/// rail they take; a single burst of a dozen waves is an event.
#[test]
fn corrugation_in_bursts_is_found() {
    for (apart, bursts) in [(4.2, 20), (6.2, 13), (4.2, 1)] {
        let profile = rail(200.0, 31, &[]).on_rail.swap_remove(0);
        let mut heights = profile.heights().to_vec();
        for (index, height) in heights.iter_mut().enumerate() {
            let x = index as f64 * 2e-3 - 60.0;
            let (burst, within) = ((x / apart).floor(), x.rem_euclid(apart));
            let long = if bursts == 1 { 0.6 } else { 3.2 };
            if (0.0..f64::from(bursts)).contains(&burst) && within < long {
                let swell = (std::f64::consts::PI * within / long).sin().powi(2);
                *height += 15e-6 * swell * (std::f64::consts::TAU * x / 0.05).sin();
            }
        }
        let profile = Profile::new(5000.0, 2e-3, heights).unwrap();
        let found = CleanRail::new(vec![profile]).dominant().unwrap();
        if bursts == 1 {
            assert!(found.is_empty(), "{found:?}");
            continue;
        }
        let one = &found[0];
        assert!((one.peak.wavelength / 0.05 - 1.0).abs() < 0.01, "{one:?}");
        let (from, to) = (one.places.iter())
            .fold((f64::MAX, 0.0), |(from, to), place| (f64::min(from, place.from), f64::max(to, place.to)));
        assert!((from - 5060.0).abs() < 3.0, "{one:?}");
        let end = 5060.0 + apart * f64::from(bursts);
        assert!((to - end).abs() < 5.0, "{one:?}");
    }
}

/// A rail too short for windows tells the place as well.
#[test]
fn a_short_rail_has_places() {
    let found = rail(80.0, 3, &[(0.05, 10e-6, 20.0, 32.0)]).dominant().unwrap();
    let one = &found[0];
    assert!(!one.all_along, "{found:?}");
    let place = one.places[0];
    assert!((place.from - 5020.0).abs() < 1.0 && (place.to - 5032.0).abs() < 1.0, "{one:?}");
}

/// Windows ask many times, and answer by chance no more often than one spectrum does.
// Long: looks for corrugation all along ten rails of a kilometre.
#[test]
fn noise_has_no_place() {
    let found: usize = (0..10).map(|seed| rail(1000.0, 100 + seed, &[]).dominant().unwrap().len()).sum();
    assert_eq!(found, 0);
}

/// Power of one over ten, smoothed over two, falls to half at its ends.
#[test]
fn a_place_ends_where_the_power_is_halved() {
    let heights: Vec<f64> = (0..100).map(|index| if (40..60).contains(&index) { 1.0 } else { 0.0 }).collect();
    let power = smoothed(&heights, 5);
    let place = around(&power, highest(&power));
    assert_eq!(place, 40..60);
    assert_eq!(runs(&[1.0, 2.0, 0.0, 3.0, 0.0, 1.0], 1..5, 1.0), [0..2, 3..4]);
    assert_eq!(joined(vec![(0, 70..80), (0, 40..60), (1, 0..5)], 10), [(0, 40..80), (1, 0..5)]);
}
