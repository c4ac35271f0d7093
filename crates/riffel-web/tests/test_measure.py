"""A measured rail: along the line, its columns, earlier records, its noise."""

import math

import pytest
from conftest import small

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]

DATA = "(place) => (document.getElementById(place).data ?? []).map(({ name, x, y, yaxis }) => ({ name, x, y, yaxis: yaxis ?? 'y' }))"


def csv(name, text):
    return {"name": name, "mimeType": "text/csv", "buffer": text.encode()}


def record(page, text, name="trolley.csv"):
    page.page.click("#tab-measure")
    page.give("#record", files=[csv(name, text)])
    page.until(page.page.locator("#along-panel").is_visible)


def curves(page, place="along"):
    return {curve["name"]: curve for curve in page.page.evaluate(DATA, place)}


def along(page, name):
    page.until(lambda: name in curves(page))
    return curves(page)[name]


def two_rails(metres=60, start=0.0):
    """A sine of 60 mm, 20 µm high, in the middle half of the left rail alone, every 4 mm."""
    rows = ["position_m,left_um,right_um"]
    for k in range(250 * metres):
        x = k / 250
        wave = 20 * math.sin(2 * math.pi * x / 0.06) if 0.25 <= x / metres < 0.75 else 0.0
        floor = 0.7 * math.sin(2 * math.pi * x / 0.0513) + 0.5 * math.sin(2 * math.pi * x / 0.0217)
        rows.append(f"{start + x:.3f},{wave + floor:.4f},{floor:.4f}")
    return "\n".join(rows) + "\n"


def test_sections_lead_to_their_part_and_what_lies_along_the_line_is_read(page):
    record(page, two_rails(210))
    rows = page.page.locator("#section-verdicts tbody tr")
    page.settle()
    # The worst first.
    assert rows.count() == 4 and "over the limit" in rows.first.inner_text() and "left" in rows.first.inner_text()
    page.give("#line-table", files=[{"name": "line.csv", "mimeType": "text/csv", "buffer": "von_m;bis_m;Art;Name\n20;90;Bogen;R 300\n50;50;Schweißung;S 7\n".encode("cp1252")}])
    assert along(page, "Bogen")["x"][:2] == [20, 90] and along(page, "Schweißung")["x"][:2] == [50, 50]
    page.settle()
    assert any("Bogen R 300" in text for text in rows.all_inner_texts())
    # Another that is none says why, and leaves the one before.
    page.give("#line-table", files=[csv("other.csv", "a,b\n1,2\n")])
    page.until(lambda: "a column `kind`" in page.text("#trouble"))
    page.settle()
    assert "Bogen" in curves(page) and page.text("#line-table-drop") == "✕ line.csv"
    page.refused(422)
    part = rows.first.locator("button").inner_text()
    rows.first.click()
    page.until(lambda: page.text("#part").split(" ")[0] == part.split(" ")[0])
    page.settle()
    # A part is one of both rails.
    assert page.page.locator("#section-verdicts tr[aria-current]").all_inner_texts() == [row for row in rows.all_inner_texts() if part in row]
    page.page.click("#line-table-drop")
    page.until(lambda: "Bogen" not in curves(page))
    page.settle()


def test_columns_of_a_table_of_many_are_chosen(page):
    rows = [row.split(",") for row in two_rails(10).splitlines()[1:]]
    text = "km;speed;inner;outer;gauge\n" + "".join(f"{float(x) / 1000:.6f};80;{float(left) / 1000:.7f};{float(right) / 1000:.7f};1435\n".replace(".", ",") for x, left, right in rows)
    page.page.click("#tab-measure")
    page.give("#record", files=[csv("table.csv", text)])
    # Heights without a unit are read in µm, and no rail is so smooth; the columns open by themselves.
    page.until(lambda: "no rail is so smooth" in page.text("#trouble") and page.page.locator("#columns-use").is_visible())
    selects = lambda: page.page.locator("#columns-table select").evaluate_all("(all) => all.filter(({ hidden }) => !hidden).map(({ value }) => value)")
    assert selects() == ["position", "km", "none", "height", "um", "height", "um", "none"]
    for k in (2, 3):
        page.page.locator("#columns-table tr").nth(k).locator("select").last.select_option("mm")
    page.page.click("#columns-use")
    assert max(along(page, "rail inner, 30–100 mm")["y"]) == pytest.approx(20 / math.sqrt(2), rel=0.05)
    # Another record takes its place; undo reads the first by its columns again.
    page.refused(422)
    record(page, two_rails(10))
    along(page, "rail left, 30–100 mm")
    page.page.locator("#notice button").first.click()
    assert max(along(page, "rail inner, 30–100 mm")["y"]) == pytest.approx(20 / math.sqrt(2), rel=0.05)
    page.settle()
    assert selects() == ["position", "km", "none", "height", "mm", "height", "mm", "none"]


def test_a_record_stays_where_the_next_one_does_not_arrive(page):
    answers = []

    def upload(route):
        answer = answers.pop(0) if answers else None
        if answer == "refuse":
            route.fulfill(status=413, json={"message": "the file is larger than 2048 MiB"})
        elif answer != "wait":
            route.fallback()

    page.page.route("**/api/upload", upload)
    state = lambda: page.text("#record-state")
    is_whole = lambda name: state().startswith(f"{name}, ") and page.page.locator("#report").is_visible()
    give = lambda text, name: page.give("#record", files=[csv(name, text)])
    record(page, two_rails(5), "first.csv")
    page.until(lambda: is_whole("first.csv"))
    page.settle()
    levels = page.text("#along-panel")
    for answer, name, text, words in [("refuse", "huge.csv", two_rails(4), "larger than"), (None, "letter.txt", "Dear all,\n", "letter.txt"), (None, "wrong.csv", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + 500 * "\0", "the file is")]:
        answers.append(answer)
        give(text, name)
        page.until(lambda: words in page.text("#trouble"))
        page.settle()
        if name != "letter.txt":
            assert is_whole("first.csv") and page.text("#along-panel") == levels, name
        else:
            page.page.locator("#notice button").first.click()
            page.until(lambda: is_whole("first.csv"))
            page.settle()
    # A file that breaks off on its way, by hand; what went wrong with another file is over.
    answers.append("wait")
    give(two_rails(4), "slow.csv")
    page.until(lambda: state().startswith("slow.csv"))
    assert not page.page.locator("#trouble").is_visible()
    page.page.locator("#drop .buttons").get_by_text("Cancel").click()
    page.until(lambda: is_whole("first.csv"))
    # One that is overtaken by another leaves it alone.
    answers.append("wait")
    give(two_rails(4), "slow.csv")
    page.until(lambda: state().startswith("slow.csv"))
    give(two_rails(6), "last.csv")
    page.until(lambda: is_whole("last.csv"))
    page.settle()
    assert is_whole("last.csv")
    # Undo leads to the record that was there before.
    page.page.locator("#notice button").first.click()
    page.until(lambda: is_whole("first.csv"))
    page.settle()
    page.complaints.clear()


# Long: asks about a record and those before it a dozen times.
def test_earlier_records_are_dated_left_out_removed_kept_and_brought_back(page):
    questions, answers = page.asked("/api/ask/measure"), page.answers("/api/ask/measure")
    rows = page.page.locator("#earlier-records > li")
    date = lambda k: rows.nth(k).locator("input")
    asked = lambda: [(one["name"], day) for one, day in zip(questions[-1].get("earlier", []), questions[-1].get("dates", [None] * 6))]
    course = lambda: page.page.locator(".course").first
    page.open_case(small("class-soft-slab"))
    record(page, two_rails(5), "now.csv")
    page.until(page.page.locator("#earlier").is_visible)
    # Nothing of dates before there is something to compare with.
    assert not page.page.locator("#record-date").is_visible()
    page.give("#earlier-file", files=[csv("last.csv", two_rails(4)), csv("older.csv", two_rails(3)), csv("notes.txt", "no table\n")])
    page.until(lambda: rows.count() == 3 and rows.nth(2).locator(".fault").last.is_visible())
    # What cannot be read says so under the name that the user knows, and the rest is asked for without it.
    assert "notes.txt" in rows.nth(2).inner_text() and "earlier-3" not in rows.nth(2).inner_text()
    page.until(lambda: asked() == [("last.csv", None), ("older.csv", None)])
    rows.nth(2).locator("button").click()
    page.until(lambda: rows.count() == 2)
    # A date that is not before that of the record is told of and not taken; the order of the dates counts, not that of the files.
    page.page.locator("#record-date").fill("2026-05-01")
    date(0).fill("2026-06-01")
    page.until(rows.nth(0).locator(".fault").first.is_visible)
    assert date(0).get_attribute("aria-invalid") == "true" and "before 2026-05-01" in rows.nth(0).inner_text()
    date(1).fill("2024-05-01")
    date(0).fill("2025-05-01")
    dated = [("older.csv", "2024-05-01"), ("last.csv", "2025-05-01")]
    page.until(lambda: asked() == dated and questions[-1]["dates"][-1] == "2026-05-01")
    page.until(lambda: "a year" in (course().inner_text() if course().count() else ""))
    page.settle()
    # What the page says is what was answered.
    levels = answers[-1]["diagnosis"]["dominant_wavelengths"][0]["course"]["levels_db"]
    assert f"2024-05-01 {levels[0]:.1f} dB, 2025-05-01 {levels[1]:.1f} dB" in course().inner_text()
    names = curves(page, "spectrum")
    assert sum("2024-05-01" in name for name in names) == 2 and "rail left, Now" in names
    # The report has them, too, and no name of a file that the user does not know.
    name, content = page.saved(lambda: page.page.click("#report"))
    assert name == "now-report.html" and b"older.csv" in content and b"earlier-1" not in content
    # That of the menu is the same.
    assert page.take("report") == (name, content)
    # The wave of 60 mm is the first finding.
    first = answers[-1]["diagnosis"]["dominant_wavelengths"][0]["wavelength_m"]
    assert 1e3 * first == pytest.approx(60, rel=0.05)
    assert page.text("#view-measure section:has(.course) h3 >> nth=0").startswith(f"{1e3 * first:.3g} mm")
    # Another record has none until they are added, and undo brings them back.
    page.give("#record", files=[csv("another.csv", two_rails(3))])
    page.until(lambda: questions[-1]["roughness"]["name"] == "another.csv" and "earlier" not in questions[-1])
    assert rows.count() == 0 and "earlier" in page.text("#notice")
    page.page.locator("#notice button").first.click()
    page.until(lambda: questions[-1]["roughness"]["name"] == "now.csv" and asked() == dated and questions[-1]["dates"][-1] == "2026-05-01")
    assert [date(k).input_value() for k in range(2)] == ["2025-05-01", "2024-05-01"]
    page.settle()
    # A reload finds files and dates.
    page.page.reload()
    page.settle()
    page.until(lambda: course().count() > 0)
    assert sorted(date(k).input_value() for k in range(2)) == ["2024-05-01", "2025-05-01"]
    # One that is removed is gone from the answer.
    rows.filter(has_text="older.csv").locator("button").click()
    page.until(lambda: asked() == dated[1:])
    page.settle()
    page.refused(422)


# Long: asks for the noise of a rail by every wheel and limit.
def test_the_noise_of_a_rail_follows_its_wheel_and_its_limit(page):
    answers = page.answers("/api/ask/noise")
    cells = lambda table: [row.split("\t") for row in page.page.locator(f"#{table} tbody tr").all_inner_texts()]
    page.open_case(small("class-soft-slab"))
    record(page, two_rails(5))
    page.until(lambda: answers and page.page.locator("#noise-panel").is_visible())
    page.settle()
    level = answers[-1]["level"]
    # A digit after the point on the page.
    shown = lambda: [cells("noise-parts")[0][part] for part in (1, 3, 4)]
    of = lambda level: [f"{level[f'{part}_dba']:.1f}" for part in ("rail", "wheel", "total")]
    assert shown() == of(level) and f"{level['total_dba']:.1f} dB(A)" in page.text("#noise-verdict") and "at 55 km/h" in page.text("#noise-verdict")
    assert [row[2] for row in cells("noise-measures")] == [f"{measure['saved_db']:.1f}".replace("-", "−") for measure in answers[-1]["measures"]]
    assert curves(page, "noise-bands")["total"]["y"] == pytest.approx(level["total_db"])
    page.page.select_option("#noise-wheel", "straight-web-920")
    page.until(lambda: answers[-1]["wheel_modes"] == "straight-web-920" and not page.page.locator("#noise-panel.stale").count())
    assert shown() == of(answers[-1]["level"]) != of(level)
    # A limit of one's own is told in months, or refused at its field.
    field = page.page.locator("#noise-limit")
    course = answers[-1]["course"]["total_dba"]
    limit = round((course[0] + course[-1]) / 2, 2)
    for text, words in [("loud", "not a number"), ("500", "0 to 200 dB(A)"), (str(limit), "")]:
        field.fill(text)
        field.press("Tab")
        page.until(lambda: page.page.locator("#noise-limit-fault").is_visible() == bool(words))
        assert words in page.text("#noise-limit-fault")
    page.until(lambda: [curve["y"] for name, curve in curves(page, "noise-course").items() if name == "limit"] == [[limit, limit]])
    months = answers[-1]["course"]["months_to_limit"]
    assert 0 < months < 12 and f"are reached in {months:.3g} months" in page.text("#noise-outlook")
    field.fill("")
    field.press("Tab")
    page.until(lambda: "reached" not in page.text("#noise-outlook"))
    assert not page.page.locator("#noise-limit-fault").is_visible()
    page.page.reload()
    page.until(page.page.locator("#noise-panel").is_visible)
    assert page.page.locator("#noise-wheel").input_value() == "straight-web-920"
    page.settle()
    # A free rail carries vibration on without end, and has no level.
    page.page.click("[popovertarget=take-away]")
    page.page.click("[data-take=nominal]")
    page.until(lambda: "has no level" in page.text("#noise-verdict"))
    assert not page.page.locator("#noise-parts").is_visible() and not page.page.locator("#noise-help-panel").is_visible()
    page.speak("de")
    assert "hat keinen Pegel" in page.text("#noise-verdict")
    page.settle()
    page.refused(422)


def test_causes_of_the_sample_are_cards_and_its_source_is_named(page):
    page.page.set_viewport_size({"width": 360, "height": 780})
    page.page.click("#tab-measure")
    page.page.click("#sample")
    page.page.locator("#view-measure .card").first.wait_for()
    page.settle()
    assert "not measured" in page.text("#sample-source") and "--synthesise" in page.text("#sample-source")
    page.fits()
    for card in page.page.locator("#view-measure .card").all():
        assert card.locator("svg").count() == 1 and card.locator("meter").count() == 1
        told = card.locator("dt").all_inner_texts()
        assert told == [word for word in ("For", "Against", "Would settle it") if word in told] and "Would settle it" in told
    # It pales with the case, and comes back.
    release = page.hold("**/api/ask/measure")
    page.set("contact.friction", "0.25")
    page.until(lambda: page.page.locator("#view-measure .stale:visible").count() >= 4)
    release()
    page.until(lambda: page.page.locator("#view-measure .stale:visible").count() == 0)
    page.settle()
