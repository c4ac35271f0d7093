//! `POST /api/compare`: two cases in one window.

use axum::extract::State;
use riffel_case::Case;
use serde::{Deserialize, Serialize};

use super::map::{Computed, Head};
use crate::Page;
use crate::fault::Fault;
use crate::framed::Framed;
use crate::request::{Asked, Asker, CaseText};

#[derive(Deserialize)]
pub(crate) struct Question {
    /// The variant that was kept.
    kept: CaseText,
    /// The case at hand, whose window both maps have.
    case: CaseText,
}

/// The values of the kept variant come first, then those of the case.
#[derive(Serialize)]
pub(crate) struct Answer {
    kept: Head,
    case: Head,
}

/// A fault of the kept variant is not one of the form.
fn of_the_kept(fault: Fault) -> Fault {
    fault.without_key("the kept variant: ")
}

/// The kept case with a contact that answers in the whole window of the other.
fn covering(kept: &Case, case: &Case) -> Result<Case, Fault> {
    let both = kept.covering(case.wavelength.min(), case.wavelength.max());
    both.map_err(|error| of_the_kept(error.into()))
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Framed<Answer>, Fault> {
    page.queue
        .run(asker.subject("comparison"), move |wanted| {
            let case = question.case.read()?;
            let kept = question.kept.read().map_err(of_the_kept)?;
            let kept = covering(&kept, &case)?;
            let (wavelength, speed) = (case.wavelength, case.speed);
            let before = Computed::new(&kept, &kept.feedback, wavelength, speed, wanted);
            let after = Computed::new(&case, &case.feedback, wavelength, speed, wanted);
            let mut values = before.values;
            values.extend(after.values);
            Ok(Framed {
                head: Answer {
                    kept: before.head,
                    case: after.head,
                },
                values,
            })
        })
        .await
}
