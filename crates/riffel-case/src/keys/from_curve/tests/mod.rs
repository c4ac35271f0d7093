mod under_load;

use std::path::Path;

use riffel_curving::WheelState;
use riffel_keys::CaseError;

use crate::Case;
use crate::ask;
use crate::curve::CurvingCase;
use crate::wheels_of_curve;

const CURVE: &str = include_str!("../../../../cases/metro-curve.toml");

fn case(overrides: &[&str]) -> Result<Case, CaseError> {
    let overrides: Vec<String> = overrides.iter().map(|&key| key.to_owned()).collect();
    Case::parse("curve.toml", CURVE, &overrides)
}

fn growth(case: &Case) -> f64 {
    case.point(0.06, 12.5).unwrap().growth_rate
}

/// Growth is that of the numbers of the curve typed by hand, on every wheel.
// Long: finds the equilibrium of a bogie in its curve for each of four wheels.
#[test]
fn numbers_are_those_of_the_curve() {
    let cases: [(usize, &str); 4] = [(1, "low"), (1, "high"), (2, "left"), (2, "right")];
    for (wheelset, rail) in cases {
        let from = format!("contact.from={{wheelset={wheelset}, rail=\"{rail}\"}}");
        let asked = case(&[&from, "wear.band_width=80 mm"]).unwrap();
        let curving = CurvingCase::parse("curve.toml", CURVE, &[]).unwrap();
        let vehicle = curving.vehicle_in_curve().unwrap();
        let state = &curving.equilibria(&vehicle).unwrap()[0];
        // To the right: the right rail is the low one.
        let index = 2 * (wheelset - 1) + usize::from(matches!(rail, "low" | "right"));
        let typed = |table: &str, wheel: &WheelState| {
            let creepages = wheel.creepages;
            vec![
                format!(
                    "{table}.creepage={{longitudinal={:e}, lateral={:e}, spin={:e}}}",
                    creepages.longitudinal, creepages.lateral, creepages.spin
                ),
                format!("{table}.contact_angle={:e} rad", wheel.contact_angle),
                format!("{table}.normal_load={:e}", wheel.normal_force),
                format!("{table}.longitudinal_radius={:e}", wheel.rolling_radius / wheel.contact_angle.cos()),
                format!("{table}.transverse_radius={:e}", wheel.lateral_curvature.unwrap().recip()),
            ]
        };
        let mut keys = typed("contact", &state.wheels[index]);
        keys.extend(typed("opposite_contact", &state.wheels[index ^ 1]));
        keys.push(format!("wheelset.rail={}", state.wheels[index].rail.name()));
        let without = CURVE
            .replace("from = { wheelset = 1, rail = \"low\" }\n", "")
            .replace("{ left = 0.4, right = 0.4 }", "0.4");
        // The high rail's first wheel has a patch wider than the band, which a contact that is given must not have.
        keys.push("wear.band_width=80 mm".to_owned());
        let by_hand = Case::parse("typed.toml", &without, &keys).unwrap();
        let (got, expected) = (growth(&asked), growth(&by_hand));
        assert!((got / expected - 1.0).abs() < 1e-9, "{got:e} {expected:e}");
    }
}

/// The wide patch on the high rail wears off its own width, and a remark says so.
// Long: computes all sensitivities of two cases in a curve, with an equilibrium for every value.
#[test]
fn a_patch_wider_than_the_band_is_told() {
    let high = "contact.from={wheelset=1, rail=\"high\"}";
    let own = case(&[high]).unwrap();
    // The curve of a lone wheel stands in another file.
    let place = tempfile::tempdir().unwrap();
    std::fs::write(place.path().join("curve.toml"), CURVE).unwrap();
    std::fs::write(place.path().join("metro.toml"), crate::METRO_CASE).unwrap();
    let keys = [
        "contact.from={curve=\"curve.toml\", wheelset=1, rail=\"high\"}",
        "contact.creep_law=fastsim",
        "wear.band_width=5 mm",
    ];
    let keys = keys.map(str::to_owned);
    let other = Case::read(&place.path().join("metro.toml"), &keys).unwrap();
    for case in [own, other] {
        let contact = &case.feedback.contacts()[0];
        assert_eq!(contact.wear.width(), 2.0 * case.hertz.semi_axis_lateral());
        let told = case.remarks.iter().any(|remark| remark.id() == "band-narrower-than-contact");
        assert!(told, "{:?}", case.remarks);
        ask::sensitivities(&case, 0.06, 12.5).unwrap();
    }
}

/// The place on the rail is where the upright profile, turned by the inclination, has the contact angle; its curvature goes where the
/// contact moves across the profiles, and what is written wins.
#[test]
fn the_place_on_the_rail_is_filled_in() {
    use riffel_curving::profile::NominalProfile;

    let moving = "contact.conformity={cross_slope=\"10 1/m\"}";
    let rail = NominalProfile::named("60E1").unwrap().profile();
    for (wheelset, side) in [(1, "low"), (1, "high"), (2, "left"), (2, "right")] {
        let from = format!("contact.from={{wheelset={wheelset}, rail=\"{side}\"}}");
        let case = case(&[&from, moving]).unwrap();
        let contact = &case.file.contact;
        let offset = contact.lateral_offset.unwrap().si();
        let is_left = matches!(side, "high" | "left");
        let outward = if is_left { -offset } else { offset };
        let there = rail.at(outward).unwrap();
        let angle = there.slope.atan() + (1.0f64 / 40.0).atan();
        // Rows of the table are interpolated.
        let off = angle - contact.contact_angle.unwrap().si();
        assert!(off.abs() < 2e-3, "{side}: {off:e}");
        let radius = contact.conformity.unwrap().rail_radius.si();
        assert!((radius + there.curvature.recip()).abs() < 1e-6, "{side}: {radius}");
        let opposite = case.file.opposite_contact.as_ref().unwrap();
        assert!(opposite.lateral_offset.is_some() && opposite.rail_radius.is_some());
    }
    let written = case(&["contact.lateral_offset=12 mm"]).unwrap();
    assert_eq!(written.file.contact.lateral_offset.unwrap().si(), 0.012);
    let told: Vec<String> = written.remarks.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|remark| remark.contains("contact.lateral_offset")), "{told:?}");
}

/// A curve to the left is its mirror image, with a wheelset and with a lone wheel.
#[test]
fn a_mirrored_curve_grows_alike() {
    const LONE: &str = "wheel.mass=600 kg";
    let (right, left) = ("curve.radius=180 m", "curve.radius=-180 m");
    let pair = [right, left].map(|radius| growth(&case(&[radius]).unwrap()));
    // The jump onto the flange is found to 1e-9 m, and wheels that hardly stick make more of that.
    assert!((pair[0] / pair[1] - 1.0).abs() < 1e-5, "{pair:?}");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let lone = |radius: &str| {
        let text = CURVE.replace("radius = \"180 m\"", radius);
        let place = tempfile::tempdir().unwrap();
        std::fs::write(place.path().join("curve.toml"), text).unwrap();
        let nominal = std::fs::read_to_string(folder.join("nominal.toml")).unwrap();
        std::fs::write(place.path().join("lone.toml"), nominal).unwrap();
        let keys =
            ["contact.from={curve=\"curve.toml\", wheelset=1, rail=\"high\"}", "contact.creep_law=fastsim", LONE];
        let case = Case::read(&place.path().join("lone.toml"), &keys.map(str::to_owned)).unwrap();
        // What is written wins: the nominal case has a load and a radius of its own.
        assert_eq!(case.file.contact.normal_load.si(), 50e3);
        growth(&case)
    };
    let pair = ["radius = \"180 m\"", "radius = \"-180 m\""].map(lone);
    assert!((pair[0] / pair[1] - 1.0).abs() < 1e-5, "{pair:?}");
}

/// A law without spin takes creepages alone, and says so of the rail that is looked at.
#[test]
fn spin_is_left_out_of_laws_that_know_none() {
    let case = case(&["contact.creep_law=full-sliding"]).unwrap();
    assert_eq!(case.file.contact.creepage.unwrap().components().spin, 0.0);
    let told = case.remarks.iter().map(ToString::to_string);
    assert!(told.filter(|remark| remark.contains("knows no spin")).count() == 1);
}

#[test]
fn what_is_written_wins() {
    let case = case(&[
        // Wide enough that the contact sticks without the spin.
        "curve.radius=900 m",
        "contact.normal_load=40 kN",
        "contact.creepage.spin=0",
        "contact.friction={left=0.2, right=0.3}",
    ])
    .unwrap();
    let contact = &case.file.contact;
    assert_eq!(contact.normal_load.si(), 40e3);
    let creepages = contact.creepage.unwrap().components();
    assert!(creepages.spin == 0.0 && creepages.lateral != 0.0);
    assert_eq!(contact.friction.si(), 0.3);
    let opposite = case.file.opposite_contact.as_ref().unwrap();
    assert_eq!(opposite.friction.unwrap().si(), 0.2);
    let told: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
    let own = "the case has its own contact.creepage.spin, contact.normal_load";
    assert!(told.iter().any(|remark| remark.contains(own)), "{told:?}");
}

/// On the high rail: the flange that is left out, and forces that are not those of the curve.
#[test]
fn what_the_loop_leaves_out_is_told() {
    let told = |keys: &[&str]| -> Vec<String> {
        let case = case(keys).unwrap();
        case.remarks.iter().map(ToString::to_string).collect()
    };
    let has = |told: &[String], words: &str| told.iter().any(|remark| remark.contains(words));
    let own = told(&["contact.from.rail=high"]);
    for words in ["with 8 % of its normal forces", "no profile has one curvature"] {
        assert!(has(&own, words), "{own:?}");
    }
    let forces = "at which the equilibrium of the curve has";
    assert!(!has(&own, forces), "{own:?}");
    // On a wheel that does not slide as a whole, a law without the spin that the curve has.
    let two_laws = told(&["contact.from.rail=high", "curve.radius=900 m", "contact.creep_law=polach"]);
    assert!(has(&two_laws, forces), "{two_laws:?}");
}

/// Of a vehicle that is balanced at seven speeds, with four wheels at each, the text is read once, and so it is where all wheels of a
/// curve are told.
#[test]
fn the_text_of_a_vehicle_is_read_once() {
    use riffel::roughness::ThirdOctave;

    use crate::Variant;
    use crate::keys::written_keys::READ;
    use crate::traffic::Traffic;

    let text = "[[vehicle]]\nname = \"metro\"\nshare = 1\ncurve = true\n\
        speed = { mean = \"45 km/h\", standard_deviation = \"2 km/h\" }\n";
    let traffic = Traffic::parse("traffic.toml", text).unwrap();
    let bands = [ThirdOctave::containing(0.05).unwrap()];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let read = pool.install(|| {
        let case = case(&[]).unwrap();
        READ.set(0);
        traffic.on(&case, &bands, &Variant::none("as it is"), &|_| ()).unwrap();
        let under_traffic = READ.replace(0);
        wheels_of_curve(&case).unwrap().unwrap();
        [under_traffic, READ.get()]
    });
    assert_eq!(read, [1, 1]);
}

/// Loads of a traffic are not those of the bogie.
#[test]
fn vehicles_of_a_traffic_have_no_loads_of_their_own() {
    use riffel::roughness::ThirdOctave;

    use crate::Variant;
    use crate::traffic::Traffic;

    let case = case(&[]).unwrap();
    for (key, taken) in [("axle_load = \"13 t\"", false), ("traction_share = 0.5", true)] {
        let text = format!("[[vehicle]]\nname = \"metro\"\nshare = 1\n{key}\nspeed = {{ mean = \"45 km/h\" }}\n");
        let traffic = Traffic::parse("traffic.toml", &text).unwrap();
        let bands = [ThirdOctave::containing(0.05).unwrap()];
        let growth = traffic.on(&case, &bands, &Variant::none("as it is"), &|_| ());
        assert_eq!(growth.is_ok(), taken, "{key}: {:?}", growth.err());
    }
}

#[test]
fn refused() {
    for row in [
        "contact.from={wheelset=3, rail=\"low\"} => must be 1, which leads, or 2",
        "contact.from={wheelset=1, rail=\"inner\"} => inner",
        "contact.from={rail=\"low\"} => wheelset",
        "contact.from.contact=flange => stands on one point",
        "wheelset.rail=left => is the right rail in a curve of 180 m",
        "contact.from.curve=bogie.toml => stand in this one",
        "contact.from.patch=elastic => elastic",
        "curve.radius=1 m => larger than the wheelbase",
        "profiles.wheel=no-such.csv => no-such.csv",
    ] {
        let (key, words) = row.split_once(" => ").unwrap();
        let Err(error) = case(&[key]) else {
            panic!("{key} was taken");
        };
        assert!(error.to_string().contains(words), "{error}");
    }
}

/// A case that somebody has sent opens no file, be it of the curve or of its profiles.
#[test]
fn sealed_cases_open_nothing() {
    assert!(Case::parse_sealed("sent.toml", CURVE).is_ok());
    let file = CURVE.replace("wheelset = 1,", "curve = \"/etc/hostname\", wheelset = 1,");
    let profile = CURVE.replace("\"S1002\"", "\"/etc/hostname\"");
    for (text, key) in [(file, "contact.from.curve"), (profile, "profiles.wheel")] {
        let Err(error) = Case::parse_sealed("sent.toml", &text) else {
            panic!("{key} was taken");
        };
        assert!(error.to_string().contains(key), "{error}");
        assert!(error.to_string().contains("may not name any"), "{error}");
    }
}

/// Wheels of two profiles: the one that is named twice is one that is named once, and a wheelset with its wheels changed over runs
/// on the other side of the track.
#[test]
fn each_wheel_has_its_profile() {
    let case = |wheels: &str| {
        let text = format!("[wheel]\nrolling_radius = \"460 mm\"\n[profiles]\n{wheels}\nrail = \"60E1\"\n");
        CurvingCase::parse("profiles.toml", &text, &[])
    };
    let radii = |wheels: &str, shift: f64| {
        let wheelset = case(wheels).unwrap().wheelset_on_track().unwrap();
        let contacts = wheelset.contact(shift, 0.0).unwrap().contacts;
        contacts.map(|contact| contact.rolling_radius)
    };
    let one = "wheel = \"S1002\"";
    let twice = "wheel = \"S1002\"\nleft_wheel = \"S1002\"";
    assert_eq!(radii(one, 2e-3), radii(twice, 2e-3));
    let mixed = "wheel = \"S1002\"\nleft_wheel = \"cone-1:40\"";
    let changed_over = "wheel = \"cone-1:40\"\nleft_wheel = \"S1002\"";
    for shift in [-3e-3, 0.0, 2e-3] {
        let [left, right] = radii(mixed, shift);
        let [other_left, other_right] = radii(changed_over, -shift);
        // The iteration of the roll leaves a micrometre.
        assert!((left - other_right).abs() < 1e-6 && (right - other_left).abs() < 1e-6);
    }
    assert!((radii(mixed, 3e-3)[1] - radii(one, 3e-3)[1]).abs() < 1e-4);
    let refused = |wheels: &str| {
        let case = case(wheels).unwrap();
        case.wheelset_on_track().map(|_| ()).unwrap_err().to_string()
    };
    for left in ["60E1", "no-such-file.csv", "cone"] {
        let message = refused(&format!("{one}\nleft_wheel = \"{left}\""));
        assert!(message.contains("profiles.left_wheel"), "{left}: {message}");
    }
}
