//! Blind changes to a file: such as an editor, another program or another country makes, and such as nobody makes.

/// Numbers from a seed, by the generator SplitMix64 (Steele, Lea & Flood 2014).
pub(super) struct Chance(pub(super) u64);

impl Chance {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `end`; 0 for an `end` of 0.
    pub(super) fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }

    pub(super) fn one_of<'a, T: ?Sized>(&mut self, choices: &[&'a T]) -> &'a T {
        choices[self.below(choices.len())]
    }
}

/// What stands in place of a number.
const NUMBERS: [&str; 22] = [
    "0",
    "-1",
    "1e-320",
    "1e308",
    "-1e308",
    "nan",
    "inf",
    "-inf",
    "1e400",
    "0.1",
    "1",
    "108",
    "1_000",
    "1.234,5",
    "12+400.123",
    "99999999999999999999",
    "0x1f",
    "\"50 kN\"",
    "\"80 km/h\"",
    "\"3 furlongs\"",
    "[]",
    "true",
];
/// What stands between others.
const PIECES: [&[u8]; 14] = [
    b"\0",
    b"\x1b[31m",
    b"\xff\xfe",
    b"\xef\xbb\xbf",
    b"\xb5",
    "µ".as_bytes(),
    "Ŵ₁".as_bytes(),
    b"\r",
    b"\t",
    b";",
    b"\"",
    b"[",
    b"=",
    b"\n\n",
];

/// A file with one to eight changes.
pub(super) fn mutated(original: &[u8], chance: &mut Chance) -> Vec<u8> {
    let mut bytes = original.to_vec();
    for _ in 0..=chance.below(8) {
        change(&mut bytes, chance);
    }
    bytes
}

fn change(bytes: &mut Vec<u8>, chance: &mut Chance) {
    let at = chance.below(bytes.len());
    match chance.below(10) {
        0..=3 => change_number(bytes, at, chance),
        4 => {
            let piece = PIECES[chance.below(PIECES.len())];
            bytes.splice(at..at, piece.iter().copied());
        }
        5 => bytes.truncate(at),
        6 => {
            let line = line_at(bytes, at);
            bytes.drain(line);
        }
        7 => {
            let line = bytes[line_at(bytes, at)].to_vec();
            let times = 1 + chance.below(50);
            bytes.splice(at..at, line.repeat(times));
        }
        8 => {
            let [from, to] = chance.one_of(&[b".,", b",;", b",\t", b"\n\r", b"= ", b"eE"]);
            bytes
                .iter_mut()
                .filter(|byte| *byte == from)
                .for_each(|byte| *byte = *to);
        }
        _ => {
            if let Some(byte) = bytes.get_mut(at) {
                *byte = chance.below(256) as u8;
            }
        }
    }
}

/// Another number in place of the first one from `at` on.
fn change_number(bytes: &mut Vec<u8>, at: usize, chance: &mut Chance) {
    let is_part = |byte: &u8| byte.is_ascii_digit() || b"+-.eE".contains(byte);
    let Some(start) = bytes[at..]
        .iter()
        .position(u8::is_ascii_digit)
        .map(|found| at + found)
    else {
        return;
    };
    let length = bytes[start..]
        .iter()
        .take_while(|byte| is_part(byte))
        .count();
    let other = chance.one_of(&NUMBERS);
    bytes.splice(start..start + length, other.bytes());
}

/// The line around a place, with its end.
fn line_at(bytes: &[u8], at: usize) -> std::ops::Range<usize> {
    let before = bytes[..at].iter().rposition(|&byte| byte == b'\n');
    let after = bytes[at..].iter().position(|&byte| byte == b'\n');
    before.map_or(0, |place| place + 1)..after.map_or(bytes.len(), |place| at + place + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_repeats_its_mutations_and_nothing_is_too_short_for_them() {
        let original = b"friction = 0.4\nload = 50e3\n";
        let all = |seed| (0..200).scan(Chance(seed), |chance, _| Some(mutated(original, chance)));
        assert!(all(1).eq(all(1)) && !all(1).eq(all(2)));
        assert!(all(1).filter(|bytes| bytes != original).count() > 150);
        let mut chance = Chance(3);
        for _ in 0..500 {
            mutated(b"", &mut chance);
            mutated(b"1", &mut chance);
        }
    }
}
