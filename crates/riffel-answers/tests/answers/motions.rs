//! The modes of a wheelset as motions to draw.

use riffel_answers::wheelset::WheelsetAnswer;
use riffel_answers::wheelset_motions::WheelsetMotions;
use riffel_case::Case;

const CURVE: &str = include_str!("../../../../cases/curve.toml");
const NOMINAL: &str = include_str!("../../../../cases/nominal.toml");

#[test]
fn modes_are_those_of_the_wheelset_over_their_largest_motion() {
    let case = Case::parse("curve.toml", CURVE, &[]).unwrap();
    let motions = WheelsetMotions::new(&case).unwrap();
    let answer = WheelsetAnswer::new(&case, vec![100.0]).unwrap();
    let frequencies: Vec<f64> = answer.modes.iter().map(|mode| mode.frequency).collect();
    let drawn: Vec<f64> = motions.modes.iter().map(|mode| mode.frequency_hz).collect();
    assert_eq!(drawn, frequencies);
    assert_eq!(motions.axle_diameter_m, 0.16);
    let wheels: Vec<f64> = motions.discs.iter().filter(|disc| disc.is_wheel).map(|disc| disc.position_m).collect();
    assert_eq!(wheels.len(), 2);
    // Alike to the left and to the right, within rounding.
    assert!((wheels[0] + wheels[1]).abs() < 1e-12, "{wheels:?}");
    for mode in &motions.modes {
        let parts = mode.displacement.iter().flatten().chain(&mode.twist);
        let largest = parts.fold(0.0, |most: f64, part| most.max(part.abs()));
        assert!((largest - 1.0).abs() < 1e-12, "{}: {largest}", mode.name);
        let twists = mode.twist.iter().any(|part| *part != 0.0);
        assert_eq!(twists, mode.name.to_string().contains("torsion"), "{}", mode.name);
    }
}

#[test]
fn a_lone_wheel_has_no_modes() {
    let case = Case::parse("nominal.toml", NOMINAL, &[]).unwrap();
    let refused = WheelsetMotions::new(&case).unwrap_err().to_string();
    assert!(refused.contains("a lone wheel has no axle"), "{refused}");
}
