//! Contacts under load.

use riffel::{HertzContact, Rail};
use riffel_curving::profile::ContactSurface;

use super::{CURVE, case, growth};
use crate::Case;
use crate::curve::CurvingCase;

/// Two circles by a smooth rail of 80 mm and wheels of several radii: under load they come to Hertz, on the slope of the head too.
#[test]
fn circles_under_load_are_those_of_hertz() {
    let folder = tempfile::tempdir().unwrap();
    let points = |name: &str, height: &dyn Fn(f64) -> f64, ends: [f64; 2]| {
        let rows = (0..=600).map(|index| {
            let x = ends[0] + (ends[1] - ends[0]) * f64::from(index) / 600.0;
            format!("{x:.9},{:.9}\n", height(x))
        });
        let text = "x_mm,y_mm\n".to_owned() + &rows.collect::<String>();
        std::fs::write(folder.path().join(name), text).unwrap();
    };
    const RAIL: f64 = 80.0;
    points("rail.csv", &|x| (RAIL * RAIL - x * x).sqrt() - RAIL, [-60.0, 60.0]);
    // A hollow wheel, a cylinder and a rounded one, by their curvatures.
    for (curvature, inclined) in [(1.0 / 240.0, 0.0), (1e-12, 0.0), (-1.0 / 160.0, 0.05)] {
        let wheel = |x: f64| {
            let under = 1.0 - (curvature * x).powi(2);
            // A flange of a wave, for a wheelset has one.
            let inside = (-40.0 - x).max(0.0) / 30.0;
            let flange = 14.0 * (1.0 - (std::f64::consts::PI * inside).cos());
            inclined * x - curvature * x * x / (1.0 + under.sqrt()) - flange
        };
        points("wheel.csv", &wheel, [-70.0, 40.0]);
        let text = "[wheel]\nrolling_radius = \"460 mm\"\n[profiles]\nwheel = \"wheel.csv\"\nrail = \"rail.csv\"\n\
                    gauge = \"1435 mm\"\ninclination = \"none\"\n";
        let path = folder.path().join("profiles.toml");
        std::fs::write(&path, text).unwrap();
        let case = CurvingCase::read(&path, &[]).unwrap();
        let on = case.wheelset_on_track().unwrap().contact(0.0, 0.0).unwrap().contacts[1];
        let patch = case.loaded_patch(Rail::Right, 0.0, on.contact_angle, 60e3, ContactSurface::Flat);
        let patch = patch.unwrap().unwrap();
        let across = (on.rail_curvature - on.wheel_curvature).recip();
        let along = on.rolling_radius / on.contact_angle.cos();
        let hertz = HertzContact::exact(case.steel().unwrap(), 0.46, across, 60e3)
            .and_then(|hertz| hertz.with_longitudinal_radius(along))
            .unwrap();
        let axes = [hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral()];
        let off = |value: f64, exact: f64| value / exact - 1.0;
        let stiffness = off(patch.stiffness, hertz.stiffness());
        let [a, b] = [0, 1].map(|axis| off(patch.semi_axes[axis], axes[axis]));
        println!("{:.1} mm by {:.1} mm: {stiffness:.4} {a:.4} {b:.4}", 1e3 * axes[0], 1e3 * axes[1]);
        // Of the grid: the stiffness to 3e-3 of a finer one; the area is that of whole elements, a root of which is an axis.
        assert!(stiffness.abs() < 1e-2, "{stiffness}");
        assert!(a.abs() < 0.03 && b.abs() < 0.03, "{a} {b}");
        // Symmetric about the touch: the plane stays, but for what a circle is more than a parabola.
        assert!((patch.contact_angle - on.contact_angle).abs() < 1e-3);
    }
}

/// With the patch of the profiles the loop has the stiffness, the axes, the angle and the spin of the contact under load, on both rails.
#[test]
fn a_patch_under_load_enters_the_loop() {
    const ASK: &str = "contact.from.patch=non-elliptic";
    let curving = CurvingCase::parse("curve.toml", CURVE, &[]).unwrap();
    let vehicle = curving.vehicle_in_curve().unwrap();
    let state = &curving.equilibria(&vehicle).unwrap()[0];
    let [hertz, case] = [&[][..], &[ASK][..]].map(|keys| {
        let wheel2 = ["contact.from.wheelset=2", "contact.from.rail=low"];
        case(&[keys, &wheel2].concat()).unwrap()
    });
    let wheel = state.wheels.iter().find(|wheel| (wheel.wheelset, wheel.rail) == (2, Rail::Right));
    let wheel = wheel.unwrap();
    let shift = state.wheelsets[1].lateral_shift;
    let patch = curving.loaded_patch(Rail::Right, shift, wheel.contact_angle, wheel.normal_force, ContactSurface::Flat);
    let patch = patch.unwrap().unwrap();
    assert!((case.hertz.stiffness() / patch.stiffness - 1.0).abs() < 1e-12);
    assert!((case.feedback.contacts()[0].stiffness / patch.stiffness - 1.0).abs() < 1e-12);
    assert!((case.hertz.semi_axis_longitudinal() / patch.semi_axes[0] - 1.0).abs() < 1e-12);
    assert!((case.hertz.semi_axis_lateral() / patch.semi_axes[1] - 1.0).abs() < 1e-12);
    let angle = case.file.contact.contact_angle.unwrap().si();
    assert!((angle - patch.contact_angle).abs() < 1e-12);
    // The turn of the wheel about another normal: φ + sin γ/r stays on the right rail.
    let of_turn = |case: &Case| {
        let contact = &case.file.contact;
        let angle = contact.contact_angle.unwrap().si();
        contact.creepage.unwrap().components().spin + angle.sin() / wheel.rolling_radius
    };
    assert!((of_turn(&case) - of_turn(&hertz)).abs() < 1e-12);
    let other = case.file.opposite_contact.as_ref().unwrap();
    assert!(other.stiffness.is_some() && hertz.file.opposite_contact.as_ref().unwrap().stiffness.is_none());
    let told: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
    let count = told.iter().filter(|remark| remark.contains("profiles under load"));
    // The other rail has no waves.
    assert_eq!(count.count(), 1, "{told:?}");
    // On the flange root the wheel stands on two points.
    let high = self::case(&[ASK, "contact.from.rail=high"]).unwrap();
    let told: Vec<String> = high.remarks.iter().map(ToString::to_string).collect();
    assert!(
        told.iter()
            .any(|remark| { remark.contains("no patch of the profiles under load: the wheel stands on two points") })
    );
}

/// What is written wins over the patch as over all else.
#[test]
fn a_written_stiffness_wins_over_the_patch() {
    let keys = ["contact.from.patch=non-elliptic", "contact.stiffness=900 MN/m"];
    let case = case(&keys).unwrap();
    assert!((case.hertz.stiffness() / 900e6 - 1.0).abs() < 1e-12);
    let told: Vec<String> = case.remarks.iter().map(ToString::to_string).collect();
    let own = "the case has its own contact.stiffness";
    assert!(told.iter().any(|remark| remark.contains(own)), "{told:?}");
}

/// Each effect of a moving contact is a part of the loop of its own; with none of them it grows as a contact that stays.
#[test]
fn effects_of_a_moving_contact_are_chosen_one_by_one() {
    const MOVING: &str = "contact.conformity={cross_slope=\"10 1/m\"}";
    const KEYS: [&str; 4] = ["rolling_radius", "contact_angle", "spin", "rail_roll"];
    // A rail that twists, of dimensions as 60E1 has them.
    const TWIST: [&str; 5] = [
        "rail.torsion_constant=2.21e-6 m4",
        "rail.polar_second_moment=3.55e-5 m4",
        "rail.head_height=95 mm",
        "rail.foot_depth=45 mm",
        "rail.foot_width=150 mm",
    ];
    const TRAILING: &str = "contact.from.wheelset=2";
    // The trailing wheel, which stands where the profiles are close and the plane is inclined.
    let on = |off: &[&str]| {
        let off = off.iter().map(|key| format!("contact.conformity.{key}=false"));
        let mut keys: Vec<String> = [MOVING, TRAILING].iter().chain(&TWIST).map(ToString::to_string).collect();
        keys.extend(off);
        let keys: Vec<&str> = keys.iter().map(String::as_str).collect();
        growth(&case(&keys).unwrap())
    };
    let all = on(&[]);
    for key in KEYS {
        let without = on(&[key]);
        println!("without {key}: {without:e}, with all {all:e}");
        assert!((without / all - 1.0).abs() > 1e-6, "{key}");
    }
    let stays: Vec<&str> = [TRAILING].into_iter().chain(TWIST).collect();
    let stays = growth(&case(&stays).unwrap());
    println!("stays {stays:e}");
    assert!((on(&KEYS) / stays - 1.0).abs() < 1e-9);
}

/// Where the patch is wide beside the radius of the rail, a note says how far Hertz is off the profiles under load.
#[test]
fn a_conformal_contact_is_told() {
    let told = |keys: &[&str]| {
        let remarks = case(keys).unwrap().remarks;
        let remarks: Vec<String> = remarks.iter().map(ToString::to_string).collect();
        remarks.into_iter().find(|remark| remark.contains("Hertz's theory is for patches"))
    };
    let high = told(&["contact.from.rail=high"]).unwrap();
    assert!(high.contains("of the radius of the left rail"), "{high}");
    // Beside the jump to the flange root the wheel stands on one point, and its patch goes on to the other.
    let wide = ["contact.from.rail=high", "curve.radius=300 m", "contact.from.patch=non-elliptic"];
    let remarks = case(&wide).unwrap().remarks;
    let joins = remarks.iter().any(|remark| remark.to_string().contains("joins that of the place"));
    assert!(joins, "{remarks:?}");
    assert!(told(&[]).is_none_or(|remark| !remark.contains("of the right rail")));
}
