//! Profiles and contact of wheelsets.

use approx::assert_relative_eq;

use super::*;

fn nominal(name: &str) -> Profile {
    NominalProfile::named(name).unwrap().profile()
}

fn wheelset(rail: &str, inclination: f64) -> WheelsetOnTrack {
    let (wheel, rail) = (nominal("S1002"), nominal(rail));
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
    let mut points: Vec<[f64; 2]> = (0..40)
        .map(|index| [1e-3 * f64::from(index), 0.0])
        .collect();
    points.swap(17, 23);
    let error = Profile::through(&points).unwrap_err();
    assert!(
        matches!(error, ProfileError::Point { index: 15..=24, .. }),
        "{error:?}"
    );
    points[5] = points[4];
    let error = Profile::through(&points).unwrap_err();
    assert!(
        matches!(error, ProfileError::Point { index: 5, .. }),
        "{error:?}"
    );
    assert!(Profile::through(&points[..4]).is_err());
}

/// Half widths at the gauge point as EN 13674-1 prints them, and crowns in the origin.
#[test]
fn nominal_rails_have_their_widths() {
    for (name, width, depth) in [
        ("60E1", 72.0, 14.3),
        ("60E2", 72.0, 14.3),
        ("54E1", 70.0, 14.1),
    ] {
        let rail = nominal(name);
        let inner = rail.inner_face(-1e-3 * depth).unwrap();
        assert!((inner + 0.5e-3 * width).abs() < 1e-6, "{name}: {inner}");
        assert!(rail.crown().x.abs() < 1e-9 && rail.crown().height.abs() < 1e-12);
    }
    // Flange of S1002: 28 mm high.
    let lowest = nominal("S1002")
        .sampled(1e-4)
        .iter()
        .fold(0.0, |least: f64, point| least.min(point.height));
    assert!((lowest + 0.028).abs() < 1e-6, "{lowest}");
}

/// The mirrored wheelset is the wheelset, and yaw to either side is alike.
#[test]
fn contact_is_symmetric() {
    let wheelset = wheelset("60E1", 0.025);
    for (shift, yaw) in [(1.3e-3, 0.0), (4.2e-3, 0.006), (7e-3, 0.012)] {
        let (one, other) = (
            wheelset.contact(shift, yaw).unwrap(),
            wheelset.contact(-shift, -yaw).unwrap(),
        );
        assert_relative_eq!(one.roll, -other.roll, max_relative = 1e-9);
        assert_relative_eq!(one.centre_z, other.centre_z, max_relative = 1e-9);
        assert!((one.contacts[0].x_wheel - other.contacts[1].x_wheel).abs() < 1e-9);
    }
}

/// Wheels and rails that cannot be are refused with the reason.
#[test]
fn wheels_and_rails_that_do_not_fit_are_refused() {
    let (wheel, rail) = (nominal("S1002"), nominal("60E1"));
    let mirrored: Vec<[f64; 2]> = wheel
        .sampled(5e-4)
        .iter()
        .map(|point| [-point.x, point.height])
        .collect();
    let mirrored = Profile::through(&mirrored).unwrap();
    let error = Wheels::new([&mirrored, &wheel], [0.46; 2], 1.36, -0.07)
        .err()
        .unwrap();
    assert!(error.to_string().contains("mirrored"), "{error}");
    let error = Track::new([&rail, &rail], -0.01, 0.014, 0.025)
        .err()
        .unwrap();
    assert!(error.to_string().contains("overlap"), "{error}");
    let error = Track::new([&rail, &rail], 1.435, 0.05, 0.025)
        .err()
        .unwrap();
    assert!(error.to_string().contains("gauge height"), "{error}");
    let narrow = WheelsetOnTrack {
        wheels: Wheels::new([&wheel, &wheel], [0.46; 2], 1.1, -0.07).unwrap(),
        track: Track::new([&rail, &rail], 1.435, 0.014, 0.025).unwrap(),
    };
    assert!(matches!(
        narrow.contact(0.0, 0.0),
        Err(ProfileError::NoContact { .. })
    ));
}

/// On a cone the three rules give its conicity, at any amplitude.
#[test]
fn a_cone_has_its_conicity() {
    for (conicity, amplitude) in [(0.05, 1e-3), (0.3, 7e-3)] {
        let found = EquivalentConicity::at(|y| 2.0 * conicity * y, amplitude, 1.5, 0.46).unwrap();
        assert_relative_eq!(found.klingel, conicity, max_relative = 1e-6);
        assert_relative_eq!(found.harmonic, conicity, max_relative = 1e-6);
        assert_relative_eq!(found.regression, conicity, max_relative = 1e-6);
    }
    assert!(EquivalentConicity::at(|y| -0.1 * y, 3e-3, 1.5, 0.46).is_none());
}
