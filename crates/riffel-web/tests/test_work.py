"""Nothing stale looks fresh, nothing is silent, and no work is lost."""

import json

import pytest
from test_page import NOMINAL, drag, profile

pytestmark = pytest.mark.without_curves

FRICTION = "() => window.riffel.state.keys.contact.friction"


def friction(page):
    return page.page.evaluate(FRICTION)


def hold(page, path):
    """Keep answers back until the function that is returned is called."""
    kept = []
    page.page.route(path, lambda route: kept.append(route))

    def release():
        page.page.unroute(path)
        for route in kept:
            try:
                route.continue_()
            except Exception:  # noqa: BLE001 - the page has given up the question.
                pass

    return release


def pale(page, view):
    return page.page.locator(f"#view-{view} .stale:visible").count()


def test_what_is_not_yet_computed_pales_and_can_be_stopped(open_page):
    page = open_page()
    release = hold(page, "**/api/map")
    page.set("contact.friction", "0.3")
    page.until(lambda: pale(page, "explore") >= 5)
    working = page.page.locator("#working")
    page.until(working.is_visible)
    page.keep("working")
    page.page.click("#stop-work")
    page.until(lambda: not working.is_visible())
    release()
    # It stays pale, and says why and how to go on.
    assert pale(page, "explore") >= 5
    page.until(page.page.locator("#trouble .said").is_visible)
    page.page.locator("#trouble").get_by_text("Try again").click()
    page.until(lambda: pale(page, "explore") == 0)
    assert not page.page.locator("#trouble").is_visible()
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.3
    page.close(complaints=len(page.complaints))


@pytest.mark.parametrize(("steps", "share"), [((3, 8), 0.375), ((0, 0), None)])
def test_long_work_tells_its_share(open_page, steps, share):
    page = open_page()
    release = hold(page, "**/api/remedies")
    asked = []

    def answer(route):
        asked.append(json.loads(route.request.post_data))
        route.fulfill(json=dict(zip(("done", "of"), steps)))

    page.page.route("**/api/progress", answer)
    page.set("contact.friction", "0.3")
    page.until(lambda: {"subject": "remedies"} in asked)
    bar = page.page.locator("#share")
    page.until(lambda: bar.is_visible() == (share is not None))
    assert share is None or bar.evaluate("bar => bar.position") == share
    page.keep("share")
    release()
    page.until(lambda: not page.page.locator("#working").is_visible())
    page.close(complaints=len(page.complaints))


def test_a_case_that_is_refused_pales_what_is_shown(open_page):
    page = open_page()
    page.set("contact.normal_load", "-50")
    page.until(lambda: pale(page, "explore") >= 5)
    # The cursor still moves over the case that is shown, without further errors.
    before = len(page.complaints)
    box = page.page.locator("#map").bounding_box()
    page.page.mouse.click(box["x"] + 0.3 * box["width"], box["y"] + 0.2 * box["height"])
    page.settle()
    assert len(page.complaints) == before
    assert pale(page, "explore") >= 5
    page.set("contact.normal_load", "50")
    page.until(lambda: pale(page, "explore") == 0)
    page.close(complaints=before)


def test_comparison_and_measurement_pale_with_the_case(page):
    page.page.click("#tab-compare")
    page.page.click("#keep")
    page.page.locator("#compare-difference").wait_for()
    release = hold(page, "**/api/compare")
    page.set("contact.friction", "0.3")
    page.until(lambda: pale(page, "compare") == 5)
    release()
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "trolley.csv", "mimeType": "text/csv", "buffer": profile()}])
    page.until(lambda: page.page.locator(".sentences li.bad").count() > 0)
    page.until(lambda: pale(page, "measure") == 0)
    release = hold(page, "**/api/ask/measure")
    page.set("contact.friction", "0.25")
    page.until(lambda: pale(page, "measure") >= 4)
    release()
    page.until(lambda: pale(page, "measure") == 0)


@pytest.mark.parametrize("damage", [lambda link: link[:-40], lambda link: link[:60] + "!" + link[61:], lambda link: link[:60] + ("A" if link[60] != "A" else "B") + link[61:]])
def test_a_damaged_link_says_so_and_keeps_what_is_open(page, open_page, damage):
    page.set("contact.friction", "0.27")
    page.settle()
    link = page.page.url.split("#")[1]
    page.page.evaluate("(link) => (location.hash = link)", damage(link))
    page.until(page.page.locator("#trouble .said").is_visible)
    assert "damaged" in page.text("#trouble")
    assert friction(page) == 0.27
    assert page.page.url.split("#")[1] == link
    # A good one that follows takes the words away.
    page.set("contact.friction", "0.3")
    page.page.evaluate("(link) => (location.hash = link)", damage(link))
    page.until(page.page.locator("#trouble .said").is_visible)
    page.page.evaluate("(link) => (location.hash = link)", link)
    page.until(lambda: friction(page) == 0.27)
    assert not page.page.locator("#trouble").is_visible()
    # In a window of its own the nominal case opens, with the same words.
    other = open_page(f"#{damage(link)}")
    assert "damaged" in other.text("#trouble")
    assert friction(other) == 0.4
    other.close()


def test_a_case_that_never_had_an_answer_is_not_said_to_be_shown(page):
    page.set("wheel.mass", "350 stones")
    page.until(page.page.locator("#trouble [data-field]").is_visible)
    assert "is the last case without an error" in page.text("#trouble")
    page.settle()
    page.page.reload()
    page.until(page.page.locator("#trouble [data-field]").is_visible)
    assert "nothing can be shown before" in page.text("#trouble")
    page.page.locator("#trouble [data-field]").click()
    assert page.page.locator("#key-wheel-mass").input_value() == "350 stones"
    page.set("wheel.mass", "350")
    page.settle()
    # A value that is missing is not shown as one that stands in for it.
    page.set("wheel.mass", "")
    page.until(lambda: "is missing" in page.text("#key-wheel-mass-fault"))
    page.settle()
    assert page.page.locator("#key-wheel-mass").get_attribute("placeholder") == ""
    page.set("wheel.mass", "350")
    page.settle()
    assert page.page.locator("#key-wheel-inertia").get_attribute("placeholder") != ""
    assert not page.page.locator("#trouble").is_visible()
    page.complaints.clear()


def test_without_the_program_the_page_says_what_to_do(browser, served):
    context = browser.new_context(locale="de-DE")
    page = context.new_page()
    page.route("**/api/vocabulary", lambda route: route.abort())
    page.goto(served.url)
    page.locator("#trouble .said").wait_for()
    assert "riffel serve" in page.locator("#trouble").inner_text()
    page.unroute("**/api/vocabulary")
    page.locator("#trouble button").first.click()
    page.locator("#verdict", has_text="Hz").wait_for()
    context.close()


def test_a_first_map_that_fails_can_be_asked_for_again(open_page):
    page = open_page()
    failing = page.context.new_page()
    failing.route("**/api/map", lambda route: route.abort())
    failing.goto(page.page.url.split("#")[0])
    failing.locator("#trouble .said").wait_for()
    failing.select_option("#language", "de")
    assert "antwortet nicht" in failing.locator("#trouble").inner_text()
    failing.unroute("**/api/map")
    failing.locator("#trouble button").first.click()
    failing.locator("#verdict", has_text="Hz").wait_for()
    assert not failing.locator("#trouble").is_visible()
    page.close()


def test_undo_and_redo_by_key_button_and_browser(page):
    for value in ["0.3", "0.2"]:
        page.set("contact.friction", value)
        page.settle()
    drag(page, "contact-friction", 0.5)
    drag(page, "contact-friction", 0.6)
    page.page.locator("#slide-key-contact-friction").dispatch_event("change")
    page.settle()
    assert friction(page) == 0.6
    # A drag is one step.
    page.page.click("#undo")
    assert friction(page) == 0.2
    page.page.keyboard.press("Control+z")
    assert friction(page) == 0.3
    page.page.keyboard.press("Control+Shift+z")
    assert friction(page) == 0.2
    page.page.keyboard.press("Control+z")
    page.page.keyboard.press("Control+z")
    assert friction(page) == 0.4
    assert page.page.locator("#undo").is_disabled()
    page.page.click("#redo")
    page.settle()
    assert friction(page) == 0.3
    assert page.page.locator("#key-contact-friction").input_value() == "0.3"
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.3
    # While a text is written, the browser undoes letters.
    field = page.page.locator("#key-contact-friction")
    field.focus()
    page.page.keyboard.type("9")
    page.page.keyboard.press("Control+z")
    assert friction(page) == 0.3 and field.input_value() == "0.3"


def test_an_answer_leaves_what_is_being_written(page):
    release = hold(page, "**/api/**")
    page.set("contact.friction", "0.3")
    field = page.page.locator("#key-contact-friction")
    field.fill("0.2")
    release()
    page.settle()
    assert field.input_value() == "0.2" and friction(page) == 0.3
    field.press("Tab")
    page.settle()
    assert field.input_value() == "0.2" and friction(page) == 0.2


def test_the_browser_goes_back_through_cases_and_views(page):
    page.set("contact.friction", "0.3")
    page.set("contact.friction", "0.2")
    page.page.click("#tab-measure")
    page.page.go_back()
    page.until(page.page.locator("#view-explore").is_visible)
    assert friction(page) == 0.2
    page.page.go_back()
    page.until(lambda: friction(page) == 0.3)
    page.page.go_back()
    page.until(lambda: friction(page) == 0.4)
    page.page.go_forward()
    page.until(lambda: friction(page) == 0.3)
    page.page.go_forward()
    page.until(lambda: friction(page) == 0.2)
    page.page.click("#undo")
    page.until(lambda: friction(page) == 0.3)


def test_starting_over_and_dropped_files_can_be_undone(page):
    page.set("contact.friction", "0.3")
    page.page.locator("[popovertarget=take-away]").click()
    page.page.click("[data-take=nominal]")
    page.until(lambda: friction(page) == 0.4)
    page.page.locator("#notice").get_by_text("Undo").click()
    page.until(lambda: friction(page) == 0.3)
    text = NOMINAL.replace("friction = 0.4", "friction = 0.55")
    page.page.evaluate(
        """(text) => {
          const files = new DataTransfer();
          files.items.add(new File([text], 'other.toml'));
          document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
        }""",
        text,
    )
    page.until(lambda: friction(page) == 0.55)
    assert "other.toml" in page.text("#notice")
    page.page.locator("#notice").get_by_text("Undo").click()
    page.until(lambda: friction(page) == 0.3)


def test_a_record_that_takes_the_place_of_another_can_be_undone(page):
    page.page.click("#tab-measure")
    for name in ["first.csv", "second.csv"]:
        page.give("#record", files=[{"name": name, "mimeType": "text/csv", "buffer": profile(20)}])
        page.until(lambda: name in page.text("#record-state") and page.page.evaluate("() => document.getElementById('upload').hidden"))
    page.until(page.page.locator("#notice").is_visible)
    page.page.locator("#notice").get_by_text("Undo").click()
    page.until(lambda: "first.csv" in page.text("#record-state"))


def test_a_reload_loses_nothing(page):
    page.set("contact.friction", "0.3")
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    page.page.fill("#traffic-daily", "4000")
    page.page.press("#traffic-daily", "Tab")
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "trolley.csv", "mimeType": "text/csv", "buffer": profile()}])
    page.until(lambda: page.page.locator(".sentences li.bad").count() > 0)
    page.settle()
    page.page.reload()
    page.settle()
    page.until(lambda: page.page.locator(".sentences li.bad").count() > 0)
    assert "trolley.csv" in page.text("#record-state")
    assert page.page.locator("#traffic-daily").input_value() == "4000"
    assert friction(page) == 0.3
    # The steps are still there.
    page.page.click("#undo")
    page.page.click("#undo")
    page.until(lambda: friction(page) == 0.4)


def test_a_visit_without_a_link_goes_on_where_the_last_one_ended(page):
    page.set("contact.friction", "0.3")
    page.settle()
    later = page.context.new_page()
    later.goto(page.page.url.split("#")[0])
    later.locator("#notice").wait_for()
    assert later.evaluate(FRICTION) == 0.3
    later.close()


def test_a_record_that_the_program_has_lost_is_asked_for(open_page):
    page = open_page()
    page.page.evaluate("(record) => sessionStorage.setItem('riffel-record', record)", json.dumps({"name": "trolley.csv", "size": 1}))
    page.page.reload()
    page.settle()
    page.page.click("#tab-measure")
    page.until(page.page.locator("#trouble .said").is_visible)
    assert "trolley.csv" in page.text("#trouble")
    page.close(complaints=1)


def test_growth_is_told_in_time_and_tonnes(page):
    assert "with the usual traffic" in page.text("#why") and "usual traffic of a main line" in page.text("#verdict")
    before = page.page.evaluate("() => Math.LN2 / window.riffel.state.at.state.growth_rate_per_passage")
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    # So many passages in a day that doubling takes ten days, which no railway has known, and 120.
    for days, told in [(10, "faster than any railway known"), (120, "3.9 months")]:
        page.page.fill("#traffic-daily", f"{before / days:.0f}")
        page.page.press("#traffic-daily", "Tab")
        page.until(lambda told=told: told in page.text("#why"))
    # An axle has two wheels of 50 kN each.
    megatonnes = before * 100e3 / 9.80665 / 1e9
    assert f"{megatonnes:.2g}" in page.text("#why") and "MGT" in page.text("#why")
    for place in ["#verdict", "#why"]:
        page.until(lambda place=place: "usual" not in page.text(place))


@pytest.mark.parametrize("width", [360, 1280])
def test_targets_are_large_enough_for_a_finger(open_page, width):
    page = open_page(viewport={"width": width, "height": 800})
    page.page.evaluate("() => document.querySelectorAll('details').forEach((group) => (group.open = true))")
    page.set("wheel.mass", "1,000")
    small = """() => [...document.querySelectorAll('button, input:not(.away), select, summary, label.plain')]
      .filter((one) => one.checkVisibility() && !one.closest('[popover]'))
      .map((one) => [one.id || one.textContent, one.getBoundingClientRect()])
      .filter(([, { width, height }]) => Math.min(width, height) < 24 - 0.01).map(([name, { width, height }]) => `${name} ${width} ${height}`)"""
    for view in ["explore", "compare", "measure"]:
        page.page.click(f"#tab-{view}")
        assert page.page.evaluate(small) == [], view
    page.close()


def test_growth_at_the_cursor_is_announced(page):
    page.page.locator("#map canvas").last.focus()
    page.page.keyboard.press("ArrowUp")
    page.settle()
    page.until(lambda: page.page.locator("#live").text_content() == page.text("#why"))


def test_a_double_click_gives_one_file(page):
    asked = []
    page.page.on("request", lambda request: request.url.endswith("/api/export/csv") and asked.append(request))
    given = []
    page.page.on("download", lambda download: given.append(download))
    page.page.locator("[popovertarget=take-away]").click()
    page.page.locator("[data-take=csv]").dblclick()
    page.until(lambda: given)
    page.pause()
    assert (len(asked), len(given)) == (1, 1)
