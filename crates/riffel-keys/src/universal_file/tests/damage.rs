//! Files that are cut short or changed anywhere.

use proptest::prelude::*;
use proptest::sample::Index;

use super::binary::binary;
use super::{FIXTURES, MILLIMETRES, SMALL, fixture};
use crate::universal_file::read;

/// However a file of one function is cut, it is refused.
// Long: reads a file as often as it has places.
#[test]
fn refuses_every_truncation() {
    for name in FIXTURES.iter().filter(|&&name| name != "several.uff") {
        let bytes = fixture(name);
        let mark = bytes.len() - b"\n".len();
        // Lines have 80 places: with a step of 7 every place of one is an end somewhere.
        let step = if mark > 4000 { 7 } else { 1 };
        for end in (0..mark).step_by(step) {
            assert!(read(&bytes[..end]).is_err(), "{name} cut at {end}");
        }
        assert!(read(&bytes[..mark]).is_ok());
    }
}

/// Nothing but finite points that the bytes have room for comes from any input.
fn check(bytes: &[u8]) {
    let Ok(file) = read(bytes) else { return };
    let mut points = 0;
    for function in &file.functions {
        points += function.abscissa.len();
        assert_eq!(function.abscissa.len(), function.ordinate.len());
        assert!(function.abscissa.iter().all(|value| value.is_finite()));
        assert!(function.ordinate.iter().all(|value| value.is_finite()));
    }
    assert!(points <= bytes.len());
}

/// One damage to a file: bytes from one place on are replaced by others.
fn damage() -> impl Strategy<Value = (Index, usize, Vec<u8>)> {
    let bytes = prop_oneof![
        prop::collection::vec(any::<u8>(), 0..8),
        prop::collection::vec(prop::sample::select(b"0123456789.+-eEdD \r\nb".to_vec()), 0..8),
        Just(b"    -1\n".to_vec()),
        Just(b"2147483647".to_vec()),
        Just("µ".as_bytes().to_vec()),
    ];
    (any::<Index>(), 0..40usize, bytes)
}

proptest! {
    #[test]
    fn survives_any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..2000)) {
        check(&bytes);
    }

    /// Lines that look like those of a universal file, in any order.
    #[test]
    fn survives_any_lines(lines in prop::collection::vec(
        prop_oneof![
            prop::sample::select(SMALL.lines().chain(MILLIMETRES.lines()).collect::<Vec<_>>())
                .prop_map(str::to_owned),
            "[ 0-9.eED+-]{0,90}",
            ".{0,90}",
        ],
        0..40,
    )) {
        check(lines.join("\n").as_bytes());
    }

    #[test]
    fn survives_damage(
        name in prop::sample::select(FIXTURES.to_vec()),
        damages in prop::collection::vec(damage(), 1..4),
    ) {
        let mut bytes = fixture(name);
        for (at, removed, inserted) in damages {
            let at = at.index(bytes.len());
            let end = (at + removed).min(bytes.len());
            bytes.splice(at..end, inserted);
            if bytes.is_empty() {
                break;
            }
        }
        check(&bytes);
    }

    /// Damage within the header, where it means most.
    #[test]
    fn survives_damaged_headers(
        data_type in prop::sample::select(vec![2, 4, 5, 6]),
        even: bool,
        text: bool,
        at in 0..700usize,
        removed in 0..4usize,
        inserted in prop::collection::vec(any::<u8>(), 0..4),
    ) {
        let mut bytes = match text {
            true => SMALL.as_bytes().to_vec(),
            false => binary(data_type, even, 1, 4, ""),
        };
        let at = at.min(bytes.len());
        let end = (at + removed).min(bytes.len());
        bytes.splice(at..end, inserted);
        check(&bytes);
    }
}
