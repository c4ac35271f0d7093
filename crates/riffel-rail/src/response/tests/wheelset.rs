//! Measured receptances of wheelsets.

use riffel::Rail;
use riffel::wheelset::Wheelset;

use super::modes::modal;
use super::*;

/// The receptances of a text, of one wheel on the right rail.
fn parse(text: &str) -> Result<WheelsetReceptances, String> {
    WheelsetReceptances::parse(text, Rail::Right).map_err(|error| error.message.to_string())
}

fn told(text: &str) -> Vec<String> {
    parse(text).unwrap().remarks.iter().map(ToString::to_string).collect()
}

/// One wheel as mobilities in decibels with phases, separated by semicolons, is both wheels without what joins them.
#[test]
fn one_wheel_stands_for_both() {
    let wheelset = modal(None);
    // 40 frequencies from 20 to 600 Hz.
    let lines = || (0..40).map(|step| 20.0 * 30f64.powf(f64::from(step) / 39.0));
    let entries = [("xx", 3, 3), ("yy", 4, 4), ("zz", 5, 5), ("zy", 5, 4)];
    let mut text = "f [kHz]".to_owned();
    for (name, ..) in entries {
        text += &format!(";|{name}| modulus [dB re 1 mm/s/kN];{name}_phase_deg");
    }
    text += "\n";
    for frequency in lines() {
        let w = TAU * frequency;
        let h = wheelset.receptances(w);
        text += &(1e-3 * frequency).to_string();
        for (_, row, column) in entries {
            let mobility = h[row][column] * Complex64::new(0.0, w);
            let decibels = 20.0 * (1e6 * mobility.norm()).log10();
            text += &format!(";{decibels};{}", mobility.arg().to_degrees());
        }
        text += "\n";
    }
    // Bars are no part of a name.
    let text = text.replace('|', "").replace('.', ",");
    let measured = parse(&text).unwrap().wheelset;
    for frequency in lines() {
        let w = TAU * frequency;
        let (got, expected) = (measured.receptances(w), wheelset.receptances(w));
        for (_, row, column) in entries {
            let expected = expected[row][column];
            let error = |got: Complex64| (got - expected).norm() / expected.norm();
            assert!(error(got[row][column]) < 1e-11);
            assert!(error(got[column][row]) < 1e-11);
            // The mirror image.
            let sign = if row == column { 1.0 } else { -1.0 };
            assert!(error(sign * got[row - 3][column - 3]) < 1e-11);
        }
        assert_eq!(got[0][3], Complex64::ZERO);
    }
}

const ONE_ENTRY: &str = "frequency_hz,zz_re,zz_im\n20,-1e-8,-1e-10\n40,-1e-8,-1e-10\n80,-1e-8,-1e-10\n160,-1e-8,-1e-10\n320,-1e-8,-1e-10\n600,-1e-8,-1e-10\n";

/// What is measured but cannot be true is said, with how far, where, and at what.
#[test]
fn doubts_are_remarks() {
    for (file, sentence) in [
        (ONE_ENTRY.to_owned(), "column `zz_re` names no unit: taken as a receptance in m/N"),
        (ONE_ENTRY.to_owned(), "the wheelset was not measured along x, y: there it is taken as rigid"),
        (
            ONE_ENTRY.replace("80,-1e-8,-1e-10", "80,-1e-8,3e-10"),
            "gives energy away, by up to 3.00 % of its largest receptance, at 80.0 Hz, most at right_z",
        ),
        (
            "f [Hz],left_y_left_z_re [m/N],left_y_left_z_im,left_z_left_y_re [m/N],left_z_left_y_im\n\
     20,1e-9,0,1e-9,0\n40,1e-9,0,0.9e-9,0\n80,1e-9,0,1e-9,0\n160,1e-9,0,1e-9,0\n320,1e-9,0,1e-9,0\n600,1e-9,0,1e-9,0\n"
                .to_owned(),
            "is not reciprocal: left_z by a force at left_y and the reverse differ by up to 10.00 %, at 40.0 Hz",
        ),
    ] {
        let said = told(&file);
        assert!(said.iter().any(|remark| remark.contains(sentence)), "{said:?}");
    }
}

/// Numbers as they round to four digits raise no doubt.
#[test]
fn rounding_raises_no_doubt() {
    let file = "f [Hz],left_x_left_x_re [m/N],left_x_left_x_im,left_x_right_x_re [m/N],left_x_right_x_im,\
                right_x_right_x_re [m/N],right_x_right_x_im\n\
                20,-1.235e-8,0,-1.234e-8,0.001e-8,-1.235e-8,0\n40,-1.235e-8,0,-1.234e-8,0,-1.235e-8,0\n";
    assert!(!told(file).iter().any(|remark| remark.contains("gives energy")));
}

#[test]
fn refuses_what_is_no_measured_wheelset() {
    for (file, sentence) in [
        (
            ONE_ENTRY.replace(",-1e-10", ",1e-10"),
            "z: the receptance gives energy away (Im H > 0) at 6 of 6 frequencies: it is conjugated",
        ),
        (
            ONE_ENTRY.replace("zz_im", "zz_imaginery"),
            "has column `zz_imaginery`, which is no frequency and no part of a receptance",
        ),
        (
            ONE_ENTRY.replace("zz_im", "yy_im"),
            "has zz_re of a receptance, which needs its real and imaginary part, or its modulus and phase",
        ),
        (ONE_ENTRY.replace("zz_im", "zz_real"), "has two columns for one quantity: `zz_re`, `zz_real`"),
        (
            "frequency_hz,zz_re,zz_im,left_x_left_x_re,left_x_left_x_im\n20,1,0,1,0\n40,1,0,1,0\n".to_owned(),
            "has receptances of one wheel and of both: `zz_re`, `left_x_left_x_re`",
        ),
        ("frequency_hz,frequency\n20,1\n40,1\n".to_owned(), "has two columns for one quantity"),
        ("zz_re,zz_im\n20,1\n40,1\n".to_owned(), "names no frequency; it has zz_re, zz_im"),
        (
            ONE_ENTRY.replace("zz_re", "zz_re [m/s]"),
            "has column `zz_re [m/s]` in \"m/s\": write m/N, m/s/N, m/s2/N or the like",
        ),
        (
            ONE_ENTRY.replace("zz_re", "zz_re [dB re 1 m/N]"),
            "has column `zz_re [dB re 1 m/N]` in \"dB re 1 m/N\": write m/N",
        ),
        (
            "frequency_hz,zz_modulus,zz_phase\n20,1e-8,90\n40,1e-8,90\n".to_owned(),
            "has column `zz_phase` without its unit: write `zz_phase [deg]` or `zz_phase [rad]`",
        ),
        (
            "frequency_hz,zz_modulus,zz_phase_deg\n20,1e-8,90\n40,-1e-8,90\n".to_owned(),
            "line 3: column `zz_modulus` is -0.00000001, but a modulus is not negative",
        ),
        (ONE_ENTRY.replace("80,-1e-8", "80,x"), "line 4: column `zz_re` is \"x\", not a number"),
        (ONE_ENTRY.replace("80,-1e-8,-1e-10\n", ""), "nothing between 40 Hz and 160 Hz"),
        (ONE_ENTRY.replace("frequency_hz", "frequency [m]"), "in \"m\": write a unit of a frequency"),
        (String::new(), "is empty"),
    ] {
        let error = parse(&file).err().unwrap();
        assert!(error.contains(sentence), "{error}");
    }
}
