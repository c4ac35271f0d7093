"""The page in a real browser."""

import json
import pathlib
import re
import tomllib

import pytest

from conftest import ROOT

NOMINAL = (ROOT / "cases/nominal.toml").read_text()
VIEWS = ["explore", "compare", "measure", "calibrate", "curve", "motion", "paper"]


def drag(page, slider, value):
    page.page.locator(f"#slide-key-{slider}").evaluate(
        "(slider, value) => { slider.value = value; slider.dispatchEvent(new Event('input')); }", value
    )


def test_the_nominal_map_is_there(page):
    assert "537 Hz" in page.text("#branches")
    assert "corrugation grows" in page.text("#why")
    assert page.page.locator("#growth .main-svg").count() > 0
    page.keep("explore", whole=True)


@pytest.mark.without_curves
def test_a_slider_changes_map_case_and_words(page):
    before, words = page.map(), page.text("#verdict")
    drag(page, "contact-friction", 0.15)
    page.settle()
    assert page.map() != before or page.text("#verdict") != words
    assert page.page.locator("#key-contact-friction").input_value() == "0.15"
    drag(page, "contact-tractive_ratio", 0.9)
    page.settle()
    assert page.map() != before
    assert page.text("#verdict") != words


def overlapping(words):
    """Pairs of words on a map whose boxes have a point in common."""
    def meet(a, b):
        return a["left"] < b["right"] and b["left"] < a["right"] and a["top"] < b["bottom"] and b["top"] < a["bottom"]

    return [(a["words"], b["words"]) for k, a in enumerate(words) for b in words[:k] if meet(a, b)]


def words_of(page, place="#map"):
    return page.page.locator(place).evaluate("(place) => place.view.taken")


# Share of the crest of each branch on which the canvas has the colour of branches, a pixel beside it allowed.
LINES = """() => {
  const { view } = document.getElementById('map');
  const probe = document.createElement('canvas').getContext('2d');
  probe.fillStyle = view.colors.warm;
  probe.fillRect(0, 0, 1, 1);
  const warm = probe.getImageData(0, 0, 1, 1).data;
  const context = view.field.getContext('2d');
  const near = (x, y) => {
    const { data } = context.getImageData(Math.round(x * view.ratio) - 1, Math.round(y * view.ratio) - 1, 3, 3);
    for (let k = 0; k < data.length; k += 4) if ([0, 1, 2].every((c) => Math.abs(data[k + c] - warm[c]) < 60)) return true;
    return false;
  };
  return view.map.branches.map(({ points }) => {
    const seen = points.wavelength_m.filter((wavelength, k) => near(view.x(wavelength), view.y(points.speed_m_per_s[k])));
    return [points.wavelength_m.length, seen.length];
  });
}"""


@pytest.mark.without_remedies
@pytest.mark.without_curves
@pytest.mark.parametrize("locale", ["en-GB", pytest.param("de-DE", marks=pytest.mark.thorough)])
def test_branches_have_lines_names_and_words(open_page, locale):
    page = open_page(locale=locale)
    for case in ["discrete-supports", "freight", "main-line", "metro", "tram"]:
        check_branches(page, case, locale)
    page.close()


def check_branches(page, case, locale):
    page.open_case((ROOT / f"cases/{case}.toml").read_text(), f"{case}.toml")
    title = tomllib.loads((ROOT / f"cases/{case}.toml").read_text())["title"]
    page.until(lambda: page.text("#map-title") == title)
    page.settle()
    branches = page.page.evaluate("() => window.riffel.state.head.branches")
    lines = [branch for branch in branches if len(branch["points"]["speed_m_per_s"]) > 1]
    # A line runs through each; marks of the ridge and names lie over parts of it.
    for (points, seen), branch in zip(page.page.evaluate(LINES), branches, strict=True):
        assert points < 2 or seen >= points / 3, branch["frequency_hz"]
    words = words_of(page)
    assert overlapping(words) == []
    named = [word["words"] for word in words]
    for branch in lines[:4]:
        hertz = branch["frequency_hz"]
        name = f"{hertz:.0f} Hz" if hertz >= 100.0 else f"{round(hertz, 1):g} Hz"
        assert (name if locale == "en-GB" else name.replace(".", ",")) in named
    verdict = page.text("#branches")
    assert f"{branches[0]['frequency_hz']:.0f} Hz" in verdict
    assert ("branch" in verdict, "Ast" in verdict) == ((True, False) if locale == "en-GB" else (False, True))
    if locale == "de-DE":
        assert english_words(verdict) == set()
    page.keep(f"branches-{case}-{locale[:2]}")


@pytest.mark.without_curves
def test_inertia_slider_speaks_in_engineers_units(page):
    drag(page, "wheel-inertia", 400)
    page.settle()
    assert page.page.locator("#key-wheel-inertia").input_value() == "300"
    assert page.page.locator("#key-wheel-inertia-unit").text_content() == "kg m²"


def test_the_cursor_leads_loop_and_curves(page):
    box = page.page.locator("#map").bounding_box()
    page.page.mouse.click(box["x"] + 0.3 * box["width"], box["y"] + 0.2 * box["height"])
    page.settle()
    assert "decays" in page.text("#why")
    page.page.click("#to-highest")
    page.settle()
    assert "grows" in page.text("#why")


@pytest.mark.without_curves
def test_by_keyboard_alone(page):
    keys = page.page.keyboard
    page.page.locator("body").focus()
    keys.press("Tab")
    assert page.page.evaluate("() => document.activeElement.className") == "skip"
    # Every tab of the page is reached with arrows from the first.
    keys.press("Tab")
    assert page.page.evaluate("() => document.activeElement.id") == "tab-explore"
    for view in [*VIEWS[1:], "explore"]:
        keys.press("ArrowRight")
        assert page.page.evaluate("() => document.activeElement.id") == f"tab-{view}"
        assert page.page.locator(f"#view-{view}").is_visible()
    # On to the first slider, and step it.
    for _ in range(30):
        keys.press("Tab")
        if page.page.evaluate("() => document.activeElement.id") == "slide-key-contact-friction":
            break
    else:
        pytest.fail("the slider of the friction is not reached")
    before = page.map(), page.text("#verdict"), page.page.locator("#key-contact-friction").input_value()
    for _ in range(10):
        keys.press("ArrowRight")
    page.settle()
    assert page.page.locator("#key-contact-friction").input_value() == "0.45"
    assert (page.map(), page.text("#verdict")) != before[:2]
    # The cursor of the map follows the arrows, and Home goes to the highest growth.
    page.page.locator("#map canvas").last.focus()
    highest = page.page.evaluate("() => window.riffel.state.point")
    keys.press("ArrowUp")
    keys.press("ArrowLeft")
    page.settle()
    moved = page.page.evaluate("() => window.riffel.state.point")
    assert moved["speed"] > highest["speed"] and moved["wavelength"] < highest["wavelength"]
    keys.press("Home")
    page.settle()
    again = page.page.evaluate("() => [window.riffel.state.point, window.riffel.state.map.highest]")
    assert again[0]["speed"] == again[1]["speed_m_per_s"]


@pytest.mark.without_remedies
@pytest.mark.without_curves
def test_a_wheelset_is_shown_and_edited(open_page):
    page = open_page()
    text = (ROOT / "cases/curve.toml").read_text()
    assert '"300 mm" }' in text and '"15 m/s" }' in text
    text = text.replace('"300 mm" }', '"300 mm", points = 31 }').replace('"15 m/s" }', '"15 m/s", points = 21 }')
    page.open_case(text, "curve.toml")
    value = lambda key: page.page.locator(f"#key-{key}").input_value()
    page.until(lambda: value("wheelset-model") == "flexible")
    page.settle()
    assert value("wheelset-axle-diameter") == "160"
    assert value("contact-creepage-lateral") == "1.7 %"
    assert value("contact-creepage") == ""
    assert value("wheelset-discs").count("polar_inertia") == 4
    assert value("wheel-mass") == ""
    # The loop at the cursor is that of the map, with a lateral force and no one angular velocity.
    assert "lateral force" in page.text("#amplitudes")
    assert "angular velocity" not in page.text("#amplitudes")
    before = page.map()
    page.page.evaluate("() => document.querySelectorAll('details.group').forEach((group) => (group.open = true))")
    page.keep("wheelset", whole=True)
    page.set("wheelset.discs", value("wheelset-discs").replace("350 kg", "500 kg"))
    page.set("wheelset.opposite_rail", "in-phase")
    page.settle()
    assert page.map() != before
    # A list that cannot be is refused at its field.
    page.set("train.wheels", "0 m, 2.5 m, 2.5 m")
    fault = page.page.locator("#key-train-wheels-fault")
    page.until(fault.is_visible)
    assert "two wheels must not be at one place" in fault.inner_text()
    page.set("train.wheels", "0 m, 2.5 m")
    page.until(lambda: not fault.is_visible())
    # A number takes the place of the table, and the table that of the number.
    page.set("contact.creepage", "0.1 %")
    page.settle()
    assert value("contact-creepage-lateral") == ""
    page.set("contact.creepage.lateral", "0.3 %")
    page.settle()
    assert value("contact-creepage") == ""
    page.close(complaints=len(page.complaints))
    assert all("422" in complaint for complaint in page.complaints)


@pytest.mark.without_remedies
@pytest.mark.without_curves
def test_a_preset_of_a_wheelset_takes_the_place_of_the_wheel(page):
    page.set("wheelset.preset", "metro-trailer")
    page.settle()
    assert page.page.locator("#key-wheel-mass").input_value() == ""
    assert page.page.locator("#key-wheelset-discs").get_attribute("placeholder").count("polar_inertia") > 1


@pytest.mark.without_curves
def test_presets_show_their_sources_and_take_the_place_of_values(page):
    page.set("vehicle", "metro-motor-car")
    page.settle()
    assert page.page.locator("#key-wheel-mass").input_value() == ""
    assert page.page.locator("#key-wheel-mass").get_attribute("placeholder") != ""
    page.page.locator("#key-vehicle").locator("xpath=../span/button").click()
    assert len(page.text("#key-vehicle-sources")) > 100
    page.keep("sources")


def test_two_variants_are_compared(page):
    page.page.click("#tab-compare")
    page.page.click("#keep")
    page.page.locator("#compare-difference").wait_for()
    page.set("contact.friction", "0.2")
    page.until(lambda: "contact.friction" in page.text("#view-compare"))
    row = page.text("#view-compare tr:has-text('contact.friction')")
    assert row.split()[-2:] == ["0.4", "0.2"]
    page.settle()
    page.keep("compare", whole=True)


def test_the_figures_of_the_paper_are_drawn(page):
    page.page.click("#tab-paper")
    for number in range(2, 9):
        figure = page.page.locator(f"#figure-{number}")
        figure.scroll_into_view_if_needed()
        page.until(lambda: f"Figure {number}." in figure.locator("h2").inner_text())
        page.until(lambda: figure.locator("canvas, .main-svg").count() > 0)
    page.settle()
    # No curve reaches into the panel beside it.
    over = "() => [...document.querySelectorAll('#view-paper figure')].filter((one) => one.scrollWidth > one.clientWidth + 1).length"
    assert page.page.evaluate(over) == 0
    page.keep("paper", whole=True)


@pytest.mark.without_curves
def test_the_table_of_the_field_is_that_which_the_project_keeps(page):
    kept = json.loads((ROOT / "validation/field/prediction-wear-of-service.json").read_text())
    outcomes = [(site["title"], outcome) for site in kept["cases"] for outcome in site["outcomes"]]
    page.page.click("#tab-paper")
    rows = page.page.locator("#field tbody tr")
    page.until(lambda: rows.count() == len(outcomes))
    for row, (title, outcome) in zip(rows.all(), outcomes, strict=True):
        cells = row.locator("th, td").all_inner_texts()
        assert cells[0] == title and cells[1].startswith(outcome["what"]) and cells[4] == ("inside" if outcome["inside"] else "outside")
        assert not outcome["predicted"] or cells[2].startswith(f"{outcome['predicted']['median']:.3g} ("), cells
    inside = sum(outcome["inside"] for _, outcome in outcomes)
    summary = page.text("#field-summary")
    assert f"riffel {kept['riffel_version']}" in summary and f"{inside} of {len(outcomes)}" in summary
    page.page.select_option("#language", "de")
    assert "Wellenlänge, mm" in page.text("#field") and "vorhergesagt von riffel" in page.text("#field-summary").lower()


def profile(metres=60):
    """A rail with corrugation of 40 mm, 20 µm high, on a rough floor."""
    import math
    import random

    random.seed(1)
    rows = ["position_m,height_um"]
    level = 0.0
    for k in range(1000 * metres):
        level = 0.995 * level + random.gauss(0, 0.4)
        rows.append(f"{k / 1000:.3f},{20 * math.sin(2 * math.pi * k / 40) + level:.3f}")
    return "\n".join(rows).encode()


def test_a_measured_rail_is_read_judged_and_reported(page, served, tmp_path):
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "trolley.csv", "mimeType": "text/csv", "buffer": profile()}])
    page.until(lambda: page.page.locator(".sentences li.bad").count() > 0)
    assert "over the limit" in page.text("#view-measure")
    assert page.page.locator(".findings h3").first.inner_text().startswith("40")
    page.settle()
    page.keep("measure", whole=True)
    with page.page.expect_download() as download:
        page.page.click("#report")
    download.value.save_as(tmp_path / "report.html")
    report = (tmp_path / "report.html").read_text()
    assert report.startswith("<!DOCTYPE html>")
    assert "trolley.csv" in report and "record.csv" not in report
    assert download.value.suggested_filename == "trolley-report.html"
    page.page.click("#tab-explore")
    page.page.get_by_text("Take away").click()
    with page.page.expect_download() as again:
        page.page.click("[data-take=report]")
    assert again.value.suggested_filename == "trolley-report.html"


PROFILES = pathlib.Path(__file__).resolve().parents[2] / "riffel-rail/tests/profiles"


def test_profiles_and_the_wheels_of_a_curve(page):
    page.page.click("#tab-curve")
    rows = page.page.locator("#wheels tbody tr")
    page.until(lambda: rows.count() == 4)
    page.until(lambda: page.page.locator("#outlines .main-svg").count() > 0)
    nominal = rows.first.inner_text()
    # A wheel of a device in place of the nominal one: the same profile, within its digits, is said to be turned.
    page.give("#profile-file-wheel", str(PROFILES / "wheel.whl"))
    page.until(lambda: "wheel.whl: read as a wheel" in page.text("#profile-remarks"))
    assert page.page.locator("#profile-wheel").input_value() == "wheel.whl"
    assert "/" not in page.text("#profile-remarks")
    assert rows.first.inner_text().split()[:3] == nominal.split()[:3]
    page.page.fill("#curve-radius", "1500")
    page.page.keyboard.press("Tab")
    page.until(lambda: rows.first.inner_text().split()[2:] != nominal.split()[2:])
    # The bogie is that of the user: a softer one steers better. It is drawn from above, wheels and creep forces.
    drawn = page.page.locator("#bogie-above svg")
    assert drawn.locator(".wheel").count() == 4 and drawn.locator(".creep").count() == 4
    assert "times as large" in page.text("#bogie-above")
    attack = lambda: abs(float(rows.first.inner_text().split()[3].replace("\u2212", "-")))
    stiff = attack()
    page.page.fill("#bogie-longitudinal", "0.5")
    page.page.keyboard.press("Tab")
    page.until(lambda: attack() < 0.8 * stiff)
    page.page.fill("#curve-gauge", "14350")
    page.page.keyboard.press("Tab")
    page.until(page.page.locator("#curve-gauge-fault").is_visible)
    assert page.text("#curve-gauge-fault") == "gauge: 14350, but must be 900 to 1800 mm."
    assert page.page.locator("#view-curve .panel.stale").count() == 3
    assert page.page.locator("#curve-gauge").get_attribute("aria-invalid") == "true"
    page.page.fill("#curve-gauge", "1435")
    page.page.keyboard.press("Tab")
    page.until(lambda: not page.page.locator("#curve-gauge-fault").is_visible())
    page.until(lambda: page.page.locator("#view-curve .panel.stale").count() == 0)
    page.settle()
    page.keep("curve", whole=True)
    # What cannot be read says so in the name of the user.
    broken = {"name": "scan.csv", "mimeType": "text/csv", "buffer": b"x_mm,y_mm\n1,2\n3,x\n"}
    page.give("#profile-file-rail", files=[broken])
    page.until(page.page.locator("#trouble").is_visible)
    assert "scan.csv" in page.text("#trouble") and "line 3" in page.text("#trouble")
    page.complaints.clear()


def test_fields_of_a_curve_read_the_separators_and_units_of_people(open_page):
    page = open_page(locale="de-DE")
    asked = []
    page.page.on("request", lambda request: request.url.endswith("/api/curve") and asked.append(request.post_data_json))
    page.page.click("#tab-curve")
    page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4)
    assert page.page.locator("#bogie-wheelbase").input_value() == "2,1" and "Pfeile: Schlupfkraft auf die Schiene, der längste 19,2 kN" in page.text("#bogie-above")
    first = asked[-1]
    for field, text, key, value in [
        ("#bogie-lateral", "8,5", "bogie.primary_lateral_stiffness", 8.5e6), ("#bogie-axle-load", "10.500 kg", None, None), ("#bogie-axle-load", "10500 kg", "bogie.mass_per_axle", 10500),
        ("#curve-speed", "28 mph", "curve.speed", 28 * 0.44704), ("#curve-radius", "−1000 ft", "curve.radius", -304.8), ("#friction-low", "30 %", "contact.friction.left", 0.3),
        ("#bogie-wheelbase", "-2,1", None, None), ("#curve-radius", "3", None, None), ("#curve-gauge", "1435 kg", None, None),
    ]:
        count = len(asked)
        page.page.fill(field, text)
        page.page.press(field, "Tab")
        if key:
            page.until(lambda: len(asked) > count and asked[-1]["set"][key] == pytest.approx(value))
            assert page.page.locator(field).input_value() == text
        else:
            page.until(page.page.locator(f"{field}-fault").is_visible)
            page.pause()
            assert len(asked) == count
            assert "Was ist gemeint?" in page.text(f"{field}-fault") or field != "#bogie-axle-load"
            page.page.fill(field, "")
            page.page.press(field, "Tab")
            page.until(lambda: len(asked) > count)
    # An empty field stands for the value at first, which it shows.
    changed = {"bogie.primary_lateral_stiffness": 8.5e6, "bogie.mass_per_axle": 10500, "curve.speed": pytest.approx(12.51712), "contact.friction.right": 0.3}
    assert asked[-1] == {**first, "set": {**first["set"], **changed}}
    assert page.page.locator("#bogie-wheelbase").get_attribute("placeholder") == "2,1"
    page.settle()
    page.page.select_option("#speed-unit", "m/s")
    assert page.page.locator("#curve-speed").input_value() == "12,517"
    page.close()


@pytest.mark.without_curves
def test_a_curve_survives_a_reload_and_a_program_that_does_not_answer(page):
    page.page.click("#tab-curve")
    rows = page.page.locator("#wheels tbody tr")
    page.until(lambda: rows.count() == 4)
    page.give("#profile-file-wheel", str(PROFILES / "wheel.whl"))
    page.until(lambda: "wheel.whl: read as a wheel" in page.text("#profile-remarks"))
    page.page.select_option("#profile-rail", "60E2")
    page.page.fill("#bogie-wheelbase", "6 ft")
    page.page.press("#bogie-wheelbase", "Tab")
    page.settle()
    page.until(lambda: page.page.locator("#view-curve .panel.stale").count() == 0)
    told = page.text("#wheels")
    page.settle()
    page.page.reload()
    page.until(lambda: rows.count() == 4 and page.text("#wheels") == told)
    assert page.page.locator("#profile-wheel").input_value() == "wheel.whl" and page.page.locator("#profile-rail").input_value() == "60E2"
    assert page.page.locator("#bogie-wheelbase").input_value() == "1.8288"
    # No equilibrium: in the words of the page.
    page.page.fill("#curve-radius", "20")
    page.page.press("#curve-radius", "Tab")
    page.until(page.page.locator("#no-equilibrium").is_visible)
    assert "`" not in page.text("#no-equilibrium")
    # Without an answer the figures pale, until there is one again.
    page.page.route("**/api/**", lambda route: route.abort())
    page.page.fill("#curve-radius", "180")
    page.page.press("#curve-radius", "Tab")
    page.until(page.page.locator("#trouble .said").is_visible)
    assert page.page.locator("#view-curve .panel.stale").count() == 3
    page.page.click("#tab-motion")
    page.until(lambda: "does not answer" in page.text("#wave-words"))
    page.page.click("#tab-curve")
    page.page.unroute("**/api/**")
    page.page.locator("#trouble").get_by_text("Try again").click()
    page.until(lambda: page.page.locator("#view-curve .panel.stale").count() == 0 and not page.page.locator("#no-equilibrium").is_visible())
    page.complaints.clear()


@pytest.mark.without_curves
def test_a_report_without_a_measured_rail_is_that_of_the_case(page, tmp_path):
    page.page.get_by_text("Take away").click()
    with page.page.expect_download() as download:
        page.page.click("[data-take=report]")
    assert download.value.suggested_filename == "br-main-line-tangent-track-report.html"
    download.value.save_as(tmp_path / "report.html")
    report = (tmp_path / "report.html").read_text()
    assert report.startswith("<!DOCTYPE html>")
    assert "Growth map</h2>" in report and "no roughness was given" in report
    assert "riffel-serve" not in report


@pytest.mark.without_curves
def test_a_file_that_is_no_profile_is_told_so(open_page):
    page = open_page()
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "letter.txt", "mimeType": "text/plain", "buffer": b"Dear all,\n"}])
    page.until(page.page.locator("#trouble").is_visible)
    assert "letter.txt" in page.text("#trouble")
    assert "riffel-serve" not in page.text("#trouble")
    page.close(complaints=1)


@pytest.mark.without_curves
def test_the_page_hands_out_files(page, tmp_path):
    for kind, begin in {"toml": b"", "csv": b"wavelength_m,", "png": b"\x89PNG", "svg": b"<svg", "html": b"<!DOCTYPE html>"}.items():
        take = page.page.locator(f"[data-take={kind}]")
        if not take.is_visible():
            page.page.get_by_text("Take away").click()
        with page.page.expect_download() as download:
            take.click()
        path = tmp_path / kind
        download.value.save_as(path)
        assert path.read_bytes().startswith(begin)
        assert download.value.suggested_filename.endswith(kind)
    assert 'model = "free-beam"' in (tmp_path / "toml").read_text()


def english_words(text):
    """Words that no German text has."""
    return {"the", "of", "and", "is", "over", "with", "track", "rail", "wheel", "beam", "speed", "Figure", "force"} & set(re.findall(r"\w+", text))


def test_in_german(open_page):
    page = open_page(locale="de-DE")
    assert page.page.locator("html").get_attribute("lang") == "de"
    assert "Riffel wächst" in page.text("#why")
    notes = page.text("#notes")
    assert "Schwellen und Schotter" in notes and "biegt sich ohne Schub" in notes
    assert english_words(notes) == set()
    # A number has its comma, shown as well as read.
    page.set("contact.friction", "0,35")
    page.settle()
    assert page.page.locator("#key-contact-friction").input_value() == "0,35"
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.35
    page.keep("german")
    page.page.click("#tab-paper")
    for number in range(2, 9):
        figure = page.page.locator(f"#figure-{number}")
        figure.scroll_into_view_if_needed()
        page.until(lambda: f"Bild {number}." in figure.locator("h2").inner_text())
        page.until(lambda: figure.locator("canvas, .main-svg").count() > 0)
        assert english_words(figure.inner_text()) == set()
    # A value that is refused, in the language of the page, which may change.
    page.page.click("#tab-explore")
    page.set("contact.normal_load", "-50")
    fault = page.page.locator("#key-contact-normal_load-fault")
    page.until(fault.is_visible)
    assert fault.get_attribute("lang") == "de"
    assert fault.inner_text().startswith("Radlast P₀ ist −50 kN, muss aber zwischen 0,001 kN und 2000 kN liegen")
    page.page.select_option("#language", "en")
    assert "must be between 0.001 kN and 2000 kN" in fault.inner_text() and fault.get_attribute("lang") == "en"
    page.page.select_option("#language", "de")
    page.set("contact.normal_load", "50")
    page.until(lambda: not fault.is_visible())
    page.page.select_option("#language", "en")
    page.settle()
    assert "corrugation grows" in page.text("#why")
    assert "the rail has no support" in page.text("#notes")
    page.page.click("#tab-paper")
    page.until(lambda: "Figure 2." in page.text("#figure-2 h2"))
    page.close(complaints=1)
