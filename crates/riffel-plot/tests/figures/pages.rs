//! Pages with a figure.

use super::{curves, growth, map, panel};

#[test]
fn pages_load_nothing() {
    let pages = [map(vec![panel(61, 56, growth), panel(30, 30, growth)]).html(), curves().html()];
    for page in pages {
        let page = page.unwrap();
        assert!(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
        assert!(page.contains("<meta charset=\"utf-8\">") && page.contains("name=\"viewport\""));
        assert!(page.contains("default-src 'none'"));
        // plotly.js is the first script; what surrounds it is ours and mentions no address at all.
        let start = page.find("<script").unwrap();
        let end = start + page[start..].find("</script>").unwrap();
        let ours = [&page[..start], &page[end..]].concat();
        for address in ["http:", "https:", "src=", "href=", "@import", "url(", "import("] {
            assert!(!ours.contains(address), "{address}");
        }
        assert!(!page[start..end].contains("<script src"));
        assert!(ours.contains("\"data\"") && ours.contains("Plotly.react"));
    }
}

#[test]
fn page_carries_the_map_and_its_marks() {
    let page = map(vec![panel(61, 56, growth)]).html().unwrap();
    let start = page.find("<script type=\"application/json\"").unwrap();
    let start = start + page[start..].find('>').unwrap() + 1;
    let figure: serde_json::Value =
        serde_json::from_str(&page[start..start + page[start..].find("</script>").unwrap()]).unwrap();
    let panel = &figure[0]["panels"][0];
    let data = panel["data"].as_array().unwrap();
    let map = data.iter().find(|trace| trace["name"] == "map").unwrap();
    assert_eq!((map["z"].as_array().unwrap().len(), map["z"][0].as_array().unwrap().len()), (56, 61));
    assert_eq!((map["x"][0].as_f64(), map["y"][55].as_f64()), (Some(20.0), Some(216.0)));
    assert_eq!((map["contours"]["end"].as_f64(), map["colorscale"].as_array().unwrap().len()), (Some(0.0), 11));
    assert!(map["hovertemplate"].as_str().unwrap().contains("growth rate per passage"));
    assert_eq!(panel["hover"].as_array().unwrap().len(), 56);
    let names: Vec<&str> = data.iter().filter_map(|trace| trace["name"].as_str()).collect();
    for name in [
        "constant frequency of the strongest branch",
        "strongest growth at each speed",
        "BR survey (1911)",
        "Harrison (1979)",
    ] {
        assert!(names.contains(&name), "{name} is not in {names:?}");
    }
}
