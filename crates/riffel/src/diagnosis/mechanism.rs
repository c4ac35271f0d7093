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
    GivenPeak,
    /// Dip of a receptance that the caller gives.
    GivenDip,
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
            Self::GivenPeak => "peak of the given receptance",
            Self::GivenDip => "dip of the given receptance",
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

    /// Where it stands in the literature, and where Riffel takes its number from.
    pub fn source(self) -> &'static str {
        match self {
            Self::GrowthRidge => {
                "Afferrante & Ciavarella (2009), with the receptances, contact and wear of this case"
            }
            Self::P2 => {
                "50–100 Hz in Afferrante & Ciavarella (2009); here the least sum of the receptances of rail, wheel \
                 and contact of this case"
            }
            Self::FullTrack => {
                "Near 100 Hz (Bhaskar et al., in Afferrante & Ciavarella 2009); here the peak of the case's rail receptance"
            }
            Self::SleeperAntiresonance => {
                "Low vertical receptance near 300 Hz (Müller, in Afferrante & Ciavarella 2009); here √((k_p + k_b)/m_s) of \
                 this case"
            }
            Self::RailOnPad => "the peak of the case's rail receptance, else √(k_p/m)",
            Self::PinnedPinned => {
                "Near 800 Hz at 0.75 m and 1200 Hz at 0.6 m (Grassie & Kalousek, in Afferrante & Ciavarella 2009); Nielsen \
                 (2003) for low receptance above sleepers; here Timoshenko's beam of this case"
            }
            Self::LateralPinnedPinned => {
                "513.7 Hz lateral beside 1050 Hz vertical (Wang & Lei 2020); here Timoshenko's beam of this case, lateral"
            }
            Self::MeasuredPeak | Self::MeasuredDip => {
                "the measured receptance of the rail: which mode of the track this is, it does not say"
            }
            Self::GivenPeak | Self::GivenDip => {
                "the receptance of the rail given with the case: which mode of the track this is, it does not say"
            }
            Self::WheelsetTorsion => {
                "second torsional mode near 300 Hz (Elkins 1998, in Afferrante & Ciavarella 2009); the frequency as given"
            }
            Self::WheelsetBending => {
                "bending of the leading axle (Torstensson & Nielsen 2013); the frequency as given"
            }
            Self::GrindingMark => {
                "stones that turn 50 to 60 times a second on a train at 3 to 15 km/h: 14 to 83 mm; marks of 60 mm with 60 Hz \
                 are reported from a Chinese high-speed line (Shock and Vibration 2021, 5546809). The speeds are \
                 Riffel's assumption"
            }
            Self::SupportSpacing => "d and d/2 of this case's support spacing d: kinematics",
            Self::WheelCircumference => {
                "2πR/n, n = 1 to 30, of this case's rolling radius: kinematics"
            }
            Self::Unlisted => {
                "every wavelength from 5 mm to 2 m equally likely on a logarithmic scale"
            }
        }
    }

    /// Where it stops being a good description.
    pub fn validity(self) -> &'static str {
        match self {
            Self::GrowthRidge => {
                "one wheel, linear, within the remarks on this case; shares follow growth inside the wavelengths asked for"
            }
            Self::P2 => {
                "rigid unsprung mass, evenly spread supports; ±15 % for the stiffness of real track"
            }
            Self::FullTrack | Self::SleeperAntiresonance => {
                "undamped layers; ballast stiffness is uncertain by a factor of two, the frequency by ±15 %"
            }
            Self::RailOnPad => "pads stiffen with load and frequency and in the cold: ±15 %",
            Self::PinnedPinned | Self::LateralPinnedPinned => {
                "Timoshenko's beam on supports at equal distances; ±5 % for spacing and foot of the rail"
            }
            Self::MeasuredPeak | Self::MeasuredDip | Self::GivenPeak | Self::GivenDip => {
                "the place and the load of the receptance; ±5 % for another place, temperature and wheel load, and its \
                 width at half power"
            }
            Self::WheelsetTorsion | Self::WheelsetBending => "as good as the frequency given; ±5 %",
            Self::GrindingMark => {
                "the wavelength of one pass of one train; several passes leave several"
            }
            Self::SupportSpacing => "supports at equal distances; ±2 %",
            Self::WheelCircumference => {
                "in a record taken from a vehicle: wheels of other diameters and phases do not print one pattern on the \
                 rail; ±3 % for worn diameters"
            }
            Self::Unlisted => "always",
        }
    }

    /// Its name with the measurement that would settle it, as a sentence.
    pub fn settled_by(self) -> String {
        let (first, rest) = self.name().split_at(1);
        format!(
            "{}{rest}: {}.",
            first.to_uppercase(),
            self.own_measurement()
        )
    }

    /// The measurement that is its own.
    fn own_measurement(self) -> &'static str {
        match self {
            Self::GrowthRidge => {
                "speed: where trains run at another speed the wavelength moves and the frequency stays; speeds spread more widely lower its \
                 growth"
            }
            Self::P2 => {
                "vertical axle-box acceleration of vehicles with another unsprung mass: P2 moves with the mass, modes of \
                 the track do not"
            }
            Self::FullTrack => {
                "receptance of the loaded track from 20 to 200 Hz, with and without voids under the sleepers"
            }
            Self::SleeperAntiresonance => {
                "impact hammer on sleeper and rail head: at this frequency the sleeper moves and the rail does not"
            }
            Self::RailOnPad => {
                "track decay rate (EN 15461) and hammer receptance: a peak here that moves with the pads (temperature, \
                 new pads over a trial length)"
            }
            Self::PinnedPinned => {
                "hammer receptance above a sleeper and in mid-span, and the profile averaged over sleeper bays: the \
                 amplitude follows the sleepers; an irregular spacing or rail dampers remove it"
            }
            Self::LateralPinnedPinned => {
                "lateral hammer receptance of the rail head in mid-span and lateral track decay rate"
            }
            Self::MeasuredPeak | Self::GivenPeak => {
                "hammer receptance above a sleeper, in mid-span and on the sleeper, with a wheel beside it: a mode of the \
                 pads moves the sleeper little and shifts with new or colder pads, a pinned-pinned mode is seen in mid-span alone"
            }
            Self::MeasuredDip | Self::GivenDip => {
                "impact hammer on sleeper and rail head: at this frequency something else moves and holds the rail"
            }
            Self::WheelsetTorsion => {
                "strain gauges for torque on a driven axle, or longitudinal axle-box acceleration, through the section"
            }
            Self::WheelsetBending => {
                "lateral and vertical axle-box acceleration of the leading axle through the curve; the low rail should be worst"
            }
            Self::GrindingMark => {
                "the log of the grinding train (date, passes, speed, turns of the stones), a photograph of the facets, and a \
                 section that was not ground"
            }
            Self::SupportSpacing => {
                "sleeper positions on the chainage of the record: the phase stays with them"
            }
            Self::WheelCircumference => {
                "a trolley record of the same rail, and wheel roughness or out-of-roundness: if the trolley does not see the \
                 wavelength it is on the wheel"
            }
            Self::Unlisted => {
                "a receptance measurement of this track in place of the model (track.model = \"measured\")"
            }
        }
    }
}
