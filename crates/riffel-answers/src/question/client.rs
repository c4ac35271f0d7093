//! The client of a question.

use std::path::Path;
use std::sync::Arc;

use riffel_keys::{Language, Message};
use riffel_study::Stop;

/// Called after some more steps of the work.
pub type Step<'a> = Box<dyn Fn(usize) + Sync + 'a>;

/// Client of a question, which learns how far the work is and what is unusual about the question.
pub trait Client: Sync {
    /// Begin work of so many steps; it ends when the returned function goes.
    fn begin(&self, work: Message, steps: usize) -> Step<'_>;

    /// Begin work of so many draws, samples or the like, likewise.
    fn count(&self, work: Message, total: u64) -> Step<'_> {
        self.begin(work, total as usize)
    }

    /// What is going on.
    fn say(&self, _what: Message) {}

    /// What asks long work to end early.
    fn stop(&self) -> Arc<Stop> {
        Arc::default()
    }

    /// What should be asked about a value or a file before the answer is trusted.
    fn remark(&self, remarks: &[Message]);

    /// The language of pages.
    fn language(&self) -> Language {
        Language::English
    }

    /// Name a file that the answer is made of, which no result may replace.
    fn reads(&self, path: &Path);
}

/// Nobody who listens.
pub struct Nobody;

impl Client for Nobody {
    fn begin(&self, _: Message, _: usize) -> Step<'_> {
        Box::new(|_| ())
    }

    fn remark(&self, _: &[Message]) {}

    fn reads(&self, _: &Path) {}
}
