//! A measured profile of one or more rails.

use std::collections::BTreeMap;

use jiff::civil::Date;
use riffel::roughness::Profile;
use riffel_keys::quantity::Quantity;
use riffel_keys::table::{DecimalMark, Delimiter, NumberRows};
use riffel_keys::{Message, Value, fixed, number, say};

use crate::chainage::{Chainage, LONGEST_FILLED, Stretch};
use crate::date::read_dates;
use crate::date_column::{date_column, dates_of_heads, day_numbers};
use crate::format::{Column, ReaderFormat};
use crate::plausibility;
use crate::rail::{EarlierRails, Rail};
use crate::rail_name::{name_alike, name_in_words};
use crate::refusal::Refusal;
use crate::resampling::resampled;

/// Shortest stretch that says anything \[m\]: the shortest segment of EN 15610.
const SHORTEST: f64 = 1.0;
/// Equal samples at the end of the range from which a sensor is taken to be there.
const CLIPPED_RUN: usize = 4;
/// Share of samples that may be clipped.
const MOST_CLIPPED: f64 = 0.01;
/// Largest height of a rail over the zero of the instrument, drift included \[m\].
const LARGEST_HEIGHT: f64 = 100.0;
/// Share by which the steps of records in one file may differ.
const SAME_SPACING: f64 = 0.01;
/// Samples in which the smallest step of the sensor is looked for.
const SAMPLE: usize = 100_000;

/// A measured profile.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// How the file was read.
    pub format: ReaderFormat,
    /// Step between samples \[m\].
    pub spacing: f64,
    /// First position \[m\].
    pub from: f64,
    /// Last position \[m\].
    pub to: f64,
    /// Whether positions fall from line to line; heights here are in the order of rising position.
    pub falling: bool,
    /// The rails as they were last, in the order of the format, for one record after the other.
    pub rails: Vec<Rail>,
    /// The last date, where the file has dates.
    pub date: Option<Date>,
    /// The rails as they were before, the earliest first.
    pub earlier: Vec<EarlierRails>,
    /// Defects of the file that were put right, each counted.
    pub warnings: Vec<Message>,
}

impl Record {
    /// `heads` are those of the columns of labels. `insisted` on the unit of the heights, a user is not refused because they
    /// are unlike any rail.
    pub(super) fn new(
        format: ReaderFormat,
        heads: &[String],
        rows: NumberRows,
        assumptions: Vec<Message>,
        insisted: bool,
    ) -> Result<Self, Refusal> {
        let mut warnings = assumptions;
        let columns = format.position.iter().chain(&format.rails);
        for (column, marked) in columns.zip(&rows.marked) {
            warnings.extend(marked.map(|marked| {
                let line = number(rows.line(marked.first));
                let said = say!(
                    marks_of_missing_values,
                    column = number(column.column),
                    mark = number(marked.mark),
                    count = marked.count
                );
                say!(first_at_line, sentence = said, line)
            }));
        }
        let records = Labelled::all(heads, rows.by_label(), &mut warnings)?;
        let first_label = records[0].words.clone();
        let (mut rails, mut dates) = (Vec::new(), Vec::new());
        let of_heads = of_heads(&format);
        let mut read: Option<Chainage> = None;
        for record in records {
            let chainage = read_record(&format, &record, &mut rails, &mut warnings)?;
            match &of_heads {
                Some(of_heads) => dates.extend(of_heads.iter().map(|(date, _)| Some(*date))),
                None => dates.resize(rails.len(), record.date),
            }
            if let Some(first) = &read
                && (chainage.spacing / first.spacing - 1.0).abs() > SAME_SPACING
            {
                let message = format!(
                    "samples of {} are {:.4} mm apart, but those of {first_label} {:.4} mm: give each record a file \
                     of its own",
                    record.words,
                    1e3 * chainage.spacing,
                    1e3 * first.spacing
                );
                return Err(Refusal::new(Some(record.rows.line(0)), message));
            }
            read.get_or_insert(chainage);
        }
        let (spacing, falling) = read.map_or((0.0, false), |read| (read.spacing, read.falling));
        let checked: Vec<(&Rail, &str, f64)> = rails
            .iter()
            .zip(format.rails.iter().cycle())
            .map(|(rail, column)| (rail, column.unit.as_str(), size(column)))
            .collect();
        match plausibility::check_heights(&checked) {
            Err(refusal) if insisted => warnings.push(refusal.message),
            checked => checked?,
        }
        warnings.extend(coarse_sampling(spacing));
        let (rails, earlier) = latest_and_earlier(rails, &dates);
        let date = dates.iter().copied().max().flatten();
        if let (Some(last), [_, ..]) = (date, &earlier[..]) {
            let before: Value = earlier.iter().map(|one| one.date.to_string()).collect();
            warnings.push(say!(rails_of_last_date, last = last.to_string(), before));
        }
        let [from, to] = Rail::ends(&rails);
        Ok(Self { format, spacing, from, to, falling, rails, date, earlier, warnings })
    }

    /// Rails that somebody gave as numbers, with the step between their samples \[m\]: warnings ask about a wide step, and about heights
    /// unlike those of a rail. The format is that of a file with a column of metres for each.
    pub fn of_rails(rails: Vec<Rail>, spacing: f64) -> Self {
        let column =
            |(place, rail): (usize, &Rail)| Column { column: place + 1, unit: "m".to_owned(), name: rail.name.clone() };
        let format = ReaderFormat {
            delimiter: Delimiter::Comma,
            decimal: DecimalMark::default(),
            header_lines: 0,
            spacing: Some(Quantity::new(spacing)),
            position: None,
            rails: rails.iter().enumerate().map(column).collect(),
            labels: Vec::new(),
        };
        let warnings = coarse_sampling(spacing).into_iter().chain(plausibility::unlike_a_rail(&rails)).collect();
        let [from, to] = Rail::ends(&rails);
        Self { format, spacing, from, to, falling: false, rails, date: None, earlier: Vec::new(), warnings }
    }

    /// Mean length of the rails \[m\].
    pub fn length(&self) -> f64 {
        self.rails.iter().map(Rail::length).sum::<f64>() / self.rails.len().max(1) as f64
    }
}

/// Size of the unit of a column \[m\].
fn size(column: &Column) -> f64 {
    column.metres().unwrap_or(1.0)
}

/// The rows of one record.
struct Labelled {
    /// What tells its rails from those of other records; empty where there is one only.
    rail: String,
    /// Words that tell its rails apart, with the date if there are several.
    words: String,
    date: Option<Date>,
    rows: NumberRows,
}

impl Labelled {
    /// Cells of labels, under heads, as dates and rails.
    fn all(
        heads: &[String],
        records: Vec<(Vec<String>, NumberRows)>,
        warnings: &mut Vec<Message>,
    ) -> Result<Vec<Self>, Refusal> {
        let cells = |column: usize| -> Vec<String> {
            let records = records.iter();
            records.filter_map(|(cells, _)| cells.get(column).cloned()).collect()
        };
        let names: Vec<&str> = heads.iter().map(String::as_str).collect();
        let time = date_column(&names, &cells);
        let mut dates = vec![None; records.len()];
        if let Some(column) = time {
            let texts = cells(column);
            let texts = || texts.iter().map(String::as_str);
            let read = read_dates(texts()).map_err(|no_date| {
                let line = records[no_date.place].1.line(0);
                Refusal::new(Some(line), no_date.of(&heads[column]).message)
            })?;
            dates = read.into_iter().map(Some).collect();
            warnings.extend(day_numbers(&heads[column], texts()));
        }
        let rail_of = |cells: &[String]| {
            let cells = cells.iter().enumerate();
            let cells = cells.filter(|(column, _)| Some(*column) != time);
            let cells: Vec<&str> = cells.map(|(_, cell)| cell.as_str()).collect();
            cells.join(" ")
        };
        let first = rail_of(&records[0].0);
        let one_rail = records.iter().all(|(cells, _)| rail_of(cells) == first);
        let one_date = dates.iter().all(|date| *date == dates[0]);
        let records = records.into_iter().zip(dates);
        let labelled = records.map(|((cells, rows), date)| {
            let rail = match one_rail {
                true => String::new(),
                false => rail_of(&cells),
            };
            let day = date.filter(|_| !one_date).map(|date| date.to_string());
            let words = [day.as_deref().unwrap_or_default(), &rail];
            Self { words: words.join(" ").trim().to_owned(), rail, date, rows }
        });
        Ok(labelled.collect())
    }
}

/// Dates that columns of heights have in their names, each with the name of its rail.
fn of_heads(format: &ReaderFormat) -> Option<Vec<(Date, String)>> {
    let names: Vec<&str> = format.rails.iter().map(|rail| &rail.name[..]).collect();
    dates_of_heads(&names)
}

/// Rails as they were last, each by its name, and before, the earliest date first.
fn latest_and_earlier(mut rails: Vec<Rail>, dates: &[Option<Date>]) -> (Vec<Rail>, Vec<EarlierRails>) {
    let dated = rails.iter_mut().zip(dates);
    name_alike(dated.filter_map(|(rail, date)| Some(((*date)?, &mut rail.name))).collect());
    let mut last: BTreeMap<String, Option<Date>> = BTreeMap::new();
    for (rail, date) in rails.iter().zip(dates) {
        let known = last.entry(rail.name.clone()).or_default();
        *known = (*known).max(*date);
    }
    let (mut latest, mut before) = (Vec::new(), BTreeMap::<Date, Vec<Rail>>::new());
    for (rail, date) in rails.into_iter().zip(dates) {
        match *date {
            Some(date) if last[&rail.name] > Some(date) => {
                before.entry(date).or_default().push(rail);
            }
            _ => latest.push(rail),
        }
    }
    let earlier = before.into_iter().map(|(date, rails)| EarlierRails { date, rails });
    (latest, earlier.collect())
}

/// The rails of one record.
fn read_record(
    format: &ReaderFormat,
    record: &Labelled,
    rails: &mut Vec<Rail>,
    warnings: &mut Vec<Message>,
) -> Result<Chainage, Refusal> {
    let (rows, label) = (&record.rows, &record.words[..]);
    let count = rows.columns.first().map_or(0, Vec::len);
    if count < 2 {
        return Err(Refusal::new(None, "the file has less than two rows of numbers, which are no profile"));
    }
    let of_label = match label {
        "" => String::new(),
        label => format!("{label}: "),
    };
    let mut columns = rows.columns.iter();
    let chainage = match (&format.position, format.spacing) {
        (Some(column), _) => {
            let positions = columns.next().map_or(&[][..], Vec::as_slice);
            let scale = size(column);
            let metres: Vec<f64> = positions.iter().map(|position| scale * position).collect();
            Chainage::new(&metres)
                .map_err(|defect| Refusal::new(Some(rows.line(defect.row)), of_label.clone() + &defect.message))?
        }
        (None, spacing) => Chainage {
            spacing: spacing.map_or(0.0, |spacing| spacing.si()),
            falling: false,
            stretches: vec![Stretch { start: 0.0, rows: vec![(0, 0..count)] }],
            uneven: None,
            warnings: Vec::new(),
        },
    };
    if let Some(column) = &format.position {
        plausibility::check_spacing(chainage.spacing, Some((&column.unit, size(column))))?;
    }
    warnings.extend(chainage.warnings.iter().map(|(row, defect)| {
        let line = number(rows.line(*row));
        let said = say!(first_at_line, sentence = defect.clone(), line);
        match label {
            "" => said,
            label => said.about(Message::verbatim(label)),
        }
    }));
    let of_heads = of_heads(format);
    for (place, (column, heights)) in format.rails.iter().zip(columns).enumerate() {
        let own = match &of_heads {
            Some(of_heads) => &of_heads[place].1,
            None => &column.name,
        };
        let name = match (&own[..], &record.rail[..]) {
            (_, label) if !label.is_empty() && format.rails.len() == 1 => label.to_owned(),
            ("", label) => format!("{label} column {}", column.column),
            (name, label) => format!("{label} {name}"),
        };
        let name = name.trim_start().to_owned();
        let reader = RailReader { name: &name, heights, scale: size(column), chainage: &chainage, rows };
        let (stretches, remarks) = reader.read()?;
        warnings.extend(remarks);
        rails.push(Rail { name, stretches });
    }
    Ok(chainage)
}

/// What to say of samples too far apart \[m\] for EN 15610.
fn coarse_sampling(spacing: f64) -> Option<Message> {
    (spacing > 1.001e-3).then(|| say!(coarse_sampling, step = fixed(1e3 * spacing, 3)))
}

/// One column of heights on its way to stretches.
struct RailReader<'a> {
    name: &'a str,
    heights: &'a [f64],
    scale: f64,
    chainage: &'a Chainage,
    rows: &'a NumberRows,
}

impl RailReader<'_> {
    fn read(&self) -> Result<(Vec<Profile>, Vec<Message>), Refusal> {
        let mut remarks = Vec::new();
        self.check_range(&mut remarks)?;
        let spacing = self.chainage.spacing;
        let (mut profiles, mut dropped) = (Vec::new(), 0.0);
        let longest_fill = (LONGEST_FILLED / spacing).round() as usize;
        // By rising position, but for places that go back.
        let mut stretches: Vec<&Stretch> = self.chainage.stretches.iter().collect();
        if self.chainage.falling {
            stretches.reverse();
        }
        for stretch in stretches {
            let (start, heights) = self.assemble(stretch);
            for (first, heights) in filled(heights, longest_fill) {
                let length = heights.len() as f64 * spacing;
                if length < SHORTEST * (1.0 - 2e-3) {
                    dropped += length;
                    continue;
                }
                let start = start + first as f64 * spacing;
                // Every height is finite after filling; there are two or more in a metre, or the spacing
                // is refused here.
                let profile = Profile::new(start, spacing, heights)
                    .map_err(|error| Refusal::new(None, format!("rail {}: {error}", self.name)))?;
                profiles.push(profile);
            }
        }
        if profiles.is_empty() {
            let length = self.heights.len() as f64 * spacing;
            return Err(Refusal::new(
                Some(self.rows.line(0)),
                format!(
                    "rail {}: the record of {length:.3} m has no stretch of {SHORTEST} m without gaps, the least \
                     that EN 15610 takes",
                    self.name
                ),
            ));
        }
        if dropped > 0.0 {
            let said = say!(short_stretches_left_out, length = fixed(dropped, 3), shortest = number(SHORTEST));
            remarks.push(self.about(said));
        }
        self.remark_missing(longest_fill, &mut remarks);
        Ok((profiles, remarks))
    }

    /// First position and heights \[m\] by rising position; not a number where samples are missing.
    fn assemble(&self, stretch: &Stretch) -> (f64, Vec<f64>) {
        let samples = stretch.rows.iter().map(|(absent, rows)| absent + rows.len());
        let mut heights = Vec::with_capacity(samples.sum());
        if let Some(positions) = &self.chainage.uneven {
            return self.assemble_uneven(stretch, positions);
        }
        for (absent, rows) in &stretch.rows {
            heights.extend(std::iter::repeat_n(f64::NAN, *absent));
            heights.extend(self.heights[rows.clone()].iter().map(|height| self.scale * height));
        }
        if !self.chainage.falling {
            return (stretch.start, heights);
        }
        heights.reverse();
        let length = (heights.len() - 1) as f64 * self.chainage.spacing;
        (stretch.start - length, heights)
    }

    /// First position and heights \[m\], resampled in even steps.
    fn assemble_uneven(&self, stretch: &Stretch, positions: &[f64]) -> (f64, Vec<f64>) {
        let rows = || stretch.rows.iter().flat_map(|(_, rows)| rows.clone());
        let mut places: Vec<f64> = rows().map(|row| positions[row]).collect();
        let mut heights: Vec<f64> = rows().map(|row| self.scale * self.heights[row]).collect();
        if self.chainage.falling {
            places.reverse();
            heights.reverse();
        }
        (places[0], resampled(&places, &heights, self.chainage.spacing))
    }

    /// What is said of this rail.
    fn about(&self, said: Message) -> Message {
        said.about(say!(rail_named, name = name_in_words(self.name)))
    }

    fn remark_missing(&self, longest_fill: usize, remarks: &mut Vec<Message>) {
        let mut missing = self.heights.iter().enumerate().filter(|(_, height)| height.is_nan());
        if let Some((first, _)) = missing.next() {
            let longest = number(longest_fill);
            let said = say!(heights_missing, count = missing.count() + 1, longest);
            let line = number(self.rows.line(first));
            remarks.push(self.about(say!(first_at_line, sentence = said, line)));
        }
    }

    /// A sensor that says nothing, or that is at its end.
    fn check_range(&self, remarks: &mut Vec<Message>) -> Result<(), Refusal> {
        let finite = || self.heights.iter().copied().filter(|height| height.is_finite());
        let (low, high) = finite()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), height| (low.min(height), high.max(height)));
        if low >= high {
            let what = if low == high {
                format!("every height is {low}: the sensor gave nothing")
            } else {
                "no height is a number".to_owned()
            };
            let from = Some(self.rows.line(0));
            return Err(Refusal::new(from, format!("rail {}: {what}", self.name)));
        }
        if self.scale * low.abs().max(high.abs()) > LARGEST_HEIGHT {
            let too_large = |height: &f64| self.scale * height.abs() > LARGEST_HEIGHT;
            let row = self.heights.iter().position(too_large).unwrap_or(0);
            let message = format!(
                "rail {}: a height of {} m is none of a rail; look at the unit, or at what the file writes where \
                 there is no height",
                self.name,
                self.scale * self.heights[row]
            );
            return Err(Refusal::new(Some(self.rows.line(row)), message));
        }
        let (mut samples, mut first) = (0, None);
        let quantum = self.quantum();
        for run in runs_at(self.heights, low, high) {
            // A wave that is only rounded comes to its crest in the smallest of steps.
            let beside = |at: Option<&f64>, edge: f64| at.is_none_or(|at| (at - edge).abs() > 2.5 * quantum);
            let edge = self.heights[run.start];
            let before = run.start.checked_sub(1).and_then(|at| self.heights.get(at));
            if run.len() >= CLIPPED_RUN && beside(before, edge) && beside(self.heights.get(run.end), edge) {
                samples += run.len();
                first.get_or_insert(run.start);
            }
        }
        let Some(first) = first else {
            return Ok(());
        };
        let line = self.rows.line(first);
        let share = samples as f64 / self.heights.len() as f64;
        let what = say!(heights_clipped, samples = number(samples), low, high, run = number(CLIPPED_RUN));
        if share > MOST_CLIPPED {
            let share = 100.0 * share;
            let message = format!("rail {}: {what} over {share:.1} % of the record, here first", self.name);
            return Err(Refusal::new(Some(line), message));
        }
        let line = number(line);
        remarks.push(self.about(say!(first_at_line, sentence = what, line)));
        Ok(())
    }

    /// The smallest step between two heights that differ.
    fn quantum(&self) -> f64 {
        let stride = (self.heights.len() / SAMPLE).max(1);
        self.heights
            .windows(2)
            .step_by(stride)
            .map(|pair| (pair[1] - pair[0]).abs())
            .filter(|step| *step > 0.0)
            .fold(f64::INFINITY, f64::min)
    }
}

/// Runs of samples that stand at either end of the range.
fn runs_at(heights: &[f64], low: f64, high: f64) -> impl Iterator<Item = std::ops::Range<usize>> {
    let mut at = 0;
    std::iter::from_fn(move || {
        let ends = |height: &f64| *height == low || *height == high;
        let start = at + heights[at..].iter().position(ends)?;
        let same = heights[start..].iter().take_while(|&&height| height == heights[start]);
        at = start + same.count();
        Some(start..at)
    })
}

/// Stretches without missing heights: runs of at most `longest` between two heights are filled by a
/// straight line. With each, the index of its first sample.
fn filled(mut heights: Vec<f64>, longest: usize) -> Vec<(usize, Vec<f64>)> {
    if heights.iter().all(|height| height.is_finite()) {
        return vec![(0, heights)];
    }
    let mut stretches = Vec::new();
    let mut start = 0;
    let mut last: Option<usize> = None;
    for index in 0..heights.len() {
        if !heights[index].is_finite() {
            continue;
        }
        match last {
            Some(before) if index - before > longest + 1 => {
                stretches.push((start, heights[start..=before].to_vec()));
                start = index;
            }
            Some(before) => {
                let (from, to) = (heights[before], heights[index]);
                let steps = (index - before) as f64;
                for (step, height) in heights[before..index].iter_mut().enumerate().skip(1) {
                    *height = from + step as f64 / steps * (to - from);
                }
            }
            None => start = index,
        }
        last = Some(index);
    }
    if let Some(last) = last {
        stretches.push((start, heights[start..=last].to_vec()));
    }
    stretches
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_gaps_are_filled_and_long_ones_divide() {
        let none = f64::NAN;
        let heights = vec![none, 1.0, none, 3.0, none, none, none, 7.0, 8.0, none];
        let stretches = filled(heights.clone(), 2);
        assert_eq!(stretches, [(1, vec![1.0, 2.0, 3.0]), (7, vec![7.0, 8.0])]);
        let one = filled(heights, 3);
        assert_eq!(one, [(1, vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0])]);
        assert!(filled(vec![none; 3], 3).is_empty());
    }

    #[test]
    fn runs_at_the_ends_are_found() {
        let heights = [0.0, 2.0, 2.0, 1.0, -1.0, 2.0];
        let runs: Vec<_> = runs_at(&heights, -1.0, 2.0).collect();
        assert_eq!(runs, [1..3, 4..5, 5..6]);
    }
}
