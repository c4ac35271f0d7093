//! Figures as pages of HTML.

mod html;
mod line;
mod map;

pub use html::plotly_js;
pub use line::html_of_stages;
