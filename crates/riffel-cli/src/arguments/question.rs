//! Questions on the command line: their keys as options.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Arg, ArgAction, ArgGroup, ArgMatches, Command, ValueHint};
use riffel_answers::question::{self, AnyQuestion, Files, Key, Kind, Rule};
use riffel_keys::question::{Held, holds};
use riffel_keys::text_file::is_standard_input;
use serde_json::{Map, Value};

use crate::error::CliError;
use crate::results::Results;

/// What names where results go.
const RESULTS: [&str; 3] = ["output", "save_format", "into"];

/// A question with its keys as they were given, and where its results go.
pub(crate) struct QuestionCall {
    pub(crate) question: &'static dyn AnyQuestion,
    pub(crate) keys: Map<String, Value>,
    /// The documents that stand in it.
    _held: Held,
    /// The folder that is named.
    pub(crate) output: Option<PathBuf>,
    /// Whether its document is printed.
    pub(crate) json: bool,
}

impl QuestionCall {
    /// The question of a command line.
    pub(crate) fn of(question: &'static dyn AnyQuestion, matches: &ArgMatches) -> Self {
        let keys = question.keys();
        let given = keys.iter().filter_map(|key| Some((key.name.clone(), given(key, matches)?)));
        let keys: Map<String, Value> = given.collect();
        let output = match keys.get("output") {
            Some(own) => own.as_str().map(PathBuf::from),
            None => matches.try_get_one::<PathBuf>("output").ok().flatten().cloned(),
        };
        let json = question.files() != Files::Text && matches.get_flag("json");
        Self { question, keys, _held: Held::default(), output, json }
    }

    /// The question of an object in JSON, which may name a place for results.
    pub(crate) fn of_json(question: &'static dyn AnyQuestion, mut keys: Map<String, Value>) -> Result<Self, CliError> {
        let own = question.keys();
        let output = match own.iter().any(|key| key.name == "output") {
            true => keys.get("output").cloned(),
            false if question.files() == Files::Named => keys.remove("output"),
            false => None,
        };
        let is_standard_input =
            |key: &&Key| key.kind == Kind::File && keys.get(&key.name).is_some_and(|path| path == "-");
        if let Some(key) = own.iter().find(is_standard_input) {
            let message = format!("`{}` is \"-\", but must be a file: standard input holds the question", key.name);
            return Err(CliError::Question { message });
        }
        let output = match output {
            None | Some(Value::Null) => None,
            Some(Value::String(path)) => Some(path.into()),
            Some(other) => {
                let message = format!("`output` is {other}, but must be a folder");
                return Err(CliError::Question { message });
            }
        };
        let held = question::hold(question, &mut keys);
        Ok(Self { question, keys, _held: held, output, json: true })
    }

    /// The files that it names, of which none may be replaced.
    pub(crate) fn inputs(&self) -> Vec<PathBuf> {
        let keys = self.keys.iter().filter(|(name, _)| !RESULTS.contains(&name.as_str()));
        let texts = keys.flat_map(|(_, value)| one_or_many(value)).filter_map(Value::as_str);
        texts.map(PathBuf::from).filter(|path| path.is_file() || is_standard_input(path)).collect()
    }

    /// Where its results go, under its name or another.
    pub(crate) fn results_of(&self, name: Option<&'static str>) -> Results {
        let command = name.unwrap_or(self.question.name());
        let usual = || match self.question.files() {
            // Of a question below another command the last word.
            Files::Named => Some(self.named_after(command.rsplit(' ').next().unwrap_or(command))),
            Files::There => self.first().map(PathBuf::from),
            Files::None | Files::Text | Files::OutputOnly => None,
        };
        let folder = self.output.clone().or_else(|| if self.json { None } else { usual() });
        Results { command, folder, json: self.json }
    }

    /// The folder that is named, or else one after the first file and what it holds.
    pub(crate) fn folder(&self, holds: &str) -> PathBuf {
        self.output.clone().unwrap_or_else(|| self.named_after(holds))
    }

    /// A folder named after the first file, or else the question, and what it holds.
    fn named_after(&self, holds: &str) -> PathBuf {
        let stem = match self.first().map(Path::new) {
            None => self.question.name().into(),
            Some(path) if is_standard_input(path) => "stdin".into(),
            Some(path) => path.file_stem().unwrap_or_default().to_string_lossy(),
        };
        format!("{stem}-{holds}").into()
    }

    /// The file or folder that stands without an option.
    fn first(&self) -> Option<&str> {
        let keys = self.question.keys();
        let first = keys.iter().find(|key| key.is_positional)?;
        one_or_many(self.keys.get(&first.name)?).first()?.as_str().filter(|path| !holds(Path::new(path)))
    }
}

/// The options of where results go.
fn results(question: &dyn AnyQuestion, keys: &[Key]) -> Vec<Arg> {
    let says_where = keys.iter().any(|key| key.name == "output");
    let help = match question.files() {
        Files::Text => return Vec::new(),
        Files::None => "Print one JSON document, complex numbers as [re, im]",
        Files::Named if !says_where => {
            "Print one JSON document, complex numbers as [re, im]; files are written only with --output"
        }
        Files::There if !says_where => "Print one JSON document and write no files",
        Files::Named | Files::There => "Print one JSON document; files are written only with --output",
        Files::OutputOnly => "Print one JSON document",
    };
    let json = Arg::new("json").long("json").help(help).action(ArgAction::SetTrue);
    let output = (question.files() == Files::Named && !says_where).then(|| {
        let output = Arg::new("output").short('o').long("output").value_name("DIR").help(Files::OUTPUT);
        output.value_parser(clap::value_parser!(PathBuf))
    });
    output.into_iter().chain([json]).collect()
}

/// The values of a list, or the one that is none.
fn one_or_many(value: &Value) -> &[Value] {
    match value {
        Value::Array(list) => list,
        one => std::slice::from_ref(one),
    }
}

/// What a command line gives for a key.
fn given(key: &Key, matches: &ArgMatches) -> Option<Value> {
    use clap::parser::ValueSource::CommandLine;
    (matches.value_source(&key.name) == Some(CommandLine)).then(|| match (&key.kind, key.takes_many) {
        (Kind::Flag, _) => Value::Bool(true),
        (_, true) => matches.get_many::<String>(&key.name).into_iter().flatten().cloned().collect(),
        (_, false) => matches.get_one::<String>(&key.name).cloned().into(),
    })
}

/// The command of a question.
pub(crate) fn command(question: &'static dyn AnyQuestion) -> Command {
    // Below another command it goes by its last word.
    let name = question.name().split(' ').next_back().unwrap_or_default();
    let command = Command::new(name).after_help(question.example());
    let keys = question.keys();
    let command = command.args(keys.iter().map(option));
    let command = question.rules().iter().fold(command, |command, rule| match rule {
        Rule::JustOneOf(names) => command.group(ArgGroup::new("just-one").args(*names).required(true)),
        _ => command,
    });
    command.args(results(question, keys)).about(question.about())
}

/// The option of a key.
fn option(key: &Key) -> Arg {
    let option = Arg::new(key.name.clone()).help(key.help.clone()).required(key.is_required);
    let option = match key.is_positional {
        true if key.takes_many => option.num_args(1..),
        true => option,
        false => option.long(key.name.replace('_', "-")).short((key.name == "output").then_some('o')),
    };
    if key.kind == Kind::Flag {
        return option.action(ArgAction::SetTrue);
    }
    let is_number = !matches!(key.kind, Kind::File | Kind::Choice(_) | Kind::Text { or_number: false });
    let option = option
        .action(if key.takes_many { ArgAction::Append } else { ArgAction::Set })
        .allow_hyphen_values(is_number && !key.is_positional)
        .value_delimiter(key.separator)
        .value_name(key.value_name.clone().unwrap_or_else(|| key.name.to_uppercase()));
    let option = match &key.default {
        Some(Value::String(text)) => option.default_value(text.clone()),
        Some(number) => option.default_value(number.to_string()),
        None => option,
    };
    let option = match &key.alias {
        Some(alias) => option.visible_alias(alias.clone()),
        None => option,
    };
    let option = match &key.alone {
        Some(alone) => option.num_args(0..=1).default_missing_value(alone.as_str().unwrap_or_default().to_owned()),
        None => option,
    };
    let option = option.hide_possible_values(key.tells_words);
    match &key.kind {
        _ if key.is_path => option.value_hint(ValueHint::AnyPath),
        Kind::Choice(words) => {
            let word = |[word, help]: &[String; 2]| PossibleValue::new(word.clone()).help(help.clone());
            option.value_parser(PossibleValuesParser::new(words.iter().map(word)))
        }
        _ => option,
    }
}
