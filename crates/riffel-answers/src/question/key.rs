//! Keys of a question, as its schema has them.

use std::sync::Arc;

use riffel_keys::question::Held;
use schemars::Schema;
use serde_json::{Map, Value, json};

use super::{AnyQuestion, Question, Rule};
use crate::AnswerError;

/// What a key takes.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// True or false.
    Flag,
    /// A number without a unit.
    Number,
    /// An integer from one to another.
    Integer([u64; 2]),
    /// One of some words, each with what it means.
    Choice(Vec<[String; 2]>),
    /// A text, or a quantity: a number in SI or a text with its unit.
    Text {
        /// Whether a number may stand in its place.
        or_number: bool,
    },
    /// The path of a file, or what stands in it.
    File,
}

/// A key of a question: in JSON, as an option of the program, as a keyword of Python.
#[derive(Debug, Clone)]
pub struct Key {
    /// In JSON.
    pub name: String,
    /// What it says, in one paragraph.
    pub help: String,
    /// What it takes.
    pub kind: Kind,
    /// What stands for its value in the help.
    pub value_name: Option<String>,
    /// Its second name as an option.
    pub alias: Option<String>,
    /// What it is where it is left out.
    pub default: Option<Value>,
    /// What it is where it is given without a value, or as true.
    pub alone: Option<Value>,
    /// Whether it may not be left out.
    pub is_required: bool,
    /// Whether it stands without its name on a command line.
    pub is_positional: bool,
    /// Whether it takes a list.
    pub takes_many: bool,
    /// What separates the values of a list in one text.
    pub separator: Option<char>,
    /// Whether it names a file or a folder.
    pub is_path: bool,
    /// Whether its help says by itself which words it takes.
    pub tells_words: bool,
}

/// A description in one paragraph, without the final stop.
pub(super) fn description(text: Option<&Value>) -> String {
    let text = text.and_then(Value::as_str).unwrap_or_default();
    let text = text.lines().collect::<Vec<_>>().join(" ");
    text.strip_suffix('.').map_or(text.clone(), str::to_owned)
}

impl Key {
    /// The keys of a schema, in its order.
    pub(super) fn all(schema: &Schema) -> Vec<Self> {
        let table = |name: &str| schema.get(name);
        let required = table("required").and_then(Value::as_array);
        let is_required = |name: &str| required.is_some_and(|names| names.iter().any(|one| one == name));
        let properties = table("properties").and_then(Value::as_object).into_iter().flatten();
        properties.map(|(name, property)| Self::new(name, property, is_required(name))).collect()
    }

    fn new(name: &str, property: &Value, is_required: bool) -> Self {
        let text = |key: &str| property[key].as_str().map(str::to_owned);
        let takes_many = types(property).any(|kind| kind == "array");
        let kind = Kind::of(if takes_many { &property["items"] } else { property });
        Self {
            name: name.to_owned(),
            help: description(property.get("description")),
            is_required: is_required
                && (!takes_many || property["minItems"] == 1)
                && kind != Kind::Flag
                && property.get("default").is_none(),
            is_path: kind == Kind::File || property["path"] == true,
            kind,
            value_name: text("value_name"),
            alias: text("alias"),
            default: property.get("default").filter(|value| !value.is_null()).cloned(),
            alone: property.get("alone").cloned(),
            is_positional: property["positional"] == true,
            tells_words: property["tells_words"] == true,
            takes_many,
            separator: text("separator").and_then(|text| text.chars().next()),
        }
    }

    /// The key as an option of the program.
    pub fn option(&self) -> String {
        let name = self.name.replace('_', "-");
        match self.is_positional {
            true => format!("<{}>", name.to_uppercase()),
            false => format!("--{name}"),
        }
    }

    /// What its field has where it is left out and has no default.
    fn nothing(&self) -> Value {
        match (self.takes_many, &self.kind) {
            (true, _) => json!([]),
            (false, Kind::Flag) => json!(false),
            (false, _) => Value::Null,
        }
    }

    /// The key in the JSON schema of its question.
    pub fn property(&self) -> Value {
        let kind = match &self.kind {
            Kind::Flag => json!("boolean"),
            Kind::Number => json!("number"),
            Kind::Integer(_) => json!("integer"),
            Kind::Choice(_) | Kind::Text { or_number: false } => json!("string"),
            Kind::Text { or_number: true } => json!(["string", "number"]),
            Kind::File => json!(["string", "object"]),
        };
        let mut one = json!({ "type": kind });
        if let Kind::Choice(words) = &self.kind {
            one["enum"] = words.iter().map(|[word, _]| word.as_str()).collect();
        }
        let mut property = match self.takes_many {
            true => json!({ "type": "array", "items": one }),
            false => one,
        };
        property["description"] = json!(self.help);
        if let Some(default) = &self.default {
            property["default"] = default.clone();
        }
        property
    }

    /// The value in the type of its field.
    fn read(&self, value: Value) -> Result<Value, String> {
        if !self.takes_many {
            return self.read_one(value);
        }
        let list = match (value, self.separator) {
            (Value::Array(list), _) => list,
            (one, Some(_)) => vec![one],
            (one, None) => return Ok(json!([self.read_one(one)?])),
        };
        let parts = list.iter().flat_map(|one| match (one.as_str(), self.separator) {
            (Some(text), Some(separator)) => text.split(separator).map(Value::from).collect(),
            _ => vec![one.clone()],
        });
        parts.map(|one| self.read_one(one)).collect()
    }

    /// What one value must be, or a list of them where it takes one.
    fn or_many(&self, one: &str) -> String {
        format!("{one}{}", if self.takes_many { ", or a list of them" } else { "" })
    }

    fn read_one(&self, value: Value) -> Result<Value, String> {
        let rule = match (&self.kind, value) {
            (Kind::Flag, value @ Value::Bool(_)) => return Ok(value),
            (Kind::Number | Kind::Text { or_number: true }, value @ Value::Number(_)) => return Ok(value),
            (Kind::Text { .. } | Kind::File, value @ Value::String(_)) => return Ok(value),
            (Kind::Text { or_number: false } | Kind::File, Value::Number(number)) => {
                return Ok(number.to_string().into());
            }
            (Kind::Number, Value::String(text)) => match text.trim().parse() {
                Ok(number) if f64::is_finite(number) => return Ok(number.into()),
                _ => {
                    let rule =
                        "a number: digits with a decimal point and no separators of thousands, as in 2500000 or 2.5e6";
                    (text.into(), rule.to_owned())
                }
            },
            (Kind::Integer([low, high]), value) => {
                let number = match &value {
                    Value::String(text) => text.parse().ok(),
                    other => other.as_u64(),
                };
                match number {
                    Some(number) if (*low..=*high).contains(&number) => return Ok(number.into()),
                    _ if *high == u64::MAX => (value, format!("an integer from {low} on")),
                    _ => (value, format!("an integer from {low} to {high}")),
                }
            }
            (Kind::Choice(words), Value::String(word)) => match words.iter().any(|[one, _]| *one == word) {
                true => return Ok(word.into()),
                false => (word.into(), one_of(words)),
            },
            (Kind::Flag, value) => (value, "true or false".to_owned()),
            (Kind::Number, value) => (value, "a number".to_owned()),
            (Kind::Choice(words), value) => (value, one_of(words)),
            (Kind::Text { or_number: true }, value) => (value, self.or_many("a number or a text")),
            (Kind::Text { .. }, value) if self.is_path => (value, self.or_many("the path of a file or a folder")),
            (Kind::Text { .. }, value) => (value, self.or_many("a text")),
            (Kind::File, value) => (value, self.or_many("the path of a file or an object with what stands in it")),
        };
        let (value, rule) = rule;
        let value = match (&self.kind, value) {
            (Kind::Number | Kind::Integer(_), Value::String(text)) => text,
            (_, value) => value.to_string(),
        };
        Err(format!("{} is {value}, but must be {rule}", self.option()))
    }
}

/// The rule of a choice.
fn one_of(words: &[[String; 2]]) -> String {
    let words: Vec<&str> = words.iter().map(|[word, _]| word.as_str()).collect();
    format!("one of {}", words.join(", "))
}

impl Kind {
    fn of(property: &Value) -> Self {
        let has = |name: &str| types(property).any(|kind| kind == name);
        let end = |name: &str, or: u64| property[name].as_u64().unwrap_or(or);
        // What may be left out is this or null.
        let property = property["anyOf"].get(0).unwrap_or(property);
        match property["oneOf"].as_array() {
            Some(words) => {
                let word = |one: &Value| Some([one["const"].as_str()?.to_owned(), description(one.get("description"))]);
                Self::Choice(words.iter().filter_map(word).collect())
            }
            None if has("boolean") => Self::Flag,
            None if has("integer") => Self::Integer([end("minimum", 0), end("maximum", u64::MAX)]),
            None if has("object") => Self::File,
            None if has("string") => Self::Text { or_number: has("number") },
            None => Self::Number,
        }
    }
}

/// The types of a property.
fn types(property: &Value) -> impl Iterator<Item = &str> {
    let kind = &property["type"];
    let list = kind.as_array().map_or(std::slice::from_ref(kind), Vec::as_slice);
    list.iter().filter_map(Value::as_str)
}

/// Hold the documents that stand in a question in place of files, each by the path that takes its place.
pub fn hold(question: &dyn AnyQuestion, given: &mut Map<String, Value>) -> Held {
    let mut held = Held::default();
    let mut take = |key: &str, value: &mut Value| {
        if value.is_object() {
            *value = held.hold(key, Arc::new(value.take())).to_string_lossy().into();
        }
    };
    for key in question.keys().iter().filter(|key| key.kind == Kind::File) {
        match given.get_mut(&key.name) {
            Some(Value::Array(list)) if key.takes_many => {
                list.iter_mut().enumerate().for_each(|(place, one)| take(&format!("{}.{place}", key.name), one));
            }
            Some(one) => take(&key.name, one),
            None => {}
        }
    }
    held
}

/// The question that has some keys.
pub(super) fn question<Q: Question>(keys: &[Key], given: Map<String, Value>) -> Result<Q, AnswerError> {
    let wrong = |message: String| AnswerError::Question { question: Q::NAME, message };
    let fields = fields(Q::NAME, Q::RULES, keys, given).map_err(wrong)?;
    let read = |fields: &Map<String, Value>| serde_path_to_error::deserialize::<_, Q>(Value::Object(fields.clone()));
    read(&fields).map_err(|error| {
        let (path, sentence) = (error.path().to_string(), error.inner().to_string());
        // Fields of a flattened struct have no path: the key is the one without which the question reads otherwise.
        let is_at_fault = |key: &&Key| {
            let mut without = fields.clone();
            without.insert(key.name.clone(), key.nothing());
            !key.is_required && read(&without).map_or_else(|error| error.inner().to_string() != sentence, |_| true)
        };
        let by_path = keys.iter().find(|key| path.split(['.', '[']).next() == Some(&*key.name));
        wrong(match by_path.or_else(|| keys.iter().filter(|key| key.default.is_none()).find(is_at_fault)) {
            Some(key) => format!("{}: {sentence}", key.option()),
            None => sentence,
        })
    })
}

/// Whether a value gives a key: a flag that is off and a list without items do not.
fn says_something(value: &Value) -> bool {
    *value != false && value.as_array().is_none_or(|list| !list.is_empty())
}

/// The fields of a question: what is given, in the types of its fields, with the defaults of the rest.
fn fields(
    question: &str,
    rules: &[Rule],
    keys: &[Key],
    given: Map<String, Value>,
) -> Result<Map<String, Value>, String> {
    if let Some(name) = given.keys().find(|name| keys.iter().all(|key| key.name != **name)) {
        let known = keys.iter().map(|key| &*key.name).collect::<Vec<_>>();
        return Err(format!("`{name}` is not a key of {question}; its keys are {}", known.join(", ")));
    }
    let mut given: Map<String, Value> = given.into_iter().filter(|(_, value)| !value.is_null()).collect();
    for rule in rules {
        rule.check(keys, &|name| given.get(name).is_some_and(says_something))?;
    }
    let mut fields = Map::new();
    for key in keys {
        let value = match given.remove(&key.name).filter(|value| key.alone.is_none() || *value != false) {
            Some(Value::Bool(true)) if key.alone.is_some() => key.alone.clone().unwrap_or_default(),
            Some(value) => key.read(value)?,
            None if key.is_required => return Err(format!("{} is missing", key.option())),
            None => key.default.clone().unwrap_or_else(|| key.nothing()),
        };
        fields.insert(key.name.clone(), value);
    }
    Ok(fields)
}
