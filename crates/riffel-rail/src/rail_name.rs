//! The names of rails: in sentences, and those that different instruments give one rail.

use std::collections::{BTreeMap, BTreeSet};

use jiff::civil::Date;
use riffel_keys::table::{is_one_of, words};
use riffel_keys::{Message, say};

/// The name of a rail by itself: of the usual ones each language has its own.
pub fn name_in_words(name: &str) -> Message {
    match name {
        "left" => say!(left),
        "right" => say!(right),
        "low" => say!(low),
        "high" => say!(high),
        name => Message::verbatim(name),
    }
}

/// A rail in a sentence.
pub fn rail_in_words(name: &str) -> Message {
    let names_itself = |word: &String| is_one_of(word, "rail|rails|schiene|column");
    match name.starts_with("rail") || words(name).iter().any(names_itself) {
        true => Message::verbatim(name),
        false => say!(rail_named, name = name_in_words(name)),
    }
}

/// Words for each of the usual rails, in the languages of instruments.
const USUAL: [&str; 4] = [
    "left|links|linke|linker|linkerspoorstaaf|l|li|lh|1|gauche|g|izquierda|izquierdo|izq|sinistra|sinistro|sx|esquerda|esquerdo|vänster|venstre|\
     vasen|lewa|lewy|levá|levý|levo|bal",
    "right|rechts|rechte|rechter|rechterspoorstaaf|r|re|rh|2|droite|droit|d|derecha|derecho|der|destra|destro|dx|direita|direito|höger|høyre|højre|\
     oikea|prawa|prawy|pravá|pravý|desno|jobb",
    "low|lower|inner|inside|innen|innere|bogeninnen|bogeninnere|basse|intérieur|intérieure|interieur|baja|interior|bassa|interna",
    "high|upper|outer|outside|außen|aussen|äußere|bogenaußen|bogenäußere|haute|extérieur|extérieure|exterieur|alta|exterior|esterna",
];
/// Words beside the name of a rail.
const BESIDE: &str = "rail|rails|schiene|height|heights|höhe|höhen|hoehe|hauteur|altura|altezza|hoogte|profile|profil|profilo|perfil|\
                      level|levels|pegel|niveau|roughness|rauheit|rugosité|rugosidad|file|fil|rotaia|carril|riel|spoorstaaf|side|\
                      seite|côté|cote|lado|lato|zijde|no|nr|de|del|di|la|le|the|of|longitudinal|vertical|db|um|µm|mm";
/// Words for a rail at the head of a column of names.
const RAIL: &str = "rail|rails|schiene|rotaia|carril|riel|szyna|kolejnice|spoorstaaf|kisko|skinne|räl|side|seite|zijde|lado|lato|\
                    côté|cote|strana|no|nr|id|name";

/// Whether the head of a column is a word for rails.
pub fn is_rail_column(head: &str) -> bool {
    let words = words(head);
    let is_rail = |word: &String| is_one_of(word, RAIL);
    words.iter().all(is_rail) && words.iter().any(|word| word.len() > 2 && word != "name")
}

/// Which of the usual rails a name means: "Höhe links", "L", "1" and "gauche" are one.
fn usual(name: &str) -> Option<usize> {
    let mut words = words(name);
    words.retain(|word| !is_one_of(word, BESIDE));
    let [word] = &words[..] else {
        return None;
    };
    let numbered = ["rail", "schiene"].iter();
    let word = numbered.filter_map(|prefix| word.strip_prefix(prefix)).next().unwrap_or(word);
    USUAL.iter().position(|words| is_one_of(word, words))
}

/// Whether two names mean the two rails of one track: left and right, or low and high.
pub fn are_opposite(name: &str, other: &str) -> bool {
    match (usual(name), usual(other)) {
        (Some(one), Some(other)) => one != other && one / 2 == other / 2,
        _ => false,
    }
}

/// Which of the usual rails a channel of several is on, by the only word for one in its name: "left front", "bogie 2 L". Numbers
/// are those of bogies, axles and channels.
pub fn rail_of_channel(name: &str) -> Option<usize> {
    let mut found = words(name).into_iter().filter_map(|word| {
        let is_number = word.bytes().all(|byte| byte.is_ascii_digit());
        USUAL.iter().position(|words| !is_number && is_one_of(&word, words))
    });
    let first = found.next()?;
    found.all(|other| other == first).then_some(first)
}

/// The place of a rail among others: that of the same name, else the only one whose name means the same rail.
pub fn find_rail<'a>(names: impl Iterator<Item = &'a str> + Clone, name: &str) -> Option<usize> {
    if let Some(same) = names.clone().position(|other| other == name) {
        return Some(same);
    }
    let plain = |name: &str| words(name).join(" ");
    let means = |other: &str| match (usual(other), usual(name)) {
        (Some(one), Some(other)) => one == other,
        _ => plain(other) == plain(name),
    };
    let mut alike = names.enumerate().filter(|(_, other)| means(other));
    match (alike.next(), alike.next()) {
        (Some((place, _)), None) => Some(place),
        _ => None,
    }
}

/// Give a rail of several dates one name: that of the last date, unless both names are there at one date.
pub(super) fn name_alike(rails: Vec<(Date, &mut String)>) {
    let mut by_date: BTreeMap<Date, Vec<&mut String>> = BTreeMap::new();
    for (date, name) in rails {
        by_date.entry(date).or_default().push(name);
    }
    let mut known: Vec<String> = Vec::new();
    for names in by_date.into_values().rev() {
        let there: BTreeSet<String> = names.iter().map(|name| (*name).clone()).collect();
        for name in names {
            let place = find_rail(known.iter().map(String::as_str), name);
            match place.map(|place| &known[place]) {
                Some(other) if other == name => {}
                Some(other) if !there.contains(other) => name.clone_from(other),
                // Two rails of one date.
                Some(_) => {}
                None => known.push(name.clone()),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rail_has_many_names() {
        let english = ["left", "right", "low", "high"];
        for (name, right) in [
            ("Höhe links", Some(0)),
            ("links", Some(0)),
            ("L", Some(0)),
            ("1", Some(0)),
            ("Rail 1", Some(0)),
            ("rail1", Some(0)),
            ("gauche", Some(0)),
            ("izquierda", Some(0)),
            ("rotaia sinistra", Some(0)),
            ("LEFT", Some(0)),
            ("left rail", Some(0)),
            ("Höhe rechts", Some(1)),
            ("Schiene 2", Some(1)),
            ("droite", Some(1)),
            ("carril derecho", Some(1)),
            ("destra", Some(1)),
            ("R", Some(1)),
            ("Bogeninnen", Some(2)),
            ("außen", Some(3)),
            ("column 1", None),
            ("3", None),
            ("left right", None),
            ("north", None),
            ("", None),
        ] {
            assert_eq!(find_rail(english.into_iter(), name), right, "{name}");
        }
        for (name, rail) in [
            ("left good", Some(0)),
            ("bogie 2 L", Some(0)),
            ("links vorn", Some(0)),
            ("rechts 1", Some(1)),
            ("2", None),
            ("left to right", None),
            ("front", None),
        ] {
            assert_eq!(rail_of_channel(name), rail, "{name}");
        }
        // Of two that mean one rail none is it, unless it has the very name.
        let twice = ["1", "links", "2"];
        assert_eq!(find_rail(twice.into_iter(), "left"), None);
        assert_eq!(find_rail(twice.into_iter(), "links"), Some(1));
        assert_eq!(find_rail(["North", "South"].into_iter(), "south"), Some(1));
    }

    #[test]
    fn a_rail_has_one_name_over_the_dates() {
        let mut rails =
            [(2024, "links"), (2024, "rechts"), (2025, "1"), (2025, "left"), (2026, "left"), (2026, "right")]
                .map(|(year, name)| (jiff::civil::date(year, 6, 1), name.to_owned()));
        name_alike(rails.iter_mut().map(|(date, name)| (*date, name)).collect());
        let names: Vec<&str> = rails.iter().map(|(_, name)| name.as_str()).collect();
        // In 2025 one is called left and the other 1.
        assert_eq!(names, ["left", "right", "1", "left", "left", "right"]);
    }

    #[test]
    fn columns_of_rails_have_many_heads() {
        for head in ["rail", "Schiene", "Rail no.", "carril", "side", "rail name"] {
            assert!(is_rail_column(head), "{head}");
        }
        for head in ["rail temperature", "name", "no", "id", "grade", ""] {
            assert!(!is_rail_column(head), "{head}");
        }
    }
}
