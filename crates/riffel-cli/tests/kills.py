"""Kill each command that writes a folder at random times, and look at what it leaves. Run by hand, from the root of the project:

    python3 crates/riffel-cli/tests/kills.py target/release/riffel [NUMBER [WRITER...]]

Every command gives the same bytes twice. So a file that stands at its place after a kill must be that of a run that nobody stopped,
and the same command must come to the same folder in the end: without leftovers, and with the file that somebody had put there.
"""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

PROGRAM = Path(sys.argv[1]).resolve()
KILLS = int(sys.argv[2]) if len(sys.argv) > 2 else 30
WRITERS = sys.argv[3:]
ROOT = Path.cwd()
SET = ROOT / "validation/calibration/b-three-dates"
# What says when it was written, how far a run is, or what else is there.
GROWING = {"calibration.json", "state.json", "riffel-manifest.json", "in-use.lock", "network.lock"}

STUDY = """
case = "{root}/cases/nominal.toml"
set.map.speed = {{ min = "5 m/s", max = "60 m/s", points = 60 }}
design = {{ method = "sobol", samples = 400, seed = 3 }}
outputs = {{ ridge = true, map = ["growth_rate"] }}
results.samples_per_chunk = 10
[[parameter]]
key = "contact.friction"
uniform = {{ min = 0.2, max = 0.5 }}
"""

PLAN = """
case = "{set}/case.toml"
traffic = "{set}/traffic.toml"
[sampler]
kind = "{kind}"
chains = 2
{warmup}
draws = {draws}
[cost]
grinding = "9000 EUR"
[[action]]
title = "less"
upkeep = "100 EUR"
multiplies = {{ "wear.coefficient" = 0.7 }}
[[parameter]]
key = "wear.coefficient"
lognormal = {{ median = 2.5e-9, factor = 2.0 }}
[[data]]
kind = "dated-levels"
file = "{set}/roughness.csv"
discrepancy = {{ kind = "band", standard_deviation = 1.0 }}
"""


def content(path: Path) -> bytes:
    """The bytes of a file but the time in it."""
    if path.name != "zarr.json":
        return path.read_bytes()

    def strip(value: object) -> object:
        if isinstance(value, dict):
            return {key: strip(inner) for key, inner in value.items() if key != "created_at"}
        return value

    try:
        return json.dumps(strip(json.loads(path.read_text()))).encode()
    except ValueError:
        return path.read_bytes()


def files(folder: Path) -> dict[str, bytes]:
    paths = [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()]
    return {str(path.relative_to(folder)): content(path) for path in paths}


def start(command: list[str]) -> subprocess.Popen[bytes]:
    silent = subprocess.DEVNULL
    return subprocess.Popen([PROGRAM, *command, "-q"], stdout=silent, stderr=silent, start_new_session=True)


def whole(command: list[str]) -> float:
    begun = time.monotonic()
    status = start(command).wait()
    assert status in (0, 1), (command, status)
    return time.monotonic() - begun


def try_one(name: str, command: list[str], place: Path, source: Path | None = None) -> None:
    """Kill a command with the folder `{}`, which begins as a copy of a source."""
    rest = [argument.replace("{}", "whole") for argument in command]
    os.chdir(place)
    for folder in ("whole", "killed"):
        shutil.rmtree(folder, ignore_errors=True)
        if source is not None:
            shutil.copytree(source, folder)
    seconds = whole(rest)
    right = files(Path("whole"))
    there = Path("killed")
    killed = ended = 0
    kept = 0
    while killed < KILLS:
        process = start([argument.replace("{}", "killed") for argument in command])
        time.sleep(random.uniform(0.0, 1.1 * seconds))
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            killed += 1
        process.wait()
        found = files(there) if there.exists() else {}
        for path, bytes_ in found.items():
            parts = Path(path).parts
            if any(part.startswith(".riffel-") for part in parts) or parts[-1] in GROWING or parts[-1] == "mine.txt":
                continue
            assert path in right and bytes_ == right[path], f"{name}: {path} is not as it should be after kill {killed}"
        if "mine.txt" in found:
            assert found["mine.txt"] == b"mine", name
            kept += 1
        elif found and len(found) > 3:
            (there / "mine.txt").write_text("mine")
        if process.returncode in (0, 1):
            ended += 1
            check_end(name, there, right)
            # From the beginning, but for what starts from results.
            shutil.rmtree(there)
            if source is not None:
                shutil.copytree(source, there)
    whole([argument.replace("{}", "killed") for argument in command])
    check_end(name, there, right)
    print(f"{name}: {killed} kills in {seconds:.1f} s each, {ended} runs came to their end between; nothing lost", flush=True)


def check_end(name: str, folder: Path, right: dict[str, bytes]) -> None:
    found = files(folder)
    found.pop("mine.txt", None)
    for path in sorted(set(found) | set(right)):
        assert found.get(path) == right.get(path), f"{name}: in the end {path} differs"


def main() -> None:
    random.seed(1)
    place = Path(tempfile.mkdtemp())
    (place / "study.toml").write_text(STUDY.format(root=ROOT))
    for kind in ("nuts", "ensemble", "smc"):
        warmup = "" if kind == "smc" else "warmup = 250"
        (place / f"{kind}.toml").write_text(PLAN.format(set=SET, kind=kind, warmup=warmup, draws=100 if kind == "smc" else 260))
    rows = [f"left,{cell},{cell + 1},{1e-6 * (1 + cell * 7919 % 13):.3e}" for cell in range(300_000)]
    (place / "blocks.csv").write_text("\n".join(["rail,from_m,to_m,rms_30_to_100_mm_m", *rows]) + "\n")
    wear = ["--spectrum", "iso-3095-2013", "--speed", "30", "--passages", "1000000", "--length", "6", "-o", "{}"]
    ingest = ["network", "ingest", "{}", "blocks.csv", "--line", "A", "--date", "2026-01-31"]
    writers = {
        "study": ["study", "study.toml", "-o", "{}"],
        "network ingest": ingest,
        "simulate --passages": ["simulate", str(ROOT / "cases/nominal.toml"), *wear],
        **{f"calibrate {kind}": ["calibrate", f"{kind}.toml", "-o", "{}", "--restart"] for kind in ("nuts", "ensemble", "smc")},
    }
    for name, command in writers.items():
        if not WRITERS or name in WRITERS:
            try_one(name, command, place)
    if not WRITERS or "decide" in WRITERS:
        os.chdir(place)
        whole(["calibrate", "nuts.toml", "-o", "calibrated", "--restart"])
        try_one("decide", ["decide", "{}"], place, place / "calibrated")
    shutil.rmtree(place)


main()
