"""What stays in its place: curves after a resize elsewhere, bubbles in the window, hints under a finger, the first visit first."""

import pytest


def test_curves_follow_a_resize_made_in_another_view(page):
    widths = "() => ['growth', 'receptance', 'traffic-curve'].map((id) => { const place = document.getElementById(id); return [place.querySelector('.main-svg').clientWidth, place.clientWidth]; })"
    page.page.click("#tab-compare")
    page.settle()
    page.page.set_viewport_size({"width": 1000, "height": 800})
    page.page.click("#tab-explore")
    page.settle()
    page.until(lambda: all(drawn == there for drawn, there in page.page.evaluate(widths)))


@pytest.mark.without_curves
@pytest.mark.parametrize("height", [420, 844])
def test_sources_stay_inside_the_window(open_page, height):
    page = open_page(viewport={"width": 390, "height": height})
    page.page.evaluate("() => document.querySelectorAll('#keys details').forEach((group) => (group.open = true))")
    page.set("track.preset", "br-stiff")
    page.settle()
    for block in ["start", "end"]:
        page.page.locator("#key-track-preset").evaluate("(field, block) => field.scrollIntoView({ block })", block)
        page.page.locator(".row:has(#key-track-preset) .info").click()
        bubble = page.page.locator("#key-track-preset-sources")
        bubble.wait_for()
        page.pause()
        box = bubble.bounding_box()
        assert box["x"] >= 0 and box["x"] + box["width"] <= 390
        assert box["y"] >= 0 and box["y"] + box["height"] <= height
        page.page.keyboard.press("Escape")
    page.close()


@pytest.mark.without_curves
def test_a_finger_reaches_the_hint_of_a_key(open_page):
    page = open_page(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    content = "(field) => getComputedStyle(field.closest('.row').querySelector('label'), '::after').content"
    field = page.page.locator("#key-contact-friction")
    field.evaluate("(field) => (field.closest('details').open = true)")
    assert field.evaluate(content) == "none"
    page.page.locator("label[for=key-contact-friction]").tap()
    assert "contact.friction" in field.evaluate(content)
    page.close()


@pytest.mark.without_curves
def test_the_choice_of_a_first_visit_comes_first(open_page):
    page = open_page(visited=None)
    assert page.page.evaluate("() => document.activeElement.id") == "start-line"
    before = "() => Boolean(document.getElementById('start').compareDocumentPosition(document.getElementById('case')) & Node.DOCUMENT_POSITION_FOLLOWING)"
    assert page.page.evaluate(before)
    page.keep("first-visit")
    # It is of the map.
    page.page.click("#tab-paper")
    assert page.page.locator("#start").is_hidden()
    page.page.click("#tab-explore")
    assert page.page.locator("#start").is_visible()
    page.close()


@pytest.mark.without_curves
def test_what_is_empty_says_what_comes(page):
    page.page.click("#tab-compare")
    assert "curves of growth over wavelength come here" in page.text("#sweep")
    page.page.click("#sweep-friction")
    page.settle()
    assert "come here" not in page.text("#sweep")
    page.page.click("#sweep-pads")
    page.settle()
    assert "this track model has no pads" in page.text("#sweep")
