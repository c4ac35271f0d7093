//! Sums of money as people write them, with a currency behind or none.

use crate::{Message, say};

/// Currencies that may stand behind a multiple, or wrongly before a sum.
const CURRENCIES: [&str; 12] = ["EUR", "€", "CHF", "GBP", "£", "USD", "$", "SEK", "NOK", "DKK", "PLN", "CZK"];

/// The number of a sum, and what stands behind it.
///
/// # Errors
/// What is wrong with the number, a rule that goes on after the name of the sum: it may be thousands (`9.000`, `9,000`), its
/// thousands stand apart (`9 000`, `9'000`), it has a decimal comma, its currency stands before it, it counts thousands or millions
/// (`9 k EUR`), or it is none.
pub fn read(text: &str) -> Result<(f64, &str), Message> {
    let text = text.trim();
    let before = |own: &&&str| text.starts_with(**own);
    if let Some(currency) = CURRENCIES.iter().find(before) {
        let (sum, _) = read(&text[currency.len()..])?;
        let plain = format!("{sum} {currency}");
        return Err(say!(is_with_its_currency_before, value = text, plain));
    }
    let (number, behind) = text.split_at(end_of_number(text));
    let value = || text.to_owned();
    let marks: Vec<char> = number.chars().filter(|c| matches!(c, '.' | ',')).collect();
    let (before, after) = number.split_once(['.', ',']).unwrap_or((number, ""));
    let before = before.trim_start_matches(['+', '-']);
    let digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    if marks.len() > 1 || number.chars().any(parts_thousands) {
        return Err(say!(is_with_thousands_apart, value = value()));
    }
    // A zero begins no thousands.
    if after.len() == 3 && digits(after) && digits(before) && !before.trim_start_matches('0').is_empty() {
        let plain = match after.trim_end_matches('0') {
            "" => before.to_owned(),
            kept if kept.len() == 3 => format!("{before}.{kept}0"),
            kept => format!("{before}.{kept}"),
        };
        let thousands = format!("{before}{after}");
        let rule = say!(is_perhaps_in_thousands, value = value(), thousands, plain);
        return Err(rule);
    }
    if marks.contains(&',') {
        return Err(say!(is_with_a_comma, value = value(), plain = format!("{before}.{after}")));
    }
    match number.parse() {
        Ok(sum) if f64::is_finite(sum) => match multiple(behind.trim_start()) {
            None => Ok((sum, behind.trim_start())),
            Some((times, currency)) => {
                Err(say!(is_with_a_multiple, value = value(), plain = format!("{} {currency}", times * sum).trim_end()))
            }
        },
        _ => Err(say!(is_but_must_be, value = value(), rule = say!(number_of_a_sum))),
    }
}

/// How much a word before a currency multiplies a sum by, and the currency: `k EUR`, `TEUR`, `Mio. €`.
fn multiple(behind: &str) -> Option<(f64, &str)> {
    const WORDS: [(f64, &[&str]); 2] = [
        (1e3, &["k", "K", "T", "Tsd", "tsd", "thousand"]),
        (1e6, &["M", "Mio", "mio", "Mill", "mn", "million", "millions"]),
    ];
    WORDS.into_iter().find_map(|(times, words)| {
        words.iter().find_map(|word| {
            let rest = behind.strip_prefix(word)?;
            let rest = rest.strip_prefix('.').unwrap_or(rest);
            let is_word = rest.is_empty() || rest.starts_with(char::is_whitespace);
            let rest = rest.trim_start();
            let is_joined = CURRENCIES.iter().any(|own| rest.starts_with(own));
            (is_word || is_joined).then_some((times, rest))
        })
    })
}

/// True for what stands between thousands alone: blanks of any width, apostrophes and underscores.
fn parts_thousands(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\'' | '\u{2019}' | '_')
}

/// Where the number at the head of a text ends: what parts thousands is of it where a digit follows.
fn end_of_number(text: &str) -> usize {
    let mut end = 0;
    let mut letters = text.char_indices().peekable();
    while let Some((at, c)) = letters.next() {
        let next = letters.peek().map(|(_, next)| *next);
        let goes_on = next.is_some_and(|next| next.is_ascii_digit());
        let is_exponent = matches!(c, 'e' | 'E') && next.is_some_and(|next| goes_on || matches!(next, '+' | '-'));
        let is_of_it = match c {
            '0'..='9' | '.' | ',' | '+' | '-' => true,
            c if parts_thousands(c) => goes_on,
            _ => is_exponent,
        };
        if !is_of_it {
            break;
        }
        end = at + c.len_utf8();
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_read_as_they_are_written() {
        for (text, sum, currency) in [
            ("9000 EUR", 9000.0, "EUR"),
            ("9000", 9000.0, ""),
            (" 9000.5 kr ", 9000.5, "kr"),
            ("9.00 EUR", 9.0, "EUR"),
            ("9.0000 EUR", 9.0, "EUR"),
            ("0.125 EUR", 0.125, "EUR"),
            ("-3 EUR", -3.0, "EUR"),
            ("2.5e6 EUR", 2.5e6, "EUR"),
            ("12 EUR/m", 12.0, "EUR/m"),
            ("60000EUR", 60e3, "EUR"),
        ] {
            assert_eq!(read(text), Ok((sum, currency)), "{text}");
        }
    }

    #[test]
    fn thousands_and_millions_are_no_currency() {
        for (text, plain) in [
            ("9 k EUR", "9000 EUR"),
            ("9kEUR", "9000 EUR"),
            ("9.5 TEUR", "9500 EUR"),
            ("1.2 Mio. €", "1200000 €"),
            ("2 million", "2000000"),
            ("9 k", "9000"),
            ("EUR 9000", "9000 EUR"),
            ("€ 9.5", "9.5 €"),
        ] {
            let rule = read(text).unwrap_err().to_string();
            assert!(rule.contains(plain), "{text}: {rule}");
        }
        for text in ["9 kr", "9 MXN", "9 TRY", "9 Kč", "9 EUR/m"] {
            assert!(read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn what_may_be_thousands_is_refused() {
        for (text, may_be) in [
            ("9.000 EUR", "9000 or 9:"),
            ("9,000", "9000 or 9:"),
            ("500.000", "500000 or 500:"),
            ("12.500 CHF", "12500 or 12.5:"),
            ("12.345", "12345 or 12.3450:"),
            ("1,250 EUR", "1250 or 1.25:"),
            ("EUR 7.500", "7500 or 7.5:"),
        ] {
            let rule = read(text).unwrap_err().to_string();
            assert!(rule.contains(may_be), "{text}: {rule}");
        }
        for apart in [
            "9 000 EUR",
            "9\u{a0}000 EUR",
            "9\u{202f}000",
            "9\u{2009}000",
            "9'000 CHF",
            "9\u{2019}000",
            "9_000",
            "9.000.000 EUR",
            "9,000.00",
            "9.000,00 EUR",
            "500 000",
            "1 9 EUR",
        ] {
            let rule = read(apart).unwrap_err().to_string();
            assert!(rule.contains("thousands apart"), "{apart}: {rule}");
        }
        assert!(read("9,5 EUR").unwrap_err().to_string().contains("9.5"));
        for none in ["", "EUR 9000", "many", "1e400", "nan EUR", "inf", "--3", "."] {
            assert!(read(none).is_err(), "{none}");
        }
    }
}
