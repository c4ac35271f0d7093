//! What was measured now and before.

use jiff::civil::Date;
use riffel_rail::Survey;

use crate::arguments::Spectra;
use crate::command::roughness::survey;
use crate::error::CliError;

/// The survey of now and the one before, with the days between if they are dated.
pub(super) struct Dated {
    pub(super) now: Survey,
    pub(super) earlier: Option<Survey>,
    pub(super) date: Option<Date>,
    pub(super) days: Option<f64>,
}

impl Dated {
    /// Chosen of all spectra of `--spectrum`, and of those of `--earlier`, which are read here.
    pub(super) fn new(spectra: &Spectra, now: Survey) -> miette::Result<Self> {
        let mut now_chosen = now.clone().choose(&spectra.choose)?.on_one_device();
        let dates = in_order(spectra)?;
        let earlier = match (spectra.earlier.first(), &spectra.earlier_choose[..]) {
            (Some(path), choices) => Some(survey(path, &spectra.layout)?.choose(choices)?),
            (None, choices @ [_, ..]) => Some(now.choose(choices)?),
            (None, []) => None,
        };
        if let Some(earlier) = &earlier {
            let device = now_chosen.device_since(earlier);
            now_chosen.warnings.extend(device);
        }
        let Some(column) = &spectra.date_column else {
            return Ok(Self {
                now: now_chosen,
                earlier,
                date: dates.map(|(date, _)| date),
                days: dates.map(|(_, days)| days),
            });
        };
        // The latest date of what is now, the earliest of what was before.
        let mut dates = now_chosen.by_date(column)?;
        let earliest = match &earlier {
            Some(earlier) => Some(earlier.by_date(column)?.swap_remove(0)),
            None if dates.len() > 1 => Some(dates[0].clone()),
            None => None,
        };
        let (date, now) = dates.swap_remove(dates.len() - 1);
        let days = match &earliest {
            Some((before, _)) => {
                let span = date.since(*before).map_err(|error| CliError::Argument {
                    argument: "--date-column",
                    value: column.clone(),
                    rule: format!("dates that can be compared: {error}"),
                })?;
                let days = f64::from(span.get_days());
                if days <= 0.0 {
                    Err(CliError::Argument {
                        argument: "--earlier",
                        value: before.to_string(),
                        rule: format!("earlier than {date}, the date of the spectrum"),
                    })?;
                }
                Some(days)
            }
            None => None,
        };
        Ok(Self {
            now,
            earlier: earliest.map(|(_, survey)| survey),
            date: Some(date),
            days,
        })
    }
}

/// The date of `--spectrum` by `--dates`, and the days since the oldest `--earlier`; none without dates.
fn in_order(spectra: &Spectra) -> Result<Option<(Date, f64)>, CliError> {
    let (dates, records) = (&spectra.dates, spectra.earlier.len() + 1);
    let wrong = |rule: String| {
        let written: Vec<String> = dates.iter().map(Date::to_string).collect();
        CliError::Argument {
            argument: "--dates",
            value: written.join(","),
            rule,
        }
    };
    let [oldest, .., latest] = dates[..] else {
        return match dates.is_empty() {
            true => Ok(None),
            false => Err(wrong(format!("{records} dates, the oldest first"))),
        };
    };
    if dates.len() != records || !dates.is_sorted_by(|one, next| one < next) {
        let rule = format!(
            "{records} dates, one for each --earlier and one for --spectrum, the oldest first"
        );
        return Err(wrong(rule));
    }
    let span = latest.since(oldest);
    let span = span.map_err(|error| wrong(format!("dates that can be compared: {error}")))?;
    Ok(Some((latest, f64::from(span.get_days()))))
}
