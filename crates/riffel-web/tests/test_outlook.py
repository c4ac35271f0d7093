"""The headline, what it follows, and what helps: as the program answers them."""

import json
import re
import subprocess

import pytest
from conftest import PROGRAM, ROOT

HELD = "() => window.riffel.state.variants.map(({ name, case: keys }) => [name, keys.track.pad?.stiffness ?? null])"


def told(folder, *command):
    run = subprocess.run([PROGRAM, *command, "--json", "-o", str(folder)], cwd=ROOT, check=True, capture_output=True, text=True)
    return json.loads(run.stdout)


CURSOR = "() => window.riffel.state.point"


def ranked(page):
    page.until(lambda: page.page.locator("#remedies tbody tr").count() > 0)
    page.settle()
    cells = "(table) => [...table.tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.innerText.trim()))"
    return page.page.locator("#remedies").evaluate(cells)


@pytest.mark.parametrize("locale", ["en-GB", "de-DE"])
def test_the_headline_is_one_number_with_its_cause(open_page, tmp_path, locale):
    page = open_page(locale=locale)
    page.open_case((ROOT / "cases/metro.toml").read_text(), "metro.toml")
    growth = told(tmp_path, "map", "cases/metro.toml", "--set", "map.speed.points=5")["under_traffic"]
    # Rails in service wear little, and long times stand in years.
    early, late = (f"{months / 12:.2g}" for months in growth["fastest"]["doubling_months_banded"]["band_80"])
    assert page.text("#doubling") == (f"In {early} to {late} years" if locale == "en-GB" else f"In {early.replace('.', ',')} bis {late} Jahren")
    # The number is the largest text of the page.
    size = "(one) => parseFloat(getComputedStyle(one).fontSize)"
    assert page.page.locator("#doubling").evaluate(size) > 2 * page.page.locator("#verdict").evaluate(size)
    assert growth["cause"]["mechanism"] == "P2 resonance"
    frequency = f"{growth['cause']['resonance_hz']:.0f} Hz"
    assert frequency in page.text("#verdict")
    card = page.text("#cause")
    assert frequency in card and ("vertical axle-box" if locale == "en-GB" else "vertikale Achslager") in card
    assert page.page.locator("#cause svg .moves circle").count() == 1
    # One click shows the place on the map and the panel with the curve of the traffic.
    page.page.click("#show-why")
    page.settle()
    speed = page.page.evaluate("() => window.riffel.state.point.speed")
    assert speed == pytest.approx(growth["cause"]["speed_m_per_s"])
    # The map reaches as far as what grows fastest: it is not moved to the edge.
    wavelength = page.page.evaluate("() => window.riffel.state.point.wavelength")
    assert wavelength == pytest.approx(growth["cause"]["wavelength_m"])
    assert page.page.evaluate("() => window.riffel.state.map.wavelength.max") > wavelength
    assert page.page.evaluate("() => document.activeElement.id") == "cause-panel"
    curve = page.page.evaluate("() => document.getElementById('traffic-curve').data[0].x.length")
    assert curve > 20
    page.keep(f"outlook-{locale}", whole=True)
    page.close()


@pytest.mark.without_curves
@pytest.mark.without_remedies
def test_the_cursor_stands_on_the_headline_until_it_is_pinned(page, open_page, tmp_path):
    first = page.page.evaluate(CURSOR)
    # Its window ends short of what grows fastest.
    narrow = (ROOT / "cases/metro.toml").read_text().replace('max = "300 mm"', 'max = "200 mm"')
    page.open_case(narrow, "metro.toml")
    growth = told(tmp_path, "map", "cases/metro.toml", "--set", "map.speed.points=5", "--set", "map.wavelength.max=200 mm")["under_traffic"]
    headline = {"wavelength": pytest.approx(growth["fastest"]["wavelength_m"]), "speed": pytest.approx(growth["cause"]["speed_m_per_s"]), "pinned": False}
    wavelength = f"{round(1e3 * growth['fastest']['wavelength_m'], -1):.0f} mm"
    assert page.page.evaluate(CURSOR) == headline
    # The window is as wide as the headline needs, marks it, and says so in one step with the opening.
    assert page.page.evaluate("() => window.riffel.state.map.wavelength.max") > growth["fastest"]["wavelength_m"]
    assert wavelength in growth["remarks"][1] and page.page.evaluate("() => document.getElementById('map').view.marks.map(({ label }) => label)") == [f"fastest under the traffic: {wavelength}"]
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
    # A link holds a place that was pinned, and no other.
    for link, at in [(address, headline), (page.page.url, pinned)]:
        other = open_page(link.split("/", 3)[3])
        assert other.page.evaluate(CURSOR) == at
        other.close()
    page.page.click("#show-why")
    page.settle()
    moved = page.page.evaluate("() => window.riffel.state.headline")
    assert page.page.evaluate(CURSOR) == {"wavelength": moved["wavelength"], "speed": moved["speed"], "pinned": False} != first
    page.page.keyboard.press("Control+z")
    page.page.keyboard.press("Control+z")
    page.settle()
    assert page.page.evaluate(CURSOR) == first


@pytest.mark.without_curves
def test_remedies_are_those_of_the_program_and_become_variants(page, tmp_path):
    page.open_case((ROOT / "cases/metro.toml").read_text(), "metro.toml")
    answer = told(tmp_path, "compare", "cases/metro.toml", "--remedies")
    rows = ranked(page)
    assert [row[0].split("\n")[0] for row in rows] == [remedy["title"] for remedy in answer["remedies"]]
    for row, remedy in zip(rows, answer["remedies"]):
        change = round(100 * remedy["change_of_fastest_growth"])
        assert row[1] == f"{'+' if change > 0 else ''}{change} %".replace("-", "−")
    best = answer["remedies"][0]
    assert best["changes"][0]["key"] == "track.pad.stiffness" and f"What helps most is {best['title']}" in page.text("#verdict")
    assert "left out: half the stiffness under the sleepers" in page.text("#remedies-panel").lower()
    # Kept, it is the case with that one value, and undo takes it away.
    page.page.locator("#remedies tbody tr").first.locator("button").click()
    assert page.page.evaluate(HELD) == [[best["title"], "30 MN/m"]]
    assert page.page.evaluate("() => window.riffel.state.keys.track.pad?.stiffness ?? null") is None
    page.page.keyboard.press("Control+z")
    page.settle()
    assert page.page.evaluate(HELD) == []
    # What is of the traffic leads to its speeds.
    page.page.locator("#remedies button", has_text="To the traffic").first.click()
    assert page.page.evaluate("() => document.activeElement.id") == "traffic-to"


@pytest.mark.without_curves
def test_a_case_in_which_nothing_grows_says_so(open_page):
    page = open_page(locale="de-DE")
    page.set("map.wavelength.max", "30 mm")
    page.settle()
    assert page.text("#doubling") == "nichts wächst" and "wächst" in page.text("#cause")
    assert page.page.locator("#show-why").is_hidden()
    page.page.wait_for_timeout(600)
    page.settle()
    assert page.page.locator("#remedies tbody tr").count() == 0
    page.close()


@pytest.mark.without_curves
@pytest.mark.parametrize("locale", ["en-GB", "de-DE"])
def test_causes_of_a_measured_rail_are_cards(open_page, locale):
    page = open_page(locale=locale)
    page.page.click("#tab-measure")
    page.page.click("#sample")
    page.page.locator("#view-measure .card").first.wait_for()
    page.settle()
    cards = page.page.locator("#view-measure .card")
    words = ("For", "Against", "Would settle it") if locale == "en-GB" else ("Dafür", "Dagegen", "Das entscheidet")
    for card in cards.all():
        assert card.locator("svg").count() == 1 and card.locator("meter").count() == 1
        told = card.locator("dt").all_inner_texts()
        assert told == [word for word in words if word in told] and words[2] in told
        measurement = card.locator("dd").last
        assert measurement.locator("span").get_attribute("lang") == locale[:2]
    page.keep(f"causes-measured-{locale}", whole=True)
    page.close()


@pytest.mark.without_curves
def test_remedies_say_when_the_rail_is_ground_and_go_by_their_cost(page, open_page, tmp_path):
    # Of clean dry discs, by which the rail is ground before the wheel leaves it.
    case = (ROOT / "cases/metro.toml").read_text().replace("0.3e-9 kg/J", "2.5e-9 kg/J")
    (tmp_path / "metro.toml").write_text(case)
    page.open_case(case, "metro.toml")
    answer = told(tmp_path / "told", "compare", str(tmp_path / "metro.toml"), "--remedies")
    before = answer["grinding_interval"]["months"]
    for row, remedy in zip(ranked(page), answer["remedies"], strict=True):
        gained = remedy["grinding_interval"]["months"] - before
        assert remedy["months_gained"] == pytest.approx(gained)
        early, late = remedy["grinding_interval"]["months_banded"]["band_80"]
        # Two digits are shown.
        shown = [float(one.replace("−", "-")) for one in re.findall(r"[+−]?[\d.]+", row[3])]
        assert shown == [pytest.approx(one, rel=0.06) for one in (early, late, gained)], row
    gained = {remedy["id"]: remedy["months_gained"] for remedy in answer["remedies"]}
    # The second gains the less, but costs so little that a month of it is the cheaper; what loses months gains no place by its cost.
    first, second, losing = "softer-pads", "lighter-wheel", "stiffer-pads"
    assert gained[first] > gained[second] > 0 > gained[losing]
    costs = {first: 10000, second: 0.5 * 10000 * gained[second] / gained[first], losing: 1}
    for id_, cost in costs.items():
        page.page.fill(f"#cost-of-{id_}", f"{cost:.2f}")
        page.page.press(f"#cost-of-{id_}", "Tab")
        page.settle()
    titles = {remedy["id"]: remedy["title"] for remedy in answer["remedies"]}
    rest = [remedy["title"] for remedy in answer["remedies"] if remedy["id"] not in (first, second)]
    assert [row[0].split("\n")[0] for row in ranked(page)] == [titles[second], titles[first], *rest]
    assert f"What helps most is {titles[first]}" in page.text("#verdict")
    # What is refused says so at its field and leaves the order; a reload finds the costs.
    page.page.fill(f"#cost-of-{first}", "0")
    page.page.press(f"#cost-of-{first}", "Tab")
    page.until(page.page.locator(f"#cost-of-{first}-fault").is_visible)
    assert "cost: 0, but must be 0.01 to 1000000000" in page.text(f"#cost-of-{first}-fault")
    page.page.reload()
    page.settle()
    assert [row[0].split("\n")[0] for row in ranked(page)][:2] == [titles[second], titles[first]]
    assert page.page.locator(f"#cost-of-{first}").input_value() == "10000"
    # So does a project, in any other page.
    page.page.click("[popovertarget=take-away]")
    with page.page.expect_download() as download:
        page.page.click("[data-take=project]")
    download.value.save_as(tmp_path / "costs.riffel")
    text = (tmp_path / "costs.riffel").read_text()
    assert json.loads(text)["costs"] == {id_: pytest.approx(cost, abs=0.005) for id_, cost in costs.items()}
    assert "what remedies cost" in page.text("#notice")
    other = open_page()
    other.open_case(text, "costs.riffel")
    other.until(lambda: other.page.locator(f"#cost-of-{first}").count() > 0 and other.page.locator(f"#cost-of-{first}").input_value() == "10000")
    other.settle()
    assert [row[0].split("\n")[0] for row in ranked(other)][:2] == [titles[second], titles[first]]
    other.close()
    page.complaints.clear()


@pytest.mark.without_curves
def test_a_rail_that_the_model_does_not_explain_comes_first_and_ranks_no_remedy(page, tmp_path):
    """Levels that have risen five times as fast as the model has it, and as fast once the wear coefficient is five times that of the case."""
    dates = ["2025-05-01", "2026-05-01"]
    passages = 365 * 6000
    now = {wavelength: 10.0 for wavelength in (25, 31.5, 40, 50, 63, 80)}
    table = lambda levels: "wavelength_mm,level_db\n" + "".join(f"{wavelength:g},{level}\n" for wavelength, level in levels.items())
    (tmp_path / "now.csv").write_text(table(now))
    # The usual traffic of the page.
    vehicle = f'[[vehicle]]\nname = "all"\nshare = "100 %"\nspeed = {{ mean = "110 km/h", standard_deviation = "{60 / 12**0.5} km/h" }}\n'
    (tmp_path / "traffic.toml").write_text(f"[line]\npassages_per_day = 6000\n{vehicle}")
    asked = ["forecast", "cases/nominal.toml", "--traffic", str(tmp_path / "traffic.toml"), "--spectrum", str(tmp_path / "now.csv"), "--months", "12"]
    bands = told(tmp_path / "told", *asked)["bands"]
    model = {round(1e3 * band["wavelength_m"], 1): band["growth_db_per_million_axles"] for band in bands}
    then = {wavelength: 10 - 5e-6 * passages * model[min(model, key=lambda one: abs(one - wavelength))] for wavelength in now}
    (tmp_path / "before.csv").write_text(table(then))
    doubts = told(tmp_path / "told", *asked, "--earlier", str(tmp_path / "before.csv"), "--dates", ",".join(dates))["unexplained"]
    # A fifth, of the fastest within a tenth of the wavelength, which is a little above its band.
    assert len(doubts) == 2 and "the model has 0.21 times that" in doubts[0]
    helps = "What helps most"
    page.until(lambda: helps in page.text("#verdict"))
    page.page.click("#tab-measure")
    page.give("#record", str(tmp_path / "now.csv"))
    page.give("#earlier-file", str(tmp_path / "before.csv"))
    page.page.locator("#earlier-records input").wait_for()
    page.page.fill("#record-date", dates[1])
    page.page.locator("#earlier-records input").fill(dates[0])
    page.until(page.page.locator("#unexplained").is_visible)
    page.settle()
    said = " ".join(f"{doubt[0].upper()}{doubt[1:]}." for doubt in doubts)
    assert page.text("#unexplained").split("\n\n") == said.replace(". The model does", ".|The model does").split("|")
    first = page.page.locator("#view-measure > article:visible").first
    assert first.get_attribute("id") == "unexplained" and doubts[0] not in page.text("#view-measure")
    page.page.click("#tab-explore")
    page.settle()
    assert page.text("#verdict").startswith(said) and helps not in page.text("#verdict")
    assert page.page.locator("#remedies tbody tr").count() == 0 and said in page.text("#remedies-panel")
    # By the growth of the rail itself the model explains it, and ranks what helps.
    page.page.click("#tab-measure")
    page.set("wear.coefficient", "12.5e-9 kg/J")
    page.until(page.page.locator("#unexplained").is_hidden)
    page.page.click("#tab-explore")
    page.until(lambda: helps in page.text("#verdict"))
    assert page.page.locator("#remedies tbody tr").count() > 0
