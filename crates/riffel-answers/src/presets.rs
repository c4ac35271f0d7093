//! Presets, and the sources of their values.

use riffel_case::{Preset, PresetValue, preset, presets};
use riffel_keys::Message;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::question::{Client, Files, Question};
use crate::{Answer, Column, Printed, Result, Rows, Table};

/// List the presets, or show one with the sources of its values.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct PresetsQuestion {
    /// Preset to show.
    #[schemars(extend("positional" = true))]
    name: Option<String>,
}

impl Question for PresetsQuestion {
    const NAME: &'static str = "presets";
    const EXAMPLE: &'static str = "Example: riffel presets BS113A";
    const FILES: Files = Files::None;

    fn ask(&self, _: &dyn Client) -> Result<Box<dyn Answer>> {
        let preset = self.name.as_deref().map(preset).transpose()?;
        let document = match preset {
            Some(preset) => preset.document(),
            None => presets().iter().map(Preset::document).collect(),
        };
        Ok(Box::new(PresetsAnswer { document, preset }))
    }
}

/// All presets, or one.
#[derive(Serialize)]
#[serde(transparent)]
struct PresetsAnswer {
    /// Each value as written and in SI, with its unit and its source.
    document: Value,
    #[serde(skip)]
    preset: Option<&'static Preset>,
}

/// A column of words under an English head.
fn column<T>(head: &str, rows: &[T], words: impl Fn(&T) -> Message) -> Column {
    rows.shown(Message::verbatim(head), words)
}

impl Answer for PresetsAnswer {
    fn name(&self) -> &'static str {
        "presets"
    }

    fn introduction(&self) -> Vec<Message> {
        self.preset.map_or_else(Vec::new, |preset| {
            let named = format!("{} = \"{}\"", preset.kind.key(), preset.name);
            vec![(&preset.title).into(), Message::verbatim(named)]
        })
    }

    fn tables(&self) -> Vec<Table> {
        let all = presets();
        vec![Table {
            name: "presets",
            columns: match self.preset.map(|preset| &*preset.values) {
                None => vec![
                    column("name", all, |preset| Message::verbatim(&preset.name)),
                    column("key", all, |preset| Message::verbatim(preset.kind.key())),
                    column("what it is", all, |preset| (&preset.title).into()),
                ],
                Some(values) => vec![
                    column("key", values, |value: &PresetValue| Message::verbatim(&value.key)),
                    column("value", values, |value| Message::verbatim(&value.value)),
                    column("", values, |value| value.badge.words()),
                    column("source", values, |value| (&value.source).into()),
                ],
            },
        }]
    }

    fn sentences(&self) -> Vec<Message> {
        let how = || Message::verbatim("riffel presets NAME shows the values with their sources");
        self.preset.is_none().then(how).into_iter().collect()
    }

    fn printed(&self) -> Vec<Printed> {
        let lines = |lines: Vec<Message>| lines.into_iter().map(Printed::Line);
        let tables = self.tables().into_iter().map(Printed::Texts);
        lines(self.introduction()).chain(tables).chain(lines(self.sentences())).collect()
    }
}
