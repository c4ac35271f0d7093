//! Texts that stand in for files, by the names that those who gave them know.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

thread_local! {
    static IN_MEMORY: RefCell<BTreeMap<PathBuf, String>> = const { RefCell::new(BTreeMap::new()) };
}

/// The result of `read`, to which texts were given with their names: meanwhile readers on this thread take them in place of
/// files.
pub fn with_texts<T>(texts: impl IntoIterator<Item = (String, String)>, read: impl FnOnce() -> T) -> T {
    let texts = texts.into_iter();
    let texts = texts.map(|(name, text)| (name.into(), text));
    let outer = IN_MEMORY.replace(texts.collect());
    let done = read();
    IN_MEMORY.replace(outer);
    done
}

/// Text that stands under this name.
pub(crate) fn in_memory(path: &Path) -> Option<Vec<u8>> {
    IN_MEMORY.with_borrow(|texts| texts.get(path).map(|text| text.clone().into_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text_file::read_bounded;

    #[test]
    fn a_text_is_read_by_its_name_and_only_meanwhile() {
        let read = |name: &str| read_bounded(Path::new(name), "profile", 4);
        let texts = [("my wheel.csv".to_owned(), "0, 1".to_owned()), ("long.csv".to_owned(), "0, 10".to_owned())];
        with_texts(texts, || {
            assert_eq!(read("my wheel.csv").unwrap(), b"0, 1");
            let refused = read("long.csv").unwrap_err().to_string();
            assert!(refused.starts_with("long.csv: is larger than"), "{refused}");
            assert!(read("other.csv").is_err());
        });
        assert!(read("my wheel.csv").is_err());
    }
}
