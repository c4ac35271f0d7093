//! Generated parts of a written page, between two marks.

/// The page with the text in place of what stands between the two marks of that name.
pub(crate) fn between_marks(path: &str, page: &str, name: &str, text: &str) -> Result<String, String> {
    let begin = format!("<!-- {name}: written by cargo xtask generate -->\n");
    let end = format!("<!-- end of {name} -->");
    let missing = || format!("{path} lacks the marks of \"{name}\"");
    let (before, rest) = page.split_once(&begin).ok_or_else(missing)?;
    let (_, after) = rest.split_once(&end).ok_or_else(missing)?;
    Ok(format!("{before}{begin}\n{text}\n{end}{after}"))
}
