//! What was computed of rails, as tables.

use riffel::roughness::{BandSummary, GrindSection, Spectrum, WavelengthBand};
use riffel_keys::{Message, decimal, number, say};
use riffel_rail::name_in_words;

use super::RailAnswer;
use super::words::name;
use crate::number_alone;
use crate::{Column, Table};

/// What to grind.
pub(crate) const GRIND: &str = "grind";
/// Sections to grind that a terminal shows; the file has all.
pub(crate) const SHOWN: usize = 20;

/// Levels of spectra by name.
pub(crate) fn levels<'a>(spectra: impl Iterator<Item = (&'a str, &'a Spectrum)>) -> Table {
    let rows: Vec<_> =
        spectra.flat_map(|(name, spectrum)| spectrum.levels().iter().map(move |level| (name, level))).collect();
    let rows = || rows.iter();
    Table {
        name: "spectrum",
        columns: vec![
            Column::names("rail", rows().map(|(name, _)| *name)),
            Column::exact("wavelength_m", rows().map(|(_, level)| level.band.wavelength())),
            Column::exact("level_db", rows().map(|(_, level)| level.level)),
        ],
    }
}

/// What stands in each band of some rails: RMS values \[µm\], window \[m\], limit and share.
pub(crate) fn bands<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Table {
    let rows: Vec<(&RailAnswer, &BandSummary)> =
        rails.flat_map(|rail| rail.analysis.bands.iter().map(move |band| (rail, band))).collect();
    let rows = || rows.iter();
    let shown = |head: Message, of: &dyn Fn(&BandSummary) -> String| {
        Column::shown(head, rows().map(|(_, band)| number_alone(of(band))).collect())
    };
    let micrometres = |length: f64, digits: usize| format!("{:.digits$}", 1e6 * length);
    Table {
        name: "bands",
        columns: vec![
            Column::shown(say!(rail_word), rows().map(|(rail, _)| name_in_words(&rail.name)).collect()),
            Column::shown(say!(band_column), rows().map(|(_, band)| Message::verbatim(name(&band.band))).collect()),
            shown(say!(rms_column), &|band| micrometres(band.rms, 2)),
            shown(say!(highest_moving_rms_column), &|band| micrometres(band.moving_rms_max, 2)),
            shown(say!(highest_peak_to_peak_column), &|band| micrometres(band.peak_to_peak_max, 1)),
            shown(say!(window_column), &|band| format!("{:.1}", band.window)),
            shown(say!(limit_of_rms_column), &|band| {
                band.limit.map_or_else(String::new, |limit| micrometres(limit, 0))
            }),
            shown(say!(over_limit_column), &|band| {
                band.share_over_limit.map_or_else(String::new, |share| format!("{:.1} %", 100.0 * share))
            }),
        ],
    }
}

/// RMS of each block of some rails, the highest moving RMS in it, and the places of its welds, joints and squats.
pub(crate) fn blocks<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Table {
    let rows: Vec<_> = rails.flat_map(|rail| rail.analysis.blocks.iter().map(move |block| (rail, block))).collect();
    let rows = || rows.iter();
    let bands = |what: &str, of: &dyn Fn(usize, usize) -> Option<f64>| -> Vec<Column> {
        let bands = WavelengthBand::GRINDING.iter().enumerate();
        let columns = bands.map(|(place, band)| {
            let (from, to) = (1e3 * band.from(), 1e3 * band.to());
            let values = (0..rows().len()).map(|row| of(row, place));
            Column::exact(&format!("{what}_{from:.0}_to_{to:.0}_mm_m"), values)
        });
        columns.collect()
    };
    let defects = rows().map(|(rail, block)| {
        let middles = rail.analysis.defects.iter().map(|one| 0.5 * (one.from + one.to));
        let own = middles.filter(|at| (block.from..block.to).contains(at));
        own.map(|at| format!("{at:.2}")).collect::<Vec<_>>().join(";")
    });
    let mut columns = vec![
        Column::names("rail", rows().map(|(rail, _)| &rail.name)),
        Column::exact("from_m", rows().map(|(_, block)| block.from)),
        Column::exact("to_m", rows().map(|(_, block)| block.to)),
    ];
    let all: Vec<_> = rows().map(|(_, block)| *block).collect();
    columns.extend(bands("rms", &|row, place| all[row].rms[place]));
    columns.extend(bands("moving_rms_max", &|row, place| all[row].moving_rms_max[place]));
    columns.push(Column::names("defects_m", defects));
    Table { name: "blocks", columns }
}

/// The sections of some rails, each with its rail.
fn sections<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Vec<(&'a RailAnswer, &'a GrindSection)> {
    rails.flat_map(|rail| rail.sections.iter().map(move |section| (rail, section))).collect()
}

/// What to grind of some rails.
pub(crate) fn grind<'a>(rails: impl Iterator<Item = &'a RailAnswer>) -> Table {
    let rows = sections(rails);
    let rows = || rows.iter();
    Table {
        name: GRIND,
        columns: vec![
            Column::names("rail", rows().map(|(rail, _)| &rail.name)),
            Column::exact("from_m", rows().map(|(_, section)| section.from)),
            Column::exact("to_m", rows().map(|(_, section)| section.to)),
            Column::names("worst_band_mm", rows().map(|(_, section)| name(&section.band))),
            Column::exact("rms_over_limit", rows().map(|(_, section)| section.ratio)),
            Column::names("stretch", rows().map(|(_, section)| section.stretch)),
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
    let rows = || rows.iter().take(most);
    let shown = |head: Message, of: &dyn Fn(&GrindSection) -> String| {
        Column::shown(head, rows().map(|(_, section)| number_alone(of(section))).collect())
    };
    Table {
        name: GRIND,
        columns: vec![
            Column::shown(say!(grind_column), (1..=rows().len()).map(number_alone).collect()),
            Column::shown(say!(rail_word), rows().map(|(rail, section)| rail_and_stretch(rail, section)).collect()),
            shown(say!(from_column), &|section| decimal(section.from, 2)),
            shown(say!(to_column), &|section| format!("{:.2}", section.to)),
            shown(say!(length_column), &|section| format!("{:.2}", section.length())),
            shown(say!(worst_band_column), &|section| name(&section.band)),
            shown(say!(ratio_to_limit_column), &|section| format!("{:.2}", section.ratio)),
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
