//! A wheel of a case along a rail, in time.

mod along_rail;
mod course;
mod evolution;
mod question;
mod rail;
mod remarks;
mod sinusoid;
mod smooth_rail;

pub use along_rail::{PassageAnswer, PassageRequest};
pub use course::Course;
pub use evolution::{EvolutionAnswer, EvolutionRequest, EvolutionRun, Surface};
pub use question::SimulateQuestion;
pub use sinusoid::{SinusoidAnswer, SinusoidRequest};
pub use smooth_rail::SmoothRailAnswer;

use riffel_case::ContactName;
use riffel_keys::{Message, fixed, say};

use crate::{Answer, ResultFile};

/// Least and largest normal force \[N\], and the share of the time without contact.
fn force_in_words(force: [f64; 2], loss: f64) -> Message {
    let [least, largest] = force.map(|force| fixed(1e-3 * force, 2));
    say!(normal_force_between, least = least, largest = largest, contact = contact_in_words(loss))
}

fn contact_in_words(loss: f64) -> Message {
    match loss {
        0.0 => say!(always_in_contact),
        share => say!(no_contact_for, share = fixed(100.0 * share, 1)),
    }
}

/// The picture, tables and grid of an answer with a course, and tables of the other contacts.
fn files<'a>(
    answer: &dyn Answer,
    course: &'a Course,
    others: impl Iterator<Item = (ContactName, &'a Course)>,
) -> Vec<ResultFile<'a>> {
    let figure = answer.figure();
    let name = answer.name();
    let grid = ResultFile::Grid(name, course.grid(figure.title.clone()));
    let tables = ResultFile::tables(answer.tables());
    let others = others.map(|(ContactName { wheel, rail }, course)| {
        ResultFile::TableAs(format!("{name}-{wheel}-{rail}"), course.table(name))
    });
    [ResultFile::Lines(name, figure)].into_iter().chain(tables).chain([grid]).chain(others).collect()
}
