//! The wordings of a language as data, for readers that have no reader of Fluent.

use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement, VariantKey};
use serde_json::{Map, Value, json};

use crate::Language;

/// The wordings of a language by their ids.
///
/// One is a text, or a list of texts and of `{value}`, `{key}` and `{choice, among, other}`: the name of a value, a key of the case,
/// and a value by whose plural category or text one of several wordings is taken.
pub fn wordings(language: Language) -> Map<String, Value> {
    let resource = fluent_syntax::parser::parse(language.wordings());
    let resource = resource.unwrap_or_else(|(resource, _)| resource);
    let wordings = resource.body.iter().filter_map(|entry| match entry {
        Entry::Message(message) => Some((message.id.name.to_owned(), of_pattern(message.value.as_ref()?))),
        _ => None,
    });
    wordings.collect()
}

fn of_pattern(pattern: &Pattern<&str>) -> Value {
    let mut parts: Vec<Value> = Vec::new();
    for element in &pattern.elements {
        let part = match element {
            PatternElement::TextElement { value } => json!(value),
            PatternElement::Placeable { expression } => of_expression(expression),
        };
        match (parts.last_mut(), part) {
            (Some(Value::String(before)), Value::String(text)) => before.push_str(&text),
            (_, part) => parts.push(part),
        }
    }
    match &mut parts[..] {
        [one @ Value::String(_)] => one.take(),
        _ => parts.into(),
    }
}

fn of_expression(expression: &Expression<&str>) -> Value {
    let (selector, variants) = match expression {
        Expression::Inline(inline) => return of_inline(inline),
        Expression::Select { selector, variants } => (selector, variants),
    };
    let name = |key: &VariantKey<&str>| match *key {
        VariantKey::Identifier { name } => name.to_owned(),
        VariantKey::NumberLiteral { value } => value.to_owned(),
    };
    let among = variants.iter().map(|variant| (name(&variant.key), of_pattern(&variant.value)));
    let other = variants.iter().find(|variant| variant.default).map(|variant| name(&variant.key));
    json!({ "choice": of_inline(selector)["value"], "among": among.collect::<Map<_, _>>(), "other": other })
}

fn of_inline(inline: &InlineExpression<&str>) -> Value {
    match inline {
        InlineExpression::StringLiteral { value } => json!(value),
        InlineExpression::VariableReference { id } => json!({ "value": id.name }),
        InlineExpression::FunctionReference { arguments, .. } => match arguments.positional.first() {
            Some(InlineExpression::StringLiteral { value }) => json!({ "key": value }),
            _ => Value::Null,
        },
        // No wording has others; a test holds them to that.
        _ => Value::Null,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wording_is_its_texts_and_the_names_of_its_values() {
        let english = wordings(Language::English);
        assert_eq!(english["is-missing"], "is missing");
        let keys = json!(["lower ", { "key": "map.wavelength.points" }, " or ", { "key": "map.speed.points" }]);
        assert_eq!(english["lower-points"], keys);
        let one = json!(["1 section to grind, ", { "value": "sums" }]);
        let several = json!([{ "value": "count" }, " sections to grind, ", { "value": "sums" }]);
        let choice = json!({ "choice": "count", "among": { "one": one, "other": several }, "other": "other" });
        assert_eq!(english["sections-to-grind"], json!([choice]));
    }

    #[test]
    fn no_wording_has_what_is_not_told() {
        for &language in Language::ALL {
            let written = serde_json::to_string(&wordings(language)).unwrap();
            let untold = ["[null", ",null", ":null"].into_iter().find(|untold| written.contains(untold));
            assert_eq!(untold, None, "{language:?}");
        }
    }
}
