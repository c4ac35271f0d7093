//! The rail right after grinding, in place of a measured one.

use riffel::roughness::{LevelLimit, Spectrum};
use riffel_keys::{CaseError, Message, say};

use crate::{Limit, LimitTable};

/// The spectrum that grinding leaves, with the words for it.
#[derive(Debug, Clone, PartialEq)]
pub struct GroundRail {
    /// Its levels.
    pub spectrum: Spectrum,
    /// What it is, after "from".
    pub words: Message,
}

impl GroundRail {
    /// Every band a number of decibels below a limit, written as in "-6 dB".
    ///
    /// # Errors
    /// The rule, for what is no number of decibels below zero.
    pub fn below(edition: &str, limit: &LevelLimit, decibels: &str) -> Result<Self, String> {
        let change = decibels_of(decibels)?;
        let wrong = |error: riffel::Error| error.to_string();
        let levels = limit.spectrum().map(|band| band.level + change);
        Ok(Self { spectrum: levels.map_err(wrong)?, words: say!(below_limit, decibels = -change, edition) })
    }

    /// The levels of a limit table, such as those that grinding has to meet, by name or file.
    ///
    /// # Errors
    /// Errors of [`LimitTable::find`], and for a table that is not one of levels.
    pub fn of_table(name: &str) -> Result<Self, CaseError> {
        let table = LimitTable::find(name)?;
        match table.limit {
            Limit::Levels(limit) => {
                Ok(Self { spectrum: limit.spectrum().clone(), words: Message::verbatim(table.edition) })
            }
            Limit::Rms(_) => Err(CaseError::data(
                name,
                "holds limits of the RMS, but the spectrum of a ground rail takes one-third-octave levels",
            )),
        }
    }

    /// Whether a name is that of a limit table rather than of a spectrum.
    pub fn is_table(name: &str) -> bool {
        name.ends_with(".toml") || LimitTable::all().iter().any(|table| table.name.eq_ignore_ascii_case(name))
    }
}

/// A change of level below zero.
fn decibels_of(text: &str) -> Result<f64, String> {
    let number = text.trim().replace('\u{2212}', "-");
    let number = number.strip_suffix("dB").unwrap_or(&number).trim();
    match number.parse::<f64>() {
        Ok(change) if change.is_finite() && change < 0.0 => Ok(change),
        _ => Err("a number of decibels below the limit, as in \"-6 dB\"".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel::roughness::ThirdOctave;

    #[test]
    fn levels_are_those_of_the_limit_less_so_many_decibels() {
        let band = ThirdOctave::containing(0.05).unwrap();
        let limit = LevelLimit::new(Spectrum::new([(band, -1.1)]).unwrap());
        for text in ["-6 dB", "-6", " -6.0dB", "\u{2212}6 dB"] {
            let ground = GroundRail::below("ISO", &limit, text).unwrap();
            assert!((ground.spectrum.level(band).unwrap() + 7.1).abs() < 1e-12);
            assert_eq!(ground.words.to_string(), "6 dB below ISO");
        }
        for text in ["6 dB", "0", "six", "-6 mm", "-inf", ""] {
            let refusal = GroundRail::below("ISO", &limit, text).unwrap_err();
            assert!(refusal.contains("below the limit"), "{refusal}");
        }
        assert!(GroundRail::is_table("ISO-3095-2013") && !GroundRail::is_table("rail.csv"));
        assert!(GroundRail::of_table("grassie-1999").is_err());
    }
}
