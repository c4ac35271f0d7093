//! What the page can ask for, one file for each.

pub(crate) mod along;
pub(crate) mod case;
pub(crate) mod compare;
pub(crate) mod curve;
pub(crate) mod export;
pub(crate) mod figure;
pub(crate) mod map;
pub(crate) mod noise;
mod note;
pub(crate) mod passage;
pub(crate) mod point;
pub(crate) mod report;
pub(crate) mod roughness;
pub(crate) mod vocabulary;
pub(crate) mod wheelset;
