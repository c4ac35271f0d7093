//! Pages of HTML that show figures with plotly.js and load nothing. Figures are its JSON.

use std::sync::LazyLock;

use plotly::Plot;
use serde_json::{Value, json};

use crate::drawing::subscript;
use crate::drawing::text;
use crate::drawing::text::{TICK_FONT, TITLE_FONT};

/// A panel of a page: traces and layout of plotly.js.
pub(crate) struct PagePanel {
    pub(crate) data: Vec<Value>,
    pub(crate) layout: Value,
    /// Second grid of a map, null if there is none.
    pub(crate) hover: Value,
}

/// Styles of the page. Panels stand side by side where there is room.
const STYLE: &str = "\
body{margin:0;background:#fff;color:#222;font-family:\"DejaVu Sans\",Verdana,sans-serif;line-height:1.45}\
main{max-width:1600px;margin:0 auto;padding:16px}\
h1{font-size:1.15rem;margin:0 0 8px}\
.panels{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,660px),1fr));gap:12px}\
.stacked{grid-template-columns:1fr}\
.panel{height:min(640px,88vh);min-height:420px;min-width:0}\
.stage{display:flex;gap:12px;align-items:center;margin:0 0 8px;font-size:.9rem}\
.stage input{flex:1;max-width:40em}\
.caption{font-size:.85rem;max-width:75em;white-space:pre-line}";

/// Draws all panels of a page; the sizes follow the window. What follows from other numbers of a
/// map is computed here instead of being written out: the speed in m/s, the frequency, the zero
/// contour.
const SCRIPT: &str = "\
const stages=JSON.parse(document.getElementById('figure').textContent);
const buttons=['select2d','lasso2d','autoScale2d'];
const config={responsive:true,displaylogo:false,modeBarButtonsToRemove:buttons,toImageButtonOptions:{format:'svg'}};
const show=panels=>panels.forEach((panel,index)=>{
  const map=panel.data.find(trace=>trace.name==='map');
  if(map){
    const extra=panel.hover;
    map.customdata=map.z.map((row,j)=>row.map((_,i)=>
      [map.y[j]/3.6,1000*map.y[j]/(3.6*map.x[i]),extra?extra[j][i]:null]));
    panel.data.filter(trace=>trace.meta==='zero').forEach(zero=>Object.assign(zero,{x:map.x,y:map.y,z:map.z}));
  }
  Plotly.react('panel-'+index,panel.data,panel.layout,config);
});
show(stages[stages.length-1].panels);
const slider=document.getElementById('stage');
if(slider)slider.addEventListener('input',()=>{
  const stage=stages[slider.value];
  document.getElementById('stage-name').textContent=stage.name;
  slider.setAttribute('aria-valuetext',stage.name);
  show(stage.panels);
});
";

/// No request may leave the page: the browser itself enforces it.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; \
                      img-src data: blob:; font-src data:";

/// What a page shows at a place of its slider.
pub(crate) struct PageStage {
    pub(crate) name: String,
    pub(crate) panels: Vec<PagePanel>,
}

/// The page; with a slider if there are stages to choose from, at the last of them.
pub(crate) fn page(title: &str, caption: &str, stacked: bool, stages: &[PageStage]) -> String {
    let figure: Vec<Value> = stages
        .iter()
        .map(|stage| {
            let panels = stage
                .panels
                .iter()
                .map(|panel| json!({ "data": panel.data, "layout": panel.layout, "hover": panel.hover }));
            json!({ "name": stage.name, "panels": panels.collect::<Vec<Value>>() })
        })
        .collect();
    // Inside a script element only "<" can end or confuse it.
    let figure = Value::from(figure).to_string().replace('<', "\\u003c");
    let heading = if title.is_empty() { String::new() } else { format!("<h1>{}</h1>\n", words(title)) };
    let title = text::escape(title);
    let caption_lines = caption.lines().map(words).collect::<Vec<_>>().join("\n");
    let caption =
        if caption_lines.is_empty() { String::new() } else { format!("<p class=\"caption\">{caption_lines}</p>\n") };
    let last = stages.len().saturating_sub(1);
    let places: String = (0..stages.last().map_or(0, |stage| stage.panels.len()))
        .map(|index| format!("<div class=\"panel\" id=\"panel-{index}\"></div>\n"))
        .collect();
    let slider = match stages {
        [] | [_] => String::new(),
        [.., end] => {
            let name = words(&end.name);
            format!(
                "<label class=\"stage\"><input type=\"range\" id=\"stage\" min=\"0\" max=\"{last}\" \
                 value=\"{last}\" autocomplete=\"off\" aria-valuetext=\"{name}\"> \
                 <output id=\"stage-name\" for=\"stage\">{name}</output></label>\n"
            )
        }
    };
    let class = if stacked { "panels stacked" } else { "panels" };
    let page_title = if title.is_empty() { "Riffel" } else { &title };
    let plotly = plotly_js();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <title>{page_title}</title>\n<style>{STYLE}</style>\n<script>{plotly}</script>\n</head>\n<body>\n<main>\n\
         {heading}{slider}<div class=\"{class}\">\n{places}</div>\n{caption}</main>\n\
         <script type=\"application/json\" id=\"figure\">{figure}</script>\n<script>{SCRIPT}</script>\n\
         </body>\n</html>\n"
    )
}

/// The text of plotly.js, the first of the scripts that the crate `plotly` carries; MathJax follows it there, and is left out.
pub fn plotly_js() -> &'static str {
    static SCRIPT: LazyLock<String> = LazyLock::new(|| {
        let scripts = Plot::offline_js_sources();
        let script = scripts.split_once("</script>").map_or("", |(first, _)| first);
        script.split_once('>').map_or("", |(_, text)| text).to_owned()
    });
    &SCRIPT
}

/// A value of a map with at most five significant digits, null if it is not finite: shorter pages.
pub(crate) fn number(value: f64) -> Value {
    rounded(value, 4)
}

/// Coordinates with at most nine significant digits, null where they are not finite.
pub(crate) fn coordinates(values: impl IntoIterator<Item = f64>) -> Value {
    values.into_iter().map(|value| rounded(value, 8)).collect()
}

fn rounded(value: f64, decimals: usize) -> Value {
    let short = format!("{value:.decimals$e}").parse::<f64>().ok().filter(|short| short.is_finite());
    short.map_or(Value::Null, |short| {
        if short.fract() == 0.0 && short.abs() < 1e9 { json!(short as i64) } else { json!(short) }
    })
}

/// Words for HTML and for plotly.js, which reads the same little markup.
pub(crate) fn words(words: &str) -> String {
    subscript::html(&text::escape(words))
}

/// An axis as in the pictures: framed, ticks inside, pale grid.
pub(crate) fn axis(title: &str) -> Value {
    json!({
        "title": { "text": words(title), "font": { "size": TITLE_FONT } },
        "automargin": true, "ticks": "inside", "showline": true, "linewidth": 1, "linecolor": "#222", "mirror": "ticks",
        "gridcolor": "#e4e4e4", "zeroline": false, "tickfont": { "size": TICK_FONT },
    })
}

/// Height of the toolbar of plotly.js, pixels.
const TOOLBAR: u32 = 32;
/// Height of the words above a panel, pixels.
const SUBTITLE: u32 = 24;

/// The layout common to all panels.
pub(crate) fn layout(subtitle: &str, x: Value, y: Value) -> Value {
    // The toolbar has a strip of its own at the top, the words above the panel stand below it.
    let top = if subtitle.is_empty() { TOOLBAR } else { TOOLBAR + SUBTITLE };
    json!({
        "title": { "text": words(subtitle), "font": { "size": 14 }, "x": 0.5, "y": 1, "yref": "paper", "yanchor": "bottom",
            "pad": { "b": 6 } },
        "font": { "family": "DejaVu Sans, Verdana, sans-serif", "color": "#222", "size": TICK_FONT },
        "paper_bgcolor": "#fff", "plot_bgcolor": "#fff",
        "margin": { "l": 64, "r": 20, "t": top, "b": 56 },
        "legend": { "orientation": "h", "x": 0, "xanchor": "left", "y": -0.14, "yanchor": "top",
            "font": { "size": 11 } },
        "hovermode": "closest",
        "xaxis": x, "yaxis": y,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plotly_alone_is_carried() {
        let script = plotly_js();
        assert!(script.trim_start().starts_with("/**") && !script.ends_with('>'));
        assert!(script.contains("plotly.js v") && !script.contains("MathJax="));
        assert!(script.len() > 3_000_000 && script.len() < 6_000_000);
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(number(-0.123_456_789).to_string(), "-0.12346");
        assert_eq!(number(20.0).to_string(), "20");
        assert_eq!(number(f64::NAN), Value::Null);
        assert_eq!(number(1.23456e300), json!(1.2346e300));
    }

    #[test]
    fn words_cannot_leave_their_element() {
        let panel =
            || PagePanel { data: vec![json!({ "name": "</script><b>" })], layout: json!({}), hover: Value::Null };
        let stage = |name: &str| PageStage { name: name.to_owned(), panels: vec![panel()] };
        let slid = page("", "", false, &[stage("one"), stage("<two>")]);
        assert!(slid.contains("max=\"1\"") && slid.contains(">&lt;two&gt;</output>"));
        let page = page("a<b", "c</p>", false, &[stage("")]);
        assert!(!page.contains("type=\"range\""));
        let tail = &page[page.find("<main>").unwrap()..];
        assert!(!tail.contains("</script><b>") && !tail.contains("c</p></p>") && tail.contains("a&lt;b"));
    }
}
