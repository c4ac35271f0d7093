//! Questions in JSON. A command of the program is the question; its options are the keys, without their dashes and with `_` for
//! `-` between words; a file of keys or a table may stand in its place as an object.

use std::any::TypeId;
use std::ffi::OsString;
use std::path::PathBuf;

use clap::{Arg, ArgAction, Command};
use riffel_keys::question::path_of;
use serde_json::{Map, Value, json};

use crate::error::CliError;

/// Arguments that are not asked: the answer is JSON in any case.
const NOT_ASKED: [&str; 2] = ["json", "help"];

/// Commands that answer nothing: they are for a person at a terminal, or write what others start from.
const NO_QUESTIONS: [&str; 10] =
    ["ask", "completions", "figures", "help", "init", "man", "page", "schema", "serve", "validate"];

/// The names of all questions, those below a command after its own name.
fn names(program: &Command) -> Vec<String> {
    let commands = program.get_subcommands();
    let asked = commands.filter(|command| !NO_QUESTIONS.contains(&command.get_name()));
    let names = asked.flat_map(|command| {
        let own = command.get_name();
        let below = names(command);
        let below = below.iter().map(|name| format!("{own} {name}"));
        let alone = !command.is_subcommand_required_set();
        let own = alone.then(|| own.to_owned());
        own.into_iter().chain(below).collect::<Vec<_>>()
    });
    names.collect()
}

/// The command of a question.
pub(crate) fn find(program: &Command, name: &[String]) -> Result<Command, CliError> {
    let known = names(program);
    let asked = name.join(" ");
    let below = |command: Command, name: &String| command.find_subcommand(name).cloned();
    let mut command = program.clone();
    command.build();
    let found = known.contains(&asked).then(|| name.iter().try_fold(command, below));
    found.flatten().ok_or_else(|| CliError::Argument {
        argument: "NAME",
        value: asked,
        rule: format!("one of {}", known.join(", ")),
    })
}

/// The command line of a question.
pub(crate) fn words(
    command: &Command,
    name: &[String],
    question: &Map<String, Value>,
) -> Result<Vec<OsString>, CliError> {
    let mut words: Vec<String> = name.to_vec();
    let mut files = Vec::new();
    let has_json = command.get_arguments().any(|argument| argument.get_id() == "json");
    words.extend(has_json.then(|| "--json".to_owned()));
    for (key, value) in question {
        let argument = arguments(command).find(|argument| key_of(argument) == *key);
        let argument = argument.ok_or_else(|| CliError::Question {
            message: format!(
                "`{key}` is not a key of {}; its keys are {}",
                name.join(" "),
                arguments(command).map(key_of).collect::<Vec<_>>().join(", ")
            ),
        })?;
        let option = match argument.is_positional() {
            true => None,
            false => Some(format!("--{}", key.replace('_', "-"))),
        };
        let given = match value {
            Value::Null | Value::Bool(false) => continue,
            Value::Bool(true) if may_stand_alone(argument) => {
                words.extend(option);
                continue;
            }
            Value::Array(list) if takes_many(argument) => {
                let list = list.iter().enumerate();
                list.map(|(place, value)| written(argument, &format!("{key}.{place}"), value))
                    .collect::<Result<_, _>>()?
            }
            value => vec![written(argument, key, value)?],
        };
        match option {
            Some(option) => words.extend(given.iter().map(|value| format!("{option}={value}"))),
            None => files.extend(given),
        }
    }
    words.push("--".to_owned());
    Ok(words.into_iter().chain(files).map(Into::into).collect())
}

/// A value as it stands on a command line.
fn written(argument: &Arg, key: &str, value: &Value) -> Result<String, CliError> {
    let rule = match value {
        Value::String(text) if text == "-" => "a file: standard input holds the question",
        Value::String(text) => return Ok(text.clone()),
        Value::Number(number) => return Ok(number.to_string()),
        Value::Object(_) if is_file(argument) => return Ok(path_of(key)),
        _ => "a number, a text or a list of them as `riffel schema --question` has it",
    };
    Err(CliError::Question { message: format!("`{key}` is {value}, but must be {rule}") })
}

/// The JSON schema of a question.
pub(crate) fn schema(command: &Command, name: &[String]) -> Value {
    let keys = arguments(command).map(|argument| (key_of(argument), property(argument)));
    let required = arguments(command).filter(|argument| argument.is_required_set());
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": format!("riffel ask {}", name.join(" ")),
        "description": command.get_about().map(ToString::to_string),
        "type": "object",
        "properties": keys.collect::<Map<_, _>>(),
        "required": required.map(key_of).collect::<Vec<_>>(),
        "additionalProperties": false,
    })
}

fn property(argument: &Arg) -> Value {
    let parser = argument.get_value_parser();
    let is = |types: &[TypeId]| types.iter().any(|one| parser.type_id() == *one);
    let values = argument.get_possible_values();
    let kind = if !argument.get_action().takes_values() {
        json!("boolean")
    } else if is(&[TypeId::of::<f64>()]) {
        json!("number")
    } else if is(&[TypeId::of::<u16>(), TypeId::of::<u32>(), TypeId::of::<u64>(), TypeId::of::<usize>()]) {
        json!("integer")
    } else if !values.is_empty() {
        json!("string")
    } else if is_file(argument) {
        json!(["string", "object"])
    } else {
        json!(["string", "number"])
    };
    let mut one = json!({ "type": kind });
    if argument.get_action().takes_values() && !values.is_empty() {
        one["enum"] = values.iter().map(|value| value.get_name()).collect();
    }
    let mut property = match takes_many(argument) {
        true => json!({ "type": "array", "items": one }),
        false => one,
    };
    property["description"] = argument.get_help().map(ToString::to_string).into();
    let default = argument.get_default_values().first();
    if let Some(default) = default.and_then(|value| value.to_str()) {
        let is_text = !matches!(kind.as_str(), Some("number" | "integer"));
        let number = serde_json::from_str(default).ok().filter(|_| !is_text);
        property["default"] = number.unwrap_or_else(|| default.into());
    }
    property
}

/// What is asked of a command.
fn arguments(command: &Command) -> impl Iterator<Item = &Arg> {
    command
        .get_arguments()
        .filter(|argument| !argument.is_global_set() && !NOT_ASKED.contains(&argument.get_id().as_str()))
}

/// The name of an option, or what a positional argument is called in the help.
fn key_of(argument: &Arg) -> String {
    let names = argument.get_value_names().unwrap_or_default();
    let positional = || names.first().map_or(argument.get_id().as_str(), |name| name);
    let name = argument.get_long().unwrap_or_else(positional);
    name.to_lowercase().replace('-', "_")
}

/// Whether an option may be given without a value.
fn may_stand_alone(argument: &Arg) -> bool {
    let values = argument.get_num_args();
    values.is_some_and(|count| count.min_values() == 0)
}

fn takes_many(argument: &Arg) -> bool {
    let many = argument.get_num_args().is_some_and(|count| count.max_values() > 1);
    many || matches!(argument.get_action(), ArgAction::Append)
}

/// Whether a file is named.
fn is_file(argument: &Arg) -> bool {
    argument.get_value_parser().type_id() == TypeId::of::<PathBuf>()
}
