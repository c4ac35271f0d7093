"""A project in one file: saved with all that is open, opened again, refused where it is none."""

import base64
import gzip
import json

import pytest
from conftest import ROOT
from test_along import two_rails

pytestmark = [pytest.mark.without_curves, pytest.mark.without_remedies]


def test_a_project_holds_all_that_is_open_and_opens_again(open_page, tmp_path):
    page = open_page()
    page.open_case((ROOT / "cases/main-line.toml").read_text())
    page.page.click("#tab-measure")
    records = {"new.csv": two_rails(30), "old.csv": two_rails(20), "line.csv": "position_m;kind;name\n12;weld;W 7\n"}
    given = lambda name: {"name": name, "mimeType": "text/csv", "buffer": records[name].encode()}
    page.give("#record", files=[given("new.csv")])
    page.until(page.page.locator("#along-panel").is_visible)
    page.give("#earlier-file", files=[given("old.csv")])
    page.give("#line-table", files=[given("line.csv")])
    page.until(page.page.locator("#line-table-drop").is_visible)
    for field, date in [("#record-date", "2026-05-01"), ("#earlier-records input[type=date]", "2025-05-01")]:
        page.page.fill(field, date)
        page.page.locator(field).blur()
    page.settle()
    page.page.click("[popovertarget=take-away]")
    with page.page.expect_download() as download:
        page.page.click("[data-take=project]")
    file = tmp_path / "all.riffel"
    download.value.save_as(file)
    assert download.value.suggested_filename.endswith(".riffel")
    assert "the record new.csv with 1 earlier" in page.text("#notice")
    text = file.read_text()
    project = json.loads(text)
    assert project["version"] == 1 and gzip.decompress(base64.b64decode(project["record"]["gzip_base64"])).decode() == records["new.csv"]
    page.close()

    other = open_page(locale="de-DE")
    title = other.page.evaluate("() => window.riffel.state.keys.title")
    # What is none is refused in a sentence, and what is open stays.
    for refused, words in [
        (text[: len(text) // 2], "beschädigt"), (json.dumps({**project, "version": 9}), "Version 9"), ('{"a": 1}', "kein Projekt"),
        (json.dumps({**project, "record": {**project["record"], "gzip_base64": project["record"]["gzip_base64"][:400]}}), "beschädigt"),
        # 260 KB that stand for 257 MiB.
        (json.dumps({**project, "record": {**project["record"], "gzip_base64": base64.b64encode(gzip.compress(bytes(257 << 20))).decode()}}), "mehr als 256 MiB"),
    ]:
        other.open_case(refused, name="all.riffel")
        other.until(lambda: words in other.text("#trouble"))
        assert other.page.evaluate("() => window.riffel.state.keys.title") == title and not other.page.locator("#notice").is_visible()
    other.page.click("#tab-measure")
    # Dropped on the page it is opened as well as chosen, and is not taken for a record.
    other.page.evaluate(
        """(text) => {
          const files = new DataTransfer();
          files.items.add(new File([text], 'all.riffel'));
          document.getElementById('drop').dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
        }""",
        text,
    )
    other.until(lambda: other.page.locator("#earlier-records li").count() == 1 and other.page.locator("#line-table-drop").is_visible())
    other.settle()
    assert other.page.evaluate("() => window.riffel.state.keys") == project["case"] and not other.page.locator("#trouble").is_visible()
    assert other.text("#record-state").startswith("new.csv")
    assert [other.page.locator(field).input_value() for field in ("#record-date", "#earlier-records input[type=date]")] == ["2026-05-01", "2025-05-01"]
    other.close()


PLAN = ROOT / "validation/calibration/c-all-together"


def opened(page, text):
    page.open_case(text, name="all.riffel")
    page.until(lambda: "is open" in page.text("#notice"))
    page.settle()


def taken(page, folder):
    page.page.click("[popovertarget=take-away]")
    with page.page.expect_download() as download:
        page.page.click("[data-take=project]")
    file = folder / "taken.riffel"
    download.value.save_as(file)
    return file.read_text()


def letters(held):
    return gzip.decompress(base64.b64decode(held["gzip_base64"])).decode()


def test_a_project_keeps_records_and_plan_over_a_reload(open_page, tmp_path):
    page = open_page()
    page.open_case((PLAN / "case.toml").read_text())
    page.page.click("#tab-measure")
    given = lambda name, text: {"name": name, "mimeType": "text/csv", "buffer": text.encode()}
    page.give("#record", files=[given("new.csv", two_rails(30))])
    page.until(page.page.locator("#along-panel").is_visible)
    page.give("#earlier-file", files=[given("old.csv", two_rails(20))])
    page.settle()
    page.page.click("#tab-calibrate")
    for name in ["hammer.csv", "decay.csv"]:
        page.give("#calibration-file", PLAN / name)
        page.settle()
    page.page.locator("#priors input[type=text]").first.fill("280 MN/m")
    page.page.locator("#priors input[type=text]").first.press("Tab")
    page.page.select_option("#draws", "3000")
    page.settle()
    # The page has the files no more, the program has.
    page.page.reload()
    page.settle()
    page.page.locator("#cost-grinding").evaluate("(input) => (input.value = '250')")
    page.until(lambda: page.page.locator("#priors tbody tr").count() > 0)
    page.settle()
    text = taken(page, tmp_path)
    project = json.loads(text)
    assert "the record new.csv with 1 earlier, the plan of a calibration with 2 tables" in page.text("#notice")
    assert letters(project["record"]) == two_rails(30) and letters(project["record"]["earlier"][0]) == two_rails(20)
    assert [(table["name"], letters(table)) for table in project["plan"]["data"]] == [(name, (PLAN / name).read_text()) for name in ("hammer.csv", "decay.csv")]
    page.close(complaints=len(page.complaints))

    other = open_page()
    other.page.click("#tab-calibrate")
    other.settle()
    other.give("#calibration-file", PLAN / "axlebox.csv")
    other.settle()
    opened(other, text)
    other.page.click("#tab-calibrate")
    other.until(lambda: other.page.locator("#priors tbody tr").count() > 0)
    other.settle()
    rows = other.page.locator("#calibration-files li").all_inner_texts()
    assert len(rows) == 2 and "receptance of the rail" in rows[0] and "decay rates" in rows[1], rows
    assert other.page.locator("#priors input[type=text]").first.input_value() == "280 MN/m"
    assert other.page.locator("#draws").input_value() == "3000"
    assert json.loads(taken(other, tmp_path))["plan"] == project["plan"] and project["plan"]["costs"]["cost-grinding"] == "250"
    # A plan that is cut short is refused, and what is open stays.
    broken = {**project, "plan": {**project["plan"], "data": [{"name": "a.csv", "gzip_base64": "AAAA"}]}}
    other.open_case(json.dumps(broken), name="all.riffel")
    other.until(lambda: "damaged" in other.text("#trouble"))
    assert other.page.locator("#calibration-files li").count() == 2
    other.close(complaints=len(other.complaints))


def test_what_the_program_has_no_more_is_named(open_page, tmp_path):
    page = open_page()
    page.page.click("#tab-measure")
    page.give("#record", files=[{"name": "new.csv", "mimeType": "text/csv", "buffer": two_rails(30).encode()}])
    page.until(page.page.locator("#along-panel").is_visible)
    page.settle()
    page.page.reload()
    page.settle()
    gone = {"message": "the file is no longer here"}
    page.page.route("**/api/upload/kept", lambda route: route.fulfill(status=410, json=gone))
    project = json.loads(taken(page, tmp_path))
    assert "record" not in project and "It does not hold new.csv" in page.text("#notice")
    page.close(complaints=len(page.complaints))
