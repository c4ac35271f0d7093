//! The contact filter: the half-space solver against the flat punch, and both against the table of CNOSSOS-EU.

use std::f64::consts::PI;

use riffel::contact::{ContactFilter, ContactGrid, NormalContact};
use riffel::{ElasticMaterial, HertzContact};

use crate::Row;

const TABLE: &str = include_str!("../reference/contact/cnossos_contact_filter.csv");
const SOURCE: &str = "CNOSSOS-EU, table G-2, `contact/cnossos_contact_filter.csv`";

/// Transverse radius of the head of a new rail \[m\]; the table does not name one.
const TRANSVERSE_RADIUS: f64 = 0.3;

/// Shortest wavelength, in semi-axes a, at which the patch takes a mean over less than one wave; the first
/// zero of sin(ka)/(ka) is at 2.
const SHORTEST: f64 = 2.5;

fn hertz(rolling_radius: f64, load: f64) -> HertzContact {
    ElasticMaterial::new(207e9, 0.3)
        .and_then(|steel| HertzContact::exact(steel, rolling_radius, TRANSVERSE_RADIUS, load))
        .expect("a contact")
}

/// The table's values for one wheel and load.
struct Curve {
    load: f64,
    diameter: f64,
    a: f64,
    filter: ContactFilter,
    /// Exact wavelengths of the bands \[m\] and levels of |H|² \[dB\].
    levels: Vec<(f64, f64)>,
}

fn curves() -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for line in TABLE.lines().skip(1) {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        let (load, diameter) = (1e3 * cells[0], 1e-3 * cells[1]);
        // Nominal to exact wavelength, a whole power of 10^{1/10} of a millimetre.
        let band = (10.0 * cells[2].log10()).round();
        let level = (1e-3 * 10_f64.powf(0.1 * band), cells[3]);
        match curves.last_mut() {
            Some(curve) if (curve.load, curve.diameter) == (load, diameter) => {
                curve.levels.push(level);
            }
            _ => {
                let hertz = hertz(0.5 * diameter, load);
                curves.push(Curve {
                    load,
                    diameter,
                    a: hertz.semi_axis_longitudinal(),
                    filter: ContactFilter::of(&hertz),
                    levels: vec![level],
                });
            }
        }
    }
    curves
}

impl Curve {
    /// The wavelength \[m\] at which the table passes a level \[dB\], on the logarithmic scale.
    fn wavelength_at(&self, level: f64) -> f64 {
        self.levels.windows(2).find(|pair| pair[0].1 >= level && level > pair[1].1).map_or(f64::NAN, |pair| {
            let share = (pair[0].1 - level) / (pair[0].1 - pair[1].1);
            pair[0].0 * (pair[1].0 / pair[0].0).powf(share)
        })
    }
}

fn decibel(square: Result<f64, riffel::Error>) -> f64 {
    10.0 * square.expect("a filter").log10()
}

fn extent(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
        // Not a number in one of them must not get lost.
        if value.is_nan() { (value, value) } else { (low.min(value), high.max(value)) }
    })
}

pub(crate) fn contact_filter_of_the_solver() -> Row {
    let contact = hertz(0.46, 50e3);
    let (a, b) = (contact.semi_axis_longitudinal(), contact.semi_axis_lateral());
    let filter = ContactFilter::of(&contact);
    let amplitude = 1e-6;
    let gap = |x: f64, y: f64| x * x / 0.92 + y * y / (2.0 * TRANSVERSE_RADIUS);
    let grid = ContactGrid::over(64, 64, 1.5 * a, 1.5 * b).expect("a grid");
    let mut solver = NormalContact::new([contact.material(); 2], grid, gap).expect("a gap");
    let mut worst: f64 = 0.0;
    let cases = [1.4, 2.0, 3.0, 4.0, 6.0, 8.0].into_iter().flat_map(|ratio| [0.0, 1.0].map(|askew| (ratio, askew)));
    for (ratio, askew) in cases {
        let along = 2.0 * PI / (ratio * a);
        let across = askew * along;
        // Half the difference of crest and trough: even orders of the amplitude cancel.
        let [crest, trough] = [amplitude, -amplitude].map(|height| {
            let wave = |x: f64, y: f64| height * (along * x + across * y).cos();
            solver.set_gap(|x, y| gap(x, y) - wave(x, y)).expect("a gap");
            solver.under_load(50e3).expect("a contact").approach()
        });
        let lift = 0.5 * (trough - crest) / amplitude;
        let error = (lift - filter.amplitude(along, across)).abs();
        worst = if error <= worst { worst } else { error };
    }
    Row {
        statement: "A wave of 1 µm under a loaded wheel lifts it by sin κ/κ of its amplitude, \
                    κ² = (k_x a)² + (k_y b)², wavelengths of 1.4–8 a along the rail and at 45°",
        source: "reciprocity: the pressure under a flat punch weights the roughness",
        expected: "12 amplitudes".to_owned(),
        got: format!("within {worst:.4}"),
        tolerance: "0.01 of the amplitude: 64 elements across, whose patch grows by whole ones",
        holds: worst <= 0.01,
    }
}

pub(crate) fn contact_filter_scales_with_the_patch() -> Row {
    let curves = curves();
    let mut widest: f64 = 0.0;
    let mut at_half = String::new();
    for level in [-1.0, -2.0, -3.0, -6.0, -9.0, -12.0, -16.0] {
        let (low, high) = extent(curves.iter().map(|curve| curve.wavelength_at(level) / curve.a));
        let spread = (high - low) / (high + low);
        widest = if spread <= widest { widest } else { spread };
        if level == -3.0 {
            at_half = format!("{low:.2}–{high:.2} a at −3 dB");
        }
    }
    Row {
        statement: "Contact filter: it reaches a level between −1 and −16 dB at the same wavelength over the exact \
                    Hertz semi-axis a, from 25 to 100 kN and from 360 to 920 mm",
        source: SOURCE,
        expected: "one λ/a for 5 wheels and loads, at 7 levels".to_owned(),
        got: format!("{at_half}; ±{:.1} % at most", 100.0 * widest),
        tolerance: "±4 %: 0.05 dB of rounding is 2.5 % of the wavelength at −1 dB, and the table's own scatter \
                    of 0.5 dB is 4 % at −6 dB. Over √(ab) the same wavelengths spread by ±15 %",
        holds: widest <= 0.04 && curves.len() == 5,
    }
}

pub(crate) fn contact_filter_rises_with_the_load() -> Row {
    let curves = curves();
    let of =
        |load: f64| curves.iter().find(|curve| (curve.load, curve.diameter) == (load, 0.92)).expect("25, 50 or 100 kN");
    // Twice the load makes a larger by 2^{1/3}, and a band is 10^{1/10}: 0.1 % apart.
    let shift = |high: f64, low: f64| (10.0 * (of(high).a / of(low).a).log10()).round() as usize;
    let mut worst = (0.0, 0.0);
    let mut compared = 0;
    for (high, low) in [(50e3, 25e3), (100e3, 50e3), (100e3, 25e3)] {
        let bands = shift(high, low);
        let pairs = of(high).levels.iter().zip(&of(low).levels[bands..]);
        for (&(wavelength, one), &(_, other)) in pairs {
            // Beyond, the table is no longer steep, and made of other things than the patch.
            if one.min(other) >= -17.0 && one < 0.0 {
                compared += 1;
                if (one - other).abs() > worst.0 {
                    worst = ((one - other).abs(), wavelength);
                }
            }
        }
    }
    Row {
        statement: "Contact filter: twice the load moves it by one band, a ∝ P^{1/3}; 920 mm, 25, 50 and 100 kN",
        source: SOURCE,
        expected: format!("0 dB apart, {compared} pairs of levels down to −17 dB"),
        got: format!("at most {:.1} dB apart, at {:.1} mm", worst.0, 1e3 * worst.1),
        tolerance: "0.8 dB: the table's own scatter, for Hertz makes the three rows one. At 40 mm and 50 kN it has \
                    −1.3 dB where the other two loads have −1.8",
        // The differences are of numbers with one digit after the point.
        holds: worst.0 < 0.85 && compared >= 30,
    }
}

pub(crate) fn contact_filter_of_long_waves() -> Row {
    let mut worst: f64 = 0.0;
    let mut compared = 0;
    for curve in curves() {
        for &(wavelength, level) in &curve.levels {
            if wavelength >= 8.0 * curve.a {
                compared += 1;
                let error = (level - decibel(curve.filter.elastic(wavelength, 0.0))).abs();
                worst = if error <= worst { worst } else { error };
            }
        }
    }
    Row {
        statement: "Contact filter: sin(ka)/(ka), roughness uniform across, wavelengths of 8 a and more",
        source: SOURCE,
        expected: format!("{compared} levels down to −1.2 dB"),
        got: format!("within {worst:.2} dB"),
        tolerance: "0.4 dB: variation across adds (αb/a)²/3 of the level, 0.3 dB at 8 a with α = 1 and b = a",
        holds: worst <= 0.4 && compared >= 80,
    }
}

pub(crate) fn contact_filter_between_bounds() -> Row {
    let mut outside: f64 = 0.0;
    let mut compared = 0;
    for curve in curves() {
        for &(wavelength, level) in &curve.levels {
            // Long waves are at 0 dB whatever the model.
            if wavelength >= SHORTEST * curve.a && wavelength <= 25.0 * curve.a {
                compared += 1;
                let above = level - decibel(curve.filter.elastic(wavelength, 0.0));
                let below = decibel(curve.filter.elastic(wavelength, 2.0)) - level;
                let error = above.max(below);
                outside = if error <= outside { outside } else { error };
            }
        }
    }
    Row {
        statement: "Contact filter: between roughness uniform across and roughness that varies across up to twice \
                    as fast as along (α = 2), wavelengths of 2.5–25 a",
        source: SOURCE,
        expected: format!("{compared} levels down to −14 dB between the two"),
        got: format!("outside by {outside:.2} dB at most"),
        tolerance: "0.15 dB: the table's rounding and scatter. What varied across in the roughness behind the \
                    table is not known; the bounds are up to 5 dB apart",
        holds: outside <= 0.15 && compared >= 45,
    }
}

pub(crate) fn contact_filter_of_remington() -> Row {
    // Fitted, one number for all rows: least squares give 2.15 to 2.33 for one row alone.
    const VARIATION: f64 = 2.2;
    let (mut sum, mut worst, mut compared) = (0.0, 0.0_f64, 0);
    for curve in curves() {
        let circle = ContactFilter::new(curve.a, curve.a).expect("a patch");
        for &(wavelength, level) in &curve.levels {
            if wavelength >= SHORTEST * curve.a && wavelength <= 25.0 * curve.a {
                compared += 1;
                let error = level - decibel(circle.uniform(wavelength, VARIATION));
                sum += error * error;
                worst = worst.max(error.abs());
            }
        }
    }
    let mean = (sum / f64::from(compared)).sqrt();
    Row {
        statement: "Contact filter: Remington's for a circle of the radius a, his α = 2.2 fitted once for five wheels and \
                    loads, wavelengths of 2.5–25 a",
        source: SOURCE,
        expected: format!("{compared} levels down to −14 dB"),
        got: format!("{mean:.2} dB root mean square, {worst:.1} dB at worst"),
        tolerance: "0.5 and 1.3 dB: the table's own scatter of up to 0.8 dB, and what varied across is not known",
        holds: mean <= 0.5 && worst <= 1.3 && compared >= 45,
    }
}

pub(crate) fn contact_filter_approximation() -> Row {
    let mut worst: f64 = 0.0;
    let mut apart = Vec::new();
    let mut compared = 0;
    for curve in curves() {
        for &(wavelength, level) in &curve.levels {
            if (-6.0..0.0).contains(&level) {
                compared += 1;
                let error = (level - decibel(curve.filter.approximate(wavelength))).abs();
                if error <= 0.5 {
                    worst = worst.max(error);
                } else {
                    apart.push((wavelength, curve.load, error));
                }
            }
        }
    }
    let known = |&(wavelength, load, error): &(f64, f64, f64)| {
        (1e3 * wavelength).round() == 40.0 && load == 50e3 && error < 0.7
    };
    let is_known = apart.len() == 1 && apart.iter().all(known);
    let apart = apart
        .iter()
        .map(|(wavelength, load, error)| {
            format!("{error:.2} dB at {:.0} mm and {:.0} kN", 1e3 * wavelength, 1e-3 * load)
        })
        .collect::<Vec<_>>()
        .join(", ");
    Row {
        statement: "Contact filter: 1/(1 + (π/4)(ka)³), with a along the rail as the radius, down to −6 dB",
        source: SOURCE,
        expected: format!("{compared} levels"),
        got: format!("within {worst:.2} dB; {apart}"),
        tolerance: "0.5 dB, the table's own scatter; 0.7 dB where the table has −1.3 dB for −1.8 (40 mm, 50 kN, 920 mm). \
                    Beyond −6 dB the formula is too weak, by 4 dB at −16.8 dB",
        holds: worst <= 0.5 && is_known && compared >= 38,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The table has one of its rows twice: that of 50 kN and 360 mm is that of 100 kN and 920 mm, three bands on,
    /// where Hertz makes the patches 3.04 bands apart.
    #[test]
    fn table_has_one_row_twice() {
        let curves = curves();
        let of = |load: f64| {
            curves
                .iter()
                .find(|curve| (curve.load, curve.diameter) == (load, if load == 50e3 { 0.36 } else { 0.92 }))
                .unwrap()
        };
        let (small, large) = (of(50e3), of(100e3));
        for (one, other) in large.levels.iter().zip(&small.levels[3..]) {
            assert_eq!(one.1, other.1);
        }
        let bands = 10.0 * (large.a / small.a).log10();
        assert!((bands - 3.04).abs() < 0.01, "{bands}");
    }
}
