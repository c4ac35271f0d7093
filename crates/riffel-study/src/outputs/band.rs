//! Bands of wavelength.

use riffel::roughness::{ThirdOctave, WavelengthBand};
use riffel_case::Case;
use riffel_keys::{CaseError, KeyFile, say};

use super::file::{BandSet, OutputsFile};

/// A band and the wavelengths of the map that lie in it, by number.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Shortest wavelength \[m\].
    pub from: f64,
    /// Longest wavelength \[m\].
    pub to: f64,
    pub(super) lines: std::ops::Range<usize>,
}

/// The bands that a plan asks for.
pub(super) fn bands(source: &KeyFile, file: &OutputsFile, case: &Case) -> Result<Vec<Band>, CaseError> {
    let wavelengths = case.wavelength.values();
    let band = |from: f64, to: f64, open: bool| {
        let first = wavelengths.partition_point(|&wavelength| wavelength < from);
        let last = wavelengths.partition_point(|&wavelength| match open {
            true => wavelength < to,
            false => wavelength <= to,
        });
        Band { from, to, lines: first..last }
    };
    let (first, last) = (case.wavelength.min(), case.wavelength.max());
    let bands: Vec<Band> = match file.growth_by_band {
        None => {
            let mut bands = Vec::new();
            for (index, written) in file.band.iter().enumerate() {
                let (from, to) = (written.from.si(), written.to.si());
                let key = format!("outputs.band[{index}]");
                WavelengthBand::new(from, to).map_err(|error| source.invalid(&key, error.to_string(), ""))?;
                let band = band(from, to, false);
                if band.lines.is_empty() {
                    let rule = format!(
                        "holds no wavelength of the map, which has {} from {first} m to {last} m",
                        wavelengths.len()
                    );
                    return Err(source.invalid(&key, &rule, "widen map.wavelength, by [set] or in the case"));
                }
                bands.push(band);
            }
            bands
        }
        Some(_) if !file.band.is_empty() => {
            return Err(source.invalid(
                "outputs.band",
                say!(and_exclude_each_other, other = "outputs.growth_by_band"),
                say!(give_one_of_the_two),
            ));
        }
        Some(BandSet::Grinding) => {
            WavelengthBand::GRINDING.iter().map(|grinding| band(grinding.from(), grinding.to(), true)).collect()
        }
        Some(BandSet::OneThirdOctaves) => {
            // An axis has wavelengths above zero.
            let ends = ThirdOctave::containing(first).and_then(|low| Ok((low, ThirdOctave::containing(last)?)));
            let ends = ends.map_err(|error| source.invalid("outputs.growth_by_band", error.to_string(), ""))?;
            ThirdOctave::between(ends.0, ends.1)
                .map(|octave| {
                    let (from, to) = octave.wavelength_range();
                    band(from, to, true)
                })
                .collect()
        }
    };
    Ok(bands.into_iter().filter(|band| !band.lines.is_empty()).collect())
}
