//! The figure of a diagnosis.

use riffel::diagnosis::{FineBand, FineSpectrum};
use riffel_keys::{Language, Message, fixed, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Mark, OKABE_ITO, Rgb, Scale, Series};
use riffel_rail::history::Curves;

use super::Diagnosis;
use crate::roughness::figure::file_name;

/// Spectra with the dominant wavelengths marked.
pub(super) fn of(diagnosis: &Diagnosis, language: Language) -> LineFigure {
    let (series, label, what) = match &diagnosis.curves {
        Curves::Fine(spectra) => {
            let curve = |spectrum: &FineSpectrum, level: fn(&FineBand) -> f64| {
                let bands = spectrum.bands().iter();
                let points = bands.map(|band| (1e3 * band.wavelength, level(band)));
                let (x, y) = points.unzip();
                Series::new("", x, y)
            };
            let colors = [5, 1, 2, 3, 6, 7].map(|index| OKABE_ITO[index % OKABE_ITO.len()]);
            let mut series: Vec<Series> = spectra
                .iter()
                .enumerate()
                .map(|(index, (name, spectrum))| Series {
                    label: if spectra.len() > 1 { name.text(language) } else { say!(measured_word).text(language) },
                    color: Some(colors[index % colors.len()]),
                    ..curve(spectrum, |band| band.level)
                })
                .collect();
            series.extend(spectra.first().map(|(_, spectrum)| Series {
                label: say!(trend_of_neighbours).text(language),
                style: LineStyle::Dashed,
                color: Some(Rgb(0, 0, 0)),
                ..curve(spectrum, |band| band.trend)
            }));
            (series, say!(fine_level_axis), say!(how_fine_bands_are))
        }
        Curves::Levels(groups) => {
            let series = groups.iter().enumerate().map(|(index, (name, mean))| {
                Series::new(
                    name.text(language),
                    mean.levels().iter().map(|level| 1e3 * level.band.wavelength()).collect(),
                    mean.levels().iter().map(|level| level.level).collect(),
                )
                .colored(OKABE_ITO[index % OKABE_ITO.len()])
            });
            (series.collect(), say!(level_axis), say!(means_of_levels))
        }
    };
    let marks = diagnosis.findings.iter().map(|finding| {
        let wavelength = 1e3 * finding.measured.peak.wavelength;
        let leads = match (finding.sideband, finding.candidates.first()) {
            (Some(sideband), _) => say!(beside_wave, wavelength = fixed(1e3 * sideband.of, 1)),
            (None, Some(leads)) => finding.name(leads),
            (None, None) => Message::verbatim(""),
        };
        let label = say!(perhaps_made_by, wavelength = fixed(wavelength, 1), mechanism = leads);
        Mark { x: wavelength, label: label.text(language) }
    });
    LineFigure::new(
        say!(dominant_wavelengths).text(language),
        say!(
            caption_of_diagnosis,
            file = file_name(std::path::Path::new(&diagnosis.file)),
            record = diagnosis.words.clone(),
            bands = what
        )
        .text(language),
        [LinePanel {
            marks: marks.collect(),
            ..LinePanel::new(say!(wavelength_axis).text(language), label.text(language), series)
                .scaled(Scale::Log, Scale::Linear)
        }],
    )
}
