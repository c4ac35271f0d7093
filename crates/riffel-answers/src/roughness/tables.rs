//! What was computed of rails, as tables.

use riffel::roughness::{BandSummary, BlockRms, GrindSection, Spectrum, WavelengthBand};
use riffel_keys::{Message, decimal, number, say};
use riffel_rail::name_in_words;

use super::RailAnswer;
use super::words::name;
use crate::number_alone;
use crate::{Column, Rows, Table};

/// What to grind.
pub(crate) const GRIND: &str = "grind";
/// Sections to grind that a terminal shows; the file has all.
pub(crate) const SHOWN: usize = 20;

/// Levels of spectra by name.
pub(crate) fn levels<'a>(spectra: impl Iterator<Item = (&'a str, &'a Spectrum)>) -> Table {
    let rows: Vec<_> =
        spectra.flat_map(|(name, spectrum)| spectrum.levels().iter().map(move |level| (name, level))).collect();
    Table {
        name: "spectrum",
        columns: vec![
            rows.names("rail", |(name, _)| *name),
            rows.exact("wavelength_m", |(_, level)| level.band.wavelength()),
            rows.exact("level_db", |(_, level)| level.level),
        ],
    }
}

/// What stands in each band of some rails: RMS values \[µm\], window \[m\], limit and share.
pub(crate) fn bands<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Table {
    let rows: Vec<(&RailAnswer, &BandSummary)> =
        rails.flat_map(|rail| rail.analysis.bands.iter().map(move |band| (rail, band))).collect();
    let micrometres = |length: f64, digits: usize| format!("{:.digits$}", 1e6 * length);
    Table {
        name: "bands",
        columns: vec![
            rows.shown(say!(rail_word), |(rail, _)| name_in_words(&rail.name)),
            rows.shown(say!(band_column), |(_, band)| Message::verbatim(name(&band.band))),
            rows.numbers(say!(rms_column), |(_, band)| micrometres(band.rms, 2)),
            rows.numbers(say!(highest_moving_rms_column), |(_, band)| micrometres(band.moving_rms_max, 2)),
            rows.numbers(say!(highest_peak_to_peak_column), |(_, band)| micrometres(band.peak_to_peak_max, 1)),
            rows.numbers(say!(window_column), |(_, band)| format!("{:.1}", band.window)),
            rows.numbers(say!(limit_of_rms_column), |(_, band)| {
                band.limit.map_or_else(String::new, |limit| micrometres(limit, 0))
            }),
            rows.numbers(say!(over_limit_column), |(_, band)| {
                band.share_over_limit.map_or_else(String::new, |share| format!("{:.1} %", 100.0 * share))
            }),
        ],
    }
}

/// RMS of each block of some rails, the highest moving RMS in it, and the places of its welds, joints and squats.
pub(crate) fn blocks<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Table {
    let rows: Vec<_> = rails.flat_map(|rail| rail.analysis.blocks.iter().map(move |block| (rail, block))).collect();
    type Of = fn(&BlockRms) -> &[Option<f64>];
    let bands = |what: &str, of: Of| -> Vec<Column> {
        let bands = WavelengthBand::GRINDING.iter().enumerate();
        let columns = bands.map(|(place, band)| {
            let (from, to) = (1e3 * band.from(), 1e3 * band.to());
            rows.exact(&format!("{what}_{from:.0}_to_{to:.0}_mm_m"), |(_, block)| of(block)[place])
        });
        columns.collect()
    };
    let defects = |(rail, block): &(&RailAnswer, &BlockRms)| {
        let middles = rail.analysis.defects.iter().map(|one| 0.5 * (one.from + one.to));
        let own = middles.filter(|at| (block.from..block.to).contains(at));
        own.map(|at| format!("{at:.2}")).collect::<Vec<_>>().join(";")
    };
    let mut columns = vec![
        rows.names("rail", |(rail, _)| &rail.name),
        rows.exact("from_m", |(_, block)| block.from),
        rows.exact("to_m", |(_, block)| block.to),
    ];
    columns.extend(bands("rms", |block| &block.rms));
    columns.extend(bands("moving_rms_max", |block| &block.moving_rms_max));
    columns.push(rows.names("defects_m", defects));
    Table { name: "blocks", columns }
}

/// The sections of some rails, each with its rail.
fn sections<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Vec<(&'a RailAnswer, &'a GrindSection)> {
    rails.flat_map(|rail| rail.sections.iter().map(move |section| (rail, section))).collect()
}

/// What to grind of some rails.
pub(crate) fn grind<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Table {
    let rows = sections(rails);
    Table {
        name: GRIND,
        columns: vec![
            rows.names("rail", |(rail, _)| &rail.name),
            rows.exact("from_m", |(_, section)| section.from),
            rows.exact("to_m", |(_, section)| section.to),
            rows.names("worst_band_mm", |(_, section)| name(&section.band)),
            rows.exact("rms_over_limit", |(_, section)| section.ratio),
            rows.names("stretch", |(_, section)| section.stretch),
        ],
    }
}

/// The first so many sections that a reader sees: number, rail and where places go back its stretch, places and length \[m\], worst band
/// and its ratio; without columns where there is none.
pub(crate) fn shown_grind<'a>(rails: impl Iterator<Item = &'a RailAnswer>, most: usize) -> Table {
    let rows = sections(rails);
    if rows.is_empty() {
        return Table { name: GRIND, columns: Vec::new() };
    }
    let rows = &rows[..most.min(rows.len())];
    Table {
        name: GRIND,
        columns: vec![
            Column::shown(say!(grind_column), (1..=rows.len()).map(number_alone).collect()),
            rows.shown(say!(rail_word), |(rail, section)| rail_and_stretch(rail, section)),
            rows.numbers(say!(from_column), |(_, section)| decimal(section.from, 2)),
            rows.numbers(say!(to_column), |(_, section)| format!("{:.2}", section.to)),
            rows.numbers(say!(length_column), |(_, section)| format!("{:.2}", section.length())),
            rows.numbers(say!(worst_band_column), |(_, section)| name(&section.band)),
            rows.numbers(say!(ratio_to_limit_column), |(_, section)| format!("{:.2}", section.ratio)),
        ],
    }
}

/// How many of so many sections only the file has, if it has more.
pub(crate) fn more(sections: usize) -> Option<Message> {
    let more = sections.saturating_sub(SHOWN);
    (more > 0).then(|| say!(more_in_grind_file, count = number(more)))
}

/// Name of a rail, and where places go back the number of a stretch of it.
fn rail_and_stretch(rail: &RailAnswer, section: &GrindSection) -> Message {
    let name = name_in_words(&rail.name);
    match rail.analysis.stretch_to_name(section.stretch) {
        Some(stretch) => say!(rail_on_stretch, rail = name, stretch = number(stretch)),
        None => name,
    }
}
