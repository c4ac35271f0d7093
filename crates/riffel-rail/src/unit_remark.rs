//! Units that remarks above a profile give: "heights in mm", "Position in m, Höhe [µm]" and, in the order of the columns,
//! "units: m, mm".

use riffel_keys::table::{is_one_of, length_word, words};

/// What the numbers of a column are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Height,
    Position,
}

impl Kind {
    /// In words, and the argument that gives its unit.
    pub(super) fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Height => ("heights", "--height-unit"),
            Self::Position => ("position", "--position-unit"),
        }
    }

    /// Whether a word of a remark speaks of heights or of positions.
    fn of(word: &str) -> Option<Self> {
        const HEIGHTS: &str = "height|heights|hoehe|hoehen|höhe|höhen|hauteur|amplitude|amplitudes|profile|profil|\
                        roughness|rauheit|rauigkeit|z|ordinate";
        const POSITIONS: &str = "position|positions|chainage|station|distance|abscissa|abszisse|abscisse|location|weg|\
                        strecke|pk|x|kilometrierung";
        if is_one_of(word, HEIGHTS) { Some(Self::Height) } else { is_one_of(word, POSITIONS).then_some(Self::Position) }
    }
}

/// A unit that a remark gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stated {
    pub(super) unit: &'static str,
    /// From 1.
    pub(super) line: usize,
}

/// The units that remarks give; of several the first.
#[derive(Debug, Default)]
pub(super) struct UnitRemarks {
    heights: Option<Stated>,
    positions: Option<Stated>,
}

impl UnitRemarks {
    /// What remarks say of a table of `count` columns.
    pub(super) fn of(remarks: &[(usize, String)], count: usize) -> Self {
        let mut units = Self::default();
        for (line, remark) in remarks {
            units.read(remark, *line, count);
        }
        units
    }

    /// Unit that a remark gives.
    pub(super) fn unit(&self, kind: Kind) -> Option<Stated> {
        match kind {
            Kind::Height => self.heights,
            Kind::Position => self.positions,
        }
    }

    fn read(&mut self, remark: &str, line: usize, count: usize) {
        let mut in_order = Vec::new();
        let mut by_kind = false;
        for clause in remark.split([',', ';', '|', '\t']) {
            let words = words(clause);
            for (place, word) in words.iter().enumerate() {
                // A unit behind a number belongs to it.
                let of_number = place > 0 && words[place - 1].ends_with(|c: char| c.is_ascii_digit());
                let Some(unit) = length_word(word).filter(|_| !of_number) else {
                    continue;
                };
                in_order.push(unit);
                let before = words[..place].iter().rev().find_map(|word| Kind::of(word));
                let kind = before.or_else(|| words[place..].iter().find_map(|word| Kind::of(word)));
                if let Some(kind) = kind {
                    by_kind = true;
                    self.state(kind, Stated { unit, line });
                }
            }
        }
        const UNITS: &str = "unit|units|einheit|einheiten|unité|unités";
        let speaks_of_units = words(remark).iter().any(|word| is_one_of(word, UNITS));
        if by_kind || !speaks_of_units {
            return;
        }
        match in_order[..] {
            [unit] => self.state(Kind::Height, Stated { unit, line }),
            [position, height, ..] if in_order.len() == count => {
                let unit = position;
                self.state(Kind::Position, Stated { unit, line });
                self.state(Kind::Height, Stated { unit: height, line });
            }
            _ => {}
        }
    }

    fn state(&mut self, kind: Kind, stated: Stated) {
        let place = match kind {
            Kind::Height => &mut self.heights,
            Kind::Position => &mut self.positions,
        };
        place.get_or_insert(stated);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn remarks_give_units() {
        for (remark, height, position) in [
            ("# heights in mm", Some("mm"), None),
            ("# Position in m, Höhe in µm", Some("um"), Some("m")),
            ("Höhen [mm]; Weg [km]", Some("mm"), Some("km")),
            ("% units: m, mm", Some("mm"), Some("m")),
            ("Einheit: mm", Some("mm"), None),
            ("# z: micrometres", Some("um"), None),
            ("# heights every 1 mm", None, None),
            ("# wheel radius in mm", None, None),
            ("# profile over 100 m", None, None),
            ("# made in spring", None, None),
        ] {
            let units = UnitRemarks::of(&[(1, remark.to_owned())], 2);
            assert_eq!(units.unit(Kind::Height).map(|stated| stated.unit), height);
            assert_eq!(units.unit(Kind::Position).map(|stated| stated.unit), position);
        }
    }
}
