"""Nothing stale looks fresh, nothing is silent, and no work is lost: steps, links, reloads, projects."""

import base64
import json

import pytest
from test_form import FRICTION, field, value
from test_measure import record, two_rails

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]


def friction(page):
    return page.page.evaluate(FRICTION)


def pale(page, view):
    return page.page.locator(f"#view-{view} .stale:visible").count()


def test_what_is_not_yet_computed_pales_tells_its_share_and_can_be_stopped(page):
    release = page.hold("**/api/map")
    asked = []
    share = {"done": 3, "of": 8}

    def progress(route):
        asked.append(json.loads(route.request.post_data))
        route.fulfill(json=share)

    page.page.route("**/api/progress", progress)
    page.set("contact.friction", "0.3")
    working, bar = page.page.locator("#working"), page.page.locator("#share")
    page.until(lambda: pale(page, "explore") >= 5 and working.is_visible() and bar.is_visible())
    assert asked[0] == {"subject": "map"} and bar.evaluate("bar => bar.position") == 0.375
    # Of what does not count its steps no share is shown.
    share.update(done=0, of=0)
    page.until(lambda: not bar.is_visible())
    assert working.is_visible()
    page.page.click("#stop-work")
    page.until(lambda: not working.is_visible())
    release()
    # It stays pale, and says why and how to go on.
    assert pale(page, "explore") >= 5 and page.page.locator("#trouble .said").is_visible()
    page.page.locator("#trouble").get_by_text("Try again").click()
    page.until(lambda: pale(page, "explore") == 0)
    assert not page.page.locator("#trouble").is_visible()
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.3


def test_without_the_program_the_page_says_what_to_do(page):
    page.page.route("**/api/vocabulary", lambda route: route.abort())
    page.page.reload()
    page.page.locator("#trouble .said").wait_for()
    assert "riffel serve" in page.text("#trouble")
    page.page.unroute("**/api/vocabulary")
    # So does a first map that fails.
    page.page.route("**/api/map", lambda route: route.abort())
    page.page.locator("#trouble button").first.click()
    page.until(lambda: "does not answer" in page.text("#trouble"))
    page.page.unroute("**/api/map")
    page.page.locator("#trouble button").first.click()
    page.page.locator("#verdict", has_text="Hz").wait_for()
    assert not page.page.locator("#trouble").is_visible()
    page.complaints.clear()


def test_a_damaged_link_says_so_and_keeps_what_is_open(page, open_page):
    damage = lambda link: link[:-40]
    page.set("contact.friction", "0.27")
    page.settle()
    link = page.page.url.split("#")[1]
    page.page.evaluate("(link) => (location.hash = link)", damage(link))
    page.until(page.page.locator("#trouble .said").is_visible)
    assert "damaged" in page.text("#trouble") and friction(page) == 0.27 and page.page.url.split("#")[1] == link
    # A good one that follows takes the words away.
    page.set("contact.friction", "0.3")
    page.page.evaluate("(link) => (location.hash = link)", damage(link))
    page.until(page.page.locator("#trouble .said").is_visible)
    page.page.evaluate("(link) => (location.hash = link)", link)
    page.until(lambda: friction(page) == 0.27)
    assert not page.page.locator("#trouble").is_visible()
    # In a window of its own the nominal case opens, with the same words.
    other = open_page(f"#{damage(link)}")
    assert "damaged" in other.text("#trouble") and friction(other) == 0.4
    # So it does for a whole link that holds no case, and without words for none.
    for link, is_told in [("#e30", True), ("#", False)]:
        page.forget()
        page.open(page.home + link)
        assert friction(page) == 0.4 and page.page.locator("#trouble").is_visible() == is_told


def test_a_link_opens_what_was_seen(page):
    page.set("track.model", "two-layer")
    page.set("contact.friction", "0.27")
    page.page.click("#tab-compare")
    page.page.click("#keep")
    page.page.locator(".variants input").fill("dry rail")
    page.page.locator(".variants input").press("Tab")
    page.set("contact.friction", "0.31")
    page.settle()
    address = page.page.url
    page.forget()
    page.open(address)
    assert [value(page, key) for key in ("contact.friction", "track.model")] == ["0.31", "two-layer"]
    # The variant that was kept comes with it, to the view that was open.
    assert page.page.evaluate("() => window.riffel.state.variants.map(({ name, case: keys }) => [name, keys.contact.friction])") == [["dry rail", 0.27]]
    row = page.page.locator("#view-compare tr:has-text('contact.friction')")
    row.wait_for()
    assert row.inner_text().split()[-2:] == ["0.27", "0.31"]
    # A link of before has one variant without a name, and no sum.
    keys = page.page.evaluate("() => window.riffel.state.keys")
    text = json.dumps({"case": keys, "kept": {**keys, "contact": {**keys["contact"], "friction": 0.6}}, "tab": "compare", "point": None})
    page.page.evaluate("(link) => (location.hash = link)", base64.urlsafe_b64encode(text.encode()).decode().rstrip("="))
    page.until(lambda: page.page.evaluate("() => window.riffel.state.variants[0].name") == "A")
    page.settle()


def test_undo_and_redo_by_key_button_and_browser(page):
    for step in ["0.3", "0.2"]:
        page.set("contact.friction", step)
    slider = page.page.locator("#slide-key-contact-friction")
    for step in ["0.5", "0.6"]:
        slider.evaluate("(slider, value) => { slider.value = value; slider.dispatchEvent(new Event('input')); }", step)
    slider.dispatch_event("change")
    assert friction(page) == 0.6
    # A drag is one step.
    page.page.click("#undo")
    assert friction(page) == 0.2
    for keys, expected in [("Control+z", 0.3), ("Control+Shift+z", 0.2), ("Control+z", 0.3), ("Control+z", 0.4)]:
        page.page.keyboard.press(keys)
        assert friction(page) == expected
    assert page.page.locator("#undo").is_disabled()
    page.page.click("#redo")
    page.settle()
    assert friction(page) == 0.3 and value(page, "contact.friction") == "0.3"
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.3
    # While a text is written, the browser undoes letters.
    field(page, "contact.friction").focus()
    page.page.keyboard.type("9")
    page.page.keyboard.press("Control+z")
    assert friction(page) == 0.3 and value(page, "contact.friction") == "0.3"
    # The browser goes back through cases and views.
    page.set("contact.friction", "0.25")
    page.page.click("#tab-measure")
    page.page.go_back()
    page.until(page.page.locator("#view-explore").is_visible)
    assert friction(page) == 0.25
    page.page.go_back()
    page.until(lambda: friction(page) == 0.3)
    page.page.go_forward()
    page.until(lambda: friction(page) == 0.25)


def test_an_answer_leaves_what_is_being_written(page):
    release = page.hold("**/api/**")
    page.set("contact.friction", "0.3")
    field(page, "contact.friction").fill("0.2")
    release()
    page.settle()
    assert value(page, "contact.friction") == "0.2" and friction(page) == 0.3
    field(page, "contact.friction").press("Tab")
    page.settle()
    assert value(page, "contact.friction") == "0.2" and friction(page) == 0.2


def test_a_reload_loses_nothing(page):
    page.set("contact.friction", "0.3")
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    page.page.fill("#traffic-daily", "4000")
    page.page.press("#traffic-daily", "Tab")
    record(page, two_rails(4), "trolley.csv")
    page.settle()
    page.page.reload()
    page.settle()
    page.until(lambda: page.page.locator(".sentences li").count() > 0)
    assert "trolley.csv" in page.text("#record-state") and page.page.locator("#traffic-daily").input_value() == "4000" and friction(page) == 0.3
    # The steps are still there.
    page.page.click("#undo")
    page.page.click("#undo")
    page.until(lambda: friction(page) == 0.4)
    page.page.click("#redo")
    page.settle()
    # A visit without a link goes on where the last one ended, and a record that the program has lost is asked for.
    page.page.goto(page.picture)
    page.page.evaluate("() => sessionStorage.setItem('riffel-page', 'another')")
    page.open(page.home)
    assert friction(page) == 0.3 and page.page.locator("#notice").is_visible()
    page.page.click("#tab-measure")
    page.until(lambda: "trolley.csv" in page.text("#trouble"))
    page.refused(410)


def test_a_project_holds_all_that_is_open_and_opens_again(page):
    given = lambda name, text: {"name": name, "mimeType": "text/csv", "buffer": text.encode()}
    record(page, two_rails(4), "new.csv")
    page.give("#earlier-file", [given("old.csv", two_rails(3))])
    page.page.locator("#earlier-records input").wait_for()
    page.give("#line-table", [given("line.csv", "position_m;kind;name\n12;weld;W 7\n")])
    page.until(page.page.locator("#line-table-drop").is_visible)
    for place, date in [("#record-date", "2026-05-01"), ("#earlier-records input[type=date]", "2025-05-01")]:
        page.page.fill(place, date)
        page.page.locator(place).blur()
    page.settle()
    name, text = page.take("project")
    assert name.endswith(".riffel") and "the record new.csv with 1 earlier" in page.text("#notice")
    # What is none is refused in a sentence, and what is open stays.
    page.set("title", "another case")
    page.open_case(text.decode()[:1000], name="all.riffel")
    page.until(lambda: "damaged" in page.text("#trouble"))
    assert page.page.evaluate("() => window.riffel.state.keys.title") == "another case"
    page.page.locator("#earlier-records button").click()
    # Dropped on the page it is opened as well as chosen, and is not taken for a record.
    page.page.evaluate(
        """(text) => {
          const files = new DataTransfer();
          files.items.add(new File([text], 'all.riffel'));
          document.getElementById('drop').dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
        }""",
        text.decode(),
    )
    page.until(lambda: page.page.locator("#earlier-records li").count() == 1 and page.page.locator("#line-table-drop").is_visible())
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.keys") == json.loads(text)["case"] and not page.page.locator("#trouble").is_visible()
    assert page.text("#record-state").startswith("new.csv")
    assert [page.page.locator(place).input_value() for place in ("#record-date", "#earlier-records input[type=date]")] == ["2026-05-01", "2025-05-01"]
    # A record that was removed is gone for who still asked about it.
    page.refused(410)


def test_the_page_hands_out_files_each_once(page):
    asked = page.asked("/api/export/csv")
    given = []
    page.on("download", lambda download: given.append(download))
    page.page.click("[popovertarget=take-away]")
    page.page.locator("[data-take=csv]").dblclick()
    page.until(lambda: given)
    page.settle()
    assert (len(asked), len(given)) == (1, 1)
    for kind, begin in {"toml": b"", "png": b"\x89PNG", "svg": b"<svg", "html": b"<!DOCTYPE html>"}.items():
        name, content = page.take(kind)
        assert content.startswith(begin) and name.endswith(kind)
        assert kind != "toml" or b'model = "free-beam"' in content
    # The report is that of the case, where no rail is measured.
    name, content = page.take("report")
    assert name == "br-main-line-tangent-track-report.html" and b"no roughness was given" in content and b"riffel-serve" not in content


def test_a_link_is_copied_and_says_what_it_holds(open_page):
    page = open_page(locale="de-DE", permissions=["clipboard-read", "clipboard-write"])
    page.page.click("[popovertarget=take-away]")
    page.page.click("[data-take=link]")
    page.until(lambda: page.page.evaluate("() => navigator.clipboard.readText()") == page.page.url)
    assert page.page.locator("#notice #link").input_value() == page.page.url and "Der Link enthält" in page.text("#notice")


def test_a_busy_program_is_asked_again(page):
    turned_away = []

    def busy(route):
        if turned_away:
            return route.continue_()
        turned_away.append(route.request.url)
        return route.fulfill(status=503, headers={"Retry-After": "1"}, content_type="application/json", body='{"message": "busy"}')

    page.page.route("**/api/map", busy)
    page.set("contact.friction", "0.6")
    page.until(lambda: turned_away)
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.6 and not page.page.locator("#trouble").is_visible()
    page.refused(503)
