//! Binary datasets: layouts, and damage.

use riffel::Complex64;

use super::{POINTS, SMALL, SMALL_DATA, only_function, sentence};
use crate::universal_file::read;

/// A dataset 58b of the three points with abscissae of the given width.
pub(in crate::universal_file) fn binary(data_type: i32, even: bool, order: i32, abscissa: usize, end: &str) -> Vec<u8> {
    let double = data_type == 4 || data_type == 6;
    let mut data = Vec::new();
    let mut push = |value: f64, width| match (width, order) {
        (4, 1) => data.extend((value as f32).to_le_bytes()),
        (4, _) => data.extend((value as f32).to_be_bytes()),
        (_, 1) => data.extend(value.to_le_bytes()),
        _ => data.extend(value.to_be_bytes()),
    };
    for [x, real, imaginary] in POINTS {
        let ordinate = if double { 8 } else { 4 };
        if !even {
            push(x, abscissa);
        }
        push(real, ordinate);
        if data_type >= 5 {
            push(imaginary, ordinate);
        }
    }
    let name = format!("    58b{order:6}     2          11{:12}     0     0           0           0", data.len());
    let form = format!("{data_type:10}         3{:10}  2.00000e+01  2.00000e+01  0.00000e+00", i32::from(even));
    let header =
        SMALL.replacen("    58", &name, 1).replacen(&SMALL[SMALL.find("         5  ").unwrap()..][..69], &form, 1);
    let header = &header[..header.find(SMALL_DATA).unwrap()];
    [header.as_bytes(), &data, end.as_bytes(), b"    -1\n"].concat()
}

/// Both byte orders, all layouts, the abscissa single as defined or as wide as the ordinate, and the
/// closing mark behind the data at once or on its own line.
#[test]
fn reads_binary_layouts() {
    for data_type in [2, 4, 5, 6] {
        for even in [true, false] {
            for order in [1, 2] {
                for abscissa in [4, 8] {
                    let single = data_type == 2 || data_type == 5;
                    if single && abscissa == 8 {
                        continue;
                    }
                    let complex = data_type >= 5;
                    let ordinate = POINTS.map(|[_, real, imaginary]| match complex {
                        true => Complex64::new(real, imaginary),
                        false => real.into(),
                    });
                    let last = if even { 60.0 } else { 80.0 };
                    for end in ["", "\n", "\r\n"] {
                        let bytes = binary(data_type, even, order, abscissa, end);
                        let function = only_function(read(&bytes).unwrap());
                        assert_eq!(function.complex, complex);
                        assert_eq!(function.abscissa, [20.0, 40.0, last]);
                        assert_eq!(function.ordinate, ordinate);
                    }
                }
            }
        }
    }
}

#[test]
fn refuses_damaged_binary() {
    for row in [
        "58b     1 => 58b     3 => line 2: the byte order must be 1 or 2, not 3",
        "     2          11 =>      1          11 => line 2: the floating point format must be 2, not 1",
        "          11 =>           12 => line 2: the number of lines before the binary data must be 11, not 12",
        "          48 =>           47 => line 2: the number of bytes is 47, but the points take 48",
        "         6         3 =>          6         4 => line 9: the number of points is 4, which takes 64 bytes, but the closing -1 does not follow them",
        "         6         3 =>          62147483647 => line 9: the number of points is 2147483647, which takes 34359738352 bytes, but the closing -1 does not follow them",
        "         6         3 =>          5         3 => line 9: the number of points is 3, which takes 24 bytes, but the closing -1 does not follow them",
    ] {
        let [from, to, expected] = row.split(" => ").collect::<Vec<_>>()[..] else { panic!("{row}") };
        let bytes = binary(6, true, 1, 8, "");
        let at = bytes.windows(from.len()).position(|window| window == from.as_bytes()).unwrap();
        let mut damaged = bytes.clone();
        damaged.splice(at..at + from.len(), to.bytes());
        assert_eq!(sentence(&damaged), expected);
    }
}

#[test]
fn refuses_binary_values_that_are_not_numbers() {
    let bytes = binary(6, true, 1, 8, "");
    let data = bytes.len() - b"    -1\n".len() - 48;
    let mut damaged = bytes.clone();
    damaged[data..data + 8].copy_from_slice(&f64::NAN.to_le_bytes());
    assert_eq!(sentence(&damaged), "line 14: a value must be a finite number, not \"NaN\"");
}
