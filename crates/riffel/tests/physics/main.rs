//! Identities and limits over random physical cases.

mod growth;
mod track;
