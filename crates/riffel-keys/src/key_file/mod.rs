//! A file of keys (TOML) with its overrides, and where each key stands.

mod text;

use std::collections::HashMap;
use std::sync::Arc;

use miette::NamedSource;
use serde::de::DeserializeOwned;
use text::{Text, join, within};
use toml::de::DeTable;
use toml::{Table, Value};

use crate::excerpt::{clipped, excerpt};
use crate::printable::{command_in, in_a_message};
use crate::quantity::{KINDS, Kind, WrittenQuantity, refused_as};
use crate::range::Judgement;
use crate::{CaseError, Message, PhysicalRange, say};

/// Most parts of a dotted key in an override, far more than any key has: tables are walked by recursion.
const DEEPEST: usize = 16;

/// A file of keys, each with the place where it was set: what a case, a traffic and a plan are read from,
/// and what makes errors that show the line.
#[derive(Clone)]
pub struct KeyFile {
    text: Arc<Text>,
    table: Table,
    /// Dotted key → the override that set it last; `None` if the program did.
    overrides: HashMap<String, Option<String>>,
}

impl KeyFile {
    /// Read TOML; `name` is shown in errors.
    ///
    /// # Errors
    /// [`CaseError::Syntax`] with the place.
    pub fn parse(name: &str, text: &str) -> Result<Self, CaseError> {
        let syntax = |error: toml::de::Error| {
            let (excerpt, span) = excerpt(text, error.span().unwrap_or(0..0));
            CaseError::Syntax {
                message: clipped(error.message()).into_owned(),
                source_code: named(name, excerpt),
                span: span.into(),
            }
        };
        let spans = DeTable::parse(text).map_err(syntax)?;
        let mut read = Text::empty(name);
        text.clone_into(&mut read.text);
        read.index("", spans.get_ref());
        let file = Self { text: Arc::new(read), table: text.parse().map_err(syntax)?, overrides: HashMap::new() };
        file.refuse_commands("", &file.table)?;
        Ok(file)
    }

    /// TOML takes control characters as escapes; names and titles with them would command the terminal.
    fn refuse_commands(&self, parent: &str, table: &Table) -> Result<(), CaseError> {
        for (name, value) in table {
            let key = join(parent, name);
            if let Some(command) = command_in(name) {
                let rule = say!(is_key_with_command, command = format!("{command:?}"));
                return Err(self.invalid(&key, rule, say!(leave_it_out)));
            }
            self.refuse_commands_in(&key, value)?;
        }
        Ok(())
    }

    fn refuse_commands_in(&self, key: &str, value: &Value) -> Result<(), CaseError> {
        match value {
            Value::String(text) => command_in(text).map_or(Ok(()), |command| {
                let rule = say!(is_text_with_command, command = format!("{command:?}"));
                Err(self.invalid(key, rule, say!(leave_it_out)))
            }),
            Value::Table(table) => self.refuse_commands(key, table),
            Value::Array(items) => (items.iter().enumerate())
                .try_for_each(|(index, item)| self.refuse_commands_in(&format!("{key}[{index}]"), item)),
            _ => Ok(()),
        }
    }

    /// The file again, from its name, its text, its keys after overrides as TOML, and these overrides: see
    /// [`name`](Self::name), [`text`](Self::text), [`table`](Self::table) and [`overrides`](Self::overrides).
    ///
    /// # Errors
    /// Errors of [`parse`](Self::parse).
    pub fn restore(name: &str, text: &str, keys: &str, overrides: &[(String, String)]) -> Result<Self, CaseError> {
        Ok(Self {
            table: Self::parse(name, keys)?.table,
            overrides: (overrides.iter().cloned()).map(|(key, assignment)| (key, Some(assignment))).collect(),
            ..Self::parse(name, text)?
        })
    }

    /// A file without keys.
    pub fn empty(name: &str) -> Self {
        Self { text: Arc::new(Text::empty(name)), table: Table::new(), overrides: HashMap::new() }
    }

    /// The name shown in errors.
    pub fn name(&self) -> &str {
        &self.text.name
    }

    /// The text that was read.
    pub fn text(&self) -> &str {
        &self.text.text
    }

    /// Each key that was overridden with the override, in the order of the keys.
    pub fn overrides(&self) -> Vec<(String, String)> {
        let overrides = self.overrides.iter();
        let mut overrides: Vec<(String, String)> =
            overrides.filter_map(|(key, assignment)| Some((key.clone(), assignment.clone()?))).collect();
        overrides.sort();
        overrides
    }

    /// The top level as a table.
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Apply one override `key=value` and return its key, dotted. The value is TOML, or a text if it does not read as
    /// such, or if the key takes a name: the rail 60E1 is not the number 600.
    ///
    /// # Errors
    /// [`CaseError::Override`] for what is no `key=value`, or a key within a value.
    pub fn set(&mut self, assignment: &str, takes_a_name: bool) -> Result<String, CaseError> {
        let wrong = |message: Message| CaseError::Override {
            assignment: clipped(assignment).into_owned(),
            message: message.clipped(),
        };
        let malformed = || wrong("write --set key=value, as in --set contact.friction=0.3".into());
        let (path, value) = assignment.split_once('=').ok_or_else(malformed)?;
        let (path, value) = (path.trim(), value.trim());
        let value = format!("value = {value}")
            .parse::<Table>()
            .ok()
            .filter(|table| table.len() == 1)
            .and_then(|mut table| table.remove("value"))
            .filter(|value| value.is_str() || value.is_table() || !takes_a_name)
            .unwrap_or_else(|| Value::String(value.to_owned()));

        let parts: Vec<&str> = path.split('.').map(str::trim).collect();
        if parts.iter().any(|part| part.is_empty()) {
            return Err(malformed());
        }
        let rails = self.insert(&parts, value).map_err(wrong)?;
        self.overrides.extend(rails.map(|table| (table, Some(assignment.to_owned()))));
        let key = parts.join(".");
        self.overrides.insert(key.clone(), Some(assignment.to_owned()));
        Ok(key)
    }

    /// Give a key a value, whatever the file and its overrides say. An error of it is [`CaseError::Changed`].
    ///
    /// # Errors
    /// [`CaseError::Changed`] for a key within a value.
    pub fn write(&mut self, key: &str, value: impl Into<Value>) -> Result<(), CaseError> {
        let parts: Vec<&str> = key.split('.').collect();
        let changed = |message: Message| CaseError::Changed { key: key.to_owned(), message: message.clipped() };
        let rails = self.insert(&parts, value.into()).map_err(changed)?;
        self.overrides.extend(rails.map(|table| (table, None)));
        self.overrides.insert(key.to_owned(), None);
        Ok(())
    }

    /// Give a key a value. Where it is that of one rail and the table has a value for both, the other rail keeps that: such a table
    /// is returned.
    fn insert(&mut self, parts: &[&str], value: Value) -> Result<Option<String>, Message> {
        const RAILS: [&str; 2] = ["left", "right"];
        let Some((last, parents)) = parts.split_last() else {
            return Ok(None);
        };
        if parts.len() > DEEPEST {
            let count = parts.len();
            return Err(say!(key_of_many_parts, most = DEEPEST, count));
        }
        let mut table = &mut self.table;
        let mut rails = None;
        for (depth, parent) in parents.iter().enumerate() {
            let inner = table.entry((*parent).to_owned()).or_insert_with(|| Value::Table(Table::new()));
            if depth > 0
                && depth + 1 == parents.len()
                && RAILS.contains(last)
                && (inner.is_str() || inner.is_float() || inner.is_integer())
            {
                let of_both = |rail: &str| (rail.to_owned(), inner.clone());
                *inner = Value::Table(RAILS.map(of_both).into_iter().collect());
                rails = Some(parents.join("."));
            }
            table = inner.as_table_mut().ok_or_else(|| {
                let path = parts.join(".");
                say!(value_not_table, parent = *parent, path)
            })?;
        }
        table.insert((*last).to_owned(), value);
        Ok(rails)
    }

    /// Remove a key.
    pub fn remove(&mut self, key: &str) {
        let (parents, last) = key.rsplit_once('.').unwrap_or(("", key));
        let mut parents = parents.split('.').filter(|parent| !parent.is_empty());
        let table = parents.try_fold(&mut self.table, |table, parent| table.get_mut(parent)?.as_table_mut());
        if let Some(table) = table {
            table.remove(last);
        }
    }

    /// The text that a key holds, if it holds a text.
    pub fn text_of(&self, key: &str) -> Option<&str> {
        self.value(key)?.as_str()
    }

    /// The value of a key as it stands in the text, which tells 9.000 from 9; `None` where the text does not have it.
    pub fn value_as_written(&self, key: &str) -> Option<&str> {
        self.text.value(key)
    }

    /// True if the key is set.
    pub fn has(&self, key: &str) -> bool {
        self.value(key).is_some()
    }

    /// Number of items of a list; zero for what is none.
    pub fn length_of(&self, key: &str) -> usize {
        let list = self.value(key).and_then(Value::as_array);
        list.map_or(0, Vec::len)
    }

    /// The value of a key such as `vehicle[0].speed.mean`.
    fn value(&self, key: &str) -> Option<&Value> {
        let mut parts = key.split(['.', '[']);
        let first = self.table.get(parts.next()?)?;
        parts.try_fold(first, |value, part| match part.strip_suffix(']') {
            Some(index) => value.as_array()?.get(index.parse::<usize>().ok()?),
            None => value.as_table()?.get(part),
        })
    }

    /// What is to be asked about the value of a key, if it is set and not usual.
    ///
    /// # Errors
    /// [`CaseError`] for a value outside its physical range.
    pub fn judge(&self, key: &str) -> Result<Option<Message>, CaseError> {
        let Some(range) = PhysicalRange::of(key) else {
            return Ok(None);
        };
        let written = match self.value(key) {
            Some(Value::String(text)) => range.kind.read_written(text).ok(),
            Some(Value::Integer(number)) => Some(WrittenQuantity::bare(*number as f64)),
            Some(Value::Float(number)) => Some(WrittenQuantity::bare(*number)),
            _ => None,
        };
        written.map_or(Ok(None), |written| self.judged(key, range, &written))
    }

    /// [`judge`](Self::judge) a number in SI that takes the place of a key.
    ///
    /// # Errors
    /// [`CaseError`] for a value outside its physical range.
    pub fn judge_number(&self, key: &str, value: f64) -> Result<Option<Message>, CaseError> {
        let range = PhysicalRange::of(key);
        range.map_or(Ok(None), |range| self.judged(key, range, &WrittenQuantity::bare(value)))
    }

    fn judged(
        &self,
        key: &str,
        range: &PhysicalRange,
        written: &WrittenQuantity,
    ) -> Result<Option<Message>, CaseError> {
        match range.judge(key, written) {
            Judgement::Usual => Ok(None),
            Judgement::Unusual(remark) => Ok(Some(remark)),
            Judgement::Impossible { rule, help } => Err(self.invalid(key, rule, help)),
        }
    }

    /// Set a key such as `rail.area` or `vehicle[0].share`, which is no override; tables, lists and the item after the
    /// last are made. A value where a table or a list is needed stays, for the reader to complain of.
    pub fn put(&mut self, key: &str, value: impl Into<Value>) {
        let empty = |next: Option<&&str>| match next {
            Some(part) if part.ends_with(']') => Value::Array(Vec::new()),
            _ => Value::Table(Table::new()),
        };
        let mut parts = key.split(['.', '[']).peekable();
        let Some(first) = parts.next() else {
            return;
        };
        let top = self.table.entry(first.to_owned());
        let mut place = top.or_insert_with(|| empty(parts.peek()));
        while let Some(part) = parts.next() {
            let inner = match part.strip_suffix(']') {
                Some(index) => index.parse().ok().and_then(|index: usize| {
                    let items = place.as_array_mut()?;
                    if items.len() == index {
                        items.push(empty(parts.peek()));
                    }
                    items.get_mut(index)
                }),
                None => place.as_table_mut().map(|table| {
                    let inner = table.entry(part.to_owned());
                    inner.or_insert_with(|| empty(parts.peek()))
                }),
            };
            let Some(inner) = inner else {
                return;
            };
            place = inner;
        }
        *place = value.into();
    }

    /// The keys as types.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn deserialize<T: DeserializeOwned>(&self) -> Result<T, CaseError> {
        self.deserialize_or(|_| None)
    }

    /// [`deserialize`](Self::deserialize), where some keys have errors of their own: what `own` makes of the key that
    /// does not read.
    ///
    /// # Errors
    /// Errors of [`deserialize`](Self::deserialize).
    pub fn deserialize_or<T: DeserializeOwned>(&self, own: impl Fn(&str) -> Option<CaseError>) -> Result<T, CaseError> {
        serde_path_to_error::deserialize(self.table.clone()).map_err(|error| {
            let path = error.path().to_string();
            let path = if path == "." { "" } else { &path };
            self.explain(path, error.inner().message(), own)
        })
    }

    /// Turn a message of the TOML reader into an error that names the key.
    fn explain(&self, path: &str, message: &str, own: impl Fn(&str) -> Option<CaseError>) -> CaseError {
        let message = message.trim();
        let quoted: Vec<&str> = message.split('`').skip(1).step_by(2).collect();
        if let (true, [field, ..]) = (message.starts_with("missing field"), &quoted[..]) {
            return self.missing(&join(path, field), "");
        }
        if let (true, [field, allowed @ ..]) = (message.starts_with("unknown field"), &quoted[..]) {
            // The reader names the table or the key itself, according to where it noticed.
            let path = match path.strip_suffix(field) {
                Some(_) => path.to_owned(),
                None => join(path, field),
            };
            return self.invalid(&path, say!(is_unknown_key), suggestion(field, allowed));
        }
        if let (true, [variant, allowed @ ..]) = (message.starts_with("unknown variant"), &quoted[..]) {
            let rule = say!(no_choice, variant = *variant);
            return self.invalid(path, rule, suggestion(variant, allowed));
        }
        if let Some(error) = own(path) {
            return error;
        }
        if message.contains("expected struct") {
            return self.invalid(path, say!(is_no_table), "");
        }
        if message.contains("expected a sequence") {
            return self.invalid(path, say!(is_no_list), "");
        }
        let rule = refused_as(message).map(|error| error.message()).or_else(|| self.of_another_kind(path, message));
        self.invalid(path, rule.unwrap_or_else(|| message.into()), "")
    }

    /// What the reader expected in place of a value, in words of the case file.
    fn of_another_kind(&self, path: &str, message: &str) -> Option<Message> {
        let (found, expected) = message.split_once(", expected ")?;
        if !found.starts_with("invalid type") && !found.starts_with("invalid value") {
            return None;
        }
        let kind = match expected {
            "f32" | "f64" => say!(some_number),
            "u8" | "u16" | "u32" | "u64" | "usize" => say!(whole_number),
            // The second of a choice among texts.
            "a string" | "string only" => say!(quoted_text),
            "a boolean" => say!(true_or_false),
            other => {
                let mut kinds = KINDS.iter().map(Kind::expected);
                let kind = kinds.find(|kind| kind.to_string() == other);
                kind.unwrap_or_else(|| other.into())
            }
        };
        let value = match self.value(path)? {
            Value::Array(_) => say!(some_list),
            Value::Table(_) => say!(some_table),
            value => value.to_string().into(),
        };
        Some(say!(is_but_must_be, value, rule = kind))
    }

    /// A key that must be there and is not; `help` says what would be right, or is empty.
    pub fn missing(&self, key: &str, help: impl Into<Message>) -> CaseError {
        self.error(key, say!(is_missing), help.into())
    }

    /// A sentence about a key, which need not begin with it.
    pub fn refuse(&self, key: &str, message: impl Into<Message>) -> CaseError {
        self.invalid_at(key, message.into(), None)
    }

    /// A key whose value is not allowed; `rule` goes on after the key, whose sentence it completes where it
    /// [has no subject](Message::has_subject); `help` says what would be right, or is empty.
    pub fn invalid(&self, key: &str, rule: impl Into<Message>, help: impl Into<Message>) -> CaseError {
        self.error(key, rule.into(), help.into())
    }

    fn error(&self, key: &str, rule: Message, help: Message) -> CaseError {
        let shown = in_a_message(key);
        let message = match (key.is_empty(), rule.has_subject()) {
            (true, _) => rule,
            (false, true) => say!(key_and_rule, key = shown, rule),
            (false, false) => say!(key_as_subject, key = shown, rule),
        };
        let help = (!help.is_empty()).then_some(help);
        // The override may have set a table or a list around the key.
        let ends = key.match_indices(['.', '[']).rev();
        let tables = ends.map(|(end, _)| &key[..end]);
        let mut places = std::iter::once(key).chain(tables);
        let set = places.find_map(|place| self.overrides.get_key_value(place));
        let Some((set, assignment)) = set.or_else(|| self.made_of_overrides(key)) else {
            return self.invalid_at(key, message, help);
        };
        let message = match help {
            Some(help) => say!(one_after_other, one = message.clipped(), other = help),
            None => message.clipped(),
        };
        match assignment {
            Some(assignment) => CaseError::Override { assignment: clipped(assignment).into_owned(), message },
            None => CaseError::Changed { key: set.clone(), message },
        }
    }

    /// The first override of a table that the text does not have.
    fn made_of_overrides(&self, key: &str) -> Option<(&String, &Option<String>)> {
        if key.is_empty() || self.text.keys.contains_key(key) {
            return None;
        }
        let overrides = self.overrides.iter();
        let inner = overrides.filter(|(overridden, _)| within(overridden, key));
        inner.min()
    }

    /// The error, with the text where the key stands.
    fn invalid_at(&self, key: &str, message: Message, help: Option<Message>) -> CaseError {
        let span = self.text.span(key);
        let (excerpt, range) = excerpt(&self.text.text, span.clone().unwrap_or(0..0));
        CaseError::Invalid {
            key: clipped(key).into_owned(),
            message: message.clipped(),
            help,
            source_code: named(&self.text.name, excerpt),
            span: span.map(|_| range.into()),
        }
    }
}

/// The key of an override `key=value`.
pub fn overridden_key(assignment: &str) -> &str {
    assignment.split('=').next().unwrap_or_default().trim()
}

/// An excerpt under the name of its file.
fn named(name: &str, excerpt: String) -> Arc<NamedSource<String>> {
    Arc::new(NamedSource::new(in_a_message(name), excerpt))
}

/// "did you mean … ?" if a name is near, else the whole list.
fn suggestion(name: &str, allowed: &[&str]) -> Message {
    const NEAR: f64 = 0.75;
    let nearest = allowed
        .iter()
        .map(|candidate| (strsim::jaro_winkler(name, candidate), candidate))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(similarity, _)| *similarity > NEAR);
    let list = allowed.join(", ");
    match nearest {
        Some((_, nearest)) => say!(near_name, nearest = *nearest, allowed = list),
        None => say!(allowed_names, allowed = list),
    }
}
