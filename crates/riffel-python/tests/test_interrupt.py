"""Ctrl-C while something long is computed."""

from __future__ import annotations

import signal
import subprocess
import sys
import time

import pytest
from conftest import ROOT

SCRIPT = """
import signal, time
import numpy as np, riffel
# A shell that starts the tests in the background lets them ignore Ctrl-C.
signal.signal(signal.SIGINT, signal.default_int_handler)
case = riffel.Case.from_toml("cases/bhaskar-track.toml", {{"track.model": "moving-beam"}})
print("begun", flush=True)
try:
    case.{call}
except KeyboardInterrupt:
    print("interrupted", flush=True)
    rested = 1.0
    while rested > 0.02:
        begun = time.process_time()
        time.sleep(0.2)
        rested = time.process_time() - begun
    print("at rest", flush=True)
"""
# Each takes minutes.
LONG = [
    "growth_map(wavelength=np.linspace(0.02, 0.08, 2000), speed=np.linspace(5.0, 60.0, 50_000))",
    "ridge(speed=np.linspace(5.0, 60.0, 1_000_000))",
    "with_({'map.speed.points': 100_000}).compare([{'title': 'slippery', 'contact': {'friction': 0.2}}])",
]


CALLABLE = """
import signal, time
import numpy as np, riffel
signal.signal(signal.SIGINT, signal.default_int_handler)
calls = -1_000_000  # while it is built
def slow(frequency):
    global calls
    calls += 1
    if calls == 3:
        print("begun", flush=True)
    time.sleep(0.01 * frequency.size)
    return 1e-9 / (1.0 + 1j * frequency)
case = riffel.Case.from_toml("cases/nominal.toml").with_track(slow).with_wheel(lambda frequency: -1e-9 / frequency)
calls = 0
try:
    case.growth_map(wavelength=np.linspace(0.02, 0.08, 200), speed=np.linspace(5.0, 60.0, 200))
except KeyboardInterrupt:
    after = calls
    time.sleep(0.5)
    print("interrupted", calls == after, flush=True)
    print(np.isfinite(case.point(wavelength=0.05, speed=30.0)["growth_rate_per_passage"]), flush=True)
"""


# Long: begins work of minutes and waits until it has ended.
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
@pytest.mark.parametrize("call", LONG)
def test_a_signal_ends_the_wait_and_the_work(call: str) -> None:
    command = [sys.executable, "-c", SCRIPT.format(call=call)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT) as process:
        assert process.stdout is not None
        try:
            assert process.stdout.readline() == "begun\n"
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            assert process.stdout.readline() == "interrupted\n"
            assert process.stdout.readline() == "at rest\n"
        finally:
            process.kill()


# Long: begins a map of minutes and waits until nobody is asked any more.
@pytest.mark.skipif(sys.platform == "win32", reason="signals of POSIX")
def test_a_signal_ends_the_calls_of_a_receptance() -> None:
    """A map asks it for minutes; once given up, never again, and the case stays good, with a wheel beside the track."""
    command = [sys.executable, "-c", CALLABLE]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT) as process:
        assert process.stdout is not None
        try:
            assert process.stdout.readline() == "begun\n"
            process.send_signal(signal.SIGINT)
            assert process.stdout.readline() == "interrupted True\n"
            assert process.stdout.readline() == "True\n"
        finally:
            process.kill()
