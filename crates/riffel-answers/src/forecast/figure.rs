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
    let title = case.file.title.clone();
    LineFigure {
        title: title.unwrap_or_else(|| "Growth forecast".to_owned()),
        caption: format!(
            "After {}. One-third-octave levels; growth of the level by wavelength, positive where corrugation \
             grows: what each kind of vehicle adds, and their sum. The forecast ends where the wheel leaves the rail.{leads}",
            answer.amount(until)
        ),
        panels: vec![
            level_panel(match until > 0.0 {
                true => vec![now, then, limit],
                false => vec![now, limit],
            }),
            rate_panel(rates),
        ],
        arrangement: Arrangement::Stacked,
    }
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
