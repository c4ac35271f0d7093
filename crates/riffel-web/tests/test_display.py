"""Colours, sizes of window and the rules of accessibility."""

import pytest
from axe_playwright_python.sync_playwright import Axe
from test_page import VIEWS


@pytest.mark.without_curves
@pytest.mark.without_remedies
def test_ends_that_are_written_alike_are_one_value(open_page):
    page = open_page(locale="de-DE")
    ranges = """async (all) => {
      const { range } = await import(document.querySelector('script[type=module]').src.replace(/[^/]*$/, 'words.js'));
      return all.map((ends) => range(ends));
    }"""
    cases = {(47, 88): "47–88", (0.3, 0.3): "0,3", (49.98, 50.02): "50", (-1.2, 3): "−1,2–3", (1000.2, 1000.4): "1000"}
    assert page.page.evaluate(ranges, [list(ends) for ends in cases]) == list(cases.values())
    page.close()


@pytest.mark.without_curves
@pytest.mark.without_remedies
def test_the_first_hint_leaves_the_sliders_of_a_phone_free(open_page):
    page = open_page(viewport={"width": 390, "height": 844})
    page.page.click("[popovertarget=help]")
    page.page.click("#help-tour")
    box = lambda selector: page.page.locator(selector).bounding_box()
    sliders, hint = box("#handles"), box("#tour")
    assert hint["y"] >= sliders["y"] + sliders["height"] and hint["y"] + hint["height"] <= 844 and sliders["y"] >= 0
    page.close()


def test_dark(open_page):
    page = open_page(color_scheme="dark")
    ground = "() => getComputedStyle(document.body).backgroundColor"
    assert page.page.evaluate(ground) == "rgb(16, 19, 22)"
    page.keep("dark", whole=True)
    page.page.click("#theme")
    assert page.page.evaluate(ground) == "rgb(238, 240, 242)"
    page.close()


@pytest.mark.parametrize(("name", "width", "height"), [
    ("phone", 360, 740),
    pytest.param("tablet", 820, 1180, marks=pytest.mark.thorough),
    pytest.param("4k", 3840, 2160, marks=pytest.mark.thorough),
])
def test_any_size_of_window(open_page, name, width, height):
    page = open_page(viewport={"width": width, "height": height})
    for view in VIEWS:
        page.page.click(f"#tab-{view}")
        page.settle()
        if view == "curve":
            page.page.wait_for_selector("#wheels tbody tr")
        wide = page.page.evaluate("() => document.documentElement.scrollWidth")
        assert wide <= width, f"{view} is {wide} wide"
        if view == "compare":
            # Nothing lies over the button.
            page.page.click("#keep")
            page.page.locator("#compare-difference").wait_for()
    page.page.click("#tab-explore")
    page.settle()
    page.keep(name, whole=width < 1000)
    page.close()


@pytest.mark.parametrize("scheme", ["light", pytest.param("dark", marks=pytest.mark.thorough)])
def test_rules_of_accessibility(open_page, scheme):
    page = open_page(color_scheme=scheme)
    for view in VIEWS:
        page.page.click(f"#tab-{view}")
        if view == "compare":
            page.page.click("#keep")
            page.page.locator("#compare-difference").wait_for()
        page.page.evaluate("() => document.querySelectorAll('details').forEach((group) => (group.open = true))")
        page.settle()
        # Colours alone differ on a dark page.
        options = {"resultTypes": ["violations"], **({"runOnly": ["color-contrast"]} if scheme == "dark" else {})}
        # What stands beside every view is looked at with the first.
        place = None if view == VIEWS[0] else f"#view-{view}"
        results = Axe().run(page.page, context=place, options=options)
        found = [
            (violation["id"], [node["html"][:160] for node in violation["nodes"]][:3])
            for violation in results.response["violations"]
        ]
        assert found == [], view
    page.close(complaints=len(page.complaints))


def test_curves_follow_the_colours_and_the_language_of_the_page(page):
    ink = lambda: page.page.evaluate("() => ['growth', 'receptance', 'force'].map((id) => document.getElementById(id).layout.font.color)")
    axes = lambda: page.page.evaluate("() => ['growth', 'receptance', 'force'].map((id) => document.getElementById(id).layout.xaxis.title.text)")
    page.page.wait_for_function("() => document.getElementById('growth').data")
    page.settle()
    light, english = ink(), axes()
    page.page.click("#theme")
    page.until(lambda: not set(ink()) & set(light))
    page.page.select_option("#language", "de")
    page.until(lambda: not set(axes()) & set(english))
