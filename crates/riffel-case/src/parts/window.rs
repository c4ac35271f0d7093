//! What wavelengths and speeds of a case are a window of.

use riffel_keys::{Message, say};

/// What the window of wavelengths and speeds of a case is, which sentences name.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Window {
    /// The growth map, as the case file says.
    Map,
    /// Bands of the spectrum at the speeds of a vehicle.
    Traffic,
    /// Bands of a wheel whose remarks nobody reads: those of another wheel of its vehicle stand for all, and none are made.
    BesideAnother,
}

impl Window {
    /// Its name, for messages.
    pub(crate) fn name(self) -> Message {
        match self {
            Self::Map => say!(map_window),
            Self::Traffic | Self::BesideAnother => say!(traffic_window),
        }
    }
}
