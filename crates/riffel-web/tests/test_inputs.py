"""What is typed is never read as something else, and what is not accepted is said where it can be seen."""

import pytest
from test_page import VIEWS, english_words

pytestmark = pytest.mark.without_curves


def complete(page, key):
    """The value of a key as the program has it, in SI."""
    value = page.page.evaluate("() => window.riffel.state.head.complete")
    for part in key.split("."):
        value = value[part]
    return float(str(value).split()[0])


def field(page, key):
    return page.page.locator(f"#key-{key.replace('.', '-')}")


def beside(page, key, what):
    return page.page.locator(f"#key-{key.replace('.', '-')}-{what}")


@pytest.mark.parametrize(("locale", "text"), [("en-GB", "1,000"), ("de-DE", "1.000"), ("en-GB", "1000,000")])
def test_a_number_that_can_be_read_two_ways_is_asked_about(open_page, locale, text):
    page = open_page(locale=locale)
    page.set("wheel.mass", text)
    question = beside(page, "wheel.mass", "fault")
    page.until(question.is_visible)
    page.settle()
    # Nothing has changed, and what was typed is still there.
    assert complete(page, "wheel.mass") == 350
    assert field(page, "wheel.mass").input_value() == text
    assert page.page.locator("#trouble [data-field]").count() == 1
    page.keep(f"two-ways-{locale[:2]}")
    answers = question.locator("button")
    assert [answers.nth(k).inner_text() for k in range(2)] == (["1000 kg", "1 kg"] if text != "1000,000" else ["1000000 kg", "1000 kg"])
    answers.nth(0 if text != "1000,000" else 1).click()
    page.until(lambda: not question.is_visible())
    page.settle()
    assert complete(page, "wheel.mass") == 1000
    assert not page.page.locator("#trouble").is_visible()
    page.close()


@pytest.mark.parametrize(
    ("locale", "texts"),
    [
        ("en-GB", {"1,234.5": 1234.5, "1 000": 1000, "350,5": 350.5, "1.000": 1, "770 lb": 349.266, "0.35 t": 350}),
        ("de-DE", {"1.234,5": 1234.5, "1'000": 1000, "1,000": 1, "0,35 t": 350}),
    ],
)
def test_separators_and_units_are_read_and_echoed(open_page, locale, texts):
    page = open_page(locale=locale)
    for text, mass in texts.items():
        # The page asks about a value that is a thousandth of the one before.
        page.set("wheel.mass", "350")
        page.settle()
        page.set("wheel.mass", text)
        page.settle()
        assert complete(page, "wheel.mass") == pytest.approx(mass, rel=1e-5)
        # What was typed stays, the unit beside it is that of a bare number, and the page says what it has read.
        assert field(page, "wheel.mass").input_value() == text
        assert beside(page, "wheel.mass", "unit").text_content() == "kg"
        echo = beside(page, "wheel.mass", "echo").inner_text()
        assert echo.startswith("= ") and "kg" in echo
        assert ("350 kg" in echo) == (mass in (1, 350)), echo
    page.close()


def test_units_of_other_countries_are_taken_where_they_fit(page):
    for key, text, value in [
        ("wheel.rolling_radius", "18 in", 0.4572), ("track.support_spacing", "2 ft", 0.6096), ("map.speed.max", "125 mph", 55.88), ("contact.normal_load", "22 kip", 97860.9)
    ]:
        page.set(key, text)
        page.settle()
        assert complete(page, key) == pytest.approx(value, rel=1e-5)
        assert field(page, key).input_value() == text


def test_a_refused_unit_never_becomes_that_of_the_field(open_page):
    page = open_page()
    for text in ["35O", "1 0O0", "50 kg"]:
        page.set("contact.normal_load", text)
        page.until(beside(page, "contact.normal_load", "fault").is_visible)
        assert field(page, "contact.normal_load").input_value() == text
        assert beside(page, "contact.normal_load", "unit").text_content() == "kN"
    page.set("contact.normal_load", "60")
    page.until(lambda: not beside(page, "contact.normal_load", "fault").is_visible())
    page.settle()
    assert complete(page, "contact.normal_load") == 60_000
    # A ratio in per cent does not make per cent of the next.
    page.set("contact.friction", "40 %")
    page.settle()
    assert complete(page, "contact.friction") == pytest.approx(0.4)
    page.set("contact.friction", "0.3")
    page.settle()
    assert complete(page, "contact.friction") == pytest.approx(0.3)
    page.close(complaints=len(page.complaints))


def test_passages_of_six_thousand_are_not_six(page):
    daily = page.page.locator("#traffic-daily")
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    daily.fill("7,500")
    daily.press("Tab")
    page.until(page.page.locator("#traffic-daily-fault").is_visible)
    assert "7.5 1/d" in page.text("#traffic-daily-fault")
    page.page.locator("#traffic-daily-fault button").first.click()
    page.until(lambda: "7500" in page.text("#traffic-group summary"))
    for text in ["many", "-3", "1e9"]:
        daily.fill(text)
        daily.press("Tab")
        page.until(page.page.locator("#traffic-daily-fault").is_visible)
        assert daily.input_value() == text
        assert page.page.locator("#trouble [data-field]").count() == 1
    daily.fill("8000")
    daily.press("Tab")
    page.until(lambda: not page.page.locator("#trouble").is_visible())


@pytest.mark.parametrize(("text", "value"), [("2.5·10⁻⁹", 2.5e-9), ("2,5 × 10^-9 kg/J", 2.5e-9), ("1.5·10⁻⁸", 1.5e-8), ("3x10-9", None)])
def test_a_number_copied_from_the_page_is_one(page, text, value):
    page.set("wear.coefficient", text)
    page.settle()
    fault = page.page.locator("#key-wear-coefficient-fault")
    assert fault.is_visible() == (value is None)
    if value:
        assert complete(page, "wear.coefficient") == pytest.approx(value)
        assert page.page.locator("#key-wear-coefficient").input_value() == text
    page.complaints.clear()


def test_a_number_beyond_all_numbers_is_refused_at_its_field(page):
    for key in ["contact.friction", "wheel.mass", "map.wavelength.points"]:
        page.set(key, "1e400")
        page.settle()
        place = f"#key-{key.replace('.', '-')}"
        page.until(page.page.locator(f"{place}-fault").is_visible)
        assert "understand" not in page.text("#trouble") and "nfinity" not in page.text(f"{place}-fault")
        assert page.page.locator(place).input_value() == "1e400"
        page.page.keyboard.press("Control+z")
        page.until(lambda: not page.page.locator("#trouble").is_visible())
    page.complaints.clear()


def test_a_traffic_shows_what_it_was_read_as(page):
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    # A point is no separator of thousands here, but it may have been meant as one.
    page.page.fill("#traffic-daily", "6.000")
    page.page.press("#traffic-daily", "Tab")
    page.until(page.page.locator("#traffic-daily-echo").is_visible)
    assert page.page.locator("#traffic-daily").input_value() == "6.000"
    assert page.text("#traffic-daily-echo") == "= 6 1/d; before it was 6000 1/d. Is that meant?"
    page.page.fill("#traffic-to", "120 mph")
    page.page.press("#traffic-to", "Tab")
    page.until(page.page.locator("#traffic-to-echo").is_visible)
    assert page.page.locator("#traffic-to").input_value() == "120 mph" and page.text("#traffic-to-echo") == "= 193.1 km/h"
    # What is typed stays for its value and its unit only.
    page.page.select_option("#speed-unit", "m/s")
    assert page.page.locator("#traffic-to").input_value() == "53.645"
    assert not page.page.locator("#traffic-to-echo").is_visible()
    page.page.fill("#traffic-daily", "5000")
    page.page.press("#traffic-daily", "Tab")
    page.until(lambda: "5000" in page.text("#traffic-group summary"))


@pytest.mark.parametrize("locale", ["en-GB", pytest.param("de-DE", marks=pytest.mark.thorough)])
def test_every_view_counts_and_leads_to_what_is_not_accepted(open_page, locale):
    page = open_page(locale=locale)
    page.set("contact.normal_load", "-50")
    page.set("steel.poisson_ratio", "0.7")
    page.set("rail.mass_per_length", "1 kN")
    names = page.page.locator("#trouble [data-field]")
    page.until(lambda: names.count() == 3)
    for view in VIEWS:
        page.page.click(f"#tab-{view}")
        assert page.page.locator("#trouble").is_visible(), view
        assert page.page.locator("#trouble span").first.inner_text().startswith("3 "), view
        if locale == "de-DE":
            assert english_words(page.text("#trouble")) == set()
    # From the last view to the field.
    page.page.evaluate("() => document.querySelectorAll('details').forEach((group) => (group.open = false))")
    page.page.locator("#trouble [data-field]", has_text="P₀").click()
    assert page.page.evaluate("() => document.activeElement.id") == "key-contact-normal_load"
    assert page.page.locator("#view-explore").is_visible()
    page.keep(f"banner-{locale[:2]}")
    # What cannot be handed out says so.
    page.page.locator("[popovertarget=take-away]").click()
    page.page.click("[data-take=png]")
    page.until(lambda: page.page.locator("#trouble .said").count() == 1)
    for key in ["contact.normal_load", "steel.poisson_ratio", "rail.mass_per_length"]:
        page.set(key, "")
    page.set("contact.normal_load", "50")
    page.set("rail.mass_per_length", "")
    page.set("steel.poisson_ratio", "0.3")
    page.until(lambda: not page.page.locator("#trouble").is_visible())
    page.close(complaints=len(page.complaints))


def test_messages_speak_of_labels_and_the_unit_of_the_field(open_page):
    page = open_page()
    faults = page.page.locator(".row .fault:visible")
    for key, text, words in [
        ("contact.normal_load", "-50", ["normal load P₀ is −50 kN", "0.001 kN and 2000 kN"]), ("contact.grid", "1.5", ["grid", "whole number"]), ("map.wavelength.points", "abc", ["Wavelengths, points"]),
        ("map.wavelength.points", "5000", ["points"]), ("contact.contact_angle", "5", ["is 5 rad", "between −1.5708 rad and 1.5708 rad", 'mean "5 deg"']), ("map.wavelength.min", "200", ["Wavelengths, to is 80 mm", "200 mm"]), ("contact.friction", "3", ["friction μ is 3"]),
    ]:
        before = field(page, key).input_value()
        page.set(key, text)
        page.until(lambda: faults.count() > 0)
        said = faults.first.inner_text()
        # It stands at the field that it speaks of.
        assert key != "map.wavelength.points" or page.page.locator("#key-map-wavelength-points-fault").is_visible()
        for word in words:
            assert word in said
        for inside in ["f64", "u64", "`", "contact.", "map.", "riffel ", "--", "invalid type", "line 1"]:
            assert inside not in said
        page.set(key, before)
        page.until(lambda: faults.count() == 0)
    page.close(complaints=len(page.complaints))


def test_a_file_dropped_anywhere_is_taken(page):
    page.page.evaluate(
        """() => {
          const files = new DataTransfer();
          files.items.add(new File(['Dear all,'], 'letter.txt', { type: 'text/plain' }));
          document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
        }"""
    )
    page.until(page.page.locator("#trouble").is_visible)
    assert "letter.txt" in page.text("#trouble")
    assert page.page.locator("#view-measure").is_visible()
    page.complaints.clear()
