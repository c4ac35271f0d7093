"""The program as a script of the package."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
import sysconfig
import urllib.request
from pathlib import Path
from typing import Any

import pytest
from conftest import PROGRAM

import riffel

SCRIPT = str(Path(sysconfig.get_path("scripts")) / "riffel")


def run(command: list[str], *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([*command, *arguments], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("command", [[SCRIPT], [sys.executable, "-m", "riffel"]], ids=["script", "module"])
@pytest.mark.parametrize(
    ("arguments", "status"),
    [
        (["point", "cases/nominal.toml", "--wavelength", "55 mm", "--speed", "108 km/h", "--json"], 0),
        (["map", "--help"], 0),
        (["point", "cases/nominal.toml", "--wavelength", "55 mm"], 2),
        (["presets", "nothing-of-the-kind"], 2),
    ],
    ids=["point", "help", "usage", "bad input"],
)
def test_it_is_the_program(command: list[str], arguments: list[str], status: int) -> None:
    there, here = run([PROGRAM], *arguments), run(command, *arguments)
    assert here.returncode == there.returncode == status
    assert here.stdout == there.stdout
    assert here.stderr == there.stderr


def test_files_are_those_of_the_program(tmp_path: Path) -> None:
    for command, folder in (([PROGRAM], "there"), ([SCRIPT], "here")):
        made = run(command, "receptance", "cases/nominal.toml", "--points", "50", "--output", str(tmp_path / folder))
        assert made.returncode == 0, made.stderr
    there, here = (sorted((tmp_path / folder).iterdir()) for folder in ("there", "here"))
    assert [file.name for file in here] == [file.name for file in there]
    assert [file.read_bytes() for file in here] == [file.read_bytes() for file in there]


def test_the_program_waits_for_neither_numpy_nor_xarray() -> None:
    """To import them takes longer than most of its commands."""
    program = (
        "import sys; from riffel.__main__ import main; status = main();"
        "found = sorted({'numpy', 'xarray', 'riffel._riffel'} & sys.modules.keys()); print(status, found)"
    )
    point = ["point", "cases/nominal.toml", "--wavelength", "55 mm", "--speed", "108 km/h", "--json"]
    found = run([sys.executable, "-c", program], *point)
    assert found.stdout.splitlines()[-1] == "0 ['riffel._riffel']", found.stderr


def test_ctrl_c_is_for_the_program(tmp_path: Path) -> None:
    """The page ends its own work and says so by a status of zero; Python would raise."""
    page = subprocess.Popen([SCRIPT, "serve", "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert page.stdout is not None and page.stdout.readline().startswith("http://127.0.0.1:")
    page.send_signal(signal.SIGINT)
    _, errors = page.communicate(timeout=30)
    assert page.returncode == 0, errors
    assert "Traceback" not in errors


def test_the_page_of_the_package_reads_a_measured_rail(tmp_path: Path) -> None:
    """The page reads files in processes of their own: here Python starts them."""
    profile = tmp_path / "profile.csv"
    made = run([PROGRAM], "roughness", "--synthesise", "cases/roughness-recipe.toml", "--output", str(profile))
    assert made.returncode == 0, made.stderr
    page = subprocess.Popen([SCRIPT, "serve", "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert page.stdout is not None
    url = page.stdout.readline().strip().rstrip("/")

    def post(path: str, kind: str, body: bytes) -> dict[str, Any]:
        headers = {"Content-Type": kind, "Origin": url, "X-Riffel-Page": "test"}
        with urllib.request.urlopen(urllib.request.Request(url + path, body, headers), timeout=60) as answer:
            found: dict[str, Any] = json.load(answer)
            return found

    try:
        upload = post("/api/upload", "text/csv", profile.read_bytes())["upload"]
        case = riffel.Case.from_toml("cases/nominal.toml").to_dict()
        vehicle = {"name": "any", "share": 1, "speed": {"mean": 25.0, "standard_deviation": 3.0}}
        question = {
            "case": case,
            "roughness": {"upload": upload, "name": "profile.csv"},
            "traffic": {"line": {"passages_per_day": 1000.0}, "vehicle": [vehicle]},
        }
        measured = post("/api/ask/measure", "application/json", json.dumps(question).encode())
    finally:
        page.terminate()
        page.communicate(timeout=30)
    assert measured["diagnosis"]["dominant_wavelengths"]
    assert page.returncode == 0
