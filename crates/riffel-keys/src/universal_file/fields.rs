//! Fields of fixed columns, and numbers as Fortran writes them.

use super::UniversalFileError;

/// What is left of a line, taken field by field.
pub(super) struct Fields<'a> {
    line: usize,
    column: usize,
    rest: &'a str,
}

impl<'a> Fields<'a> {
    pub(super) fn new(line: usize, text: &'a str) -> Self {
        Self { line, column: 0, rest: text }
    }

    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// Text of the next columns without the blanks around it.
    pub(super) fn text(&mut self, width: usize) -> &'a str {
        let end = self.rest.char_indices().nth(width).map(|(end, _)| end);
        let (field, rest) = end.and_then(|end| self.rest.split_at_checked(end)).unwrap_or((self.rest, ""));
        self.rest = rest;
        self.column += width;
        field.trim()
    }

    /// A column between two fields.
    pub(super) fn gap(&mut self) -> Result<(), UniversalFileError> {
        if self.text(1).is_empty() {
            return Ok(());
        }
        Err(UniversalFileError::Gap { line: self.line, column: self.column })
    }

    /// An integer; nothing is zero, as Fortran reads it.
    pub(super) fn integer(&mut self, width: usize, what: &'static str) -> Result<i32, UniversalFileError> {
        match self.text(width) {
            "" => Ok(0),
            text => {
                text.parse().map_err(|_| UniversalFileError::Integer { line: self.line, what, text: text.to_owned() })
            }
        }
    }

    /// An integer that must be one of those allowed.
    pub(super) fn choice(
        &mut self,
        width: usize,
        what: &'static str,
        allowed: &[i32],
    ) -> Result<i32, UniversalFileError> {
        let value = self.integer(width, what)?;
        if allowed.contains(&value) {
            return Ok(value);
        }
        Err(UniversalFileError::Choice { line: self.line, what, value, allowed: allowed.to_vec() })
    }

    /// A finite number; nothing is zero, as Fortran reads it.
    pub(super) fn number(&mut self, width: usize, what: &'static str) -> Result<f64, UniversalFileError> {
        match self.text(width) {
            "" => Ok(0.0),
            text => self.parse(text, what),
        }
    }

    fn parse(&self, text: &str, what: &'static str) -> Result<f64, UniversalFileError> {
        fortran(text).filter(|number| number.is_finite()).ok_or_else(|| UniversalFileError::Number {
            line: self.line,
            what,
            text: text.to_owned(),
        })
    }

    /// The numbers of a line of values, to the first blank field.
    pub(super) fn numbers(mut self, widths: &[usize]) -> Result<Vec<f64>, UniversalFileError> {
        let mut numbers = Vec::new();
        for &width in widths {
            match self.text(width) {
                "" => {
                    self.column -= width;
                    break;
                }
                text => numbers.push(self.parse(text, "a value")?),
            }
        }
        if self.rest.trim().is_empty() {
            return Ok(numbers);
        }
        Err(UniversalFileError::LongLine { line: self.line, column: self.column })
    }
}

/// A number with the exponent letter `E` or `D` of either case, or none: an exponent of three digits
/// takes its place, as in `0.12345-100`.
fn fortran(text: &str) -> Option<f64> {
    let mut plain = String::with_capacity(text.len() + 1);
    for character in text.chars() {
        match character {
            'e' | 'E' | 'd' | 'D' => plain.push('e'),
            '+' | '-' => {
                if plain.ends_with(|last: char| last.is_ascii_digit() || last == '.') {
                    plain.push('e');
                }
                plain.push(character);
            }
            '0'..='9' | '.' => plain.push(character),
            _ => return None,
        }
    }
    plain.parse().ok()
}
