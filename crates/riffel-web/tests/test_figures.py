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
    page.settle()
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
    page.settle()
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
    assert page.page.locator(".paper-map").count() == 0
    assert page.page.evaluate("() => document.documentElement.dataset.theme") == "dark"
    assert page.page.locator("#growth .main-svg").first.bounding_box()["width"] == before["width"]
    page.page.pdf(path=tmp_path / "page.pdf", prefer_css_page_size=True, print_background=True)
    pdf = (tmp_path / "page.pdf").read_bytes()
    # A4, and four of them at most: a page cut into slivers would take more.
    assert 1 <= pdf.count(b"/Type /Page\n") <= 4
    page.close()


def test_curve_and_paper_hand_out_their_figures(open_page):
    page = open_page(color_scheme="dark")
    page.page.click("#tab-curve")
    page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4)
    page.until(lambda: page.page.locator("#curvatures .main-svg").count() > 0)
    svg = ElementTree.fromstring(given(page, "bogie-above", "svg"))
    # White as wide as the drawing, wheels as dark as they wear, no styles.
    assert svg.find(f"{SVG}rect").get("fill") == "#fff"
    left, top, width, height = (float(value) for value in svg.get("viewBox").split())
    assert float(svg.get("width")) / float(svg.get("height")) == pytest.approx(width / height)
    wheels = [rect for rect in svg.iter(f"{SVG}rect") if rect.get("rx")]
    opacities = [float(rect.get("fill-opacity")) for rect in wheels]
    assert len(wheels) == 4 and max(opacities) == pytest.approx(1) and min(opacities) < 0.9
    assert not [node for node in svg.iter() if node.get("style")] and "#e8ebee" not in ElementTree.tostring(svg, encoding="unicode")
    assert corner(given(page, "bogie-above", "png"))[2] == [255, 255, 255]
    rows = list(csv.reader(io.StringIO(given(page, "bogie-above", "csv").decode())))
    assert len(rows) == 5 and rows[0][1] == "shift mm" and rows[1][0] == "1 left"
    for place, least in [("outlines", "Profiles"), ("curvatures", "Curvature")]:
        header = page.page.locator("#view-curve header").filter(has_text=least)
        header.locator(".take summary").click()
        with page.page.expect_download() as download:
            header.locator("[data-figure=csv]").click()
        assert download.value.suggested_filename == {"outlines": "profiles.csv", "curvatures": "curvatures.csv"}[place]
        points = list(csv.reader(open(download.value.path(), encoding="utf-8", newline="")))
        assert {row[0] for row in points[1:]} == {"wheel", "rail"} and len(points) > 500
    page.page.click("#tab-paper")
    figure = page.page.locator("#figure-4")
    figure.scroll_into_view_if_needed()
    page.until(lambda: figure.locator(".take").count() > 0)
    asked = page.page.evaluate("async () => (await fetch('/api/figure', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ number: 4, contact: 'quasi-static' }) })).json()")
    panel = asked["maps"][0]
    caption = figure.locator("figcaption").first
    for kind in ["csv", "svg"]:
        caption.locator(".take summary").click()
        with page.page.expect_download() as download:
            caption.locator(f"[data-figure={kind}]").click()
        assert download.value.suggested_filename.startswith("figure-4-1") and download.value.suggested_filename.endswith(kind)
        text = open(download.value.path(), encoding="utf-8", newline="").read()
        if kind == "csv":
            rows = list(csv.reader(io.StringIO(text)))
            # The values of the paper, with its sign.
            assert rows[0] == ["wavelength_m", "speed_m_per_s", panel["value_label"]]
            assert [float(row[2]) for row in rows[1:]] == panel["values"]
        else:
            assert ElementTree.fromstring(text).findall(f".//{SVG}image")
    page.close()


@pytest.mark.parametrize("view", ["curve", "paper"])
def test_curve_and_paper_on_paper_say_what_was_asked(page, view, tmp_path):
    page.page.click(f"#tab-{view}")
    if view == "curve":
        page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4)
        page.until(lambda: page.page.locator("#curvatures .main-svg").count() > 0)
    else:
        page.page.locator("#figure-4").scroll_into_view_if_needed()
        page.until(lambda: page.page.locator("#figure-4 .take").count() > 0)
    page.settle()
    page.page.evaluate("() => dispatchEvent(new Event('beforeprint'))")
    assert page.page.locator("#curve-radius" if view == "curve" else "#paper-contact").is_visible()
    for selector in [".take", ".strip .plain", ".waiting"]:
        assert page.page.locator(f"#view-{view} {selector}:visible").count() == 0, selector
    widths = page.page.locator(f"#view-{view} svg:visible").evaluate_all("(all) => all.map((one) => one.getBoundingClientRect().width)")
    assert widths and max(widths) <= 186 / 25.4 * 96 + 1
    # Maps keep their height beside curves.
    if view == "paper":
        maps = page.page.locator("#view-paper .map").evaluate_all("(all) => all.map((one) => one.getBoundingClientRect().height)")
        assert maps and min(maps) > 250
    for plot in page.page.locator(f"#view-{view} .js-plotly-plot:visible").all():
        title, legend = plot.locator(".xtitle").bounding_box(), plot.locator(".legend")
        if legend.count():
            box = legend.bounding_box()
            assert box["y"] >= title["y"] + title["height"] - 1 or box["y"] + box["height"] <= title["y"], "a legend on the title of an axis"
    page.page.evaluate("() => dispatchEvent(new Event('afterprint'))")
    page.settle()
    page.page.pdf(path=tmp_path / "page.pdf", prefer_css_page_size=True, print_background=True)
    pdf = (tmp_path / "page.pdf").read_bytes()
    assert 1 <= pdf.count(b"/Type /Page\n") <= (2 if view == "curve" else 4)
