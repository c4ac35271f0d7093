"""The map as an instrument: what stands under the pointer, closer looks, the speeds of the traffic, units of speed."""

import re

import pytest
from conftest import ROOT

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]

VIEW = "document.getElementById('map').view"


def frame(page):
    return page.page.evaluate(f"() => {{ const {{ wavelength, speed }} = {VIEW}.frame; return [wavelength.min, wavelength.max, speed.min, speed.max]; }}")


def under(page, share_x, share_y):
    """A place of the page, and wavelength and speed there."""
    return page.page.evaluate(
        """([right, up]) => {
          const { view } = document.getElementById('map');
          const frame = view.marksOver.getBoundingClientRect();
          const { box, frame: { wavelength, speed } } = view;
          return { x: frame.left + box.left + right * box.width, y: frame.top + box.top + (1 - up) * box.height,
            wavelength: wavelength.min + right * (wavelength.max - wavelength.min), speed: speed.min + up * (speed.max - speed.min) };
        }""",
        [share_x, share_y],
    )


def readout(page):
    return page.page.evaluate(f"() => {VIEW}.readout")


def test_the_pointer_reads_the_map_beside_the_pinned_cursor(page):
    page.page.click("#to-highest")
    page.settle()
    pinned = page.page.evaluate("() => window.riffel.state.point")
    place = under(page, 0.5, 0.5)
    page.page.mouse.move(place["x"], place["y"])
    page.until(lambda: readout(page))
    where, rate = readout(page)
    hertz = place["speed"] / place["wavelength"]
    assert where.startswith(f"{1e3 * place['wavelength']:.3g} mm, {3.6 * place['speed']:.0f} km/h") and f"{hertz:.0f} Hz" in where
    assert page.page.evaluate("() => window.riffel.state.point") == pinned
    # It is the growth that the program gives there.
    page.page.mouse.click(place["x"], place["y"])
    page.settle()
    growth = page.page.evaluate("() => window.riffel.state.at.state.growth_rate_per_passage")
    mantissa, exponent = rate.split(" ")[0].replace("−", "-").split("·10")
    raised = exponent.translate(str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789"))
    assert float(f"{mantissa}e{raised}") == pytest.approx(growth, rel=0.02)
    page.page.mouse.move(5, 5)
    page.until(lambda: not readout(page))


def test_the_wheel_zooms_about_the_pointer_and_keys_and_buttons_do_too(page):
    whole, picture = frame(page), page.map()
    place = under(page, 0.4, 0.45)
    page.page.mouse.move(place["x"], place["y"])
    page.page.mouse.wheel(0, -500)
    page.until(lambda: frame(page) != whole)
    closer = frame(page)
    assert closer[1] - closer[0] == pytest.approx((whole[1] - whole[0]) / 2.718, rel=0.01)
    # The place under the pointer stays there, but for the pixel to which the browser rounds the pointer.
    again = under(page, 0.4, 0.45)
    assert again["wavelength"] == pytest.approx(place["wavelength"], rel=2e-3) and again["speed"] == pytest.approx(place["speed"], rel=5e-3)
    assert page.map() != picture
    page.page.click("#whole-map")
    assert frame(page) == whole and not page.page.locator("#whole-map").is_visible()
    assert page.map() == picture
    # On the whole map the wheel downwards scrolls the page.
    page.page.mouse.move(place["x"], place["y"])
    page.page.mouse.wheel(0, 300)
    page.until(lambda: page.page.evaluate("() => scrollY") > 0)
    assert frame(page) == whole
    page.page.evaluate("() => scrollTo(0, 0)")
    page.page.locator("#map canvas").last.focus()
    page.page.keyboard.press("+")
    assert frame(page) != whole
    # The cursor does not leave the part that is shown.
    for _ in range(60):
        page.page.keyboard.press("ArrowRight")
    page.settle()
    low, high = frame(page)[:2]
    assert low <= page.page.evaluate("() => window.riffel.state.point.wavelength") <= high == whole[1]
    page.page.keyboard.press("0")
    assert frame(page) == whole


def test_a_frame_drawn_with_shift_is_looked_at(page):
    one, other = under(page, 0.2, 0.3), under(page, 0.6, 0.7)
    page.page.click("#to-highest")
    before = page.page.evaluate("() => window.riffel.state.point")
    page.page.mouse.move(one["x"], one["y"])
    page.page.keyboard.down("Shift")
    page.page.mouse.down()
    page.page.mouse.move(other["x"], other["y"], steps=4)
    page.page.mouse.up()
    page.page.keyboard.up("Shift")
    wanted = [one["wavelength"], other["wavelength"], one["speed"], other["speed"]]
    assert frame(page) == pytest.approx(wanted, rel=0.02)
    assert page.page.evaluate("() => window.riffel.state.point") == before
    page.page.mouse.dblclick(one["x"] + 40, one["y"] - 40)
    assert not page.page.locator("#whole-map").is_visible()


def test_two_fingers_zoom(open_page):
    page = open_page(viewport={"width": 360, "height": 740}, has_touch=True)
    whole = frame(page)
    page.page.locator("#map").scroll_into_view_if_needed()
    middle = under(page, 0.5, 0.5)
    session = page.context.new_cdp_session(page.page)

    def touch(kind, apart):
        points = [{"x": middle["x"] + side * apart, "y": middle["y"], "id": k} for k, side in enumerate([-1, 1])]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points if kind != "touchEnd" else []})

    touch("touchStart", 20)
    for apart in [30, 40, 60]:
        touch("touchMove", apart)
    touch("touchEnd", 0)
    page.until(lambda: frame(page) != whole)
    closer = frame(page)
    assert (whole[1] - whole[0]) / (closer[1] - closer[0]) == pytest.approx(3, rel=0.15)


def test_speeds_in_other_units(page):
    unit, size = "mph", 0.44704
    page.page.select_option("#speed-unit", unit)
    page.settle()
    cursor = page.page.evaluate("() => window.riffel.state.point.speed")
    # The usual traffic of a main line begins at 80 km/h.
    for place, speed in [("#verdict", 80 / 3.6), ("#why", cursor)]:
        words = page.text(place)
        told = [float(number) for number in re.findall(r"\d+\.\d+|\d+", words)]
        assert any(abs(number - speed / size) <= 0.051 for number in told) and unit in words and "km/h" not in words
    assert unit in page.text("#branches") and "km/h" not in page.text("#branches")
    assert page.page.locator("#key-map-speed-max-unit").text_content() == unit
    # A bare number is in the unit beside the field.
    page.set("map.speed.max", "50")
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    page.page.fill("#traffic-from", "20")
    page.page.press("#traffic-from", "Tab")
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.head.window.speed_m_per_s.max") == pytest.approx(50 * size)
    assert page.page.evaluate(f"() => {VIEW}.band.from") == pytest.approx(20 * size)
    # In km/h again the value is still that which was written.
    page.page.select_option("#speed-unit", "km/h")
    page.settle()
    assert page.page.locator("#key-map-speed-max").input_value() == f"50 {unit}"
    assert page.page.evaluate("() => window.riffel.state.head.window.speed_m_per_s.max") == pytest.approx(50 * size)


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


@pytest.mark.parametrize("case", ["discrete-supports", *(pytest.param(name, marks=pytest.mark.thorough) for name in ["freight", "main-line", "metro", "tram"])])
def test_branches_have_lines_names_and_words(page, case):
    page.open_case((ROOT / f"cases/{case}.toml").read_text(), f"{case}.toml")
    branches = page.page.evaluate("() => window.riffel.state.head.branches")
    lines = [branch for branch in branches if len(branch["points"]["speed_m_per_s"]) > 1]
    # A line runs through each; marks of the ridge and names lie over parts of it.
    for (points, seen), branch in zip(page.page.evaluate(LINES), branches, strict=True):
        assert points < 2 or seen >= points / 3, branch["frequency_hz"]
    taken = page.page.evaluate(f"() => {VIEW}.taken")
    meet = lambda a, b: a["left"] < b["right"] and b["left"] < a["right"] and a["top"] < b["bottom"] and b["top"] < a["bottom"]
    assert [(a["words"], b["words"]) for k, a in enumerate(taken) for b in taken[:k] if meet(a, b)] == []
    hertz = lambda value: f"{value:.0f} Hz" if value >= 100.0 else f"{round(value, 1):g} Hz"
    assert {hertz(branch["frequency_hz"]) for branch in lines[:4]} <= {word["words"] for word in taken}
    assert f"{branches[0]['frequency_hz']:.0f} Hz" in page.text("#branches") and "branch" in page.text("#branches")
