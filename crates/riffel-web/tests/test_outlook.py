"""The headline, what it follows, and what helps: as the program answers them."""

import json
import re

import pytest
from conftest import small
from test_measure import csv

pytestmark = pytest.mark.without_curves

HELD = "() => window.riffel.state.variants.map(({ name, case: keys }) => [name, keys.track.pad?.stiffness ?? null])"
CURSOR = "() => window.riffel.state.point"


def ranked(page):
    page.until(lambda: page.page.locator("#remedies tbody tr").count() > 0)
    page.settle()
    cells = "(table) => [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.innerText.trim()))"
    return page.page.locator("#remedies").evaluate(cells)


def test_the_headline_is_one_number_with_its_cause(page):
    line = page.answers("/api/line")
    page.page.route("**/api/remedies", lambda route: route.fulfill(json={"remedies": [], "left_out": [], "notes": []}))
    page.open_case(small("metro"), "metro.toml")
    growth = line[-1]
    # Rails in service wear little, and long times stand in years.
    early, late = (f"{passages / 6000 / 365.2425:.2g}" for passages in growth["fastest"]["doubling_passages_banded"]["band_80"])
    assert page.text("#doubling") == f"In {early} to {late} years"
    # The number is the largest text of the page.
    size = "(one) => parseFloat(getComputedStyle(one).fontSize)"
    assert page.page.locator("#doubling").evaluate(size) > 2 * page.page.locator("#verdict").evaluate(size)
    frequency = f"{growth['cause']['resonance_hz']:.0f} Hz"
    card = page.text("#cause")
    assert frequency in page.text("#verdict") and frequency in card and "vertical axle-box" in card
    assert page.page.locator("#cause svg .moves circle").count() == 1
    # One click shows the place on the map, which reaches as far as what grows fastest, and the panel with the curve of the traffic.
    page.page.click("#show-why")
    page.settle()
    point = page.page.evaluate(CURSOR)
    assert [point["speed"], point["wavelength"]] == pytest.approx([growth["cause"]["speed_m_per_s"], growth["cause"]["wavelength_m"]])
    assert page.page.evaluate("() => window.riffel.state.map.wavelength.max") > point["wavelength"]
    assert page.page.evaluate("() => document.activeElement.id") == "cause-panel"
    assert page.page.evaluate("() => document.getElementById('traffic-curve').data[0].x.length") > 20
    page.keep("outlook", whole=True)


def test_the_cursor_stands_on_the_headline_until_it_is_pinned(page):
    # Its window ends short of what grows fastest.
    narrow = small("metro").replace('max = "300 mm"', 'max = "200 mm"')
    first = page.page.evaluate(CURSOR)
    line = page.answers("/api/line")
    page.page.route("**/api/remedies", lambda route: route.fulfill(json={"remedies": [], "left_out": [], "notes": []}))
    page.open_case(narrow, "metro.toml")
    growth = line[-1]
    headline = {"wavelength": pytest.approx(growth["fastest"]["wavelength_m"]), "speed": pytest.approx(growth["cause"]["speed_m_per_s"]), "pinned": False}
    wavelength = f"{round(1e3 * growth['fastest']['wavelength_m'], -1):.0f} mm"
    assert page.page.evaluate(CURSOR) == headline
    # The window is as wide as the headline needs, marks it, and says so in one step with the opening.
    assert page.page.evaluate("() => window.riffel.state.map.wavelength.max") > growth["fastest"]["wavelength_m"]
    assert page.page.evaluate("() => document.getElementById('map').view.marks.map(({ label }) => label)") == [f"fastest under the traffic: {wavelength}"]
    assert re.search(r"metro\.toml is open\. The map is wider now", page.text("#notice"))
    # It follows the pointer and goes back to the headline when that leaves.
    x, y, width, height = page.page.locator("#map").bounding_box().values()
    page.page.mouse.move(x + width / 2, y + height / 2)
    page.until(lambda: page.page.evaluate(CURSOR) != headline)
    page.page.mouse.move(5, 5)
    page.settle()
    assert page.page.evaluate(CURSOR) == headline
    address = page.page.url
    # Pinned, it stays whatever becomes of the headline, until that is asked for.
    page.page.mouse.click(x + width / 2, y + height / 2)
    page.settle()
    pinned = page.page.evaluate(CURSOR)
    page.page.mouse.move(5, 5)
    page.set("track.pad.stiffness", "30 MN/m")
    page.settle()
    assert pinned["pinned"] and page.page.evaluate(CURSOR) == pinned
    links = [(address, headline), (page.page.url, pinned)]
    page.page.click("#show-why")
    page.settle()
    moved = page.page.evaluate("() => window.riffel.state.headline")
    assert page.page.evaluate(CURSOR) == {"wavelength": moved["wavelength"], "speed": moved["speed"], "pinned": False} != first
    # Undo leads to the cursor of the case before.
    page.page.keyboard.press("Control+z")
    page.page.keyboard.press("Control+z")
    page.settle()
    assert page.page.evaluate(CURSOR) == first
    # A link holds a place that was pinned, and no other.
    for link, at in links:
        page.forget()
        page.open(link)
        assert page.page.evaluate(CURSOR) == at


# Long: computes all remedies of a line, and a variant of each.
def test_remedies_become_variants_and_go_by_their_cost(page):
    answers = page.answers("/api/remedies")
    # Of clean dry discs, by which the rail is ground before the wheel leaves it.
    page.open_case(small("metro").replace("0.3e-9 kg/J", "2.5e-9 kg/J"), "metro.toml")
    rows = ranked(page)
    remedies = answers[-1]["remedies"]
    assert [f"cost-of-{one['id']}" for one in remedies] == page.page.locator("#remedies input").evaluate_all("(all) => all.map(({ id }) => id)")
    for row, remedy in zip(rows, remedies, strict=True):
        change = round(100 * remedy["change_of_fastest_growth"])
        assert row[1] == f"{'+' if change > 0 else ''}{change} %".replace("-", "−")
        # Two digits are shown.
        early, late = remedy["grinding_interval"]["months_banded"]["band_80"]
        shown = [float(one.replace("−", "-")) for one in re.findall(r"[+−]?[\d.]+", row[3])]
        assert shown == [pytest.approx(one, rel=0.06) for one in (early, late, remedy["months_gained"])], row
    names = {remedy["id"]: row[0].split("\n")[0] for row, remedy in zip(rows, remedies)}
    assert "What helps most is" in page.text("#verdict") and "left out: half the stiffness under the sleepers" in page.text("#remedies-panel").lower()
    # Kept, it is the case with that one value, and undo takes it away.
    pads = page.page.locator("#remedies tr:has(#cost-of-softer-pads)")
    pads.locator("button").click()
    assert page.page.evaluate(HELD) == [[names["softer-pads"], "30 MN/m"]]
    page.page.keyboard.press("Control+z")
    assert page.page.evaluate(HELD) == []
    # What is of the traffic leads to its speeds.
    page.page.locator("#remedies button", has_text="To the traffic").first.click()
    assert page.page.evaluate("() => document.activeElement.id") == "traffic-to"
    page.settle()
    # The second gains the less, but costs so little that a month of it is the cheaper.
    gained = {remedy["id"]: remedy["months_gained"] for remedy in remedies}
    first, second = "softer-pads", "lighter-wheel"
    assert gained[first] > gained[second] > 0
    for id_, cost in [(first, 10000), (second, 0.5 * 10000 * gained[second] / gained[first])]:
        page.page.fill(f"#cost-of-{id_}", f"{cost:.2f}")
        page.page.press(f"#cost-of-{id_}", "Tab")
        page.settle()
    assert [row[0].split("\n")[0] for row in ranked(page)][:2] == [names[second], names[first]]
    assert f"What helps most is {names[first]}" in page.text("#verdict")
    # What is refused says so at its field; a reload finds the costs.
    page.page.fill(f"#cost-of-{first}", "0")
    page.page.press(f"#cost-of-{first}", "Tab")
    page.until(page.page.locator(f"#cost-of-{first}-fault").is_visible)
    assert "cost: 0, but must be 0.01 to 1000000000" in page.text(f"#cost-of-{first}-fault")
    page.page.reload()
    assert [row[0].split("\n")[0] for row in ranked(page)][:2] == [names[second], names[first]]
    _, project = page.take("project")
    assert json.loads(project)["costs"][first] == 10000 and "what remedies cost" in page.text("#notice")
    # They rank the remedies of any page that opens it.
    page.forget()
    page.open(page.home)
    page.open_case(project.decode(), name="costs.riffel")
    assert [row[0].split("\n")[0] for row in ranked(page)][:2] == [names[second], names[first]]
    assert page.page.input_value(f"#cost-of-{first}") == "10000"


def test_a_case_in_which_nothing_grows_says_so(page):
    page.speak("de")
    page.set("map.wavelength.max", "30 mm")
    page.settle()
    assert page.text("#doubling") == "nichts wächst" and "wächst" in page.text("#cause")
    assert page.page.locator("#show-why").is_hidden() and page.page.locator("#remedies tbody tr").count() == 0


def test_a_rail_that_the_model_does_not_explain_comes_first_and_ranks_no_remedy(page):
    """Levels of all bands that have risen by 30 dB in a year, whatever the model has of them."""
    table = lambda level: "wavelength_mm,level_db\n" + "".join(f"{wavelength:g},{level}\n" for wavelength in (25, 31.5, 40, 50, 63, 80))
    helps = "What helps most"
    page.until(lambda: helps in page.text("#verdict"))
    page.page.click("#tab-measure")
    page.give("#record", files=[csv("now.csv", table(10))])
    page.give("#earlier-file", files=[csv("before.csv", table(-20))])
    page.page.locator("#earlier-records input").wait_for()
    page.page.fill("#record-date", "2026-05-01")
    page.page.locator("#earlier-records input").fill("2025-05-01")
    page.until(page.page.locator("#unexplained").is_visible)
    page.settle()
    said = page.text("#unexplained").replace("\n\n", " ")
    assert "the model has" in said.lower() and page.page.locator("#view-measure > article:visible").first.get_attribute("id") == "unexplained"
    page.page.click("#tab-explore")
    page.settle()
    assert page.text("#verdict").startswith(said) and helps not in page.text("#verdict")
    assert page.page.locator("#remedies tbody tr").count() == 0 and said in page.text("#remedies-panel")
