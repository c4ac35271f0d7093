//! What stands above the numbers: names of columns, their units, and remarks.

use super::delimiter::Delimiter;
use super::length::{ends_in_inches, foreign_unit, is_one_of, length_in, length_word, words};
use super::line::{cells, cells_up_to};
use crate::printable::printable;
use crate::text_file::text_of;

/// Names and units of the columns.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Heading {
    /// Names, if a line has them.
    pub names: Option<Vec<String>>,
    /// Cells of a line of units of its own.
    pub(super) units: Option<Vec<String>>,
    /// The other lines above the numbers, each with its number from 1.
    pub remarks: Vec<(usize, String)>,
}

impl Heading {
    /// The head of one column.
    pub fn of_name(name: &str) -> Self {
        Self { names: Some(vec![name.to_owned()]), ..Self::default() }
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
                names_of(line, delimiter, count, |cells| {
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
            let has_words = |cell: &String| cell.contains(char::is_alphabetic);
            if cells.iter().any(has_words) {
                heading.names = Some(cells);
                taken.push(index);
                break;
            }
            nearest = false;
        }
        let others = above.iter().enumerate().filter(|(index, _)| !taken.contains(index));
        heading.remarks = others.map(|(index, line)| (index + 1, text_of(without_mark(line)))).collect();
        heading
    }

    /// Name of a column, counted from zero.
    pub fn name(&self, column: usize) -> Option<&str> {
        self.names.as_ref()?.get(column).map(String::as_str)
    }

    /// Unit of length that the head of a column gives.
    pub fn unit_of(&self, column: usize) -> Option<&'static str> {
        let row = self.unit_below(column).and_then(length_in);
        row.or_else(|| length_in(self.name(column)?))
    }

    /// Unit that the head of a column gives and that is no length known here, as it is written there.
    pub fn foreign_unit_of(&self, column: usize) -> Option<String> {
        match self.unit_below(column) {
            Some(unit) => length_in(unit).is_none().then(|| unit.trim_matches(['[', ']', '(', ')']).trim().to_owned()),
            None => foreign_unit(self.name(column)?),
        }
    }

    /// What a line of units has for a column.
    pub fn unit_below(&self, column: usize) -> Option<&str> {
        let unit = self.units.as_ref()?.get(column)?.as_str();
        unit.contains(char::is_alphanumeric).then_some(unit)
    }

    /// Whether the name of a column has one of these words, divided by bars; a word of more than four letters may go on.
    pub fn is(&self, column: usize, known: &str) -> bool {
        let own = words(self.name(column).unwrap_or_default());
        own.iter().any(|own| {
            let mut known = known.split('|');
            known.any(|word| own == word || word.len() > 4 && own.starts_with(word))
        })
    }

    /// The name of a column without its unit of length; its number where nothing is left.
    pub fn bare_name(&self, column: usize) -> String {
        let mut words = words(self.name(column).unwrap_or_default());
        if ends_in_inches(&words) {
            words.pop();
        }
        words.retain(|word| length_word(word).is_none());
        match words.is_empty() {
            true => format!("column {}", column + 1),
            false => words.join(" "),
        }
    }
}

/// A line without the signs that make it a remark.
fn without_mark(line: &[u8]) -> &[u8] {
    let marks = line.iter().take_while(|byte| matches!(byte, b'#' | b'%'));
    &line[marks.count()..]
}

/// Whether a line speaks of units in words, as in "heights are in mm", rather than naming columns.
fn is_sentence(line: &[u8]) -> bool {
    const WORDS: &str = "in|are|is|of|sind|ist|von|en|unit|units|einheit|einheiten";
    let text = text_of(line);
    text.contains(": ") || words(&text).iter().any(|word| is_one_of(word, WORDS))
}

/// Cells of a line of names, if their number fits. With blanks between columns, names may have blanks of their own:
/// two blanks divide, or a unit in brackets belongs to the name before it.
fn names_of(line: &[u8], delimiter: Delimiter, count: usize, fits: impl Fn(usize) -> bool) -> Option<Vec<String>> {
    let text = |cells: Vec<&[u8]>| -> Vec<String> { cells.into_iter().map(label).collect() };
    if delimiter != Delimiter::Space {
        // A delimiter at the end of the line may begin a column or none.
        return [cells(line, delimiter), cells_up_to(line, delimiter, count)]
            .into_iter()
            .find(|cells| fits(cells.len()))
            .map(text);
    }
    let plain = text(cells(line, delimiter));
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
    [joined, wide, plain].into_iter().find(|names| fits(names.len()))
}

/// Whether every cell is a unit or empty, as in "m;µm;µm" or "[m] [mm]".
fn is_row_of_units(cells: &[String]) -> bool {
    const OTHERS: &str = "s|h|hz|db|v|g|c|deg|km/h|m/s|m/s2|m/s²";
    let is_unit = |cell: &String| {
        let written = cell.to_lowercase();
        let written = written.trim_matches(|c: char| "[]() -".contains(c));
        let written = written.replace("_per_", "/").replace([' ', '_', '^'], "");
        written.is_empty() || written == "in" || length_word(&written).is_some() || is_one_of(&written, OTHERS)
    };
    cells.iter().all(is_unit) && cells.iter().any(|cell| length_in(cell).is_some())
}

/// What columns a table has, as the end of a sentence: "it has f, re, im".
pub fn it_has(names: &[String]) -> String {
    let named: Vec<&str> = names.iter().map(String::as_str).filter(|name| !name.is_empty()).collect();
    match &named[..] {
        [] => "it has no names of columns".to_owned(),
        named => format!("it has {}", named.join(", ")),
    }
}

/// Text of a cell without quotes.
pub fn label(cell: &[u8]) -> String {
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
    fn no_sentence_ends_in_an_empty_list() {
        let has = |names: &[&str]| it_has(&names.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>());
        assert_eq!(has(&["f", "", "re"]), "it has f, re");
        for none in [&[][..], &[""], &["", ""]] {
            assert_eq!(has(none), "it has no names of columns");
        }
    }

    #[test]
    fn sentences_are_no_names() {
        let heading = heading("# heights in mm", Delimiter::Space, 3);
        assert_eq!(heading.name(0), None);
        assert_eq!(heading.remarks, [(1, " heights in mm".to_owned())]);
    }

    #[test]
    fn units_have_a_line_of_their_own() {
        let heading = heading("Weg;links;rechts\n[m];[µm];[µm]\n", Delimiter::Semicolon, 3);
        assert_eq!(heading.name(1), Some("links"));
        assert_eq!((heading.unit_of(0), heading.unit_of(2)), (Some("m"), Some("um")));
    }

    #[test]
    fn names_have_blanks() {
        let joined = heading("position [m] height (mm)", Delimiter::Space, 2);
        assert_eq!((joined.name(0), joined.unit_of(1)), (Some("position [m]"), Some("mm")));
        let wide = heading("distance along rail   rail height mm", Delimiter::Space, 2);
        assert_eq!((wide.name(0), wide.unit_of(1)), (Some("distance along rail"), Some("mm")));
    }
}
