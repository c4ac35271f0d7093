//! The classes of corrugation of Grassie & Kalousek (1993) and Grassie (2009): where the case file of each grows, beside
//! what is published.
//!
//! What the papers say is quoted after what could be read: Afferrante & Ciavarella (2009), abstracts, the page of a
//! maker of instruments. Wavelengths that are commonly cited for a class and could not be read at their source are
//! said to be so.

use std::f64::consts::TAU;

use riffel::Ridge;
use riffel::growth::RidgeBranch;
use riffel::receptance::ResonanceKind;
use riffel::wheelset::{DiscMotion, ModeName};
use riffel_case::{Case, ask};

use crate::Row;

/// A case file and the branches of its ridge, the strongest first.
struct Class {
    case: Case,
    ridge: Ridge,
}

impl Class {
    fn of(text: &str) -> Self {
        let case = Case::parse("class.toml", text, &[]).expect("a case of the repository");
        let ridge = Ridge::search(&case.feedback, case.wavelength, case.speed);
        Self { case, ridge }
    }

    fn strongest(&self) -> &RidgeBranch {
        self.ridge.branches.first().expect("a line of growth")
    }

    /// Frequency \[Hz\] of a resonance of track and wheel.
    fn resonance(&self, kind: ResonanceKind) -> f64 {
        let resonances = ask::resonances(&self.case);
        let found = resonances.iter().find(|found| found.kind == kind);
        found.map_or(f64::NAN, |found| found.angular_frequency / TAU)
    }

    /// Shortest and longest wavelength \[mm\] that a frequency \[Hz\] makes at the speeds of the case.
    fn wavelengths(&self, frequency: f64) -> [f64; 2] {
        [self.case.speed.min(), self.case.speed.max()].map(|speed| 1e3 * speed / frequency)
    }
}

/// Wavelengths of a branch inside the window \[mm\].
fn wavelengths(branch: &RidgeBranch) -> [f64; 2] {
    let (shortest, longest) = branch.wavelengths();
    [1e3 * shortest, 1e3 * longest]
}

fn overlap(one: [f64; 2], other: [f64; 2]) -> bool {
    one[0] <= other[1] && other[0] <= one[1]
}

fn near(one: f64, other: f64, share: f64) -> bool {
    (one / other - 1.0).abs() <= share
}

pub(crate) fn class_of_roaring_rails() -> Row {
    let class = Class::of(include_str!("../cases/class-roaring-rails.toml"));
    let branch = class.strongest();
    let (frequency, [from, to]) = (branch.frequency(), wavelengths(branch));
    let pinned = class.resonance(ResonanceKind::PinnedPinned);
    Row {
        statement: "Class of roaring rails, under constant tangential force, 100–250 km/h: highest growth at the pinned-pinned mode",
        source: "Grassie & Kalousek (1993), Grassie & Edwards (2008), both as quoted by Afferrante & Ciavarella (2009)",
        expected: "around 1000 Hz, 20–80 mm".to_owned(),
        got: format!("{frequency:.0} Hz beside the mode at {pinned:.0} Hz, {from:.0}–{to:.0} mm"),
        tolerance: "10 %: \"around\", and growth stands some per cent beside the resonance. With the inertia of the wheel nothing grows there",
        holds: !branch.only_at_edge()
            && near(frequency, 1000.0, 0.1)
            && near(frequency, pinned, 0.1)
            && overlap([from, to], [20.0, 80.0]),
    }
}

pub(crate) fn class_of_rutting() -> Row {
    let class = Class::of(include_str!("../cases/class-rutting.toml"));
    let wheelset = class.case.wheelset.as_ref().expect("a wheelset");
    let modes = ask::wheelset_modes(&class.case, wheelset, 400.0);
    let modes = modes.expect("below shear across the thickness");
    // The lowest mode of torsion is that of the rotor on its coupling, which a wheel does not feel.
    let torsion = |against: bool| {
        let mut modes = modes.iter().filter(|mode| match mode.name {
            ModeName::Torsion { discs: None, .. } => !against,
            ModeName::Torsion { order, discs: Some(DiscMotion::AgainstWheels) } => against && order > 1,
            _ => false,
        });
        modes.next().map_or(f64::NAN, |mode| mode.frequency)
    };
    let natural = [torsion(false), torsion(true)];
    let branches = natural.map(|natural| {
        let mut branches = class.ridge.branches.iter();
        branches.find(|branch| near(branch.frequency(), natural, 0.02))
    });
    let [first, second] = branches.map(|branch| branch.map_or(f64::NAN, |branch| branch.frequency()));
    let [from, to] = branches[1].map_or([f64::NAN; 2], wavelengths);
    Row {
        statement: "Class of rutting, driven wheelset that slides along the low rail, 25–60 km/h: growth at both its torsional modes, most at the first",
        source: "Tassilly & Vincent (1991), first torsion; Elkins et al. (1998), second; both as quoted by Afferrante & Ciavarella (2009)",
        expected: "the first; the second near 300 Hz on their wheelsets".to_owned(),
        got: format!(
            "{first:.0} Hz, wheels against each other ({:.0} Hz); {second:.0} Hz, gear against wheels ({:.0} Hz), {from:.0}–{to:.0} mm",
            natural[0], natural[1]
        ),
        tolerance: "2 % of the mode: growth stands beside it. The frequency of the second hangs on gear and motor; those of this preset are chosen, and lower than theirs",
        holds: near(first, natural[0], 0.02)
            && near(second, natural[1], 0.02)
            && near(class.strongest().frequency(), first, 1e-12),
    }
}

pub(crate) fn class_of_contact_fatigue() -> Row {
    let class = Class::of(include_str!("../cases/class-contact-fatigue.toml"));
    let branch = class.strongest();
    let (frequency, [from, to]) = (branch.frequency(), wavelengths(branch));
    let p2 = class.resonance(ResonanceKind::P2);
    Row {
        statement: "Class of P2 corrugation by wear or contact fatigue, metro, 30–90 km/h: highest growth at P2",
        source: "Grassie & Edwards (2008), as quoted by Afferrante & Ciavarella (2009); wavelengths as commonly cited",
        expected: "50–100 Hz; 150–450 mm".to_owned(),
        got: format!("{frequency:.0} Hz beside P2 at {p2:.0} Hz, {from:.0}–{to:.0} mm"),
        tolerance: "the band; 10 % of P2: growth stands some per cent beside the resonance",
        holds: !branch.only_at_edge()
            && (50.0..=100.0).contains(&frequency)
            && near(frequency, p2, 0.1)
            && overlap([from, to], [150.0, 450.0]),
    }
}

pub(crate) fn class_of_booted_sleepers() -> Row {
    let class = Class::of(include_str!("../cases/class-booted-sleeper.toml"));
    let branch = class.strongest();
    let (frequency, [from, to]) = (branch.frequency(), wavelengths(branch));
    let support = class.case.track.support.expect("supports");
    let block = support.sleeper_antiresonance().unwrap_or(f64::NAN) / TAU;
    Row {
        statement: "Class of a trackform's own resonance, booted sleeper, 40–80 km/h: highest growth where the block holds the rail",
        source: "low rail of a metro curve, railmeasurement.com, trackform-specific corrugation; no frequency given",
        expected: "its own resonance; 30–100 mm".to_owned(),
        got: format!("{frequency:.0} Hz beside the block on boot and pad at {block:.0} Hz, {from:.0}–{to:.0} mm"),
        tolerance: "10 %: growth stands some per cent beside the resonance; the bands overlap, boot and pad are chosen",
        holds: !branch.only_at_edge() && near(frequency, block, 0.1) && overlap([from, to], [30.0, 100.0]),
    }
}

pub(crate) fn class_of_soft_slabs() -> Row {
    let class = Class::of(include_str!("../cases/class-soft-slab.toml"));
    let branch = class.strongest();
    let (frequency, [from, to]) = (branch.frequency(), wavelengths(branch));
    let far_from_p2 = class.resonance(ResonanceKind::P2) < 0.5 * frequency;
    Row {
        statement: "Class of a trackform's own, fastenings below 20 MN/m, metro, 50–90 km/h: growth far from P2",
        source: "abstract of TRID 01885638 (2023), measured on metro lines with resilient fasteners",
        expected: "340–700 Hz, 30–60 mm".to_owned(),
        got: format!("{frequency:.0} Hz, {from:.0}–{to:.0} mm"),
        tolerance: "the bands; the rail is nearly free here, and the line is that of the paper, of no resonance of the track",
        holds: !branch.only_at_edge()
            && (340.0..=700.0).contains(&frequency)
            && from >= 30.0
            && to <= 60.0
            && far_from_p2,
    }
}

/// A class whose damage is no wear: its P2, and the branch of its ridge by that damage that lies nearest, with the growth that it
/// has of the fastest.
fn by_damage(text: &str, settings: &[&str], published: [f64; 2]) -> (String, bool) {
    let class = Class::of(text);
    let p2 = class.resonance(ResonanceKind::P2);
    let settings: Vec<String> = settings.iter().map(|&it| it.to_owned()).collect();
    let damaged = Case::parse("class.toml", text, &settings).expect("a case of the repository");
    let ridge = Ridge::search(&damaged.feedback, damaged.wavelength, damaged.speed);
    let mut branches: Vec<&RidgeBranch> = ridge.branches.iter().collect();
    branches.sort_by(|a, b| (a.frequency() - p2).abs().total_cmp(&(b.frequency() - p2).abs()));
    let Some(branch) = branches.first() else {
        return (format!("P2 at {p2:.0} Hz, nothing grows"), false);
    };
    let [from, to] = wavelengths(branch);
    let grown = branch.frequency();
    let holds = (50.0..=100.0).contains(&p2)
        && overlap(class.wavelengths(p2), published)
        && near(grown, p2, 0.2)
        && overlap([from, to], published)
        && !branch.only_at_edge();
    let others = ridge.branches.iter().filter(|other| !std::ptr::eq(*other, *branch));
    let others: Vec<String> = others.map(|other| format!("{:.0} Hz", other.frequency())).collect();
    let others = match others.is_empty() {
        true => String::new(),
        false => format!("; another branch at {}", others.join(", ")),
    };
    (format!("P2 at {p2:.0} Hz; grows at {grown:.0} Hz, {from:.0}–{to:.0} mm{others}"), holds)
}

pub(crate) fn class_of_heavy_haul() -> Row {
    let (got, holds) =
        by_damage(include_str!("../cases/class-heavy-haul.toml"), &["damage.laws=[\"flow\"]"], [200.0, 300.0]);
    Row {
        statement: "Class of heavy haul, axle load of 30 t, 40–80 km/h: growth by plastic flow above the shakedown limit of line contact",
        source: "P2 as quoted by Afferrante & Ciavarella (2009); wavelengths as commonly cited",
        expected: "50–100 Hz; 200–300 mm".to_owned(),
        got,
        tolerance: "the bands overlap; 20 % of P2: flow deepens troughs below it. The depth per passage is chosen and scales the rate alone",
        holds,
    }
}

pub(crate) fn class_of_light_rail() -> Row {
    let (got, holds) =
        by_damage(include_str!("../cases/class-light-rail.toml"), &["damage.laws=[\"bending\"]"], [500.0, 1500.0]);
    Row {
        statement: "Class of light rail, 47 kg/m, 80–160 km/h: growth by bending of the rail beyond yield",
        source: "P2 as quoted by Afferrante & Ciavarella (2009); wavelengths as commonly cited",
        expected: "50–100 Hz; 500–1500 mm".to_owned(),
        got,
        tolerance: "the bands overlap; 20 % of P2. The curvature per passage and the moment at which the rail yields are chosen",
        holds,
    }
}

pub(crate) fn class_of_cracks_at_p2() -> Row {
    let (got, holds) = by_damage(
        include_str!("../cases/class-contact-fatigue.toml"),
        &["damage.laws=[\"fatigue\"]", "contact.creepage=0.2 %"],
        [150.0, 450.0],
    );
    Row {
        statement: "Class of P2 corrugation by contact fatigue, metro, creepage of 0.2 %, 30–90 km/h: growth where cracks take the rail away",
        source: "Grassie & Edwards (2008), as quoted by Afferrante & Ciavarella (2009); wavelengths as commonly cited",
        expected: "50–100 Hz; 150–450 mm".to_owned(),
        got,
        tolerance: "the bands overlap; 20 % of P2. How much a crack takes away is chosen and scales the rate alone",
        holds,
    }
}
