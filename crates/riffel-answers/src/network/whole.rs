//! A store of which nothing is lost, told.

use riffel_keys::{Message, number, say};
use serde::Serialize;

use crate::Answer;

/// A store of which nothing is lost or damaged.
#[derive(Serialize)]
pub struct WholeAnswer {
    /// How many surveys it holds.
    pub surveys: usize,
}

impl Answer for WholeAnswer {
    fn name(&self) -> &'static str {
        "check"
    }

    fn sentences(&self) -> Vec<Message> {
        vec![say!(surveys_are_whole, count = number(self.surveys))]
    }
}
