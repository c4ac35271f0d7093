//! An answer, as bytes.

use riffel_keys::message::as_data;
use serde::Serialize;

use crate::page::fault::Fault;

/// An answer.
#[derive(Clone)]
pub struct Reply {
    /// Its content type.
    pub content_type: &'static str,
    /// A file for the disk of the user, not for the page.
    pub attached: bool,
    /// What it says.
    pub bytes: Vec<u8>,
}

impl Reply {
    /// An answer in JSON.
    pub(crate) fn json(answer: &impl Serialize) -> Result<Self, Fault> {
        Ok(Self { content_type: "application/json", attached: false, bytes: written(answer)? })
    }

    /// Numbers by the ten thousand, with a head that says what they are.
    ///
    /// The length of the head in bytes (u32, little-endian), the head in JSON, padded with blanks to a multiple
    /// of four bytes, then the values (f32, little-endian): the browser looks at them as they lie, where a map
    /// in JSON would take it longer to read than to draw.
    pub(crate) fn framed(head: &impl Serialize, values: &[f32]) -> Result<Self, Fault> {
        let mut head = written(head)?;
        head.resize(head.len().next_multiple_of(4), b' ');
        let length = u32::try_from(head.len()).map_err(|_| Fault::defect("the answer is too long"))?;
        let mut bytes = Vec::with_capacity(4 + head.len() + 4 * values.len());
        bytes.extend(length.to_le_bytes());
        bytes.extend(head);
        bytes.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        Ok(Self { content_type: "application/octet-stream", attached: false, bytes })
    }
}

/// An answer in JSON, its messages as data: the page makes words of them.
///
/// # Errors
/// A [`Fault`] if it has no JSON.
pub fn written(answer: &impl Serialize) -> Result<Vec<u8>, Fault> {
    as_data(|| serde_json::to_vec(answer)).map_err(|_| Fault::defect("the answer cannot be written"))
}
