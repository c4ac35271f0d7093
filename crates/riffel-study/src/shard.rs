//! A part of the chunks of a study.

use std::fmt;
use std::str::FromStr;

/// A part of the chunks: every n-th, so that the parts take about as long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 1.
    pub(crate) index: u64,
    /// Of how many.
    pub(crate) count: u64,
}

impl Shard {
    /// All chunks.
    pub const ALL: Self = Self { index: 1, count: 1 };

    /// The shard `index`, from 1, of `count`; none unless 1 ≤ `index` ≤ `count`.
    pub fn new(index: u64, count: u64) -> Option<Self> {
        (1..=count).contains(&index).then_some(Self { index, count })
    }

    /// Whether a chunk belongs to it.
    pub fn contains(&self, chunk: u64) -> bool {
        chunk % self.count == self.index - 1
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.count)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let parts = parts.and_then(|(index, count)| Some((index.trim().parse().ok()?, count.trim().parse().ok()?)));
        parts
            .and_then(|(index, count)| Self::new(index, count))
            .ok_or_else(|| "write i/n with i from 1 to n, as in 3/8".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_share_the_chunks() {
        let shards: Vec<Shard> = (1..=7).filter_map(|index| Shard::new(index, 7)).collect();
        for chunk in 0..50 {
            assert_eq!(shards.iter().filter(|shard| shard.contains(chunk)).count(), 1);
        }
        assert_eq!("3/8".parse(), Ok(Shard { index: 3, count: 8 }));
        for wrong in ["0/8", "9/8", "3", "3/0", "-1/2", "a/b"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
