//! How the values of a function are laid out, and the points they make.

use riffel::Complex64;

use super::UniversalFileError;
use super::fields::Fields;

/// How the values of a function are laid out (record 7).
#[derive(Debug, Clone)]
pub(super) struct Form {
    pub(super) line: usize,
    pub(super) complex: bool,
    pub(super) double: bool,
    pub(super) points: usize,
    spacing: Spacing,
}

#[derive(Debug, Clone)]
enum Spacing {
    Even { minimum: f64, increment: f64 },
    Uneven,
}

impl Spacing {
    fn read_even(mut fields: Fields, points: usize) -> Result<Self, UniversalFileError> {
        let line = fields.line();
        let minimum = fields.number(13, "the minimum of the abscissa")?;
        let increment = fields.number(13, "the increment of the abscissa")?;
        if increment <= 0.0 {
            return Err(UniversalFileError::NotPositive {
                line,
                what: "the increment of the abscissa",
                value: increment,
            });
        }
        let last = even_abscissa(minimum, increment, points - 1);
        if !last.is_finite() {
            return Err(UniversalFileError::Number {
                line,
                what: "the last value of the abscissa",
                text: last.to_string(),
            });
        }
        Ok(Self::Even { minimum, increment })
    }
}

impl Form {
    pub(super) fn read(mut fields: Fields) -> Result<Self, UniversalFileError> {
        let line = fields.line();
        let data_type = fields.choice(10, "the data type of the ordinate", &[2, 4, 5, 6])?;
        let points = fields.integer(10, "the number of points")?;
        let even = fields.choice(10, "the spacing of the abscissa", &[0, 1])? == 1;
        let points = usize::try_from(points)
            .ok()
            .filter(|&points| points > 0)
            .ok_or(UniversalFileError::NotPositive { line, what: "the number of points", value: points.into() })?;
        let spacing = match even {
            true => Spacing::read_even(fields, points)?,
            false => Spacing::Uneven,
        };
        Ok(Self { line, complex: data_type >= 5, double: data_type == 4 || data_type == 6, points, spacing })
    }

    pub(super) fn uneven(&self) -> bool {
        matches!(self.spacing, Spacing::Uneven)
    }

    /// First value and step of the abscissa; `None` if it is uneven.
    pub(super) fn even(&self) -> Option<(f64, f64)> {
        match self.spacing {
            Spacing::Even { minimum, increment } => Some((minimum, increment)),
            Spacing::Uneven => None,
        }
    }

    /// Numbers in the file for one point: abscissa if uneven, real part, imaginary part if complex.
    pub(super) fn numbers_of_point(&self) -> usize {
        1 + usize::from(self.uneven()) + usize::from(self.complex)
    }

    /// Numbers in the file for all points; as it is only compared, it may saturate.
    pub(super) fn numbers(&self) -> usize {
        self.points.saturating_mul(self.numbers_of_point())
    }

    /// Abscissa and ordinate from the numbers in the file.
    pub(super) fn points_of(&self, numbers: &[f64]) -> (Vec<f64>, Vec<Complex64>) {
        let point = |(index, numbers): (usize, &[f64])| {
            let mut numbers = numbers.iter().copied();
            let mut next = || numbers.next().unwrap_or(0.0);
            let abscissa = match self.spacing {
                Spacing::Even { minimum, increment } => even_abscissa(minimum, increment, index),
                Spacing::Uneven => next(),
            };
            (abscissa, Complex64::new(next(), next()))
        };
        let points = numbers.chunks_exact(self.numbers_of_point()).enumerate();
        points.map(point).unzip()
    }
}

fn even_abscissa(minimum: f64, increment: f64, index: usize) -> f64 {
    minimum + increment * index as f64
}
