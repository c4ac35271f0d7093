//! Chainage: positions along a line, as track engineers read them.

/// The unit of an axis of positions: metres within the first kilometre, kilometres of the line beyond.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChainageUnit {
    /// m
    Metre,
    /// km
    Kilometre,
}

impl ChainageUnit {
    /// The unit that suits positions \[m\]; those that are not finite do not count.
    ///
    /// ```
    /// use riffel_plot::ChainageUnit;
    ///
    /// assert_eq!(ChainageUnit::suiting([0.0, 300.0]), ChainageUnit::Metre);
    /// assert_eq!(ChainageUnit::suiting([12_400.0, 12_450.0]), ChainageUnit::Kilometre);
    /// ```
    pub fn suiting(positions: impl IntoIterator<Item = f64>) -> Self {
        let farthest = positions
            .into_iter()
            .filter(|position| position.is_finite())
            .fold(0.0, |farthest: f64, position| farthest.max(position.abs()));
        if farthest < 1e3 { Self::Metre } else { Self::Kilometre }
    }

    /// A position \[m\] in this unit.
    pub fn of(self, position: f64) -> f64 {
        match self {
            Self::Metre => position,
            Self::Kilometre => 1e-3 * position,
        }
    }

    /// The name of the axis, with the unit.
    pub fn axis_label(self) -> &'static str {
        match self {
            Self::Metre => "position along the rail [m]",
            Self::Kilometre => "position along the rail [km]",
        }
    }
}
