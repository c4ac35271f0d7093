//! Profiles and contact of wheelsets.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use riffel::Rail;

use super::*;
use crate::{RunningSurfaces, TwoPoints};

fn nominal(name: &str) -> Profile {
    NominalProfile::named(name).unwrap().profile()
}

fn wheelset(rail: &str, inclination: f64) -> WheelsetOnTrack {
    of_wheel("S1002", rail, inclination)
}

fn of_wheel(wheel: &str, rail: &str, inclination: f64) -> WheelsetOnTrack {
    let (wheel, rail) = (nominal(wheel), nominal(rail));
    WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [0.46, 0.46], 1.36, -0.07).unwrap(),
        track: Track::new([&rail, &rail], 1.435, 0.014, inclination).unwrap(),
    }
}

/// Points of an arc: a spline through them has its heights, slopes and curvatures.
#[test]
fn a_spline_through_an_arc_is_the_arc() {
    let radius = 0.3;
    let points: Vec<[f64; 2]> = (-60..=60)
        .map(|index| {
            let angle = 1e-3 * f64::from(index);
            [radius * angle.sin(), radius * (angle.cos() - 1.0)]
        })
        .collect();
    let profile = Profile::through(&points).unwrap();
    let mut reversed = points.clone();
    reversed.reverse();
    assert_eq!(Profile::through(&reversed).unwrap(), profile);
    for angle in [-0.0311_f64, 0.0, 0.0257] {
        let point = profile.at(radius * angle.sin()).unwrap();
        assert!((point.height - radius * (angle.cos() - 1.0)).abs() < 1e-12);
        assert!((point.slope + angle.tan()).abs() < 1e-8);
        assert_relative_eq!(point.curvature, -1.0 / radius, max_relative = 1e-4);
    }
    assert!(profile.at(0.02).is_none());
}

#[test]
fn loops_and_wrong_orders_are_refused_with_their_point() {
    let mut points: Vec<[f64; 2]> = (0..40).map(|index| [1e-3 * f64::from(index), 0.0]).collect();
    points.swap(17, 23);
    let error = Profile::through(&points).unwrap_err();
    assert!(matches!(error, ProfileError::Point { index: 15..=24, .. }), "{error:?}");
    points[5] = points[4];
    let error = Profile::through(&points).unwrap_err();
    assert!(matches!(error, ProfileError::Point { index: 5, .. }), "{error:?}");
    assert!(Profile::through(&points[..4]).is_err());
}

/// A second pass beside the first is refused; the underside of a head, which lies below, is cut.
#[test]
fn only_what_hangs_over_is_cut() {
    let pass = |height: f64, back: bool| {
        let places = (0..=40).map(move |place| if back { 40 - place } else { place });
        places.map(move |place| {
            let x = 1e-3 * f64::from(place);
            [x, height - 2.0 * (x - 0.02) * (x - 0.02)]
        })
    };
    let both = |height: f64| pass(0.0, false).chain(pass(height, true)).collect::<Vec<_>>();
    let error = Profile::through(&both(5e-5)).unwrap_err();
    assert!(error.to_string().contains("closes"), "{error}");
    let with_underside: Vec<[f64; 2]> = pass(0.0, false).chain(pass(-0.03, true).take(20)).collect();
    let head = Profile::through(&with_underside).unwrap();
    assert!(head.range()[1] > 0.0399 && head.at(0.02).unwrap().height.abs() < 1e-9);
    let above: Vec<[f64; 2]> = pass(0.0, false).chain(pass(0.03, true).take(20)).collect();
    let error = Profile::through(&above).unwrap_err();
    assert!(error.to_string().contains("above itself"), "{error}");
}

/// Half widths at the gauge point as EN 13674-1 prints them, and crowns in the origin.
#[test]
fn nominal_rails_have_their_widths() {
    for (name, width, depth) in [("60E1", 72.0, 14.3), ("60E2", 72.0, 14.3), ("54E1", 70.0, 14.1)] {
        let rail = nominal(name);
        let inner = rail.inner_face(-1e-3 * depth).unwrap();
        assert!((inner + 0.5e-3 * width).abs() < 1e-6, "{name}: {inner}");
        assert!(rail.crown().x.abs() < 1e-9 && rail.crown().height.abs() < 1e-12);
    }
    // Flange of S1002: 28 mm high.
    let lowest = nominal("S1002").sampled(1e-4).iter().fold(0.0, |least: f64, point| least.min(point.height));
    assert!((lowest + 0.028).abs() < 1e-6, "{lowest}");
}

/// The mirrored wheelset is the wheelset, and yaw to either side is alike.
#[test]
fn contact_is_symmetric() {
    let wheelset = wheelset("60E1", 0.025);
    for (shift, yaw) in [(1.3e-3, 0.0), (4.2e-3, 0.006), (7e-3, 0.012)] {
        let (one, other) = (wheelset.contact(shift, yaw).unwrap(), wheelset.contact(-shift, -yaw).unwrap());
        assert_relative_eq!(one.roll, -other.roll, max_relative = 1e-9);
        assert_relative_eq!(one.centre_z, other.centre_z, max_relative = 1e-9);
        assert!((one.contacts[0].x_wheel - other.contacts[1].x_wheel).abs() < 1e-9);
    }
}

/// Wheels and rails that cannot be are refused with the reason.
#[test]
fn wheels_and_rails_that_do_not_fit_are_refused() {
    let (wheel, rail) = (nominal("S1002"), nominal("60E1"));
    let mirrored: Vec<[f64; 2]> = wheel.sampled(5e-4).iter().map(|point| [-point.x, point.height]).collect();
    let mirrored = Profile::through(&mirrored).unwrap();
    let error = Wheels::new([&mirrored, &wheel], [0.46; 2], 1.36, -0.07).err().unwrap();
    assert!(error.to_string().contains("mirrored"), "{error}");
    let error = Track::new([&rail, &rail], -0.01, 0.014, 0.025).err().unwrap();
    assert!(error.to_string().contains("overlap"), "{error}");
    let error = Track::new([&rail, &rail], 1.435, 0.05, 0.025).err().unwrap();
    assert!(error.to_string().contains("gauge height"), "{error}");
    let narrow = WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [0.46; 2], 1.1, -0.07).unwrap(),
        track: Track::new([&rail, &rail], 1.435, 0.014, 0.025).unwrap(),
    };
    assert!(matches!(narrow.contact(0.0, 0.0), Err(ProfileError::NoContact { .. })));
}

/// On a cone the three rules give its conicity, at any amplitude.
#[test]
fn a_cone_has_its_conicity() {
    for (conicity, amplitude) in [(0.05, 1e-3), (0.3, 7e-3)] {
        let found = EquivalentConicity::at(|y| 2.0 * conicity * y, ENDS, amplitude, 1.5, 0.46).unwrap();
        assert_relative_eq!(found.klingel, conicity, max_relative = 1e-6);
        assert_relative_eq!(found.harmonic, conicity, max_relative = 1e-6);
        assert_relative_eq!(found.regression, conicity, max_relative = 1e-6);
    }
    assert!(EquivalentConicity::at(|y| -0.1 * y, ENDS, 3e-3, 1.5, 0.46).is_none());
    let nought = EquivalentConicity::at(|_| 1e-12, ENDS, 3e-3, 1.5, 0.46).unwrap();
    assert_eq!((nought.klingel, nought.wavelength), (0.0, f64::INFINITY));
}

/// Wheels of unequal diameter run about another middle, d/2γ to the side, with the conicity of their cone; where that lies too
/// far out for the amplitude there is no motion.
#[test]
fn unequal_wheels_have_the_conicity_of_their_cone() {
    let at = |unequal: f64, amplitude: f64| EquivalentConicity::at(|y| 0.2 * y + unequal, ENDS, amplitude, 1.5, 0.46);
    for unequal in [-1e-3, 0.4e-3, 1.6e-3] {
        let found = at(unequal, 3e-3).unwrap();
        for conicity in [found.klingel, found.harmonic, found.regression] {
            assert_relative_eq!(conicity, 0.1, max_relative = 1e-6);
        }
    }
    assert!(at(1.6e-3, 5e-3).is_none());
}

/// Wheels of two profiles: Δr = 2γy to the left and a step higher, s + 2δy, to the right of the middle of the track. The way runs to
/// γa² = sb + δb², and the wave is that of two springs: √(e r₀/2γ) π on the left, √(e r₀/2δ)(π − 2 asin(c/(b + c))), c = s/2δ, on
/// the right.
#[test]
fn a_step_of_the_radius_difference_is_no_end_of_motion() {
    let (gentle, steep, step, scale) = (0.02, 0.1, 0.5e-3, 1.5 * 0.46);
    let difference = |y: f64| match y < 0.0 {
        true => 2.0 * gentle * y,
        false => step + 2.0 * steep * y,
    };
    for amplitude in [0.5e-3, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3] {
        // (δ − γ)b² + (s + 4γA)b = 4γA².
        let (a, b, c) = (steep - gentle, step + 4.0 * gentle * amplitude, -4.0 * gentle * amplitude * amplitude);
        let right = (-b + (b * b - 4.0 * a * c).sqrt()) / (2.0 * a);
        let offset = step / (2.0 * steep);
        let wave = |slope: f64, angle: f64| (scale / (2.0 * slope)).sqrt() * angle;
        let expected = wave(gentle, PI) + wave(steep, PI - 2.0 * (offset / (right + offset)).asin());
        let found = EquivalentConicity::at(difference, [-12e-3, 12e-3], amplitude, 1.5, 0.46);
        // The step falls inside a piece of the rule.
        assert_relative_eq!(found.unwrap().wavelength, expected, max_relative = 2e-3);
    }
}

/// Ends of the lateral shift \[m\].
const ENDS: [f64; 2] = [-12e-3, 12e-3];

/// A level axle and one that rolls have one rolling radius difference but on flanks. On cones, which
/// touch their rails at one place of the head, a level axle's is 2 tan γ times its shift.
#[test]
fn a_level_axle_has_the_conicity_of_the_standard() {
    let wheelset = wheelset("60E1", 0.025);
    let of = |table: Result<RadiusDifference, ProfileError>, amplitude: f64| {
        let conicity = table.unwrap().equivalent_conicity(amplitude, 1.5);
        conicity.unwrap().klingel
    };
    let level = || RadiusDifference::level(&wheelset, 0.46, 12e-3, 1e-4);
    let rolling = || RadiusDifference::rolling(&wheelset, 0.46, 12e-3, 1e-4);
    let (one, other) = (of(level(), 3e-3), of(rolling(), 3e-3));
    assert!((one / other - 1.0).abs() < 0.02, "{one} {other}");
    let cones = of_wheel("cone-1:40", "60E1", 0.025);
    let table = RadiusDifference::level(&cones, 0.46, 4e-3, 1e-4).unwrap();
    assert_relative_eq!(table.at(2e-3), 2.0 * 2e-3 / 40.0, max_relative = 1e-6);
}

/// The cone of 1:40 has its slope and a continuous tangent from the flange of S1002 to the field side.
#[test]
fn the_nominal_cone_is_smooth() {
    let (cone, wheel) = (nominal("cone-1:40"), nominal("S1002"));
    assert_relative_eq!(cone.at(0.03).unwrap().height, 0.03 / 40.0, max_relative = 1e-9);
    assert_eq!(cone.at(-0.05).unwrap().height, wheel.at(-0.05).unwrap().height);
    let points = cone.along(1e-4);
    for pair in points.windows(2) {
        let turn = pair[1].slope.atan() - pair[0].slope.atan();
        // At most 0.1 mm on an arc of 12 mm.
        assert!(turn.abs() < 0.0085, "{turn} at {}", pair[0].x);
    }
}

/// Dimensions of S1002 as EN 13715 names it: 28 mm high, 32.5 mm thick; qR from its arcs by hand, 10.794 mm.
#[test]
fn dimensions_of_a_wheel() {
    let wheel = nominal("S1002");
    let found = WheelDimensions::new(&wheel, -0.07).unwrap();
    assert!((found.flange_height.unwrap() - 0.028).abs() < 1e-6, "{found:?}");
    assert!((found.flange_thickness.unwrap() - 0.0325).abs() < 1e-6, "{found:?}");
    assert!((found.flange_gradient.unwrap() - 0.010794).abs() < 1e-6, "{found:?}");
    let rail = nominal("60E1");
    assert!(WheelDimensions::new(&rail, -0.07).is_err());
    // Without the points of 8 mm around the tip, the flank 10 mm beyond the datum circle, and the circle itself.
    for (middle, told) in [
        ([-0.055, -0.028], [false, true, false]),
        ([-0.0375, -0.010], [true, false, false]),
        ([0.0, 0.0], [false, false, false]),
    ] {
        let points = wheel.along(2.5e-4).into_iter();
        let points = points.map(|point| [point.x, point.height]);
        let kept = points.filter(|[x, height]| (x - middle[0]).hypot(height - middle[1]) > 4e-3);
        let wheel = Profile::through(&kept.collect::<Vec<_>>()).unwrap();
        let found = WheelDimensions::new(&wheel, -0.07).unwrap();
        let found = [found.flange_height, found.flange_thickness, found.flange_gradient];
        assert_eq!(found.map(|value| value.is_some()), told, "{middle:?}");
    }
}

/// A tread turned down by 2 mm, a rail ground by 1 mm and one worn by 3 mm at its gauge face.
#[test]
fn what_is_cut_off_is_found() {
    let cut = |profile: &Profile, keep: &dyn Fn(&ProfilePoint) -> [f64; 2]| {
        let points: Vec<[f64; 2]> = profile.along(2e-4).iter().map(keep).collect();
        Profile::through(&points).unwrap()
    };
    // A hollow 40 mm wide and 2 mm deep, sin², in the tread of a wheel that lies 5 mm too low.
    let wheel = nominal("S1002");
    let hollow = |x: f64| {
        let share = (x + 0.02) / 0.04;
        match (0.0..=1.0).contains(&share) {
            true => 2e-3 * (PI * share).sin().powi(2),
            false => 0.0,
        }
    };
    let worn = cut(&wheel, &|point| [point.x, point.height + hollow(point.x) - 5e-3]);
    let wear = ProfileWear::new(&worn, &wheel, true, ProfileAlignment::Flange).unwrap();
    assert!((wear.shift[1] - 5e-3).abs() < 1e-7, "{:?}", wear.shift);
    // Depth across a slope of 1:40 is that upward to 3e-4; the area is ∫ of the hollow, half its width times its depth.
    let (place, depth) = wear.deepest().unwrap();
    assert!((depth - 2e-3).abs() < 2e-6 && place.x.abs() < 1e-3, "{depth} {place:?}");
    assert_relative_eq!(wear.area, 40e-6, max_relative = 1e-4);
    let dimensions = WheelDimensions::new(&wear.measured, -0.07).unwrap();
    assert_relative_eq!(dimensions.flange_height.unwrap(), 0.030, max_relative = 1e-4);
    // A head ground flat by a millimetre at its crown, displaced by (3, −4) mm: what is left has its field side.
    let rail = nominal("60E1");
    let ground = cut(&rail, &|point| [point.x + 3e-3, point.height.min(-1e-3) - 4e-3]);
    let wear = ProfileWear::new(&ground, &rail, false, ProfileAlignment::FieldSide).unwrap();
    assert!((wear.shift[0] + 3e-3).abs() < 2e-6 && (wear.shift[1] - 4e-3).abs() < 2e-6, "{:?}", wear.shift);
    assert!(wear.misfit.unwrap() < 1e-6, "{:?}", wear.misfit);
    let found = RailWear::new(&wear, &rail, 0.014);
    assert_relative_eq!(found.vertical.unwrap(), 1e-3, max_relative = 3e-3);
    assert!(found.lateral.unwrap().abs() < 3e-6 && found.diagonal.unwrap().abs() < 3e-6, "{found:?}");
    // The segment between the crown and the chord 1 mm below it.
    let segment: f64 = rail
        .sampled(1e-5)
        .windows(2)
        .map(|pair| 1e-3 + pair[0].height.clamp(-1e-3, 0.0))
        .filter(|depth| *depth > 0.0)
        .map(|depth| depth * 1e-5)
        .sum();
    assert_relative_eq!(wear.area, segment, max_relative = 2e-3);
    // The whole rail moved outward by 3 mm: W2 is that, and where the corner is an arc W3 is R − √(R² − s²) + s, s = 3 mm cos 45°,
    // along the radius from the corner's point to the displaced arc.
    let aside = rail.moved([3e-3, 0.0]);
    let wear = ProfileWear::new(&aside, &rail, false, ProfileAlignment::AsWritten).unwrap();
    let found = RailWear::new(&wear, &rail, 0.014);
    assert_relative_eq!(found.lateral.unwrap(), 3e-3, max_relative = 1e-9);
    let along = 3e-3 * std::f64::consts::FRAC_1_SQRT_2;
    let exact = 0.013 + along - (0.013f64.powi(2) - along * along).sqrt();
    // The point of the corner is within 0.6° of 45°.
    assert_relative_eq!(found.diagonal.unwrap(), exact, max_relative = 1e-2);
}

/// The rigid geometry at the level of the rails is that of the axle, and goes on where the axle turns back.
#[test]
fn a_large_wheelset_rolls_back_on_its_flange() {
    let (wheel, rail) = (nominal("S1002"), nominal("60E1"));
    let radius = 0.6;
    let wheelset = WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [radius, radius], 1.36, -0.07).unwrap(),
        track: Track::new([&rail, &rail], 1.435, 0.014, 0.025).unwrap(),
    };
    for shift in [-4e-3, 1.3e-3, 5.9e-3] {
        let at_rail = wheelset.contact_at_rail_level(shift, 4e-3).unwrap();
        let axle = wheelset.contact(at_rail.lateral_shift, 4e-3).unwrap();
        // Rolls to 1e-15 over the spacing.
        assert!((at_rail.roll - axle.roll).abs() < 1e-13);
        assert!((at_rail.lateral_shift - shift - radius * at_rail.roll.sin()).abs() < 1e-15);
        assert!((at_rail.contacts[1].x_wheel - axle.contacts[1].x_wheel).abs() < 1e-8);
    }
    // r tan γ/2s = 0.6 · 2.75/1.5 > 1: up the flange the axle turns back.
    let climbing = [7.2e-3, 7.6e-3].map(|shift| wheelset.contact_at_rail_level(shift, 0.0).unwrap());
    let [low, high] = climbing;
    assert!(low.contacts[1].contact_angle > 1.2 && high.contacts[1].contact_angle > 1.2);
    assert!(high.contacts[1].rolling_radius > low.contacts[1].rolling_radius + 0.5e-3);
    assert!(high.lateral_shift < low.lateral_shift - 1e-5);
}

/// A yawed flange meets its rail ahead of the axle: of a flat flank with tan γ at the height z the shift falls by about
/// r ψ² tan γ/2.
#[test]
fn yaw_takes_play_from_the_flange() {
    let wheelset = wheelset("60E1", 0.025);
    let play = |yaw: f64| wheelset.flange_shift(Rail::Right, yaw).unwrap();
    assert!((play(0.0) - wheelset.flange_shift(Rail::Left, 0.0).unwrap()).abs() < 2e-6);
    // 6.26 mm of the axle, which has rolled back by 0.3 mm there.
    assert!((play(0.0) - 6.57e-3).abs() < 0.05e-3, "{}", play(0.0));
    assert!((play(0.03) - play(-0.03)).abs() < 2e-6);
    let fall = |yaw: f64| play(0.0) - play(yaw);
    let parabola = 0.5 * 0.46 * 2.75 * 0.03_f64.powi(2);
    assert!(fall(0.03) > 0.5 * parabola && fall(0.03) < parabola, "{}", fall(0.03));
}

/// Between its rows and beside its jumps a table is the geometry itself.
#[test]
fn a_rolling_table_is_the_geometry_between_its_rows() {
    let wheelset = wheelset("60E1", 0.025);
    let table = RollingTable::new(&wheelset, [0.46, 0.46], 0.008, 1e-4).unwrap();
    let jumps = table.two_points();
    assert!(jumps.len() >= 2);
    let mirrored =
        |jump: &TwoPoints| jumps.iter().any(|other| other.rail != jump.rail && (other.shift + jump.shift).abs() < 1e-8);
    assert!(jumps.iter().all(mirrored));
    let beside = |shift: f64| jumps.iter().map(|jump| (jump.shift - shift).abs()).fold(f64::INFINITY, f64::min);
    let mut bridged = 0;
    for index in -790..790 {
        let shift = 1e-5 * f64::from(index) + 3e-6;
        if beside(shift) < 1e-7 {
            continue;
        }
        let exact = wheelset.contact_at_rail_level(shift, 0.0).unwrap();
        assert!((table.axle_shift(shift).unwrap() - exact.lateral_shift).abs() < 2e-7);
        for rail in Rail::BOTH {
            let there = table.position(rail, shift).unwrap();
            let on = &exact.contacts[usize::from(rail == Rail::Right)];
            let radius = there.radius_change + 0.46 - on.rolling_radius;
            let angle = there.contact_angle - on.contact_angle;
            // A cubic over 0.1 mm on the fillet of a flange, of 13 mm.
            if radius.abs() > 1e-5 || angle.abs() > 1e-3 {
                bridged += 1;
            }
        }
    }
    // On the flange at 6.597 mm the contact moves by 0.65 mm on the wheel: such jumps are bridged.
    assert!(bridged <= 4, "{bridged}");
    assert!(table.position(Rail::Left, 0.009).is_none() && table.axle_shift(-0.009).is_none());
}
