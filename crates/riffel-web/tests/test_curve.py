"""Curve: files of profiles, the fields of bogie and track, and a wheel of the bogie as that of the case."""

import pathlib

import pytest
from conftest import ROOT

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]

PROFILES = pathlib.Path(__file__).resolve().parents[2] / "riffel-rail/tests/profiles"


def type_(page, field, text):
    page.page.fill(field, text)
    page.page.press(field, "Tab")


def rows(page):
    return page.page.locator("#wheels tbody tr")


def pale(page):
    return page.page.locator("#view-curve .panel.stale").count()


def opened(page):
    # Growth under each wheel is that of one test.
    page.page.route("**/api/curve/wheels", lambda route: route.fulfill(status=422, json={"message": "not asked"}))
    page.page.click("#tab-curve")
    page.until(lambda: rows(page).count() == 4)
    page.settle()
    page.refused(422)


def test_a_wheel_of_the_bogie_becomes_that_of_the_case(page):
    answers = page.answers("/api/curve/wheels")
    page.page.click("#tab-curve")
    figures = page.page.locator("#growth-of-wheels figure")
    page.until(lambda: figures.count() == 4 and pale(page) == 0)
    page.settle()
    wheels = [wheel for wheel in answers[-1]["wheels"] if wheel["share_of_second_contact"] <= 0.5]
    for figure, wheel in zip(figures.all(), wheels, strict=True):
        text = figure.inner_text()
        assert f"Wheelset {wheel['wheelset']}, {wheel['rail']} rail" in text
        assert f"{wheel['highest']['wavelength_m'] * 1e3:.3g} mm, {wheel['highest']['frequency_hz']:.3g} Hz" in text
    # The second wheelset on the low rail is the wheel of the case.
    figures.nth(2).get_by_role("button").click()
    page.until(lambda: page.page.evaluate("() => window.riffel.state.current"))
    page.settle()
    contact = page.page.evaluate("() => window.riffel.state.accepted.contact")
    assert "tractive_ratio" not in contact and contact["creep_law"] == "fastsim" and "Wheelset 2, low rail" in page.text("#notice")
    for axis in ("longitudinal", "lateral"):
        # Five digits are written.
        assert contact["creepage"][axis] == pytest.approx(wheels[2][f"{axis}_creepage"], rel=1e-4)
    page.page.click("#undo")
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.keys.contact.tractive_ratio") == 0.1


def test_fields_of_a_curve_are_read_refused_and_kept(page):
    opened(page)
    page.speak("de")
    asked = page.asked("/api/curve")
    assert page.page.locator("#bogie-wheelbase").input_value() == "2,1"
    for field, text, key, value in [
        ("#bogie-lateral", "8,5", "bogie.primary_lateral_stiffness", 8.5e6), ("#bogie-axle-load", "10.500 kg", None, None), ("#bogie-axle-load", "10500 kg", "bogie.mass_per_axle", 10500), ("#curve-speed", "28 mph", "curve.speed", 28 * 0.44704),
        # In a curve to the left the low rail is the left one.
        ("#curve-radius", "−1000 ft", "curve.radius", -304.8), ("#friction-low", "30 %", "contact.friction.left", 0.3), ("#curve-gauge", "14350", None, None),
    ]:
        count = len(asked)
        type_(page, field, text)
        if key:
            page.until(lambda: len(asked) > count and asked[-1]["set"][key] == pytest.approx(value))
            assert page.page.locator(field).input_value() == text
        else:
            page.until(page.page.locator(f"{field}-fault").is_visible)
            assert pale(page) == 3 and page.page.locator(field).get_attribute("aria-invalid") == "true"
            # An empty field stands for the value at first, which it shows.
            type_(page, field, "")
            page.until(lambda: not page.page.locator(f"{field}-fault").is_visible())
        page.until(lambda: pale(page) == 0)
    page.settle()
    told = page.text("#wheels")
    page.page.reload()
    page.until(lambda: rows(page).count() == 4 and page.text("#wheels") == told)
    page.refused(422)
    # No equilibrium: in the words of the page.
    type_(page, "#curve-radius", "20")
    page.until(page.page.locator("#no-equilibrium").is_visible)
    assert "`" not in page.text("#no-equilibrium") and not page.page.locator("#wheels-panel").is_visible()
    page.settle()
    # Without an answer the figures pale, until there is one again.
    page.page.route("**/api/curve", lambda route: route.abort())
    type_(page, "#curve-radius", "180")
    page.until(page.page.locator("#trouble .said").is_visible)
    assert pale(page) == 3
    page.page.unroute("**/api/curve")
    page.page.locator("#trouble button").first.click()
    page.until(lambda: pale(page) == 0 and not page.page.locator("#no-equilibrium").is_visible())
    assert [asked[-1]["set"][f"contact.friction.{side}"] for side in ("left", "right")] == [0.4, 0.3]
    page.settle()
    page.complaints.clear()


def test_profiles_are_read_turned_and_refused_and_the_bogie_is_drawn(page):
    opened(page)
    nominal = rows(page).first.inner_text().split()
    # A wheel of a device in place of the nominal one: the same profile, within its digits, is said to be turned.
    page.give("#profile-file-wheel", str(PROFILES / "wheel.whl"))
    page.until(lambda: "wheel.whl: read as a wheel" in page.text("#profile-remarks"))
    assert page.page.locator("#profile-wheel").input_value() == "wheel.whl" and "/" not in page.text("#profile-remarks")
    assert rows(page).first.inner_text().split()[:3] == nominal[:3]
    # It is drawn from above, wheels and creep forces, on rails that lie apart by the gauge and the breadth of a head, to the millimetre.
    drawn = page.page.locator("#bogie-above svg")
    assert drawn.locator(".wheel").count() == 4 and drawn.locator(".creep").count() == 4 and "times as large" in page.text("#bogie-above")
    apart = "() => { const at = [...document.querySelectorAll('#bogie-above .rail')].map((rail) => Number(rail.getAttribute('points').split(' ')[20].split(',')[1])); return at[1] - at[0]; }"
    assert page.page.evaluate(apart) == pytest.approx(1.435 + 0.07, abs=1.1e-3)
    type_(page, "#curve-gauge", "1480")
    page.until(lambda: page.page.evaluate(apart) == pytest.approx(1.48 + 0.07, abs=1.1e-3))
    type_(page, "#curve-gauge", "1435")
    # A softer bogie steers better.
    attack = lambda: abs(float(rows(page).first.inner_text().split()[3].replace("\u2212", "-")))
    page.until(lambda: pale(page) == 0)
    page.settle()
    stiff = attack()
    type_(page, "#bogie-longitudinal", "0.5")
    page.until(lambda: attack() < 0.8 * stiff)
    # Columns that nothing tells but their shape may be turned, which a reload keeps.
    orientation = page.page.locator("#orientation-wheel")
    asked = page.asked("/api/curve")
    page.give("#profile-file-wheel", str(ROOT / "cases/worn-wheel.csv"))
    page.until(orientation.is_visible)
    page.settle()
    page.page.select_option("#orientation-wheel", "as-written")
    page.page.select_option("#profile-rail", "60E2")
    page.until(lambda: "as-written" in str(asked[-1]) and "60E2" in str(asked[-1]))
    page.settle()
    page.page.reload()
    page.until(lambda: orientation.is_visible() and orientation.input_value() == "as-written")
    assert page.page.locator("#profile-rail").input_value() == "60E2"
    # What cannot be read says so in the name of the user.
    page.give("#profile-file-rail", files=[{"name": "scan.csv", "mimeType": "text/csv", "buffer": b"x_mm,y_mm\n1,2\n3,x\n"}])
    page.until(lambda: "scan.csv" in page.text("#trouble") and "line 3" in page.text("#trouble"))
    page.settle()
    page.refused(422)
