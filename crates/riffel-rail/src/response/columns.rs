//! Which column of a table holds what.

use riffel_keys::table::{is_one_of, it_has, words};

use super::MeasurementError;
use super::keys::Measurement;

/// The columns that are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) frequency: usize,
    pub(super) values: Parts,
    pub(super) coherence: Option<usize>,
}

/// The columns of a complex value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Parts {
    Cartesian([usize; 2]),
    Polar([usize; 2]),
    /// One column of complex numbers.
    Complex(usize),
}

/// What a column holds by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    Frequency,
    Real,
    Imaginary,
    Modulus,
    Phase,
    Coherence,
}

impl Role {
    /// From a word of the name, in English or German; the first role that has one is taken, so that "phase of the frequency response" is
    /// a phase.
    const WORDS: [(Self, &'static str); 6] = [
        (Self::Coherence, "coherence|coh|kohärenz|kohaerenz|gamma2|γ²|γ2"),
        (Self::Phase, "phase|arg|angle|winkel|phasenwinkel"),
        (Self::Imaginary, "im|imag|imaginary|imaginär|imaginärteil|imaginaerteil"),
        (Self::Real, "re|real|realteil"),
        (
            Self::Modulus,
            "modulus|mod|magnitude|mag|abs|amplitude|amp|betrag|receptance|mobility|accelerance|inertance|compliance|\
             rezeptanz|mobilität|akzeleranz",
        ),
        (Self::Frequency, "frequency|freq|f|frequenz|hz"),
    ];

    pub(super) fn of(name: &str) -> Option<Self> {
        let own = without_unit(name);
        let words = words(own);
        let mut roles = Self::WORDS.into_iter();
        let role = roles.find(|(_, known)| words.iter().any(|word| is_one_of(word, known)));
        match role {
            // |H| is a modulus whatever it is called.
            None if own.trim().starts_with('|') => Some(Self::Modulus),
            role => role.map(|(role, _)| role),
        }
    }
}

impl Columns {
    /// The columns that the case names, and for those it does not, the ones that the header tells.
    pub(super) fn find(header: &[String], measurement: &Measurement) -> Result<Self, MeasurementError> {
        Ok(Self { values: Parts::find(header, measurement)?, ..Self::with(header, measurement, Parts::Complex(0))? })
    }

    /// The columns where values are complex numbers in the only other column.
    pub(super) fn complex(header: &[String], measurement: &Measurement) -> Result<Self, MeasurementError> {
        let columns = Self::with(header, measurement, Parts::Complex(0))?;
        let known = [Some(columns.frequency), columns.coherence];
        let mut others =
            (0..header.len()).filter(|&column| !known.contains(&Some(column)) && !header[column].is_empty());
        match (others.next(), others.next()) {
            (Some(column), None) => Ok(Self { values: Parts::Complex(column), ..columns }),
            _ => Err(MeasurementError::file("has no column of complex numbers")),
        }
    }

    fn with(header: &[String], measurement: &Measurement, values: Parts) -> Result<Self, MeasurementError> {
        let frequency = match &measurement.frequency {
            Some(name) => named(header, "frequency", name)?,
            None => told(header, Role::Frequency, "frequency")?.ok_or_else(|| {
                let message = format!("is left out, and the header names no frequency; {}", it_has(header));
                MeasurementError::new("frequency", message)
            })?,
        };
        let coherence = match &measurement.coherence {
            Some(name) => Some(named(header, "coherence", name)?),
            None => told(header, Role::Coherence, "coherence")?,
        };
        Ok(Self { frequency, values, coherence })
    }

    /// All of them.
    pub(super) fn all(&self) -> Vec<usize> {
        let mut columns = self.values.all();
        columns.push(self.frequency);
        columns
    }
}

impl Parts {
    /// All of them.
    pub(super) fn all(self) -> Vec<usize> {
        match self {
            Self::Cartesian(columns) | Self::Polar(columns) => columns.to_vec(),
            Self::Complex(column) => vec![column],
        }
    }

    /// The column of the real part, the modulus or the whole, which names the unit.
    pub(super) fn first(self) -> usize {
        let (Self::Cartesian([first, _]) | Self::Polar([first, _]) | Self::Complex(first)) = self;
        first
    }

    fn find(header: &[String], measurement: &Measurement) -> Result<Self, MeasurementError> {
        let Measurement { real, imaginary, modulus, phase, .. } = measurement;
        match (real, imaginary, modulus, phase) {
            (Some(real), Some(imaginary), None, None) => {
                Ok(Self::Cartesian([named(header, "real", real)?, named(header, "imaginary", imaginary)?]))
            }
            (None, None, Some(modulus), Some(phase)) => {
                Ok(Self::Polar([named(header, "modulus", modulus)?, named(header, "phase", phase)?]))
            }
            (None, None, None, None) => Self::told(header),
            _ => Err(MeasurementError::new(
                "",
                "names its values by `real` and `imaginary`, or by `modulus` and `phase`: give the two \
                 columns of one pair",
            )),
        }
    }

    fn told(header: &[String]) -> Result<Self, MeasurementError> {
        let real = told(header, Role::Real, "real")?;
        let imaginary = told(header, Role::Imaginary, "imaginary")?;
        if let (Some(real), Some(imaginary)) = (real, imaginary) {
            return Ok(Self::Cartesian([real, imaginary]));
        }
        let modulus = told(header, Role::Modulus, "modulus")?;
        let phase = told(header, Role::Phase, "phase")?;
        if let (Some(modulus), Some(phase)) = (modulus, phase) {
            return Ok(Self::Polar([modulus, phase]));
        }
        Err(MeasurementError::new(
            "",
            format!(
                "does not name the columns of the values, by `real` and `imaginary` or by `modulus` and `phase`, and the \
                 header does not tell them; {}",
                it_has(header)
            ),
        ))
    }
}

/// The column that the case names.
fn named(header: &[String], key: &'static str, name: &str) -> Result<usize, MeasurementError> {
    header.iter().position(|known| known == name).ok_or_else(|| {
        let message = format!("is \"{name}\", but the file has no such column; {}", it_has(header));
        MeasurementError::new(key, message)
    })
}

/// The one column whose name has a word of the role.
fn told(header: &[String], role: Role, key: &'static str) -> Result<Option<usize>, MeasurementError> {
    let mut columns = (0..header.len()).filter(|&column| Role::of(&header[column]) == Some(role));
    match (columns.next(), columns.next()) {
        (Some(first), Some(second)) => Err(MeasurementError::new(
            key,
            format!("is left out, and more than one column could be it: `{}`, `{}`", header[first], header[second]),
        )),
        (first, _) => Ok(first),
    }
}

/// The unit in the name of a column: "|H| [m/N]", "Accelerance ((m/s²)/N)", "f / Hz", "modulus in m/N", "phase_deg".
pub(super) fn unit_in_name(name: &str) -> Option<&str> {
    let unit = if let Some((_, rest)) = name.split_once('[') {
        rest.strip_suffix(']')
    } else if let Some(inside) = last_of_two_brackets(name) {
        Some(inside)
    } else if let Some((_, rest)) = name.split_once('(') {
        // The outer pair goes, unless it is the first of "(m/s²)/N".
        match rest.strip_suffix(')') {
            Some(inside) => Some(inside),
            None => Some(&name[name.len() - rest.len() - 1..]),
        }
    } else if let Some((_, rest)) = name.split_once(" / ").or_else(|| name.split_once(" in ")) {
        Some(rest)
    } else {
        let known = ["Hz", "hz", "kHz", "khz", "deg", "rad", "dB", "db", "rad_s", "rad_per_s", "rpm"];
        let known = known.into_iter().find(|unit| {
            let before = name.strip_suffix(unit);
            before.is_some_and(|before| before.len() > 1 && before.ends_with('_'))
        });
        known.or_else(|| per_force(name))
    };
    unit.map(str::trim).filter(|unit| !unit.is_empty())
}

/// What stands in the last brackets of a name that has others before them, as in "Re(H) (mm/N)".
fn last_of_two_brackets(name: &str) -> Option<&str> {
    let inside = name.strip_suffix(')')?;
    let (before, last) = inside.rsplit_once('(')?;
    // Brackets within brackets are one unit.
    let is_second = before.contains('(') && before.trim_end().ends_with(')');
    is_second.then_some(last)
}

/// The unit in a name of words, as in rail_m_per_n_re or zz_mm_per_s_per_kn_im.
fn per_force(name: &str) -> Option<&str> {
    const PER: &str = "_per_";
    let first = name.find(PER)?;
    let begin = name[..first].rfind('_').map_or(0, |mark| mark + 1);
    let (mut end, mut last) = (first, "");
    while let Some(rest) = name[end..].strip_prefix(PER) {
        last = rest.split('_').next()?;
        end += PER.len() + last.len();
    }
    matches!(last, "n" | "N" | "kn" | "kN" | "mn" | "mN" | "MN").then(|| &name[begin..end])
}

/// The name without what [`unit_in_name`] finds in brackets or behind a slash: in "dB re 1 m/N" nothing is real.
pub(super) fn without_unit(name: &str) -> &str {
    let ends = ["[", "(", " / ", " in "].into_iter();
    let end = ends.filter_map(|mark| name.find(mark)).min();
    &name[..end.unwrap_or(name.len())]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_role_and_unit() {
        for (name, role, unit) in [
            ("frequency_hz", Role::Frequency, Some("hz")),
            ("f / kHz", Role::Frequency, Some("kHz")),
            ("frequency_rad_s", Role::Frequency, Some("rad_s")),
            ("frequency_rpm", Role::Frequency, Some("rpm")),
            ("Frequenz [Hz]", Role::Frequency, Some("Hz")),
            ("rail_m_per_n_re", Role::Real, Some("m_per_n")),
            ("zz_mm_per_n_re", Role::Real, Some("mm_per_n")),
            ("yz_mm_per_s_per_kn_im", Role::Imaginary, Some("mm_per_s_per_kn")),
            ("zz_furlong_per_n_re", Role::Real, Some("furlong_per_n")),
            ("Imaginärteil in m/N", Role::Imaginary, Some("m/N")),
            ("|H| (dB re 1 m/N)", Role::Modulus, Some("dB re 1 m/N")),
            ("Accelerance magnitude ((m/s²)/N)", Role::Modulus, Some("(m/s²)/N")),
            ("Mag (m/s²)/N", Role::Modulus, Some("(m/s²)/N")),
            ("Phase of the frequency response [°]", Role::Phase, Some("°")),
            ("Coherence", Role::Coherence, None),
        ] {
            assert_eq!(Role::of(name), Some(role));
            assert_eq!(unit_in_name(name), unit);
        }
    }
}
