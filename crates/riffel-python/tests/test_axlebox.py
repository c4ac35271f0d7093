"""Roughness from axle boxes: what the program finds, in every format."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import pyuff
import scipy.io
import scipy.io.wavfile

import riffel

CASE = "cases/nominal.toml"
RATE = 4000
SPEED = 20.0

# pyuff leaves its files open.
pytestmark = pytest.mark.filterwarnings("ignore::pytest.PytestUnraisableExceptionWarning")

Signal = npt.NDArray[np.float64]


@pytest.fixture(scope="module")
def signal() -> Signal:
    """20 s of waves of 25 to 400 mm in m/s² with a spread that no axle box would be ashamed of."""
    time = np.arange(20 * RATE) / RATE
    random = np.random.default_rng(5)
    frequencies = np.geomspace(50.0, 800.0, 60)
    waves = np.sin(2 * np.pi * frequencies[:, None] * time + random.uniform(0, 6, (60, 1)))
    return np.asarray(waves.sum(axis=0) + 0.01 * random.standard_normal(time.size))


def levels(document: dict[str, Any]) -> Signal:
    (rail,) = document["rails"]
    return np.array([level["level_db"] for level in rail["spectrum"]])


def wave(path: Path, signal: Signal, kind: type) -> Path:
    """A WAV of SciPy, of 100 m/s² and 360 km/h at full scale."""
    channels = np.stack([signal / 100.0, np.full(signal.size, 3.6 * SPEED / 360.0)], axis=1)
    if kind is not np.float32:
        channels = np.round(channels * np.iinfo(kind).max)
    scipy.io.wavfile.write(path, RATE, channels.astype(kind))
    return path


def universal(path: Path, signal: Signal, binary: bool, unit: str, scale: float) -> Path:
    """A universal file of pyuff: acceleration, and the odometer."""
    signals = [(signal / scale, 12, unit, "Axle box left"), (SPEED * np.arange(signal.size) / RATE, 8, "m", "Odometer")]
    sets = [
        {
            "type": 58,
            "binary": int(binary),
            "id1": title,
            "id3": "21-Nov-26 12:00:00",
            "func_type": 1,
            "rsp_node": 1,
            "rsp_dir": 3,
            "ref_node": 0,
            "ref_dir": 0,
            "ord_data_type": 4,
            "abscissa_spacing": 1,
            "abscissa_min": 0.0,
            "abscissa_inc": 1.0 / RATE,
            "num_pts": signal.size,
            "abscissa_spec_data_type": 17,
            "abscissa_axis_units_lab": "s",
            "ordinate_spec_data_type": kind,
            "ordinate_axis_units_lab": unit,
            "orddenom_spec_data_type": 0,
            "data": values,
            "x": np.arange(signal.size) / RATE,
        }
        for values, kind, unit, title in signals
    ]
    # The mode "overwrite" of pyuff loses all but the end of a binary dataset.
    pyuff.UFF(str(path)).write_sets(sets, mode="add")
    return path


def test_every_format_has_the_same_levels(signal: Signal, tmp_path: Path) -> None:
    case = riffel.Case.from_toml(CASE)
    expected = levels(case.axlebox(signal, rate=RATE, speed=SPEED))
    odometer = SPEED * np.arange(signal.size) / RATE
    matlab = str(tmp_path / "run.mat")
    scipy.io.savemat(matlab, {"left": signal})
    loaded = scipy.io.loadmat(matlab)["left"].ravel()
    channels = ["acceleration_left_m_per_s2=100", "speed_km_per_h=360"]
    runs: list[tuple[Any, dict[str, Any]]] = [
        ({"left": signal.tolist()}, {"rate": "4 kHz", "speed": np.full(signal.size, SPEED)}),
        ({"left": loaded}, {"rate": RATE, "odometer": odometer}),
        (wave(tmp_path / "float.wav", signal, np.float32), {"channels": channels}),
        (wave(tmp_path / "long.wav", signal, np.int32), {"channels": channels}),
        (universal(tmp_path / "text.uff", signal, False, "m/s^2", 1.0), {}),
        (universal(tmp_path / "binary.uff", signal, True, "g", 9.80665), {}),
    ]
    # Bands without a wave hold only what is left of others, -60 dB, which the digits of a file show.
    clear = expected > -40
    assert clear.sum() == 12
    for run, given in runs:
        found = levels(case.axlebox(run, **given))
        # Six digits of a step or of a sample; an odometer is averaged, a speed is not.
        np.testing.assert_allclose(found[clear], expected[clear], atol=1e-3, err_msg=str(run)[:80])
    # 16 bits of 100 m/s² are steps of 3 mm/s², which short waves show.
    coarse = levels(case.axlebox(wave(tmp_path / "short.wav", signal, np.int16), channels=channels))
    np.testing.assert_allclose(coarse[clear], expected[clear], atol=0.05)


def test_the_program_says_the_same(signal: Signal, tmp_path: Path, program: Callable[..., Any]) -> None:
    path = universal(tmp_path / "run.uff", signal, True, "m/s^2", 1.0)
    printed = program("axlebox", str(path), "--case", CASE, "--json")
    assert riffel.Case.from_toml(CASE).axlebox(path) == printed
    assert printed["rails"][0]["name"] == "Axle box left"


def test_a_flat_is_the_wheels(signal: Signal) -> None:
    """Blows once a turn of a wheel of 0.46 m."""
    turn = 2 * np.pi * 0.46
    away = (SPEED * np.arange(signal.size) / RATE + 0.5 * turn) % turn - 0.5 * turn
    blows = 50.0 * np.exp(-((away / 0.01) ** 2))
    case = riffel.Case.from_toml(CASE)
    assert case.axlebox({"left": signal}, rate=RATE, speed=SPEED)["wheels"] == []
    found = case.axlebox({"left": signal + blows}, rate=RATE, speed=SPEED)
    (flat,) = found["wheels"]
    assert (flat["name"], flat["kind"], flat["order"]) == ("left", "flat", None)
    assert found["rails"][0]["defects"] == []


def test_what_is_wrong_is_said(signal: Signal, tmp_path: Path) -> None:
    case = riffel.Case.from_toml(CASE)
    plain = {"rate": RATE, "speed": SPEED}
    clipped = np.clip(signal, -5.0, 5.0)
    sound = wave(tmp_path / "run.wav", signal, np.int16)
    unlabelled = universal(tmp_path / "unlabelled.uff", signal, False, "NONE", 1.0)
    cut = tmp_path / "cut.wav"
    cut.write_bytes(sound.read_bytes()[:-1001])
    channels = ["acceleration_left_g=50", "speed_km_per_h=360"]
    wrong: list[tuple[Any, dict[str, Any], str]] = [
        (signal, {"speed": SPEED}, "rate is missing"),
        (signal, {"rate": RATE}, "give one of the two"),
        (signal, {"rate": RATE, "speed": "72 kg"}, "speed: "),
        (signal, {"rate": RATE, "speed": np.full(7, SPEED)}, "7 values"),
        (signal, {**plain, "speed": "10 km/h"}, "never runs faster than 20.0 km/h"),
        (signal, {"rate": RATE, "odometer": -np.arange(signal.size)}, "odometer falls"),
        (signal, {"rate": RATE, "odometer": 20.0 * np.arange(signal.size)}, "faster than any train"),
        (signal, {"rate": RATE, "speed": np.full(signal.size, 200.0)}, "faster than any train"),
        (signal, {"rate": RATE, "speed": np.full(signal.size, -20.0)}, "sample 1: the speed is -20 m/s"),
        (clipped, plain, r"rail: clipped at 5.0000 m/s² and -5.0000 m/s² in"),
        (0.1 * signal + 1.0, plain, "as gravity is in g"),
        (np.zeros(signal.size), plain, "never|keeps|drops|faster"),
        ({"left": signal, "right": signal[1:]}, plain, "right has 79999 values, but left has 80000"),
        (signal, {**plain, "longest": "15 mm"}, "at least twice --shortest"),
        (sound, {}, "a WAV file has no units"),
        (sound, {"channels": channels[:1]}, "has 2 channels, but --channels names 1"),
        (sound, {"channels": ["acceleration_left=50", channels[1]]}, "no unit known here"),
        (sound, {"channels": ["acceleration_left_g", channels[1]]}, "value at full scale"),
        (sound, {"channels": [channels[0], "microphone=1"]}, "no channel is the speed"),
        (cut, {"channels": channels}, "ends before its head says"),
        (unlabelled, {}, "without a unit"),
        (CASE, {"channels": channels}, "--channels is for WAV files"),
    ]
    for run, given, sentence in wrong:
        with pytest.raises(ValueError, match=sentence):
            case.axlebox(run, **given)
    with pytest.raises(FileNotFoundError):
        case.axlebox(tmp_path / "nothing.wav", speed=SPEED)
