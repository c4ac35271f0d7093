//! Numbers of the command line that have no unit.

/// A number as it is written in a program: digits with a decimal point.
pub(crate) fn plain_number(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(number) if f64::is_finite(number) => Ok(number),
        _ => Err(format!(
            "\"{text}\" is not a number; write digits with a decimal point and no separators of thousands, as in 2500000 or 2.5e6"
        )),
    }
}
