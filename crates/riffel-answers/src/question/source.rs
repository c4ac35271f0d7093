//! Where a value comes from: a file, or memory.

use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use riffel_keys::question;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer};

/// A value by its file, or as it is; what stands in a question in place of a file has a path, too.
pub enum Source<T> {
    /// To be read.
    File(PathBuf),
    /// In memory.
    InMemory(Arc<T>),
}

/// Name of what stands under a path: the path of its file, or its name in memory.
pub(crate) fn called(path: &Path) -> &Path {
    question::key_of(path).filter(|_| question::is_value(path)).unwrap_or(path)
}

impl<T> Source<T> {
    /// The path, if it is to be read.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::File(path) => Some(path),
            Self::InMemory(_) => None,
        }
    }

    /// The path, or an empty one for what is in memory.
    pub fn name(&self) -> &Path {
        self.path().unwrap_or_else(|| Path::new(""))
    }
}

impl<T: Send + Sync + 'static> Source<T> {
    /// The value, by `read` if it stands in a file.
    ///
    /// # Errors
    /// Errors of `read`.
    pub fn value<E>(&self, read: impl FnOnce(&Path) -> Result<T, E>) -> Result<Arc<T>, E> {
        match self {
            Self::File(path) => question::value(path).map_or_else(|| read(path).map(Arc::new), Ok),
            Self::InMemory(value) => Ok(value.clone()),
        }
    }
}

impl<T> From<T> for Source<T> {
    fn from(value: T) -> Self {
        Self::InMemory(Arc::new(value))
    }
}

impl<T> Clone for Source<T> {
    fn clone(&self) -> Self {
        match self {
            Self::File(path) => Self::File(path.clone()),
            Self::InMemory(value) => Self::InMemory(value.clone()),
        }
    }
}

impl<T> fmt::Debug for Source<T> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_tuple("Source").field(&self.path()).finish()
    }
}

impl<'de, T> Deserialize<'de> for Source<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        PathBuf::deserialize(deserializer).map(Self::File)
    }
}

impl<T> JsonSchema for Source<T> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        Cow::Borrowed("Source")
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({ "type": ["string", "object"] })
    }
}
