//! What stands in each band of each rail, on the command line.

use riffel_answers::roughness::{RailAnswer, band_row};

use crate::output::table;

pub(crate) fn bands_table<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> String {
    let mut rows = table(&[
        "rail",
        "band mm",
        "rms µm",
        "highest moving rms µm",
        "highest peak-to-peak µm",
        "window m",
        "limit µm",
        "over limit",
    ]);
    for rail in rails {
        for band in &rail.analysis.bands {
            rows.add_row(band_row(&rail.name, band));
        }
    }
    format!("{rows}\n")
}
