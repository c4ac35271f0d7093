//! Traffic files, files of changes and surveys as users write them.

use riffel_case::traffic::{Traffic, TrafficOnCase, bands_of};
use riffel_case::{Case, NOMINAL_CASE, TRAFFIC, Variant};
use riffel_keys::CaseError;
use riffel_rail::{Layout, RoughnessFile, Survey};

use crate::nominal;

/// What the traffic makes of the case as it is.
fn on(traffic: &Traffic, case: &Case) -> Result<TrafficOnCase, CaseError> {
    traffic.on(case, &bands_of(case), &Variant::none(""), &|_| {})
}

const VEHICLE: &str = "[[vehicle]]\nname = \"unit\"\nshare = 1\n";
const SPEED: &str = "speed = { mean = 30 }\n";

#[test]
fn the_example_runs_on_the_nominal_case() -> Result<(), CaseError> {
    let traffic = Traffic::parse("traffic.toml", TRAFFIC)?;
    let case = nominal(&[]);
    let on = on(&traffic, &case)?;
    assert_eq!(on.passages_per_day, Some(6000.0));
    // 0.55 · 13 t + 0.05 · 21 t + 0.4 · 16 t.
    assert!((on.growth.axle_mass() - 14_600.0).abs() < 1e-6);
    assert_eq!(on.growth.vehicles()[1].wheel_load, 0.5 * 21e3 * 9.80665);
    assert_eq!(on.growth.bands().len(), 7);
    assert!(on.remarks[0].to_string().starts_with("multiple unit: "), "{:?}", on.remarks);
    Ok(())
}

/// A vehicle without values of its own is the wheel of the case.
#[test]
fn what_a_vehicle_leaves_out_is_of_the_case() -> Result<(), CaseError> {
    let case = nominal(&[]);
    let traffic = Traffic::parse("t.toml", &format!("{VEHICLE}{SPEED}"))?;
    let on = on(&traffic, &case)?;
    let wavelength = on.growth.wavelengths()[50];
    let expected = case.feedback.at(wavelength, 30.0).growth_rate;
    assert!((on.growth.rates()[50] / expected - 1.0).abs() < 1e-12);
    assert_eq!(on.growth.vehicles()[0].wheel_load, 50e3);
    Ok(())
}

#[test]
fn tonnes_a_year_are_axles_a_day() -> Result<(), CaseError> {
    let text = format!("[line]\nmgt_per_year = 20\n{VEHICLE}axle_load = \"20 t\"\n{SPEED}");
    let case = nominal(&[]);
    let on = on(&Traffic::parse("t.toml", &text)?, &case)?;
    let a_day = on.passages_per_day.unwrap();
    assert!((a_day / (1e6 / 365.2425) - 1.0).abs() < 1e-12, "{a_day}");
    Ok(())
}

#[test]
fn keys_of_the_case_can_be_set_for_one_vehicle() -> Result<(), CaseError> {
    let set = "[vehicle.set]\ncontact.friction = 0.3\nwheel = { rotation = \"constant-creepage\" }\n";
    let text = format!("{VEHICLE}{SPEED}creepage = \"0.03 %\"\n{set}");
    let case = nominal(&[]);
    let on = on(&Traffic::parse("t.toml", &text)?, &case)?;
    let changed = ["contact.friction=0.3", "contact.creepage=3e-4", "wheel.rotation=constant-creepage"];
    let changed = changed.map(str::to_owned);
    let expected = Case::parse("case.toml", NOMINAL_CASE, &changed)?;
    let wavelength = on.growth.wavelengths()[50];
    let expected = expected.feedback.at(wavelength, 30.0).growth_rate;
    assert!((on.growth.rates()[50] / expected - 1.0).abs() < 1e-12);
    Ok(())
}

/// A speed without its unit is asked about where it may be in km/h, once, and not of the window that follows from it.
#[test]
fn a_speed_without_its_unit_is_asked_about() -> Result<(), CaseError> {
    let asked = |mean: &str| -> Result<Vec<String>, CaseError> {
        let text = format!("{VEHICLE}speed = {{ mean = {mean} }}\n");
        let case = nominal(&[]);
        let traffic = Traffic::parse("t.toml", &text)?;
        let on = on(&traffic, &case)?;
        let remarks = on.remarks.into_iter();
        Ok(remarks.map(|remark| remark.to_string()).filter(|remark| remark.contains("did you mean")).collect())
    };
    assert_eq!(
        asked("52")?,
        ["vehicle[0].speed.mean has no unit and is read as 52 m/s = 187.2 km/h (did you mean \"52 km/h\" or \
             \"52 mph\"?)"]
    );
    assert!(asked("\"52 m/s\"")?.is_empty());
    assert!(asked("14.5")?.is_empty());
    Ok(())
}

#[test]
fn wrong_traffic_is_refused() {
    for row in [
        "[[vehicle]]\nname = \"unit\"\n => `vehicle[0].share` is missing",
        "vehicle = []\n => `vehicle` is missing",
        "title = \"none\"\n => `vehicle` is missing",
        "[[vehicle]]\nname = \" \"\nshare = 1\nspeed = { mean = 30 }\n => `vehicle[0].name` is empty",
        "[[vehicle]]\nname = \"unit\"\nshare = 0.7\nspeed = { mean = 30 }\n => sum to 0.7000, but must sum to 1",
        "[[vehicle]]\nname = \"unit\"\nshare = -1\nspeed = { mean = 30 }\n => `vehicle[0].share` is -1, but must be greater",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\n => `vehicle[0].speed` is missing",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = \"30 kN\" }\n => not a speed in m/s",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30, standard_deviation = 8 }\n => less than a quarter of the mean",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeeds = [{ speed = 30, share = 0.5 }]\n => `vehicle[0].speeds` sum to 0.5",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\nspeeds = [{ speed = 30, share = 1 }]\n => exclude each other",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\naxle_load = \"10 t\"\nwheel_load = \"50 kN\"\n => exclude each other",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\ntraction = 0.2\n => `vehicle[0].traction` is not a key",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\ntractive_ratio = 1.2\n => `vehicle[0].tractive_ratio` is 1.2, but must be between 1e-6 and 0.999999",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\naxle_load = \"20 kN\"\n => is \"20 kN\", a force, but must be a mass",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeeds = [{ speed = 300, share = 1 }]\n => `vehicle[0].speeds[0].speed` is 300 m/s, but must be between 0.01 m/s and 200 m/s",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeeds = []\n => `vehicle[0].speeds` is an empty list",
        "[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\ncurve = 5\n => `vehicle[0].curve` is neither true, for the curve of the case",
        "[line]\nmeasured_line = 10\n[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\n => `line.measured_line` is 10 m, but must be between -100 mm and 100 mm",
        "[line]\npassages_per_day = 0\n[[vehicle]]\nname = \"unit\"\nshare = 1\nspeed = { mean = 30 }\n => `line.passages_per_day` is 0",
    ] {
        let (text, part) = row.split_once(" => ").unwrap();
        let error = Traffic::parse("t.toml", text).expect_err("a mistake");
        assert!(error.to_string().contains(part), "{error}");
    }
}

/// What is wrong only with the case is found with it, and said of the vehicle, with its line.
#[test]
fn a_vehicle_that_the_case_refuses_is_named() {
    for row in [
        "[vehicle.set]\ncontact.friction = -0.2\n => vehicle[0].set.contact.friction => between 0.001 and 1.5",
        "[vehicle.set]\ncontact.frction = 0.2\n => vehicle[0].set.contact.frction => did you mean friction",
    ] {
        let [rest, key, rule] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let traffic = Traffic::parse("t.toml", &format!("{VEHICLE}{SPEED}{rest}")).unwrap();
        let case = nominal(&[]);
        let error = on(&traffic, &case).unwrap_err();
        assert!(error.to_string().contains(key) && error.to_string().contains(rule), "{error}");
        let CaseError::Invalid { span, .. } = error else {
            panic!("{error:?}");
        };
        assert!(span.is_some());
    }
}

/// A later set of overrides replaces what an earlier one excludes.
#[test]
fn sets_of_overrides_follow_each_other() -> Result<(), CaseError> {
    let text = |text: &str| vec![text.to_owned()];
    let base = Case::parse("case.toml", NOMINAL_CASE, &text("contact.creepage=1e-3"))?;
    let ratio = base.with(&text("contact.tractive_ratio=0.3")[..])?.with(&text("rail.section=60E1")[..])?;
    assert!((ratio.steady.tractive_ratio() - 0.3).abs() < 1e-12);
    assert_eq!(ratio.file.rail.mass_per_length.unwrap().si(), 60.21);
    assert!((base.steady.creepages.longitudinal - 1e-3).abs() < 1e-15);
    Ok(())
}

const TABLE: &str = "id,section,date,wavelength_mm,level_db\n\
    1,A,2024-03-01,20,-4\n1,A,2024-03-01,25,-8\n\
    2,B,2024-03-01,20,-2\n2,B,2024-03-01,25,-9\n\
    3,B,2025-03-01,20,-6\n3,B,2025-03-01,25,-9\n\
    4,A,2025-03-01,20,-8\n4,A,2025-03-01,25,-7\n";

fn survey(text: &str) -> Survey {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("table.csv");
    std::fs::write(&path, text).unwrap();
    let file = RoughnessFile::read(&path, &Layout::default(), &|_| {}).unwrap();
    Survey::of(&path, file).unwrap()
}

/// Sections pair whatever the order of the rows; the number of the spectrum and the date do not count.
#[test]
fn records_are_paired_by_place() -> Result<(), CaseError> {
    let dates = survey(TABLE).by_date("date")?;
    let [(first, earlier), (last, later)] = &dates[..] else {
        panic!("{dates:?}");
    };
    assert_eq!((first.to_string(), last.to_string()), ("2024-03-01".into(), "2025-03-01".into()));
    let change = later.change_since(earlier, 1e6).unwrap();
    let spectra = |survey: &Survey| survey.spectra();
    // By section: A of both, then B of both.
    let (a, b) = (spectra(later)[1].clone(), spectra(later)[0].clone());
    let expected = riffel::forecast::MeasuredChange::paired(spectra(earlier), vec![a, b], 1e6).unwrap();
    assert_eq!(change, expected);
    Ok(())
}

#[test]
fn wrong_choices_are_refused() {
    for (message, part) in [
        (survey(TABLE).choose(&["section=C".to_owned()]).unwrap_err(), "no spectrum has section=C"),
        (survey(TABLE).choose(&["rail=L".to_owned()]).unwrap_err(), "no column \"rail\""),
        (survey(TABLE).choose(&["section".to_owned()]).unwrap_err(), "COLUMN=VALUE"),
        (survey(TABLE).by_date("section").unwrap_err(), "is no date"),
    ] {
        assert!(message.to_string().contains(part), "{message}");
    }
}

#[test]
fn unusual_amounts_are_asked_about() {
    let traffic = |amount: &str| {
        let text = format!("[line]\n{amount}\n[[vehicle]]\nname = \"a\"\nshare = 1\nspeed = {{ mean = 20 }}\n");
        Traffic::parse("t.toml", &text).unwrap()
    };
    let case = nominal(&[]);
    let remarks = |amount: &str| -> Vec<String> {
        let on = on(&traffic(amount), &case);
        on.unwrap().remarks.iter().map(ToString::to_string).collect()
    };
    // A thousand's point that is none.
    let asked = remarks("passages_per_day = 6.000");
    assert!(
        asked.iter().any(|remark| remark.contains("line.passages_per_day is 6; usual values are 20 to")),
        "{asked:?}"
    );
    let asked = remarks("passages_per_day = 6000");
    assert!(asked.iter().all(|remark| !remark.contains("passages_per_day")), "{asked:?}");
    let asked = remarks("mgt_per_year = 2500");
    assert!(asked.iter().any(|remark| remark.contains("line.mgt_per_year is 2500")), "{asked:?}");
}

#[test]
fn an_axle_load_is_no_force() {
    let text = "[[vehicle]]\nname = \"a\"\nshare = 1\nspeed = { mean = 20 }\naxle_load = \"130 kN\"\n";
    let error = Traffic::parse("t.toml", text).err().unwrap();
    let sentence = error.to_string();
    assert!(
        sentence.contains("130 kN") && sentence.contains("wheel_load") && sentence.contains("as in \"13 t\""),
        "{sentence}"
    );
}

#[test]
fn a_traffic_file_is_no_file_of_changes() {
    let text = "[[vehicle]]\nname = \"a\"\nshare = 1\nspeed = { mean = 20 }\n";
    let error = Variant::parse("t.toml", text).err().unwrap().to_string();
    assert!(error.starts_with("this is a traffic file"), "{error}");
}

const WHEELSET: &str = "model = \"rigid\"\nmass = 1200\nroll_inertia = 620\nspin_inertia = 55\n";

/// A vehicle with a wheelset and a table of creepages is the case that has both, and the wheel of the case is gone.
#[test]
fn a_vehicle_brings_its_wheelset() -> Result<(), CaseError> {
    let law = "contact.creep_law=fastsim".to_owned();
    let case = Case::parse("case.toml", NOMINAL_CASE, std::slice::from_ref(&law))?;
    let text = format!(
        "{VEHICLE}creepage = {{ lateral = \"0.2 %\", longitudinal = \"0.1 %\" }}\n{SPEED}[vehicle.set.wheelset]\n{WHEELSET}"
    );
    let traffic = Traffic::parse("t.toml", &text)?;
    let on = on(&traffic, &case)?;

    let alone = NOMINAL_CASE.replacen("mass = \"350 kg\"", "", 1).replacen(
        "tractive_ratio = 0.1",
        "creepage = { lateral = 0.002, longitudinal = 0.001 }",
        1,
    );
    let alone = Case::parse("alone.toml", &format!("{alone}\n[wheelset]\n{WHEELSET}"), &[law])?;
    let wavelength = on.growth.wavelengths()[50];
    let expected = alone.feedback.at(wavelength, 30.0).growth_rate;
    assert!((on.growth.rates()[50] / expected - 1.0).abs() < 1e-12);
    let before = case.feedback.at(wavelength, 30.0).growth_rate;
    assert!((expected / before - 1.0).abs() > 0.1, "{expected} {before}");
    Ok(())
}

/// What goes with a wheelset, or with full sliding, is said at the key of the vehicle.
#[test]
fn what_a_vehicle_cannot_bring() -> Result<(), CaseError> {
    for row in [
        "wheel_mass = 500\n =>  => `vehicle[0].wheel_mass`: `wheel.mass` and `wheelset` exclude each other",
        "tractive_ratio = 0.3\n => contact.creep_law=full-sliding => is no mean state of a law of full sliding",
        "creepage = { sideways = 0.01 }\n =>  => vehicle[0].creepage.sideways",
        "creepage = { lateral = 0.01 }\n => contact.creep_law=carter-2d => `vehicle[0].creepage`: `contact.creepage.lateral` is 0.01",
    ] {
        let [key, law, expected] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let wheelset = "wheelset={ model = \"rigid\", mass = 1200, roll_inertia = 620, spin_inertia = 55 }".to_owned();
        let overrides: Vec<String> = std::iter::once(wheelset)
            .chain((!law.is_empty()).then(|| law.to_owned()))
            // The case itself has a mean state that every law knows.
            .chain(["contact.creepage={ longitudinal = 0.001 }".to_owned()])
            .collect();
        let case = Case::parse("case.toml", NOMINAL_CASE, &overrides)?;
        let error = match Traffic::parse("t.toml", &format!("{VEHICLE}{key}{SPEED}")) {
            Err(error) => error,
            Ok(traffic) => on(&traffic, &case).unwrap_err(),
        };
        let words = format!("{error} {}", error.in_words());
        assert!(words.contains(expected), "{words}");
    }
    Ok(())
}
