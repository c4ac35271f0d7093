//! The values of dataset 58 as text.

use super::UniversalFileError;
use super::form::Form;
use super::lines::Lines;

/// The values of a dataset 58 and its closing mark.
///
/// Only the last line may be short. It may also be filled up with zeros: the definition's own
/// program writes whole lines, and some systems do.
pub(super) fn numbers(lines: &mut Lines, form: &Form) -> Result<Vec<f64>, UniversalFileError> {
    let widths = widths(form);
    let mut numbers = Vec::new();
    loop {
        let line = lines.inside()?;
        if line.is_mark() {
            break;
        }
        let values = line.fields().numbers(widths)?;
        let missing = form.numbers() - numbers.len();
        let needed = missing.min(widths.len());
        if values.len() < needed && !lines.mark_follows() {
            return Err(UniversalFileError::ShortLine { line: line.number, needed, held: values.len() });
        }
        let fill = values.iter().skip(needed);
        if missing == 0 || fill.copied().any(|value| value != 0.0) {
            return Err(UniversalFileError::TooMany {
                line: line.number,
                points: form.points,
                numbers: form.numbers(),
            });
        }
        numbers.extend(values.into_iter().take(needed));
    }
    if numbers.len() < form.numbers() {
        return Err(UniversalFileError::TooFew {
            line: form.line,
            points: form.points,
            numbers: form.numbers(),
            held: numbers.len(),
        });
    }
    Ok(numbers)
}

/// Widths of the numbers of a line; an abscissa is single whatever the ordinate is.
pub(super) fn widths(form: &Form) -> &'static [usize] {
    match (form.double, form.uneven(), form.complex) {
        (false, ..) => &[13; 6],
        (true, false, _) => &[20; 4],
        (true, true, false) => &[13, 20, 13, 20],
        (true, true, true) => &[13, 20, 20],
    }
}
