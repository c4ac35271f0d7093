//! Every sentence that Riffel says in more than one language, with a place for each value.

use std::fmt::{Display, Write};

use crate::Language;

/// A sentence in every language.
struct Wording {
    english: &'static str,
    german: &'static str,
    /// The English one for a terminal, where it is longer than a line.
    short: Option<&'static str>,
}

/// Declares the sentences: names in braces are the places of values.
macro_rules! sentences {
    ($($name:ident { en: $en:literal, de: $de:literal $(, short: $short:literal)? })*) => {
        /// A sentence, or a part of one, that is said in more than one language.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[allow(missing_docs)] // Each is what it says.
        pub enum Sentence {
            $($name,)*
        }

        impl Sentence {
            /// All of them.
            const ALL: &[Self] = &[$(Self::$name,)*];

            fn wording(self) -> Wording {
                match self {
                    $(Self::$name => {
                        #[allow(unused_mut, unused_assignments)]
                        let mut short = None;
                        $(short = Some($short);)?
                        Wording { english: $en, german: $de, short }
                    })*
                }
            }
        }
    };
}

sentences! {
    // Windows, values and presets.
    MapWindow {
        en: "map",
        de: "Karte"
    }
    TrafficWindow {
        en: "traffic",
        de: "Verkehr"
    }
    UnusualValue {
        en: "{key} is {value}; usual values are {from} to {to}{question}",
        de: "{key} ist {value}; üblich sind {from} bis {to}{question}"
    }
    NumberWithoutUnit {
        en: "{key} has no unit and is read as {read}{question}",
        de: "{key} hat keine Einheit und wird als {read} gelesen{question}"
    }
    PresetChangesNothing {
        en: "{key} = \"{name}\" changes nothing: the case gives all of its values itself",
        de: "{key} = \"{name}\" ändert nichts: der Fall gibt alle Werte selbst vor"
    }
    // Measured receptances.
    ValueAtZeroLeftOut {
        en: "the measured value at 0 Hz is left out",
        de: "der gemessene Wert bei 0 Hz bleibt weg"
    }
    SetConjugate {
        en: "set track.measurement.conjugate",
        de: "track.measurement.conjugate setzen"
    }
    ConjugateIt {
        en: "conjugate it",
        de: "konjugieren"
    }
    ReceptanceGivesEnergy {
        en: "the measured receptance gives energy away (Im H > 0) at {count} of {points} frequencies, between {first} and {last} Hz: check its phase, its noise, and whether it follows exp(+iωt) (else {remedy})",
        de: "die gemessene Rezeptanz gibt Energie ab (Im H > 0), bei {count} von {points} Frequenzen zwischen {first} und {last} Hz: Phase und Rauschen prüfen, und ob sie exp(+iωt) folgt (sonst {remedy})",
        short: "the measured receptance gives energy away (Im H > 0) at {count} of {points} frequencies: check its phase"
    }
    ColumnWithoutUnit {
        en: "column `{column}` names no unit: taken as a receptance in m/N (else set track.measurement.quantity and unit)",
        de: "Spalte `{column}` nennt keine Einheit: als Rezeptanz in m/N gelesen (sonst track.measurement.quantity und unit setzen)"
    }
    ReceptanceUnlikeRail {
        en: "the measured receptance is {least} to {most} m/N, but rails have 1e-11 to 1e-7 m/N: check track.measurement.quantity and unit",
        de: "die gemessene Rezeptanz liegt bei {least} bis {most} m/N, Schienen haben 1e-11 bis 1e-7 m/N: track.measurement.quantity und unit prüfen"
    }
    PoorCoherence {
        en: "the coherence is below {good} at {count} of {points} frequencies, between {first} and {last} Hz: there the receptance is the mean of the lines within 1/24 octave, weighted by γ²/(1 − γ²)",
        de: "die Kohärenz liegt bei {count} von {points} Frequenzen zwischen {first} und {last} Hz unter {good}: dort gilt das Mittel der Linien im Umkreis von 1/24 Oktave, gewichtet mit γ²/(1 − γ²)"
    }
    ResponseAtOtherNode {
        en: "the measured response is at node {response} and its force at node {reference}: it is taken as the receptance at the contact",
        de: "gemessen ist die Antwort am Knoten {response} auf eine Kraft am Knoten {reference}: sie gilt als Rezeptanz am Kontakt"
    }
    // Ranges of validity.
    RailWithoutSupport {
        en: "the rail has no support: below about {free_beam_from_hz} Hz (lowest of the {window}: {lowest} Hz) pads, sleepers and ballast change its receptance",
        de: "die Schiene liegt nirgends auf: unter etwa {free_beam_from_hz} Hz ({window}: ab {lowest} Hz) ändern Zwischenlagen, Schwellen und Schotter ihre Rezeptanz",
        short: "the rail has no support: wrong below about {free_beam_from_hz} Hz ({window} from {lowest} Hz)"
    }
    RailWithoutShear {
        en: "the rail bends without shear: its receptance is some 9° off at {euler_beam_up_to_hz} Hz, 24° and 14 % at 1500 Hz (highest of the {window}: {highest} Hz)",
        de: "die Schiene biegt sich ohne Schub: ihre Rezeptanz weicht bei {euler_beam_up_to_hz} Hz um etwa 9° ab, bei 1500 Hz um 24° und 14 % ({window}: bis {highest} Hz)",
        short: "the rail bends without shear: 24° and 14 % off at 1500 Hz ({window} to {highest} Hz)"
    }
    PinnedPinnedWithoutShear {
        en: "the rail bends without shear: its pinned-pinned frequency is overstated by 20 to 35 % or more and not named (choose rail.beam = \"timoshenko\")",
        de: "die Schiene biegt sich ohne Schub: ihre Pinned-pinned-Frequenz ist um 20 bis 35 % oder mehr zu hoch und wird nicht genannt (rail.beam = \"timoshenko\" wählen)",
        short: "the rail bends without shear: its pinned-pinned frequency is too high and not named"
    }
    SupportsSpreadEvenly {
        en: "supports are spread evenly along the rail: the pinned-pinned resonance near {pinned} Hz is missing, and below it the receptance is 10 to 50 % off, more on very stiff pads (highest of the {window}: {highest} Hz; choose a model that ends in -periodic)",
        de: "die Stützpunkte sind gleichmäßig über die Schiene verteilt: die Pinned-pinned-Resonanz nahe {pinned} Hz fehlt, und darunter weicht die Rezeptanz um 10 bis 50 % ab, auf sehr steifen Zwischenlagen um mehr ({window}: bis {highest} Hz; ein Modell wählen, das auf -periodic endet)",
        short: "supports are spread evenly: no pinned-pinned resonance near {pinned} Hz ({window} to {highest} Hz)"
    }
    NoAverageOverPatch {
        en: "the contact is quasi-static and does not average over its patch: below {shortest} mm growth is overstated",
        de: "der Kontakt ist quasistatisch und mittelt nicht über seine Fläche: unter {shortest} mm ist das Wachstum zu hoch",
        short: "the contact does not average over its patch: growth is overstated below {shortest} mm"
    }
    ClosedFormOfEllipse {
        en: "the radii of wheel and rail differ much: the closed form of the contact ellipse is {percent} % off across the rail (choose contact.hertz = \"exact\")",
        de: "die Radien von Rad und Schiene sind sehr verschieden: die geschlossene Formel der Kontaktellipse weicht quer zur Schiene um {percent} % ab (contact.hertz = \"exact\" wählen)",
        short: "the closed form of the contact ellipse is {percent} % off (contact.hertz = \"exact\" is not)"
    }
    FallingFrictionAtOneSpeed {
        en: "falling friction is that of the slip at {rolling}, contact.polach.speed, at every speed of the {window}",
        de: "die fallende Reibung ist die beim Schlupf bei {rolling}, contact.polach.speed, bei jeder Geschwindigkeit ({window})",
        short: "falling friction is that at {rolling} at every speed of the {window}"
    }
    WheelAndRailPart {
        en: "an amplitude of {amplitude} µm makes |P₁/P₀| reach {worst}: wheel and rail part; forces are linear up to {limit} µm (growth rates hold for small amplitudes and do not change)",
        de: "bei einer Amplitude von {amplitude} µm erreicht |P₁/P₀| {worst}: Rad und Schiene trennen sich; Kräfte sind bis {limit} µm linear (Wachstumsraten gelten für kleine Amplituden und ändern sich nicht)",
        short: "{amplitude} µm make wheel and rail part (|P₁/P₀| = {worst}); forces are linear up to {limit} µm"
    }
    // Branches of the ridge.
    AtEdgeOfWindow {
        en: ", at the edge of the window",
        de: ", am Rand des Fensters"
    }
    NothingGrows {
        en: "nothing grows in this window",
        de: "in diesem Fenster wächst nichts"
    }
    AndBetween {
        en: " and ",
        de: " und "
    }
    NoCrest {
        en: "no crest lies in this window: growth rises towards {ends} mm",
        de: "in diesem Fenster liegt kein Kamm: das Wachstum steigt bis {ends} mm"
    }
    OneBranch {
        en: "the ridge is one branch, which grows at {words}",
        de: "der Grat ist ein einziger Ast, der bei {words} wächst"
    }
    BranchWithShare {
        en: "{words} with {share} of its growth",
        de: "{words} mit {share} seines Wachstums"
    }
    MoreBranches {
        en: "{count} more",
        de: "{count} weitere"
    }
    OneWeakerBranch {
        en: "1 weaker branch",
        de: "1 schwächerer Ast"
    }
    WeakerBranches {
        en: "{count} weaker branches",
        de: "{count} schwächere Äste"
    }
    StrongestBranch {
        en: "the strongest branch grows at {words}; {noun}: {named}",
        de: "der stärkste Ast wächst bei {words}; {noun}: {named}"
    }
    // Mechanisms.
    MechanismP2 {
        en: "P2 resonance",
        de: "P2-Resonanz"
    }
    MechanismWheelsetTorsion {
        en: "wheelset torsion",
        de: "Torsion des Radsatzes"
    }
    MechanismWheelsetBending {
        en: "wheelset bending",
        de: "Biegung des Radsatzes"
    }
    MechanismFullTrack {
        en: "full-track resonance",
        de: "Resonanz des ganzen Gleises"
    }
    MechanismSleeperAntiresonance {
        en: "sleeper antiresonance",
        de: "Antiresonanz der Schwelle"
    }
    MechanismRailOnPad {
        en: "rail on pad",
        de: "Schiene auf Zwischenlage"
    }
    MechanismPinnedPinned {
        en: "pinned-pinned, vertical",
        de: "Pinned-Pinned, vertikal"
    }
    MechanismMeasuredPeak {
        en: "peak of the measured receptance",
        de: "Spitze der gemessenen Rezeptanz"
    }
    MechanismMeasuredDip {
        en: "dip of the measured receptance",
        de: "Senke der gemessenen Rezeptanz"
    }
    MechanismGivenPeak {
        en: "peak of the given receptance",
        de: "Spitze der gegebenen Rezeptanz"
    }
    MechanismGivenDip {
        en: "dip of the given receptance",
        de: "Senke der gegebenen Rezeptanz"
    }
    // Captions: the track.
    RailWord {
        en: "rail",
        de: "Schiene"
    }
    UnderMovingLoad {
        en: " under a moving load",
        de: " unter wandernder Last"
    }
    ReceptanceFromFile {
        en: "receptance read from {file}",
        de: "Rezeptanz aus {file}"
    }
    FreeBeam {
        en: "free {beam} beam{moving}",
        de: "freier {beam}-Balken{moving}"
    }
    RailOnPads {
        en: "{beam} rail{moving} on pads ({pad})",
        de: "{beam}-Schiene{moving} auf Zwischenlagen ({pad})"
    }
    SleepersAndBallast {
        en: ", sleepers ({mass} kg) and ballast ({ballast})",
        de: ", Schwellen ({mass} kg) und Schotter ({ballast})"
    }
    Spacing {
        en: " every {spacing} m, ",
        de: " alle {spacing} m, "
    }
    Discrete {
        en: "discrete",
        de: "diskret"
    }
    SpreadEvenly {
        en: "spread evenly",
        de: "gleichmäßig verteilt"
    }
    FromPreset {
        en: ", preset {name}",
        de: ", Vorgabe {name}"
    }
    // Captions: the case.
    Track {
        en: "Track",
        de: "Gleis"
    }
    ConstantTangentialForce {
        en: "constant tangential force (I_w → 0)",
        de: "konstante Tangentialkraft (I_w → 0)"
    }
    ConstantCreepage {
        en: "constant creepage (I_w → ∞)",
        de: "konstanter Schlupf (I_w → ∞)"
    }
    Wheelset {
        en: "wheelset",
        de: "Radsatz"
    }
    NonSteadyContact {
        en: "non-steady contact",
        de: "instationärer Kontakt"
    }
    PhaseLag {
        en: "dissipation phase: lag",
        de: "Phase der Dissipation: lag"
    }
    PhaseLead {
        en: "dissipation phase: lead",
        de: "Phase der Dissipation: lead"
    }
    PhaseNone {
        en: "dissipation phase: none",
        de: "Phase der Dissipation: none"
    }
    CreepLaw {
        en: "creep law",
        de: "Kraftschlussgesetz"
    }
    SpringAndDashpot {
        en: "spring and dashpot; ",
        de: "Feder und Dämpfer; "
    }
    SignOfGrowth {
        en: "Corrugation grows where Re Ŵ₁ < 0 (coloured): the dissipation is in antiphase with the profile; time factor exp(+iωt), braking positive.",
        de: "Riffeln wachsen, wo Re Ŵ₁ < 0 (farbig): die Dissipation ist in Gegenphase zum Profil; Zeitfaktor exp(+iωt), Bremsen positiv."
    }
    // Figures of the paper.
    Figure4 {
        en: "Figure 4. Real part of the dissipation, free Euler beam",
        de: "Bild 4. Realteil der Dissipation, freier Euler-Balken"
    }
    Figure5 {
        en: "Figure 5. Real part of the dissipation, track of Bhaskar et al.",
        de: "Bild 5. Realteil der Dissipation, Gleis von Bhaskar et al."
    }
    ParametersOf {
        en: "Parameters of ({letter}): {parameters} {sign}",
        de: "Werte von ({letter}): {parameters} {sign}"
    }
    PlusSpringAndDashpot {
        en: ", spring and dashpot",
        de: ", Feder und Dämpfer"
    }
    PlusNonSteady {
        en: ", non-steady contact",
        de: ", instationärer Kontakt"
    }
    SpeedAxis {
        en: "speed V [m/s]",
        de: "Geschwindigkeit V [m/s]"
    }
    MinimaOverWavelengths {
        en: "Minima over wavelengths of 20–80 mm.",
        de: "Minima über Wellenlängen von 20–80 mm."
    }
    Figure6 {
        en: "Figure 6. Highest growth over speed",
        de: "Bild 6. Höchstes Wachstum über der Geschwindigkeit"
    }
    MinimaInsideWindow {
        en: "Minima over wavelengths of 20–80 mm; (b) leaves out minima at the edge of the window.",
        de: "Minima über Wellenlängen von 20–80 mm; (b) lässt Minima am Rand des Fensters weg."
    }
    PanelOfTractiveRatio {
        en: "(a) tractive ratio",
        de: "(a) Kraftschlussausnutzung"
    }
    PanelOfInertia {
        en: "(b) inertia, τ = 0.1",
        de: "(b) Trägheit, τ = 0.1"
    }
    WavelengthAxis {
        en: "wavelength λ [mm]",
        de: "Wellenlänge λ [mm]"
    }
    Figure7 {
        en: "Figure 7. Highest growth over speed for different inertia",
        de: "Bild 7. Höchstes Wachstum über der Geschwindigkeit bei verschiedener Trägheit"
    }
    Figure8 {
        en: "Figure 8. Highest growth at {speed} m/s",
        de: "Bild 8. Höchstes Wachstum bei {speed} m/s"
    }
    FallsInPart {
        en: "(a) falls up to τ ≈ 0.9 only. ",
        de: "(a) fällt nur bis τ ≈ 0.9. "
    }
    TractiveRatioAxis {
        en: "tractive ratio τ [-]",
        de: "Kraftschlussausnutzung τ [-]"
    }
    InertiaAxis {
        en: "inertia I_w [kg m²]",
        de: "Trägheit I_w [kg m²]"
    }
    FrequencyAxis {
        en: "frequency f [Hz]",
        de: "Frequenz f [Hz]"
    }
    BeamUnderMovingLoad {
        en: "beam under a moving load",
        de: "Balken unter wandernder Last"
    }
    TrackOfBhaskar {
        en: "track of Bhaskar et al. (inferred)",
        de: "Gleis von Bhaskar et al. (erschlossen)"
    }
    Figure2 {
        en: "Figure 2. Vertical direct receptance",
        de: "Bild 2. Vertikale Eingangsrezeptanz"
    }
    CaptionOfFigure2 {
        en: "Load at {speed} m/s, exp(+iωt), displacement and force downward. Solid: {solid}. Dashed: {dashed}.",
        de: "Last mit {speed} m/s, exp(+iωt), Weg und Kraft nach unten. Durchgezogen: {solid}. Gestrichelt: {dashed}."
    }
    Modulus {
        en: "modulus",
        de: "Betrag"
    }
    Phase {
        en: "phase",
        de: "Phase"
    }
    Figure3 {
        en: "Figure 3. Normal force",
        de: "Bild 3. Normalkraft"
    }
    CaptionOfFigure3 {
        en: "V = {speed} m/s, equation (24). {parameters}",
        de: "V = {speed} m/s, Gleichung (24). {parameters}"
    }
    Amplitude {
        en: "amplitude",
        de: "Amplitude"
    }
    ProfileOverRail {
        en: "Δ/H rail",
        de: "Δ/H Schiene"
    }
    ProfileOverWheel {
        en: "Δ/H wheel",
        de: "Δ/H Rad"
    }
}

impl Language {
    /// A sentence without values.
    pub fn say(self, sentence: Sentence) -> &'static str {
        let Wording {
            english, german, ..
        } = sentence.wording();
        self.pick(english, german)
    }

    /// A sentence with its values, each by its name.
    pub fn fill(self, sentence: Sentence, values: &[(&str, &dyn Display)]) -> String {
        fill(self.say(sentence), values)
    }
}

impl Sentence {
    /// The English and the German wording of all sentences, with names in braces in the place of values.
    pub fn wordings() -> impl Iterator<Item = (&'static str, &'static str)> {
        Self::ALL.iter().map(|sentence| {
            let Wording {
                english, german, ..
            } = sentence.wording();
            (english, german)
        })
    }

    /// The English sentence in one line, with its values; none where it is short itself.
    pub(crate) fn in_short(self, values: &[(&str, &dyn Display)]) -> Option<String> {
        self.wording().short.map(|short| fill(short, values))
    }
}

/// A wording with values in the place of their names. A name without a value stays, in braces, for the reader to report.
fn fill(wording: &str, values: &[(&str, &dyn Display)]) -> String {
    let mut filled = String::with_capacity(wording.len());
    let mut rest = wording;
    while let Some((before, after)) = rest.split_once('{') {
        filled.push_str(before);
        let Some((name, after)) = after.split_once('}') else {
            break;
        };
        let value = values.iter().find(|value| value.0 == name);
        debug_assert!(value.is_some(), "{name} of \"{wording}\" has no value");
        match value {
            // Writing to a string does not fail.
            Some((_, value)) => {
                let _ = write!(filled, "{value}");
            }
            None => filled.push_str(&format!("{{{name}}}")),
        }
        rest = after;
    }
    filled.push_str(rest);
    filled
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    fn names(wording: &str) -> BTreeSet<&str> {
        let after = wording.split('{').skip(1);
        after
            .map(|after| after.split_once('}').expect("a closing brace").0)
            .collect()
    }

    /// No sentence is empty, lacks a value or is left untranslated in one of the languages; its short wording is shorter
    /// and has no value of its own.
    #[test]
    fn languages_have_no_gaps() {
        for &sentence in Sentence::ALL {
            let Wording {
                english,
                german,
                short,
            } = sentence.wording();
            assert!(!english.is_empty() && !german.is_empty(), "{sentence:?}");
            assert_eq!(names(english), names(german), "{sentence:?}");
            assert_ne!(english, german, "{sentence:?}");
            if let Some(short) = short {
                assert!(
                    !short.is_empty() && short.len() < english.len(),
                    "{sentence:?}"
                );
                assert!(names(short).is_subset(&names(english)), "{sentence:?}");
            }
            let white = |text: &str| (text.starts_with(' '), text.ends_with(' '));
            assert_eq!(white(english), white(german), "{sentence:?}");
        }
    }

    #[test]
    fn values_stand_at_their_names() {
        let words = |language: Language| {
            language.fill(
                Sentence::BranchWithShare,
                &[("share", &"9 %"), ("words", &"327 Hz")],
            )
        };
        assert_eq!(words(Language::English), "327 Hz with 9 % of its growth");
        assert_eq!(words(Language::German), "327 Hz mit 9 % seines Wachstums");
    }
}
