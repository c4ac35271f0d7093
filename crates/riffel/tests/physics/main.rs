//! Identities and limits over random physical cases.

mod contact;
mod growth;
mod track;
