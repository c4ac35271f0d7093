//! What stands above the numbers: names of columns, their units, and remarks that give units.

use riffel_keys::text_file::{printable, text_of};

use crate::format::Delimiter;
use crate::rows::cells;

/// Names and units of the columns.
#[derive(Debug, PartialEq, Default)]
pub(super) struct Heading {
    /// Names, if a line has them.
    pub(super) names: Option<Vec<String>>,
    /// Units of a line of its own.
    units: Option<Vec<Option<&'static str>>>,
    /// Unit of the heights by a remark.
    heights: Option<Stated>,
    /// Unit of the positions by a remark.
    positions: Option<Stated>,
}

/// A unit that a remark gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stated {
    pub(super) unit: &'static str,
    /// From 1.
    pub(super) line: usize,
}

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
}

impl Heading {
    /// What the lines above a table of `count` columns say, of which rows may have up to `widest` cells.
    pub(super) fn read(above: &[&[u8]], delimiter: Delimiter, count: usize, widest: usize) -> Self {
        let mut heading = Self::default();
        let mut nearest = true;
        let mut taken = Vec::new();
        for (index, line) in above.iter().enumerate().rev() {
            let marked = without_mark(line).len() < line.len();
            let line = without_mark(line);
            if line.trim_ascii().is_empty() {
                continue;
            }
            let names = if (marked || delimiter == Delimiter::Space) && is_sentence(line) {
                None
            } else {
                names_of(line, delimiter, |cells| {
                    let loose = nearest && cells > count && delimiter != Delimiter::Space;
                    cells == count || cells == widest || loose
                })
            };
            let Some(cells) = names else {
                nearest = false;
                continue;
            };
            if heading.units.is_none() && is_row_of_units(&cells) {
                heading.units = Some(cells.iter().map(|cell| unit_in(&tokens(cell))).collect());
                taken.push(index);
                // Names are looked for right above.
                continue;
            }
            if cells
                .iter()
                .any(|cell| cell.chars().any(char::is_alphabetic))
            {
                heading.names = Some(cells);
                taken.push(index);
                break;
            }
            nearest = false;
        }
        for (index, line) in above.iter().enumerate() {
            if !taken.contains(&index) {
                heading.read_remark(&text_of(without_mark(line)), index + 1, count);
            }
        }
        heading
    }

    /// Name of a column, counted from zero.
    pub(super) fn name(&self, column: usize) -> Option<&str> {
        self.names.as_ref()?.get(column).map(String::as_str)
    }

    /// Unit that the head of a column gives.
    pub(super) fn unit_of(&self, column: usize) -> Option<&'static str> {
        let row = self.units.as_ref().and_then(|units| *units.get(column)?);
        row.or_else(|| unit_in(&tokens(self.name(column)?)))
    }

    /// Unit that a remark gives.
    pub(super) fn stated(&self, kind: Kind) -> Option<Stated> {
        match kind {
            Kind::Height => self.heights,
            Kind::Position => self.positions,
        }
    }

    /// Whether the name of a column has one of these words.
    pub(super) fn is(&self, column: usize, words: &[&str]) -> bool {
        let Some(name) = self.name(column) else {
            return false;
        };
        tokens(name).iter().any(|token| {
            words
                .iter()
                .any(|word| token == word || (word.len() > 4 && token.starts_with(word)))
        })
    }

    /// What the head calls a rail, without its unit.
    pub(super) fn rail_name(&self, column: usize) -> String {
        let tokens = tokens(self.name(column).unwrap_or_default());
        let kept: Vec<String> = tokens
            .into_iter()
            .filter(|token| unit(token).is_none())
            .collect();
        if kept.is_empty() {
            format!("column {}", column + 1)
        } else {
            kept.join(" ")
        }
    }

    /// "heights in mm", "Position in m, Höhe [µm]" and, in the order of the columns, "units: m, mm".
    fn read_remark(&mut self, remark: &str, line: usize, count: usize) {
        let mut in_order = Vec::new();
        let mut by_kind = false;
        for clause in remark.split([',', ';', '|', '\t']) {
            let tokens = tokens(clause);
            for (place, token) in tokens.iter().enumerate() {
                // A unit behind a number belongs to it.
                let of_number =
                    place > 0 && tokens[place - 1].ends_with(|c: char| c.is_ascii_digit());
                let Some(unit) = unit(token).filter(|_| !of_number) else {
                    continue;
                };
                in_order.push(unit);
                let before = tokens[..place].iter().rev().find_map(|token| kind(token));
                let kind = before.or_else(|| tokens[place..].iter().find_map(|token| kind(token)));
                if let Some(kind) = kind {
                    by_kind = true;
                    self.state(kind, Stated { unit, line });
                }
            }
        }
        let speaks_of_units = tokens(remark).iter().any(|token| {
            ["unit", "units", "einheit", "einheiten", "unité", "unités"].contains(&token.as_str())
        });
        if by_kind || !speaks_of_units {
            return;
        }
        match in_order[..] {
            [unit] => self.state(Kind::Height, Stated { unit, line }),
            [position, height, ..] if in_order.len() == count => {
                self.state(
                    Kind::Position,
                    Stated {
                        unit: position,
                        line,
                    },
                );
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

/// Whether the name of a column is that of dates.
pub(super) fn is_date(name: &str) -> bool {
    tokens(name)
        .iter()
        .any(|word| word == "date" || word == "datum")
}

/// Words of a name, in small letters.
pub(super) fn tokens(name: &str) -> Vec<String> {
    name.to_lowercase()
        .split(|c: char| !c.is_alphanumeric())
        .filter(|token| !token.is_empty())
        .map(str::to_owned)
        .collect()
}

/// The unit of length that a word is.
fn unit(word: &str) -> Option<&'static str> {
    const UNITS: [(&str, &[&str]); 5] = [
        (
            "km",
            &["km", "kilometer", "kilometre", "kilometers", "kilometres"],
        ),
        (
            "mm",
            &[
                "mm",
                "millimeter",
                "millimetre",
                "millimeters",
                "millimetres",
                "millimètres",
            ],
        ),
        ("cm", &["cm", "centimeter", "centimetre"]),
        (
            "um",
            &[
                "um",
                "µm",
                "μm",
                "micron",
                "microns",
                "micrometer",
                "micrometers",
                "micrometre",
                "micrometres",
                "mikrometer",
                "micromètres",
            ],
        ),
        ("nm", &["nm", "nanometer", "nanometre"]),
    ];
    const METRE: [&str; 5] = ["m", "meter", "metre", "meters", "metres"];
    if METRE.contains(&word) {
        return Some("m");
    }
    let known = UNITS.iter().find(|(_, words)| words.contains(&word));
    known.map(|(unit, _)| *unit)
}

/// The last unit among some words.
fn unit_in(tokens: &[String]) -> Option<&'static str> {
    tokens.iter().rev().find_map(|token| unit(token))
}

/// Whether a word of a remark speaks of heights or of positions.
fn kind(word: &str) -> Option<Kind> {
    const HEIGHTS: [&str; 16] = [
        "height",
        "heights",
        "hoehe",
        "hoehen",
        "höhe",
        "höhen",
        "hauteur",
        "amplitude",
        "amplitudes",
        "profile",
        "profil",
        "roughness",
        "rauheit",
        "rauigkeit",
        "z",
        "ordinate",
    ];
    const POSITIONS: [&str; 14] = [
        "position",
        "positions",
        "chainage",
        "station",
        "distance",
        "abscissa",
        "abszisse",
        "abscisse",
        "location",
        "weg",
        "strecke",
        "pk",
        "x",
        "kilometrierung",
    ];
    if HEIGHTS.contains(&word) {
        Some(Kind::Height)
    } else if POSITIONS.contains(&word) {
        Some(Kind::Position)
    } else {
        None
    }
}

/// A line without the signs that make it a remark.
fn without_mark(line: &[u8]) -> &[u8] {
    let marks = line.iter().take_while(|byte| matches!(byte, b'#' | b'%'));
    &line[marks.count()..]
}

/// Whether a line speaks of units in words, as in "heights are in mm", rather than naming columns.
fn is_sentence(line: &[u8]) -> bool {
    const WORDS: [&str; 12] = [
        "in",
        "are",
        "is",
        "of",
        "sind",
        "ist",
        "von",
        "en",
        "unit",
        "units",
        "einheit",
        "einheiten",
    ];
    let text = text_of(line);
    text.contains(": ")
        || tokens(&text)
            .iter()
            .any(|token| WORDS.contains(&token.as_str()))
}

/// Cells of a line of names, if their number fits. With blanks between columns, names may have blanks of their own:
/// two blanks divide, or a unit in brackets belongs to the name before it.
fn names_of(
    line: &[u8],
    delimiter: Delimiter,
    fits: impl Fn(usize) -> bool,
) -> Option<Vec<String>> {
    let text = |cells: Vec<&[u8]>| -> Vec<String> { cells.into_iter().map(words).collect() };
    let plain = text(cells(line, delimiter));
    if delimiter != Delimiter::Space {
        return fits(plain.len()).then_some(plain);
    }
    let line = text_of(line.trim_ascii());
    let wide: Vec<String> = line
        .split(['\t'])
        .flat_map(|part| part.split("  "))
        .map(str::trim)
        .filter(|part| !part.is_empty())
        .map(|part| printable(part).into_owned())
        .collect();
    let mut joined: Vec<String> = Vec::new();
    for cell in &plain {
        match joined.last_mut() {
            Some(name) if cell.starts_with(['[', '(']) => *name += &format!(" {cell}"),
            _ => joined.push(cell.clone()),
        }
    }
    [joined, wide, plain]
        .into_iter()
        .find(|names| fits(names.len()))
}

/// Whether every cell is a unit or empty, as in "m;µm;µm" or "[m] [mm]".
fn is_row_of_units(cells: &[String]) -> bool {
    const OTHERS: [&str; 10] = ["s", "h", "hz", "db", "v", "g", "c", "deg", "km h", "m s"];
    let is_unit = |cell: &String| {
        let joined = tokens(cell).join(" ");
        joined.is_empty() || unit(&joined).is_some() || OTHERS.contains(&joined.as_str())
    };
    cells.iter().all(is_unit) && cells.iter().any(|cell| unit_in(&tokens(cell)).is_some())
}

/// Text of a cell without quotes.
fn words(cell: &[u8]) -> String {
    let text = text_of(cell);
    printable(text.trim_matches(['"', '\'']).trim()).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rstest::rstest;

    fn heading(text: &str, delimiter: Delimiter, count: usize) -> Heading {
        let lines: Vec<&[u8]> = text.lines().map(str::as_bytes).collect();
        Heading::read(&lines, delimiter, count, count)
    }

    #[rstest]
    #[case("# heights in mm", Some("mm"), None)]
    #[case("# Position in m, Höhe in µm", Some("um"), Some("m"))]
    #[case("Höhen [mm]; Weg [km]", Some("mm"), Some("km"))]
    #[case("% units: m, mm", Some("mm"), Some("m"))]
    #[case("Einheit: mm", Some("mm"), None)]
    #[case("# z: micrometres", Some("um"), None)]
    #[case("# heights every 1 mm", None, None)]
    #[case("# wheel radius in mm", None, None)]
    #[case("# profile over 100 m", None, None)]
    #[case("# made in spring", None, None)]
    fn remarks_give_units(
        #[case] remark: &str,
        #[case] height: Option<&str>,
        #[case] position: Option<&str>,
    ) {
        let heading = heading(&format!("{remark}\nx;z\n"), Delimiter::Semicolon, 2);
        assert_eq!(
            heading.stated(Kind::Height).map(|stated| stated.unit),
            height
        );
        assert_eq!(
            heading.stated(Kind::Position).map(|stated| stated.unit),
            position
        );
    }

    #[test]
    fn sentences_are_no_names() {
        let heading = heading("# heights in mm", Delimiter::Space, 3);
        assert_eq!(
            (
                heading.name(0),
                heading.stated(Kind::Height).map(|stated| stated.unit)
            ),
            (None, Some("mm"))
        );
    }

    #[test]
    fn units_have_a_line_of_their_own() {
        let heading = heading("Weg;links;rechts\n[m];[µm];[µm]\n", Delimiter::Semicolon, 3);
        assert_eq!(heading.name(1), Some("links"));
        assert_eq!(
            (heading.unit_of(0), heading.unit_of(2)),
            (Some("m"), Some("um"))
        );
    }

    #[test]
    fn names_have_blanks() {
        let joined = heading("position [m] height (mm)", Delimiter::Space, 2);
        assert_eq!(
            (joined.name(0), joined.unit_of(1)),
            (Some("position [m]"), Some("mm"))
        );
        let wide = heading("distance along rail   rail height mm", Delimiter::Space, 2);
        assert_eq!(
            (wide.name(0), wide.unit_of(1)),
            (Some("distance along rail"), Some("mm"))
        );
    }
}
