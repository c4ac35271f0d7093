//! Tables that come with Riffel, one in each file of a folder.

use include_dir::Dir;

/// What the files of a folder hold, by name. One that does not read is left out.
pub(crate) fn built_in<T>(
    files: &Dir<'_>,
    parse: impl Fn(&str, &str) -> Option<T>,
    name: impl Fn(&T) -> &str,
) -> Vec<T> {
    let mut tables: Vec<T> =
        files.files().filter_map(|file| parse(file.path().to_str()?, file.contents_utf8()?)).collect();
    tables.sort_by(|a, b| name(a).cmp(name(b)));
    tables
}
