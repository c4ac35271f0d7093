"""Make the universal files that the tests of the reader read, with pyuff 2.5.8.

The functions are those of a chain ground - spring and damper - mass 1 - spring and damper - mass 2,
excited and observed at mass 1: receptance, mobility, accelerance, and the modulus of the
receptance as a real function. They stand in every layout of dataset 58: real or complex, single or
double precision, even or uneven abscissa, and in the binary form 58b. exact.csv holds the receptance
to all digits of a double.

    pip install pyuff==2.5.8
    python make_fixtures.py
"""

from pathlib import Path

import numpy as np
import pyuff

FOLDER = Path(__file__).parent
EVEN = np.linspace(20.0, 2000.0, 100)  # Hz; the step of 20 Hz is exact in the header
UNEVEN = np.geomspace(20.0, 2000.0, 100)  # Hz

KIND = {"displacement": 8, "velocity": 11, "acceleration": 12, "force": 13, "frequency": 18}
UNIT = {"displacement": "m", "velocity": "m/s", "acceleration": "m/s2"}
POWER = {"displacement": 0, "velocity": 1, "acceleration": 2}


def receptance(frequency):
    """Displacement of mass 1 over the force on it, in m/N."""
    s = 2j * np.pi * frequency
    m1, m2 = 2.0, 0.5  # kg
    ground = 2e6 + 40.0 * s  # N/m
    between = 5e6 + 30.0 * s
    second = m2 * s**2 + between
    return second / ((m1 * s**2 + ground + between) * second - between**2)


def dataset(motion, frequency, *, real=False, single=False, binary=False, nodes=(1, 1), factor=1.0):
    """A dataset 58 with the motion of mass 1 over the force on it."""
    values = factor * receptance(frequency) * (2j * np.pi * frequency) ** POWER[motion]
    return {
        "type": 58,
        "binary": int(binary),
        "id1": f"{motion} over force",
        "id3": "21-Nov-26 12:00:00",
        "func_type": 4,
        "rsp_ent_name": "RAIL",
        "rsp_node": nodes[0],
        "rsp_dir": 3,
        "ref_ent_name": "RAIL",
        "ref_node": nodes[1],
        "ref_dir": -3,
        "ord_data_type": {(True, True): 2, (True, False): 4, (False, True): 5, (False, False): 6}[
            real, single
        ],
        "abscissa_spacing": int(frequency is EVEN),
        "abscissa_spec_data_type": KIND["frequency"],
        "abscissa_axis_lab": "Frequency",
        "abscissa_axis_units_lab": "Hz",
        "ordinate_spec_data_type": KIND[motion],
        "ordinate_len_unit_exp": 1,
        "ordinate_axis_lab": motion.capitalize(),
        "ordinate_axis_units_lab": UNIT[motion],
        "orddenom_spec_data_type": KIND["force"],
        "orddenom_force_unit_exp": 1,
        "orddenom_axis_lab": "Force",
        "orddenom_axis_units_lab": "N",
        "x": frequency,
        "data": np.abs(values) if real else values,
    }


def write(name, *datasets):
    """Write the datasets as one universal file."""
    path = FOLDER / name
    path.unlink(missing_ok=True)
    # The mode "overwrite" of this version loses all but the end of a binary dataset.
    pyuff.UFF(str(path)).write_sets(list(datasets), "add", force_double=False)


def header():
    """A dataset 151, which the reader skips; without these dates it would hold the present ones."""
    return {
        "type": 151,
        "model_name": "Two masses",
        "description": "NONE",
        "db_app": "NONE",
        "date_db_created": "21-Nov-26",
        "time_db_created": "12:00:00",
        "date_db_saved": "21-Nov-26",
        "time_db_saved": "12:00:00",
        "program": "make_fixtures.py",
        "date_file_written": "21-Nov-26",
        "time_file_written": "12:00:00",
    }


def units():
    """A dataset 164 for millimetres and newtons."""
    return pyuff.prepare_164(
        units_code=9,
        units_description="mm and N",
        temp_mode=1,
        length=1000.0,
        force=1.0,
        temp=1.0,
        temp_offset=273.15,
    )


for spacing, frequency in [("even", EVEN), ("uneven", UNEVEN)]:
    write(f"receptance_double_{spacing}.uff", dataset("displacement", frequency))
    write(f"receptance_binary_{spacing}.uff", dataset("displacement", frequency, binary=True))
    for precision in ["single", "double"]:
        write(
            f"modulus_{precision}_{spacing}.uff",
            dataset("displacement", frequency, real=True, single=precision == "single"),
        )
write("mobility_single_even.uff", dataset("velocity", EVEN, single=True))
write("accelerance_single_uneven.uff", dataset("acceleration", UNEVEN, single=True))
write(
    "several.uff",
    header(),
    units(),
    dataset("displacement", EVEN, factor=1000.0),  # mm/N
    dataset("displacement", UNEVEN, factor=1000.0, nodes=(2, 1)),
)

with (FOLDER / "exact.csv").open("w", encoding="utf-8", newline="\n") as file:
    file.write("frequency_hz,receptance_real_m_per_n,receptance_imaginary_m_per_n\n")
    for frequency in [*EVEN, *UNEVEN]:
        value = receptance(frequency)
        file.write(f"{float(frequency)!r},{float(value.real)!r},{float(value.imag)!r}\n")
