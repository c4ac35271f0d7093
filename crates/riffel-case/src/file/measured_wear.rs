//! Wear of the rail under study as it was measured.

use riffel_keys::quantity::{Kind, Length, Mass, Quantity, Ratio};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

/// Depth worn off the head of the rail under study in the mean over the width of wear, and the traffic that wore it off.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredWear {
    /// Depth worn off the head.
    pub depth: Quantity<Length>,
    /// Gross mass of the trains that wore it off, as in "100 MGT"; left out, that.
    #[serde(default = "MeasuredWear::default_per")]
    pub per: Quantity<Mass>,
    /// Factor either way within which the wear is known (80 %).
    #[serde(default = "MeasuredWear::default_factor")]
    pub factor: Quantity<Ratio>,
}

/// A million tonnes as sentences write it.
const MILLION_TONNES: [&str; 5] = ["Mt", "Mio. t", "Mio t", "million tonnes", "million t"];

impl MeasuredWear {
    /// Factor within which a wear that was measured is known, where nothing is said of it (80 %). Chosen: two surveys of a head with 0.2 mm of
    /// error each, a millimetre apart.
    pub const FACTOR: f64 = 1.5;

    fn default_per() -> Quantity<Mass> {
        Quantity::new(riffel::MeanWear::HUNDRED_MILLION_TONNES)
    }

    fn default_factor() -> Quantity<Ratio> {
        Quantity::new(Self::FACTOR)
    }

    /// Depth under 100 million gross tonnes \[m\].
    pub fn depth_per_100_mgt(&self) -> f64 {
        self.depth.si() * riffel::MeanWear::HUNDRED_MILLION_TONNES / self.per.si()
    }

    /// Depth and traffic of the short text, "1.2 mm / 100 MGT" or "1.2 mm per 100 MGT"; a traffic of a unit alone is one of it.
    pub(crate) fn in_words(text: &str) -> Option<[String; 2]> {
        let (depth, per) = text.rsplit_once('/').or_else(|| text.split_once(" per "))?;
        let (depth, per) = (depth.trim(), per.trim());
        let count = MILLION_TONNES.iter().find_map(|it| per.strip_suffix(it));
        let per = count.map_or_else(|| per.to_owned(), |count| format!("{count}MGT"));
        let per = match per.starts_with(|first: char| first.is_ascii_digit() || first == '.') {
            true => per,
            false => format!("1 {per}"),
        };
        // A bare number is in the units of SI, which nobody means here.
        let has_unit = |text: &str| text.ends_with(char::is_alphabetic);
        let reads = has_unit(depth)
            && has_unit(&per)
            && Kind::of::<Length>().read(depth).is_ok()
            && Kind::of::<Mass>().read(&per).is_ok();
        reads.then(|| [depth.to_owned(), per])
    }
}

/// A table, or the short text.
pub(crate) fn schema(generator: &mut SchemaGenerator) -> Schema {
    json_schema!({
        "anyOf": [
            generator.subschema_for::<MeasuredWear>(),
            { "type": "string", "examples": ["1.2 mm / 100 MGT"] },
            { "type": "null" },
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_short_text_has_many_spellings() {
        for (text, depth, per) in [
            ("1.2 mm / 100 MGT", "1.2 mm", "100 MGT"),
            ("1.2mm/100MGT", "1.2mm", "100MGT"),
            ("1.2 mm per 100 MGT", "1.2 mm", "100 MGT"),
            ("12 um / MGT", "12 um", "1 MGT"),
            ("0.05 in / 1e8 t", "0.05 in", "1e8 t"),
            ("1.2 mm / 100 Mio. t", "1.2 mm", "100 MGT"),
            ("1.2 mm per 50 million tonnes", "1.2 mm", "50 MGT"),
            ("1.2 mm / 100 Mt", "1.2 mm", "100 MGT"),
        ] {
            let read = MeasuredWear::in_words(text);
            assert_eq!(read, Some([depth.to_owned(), per.to_owned()]), "{text}");
        }
        for text in ["1.2 mm", "1.2 / 100", "1.2 mm / 100", "1.2 mm / 100 km", "1 kg / 1 MGT", ""] {
            assert_eq!(MeasuredWear::in_words(text), None, "{text}");
        }
    }
}
