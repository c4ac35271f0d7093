"""A measured rail along the line: courses with limits, sections, the spectrum at a place, columns, the sample."""

import csv
import io
import json
import math
import subprocess

import pytest
from axe_playwright_python.sync_playwright import Axe
from conftest import PROGRAM, ROOT

DATA = "() => (document.getElementById('along').data ?? []).map(({ name, x, y, yaxis }) => ({ name, x, y, yaxis: yaxis ?? 'y' }))"


def measured(page, text, name="trolley.csv"):
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": name, "mimeType": "text/csv", "buffer": text.encode()}])


def along(page):
    page.until(page.page.locator("#along-panel").is_visible)
    page.until(lambda: page.page.evaluate(DATA))
    return {curve["name"]: curve for curve in page.page.evaluate(DATA)}


def two_rails(metres=120, start=0.0):
    """A sine of 60 mm, 20 µm high, from 40 to 70 m of the left rail alone."""
    rows = ["position_m,left_um,right_um"]
    for k in range(1000 * metres):
        x = k / 1000
        wave = 20 * math.sin(2 * math.pi * x / 0.06) if 40 <= x < 70 else 0.0
        floor = 0.7 * math.sin(2 * math.pi * x / 0.0513) + 0.5 * math.sin(2 * math.pi * x / 0.0217)
        rows.append(f"{start + x:.3f},{wave + floor:.4f},{floor:.4f}")
    return "\n".join(rows) + "\n"


def test_moving_rms_limits_and_sections_along_the_line(page):
    measured(page, two_rails())
    curves = along(page)
    course, other, limit = curves["rail left, 30–100 mm"], curves["rail right, 30–100 mm"], curves["limit 30–100 mm"]
    # Grassie, Saxon & Smith (1999): 7 µm. The RMS of a sine is its amplitude over √2, to 3 % by the edges of the band.
    assert set(limit["y"]) == {7.0} and limit["yaxis"] == course["yaxis"]
    within = [y for x, y in zip(course["x"], course["y"]) if 45 < x < 65]
    assert within and all(value == pytest.approx(20 / math.sqrt(2), rel=0.03) for value in within)
    assert max(y for x, y in zip(course["x"], course["y"]) if x < 35 or x > 75) < 2
    # The section is that of the wave, within the window of 1 m; the other rail has none.
    rows = page.page.locator("#sections tbody tr").all_inner_texts()
    assert len(rows) == 1 and rows[0].startswith("left")
    start, end = (float(value) for value in page.text("#sections button").split("–"))
    assert start == pytest.approx(40, abs=1) and end == pytest.approx(70, abs=1)
    assert max(other["y"]) < 2 and other["yaxis"] == course["yaxis"]


SPECTRUM = "() => document.getElementById('spectrum').data.map(({ name, x, y }) => ({ name, x, y }))"


def level(page, name):
    """The level of the third octave about 63 mm of a curve of the spectrum."""
    [curve] = [curve for curve in page.page.evaluate(SPECTRUM) if curve["name"] == name]
    return dict(zip((round(x) for x in curve["x"]), curve["y"]))[63]


def test_everything_follows_the_part_that_is_clicked(page):
    page.open_case((ROOT / "cases/main-line.toml").read_text())
    measured(page, two_rails(start=5000.0))
    curves = along(page)
    # Kilometres where the line is long.
    assert 5.0 <= min(curves["rail left, 30–100 mm"]["x"]) and max(curves["rail left, 30–100 mm"]["x"]) < 5.2
    page.settle()
    whole = level(page, "rail left, Now")
    noise_of = lambda: page.text("#noise-verdict")
    before = noise_of()
    asked = []
    page.page.on("request", lambda request: request.method == "POST" and asked.append((request.url.split("/api/ask/")[-1], json.loads(request.post_data))) if "/api/" in request.url else None)

    def go(share):
        page.page.locator("#along .nsewdrag").first.evaluate("(plot) => plot.scrollIntoView({ block: 'center' })")
        box = page.page.locator("#along .nsewdrag").first.bounding_box()
        page.page.mouse.move(box["x"] + share * box["width"], box["y"] + box["height"] / 2)
        pointed = lambda: page.page.evaluate("() => document.getElementById('along')._hoverdata?.[0].x ?? 0")
        page.until(lambda: abs(pointed() - 5 - 0.12 * share) < 5e-3)
        page.page.mouse.click(box["x"] + share * box["width"], box["y"] + box["height"] / 2)
        wanted = f"{5000 + 120 * share:.0f}"[:3]
        page.until(lambda: page.text("#part").replace(",", "").startswith(wanted))
        page.settle()
        return level(page, "rail left, Now")

    # In the wave its level is that of 20/√2 µm, 23 dB re 1 µm; the third octave about 63 mm loses none of it.
    there = go(0.46)
    assert there == pytest.approx(20 * math.log10(20 / math.sqrt(2)), abs=0.5)
    # Of the whole record it is what 30 m of 120 m leave, 6 dB less; that curve stands behind.
    assert there - whole == pytest.approx(6.0, abs=0.7) and level(page, "rail left, whole record") == pytest.approx(whole)
    assert noise_of() != before
    questions = {name: question for name, question in asked}
    assert questions["measure"]["to"] == questions["noise"]["to"] == pytest.approx(questions["measure"]["from"] + 10)
    assert go(0.15) < 3
    page.page.click("#whole-record")
    page.settle()
    assert level(page, "rail left, Now") == pytest.approx(whole) and noise_of() == before


def test_a_drag_zooms_and_the_part_in_view_is_taken(page):
    measured(page, two_rails())
    along(page)
    page.settle()
    band = page.page.locator("#along .nsewdrag").first
    band.evaluate("(plot) => plot.scrollIntoView({ block: 'center' })")
    box = band.bounding_box()
    place = lambda share: (box["x"] + share * box["width"], box["y"] + box["height"] / 2)
    page.page.mouse.move(*place(0.25))
    page.page.mouse.down()
    page.page.mouse.move(*place(0.5), steps=5)
    page.page.mouse.move(*place(0.75), steps=5)
    page.page.mouse.up()
    page.until(page.page.locator("#part-in-view").is_visible)
    # A drag is no click: nothing is taken by itself.
    assert page.text("#part") == "whole record"
    page.page.click("#part-in-view")
    page.settle()
    # To a pixel of some hundred for 120 m.
    assert [float(end) for end in page.text("#part").removesuffix(" m").split("–")] == pytest.approx([30, 90], abs=1)

    def whole_again():
        # Two clicks that a busy machine takes 0.3 s apart are not a double one: it is made again.
        page.page.mouse.dblclick(*place(0.5))
        page.pause()
        return not page.page.locator("#part-in-view").is_visible()

    page.until(whole_again)


def test_sections_are_judged_the_worst_first_and_lead_to_their_part(open_page, tmp_path):
    page = open_page(locale="de-DE")
    text = two_rails(240)
    measured(page, text)
    along(page)
    rows = lambda: page.page.locator("#section-verdicts tbody tr").all_inner_texts()
    page.settle()
    (tmp_path / "trolley.csv").write_text(text)
    told = subprocess.run([PROGRAM, "roughness", "trolley.csv", "--json"], capture_output=True, check=True, text=True, cwd=tmp_path).stdout
    sections = json.loads(told)["sections"]
    assert [(section["rail"], section["from_m"]) for section in sections[:1]] == [("left", 0.0)]
    assert len(rows()) == len(sections) == 4
    assert "über dem Grenzwert der Pegel" in rows()[0] and "m zu schleifen" in rows()[0]
    page.page.locator("#section-verdicts tbody tr").first.click()
    page.until(lambda: page.text("#part").startswith("0–100"))
    page.settle()
    # A part is one of both rails.
    assert page.page.locator("#section-verdicts tr[aria-current]").all_inner_texts() == [row for row in rows() if "0–100" in row]
    assert "0–100 m" in page.text("#measured-against")
    for scheme in ["light", "dark"]:
        page.page.emulate_media(color_scheme=scheme)
        page.settle()
        assert Axe().run(page.page, context="#view-measure", options={"resultTypes": ["violations"]}).response["violations"] == [], scheme
    page.keep("sections-de", whole=True)
    page.close()


def test_what_lies_along_the_line_is_read_by_the_program(page):
    measured(page, two_rails(240))
    along(page)
    table = lambda text, name="line.csv": page.give("#line-table", files=[{"name": name, "mimeType": "text/csv", "buffer": text.encode("cp1252")}])
    table("von_m;bis_m;Art;Name\n20;90;Bogen;R 300\n50;50;Schweißung;S 7\n")
    page.until(lambda: "Bogen" in along(page))
    found = along(page)
    assert found["Bogen"]["x"][:2] == [20, 90] and found["Schweißung"]["x"][:2] == [50, 50]
    assert "Bogen R 300" in page.page.locator("#section-verdicts tbody tr").first.inner_text()
    # Another that is none says why, and leaves the one before.
    refused = len(page.complaints)
    table("a,b\n1,2\n", name="other.csv")
    page.until(lambda: "a column `kind`" in page.text("#trouble"))
    page.settle()
    assert "Bogen" in along(page) and page.text("#line-table-drop") == "✕ line.csv"
    del page.complaints[refused:]
    page.page.click("#line-table-drop")
    page.until(lambda: "Bogen" not in along(page))
    page.settle()


def test_columns_of_a_table_of_many_are_chosen(open_page):
    page = open_page()
    rows = list(csv.reader(io.StringIO(two_rails(80))))[1:]
    text = "km;speed;inner;outer;gauge\n" + "".join(
        f"{float(x) / 1000:.6f};80;{float(left) / 1000:.7f};{float(right) / 1000:.7f};1435\n".replace(".", ",") for x, left, right in rows
    )
    measured(page, text)
    page.until(page.page.locator("#trouble .said").is_visible)
    # Heights without a unit are read in µm, and no rail is so smooth; the columns open by themselves.
    assert "no rail is so smooth" in page.text("#trouble")
    page.until(page.page.locator("#columns-use").is_visible)
    selects = lambda: page.page.locator("#columns-table select").evaluate_all("(all) => all.filter(({ hidden }) => !hidden).map(({ value }) => value)")
    assert selects() == ["position", "km", "none", "height", "um", "height", "um", "none"]
    for k in (2, 3):
        page.page.locator("#columns-table tr").nth(k).locator("select").last.select_option("mm")
    page.page.click("#columns-use")
    curves = along(page)
    assert max(curves["rail inner, 30–100 mm"]["y"]) == pytest.approx(20 / math.sqrt(2), rel=0.05)
    assert "rail outer, 30–100 mm" in curves
    # Another record takes its place; undo reads the first by its columns again.
    refused = len(page.complaints)
    measured(page, two_rails(80))
    page.until(lambda: "rail left, 30–100 mm" in along(page))
    page.page.locator("#notice button").first.click()
    page.until(lambda: "rail inner, 30–100 mm" in along(page))
    assert max(along(page)["rail inner, 30–100 mm"]["y"]) == pytest.approx(20 / math.sqrt(2), rel=0.05)
    assert selects() == ["position", "km", "none", "height", "mm", "height", "mm", "none"]
    assert len(page.complaints) == refused
    # Nothing chosen is told, and asks nothing.
    page.page.evaluate("() => (document.getElementById('columns').open = true)")
    for k in (2, 3):
        page.page.locator("#columns-table tr").nth(k).locator("select").first.select_option("none")
    page.page.click("#columns-use")
    assert "at least one column" in page.text("#columns > .fault").lower()
    page.close(complaints=len(page.complaints))


@pytest.mark.parametrize("locale", ["en-GB", pytest.param("de-DE", marks=pytest.mark.thorough)])
def test_the_sample_says_what_it_is(open_page, locale):
    page = open_page(locale=locale, viewport={"width": 360, "height": 780})
    page.page.click("#tab-measure")
    page.page.click("#sample")
    along(page)
    told = page.text("#sample-source")
    assert ("not measured" if locale == "en-GB" else "nicht gemessen") in told and "--synthesise" in told
    page.fits()
    # The same file, the same words as from the program.
    made = subprocess.run([PROGRAM, "roughness", "--synthesise"], capture_output=True, check=True, text=True).stdout
    assert f"{len(made) / 1e6:.2f}".replace(".", "," if locale == "de-DE" else ".") in page.text("#record-state")
    page.settle()
    page.keep(f"along-{locale}", whole=True)
    page.close()


def test_one_column_of_heights_has_a_step_of_its_own(open_page):
    page = open_page(locale="de-DE")
    heights = [20e-3 * math.sin(2 * math.pi * k / 100) for k in range(40_000)]
    measured(page, "".join(f"{height:.7f}\n".replace(".", ",") for height in heights), name="alone.txt")
    page.until(page.page.locator("#columns-use").is_visible)
    assert "eine Spalte" in page.text("#trouble") and "Die Seite liest" in page.text("#trouble")
    page.page.locator("#columns-table select").last.select_option("mm")
    step = page.page.locator("#columns-spacing")
    for text, refused in [("1.000", "Was ist gemeint?"), ("0", "erlaubt ist")]:
        step.fill(text)
        step.press("Tab")
        assert refused in page.text("#columns-spacing-fault")
        page.page.click("#columns-use")
        page.pause()
        assert not page.page.locator("#report").is_visible()
    step.fill("0,5")
    step.press("Tab")
    page.page.click("#columns-use")
    # 100 samples of half a millimetre are a wave of 50 mm; half of 40 m of rail is none.
    curves = along(page)
    assert max(curves["30–100 mm"]["y"]) == pytest.approx(20 / math.sqrt(2), rel=0.05)
    assert max(curves["30–100 mm"]["x"]) == pytest.approx(20, abs=1)
    page.close(complaints=len(page.complaints))


def test_columns_in_feet_and_inches_stay_in_them(page):
    rows = "".join(f"{k * 1e-3 / 0.3048:.7f},{20e-6 / 0.0254 * math.sin(2 * math.pi * k / 50):.9f}\n" for k in range(40_000))
    measured(page, "distance [ft],height [in]\n" + rows)
    read = max(along(page)["30–100 mm"]["y"])
    assert read == pytest.approx(20 / math.sqrt(2), rel=0.05)
    page.page.evaluate("() => (document.getElementById('columns').open = true)")
    units = page.page.locator("#columns-table tr").evaluate_all("(rows) => rows.map((row) => [...row.querySelectorAll('select')].at(-1).value)")
    assert units == ["ft", "in"]
    asked = []
    page.page.on("request", lambda request: request.url.endswith("/api/ask/measure") and asked.append(request))
    page.page.click("#columns-use")
    page.until(lambda: asked)
    page.settle()
    assert max(along(page)["30–100 mm"]["y"]) == pytest.approx(read)


def test_a_record_stays_where_the_next_one_does_not_arrive(page):
    answers = []

    def roughness(route):
        answer = answers.pop(0) if answers else None
        if answer == "refuse":
            route.fulfill(status=413, json={"message": "the file is larger than 2048 MiB"})
        elif answer != "wait":
            route.fallback()

    page.page.route("**/api/upload", roughness)
    state = lambda: page.text("#record-state")
    measured(page, two_rails(40), name="first.csv")
    page.until(lambda: page.page.locator("#report").is_visible() and state().startswith("first.csv"))
    page.settle()
    levels = page.text("#along-panel")
    answers.append("refuse")
    measured(page, two_rails(20), name="huge.csv")
    page.until(lambda: "larger than" in page.text("#trouble"))
    page.settle()
    assert state().startswith("first.csv, ") and page.page.locator("#report").is_visible() and page.text("#along-panel") == levels
    # A file that breaks off on its way, by hand.
    answers.append("wait")
    measured(page, two_rails(20), name="slow.csv")
    page.until(lambda: state().startswith("slow.csv"))
    # What went wrong with another file is over.
    assert not page.page.locator("#trouble").is_visible()
    page.page.locator("#drop .buttons").get_by_text("Cancel").click()
    page.until(lambda: state().startswith("first.csv, ") and page.page.locator("#report").is_visible())
    # One that is overtaken by another leaves it alone.
    answers.append("wait")
    measured(page, two_rails(20), name="slow.csv")
    page.until(lambda: state().startswith("slow.csv"))
    measured(page, two_rails(30), name="last.csv")
    page.until(lambda: state().startswith("last.csv, ") and page.page.locator("#report").is_visible())
    page.settle()
    assert state().startswith("last.csv, ")
    # Undo leads to the record that was there before.
    page.page.locator("#notice button").first.click()
    page.until(lambda: state().startswith("first.csv, ") and page.page.locator("#report").is_visible())
    page.complaints.clear()


def test_sizes_of_files_are_readable(page):
    for size, words in [(0, "0 B"), (28, "28 B"), (2850, "2.85 kB")]:
        measured(page, ("position_m,left_um\n" + " " * 3000)[:size], name="small.csv")
        page.until(lambda: page.text("#record-state") == f"small.csv, {words}")
    page.complaints.clear()


@pytest.mark.parametrize("encoding", ["utf-16", "cp1252", "utf-8-sig"])
def test_columns_of_other_encodings_are_offered(page, encoding):
    rows = "".join(f"{k * 1e-3:.3f};{20e-3 * math.sin(2 * math.pi * k / 50):.5f};{20 * math.sin(2 * math.pi * k / 50):.3f}\n".replace(".", ",") for k in range(4000))
    text = "Weg [m];Höhe links [mm];Höhe rechts [µm]\n" + rows
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "umlaut.csv", "mimeType": "text/csv", "buffer": text.encode(encoding)}])
    along(page)
    page.page.evaluate("() => (document.getElementById('columns').open = true)")
    assert page.page.locator("#columns-table th").all_inner_texts() == ["Weg [m]", "Höhe links [mm]", "Höhe rechts [µm]"]
    units = page.page.locator("#columns-table tr").evaluate_all("(rows) => rows.map((row) => [...row.querySelectorAll('select')].at(-1).value)")
    assert units == ["m", "mm", "um"]
    page.page.click("#columns-use")
    page.settle()
    assert not page.page.locator("#trouble").is_visible()
    heights = [max(curve["y"]) for name, curve in along(page).items() if name.startswith("rail") and name.endswith("30–100 mm")]
    assert len(heights) == 2 and max(heights) == pytest.approx(20 / math.sqrt(2), rel=0.05)
