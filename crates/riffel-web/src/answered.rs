//! Long answers, kept for the next who asks the same: a page that is opened or reloaded, a step back.
//!
//! A question holds all that its answer depends on, so an answer that is kept is the one that would be computed.

use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::body::Bytes;
use quick_cache::Weighter;
use quick_cache::sync::Cache;
use riffel_answers::page::Reply;

use crate::fault::Fault;
use crate::queue::CancelToken;

/// An answer that took less is computed again: those of a slider would drive out the others.
const WORTH_KEEPING: Duration = Duration::from_millis(50);
/// Room for questions and answers \[bytes\]: some 500 rankings of remedies.
const MOST_BYTES: u64 = 16 << 20;
const MOST_ANSWERS: usize = 1024;

/// Where a question goes, and what it says.
type QuestionKey = (&'static str, Bytes);

/// The answers that are kept; the least used go first.
#[derive(Clone)]
pub(crate) struct Answered(Arc<Cache<QuestionKey, Arc<Reply>, Size>>);

#[derive(Clone)]
struct Size;

impl Weighter<QuestionKey, Arc<Reply>> for Size {
    fn weight(&self, (_, question): &QuestionKey, reply: &Arc<Reply>) -> u64 {
        (question.len() + reply.bytes.len()) as u64
    }
}

impl Default for Answered {
    fn default() -> Self {
        Self(Arc::new(Cache::with_weighter(MOST_ANSWERS, MOST_BYTES, Size)))
    }
}

impl Answered {
    /// The answer to a question, if it is kept.
    pub(crate) fn to(&self, path: &'static str, question: &Bytes) -> Option<Arc<Reply>> {
        self.0.get(&(path, question.clone()))
    }

    /// Compute an answer, and keep it if that took long. What nobody waited for to its end is no answer.
    pub(crate) fn keep(
        &self,
        path: &'static str,
        question: Bytes,
        cancel: &CancelToken,
        answer: impl FnOnce() -> Result<Reply, Fault>,
    ) -> Result<Arc<Reply>, Fault> {
        let begun = Instant::now();
        let reply = Arc::new(answer()?);
        if begun.elapsed() >= WORTH_KEEPING && cancel.is_wanted() {
            self.0.insert((path, question), reply.clone());
        }
        Ok(reply)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::queue::Queue;

    fn kept(answered: &Answered, question: &'static str, takes: Duration, size: usize) -> bool {
        let question = Bytes::from_static(question.as_bytes());
        let answer = || {
            std::thread::sleep(takes);
            Ok(Reply { content_type: "application/json", attached: false, bytes: vec![0; size] })
        };
        answered.keep("/api/line", question.clone(), &CancelToken::default(), answer).unwrap();
        assert!(answered.to("/api/map", &question).is_none());
        answered.to("/api/line", &question).is_some()
    }

    #[test]
    fn what_took_long_is_kept_within_bounds() {
        let answered = Answered::default();
        assert!(kept(&answered, "long", WORTH_KEEPING, 1000));
        assert!(!kept(&answered, "large", WORTH_KEEPING, usize::try_from(MOST_BYTES).unwrap()));
        assert!(answered.0.weight() <= MOST_BYTES);
    }

    #[tokio::test]
    async fn neither_a_fault_nor_what_was_given_up_is_kept() {
        let answered = Answered::default();
        let question = Bytes::from_static(b"question");
        let asked = |reply: Result<Reply, Fault>| {
            let (answered, question) = (answered.clone(), question.clone());
            move |cancel: &CancelToken| {
                answered.keep("/api/line", question, cancel, || {
                    std::thread::sleep(WORTH_KEEPING);
                    reply
                })
            }
        };
        let reply = || Reply { content_type: "application/json", attached: false, bytes: Vec::new() };
        let queue = Queue::new(1);
        assert!(queue.run(None, asked(Err(Fault::bad("wrong")))).await.is_err());
        assert!(answered.to("/api/line", &question).is_none());
        let closing = queue.clone();
        let given_up = asked(Ok(reply()));
        let outcome = queue.run(None, move |cancel| {
            closing.close();
            given_up(cancel)
        });
        assert!(outcome.await.is_err());
        assert!(answered.to("/api/line", &question).is_none());
        assert!(Queue::new(1).run(None, asked(Ok(reply()))).await.is_ok());
        assert!(answered.to("/api/line", &question).is_some());
    }
}
