"""The view of the case: map, loop and curves follow a hand; colours, sizes, keyboard and language of all views."""

import re

import pytest
from axe_playwright_python.sync_playwright import Axe
from conftest import small

pytestmark = pytest.mark.without_remedies

VIEWS = ["explore", "compare", "measure", "calibrate", "curve", "motion", "paper"]
SLIDE = "([id, value]) => { const slider = document.getElementById(`slide-key-${id}`); slider.value = value; slider.dispatchEvent(new Event('input', { bubbles: true })); }"


def drag(page, slider, value):
    page.page.evaluate(SLIDE, [slider, value])


def test_the_nominal_map_is_there_and_the_cursor_leads_loop_and_curves(page):
    assert "537 Hz" in page.text("#branches") and "corrugation grows" in page.text("#why")
    assert page.page.locator("#growth .main-svg").count() > 0
    box = page.page.locator("#map").bounding_box()
    page.page.mouse.click(box["x"] + 0.3 * box["width"], box["y"] + 0.2 * box["height"])
    page.settle()
    assert "decays" in page.text("#why")
    page.page.click("#to-highest")
    page.settle()
    assert "grows" in page.text("#why")
    # A screen reader is told of it.
    page.until(lambda: page.page.locator("#live").text_content() == page.text("#why"))
    page.keep("explore", whole=True)


def test_map_case_words_and_curves_follow_a_slider(page):
    ghosts = "(id) => document.getElementById(id).data.filter(({ name }) => name === 'ghost').map(({ y }) => Math.max(...y))"
    highest = "() => Math.max(...window.riffel.state.at.growth.growth_rate_per_passage)"
    before, picture, words = page.page.evaluate(highest), page.map(), page.text("#verdict")
    drag(page, "contact-friction", 0.2)
    page.settle()
    assert page.page.locator("#key-contact-friction").input_value() == "0.2" and page.text("#verdict") != words
    # The curve of before stays behind until the slider is let go; both in one power of ten.
    now = page.page.evaluate(highest)
    [ghost] = page.page.evaluate(ghosts, "growth")
    assert ghost / max(page.page.evaluate("() => document.getElementById('growth').data.at(-2).y")) == pytest.approx(before / now)
    assert len(page.page.evaluate(ghosts, "receptance")) == 2 and len(page.page.evaluate(ghosts, "force")) == 1
    page.page.locator("#slide-key-contact-friction").dispatch_event("change")
    page.settle()
    assert [page.page.evaluate(ghosts, place) for place in ("growth", "receptance", "force")] == [[], [], []]
    drag(page, "contact-tractive_ratio", 0.9)
    page.settle()
    assert page.map() != picture
    # Sliders speak in the units of engineers.
    drag(page, "wheel-inertia", 400)
    assert page.page.locator("#key-wheel-inertia").input_value() == "300" and page.page.locator("#key-wheel-inertia-unit").text_content() == "kg m²"
    page.settle()


def test_a_fast_hand_is_not_left_behind_and_curves_wait_for_the_map(page):
    page.page.evaluate(
        """() => {
          window.drawn = 0;
          document.getElementById('growth').on('plotly_afterplot', () => window.drawn++);
          // A screen that is late.
          const [frame, late] = [window.requestAnimationFrame.bind(window), []];
          window.requestAnimationFrame = (draw) => late.push(draw);
          window.paint = () => {
            window.requestAnimationFrame = frame;
            late.forEach((draw) => frame(draw));
          };
          performance.clearMarks('riffel-map-shown');
          const slider = document.getElementById('slide-key-contact-friction');
          for (let k = 0; k < 300; k++) {
            slider.value = 0.2 + 0.001 * k;
            slider.dispatchEvent(new Event('input'));
          }
        }"""
    )
    page.until(lambda: page.page.evaluate("() => window.riffel.state.current && performance.getEntriesByName('riffel-map-shown').length"))
    assert page.page.evaluate("() => window.drawn") == 0
    page.page.evaluate("() => window.paint()")
    page.settle()
    assert page.page.evaluate("() => window.drawn") >= 1
    # What is shown is the last that was asked, and most that lay between was not.
    assert page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == pytest.approx(0.5)
    assert page.page.evaluate("() => window.riffel.traffic.superseded") > 200


def test_by_keyboard_alone(page):
    keys = page.page.keyboard
    focused = lambda: page.page.evaluate("() => document.activeElement.id || document.activeElement.className")
    page.page.locator("body").focus()
    keys.press("Tab")
    assert focused() == "skip"
    # Tabs are reached with arrows from the first.
    keys.press("Tab")
    assert focused() == "tab-explore"
    for key, view in [("ArrowRight", "compare"), ("ArrowLeft", "explore"), ("ArrowLeft", "paper"), ("ArrowRight", "explore")]:
        keys.press(key)
        assert focused() == f"tab-{view}" and page.page.locator(f"#view-{view}").is_visible()
    # On to the first slider, and step it.
    for _ in range(30):
        keys.press("Tab")
        if focused() == "slide-key-contact-friction":
            break
    for _ in range(10):
        keys.press("ArrowRight")
    page.settle()
    assert page.page.locator("#key-contact-friction").input_value() == "0.45"
    # The cursor of the map follows the arrows, and Home goes to the highest growth.
    page.page.locator("#map canvas").last.focus()
    highest = page.page.evaluate("() => window.riffel.state.point")
    keys.press("ArrowUp")
    keys.press("ArrowLeft")
    moved = page.page.evaluate("() => window.riffel.state.point")
    assert moved["speed"] > highest["speed"] and moved["wavelength"] < highest["wavelength"]
    keys.press("Home")
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.point.speed === window.riffel.state.map.highest.speed_m_per_s")


def test_curves_follow_colours_language_and_size(page):
    plots = ["growth", "receptance", "force"]
    of = lambda what: page.page.evaluate(f"(all) => all.map((id) => document.getElementById(id).layout.{what})", plots)
    ground = lambda: page.page.evaluate("() => getComputedStyle(document.body).backgroundColor")
    light, english = of("font.color"), of("xaxis.title.text")
    assert ground() == "rgb(238, 240, 242)"
    page.page.click("#theme")
    assert ground() == "rgb(16, 19, 22)"
    page.until(lambda: not set(of("font.color")) & set(light))
    page.speak("de")
    page.until(lambda: not set(of("xaxis.title.text")) & set(english))
    # A resize in another view is made good.
    widths = "(all) => all.map((id) => document.getElementById(id)).map((place) => [place.querySelector('.main-svg').clientWidth, place.clientWidth])"
    page.page.click("#tab-compare")
    page.page.set_viewport_size({"width": 1000, "height": 800})
    page.page.click("#tab-explore")
    page.settle()
    page.until(lambda: all(drawn == there for drawn, there in page.page.evaluate(widths, plots)))


def opened(page, view):
    """A view with what it shows of itself."""
    page.page.click(f"#tab-{view}")
    if view == "compare":
        page.page.click("#keep")
        page.page.locator("#compare-difference").wait_for()
    page.settle()


LARGE = """() => [...document.querySelectorAll('button, input:not(.away), select, summary, label.plain')]
  .filter((one) => one.checkVisibility() && !one.closest('[popover]'))
  .map((one) => [one.id || one.textContent, one.getBoundingClientRect()])
  .filter(([, { width, height }]) => Math.min(width, height) < 24 - 0.01).map(([name, { width, height }]) => `${name} ${width} ${height}`)"""


@pytest.mark.parametrize(("width", "height"), [(360, 740), pytest.param(820, 1180, marks=pytest.mark.thorough), pytest.param(3840, 2160, marks=pytest.mark.thorough)])
def test_any_size_of_window(page, width, height):
    page.page.set_viewport_size({"width": width, "height": height})
    page.page.evaluate("() => document.querySelectorAll('details').forEach((group) => (group.open = true))")
    for view in VIEWS:
        opened(page, view)
        page.fits()
        # Targets are large enough for a finger.
        assert view not in ("explore", "compare", "measure") or page.page.evaluate(LARGE) == [], view
        page.keep(f"{view}-{width}", whole=width < 1000)


# Long: looks at every view of the page.
@pytest.mark.parametrize("scheme", ["light", pytest.param("dark", marks=pytest.mark.thorough)])
def test_rules_of_accessibility(page, scheme):
    page.page.emulate_media(color_scheme=scheme)
    # Colours alone differ on a dark page.
    options = {"resultTypes": ["violations"], **({"runOnly": ["color-contrast"]} if scheme == "dark" else {})}
    for view in VIEWS:
        opened(page, view)
        page.page.evaluate("() => document.querySelectorAll('details').forEach((group) => (group.open = true))")
        # What stands beside every view is looked at with the first.
        violations = Axe().run(page.page, context=None if view == VIEWS[0] else f"#view-{view}", options=options).response["violations"]
        assert [(one["id"], [node["html"][:160] for node in one["nodes"]][:3]) for one in violations] == [], view


# Small words without which English gets nowhere, and which German does not have. Names of standards and sources keep theirs.
ENGLISH = re.compile(
    r"\b(the|of|and|is|are|at|from|with|by|on|not|over|under|after|which|that|must|no|rails?|wheels?|track|speed|force|level|growth|"
    r"limit|left|right|now|length|wavelength|choose|give|stiff|soft|pads?|sleepers?|ballast|half|driven|typical|chosen)\b"
)
# So do keys and names of a case file.
KEPT = re.compile(r"\b[a-z_]+(?:\.[a-z_]+)+|\b[a-z]+ = |\b[a-z]+(?:-[a-z]+)+|Grassie, Saxon & Smith|Shock and Vibration|Figure \d|\(?\w+ \(?20\d\d\)?.*?;|`[^`]*`|\"[^\"]*\"|„[^“]*“|riffel [a-z-]+|--[a-z-]+")


def english(text):
    return [line for line in text.split("\n") if ENGLISH.search(KEPT.sub("", line)) and "Shock and Vibration" not in line]


# What a reader sees or hears; menus list the names of a case file, and titles of cases are those of their authors.
SEEN = r"""() => {
  const seen = new Set();
  const note = (text) => (text ?? '').split('\n').forEach((line) => line.trim() && seen.add(line.trim()));
  for (const node of document.querySelectorAll('body *')) {
    if (!node.checkVisibility() || node.closest('option, select, script, style, noscript, #map-title, #key-title, #field th')) continue;
    for (const name of ['title', 'aria-label', 'placeholder', 'aria-valuetext']) note(node.getAttribute(name));
    for (const child of node.childNodes) if (child.nodeType === Node.TEXT_NODE) note(child.textContent);
  }
  for (const option of document.querySelectorAll('option')) note(option.title);
  return [...seen];
}"""


# Long: opens every view of the page in German.
def test_no_view_says_anything_in_english(page):
    """One page in German, of which each view is opened in turn: that all words have their German is held by the unit tests."""
    page.speak("de")
    page.open_case(small("metro"))
    page.page.locator("details").evaluate_all("(all) => all.forEach((one) => (one.open = true))")
    assert page.page.locator("html").get_attribute("lang") == "de" and "Riffel wächst" in page.text("#why")
    # A number has its comma, shown as well as read.
    page.set("contact.friction", "0,35")
    page.settle()
    assert page.page.locator("#key-contact-friction").input_value() == "0,35" and page.page.evaluate("() => window.riffel.state.head.complete.contact.friction") == 0.35
    for view in ["explore", "compare", "measure", "calibrate", "curve", "motion", "paper"]:
        opened(page, view)
        if view == "measure":
            page.page.click("#sample")
            page.page.locator("#noise-parts td").first.wait_for()
            page.settle()
        seen = page.page.evaluate(SEEN)
        assert len(seen) > 50 and english("\n".join(seen)) == [], view
    page.keep("german")
