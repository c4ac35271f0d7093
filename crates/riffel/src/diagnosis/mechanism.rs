//! The mechanisms that fix a wavelength, and what is known of each.

/// What a mechanism does to a level from record to record.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expectation {
    /// Corrugation: it rises under traffic.
    Grows,
    /// A mark of machining: traffic wears it away.
    Fades,
    /// It may do either.
    Either,
}

/// A mechanism that fixes a wavelength.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MechanismKind {
    /// The feedback of this case: normal force, creepage, wear.
    GrowthRidge,
    /// Unsprung mass on the stiffness of the track.
    P2,
    /// Rail and sleepers together on the ballast.
    FullTrack,
    /// Sleeper between pad and ballast, which holds the rail still.
    SleeperAntiresonance,
    /// Rail on its pads against the sleepers or the slab.
    RailOnPad,
    /// Rail bending vertically between its supports.
    PinnedPinned,
    /// Rail bending laterally between its supports.
    LateralPinnedPinned,
    /// Peak of the rail's receptance as it was measured.
    MeasuredPeak,
    /// Dip of the rail's receptance as it was measured.
    MeasuredDip,
    /// Peak of a receptance that the caller gives.
    FunctionPeak,
    /// Dip of a receptance that the caller gives.
    FunctionDip,
    /// The two wheels turning against each other.
    WheelsetTorsion,
    /// The axle bending.
    WheelsetBending,
    /// Marks of grinding stones.
    GrindingMark,
    /// Sleeper passing: each support a little stiffer than the rail between.
    SupportSpacing,
    /// Orders of the wheel's circumference.
    WheelCircumference,
    /// None of the above.
    Unlisted,
}

impl MechanismKind {
    /// Its name in the field's words.
    pub fn name(self) -> &'static str {
        match self {
            Self::GrowthRidge => "growth ridge",
            Self::P2 => "P2 resonance",
            Self::FullTrack => "full-track resonance",
            Self::SleeperAntiresonance => "sleeper antiresonance",
            Self::RailOnPad => "rail on pad",
            Self::PinnedPinned => "pinned-pinned, vertical",
            Self::LateralPinnedPinned => "pinned-pinned, lateral",
            Self::MeasuredPeak => "peak of the measured receptance",
            Self::MeasuredDip => "dip of the measured receptance",
            Self::FunctionPeak => "peak of the given receptance",
            Self::FunctionDip => "dip of the given receptance",
            Self::WheelsetTorsion => "wheelset torsion",
            Self::WheelsetBending => "wheelset bending",
            Self::GrindingMark => "grinding mark",
            Self::SupportSpacing => "sleeper passing",
            Self::WheelCircumference => "wheel circumference",
            Self::Unlisted => "a cause not listed",
        }
    }

    /// What it does to a level from record to record.
    pub fn expectation(self) -> Expectation {
        match self {
            Self::GrindingMark => Expectation::Fades,
            Self::SupportSpacing | Self::WheelCircumference | Self::Unlisted => Expectation::Either,
            _ => Expectation::Grows,
        }
    }
}
