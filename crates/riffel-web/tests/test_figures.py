"""Figures to take away as SVG, PNG and CSV, and the page on paper."""

import csv
import io
import json
import struct
import xml.etree.ElementTree as ElementTree
import zlib

import pytest
from conftest import ROOT
from test_compare import CURVES, keep_with, settled

pytestmark = pytest.mark.without_remedies

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


def test_figures_come_as_svg_png_and_csv_on_white(page):
    page.page.emulate_media(color_scheme="dark")
    page.settle()
    for place in ["map", "phasors", "growth"]:
        svg = ElementTree.fromstring(given(page, place, "svg"))
        assert svg.tag == f"{SVG}svg" and svg.find(f"{SVG}rect").get("fill") == "#fff"
        assert svg.findall(f".//{SVG}text"), "words stay words"
        # Nothing of it is pale: no light ink of the dark page.
        assert "#e8ebee" not in ElementTree.tostring(svg, encoding="unicode")
        assert not [node for node in svg.iter() if node.get("style")], "the policy forbids styles in a picture"
        rows = list(csv.reader(io.StringIO(given(page, place, "csv").decode())))
        assert len(rows) == {"map": 1 + 241 * 221, "phasors": 6}.get(place, len(rows)) > 5
        if place == "map":
            # The highest of the map lies between its points.
            wavelength, speed, growth = (float(value) for value in max(rows[1:], key=lambda row: float(row[2])))
            told = page.page.evaluate("() => window.riffel.state.head.highest")
            assert growth == pytest.approx(told["growth_rate_per_passage"], rel=1e-4)
            assert [wavelength, speed] == pytest.approx([told["wavelength_m"], told["speed_m_per_s"]], rel=0.03)
        elif place == "phasors":
            assert "31.5 µm" in " ".join(" ".join(row) for row in rows)
        width, height, pixel = corner(given(page, place, "png"))
        assert width > 300 and height > 200 and pixel == [255, 255, 255], place
    # The page is dark as before.
    assert page.page.evaluate("() => document.documentElement.dataset.theme") == "dark"


def test_on_paper_there_is_the_view_alone_on_white(page, tmp_path):
    page.page.emulate_media(color_scheme="dark")
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


def test_the_curve_is_handed_out_and_on_paper_says_what_was_asked(page, tmp_path):
    page.page.route("**/api/curve/wheels", lambda route: route.fulfill(status=422, json={"message": "not asked"}))
    page.page.emulate_media(color_scheme="dark")
    page.page.click("#tab-curve")
    page.until(lambda: page.page.locator("#wheels tbody tr").count() == 4 and page.page.locator("#curvatures .main-svg").count() > 0)
    page.settle()
    svg = ElementTree.fromstring(given(page, "bogie-above", "svg"))
    # White as wide as the drawing, wheels as dark as they wear, no styles.
    left, top, width, height = (float(value) for value in svg.get("viewBox").split())
    assert svg.find(f"{SVG}rect").get("fill") == "#fff" and float(svg.get("width")) / float(svg.get("height")) == pytest.approx(width / height)
    opacities = [float(rect.get("fill-opacity")) for rect in svg.iter(f"{SVG}rect") if rect.get("rx")]
    assert len(opacities) == 4 and max(opacities) == pytest.approx(1) and min(opacities) < 0.9
    assert not [node for node in svg.iter() if node.get("style")]
    rows = list(csv.reader(io.StringIO(given(page, "bogie-above", "csv").decode())))
    assert len(rows) == 5 and rows[0][1] == "shift mm" and rows[1][0] == "1 left"
    assert corner(given(page, "bogie-above", "png"))[2] == [255, 255, 255]
    for heading, name in [("Profiles", "profiles.csv"), ("Curvature", "curvatures.csv")]:
        header = page.page.locator("#view-curve header").filter(has_text=heading)
        header.locator(".take summary").click()
        taken, text = page.saved(lambda: header.locator("[data-figure=csv]").click())
        rows = list(csv.reader(io.StringIO(text.decode())))
        assert taken == name and {row[0] for row in rows[1:]} == {"wheel", "rail"} and len(rows) > 500
    on_paper(page, "curve", tmp_path, 2)
    page.refused(422)


def test_the_paper_is_drawn_handed_out_and_printed(page, tmp_path):
    figures = page.answers("/api/figure")
    page.page.click("#tab-paper")
    for number in range(2, 9):
        figure = page.page.locator(f"#figure-{number}")
        figure.scroll_into_view_if_needed()
        page.until(lambda: f"Figure {number}." in figure.locator("h2").inner_text() and figure.locator("canvas, .main-svg").count() > 0)
    page.settle()
    # No curve reaches into the panel beside it.
    over = "() => [...document.querySelectorAll('#view-paper figure')].filter((one) => one.scrollWidth > one.clientWidth + 1).length"
    assert page.page.evaluate(over) == 0
    caption = page.page.locator("#figure-4 figcaption").first
    for kind in ["csv", "svg"]:
        caption.locator(".take summary").click()
        name, text = page.saved(lambda: caption.locator(f"[data-figure={kind}]").click())
        assert name.startswith("figure-4-1") and name.endswith(kind)
        if kind == "csv":
            rows = list(csv.reader(io.StringIO(text.decode())))
            # The values of the paper, with its sign.
            [panel] = [figure["maps"][0] for figure in figures if figure["title"].startswith("Figure 4.")]
            assert rows[0] == ["wavelength_m", "speed_m_per_s", panel["value_label"]]
            assert [float(row[2]) for row in rows[1:]] == pytest.approx(panel["values"]) and min(panel["values"]) < 0
        else:
            assert ElementTree.fromstring(text).findall(f".//{SVG}image")
    # The field is what the project keeps.
    kept = json.loads((ROOT / "validation/field/prediction-wear-of-service.json").read_text())
    outcomes = [(site["title"], outcome) for site in kept["cases"] for outcome in site["outcomes"]]
    cells = [row.locator("th, td").all_inner_texts() for row in page.page.locator("#field tbody tr").all()]
    assert [row[0] for row in cells] == [title for title, _ in outcomes]
    assert all(row[4] == ("inside" if outcome["inside"] else "outside") for row, (_, outcome) in zip(cells, outcomes))
    for row, (_, outcome) in zip(cells, outcomes):
        assert row[1].startswith(outcome["what"]) and (not outcome["predicted"] or row[2].startswith(f"{outcome['predicted']['median']:.3g} (")), row
    summary = page.text("#field-summary")
    assert f"riffel {kept['riffel_version']}" in summary and f"{sum(outcome['inside'] for _, outcome in outcomes)} of {len(outcomes)}" in summary
    on_paper(page, "paper", tmp_path, 4)


def on_paper(page, view, folder, most):
    """A view that is printed: what was asked stays, what only a screen needs does not, and all fits its sheets."""
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
    page.page.pdf(path=folder / "page.pdf", prefer_css_page_size=True, print_background=True)
    assert 1 <= (folder / "page.pdf").read_bytes().count(b"/Type /Page\n") <= most


def test_a_report_of_the_variants(page, tmp_path, browser):
    page.page.click("#tab-compare")
    keep_with(page, contact__friction="0.2")
    name = page.page.locator(".variants input")
    name.fill("<b>dry</b>")
    name.press("Tab")
    settled(page, 3)
    page.until(lambda: len(page.page.evaluate(CURVES, "compare-curves")) == 2)
    with page.page.expect_download() as download:
        page.page.click("#report-variants")
    file = tmp_path / "variants.html"
    download.value.save_as(file)
    context = browser.new_context(viewport={"width": 1100, "height": 900})
    report = context.new_page()
    asked = []
    report.on("request", lambda request: asked.append(request.url))
    report.goto(file.as_uri())
    assert [url for url in asked if not url.startswith(("file:", "data:"))] == []
    assert report.locator("th", has_text="<b>dry</b>").count() == 1
    pictures = report.locator("img").evaluate_all("(all) => all.map(({ naturalWidth }) => naturalWidth)")
    assert len(pictures) == 4 and min(pictures) > 100
    assert report.locator("a").get_attribute("href") == page.page.url
    context.close()
