//! Identities and limits over random physical cases.

mod contact;
mod forecast;
mod growth;
mod track;
