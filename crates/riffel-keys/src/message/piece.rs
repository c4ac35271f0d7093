//! A message in words.

use std::borrow::Cow;
use std::sync::OnceLock;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use unic_langid::LanguageIdentifier;

use super::{Message, Value};
use crate::Language;

/// A part of a message.
#[derive(Debug, Clone, PartialEq)]
pub enum Piece<'a> {
    /// Words of the language.
    Words(String),
    /// A value of the message.
    Value(Cow<'a, Value>),
}

type Bundle = FluentBundle<FluentResource>;

/// The first of the private characters that stand for the values of a message while Fluent puts it together.
const FIRST_MARK: u32 = 0xE000;

/// The wordings of a language, parsed when they are first needed.
fn bundle(language: Language) -> &'static Bundle {
    static BUNDLES: [OnceLock<Bundle>; Language::ALL.len()] =
        [const { OnceLock::new() }; Language::ALL.len()];
    BUNDLES[language as usize].get_or_init(|| {
        let locale: LanguageIdentifier = language.code().parse().unwrap_or_default();
        let mut bundle = FluentBundle::new_concurrent(vec![locale]);
        bundle.set_use_isolating(false);
        // A message with an error in it is left out; the tests find it.
        let resource = match FluentResource::try_new(language.wordings().to_owned()) {
            Ok(resource) | Err((resource, _)) => resource,
        };
        let _ = bundle.add_resource(resource);
        bundle
    })
}

/// The words and values of a message or, where it has it, of one of its attributes.
pub(super) fn pieces<'a>(
    message: &'a Message,
    language: Language,
    attribute: Option<&str>,
) -> Vec<Piece<'a>> {
    let bundle = bundle(language);
    let Some(wording) = bundle.get_message(message.id) else {
        return vec![Piece::Words(message.id.to_owned())];
    };
    let attribute = attribute.and_then(|name| wording.get_attribute(name));
    let pattern = attribute.map_or(wording.value(), |attribute| Some(attribute.value()));
    let Some(pattern) = pattern else {
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
    let mut words = String::new();
    for letter in marked.chars() {
        let index = u32::from(letter).checked_sub(FIRST_MARK);
        let value = index.and_then(|index| message.values.get(index as usize));
        match value {
            None => words.push(letter),
            Some((_, value)) => {
                if !words.is_empty() {
                    pieces.push(Piece::Words(std::mem::take(&mut words)));
                }
                pieces.push(Piece::Value(Cow::Borrowed(value)));
            }
        }
    }
    if !words.is_empty() {
        pieces.push(Piece::Words(words));
    }
    pieces
}

/// Pieces as one text.
pub(super) fn join(pieces: &[Piece<'_>], language: Language) -> String {
    let texts = pieces.iter().map(|piece| match piece {
        Piece::Words(words) => Cow::Borrowed(&**words),
        Piece::Value(value) => in_words(value, language),
    });
    texts.collect()
}

fn in_words(value: &Value, language: Language) -> Cow<'_, str> {
    match value {
        Value::Text(text) | Value::Key(text) => Cow::Borrowed(text),
        Value::Number(number) => Cow::Owned(number.replace('.', language.decimal_mark())),
        Value::Count(count) => Cow::Owned(count.to_string()),
        Value::Words(words) => Cow::Borrowed(words.text(language)),
        Value::Message(message) => Cow::Owned(message.text(language)),
        Value::List(values) => {
            let values: Vec<_> = values
                .iter()
                .map(|value| in_words(value, language))
                .collect();
            Cow::Owned(values.join(", "))
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::{BTreeMap, BTreeSet};

    use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};

    use super::*;

    /// Names of the values in a wording, also those within choices.
    fn names<'a>(pattern: &Pattern<&'a str>, into: &mut BTreeSet<&'a str>) {
        let mut of_inline = |inline: &InlineExpression<&'a str>| {
            if let InlineExpression::VariableReference { id } = inline {
                into.insert(id.name);
            }
        };
        let mut choices = Vec::new();
        for element in &pattern.elements {
            match element {
                PatternElement::Placeable {
                    expression: Expression::Inline(inline),
                } => of_inline(inline),
                PatternElement::Placeable {
                    expression: Expression::Select { selector, variants },
                } => {
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

    /// Every message of a language with the names of its values and whether its attributes have no others.
    fn messages(language: Language) -> BTreeMap<&'static str, BTreeSet<&'static str>> {
        let resource = fluent_syntax::parser::parse(language.wordings()).expect("no errors");
        let mut messages = BTreeMap::new();
        for entry in resource.body {
            let Entry::Message(message) = entry else {
                continue;
            };
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

    /// Every language has every message, with the same values; none is left in English.
    #[test]
    fn languages_have_no_gaps() {
        let english = messages(Language::English);
        for language in Language::ALL {
            assert_eq!(messages(language), english, "{language:?}");
        }
    }
}
