//! The page of a report: HTML that loads nothing and prints on A4.

use std::fmt::Write as _;

use riffel_keys::{Language, Message, say};
use riffel_plot::Picture;

use crate::Table;

const STYLE: &str = include_str!("page.css");

/// No request may leave the page, and no script runs: the browser itself enforces it.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";

/// What a page says it was written by, near its beginning.
pub(super) const GENERATOR: &str = "<meta name=\"generator\" content=\"riffel report\">";

/// A section, or the sentence why there is none.
pub(super) enum Section {
    /// Heading and HTML.
    There(Message, String),
    /// Heading and a sentence.
    LeftOut(Message, Message),
}

/// What stands above the sections.
pub(super) struct Head<'a> {
    pub(super) title: String,
    pub(super) facts: Vec<(Message, &'a str)>,
    pub(super) remarks: Option<&'a str>,
    /// The strip map, or nothing.
    pub(super) map: String,
    /// Sentences of HTML that a reader in a hurry takes away.
    pub(super) brief: Vec<String>,
}

/// The whole page.
pub(super) fn page(head: &Head, sections: &[Section], language: Language) -> String {
    let title = escape(&head.title);
    let mut body = format!("<header>\n<h1>{title}</h1>\n");
    if !head.facts.is_empty() {
        body += "<dl class=\"facts\">\n";
        for (name, value) in &head.facts {
            let _ = writeln!(body, "<dt>{}</dt><dd>{}</dd>", said(name, language), escape(value));
        }
        body += "</dl>\n";
    }
    body += "</header>\n";
    if let Some(remarks) = head.remarks {
        let _ = writeln!(body, "<p>{}</p>", escape(remarks));
    }
    let in_brief = said(&say!(in_brief), language);
    let _ = write!(body, "<section class=\"brief\">\n<h2>{in_brief}</h2>\n");
    body += &head.map;
    body += "<ul>\n";
    for sentence in &head.brief {
        let _ = writeln!(body, "<li>{sentence}</li>");
    }
    body += "</ul>\n</section>\n";
    let mut left_out = String::new();
    let mut number = 0;
    for section in sections {
        match section {
            Section::There(heading, html) => {
                number += 1;
                let heading = said(heading, language);
                let _ = write!(body, "<section>\n<h2>{number} {heading}</h2>\n{html}</section>\n");
            }
            Section::LeftOut(heading, why) => {
                let why = why.clone().about(heading.clone());
                let _ = writeln!(left_out, "<li>{}.</li>", said(&why, language));
            }
        }
    }
    if !left_out.is_empty() {
        let heading = said(&say!(not_in_this_report), language);
        let _ = write!(body, "<section>\n<h2>{heading}</h2>\n<ul>\n{left_out}</ul>\n</section>\n");
    }
    let code = language.code();
    format!(
        "<!DOCTYPE html>\n<html lang=\"{code}\">\n<head>\n<meta charset=\"utf-8\">\n\
         {GENERATOR}\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n{body}</main>\n</body>\n</html>\n"
    )
}

/// Words for HTML.
pub(super) fn escape(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A message in HTML.
pub(super) fn said(message: &Message, language: Language) -> String {
    escape(&message.text(language))
}

/// A message as a sentence of its own in HTML.
pub(super) fn sentence(message: &Message, language: Language) -> String {
    escape(&message.capitalised(language)) + "."
}

/// HTML with words in bold where they first stand.
pub(super) fn bold(html: &str, words: &str) -> String {
    let words = escape(words);
    html.replacen(&words, &format!("<b>{words}</b>"), 1)
}

/// Messages in words, as for the heads of a table.
pub(super) fn texts<const N: usize>(messages: [Message; N], language: Language) -> Vec<String> {
    messages.iter().map(|message| message.text(language)).collect()
}

/// A table; its cells are HTML already.
pub(super) fn table(class: &str, header: &[String], rows: &[Vec<String>]) -> String {
    /// Rows up to which a table stays on one sheet.
    const SHORT: usize = 14;
    let keep = if rows.len() <= SHORT { " keep" } else { "" };
    let mut html = format!("<div class=\"wide{keep}\"><table class=\"{class}\">\n<thead><tr>");
    for cell in header {
        let _ = write!(html, "<th>{cell}</th>");
    }
    html += "</tr></thead>\n<tbody>\n";
    for row in rows {
        html += "<tr>";
        for cell in row {
            let _ = write!(html, "<td>{cell}</td>");
        }
        html += "</tr>\n";
    }
    html + "</tbody>\n</table></div>\n"
}

/// Heads and cells of a table as a reader sees them, in HTML.
pub(super) fn cells(table: &Table, language: Language) -> (Vec<String>, Vec<Vec<String>>) {
    let (heads, rows) = table.shown(language);
    (heads, rows.iter().map(|row| row.iter().map(|cell| escape(cell)).collect()).collect())
}

/// A table of an answer.
pub(super) fn table_of(shown: &Table, language: Language) -> String {
    let (heads, rows) = cells(shown, language);
    table("", &heads, &rows)
}

/// A list of items in HTML.
pub(super) fn list(items: impl IntoIterator<Item = String>) -> String {
    let mut html = "<ul>\n".to_owned();
    for item in items {
        let _ = writeln!(html, "<li>{item}</li>");
    }
    html + "</ul>\n"
}

/// A figure drawn in the page. The name of the drawing language is known to HTML and need not be said.
pub(super) fn figure(class: &str, picture: Picture, caption: &str, language: Language) -> String {
    let svg = picture.with_decimal_mark(language.decimal_mark()).svg();
    let svg = svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
    format!("<figure class=\"{class}\">\n{svg}\n<figcaption>{}</figcaption>\n</figure>\n", escape(caption))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stay_words() {
        let head = Head {
            title: "a<script>".to_owned(),
            facts: vec![(say!(line_of_site), "\"U2\" & co")],
            remarks: Some("</main>"),
            brief: Vec::new(),
            map: String::new(),
        };
        let left_out = Section::LeftOut(say!(growth_map), say!(no_case_given));
        let page = page(&head, &[left_out], Language::English);
        assert!(!page.contains("<script>") && page.contains("a&lt;script&gt;"));
        assert!(page.contains("&quot;U2&quot; &amp; co") && page.contains("&lt;/main&gt;"));
        assert!(page.contains("Growth map: no case was given."));
    }
}
