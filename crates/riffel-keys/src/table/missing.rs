//! Numbers that only mark a missing value.

/// What programs write where there is no value, without its sign.
const MARKS: [f64; 16] = [
    99.9,
    99.99,
    999.0,
    999.25,
    999.9,
    999.99,
    9999.0,
    9999.9,
    9999.99,
    32_767.0,
    32_768.0,
    65_535.0,
    99_999.0,
    2_147_483_647.0,
    2_147_483_648.0,
    1e30,
];

/// A mark that was found in a column.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Marked {
    /// What it is.
    pub mark: f64,
    /// How often it, or another one, stands there.
    pub count: usize,
    /// The first row, from zero.
    pub first: usize,
}

/// Whether a number is one that programs write where there is no value.
#[inline]
pub fn is_mark(value: f64) -> bool {
    // Of a chainage all values come here.
    let size = value.abs();
    size >= MARKS[0] && MARKS.contains(&size)
}

/// The marks of missing values in a column: numbers of the list above that stand off all others, by more than half of what
/// these range over, so that a chainage of 9999 m is one. NaN is left alone.
pub fn marks(values: &[f64]) -> Option<Marked> {
    let is_far = far_marks(values)?;
    let mut marked = values.iter().enumerate().filter(|(_, value)| is_far(**value));
    let (first, &mark) = marked.next()?;
    let count = 1 + marked.count();
    Some(Marked { mark, count, first })
}

/// Write NaN for the marks of missing values in a column.
pub(super) fn leave_out_marks(values: &mut [f64]) -> Option<Marked> {
    let marked = marks(values)?;
    if let Some(is_far) = far_marks(values) {
        for value in values.iter_mut().filter(|value| is_far(**value)) {
            *value = f64::NAN;
        }
    }
    Some(marked)
}

/// Which marks stand off all other values; `None` if there is no mark at all, or nothing else.
fn far_marks(values: &[f64]) -> Option<impl Fn(f64) -> bool + use<>> {
    if !values.iter().any(|&value| is_mark(value)) {
        return None;
    }
    let others = values.iter().filter(|value| !is_mark(**value));
    let (low, high) =
        others.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| (low.min(value), high.max(value)));
    let far = 0.5 * (high - low);
    let is_far = move |value: f64| is_mark(value) && (value < low - far || value > high + far);
    (low <= high).then_some(is_far)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_stands_off_is_a_mark() {
        let mut heights = [1.5, -9999.0, 2.5, -32_768.0, 1.0, 32_767.0, -99.99];
        let marked = leave_out_marks(&mut heights).unwrap();
        assert_eq!((marked.mark, marked.count, marked.first), (-9999.0, 4, 1));
        assert_eq!(heights.iter().filter(|height| height.is_nan()).count(), 4);
        let chainage: Vec<f64> = (9990..=9999).map(f64::from).collect();
        assert_eq!(marks(&chainage), None);
        assert_eq!(marks(&[-800.0, 999.0, 1200.0]), None);
        // A dip of 99.9 µm has shallower heights beside it.
        assert_eq!(marks(&[2.0, -61.3, -99.9, -72.5, -3.0]), None);
        assert_eq!(marks(&[-9999.0, f64::NAN]), None);
    }
}
