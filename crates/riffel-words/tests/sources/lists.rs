//! Sentences that stay English, and files of them.

/// Crates that do not speak German: the catalogue itself, the Python package, whose errors are English as those of Python, and
/// calibration, whose plans are for those who read English manuals of statistics.
pub(super) const WITHOUT: [&str; 3] = ["riffel-words", "riffel-python", "riffel-calibrate"];

/// What has no German, and why, file by file. Paths in `crates`.
pub(super) const LEFT: &[(&str, &[&str])] = &[
    // For browsers, not for people.
    (
        "riffel-plot/src/page/html.rs",
        &["body{margin", "default-src", "panels stacked"],
    ),
    (
        "riffel-web/src/assets.rs",
        &["// What Riffel says", "max-age"],
    ),
    (
        "riffel-web/src/file.rs",
        &["default-src", "name=\"generator\""],
    ),
    (
        "riffel-web/src/guard.rs",
        &[
            "default-src",
            "this page is not served",
            "open it by the address",
            "only the page itself may ask",
            "the header Origin",
        ],
    ),
    (
        "riffel-web/src/request.rs",
        &[
            "a request about a file must say",
            "a request must be JSON",
            "send the header",
        ],
    ),
    ("riffel-answers/src/report/page.rs", &["name=\"generator\""]),
    // Defects, told in English to those who mend them.
    (
        "riffel/src/contact/law/checks.rs",
        &["{next} after {last} at step"],
    ),
    ("riffel/src/growth/map.rs", &["tiles of a map"]),
    (
        "riffel/src/passage/transient_contact.rs",
        &["beside a transient one", "must be none, under a free wheel"],
    ),
    (
        "riffel-keys/src/question.rs",
        &[
            "the question is",
            "the question has no such key",
            "the first column has",
        ],
    ),
    (
        "riffel-cli/src/error.rs",
        &[
            "the question on standard input",
            "riffel schema --question NAME",
        ],
    ),
    (
        "riffel-cli/src/question.rs",
        &[
            "standard input holds the question",
            "a list of them as",
            "riffel ask",
        ],
    ),
    (
        "riffel/src/growth/with_neighbours.rs",
        &["number of contacts of a wave", "of a wheel along one axis"],
    ),
    ("riffel-web/src/workspace.rs", &["cannot be stored"]),
    ("riffel-page/src/case_text.rs", &["cannot be written"]),
    ("riffel-page/src/fault.rs", &["cannot be drawn"]),
    ("riffel-page/src/figure.rs", &["the paper has no figure"]),
    (
        "riffel-page/src/reply.rs",
        &["is too long", "cannot be written"],
    ),
    ("riffel-page/src/table.rs", &["cannot be written"]),
    ("riffel-page/src/traffic.rs", &["cannot be written"]),
    ("riffel-plot/src/drawing/collision.rs", &["{said:?}"]),
    (
        "riffel-plot/src/error.rs",
        &["cannot be read", "the drawing library failed"],
    ),
    (
        "riffel-web/src/api/along.rs",
        &["cannot be read", "there is no place"],
    ),
    ("riffel-web/src/api/export.rs", &["cannot be drawn"]),
    ("riffel-web/src/api/report.rs", &["there is no place"]),
    (
        "riffel-web/src/api/roughness.rs",
        &["cannot be written", "cannot be stored"],
    ),
    (
        "riffel-web/src/program.rs",
        &["printed something else", "cannot be run", "is not known"],
    ),
    ("riffel-web/src/uploads.rs", &["cannot be stored"]),
    (
        "riffel-web/src/api/curve.rs",
        &[
            "there is no place",
            "the curve of the page",
            "there is no such nominal profile",
            "cannot be stored",
        ],
    ),
    // Said to those who build.
    ("riffel-page/src/lib.rs", &["answers of riffel"]),
    ("riffel-wasm/src/lib.rs", &["a name that"]),
    // Words of another reader, which are put into our own.
    (
        "riffel-keys/src/key_file/mod.rs",
        &[
            "missing field",
            "unknown field",
            "unknown variant",
            "expected struct",
            "expected a sequence",
            "invalid type",
        ],
    ),
    // Sources of nominal profiles.
    (
        "riffel/src/profile/nominal.rs",
        &["Wheel of EN", "Cone of 1:40"],
    ),
    // Titles of schemas.
    (
        "riffel-case/src/file/curving/mod.rs",
        &["case file of curving"],
    ),
    ("riffel-case/src/file/mod.rs", &["Riffel case file"]),
    (
        "riffel-case/src/traffic/traffic_file.rs",
        &["Riffel traffic file"],
    ),
    // Descriptions of arrays in a store, for those who open it with other programs.
    (
        "riffel-network/src/ingest.rs",
        &["of a cell along the line"],
    ),
    (
        "riffel-arrays/src/band_axes.rs",
        &["in the logarithm of wavelength", "wavelength of the band"],
    ),
    (
        "riffel-network/src/store.rs",
        &["RMS of roughness in a band"],
    ),
    (
        "riffel-study/src/outputs/variable.rs",
        &[
            "that the strongest branch of the ridge follows",
            "growth rate per passage",
            "highest growth",
            "sits at an end of the window",
            "growth where its real part is negative",
        ],
    ),
    (
        "riffel-study/src/outputs/wave.rs",
        &[
            "first harmonic of the normal force",
            "least normal force",
            "largest normal force",
            "share of the time without contact",
            "mean creepage along the rail",
            "mean energy dissipated",
            "amplitude of the wave",
            " worn by {passages}",
            "over a wave of",
        ],
    ),
    (
        "riffel-study/src/results/arrays.rs",
        &["why the sample has no results"],
    ),
    // Words in drawings and tables on disk, beside sentences that are said.
    (
        "riffel-answers/src/map/bay.rs",
        &[
            "Growth over a sleeper bay",
            "distance from a support",
            "growth rate per passage [-]",
            "wheel at this place",
            "over wavelength at",
            "Quasi-static in position",
        ],
    ),
    (
        "riffel-answers/src/profile/under_load.rs",
        &[
            "Exact contact of the profiles",
            "lateral shift y",
            "peak pressure [MPa]",
            "contact stiffness [MN/m]",
            "largest pressure",
        ],
    ),
    (
        "riffel-answers/src/profile/wear.rs",
        &["lateral x, field side", "Depth is measured across"],
    ),
    (
        "riffel-answers/src/simulate/along_rail.rs",
        &["A passage at", "Wheel centre at x"],
    ),
    (
        "riffel-answers/src/simulate/sinusoid.rs",
        &[
            "of the exact contact",
            "The last wave",
            "A wave of",
            "wheel centre at x",
        ],
    ),
    (
        "riffel-answers/src/simulate/smooth_rail.rs",
        &["motion that has not settled", "A smooth rail at"],
    ),
    (
        "riffel-answers/src/wheels/table.rs",
        &["one for the", "Growth under the wheels"],
    ),
];

/// Files of what is English in every language: help, drawings and tables that are written to disk, and what a model of the
/// field is, in JSON. Paths in `crates`; a folder stands for all of its files.
pub(super) const IN_ENGLISH: &[&str] = &[
    // Where the ends of ranges come from: for the documentation.
    "riffel-keys/src/range/table.rs",
    // Help with its examples.
    "riffel-cli/src/arguments",
    // Drawings, and names of the columns of tables.
    "riffel-answers/src/axlebox/figure.rs",
    "riffel-answers/src/contact/creep_curves.rs",
    "riffel-answers/src/contact/frequency_response.rs",
    "riffel-answers/src/contact/mod.rs",
    "riffel-answers/src/contact/patch.rs",
    "riffel-answers/src/curve/over_radius.rs",
    "riffel-answers/src/growth_lines.rs",
    "riffel-answers/src/map/table.rs",
    "riffel-answers/src/models/figure.rs",
    "riffel-answers/src/profile/on_track.rs",
    "riffel-answers/src/profile/outline.rs",
    "riffel-answers/src/receptance",
    "riffel-answers/src/roughness/figure.rs",
    "riffel-answers/src/simulate/course.rs",
    "riffel-answers/src/simulate/evolution/figure.rs",
    "riffel-answers/src/simulate/evolution/table.rs",
    "riffel-answers/src/study/figure.rs",
    "riffel-answers/src/wheels/figure.rs",
    "riffel-answers/src/wheelset.rs",
    // What a model is, is the author's.
    "riffel-case/src/model/afferrante_ciavarella_2009.rs",
    "riffel-case/src/model/bhaskar_1997.rs",
    "riffel-case/src/model/both_2001.rs",
    "riffel-case/src/model/carson_johnson_1971.rs",
    "riffel-case/src/model/elkins_1998.rs",
    "riffel-case/src/model/frederick_1987.rs",
    "riffel-case/src/model/grassie_edwards_2008.rs",
    "riffel-case/src/model/grassie_johnson_1985.rs",
    "riffel-case/src/model/hempelmann_knothe_1996.rs",
    "riffel-case/src/model/riffel_exact.rs",
    "riffel-case/src/model/tassilly_vincent_1991.rs",
    "riffel-case/src/model/valdivia_1988.rs",
];
