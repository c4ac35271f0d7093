//! Joints, welds and squats among the cells of a section, and whether they come rail by rail.

use std::ops::Range;

/// Longest single place \[m\]: corrugation of the shortest waves lasts for tens of them.
pub(crate) const LONGEST_PLACE: f64 = 2.0;
/// Longest single place that the survey names \[m\]: its filters ring beside it, and cells cut it in three.
const LONGEST_NAMED: f64 = 4.0;
/// How wide it may seem in metres or in cells, as its energy over its highest mean square: a place of 2 m, or one that the edges of cells
/// cut in halves, with a little noise.
const WIDEST: f64 = 1.25 * LONGEST_PLACE;
/// How far it stands out of its section.
const STANDS_OUT: f64 = 2.0;
/// Distance of places \[m\] that no rails are shorter than: what stands out more often is the rail itself.
const CLOSEST: f64 = 8.0;
/// Lengths of rails between joints \[m\]: bolted rails are 9 m to 30 m long.
const RAILS: [f64; 2] = [CLOSEST, 32.0];
/// How far a joint may be off the next but for the length of a rail \[m\]: cells of a metre know either to half of one, and rails
/// that were cut differ.
const JITTER: f64 = 1.6;
/// Distances that must agree, and their share among all: a joint may not stand out, and a weld may stand between two.
const LEAST_RAILS: usize = 3;
const SHARE: f64 = 0.6;

/// Whether cells of a length \[m\] tell single places; an odometer has those of 2 m a little longer.
pub(crate) fn tells_places(resolution: f64) -> bool {
    resolution <= 1.01 * LONGEST_PLACE
}

/// Runs of cells that are a single place.
///
/// A run of cells twice as rough as the median of their section is one where its energy, over its highest mean square, is no wider than
/// 2 m or two cells, or where the survey names a defect in it and it is no longer than 4 m. Cells of more than 2 m are one where the survey
/// names a defect in them. `named` tells it cell by cell.
pub(crate) fn single_places(cells: &[f64], named: &[bool], resolution: f64) -> Vec<Range<usize>> {
    let is_named = |run: &Range<usize>| named[run.clone()].contains(&true);
    if !tells_places(resolution) {
        let all = (0..cells.len()).map(|cell| cell..cell + 1);
        return all.filter(is_named).collect();
    }
    let usual = median(cells.iter().copied().filter(|rms| rms.is_finite()).collect());
    let mut runs: Vec<Range<usize>> = Vec::new();
    for cell in (0..cells.len()).filter(|cell| cells[*cell] > STANDS_OUT * usual) {
        match runs.last_mut().filter(|run| run.end == cell) {
            Some(run) => run.end += 1,
            None => runs.push(cell..cell + 1),
        }
    }
    let width = |run: &Range<usize>| {
        let squares = cells[run.clone()].iter().map(|rms| rms * rms);
        resolution * squares.clone().sum::<f64>() / squares.fold(0.0, f64::max)
    };
    let (mut own, mut others): (Vec<_>, Vec<_>) = runs.into_iter().partition(&is_named);
    own.retain(|run| run.len() as f64 * resolution <= LONGEST_NAMED.max(resolution));
    others.retain(|run| width(run) <= WIDEST * resolution.max(1.0));
    if others.len() as f64 <= cells.len() as f64 * resolution / CLOSEST + 1.0 {
        own.append(&mut others);
        own.sort_by_key(|run| run.start);
    }
    own
}

/// Whether places \[m\], in order, are the joints of rails of one length: three distances and more agree, and most of all do.
pub(crate) fn are_joints(places: &[f64]) -> bool {
    let mut joints: Vec<f64> = Vec::new();
    for place in places {
        // What two cells or two sections have of it is one.
        if joints.last().is_none_or(|last| place - last > LONGEST_PLACE) {
            joints.push(*place);
        }
    }
    let distances: Vec<f64> = joints.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let rails = || {
        let rails = distances.iter().copied();
        rails.filter(|length| (RAILS[0]..=RAILS[1]).contains(length))
    };
    let agree = |length: f64| {
        let alike = rails().filter(|other| (other - length).abs() <= JITTER);
        alike.count()
    };
    let most = rails().map(agree).max().unwrap_or(0);
    most >= LEAST_RAILS && most as f64 >= SHARE * distances.len() as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(of: impl Fn(usize) -> f64) -> Vec<f64> {
        (0..100).map(of).collect()
    }

    /// A joint over two cells that another grid has in three is one; three whole cells are none, unless the survey names a defect there.
    #[test]
    fn a_joint_is_as_wide_as_its_energy() {
        let two = cells(|cell| if matches!(cell % 15, 7 | 8) { 12.0 } else { 2.0 });
        let square = |at: usize| two[at].powi(2);
        let three = cells(|cell| match cell {
            0 => 2.0,
            _ => (0.35 * square(cell - 1) + 0.65 * square(cell)).sqrt(),
        });
        let none = vec![false; 100];
        for cells in [&two, &three] {
            assert_eq!(single_places(cells, &none, 1.0).len(), 7);
        }
        let wide = cells(|cell| if cell % 20 < 3 { 36.0 } else { 2.0 });
        assert!(single_places(&wide, &none, 1.0).is_empty());
        let named: Vec<bool> = (0..100).map(|cell| cell % 20 == 1).collect();
        assert_eq!(single_places(&wide, &named, 1.0).len(), 5);
        // In cells of 2 m, every seven of them, in one or in halves.
        let long = cells(|cell| match cell % 14 {
            3 => 9.0,
            10 | 11 => 6.4,
            _ => 2.0,
        });
        assert_eq!(single_places(&long, &none, 2.001).len(), 14);
        // A cell of 10 m tells no joint by itself.
        assert!(single_places(&two, &none, 10.0).is_empty());
        assert_eq!(single_places(&two, &named, 10.0).len(), 5);
    }

    /// What stands out every 4 m is the rail itself.
    #[test]
    fn places_are_rails_apart() {
        let often = cells(|cell| if cell % 4 == 0 { 9.0 } else { 3.0 });
        assert!(single_places(&often, &[false; 100], 1.0).is_empty());
    }

    /// Rails of 15 m and of 25 m with a metre of jitter, one joint missing; welds where the distance is any; two joints tell nothing.
    #[test]
    fn joints_are_a_rail_apart() {
        assert!(are_joints(&[3.0, 17.5, 33.0, 48.5, 78.0, 92.5]));
        assert!(are_joints(&[2.0, 26.0, 52.0, 76.5]));
        assert!(!are_joints(&[2.0, 16.0, 47.0, 58.0, 93.0]));
        assert!(!are_joints(&[2.0, 17.0, 32.0]));
        assert!(!are_joints(&[]));
    }
}
