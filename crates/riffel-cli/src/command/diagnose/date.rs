//! Dates as YYYY-MM-DD.

/// Days from 1 March of the year 0 to a date of the Gregorian calendar; None for what is no date.
///
/// Years begin in March, so that the day of a leap year is their last.
pub(crate) fn days(date: &str) -> Option<i64> {
    let mut parts = date.trim().split('-');
    let mut number = |digits: usize| {
        let part = parts.next()?;
        let written = part.len() == digits && part.bytes().all(|byte| byte.is_ascii_digit());
        part.parse::<i64>().ok().filter(|_| written)
    };
    let (year, month, day) = (number(4)?, number(2)?, number(2)?);
    let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let longest = match month {
        2 => 28 + i64::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if parts.next().is_some() || !(1..=longest).contains(&day) {
        return None;
    }
    let (year, month) = if month < 3 {
        (year - 1, month + 9)
    } else {
        (year, month - 3)
    };
    let before_month = (153 * month + 2) / 5;
    let before_year = 365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400);
    Some(before_year + before_month + day - 1)
}

#[cfg(test)]
mod tests {
    use super::days;

    #[test]
    fn dates_are_counted() {
        let between = |from, to| days(to).unwrap() - days(from).unwrap();
        assert_eq!(between("2014-03-01", "2015-03-01"), 365);
        assert_eq!(between("2016-02-28", "2016-03-01"), 2);
        assert_eq!(between("2000-01-01", "2001-01-01"), 366);
        assert_eq!(between("1900-02-28", "1900-03-01"), 1);
        assert_eq!(between("2014-03-01", "2015-10-01"), 579);
        for wrong in [
            "",
            "2014",
            "2014-13-01",
            "2015-02-29",
            "01.03.2014",
            "2014-3-1",
            "2014-03-01-1",
        ] {
            assert_eq!(days(wrong), None, "{wrong}");
        }
    }
}
