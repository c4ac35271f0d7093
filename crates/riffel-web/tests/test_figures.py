"""Figures to take away as SVG, PNG and CSV, and the page on paper."""

import csv
import io
import struct
import xml.etree.ElementTree as ElementTree
import zlib

import pytest

SVG = "{http://www.w3.org/2000/svg}"


def given(page, place, kind):
    panel = page.page.locator(f"#{place}").locator("xpath=ancestor::article")
    panel.locator(".take summary").click()
    with page.page.expect_download() as download:
        panel.locator(f"[data-figure={kind}]").click()
    assert download.value.suggested_filename.endswith(f".{kind}")
    with open(download.value.path(), "rb") as file:
        return file.read()


def corner(png):
    """Size and first pixel of a PNG of eight bits, whose first line has no pixel above it."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    width, height, depth, colour = struct.unpack(">IIBB", png[16:26])
    assert depth == 8
    data, at = b"", 8
    while at < len(png):
        (length,) = struct.unpack(">I", png[at : at + 4])
        if png[at + 4 : at + 8] == b"IDAT":
            data += png[at + 8 : at + 8 + length]
        at += 12 + length
    return width, height, list(zlib.decompress(data)[1 : 1 + 3])


@pytest.mark.parametrize("place", ["map", "phasors", "growth"])
def test_a_figure_comes_as_svg_png_and_csv_on_white(open_page, place):
    page = open_page(color_scheme="dark")
    page.page.wait_for_timeout(300)
    svg = ElementTree.fromstring(given(page, place, "svg"))
    assert svg.tag == f"{SVG}svg"
    assert svg.find(f"{SVG}rect").get("fill") == "#fff"
    assert svg.findall(f".//{SVG}text"), "words stay words"
    # Nothing of it is pale: no light ink of the dark page.
    assert "#e8ebee" not in ElementTree.tostring(svg, encoding="unicode")
    assert not [node for node in svg.iter() if node.get("style")], "the policy forbids styles in a picture"
    width, height, pixel = corner(given(page, place, "png"))
    assert width > 300 and height > 200 and pixel == [255, 255, 255]
    rows = list(csv.reader(io.StringIO(given(page, place, "csv").decode())))
    if place == "map":
        assert rows[0] == ["wavelength_m", "speed_m_per_s", "growth_rate_per_passage"] and len(rows) == 1 + 241 * 221
        strongest = max(rows[1:], key=lambda row: float(row[2]))
        highest = page.page.evaluate("() => window.riffel.state.head.highest")
        # The highest of the grid against the ridge between its points, where growth is flat.
        assert float(strongest[2]) == pytest.approx(highest["growth_rate_per_passage"], rel=1e-3)
        assert [float(value) for value in rows[1][:2]] == [0.02, 5.0]
    elif place == "growth":
        assert len(rows) > 241 and rows[0][:2] == ["curve", "wavelength λ [mm]"]
        assert float(rows[1][1]) == 20
    else:
        assert len(rows) == 6 and rows[1][1] == "31.5 µm"
    # The page is dark as before.
    assert page.page.evaluate("() => document.documentElement.dataset.theme") == "dark"
    page.close()


def test_on_paper_there_is_the_view_alone_on_white(open_page, tmp_path):
    page = open_page(color_scheme="dark")
    page.page.wait_for_timeout(300)
    before = page.page.locator("#growth .main-svg").first.bounding_box()
    page.page.evaluate("() => dispatchEvent(new Event('beforeprint'))")
    for selector in [".tabs", ".tools", ".case", ".take", "#hold", "#to-highest"]:
        assert page.page.locator(selector).first.is_hidden(), selector
    assert page.page.evaluate("() => getComputedStyle(document.body).backgroundColor") == "rgb(255, 255, 255)"
    assert page.page.locator("#map .paper-map svg image").count() == 1
    # No figure is wider than the sheet of 210 mm without its margins.
    widths = page.page.locator(".panel:visible svg").evaluate_all("(all) => all.map((one) => one.getBoundingClientRect().width)")
    assert widths and max(widths) <= 186 / 25.4 * 96 + 1
    ink = page.page.locator("#growth .xtick text").first.evaluate("(word) => getComputedStyle(word).fill")
    assert ink == "rgb(83, 92, 102)"
    page.page.evaluate("() => dispatchEvent(new Event('afterprint'))")
    page.settle()
    page.page.wait_for_timeout(300)
    assert page.page.locator(".paper-map").count() == 0
    assert page.page.evaluate("() => document.documentElement.dataset.theme") == "dark"
    assert page.page.locator("#growth .main-svg").first.bounding_box()["width"] == before["width"]
    page.page.pdf(path=tmp_path / "page.pdf", prefer_css_page_size=True, print_background=True)
    pdf = (tmp_path / "page.pdf").read_bytes()
    # A4, and three of them at most: a page cut into slivers would take more.
    assert 1 <= pdf.count(b"/Type /Page\n") <= 3
    page.close()
