//! Questions as data: one type for each command of the program.
//!
//! The fields of a question are its keys in JSON, the options of the program and the keywords of Python; their docs are the help, the
//! schema and the reference; their defaults stand once, in the schema. Whoever asks hands in a map of keys, which is checked here: a wrong
//! value is refused by the same sentence everywhere.

mod as_written;
mod case_source;
mod client;
mod files;
mod ground_source;
mod key;
mod money;
mod posterior_source;
mod rail_records;
mod rule;
mod source;
mod threads;

use std::any::TypeId;
use std::collections::BTreeMap;
use std::marker::PhantomData;
use std::sync::{Mutex, PoisonError};

use schemars::{JsonSchema, schema_for};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

pub use as_written::AsWritten;
pub use case_source::{CaseSource, OfCase, covering};
pub use client::{Client, Nobody, Step};
pub use files::Files;
pub use ground_source::GroundSource;
pub use key::{Key, Kind, hold};
pub(crate) use money::Money;
pub use posterior_source::{PosteriorSource, finished_of, over};
pub use rail_records::{EarlierRecords, History, KeptRecords, RecordLayout, positive};
pub(crate) use rail_records::{choose_nothing, date_of};
pub use rule::Rule;
pub use source::Source;
pub(crate) use source::called;
pub use threads::on_threads;

use crate::{Answer, AnswerError, QUESTIONS, QUESTIONS_OF_THE_PAGE, Result};

/// A question of its own type; its docs say what it asks.
pub trait Question: DeserializeOwned + JsonSchema + 'static {
    /// Name of the question, and of the command of the program.
    const NAME: &'static str;
    /// Command lines to try, below the help.
    const EXAMPLE: &'static str;
    /// Which keys need or exclude others.
    const RULES: &'static [Rule] = &[];

    /// Where the program writes the files of the answer.
    const FILES: Files = Files::Named;

    /// The answer; `client` is told how far it is and what is unusual about the question.
    ///
    /// # Errors
    /// [`AnswerError`] with the key or the file at fault.
    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>>;
}

/// A question of any type, by its keys.
pub trait AnyQuestion: Sync {
    /// Name of the question, and of the command of the program.
    fn name(&self) -> &'static str;
    /// Command lines to try, below the help.
    fn example(&self) -> &'static str;
    /// Which keys need or exclude others.
    fn rules(&self) -> &'static [Rule];
    /// Where the program writes the files of the answer.
    fn files(&self) -> Files;
    /// What it asks, in one line.
    fn about(&self) -> &'static str;
    /// Its keys, in the order of its fields.
    fn keys(&self) -> &'static [Key];
    /// The JSON schema of its keys.
    fn schema(&self) -> Value;
    /// The answer to the question that has these keys.
    ///
    /// # Errors
    /// [`AnswerError::Question`] for a key that is unknown, missing or of the wrong kind; those of [`Question::ask`].
    fn answer(&self, keys: Map<String, Value>, client: &dyn Client) -> Result<Box<dyn Answer>>;
}

/// The question of a name, of the program or of the page.
pub fn named(name: &str) -> Option<&'static dyn AnyQuestion> {
    QUESTIONS.iter().chain(QUESTIONS_OF_THE_PAGE).copied().find(|question| question.name() == name)
}

/// The question of a name that somebody wrote.
///
/// # Errors
/// [`AnswerError::Argument`] for a name that no question has.
pub fn known(name: &str) -> Result<&'static dyn AnyQuestion> {
    named(name).ok_or_else(|| {
        let known: Vec<&str> = QUESTIONS.iter().map(|question| question.name()).collect();
        let rule = format!("one of {}", known.join(", "));
        AnswerError::argument("NAME", name, rule)
    })
}

/// A question of some keys.
///
/// # Errors
/// [`AnswerError::Question`] for a key that is unknown, missing or of the wrong kind.
pub fn of_keys<Q: Question>(keys: Value) -> Result<Q> {
    match keys {
        Value::Object(keys) => key::question(&described::<Q>().keys, keys),
        other => {
            let message = format!("the question is {other}, but must be an object");
            Err(AnswerError::Question { question: Q::NAME, message })
        }
    }
}

/// The questions of a type.
#[derive(Debug)]
pub struct Of<Q>(PhantomData<fn() -> Q>);

/// The questions of a type, by their keys.
pub const fn of<Q: Question>() -> Of<Q> {
    Of(PhantomData)
}

/// What the schema of a question says of it.
struct Described {
    about: String,
    keys: Vec<Key>,
}

/// What the schema of a question says, which is generated once: a command line is made of all questions, and read by one.
fn described<Q: Question>() -> &'static Described {
    static DESCRIBED: Mutex<BTreeMap<TypeId, &'static Described>> = Mutex::new(BTreeMap::new());
    let mut known = DESCRIBED.lock().unwrap_or_else(PoisonError::into_inner);
    known.entry(TypeId::of::<Q>()).or_insert_with(|| {
        let schema = schema_for!(Q);
        let about = key::description(schema.get("description"));
        Box::leak(Box::new(Described { about, keys: Key::all(&schema) }))
    })
}

impl<Q: Question> AnyQuestion for Of<Q> {
    fn name(&self) -> &'static str {
        Q::NAME
    }

    fn example(&self) -> &'static str {
        Q::EXAMPLE
    }

    fn rules(&self) -> &'static [Rule] {
        Q::RULES
    }

    fn files(&self) -> Files {
        Q::FILES
    }

    fn about(&self) -> &'static str {
        &described::<Q>().about
    }

    fn keys(&self) -> &'static [Key] {
        &described::<Q>().keys
    }

    fn schema(&self) -> Value {
        let keys = self.keys();
        let required = keys.iter().filter(|key| key.is_required).map(|key| &key.name);
        let properties = keys.iter().map(|key| (key.name.clone(), key.property()));
        let says_where = keys.iter().any(|key| key.name == "output");
        let output = (Q::FILES == Files::Named && !says_where)
            .then(|| json!({ "type": ["string", "object"], "description": Files::OUTPUT }));
        let properties = properties.chain(output.map(|output| ("output".to_owned(), output)));
        json!({
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": format!("riffel ask {}", self.name()),
            "description": self.about(),
            "type": "object",
            "properties": properties.collect::<Map<_, _>>(),
            "required": required.collect::<Vec<_>>(),
            "additionalProperties": false,
        })
    }

    fn answer(&self, keys: Map<String, Value>, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let question = key::question::<Q>(self.keys(), keys)?;
        question.ask(client)
    }
}
