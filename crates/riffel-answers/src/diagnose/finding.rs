//! A finding: one dominant wavelength with its candidates, in words.

use riffel::diagnosis::{Candidate, MechanismKind, TrafficSpeeds};
use riffel_keys::decimal;
use riffel_rail::history::Measured;

/// A dominant wavelength with what may have made it.
pub struct Finding {
    /// What stands out, and what it did in time.
    pub measured: Measured,
    /// What may have made it, the likeliest first.
    pub candidates: Vec<Candidate>,
    /// What would tell the candidates apart.
    pub measurements: Vec<String>,
}

impl Finding {
    /// Wavelength and frequencies.
    pub fn headline(&self, speeds: &TrafficSpeeds) -> String {
        let peak = &self.measured.peak;
        format!(
            "dominant wavelength {:.1} mm ({:.1}–{:.1} mm), {}{}",
            1e3 * peak.wavelength,
            1e3 * peak.from,
            1e3 * peak.to,
            self.place()
                .map_or_else(String::new, |place| format!("{place}, ")),
            frequencies(peak.wavelength, speeds)
        )
    }

    /// Rail and place: "rail low, 1200–1240 m and 2 more places".
    pub fn place(&self) -> Option<String> {
        let Measured {
            rail,
            places,
            all_along,
            ..
        } = &self.measured;
        let name = match rail.as_deref()? {
            name if name.starts_with("rail") || name.starts_with("column") => name.to_owned(),
            name => format!("rail {name}"),
        };
        let first = places.first().filter(|_| !all_along);
        let where_on = match first {
            Some(first) => format!(", {}–{} m", decimal(first.from, 1), decimal(first.to, 1)),
            // A table of levels has no places.
            None if places.is_empty() => String::new(),
            None => ", all along".to_owned(),
        };
        let more = match places.len() {
            0 | 1 => String::new(),
            2 => " and one more place".to_owned(),
            count => format!(" and {} more places", count - 1),
        };
        Some(name + &where_on + &more)
    }

    /// Level, prominence and how sure.
    pub fn sureness(&self) -> String {
        let peak = &self.measured.peak;
        let scatter = peak.scatter.map_or_else(
            || "scatter unknown, one spectrum only".to_owned(),
            |scatter| format!("scatter {scatter:.1} dB"),
        );
        let chance = peak.false_peaks.map_or_else(String::new, |peaks| {
            if peaks < 1e-6 {
                "; by chance in less than one spectrum of a million".to_owned()
            } else {
                format!("; by chance in one spectrum of {:.0}", 1.0 / peaks)
            }
        });
        let rails = &self.measured.rails;
        let rails: Vec<String> = rails
            .iter()
            .map(|(name, level)| format!("{name} {level:.1}"))
            .collect();
        let rails = if rails.is_empty() {
            String::new()
        } else {
            format!(" ({})", rails.join(", "))
        };
        let harmonic = peak
            .harmonic_of
            .map_or_else(String::new, |(number, longer)| {
                format!("; harmonic {number} of {:.1} mm", 1e3 * longer)
            });
        let record = &self.measured.record;
        let record = record
            .as_ref()
            .map_or_else(String::new, |record| format!(", record {record}"));
        format!(
            "level {:.1} dB re 1 µm{record}{rails}, {:.1} dB over the trend of its neighbours ({scatter}){chance}{harmonic}",
            peak.level, peak.prominence
        )
    }

    /// What the course says, with the means of energies beside those of levels.
    pub fn course(&self) -> Option<String> {
        let course = self.measured.course.as_ref()?;
        let energy = self
            .measured
            .energy_levels
            .as_ref()
            .map_or_else(String::new, |levels| {
                let levels: Vec<String> =
                    levels.iter().map(|level| format!("{level:.1}")).collect();
                format!("; means of energies {}", levels.join(", "))
            });
        Some(format!("{}{energy}", course.words()))
    }

    /// The candidates in one sentence: who leads, who is next, and what the course rules out.
    pub fn summary(&self) -> String {
        let [first, second, ..] = &self.candidates[..] else {
            return String::new();
        };
        let mut text = format!(
            "{} leads with a share of {:.2}, next is {} with {:.2}.",
            first.name(),
            first.share,
            second.name(),
            second.share
        );
        let rises = self
            .measured
            .course
            .as_ref()
            .map(|course| course.probability_of_rise());
        match rises {
            Some(rises) if rises < 0.05 => {
                text += &format!(
                    " The level falls with a probability of {}, as {} does and growing corrugation does not.",
                    percent(1.0 - rises),
                    match first.kind {
                        MechanismKind::GrindingMark => "a fading grinding mark",
                        _ => "a fading mark",
                    }
                );
                if first.kind == MechanismKind::GrindingMark {
                    text += " Best read as a fading grinding mark and not growing corrugation.";
                }
            }
            Some(rises) if rises > 0.95 => {
                text += &format!(
                    " The level rises with a probability of {}, as corrugation under traffic does and a grinding mark \
                     does not.",
                    percent(rises)
                );
            }
            Some(rises) => {
                text += &format!(
                    " Whether the level rises is open (probability {:.0} %).",
                    100.0 * rises
                );
            }
            None => text += " There is one record only: whether it grows is not known.",
        }
        text
    }
}

/// Frequencies of a wavelength at the speeds of the traffic: "1375–1958 Hz at 99–141 km/h".
fn frequencies(wavelength: f64, speeds: &TrafficSpeeds) -> String {
    let (low, high) = (speeds.slowest() / wavelength, speeds.fastest() / wavelength);
    let range = if high - low < 0.5 {
        format!("{low:.0} Hz")
    } else {
        format!("{low:.0}–{high:.0} Hz")
    };
    format!("{range} at {}", speeds.words())
}

fn percent(probability: f64) -> String {
    if probability > 0.9995 {
        "more than 99.9 %".to_owned()
    } else {
        format!("{:.1} %", 100.0 * probability)
    }
}
