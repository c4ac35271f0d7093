//! Bogies in curves, from the command line to the files.

use crate::sandbox::{Sandbox, number};

const CASE: &str = "cases/bogie.toml";

/// The document has what the table over the radius has at the radius of the case, and tells its residuals.
#[test]
fn curve_and_its_table_hold_the_same() {
    let sandbox = Sandbox::new();
    let written = sandbox.riffel(&format!("curve {CASE} --json -o out"));
    assert_eq!(written.status, Some(0), "{}", written.text);
    let document = sandbox.json(&format!("curve {CASE} --json --radius \"300 m,-300 m\""));
    let first = &document["wheelsets"][0];
    // The leading wheelset of a stiff bogie runs on its outer flange, with its nose to the outside.
    assert!(first["lateral_shift_m"].as_f64().unwrap() < -5e-3);
    assert!(first["angle_of_attack_rad"].as_f64().unwrap() > 1e-3);
    assert!(document["residual"].as_f64().unwrap() < 1e-10);
    for step in document["continuation"].as_array().unwrap() {
        assert!(step["residual"].as_f64().unwrap() < 1e-10);
    }
    let power = document["frictional_power_w"].as_f64().unwrap();
    let wheels = document["wheels"].as_array().unwrap();
    let sum: f64 = wheels.iter().map(|wheel| wheel["t_gamma_n"].as_f64().unwrap()).sum();
    assert!((sum * 60.0 / 3.6 / power - 1.0).abs() < 1e-12);
    // At listed radii, the first that of the case, the second its mirror image.
    let over_radius = document["over_radius"].as_array().unwrap();
    let state = |index: usize| &over_radius[index]["equilibrium"];
    assert_eq!(state(0)["wheels"], document["wheels"]);
    let shift = |index: usize| state(index)["wheelsets"][0]["lateral_shift_m"].as_f64().unwrap();
    assert!((shift(0) + shift(1)).abs() < 1e-10);
    let refused = sandbox.riffel(&format!("curve {CASE} --radius 2"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.sentence().contains("larger than the wheelbase"), "{}", refused.text);
    // Above the case and below it the table has radii; wear falls with the radius.
    let table = std::fs::read_to_string(sandbox.path("out/curve.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let wear = |row: &Vec<&str>| row.last().unwrap().parse::<f64>().unwrap();
    assert_eq!(rows.len() % 4, 0);
    assert!(rows.len() >= 4 * 70, "{}", rows.len());
    assert!(wear(&rows[0]) > 10.0 * wear(&rows[rows.len() - 4]));
}

/// A case of all axes may hold the tables of curving, and both commands read it.
#[test]
fn an_ordinary_case_may_hold_the_tables() {
    let sandbox = Sandbox::new();
    let ordinary = std::fs::read_to_string(sandbox.path("cases/nominal.toml")).unwrap();
    let tables = std::fs::read_to_string(sandbox.path(CASE)).unwrap();
    let from = tables.find("[curve]").unwrap();
    let to = tables.find("[contact]").unwrap();
    std::fs::write(sandbox.path("both.toml"), format!("{ordinary}\n{}", &tables[from..to])).unwrap();
    let point = sandbox.json("point both.toml --wavelength 0.05 --speed 30 --json");
    assert_eq!(point, sandbox.json("point cases/nominal.toml --wavelength 0.05 --speed 30 --json"));
    let wheelset = "--set wheelset.mass=1400 --set wheelset.contact_spacing=1.5";
    let law = "--set contact.creep_law=shen-hedrick-elkins";
    sandbox.json(&format!("curve both.toml {wheelset} {law} --json"));
}

/// What may be meant is computed, with a remark: cones without a flange, linear creep beyond friction.
#[test]
fn unusual_equilibria_are_remarked() {
    let sandbox = Sandbox::new();
    let text = std::fs::read_to_string(sandbox.path(CASE)).unwrap();
    let without: String =
        text.lines().filter(|line| !line.starts_with("flange")).map(|line| format!("{line}\n")).collect();
    std::fs::write(sandbox.path("cones.toml"), without).unwrap();
    let remarks = |arguments: &str| {
        let document = sandbox.json(&format!("curve cones.toml --json {arguments}"));
        document["remarks"].to_string()
    };
    let linear = remarks("--set curve.theory=linear --set curve.radius=\"600 m\" --set contact.friction=0.01");
    assert!(linear.contains("this case has none"), "{linear}");
    assert!(linear.contains("knows no friction"), "{linear}");
    assert!(!linear.contains("without the moment of spin"), "{linear}");
    // A wheelset in the middle of a wide curve has spin and hardly any creepage.
    let wide = remarks("--set curve.theory=linear --set curve.radius=\"20000 m\" --set curve.cant=0");
    assert!(wide.contains("without the moment of spin"), "{wide}");
}

/// A vehicle on two bogies and a lone wheelset from the same file.
#[test]
fn vehicles_and_lone_wheelsets_run() {
    let sandbox = Sandbox::new();
    let text = std::fs::read_to_string(sandbox.path(CASE)).unwrap();
    let body = "[body]\nbogie_spacing = \"15 m\"\nmass = \"28 t\"\nsecondary_lateral_stiffness = \"0.4 MN/m\"\nsecondary_yaw_stiffness = \"0.3 MN m/rad\"\n";
    std::fs::write(sandbox.path("vehicle.toml"), format!("{text}\n{body}")).unwrap();
    let document = sandbox.json("curve vehicle.toml --json");
    let count = |key: &str| document[key].as_array().unwrap().len();
    assert_eq!((count("wheelsets"), count("wheels"), count("frames")), (4, 8, 2));
    assert!(document["body"]["yaw_rad"].is_number() && document["frame"].is_null());
    let moment = |bogie: usize| document["frames"][bogie]["secondary_yaw_moment_nm"].as_f64().unwrap();
    // To the right: the leading bogie is turned to the left.
    assert!(moment(0) < 0.0 && moment(1) > 0.0);
    let torque = sandbox.riffel("curve vehicle.toml --set 'bogie.drive_torque=[1, 2]'");
    assert!(torque.sentence().contains("has 2 torques, but there are 4 wheelsets"), "{}", torque.text);
    let alone: String =
        text.lines().filter(|line| !line.starts_with("wheelbase")).map(|line| format!("{line}\n")).collect();
    std::fs::write(sandbox.path("alone.toml"), alone).unwrap();
    let document = sandbox.json("curve alone.toml --set bogie.wheelsets=1 --json");
    assert_eq!(document["wheels"].as_array().unwrap().len(), 2);
    assert!(document["frame"]["yaw_rad"].as_f64() == Some(0.0));
    let missing = sandbox.riffel("curve alone.toml --json");
    assert!(missing.sentence().contains("wheelbase"), "{}", missing.text);
}

/// Bad input ends in one sentence with its key.
#[test]
fn what_cannot_run_is_refused() {
    let sandbox = Sandbox::new();
    for (change, sentence) in [
        ("--set curve.radius=0.5", "must be larger than the wheelbase"),
        ("--set curve.radius=\"60 m\" --set curve.speed=\"100 km/h\"", "the vehicle tips over"),
        ("--set curve.theory=linear", "knows no flange"),
        ("--set contact.creep_law=polach", "\"polach\" is not one of its choices"),
        ("--set profiles.flange.stiffness=\"50 MN/m\"", "takes a flange of slope, shift, width"),
        ("--set bogie.weelbase=2", "is not a key Riffel knows"),
        ("--set contact.friction=40", "friction"),
        ("--set wheelset.mass=\"12 t\"", "at most the mass per axle"),
        (
            "--set 'bogie.drive_torque=[\"60 kN m\",\"0 N m\"]'",
            "60000 N m on wheelset 1 is more than the 19936 N m that friction carries",
        ),
        ("--radius \"3,800 m\"", "3,800 m are two"),
        ("--set profiles.flange.slope=0.05", "must be shifted by less than 60 mm"),
    ] {
        let refused = sandbox.riffel(&format!("curve {CASE} {change}"));
        assert_eq!(refused.status, Some(2), "{change}: {}", refused.text);
        assert!(refused.sentence().contains(sentence), "{change}: {}", refused.text);
        assert_eq!(sandbox.list("."), ["cases"]);
    }
    let spacing = "--set wheelset.contact_spacing=\"1.6 m\"";
    let refused = sandbox.riffel(&format!("curve cases/profiles.toml {spacing}"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.sentence().contains("the profiles lie 1.5000 m apart"), "{}", refused.text);
}

/// Profiles from files as the nominal ones, in the same place on the wheel, and the table beside the document.
#[test]
fn profiles_of_files_are_those_of_their_names() {
    let sandbox = Sandbox::new();
    let case = "cases/profiles.toml";
    let shown = sandbox.json("profile S1002 60E1 --json");
    for (index, name) in ["wheel.csv", "rail.csv"].into_iter().enumerate() {
        let profile = &shown["profiles"][index];
        let column = |key: &str| -> Vec<f64> { serde_json::from_value(profile[key].clone()).unwrap() };
        let rows = column("x_m").into_iter().zip(column("height_m"));
        let rows: Vec<String> = rows.map(|(x, height)| format!("{x:.9};{height:.9}")).collect();
        std::fs::write(sandbox.path(name), format!("x [m]; y [m]\n{}\n", rows.join("\n"))).unwrap();
    }
    let asked = "--wheelset --yaw \"2 mrad\" --lateral-shift=\"-3 mm,0 mm,4.5 mm\" --json";
    let nominal = sandbox.json(&format!("profile {case} {asked}"));
    // The case lies in another folder than the files.
    let files = "--set profiles.wheel=../wheel.csv --set profiles.rail=../rail.csv";
    let of_files = sandbox.json(&format!("profile {case} {asked} {files}"));
    let column = |document: &serde_json::Value, key: &str| -> Vec<f64> {
        serde_json::from_value(document[key].clone()).unwrap()
    };
    for (key, tolerance) in [("centre_z", 1e-7), ("right_y_wheel", 5e-5), ("left_y_wheel", 5e-5), ("roll", 2e-7)] {
        let pairs = column(&nominal, key).into_iter().zip(column(&of_files, key));
        for (one, other) in pairs {
            assert!((one - other).abs() < tolerance, "{key}: {one} {other}");
        }
    }
    let shifts = column(&nominal, "lateral_shift").into_iter().zip([-0.003, 0.0, 0.0045]);
    assert!(shifts.into_iter().all(|(got, asked)| (got - asked).abs() < 1e-12));
    // About 0.18 at 3 mm.
    let klingel = nominal["equivalent_conicity"]["klingel"][2].as_f64().unwrap();
    assert!((klingel - 0.1771).abs() < 5e-4, "{klingel}");
    let curve = sandbox.json(&format!("curve {case} --json"));
    assert!(curve["residual"].as_f64().unwrap() < 1e-10);
    assert!(curve["wheelsets"][0]["lateral_shift_m"].as_f64().unwrap() < 0.0);
}

/// In a tight curve S1002 stands on tread and flange of 60E1, at the shift at which both touch; the document, the words and
/// the table tell both contacts, and their forces carry the load of the wheel.
#[test]
fn tight_curves_stand_on_two_points() {
    let sandbox = Sandbox::new();
    let tight = "--set curve.radius=150 --set bogie.primary_longitudinal_stiffness=\"10 MN/m\" --set curve.cant=\"100 mm\" --set curve.speed=\"11.6 m/s\"";
    let case = format!("curve cases/profiles.toml {tight} --radius 150");
    let document = sandbox.json(&format!("{case} --json"));
    let number = |value: &serde_json::Value, key: &str| value[key].as_f64().unwrap();
    let wheel = &document["wheels"][0];
    assert_eq!(wheel["on_two_points"], true);
    let second = &wheel["second_contact"];
    assert!(number(wheel, "normal_force_n") > 0.0 && number(second, "normal_force_n") > 0.0);
    // Near 70 degrees, the flange of S1002.
    assert!((number(second, "contact_angle_rad").to_degrees() - 70.0).abs() < 0.2);
    let carried = |contact: &serde_json::Value| {
        let angle = number(contact, "contact_angle_rad");
        number(contact, "normal_force_n") * angle.cos() + number(contact, "lateral_force_n") * angle.sin()
    };
    let load = number(wheel, "vertical_load_n");
    assert!((carried(wheel) + carried(second) - load).abs() < 1e-9 * load);
    assert!(number(&document, "residual") < 1e-10);
    let wheels = document["wheels"].as_array().unwrap();
    let wear: f64 = wheels
        .iter()
        .flat_map(|wheel| [wheel, &wheel["second_contact"]])
        .filter_map(|contact| contact["t_gamma_n"].as_f64())
        .sum();
    assert!((wear * 11.6 / number(&document, "frictional_power_w") - 1.0).abs() < 1e-12);
    let written = sandbox.riffel(&format!("{case} -o out"));
    assert!(written.text.contains("1 left, second"), "{}", written.text);
    assert!(written.text.contains("wheelset 1 stands on two points of the left wheel"), "{}", written.text);
    let table = std::fs::read_to_string(sandbox.path("out/curve.csv")).unwrap();
    let contacts = 4 + wheels.iter().filter(|wheel| wheel["on_two_points"] == true).count();
    assert_eq!(table.lines().count(), 1 + contacts);
}

/// On a flange of 70° the axle of 600 mm wheels turns back as they climb: they find their equilibrium on it as smaller ones do.
#[test]
fn large_wheels_stand_on_their_flanges() {
    let sandbox = Sandbox::new();
    let document = sandbox.json(
        "curve cases/profiles.toml --set wheel.rolling_radius=0.6 --set curve.radius=150 --set curve.speed=11.6 --set curve.cant=0.1 --set \
         'bogie.primary_longitudinal_stiffness=\"10 MN/m\"' --json",
    );
    let wheel = &document["wheels"][0];
    assert_eq!(wheel["on_two_points"], true);
    let angle = wheel["second_contact"]["contact_angle_rad"].as_f64().unwrap();
    assert!((angle.to_degrees() - 70.0).abs() < 0.2, "{angle}");
    assert!(document["residual"].as_f64().unwrap() < 1e-10);
}

/// FASTSIM is a law of the curve; it needs an ellipse. Yaw that takes play from the flange is told.
#[test]
fn fastsim_is_a_law_of_the_curve() {
    let sandbox = Sandbox::new();
    let law = "--set contact.creep_law=fastsim";
    let forces = |law: &str| {
        let document = sandbox.json(&format!(
            "curve cases/profiles.toml --set curve.radius=\"60 m\" --set curve.speed=\"10 km/h\" {law} --json"
        ));
        assert!(document["remarks"].to_string().contains("to its flange, not the"));
        document["wheels"][0]["lateral_force_n"].as_f64().unwrap()
    };
    assert!((forces(law) - forces("")).abs() > 10.0);
    let coefficients = "--set 'contact.creep_coefficients={longitudinal=\"10 MN\", lateral=\"9 MN\", spin=\"20 kN m\", load=\"54 kN\"}'";
    let refused = sandbox.riffel(&format!("curve {CASE} {law} {coefficients}"));
    assert_eq!(refused.status, Some(2), "{}", refused.text);
    assert!(refused.sentence().contains("needs the ellipse itself"), "{}", refused.text);
}

/// Profiles that cannot be end in one sentence.
#[test]
fn profiles_that_cannot_be_are_refused() {
    let sandbox = Sandbox::new();
    let arc = |side: f64| {
        let rows = (-300..=300).map(|index| {
            let x = 0.1 * f64::from(index);
            format!("{x},{}\n", side * x * x / 600.0)
        });
        rows.collect::<Vec<String>>()
    };
    let mut swapped = arc(-1.0);
    swapped.swap(40, 90);
    std::fs::write(sandbox.path("swapped.csv"), swapped.concat()).unwrap();
    std::fs::write(sandbox.path("upside-down.csv"), arc(1.0).concat()).unwrap();
    std::fs::write(sandbox.path("words.csv"), "x,y\n1,2\nabout 3,4\n").unwrap();
    for (change, sentence) in [
        ("profiles.rail=../swapped.csv", "swapped.csv, line 90"),
        ("profiles.rail=../upside-down.csv", "upside down"),
        ("profiles.rail=../words.csv", "words.csv, line 3"),
        ("profiles.rail=../none.csv", "cannot be read"),
        ("profiles.wheel=60E1", "is \"60E1\", which is a rail"),
        ("profiles.gauge=1.7 m", "do not stand on both rails"),
        ("profiles.gauge_height=40 mm", "ends above the gauge height"),
        ("profiles.inclination=steep", "as in \"1:40\""),
        ("profiles.wheel=cone", "which has no profile"),
    ] {
        let refused = sandbox.riffel(&format!("profile cases/profiles.toml --wheelset --json --set '{change}'"));
        assert_eq!(refused.status, Some(2), "{change}: {}", refused.text);
        assert!(refused.sentence().contains(sentence), "{change}: {}", refused.text);
    }
    let far = sandbox.riffel("profile cases/profiles.toml --wheelset --lateral-shift \"90 mm\" --json");
    assert_eq!(far.status, Some(2), "{}", far.text);
    assert_eq!(sandbox.list("."), ["cases", "swapped.csv", "upside-down.csv", "words.csv"]);
}

/// The loop of the curve is stable at a friction of 0.1 and not at 0.3, at each speed as a point says it.
#[test]
fn stability_over_speed_and_friction() {
    let sandbox = Sandbox::new();
    let document = sandbox.json("stability cases/curve.toml --friction 0.3,0.1 --json");
    let points = document["points"].as_array().unwrap();
    let (low, high) = points.split_at(points.len() / 2);
    assert!(low.iter().all(|point| number(&point["friction"]) == 0.1 && point["unstable_roots"] == 0));
    assert!(high.iter().all(|point| number(&point["friction"]) == 0.3 && point["unstable_roots"] == 2));
    let last = &high[high.len() - 1];
    let speed = number(&last["speed_m_per_s"]);
    let point = sandbox
        .json(&format!("point cases/curve.toml --wavelength 0.08 --speed {speed} --set contact.friction=0.3 --json"));
    assert_eq!(point["stability"]["frequency_hz"], last["frequency_hz"]);
    assert_eq!(point["stability"]["growth_rate_per_s"], last["growth_rate_per_s"]);
    assert_eq!(document["branches"].as_array().unwrap().len(), 1);
    let outcome = sandbox.riffel("stability cases/curve.toml --friction 0.3");
    assert_eq!(outcome.status, Some(2));
    assert!(outcome.text.contains("two different values"), "{}", outcome.text);
}
