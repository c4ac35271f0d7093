//! The binary form of dataset 58: the same lines, but the values as IEEE floating point numbers.

use std::io;

use super::fields::Fields;
use super::form::Form;
use super::lines::Lines;
use super::{SignalError, UniversalFileError};

const SINGLE: usize = 4;
const DOUBLE: usize = 8;

/// How the binary part is encoded, from the line with the dataset's number.
#[derive(Debug, Clone)]
pub(super) struct Encoding {
    line: usize,
    big_endian: bool,
    declared: i32,
}

impl Encoding {
    /// Read the fields that follow the "58b".
    pub(super) fn read(mut fields: Fields) -> Result<Self, UniversalFileError> {
        let order = fields.choice(6, "the byte order", &[1, 2])?;
        fields.choice(6, "the floating point format", &[2])?;
        fields.choice(12, "the number of lines before the binary data", &[11])?;
        Ok(Self { line: fields.line(), big_endian: order == 2, declared: fields.integer(12, "the number of bytes")? })
    }

    /// The values of a dataset 58b and its closing mark.
    ///
    /// By the definition, the abscissa of an uneven spacing is single whatever the ordinate is, but
    /// pyuff writes it as wide as the ordinate. As the closing mark is where only one of the two
    /// lengths can end, it tells which.
    pub(super) fn numbers(&self, lines: &mut Lines, form: &Form) -> Result<Vec<f64>, UniversalFileError> {
        let ordinate = if form.double { DOUBLE } else { SINGLE };
        let line = lines.coming();
        for abscissa in [SINGLE, ordinate] {
            let widths = widths(form, abscissa, ordinate);
            let bytes = length(form, &widths);
            if let Some(block) = lines.block(bytes) {
                self.check_bytes(bytes, form.points.saturating_mul(ordinate))?;
                return self.decode(block, &widths, line);
            }
        }
        Err(UniversalFileError::BinaryEnd {
            line: form.line,
            points: form.points,
            bytes: length(form, &widths(form, SINGLE, ordinate)),
        })
    }

    /// Leap over the values of a dataset 58b and its closing mark: `block` does so if the mark follows so many bytes.
    ///
    /// Returns the bytes of each number of a point.
    pub(super) fn leap(
        &self,
        form: &Form,
        mut block: impl FnMut(u64) -> io::Result<bool>,
    ) -> Result<Vec<usize>, SignalError> {
        let ordinate = if form.double { DOUBLE } else { SINGLE };
        for abscissa in [SINGLE, ordinate] {
            let widths = widths(form, abscissa, ordinate);
            let bytes = length(form, &widths);
            if block(bytes as u64)? {
                self.check_bytes(bytes, form.points.saturating_mul(ordinate))?;
                return Ok(widths);
            }
        }
        Err(UniversalFileError::BinaryEnd {
            line: form.line,
            points: form.points,
            bytes: length(form, &widths(form, SINGLE, ordinate)),
        }
        .into())
    }

    /// The declared number of bytes must be right, or the one that pyuff writes, which counts one
    /// number for each point also where there are two or three.
    fn check_bytes(&self, bytes: usize, one_each: usize) -> Result<(), UniversalFileError> {
        let declared = usize::try_from(self.declared).unwrap_or(0);
        if declared == bytes || declared == one_each {
            return Ok(());
        }
        Err(UniversalFileError::ByteCount { line: self.line, declared: self.declared, bytes })
    }

    fn decode(&self, block: &[u8], widths: &[usize], line: usize) -> Result<Vec<f64>, UniversalFileError> {
        let mut numbers = Vec::new();
        let mut rest = block;
        for &width in widths.iter().cycle() {
            let Some((field, after)) = rest.split_at_checked(width) else {
                break;
            };
            rest = after;
            numbers.push(self.finite(field, line)?);
        }
        Ok(numbers)
    }

    /// One number of four or eight bytes, which must be finite.
    pub(super) fn finite(&self, field: &[u8], line: usize) -> Result<f64, UniversalFileError> {
        let number = self.number(field);
        if number.is_finite() {
            return Ok(number);
        }
        Err(UniversalFileError::Number { line, what: "a value", text: number.to_string() })
    }

    /// One number of four or eight bytes.
    fn number(&self, field: &[u8]) -> f64 {
        if let Ok(bytes) = <[u8; DOUBLE]>::try_from(field) {
            return match self.big_endian {
                true => f64::from_be_bytes(bytes),
                false => f64::from_le_bytes(bytes),
            };
        }
        let single = <[u8; SINGLE]>::try_from(field).map_or(f32::NAN, |bytes| match self.big_endian {
            true => f32::from_be_bytes(bytes),
            false => f32::from_le_bytes(bytes),
        });
        single.into()
    }
}

/// Bytes of each number of a point.
fn widths(form: &Form, abscissa: usize, ordinate: usize) -> Vec<usize> {
    let mut widths = vec![ordinate; form.numbers_of_point()];
    if let (true, Some(first)) = (form.uneven(), widths.first_mut()) {
        *first = abscissa;
    }
    widths
}

/// Bytes of all points; as it is only compared, it may saturate.
fn length(form: &Form, widths: &[usize]) -> usize {
    form.points.saturating_mul(widths.iter().sum())
}
