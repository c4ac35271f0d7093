//! The forecast of a rail over the posterior of a calibration.

use riffel::roughness::LevelLimit;
use riffel_calibrate::{BandForecast, CalibrationError, Chains, Forecast, Months, Plan};
use riffel_keys::{Language, Message, fixed, number as numeral, range, say};
use riffel_plot::{Area, LineFigure, LinePanel, LineStyle, Scale, Series};
use riffel_rail::LimitTable;
use serde::Serialize;

use crate::{Answer, Column, Rows, Table};

/// When the rail of a calibration reaches its limit, with bands of 50 and 90 %.
#[derive(Serialize)]
pub struct PosteriorForecast {
    riffel_version: &'static str,
    title: Option<String>,
    limit: String,
    #[serde(flatten)]
    forecast: Forecast,
    remarks: Vec<Message>,
}

impl PosteriorForecast {
    /// The forecast of a plan over its chains, so many months from the last date on.
    ///
    /// # Errors
    /// Errors of [`Forecast::of`].
    pub fn new(
        plan: &Plan,
        chains: &Chains,
        (table, limit): &(LimitTable, LevelLimit),
        months: f64,
    ) -> Result<Self, CalibrationError> {
        let mut remarks = vec![say!(posterior_forecast_is_linear)];
        let doubts = chains.summary(plan).doubts().len();
        if doubts > 0 {
            remarks.push(say!(forecast_on_doubtful_chains, doubts));
        }
        Ok(Self {
            riffel_version: env!("CARGO_PKG_VERSION"),
            title: plan.file.title.clone(),
            limit: table.edition.clone(),
            forecast: Forecast::of(plan, chains, limit, months)?,
            remarks,
        })
    }
}

/// Months as a median with its band of 90 %: "7 (4-13)"; what is not reached within the horizon is "> 240".
fn in_words(months: &Months, horizon: f64) -> String {
    let [low, _, middle, _, high] = months.quantiles;
    let number = |months: Option<f64>| match months {
        Some(months) if months < 10.0 => fixed_text(months, 1),
        Some(months) => fixed_text(months, 0),
        None => format!("> {}", fixed_text(horizon, 0)),
    };
    match (low, middle) {
        (None, None) => number(None),
        _ => format!("{} ({})", number(middle), range([low, high], number)),
    }
}

fn fixed_text(number: f64, digits: usize) -> String {
    format!("{number:.digits$}")
}

const SHARES: [&str; 5] = ["q05", "q25", "q50", "q75", "q95"];

impl Answer for PosteriorForecast {
    fn name(&self) -> &'static str {
        "forecast"
    }

    fn introduction(&self) -> Vec<Message> {
        let forecast = &self.forecast;
        let title = self.title.as_deref().map(Message::verbatim);
        let about =
            say!(posterior_forecast_is_over, draws = forecast.draws, months = fixed(forecast.horizon_months, 0));
        title.into_iter().chain([about]).collect()
    }

    fn tables(&self) -> Vec<Table> {
        let bands = &self.forecast.bands;
        let horizon = self.forecast.horizon_months;
        let mut columns =
            vec![bands.fixed("wavelength_mm", say!(wavelength_of_band), 0, |band| 1e3 * band.wavelength_m)];
        type Of = fn(&BandForecast) -> &[f64; 5];
        let levels: [(&str, Of); 2] =
            [("level_now_db", |band| &band.level_now_db), ("level_then_db", |band| &band.level_then_db)];
        for (name, of) in levels {
            let words = |band: &BandForecast| {
                let [low, _, middle, _, high] = of(band).map(|level| fixed_text(level, 1));
                Message::verbatim(format!("{middle} ({low} … {high})"))
            };
            let head = match name {
                "level_now_db" => say!(level_now_banded),
                _ => say!(level_then_banded),
            };
            // A reader sees the words, a file the numbers.
            columns.push(bands.shown(head, words));
            for (place, share) in SHARES.iter().enumerate() {
                columns.push(bands.plain(&format!("{name}_{share}"), |band| of(band)[place]));
            }
        }
        let limits = bands.iter().map(|band| band.limit_db);
        columns.push(Column::decibels("limit_db".to_owned(), Some(say!(limit_of_band)), limits.collect()));
        columns.push(bands.shown(say!(months_banded), |band| {
            let months = band.months_to_limit.as_ref();
            Message::verbatim(months.map_or_else(String::new, |it| in_words(it, horizon)))
        }));
        for (place, share) in SHARES.iter().enumerate() {
            let months = |band: &BandForecast| band.months_to_limit.as_ref()?.quantiles[place];
            columns.push(bands.plain(&format!("months_to_limit_{share}"), months));
        }
        columns.push(bands.plain("probability_never", |band| Some(band.months_to_limit.as_ref()?.probability_never)));
        vec![Table { name: "forecast", columns }]
    }

    fn sentences(&self) -> Vec<Message> {
        let forecast = &self.forecast;
        let months = &forecast.months_to_limit;
        let [_, low, _, high, _] = months
            .quantiles
            .map(|it| it.map_or_else(|| format!("> {:.0}", forecast.horizon_months), |it| format!("{it:.1}")));
        let mut sentences = vec![say!(
            months_to_the_limit,
            limit = &self.limit,
            months = numeral(in_words(months, forecast.horizon_months)),
            low = numeral(low),
            high = numeral(high)
        )];
        if months.probability_never > 0.0 {
            sentences.push(say!(
                never_within,
                share = fixed(100.0 * months.probability_never, 0),
                months = fixed(forecast.horizon_months, 0)
            ));
        }
        sentences
    }

    fn figure(&self) -> LineFigure {
        self.figure_in(Language::English)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

impl PosteriorForecast {
    /// The picture in a language.
    pub(crate) fn figure_in(&self, language: Language) -> LineFigure {
        let bands = &self.forecast.bands;
        let x: Vec<f64> = bands.iter().map(|band| 1e3 * band.wavelength_m).collect();
        let of = |levels: fn(&BandForecast) -> &[f64; 5], place: usize| -> Vec<f64> {
            bands.iter().map(|band| levels(band)[place]).collect()
        };
        let panel = |subtitle: Message, levels: fn(&BandForecast) -> &[f64; 5]| {
            let area = |label: &str, low: usize, high: usize, shade: u8| Area {
                label: label.to_owned(),
                x: x.clone(),
                low: of(levels, low),
                high: of(levels, high),
                color: riffel_plot::Rgb(shade, shade, 255),
            };
            LinePanel {
                areas: vec![area("90 %", 0, 4, 225), area("50 %", 1, 3, 190)],
                ..LinePanel::new(
                    say!(wavelength_in_millimetres).text(language),
                    say!(level_axis).text(language),
                    [
                        Series::new(say!(median).text(language), x.clone(), of(levels, 2)),
                        Series::new(
                            self.limit.clone(),
                            x.clone(),
                            bands.iter().map(|band| band.limit_db.unwrap_or(f64::NAN)).collect(),
                        )
                        .styled(LineStyle::Dashed),
                    ],
                )
                .titled(subtitle.text(language))
                .scaled(Scale::Log, Scale::Linear)
            }
        };
        let months = self.forecast.horizon_months;
        LineFigure::new(
            self.title.clone().unwrap_or_else(|| say!(forecast).text(language)),
            say!(
                caption_of_posterior_forecast,
                draws = numeral(self.forecast.draws),
                months = numeral(in_words(&self.forecast.months_to_limit, months))
            )
            .text(language),
            [
                panel(say!(at_the_last_date), |band| &band.level_now_db),
                panel(say!(months_later, months = fixed(months, 0)), |band| &band.level_then_db),
            ],
        )
    }
}
