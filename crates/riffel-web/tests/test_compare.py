"""Variants beside the case at hand: maps, curves, sweeps, report, link and undo."""

import base64
import json

import pytest

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
        keep_with(page, wheel__mass=mass)
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
    page.keep("compare-six", whole=True)


@pytest.mark.without_curves
def test_the_difference_of_any_two_maps(page):
    page.page.click("#tab-compare")
    keep_with(page, contact__friction="0.3")
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


@pytest.mark.without_curves
def test_a_link_holds_all_variants_and_an_old_one_opens(page, open_page):
    page.page.click("#tab-compare")
    keep_with(page, contact__friction="0.3")
    keep_with(page, contact__friction="0.2")
    name = page.page.locator(".variants input").first
    name.fill("dry rail")
    name.press("Tab")
    page.settle()
    other = open_page("#" + page.page.url.split("#")[1])
    assert variants(other) == [["dry rail", 0.4], ["B", 0.3]]
    settled(other, 4)
    other.close()
    # A link of before: one variant without a name, and no sum.
    state = page.page.evaluate("() => window.riffel.state.keys")
    kept = {**state, "contact": {**state["contact"], "friction": 0.6}}
    text = json.dumps({"case": state, "kept": kept, "tab": "compare", "point": None})
    old = open_page("#" + base64.urlsafe_b64encode(text.encode()).decode().rstrip("="))
    assert variants(old) == [["A", 0.6]]
    settled(old, 3)
    old.close()


@pytest.mark.without_curves
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
    page.page.click("#sweep-pads")
    page.until(page.page.locator("#sweep .fine").is_visible)
    assert "no pads" in page.text("#sweep .fine")
    page.page.click("#sweep-friction")
    page.until(lambda: len(page.page.evaluate(CURVES, "sweep-curves")) == 6)
    highest = [max(curve["y"]) for curve in page.page.evaluate(CURVES, "sweep-curves")]
    assert highest[5] / highest[0] == pytest.approx(36, rel=1e-6), "creepage times force, each as the friction"
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
    page.set("track.model", "two-layer")
    page.settle()
    page.page.click("#sweep-pads")
    page.until(lambda: "500 MN/m" in page.text("#sweep-table") and len(page.page.evaluate(CURVES, "sweep-curves")) == 6)
    highest = [max(curve["y"]) for curve in page.page.evaluate(CURVES, "sweep-curves")]
    assert len(set(highest)) == 6, "each stiffness has its own growth"
    # Where growth still rises at the end of the curve, the table says so.
    page.set("track.preset", "ballasted-soft-pads")
    page.settle()
    page.until(lambda: any("at the edge" in row[2] for row in rows(page, "#sweep-table")))
    for curve, row in zip(page.page.evaluate(CURVES, "sweep-curves"), rows(page, "#sweep-table")[1:], strict=True):
        assert ("at the edge of the window" in row[2]) == (curve["y"].index(max(curve["y"])) in (0, len(curve["y"]) - 1)), row
    keep_with(page)
    page.page.click("#sweep-keep")
    page.until(lambda: len(variants(page)) == 6)
    assert [name for name, _ in variants(page)] == [f"{k} MN/m" for k in (50, 80, 125, 200, 320, 500)]
    settled(page, 8)
    page.keep("sweep", whole=True)
    page.page.click("#undo")
    assert [name for name, _ in variants(page)] == ["A"]


def test_a_report_of_the_variants(page, tmp_path, browser):
    page.page.click("#tab-compare")
    keep_with(page, contact__friction="0.2")
    name = page.page.locator(".variants input")
    name.fill("<b>dry</b>")
    name.press("Tab")
    settled(page, 3)
    page.until(lambda: len(page.page.evaluate(CURVES, "compare-curves")) == 2)
    with page.page.expect_download() as download:
        page.page.click("#report-variants")
    file = tmp_path / "variants.html"
    download.value.save_as(file)
    context = browser.new_context(viewport={"width": 1100, "height": 900})
    report = context.new_page()
    asked = []
    report.on("request", lambda request: asked.append(request.url))
    report.goto(file.as_uri())
    assert [url for url in asked if not url.startswith(("file:", "data:"))] == []
    assert report.locator("th", has_text="<b>dry</b>").count() == 1
    pictures = report.locator("img").evaluate_all("(all) => all.map(({ naturalWidth }) => naturalWidth)")
    assert len(pictures) == 4 and min(pictures) > 100
    assert report.locator("a").get_attribute("href") == page.page.url
    report.screenshot(path=tmp_path / "report.png", full_page=True)
    context.close()


@pytest.mark.without_curves
@pytest.mark.parametrize("locale", ["en-GB", "de-DE"])
def test_variants_fit_a_phone(open_page, locale):
    page = open_page(viewport={"width": 360, "height": 780}, locale=locale)
    page.page.click("#tab-compare")
    keep_with(page, contact__friction="0.2")
    keep_with(page, contact__friction="0.3")
    page.page.click("#sweep-friction")
    page.until(lambda: "0.6" in page.text("#sweep-table") or "0,6" in page.text("#sweep-table"))
    page.fits()
    assert ("Now" if locale == "en-GB" else "Jetzt") in page.text("#compare-first")
    page.close()


@pytest.mark.without_curves
def test_the_common_window_is_named(page):
    """All maps have the window of the case at hand; a variant kept with another one is told apart."""
    page.page.click("#tab-compare")
    keep_with(page, wheel__mass="500")
    settled(page, 3)
    words = page.text("#compare-window")
    assert "20–80 mm, 18–216 km/h" in words and "is another" not in words
    page.set("map.wavelength.max", "60 mm")
    settled(page, 3)
    words = page.text("#compare-window")
    assert "20–60 mm, 18–216 km/h" in words and "“A” alone is another" in words
