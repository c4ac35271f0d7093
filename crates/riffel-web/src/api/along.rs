//! `POST /api/along`: a measured rail along the line; `GET /api/sample`: a profile to try.

use riffel_keys::say;
use std::path::Path;

use axum::extract::State;
use axum::http::header;
use axum::response::IntoResponse;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::reading::Reading;
use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::request::{Asked, Asker};
use crate::told::Told;
use crate::workspace::Workspace;

/// Where the program puts its tables.
const RESULTS: &str = "along";
/// The table of the reader before it has the name that the reader knows.
const TABLE: &str = ".table";
/// Columns of the highest moving RMS in a block are named so, then the band and its unit.
const MOVING_RMS: &str = "moving_rms_max_";

#[derive(Deserialize)]
pub(crate) struct Question {
    /// Name of the file to the user.
    name: String,
    #[serde(flatten)]
    reading: Reading,
    /// Length of line of which the highest value is shown.
    block_m: f64,
    /// What lies along the line.
    #[serde(default)]
    along: Option<Table>,
}

/// A table of the reader.
#[derive(Deserialize)]
struct Table {
    /// Name of the file to the user.
    name: String,
    text: String,
}

/// A rail in blocks.
#[derive(Debug, Serialize)]
struct Rail {
    name: String,
    from_m: Vec<f64>,
    to_m: Vec<f64>,
    /// Highest moving RMS in each block by band, in the order of `bands_m`; none where the band cannot be judged.
    moving_rms_max_m: Vec<Vec<Option<f64>>>,
}

#[derive(Debug, Serialize)]
pub(crate) struct Answer {
    /// Shortest and longest wavelength of each band.
    bands_m: Vec<[f64; 2]>,
    rails: Vec<Rail>,
    /// What `riffel roughness` says of the whole record.
    roughness: Value,
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Answer>, Refusal> {
    let block = question.block_m;
    if !(1.0..=1e6).contains(&block) {
        return Err(Refusal(Fault::bad(say!(blocks_are_m_long_but_must, block = block))));
    }
    let upload = page.uploads.of(&asker.owner()?)?;
    let program = page.program.clone();
    page.long
        .run(asker.subject("along"), move |wanted| {
            let files = Workspace::within(upload.folder())?;
            let file = files.put(&upload.file(), &question.name)?;
            let along = question.along.map(|table| {
                files.write(TABLE, &table.text)?;
                files.put(&files.path().join(TABLE), &table.name)
            });
            let asked = question.reading.add_to(json!({
                "file": file, "block": format!("{block} m"), "output": RESULTS, "along": along.transpose()?,
            }));
            let roughness = program.ask(files.path(), "roughness", &asked, wanted)?;
            let table = files.read(Path::new(RESULTS).join("blocks.csv"))?;
            let (bands_m, rails) =
                courses(&table).ok_or_else(|| Fault::defect("the table of blocks cannot be read"))?;
            Ok(Told(Answer { bands_m, rails, roughness }))
        })
        .await
}

/// The table of blocks by rail and band; none if it is laid out in another way.
fn courses(table: &str) -> Option<(Vec<[f64; 2]>, Vec<Rail>)> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let head = reader.headers().ok()?.clone();
    let column = |name: &str| head.iter().position(|field| field == name);
    let [rail, from, to] = [column("rail")?, column("from_m")?, column("to_m")?];
    let mut bands_m = Vec::new();
    let mut bands = Vec::new();
    for (index, field) in head.iter().enumerate() {
        let Some(band) = field.strip_prefix(MOVING_RMS) else {
            continue;
        };
        let (shortest, longest) = band.strip_suffix("_mm_m")?.split_once("_to_")?;
        bands_m.push([1e-3 * shortest.parse::<f64>().ok()?, 1e-3 * longest.parse::<f64>().ok()?]);
        bands.push(index);
    }
    let mut rails: Vec<Rail> = Vec::new();
    for row in reader.records() {
        let row = row.ok()?;
        let number = |index: usize| row.get(index)?.parse::<f64>().ok();
        let name = row.get(rail)?;
        if rails.last().is_none_or(|last| last.name != name) {
            rails.push(Rail {
                name: name.to_owned(),
                from_m: Vec::new(),
                to_m: Vec::new(),
                moving_rms_max_m: vec![Vec::new(); bands.len()],
            });
        }
        let last = rails.last_mut()?;
        last.from_m.push(number(from)?);
        last.to_m.push(number(to)?);
        for (course, &index) in last.moving_rms_max_m.iter_mut().zip(&bands) {
            course.push(number(index).filter(|value| value.is_finite()));
        }
    }
    Some((bands_m, rails))
}

/// The profile that `riffel roughness --synthesise` makes to the recipe that is built in.
pub(crate) async fn sample(State(page): State<Page>, asker: Asker) -> Result<impl IntoResponse, Refusal> {
    // No other page can say which one it is.
    asker.owner()?;
    let (program, uploads) = (page.program.clone(), page.uploads.clone());
    let text = page
        .long
        .run(asker.subject("sample"), move |wanted| {
            let folder = uploads.folder()?;
            program.run(folder.path(), &["roughness", "--synthesise"], &Value::Null, wanted)
        })
        .await?;
    Ok(([(header::CONTENT_TYPE, "text/csv; charset=utf-8")], text))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_parted_by_rail_and_band() {
        let table = "rail,from_m,to_m,rms_10_to_30_mm_m,moving_rms_max_10_to_30_mm_m,moving_rms_max_30_to_100_mm_m\n\
                     \"low, inner\",0.0,10.0,1e-6,2e-6,\n\"low, inner\",10.0,20.0,1e-6,3e-6,4e-6\nhigh,0.0,10.0,1e-6,5e-6,6e-6\n";
        let (bands_m, rails) = courses(table).unwrap();
        assert_eq!(bands_m, [[0.01, 0.03], [0.03, 0.1]]);
        let [low, high] = &rails[..] else { panic!("two rails") };
        assert_eq!((low.name.as_str(), high.name.as_str()), ("low, inner", "high"));
        assert_eq!(low.to_m, [10.0, 20.0]);
        assert_eq!(low.moving_rms_max_m, [vec![Some(2e-6), Some(3e-6)], vec![None, Some(4e-6)]]);
        assert!(courses("rail,from_m\nlow,0\n").is_none());
    }
}
