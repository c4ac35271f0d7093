//! Dates as files write them.

use std::ops::RangeInclusive;

use jiff::ToSpan as _;
use jiff::civil::{Date, date};
use riffel_keys::table::{is_one_of, words};
use riffel_keys::text_file::printable;
use riffel_keys::{Message, say};

/// Days that spreadsheets write in place of dates, counted from 1899-12-30: 2009 to 2064.
const DAY_NUMBERS: RangeInclusive<i32> = 40_000..=60_000;

/// A text that is no date, or may be two.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct NoDate {
    /// Place of the text among all.
    pub(super) place: usize,
    /// A sentence that begins with the text.
    pub(super) message: Message,
}

/// Years of what is measured and of what is planned: another one is a slip, or stands for no date.
const YEARS: RangeInclusive<i16> = 1950..=2100;

/// The numbers of a date in the order in which they are written.
enum DateNumbers {
    /// The day of a spreadsheet.
    Day(Date),
    YearFirst([i16; 3]),
    DayFirst([i16; 3]),
    /// Day and month in an order that depends on the country.
    Open([i16; 3]),
}

/// Read the date that a text gives.
///
/// # Errors
/// A sentence on the text.
pub fn read_date(text: &str) -> Result<Date, Message> {
    let dates = read_dates([text]).map_err(|no_date| no_date.message)?;
    Ok(dates[0])
}

/// The dates of a column, in its order: 2026-01-31, 2026/01/31, 20260131 or 31.01.2026, each with or without a time of
/// day, or the days of a spreadsheet from 40000 to 60000. 31/01/2026, 01/31/2026 and the same with hyphens are read where
/// one date of the column leaves no doubt which number is the day.
///
/// # Errors
/// The first text that is no date, or may be two.
pub(super) fn read_dates<'a>(texts: impl IntoIterator<Item = &'a str>) -> Result<Vec<Date>, NoDate> {
    let texts: Vec<&str> = texts.into_iter().collect();
    let at = |place: usize| move |message: Message| NoDate { place, message };
    let written = texts.iter().enumerate();
    let written: Vec<DateNumbers> =
        written.map(|(place, text)| DateNumbers::of(text).map_err(at(place))).collect::<Result<_, _>>()?;
    let open = || {
        let pairs = written.iter().enumerate();
        pairs.filter_map(|(place, date)| match date {
            DateNumbers::Open(numbers) => Some((*numbers, place)),
            _ => None,
        })
    };
    let day_first = open().find(|([first, ..], _)| *first > 12);
    let month_first = open().find(|([_, second, _], _)| *second > 12);
    if let (Some((_, day)), Some((_, month))) = (day_first, month_first) {
        return Err(at(day)(say!(days_in_two_orders, text = texts[day], other = texts[month])));
    }
    if day_first.is_none()
        && month_first.is_none()
        && let Some(([first, second, year], place)) = open().find(|([day, month, _], _)| day != month)
    {
        return Err(at(place)(say!(
            date_may_be_two,
            text = texts[place],
            one = format!("{year}-{second:02}-{first:02}"),
            other = format!("{year}-{first:02}-{second:02}")
        )));
    }
    let dates = written.into_iter().zip(&texts).enumerate();
    let dates = dates.map(|(place, (date, text))| {
        let [year, month, day] = match date {
            DateNumbers::Day(date) => return Ok(date),
            DateNumbers::YearFirst(numbers) => numbers,
            DateNumbers::DayFirst([day, month, year]) => [year, month, day],
            DateNumbers::Open([month, day, year]) if month_first.is_some() => [year, month, day],
            DateNumbers::Open([day, month, year]) => [year, month, day],
        };
        if !YEARS.contains(&year) {
            let (first, last) = (YEARS.start(), YEARS.end());
            return Err(at(place)(say!(
                year_is_out_of_range,
                text = *text,
                first = first.to_string(),
                last = last.to_string()
            )));
        }
        let small = |number: i16| i8::try_from(number).unwrap_or(0);
        Date::new(year, small(month), small(day)).map_err(|_| at(place)(say!(day_is_not_in_calendar, text = *text)))
    });
    dates.collect()
}

/// The date that a spreadsheet writes as a number of days, with the time of day as decimals.
pub(super) fn of_day_number(text: &str) -> Option<Date> {
    let text = text.trim();
    let (days, time) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let is_number = days.len() == 5 && [days, time].iter().all(|part| are_digits(part));
    let days: i32 = days.parse().ok().filter(|_| is_number)?;
    let is_known = DAY_NUMBERS.contains(&days);
    is_known.then(|| date(1899, 12, 30).saturating_add(days.days()))
}

/// Whether a cell is a date by its form, whatever its column is called: three numbers, or the name of a month beside a year.
pub(super) fn looks_like_date(text: &str) -> bool {
    const MONTHS: &str = "jan|feb|mar|mär|mrz|apr|may|mai|jun|jul|aug|sep|sept|oct|okt|nov|dec|dez|january|february|march|\
                          april|june|july|august|september|october|november|december|januar|februar|märz|juni|juli|oktober|\
                          dezember|janv|févr|mars|avr|avril|juin|juil|juillet|août|déc|ene|abr|ago|dic|gen|mag|giu|lug|set|ott";
    let words = words(text);
    let is_year =
        |word: &String| word.len() == 4 && are_digits(word) && (word.starts_with("19") || word.starts_with("20"));
    let has_month = words.iter().any(|word| is_one_of(word, MONTHS));
    matches!(words.len(), 2..=3) && has_month && words.iter().any(is_year)
        || of_day_number(text).is_none() && DateNumbers::of(text).is_ok()
}

/// Whether a cell is the day of a spreadsheet, or a year with or without decimals.
pub(super) fn looks_like_point(text: &str) -> bool {
    let (year, decimals) = text.trim().split_once(['.', ',']).unwrap_or((text.trim(), ""));
    let is_year = year.parse().is_ok_and(|year: i16| YEARS.contains(&year));
    of_day_number(text).is_some() || is_year && are_digits(decimals)
}

fn are_digits(text: &str) -> bool {
    text.bytes().all(|byte| byte.is_ascii_digit())
}

impl DateNumbers {
    fn of(text: &str) -> Result<Self, Message> {
        let no_date = || say!(no_date, text = printable(text));
        if let Some(day) = of_day_number(text) {
            return Ok(Self::Day(day));
        }
        let date = without_time(text.trim()).ok_or_else(no_date)?;
        if date.len() == 8 && are_digits(date) {
            let part = |range: std::ops::Range<usize>| date[range].parse().unwrap_or(0);
            return Ok(Self::YearFirst([part(0..4), part(4..6), part(6..8)]));
        }
        let mark = ['-', '.', '/'].into_iter().find(|mark| date.contains(*mark));
        let mark = mark.ok_or_else(no_date)?;
        let parts: Vec<&str> = date.split(mark).collect();
        let [first, second, third] = parts[..] else {
            return Err(no_date());
        };
        if !parts.iter().all(|part| are_digits(part)) {
            return Err(no_date());
        }
        // No more than four digits, or refused by the lengths below.
        let numbers = [first, second, third].map(|part| part.parse().unwrap_or(0));
        match (first.len(), second.len(), third.len(), mark) {
            (4, 1..=2, 1..=2, _) => Ok(Self::YearFirst(numbers)),
            (1..=2, 1..=2, 4, '.') => Ok(Self::DayFirst(numbers)),
            (1..=2, 1..=2, 4, _) => Ok(Self::Open(numbers)),
            (1..=2, 1..=2, 2, _) => Err(say!(year_of_two_digits, text = printable(text))),
            _ => Err(no_date()),
        }
    }
}

/// The date without a time of day behind it; None if something else is there.
fn without_time(text: &str) -> Option<&str> {
    let Some(end) = text.find([' ', 'T', ',']) else {
        return Some(text);
    };
    let (date, time) = (&text[..end], text[end + 1..].trim());
    let hours = time.bytes().take_while(u8::is_ascii_digit).count();
    let clock = |c: char| c.is_ascii_digit() || ":.,+-ZhAPMapm ".contains(c);
    let is_time = (1..=2).contains(&hours)
        && matches!(time.as_bytes().get(hours), Some(b':' | b'h'))
        && time.trim_end_matches("Uhr").chars().all(clock);
    is_time.then_some(date)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_day_in_many_ways() {
        for text in [
            "2024-03-15",
            "2024/03/15",
            "20240315",
            "15.03.2024",
            "15.3.2024",
            " 15.03.2024 09:30 ",
            "15.03.2024, 09:30:12 Uhr",
            "2024-03-15T09:30:12.5Z",
            "2024-03-15 09:30:12+01:00",
            "15/03/2024",
            "03/15/2024 2:30 PM",
            "15-03-2024",
            "45366",
            "45366.39",
            "45366,0",
        ] {
            assert_eq!(read_date(text).map(|date| date.to_string()), Ok("2024-03-15".to_owned()));
        }
    }

    #[test]
    fn one_date_of_a_column_tells_the_order_of_all() {
        let words = |texts: &[&str]| {
            let dates = read_dates(texts.iter().copied());
            dates
                .map(|dates| dates.iter().map(Date::to_string).collect::<Vec<_>>().join(" "))
                .map_err(|no_date| no_date.message.to_string())
        };
        assert_eq!(words(&["03/04/2024", "25/04/2024"]).unwrap(), "2024-04-03 2024-04-25");
        assert_eq!(words(&["03/04/2024", "04/25/2024"]).unwrap(), "2024-03-04 2024-04-25");
        assert_eq!(words(&["05/05/2024"]).unwrap(), "2024-05-05");
        assert_eq!(
            words(&["03/04/2024", "05/06/2024"]).unwrap_err(),
            "\"03/04/2024\" may be two dates; write 2024-04-03 or 2024-03-04"
        );
        assert!(words(&["25/04/2024", "04/25/2024"]).unwrap_err().contains("different orders"));
    }

    #[test]
    fn what_is_no_date_is_refused() {
        for (text, part) in [
            ("31.02.2024", "not in the calendar"),
            ("15.03.24", "two digits"),
            ("March", "no date"),
            ("", "no date"),
            ("2024-03", "no date"),
            ("2999-01-01", "between 1950 and 2100"),
            ("9999-12-31", "between 1950 and 2100"),
            ("01.01.0026", "between 1950 and 2100"),
            ("39999", "no date"),
            ("60001", "no date"),
            ("45,366", "no date"),
            ("15.03.2024 before grinding", "no date"),
            ("1.2.3.2024", "no date"),
            ("2024-03-99999999999999999999", "no date"),
        ] {
            let wrong = read_date(text).unwrap_err();
            assert!(wrong.to_string().contains(part), "{wrong}");
            assert_ne!(wrong.id(), "verbatim", "{wrong} is in one language");
        }
    }
}
