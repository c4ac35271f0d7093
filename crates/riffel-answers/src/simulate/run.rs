//! What marches in time have in common, whatever they roll over.

use riffel::contact::ContactFilter;
use riffel::passage::PassageModel;
use riffel_case::{Case, ContactName, ask};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure};
use serde::Serialize;

use super::ContactHistory;
use crate::answer::titled;
use crate::parameters::parameters_on_rail;
use crate::{Answer, ResultFile, Table};

/// What every march of a case has, beside the numbers of its own.
pub struct Run {
    /// Courses of all contacts in their order.
    pub courses: Vec<ContactHistory>,
    /// Names of the contacts whose courses are told one by one; else empty.
    pub contacts: Vec<ContactName>,
    /// Remarks on the march itself.
    pub own_remarks: Vec<Message>,
    /// Remarks on the march and on its case.
    pub(super) remarks: Vec<Message>,
    pub(super) case: Case,
}

impl Run {
    /// A march with remarks of its own and those of its case.
    pub(super) fn new(case: &Case, own_remarks: impl IntoIterator<Item = Message>, of_case: &[Message]) -> Self {
        let own_remarks: Vec<Message> = own_remarks.into_iter().collect();
        Self {
            courses: Vec::new(),
            contacts: Vec::new(),
            remarks: of_case.iter().chain(&own_remarks).cloned().collect(),
            own_remarks,
            case: case.clone(),
        }
    }

    /// The title of the case, or the usual one.
    pub(super) fn titled(&self, usual: Message) -> Message {
        titled(self.case.file.title.as_ref(), usual)
    }

    /// Courses of the contacts after the first, by their names.
    pub(super) fn others(&self) -> impl Iterator<Item = (ContactName, &ContactHistory)> {
        self.contacts.iter().copied().zip(&self.courses).skip(1)
    }
}

/// The model of a case at a speed \[m/s\], whose wheels feel the mean over their patch where the profile is filtered.
pub(super) fn model(case: &Case, speed: f64, contact_filter: bool) -> Result<PassageModel, CaseError> {
    let mut model = ask::in_time(case, speed)?;
    model.contact_filter = contact_filter.then(|| ContactFilter::of(&case.hertz));
    Ok(model)
}

/// Answer that is a march with the course of each contact.
pub(super) trait March: Serialize {
    /// Name of its table and picture.
    const NAME: &'static str;
    /// File of its document.
    const DOCUMENT: &'static str;

    fn run(&self) -> &Run;

    /// Title, what it is over, and how it went.
    fn about(&self) -> Vec<Message>;

    /// A table for readers.
    fn shown(&self) -> Option<Table> {
        None
    }

    /// Sentences below the tables.
    fn below_tables(&self) -> Vec<Message> {
        Vec::new()
    }

    /// Title of the picture, what its caption says before the parameters, and the number of the contact in it.
    fn picture(&self) -> (String, String, usize);
}

impl<M: March> Answer for M {
    fn name(&self) -> &'static str {
        M::NAME
    }

    fn document_name(&self) -> &'static str {
        M::DOCUMENT
    }

    fn introduction(&self) -> Vec<Message> {
        self.about()
    }

    fn tables(&self) -> Vec<Table> {
        self.shown().into_iter().chain([self.run().courses[0].table(M::NAME)]).collect()
    }

    fn sentences(&self) -> Vec<Message> {
        self.below_tables()
    }

    /// The course of a contact as strips.
    fn figure(&self) -> LineFigure {
        let (title, about, contact) = self.picture();
        let Run { courses, case, .. } = self.run();
        LineFigure::new(
            title,
            format!("{about} {}", parameters_on_rail(case)),
            courses.get(contact).map(ContactHistory::panels).unwrap_or_default(),
        )
        .arranged(Arrangement::Strips)
    }

    /// The picture, tables and grid of the first contact, and tables of the others.
    fn files(&self) -> Vec<ResultFile<'_>> {
        let (run, figure) = (self.run(), self.figure());
        let grid = ResultFile::Grid(M::NAME, run.courses[0].grid(figure.title.clone()));
        let tables = ResultFile::tables(self.tables());
        let others = run.others().map(|(ContactName { wheel, rail }, course)| {
            ResultFile::TableAs(format!("{}-{wheel}-{rail}", M::NAME), course.table(M::NAME))
        });
        [ResultFile::Lines(M::NAME, figure)].into_iter().chain(tables).chain([grid]).chain(others).collect()
    }

    fn remarks(&self) -> &[Message] {
        &self.run().remarks
    }
}
