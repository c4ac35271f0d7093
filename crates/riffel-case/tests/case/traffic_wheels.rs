//! Vehicles that bring all their wheels, and what is spread over them.

use riffel::Loop;
use riffel::forecast::{MeanGrowth, SpeedDistribution, band_lines};
use riffel::roughness::ThirdOctave;
use riffel_case::traffic::{Traffic, TrafficOnCase, bands_of};
use riffel_case::{BHASKAR_TRACK_CASE, Case, METRO_CURVE_CASE, NOMINAL_CASE, Variant};
use riffel_keys::CaseError;
use riffel_numerics::normal_distribution::quantile;

use crate::nominal;

/// Closed laws: the bogie by Shen, Hedrick & Elkins, the loop by Polach.
fn curve(keys: &[&str]) -> Case {
    crate::case(METRO_CURVE_CASE, &[&["contact.creep_law=polach", "map.wavelength=40-80 mm"], keys].concat())
}

fn on(case: &Case, vehicle: &str) -> Result<TrafficOnCase, CaseError> {
    let text = format!("[[vehicle]]\nname = \"unit\"\nshare = 1\n{vehicle}\n");
    let traffic = Traffic::parse("t.toml", &text)?;
    traffic.on(case, &bands_of(case), &Variant::none(""), &|_| {})
}

fn refusal(case: &Case, vehicle: &str) -> String {
    on(case, vehicle).map(|_| ()).unwrap_err().to_string()
}

/// Growth and wear of a bogie are the means of its wheelsets, each asked for by its keys, at each speed on its own equilibrium.
// Long: finds the equilibrium of a bogie for every wheelset and speed by itself.
#[test]
fn all_wheels_are_the_mean_of_separate_runs() -> Result<(), CaseError> {
    let speeds = [(40.0 / 3.6, 0.25), (50.0 / 3.6, 0.75)];
    let listed = speeds.map(|(speed, share)| format!("{{ speed = {speed:?}, share = {share} }}"));
    let all = on(&curve(&[]), &format!("curve = true\nspeeds = [{}]", listed.join(", ")))?;
    let lines = all.growth.rates().len();
    let (mut expected, mut depth) = (vec![0.0; lines], 0.0);
    for (speed, share) in speeds {
        for wheelset in [1, 2] {
            let keys = [format!("curve.speed={speed:?}"), format!("contact.from.wheelset={wheelset}")];
            let alone = on(
                &curve(&keys.each_ref().map(String::as_str)),
                &format!("speeds = [{{ speed = {speed:?}, share = 1 }}]"),
            )?;
            let part = 0.5 * share;
            depth += part * alone.growth.mean_wear().depth;
            for (sum, rate) in expected.iter_mut().zip(alone.growth.rates()) {
                *sum += part * rate;
            }
        }
    }
    let largest = expected.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    for (got, expected) in all.growth.rates().iter().zip(&expected) {
        assert!((got - expected).abs() <= 1e-12 * largest, "{got:e} {expected:e}");
    }
    assert!((all.growth.mean_wear().depth / depth - 1.0).abs() < 1e-12);
    Ok(())
}

/// Wheels of a case that shares its parts ask one wheelset that remembers: to the last bit what they answer alone.
#[test]
fn wheels_that_share_a_wheelset_grow_as_they_do_alone() -> Result<(), CaseError> {
    let vehicle = "curve = true\nspeed = { mean = 12.5, standard_deviation = 1 }";
    let alone = on(&curve(&[]), vehicle)?;
    let shared = on(&curve(&[]).sharing_parts(), vehicle)?;
    assert_eq!(alone.growth.rates(), shared.growth.rates());
    Ok(())
}

/// Bands are asked at as many speeds as each needs: under resonances of a flexible wheelset in one mean state and between two, rates and
/// forces are those of sums over 1601 speeds, to 1e-3 of the largest.
#[test]
fn means_over_speeds_hold_their_tolerance_band_by_band() -> Result<(), Box<dyn std::error::Error>> {
    let at = |speed: f64| curve(&[&format!("curve.speed={speed:?}")]).feedback;
    let bands = [-17, -14, -11, -8].map(ThirdOctave::new);
    let lines = band_lines(&bands);
    for (mean, deviation, states) in [(12.5, 0.7, &[12.0, 13.1][..]), (15.8, 1.9, &[15.8])] {
        let loops: Vec<(f64, [(Loop, f64); 1])> = states.iter().map(|&speed| (speed, [(at(speed), 1.0)])).collect();
        let states: Vec<(f64, &[(Loop, f64)])> = loops.iter().map(|(speed, places)| (*speed, &places[..])).collect();
        let found = MeanGrowth::between(&states, &lines, &SpeedDistribution::normal(mean, deviation)?);
        let fine = (0..=1600).map(|step| {
            let z = f64::from(step) / 200.0 - 4.0;
            let end = if z.abs() == 4.0 { 0.5 } else { 1.0 };
            (mean + z * deviation, end * (-0.5 * z * z).exp())
        });
        let fine = SpeedDistribution::shares(&fine.collect::<Vec<_>>())?;
        let fine = MeanGrowth::between(&states, &lines, &fine);
        let forces = (&found.squared_force_per_amplitude, &fine.squared_force_per_amplitude);
        for (found, fine) in [(&found.rates, &fine.rates), forces] {
            let largest = fine.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            for ((found, fine), line) in found.iter().zip(fine).zip(&lines) {
                assert!((found - fine).abs() <= 1e-3 * largest, "{line}: {found:e} {fine:e}");
            }
        }
        assert!(found.speeds < 1025);
    }
    Ok(())
}

/// However wide the gauge and tight the curve: contact is tabulated as far as the flange and beyond.
// Long: tabulates the contact and finds the equilibrium of a bogie for twelve curves.
#[test]
fn a_bogie_finds_its_equilibrium_on_any_gauge() {
    for gauge in [1430, 1440, 1455, 1465] {
        for radius in [120, 180, 600] {
            let keys = [format!("profiles.gauge={gauge} mm"), format!("curve.radius={radius} m")];
            let keys = keys.each_ref().map(String::as_str);
            assert!(on(&curve(&keys), "curve = true\nspeeds = [{ speed = 10, share = 1 }]").is_ok());
        }
    }
}

/// At 28 km/h and a friction of 0.6 this bogie finds no equilibrium, 2 km/h beside it one: both neighbours stand in, and a note
/// says so. A listed speed without one is refused.
#[test]
fn a_speed_between_two_with_an_equilibrium_is_bridged() {
    let text = include_str!("../../../../validation/field/stockholm-alvik/case.toml");
    let friction = ["contact.friction=0.6".to_owned()];
    let case = Case::parse("case.toml", text, &friction).unwrap();
    let vehicle = "curve = true\nspeed = { mean = \"28 km/h\", standard_deviation = \"2 km/h\" }";
    let found = on(&case, vehicle).unwrap();
    let notes: Vec<String> = found.remarks.iter().map(ToString::to_string).collect();
    assert!(notes.iter().any(|note| note.contains("no equilibrium in its curve at 28 km/h:")), "{notes:#?}");
    let listed = "curve = true\nspeeds = [{ speed = \"28 km/h\", share = 1 }]";
    assert!(refusal(&case, listed).contains("no equilibrium was found"));
}

/// Between the speeds at which the bogie is balanced rates are interpolated: to 2 % of the largest beside balancing it at every
/// twentieth of a standard deviation. Cause: second order in two standard deviations of the tails.
// Long: balances the bogie at 161 speeds, the side that is held against the interpolation.
#[test]
fn speeds_of_a_distribution_take_the_states_between() -> Result<(), CaseError> {
    let normal = on(&curve(&[]), "curve = true\nspeed = { mean = 12.5, standard_deviation = 1 }")?;
    let steps = (-80..=80).map(|step| f64::from(step) / 20.0);
    let nodes: Vec<(f64, f64)> = steps.map(|z| (12.5 + z, (-0.5 * z * z).exp())).collect();
    let sum: f64 = nodes.iter().map(|node| node.1).sum();
    let listed = nodes.iter().map(|(v, weight)| format!("{{ speed = {v:?}, share = {:?} }}", weight / sum));
    let listed = listed.collect::<Vec<_>>().join(", ");
    let listed = on(&curve(&[]), &format!("curve = true\nspeeds = [{listed}]"))?;
    let rates = listed.growth.rates().iter();
    let largest = rates.fold(0.0, |a: f64, b| a.max(b.abs()));
    for (one, other) in normal.growth.rates().iter().zip(listed.growth.rates()) {
        assert!((one - other).abs() < 0.02 * largest, "{one:e} {other:e}");
    }
    Ok(())
}

/// One wheel without spread has the rates of the loop, bit by bit, at the amplitude that traffic takes.
#[test]
fn one_wheel_without_spread_is_the_loop() -> Result<(), CaseError> {
    let case = nominal(&["corrugation.amplitude=1e-6"]);
    let found = on(&case, "speed = { mean = 30, standard_deviation = 2 }")?;
    let speeds = SpeedDistribution::normal(30.0, 2.0).unwrap();
    let loops = MeanGrowth::compute(&case.places(), &found.growth.wavelengths(), &speeds);
    assert_eq!(found.growth.rates(), loops.rates);
    assert_eq!(found.growth.mean_wear(), case.feedback.mean_wear());
    Ok(())
}

/// Means over normal loads, even friction and the friction of days, against the mean over draws of equal probability of each, which is right to
/// 3e-5, for the friction of days to some 1e-3: to 1 % of the largest rate, which is the tolerance of the rule.
// Long: computes growth at 600 drawn values, the independent side of the comparison.
#[test]
fn spreads_are_means_over_their_values() -> Result<(), CaseError> {
    let case = nominal(&[]);
    let speed = "speeds = [{ speed = 30, share = 1 }]";
    let cases = [
        ("load = { mean = 50e3, standard_deviation = 5e3 }", "wheel_load", "normal", 100),
        ("friction = { min = 0.2, max = 0.5 }", "friction", "even", 100),
        ("[line]\nfriction_days = {}", "friction", "days", 400),
    ];
    for (spread, key, kind, draws) in cases {
        let found = on(&case, &format!("{speed}\n{spread}"))?;
        let mut mean = vec![0.0; found.growth.rates().len()];
        for draw in 0..draws {
            let share = (f64::from(draw) + 0.5) / f64::from(draws);
            let value = match kind {
                "normal" => 50e3 + 5e3 * quantile(share),
                "days" => 0.4 * 1.4f64.powf(quantile(share)),
                _ => 0.2 + 0.3 * share,
            };
            let set = match key {
                "friction" => format!("set.contact.friction = {value:?}"),
                key => format!("{key} = {value:?}"),
            };
            let one = on(&case, &format!("{set}\n{speed}"))?;
            let rates = mean.iter_mut().zip(one.growth.rates());
            rates.for_each(|(sum, rate)| *sum += rate / f64::from(draws));
        }
        let largest = mean.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        for (got, expected) in found.growth.rates().iter().zip(&mean) {
            assert!((got - expected).abs() < 0.01 * largest, "{key}: {got:e} {expected:e}");
        }
    }
    Ok(())
}

/// A vehicle that says its friction keeps it on all days; a factor below one and a friction of none are refused.
#[test]
fn friction_of_days_is_that_of_vehicles_that_say_none() {
    let case = nominal(&[]);
    let rates = |text: &str| {
        let found = on(&case, &format!("speeds = [{{ speed = 30, share = 1 }}]\n{text}"));
        found.map(|found| found.growth.rates().to_vec())
    };
    let days = "\n[line]\nfriction_days = { mean = 0.3 }";
    for own in [
        "set.contact.friction = 0.5",
        "friction = [{ value = 0.5, share = 1 }]",
        "spread.contact.friction = [{ value = 0.5, share = 1 }]",
    ] {
        let with_days = rates(&format!("{own}{days}")).unwrap();
        assert_eq!(with_days, rates(own).unwrap(), "{own}");
    }
    assert_ne!(rates(days).unwrap(), rates("").unwrap());
    let single = rates("[line]\nfriction_days = { mean = 0.3, factor = 1 }").unwrap();
    assert_eq!(single, rates("set.contact.friction = 0.3").unwrap());
    for (written, told) in [
        ("{ factor = 0.9 }", "`line.friction_days.factor` is 0.9"),
        ("{ mean = 0 }", "`line.friction_days.mean` is 0"),
        ("{ median = 0.4 }", "line.friction_days.median"),
    ] {
        let error = rates(&format!("[line]\nfriction_days = {written}")).unwrap_err();
        assert!(error.to_string().contains(told), "{error}");
    }
    let error = refusal(&curve(&[]), &format!("speed.mean = 12{days}"));
    assert!(error.contains("`line.friction_days` is given, but contact.from"), "{error}");
}

/// Contacts that are spread across the rail cover the line in P(|y| ≤ b) of the passages; a band takes 2b/w.
#[test]
fn places_across_the_rail_thin_the_wear() -> Result<(), CaseError> {
    let case = nominal(&[]);
    let speed = "speeds = [{ speed = 30, share = 1 }]";
    let on_line = on(&case, speed)?;
    let b = case.hertz.semi_axis_lateral();
    let ends = format!("lateral_position = {{ min = {:?}, max = {:?} }}", -4.0 * b, 4.0 * b);
    let spread = on(&case, &format!("{ends}\n{speed}"))?;
    let band = on(&nominal(&[&format!("wear.band_width={:?}", 8.0 * b)]), speed)?;
    for other in [&spread, &band] {
        for (rate, alone) in other.growth.rates().iter().zip(on_line.growth.rates()) {
            assert!((rate / alone - 0.25).abs() < 1e-12, "{rate:e} {alone:e}");
        }
        let ratio = other.growth.mean_wear().depth / on_line.growth.mean_wear().depth;
        assert!((ratio - 0.25).abs() < 1e-12);
    }
    let both = refusal(&nominal(&["wear.band_width=40 mm"]), &format!("{ends}\n{speed}"));
    assert!(both.contains("vehicle[0].lateral_position") && both.contains("wear.band_width"), "{both}");
    Ok(())
}

/// On a measured line counts what covers it: each wheel where its profiles touch, with half the width of its band, and a share of it
/// where contacts scatter.
// Long: finds the equilibrium of a bogie for every line, share and wheelset.
#[test]
fn a_measured_line_has_the_wheels_that_run_on_it() -> Result<(), CaseError> {
    let band = 2e-3;
    let narrow = format!("wear.band_width={band:?}");
    let case = curve(&[&narrow]);
    let speed = 45.0 / 3.6;
    let vehicle = format!("curve = true\nspeeds = [{{ speed = {speed:?}, share = 1 }}]");
    let with = |line: &str, more: &str| {
        let text = format!("{line}[[vehicle]]\nname = \"unit\"\nshare = 1\n{vehicle}\n{more}\n");
        let traffic = Traffic::parse("t.toml", &text)?;
        traffic.on(&case, &bands_of(&case), &Variant::none(""), &|_| {})
    };
    let at = |line: f64| with(&format!("line.measured_line = {line:?}\n"), "");
    let [first, second] = [1, 2].map(|wheelset| {
        let from = format!("contact.from.wheelset={wheelset}");
        let alone = curve(&[&narrow, &from]);
        let offset = alone.file.contact.lateral_offset.unwrap().si();
        let half = alone.hertz.semi_axis_lateral().max(0.5 * band);
        let traffic = format!("speeds = [{{ speed = {speed:?}, share = 1 }}]");
        // The low rail of this curve is the right one, outside its middle to the right.
        (offset, half, on(&alone, &traffic).unwrap().growth)
    });
    let all = with("", "")?;
    let check = |got: &[f64], shares: [f64; 2]| {
        let both = first.2.rates().iter().zip(second.2.rates());
        for (got, (one, two)) in got.iter().zip(both) {
            let expected = 0.5 * (shares[0] * one + shares[1] * two);
            assert!((got - expected).abs() < 1e-12 * (one.abs() + two.abs()), "{got:e} {expected:e}");
        }
    };
    check(all.growth.rates(), [1.0, 1.0]);
    let covers = |line: f64| [&first, &second].map(|it| f64::from((line - it.0).abs() <= it.1));
    for line in [first.0, second.0, 0.5 * (first.0 + second.0), first.0 + 1.01 * first.1, 0.06] {
        check(at(line)?.growth.rates(), covers(line));
    }
    assert_eq!(covers(0.06), [0.0; 2]);
    let scattered = with(
        &format!("line.measured_line = {:?}\n", first.0),
        "lateral_position = { min = \"-20 mm\", max = \"20 mm\" }",
    );
    assert!(scattered.unwrap_err().to_string().contains("wear.band_width"));
    let words: Vec<String> = at(first.0)?.remarks.iter().map(ToString::to_string).collect();
    let line = format!("cover the line at {:.1} mm", 1e3 * first.0);
    assert!(words.iter().any(|words| words.contains(&line)), "{words:?}");
    // A vehicle whose wheels stand nowhere in particular.
    let text = "line.measured_line = 0\n[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed.mean = 12\n";
    let refused = Traffic::parse("t.toml", text).map(|_| ()).unwrap_err().to_string();
    assert!(refused.contains("line.measured_line") && refused.contains("vehicle[0].curve"), "{refused}");
    Ok(())
}

/// A spread of speed takes a line of growth down, and the others are told as well.
#[test]
fn each_spread_tells_what_it_does() -> Result<(), CaseError> {
    let case = nominal(&[]);
    let text = "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30, standard_deviation = 3 }\n\
                friction = [{ value = 0.4, share = 0.5 }, { value = 0.1, share = 0.5 }]\n";
    let traffic = Traffic::parse("t.toml", text)?;
    let bands = bands_of(&case);
    let (_, effects) = traffic.on_with_effects(&case, &bands, &|_| {})?;
    let names: Vec<&str> = effects.iter().map(|effect| &*effect.what).collect();
    assert_eq!(names, ["speed", "friction"]);
    assert!(effects[0].reduction.is_some_and(|factor| factor > 1.0), "{effects:?}");
    Ok(())
}

/// Any key of the case may be spread, as the stiffness of pads along the track: growth is the mean of runs with each value.
#[test]
fn a_spread_of_a_key_is_the_mean_of_its_values() -> Result<(), CaseError> {
    let case = crate::parsed(BHASKAR_TRACK_CASE, &[])?;
    let bands = bands_of(&case);
    let rates = |keys: &str| {
        let text = format!("[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = {{ mean = 30 }}\n{keys}\n");
        let on = Traffic::parse("t.toml", &text)?.on(&case, &bands, &Variant::none(""), &|_| {})?;
        Ok::<_, CaseError>(on.growth.rates().to_vec())
    };
    let [soft, stiff] = [rates("set.track.pad.stiffness = \"150 MN/m\"")?, rates("set.track.pad.stiffness = 4e8")?];
    // The key as it stands in a case, and as one word.
    for key in ["track.pad.stiffness", "\"track.pad.stiffness\""] {
        let spread = rates(&format!(
            "spread.{key} = [{{ value = \"150 MN/m\", share = 0.25 }}, {{ value = 4e8, share = \"75 %\" }}]"
        ))?;
        for ((soft, stiff), spread) in soft.iter().zip(&stiff).zip(spread) {
            let mean = 0.25 * soft + 0.75 * stiff;
            assert!((spread - mean).abs() <= 1e-12 * mean.abs(), "{spread:e} {mean:e}");
        }
    }
    Ok(())
}

/// Profiles of a fleet are names with shares: growth is the mean of runs with each of them.
#[test]
fn a_fleet_of_profiles_is_the_mean_of_its_profiles() -> Result<(), CaseError> {
    let case = curve(&["curve.radius=900 m"]);
    let bands = bands_of(&case);
    let rates = |keys: &str| {
        let text = format!(
            "[[vehicle]]\nname = \"unit\"\nshare = 1\ncurve = true\nspeeds = [{{ speed = \"45 km/h\", share = 1 }}]\n{keys}\n"
        );
        let on = Traffic::parse("t.toml", &text)?.on(&case, &bands, &Variant::none(""), &|_| {})?;
        Ok::<_, CaseError>(on.growth.rates().to_vec())
    };
    let [new, worn] = [rates("set.profiles.wheel = \"S1002\"")?, rates("set.profiles.wheel = \"cone-1:40\"")?];
    let fleet =
        rates("spread.profiles.wheel = [{ value = \"S1002\", share = 0.7 }, { value = \"cone-1:40\", share = 0.3 }]")?;
    assert_ne!(new, worn);
    for ((new, worn), fleet) in new.iter().zip(&worn).zip(fleet) {
        let mean = 0.7 * new + 0.3 * worn;
        assert!((fleet - mean).abs() <= 1e-12 * mean.abs(), "{fleet:e} {mean:e}");
    }
    let wrong = rates("spread.profiles.wheel = { min = 1, max = 2 }").unwrap_err();
    assert!(wrong.to_string().contains("vehicle[0].spread.profiles.wheel"), "{wrong}");
    Ok(())
}

#[test]
fn what_is_no_spread_is_refused_with_its_key() {
    let case = nominal(&[]);
    let speed = "speed = { mean = 30 }\n";
    let cases = [
        ("load = [{ value = 5e4, share = 0.5 }]", "vehicle[0].load"),
        ("load = { mean = 5e4, standard_deviation = 2e4 }", "vehicle[0].load"),
        ("load = { min = -5e4, max = 5e4 }", "vehicle[0].load"),
        ("load = { mean = 5e4, max = 6e4 }", "vehicle[0].load"),
        ("load = []", "vehicle[0].load"),
        ("load = { mean = 5e4, standard_deviation = 1e3 }\naxle_load = \"10 t\"", "vehicle[0].load"),
        ("friction = { min = 0.5, max = 0.3 }", "vehicle[0].friction"),
        ("wheel_radius = \"0.4 m\"", "vehicle[0].wheel_radius"),
        ("spread.contact.frition = { min = 0.3, max = 0.5 }", "vehicle[0].spread.contact.frition"),
        ("spread.contact.friction = { min = \"0.3 m\", max = 0.5 }", "vehicle[0].spread.contact.friction.min"),
        ("spread.contact.friction = 0.3", "vehicle[0].spread.contact.friction"),
        ("spread.contact.friction = { min = -0.3, max = 0.5 }", "vehicle[0].spread.contact.friction"),
        ("curve = true", "`vehicle[0].curve` is true, but the case has no [curve]"),
        ("curve = \"no-such-file.toml\"", "no-such-file.toml"),
    ];
    for (vehicle, key) in cases {
        let message = refusal(&case, &format!("{vehicle}\n{speed}"));
        assert!(message.contains(key), "{vehicle}: {message}");
    }
    let lawless = crate::parsed(NOMINAL_CASE, &["damage.laws=[]"]).map(|_| ()).unwrap_err().to_string();
    assert!(lawless.contains("`damage.laws` is an empty list"), "{lawless}");
    let narrow = crate::parsed(NOMINAL_CASE, &["wear.band_width=2 mm"]);
    let narrow = narrow.map(|_| ()).unwrap_err().to_string();
    assert!(narrow.contains("wear.band_width") && narrow.contains("one contact"), "{narrow}");
}

/// Two keys of a vehicle that say one key of the case.
#[test]
fn a_key_of_the_case_is_said_once() {
    let case = nominal(&[]);
    for (one, other) in [
        ("axle_load = \"10 t\"", "set.contact.normal_load = 3e4"),
        ("axle_load = \"10 t\"", "spread.contact.normal_load = { min = 4e4, max = 5e4 }"),
        ("set.contact.normal_load = 4e4", "load = { min = 4e4, max = 5e4 }"),
        ("wheel_mass = 350", "spread.wheel.mass = { min = 300, max = 400 }"),
        ("set.wheel.mass = 350", "spread.wheel.mass = { min = 300, max = 400 }"),
        ("rolling_radius = 0.4", "wheel_radius = { min = 0.4, max = 0.5 }"),
        ("rolling_radius = 0.4", "spread.wheel.rolling_radius = { min = 0.4, max = 0.5 }"),
        ("set.wheel.rolling_radius = 0.4", "wheel_radius = { min = 0.4, max = 0.5 }"),
        ("set.contact.friction = 0.3", "friction = { min = 0.2, max = 0.4 }"),
        ("set.contact.friction.left = 0.3", "friction = { min = 0.2, max = 0.4 }"),
        ("tractive_ratio = 0.1", "spread.contact.tractive_ratio = { min = 0.1, max = 0.2 }"),
        ("creepage = 1e-3", "spread.contact.tractive_ratio = { min = 0.1, max = 0.2 }"),
        ("creepage = 1e-3", "tractive_ratio = 0.1"),
    ] {
        let message = refusal(&case, &format!("{one}\n{other}\nspeed = {{ mean = 30 }}"));
        let key = |text: &str| format!("`vehicle[0].{}", text.split_once(" = ").unwrap().0);
        let told = format!("{}` and {}` exclude each other", key(other), key(one));
        assert!(message.contains(&told), "{told}: {message}");
    }
}

/// What has no effect on a vehicle, and what only the curve of a vehicle says, is refused with its key and the rule.
// Long: reads vehicles with a dozen wrong keys, each onto a bogie in its curve.
#[test]
fn keys_of_a_vehicle_have_an_effect() {
    let without = "is without effect";
    let of_curve = "takes its creepage from the equilibrium";
    for (case, vehicle, told) in [
        (nominal(&[]), "set.map.speed = { min = 20, max = 30 }", without),
        (nominal(&[]), "spread.map.speed.max = { min = 50, max = 60 }", without),
        (nominal(&[]), "spread.title = [{ value = \"x\", share = 1 }]", without),
        (curve(&[]), "curve = true\nset.contact.from.wheelset = 2", without),
        (curve(&[]), "curve = true\nset.curve.speed = 10", without),
        (curve(&[]), "curve = true\nspread.curve.speed = { min = 10, max = 14 }", without),
        (curve(&[]), "curve = true\ntractive_ratio = 0.1", of_curve),
        (curve(&[]), "curve = true\ncreepage = 1e-3", of_curve),
        (curve(&[]), "curve = true\nspread.contact.tractive_ratio = { min = 0.1, max = 0.2 }", of_curve),
        (curve(&[]), "creepage = 1e-3", "takes creepage and load from a bogie"),
        (curve(&[]), "spread.contact.friction = { min = 0.2, max = 0.4 }", "takes creepage and load from a bogie"),
    ] {
        let message = refusal(&case, &format!("{vehicle}\nspeeds = [{{ speed = 12.5, share = 1 }}]"));
        let key = vehicle.trim_start_matches("curve = true\n").split_once(" = ").unwrap().0;
        assert!(message.starts_with(&format!("`vehicle[0].{key}")) && message.contains(told), "{vehicle}: {message}");
    }
}

/// An axle load, a wheel load and a radius reach the bogie, as their spreads do.
// Long: finds the equilibrium of a bogie for every load.
#[test]
fn loads_and_radii_of_a_vehicle_reach_its_bogie() -> Result<(), CaseError> {
    let rates = |vehicle: &str| -> Result<Vec<f64>, CaseError> {
        let vehicle = format!("curve = true\n{vehicle}\nspeeds = [{{ speed = 12.5, share = 1 }}]");
        Ok(on(&curve(&[]), &vehicle)?.growth.rates().to_vec())
    };
    let loads =
        ["load = [{ value = 39226.6, share = 1 }]", "set.bogie.mass_per_axle = \"8 t\"", "wheel_load = 39226.6"];
    let without = rates("")?;
    for (one, others) in
        [("axle_load = \"8 t\"", &loads[..]), ("rolling_radius = 0.4", &["wheel_radius = { min = 0.4, max = 0.4 }"])]
    {
        let own = rates(one)?;
        assert_ne!(own, without, "{one}");
        for other in others {
            assert_eq!(own, rates(other)?, "{one} {other}");
        }
    }
    Ok(())
}

/// A friction modifier on one rail stays under days that scale both, and is not wiped out by one friction for both.
// Long: finds the equilibrium of a bogie for every friction.
#[test]
fn friction_of_each_rail_stays_under_a_traffic() -> Result<(), CaseError> {
    let rails = &["contact.friction={ left = 0.4, right = 0.2 }"];
    let rates = |keys: &[&str], vehicle: &str| -> Result<Vec<f64>, CaseError> {
        let vehicle = format!("curve = true\nspeeds = [{{ speed = 12.5, share = 1 }}]\n{vehicle}");
        Ok(on(&curve(keys), &vehicle)?.growth.rates().to_vec())
    };
    let same = "[line]\nfriction_days = { factor = 1 }";
    // The logarithm of friction costs its last digits.
    let (days, as_it_is) = (rates(rails, same)?, rates(rails, "")?);
    let largest = as_it_is.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
    assert!(days.iter().zip(&as_it_is).all(|(a, b)| (a - b).abs() < 1e-11 * largest), "{days:?}");
    assert_ne!(rates(rails, same)?, rates(&[], same)?);
    let own = format!("set.contact.friction = {{ left = 0.4, right = 0.2 }}\n{same}");
    assert_eq!(rates(&[], &own)?, rates(rails, "")?);
    // The mean over the days is that over the same factors of both rails.
    let days = rates(rails, "[line]\nfriction_days = { factor = 1.1 }")?;
    assert_ne!(days, rates(rails, "")?);
    for (vehicle, key) in [
        ("friction = [{ value = 0.4, share = 1 }]", "vehicle[0].friction"),
        ("spread.contact.friction = { min = 0.3, max = 0.5 }", "vehicle[0].spread.contact.friction"),
        ("[line]\nfriction_days = { mean = 0.4 }", "line.friction_days"),
    ] {
        let message = rates(rails, vehicle).map(|_| ()).unwrap_err().to_string();
        let told =
            format!("`{key}` is one friction for both rails, but `contact.friction` is 0.4 on the left rail and 0.2");
        assert!(message.contains(&told) && message.contains("set.contact.friction = { left"), "{message}");
    }
    Ok(())
}

/// A key of one rail gives a table of both, in which the other rail keeps its value.
#[test]
fn one_rail_takes_a_value_of_its_own() {
    let growth = |keys: &[&str]| curve(keys).point(0.06, 12.5).unwrap().growth_rate;
    for (both, one, table) in [
        ("contact.friction=0.3", "contact.friction.right=0.2", "contact.friction={ left = 0.3, right = 0.2 }"),
        ("profiles.rail=60E1", "profiles.rail.right=54E1", "profiles.rail={ left = \"60E1\", right = \"54E1\" }"),
    ] {
        assert_eq!(growth(&[both, one]), growth(&[table]), "{one}");
        assert_ne!(growth(&[both]), growth(&[table]), "{one}");
    }
    let straight = crate::parsed(NOMINAL_CASE, &["contact.friction.left=0.1"]).map(|_| ()).unwrap_err().to_string();
    assert!(straight.contains("contact.friction.left=0.1") && straight.contains("`contact.friction` is"), "{straight}");
}

/// Tonnes are of the axles of the bogie, whichever rail is under study.
#[test]
fn tonnes_are_of_axles_of_the_bogie() -> Result<(), CaseError> {
    for rail in ["contact.from.rail=low", "contact.from.rail=high"] {
        for vehicle in ["curve = true\n", ""] {
            let on = on(&curve(&[rail]), &format!("{vehicle}speeds = [{{ speed = 12.5, share = 1 }}]"))?;
            assert!((on.growth.axle_mass() - 1e4).abs() < 1e-6, "{rail} {}", on.growth.axle_mass());
        }
    }
    Ok(())
}

/// So fast that the bogie tips over: the speed is told.
#[test]
fn a_speed_without_equilibrium_is_told() {
    let message =
        refusal(&curve(&[]), "curve = true\nspeeds = [{ speed = 12.5, share = 0.5 }, { speed = 60, share = 0.5 }]");
    assert!(message.contains("vehicle[0].curve") && message.contains("216.0 km/h"), "{message}");
}
