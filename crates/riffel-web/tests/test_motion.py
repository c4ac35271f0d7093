"""Motion: a wheel over a wave in time beside the linear loop, a wheelset in its modes, stability and damage."""

import pytest
from conftest import ROOT, small
from test_figures import given

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]

CURVES = """() => document.getElementById('wave').data.map(({ x, y, yaxis, name, line }) => ({ x, y, yaxis, dashed: line.dash === 'dash' }))"""


def amplitude(page, text):
    page.page.fill("#wave-amplitude", text)
    page.page.press("#wave-amplitude", "Tab")


def curves(page):
    return page.page.evaluate(CURVES)


def test_a_small_wave_is_linear_a_large_one_parts_and_another_case_pales(page):
    page.page.click("#tab-motion")
    page.until(lambda: page.page.evaluate("() => Boolean(document.getElementById('wave').data)"))
    amplitude(page, "0.1")
    page.until(lambda: max(curves(page)[0]["y"]) == pytest.approx(0.1))
    _, force, linear, _, dissipated, of_loop = curves(page)
    assert not force["dashed"] and linear["dashed"]
    # A thousandth of the static load; what is left is of second order in the amplitude and in the step of the march.
    for one, other in [(force, linear), (dissipated, of_loop)]:
        swing = max(other["y"]) - min(other["y"])
        assert 0 < swing and max(abs(a - b) for a, b in zip(one["y"], other["y"], strict=True)) < 0.02 * swing
    assert "holds" in page.text("#wave-words")
    # A unit with the number counts, and another quantity is none.
    amplitude(page, "0.15 mm")
    page.until(lambda: "in the air" in page.text("#wave-words"))
    assert page.text("#wave-amplitude-echo").startswith("= 150 µm;")
    _, force, linear, *_ = curves(page)
    assert min(force["y"]) == 0 and min(linear["y"]) < 0 and page.page.evaluate("() => document.getElementById('wave').layout.shapes.length") > 0
    # A wave that the wheel hardly touches is none.
    amplitude(page, "1000")
    page.until(lambda: "choose a smaller amplitude" in page.text("#wave-words"))
    for text, words in [("50 kN", "no unit of this field"), ("3000", "must be 0.01 to 2000 µm.")]:
        amplitude(page, text)
        assert words in page.text("#wave-amplitude-fault")
    amplitude(page, "20")
    page.settle()
    # As long as the answer to a changed case is not there, what is drawn is that of the case before, and says so.
    pale, wave = lambda: page.page.locator("#view-motion .stale").count(), page.page.locator("#wave-at")
    page.until(lambda: pale() == 0 and "BR main line" in wave.inner_text())
    release = page.hold("**/api/passage")
    page.set("title", "another case")
    page.until(lambda: pale() >= 1)
    assert "BR main line" in wave.inner_text()
    release()
    page.until(lambda: "another case" in wave.inner_text() and pale() == 0)
    page.settle()
    assert page.text("#wheelset-of") == "“another case”"
    # Without the program it says so.
    page.page.route("**/api/passage", lambda route: route.abort())
    amplitude(page, "30")
    page.until(lambda: "does not answer" in page.text("#wave-words"))
    page.settle()
    page.complaints.clear()


def tiny_curve():
    return (ROOT / "cases/curve.toml").read_text().replace('"300 mm" }', '"300 mm", points = 11 }').replace('"15 m/s" }', '"15 m/s", points = 7 }')


def test_a_wheelset_moves_in_its_modes_and_who_asks_for_no_motion_sees_none(page):
    for path in ("line", "passage", "damage", "stability"):
        page.page.route(f"**/api/{path}", lambda route: route.fulfill(status=422, json={"message": "not asked"}))
    wheelsets = page.answers("/api/wheelset")
    page.page.click("#tab-motion")
    page.until(lambda: "no axle" in page.text("#wheelset-words"))
    page.open_case(tiny_curve(), "curve.toml")
    page.until(lambda: page.page.locator("#wheelset-modes input").count() > 3)
    page.settle()
    labels = page.page.locator("#wheelset-modes label span").all_inner_texts()
    assert len(labels) == len(wheelsets[-1]["modes"])
    shape = lambda: page.page.locator("#wheelset-drawing svg").inner_html()
    frame = "() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))"
    still = shape()
    page.page.evaluate(frame)
    assert shape() == still
    page.page.click("#wheelset-play")
    page.until(lambda: shape() != still)
    page.page.click("#wheelset-play")
    held = shape()
    page.page.evaluate(frame)
    assert shape() == held
    page.page.locator("#wheelset-modes input").nth(next(k for k, name in enumerate(labels) if "bending" in name)).check()
    assert shape() != held
    for kind in ("svg", "csv"):
        text = given(page, "wheelset-drawing", kind)
        assert (b"<svg" if kind == "svg" else b"frequency_hz,mode") in text[:300]
    # To who asks for nothing else it moves by itself.
    page.page.emulate_media(reduced_motion="no-preference")
    page.page.reload()
    page.page.locator("#wheelset-drawing svg").wait_for()
    still = shape()
    page.until(lambda: shape() != still)
    page.refused(422)


def test_where_the_loop_oscillates_without_a_profile(page):
    for path in ("line", "passage", "damage", "wheelset"):
        page.page.route(f"**/api/{path}", lambda route: route.fulfill(status=422, json={"message": "not asked"}))
    answers = page.answers("/api/stability")
    page.page.click("#tab-motion")
    # A lone wheel on one axis does not: the panel says what it would take.
    page.until(lambda: "contact.from" in page.text("article:has(#stability)"))
    assert not page.page.locator("#stability").is_visible()
    page.open_case(tiny_curve(), "curve.toml")
    page.until(page.page.locator("#stability").is_visible)
    page.settle()
    points = answers[-1]["points"]
    expected = [[3.6 * point["speed_m_per_s"], point["friction"]] for point in points if point["frequency_hz"] is not None]
    drawn = page.page.evaluate("() => document.getElementById('stability').data.flatMap(({ x, y }) => x.map((speed, k) => [speed, y[k]]))")
    assert 0 < len(expected) < len(points) and sorted(drawn) == [pytest.approx(point) for point in sorted(expected)]
    rows = given(page, "stability", "csv").decode().splitlines()
    assert len(rows) == len(points) + 1 and rows[0].startswith("speed_m_per_s,friction")
    words = page.page.locator("#stability-words")
    assert all(f"{branch['friction_min']:.3f}" in words.inner_text() for branch in answers[-1]["branches"][:1])
    page.speak("de")
    assert "Reibung" in words.inner_text() and f"{answers[-1]['branches'][0]['friction_min']:.3f}".replace(".", ",") in words.inner_text()
    page.refused(422)


def test_damage_is_drawn_over_the_wave_and_cracks_are_a_table(page):
    for path in ("line", "passage"):
        page.page.route(f"**/api/{path}", lambda route: route.fulfill(status=422, json={"message": "not asked"}))
    fatigue = small("class-contact-fatigue")
    for before, after in [('laws = ["wear"]  ', 'laws = ["wear", "fatigue"]'), ('loss = "1 mm"', 'loss = "1 mm", crack_growth = "1 mm"'), ("tractive_ratio = 0.3 ", "tractive_ratio = 0.5 ")]:
        assert before in fatigue
        fatigue = fatigue.replace(before, after)
    answers = page.answers("/api/damage")
    page.page.click("#tab-motion")
    page.until(lambda: "Mean state: p₀/k" in page.text("#damage-words"))
    assert not page.page.locator("#cracks").is_visible()
    page.open_case(fatigue, "fatigue.toml")
    page.until(lambda: page.page.locator("#cracks tbody tr").count() > 0)
    page.settle()
    shakedown, cracks = answers[-1]["shakedown"], answers[-1]["cracks"]
    drawn = page.page.evaluate("() => document.getElementById('damage').data.map(({ x, y }) => [x, y])")
    loop = [[row[key] for row in [*shakedown["loop"], shakedown["loop"][0]]] for key in ("utilised_friction", "p0_over_k")]
    # Four limits first, then the orbit, then crest and trough.
    assert drawn[4] == [pytest.approx(one, rel=1e-9) for one in loop]
    [low], [high] = ([row["p0_over_k"] for row in shakedown["loop"] if row["phase_deg"] == degrees] for degrees in (180, 0))
    assert [drawn[6][1], drawn[7][1]] == [[pytest.approx(high)], [pytest.approx(low)]]
    expected = {phase: [crack for crack in cracks if crack["phase"] == phase] for phase in ("crest", "trough")}
    rows = page.page.locator("#cracks tbody tr").evaluate_all("(rows) => rows.map((row) => [...row.cells].map(({ textContent }) => Number(textContent.replace('−', '-'))))")
    for row, crest, trough in zip(rows, expected["crest"], expected["trough"], strict=True):
        numbers = [1e3 * crest["wavelength_m"], *(value for crack in (crest, trough) for value in (1e3 * crack["crack_length_m"], crack["crack_growth_mm_per_month"]))]
        # Three digits are shown.
        assert row == [pytest.approx(number, rel=6e-3, abs=1e-12) for number in numbers]
    page.speak("de")
    assert "ausgenutzter Kraftschluss" in page.text("#damage-words") and "Riss auf dem Berg" in page.text("#cracks")
    page.refused(422)
