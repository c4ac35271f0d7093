//! The models of the field, each with its joints, in the chapter on them.

use std::fs;

use riffel_case::model::{FieldModel, Joint};

use crate::marked::between_marks;
use crate::root;

const PAGE: &str = "docs/src/models.md";

/// The chapter with the descriptions of all models.
pub(crate) fn page() -> Result<String, String> {
    let page = fs::read_to_string(root().join(PAGE)).map_err(|error| format!("cannot read {PAGE}: {error}"))?;
    let models = FieldModel::all().iter().map(described).collect::<Vec<_>>().join("\n");
    between_marks(PAGE, &page, "models", models.trim_end())
}

fn described(model: &FieldModel) -> String {
    let mut text = format!("### {}\n\n`{}`: {}\n\n", model.title, model.name, model.source);
    text += "| joint | what stands there |\n|---|---|\n";
    for joint in Joint::ALL {
        text += &format!("| {} | {} |\n", joint.name(), model.joints.words(joint));
    }
    for (head, items) in [
        ("Assumes", &model.assumptions),
        ("Leaves out", &model.leaves_out),
        ("Not given, or not at hand", &model.not_given),
    ] {
        if items.is_empty() {
            continue;
        }
        text += &format!("\n{head}:\n\n");
        for item in items {
            text += &format!("* {item}\n");
        }
    }
    text
}
