//! What wavelengths and speeds of a case are a window of.

use riffel_keys::{Language, Sentence};

/// What the window of wavelengths and speeds of a case is, which sentences name.
#[derive(Clone, Copy)]
pub(crate) enum Window {
    /// The growth map, as the case file says.
    Map,
    /// Bands of the spectrum at the speeds of a vehicle.
    Traffic,
}

impl Window {
    /// Its name, for sentences.
    pub(crate) fn name(self, language: Language) -> &'static str {
        match self {
            Self::Map => language.say(Sentence::MapWindow),
            Self::Traffic => language.say(Sentence::TrafficWindow),
        }
    }
}
