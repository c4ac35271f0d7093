//! The messages with their values, made of `messages/en.ftl`; [`say!`](crate::say) fills them in.
#![expect(non_camel_case_types, reason = "an id is no type: `say!(far_away)` reads as what is said")]

use super::{Message, Value};

include!(concat!(env!("OUT_DIR"), "/wording.rs"));
