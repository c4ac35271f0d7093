"""Variants beside the case at hand: maps, curves, sweeps, report, link and undo."""

import pytest

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]

CURVES = """(id) => (document.getElementById(id).data ?? []).map(({ name, x, y }) => ({ name, x, y }))"""
VALUES = """(id) => Array.from(document.querySelector(`#compare-${id} .map`).view.map.values)"""
VARIANTS = "() => window.riffel.state.variants.map(({ name, case: keys }) => [name, keys.contact.friction])"


def variants(page):
    return page.page.evaluate(VARIANTS)


def keep_with(page, **values):
    """Keep the case at hand, then change it."""
    before = len(variants(page))
    page.page.click("#keep")
    page.until(lambda: len(variants(page)) == before + 1)
    for key, value in values.items():
        page.set(key.replace("__", "."), value)
    page.settle()


def rows(page, table):
    cells = "(table) => [...table.rows].map((row) => [...row.cells].map((cell) => cell.textContent))"
    return page.page.locator(table).evaluate(cells)


def settled(page, columns):
    page.until(lambda: len((rows(page, "#view-compare .comparison >> nth=0") or [[]])[0]) == columns)
    page.settle()
    page.until(lambda: page.page.locator("#view-compare .stale").count() == 0)


def test_six_variants_in_maps_curves_and_table(page):
    page.page.click("#tab-compare")
    for mass in ["400", "450", "500", "550", "600"]:
        page.page.click("#keep")
        page.set("wheel.mass", mass)
    keep_with(page, contact__friction="0.2")
    assert page.page.locator("#keep").is_disabled()
    settled(page, 8)
    table = {row[0]: row[1:] for row in rows(page, "#view-compare .comparison >> nth=0")}
    assert table[""] == ["A", "B", "C", "D", "E", "F", "Now"]
    [mass] = [cells for name, cells in table.items() if "(wheel.mass)" in name]
    assert mass == ["350 kg", "400 kg", "450 kg", "500 kg", "550 kg", "600 kg", "600 kg"]
    # Three digits, in the unit of the form: 0.75 · 500 kg · (0.46 m)² / 2.
    [inertia] = [cells for name, cells in table.items() if "(wheel.inertia)" in name]
    assert inertia[3] == "39.7 kg m²"
    # What leads is what grows under the traffic, as the view of the case says.
    fastest, doubles_in = (table[name][-1] for name in ("grows fastest under the traffic", "doubles in"))
    assert fastest.removesuffix(" mm") in page.page.text_content("#verdict") and doubles_in in page.page.text_content("#verdict")
    page.until(lambda: len(page.page.evaluate(CURVES, "compare-curves")) == 7)
    curves = page.page.evaluate(CURVES, "compare-curves")
    assert [curve["name"] for curve in curves] == ["A", "B", "C", "D", "E", "F", "Now"]
    # Friction 0.4 and 0.2 at one tractive ratio: creepage and with it growth fall to a quarter.
    ratio = max(curves[6]["y"]) / max(curves[5]["y"])
    assert ratio == pytest.approx(0.25, rel=1e-6)
    # It pales until it is that of the case at hand.
    release = page.hold("**/api/compare")
    page.set("contact.friction", "0.1")
    page.until(lambda: page.page.locator("#view-compare .stale").count() > 0)
    release()
    page.until(lambda: page.page.locator("#view-compare .stale").count() == 0)
    page.settle()
    page.keep("compare-six", whole=True)


def test_the_difference_of_any_two_maps(page):
    page.page.click("#tab-compare")
    # Curves that are answered before the maps appear with them.
    release, curves = page.hold("**/api/compare"), page.answers("/api/growth")
    page.page.click("#keep")
    page.until(lambda: curves)
    release()
    page.until(lambda: len(page.page.evaluate(CURVES, "compare-curves")) == 2)
    page.set("contact.friction", "0.3")
    page.settle()
    keep_with(page, contact__friction="0.2")
    settled(page, 4)
    forth = page.page.evaluate(VALUES, "difference")
    assert page.text("#compare-difference .aside") == "Now − A"
    page.page.select_option("#compare-first", "now")
    page.page.select_option("#compare-second", "0")
    assert page.text("#compare-difference .aside") == "A − Now"
    back = page.page.evaluate(VALUES, "difference")
    assert max(abs(value) for value in forth) > 0
    assert back == [-value for value in forth]
    page.page.select_option("#compare-first", "1")
    page.page.select_option("#compare-second", "1")
    assert max(abs(value) for value in page.page.evaluate(VALUES, "difference")) == 0
    # All maps have the window of the case at hand; variants kept with another one are told apart.
    words = lambda: page.text("#compare-window")
    assert "20–80 mm, 18–216 km/h" in words() and "is another" not in words()
    page.page.locator(".variants button", has_text="✕").last.click()
    page.set("map.wavelength.max", "60 mm")
    settled(page, 3)
    assert "20–60 mm, 18–216 km/h" in words() and "“A” alone is another" in words()


def test_keeping_naming_and_removing_can_be_undone(page):
    page.page.click("#tab-compare")
    keep_with(page, contact__friction="0.3")
    keep_with(page)
    name = page.page.locator(".variants input").last
    name.fill("A")
    name.press("Tab")
    # No two have one name.
    assert [one for one, _ in variants(page)] == ["A", "A (2)"]
    page.page.locator(".variants button", has_text="✕").first.click()
    assert variants(page) == [["A (2)", 0.3]]
    page.page.click("#undo")
    assert variants(page) == [["A", 0.4], ["A (2)", 0.3]]
    page.page.click("#undo")
    assert variants(page) == [["A", 0.4], ["B", 0.3]]
    page.page.click("#undo")
    assert variants(page) == [["A", 0.4]]
    for _ in range(2):
        page.page.click("#undo")
    assert variants(page) == []
    assert page.page.locator("#compare-difference").is_hidden()
    for _ in range(5):
        page.page.click("#redo")
    assert variants(page) == [["A (2)", 0.3]]
    settled(page, 3)
    # A variant is opened in place of the case, and back.
    page.set("contact.friction", "0.5")
    page.page.locator(".variants button", has_text="Open").click()
    page.until(lambda: page.page.evaluate("() => window.riffel.state.keys.contact.friction") == 0.3)
    page.page.click("#undo")
    assert page.page.evaluate("() => window.riffel.state.keys.contact.friction") == 0.5


def test_sweeps_make_curves_and_variants(page):
    headline = page.text("#doubling")
    page.page.click("#tab-compare")
    assert "curves of growth over wavelength come here" in page.text("#sweep")
    page.page.click("#sweep-pads")
    page.until(page.page.locator("#sweep .fine").is_visible)
    assert "this track model has no pads" in page.text("#sweep")
    page.page.click("#sweep-friction")
    page.until(lambda: len(page.page.evaluate(CURVES, "sweep-curves")) == 6)
    highest = [max(curve["y"]) for curve in page.page.evaluate(CURVES, "sweep-curves")]
    assert highest[5] / highest[0] == pytest.approx(36, rel=1e-6), "creepage times force, each as the friction"
    assert "come here" not in page.text("#sweep")
    assert [row[0] for row in rows(page, "#sweep-table")[1:]] == [f"μ = 0.{k}" for k in range(1, 7)]
    # Under the traffic, so that the friction of the case has the time of the headline.
    assert "under the traffic" in page.text("#sweep header") and f"In {rows(page, '#sweep-table')[4][4]}" == headline
    # Decay takes no more of the axis than growth does.
    low, high = page.page.evaluate("() => document.getElementById('sweep-curves').layout.yaxis.range")
    assert 0 < -low <= high
    page.page.click("#sweep-speeds")
    page.until(lambda: "km/h" in page.text("#sweep-table"))
    page.until(lambda: len(page.page.evaluate(CURVES, "sweep-curves")) == 6)
    assert page.page.locator("#sweep-keep").is_hidden()
    page.page.click("#sweep-tractive")
    page.until(lambda: "τ = 0.15" in page.text("#sweep-table"))
    page.page.set_viewport_size({"width": 360, "height": 780})
    page.fits()
    page.set("track.model", "two-layer")
    page.settle()
    page.page.click("#sweep-pads")
    page.until(lambda: "500 MN/m" in page.text("#sweep-table") and len(page.page.evaluate(CURVES, "sweep-curves")) == 6)
    highest = [max(curve["y"]) for curve in page.page.evaluate(CURVES, "sweep-curves")]
    assert len(set(highest)) == 6, "each stiffness has its own growth"
    # Where growth still rises at the end of the curve, the table says so.
    for curve, row in zip(page.page.evaluate(CURVES, "sweep-curves"), rows(page, "#sweep-table")[1:], strict=True):
        assert ("at the edge of the window" in row[2]) == (curve["y"].index(max(curve["y"])) in (0, len(curve["y"]) - 1)), row
    keep_with(page)
    page.page.click("#sweep-keep")
    page.until(lambda: len(variants(page)) == 6)
    assert [name for name, _ in variants(page)] == [f"{k} MN/m" for k in (50, 80, 125, 200, 320, 500)]
    page.keep("sweep", whole=True)
    page.page.click("#undo")
    assert [name for name, _ in variants(page)] == ["A"]
    page.settle()
