//! Numbers of the command line that have no unit.

use riffel_keys::money;

/// A number as it is written in a program: digits with a decimal point.
pub(crate) fn plain_number(text: &str) -> Result<f64, String> {
    match text.trim().parse() {
        Ok(number) if f64::is_finite(number) => Ok(number),
        _ => Err(format!(
            "\"{text}\" is not a number; write digits with a decimal point and no separators of thousands, as in 2500000 or 2.5e6"
        )),
    }
}

/// A sum of money without a currency, which no separator of thousands makes another.
pub(crate) fn sum_of_money(text: &str) -> Result<f64, String> {
    match money::read(text) {
        Ok((sum, "")) => Ok(sum),
        Err(rule) => Err(format!("the sum {rule}")),
        Ok(_) => Err(format!("\"{text}\" is not a number; write it without its currency")),
    }
}
