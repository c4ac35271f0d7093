//! What stands above the numbers: names of columns, their units, and remarks that give units.

use riffel_keys::Unit;
use riffel_keys::text_file::{printable, text_of};

use crate::format::Delimiter;
use crate::rows::cells;

/// Names and units of the columns.
#[derive(Debug, PartialEq, Default)]
pub(super) struct Heading {
    /// Names, if a line has them.
    pub(super) names: Option<Vec<String>>,
    /// Cells of a line of units of its own.
    units: Option<Vec<String>>,
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
    /// The head of one column.
    pub(super) fn of_name(name: &str) -> Self {
        Self {
            names: Some(vec![name.to_owned()]),
            ..Self::default()
        }
    }

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
                heading.units = Some(cells);
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

    /// Unit of length that the head of a column gives.
    pub(super) fn unit_of(&self, column: usize) -> Option<&'static str> {
        let row = self.unit_below(column).and_then(length_in);
        row.or_else(|| length_in(self.name(column)?))
    }

    /// Unit that the head of a column gives and that is no length known here, as it is written there.
    pub(super) fn foreign_unit_of(&self, column: usize) -> Option<String> {
        match self.unit_below(column) {
            Some(unit) => length_in(unit)
                .is_none()
                .then(|| unit.trim_matches(['[', ']', '(', ')']).trim().to_owned()),
            None => foreign_unit(self.name(column)?),
        }
    }

    /// What a line of units has for a column.
    pub(super) fn unit_below(&self, column: usize) -> Option<&str> {
        let unit = self.units.as_ref()?.get(column)?.as_str();
        unit.contains(char::is_alphanumeric).then_some(unit)
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
        let mut tokens = tokens(self.name(column).unwrap_or_default());
        if ends_in_inches(&tokens) {
            tokens.pop();
        }
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

/// The unit of length that a word is, wherever it stands. "in" is one at the end of a name only.
fn unit(word: &str) -> Option<&'static str> {
    const UNITS: [(&str, &[&str]); 12] = [
        ("m", &["m", "meter", "metre", "meters", "metres"]),
        (
            "km",
            &["km", "kilometer", "kilometre", "kilometers", "kilometres"],
        ),
        ("dm", &["dm", "decimeter", "decimetre", "dezimeter"]),
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
        ("in", &["inch", "inches", "zoll"]),
        ("ft", &["ft", "foot", "feet"]),
        ("yd", &["yd", "yard", "yards"]),
        ("mi", &["mi", "mile", "miles"]),
        ("mil", &["mil", "mils", "thou", "thous"]),
    ];
    let known = UNITS.iter().find(|(_, words)| words.contains(&word));
    known.map(|(unit, _)| *unit)
}

/// Whether a name ends in "in", as in "left [in]" or "height_in".
fn ends_in_inches(tokens: &[String]) -> bool {
    tokens.last().is_some_and(|last| last == "in")
}

/// The unit of length in the name of a column or in a cell of a line of units: the last of several.
pub(super) fn length_in(name: &str) -> Option<&'static str> {
    let tokens = tokens(name);
    if ends_in_inches(&tokens) {
        return Some("in");
    }
    tokens.iter().rev().find_map(|token| unit(token))
}

/// What the name of a column gives as its unit and is no length known here, as it is written: what stands in brackets,
/// or a last word that is a unit.
pub(super) fn foreign_unit(name: &str) -> Option<String> {
    /// Units at the end of a name, as in "t_s".
    const AT_THE_END: [&str; 16] = [
        "s", "sec", "ms", "min", "hz", "khz", "db", "dba", "deg", "rad", "rpm", "kmh", "mph",
        "kph", "pa", "upa",
    ];
    /// Units that are no other word.
    const ALWAYS: [&str; 6] = ["furlong", "furlongs", "fuss", "fuß", "hm", "hectometre"];
    let words = tokens(name);
    let other =
        |word: &String| AT_THE_END.contains(&word.as_str()) || ALWAYS.contains(&word.as_str());
    for (open, close) in [('[', ']'), ('(', ')')] {
        let groups = name.split(open).skip(1);
        for (inside, _) in groups.filter_map(|group| group.split_once(close)) {
            let inside = inside.trim();
            let words = tokens(inside);
            let lengths = words.iter().filter(|word| unit(word).is_some()).count();
            let is_product = inside.contains(|c: char| c.is_numeric() || "/·*^".contains(c));
            // "[mm]" and "(mm, filtered)", but not "[10 um]" nor "[µm/m]".
            if lengths == 1 && !is_product || words == ["in"] {
                continue;
            }
            let names_a_unit = lengths > 0
                || words.iter().any(other)
                || !inside.is_empty() && Unit::parse(inside).is_ok();
            // Square brackets are for units; round ones are for remarks, too.
            let has_a_sign = inside.contains(|c: char| c.is_alphabetic() || "°%‰".contains(c));
            if has_a_sign && (open == '[' || names_a_unit) {
                return Some(inside.to_owned());
            }
        }
    }
    if length_in(name).is_some() {
        return None;
    }
    let last = words.last()?;
    let is_unit = ALWAYS.contains(&last.as_str()) || words.len() > 1 && other(last);
    let written = name.trim_end_matches(|c: char| !c.is_alphanumeric());
    let begin = written.rfind(|c: char| !c.is_alphanumeric());
    is_unit.then(|| written[begin.map_or(0, |at| at + 1)..].to_owned())
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
        joined.is_empty()
            || joined == "in"
            || unit(&joined).is_some()
            || OTHERS.contains(&joined.as_str())
    };
    cells.iter().all(is_unit) && cells.iter().any(|cell| length_in(cell).is_some())
}

/// Text of a cell without quotes.
fn words(cell: &[u8]) -> String {
    let text = text_of(cell);
    printable(text.trim_matches(['"', '\'']).trim()).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heading(text: &str, delimiter: Delimiter, count: usize) -> Heading {
        let lines: Vec<&[u8]> = text.lines().map(str::as_bytes).collect();
        Heading::read(&lines, delimiter, count, count)
    }

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
    fn heads_give_units() {
        for (name, length, foreign) in [
            ("x [ft]", Some("ft"), None),
            ("left_in", Some("in"), None),
            ("Höhe [Zoll]", Some("in"), None),
            ("height (thou)", Some("mil"), None),
            ("Miles", Some("mi"), None),
            ("x [dm]", Some("dm"), None),
            ("distance in metres", Some("m"), None),
            ("z (mm, filtered)", Some("mm"), None),
            ("height [furlong]", None, Some("furlong")),
            ("Weg [Fuss]", None, Some("Fuss")),
            ("x [hm]", None, Some("hm")),
            ("left [°]", None, Some("°")),
            ("left (dB)", None, Some("dB")),
            ("left [10 um]", Some("um"), Some("10 um")),
            ("slope [µm/m]", Some("m"), Some("µm/m")),
            ("t_s", None, Some("s")),
            ("s", None, None),
            ("rail (left)", None, None),
            ("z[0]", None, None),
            ("[2Jz um", Some("um"), None),
        ] {
            assert_eq!(length_in(name), length);
            assert_eq!(foreign_unit(name).as_deref(), foreign);
        }
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
