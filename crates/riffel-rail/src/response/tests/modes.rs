//! Modes of wheelsets.

use riffel::wheelset::{ContactGeometry, ElasticMode, ModalWheelset, RigidBody, RigidWheelset, Wheelset};

use super::*;

/// Two modes with all that stands in a table of them.
const MODES: &str = "frequency_hz,damping_ratio,generalised_mass_kg,left_x,left_y,left_z,right_x,right_y,right_z\n\
                     78.6,0.002,55,1,0,0,-1,0,0\n\
                     97.2,0.003,300,0,0.4,1,0,-0.4,1\n";

fn rigid() -> RigidWheelset {
    let body = RigidBody { mass: 1100.0, roll_inertia: 620.0, spin_inertia: 85.0 };
    RigidWheelset::new(body, ContactGeometry { contact_spacing: 1.5, rolling_radius: 0.42 }).unwrap()
}

/// The wheelset of the modes of a text.
fn parse(text: &str) -> Result<ModalWheelset, String> {
    let modes = WheelsetModes::parse(text).and_then(|modes| modes.wheelset(rigid()));
    modes.map_err(|error| error.message.to_string())
}

/// The wheelset of [`MODES`].
pub(super) fn modal(residual: Option<[[f64; 6]; 6]>) -> ModalWheelset {
    let mode = |frequency: f64, damping_ratio, generalised_mass, shape| ElasticMode {
        angular_frequency: TAU * frequency,
        damping_ratio,
        generalised_mass,
        shape,
    };
    let modes = vec![
        mode(78.6, 0.002, 55.0, [1.0, 0.0, 0.0, -1.0, 0.0, 0.0]),
        mode(97.2, 0.003, 300.0, [0.0, 0.4, 1.0, 0.0, -0.4, 1.0]),
    ];
    let wheelset = ModalWheelset::new(Some(rigid()), modes).unwrap();
    match residual {
        Some(residual) => wheelset.with_residual(residual).unwrap(),
        None => wheelset,
    }
}

fn diagonal(residual: f64) -> [[f64; 6]; 6] {
    std::array::from_fn(|row| std::array::from_fn(|column| if row == column { residual } else { 0.0 }))
}

/// Tables of the same two modes in other words, units and separators.
#[test]
fn modes_are_read_in_their_units() {
    let cases: [(String, Option<[[f64; 6]; 6]>); 6] = [
(MODES.to_owned(), None),
("mode;eigenfrequency [rad/s];damping [%];modal_mass_t;left_x;left_y;left_z;right_x;right_y;right_z\n\
     1;493,858365144315;0,2;0,055;1;0;0;-1;0;0\n2;610,725611857856;0,3;0,3;0;0,4;1;0;-0,4;1\n"
        .to_owned(), None),
("# of a model\nfrequency_hz,damping_ratio_percent,left_x [1/√kg],left_y [1/√kg],left_z [1/√kg],right_x [1/√kg],\
     right_y [1/√kg],right_z [1/√kg]\n\
     97.2,0.3,0,0.0230940107676,0.0577350269190,0,-0.0230940107676,0.0577350269190\n\
     78.6,0.2,0.134839972493,0,0,-0.134839972493,0,0\n"
        .to_owned(), None),
("frequency\tzeta\tLeft x\tLeft y\tLeft z\tRight x\tRight y\tRight z\n\
     kHz\t%\tt^-0.5\tt^-0.5\tt^-0.5\tt^-0.5\tt^-0.5\tt^-0.5\n\
     0.0786\t0.2\t4.26401432711\t0\t0\t-4.26401432711\t0\t0\n\
     0.0972\t0.3\t0\t0.730296743340\t1.82574185835\t0\t-0.730296743340\t1.82574185835\n"
        .to_owned(), None),
(format!("{MODES}residual,,,3e-10,3e-10,3e-10,3e-10,3e-10,3e-10\n"), Some(diagonal(3e-10))),
(MODES.to_owned()
        + "residual,,,1e-10,0,0,2e-11,0,0\nresidual,,,0,1e-10,0,0,0,0\nresidual,,,0,0,1e-10,0,0,0\n\
           residual,,,2e-11,0,0,1e-10,0,0\nresidual,,,0,0,0,0,1e-10,0\nresidual,,,0,0,0,0,0,1e-10\n", Some({
        let mut residual = diagonal(1e-10);
        (residual[0][3], residual[3][0]) = (2e-11, 2e-11);
        residual
    })),
];
    for (file, residual) in cases {
        let (read, expected) = (parse(&file).unwrap(), modal(residual));
        for frequency in [10.0, 78.0, 97.0, 300.0] {
            let w = TAU * frequency;
            let (got, expected) = (read.receptances(w), expected.receptances(w));
            for (got, expected) in got.iter().flatten().zip(expected.iter().flatten()) {
                // The tables hold twelve digits, which resonances make eight of.
                assert!((got - expected).norm() <= 1e-8 * expected.norm(), "{frequency}: {got} {expected}");
            }
        }
    }
}

#[test]
fn refuses_what_are_no_modes() {
    for (file, sentence) in [
        (
            MODES.replace("generalised_mass_kg", "mass"),
            "does not say how its shapes are normalised: give a column `generalised_mass_kg`, or, if they are mass-normalised, \
     their unit, as in `left_x [1/√kg]`",
        ),
        (
            MODES.replace("left_x", "left_x [1/√kg]"),
            "beside `generalised_mass_kg` a shape has no unit; leave that column out if the shapes are mass-normalised",
        ),
        (
            MODES.replace("55,", "1,"),
            "line 2: a mode moves a contact as less than a 500th of the wheelset's mass would",
        ),
        (
            MODES
                .replace("generalised_mass_kg", "mass")
                .replace("_x", "_x [mm]")
                .replace("_y", "_y [mm]")
                .replace("_z", "_z [mm]"),
            "has column `left_x [mm]` in \"mm\": a mass-normalised shape is in 1/√kg or 1/√t",
        ),
        (
            MODES
                .replace("generalised_mass_kg", "mass")
                .replace("left_x", "left_x [1/√t]")
                .replace("_y", "_y [1/√kg]")
                .replace("_z", "_z [1/√kg]")
                .replace("right_x", "right_x [1/√kg]"),
            "all shapes have one unit, that of `left_x [1/√t]`",
        ),
        (MODES.replace("right_z", "z"), "has no column `right_z`; it has frequency_hz, "),
        (MODES.replace("damping_ratio", "loss"), "has no column `damping_ratio`"),
        (MODES.replace("damping_ratio", "damping_ratio,zeta"), "has two columns for `damping_ratio`"),
        (MODES.replace("0.003", "3"), "line 3: the damping ratio of a mode must be at least 0 and below 1"),
        (
            MODES.replace("damping_ratio", "damping_ratio [Ns/m]"),
            "has column `damping_ratio [Ns/m]` in \"Ns/m\": a damping ratio has none, or %",
        ),
        (MODES.replace("mass_kg", "mass_m"), "write a unit of a mass, kg or t"),
        (MODES.replace("97.2", "0"), "line 3: the natural frequency of an elastic mode must be finite and above zero"),
        (MODES.replace("-0.4", "?"), "line 3: column `right_y` is \"?\", not a number"),
        (MODES.replace("-0.4", "inf"), "line 3: column `right_y` is inf, but must be finite"),
        (format!("{MODES}residual,,,0,0,0,0,0,0\nresidual,,,0,0,0,0,0,0\n"), "has 2 rows `residual`: give one"),
        (
            MODES.to_owned() + "residual,,,1e-10,0,0,2e-11,0,0\n" + &"residual,,,0,0,0,0,0,0\n".repeat(5),
            "a residual compliance must be finite and symmetric",
        ),
        ("78.6,0.002,55,1,0,0,-1,0,0\n".to_owned(), "has no header: its columns need names above them"),
        (MODES.lines().next().unwrap().to_owned(), "has no mode below its header"),
    ] {
        let error = parse(&file).err().unwrap();
        assert!(error.contains(sentence), "{error}");
    }
}
