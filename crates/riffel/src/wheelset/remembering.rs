//! A wheelset that several loops ask at the same frequencies.

use std::sync::Arc;

use num_complex::Complex64;

use super::{ContactReceptances, HubReceptances, Wheelset, WheelsetWithHubs};
use crate::memory::{Memory, bits};

/// Most groups of frequencies that are remembered: 100 MB, of 208 wavelengths at the 1025 speeds that sharp resonances ask for.
const MOST: usize = 1 << 16;

/// Entries of a symmetric matrix of six rows.
const ENTRIES: usize = 21;

/// A wheelset that remembers what it answered, for the wheels of a vehicle in a curve: they run in states of their own on
/// wheelsets that are alike, and are asked at the same speeds and wavelengths.
///
/// Answers are those of the wheelset, to the last bit. Cost: 0.1 µs for a group of frequencies that is known.
pub struct RememberingWheelset {
    of: Arc<dyn Wheelset>,
    with_hubs: Option<Arc<dyn WheelsetWithHubs>>,
    memory: Memory<Box<[Answered]>>,
}

/// What a wheelset answers at one frequency.
struct Answered {
    /// At its contacts, up to the diagonal.
    contacts: [Complex64; ENTRIES],
    /// Zeros if it does not describe them.
    hubs: HubReceptances,
}

/// Hubs of a wheelset that remembers.
struct RememberedHubs {
    of: Arc<dyn WheelsetWithHubs>,
    wheelset: Arc<RememberingWheelset>,
}

impl RememberingWheelset {
    /// One that was not asked yet, of a wheelset and of the same with its hubs, if it describes them.
    pub fn new(of: Arc<dyn Wheelset>, with_hubs: Option<Arc<dyn WheelsetWithHubs>>) -> Self {
        Self { of, with_hubs, memory: Memory::new(MOST) }
    }

    /// Receptances of its hubs, which it finds and remembers with those of its contacts; `None` if it does not describe them.
    pub fn with_hubs(self: &Arc<Self>) -> Option<Arc<dyn WheelsetWithHubs>> {
        let of = self.with_hubs.clone()?;
        Some(Arc::new(RememberedHubs { of, wheelset: self.clone() }))
    }

    fn recall(&self, angular_frequencies: &[f64], mut take: impl FnMut(usize, &Answered)) {
        let find = |&w: &f64| {
            let (contacts, hubs) = match &self.with_hubs {
                Some(both) => both.receptances_and_hubs(w),
                None => (self.of.receptances(w), HubReceptances::default()),
            };
            Answered { contacts: lower(&contacts), hubs }
        };
        self.memory.recall(
            &bits(angular_frequencies),
            |answers| answers.iter().enumerate().for_each(|(index, answered)| take(index, answered)),
            || angular_frequencies.iter().map(find).collect(),
        );
    }
}

impl Wheelset for RememberingWheelset {
    fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
        let mut contacts = ContactReceptances::default();
        self.receptances_at(&[angular_frequency], &mut |_, found| contacts = *found);
        contacts
    }

    fn receptances_at(&self, angular_frequencies: &[f64], take: &mut dyn FnMut(usize, &ContactReceptances)) {
        self.recall(angular_frequencies, |index, answered| take(index, &whole(&answered.contacts)));
    }

    fn free_at_contacts(&self) -> [[f64; 6]; 6] {
        self.of.free_at_contacts()
    }
}

impl WheelsetWithHubs for RememberedHubs {
    fn hubs(&self, angular_frequency: f64) -> HubReceptances {
        self.receptances_and_hubs(angular_frequency).1
    }

    fn hubs_at(&self, angular_frequencies: &[f64], take: &mut dyn FnMut(usize, &HubReceptances)) {
        self.wheelset.recall(angular_frequencies, |index, answered| take(index, &answered.hubs));
    }

    fn receptances_and_hubs(&self, angular_frequency: f64) -> (ContactReceptances, HubReceptances) {
        let mut both = Default::default();
        self.wheelset.recall(&[angular_frequency], |_, answered| both = (whole(&answered.contacts), answered.hubs));
        both
    }

    fn free_hubs(&self) -> [[f64; 2]; 2] {
        self.of.free_hubs()
    }
}

/// Entries of a symmetric matrix up to its diagonal, row by row.
fn lower(matrix: &ContactReceptances) -> [Complex64; ENTRIES] {
    let mut rows = matrix.iter().enumerate().flat_map(|(row, entries)| &entries[..=row]);
    std::array::from_fn(|_| rows.next().copied().unwrap_or_default())
}

/// The symmetric matrix of which the entries up to the diagonal are given.
fn whole(lower: &[Complex64; ENTRIES]) -> ContactReceptances {
    // Row by row, the entry of row i and column j < i at i(i + 1)/2 + j.
    let entry = |row: usize, column: usize| lower[row * (row + 1) / 2 + column];
    std::array::from_fn(|row| std::array::from_fn(|column| entry(row.max(column), row.min(column))))
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use num_complex::Complex64;

    use super::*;

    /// Counts how often it is asked.
    struct Counting(AtomicUsize);

    impl Wheelset for Counting {
        fn receptances(&self, angular_frequency: f64) -> ContactReceptances {
            self.0.fetch_add(1, Ordering::Relaxed);
            let entry = |row, column| Complex64::new(angular_frequency, (row * column) as f64);
            std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
        }
    }

    #[test]
    fn asks_its_wheelset_once_for_each_frequency() {
        let counting = Arc::new(Counting(AtomicUsize::new(0)));
        let wheelset = RememberingWheelset::new(counting.clone(), None);
        for _ in 0..3 {
            for step in 1..=50 {
                let w = f64::from(step) * 0.1;
                assert_eq!(wheelset.receptances(w), counting.receptances(w));
            }
        }
        let by_the_test = 150;
        assert_eq!(counting.0.load(Ordering::Relaxed) - by_the_test, 50);
    }
}
