//! Two columns of lateral coordinate and height.

use riffel_keys::table::{Delimiter, cells, is_one_of, label, number_in, words};
use riffel_keys::{Message, clipped, say};

use super::written::{WIDEST_IN_METRES, WrittenProfile};
use crate::refusal::Refusal;

/// The points of two columns, lateral coordinate and height, in millimetres or metres as a head says or their size.
pub(super) fn read(text: &str) -> Result<WrittenProfile, Refusal> {
    let mut written = WrittenProfile::default();
    let mut head = Head::default();
    let mut may_be_head = true;
    for (index, line) in text.lines().enumerate() {
        let line = without_comment(line);
        if line.is_empty() {
            continue;
        }
        let cells = cells_of(line);
        let numbers: Vec<Option<f64>> = cells.iter().map(|cell| number_in(cell)).collect();
        if may_be_head && numbers.iter().all(Option::is_none) {
            head = Head::read(&cells).map_err(|rule| Refusal::new(Some(index + 1), rule))?;
        } else {
            let point = head.columns.map(|column| numbers.get(column).copied().flatten());
            match point {
                [Some(x), Some(height)] if numbers.len() == head.width => {
                    written.push([x, height], index + 1);
                }
                [Some(_), Some(_)] => {
                    return Err(Refusal::new(Some(index + 1), columns_there(numbers.len())));
                }
                _ => {
                    let no_pair = say!(line_is_no_pair, text = clipped(line));
                    return Err(Refusal::new(Some(index + 1), no_pair));
                }
            }
        }
        may_be_head = false;
    }
    let factor = match head.unit {
        Some(factor) => factor,
        None if written.width() > WIDEST_IN_METRES => 1e-3,
        None => 1.0,
    };
    written.scale(factor);
    Ok(written)
}

fn columns_there(count: usize) -> Message {
    say!(other_count_of_columns, count)
}

/// A line without what follows #, ! or %, and without blanks around it.
pub(super) fn without_comment(line: &str) -> &str {
    let end = line.find(['#', '!', '%']).unwrap_or(line.len());
    line[..end].trim()
}

/// The cells of a line.
fn cells_of(line: &str) -> Vec<String> {
    let marks = [Delimiter::Semicolon, Delimiter::Tab, Delimiter::Comma];
    let is_in_line = |mark: &Delimiter| line.as_bytes().contains(&mark.byte());
    let mark = marks.into_iter().find(is_in_line);
    let blanks: Vec<&str> = line.split_whitespace().collect();
    // Two numbers with decimal commas and a blank between them.
    let with_commas =
        matches!(blanks[..], [x, y] if number_in(x).is_some() && number_in(y).is_some() && x.contains(','));
    let delimiter = mark.filter(|_| !with_commas).unwrap_or(Delimiter::Space);
    let mut cells: Vec<String> = cells(line.as_bytes(), delimiter).into_iter().map(label).collect();
    // A delimiter at the end of a line makes no column.
    while cells.last().is_some_and(String::is_empty) {
        cells.pop();
    }
    cells
}

/// Words for the lateral coordinate, but for x and y, which has two meanings.
const ACROSS: &str = "x|lateral|across|quer|querlage|querposition|querkoordinate|horizontal|transverse|transversal|breite|width|\
                      latéral|largeur|abszisse|abscissa";
/// Words for the height, but for y.
const UPWARD: &str =
    "z|h|height|höhe|hoehe|höhenlage|hoehenlage|elevation|vertical|vertikal|hauteur|altura|altezza|ordinate";

/// What a head says.
struct Head {
    /// Of the lateral coordinate and of the height.
    columns: [usize; 2],
    /// How many there are.
    width: usize,
    /// Metres in a unit; `None` if the head names none.
    unit: Option<f64>,
}

impl Default for Head {
    fn default() -> Self {
        Self { columns: [0, 1], width: 2, unit: None }
    }
}

impl Head {
    /// The columns by their names, x or y across and y or z upward, else in their order; row numbers are left out.
    fn read(cells: &[String]) -> Result<Self, Message> {
        let names: Vec<Vec<String>> = cells.iter().map(|cell| words(cell)).collect();
        let first = |column: usize| names[column].first().map_or("", String::as_str);
        let is = |column: usize, known: &str| is_one_of(first(column), known);
        let numbers_rows =
            |column: usize| first(column).is_empty() || is(column, "index|idx|row|line|point|punkt|zeile|nr|no|id|i|n");
        let columns: Vec<usize> = (0..cells.len()).filter(|column| !numbers_rows(*column)).collect();
        let of = |known: &str| {
            let mut found = columns.iter().copied().filter(|column| is(*column, known));
            found.next().filter(|_| found.next().is_none())
        };
        let (x, y) = (of(ACROSS), of("y"));
        let z = of(UPWARD);
        let by_name = match (x, y, z) {
            (Some(x), Some(height), None) | (Some(x), None, Some(height)) => Some([x, height]),
            (None, Some(y), Some(z)) => Some([y, z]),
            // Of two columns the other, in whatever language.
            (None, None, Some(z)) if columns.len() == 2 => Some([columns[usize::from(columns[0] == z)], z]),
            (Some(x), None, None) if columns.len() == 2 => Some([x, columns[usize::from(columns[0] == x)]]),
            _ => None,
        };
        let columns = match (by_name, &columns[..]) {
            (Some(columns), _) => columns,
            (None, [across, up]) => [*across, *up],
            _ => return Err(columns_there(cells.len())),
        };
        let units = columns.into_iter().flat_map(|column| &names[column]);
        let units = units.filter_map(|word| match word.as_str() {
            "mm" => Some(Ok(1e-3)),
            "m" => Some(Ok(1.0)),
            word => is_one_of(word, "um|µm|μm|cm|dm|nm|km|in|inch|inches|ft|mil")
                .then(|| Err(say!(head_says_other_unit, unit = word))),
        });
        let units: Vec<f64> = units.collect::<Result<_, _>>()?;
        let unit = match units[..] {
            [one, other] if one != other => {
                return Err(say!(head_with_two_units));
            }
            _ => units.first().copied(),
        };
        Ok(Self { columns, width: cells.len(), unit })
    }
}
