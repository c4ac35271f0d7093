//! Files have names of ours in a private folder, and names that the user knows in all that is said of them.

use std::path::Path;

use serde_json::Value;

use crate::fault::Fault;
use crate::program::Program;
use crate::queue::Wanted;
use crate::uploads::Upload;

/// Longest name of a file that is shown.
pub(super) const LONGEST_NAME: usize = 120;

/// Names of files here, with those that the user knows.
pub(super) struct Names(Vec<(String, String)>);

impl Names {
    pub(super) fn new(pairs: impl IntoIterator<Item = (String, String)>) -> Self {
        let pairs = pairs.into_iter();
        Self(
            pairs
                .map(|(here, name)| (here, name.chars().take(LONGEST_NAME).collect()))
                .collect(),
        )
    }

    /// Words of the program with the names that the user knows, of which none is taken for one of ours.
    pub(super) fn put_into(&self, words: &str) -> String {
        self.put(words, str::to_owned)
    }

    /// A page of the program with the names that the user knows.
    pub(super) fn put_into_page(&self, page: &str) -> String {
        self.put(page, |name| {
            name.replace('&', "&amp;")
                .replace('<', "&lt;")
                .replace('>', "&gt;")
        })
    }

    fn put(&self, words: &str, written: impl Fn(&str) -> String) -> String {
        let (mut done, mut rest) = (String::new(), words);
        let first = |rest: &str| {
            let found = self.0.iter();
            found
                .filter_map(|(here, name)| Some((rest.find(here.as_str())?, here.len(), name)))
                .min_by_key(|(at, ..)| *at)
                .map(|(at, length, name)| (at, length, name.clone()))
        };
        while let Some((at, length, name)) = first(rest) {
            done.push_str(&rest[..at]);
            done.push_str(&written(&name));
            rest = &rest[at + length..];
        }
        done + rest
    }

    /// The same in all texts of a document.
    fn put_into_document(&self, document: Value) -> Value {
        match document {
            Value::String(text) => Value::String(self.put_into(&text)),
            Value::Array(list) => {
                let list = list.into_iter();
                list.map(|one| self.put_into_document(one)).collect()
            }
            Value::Object(table) => {
                let entries = table.into_iter();
                entries
                    .map(|(key, one)| (key, self.put_into_document(one)))
                    .collect()
            }
            other => other,
        }
    }

    /// What the program prints when it is run in a folder, with the names that the user knows.
    pub(super) fn document(
        &self,
        program: &Program,
        folder: &Path,
        arguments: &[&str],
        wanted: &Wanted,
    ) -> Result<Value, Fault> {
        let printed = program
            .run(folder, arguments, wanted)
            .map_err(|fault| fault.in_words(|words| self.put_into(words)))?;
        let document = serde_json::from_str(&printed)
            .map_err(|_| Fault::defect("the program printed something else than a document"))?;
        Ok(self.put_into_document(document))
    }
}

/// Words of the program with the name that the user knows.
pub(super) fn named(name: &str, words: &str, upload: &Upload) -> String {
    Names::new([(upload.name.clone(), name.to_owned())]).put_into(words)
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_name_of_the_user_is_never_taken_for_one_of_ours() {
        let names = [
            ("record.csv", "earlier-1.csv"),
            ("earlier-1.csv", "a \"b\" <c>.csv"),
        ];
        let names = names.map(|(here, name)| (here.to_owned(), name.to_owned()));
        let names = Names::new(names);
        let document = json!({ "file": "record.csv", "warnings": ["earlier-1.csv, line 1: record.csv"], "n": 1 });
        assert_eq!(
            names.put_into_document(document),
            json!({ "file": "earlier-1.csv", "warnings": ["a \"b\" <c>.csv, line 1: earlier-1.csv"], "n": 1 })
        );
        assert_eq!(
            names.put_into_page("<p>earlier-1.csv</p>"),
            "<p>a \"b\" &lt;c&gt;.csv</p>"
        );
    }
}
