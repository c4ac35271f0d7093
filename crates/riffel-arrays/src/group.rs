//! The metadata of a group of arrays.

use serde_json::{Map, Value, json};

use crate::Array;

/// The document `zarr.json` of a folder of arrays. It repeats the metadata of its arrays, so that a reader opens one
/// file instead of one for each array.
pub fn group<'a>(attributes: Value, arrays: impl IntoIterator<Item = &'a Array>) -> Value {
    let arrays = arrays.into_iter();
    let metadata: Map<String, Value> = arrays.map(|array| (array.name.clone(), array.metadata())).collect();
    json!({
        "zarr_format": 3,
        "node_type": "group",
        "attributes": attributes,
        "consolidated_metadata": { "kind": "inline", "must_understand": false, "metadata": metadata },
    })
}
