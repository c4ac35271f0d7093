//! The figure of a diagnosis.

use riffel::diagnosis::{Candidate, FineBand, FineSpectrum};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Mark, OKABE_ITO, Rgb, Scale, Series};
use riffel_rail::history::Curves;

use super::Diagnosis;

/// Spectra with the dominant wavelengths marked.
pub(super) fn of(file: &str, diagnosis: &Diagnosis) -> LineFigure {
    let (series, label, what) = match &diagnosis.curves {
        Curves::Fine(spectra) => {
            let curve = |spectrum: &FineSpectrum, level: fn(&FineBand) -> f64| {
                let bands = spectrum.bands().iter();
                let points = bands.map(|band| (1e3 * band.wavelength, level(band)));
                let (x, y) = points.unzip();
                Series {
                    x,
                    y,
                    ..Series::default()
                }
            };
            let colors = [5, 1, 2, 3, 6, 7].map(|index| OKABE_ITO[index % OKABE_ITO.len()]);
            let mut series: Vec<Series> = spectra
                .iter()
                .enumerate()
                .map(|(index, (name, spectrum))| Series {
                    label: if spectra.len() > 1 {
                        name.clone()
                    } else {
                        "measured".to_owned()
                    },
                    color: Some(colors[index % colors.len()]),
                    ..curve(spectrum, |band| band.level)
                })
                .collect();
            series.extend(spectra.first().map(|(_, spectrum)| Series {
                label: "trend of the neighbours".to_owned(),
                style: LineStyle::Dashed,
                color: Some(Rgb(0, 0, 0)),
                ..curve(spectrum, |band| band.trend)
            }));
            (
                series,
                "level in 1/24 octave [dB re 1 µm]",
                "Bands of 1/24 octave, at least one line of the transform wide; trend of the first curve.",
            )
        }
        Curves::Levels(groups) => {
            let series = groups
                .iter()
                .enumerate()
                .map(|(index, (name, mean))| Series {
                    label: name.clone(),
                    x: mean
                        .levels()
                        .iter()
                        .map(|level| 1e3 * level.band.wavelength())
                        .collect(),
                    y: mean.levels().iter().map(|level| level.level).collect(),
                    color: Some(OKABE_ITO[index % OKABE_ITO.len()]),
                    ..Series::default()
                });
            (
                series.collect(),
                "level [dB re 1 µm]",
                "Means of one-third-octave levels.",
            )
        }
    };
    let marks = diagnosis.findings.iter().map(|finding| {
        let wavelength = 1e3 * finding.measured.peak.wavelength;
        let leads = finding
            .candidates
            .first()
            .map_or_else(String::new, Candidate::name);
        Mark {
            x: wavelength,
            label: format!("{wavelength:.1} mm: {leads}?"),
        }
    });
    LineFigure {
        title: "Dominant wavelengths".to_owned(),
        caption: format!(
            "{}: {}. {what} Named at each wavelength is the candidate that leads; the list has the others and the \
             reasons.",
            std::path::Path::new(file)
                .file_name()
                .unwrap_or_default()
                .to_string_lossy(),
            diagnosis.words
        ),
        panels: vec![LinePanel {
            x_label: "wavelength λ [mm]".to_owned(),
            y_label: label.to_owned(),
            x_scale: Scale::Log,
            series,
            marks: marks.collect(),
            ..LinePanel::default()
        }],
        ..LineFigure::default()
    }
}
