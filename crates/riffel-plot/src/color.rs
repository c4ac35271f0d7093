//! Colours: a sequential map for growth and a palette for lines, both safe for colour-blind
//! readers.

/// A colour of the sRGB space, 8 bits per channel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rgb(pub u8, pub u8, pub u8);

impl Rgb {
    pub(crate) const WHITE: Rgb = Rgb(255, 255, 255);
    /// Black, the first of [`OKABE_ITO`].
    pub const BLACK: Rgb = Rgb(0, 0, 0);
    /// Axes, ticks and text.
    pub(crate) const INK: Rgb = Rgb(34, 34, 34);
    /// Rays of constant frequency and other auxiliary lines.
    pub(crate) const AUXILIARY: Rgb = Rgb(120, 120, 120);
    /// Grid lines.
    pub(crate) const GRID: Rgb = Rgb(228, 228, 228);
    /// Cells of a map that hold no number.
    pub(crate) const NOT_COMPUTED: Rgb = Rgb(205, 205, 205);

    /// The colour as `#rrggbb`.
    pub(crate) fn hex(self) -> String {
        format!("#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

/// Palette of eight colours that remain distinct for colour-blind readers, black first.
///
/// Source: M. Okabe and K. Ito, *Color universal design*, 2008. Their yellow comes last: it is weak
/// on white paper.
pub const OKABE_ITO: [Rgb; 8] = [
    Rgb(0, 0, 0),
    Rgb(0, 114, 178),
    Rgb(213, 94, 0),
    Rgb(0, 158, 115),
    Rgb(204, 121, 167),
    Rgb(230, 159, 0),
    Rgb(86, 180, 233),
    Rgb(240, 228, 66),
];

/// Colour of the best-fit frequency: the vermilion of [`OKABE_ITO`], the complement of the blues of
/// growth.
pub(crate) const BEST_FIT: Rgb = OKABE_ITO[2];

/// Colour of relative growth, from pale blue at 0 (none) to dark blue at 1 (strongest).
///
/// The lightness of the OKLab space (B. Ottosson, 2020) falls linearly with `fraction`, so equal
/// steps of growth look equal, in print without colour too. `fraction` outside 0 … 1 is clamped.
pub(crate) fn growth_color(fraction: f64) -> Rgb {
    let t = if fraction.is_finite() { fraction.clamp(0.0, 1.0) } else { 0.0 };
    let lightness = 0.955 + (0.40 - 0.955) * t;
    let chroma = 0.022 + (0.130 - 0.022) * (1.0 - (1.0 - t).powi(2));
    let hue = (225.0 + (262.0 - 225.0) * t).to_radians();
    oklab_to_srgb(lightness, chroma * hue.cos(), chroma * hue.sin())
}

/// OKLab to sRGB with the matrices of B. Ottosson, *A perceptual color space for image processing*,
/// 2020.
fn oklab_to_srgb(lightness: f64, a: f64, b: f64) -> Rgb {
    let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
    Rgb(
        srgb_channel(4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s),
        srgb_channel(-1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s),
        srgb_channel(-0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s),
    )
}

/// The transfer function of IEC 61966-2-1.
fn srgb_channel(linear: f64) -> u8 {
    let encoded = if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded.clamp(0.0, 1.0)).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance of WCAG 2, from the same transfer function read backwards.
    fn luminance(color: Rgb) -> f64 {
        let linear = |c: u8| {
            let c = f64::from(c) / 255.0;
            if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(color.0) + 0.7152 * linear(color.1) + 0.0722 * linear(color.2)
    }

    #[test]
    fn stronger_growth_is_darker() {
        let steps: Vec<f64> = (0..=20).map(|k| luminance(growth_color(f64::from(k) / 20.0))).collect();
        assert!(steps.windows(2).all(|pair| pair[1] < pair[0]), "{steps:?}");
        // Black marks on the darkest blue and dark lines on the palest must both be seen.
        assert!(steps[20] > 0.03 && steps[0] > 0.7, "{steps:?}");
    }

    #[test]
    fn oklab_white_is_srgb_white() {
        assert_eq!(oklab_to_srgb(1.0, 0.0, 0.0), Rgb::WHITE);
        assert_eq!(oklab_to_srgb(0.0, 0.0, 0.0), Rgb::BLACK);
    }
}
