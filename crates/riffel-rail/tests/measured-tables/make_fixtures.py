"""Make the tables that the tests of measured receptances read, with NumPy and pyuff 2.5.8.

They are the receptance of one track, from its closed form: an Euler-Bernoulli rail on two layers spread evenly,
H = 1 / (2 sqrt(2) B^(1/4) K^(3/4)). Each file is written as a measuring system or a script would: other units, marks,
encodings and kinds of response. case.toml is the track as a model, for comparison.

    pip install numpy==2.4.6 pyuff==2.5.8
    python make_fixtures.py
"""

from pathlib import Path

import numpy as np
import pyuff

FOLDER = Path(__file__).parent
FREQUENCY = np.arange(0.0, 2501.0, 10.0)  # Hz, as a Fourier transform has them
G = 9.80665  # m/s2


def receptance(frequency):
    """Displacement over force on the rail, downward, in m/N; time factor exp(+i omega t)."""
    omega = 2.0 * np.pi * frequency
    bending = 210e9 * 3.0383e-5  # N m2
    spacing = 0.6  # m
    pad = 200e6 * (1.0 + 0.2j) / spacing  # N/m2
    ballast = 60e6 * (1.0 + 0.6j) / spacing
    sleeper = 150.0 / spacing  # kg/m
    support = 1.0 / (1.0 / pad + 1.0 / (ballast - omega**2 * sleeper))
    stiffness = support - omega**2 * 60.21
    return 1.0 / (2.0 * np.sqrt(2.0) * bending**0.25 * stiffness**0.75)


H = receptance(FREQUENCY)
S = 2j * np.pi * FREQUENCY
COHERENCE = np.where(FREQUENCY < 45.0, 0.6, 0.98)


def comma(value):
    return f"{value:.9e}".replace(".", ",")


# A German analyser: Windows-1252, lines before the header, a row of units, 0 Hz, coherence.
accelerance = H * S**2 / G
rows = [
    f"{f:.1f}".replace(".", ",") + f";{comma(abs(a))};{comma(np.degrees(np.angle(a)))};{c:.3f}".replace(".", ",")
    for f, a, c in zip(FREQUENCY, accelerance, COHERENCE)
]
head = ["Messung am Gleis, Prüfer: Müller", "Mittelungen;10", "", "Frequenz;Betrag;Phase;Kohärenz", "Hz;g/N;°;-"]
(FOLDER / "accelerance_g.csv").write_bytes("\r\n".join([*head, *rows, ""]).encode("cp1252"))

# Decibels, kilohertz and radians, tabs, UTF-16 with a byte order mark, as a spreadsheet saves "Unicode text".
rows = [
    f"{f / 1e3:.4f}\t{20 * np.log10(abs(h)):.9f}\t{np.angle(h):.9f}" for f, h in zip(FREQUENCY[1:], H[1:])
]
head = "Frequency [kHz]\t|H| [dB re 1 m/N]\tPhase [rad]"
(FOLDER / "receptance_db.txt").write_bytes("\r\n".join([head, *rows, ""]).encode("utf-16"))

# NumPy's savetxt: blanks, the header behind a mark of a comment, mobility in mm/s per kN.
mobility = H * S * 1e6
np.savetxt(
    FOLDER / "mobility_savetxt.txt",
    np.column_stack([FREQUENCY[1:], mobility.real[1:], mobility.imag[1:]]),
    fmt="%.9e",
    header="frequency real imag",
)

# Quoted names with units in brackets, carriage returns alone.
rows = [f"{f:.1f},{h.real:.9e},{h.imag:.9e}" for f, h in zip(FREQUENCY[1:], H[1:])]
head = '"Frequency (Hz)","Real part (m/N)","Imaginary part (m/N)"'
(FOLDER / "receptance_quoted.csv").write_bytes("\r".join([head, *rows, ""]).encode("utf-8-sig"))


def function(response, reference, values):
    """A dataset 58 with the receptance between two directions."""
    return {
        "type": 58,
        "func_type": 4,
        "id1": f"rail head, direction {response}",
        "rsp_node": 1,
        "rsp_dir": response,
        "ref_node": 1,
        "ref_dir": reference,
        "abscissa_spec_data_type": 18,
        "ordinate_spec_data_type": 12,
        "ordinate_axis_units_lab": "g",
        "orddenom_spec_data_type": 13,
        "orddenom_axis_units_lab": "N",
        "x": FREQUENCY,
        "data": values,
        "id5": "NONE",
    }


# Vertical, lateral and across; the lateral one is three times as soft. Accelerance in g/N.
path = FOLDER / "three_directions.uff"
path.unlink(missing_ok=True)
pyuff.UFF(str(path)).write_sets(
    [function(2, 2, 3 * accelerance), function(3, 3, accelerance), function(3, 2, 0.1 * accelerance)], "add"
)
