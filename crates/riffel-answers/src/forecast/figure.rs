//! The figure of a forecast.

use riffel_case::Case;
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale, Series};

use super::{ForecastAnswer, number};
use crate::roughness::figure::{level_panel, levels};

pub(super) fn figure(answer: &ForecastAnswer, case: &Case) -> LineFigure {
    let traffic = answer.growth();
    let rail = answer.leading();
    let prefix = answer.prefix(rail);
    let now = match &answer.ground {
        Some(_) => "after grinding",
        None => "now",
    };
    let now = format!("{prefix}{now}");
    let now = levels(
        &now,
        &rail.measured.spectrum,
        LineStyle::Solid,
        OKABE_ITO[1],
    );
    let valid_to = rail.forecast.valid_to();
    let (until, end) = match answer.passages <= valid_to {
        true => (answer.passages, ""),
        false => (valid_to, ", where the forecast ends"),
    };
    let bands = || rail.forecast.bands().iter();
    let then = Series {
        label: format!("{prefix}after {} MGT{end}", number(traffic.mgt(until))),
        x: bands()
            .map(|band| 1e3 * band.now.band.wavelength())
            .collect(),
        y: bands().map(|band| band.level(until)).collect(),
        style: LineStyle::Solid,
        color: Some(OKABE_ITO[2]),
    };
    let limit = levels(
        &answer.table.edition,
        answer.limit.spectrum(),
        LineStyle::Dashed,
        Rgb::BLACK,
    );
    let wavelengths: Vec<f64> = traffic.wavelengths().iter().map(|w| 1e3 * w).collect();
    let rate = |label: String, rates: &[f64], color| Series {
        label,
        x: wavelengths.clone(),
        y: rates.iter().map(|rate| super::per_million(*rate)).collect(),
        style: LineStyle::Solid,
        color: Some(color),
    };
    let mut rates: Vec<Series> = traffic
        .vehicles()
        .iter()
        .enumerate()
        .map(|(index, vehicle)| {
            let color = OKABE_ITO[1 + index % (OKABE_ITO.len() - 1)];
            let label = format!("by {}, {:.0} %", vehicle.name, 100.0 * vehicle.share);
            let own = vehicle.growth.rates.iter();
            let parts: Vec<f64> = own.map(|rate| vehicle.share * rate).collect();
            rate(label, &parts, color)
        })
        .collect();
    rates.push(rate("mix".to_owned(), traffic.rates(), Rgb::BLACK));
    rates.push(zero(&wavelengths));
    let leads = match prefix.trim_end() {
        "" => String::new(),
        name => format!(" Levels are those of {name}, which leads."),
    };
    let mut panels = vec![
        level_panel(match until > 0.0 {
            true => vec![now, then, limit],
            false => vec![now, limit],
        }),
        rate_panel(rates),
    ];
    panels.extend(crack_panel(answer, until));
    let title = case.file.title.clone();
    LineFigure {
        title: title.unwrap_or_else(|| "Growth forecast".to_owned()),
        caption: format!(
            "After {}. One-third-octave levels; growth of the level by wavelength, positive where corrugation \
             grows: what each kind of vehicle adds, and their sum. The forecast ends where the wheel leaves the rail.{leads}",
            answer.amount(until)
        ),
        panels,
        arrangement: Arrangement::Stacked,
    }
}

/// Length of cracks over the passages at the phases of the wave where they become longest; none where none
/// grows.
fn crack_panel(answer: &ForecastAnswer, until: f64) -> Option<LinePanel> {
    const STEPS: u32 = 24;
    let longest = (answer.cracks().into_iter())
        .max_by(|a, b| a.crack_length_m.total_cmp(&b.crack_length_m))
        .filter(|longest| longest.crack_length_m > 0.0)?;
    let forecast = &answer.leading().forecast;
    let mut bands = forecast.bands().iter();
    let band = bands.find(|band| band.now.band.wavelength() == longest.wavelength_m)?;
    let passages: Vec<f64> = (0..=STEPS)
        .map(|step| until * f64::from(step) / f64::from(STEPS))
        .collect();
    let courses = passages
        .iter()
        .map(|&passages| forecast.cracks(band, passages));
    let courses: Vec<_> = courses.collect::<Option<Vec<_>>>()?;
    let (x_label, x): (_, Vec<f64>) = match answer.on.passages_per_month() {
        Some(per_month) => ("months", passages.iter().map(|p| p / per_month).collect()),
        None => (
            "10⁶ axle passages",
            passages.iter().map(|p| 1e-6 * p).collect(),
        ),
    };
    let names = ["crest", "falling flank", "trough", "rising flank"];
    let series = names.iter().enumerate().map(|(phase, name)| Series {
        label: (*name).to_owned(),
        x: x.clone(),
        y: courses
            .iter()
            .map(|course| 1e3 * course[phase].length)
            .collect(),
        style: match phase % 2 {
            0 => LineStyle::Solid,
            _ => LineStyle::Dashed,
        },
        color: Some(OKABE_ITO[1 + phase]),
    });
    Some(LinePanel {
        subtitle: format!("cracks at {} mm", band.now.band.nominal_millimetres()),
        x_label: x_label.to_owned(),
        y_label: "length of a crack [mm]".to_owned(),
        series: series.collect(),
        ..LinePanel::default()
    })
}

/// Growth over wavelength.
pub(crate) fn rate_panel(series: Vec<Series>) -> LinePanel {
    LinePanel {
        x_label: "wavelength λ [mm]".to_owned(),
        y_label: "growth [dB per 10⁶ passages]".to_owned(),
        x_scale: Scale::Log,
        series,
        ..LinePanel::default()
    }
}

/// Neither growth nor decay.
pub(crate) fn zero(wavelengths: &[f64]) -> Series {
    Series {
        label: String::new(),
        x: wavelengths
            .first()
            .into_iter()
            .chain(wavelengths.last())
            .copied()
            .collect(),
        y: vec![0.0; 2],
        style: LineStyle::Dotted,
        color: Some(Rgb::BLACK),
    }
}
