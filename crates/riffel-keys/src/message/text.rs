//! A message in words.

use std::borrow::Cow;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use unic_langid::LanguageIdentifier;

use super::{Message, Value};
use crate::Language;

type Bundle = FluentBundle<FluentResource>;

/// The wordings of a language, parsed when they are first needed.
fn bundle(language: Language) -> &'static Bundle {
    static BUNDLES: [OnceLock<Bundle>; Language::ALL.len()] = [const { OnceLock::new() }; Language::ALL.len()];
    BUNDLES[language as usize].get_or_init(|| {
        let locale: LanguageIdentifier = language.code().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        bundle.set_use_isolating(false);
        let _ = bundle.add_function("KEY", |key, _| match key {
            [FluentValue::String(key)] => key.to_string().into(),
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

/// A message in words or, where it has it, one of its attributes; in English where the language has no wording.
pub(super) fn text(message: &Message, language: Language, attribute: Option<&str>) -> String {
    let pattern = |language| {
        let bundle = bundle(language);
        let wording = bundle.get_message(message.id)?;
        let attribute = attribute.and_then(|name| wording.get_attribute(name));
        let pattern = attribute.map_or(wording.value(), |attribute| Some(attribute.value()));
        Some((bundle, pattern?))
    };
    let Some((bundle, pattern)) = pattern(language).or_else(|| pattern(Language::English)) else {
        return message.id.to_owned();
    };
    let mut arguments = FluentArgs::with_capacity(message.values.len());
    for (name, value) in &message.values {
        let filled = match value {
            // Languages choose between singular and plural by it.
            Value::Count(count) => FluentValue::from(*count),
            value => FluentValue::from(of_value(value, language)),
        };
        arguments.set(*name, filled);
    }
    bundle.format_pattern(pattern, Some(&arguments), &mut Vec::new()).into_owned()
}

fn of_value(value: &Value, language: Language) -> String {
    match value {
        Value::Text(text) | Value::Key(text) => text.clone(),
        Value::Number(shown) | Value::Quantity { shown, .. } | Value::Speeds { shown, .. } => {
            shown.replace('.', language.decimal_mark())
        }
        Value::Count(count) => count.to_string(),
        Value::Words(words) => words.text(language).into_owned(),
        Value::Message(message) => message.text(language),
        Value::Capital(message) => message.capitalised(language),
        Value::List(values) => values.iter().map(|value| of_value(value, language)).collect::<Vec<_>>().join(", "),
    }
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
    fn keys_and_quantities_stand_between_the_words() {
        let load = crate::message::quantity(1500.0, "N", "1.5 kN");
        let rule = say!(is_but_must_be, value = load, rule = "more");
        let message = say!(key_and_rule, key = "contact.normal_load", rule);
        for (language, expected) in [
            (Language::English, "`contact.normal_load`: is 1.5 kN, but must be more"),
            (Language::German, "`contact.normal_load`: ist 1,5 kN, muss aber more sein"),
        ] {
            assert_eq!(message.text(language), expected);
        }
        let message = say!(traffic_at_speeds, traffic = "trains", speeds = crate::shown_speeds([10.0, 25.0]));
        assert_eq!(message.text(Language::English), "trains (36–90 km/h)");
        // Keys that the wording itself names.
        assert_eq!(say!(lower_points).text(Language::English), "lower map.wavelength.points or map.speed.points");
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
