//! The page of a report: HTML that loads nothing and prints on A4.

use std::borrow::Cow;
use std::fmt::Write as _;

use riffel_plot::Picture;

const STYLE: &str = include_str!("page.css");

/// No request may leave the page, and no script runs: the browser itself enforces it.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";

/// What a page says it was written by, near its beginning.
pub const GENERATOR: &str = "<meta name=\"generator\" content=\"riffel report\">";

/// A section, or the sentence why there is none.
pub(super) enum Section {
    /// Heading and HTML.
    There(&'static str, String),
    /// Heading and a sentence.
    LeftOut(&'static str, Cow<'static, str>),
}

impl Section {
    /// A heading that has no section, and why.
    pub(super) fn left_out(heading: &'static str, why: impl Into<Cow<'static, str>>) -> Self {
        Self::LeftOut(heading, why.into())
    }
}

/// What stands above the sections.
pub(super) struct Head<'a> {
    pub(super) title: &'a str,
    pub(super) facts: Vec<(&'a str, &'a str)>,
    pub(super) remarks: Option<&'a str>,
    /// The strip map, or nothing.
    pub(super) map: String,
    /// Sentences of HTML that a reader in a hurry takes away.
    pub(super) brief: Vec<String>,
}

/// The whole page.
pub(super) fn page(head: &Head, sections: &[Section]) -> String {
    let title = escape(head.title);
    let mut body = format!("<header>\n<h1>{title}</h1>\n");
    if !head.facts.is_empty() {
        body += "<dl class=\"facts\">\n";
        for (name, value) in &head.facts {
            let _ = writeln!(body, "<dt>{}</dt><dd>{}</dd>", escape(name), escape(value));
        }
        body += "</dl>\n";
    }
    body += "</header>\n";
    if let Some(remarks) = head.remarks {
        let _ = writeln!(body, "<p>{}</p>", escape(remarks));
    }
    body += "<section class=\"brief\">\n<h2>In brief</h2>\n";
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
                let _ = write!(
                    body,
                    "<section>\n<h2>{number} {heading}</h2>\n{html}</section>\n"
                );
            }
            Section::LeftOut(heading, why) => {
                let _ = writeln!(left_out, "<li>{heading}: {}</li>", escape(why));
            }
        }
    }
    if !left_out.is_empty() {
        let _ = write!(
            body,
            "<section>\n<h2>Not in this report</h2>\n<ul>\n{left_out}</ul>\n</section>\n"
        );
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         {GENERATOR}\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n{body}</main>\n</body>\n</html>\n"
    )
}

/// Words for HTML.
pub(super) fn escape(words: &str) -> String {
    words
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// A table; its cells are HTML already.
pub(super) fn table(class: &str, header: &[&str], rows: &[Vec<String>]) -> String {
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

/// A list of sentences.
pub(super) fn list(sentences: impl IntoIterator<Item = String>) -> String {
    let mut html = "<ul>\n".to_owned();
    for sentence in sentences {
        let _ = writeln!(html, "<li>{}</li>", escape(&sentence));
    }
    html + "</ul>\n"
}

/// A figure drawn in the page. The name of the drawing language is known to HTML and need not be said.
pub(super) fn figure(class: &str, picture: &Picture, caption: &str) -> String {
    let svg = picture.svg();
    let svg = svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
    format!(
        "<figure class=\"{class}\">\n{svg}\n<figcaption>{}</figcaption>\n</figure>\n",
        escape(caption)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_stay_words() {
        let head = Head {
            title: "a<script>",
            facts: vec![("Line", "\"U2\" & co")],
            remarks: Some("</main>"),
            brief: Vec::new(),
            map: String::new(),
        };
        let page = page(&head, &[Section::left_out("Map", "there is no case.")]);
        assert!(!page.contains("<script>") && page.contains("a&lt;script&gt;"));
        assert!(page.contains("&quot;U2&quot; &amp; co") && page.contains("&lt;/main&gt;"));
        assert!(page.contains("Map: there is no case."));
    }
}
