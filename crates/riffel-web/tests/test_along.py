"""A measured rail along the line under the pointer."""

import math

import pytest
from conftest import small
from test_measure import along, curves, record, two_rails

pytestmark = pytest.mark.without_remedies


def level(page, name):
    """The level of the third octave about 63 mm of a curve of the spectrum."""
    curve = curves(page, "spectrum")[name]
    return dict(zip((round(x) for x in curve["x"]), curve["y"]))[63]


def at(page, share):
    """A place in the middle of a panel along the line."""
    band = page.page.locator("#along .nsewdrag").first
    band.evaluate("(plot) => plot.scrollIntoView({ block: 'center' })")
    box = band.bounding_box()
    return box["x"] + share * box["width"], box["y"] + box["height"] / 2


# Long: asks about a record for every part that is clicked.
def test_everything_follows_the_part_that_is_clicked(page):
    page.open_case(small("class-soft-slab"))
    asked = {name: page.asked(f"/api/ask/{name}") for name in ("measure", "noise")}
    record(page, two_rails(start=5000.0))
    # Kilometres where the line is long.
    positions = along(page, "rail left, 30–100 mm")["x"]
    assert 5.0 <= min(positions) and max(positions) < 5.1
    page.settle()
    assert set(curves(page)["limit 30–100 mm"]["y"]) == {7.0}
    # Outside the wave, and on the other rail, is next to nothing [µm].
    left, right = (curves(page)[f"rail {name}, 30–100 mm"] for name in ("left", "right"))
    outside = [level for x, level in zip(left["x"], left["y"]) if level is not None and not 5.013 < x < 5.047]
    assert len(outside) > 5 and max(outside) < 2 and max(level for level in right["y"] if level is not None) < 2
    assert curves(page)["limit 30–100 mm"]["yaxis"] == left["yaxis"]
    # The section is that of the wave, within the window of 1 m; the other rail has none.
    [row] = page.page.locator("#sections tbody tr").all_inner_texts()
    assert row.startswith("left") and [float(end.replace(",", "")) for end in page.text("#sections button").removesuffix(" m").split("–")] == pytest.approx([5015, 5045], abs=1)
    whole, before = level(page, "rail left, Now"), page.text("#noise-verdict")
    page.page.mouse.move(*at(page, 0.46))
    page.until(lambda: abs(page.page.evaluate("() => document.getElementById('along')._hoverdata?.[0].x ?? 0") - 5.0276) < 5e-3)
    page.page.mouse.click(*at(page, 0.46))
    page.until(lambda: page.text("#part").replace(",", "").startswith("502"))
    page.settle()
    # In the wave its level is that of 20/√2 µm, 23 dB re 1 µm; of the whole record it is half of it, 3 dB less, which stands behind.
    assert level(page, "rail left, Now") == pytest.approx(20 * math.log10(20 / math.sqrt(2)), abs=0.5)
    assert level(page, "rail left, Now") - whole == pytest.approx(3.0, abs=0.7) and level(page, "rail left, whole record") == pytest.approx(whole)
    assert page.text("#noise-verdict") != before and "502" in page.text("#measured-against").replace(",", "")
    assert asked["measure"][-1]["to"] == asked["noise"][-1]["to"] == pytest.approx(asked["measure"][-1]["from"] + 10)
    page.page.click("#whole-record")
    page.settle()
    assert level(page, "rail left, Now") == pytest.approx(whole) and page.text("#noise-verdict") == before
    # A drag zooms, and is no click.
    page.page.mouse.move(*at(page, 0.25))
    page.page.mouse.down()
    page.page.mouse.move(*at(page, 0.5), steps=5)
    page.page.mouse.move(*at(page, 0.75), steps=5)
    page.page.mouse.up()
    page.until(page.page.locator("#part-in-view").is_visible)
    assert page.text("#part") == "whole record"
    page.page.click("#part-in-view")
    page.settle()
    assert [float(end.replace(",", "")) for end in page.text("#part").removesuffix(" m").split("–")] == pytest.approx([5015, 5045], abs=1)
