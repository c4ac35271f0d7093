"""Motion: a wheel over a wave in time beside the linear loop, and a wheelset in its modes."""

import json
import subprocess

import pytest
from conftest import PROGRAM, ROOT
from test_figures import given

pytestmark = pytest.mark.without_remedies

CURVES = """() => document.getElementById('wave').data.map(({ x, y, yaxis, name, line }) => ({ x, y, yaxis, dashed: line.dash === 'dash' }))"""


def amplitude(page, text):
    page.page.fill("#wave-amplitude", text)
    page.page.press("#wave-amplitude", "Tab")


def curves(page):
    return page.page.evaluate(CURVES)


def test_a_small_wave_is_linear_and_a_large_one_parts(page, tmp_path):
    page.page.click("#tab-motion")
    page.until(lambda: page.page.locator("#wave .main-svg").count() > 0)
    amplitude(page, "0.1")
    page.until(lambda: max(curves(page)[0]["y"]) == pytest.approx(0.1))
    _, force, linear, _, dissipated, of_loop = curves(page)
    assert not force["dashed"] and linear["dashed"]
    # A thousandth of the static load; what is left is of second order in the amplitude and in the step of the march.
    for one, other in [(force, linear), (dissipated, of_loop)]:
        swing = max(other["y"]) - min(other["y"])
        assert swing > 0
        assert max(abs(a - b) for a, b in zip(one["y"], other["y"], strict=True)) < 0.02 * swing
    assert "holds" in page.text("#wave-words")
    amplitude(page, "150")
    page.until(lambda: "in the air" in page.text("#wave-words"))
    page.until(lambda: max(curves(page)[0]["y"]) == pytest.approx(150))
    _, force, linear, *_ = curves(page)
    assert min(force["y"]) == 0 and min(linear["y"]) < 0
    # As the program has it at the same place of the map.
    point = page.page.evaluate("() => window.riffel.state.point")
    command = [
        PROGRAM, "simulate", str(ROOT / "cases/nominal.toml"), "--sinusoid", f"150um,{point['wavelength']} m", "--speed", f"{point['speed']} m/s", "--json", "--quiet",
    ]
    document = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    assert f"{100 * document['contact_loss_fraction']:.2g} %" in page.text("#wave-words")
    assert max(force["y"]) == pytest.approx(1e-3 * document["maximum_normal_force_n"], rel=1e-3)
    assert page.page.evaluate("() => document.getElementById('wave').layout.shapes.length") > 0
    page.keep("passage", whole=True)
    # A unit with the number counts, and another quantity is none.
    amplitude(page, "0.05 mm")
    page.until(lambda: max(curves(page)[0]["y"]) == pytest.approx(50))
    assert page.text("#wave-amplitude-echo") == "= 50 µm"
    amplitude(page, "1000")
    page.until(lambda: "choose a smaller amplitude" in page.text("#wave-words"))
    assert page.text("#wave-words").startswith("a sinusoid of 1000.0 µm and ")
    page.complaints.clear()
    amplitude(page, "50 kN")
    assert "no unit of this field" in page.text("#wave-amplitude-fault")
    amplitude(page, "3000")
    assert page.text("#wave-amplitude-fault") == "amplitude of the wave: 3000, but must be 0.01 to 2000 µm."


def test_a_wheelset_moves_in_its_modes(open_page):
    page = open_page(reduced_motion="no-preference")
    page.page.click("#tab-motion")
    page.until(lambda: "no axle" in page.text("#wheelset-words"))
    page.open_case((ROOT / "cases/curve.toml").read_text(), "curve.toml")
    page.until(lambda: page.page.locator("#wheelset-modes input").count() > 3)
    page.settle()
    command = [PROGRAM, "wheelset", str(ROOT / "cases/curve.toml"), "--json", "--quiet"]
    document = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    modes = [one["name"] for one in document["natural_frequencies"]]
    assert page.page.locator("#wheelset-modes label span").all_inner_texts() == modes
    shape = lambda: page.page.locator("#wheelset-drawing svg").inner_html()
    bending = next(k for k, name in enumerate(modes) if "bending" in name)
    page.page.locator("#wheelset-modes input").nth(bending).check()
    before = shape()
    page.until(lambda: shape() != before)
    page.page.click("#wheelset-play")
    held = shape()
    page.pause()
    assert shape() == held
    page.page.locator("#wheelset-modes input").nth(next(k for k, name in enumerate(modes) if "torsion" in name)).check()
    assert shape() != held
    for kind in ("svg", "csv"):
        text = given(page, "wheelset-drawing", kind)
        assert (b"<svg" if kind == "svg" else b"frequency_hz,mode") in text[:300]
    page.keep("wheelset-modes", whole=True)
    page.close(complaints=len(page.complaints))


@pytest.mark.without_curves
def test_who_asks_for_no_motion_sees_none(open_page):
    page = open_page(reduced_motion="reduce")
    page.open_case((ROOT / "cases/curve.toml").read_text(), "curve.toml")
    page.settle()
    page.page.click("#tab-motion")
    page.until(lambda: page.page.locator("#wheelset-drawing svg").count() > 0)
    shape = lambda: page.page.locator("#wheelset-drawing svg").inner_html()
    still = shape()
    page.pause()
    assert shape() == still
    page.page.click("#wheelset-play")
    page.until(lambda: shape() != still)
    page.close(complaints=len(page.complaints))


@pytest.mark.without_curves
def test_what_is_of_another_case_is_pale_and_named(page):
    """As long as the answer to a changed case is not there, and at once when the view is opened again."""
    page.page.click("#tab-motion")
    wave, wheelset = page.page.locator("#wave-at"), page.page.locator("#wheelset-of")
    page.until(lambda: "BR main line" in wave.inner_text())
    pale = lambda: page.page.locator("#view-motion .stale").count()
    page.settle()
    assert pale() == 0
    page.page.click("#tab-explore")
    kept = []
    page.page.route("**/api/passage", lambda route: kept.append(route))
    page.set("title", "another case")
    page.set("wheel.mass", "500 kg")
    page.until(lambda: page.page.evaluate("() => window.riffel.state.current"))
    page.page.click("#tab-motion")
    page.until(lambda: kept)
    # What is drawn is that of the case before, and says so.
    page.until(lambda: pale() == 1)
    assert "BR main line" in wave.inner_text()
    for route in kept:
        route.continue_()
    page.page.unroute("**/api/passage")
    page.until(lambda: "another case" in wave.inner_text() and pale() == 0)
    assert wheelset.inner_text() == "“another case”"


def test_where_the_loop_oscillates_without_a_profile(page):
    page.page.click("#tab-motion")
    # A lone wheel on one axis does not: the panel says what it would take.
    page.until(lambda: "contact.from" in page.text("article:has(#stability)"))
    assert not page.page.locator("#stability").is_visible()
    page.open_case((ROOT / "cases/curve.toml").read_text(), "curve.toml")
    page.until(lambda: page.page.locator("#stability .main-svg").count() > 0)
    page.settle()
    command = [PROGRAM, "stability", str(ROOT / "cases/curve.toml"), "--json", "--quiet"]
    document = json.loads(subprocess.run(command, capture_output=True, check=True, text=True).stdout)
    expected = [[3.6 * point["speed_m_per_s"], point["friction"]] for point in document["points"] if point["frequency_hz"] is not None]
    drawn = page.page.evaluate("() => document.getElementById('stability').data.flatMap(({ x, y }) => x.map((speed, k) => [speed, y[k]]))")
    assert 0 < len(expected) < len(document["points"])
    assert sorted(drawn) == [pytest.approx(point) for point in sorted(expected)]
    [branch] = document["branches"]
    assert f"{branch['friction_min']:.3f}" in page.text("#stability-words")
    rows = given(page, "stability", "csv").decode().splitlines()
    assert len(rows) == len(document["points"]) + 1 and rows[0].startswith("speed_m_per_s,friction")
    page.keep("stability", whole=True)
    page.page.select_option("#language", "de")
    assert "Reibung" in page.text("#stability-words")
    # Where the loop is unstable no wave settles in time, and the panel beside says so.
    page.complaints.clear()


def test_damage_is_that_of_the_program(page, tmp_path):
    """Shakedown over the wave at the cursor, and cracks where fatigue is among the laws."""
    fatigue = (ROOT / "cases/class-contact-fatigue.toml").read_text().replace('laws = ["wear"]  ', 'laws = ["wear", "fatigue"]')
    for before, after in [('loss = "1 mm"', 'loss = "1 mm", crack_growth = "1 mm"'), ("tractive_ratio = 0.3 ", "tractive_ratio = 0.5 "), ("0.3e-9 kg/J", "2.5e-10 kg/J")]:
        assert before in fatigue
        fatigue = fatigue.replace(before, after)
    (tmp_path / "fatigue.toml").write_text(fatigue)
    # The usual traffic of a metro: 40 to 70 km/h, which even speeds have the standard deviation of.
    (tmp_path / "traffic.toml").write_text('[line]\npassages_per_day = 6000\n[[vehicle]]\nname = "any"\nshare = 1\nspeed = { mean = "55 km/h", standard_deviation = "8.6602540378443865 km/h" }\n')
    page.page.click("#tab-motion")
    page.until(lambda: "Mean state: p₀/k" in page.text("#damage-words"))
    assert not page.page.locator("#cracks").is_visible()
    page.open_case(fatigue, "fatigue.toml")
    page.until(lambda: page.page.locator("#cracks tbody tr").count() > 0)
    page.settle()
    point = page.page.evaluate("() => window.riffel.state.point")

    def told(*command):
        run = subprocess.run([PROGRAM, *command, "--json", "--quiet"], cwd=tmp_path, capture_output=True, text=True)
        assert run.returncode == 0, run.stderr
        return json.loads(run.stdout)

    shakedown = told("shakedown", "fatigue.toml", "--wavelength", f"{point['wavelength']!r} m", "--speed", f"{point['speed']!r} m/s")
    drawn = page.page.evaluate("() => document.getElementById('damage').data.map(({ x, y }) => [x, y])")
    loop = [[row[key] for row in [*shakedown["loop"], shakedown["loop"][0]]] for key in ("utilised_friction", "p0_over_k")]
    # Four limits first, then the orbit; the place of the wave is written in decimal digits that hold it.
    assert drawn[4] == [pytest.approx(one, rel=1e-9) for one in loop]
    [low], [high] = ([row["p0_over_k"] for row in shakedown["loop"] if row["phase_deg"] == degrees] for degrees in (180, 0))
    assert [drawn[6][1], drawn[7][1]] == [[pytest.approx(high)], [pytest.approx(low)]]
    # Cracks after a year under the usual traffic of the line, from a rail that is 6 dB below the limit.
    forecast = told("forecast", "fatigue.toml", "--from-limit=-6 dB", "--traffic", "traffic.toml", "--months", "12")
    expected = {phase: [crack for crack in forecast["cracks"] if crack["phase"] == phase] for phase in ("crest", "trough")}
    rows = page.page.locator("#cracks tbody tr").evaluate_all("(rows) => rows.map((row) => [...row.cells].map(({ textContent }) => Number(textContent.replace('−', '-'))))")
    assert any(row[1] != row[3] and row[1] > 0 for row in rows)
    for row, crest, trough in zip(rows, expected["crest"], expected["trough"], strict=True):
        numbers = [1e3 * crest["wavelength_m"], *(value for crack in (crest, trough) for value in (1e3 * crack["crack_length_m"], crack["crack_growth_mm_per_month"]))]
        # Three digits are shown.
        assert row == [pytest.approx(number, rel=6e-3, abs=1e-12) for number in numbers]
    page.keep("damage", whole=True)
    page.page.select_option("#language", "de")
    assert "ausgenutzter Kraftschluss" in page.text("#damage-words") and "Riss auf dem Berg" in page.text("#cracks")
    page.complaints.clear()
