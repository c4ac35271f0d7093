//! Wheelsets: rigid, elastic, and what they must have in common.

mod measured;
mod modal;
mod passivity;
mod rigid;

use std::f64::consts::{PI, TAU};

use approx::assert_relative_eq;
use riffel::receptance::Structure;
use riffel::wheelset::{
    Axle, ContactGeometry, CoupledInertia, Disc, FlexibleWheelset, ModeName, NaturalMode, Port, Segment, Suspension,
    Wheelset,
};
use riffel::{Complex64, Direction, ElasticMaterial, Place, Rail};

const DENSITY: f64 = 7850.0;
const CONTACTS: ContactGeometry = ContactGeometry { contact_spacing: 1.5, rolling_radius: 0.46 };

fn steel(youngs_modulus: f64) -> ElasticMaterial {
    ElasticMaterial::new(youngs_modulus, 0.3).unwrap()
}

fn disc(position: f64, mass: f64, polar_inertia: f64, diametral_inertia: f64) -> Disc {
    Disc { position, mass, polar_inertia, diametral_inertia, coupled: None }
}

fn uniform(youngs_modulus: f64, diameter: f64, length: f64) -> Axle {
    let segment = Segment { length, diameter };
    Axle::new(steel(youngs_modulus), DENSITY, vec![segment]).and_then(|axle| axle.with_shear_coefficient(0.9)).unwrap()
}

/// Two wheels over the contacts and axle boxes at the ends of an axle of 2 m.
fn wheels_and_boxes(wheel: [f64; 3], axle_box: f64) -> Vec<Disc> {
    let [mass, polar, diametral] = wheel;
    [-0.75, 0.75]
        .map(|place| disc(place, mass, polar, diametral))
        .into_iter()
        .chain([-1.0, 1.0].map(|place| disc(place, axle_box, 0.0, 0.0)))
        .collect()
}

fn hertz(modes: &[NaturalMode], wanted: impl Fn(&ModeName) -> bool) -> Vec<f64> {
    let modes = modes.iter().filter(|mode| wanted(&mode.name));
    modes.map(|mode| mode.angular_frequency / TAU).collect()
}

/// Seven wheelsets against finite elements, to the digits of that table. Of its brake discs and gear it gives mass and
/// polar inertia; half of that is the diametral one of a thin disc.
#[test]
fn natural_frequencies_of_seven_wheelsets() {
    const WHEEL: [f64; 3] = [350.0, 27.77, 14.5];
    let brakes = |mass: f64, polar: f64, places: &[f64]| -> Vec<Disc> {
        let brake = |&place: &f64| disc(place, mass, polar, 0.5 * polar);
        places.iter().map(brake).collect()
    };
    type Row<'a> = (f64, [f64; 3], f64, Vec<Disc>, &'a [f64], &'a [f64]);
    let rows: [Row; 7] = [
        (0.16, WHEEL, 0.0, vec![], &[97.2, 203.4, 414.1, 859.0], &[78.6, 1067.5]),
        (0.16, WHEEL, 80.0, vec![], &[86.4, 188.6, 406.0, 699.0], &[78.6, 1067.5]),
        (0.15, [300.0, 21.0, 11.0], 60.0, vec![], &[85.0, 187.3, 391.0], &[79.4, 1067.6]),
        (
            0.16,
            WHEEL,
            80.0,
            brakes(100.0, 4.5, &[0.0, -0.35, 0.35]),
            &[71.1, 171.3, 306.9],
            &[77.2, 227.3, 395.0, 522.0],
        ),
        (0.16, WHEEL, 80.0, brakes(110.0, 5.5, &[-0.35, 0.35]), &[75.6, 171.7, 339.8], &[76.9, 261.1, 360.0]),
        (0.16, WHEEL, 80.0, brakes(150.0, 12.0, &[0.4]), &[78.8, 178.4, 342.0], &[76.4, 225.9, 1395.0]),
        (0.18, [400.0, 35.0, 18.5], 100.0, vec![], &[97.0, 212.3, 454.0], &[88.5, 1069.0]),
    ];
    for (diameter, wheel, axle_box, brakes, bending, torsion) in rows {
        let mut discs = wheels_and_boxes(wheel, axle_box);
        discs.extend(brakes);
        let wheelset = FlexibleWheelset::new(uniform(207e9, diameter, 2.0), discs, CONTACTS).unwrap();
        let modes = wheelset.natural_modes(TAU * 2000.0).unwrap();
        let bent = hertz(&modes, |name| matches!(name, ModeName::Bending { .. }));
        for (index, (got, expected)) in bent.iter().zip(bending).enumerate() {
            // Those of the table are of one program, its elements 25 mm long: they tell on the higher modes.
            let tolerance = if index < 2 { 1e-3 } else { 5e-3 };
            assert_relative_eq!(*got, *expected, max_relative = tolerance);
        }
        let twisted = hertz(&modes, |name| matches!(name, ModeName::Torsion { .. }));
        for (got, expected) in twisted.iter().zip(torsion) {
            assert_relative_eq!(*got, *expected, max_relative = 1e-3);
        }
    }
}

/// Discs between the wheels bring a torsion of their own, and nothing else does below 1 kHz.
#[test]
fn torsion_of_discs_against_wheels_is_named() {
    let names = |discs: Vec<Disc>| -> Vec<String> {
        let wheelset = FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS).unwrap();
        let modes = wheelset.natural_modes(TAU * 500.0).unwrap();
        modes.iter().map(|mode| mode.name.to_string()).collect()
    };
    let plain = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    assert_eq!(
        names(plain.clone()),
        ["first torsion", "first symmetric bending", "first antisymmetric bending", "second symmetric bending",]
    );
    let brakes = [-0.35, 0.35].map(|place| disc(place, 110.0, 5.5, 2.75));
    assert_eq!(
        names([plain, brakes.to_vec()].concat()),
        [
            "first symmetric bending",
            "first torsion",
            "first antisymmetric bending",
            "second torsion (discs against wheels)",
            "second symmetric bending",
            "third torsion (discs against each other)",
        ]
    );
}

/// Two wheels at the ends of a shaft: antisymmetric torsion κ tan κ = ρJs/I, symmetric tan κ = −(I/ρJs)κ, κ = ωs/c.
/// To the accuracy of the frequencies; 78.75 and 1067.39 Hz.
#[test]
fn torsion_of_two_wheels_on_a_shaft() {
    let (half, inertia, diameter) = (0.75, 27.77, 0.16);
    let wheels = [-half, half].map(|place| disc(place, 350.0, inertia, 14.5));
    let axle = uniform(207e9, diameter, 2.0 * half);
    let wheelset = FlexibleWheelset::new(axle, wheels.to_vec(), CONTACTS).unwrap();
    let modes = wheelset.natural_modes(TAU * 6000.0).unwrap();
    let twisted = hertz(&modes, |name| matches!(name, ModeName::Torsion { .. }));
    assert!((twisted[0] - 78.75).abs() < 0.005, "{}", twisted[0]);
    assert!((twisted[1] - 1067.39).abs() < 0.005, "{}", twisted[1]);

    let ratio = DENSITY * PI * diameter.powi(4) / 32.0 * half / inertia;
    let speed = (steel(207e9).shear_modulus() / DENSITY).sqrt();
    for (index, got) in twisted.iter().enumerate() {
        let phase = TAU * got * half / speed;
        // Near their roots these change as κ does, or faster.
        let (error, slope) = if index % 2 == 0 {
            let tangent = phase.tan();
            (phase * tangent - ratio, tangent + phase * (1.0 + tangent * tangent))
        } else {
            let tangent = phase.tan();
            (tangent + phase / ratio, 1.0 + tangent * tangent + ratio.recip())
        };
        assert!((error / slope / phase).abs() < 1e-9, "{index}: {error}");
    }
    assert_eq!(twisted.len(), 6);
}

/// Point receptances of the second of the seven wheelsets at its right contact, loss factor 0.01, to the accuracy of the
/// finite elements they come from. Their axle does not stretch, which leaves yy out.
#[test]
fn point_receptances_of_a_wheelset_with_axle_boxes() {
    let axle = uniform(207e9, 0.16, 2.0).with_loss_factor(0.01).unwrap();
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let wheelset = FlexibleWheelset::new(axle, discs, CONTACTS).unwrap();
    // Real parts of xx, zz, zy.
    let rows = [
        (50.0, 3e-4, [-2.859e-8, -1.670e-8, 5.375e-9]),
        (100.0, 3e-4, [-3.848e-8, -4.019e-9, 2.939e-9]),
        (150.0, 5e-4, [-1.157e-8, -1.497e-9, 2.409e-9]),
        (200.0, 2e-3, [-7.130e-9, -1.934e-9, -4.469e-9]),
        (500.0, 2e-3, [-9.783e-10, -2.083e-10, -3.295e-10]),
    ];
    for (frequency, tolerance, expected) in rows {
        let h = wheelset.receptances(TAU * frequency);
        let got = [h[3][3].re, h[5][5].re, h[5][4].re];
        for (got, expected) in got.into_iter().zip(expected) {
            assert_relative_eq!(got, expected, max_relative = tolerance);
        }
    }
}

/// Wheelsets at two places do not feel each other, and answer alike.
#[test]
fn wheelsets_stand_alone() {
    let discs = wheels_and_boxes([350.0, 27.77, 14.5], 80.0);
    let wheelset = FlexibleWheelset::new(uniform(207e9, 0.16, 2.0), discs, CONTACTS).unwrap();
    let place = |along, rail| Place { along, rail, direction: Direction::Vertical };
    let h = wheelset.receptances(500.0);
    let cross = |at, from| wheelset.cross_receptance(500.0, 30.0, at, from);
    for along in [0.0, -2.5] {
        assert_eq!(cross(place(along, Rail::Left), place(along, Rail::Right)), h[2][5]);
    }
    assert_eq!(cross(place(0.0, Rail::Left), place(-2.5, Rail::Left)), Complex64::ZERO);
    // All places at once.
    let places: Vec<Place> =
        [0.0, -2.5].into_iter().flat_map(|along| [place(along, Rail::Left), place(along, Rail::Right)]).collect();
    let mut matrix = [Complex64::ZERO; 16];
    wheelset.receptance_matrix(500.0, 30.0, &places, &mut matrix);
    for (i, &at) in places.iter().enumerate() {
        for (j, &from) in places.iter().enumerate() {
            assert_eq!(matrix[4 * i + j], cross(at, from));
        }
    }
    assert_eq!(Port::new(Rail::Right, Direction::Vertical).index(), 5);
    for (index, port) in Port::ALL.into_iter().enumerate() {
        assert_eq!(port.index(), index);
    }
}

#[test]
fn refuses_what_is_no_wheelset() {
    let axle = || uniform(207e9, 0.16, 1.6);
    let wheels = || [-0.75, 0.75].map(|place| disc(place, 350.0, 27.77, 14.5)).to_vec();
    let message = |discs: Vec<Disc>, contacts| FlexibleWheelset::new(axle(), discs, contacts).unwrap_err().to_string();
    assert_eq!(
        message(vec![disc(0.9, 80.0, 0.0, 0.0)], CONTACTS),
        "position of a disc is 0.9 m, but must lie on the axle, at most half its length from its middle"
    );
    let wide = ContactGeometry { contact_spacing: 1.7, ..CONTACTS };
    assert_eq!(message(wheels(), wide), "contact spacing is 1.7 m, but must not exceed the length of the axle");
    let negative = Disc { mass: -1.0, ..wheels()[0] };
    assert_eq!(message(vec![negative], CONTACTS), "mass of a disc is -1 kg, but must be finite and not negative");
    let wheelset = FlexibleWheelset::new(axle(), wheels(), CONTACTS).unwrap();
    let far = Suspension::new([1e6; 3], [0.0; 3], 2.0).unwrap();
    assert!(wheelset.clone().with_suspension(far).is_err());
    assert!(wheelset.natural_modes(TAU * 20e3).is_err());
    assert!(wheelset.natural_modes(f64::NAN).is_err());
    assert!(Axle::new(steel(207e9), DENSITY, vec![]).is_err());
    assert!(axle().with_shear_coefficient(1.2).is_err());
}

/// Two absorbers of one frequency on one wheel: against each other they swing while the wheel stands still, a mode that has
/// no node to be seen at. It is counted, and no shape is without a number.
#[test]
fn equal_absorbers_are_counted() {
    let coupled = CoupledInertia { polar_inertia: 4.0, stiffness: 4.0 * 700f64.powi(2), damping: 0.0 };
    let absorber = Disc { coupled: Some(coupled), ..disc(0.75, 0.0, 0.0, 0.0) };
    let count = |absorbers: Vec<Disc>| {
        let discs = [wheels_and_boxes([350.0, 27.77, 14.5], 80.0), absorbers].concat();
        let axle = uniform(207e9, 0.16, 2.0);
        let wheelset = FlexibleWheelset::new(axle, discs, CONTACTS).unwrap();
        let modes = wheelset.natural_modes(TAU * 500.0).unwrap();
        for mode in &modes {
            let shape = [-0.75, 0.0, 0.75].map(|place| mode.motion_at(place).below(0.46));
            assert!(shape.iter().flatten().all(|value| value.is_finite()), "{}", mode.name);
        }
        hertz(&modes, |name| matches!(name, ModeName::Torsion { .. }))
    };
    assert_eq!(count(vec![]).len(), 1);
    assert_eq!(count(vec![absorber]).len(), 2);
    let both = count(vec![absorber; 2]);
    assert_eq!(both.len(), 3);
    assert_relative_eq!(both[1], 700.0 / TAU, max_relative = 1e-12);
}
