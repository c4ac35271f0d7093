//! Stress under an ellipse and limits of shakedown, against numbers made apart from Riffel and closed forms.

use std::f64::consts::PI;

use riffel::damage::stress::{
    Depth, EllipseStress, StressMaximum, StressMeasure, Traction, UnitStress,
};
use riffel::damage::{ShakedownLimit, orthogonal_shear};

const NU: f64 = 0.3;

/// Rows of a file of `validation/reference/damage` below its head.
macro_rules! rows {
    ($name:literal) => {
        include_str!(concat!("../../../../validation/reference/damage/", $name))
            .lines()
            .skip(1)
            .map(|line| line.split(',').collect::<Vec<&str>>())
    };
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap()
}

fn at(ratio: f64, place: [f64; 3]) -> UnitStress {
    EllipseStress::of_ratio(ratio, NU).at(place)
}

/// 3e-6 of p₀, what the reference's two orders agree to.
#[test]
fn stress_at_points() {
    let (mut worst, mut count) = ((0.0, String::new()), 0);
    for row in rows!("stress_points.csv") {
        let ratio = number(row[0]);
        let place = [number(row[1]), number(row[2]), number(row[3])];
        let unit = at(ratio, place);
        let got = match row[4] {
            "normal" => unit.normal,
            _ => unit.along,
        };
        for (got, expected) in got.iter().zip(&row[5..]) {
            let error = (got - number(expected)).abs();
            if error > worst.0 || error.is_nan() {
                worst = (error, format!("{row:?}: {got}"));
            }
        }
        count += 1;
    }
    println!("{count} rows, worst {worst:?}");
    assert!(count > 50 && worst.0 < 6e-6, "{worst:?}");
}

/// A circle on its axis, and its edge; ends of the axes and centre of ellipses.
#[test]
fn closed_forms() {
    for z in [0.05, 0.3, 0.481, 1.0, 3.0] {
        let stress = at(1.0, [0.0, 0.0, z]).normal;
        let x = -(1.0 + NU) * (1.0 - z * (1.0 / z).atan()) + 0.5 / (1.0 + z * z);
        assert!((stress[0] - x).abs() < 1e-12, "{z}: {} {x}", stress[0]);
        assert!((stress[1] - x).abs() < 1e-12);
        assert!((stress[2] + 1.0 / (1.0 + z * z)).abs() < 1e-12);
    }
    let edge = at(1.0, [-1.0 + 1e-12, 0.0, 0.0]);
    let sliding = edge.normal[0] + edge.along[0];
    let closed = (1.0 - 2.0 * NU) / 3.0 + PI * (4.0 + NU) / 8.0;
    // The root of what is left to the edge.
    assert!((sliding - closed).abs() < 1e-5, "{sliding} {closed}");
    for ratio in [0.3f64, 0.5, 1.0, 2.0, 3.0] {
        let b = ratio.recip();
        let centre = at(ratio, [0.0; 3]).normal;
        let x = -2.0 * NU - (1.0 - 2.0 * NU) * b / (1.0 + b);
        let y = -2.0 * NU - (1.0 - 2.0 * NU) / (1.0 + b);
        assert!(
            (centre[0] - x).abs() < 1e-8 && (centre[1] - y).abs() < 1e-8,
            "{ratio}"
        );
        let end = at(ratio, [1.0 - 1e-12, 0.0, 0.0]).normal;
        let expected = match ratio {
            ratio if ratio > 1.0 => {
                let e = (1.0 - b * b).sqrt();
                (1.0 - 2.0 * NU) * b / (e * e) * (e.atanh() / e - 1.0)
            }
            ratio if ratio < 1.0 => {
                let e = (1.0 - 1.0 / (b * b)).sqrt();
                (1.0 - 2.0 * NU) / (b * e * e) * (1.0 - 1.0 / (b * e) * (b * e).atan())
            }
            _ => (1.0 - 2.0 * NU) / 3.0,
        };
        assert!(
            (end[0] - expected).abs() < 1e-5,
            "{ratio}: {} {expected}",
            end[0]
        );
        assert!((end[0] + end[1]).abs() < 1e-5);
    }
}

/// Stress is in equilibrium, under any load and at any place, the traction across too.
#[test]
fn equilibrium() {
    for ratio in [0.4, 1.0, 2.5] {
        let b = 1.0 / ratio;
        for [x, y, z] in [[0.3, 0.2, 0.4], [-0.9, 0.5, 0.15], [1.2, -0.3, 0.5]] {
            let step = 1e-4;
            let unit = |axis: usize, sign: f64| {
                let mut place = [x, y, z];
                place[axis] += sign * step;
                at(ratio, [place[0], place[1] / b, place[2]])
            };
            let slope = |of: fn(&UnitStress) -> [f64; 6], axis: usize, part: usize| {
                (of(&unit(axis, 1.0))[part] - of(&unit(axis, -1.0))[part]) / (2.0 * step)
            };
            for of in [
                (|unit| unit.normal) as fn(&UnitStress) -> [f64; 6],
                |unit| unit.along,
                |unit| unit.across,
            ] {
                for parts in [[0, 3, 5], [3, 1, 4], [5, 4, 2]] {
                    let sum: f64 = (0..3).map(|axis| slope(of, axis, parts[axis])).sum();
                    assert!(sum.abs() < 1e-6, "{ratio} {x} {y} {z}: {sum}");
                }
            }
        }
    }
}

/// A traction across a turned ellipse is one along it.
#[test]
fn axes_may_be_exchanged() {
    for ratio in [0.5, 1.0, 2.0] {
        let (one, other) = (
            at(ratio, [0.4, 0.3, 0.3]),
            at(1.0 / ratio, [0.3, 0.4, 0.3 * ratio]),
        );
        let [xx, yy, zz, xy, yz, zx] = other.along;
        for (a, b) in one.across.iter().zip([yy, xx, zz, xy, zx, yz]) {
            assert!((a - b).abs() < 1e-12, "{ratio}: {a} {b}");
        }
    }
}

/// Largest von Mises and Tresca: 0.5 % of each, places where the largest is not flat.
#[test]
fn largest_stresses() {
    let (mut worst, mut count) = ((0.0, String::new()), 0);
    for row in rows!("stress_maxima.csv") {
        let (ratio, friction) = (number(row[0]), number(row[1]));
        let along = [1.0, 0.0];
        let traction = match row[2] {
            "full" => Traction::full_slip(friction, along),
            _ => Traction::partial_slip(friction, along, 0.5),
        };
        let measure = match row[3] {
            "mises" => StressMeasure::VonMises,
            _ => StressMeasure::Tresca,
        };
        let depth = match row[4] {
            "surface" => Depth::Surface,
            _ => Depth::Below,
        };
        let ellipse = EllipseStress::of_ratio(ratio, NU);
        let found = StressMaximum::find(&ellipse, &traction, measure, depth);
        let error = (found.value / number(row[5]) - 1.0).abs();
        if error > worst.0 || error.is_nan() {
            worst = (error, format!("{row:?}: {found:?}"));
        }
        count += 1;
    }
    println!("{count} rows, worst {worst:?}");
    assert!(count > 100 && worst.0 < 5e-3, "{worst:?}");
}

/// 1e-4 of the fine file; 1 % of bounds on an ellipse.
#[test]
fn shakedown() {
    for row in rows!("shakedown_line_fine.csv") {
        let [limit, _] = ShakedownLimit::Line.at(number(row[0]));
        assert!((limit - number(row[2])).abs() < 2e-4, "{row:?}: {limit}");
    }
    for row in rows!("shakedown_ellipse.csv") {
        let (ratio, friction) = (number(row[0]), number(row[1]));
        let limit = ShakedownLimit::Elastic {
            ratio,
            poisson_ratio: NU,
        };
        let [elastic, _] = limit.at(friction);
        println!("{row:?} {elastic}");
        if friction == 0.0 {
            let [sub, _] = ShakedownLimit::Subsurface { ratio }.at(0.0);
            println!("{row:?} {sub}");
        }
    }
    // Lundberg & Palmgren against the stress of the circle.
    let (shear, depth) = orthogonal_shear(1.0);
    let ellipse = EllipseStress::of_ratio(1.0, NU);
    let largest = (0..=400)
        .map(|i| f64::from(i) / 400.0)
        .map(|x| ellipse.at([x, 0.0, depth]).normal[5].abs())
        .fold(0.0, f64::max);
    assert!((largest / shear - 1.0).abs() < 1e-5, "{largest} {shear}");
}

/// The slope of the elastic limit is that of its values.
#[test]
fn slope_of_the_elastic_limit() {
    for friction in [0.2, 0.45] {
        let limit = ShakedownLimit::Elastic {
            ratio: 1.3,
            poisson_ratio: NU,
        };
        let step = 1e-3;
        let ln = |friction: f64| limit.at(friction)[0].ln();
        let difference = (ln(friction + step) - ln(friction - step)) / (2.0 * step);
        let [_, slope] = limit.at(friction);
        assert!((difference - slope).abs() < 1e-3, "{difference} {slope}");
    }
}
