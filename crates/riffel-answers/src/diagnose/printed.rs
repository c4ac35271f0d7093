//! A finding in lines.

use riffel_keys::{Message, say};

use super::{Finding, tables};
use crate::Printed;
use crate::capital::{as_sentence, capitalised};

/// Share from which a candidate's reasons are told, and how many are at least.
const SHOWN: (f64, usize) = (0.02, 3);

/// What a reader sees of a finding.
pub(super) fn finding(finding: &Finding) -> Vec<Printed> {
    let course = finding.course().map(|course| say!(course_line, course));
    let sureness = say!(indented_line, line = finding.sureness());
    let before = [Message::verbatim(""), finding.headline(), sureness].into_iter().chain(course);
    let summary = capitalised(&finding.summary());
    if finding.candidates.is_empty() {
        return before.chain([summary]).map(Printed::Line).collect();
    }
    let shown = finding.candidates.iter().enumerate();
    let shown = shown.filter(|(place, candidate)| *place < SHOWN.1 || candidate.share >= SHOWN.0);
    let reasons = shown.flat_map(|(_, candidate)| {
        let name = finding.name(candidate);
        let supporting = finding.reasons(&candidate.reasons_for).map(|reason| say!(reason_for, reason));
        let opposing = finding.reasons(&candidate.reasons_against).map(|reason| say!(reason_against, reason));
        [name].into_iter().chain(supporting).chain(opposing)
    });
    let measurements = finding.measurements().map(|one| say!(indented_line, line = as_sentence(&one)));
    let after = [summary].into_iter().chain(reasons).chain([say!(telling_them_apart)]).chain(measurements);
    let table = Printed::Table(tables::of_finding(finding));
    before.map(Printed::Line).chain([table]).chain(after.map(Printed::Line)).collect()
}
