//! The words of a map itself, for who draws it in another language.

/// What axes and legend of a map say.
#[derive(Debug, Clone, PartialEq)]
pub struct MapWords {
    /// The axis of wavelengths \[mm\].
    pub wavelength: String,
    /// The axis of speeds on the left \[km/h\].
    pub speed_km_per_h: String,
    /// Axis of speeds on the right \[m/s\].
    pub speed_m_per_s: String,
    /// Marks of the ridge.
    pub ridge: String,
    /// Marks of the ridge at the edge of the window.
    pub ridge_at_edge: String,
    /// The ray of the strongest branch.
    pub best_fit_ray: String,
    /// Lines of branches.
    pub branches: String,
    /// The other rays.
    pub rays: String,
    /// The contour of zero.
    pub zero: String,
    /// What has no value.
    pub not_computed: String,
}

impl Default for MapWords {
    /// In English.
    fn default() -> Self {
        let words = |words: &str| words.to_owned();
        Self {
            wavelength: words("wavelength λ [mm]"),
            speed_km_per_h: words("speed V [km/h]"),
            speed_m_per_s: words("speed V [m/s]"),
            ridge: words("strongest growth at each speed"),
            ridge_at_edge: words("strongest at the edge of the window"),
            best_fit_ray: words("constant frequency of the strongest branch"),
            branches: words("branches of growth"),
            rays: words("constant frequency V = fλ"),
            zero: words("neither growth nor decay"),
            not_computed: words("not computed"),
        }
    }
}
