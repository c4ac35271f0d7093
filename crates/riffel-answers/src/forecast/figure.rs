//! The figure of a forecast.

use riffel_case::Case;
use riffel_case::traffic::vehicle_in_words;
use riffel_keys::{Language, Message, fixed, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::{TrackForecast, number};
use crate::roughness::figure::{level_panel, levels};

pub(super) fn figure(answer: &TrackForecast, case: &Case, language: Language) -> LineFigure {
    let traffic = answer.growth();
    let rail = answer.leading();
    let of_rail = |words: Message| match answer.rail(rail) {
        Some(rail) => say!(rail_when, rail, time = words).text(language),
        None => words.text(language),
    };
    let now = of_rail(match &answer.ground {
        Some(_) => say!(after_grinding),
        None => say!(now),
    });
    let now = levels(&now, &rail.start.levels.spectrum, LineStyle::Solid, OKABE_ITO[1]);
    let valid_to = rail.forecast.valid_to();
    let until = answer.passages.min(valid_to);
    let tonnes = number(traffic.mgt(until));
    let after = match answer.passages <= valid_to {
        true => say!(after_tonnes, tonnes),
        false => say!(after_tonnes_at_end, tonnes),
    };
    let bands = || rail.forecast.bands().iter();
    let then = Series::new(
        of_rail(after),
        bands().map(|band| 1e3 * band.now.band.wavelength()).collect(),
        bands().map(|band| band.level(until)).collect(),
    )
    .colored(OKABE_ITO[2]);
    let limit = levels(&answer.table.edition, answer.limit.spectrum(), LineStyle::Dashed, Rgb::BLACK);
    let wavelengths: Vec<f64> = traffic.wavelengths().iter().map(|w| 1e3 * w).collect();
    let rate = |label: String, rates: &[f64], color| {
        Series::new(label, wavelengths.clone(), rates.iter().map(|rate| super::per_million(*rate)).collect())
            .colored(color)
    };
    let mut rates: Vec<Series> = traffic
        .vehicles()
        .iter()
        .enumerate()
        .map(|(index, vehicle)| {
            let color = OKABE_ITO[1 + index % (OKABE_ITO.len() - 1)];
            let percent = fixed(100.0 * vehicle.share, 0);
            let label = say!(by_vehicle, vehicle = vehicle_in_words(&vehicle.name), percent).text(language);
            let own = vehicle.growth.rates.iter();
            let parts: Vec<f64> = own.map(|rate| vehicle.share * rate).collect();
            rate(label, &parts, color)
        })
        .collect();
    rates.push(rate(say!(mix_of_vehicles).text(language), traffic.rates(), Rgb::BLACK));
    rates.push(zero(&wavelengths));
    let caption = say!(caption_of_forecast, amount = answer.amount(until)).text(language);
    let caption = match answer.rail(rail) {
        Some(rail) => caption + " " + &say!(levels_of_leading_rail, rail).text(language),
        None => caption,
    };
    let mut panels = vec![
        level_panel(
            match until > 0.0 {
                true => vec![now, then, limit],
                false => vec![now, limit],
            },
            language,
        ),
        rate_panel(rates, language),
    ];
    panels.extend(crack_panel(answer, until, language));
    let title = case.file.title.clone();
    LineFigure::new(title.unwrap_or_else(|| say!(growth_forecast).text(language)), caption, panels)
        .arranged(Arrangement::Stacked)
}

/// Length of cracks over the passages at the phases of the wave where they become longest; `None` if none
/// grows.
fn crack_panel(answer: &TrackForecast, until: f64, language: Language) -> Option<LinePanel> {
    const STEPS: u32 = 24;
    let longest = (answer.cracks().into_iter())
        .max_by(|a, b| a.crack_length_m.total_cmp(&b.crack_length_m))
        .filter(|longest| longest.crack_length_m > 0.0)?;
    let forecast = &answer.leading().forecast;
    let mut bands = forecast.bands().iter();
    let band = bands.find(|band| band.now.band.wavelength() == longest.wavelength_m)?;
    let passages: Vec<f64> = (0..=STEPS).map(|step| until * f64::from(step) / f64::from(STEPS)).collect();
    let courses = passages.iter().map(|&passages| forecast.cracks(band, passages));
    let courses: Vec<_> = courses.collect::<Option<Vec<_>>>()?;
    let (x_label, x): (_, Vec<f64>) = match answer.on.passages_per_month() {
        Some(per_month) => (say!(months_axis), passages.iter().map(|p| p / per_month).collect()),
        None => (say!(million_passages_axis), passages.iter().map(|p| 1e-6 * p).collect()),
    };
    let names = [say!(crest), say!(falling_flank), say!(trough), say!(rising_flank)];
    let series = names.iter().enumerate().map(|(phase, name)| {
        Series::new(name.text(language), x.clone(), courses.iter().map(|course| 1e3 * course[phase].length).collect())
            .styled(match phase % 2 {
                0 => LineStyle::Solid,
                _ => LineStyle::Dashed,
            })
            .colored(OKABE_ITO[1 + phase])
    });
    Some(
        LinePanel::new(x_label.text(language), say!(crack_axis).text(language), series)
            .titled(say!(cracks_at, wavelength = band.now.band.nominal_millimetres()).text(language)),
    )
}

/// Growth over wavelength.
pub(crate) fn rate_panel(series: Vec<Series>, language: Language) -> LinePanel {
    LinePanel::new(say!(wavelength_axis).text(language), say!(growth_axis).text(language), series)
        .scaled(Scale::Log, Scale::Linear)
}

/// Neither growth nor decay.
pub(crate) fn zero(wavelengths: &[f64]) -> Series {
    Series::new("", wavelengths.first().into_iter().chain(wavelengths.last()).copied().collect(), vec![0.0; 2])
        .styled(LineStyle::Dotted)
        .colored(Rgb::BLACK)
}
