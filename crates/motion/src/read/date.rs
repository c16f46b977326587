//! Dates of files as seconds.

const NANOSECONDS: i64 = 1_000_000_000;
const DAY: i64 = 86_400 * NANOSECONDS;

fn is_leap(year: i64) -> bool {
    year % 4 == 0 && (year % 100 != 0 || year % 400 == 0)
}

/// Nanoseconds from the beginning of 1970 to midnight of a year's `day`-th day, counted from 1; `None` beyond 1900 to 2100
/// and for a day that the year does not have. The range keeps sums far from the ends of `i64`.
pub(super) fn midnight(year: i64, day: i64) -> Option<i64> {
    let days = if is_leap(year) { 366 } else { 365 };
    if !(1900..=2100).contains(&year) || !(1..=days).contains(&day) {
        return None;
    }
    // Leap years from the year 1 to before `y`.
    let leaps = |y: i64| (y - 1) / 4 - (y - 1) / 100 + (y - 1) / 400;
    Some(((year - 1970) * 365 + leaps(year) - leaps(1970) + day - 1) * DAY)
}

/// Seconds since the beginning of 1970 of a date and time written as `2018/01/24 19:51:37` or `20190728_160905.700`: the fourteen
/// digits from the year to the second, with or without marks between them, and a fraction of the second. `None` for what is
/// no such time.
pub(super) fn seconds(text: &str) -> Option<f64> {
    let (whole, fraction) = text.trim().split_once('.').unwrap_or((text.trim(), "0"));
    if !whole.chars().all(|c| c.is_ascii_digit() || "/-: _T".contains(c))
        || !fraction.bytes().all(|b| b.is_ascii_digit())
    {
        return None;
    }
    let digits: String = whole.chars().filter(char::is_ascii_digit).collect();
    if digits.len() != 14 {
        return None;
    }
    let part = |from: usize, to: usize| digits[from..to].parse::<i64>().ok();
    let (year, month, day) = (part(0, 4)?, part(4, 6)?, part(6, 8)?);
    let (hour, minute, second) = (part(8, 10)?, part(10, 12)?, part(12, 14)?);
    let february = if is_leap(year) { 29 } else { 28 };
    let months = [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];
    let before = months.get(..usize::try_from(month).ok()?.checked_sub(1)?)?;
    if !(1..=*months.get(before.len())?).contains(&day) || hour > 23 || minute > 59 || second > 60 {
        return None;
    }
    let midnight = midnight(year, before.iter().sum::<i64>() + day)?;
    let whole = midnight / NANOSECONDS + hour * 3600 + minute * 60 + second;
    Some(whole as f64 + format!("0.{fraction}").parse::<f64>().ok()?)
}

/// A time (ns since the beginning of 1970) for messages: `2018-01-24T10:51:37.0000Z`.
pub(super) fn written(time: i64) -> String {
    // Years of 365 days guess too late after 1970 and at most one year too early before; from there it goes down.
    let mut year = 1971 + time.div_euclid(365 * DAY);
    let first = |year: i64| midnight(year, 1);
    while first(year).is_none_or(|begin| begin > time) && year > 1900 {
        year -= 1;
    }
    let mut rest = time - first(year).unwrap_or(0);
    let february = if is_leap(year) { 29 } else { 28 };
    let mut month = 1;
    for days in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30] {
        if rest < days * DAY {
            break;
        }
        rest -= days * DAY;
        month += 1;
    }
    let seconds = rest % DAY / NANOSECONDS;
    format!(
        "{year}-{month:02}-{:02}T{:02}:{:02}:{:02}.{:04}Z",
        1 + rest / DAY,
        seconds / 3600,
        seconds / 60 % 60,
        seconds % 60,
        rest % NANOSECONDS / 100_000
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The figures are those of GNU date (`date -u -d '2018-01-24 19:51:37' +%s`).
    #[test]
    fn dates_become_seconds_and_back() {
        for (text, expected) in [
            ("1970/01/01 00:00:00", 0.0),
            ("2018/01/24 19:51:37", 1_516_823_497.0),
            ("20190728_160905.700", 1_564_330_145.7),
            ("2000-03-01T00:00:00", 951_868_800.0),
            ("1900/01/01 00:00:00", -2_208_988_800.0),
            ("2100/12/31 23:59:59", 4_133_980_799.0),
        ] {
            assert_eq!(seconds(text), Some(expected), "{text}");
        }
        for (year, day, text) in [
            (2000, 366, "2000-12-31"),
            (1969, 365, "1969-12-31"),
            (2016, 60, "2016-02-29"),
            (1900, 1, "1900-01-01"),
            (2100, 365, "2100-12-31"),
            (2001, 1, "2001-01-01"),
        ] {
            let time = midnight(year, day).unwrap() + DAY - NANOSECONDS / 10_000;
            assert_eq!(written(time), format!("{text}T23:59:59.9999Z"));
        }
    }

    #[test]
    fn what_is_no_date_is_none() {
        for text in [
            "",
            "2018/01/24",
            "2018/13/01 00:00:00",
            "2018/00/01 00:00:00",
            "2018/02/29 00:00:00",
            "2018/01/00 00:00:00",
            "2018/01/24 24:00:00",
            "2018/01/24 19:60:00",
            "2018/01/24 19:51:61",
            "1850/01/24 19:51:37",
            "2018/01/24 19:51:37.x",
            "a2018/01/24 19:51:37",
            "99999999999999999999",
        ] {
            assert_eq!(seconds(text), None, "{text}");
        }
        assert!(midnight(2019, 366).is_none() && midnight(2019, 0).is_none() && midnight(2101, 1).is_none());
    }
}
