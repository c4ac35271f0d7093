//! Columns and channels that tell nothing of a rail, by their names.

use riffel_keys::table::{is_one_of, words};
use riffel_keys::{Message, Value, say};

/// Track geometry, but for lines along the head of a rail.
const GEOMETRY: &str = "cant|superelevation|überhöhung|ueberhoehung|gauge|spurweite|twist|verwindung|curvature|krümmung|\
                        kruemmung|alignment|crosslevel|dévers|écartement|peralte|ancho|alabeo|sopraelevazione|scartamento|\
                        sghembo";
const LINES: &str = "corner|side|face";
/// What is measured over a chord.
const CHORD: &str = "chord|midchord|mco|versine|versines|sehne|sehnenmaß|wandersehne|pfeilhöhe|pfeilhoehe|pfeilhöhen|corde|\
                     flèche|fleche|flèches|cuerda|flecha|corda|freccia|pijl|sagitta|ordinate|midordinate";
/// Along and across the rail.
const ACROSS: &str = "longitudinal|längs|laengs|lateral|laterale|latéral|latérale|transverse|transversal|quer|längsrichtung|\
                      querrichtung|horizontal|seitlich|trasversale|lat|hor";
/// Above the springs.
const ABOVE: &str = "coach|underframe|bolster|body|carbody|wagenkasten|kasten|frame|rahmen|drehgestellrahmen|floor|wagenboden|fußboden|fussboden|\
                     boden|plancher|caisse|châssis|pavimento|cassa|telaio|suelo|bastidor|vloer|seat|sitz|cab|\
                     führerstand|gearbox|getriebe|motor";
/// Scatter, counts and limits.
const STATISTIC: &str = "std|stdev|stddev|sd|sigma|stdabw|standardabweichung|count|anzahl|quality|limit|limits|grenzwert|\
                         grenzwerte|grenzkurve|tolerance|toleranz|iso|tsi";
/// Sizes without a sign, and other numbers of many samples.
const SIZE: &str = "abs|absolute|absolutwert|betrag|absolu|absoluto|assoluto|rectified|gleichgerichtet|rms|rmq|effektivwert|\
                    effektiv|efficace|eficaz|envelope|env|hüllkurve|huellkurve|enveloppe|envolvente|inviluppo|peak|peaks|\
                    spitze|spitzenwert|p2p|crest|kurtosis|power|psd|energy|energie|squared|quadrat|magnitude|max|maximum|minimum";
/// Means and differences of several columns.
const OF_SEVERAL: &str = "mean|average|avg|mittel|mittelwert|moyenne|media|diff|difference|differenz|sum|summe|delta";
/// Derivatives.
const DERIVATIVE: &str = "derivative|slope|gradient|jerk|ableitung|steigung|ruck|dérivée|pente|derivada|pendiente|derivata|\
                          pendenza";
/// Beginnings of words for what a filter leaves.
const FILTERED: [&str; 33] = [
    "filt",
    "gefilt",
    "bandp",
    "lowp",
    "highp",
    "tiefp",
    "hochp",
    "passe",
    "passa",
    "paso",
    "smooth",
    "gegl",
    "glätt",
    "liss",
    "alisad",
    "detrend",
    "trendber",
    "butter",
    "moving",
    "gleitend",
    "demean",
    "mittelwertfrei",
    "integrat",
    "derived",
    "derivat",
    "comput",
    "gliss",
    "mobil",
    "móvil",
    "movil",
    "glijd",
    "voortschr",
    "running",
];
/// Whole words for it.
const FILTERS: &str = "bp|lp|hp|bpf|lpf|hpf|band|berechnet|calc|calculated|abgeleitet|calculé|calculado|calcolato";

/// Words for what no filter has touched.
const RAW: &str = "unfiltered|raw|roh|ungefiltert|brut|grezzo|crudo";

/// Why each of some columns, whose names are given, tells nothing of a rail; None for one that does.
///
/// Left out are track geometry, chord offsets, what is felt along or across the rail or above the springs, statistics, and
/// sizes without a sign; x and y beside a z; means and differences beside other columns; and what a filter leaves beside the
/// column that it was made of.
pub(crate) fn why_no_rail(names: &[&str]) -> Vec<Option<Message>> {
    let all: Vec<Name> = names.iter().map(|name| Name::of(name)).collect();
    let by_itself: Vec<Option<Message>> = all.iter().map(|name| name.by_itself(&all)).collect();
    let originals: Vec<&Name> = all
        .iter()
        .zip(&by_itself)
        .filter(|(name, why)| why.is_none() && !name.has(OF_SEVERAL) && !name.is_filtered())
        .map(|(name, _)| name)
        .collect();
    let computed = |name: &Name| {
        name.has(OF_SEVERAL) && !originals.is_empty()
            || name.is_filtered() && originals.iter().any(|other| name.is_made_of(other))
    };
    all.iter().zip(by_itself).map(|(name, why)| why.or_else(|| computed(name).then(|| say!(it_is_computed)))).collect()
}

/// What a level of a column that is called `name` does not tell, where a filter has touched it; `column` are the words for it.
pub(crate) fn filter_remark(name: &str, column: Value) -> Option<Message> {
    let is_filtered = Name::of(name).is_filtered();
    is_filtered.then(|| say!(column_is_filtered, column))
}

/// Whether the words of a name are those of a scatter, a count or a limit.
pub(crate) fn is_statistic(name: &[String]) -> bool {
    let is_norm = |pair: &[String]| is_one_of(&pair[0], "en|din") && pair[1].starts_with(|c: char| c.is_ascii_digit());
    name.iter().any(|word| is_one_of(word, STATISTIC)) || name.windows(2).any(is_norm)
}

fn is_filter(word: &str) -> bool {
    is_one_of(word, FILTERS) || FILTERED.iter().any(|begin| word.starts_with(begin))
}

/// The words of a name without its axis, x, y or z, and its axis.
struct Name {
    words: Vec<String>,
    axis: Option<String>,
}

impl Name {
    fn of(name: &str) -> Self {
        let mut words = words(name);
        let axis = words.iter().position(|word| is_one_of(word, "x|y|z"));
        let axis = axis.map(|place| words.remove(place));
        Self { words, axis }
    }

    /// Whether one of the words is in a list; a word of more than four letters may go on.
    fn has(&self, known: &str) -> bool {
        let is = |own: &String, word: &str| own == word || word.len() > 4 && own.starts_with(word);
        let mut own = self.words.iter();
        own.any(|own| known.split('|').any(|word| is(own, word)))
    }

    fn is_filtered(&self) -> bool {
        self.words.iter().any(|word| is_filter(word))
    }

    /// Whether a filtered column can be made of another: the name of either has all words of the other but those of the filter.
    fn is_made_of(&self, other: &Self) -> bool {
        let has_all = |name: &Self, of: &Self| {
            let mut words = of.words.iter();
            words.all(|word| is_filter(word) || is_one_of(word, RAW) || name.words.contains(word))
        };
        self.axis == other.axis && (has_all(self, other) || has_all(other, self))
    }

    /// Why the column is none of a rail whatever stands beside it, but for the other axes.
    fn by_itself(&self, all: &[Self]) -> Option<Message> {
        let is_vertical = |other: &Self| other.axis.as_deref() == Some("z");
        let is_other_axis = matches!(self.axis.as_deref(), Some("x" | "y"))
            && all.iter().any(|other| is_vertical(other) && other.words == self.words);
        if self.has(CHORD) {
            Some(say!(it_is_a_chord_offset))
        } else if self.has(GEOMETRY) && !self.has(LINES) {
            Some(say!(it_is_geometry))
        } else if self.has(ACROSS) || is_other_axis {
            Some(say!(it_is_across))
        } else if self.has(ABOVE) {
            Some(say!(it_is_above_springs))
        } else if is_statistic(&self.words) {
            Some(say!(it_is_a_statistic))
        } else if self.has(SIZE) {
            Some(say!(it_is_a_size))
        } else if self.has(DERIVATIVE) {
            Some(say!(it_is_computed))
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of each line, the names before the bar are rails and those behind it are none.
    #[test]
    fn only_what_a_rail_is_felt_or_measured_by_is_kept() {
        for (rails, others) in [
            ("left_um,right_um", "left_rms_um,mean_um,right_filtered_um"),
            ("left_um,right_filtered_um", "cant_mm,versine left [mm],sagitta_um,mid-ordinate [um]"),
            ("z_filtered_um", "chord offset 200 mm [um],Pfeilhöhe rechts [mm]"),
            ("gauge corner left [mm],left [mm]", "gauge [mm],lateral left [mm],twist3m"),
            ("acc_z_g,acc left y [g]", "acc_x_g,acc_y_g,acc_z_bandpass_30_300_Hz_g,acc_z_abs_g"),
            (
                "acceleration_axlebox_left_m_per_s2",
                "acceleration_wagon_floor_m_per_s2,acceleration_left_lowpass_m_per_s2",
            ),
            (
                "Beschleunigung links [m/s²],acc bogie 1 left [g]",
                "Beschleunigung quer [m/s²],Beschleunigung links gefiltert [m/s²],Effektivwert links [m/s²],\
                 acc bogie frame left [g],acc car body [g],Hüllkurve links [g]",
            ),
            ("accélération gauche [m/s²]", "accélération gauche efficace [m/s²],plancher [m/s²]"),
            ("aceleración izquierda [m/s²]", "aceleración izquierda (valor absoluto) [m/s²]"),
            (
                "gauche [um],sinistra [um],linkerspoorstaaf [um]",
                "gauche glissant 1m [um],sinistra media mobile [um],linkerspoorstaaf voortschrijdend [um],sinistra running [um]",
            ),
            ("left unfiltered [g]", "left filt. [g],left HP 10 Hz [g],left envelope [g],left peak [g]"),
            // What is all computed is there all the same, but sizes never are.
            ("left mean um,right mean um", "left RMS um"),
        ] {
            let names: Vec<&str> = rails.split(',').chain(others.split(',')).collect();
            let kept: Vec<&str> =
                names.iter().zip(why_no_rail(&names)).filter(|(_, why)| why.is_none()).map(|(name, _)| *name).collect();
            assert_eq!(kept.join(","), rails);
        }
    }
}
