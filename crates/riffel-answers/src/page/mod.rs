//! What the page asks and what it is answered: a question comes as JSON, its answer goes as bytes.
//!
//! There is no server here. `riffel serve` answers its page with this over HTTP, and the page that `riffel page`
//! writes holds the same code as WebAssembly. [`QUESTIONS`] is all that both can ask.
//!
//! ```
//! use riffel_answers::page::read;
//!
//! let question = read("/api/figure", br#"{ "number": 2, "contact": "quasi-static" }"#).unwrap()?;
//! let answer = question.answer()?;
//! assert!(answer.bytes.starts_with(b"{\"title\""));
//! # Ok::<(), riffel_answers::page::Fault>(())
//! ```

pub(crate) mod along;
mod bounds;
mod case;
mod case_text;
mod compare;
mod damage;
mod fault;
mod field;
mod figure;
mod line;
mod map;
pub(crate) mod measure;
mod own_values;
mod passage;
mod point;
mod remedies;
mod reply;
mod stability;
mod table;
mod traffic;
mod vocabulary;
mod wheelset;

use serde::de::DeserializeOwned;

pub use bounds::check_bounds;
pub use case_text::{CaseText, LARGEST_CASE};
pub use fault::Fault;
pub use reply::{Reply, written};
pub use traffic::Traffic;
pub use vocabulary::{VOCABULARY, vocabulary_of};

/// What a module of the answers holds, so that the release it is of can be told: [`RELEASE_BEGINS`], a version and `;`.
pub const RELEASE: &str = concat!("answers of riffel ", env!("CARGO_PKG_VERSION"), ";");

/// How [`RELEASE`] begins.
pub const RELEASE_BEGINS: &str = "answers of riffel ";

/// Told how many steps are done, and how many there are.
pub type Tell<'a> = &'a (dyn Fn(u64, u64) + Sync);

/// A question that was understood.
pub trait Question {
    /// What the answer is for: of the questions of one page for the same, only the newest is wanted.
    fn subject(&self) -> Option<String>;

    /// The answer; [`riffel::cancel::run_while`] breaks it off.
    ///
    /// # Errors
    /// A [`Fault`] of the case or of the question.
    fn answer(&self) -> Result<Reply, Fault>;

    /// Answer that reports its progress: what takes seconds tells how many of its steps are done, and how many there are.
    ///
    /// # Errors
    /// Errors of [`Self::answer`].
    fn answer_telling(&self, _tell: Tell<'_>) -> Result<Reply, Fault> {
        self.answer()
    }
}

/// Reads a question.
pub type Reader = fn(&[u8]) -> Result<Box<dyn Question + Send>, Fault>;

/// The questions by their paths.
pub const QUESTIONS: [(&str, Reader); 15] = [
    ("/api/case", reader::<case::Question>),
    ("/api/own-values", reader::<own_values::Question>),
    ("/api/map", reader::<map::Question>),
    ("/api/line", reader::<line::Question>),
    ("/api/remedies", reader::<remedies::Question>),
    ("/api/point", reader::<point::Question>),
    ("/api/compare", reader::<compare::Question>),
    ("/api/growth", reader::<compare::CurvesQuestion>),
    ("/api/figure", reader::<figure::Question>),
    ("/api/passage", reader::<passage::Question>),
    ("/api/stability", reader::<stability::Question>),
    ("/api/damage", reader::<damage::Question>),
    ("/api/field", reader::<field::Question>),
    ("/api/wheelset", reader::<wheelset::Question>),
    ("/api/export/csv", reader::<table::Question>),
];

/// A question in JSON; `None` for a path that is not one of [`QUESTIONS`].
pub fn read(path: &str, json: &[u8]) -> Option<Result<Box<dyn Question + Send>, Fault>> {
    let (_, reader) = QUESTIONS.into_iter().find(|(known, _)| *known == path)?;
    Some(reader(json))
}

fn reader<T>(json: &[u8]) -> Result<Box<dyn Question + Send>, Fault>
where
    T: DeserializeOwned + Question + Send + 'static,
{
    Ok(Box::new(understood::<T>(json)?))
}

/// A question of a given form.
///
/// # Errors
/// A [`Fault`] if it has another.
pub fn understood<T: DeserializeOwned>(json: &[u8]) -> Result<T, Fault> {
    serde_json::from_slice(json).map_err(|error| Fault::misunderstood(&error.to_string()))
}
