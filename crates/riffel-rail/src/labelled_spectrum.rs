//! A one-third-octave spectrum with its labels.

use riffel::roughness::Spectrum;

/// A spectrum with what the file says of it.
#[derive(Debug, Clone, PartialEq)]
pub struct LabelledSpectrum {
    /// The other columns of its rows and what they hold, in the order of the file.
    pub labels: Vec<(String, String)>,
    /// The spectrum.
    pub spectrum: Spectrum,
}

impl LabelledSpectrum {
    /// The spectrum of one rail of a profile.
    pub fn of_rail(name: &str, spectrum: Spectrum) -> Self {
        Self { labels: vec![("rail".to_owned(), name.to_owned())], spectrum }
    }

    /// What a column holds.
    pub fn label(&self, column: &str) -> Option<&str> {
        let same = |label: &&(String, String)| label.0 == column;
        self.labels.iter().find(same).map(|label| label.1.as_str())
    }
}
