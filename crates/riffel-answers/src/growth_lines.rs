//! Growth over wavelength of several things side by side: as it is, and each over its own largest.

use riffel_plot::{LinePanel, LineStyle, Rgb, Series};

use crate::forecast::zero;
use crate::{Column, Highest, Table, column};

/// Growth of one thing at the wavelengths of the figure.
pub(crate) struct GrowthLine<'a> {
    /// Name in the legend.
    pub(crate) label: &'a str,
    /// Growth rates per passage \[-\].
    pub(crate) rates: &'a [f64],
    /// Marked, if anything grows.
    pub(crate) highest: Option<Highest>,
    pub(crate) color: Rgb,
    pub(crate) style: LineStyle,
}

/// One row for each wavelength \[m\], a column for each name with its growth rates per passage \[-\].
pub(crate) fn table<'a>(wavelengths: &[f64], lines: impl Iterator<Item = (&'a str, &'a [f64])>) -> Table {
    let (names, rates): (Vec<&str>, Vec<&[f64]>) = lines.unzip();
    let names = column::names(names, "growth_rate_per_passage");
    let columns = names.iter().zip(rates).map(|(name, rates)| Column::in_file(name, rates.iter().copied()));
    let wavelengths = Column::in_file("wavelength_m", wavelengths.iter().copied());
    Table { name: "growth", columns: [wavelengths].into_iter().chain(columns).collect() }
}

/// Two panels over the wavelengths \[m\]: rates, and rates over the largest of each, which is of "each `what`".
pub(crate) fn panels<'a>(
    wavelengths: &[f64],
    lines: impl Iterator<Item = GrowthLine<'a>>,
    what: &str,
) -> Vec<LinePanel> {
    let millimetres: Vec<f64> = wavelengths.iter().map(|w| 1e3 * w).collect();
    let mut absolute = Vec::new();
    let mut relative = Vec::new();
    for line in lines {
        let rates = line.rates.iter();
        let largest = rates.fold(0.0, |largest: f64, rate| largest.max(rate.abs()));
        for (series, label, scale) in [(&mut absolute, line.label, 1e6), (&mut relative, "", largest.recip())] {
            series.push(
                Series::new(label, millimetres.clone(), line.rates.iter().map(|rate| scale * rate).collect())
                    .styled(line.style)
                    .colored(line.color),
            );
            if let Some(highest) = line.highest {
                series.push(
                    Series::new("", vec![1e3 * highest.wavelength], vec![scale * highest.rate])
                        .styled(LineStyle::Markers)
                        .colored(line.color),
                );
            }
        }
    }
    absolute.push(zero(&millimetres));
    relative.push(zero(&millimetres));
    let x_label = "wavelength λ [mm]";
    vec![
        LinePanel::new(x_label, "growth rate [10⁻⁶ per passage]", absolute).titled("growth rate"),
        LinePanel {
            y_range: Some((-1.05, 1.05)),
            ..LinePanel::new(x_label, "growth rate / largest [-]", relative)
                .titled(format!("over the largest of each {what}"))
        },
    ]
}
