//! What lies along a line: curves, stations, welds and joints in a table of the user.

use std::path::Path;

use riffel_keys::CaseError;
use riffel_keys::table::{HeadedTable, Row, is_one_of, length_in, words};
use riffel_keys::text_file::{LARGEST_KEYS, decode, read_bounded};
use serde::Serialize;

use crate::length_unit::metres;
use crate::refusal::Refusal;

/// Words of the names of columns, in English and German.
const POSITION: &str = "position|place|chainage|ort|stelle|kilometrierung";
const FROM: &str = "from|begin|start|von|anfang";
const TO: &str = "to|end|bis|ende";
const KIND: &str = "kind|type|art|typ";
const NAME: &str = "name|label|bezeichnung";

/// A curve, a station, a weld, a joint or whatever its kind says, from one place of a line to another.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LinePlace {
    /// Where it begins \[m\].
    #[serde(rename = "from_m")]
    pub from: f64,
    /// Where it ends \[m\]; where it begins, if it is one place.
    #[serde(rename = "to_m")]
    pub to: f64,
    /// What it is, in the words of the table.
    pub kind: String,
    /// Its name; empty where it has none.
    pub name: String,
}

/// The columns of the table.
struct Columns {
    from: usize,
    to: usize,
    kind: usize,
    name: Option<usize>,
}

impl LinePlace {
    /// The places of a table, along the line. Its head has a column `position`, or `from` and `to`, each in metres or in the unit of
    /// its name (`from_km`) or of a row of units, a column `kind` and, if it likes, a column `name`.
    ///
    /// # Errors
    /// [`CaseError::Read`] if the file cannot be read, [`CaseError::Data`] with the line and the rule if it is no such table.
    pub fn read(path: &Path) -> Result<Vec<Self>, CaseError> {
        let refuse = |refusal: Refusal| refusal.of(path);
        let text = decode(read_bounded(path, "file", LARGEST_KEYS)?);
        let text = text.map_err(|byte| refuse(Refusal::new(Some(byte.line), byte)))?;
        parse(&text).map_err(refuse)
    }
}

fn parse(text: &str) -> Result<Vec<LinePlace>, Refusal> {
    let column = |names: &[String], list: &str| {
        let is_named = |name: &String| words(name).iter().any(|word| is_one_of(word, list));
        names.iter().position(is_named)
    };
    let find = |names: &[String]| {
        let ends = column(names, FROM).zip(column(names, TO));
        let ends = ends.or_else(|| column(names, POSITION).map(|position| (position, position)));
        let (from, to) = ends.ok_or(())?;
        Ok::<_, ()>(Columns { from, to, kind: column(names, KIND).ok_or(())?, name: column(names, NAME) })
    };
    let is_row = |columns: &Columns, row: &Row<'_>| row.number(columns.from).is_ok();
    let table = HeadedTable::find(text, find, is_row).map_err(|_| {
        Refusal::new(
            None,
            "a table of what lies along the line has a head with a column `position`, or `from` and `to`, and a column `kind`",
        )
    })?;
    let columns = &table.columns;
    let in_metres = |row: &Row<'_>, column: usize| {
        let name = &table.names[column];
        let unit = table.unit_below(column).or_else(|| length_in(name));
        let unit = unit.unwrap_or("m");
        let at = |message: String| Refusal::new(Some(row.line), message);
        let size = metres(unit).ok_or_else(|| at(format!("the column `{name}` is in {unit}, which is no length")))?;
        let value = row.number(column);
        let value = value.map_err(|end| at(format!("the column `{name}` {end}")))?;
        Ok(size * value)
    };
    let place = |row: Row<'_>| {
        let (from, to) = (in_metres(&row, columns.from)?, in_metres(&row, columns.to)?);
        let kind = row.text(columns.kind);
        if kind.is_empty() {
            let message = "the column `kind` is empty, but says what lies there";
            return Err(Refusal::new(Some(row.line), message));
        }
        Ok(LinePlace {
            // From either end of the line.
            from: from.min(to),
            to: from.max(to),
            kind,
            name: columns.name.map_or_else(String::new, |name| row.text(name)),
        })
    };
    let mut places: Vec<LinePlace> = table.rows().map(place).collect::<Result<_, Refusal>>()?;
    places.sort_by(|one, other| one.from.total_cmp(&other.from));
    Ok(places)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<Vec<LinePlace>, String> {
        parse(text).map_err(|refusal| refusal.message.to_string())
    }

    fn place(from: f64, to: f64, kind: &str, name: &str) -> LinePlace {
        LinePlace { from, to, kind: kind.to_owned(), name: name.to_owned() }
    }

    #[test]
    fn places_and_lengths_are_read_in_their_unit_along_the_line() {
        let lengths = of("from_km,to_km,kind,name\n12.4,12.1,curve,R 300\n12.0,12.05,station,Mitte\n");
        let expected = [place(12_000.0, 12_050.0, "station", "Mitte"), place(12_100.0, 12_400.0, "curve", "R 300")];
        let lengths = lengths.unwrap();
        let close = |one: f64, other: f64| (one - other).abs() < 1e-9 * other;
        for (read, expected) in lengths.iter().zip(&expected) {
            assert!(close(read.from, expected.from) && close(read.to, expected.to));
            assert_eq!((&read.kind, &read.name), (&expected.kind, &expected.name));
        }
        assert_eq!(lengths.len(), 2);
        // A German table without names; one place is where it is.
        let welds = of("Ort [m];Art\n62,5;Schweißung\n12,25;Stoß\n").unwrap();
        let expected = [place(12.25, 12.25, "Stoß", ""), place(62.5, 62.5, "Schweißung", "")];
        assert_eq!(welds, expected);
    }

    #[test]
    fn other_tables_are_refused_with_the_rule() {
        for (text, part) in [
            ("position_m,left_um\n1,2\n", "a column `kind`"),
            ("from,kind\n1,weld\n", "or `from` and `to`"),
            ("position,kind\n1,weld\nx,weld\n", "the column `position` is \"x\", not a number"),
            ("position,kind\n1,\n", "the column `kind` is empty"),
            ("position,kind\n[kg],\n1,weld\n", "is in kg, which is no length"),
        ] {
            let refusal = of(text).unwrap_err();
            assert!(refusal.contains(part), "{refusal}");
        }
    }
}
