//! The sites that bring the most track below its limit for the money.

use riffel_numerics::bisection::bisection;

/// Sections of a line that join on: whether each is over its limit.
pub(crate) type OverLimit = Vec<bool>;

/// What is chosen.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MostTrack {
    /// The sections of each line that are ground; below their limit are those that join two sites for less than a site costs.
    pub(crate) ground: Vec<Vec<bool>>,
    /// No choice brings more sections below their limit, whole or not.
    pub(crate) bound: f64,
}

/// Sections whose grinding brings the most of them below their limit, for the cost of a section and of a site.
///
/// Method: the budget is put into the objective with a price ν (Lagrange). What remains, Σ over − ν cost, falls apart into lines,
/// each solved exactly from section to section by whether the machine is there (Viterbi). The price is the lowest at which the
/// choice is within the budget, found by halving. What is left of the money lengthens the sites, and opens new ones in the longest
/// stretches that remain. Error: told by `bound`, the least of the dual function, which no choice exceeds. Cost: sixty passes
/// over the sections.
pub(crate) fn most_track(lines: &[OverLimit], money: f64, per_section: f64, per_site: f64) -> MostTrack {
    let costs = Costs { per_section, per_site };
    // For nothing a section is worth 1; at this price none is.
    let highest = 1.0 / per_section;
    let mut ground: Vec<Vec<bool>> = lines.iter().map(|line| vec![false; line.len()]).collect();
    let total = |ground: &[Vec<bool>]| ground.iter().map(|line| costs.of(line)).sum::<f64>();
    let worth = |ground: &[Vec<bool>]| brought_below(lines, ground) as f64;
    let mut bound = lines.iter().flatten().filter(|over| **over).count() as f64;
    bisection([0.0, highest], 1e-18 * highest, |price| {
        let chosen: Vec<Vec<bool>> = lines.iter().map(|line| costs.best(line, price)).collect();
        let cost = total(&chosen);
        bound = bound.min(worth(&chosen) + price * (money - cost));
        let is_enough = cost <= money;
        if is_enough && worth(&chosen) > worth(&ground) {
            ground = chosen;
        }
        is_enough
    });
    let rest = money - total(&ground);
    costs.spend(lines, &mut ground, rest);
    MostTrack { ground, bound }
}

/// Sections over their limit that are ground.
pub(crate) fn brought_below(lines: &[OverLimit], ground: &[Vec<bool>]) -> usize {
    let pairs = lines.iter().flatten().zip(ground.iter().flatten());
    pairs.filter(|(over, ground)| **over && **ground).count()
}

struct Costs {
    per_section: f64,
    per_site: f64,
}

impl Costs {
    /// Of what is ground of a line.
    fn of(&self, ground: &[bool]) -> f64 {
        let sections = ground.iter().filter(|ground| **ground).count();
        let begins = ground.iter().enumerate();
        let sites = begins.filter(|&(index, &there)| there && (index == 0 || !ground[index - 1])).count();
        self.per_section * sections as f64 + self.per_site * sites as f64
    }

    /// The best of a line at a price.
    fn best(&self, line: &[bool], price: f64) -> Vec<bool> {
        // Most that is gained up to a section, without and with the machine there, and whether it was there one before.
        let (mut without, mut with) = (0.0f64, f64::NEG_INFINITY);
        let mut before = Vec::with_capacity(line.len());
        for &over in line {
            let own = f64::from(u8::from(over)) - price * self.per_section;
            let (begun, gone_on) = (without - price * self.per_site, with);
            before.push([with > without, gone_on >= begun]);
            (without, with) = (without.max(with), own + begun.max(gone_on));
        }
        let mut there = with > without;
        let mut ground = vec![false; line.len()];
        for (index, before) in before.iter().enumerate().rev() {
            ground[index] = there;
            there = before[usize::from(there)];
        }
        ground
    }

    /// Spend what is left: on sections over their limit beside a site, then on the longest stretches of them.
    fn spend(&self, lines: &[OverLimit], ground: &mut [Vec<bool>], mut money: f64) {
        // To roundings of sums of costs.
        let fits = |cost: f64, money: f64| cost <= money * (1.0 + 1e-12);
        for (line, ground) in lines.iter().zip(ground.iter_mut()) {
            let mut lengthen = |index: usize, beside: usize| {
                let wanted = line[index] && !ground[index] && ground[beside];
                if wanted && fits(self.per_section, money) {
                    ground[index] = true;
                    money -= self.per_section;
                }
            };
            (1..line.len()).for_each(|index| lengthen(index, index - 1));
            (1..line.len()).rev().for_each(|index| lengthen(index - 1, index));
        }
        // What no stretch of ground track reaches: the longest first, the first of equals.
        let mut left: Vec<(usize, usize, usize)> = Vec::new();
        for (number, (line, ground)) in lines.iter().zip(ground.iter()).enumerate() {
            let missed: Vec<bool> = line.iter().zip(ground).map(|(over, ground)| *over && !*ground).collect();
            left.extend(stretches(&missed).into_iter().map(|(from, to)| (number, from, to)));
        }
        left.sort_by_key(|(_, from, to)| std::cmp::Reverse(to - from));
        for (number, from, to) in left {
            if !fits(self.per_site + self.per_section, money) {
                return;
            }
            let paid = ((money * (1.0 + 1e-12) - self.per_site) / self.per_section) as usize;
            let taken = (to - from).min(paid);
            ground[number][from..from + taken].fill(true);
            money -= self.per_site + self.per_section * taken as f64;
        }
    }
}

/// Where runs of true begin and end.
fn stretches(of: &[bool]) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    for (index, _) in of.iter().enumerate().filter(|(_, there)| **there) {
        match found.last_mut() {
            Some((_, end)) if *end == index => *end = index + 1,
            _ => found.push((index, index + 1)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The most sections of some lines that any choice within the budget brings below their limit.
    fn optimum(lines: &[OverLimit], money: f64, costs: &Costs) -> usize {
        let sections: Vec<bool> = lines.concat();
        let parts = |choice: u32| -> Vec<Vec<bool>> {
            let mut bits = (0..sections.len()).map(|bit| choice >> bit & 1 == 1);
            lines.iter().map(|line| bits.by_ref().take(line.len()).collect()).collect()
        };
        (0..1u32 << sections.len())
            .map(parts)
            .filter(|ground| ground.iter().map(|line| costs.of(line)).sum::<f64>() <= money)
            .map(|ground| brought_below(lines, &ground))
            .max()
            .unwrap()
    }

    proptest! {
        /// Against every choice of up to a dozen sections: within the budget, never above the optimum, which is never above the bound;
        /// short of it by no more than a line, of which a price may take all or nothing.
        #[test]
        fn no_choice_is_much_better(
            lines in prop::collection::vec(prop::collection::vec(any::<bool>(), 1..7), 1..3),
            money in 0.0..40.0,
            per_site in 0.0..10.0,
        ) {
            let costs = Costs { per_section: 2.0, per_site };
            let found = most_track(&lines, money, 2.0, per_site);
            let cost: f64 = found.ground.iter().map(|line| costs.of(line)).sum();
            prop_assert!(cost <= money + 1e-9);
            let (own, best) = (brought_below(&lines, &found.ground), optimum(&lines, money, &costs));
            prop_assert!(own <= best && best as f64 <= found.bound + 1e-9, "{own} {best} {}", found.bound);
            let longest = lines.iter().map(|line| line.iter().filter(|over| **over).count()).max();
            prop_assert!(best - own <= longest.unwrap_or(0), "{own} of {best}");
        }
    }

    /// A gap of a section is ground through where that costs less than a site, and is not where it costs more.
    #[test]
    fn sites_join_where_that_is_cheaper() {
        let line = vec![true, true, false, true, true];
        let whole = most_track(std::slice::from_ref(&line), 100.0, 2.0, 3.0);
        assert_eq!(whole.ground, [[true; 5]]);
        assert_eq!(whole.bound, 4.0);
        let parted = most_track(std::slice::from_ref(&line), 100.0, 2.0, 1.0);
        assert_eq!(parted.ground, [line]);
    }
}
