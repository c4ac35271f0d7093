//! Frequency weighting A.

/// Weighting A \[dB\] at a frequency \[Hz\].
///
/// A(f) = 20 lg(f₄²f⁴/((f² + f₁²) √(f² + f₂²) √(f² + f₃²) (f² + f₄²))) less its value at 1 kHz, with the poles
/// 20.599, 107.65, 737.86 and 12194 Hz. Source: IEC 61672-1:2013, annex E.
pub fn a_weighting(frequency: f64) -> f64 {
    unnormalised(frequency) - unnormalised(1000.0)
}

/// Poles f₁ to f₄ \[Hz\].
const POLES: [f64; 4] = [20.598_997, 107.652_65, 737.862_23, 12_194.217];

fn unnormalised(frequency: f64) -> f64 {
    let square = frequency * frequency;
    let [first, second, third, fourth] = POLES.map(|pole| square + pole * pole);
    let response = square * square / (first * (second * third).sqrt() * fourth);
    20.0 * response.log10()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FrequencyBand;

    /// IEC 61672-1:2013, table 3, printed to 0.1 dB at the exact base-ten frequencies.
    #[test]
    fn the_printed_table_comes_back() {
        let table = [(20, -19.1), (23, -10.9), (27, -3.2), (30, 0.0), (34, 1.3), (37, 0.5), (40, -2.5)];
        for (index, printed) in table {
            let found = a_weighting(FrequencyBand::new(index).centre());
            assert!((found - printed).abs() < 0.051, "{index}: {found}");
        }
    }
}
