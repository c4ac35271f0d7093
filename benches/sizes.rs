//! What the sections work on and how often, in full and in a trial.

/// Sizes and rounds of all sections.
pub(crate) struct Sizes {
    /// Rounds of tasks of milliseconds.
    pub(crate) rounds: usize,
    /// Rounds of tasks of tenths of a second, whose medians are steady.
    pub(crate) few_rounds: usize,
    /// Rounds of tasks of seconds.
    pub(crate) fewest_rounds: usize,
    /// Points along each axis of the map of the comparison.
    pub(crate) side: usize,
    /// Points along each axis of the map under a moving load on layers, whose points cost most.
    pub(crate) moving_load_side: usize,
    /// Points along each axis of the maps that tell cost against size, with their rounds.
    pub(crate) sides: &'static [(usize, usize)],
    /// Frequencies of receptances.
    pub(crate) frequencies: usize,
    /// Points along each axis of the maps of equations alone, of one wheel and of eight.
    pub(crate) equation_sides: [usize; 2],
    /// Points along the axes of the map of the loop on all axes.
    pub(crate) general_map: (usize, usize),
    /// Elements over a diameter of rolling contact, as in the times of CONTACT.
    pub(crate) elements: usize,
    /// Elements of a frequency response, by default those of the case file.
    pub(crate) response_elements: usize,
    /// Wavelengths of a frequency response and of a table.
    pub(crate) wavelengths: [usize; 2],
    /// Cells of FASTSIM along and across.
    pub(crate) cells: usize,
    /// Points of the stress along and across; half as many depths.
    pub(crate) stress_points: usize,
    /// Shifts of a wheelset, 0.1 mm apart, at each of three yaws.
    pub(crate) shifts: i32,
    /// Elements across the patch of the exact contact.
    pub(crate) patch_elements: usize,
    /// Speeds of the traffic through a curve.
    pub(crate) speeds: usize,
    /// Sleeper bays that a wheel runs in, bays that count after them, and bays of the finite elements beside it.
    pub(crate) bays: [usize; 3],
    /// Wheels over the rail that wears.
    pub(crate) passages: usize,
    /// Samples of a rough rail, 1 mm apart.
    pub(crate) samples: usize,
    /// Monte-Carlo samples on one thread, on two and on two workers.
    pub(crate) study: usize,
    /// Monte-Carlo samples of the fit, with their rounds.
    pub(crate) studies: &'static [(usize, usize)],
}

/// Sizes of the report: a quarter of an hour on two processors.
pub(crate) const FULL: Sizes = Sizes {
    rounds: 41,
    few_rounds: 7,
    fewest_rounds: 3,
    side: 1001,
    moving_load_side: 101,
    sides: &[(100, 401), (316, 201), (1000, 41), (3162, 11), (10_000, 3)],
    frequencies: 200,
    equation_sides: [301, 61],
    general_map: (241, 221),
    elements: 40,
    response_elements: riffel::contact::HalfSpace::DEFAULT_ELEMENTS,
    wavelengths: [30, 64],
    cells: 50,
    stress_points: 64,
    shifts: 201,
    patch_elements: 48,
    speeds: 20,
    bays: [14, 6, 40],
    passages: 10_000,
    samples: 2_000_000,
    study: 10_000,
    studies: &[(1000, 7), (10_000, 3), (100_000, 1)],
};

/// Sizes of a trial: every contestant at work, and every result compared, in seconds.
pub(crate) const SMOKE: Sizes = Sizes {
    rounds: 1,
    few_rounds: 1,
    fewest_rounds: 1,
    side: 31,
    moving_load_side: 3,
    sides: &[(20, 1), (40, 1)],
    frequencies: 10,
    equation_sides: [11, 3],
    general_map: (5, 3),
    elements: 16,
    response_elements: 16,
    wavelengths: [3, 3],
    cells: 10,
    stress_points: 6,
    shifts: 3,
    patch_elements: 16,
    speeds: 1,
    bays: [2, 6, 16],
    passages: 10,
    samples: 60_000,
    study: 20,
    studies: &[(10, 1), (20, 1), (40, 1)],
};
