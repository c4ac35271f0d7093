//! A message in words.

use std::borrow::Cow;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use unic_langid::LanguageIdentifier;

use super::{Message, Value};
use crate::Language;

/// A part of a message in one language: words, or what a reader may show in another way.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece {
    /// Words of the language.
    Words(String),
    /// A key of the case, or an option of the program.
    Key {
        /// As it stands in the message, with its quotation marks.
        text: String,
        /// Dotted, or with its dashes.
        key: String,
    },
    /// A quantity.
    Quantity {
        /// As it stands in the message.
        text: String,
        /// In SI.
        si: f64,
        /// The SI unit.
        unit: String,
    },
    /// A speed, or the slowest and the fastest of several.
    Speeds {
        /// As it stands in the message, in km/h.
        text: String,
        /// In m/s.
        speeds_m_per_s: Vec<f64>,
    },
}

impl Piece {
    /// As it stands in the message.
    pub(super) fn text(&self) -> &str {
        match self {
            Self::Words(text) | Self::Key { text, .. } | Self::Quantity { text, .. } | Self::Speeds { text, .. } => {
                text
            }
        }
    }
}

type Bundle = FluentBundle<FluentResource>;

/// The first of the private characters that stand for the values of a message while Fluent puts it together.
const FIRST_MARK: u32 = 0xE000;
/// The private characters around a key that a wording names by `KEY`.
const KEY_BEGINS: char = '\u{F000}';
const KEY_ENDS: char = '\u{F001}';

/// The wordings of a language, parsed when they are first needed.
fn bundle(language: Language) -> &'static Bundle {
    static BUNDLES: [OnceLock<Bundle>; Language::ALL.len()] = [const { OnceLock::new() }; Language::ALL.len()];
    BUNDLES[language as usize].get_or_init(|| {
        let locale: LanguageIdentifier = language.code().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        bundle.set_use_isolating(false);
        let _ = bundle.add_function("KEY", |key, _| match key {
            [FluentValue::String(key)] => format!("{KEY_BEGINS}{key}{KEY_ENDS}").into(),
            _ => FluentValue::Error,
        });
        // A message with an error in it is left out; the tests find it.
        let resource = match FluentResource::try_new(language.wordings().to_owned()) {
            Ok(resource) | Err((resource, _)) => resource,
        };
        let _ = bundle.add_resource(resource);
        bundle
    })
}

/// The wording of an id without values; `None` where the language has none of its own.
pub(super) fn wording_of(id: &str, language: Language) -> Option<Cow<'static, str>> {
    let bundle = bundle(language);
    let pattern = bundle.get_message(id)?.value()?;
    Some(bundle.format_pattern(pattern, None, &mut Vec::new()))
}

/// The pieces of a message or, where it has it, of one of its attributes; in English where the language has no wording.
pub(super) fn pieces(message: &Message, language: Language, attribute: Option<&str>) -> Vec<Piece> {
    let pattern = |language| {
        let bundle = bundle(language);
        let wording = bundle.get_message(message.id)?;
        let attribute = attribute.and_then(|name| wording.get_attribute(name));
        let pattern = attribute.map_or(wording.value(), |attribute| Some(attribute.value()));
        Some((bundle, pattern?))
    };
    let Some((bundle, pattern)) = pattern(language).or_else(|| pattern(Language::English)) else {
        return vec![Piece::Words(message.id.to_owned())];
    };
    let mut arguments = FluentArgs::with_capacity(message.values.len());
    for (mark, (name, value)) in (FIRST_MARK..).zip(&message.values) {
        let stands_for = match value {
            Value::Count(count) => FluentValue::from(*count),
            _ => FluentValue::from(char::from_u32(mark).map(String::from).unwrap_or_default()),
        };
        arguments.set(*name, stands_for);
    }
    let marked = bundle.format_pattern(pattern, Some(&arguments), &mut Vec::new());
    let mut pieces = Vec::new();
    let mut letters = marked.chars().peekable();
    while let Some(letter) = letters.next() {
        let index = u32::from(letter).checked_sub(FIRST_MARK);
        let value = index.and_then(|index| Some(&message.values.get(index as usize)?.1));
        let key = match value {
            _ if letter == KEY_BEGINS => letters.by_ref().take_while(|&c| c != KEY_ENDS).collect(),
            Some(Value::Key(key)) => key.clone(),
            Some(value) => {
                push_value(value, language, &mut pieces);
                continue;
            }
            None => {
                push_words(letter.encode_utf8(&mut [0; 4]), &mut pieces);
                continue;
            }
        };
        // The quotation marks of code belong to the key.
        let text = match pieces.pop() {
            Some(Piece::Words(words)) if words.ends_with('`') && letters.peek() == Some(&'`') => {
                letters.next();
                if words.len() > 1 {
                    push_words(&words[..words.len() - 1], &mut pieces);
                }
                format!("`{key}`")
            }
            before => {
                pieces.extend(before);
                key.clone()
            }
        };
        pieces.push(Piece::Key { text, key });
    }
    pieces
}

fn push_words(words: &str, pieces: &mut Vec<Piece>) {
    match pieces.last_mut() {
        Some(Piece::Words(before)) => before.push_str(words),
        _ => pieces.push(Piece::Words(words.to_owned())),
    }
}

fn push_all(more: Vec<Piece>, pieces: &mut Vec<Piece>) {
    for piece in more {
        match piece {
            Piece::Words(words) => push_words(&words, pieces),
            other => pieces.push(other),
        }
    }
}

fn push_value(value: &Value, language: Language, pieces: &mut Vec<Piece>) {
    let of_language = |number: &str| number.replace('.', language.decimal_mark());
    match value {
        Value::Text(text) => push_words(text, pieces),
        Value::Key(key) => pieces.push(Piece::Key { text: key.clone(), key: key.clone() }),
        Value::Number(number) => push_words(&of_language(number), pieces),
        Value::Quantity { shown, si, unit } => {
            pieces.push(Piece::Quantity { text: of_language(shown), si: *si, unit: (*unit).to_owned() })
        }
        Value::Speeds { shown, speeds_m_per_s } => {
            pieces.push(Piece::Speeds { text: of_language(shown), speeds_m_per_s: speeds_m_per_s.clone() })
        }
        Value::Count(count) => push_words(&count.to_string(), pieces),
        Value::Words(words) => push_words(&words.text(language), pieces),
        Value::Message(message) => push_all(self::pieces(message, language, None), pieces),
        Value::Capital(message) => {
            let mut own = self::pieces(message, language, None);
            if let Some(Piece::Words(words)) = own.first_mut() {
                *words = capital(words);
            }
            push_all(own, pieces);
        }
        Value::List(values) => {
            for (k, value) in values.iter().enumerate() {
                if k > 0 {
                    push_words(", ", pieces);
                }
                push_value(value, language, pieces);
            }
        }
    }
}

/// Words with a capital first letter.
pub fn capital(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map(char::to_uppercase);
    first.into_iter().flatten().chain(letters).collect()
}

/// Pieces as one text.
pub(super) fn join(pieces: &[Piece]) -> String {
    pieces.iter().map(Piece::text).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};

    use super::*;
    use crate::say;

    /// Names of the values and keys in a wording, also those within choices.
    fn names<'a>(pattern: &Pattern<&'a str>, into: &mut BTreeSet<&'a str>) {
        let mut of_inline = |inline: &InlineExpression<&'a str>| match inline {
            InlineExpression::VariableReference { id } => {
                into.insert(id.name);
            }
            InlineExpression::FunctionReference { id, arguments } => {
                assert_eq!(id.name, "KEY");
                for key in &arguments.positional {
                    let InlineExpression::StringLiteral { value } = key else {
                        panic!("KEY takes a text, not {key:?}");
                    };
                    into.insert(value);
                }
            }
            _ => {}
        };
        let mut choices = Vec::new();
        for element in &pattern.elements {
            match element {
                PatternElement::Placeable { expression: Expression::Inline(inline) } => of_inline(inline),
                PatternElement::Placeable { expression: Expression::Select { selector, variants } } => {
                    of_inline(selector);
                    choices.extend(variants);
                }
                PatternElement::TextElement { .. } => {}
            }
        }
        for variant in choices {
            names(&variant.value, into);
        }
    }

    /// Every message of a language with the names of its values and keys and whether its attributes have no others.
    fn messages(language: Language) -> BTreeMap<&'static str, BTreeSet<&'static str>> {
        let resource = fluent_syntax::parser::parse(language.wordings()).expect("no errors");
        let mut messages = BTreeMap::new();
        for entry in resource.body {
            let Entry::Message(message) = entry else {
                continue;
            };
            // The English of others stands where they are used.
            if message.id.name.starts_with(|first: char| first.is_ascii_uppercase()) {
                continue;
            }
            let mut own = BTreeSet::new();
            names(message.value.as_ref().expect("a wording"), &mut own);
            for attribute in &message.attributes {
                let mut shorter = BTreeSet::new();
                names(&attribute.value, &mut shorter);
                assert!(shorter.is_subset(&own), "{}", message.id.name);
            }
            let earlier = messages.insert(message.id.name, own);
            assert!(earlier.is_none(), "{} stands twice", message.id.name);
        }
        messages
    }

    #[test]
    fn the_ids_of_what_has_no_subject_begin_like_it() {
        let english = Language::English.wordings();
        let resource = fluent_syntax::parser::parse(english).expect("no errors");
        for entry in resource.body {
            let Entry::Message(message) = entry else {
                continue;
            };
            let begins = message.value.and_then(|value| match value.elements.first() {
                Some(PatternElement::TextElement { value }) => Some(*value),
                _ => None,
            });
            let name = message.id.name;
            // What the page says by itself follows no key.
            if name.starts_with("web-") {
                continue;
            }
            for (id, words) in [("is-", "is "), ("and-", "and ")] {
                let has_no_subject = begins.is_some_and(|text| text.starts_with(words));
                assert_eq!(name.starts_with(id), has_no_subject, "{name}");
            }
        }
    }

    #[test]
    fn keys_and_quantities_are_pieces_and_the_rest_is_words() {
        let words = |text: &str| Piece::Words(text.to_owned());
        let key = |text: &str, key: &str| Piece::Key { text: text.to_owned(), key: key.to_owned() };
        let load = crate::message::quantity(1500.0, "N", "1.5 kN");
        let rule = say!(is_but_must_be, value = load, rule = "more");
        let message = say!(key_and_rule, key = "contact.normal_load", rule = rule);
        let quantity = |text: &str| Piece::Quantity { text: text.to_owned(), si: 1500.0, unit: "N".to_owned() };
        let begins = key("`contact.normal_load`", "contact.normal_load");
        for (language, expected) in [
            (Language::English, [begins.clone(), words(": is "), quantity("1.5 kN"), words(", but must be more")]),
            (Language::German, [begins, words(": ist "), quantity("1,5 kN"), words(", muss aber more sein")]),
        ] {
            assert_eq!(message.pieces(language), expected);
            assert_eq!(message.text(language), join(&expected));
        }
        // Speeds, of which readers choose the unit.
        let speeds = crate::shown_speeds([10.0, 25.0]);
        let message = say!(traffic_at_speeds, traffic = "trains", speeds = speeds);
        let shown = Piece::Speeds { text: "36–90 km/h".to_owned(), speeds_m_per_s: vec![10.0, 25.0] };
        assert_eq!(message.pieces(Language::English), [words("trains ("), shown, words(")")]);
        // A key that the wording itself names.
        let message = say!(lower_points);
        assert_eq!(
            message.pieces(Language::English),
            [
                words("lower "),
                key("map.wavelength.points", "map.wavelength.points"),
                words(" or "),
                key("map.speed.points", "map.speed.points"),
            ]
        );
    }

    /// German has every message, other languages have some, with the same values and keys.
    #[test]
    fn languages_have_no_gaps() {
        let english = messages(Language::English);
        assert_eq!(messages(Language::German), english);
        for &language in Language::ALL {
            for (id, names) in messages(language) {
                assert_eq!(Some(&names), english.get(id), "{id} in {language:?}");
            }
        }
    }
}
