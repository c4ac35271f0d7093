//! Wheelsets by measured receptances.

use approx::assert_relative_eq;
use riffel::receptance::MeasuredReceptance;
use riffel::wheelset::{FlexibleWheelset, MeasuredEntry, MeasuredWheelset, Port, Wheelset};
use riffel::{Complex64, Direction, Rail};

use super::{CONTACTS, uniform, wheels_and_boxes};

/// A flexible wheelset as a measurement of it: on its lines the same, elsewhere near, outside not a number.
#[test]
fn measured_wheelset_is_what_was_measured() {
    let axle = uniform(207e9, 0.16, 2.0).with_loss_factor(0.05).unwrap();
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let source = FlexibleWheelset::new(axle, discs, CONTACTS).unwrap();
    let lines: Vec<f64> = (0..200).map(|line| 100.0 * 1.02f64.powi(line)).collect();
    let table = |i: usize, j: usize, sign: f64| {
        let values = lines.iter().map(|&w| sign * source.receptances(w)[i][j]);
        MeasuredReceptance::new(&lines, values.collect()).unwrap()
    };
    let entry = |i: usize, j: usize, sign: f64| MeasuredEntry {
        at: Port::ALL[i],
        from: Port::ALL[j],
        receptance: table(i, j, sign),
    };
    // The right wheel whole, and one entry across; zy given one way only.
    let entries = || vec![entry(3, 3, 1.0), entry(4, 4, 1.0), entry(5, 5, 1.0), entry(5, 4, 1.0), entry(3, 0, 1.0)];
    let measured = MeasuredWheelset::new(entries()).unwrap();
    let w = lines[77];
    let (got, expected) = (measured.receptances(w), source.receptances(w));
    for (i, j) in [(3, 3), (4, 4), (5, 5), (5, 4), (4, 5), (3, 0), (0, 3)] {
        assert!((got[i][j] - expected[i][j]).norm() < 1e-12 * expected[i][j].norm(), "{i} {j}");
    }
    assert_eq!(got[0][0], Complex64::ZERO);
    assert!(measured.receptances(99.0)[5][5].is_nan());
    assert_eq!(measured.reciprocity_violation(), None);
    // An entry across without those of the other wheel cannot be.
    let violation = measured.passivity_violation().unwrap();
    assert!(violation.ports[0].direction == Direction::Longitudinal);

    let one_wheel = entries()[..4].to_vec();
    let passive = MeasuredWheelset::new(one_wheel.clone()).unwrap();
    assert!(passive.passivity_violation().is_none_or(|violation| violation.size < 1e-12));
    let both = MeasuredWheelset::from_one_wheel(
        Rail::Right,
        one_wheel.iter().map(|entry| (entry.at.direction, entry.from.direction, entry.receptance.clone())).collect(),
    )
    .unwrap();
    let got = both.receptances(w);
    for (i, j) in [(0, 0), (1, 1), (2, 2), (2, 1), (5, 4)] {
        assert!((got[i][j] - expected[i][j]).norm() < 1e-12 * expected[i][j].norm(), "{i} {j}");
    }

    // Measured both ways, once with the wrong sign of an axis.
    let crossed = [entries(), vec![entry(4, 5, -1.0)]].concat();
    let violation = MeasuredWheelset::new(crossed).unwrap().reciprocity_violation().unwrap();
    assert_relative_eq!(violation.size, 2.0, max_relative = 1e-12);
    assert_eq!(violation.ports, [Port::ALL[5], Port::ALL[4]]);
    let wrong = MeasuredWheelset::new(vec![entry(5, 5, -1.0)]).unwrap().passivity_violation();
    assert_eq!(wrong.unwrap().ports, [Port::ALL[5]; 2]);

    let twice = [entries(), vec![entry(5, 4, 1.0)]].concat();
    assert!(MeasuredWheelset::new(twice).is_err());
    assert!(MeasuredWheelset::new(vec![]).is_err());
}
