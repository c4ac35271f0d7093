"""The map as an instrument: what stands under the pointer, closer looks, the speeds of the traffic, units of speed."""

import json
import math
import re
import subprocess
import tempfile

import pytest
from conftest import PROGRAM, ROOT

pytestmark = pytest.mark.without_curves

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
    page.keep("readout")
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
    page.keep("zoom")
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
    page.close()


def test_the_speeds_of_the_traffic_lie_on_the_map(page):
    assert "usual traffic" in [word["words"] for word in page.page.evaluate(f"() => {VIEW}.taken")]
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    page.page.fill("#traffic-to", "50 m/s")
    page.page.press("#traffic-to", "Tab")
    page.until(lambda: page.page.evaluate(f"() => {VIEW}.band.to") == pytest.approx(50))
    words = [word["words"] for word in page.page.evaluate(f"() => {VIEW}.taken")]
    assert "traffic" in words and "usual traffic" not in words


@pytest.mark.parametrize(("unit", "size"), [("m/s", 1), ("mph", 0.44704)])
def test_speeds_in_other_units(page, unit, size):
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
    page.keep(f"speeds-{unit.replace('/', '-')}")
    # In km/h again the value is still that which was written.
    page.page.select_option("#speed-unit", "km/h")
    page.settle()
    assert page.page.locator("#key-map-speed-max").input_value() == f"50 {unit}"
    assert page.page.evaluate("() => window.riffel.state.head.window.speed_m_per_s.max") == pytest.approx(50 * size)


def test_the_headline_is_growth_under_the_traffic(page):
    """The sentence and the numbers of the program, at speeds at which trains run; other wear than any seen is said to be so."""
    with tempfile.TemporaryDirectory() as folder:
        command = [PROGRAM, "map", "cases/nominal.toml", "--json", "--set", "map.speed.points=5", "-o", folder]
        told = json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout)["under_traffic"]
    assert told["usual_traffic_of"] == "main-line"
    sentence = told["remarks"][0]
    assert page.text("#verdict").startswith(sentence[0].upper() + sentence[1:])
    # The cursor begins where growth is highest at these speeds, not at the edge of the window.
    assert 80 / 3.6 <= page.page.evaluate("() => window.riffel.state.point.speed") <= 140 / 3.6
    assert "faster than any railway known" not in page.text("#verdict") + page.text("#why")
    page.set("wear.coefficient", "2.5e-7 kg/J")
    page.settle()
    for place in ["#verdict", "#why"]:
        assert "faster than any railway known" in page.text(place)
    page.page.locator("#traffic-group summary").click()
    page.page.fill("#traffic-daily", "40")
    page.page.press("#traffic-daily", "Tab")
    page.settle()
    assert "under the traffic given (80–140 km/h, 40 axles a day);" in page.text("#verdict")
    for place in ["#verdict", "#why"]:
        assert "faster than any railway known" not in page.text(place)


@pytest.mark.without_remedies
def test_a_line_has_its_own_usual_traffic(open_page):
    page = open_page(visited=None)
    for line, speeds in [("metro", "40–70 km/h, 6000"), ("freight", "60–100 km/h, 3000"), ("tram", "20–50 km/h, 2400")]:
        page.page.select_option("#start-line", line)
        page.settle()
        assert f"({speeds} axles a day)" in page.text("#verdict")
    page.close()


@pytest.mark.without_remedies
def test_all_wheels_of_a_bogie_run_through_the_curve(open_page, tmp_path):
    page = open_page()
    tick = page.page.locator("#traffic-all-wheels")
    page.page.click("#traffic-group summary")
    assert not tick.is_visible()
    # A law in closed form, which takes tenths of a second.
    text = (ROOT / "cases/metro-curve.toml").read_text().replace('creep_law = "fastsim"', 'creep_law = "polach"')
    page.open_case(text)
    page.until(tick.is_visible)
    page.settle()
    one_wheel = page.text("#verdict")
    tick.check()
    page.settle()
    (tmp_path / "case.toml").write_text(text)
    deviation = 9 / 3.6 / math.sqrt(12)
    (tmp_path / "traffic.toml").write_text(
        '[line]\npassages_per_day = 6000\n[[vehicle]]\nname = "all"\nshare = 1\ncurve = true\n'
        f'speed = {{ mean = "45 km/h", standard_deviation = "{deviation} m/s" }}\n'
    )
    command = [PROGRAM, "map", "case.toml", "--traffic", "traffic.toml", "--json"]
    told = json.loads(subprocess.run(command, cwd=tmp_path, capture_output=True, check=True, text=True).stdout)["under_traffic"]["remarks"][0]
    assert told[1:] in page.text("#verdict") and told[1:] not in one_wheel
    page.close()
