"""What a train sounds like on a measured rail: the levels of the program, measures, the months ahead, a limit of one's own."""

import json
import math
import re
import subprocess

import pytest
from conftest import PROGRAM, ROOT
from test_page import profile

pytestmark = pytest.mark.without_remedies

CASE = ROOT / "cases/main-line.toml"
# On this one the corrugation of the record grows.
GROWING = ROOT / "cases/class-soft-slab.toml"
# Mean and width of the speeds of the usual traffic, 80 to 140 km/h on a main line and 40 to 70 km/h in a metro.
SPEEDS = {CASE: (110, 60), GROWING: (55, 30)}


def show_noise(page, case=CASE):
    page.open_case(case.read_text(), case.name)
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "trolley.csv", "mimeType": "text/csv", "buffer": profile(30)}])
    page.until(page.page.locator("#noise-panel").is_visible)


def by_the_program(folder, *more, case=CASE):
    mean, width = SPEEDS[case]
    (folder / "trolley.csv").write_bytes(profile(30))
    (folder / "traffic.toml").write_text(
        '[line]\npassages_per_day = 6000\n[[vehicle]]\nname = "wheel"\nshare = 1\n'
        f'speed = {{ mean = "{mean} km/h", standard_deviation = "{width / math.sqrt(12)} km/h" }}\n'
    )
    command = [PROGRAM, "noise", case, "--roughness", "trolley.csv", "--speed", f"{mean} km/h", "--traffic", "traffic.toml", "--json", *more]
    return json.loads(subprocess.run(command, cwd=folder, capture_output=True, check=True, text=True).stdout)


def cells(page, table):
    return [row.split("\t") for row in page.page.locator(f"#{table} tbody tr").all_inner_texts()]


def data(page, place):
    return page.page.evaluate("(place) => (document.getElementById(place).data ?? []).map(({ name, x, y }) => ({ name, x, y }))", place)


def test_the_level_is_that_of_the_program(page, tmp_path):
    show_noise(page)
    own = by_the_program(tmp_path)
    level = own["level"]
    # A digit after the point on the page.
    [shown] = cells(page, "noise-parts")
    assert shown[0] == "dB(A)" and shown[1:] == [f"{level[f'{part}_dba']:.1f}" for part in ("rail", "sleepers", "wheel", "total")]
    assert f"{level['total_dba']:.1f} dB(A)" in page.text("#noise-verdict") and "at 110 km/h" in page.text("#noise-verdict")
    rows = cells(page, "noise-measures")
    assert [row[0] for row in rows] == [measure["title"] for measure in own["measures"]] and len(rows) >= 5
    assert [row[2] for row in rows] == [f"{measure['saved_db']:.1f}".replace("-", "−") for measure in own["measures"]]
    page.until(lambda: len(data(page, "noise-course")) == 1)
    bands = {curve["name"]: curve for curve in data(page, "noise-bands")}
    assert set(bands) == {"rail", "sleepers", "wheel", "total"}
    assert bands["total"]["x"] == own["frequency_hz"]
    # Speeds come over the page as m/s in decimal digits.
    assert bands["total"]["y"] == pytest.approx(level["total_db"], abs=1e-6)
    [course] = data(page, "noise-course")
    assert course["x"] == pytest.approx(own["course"]["month"], rel=1e-6) and course["y"] == pytest.approx(own["course"]["total_dba"], abs=1e-6)
    page.settle()
    page.keep("noise", whole=True)


@pytest.mark.without_curves
@pytest.mark.parametrize("case", [CASE, ROOT / "cases/metro.toml"])
def test_the_report_of_a_rail_has_level_and_causes_of_the_page(page, tmp_path, case):
    """`riffel report` is told of no traffic, and the page neither: both go by the usual one of the line."""
    given = {}
    for what in ("measure", "noise"):
        page.page.on("response", lambda response, what=what: response.url.endswith(f"/api/ask/{what}") and response.ok and given.update({what: json.loads(response.text())}))
    show_noise(page, case)
    page.until(lambda: len(given) == 2)
    (tmp_path / "trolley.csv").write_bytes(profile(30))
    subprocess.run([PROGRAM, "report", case, "--roughness", "trolley.csv", "-o", "report.html", "--quiet"], cwd=tmp_path, capture_output=True, check=True, text=True)
    report = (tmp_path / "report.html").read_text()
    assert f"{given['noise']['level']['total_dba']:.1f} dB(A)" in report
    shares = [candidate["share"] for finding in given["measure"]["diagnosis"]["dominant_wavelengths"] for candidate in finding["candidates"]]
    # A digit of a percent is drawn.
    assert [float(width) / 100 for width in re.findall(r'<span class="bar"><i style="width:([\d.]+)%', report)] == pytest.approx(shares, abs=6e-4) and len(shares) > 3


@pytest.mark.without_curves
def test_a_wheel_that_rings_is_that_of_the_program(page, tmp_path):
    answers = []
    page.page.on("response", lambda response: response.url.endswith("/api/ask/noise") and response.ok and answers.append(json.loads(response.text())))
    show_noise(page)
    page.until(lambda: answers and answers[-1]["wheel_modes"] is None)
    page.page.select_option("#noise-wheel", "straight-web-920")
    page.until(lambda: answers[-1]["wheel_modes"] == "straight-web-920" and not page.page.locator("#noise-panel.stale").count())
    own = by_the_program(tmp_path, "--wheel-modes", "straight-web-920")["level"]
    assert answers[-1]["level"]["total_dba"] == pytest.approx(own["total_dba"], rel=0, abs=1e-9)
    assert abs(own["wheel_dba"] - answers[0]["level"]["wheel_dba"]) > 0.5
    [shown] = cells(page, "noise-parts")
    assert shown[1:] == [f"{own[f'{part}_dba']:.1f}" for part in ("rail", "sleepers", "wheel", "total")]
    page.page.select_option("#language", "de")
    assert page.page.locator("#noise-wheel option").all_text_contents() == ["starr", "gerader Steg, 920 mm"]
    page.page.reload()
    page.until(page.page.locator("#noise-panel").is_visible)
    assert page.page.locator("#noise-wheel").input_value() == "straight-web-920" and answers[-1]["wheel_modes"] == "straight-web-920"


def test_a_limit_of_ones_own_is_told_in_months(open_page, tmp_path):
    page = open_page(locale="de-DE", color_scheme="dark", viewport={"width": 360, "height": 780})
    show_noise(page, GROWING)
    levels = by_the_program(tmp_path, case=GROWING)["course"]["total_dba"]
    limit = round((levels[0] + levels[-1]) / 2, 2)
    field = page.page.locator("#noise-limit")
    field.fill(str(limit).replace(".", ","))
    field.press("Tab")
    months = by_the_program(tmp_path, "--limit-dba", str(limit), case=GROWING)["course"]["months_to_limit"]
    assert 0 < months < 12
    page.until(lambda: f"sind in {months:.3g} Monaten erreicht".replace(".", ",") in page.text("#noise-outlook"))
    page.until(lambda: [curve["y"] for curve in data(page, "noise-course") if curve["name"] == "Grenze"] == [[limit, limit]])
    page.fits()
    page.settle()
    page.keep("noise-dark-360", whole=True)
    # Every measure in the language of the page.
    titles = [row[0] for row in cells(page, "noise-measures")]
    assert titles[0].startswith("Schiene geschliffen auf") and "Zwischenlagen halber Steifigkeit" in titles
    assert not [title for title in titles if title.startswith(("rail", "pads"))]
    for wrong, told in [("laut", "keine Zahl"), ("500", "0 bis 200 dB(A)")]:
        field.fill(wrong)
        field.press("Tab")
        page.until(page.page.locator("#noise-limit-fault").is_visible)
        assert told in page.text("#noise-limit-fault") and field.get_attribute("aria-invalid") == "true"
    field.fill("")
    field.press("Tab")
    page.until(lambda: "erreicht" not in page.text("#noise-outlook"))
    assert not page.page.locator("#noise-limit-fault").is_visible()
    page.close()


@pytest.mark.without_curves
def test_a_track_without_a_level_says_so(page):
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "trolley.csv", "mimeType": "text/csv", "buffer": profile(10)}])
    # A free rail carries vibration on without end; what a moving one carries is not known.
    for model in ["free-beam", "moving-beam"]:
        page.set("track.model", model)
        page.until(lambda: page.page.locator("#noise-panel").is_visible() and not page.page.locator("#noise-panel.stale").count())
        assert "has no level" in page.text("#noise-verdict")
        assert not page.page.locator("#noise-parts").is_visible() and not page.page.locator("#noise-help-panel").is_visible()
    page.page.select_option("#language", "de")
    assert "hat keinen Pegel" in page.text("#noise-verdict")
