"""Earlier records of a rail and several vehicles on it: the same answers as from the program, and what is refused."""

import json
import math
import random
import subprocess

import pytest
from conftest import PROGRAM
from test_german import english, panels
from test_noise import GROWING, by_the_program

DAILY = 4000
# Name, share, speeds, wheel load and tractive ratio.
VEHICLES = [("tram", 0.7, [40, 60], None, None), ("works car", 0.3, [20, 70], 55e3, 0.05)]
DATES = ["2025-05-01", "2026-05-01"]


def record(height, seed=1, metres=12):
    """Two rails with corrugation of 40 mm, so many µm high on the left one, on a rough floor."""
    random.seed(seed)
    rows, left, right = ["position_m,left_um,right_um"], 0.0, 0.0
    for k in range(1000 * metres):
        left, right = 0.995 * left + random.gauss(0, 0.4), 0.995 * right + random.gauss(0, 0.4)
        rows.append(f"{k / 1000:.3f},{height * math.sin(2 * math.pi * k / 40) + left:.3f},{right:.3f}")
    return "\n".join(rows) + "\n"


def files(**texts):
    return [{"name": f"{name}.csv", "mimeType": "text/csv", "buffer": text.encode()} for name, text in texts.items()]


def type_into(page, field, text):
    page.page.fill(field, text)
    page.page.press(field, "Tab")


def add_vehicles(page):
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    type_into(page, "#traffic-daily", str(DAILY))
    for k, (name, _, speeds, load, traction) in enumerate(VEHICLES):
        page.page.click("#add-vehicle")
        type_into(page, f"#vehicle-{k}-name", name)
        # The second begins with the speeds of the first.
        for end in ("from", "to") if k == 1 else ("to", "from"):
            type_into(page, f"#vehicle-{k}-{end}", f"{speeds[end == 'to']} km/h")
        if load:
            type_into(page, f"#vehicle-{k}-wheel", f"{load:g} N")
        if traction:
            type_into(page, f"#vehicle-{k}-tractive", f"{100 * traction:g} %")
    for k, (_, share, *_) in enumerate(VEHICLES):
        type_into(page, f"#vehicle-{k}-share", f"{100 * share:g}")


def traffic_file():
    text = f"[line]\npassages_per_day = {DAILY}\n"
    for name, share, (slow, fast), load, traction in VEHICLES:
        text += f'[[vehicle]]\nname = "{name}"\nshare = "{100 * share:g} %"\n'
        if load:
            text += f'wheel_load = "{load / 1e3:g} kN"\ntractive_ratio = {traction}\n'
        # Of speeds spread evenly: their standard deviation, or the middles of sixteenths where that would reach below standstill.
        mean, deviation = (slow + fast) / 2, (fast - slow) / math.sqrt(12)
        if 4 * deviation < mean:
            text += f'speed = {{ mean = "{mean} km/h", standard_deviation = "{deviation} km/h" }}\n'
        else:
            middles = [slow + (fast - slow) * (k + 0.5) / 16 for k in range(16)]
            text += "speeds = [" + ", ".join(f'{{ speed = "{speed} km/h", share = {1 / 16} }}' for speed in middles) + "]\n"
    return text


def test_two_dated_records_and_two_vehicles_are_answered_as_by_the_program(page, tmp_path):
    page.page.locator("#open-toml").set_input_files(str(GROWING))
    page.until(lambda: page.page.evaluate("() => window.riffel.state.current && Boolean(window.riffel.state.keys.rail)"))
    add_vehicles(page)
    assert not page.page.locator("#trouble").is_visible() and not page.page.locator("#traffic-from").is_visible()
    texts = {"before": record(8, seed=2), "now": record(14)}
    page.page.click("#tab-measure")
    page.page.set_input_files("#record", files=files(now=texts["now"]))
    page.until(page.page.locator("#earlier").is_visible)
    # Nothing of dates before there is something to compare with.
    assert not page.page.locator("#record-date").is_visible()
    page.page.set_input_files("#earlier-file", files=files(before=texts["before"]))
    page.page.locator("#earlier-records input").wait_for()
    given = {}
    page.page.on("response", lambda response: response.url.endswith("/api/measure") and response.ok and given.update(json.loads(response.text())))
    page.page.fill("#record-date", DATES[1])
    page.page.locator("#earlier-records input").fill(DATES[0])
    page.until(lambda: (given.get("forecast") or {}).get("wear_fit"), seconds=60)

    for name, text in texts.items():
        (tmp_path / f"{name}.csv").write_text(text)
    (tmp_path / "traffic.toml").write_text(traffic_file())

    def program(command, *more):
        words = [PROGRAM, command, GROWING, "--traffic", "traffic.toml", "--earlier", "before.csv", "--json", *more]
        return json.loads(subprocess.run(words, cwd=tmp_path, capture_output=True, check=True, text=True).stdout)

    diagnosis = program("diagnose", "--roughness", "now.csv", "--dates", ",".join(DATES))
    forecast = program("forecast", "--spectrum", "now.csv", "--months", "12", "--passages-between", str(365 * DAILY))
    page.until(lambda: page.page.locator(".course").count() > 0)
    for own, there in [(given["diagnosis"], diagnosis), (given["forecast"], forecast)]:
        # Speeds come over the page in m/s, which costs a bit or two of the last digits.
        numbers(own, there)
    [first, *_] = diagnosis["dominant_wavelengths"]
    course = first["course"]
    assert course["records"] == DATES and course["levels_db"][1] - course["levels_db"][0] == pytest.approx(20 * math.log10(14 / 8), abs=0.3)
    shown = page.page.locator(".course").first.inner_text()
    assert f"{DATES[0]} {course['levels_db'][0]:.1f} dB, {DATES[1]} {course['levels_db'][1]:.1f} dB" in shown and "a year" in shown
    fit = forecast["wear_fit"]
    outlook = page.text("#view-measure")
    assert "1.5 million axle passages" in outlook and all(sentence.split(": forecast with")[0] in outlook for sentence in fit["sentences"])
    # Both rails of then beside both of now, by their dates.
    page.until(lambda: sum(DATES[0] in name for name in spectra(page)) == 2)
    levels = spectra(page)
    at = lambda name: levels[name][min(levels[name], key=lambda wavelength: abs(wavelength - 40))]
    assert at("rail left, Now") - at(f"rail left, {DATES[0]}") == pytest.approx(20 * math.log10(14 / 8), abs=0.3)
    page.page.wait_for_timeout(300)
    page.keep("earlier", whole=True)
    # The report has the dates, too, and no name of a file that the user does not know.
    with page.page.expect_download() as download:
        page.page.click("#report")
    download.value.save_as(tmp_path / "report.html")
    report = (tmp_path / "report.html").read_text()
    assert "before.csv" in report and "earlier-1" not in report and "works car" in report


def spectra(page):
    data = page.page.evaluate("() => (document.getElementById('spectrum').data ?? []).map(({ name, x, y }) => [name, x, y])")
    return {name: dict(zip(x, y)) for name, x, y in data}


def numbers(own, there, where=""):
    """The same document, its numbers to nine digits."""
    if isinstance(there, dict):
        assert own.keys() == there.keys(), where
        for key, value in there.items():
            # What was asked is written in other words.
            if key not in ("inputs", "file"):
                numbers(own[key], value, f"{where}.{key}")
    elif isinstance(there, list):
        assert len(own) == len(there), where
        for k, value in enumerate(there):
            numbers(own[k], value, f"{where}[{k}]")
    elif isinstance(there, float) and isinstance(own, (int, float)):
        assert own == pytest.approx(there, rel=1e-9, abs=1e-12), where
    else:
        assert own == there, where
