"""Curve: growth of the case under each wheel of the bogie, its mean state in the case, and files that stand the wrong way round."""

import json
import pathlib
import subprocess

import pytest
from conftest import PROGRAM, ROOT

PROFILES = pathlib.Path(__file__).resolve().parents[2] / "riffel-rail/tests/profiles"
# Under trains within a tenth of 45 km/h, the speed of the curve.
GROWTH = """async () => {
  const body = { case: { keys: window.riffel.state.accepted }, traffic: { vehicle: [{ name: 'any', share: 1, speed: { mean: 12.5, standard_deviation: 2.5 / Math.sqrt(12) } }] } };
  const answer = await fetch('/api/line', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) });
  return (await answer.json()).fastest.growth_rate_per_passage;
}"""


def wheels_of_the_program(folder):
    """The nominal case under the bogie that the view begins with, as `riffel map --wheels` has it."""
    curve = (ROOT / "crates/riffel-case/cases/metro-curve.toml").read_text()
    (folder / "curve.toml").write_text(curve)
    given = ("tractive_ratio", "transverse_radius", "normal_load", "friction", "rolling_radius")
    lines = [line for line in (ROOT / "cases/nominal.toml").read_text().splitlines() if not line.startswith(given)]
    asked = '[contact]\ncreep_law = "fastsim"\nfrom = { curve = "curve.toml", wheelset = 1, rail = "low" }'
    (folder / "case.toml").write_text("\n".join(lines).replace("[contact]", asked))
    done = subprocess.run([PROGRAM, "map", "case.toml", "--wheels", "--json", "--quiet"], cwd=folder, capture_output=True, check=True, text=True)
    return [wheel for wheel in json.loads(done.stdout)["wheels"] if wheel["share_of_second_contact"] <= 0.5]


@pytest.mark.without_curves
def test_a_wheel_of_the_bogie_becomes_that_of_the_case(page, tmp_path):
    expected = wheels_of_the_program(tmp_path)
    page.page.click("#tab-curve")
    figures = page.page.locator("#growth-of-wheels figure")
    page.until(lambda: figures.count() == 4 and page.page.locator("#view-curve .panel.stale").count() == 0)
    for figure, wheel in zip(figures.all(), expected, strict=True):
        text = figure.inner_text()
        assert f"Wheelset {wheel['wheelset']}, {wheel['rail']} rail" in text
        assert f"{wheel['highest']['wavelength_m'] * 1e3:.3g} mm, {wheel['highest']['frequency_hz']:.3g} Hz" in text
        assert ("edge of the window" in text) == wheel["highest"]["at_edge"]
        # Under the usual traffic of the page; 96 days is the fastest doubling known.
        assert ("to double: faster than any railway known" in text) == (wheel["highest"]["doubling_passages"] / 6000 < 95.97), text
    page.keep("growth-of-wheels", whole=True)
    # The second wheelset on the low rail is the wheel of the case, with the growth that its picture told.
    figures.nth(2).get_by_role("button").click()
    page.until(lambda: page.page.evaluate("() => window.riffel.state.current"))
    page.settle()
    wheel = expected[2]
    contact = page.page.evaluate("() => window.riffel.state.accepted.contact")
    assert "tractive_ratio" not in contact and contact["creep_law"] == "fastsim"
    for axis in ("longitudinal", "lateral"):
        # Five digits are written.
        assert contact["creepage"][axis] == pytest.approx(wheel[f"{axis}_creepage"], rel=1e-4)
    found = page.page.evaluate(GROWTH)
    # Growth turns on the difference of two phases, which makes ten times as much of the last digit.
    assert found == pytest.approx(wheel["highest"]["growth_rate_per_passage"], rel=1e-3)
    assert "Wheelset 2, low rail" in page.text("#notice")
    page.page.click("#undo")
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.keys.contact.tractive_ratio") == 0.1
    assert page.page.evaluate("() => window.riffel.state.keys.contact.creepage") is None


@pytest.mark.without_curves
def test_a_case_that_changes_changes_the_growth_of_its_wheels(page):
    page.page.click("#tab-curve")
    figures = page.page.locator("#growth-of-wheels figure")
    page.until(lambda: figures.count() == 4)
    page.settle()
    before = page.text("#growth-of-wheels")
    page.set("wheel.mass", "900 kg")
    page.until(lambda: page.text("#growth-of-wheels") != before)
    # Where the bogie does not stand there is no growth.
    page.page.fill("#curve-radius", "20")
    page.page.press("#curve-radius", "Tab")
    page.until(page.page.locator("#no-equilibrium").is_visible)
    assert not page.page.locator("#wheels-panel").is_visible()


def test_a_file_that_stands_the_wrong_way_round_is_turned(page):
    """A wheel whose x is written toward the gauge, in columns, which nothing tells but its shape."""
    lines = (ROOT / "cases/worn-wheel.csv").read_text().splitlines()
    rows = [line.split(",") for line in lines]
    mirrored = "\n".join(",".join([f"-{row[0]}" if row[0][:1] != "-" else row[0][1:], *row[1:]]) if row[0].lstrip("-")[:1].isdigit() else ",".join(row) for row in rows)
    page.page.click("#tab-curve")
    page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4)
    orientation = page.page.locator("#orientation-wheel")
    assert not orientation.is_visible()
    drawn = "() => document.getElementById('outlines').data[0].y"
    page.give("#profile-file-wheel", str(ROOT / "cases/worn-wheel.csv"))
    page.until(orientation.is_visible)
    page.settle()
    right = page.page.evaluate(drawn)
    page.give("#profile-file-wheel", files=[{"name": "mirrored.csv", "mimeType": "text/csv", "buffer": mirrored.encode()}])
    page.page.select_option("#orientation-wheel", "as-written")
    page.until(lambda: page.page.evaluate(drawn) != pytest.approx(right))
    page.page.select_option("#orientation-wheel", "mirrored")
    page.until(lambda: page.page.evaluate(drawn) == pytest.approx(right))
    page.settle()
    page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4 and page.page.locator("#no-equilibrium").is_hidden())
    page.keep("mirrored-wheel", whole=True)
    # It is kept over a reload.
    page.page.reload()
    page.until(lambda: orientation.is_visible() and orientation.input_value() == "mirrored")
    page.settle()
    page.complaints.clear()


@pytest.mark.without_curves
def test_the_bogie_is_drawn_on_its_gauge(page):
    page.page.click("#tab-curve")
    page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4)
    page.settle()
    # Rails lie apart by the gauge and the breadth of a head, 0.07 m, to the millimetre that is drawn.
    apart = "() => { const at = [...document.querySelectorAll('#bogie-above .rail')].map((rail) => Number(rail.getAttribute('points').split(' ')[20].split(',')[1])); return at[1] - at[0]; }"
    assert page.page.evaluate(apart) == pytest.approx(1.435 + 0.07, abs=1.1e-3)
    page.page.fill("#curve-gauge", "1480")
    page.page.press("#curve-gauge", "Tab")
    page.until(lambda: page.page.evaluate(apart) == pytest.approx(1.48 + 0.07, abs=1.1e-3))
